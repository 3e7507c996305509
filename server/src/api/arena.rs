//! `sessions/{id}/arena.png`: the arena at any size.

use axum::extract::State;
use axum::http::header;
use axum::response::{IntoResponse, Response};
use serde::Deserialize;
use utoipa::IntoParams;

use super::extract::{Path, Query};
use super::problem::Failure;
use super::{App, blocking};
use crate::render::{ArenaView, LARGEST_PX, Quality};
use crate::session::{LabError, Scenery};
use crate::wire::{Family, Problem, ThemeName};

/// What the picture shows.
#[derive(Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(super) struct ArenaQuery {
    /// Pixels, 1 to 4096; 960 when missing.
    width: Option<u32>,
    /// Pixels, 1 to 4096; 640 when missing.
    height: Option<u32>,
    /// A trial that ended, or in chapter 2 a run, by its round; the present when missing.
    trial: Option<u32>,
    /// Theme.
    #[serde(default)]
    #[param(inline)]
    theme: ThemeName,
}

/// A picture of the arena, now or after a trial
#[utoipa::path(get, path = "/sessions/{id}/arena.png", tag = "results",
    params(("id" = String, Path, description = "Identifier"), ArenaQuery),
    responses((status = 200, content_type = "image/png", body = [u8]), (status = 404, body = Problem),
        (status = 422, body = Problem)))]
pub(super) async fn picture(
    State(app): State<App>,
    Path(id): Path<String>,
    Query(query): Query<ArenaQuery>,
) -> Result<Response, Failure> {
    let size = Size::new(query.width.unwrap_or(960), query.height.unwrap_or(640))?;
    if app.lab.session(&id)?.family == Family::Drive {
        app.lab.flush(&id).await;
        let (app_too, id) = (app.clone(), id.clone());
        let view = blocking(move || app_too.reporter().run_arena(&id, query.trial)).await?;
        return png(&app, view, size, query.theme, Quality::Fast).await;
    }
    let view = match query.trial {
        Some(trial) => {
            app.lab.flush(&id).await;
            let app = app.clone();
            blocking(move || app.reporter().trial_arena(&id, trial)).await?
        }
        None => {
            let lab = app.lab.clone();
            blocking(move || -> Result<ArenaView, LabError> {
                let (feed, scenery) = (lab.feed(&id)?, Scenery::new(&lab.plan(&id)?));
                Ok(scenery.live(&feed.snapshot(), &feed.yardstick()))
            })
            .await?
        }
    };
    png(&app, view, size, query.theme, Quality::Fast).await
}

/// Width and height that can be drawn.
#[derive(Clone, Copy)]
pub(super) struct Size {
    width: u32,
    height: u32,
}

impl Size {
    pub(super) fn new(width: u32, height: u32) -> Result<Self, Failure> {
        for (field, pixels) in [("width", width), ("height", height)] {
            if !(1..=LARGEST_PX).contains(&pixels) {
                let detail = format!("must be 1 to {LARGEST_PX} pixels, not {pixels}");
                return Err(Failure::not_acceptable(field, detail));
            }
        }
        Ok(Self { width, height })
    }
}

/// Draws a picture and answers with it.
pub(super) async fn png(
    app: &App,
    view: ArenaView,
    size: Size,
    theme: ThemeName,
    quality: Quality,
) -> Result<Response, Failure> {
    let renderer = app.frames.renderer();
    let png = renderer.picture(view, size.width, size.height, theme, quality).await?;
    let headers = [(header::CONTENT_TYPE, "image/png"), (header::CACHE_CONTROL, "no-cache")];
    Ok((headers, png).into_response())
}
