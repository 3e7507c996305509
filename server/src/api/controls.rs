//! `sessions/{id}/start` and the other controls.

use axum::Json;
use axum::extract::State;

use super::App;
use super::extract::{Body, OptionalBody, Path};
use super::problem::Failure;
use crate::catalog::check_speed;
use crate::session::Control;
use crate::wire::{Ack, Problem, SpeedRequest, StepRequest};

/// Start a session, as soon as a core is free
#[utoipa::path(post, path = "/sessions/{id}/start", tag = "controls",
    params(("id" = String, Path, description = "Identifier")),
    responses((status = 200, body = Ack), (status = 404, body = Problem), (status = 409, body = Problem)))]
pub(super) async fn start(State(app): State<App>, Path(id): Path<String>) -> Answer {
    control(&app, &id, Control::Start).await
}

/// Hold between two ticks
#[utoipa::path(post, path = "/sessions/{id}/pause", tag = "controls",
    params(("id" = String, Path, description = "Identifier")),
    responses((status = 200, body = Ack), (status = 404, body = Problem), (status = 409, body = Problem)))]
pub(super) async fn pause(State(app): State<App>, Path(id): Path<String>) -> Answer {
    control(&app, &id, Control::Pause).await
}

/// Go on from where it was paused, or from the last checkpoint
#[utoipa::path(post, path = "/sessions/{id}/resume", tag = "controls",
    params(("id" = String, Path, description = "Identifier")),
    responses((status = 200, body = Ack), (status = 404, body = Problem), (status = 409, body = Problem)))]
pub(super) async fn resume(State(app): State<App>, Path(id): Path<String>) -> Answer {
    control(&app, &id, Control::Resume).await
}

/// End before the last trial
#[utoipa::path(post, path = "/sessions/{id}/stop", tag = "controls",
    params(("id" = String, Path, description = "Identifier")),
    responses((status = 200, body = Ack), (status = 404, body = Problem), (status = 409, body = Problem)))]
pub(super) async fn stop(State(app): State<App>, Path(id): Path<String>) -> Answer {
    control(&app, &id, Control::Stop).await
}

/// Back to tick 0 with an empty network; the log is put aside
#[utoipa::path(post, path = "/sessions/{id}/reset", tag = "controls",
    params(("id" = String, Path, description = "Identifier")),
    responses((status = 200, body = Ack), (status = 404, body = Problem), (status = 409, body = Problem)))]
pub(super) async fn reset(State(app): State<App>, Path(id): Path<String>) -> Answer {
    control(&app, &id, Control::Reset).await
}

/// Go one tick or one trial, then hold
#[utoipa::path(post, path = "/sessions/{id}/step", tag = "controls",
    params(("id" = String, Path, description = "Identifier")), request_body = StepRequest,
    responses((status = 200, body = Ack), (status = 400, body = Problem), (status = 404, body = Problem),
        (status = 409, body = Problem)))]
pub(super) async fn step(
    State(app): State<App>,
    Path(id): Path<String>,
    OptionalBody(request): OptionalBody<StepRequest>,
) -> Answer {
    control(&app, &id, Control::Step(request.unit)).await
}

/// Change the pace
#[utoipa::path(post, path = "/sessions/{id}/speed", tag = "controls",
    params(("id" = String, Path, description = "Identifier")), request_body = SpeedRequest,
    responses((status = 200, body = Ack), (status = 400, body = Problem), (status = 404, body = Problem),
        (status = 409, body = Problem), (status = 422, body = Problem)))]
pub(super) async fn speed(
    State(app): State<App>,
    Path(id): Path<String>,
    Body(request): Body<SpeedRequest>,
) -> Answer {
    control(&app, &id, Control::Speed(check_speed(request.speed)?)).await
}

type Answer = Result<Json<Ack>, Failure>;

async fn control(app: &App, id: &str, control: Control) -> Answer {
    Ok(Json(app.lab.control(id, control).await?))
}
