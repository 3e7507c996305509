//! `worlds/{name}/map`: the picture of the map that a world was traced from.

use axum::Json;
use axum::extract::State;
use axum::http::StatusCode;

use super::extract::{Body, Path};
use super::problem::Failure;
use super::{App, blocking};
use crate::wire::{MapPicture, Problem};

/// The picture of the map that a world was traced from; `null` when none is kept
#[utoipa::path(get, path = "/worlds/{name}/map", tag = "worlds",
    params(("name" = String, Path, description = "Name of the world")),
    responses((status = 200, body = Option<MapPicture>), (status = 404, body = Problem),
        (status = 422, body = Problem)))]
pub(super) async fn one(
    State(app): State<App>,
    Path(name): Path<String>,
) -> Result<Json<Option<MapPicture>>, Failure> {
    blocking(move || app.lab.catalog().worlds().map(&name)).await.map(Json)
}

/// Keep a picture of the map beside a world of one's own
///
/// Nothing that runs depends on it. A PNG of at most 4096 x 4096 pixels and 8 MiB.
#[utoipa::path(put, path = "/worlds/{name}/map", tag = "worlds", request_body = MapPicture,
    params(("name" = String, Path, description = "Name of the world")),
    responses((status = 204), (status = 404, body = Problem), (status = 409, body = Problem),
        (status = 422, body = Problem)))]
pub(super) async fn keep(
    State(app): State<App>,
    Path(name): Path<String>,
    Body(picture): Body<MapPicture>,
) -> Result<StatusCode, Failure> {
    blocking(move || app.lab.catalog().worlds().keep_map(&name, &picture)).await?;
    Ok(StatusCode::NO_CONTENT)
}

/// Delete the picture of the map; the world stays
#[utoipa::path(delete, path = "/worlds/{name}/map", tag = "worlds",
    params(("name" = String, Path, description = "Name of the world")),
    responses((status = 204), (status = 404, body = Problem), (status = 409, body = Problem)))]
pub(super) async fn delete(
    State(app): State<App>,
    Path(name): Path<String>,
) -> Result<StatusCode, Failure> {
    blocking(move || app.lab.catalog().worlds().delete_map(&name)).await?;
    Ok(StatusCode::NO_CONTENT)
}
