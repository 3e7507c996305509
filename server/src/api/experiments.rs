//! `experiments`: what can be run.

use axum::Json;
use axum::extract::State;
use axum::response::Response;
use serde::Deserialize;
use utoipa::IntoParams;

use super::App;
use super::arena::{Size, png};
use super::extract::{Path, Query};
use super::problem::Failure;
use crate::catalog::DEFAULT_WORLD;
use crate::render::Quality;
use crate::session::empty_arena;
use crate::wire::{ExperimentInfo, Problem, ThemeName};

/// All experiments
#[utoipa::path(get, path = "/experiments", tag = "experiments",
    responses((status = 200, body = [ExperimentInfo])))]
pub(super) async fn list(State(app): State<App>) -> Json<Vec<ExperimentInfo>> {
    Json(app.lab.catalog().experiments())
}

/// One experiment
#[utoipa::path(get, path = "/experiments/{name}", tag = "experiments",
    params(("name" = String, Path, description = "Name of the experiment")),
    responses((status = 200, body = ExperimentInfo), (status = 404, body = Problem)))]
pub(super) async fn one(
    State(app): State<App>,
    Path(name): Path<String>,
) -> Result<Json<ExperimentInfo>, Failure> {
    find(&app, &name).map(Json)
}

/// What the picture of an experiment shows.
#[derive(Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(super) struct PictureQuery {
    /// Pixels, 1 to 4096; 480 when missing.
    width: Option<u32>,
    /// Pixels, 1 to 4096; 320 when missing.
    height: Option<u32>,
    /// Theme.
    #[serde(default)]
    #[param(inline)]
    theme: ThemeName,
    /// World; the default one when missing.
    world: Option<String>,
}

/// A picture of the experiment's world
#[utoipa::path(get, path = "/experiments/{name}/picture.png", tag = "experiments",
    params(("name" = String, Path, description = "Name of the experiment"), PictureQuery),
    responses((status = 200, content_type = "image/png", body = [u8]), (status = 404, body = Problem),
        (status = 422, body = Problem)))]
pub(super) async fn picture(
    State(app): State<App>,
    Path(name): Path<String>,
    Query(query): Query<PictureQuery>,
) -> Result<Response, Failure> {
    let experiment = find(&app, &name)?;
    let default = experiment.worlds.first().map_or(DEFAULT_WORLD, |world| world.name.as_str());
    let size = Size::new(query.width.unwrap_or(480), query.height.unwrap_or(320))?;
    let worlds = app.lab.catalog().worlds();
    let world = worlds
        .get(query.world.as_deref().unwrap_or(default))
        .map_err(|error| Failure::not_acceptable("world", error.message))?;
    let names: Vec<String> =
        world.world.regions().iter().map(|region| region.name.clone()).collect();
    let view = empty_arena(&world.world, &names);
    png(&app, view, size, query.theme, Quality::Fast).await
}

fn find(app: &App, name: &str) -> Result<ExperimentInfo, Failure> {
    let found = app.lab.catalog().experiments().into_iter().find(|info| info.name == name);
    found.ok_or_else(|| Failure::not_found(format!("there is no experiment `{name}`")))
}
