//! `sessions`: creating, listing, deleting.

use axum::Json;
use axum::extract::State;
use axum::http::{HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};

use super::extract::{Body, Path};
use super::files::download;
use super::problem::Failure;
use super::{App, LARGEST_BODY, blocking};
use crate::catalog::LARGEST_NETWORK;
use crate::wire::{NetworkFile, NewSession, Problem, Session};

/// Largest body of a request for a session, bytes: the largest network, and the rest of the request.
pub(super) const LARGEST_SESSION: usize = LARGEST_NETWORK + LARGEST_BODY;

/// Create a session; it is `queued` until it is started
///
/// With its network the body may have as many bytes as one of 100,000 neurons needs (196 MiB).
#[utoipa::path(post, path = "/sessions", tag = "sessions", request_body = NewSession,
    responses((status = 201, body = Session), (status = 400, body = Problem),
        (status = 413, body = Problem), (status = 422, body = Problem), (status = 507, body = Problem)))]
pub(super) async fn create(
    State(app): State<App>,
    Body(request): Body<NewSession>,
) -> Result<Response, Failure> {
    let session = blocking(move || app.lab.create(&request)).await?;
    let location = HeaderValue::try_from(format!("/api/v1/sessions/{}", session.id));
    let mut response = (StatusCode::CREATED, Json(session)).into_response();
    if let Ok(location) = location {
        response.headers_mut().insert(header::LOCATION, location);
    }
    Ok(response)
}

/// The session's trained networks as a file, as its last finished trial left them
#[utoipa::path(get, path = "/sessions/{id}/network", tag = "results",
    params(("id" = String, Path, description = "Identifier")),
    responses((status = 200, body = NetworkFile), (status = 404, body = Problem),
        (status = 409, description = "No trial has ended yet", body = Problem)))]
pub(super) async fn network(
    State(app): State<App>,
    Path(id): Path<String>,
) -> Result<Response, Failure> {
    app.lab.flush(&id).await;
    let name = format!("sonarium-{id}-network.json");
    let trained = blocking(move || app.lab.trained(&id)).await?.ok_or_else(|| {
        let detail = "no trial has ended yet; the networks can be had after the first";
        Failure::new(StatusCode::CONFLICT, "too-early", "There is no network yet", detail)
    })?;
    Ok(download(&name, "json", trained.text.into()))
}

/// All sessions, newest first
#[utoipa::path(get, path = "/sessions", tag = "sessions", responses((status = 200, body = [Session])))]
pub(super) async fn list(State(app): State<App>) -> Result<Json<Vec<Session>>, Failure> {
    blocking(move || app.lab.sessions()).await.map(Json)
}

/// One session
#[utoipa::path(get, path = "/sessions/{id}", tag = "sessions",
    params(("id" = String, Path, description = "Identifier")),
    responses((status = 200, body = Session), (status = 404, body = Problem)))]
pub(super) async fn one(
    State(app): State<App>,
    Path(id): Path<String>,
) -> Result<Json<Session>, Failure> {
    blocking(move || app.lab.session(&id)).await.map(Json)
}

/// Delete a session with all its files; it must not be in use
#[utoipa::path(delete, path = "/sessions/{id}", tag = "sessions",
    params(("id" = String, Path, description = "Identifier")),
    responses((status = 204), (status = 404, body = Problem), (status = 409, body = Problem)))]
pub(super) async fn delete(
    State(app): State<App>,
    Path(id): Path<String>,
) -> Result<StatusCode, Failure> {
    blocking(move || app.lab.delete(&id)).await.map(|()| StatusCode::NO_CONTENT)
}
