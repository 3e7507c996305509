//! `worlds`: those that come with the program, and the user's own.

use axum::Json;
use axum::body::Bytes;
use axum::extract::State;
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::Deserialize;
use sonarium_core::world as core;
use utoipa::IntoParams;

use super::arena::{Size, png};
use super::extract::{Path, Query, Raw, media_type, parse};
use super::problem::Failure;
use super::{App, blocking};
use crate::catalog::{
    NamedWorld, WorldsError, parse_world, region_shapes, robot_radius_m, to_toml,
};
use crate::render::Quality;
use crate::session::empty_arena;
use crate::wire::{
    Problem, RegionProposal, ThemeName, WorldCheck, WorldFile, WorldProblem, WorldRegion,
    WorldSummary,
};

/// Largest body of a request that carries a world or a map, bytes.
pub(super) const LARGEST_WORLD: usize = 32 << 20;

const TOML: &str = "application/toml";

/// All worlds, usable or not
#[utoipa::path(get, path = "/worlds", tag = "worlds",
    responses((status = 200, body = [WorldSummary])))]
pub(super) async fn list(State(app): State<App>) -> Result<Json<Vec<WorldSummary>>, Failure> {
    let summaries = move || Ok::<_, Failure>(app.lab.catalog().worlds().summaries());
    blocking(summaries).await.map(Json)
}

/// How a world is to be written.
#[derive(Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(super) struct FormatQuery {
    /// `json` or `toml`; what the request accepts when missing.
    #[param(inline)]
    format: Option<Format>,
}

#[derive(Clone, Copy, PartialEq, Eq, Deserialize, utoipa::ToSchema)]
#[serde(rename_all = "lowercase")]
enum Format {
    Json,
    Toml,
}

/// One world, as JSON or as its file
#[utoipa::path(get, path = "/worlds/{name}", tag = "worlds",
    params(("name" = String, Path, description = "Name of the world"), FormatQuery),
    responses((status = 200, body = WorldFile), (status = 404, body = Problem),
        (status = 422, body = Problem)))]
pub(super) async fn one(
    State(app): State<App>,
    Path(name): Path<String>,
    Query(query): Query<FormatQuery>,
    headers: HeaderMap,
) -> Result<Response, Failure> {
    let asked = name.clone();
    let text = blocking(move || app.lab.catalog().worlds().text(&asked)).await?;
    let accepted = headers.get(header::ACCEPT).and_then(|value| value.to_str().ok());
    let format = match query.format {
        Some(format) => format,
        None if accepted.is_some_and(|types| types.contains(TOML)) => Format::Toml,
        None => Format::Json,
    };
    if format == Format::Json {
        let file = parse_world(&text).map_err(|problem| refusal(&problem))?;
        return Ok(Json(WorldFile::from(file)).into_response());
    }
    // Only letters that need no quoting are names of files that were saved here.
    let safe: String =
        name.chars().filter(|c| c.is_ascii_alphanumeric() || "-_".contains(*c)).collect();
    let attachment = format!("attachment; filename=\"{safe}.toml\"");
    let headers =
        [(header::CONTENT_TYPE, TOML.to_owned()), (header::CONTENT_DISPOSITION, attachment)];
    Ok((headers, text).into_response())
}

/// Save a world
///
/// The body is the world as JSON, or as TOML with `content-type: application/toml`; TOML is kept as it
/// is. It can be used at once. With `If-None-Match: *` a world that exists is not replaced.
#[utoipa::path(put, path = "/worlds/{name}", tag = "worlds",
    params(("name" = String, Path, description = "Name of the world")), request_body = WorldFile,
    responses((status = 200, body = WorldSummary, description = "It was replaced"),
        (status = 201, body = WorldSummary, description = "It is new"),
        (status = 400, body = Problem), (status = 409, body = Problem), (status = 412, body = Problem),
        (status = 422, body = Problem)))]
pub(super) async fn save(
    State(app): State<App>,
    Path(name): Path<String>,
    headers: HeaderMap,
    Raw(body): Raw,
) -> Result<Response, Failure> {
    let only_new = headers.get(header::IF_NONE_MATCH).is_some_and(|value| value == "*");
    let (_, text) = world_in(&headers, &body)?;
    let saved = blocking(move || app.lab.catalog().worlds().save(&name, text, only_new)).await?;
    let (summary, is_new) = saved;
    let status = if is_new { StatusCode::CREATED } else { StatusCode::OK };
    Ok((status, Json(summary)).into_response())
}

/// Delete a world
///
/// Sessions that run in it keep the text that they were created with.
#[utoipa::path(delete, path = "/worlds/{name}", tag = "worlds",
    params(("name" = String, Path, description = "Name of the world")),
    responses((status = 204), (status = 404, body = Problem), (status = 409, body = Problem)))]
pub(super) async fn delete(
    State(app): State<App>,
    Path(name): Path<String>,
) -> Result<StatusCode, Failure> {
    blocking(move || app.lab.catalog().worlds().delete(&name)).await?;
    Ok(StatusCode::NO_CONTENT)
}

