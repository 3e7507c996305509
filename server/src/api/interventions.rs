//! What an operator does in a session under way: advice, edited values and saved tables for a learner; another
//! method, or a silent sonar, for a robot driven by rules.

use axum::Json;
use axum::body::Body as Bytes;
use axum::extract::State;
use axum::response::Response;

use super::App;
use super::extract::{Body, Path};
use super::files::download;
use super::problem::Failure;
use crate::session::Intervention;
use crate::wire::{
    Ack, AdviceRequest, MethodRequest, Problem, SonarRequest, TableFile, TableRequest,
};

/// Advise the learner whose turn it is; it holds until its episode ends
#[utoipa::path(post, path = "/sessions/{id}/advice", tag = "controls",
    params(("id" = String, Path, description = "Identifier")), request_body = AdviceRequest,
    responses((status = 200, body = Ack), (status = 404, body = Problem), (status = 409, body = Problem),
        (status = 422, description = "The character of the advice that is wrong", body = Problem)))]
pub(super) async fn advise(
    State(app): State<App>,
    Path(id): Path<String>,
    Body(request): Body<AdviceRequest>,
) -> Result<Json<Ack>, Failure> {
    Ok(Json(app.lab.intervene(&id, Intervention::Advise(request.text)).await?))
}

/// Change one value of the learner whose turn it is, or load a whole table
#[utoipa::path(post, path = "/sessions/{id}/table", tag = "controls",
    params(("id" = String, Path, description = "Identifier")), request_body = TableRequest,
    responses((status = 200, body = Ack), (status = 404, body = Problem), (status = 409, body = Problem),
        (status = 422, body = Problem)))]
pub(super) async fn change(
    State(app): State<App>,
    Path(id): Path<String>,
    Body(request): Body<TableRequest>,
) -> Result<Json<Ack>, Failure> {
    let what = match request {
        TableRequest::Value { state, action, value } => {
            Intervention::Edit { state: state as usize, action: action as usize, value }
        }
        TableRequest::Table { values } => Intervention::Load(values),
    };
    Ok(Json(app.lab.intervene(&id, what).await?))
}

/// The values of the learner whose turn it is, as a file that can be loaded again
#[utoipa::path(get, path = "/sessions/{id}/table", tag = "results",
    params(("id" = String, Path, description = "Identifier")),
    responses((status = 200, body = TableFile), (status = 404, body = Problem),
        (status = 422, description = "The learner has no table of its own", body = Problem)))]
pub(super) async fn save(
    State(app): State<App>,
    Path(id): Path<String>,
) -> Result<Response, Failure> {
    let table = app.lab.table(&id).await?;
    let text = serde_json::to_vec(&table).map_err(|error| Failure::internal(error.to_string()))?;
    Ok(download(&format!("sonarium-{id}-table.json"), "json", Bytes::from(text)))
}

/// Change the method that drives a robot of chapter 2; it holds until the run ends
#[utoipa::path(post, path = "/sessions/{id}/method", tag = "controls",
    params(("id" = String, Path, description = "Identifier")), request_body = MethodRequest,
    responses((status = 200, body = Ack), (status = 404, body = Problem), (status = 409, body = Problem),
        (status = 422, body = Problem)))]
pub(super) async fn method(
    State(app): State<App>,
    Path(id): Path<String>,
    Body(request): Body<MethodRequest>,
) -> Result<Json<Ack>, Failure> {
    Ok(Json(app.lab.intervene(&id, Intervention::Method(request.method)).await?))
}

/// Let a sonar of a robot of chapter 2 fall silent, or answer again
#[utoipa::path(post, path = "/sessions/{id}/sonars", tag = "controls",
    params(("id" = String, Path, description = "Identifier")), request_body = SonarRequest,
    responses((status = 200, body = Ack), (status = 404, body = Problem), (status = 409, body = Problem),
        (status = 422, body = Problem)))]
pub(super) async fn sonar(
    State(app): State<App>,
    Path(id): Path<String>,
    Body(SonarRequest { sonar, silent }): Body<SonarRequest>,
) -> Result<Json<Ack>, Failure> {
    let what = Intervention::Sonar { sonar: sonar as usize, silent };
    Ok(Json(app.lab.intervene(&id, what).await?))
}
