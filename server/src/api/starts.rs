//! `sessions/{id}/starts`: a trained network started from elsewhere.

use axum::Json;
use axum::extract::State;
use axum::response::Response;
use serde::Deserialize;
use utoipa::IntoParams;

use super::arena::{Size, png};
use super::extract::{Path, Query};
use super::problem::Failure;
use super::{App, blocking};
use crate::catalog::starts_from_text;
use crate::render::Quality;
use crate::session::{Scenery, starts_arena};
use crate::wire::{AlteredStartView, Problem, StartView, ThemeName};

/// Which starts.
#[derive(Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(super) struct StartsQuery {
    /// Poses `x,y,heading` in metres and degrees, with `;` between them, e.g. `1,0.5,90;2,1,0`; those of
    /// the experiment when missing.
    at: Option<String>,
}

/// What a session's networks do from altered starts, as its last finished trial left them
#[utoipa::path(get, path = "/sessions/{id}/starts", tag = "results",
    params(("id" = String, Path, description = "Identifier"), StartsQuery),
    responses((status = 200, body = [AlteredStartView]), (status = 404, body = Problem),
        (status = 422, body = Problem)))]
pub(super) async fn list(
    State(app): State<App>,
    Path(id): Path<String>,
    Query(query): Query<StartsQuery>,
) -> Result<Json<Vec<AlteredStartView>>, Failure> {
    let starts = asked(query.at.as_deref())?;
    app.lab.flush(&id).await;
    blocking(move || app.lab.altered_starts(&id, starts.as_deref())).await.map(Json)
}

/// What their picture shows.
#[derive(Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(super) struct PictureQuery {
    /// Poses as in `starts`.
    at: Option<String>,
    /// Pixels, 1 to 4096; 960 when missing.
    width: Option<u32>,
    /// Pixels, 1 to 4096; 640 when missing.
    height: Option<u32>,
    /// Theme.
    #[serde(default)]
    #[param(inline)]
    theme: ThemeName,
}

/// A picture of the ways from altered starts
#[utoipa::path(get, path = "/sessions/{id}/starts.png", tag = "results",
    params(("id" = String, Path, description = "Identifier"), PictureQuery),
    responses((status = 200, content_type = "image/png", body = [u8]), (status = 404, body = Problem),
        (status = 422, body = Problem)))]
pub(super) async fn picture(
    State(app): State<App>,
    Path(id): Path<String>,
    Query(query): Query<PictureQuery>,
) -> Result<Response, Failure> {
    let size = Size::new(query.width.unwrap_or(960), query.height.unwrap_or(640))?;
    let starts = asked(query.at.as_deref())?;
    app.lab.flush(&id).await;
    let lab = app.lab.clone();
    let view = blocking(move || -> Result<_, crate::session::LabError> {
        let found = lab.altered_starts(&id, starts.as_deref())?;
        Ok(starts_arena(&Scenery::new(&lab.plan(&id)?), &found))
    })
    .await?;
    png(&app, view, size, query.theme, Quality::Balanced).await
}

fn asked(at: Option<&str>) -> Result<Option<Vec<StartView>>, Failure> {
    let starts = at.map(starts_from_text).transpose();
    starts.map_err(|error| Failure::not_acceptable("at", error.message))
}