/// Check a world without saving it
///
/// The body is the world as JSON, or as TOML with `content-type: application/toml`.
#[utoipa::path(post, path = "/worlds/check", tag = "worlds", request_body = WorldFile,
    responses((status = 200, body = WorldCheck), (status = 400, body = Problem)))]
pub(super) async fn check(
    State(app): State<App>,
    headers: HeaderMap,
    Raw(body): Raw,
) -> Result<Json<WorldCheck>, Failure> {
    let (file, _) = world_in(&headers, &body)?;
    let work = move || Ok::<_, Failure>(app.lab.catalog().worlds().check(file));
    blocking(work).await.map(Json)
}

/// How many regions are proposed.
#[derive(Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(super) struct RegionQuery {
    /// Most regions, 1 to 16; 4 when missing, as many as Algorithm 8 has.
    most: Option<usize>,
}

/// Propose regions for a world
///
/// The world is cut at the doors and corners of the way from home to goal (section 5.6). The regions in
/// the body are left alone.
#[utoipa::path(post, path = "/worlds/regions", tag = "worlds", params(RegionQuery),
    request_body = WorldFile,
    responses((status = 200, body = RegionProposal), (status = 400, body = Problem),
        (status = 422, body = Problem)))]
pub(super) async fn regions(
    Query(query): Query<RegionQuery>,
    headers: HeaderMap,
    Raw(body): Raw,
) -> Result<Json<RegionProposal>, Failure> {
    let most = query.most.unwrap_or(core::DEFAULT_REGIONS);
    if !(1..=16).contains(&most) {
        return Err(Failure::not_acceptable("most", format!("must be 1 to 16, not {most}")));
    }
    let (mut file, _) = world_in(&headers, &body)?;
    blocking(move || {
        let radius_m = robot_radius_m();
        file.regions = vec![core::RegionFile { name: "everywhere".into(), rules: Vec::new() }];
        let refused = |error: core::WorldError| refusal(&WorldProblem::from(&error));
        let world = core::World::new(&file, radius_m).map_err(refused)?;
        file.regions = core::propose_regions(&world, radius_m, most);
        let world = core::World::new(&file, radius_m).map_err(refused)?;
        let regions = file.regions.into_iter().map(WorldRegion::from).collect();
        Ok::<_, Failure>(RegionProposal { regions, shapes: region_shapes(&world) })
    })
    .await
    .map(Json)
}

/// Size and theme of a picture.
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
}

/// A picture of a world
#[utoipa::path(get, path = "/worlds/{name}/picture.png", tag = "worlds",
    params(("name" = String, Path, description = "Name of the world"), PictureQuery),
    responses((status = 200, content_type = "image/png", body = [u8]), (status = 404, body = Problem),
        (status = 422, body = Problem)))]
pub(super) async fn picture(
    State(app): State<App>,
    Path(name): Path<String>,
    Query(query): Query<PictureQuery>,
) -> Result<Response, Failure> {
    let size = Size::new(query.width.unwrap_or(480), query.height.unwrap_or(320))?;
    let worlds = app.clone();
    let world: NamedWorld = blocking(move || worlds.lab.catalog().worlds().find(&name)).await?;
    let names: Vec<String> =
        world.world.regions().iter().map(|region| region.name.clone()).collect();
    png(&app, empty_arena(&world.world, &names), size, query.theme, Quality::Fast).await
}

/// The world in a body, and its text as a file.
fn world_in(headers: &HeaderMap, body: &Bytes) -> Result<(core::WorldFile, String), Failure> {
    if media_type(headers).eq_ignore_ascii_case(TOML) {
        let text = std::str::from_utf8(body)
            .map_err(|error| Failure::unreadable(format!("the body must be UTF-8 ({error})")))?;
        let file = parse_world(text).map_err(|problem| Failure::unreadable(problem.message))?;
        return Ok((file, text.to_owned()));
    }
    super::extract::check_json(headers)?;
    let file = core::WorldFile::from(parse::<WorldFile>(body)?);
    let text = to_toml(&file);
    Ok((file, text))
}

fn refusal(problem: &WorldProblem) -> Failure {
    let mut failure = Failure::not_acceptable(&problem.field, problem.message.clone());
    failure.0.place = problem.place;
    failure
}

impl From<WorldsError> for Failure {
    fn from(error: WorldsError) -> Self {
        let message = error.to_string();
        match error {
            WorldsError::Missing { .. } => Self::not_found(message),
            WorldsError::BuiltIn { .. } | WorldsError::NoFolder => {
                let title = "The world cannot be changed";
                Self::new(StatusCode::CONFLICT, "conflict", title, message).at("name")
            }
            WorldsError::Exists { .. } => {
                let title = "There already is such a world";
                Self::new(StatusCode::PRECONDITION_FAILED, "exists", title, message).at("name")
            }
            WorldsError::Name { .. } => Self::not_acceptable("name", message),
            WorldsError::Broken(broken) => refusal(&broken.problem),
            WorldsError::Map(error) => Self::not_acceptable(&error.field, error.message),
            WorldsError::Folder { .. } => {
                let title = "The data folder refused";
                Self::new(StatusCode::INSUFFICIENT_STORAGE, "storage", title, message)
            }
        }
    }
}
