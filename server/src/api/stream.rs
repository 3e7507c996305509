//! `sessions/{id}/stream`: opening the WebSocket.

use std::sync::Arc;

use axum::extract::State;
use axum::extract::ws::WebSocketUpgrade;
use axum::extract::ws::rejection::WebSocketUpgradeRejection;
use axum::http::{HeaderMap, StatusCode};
use axum::response::Response;
use serde::Deserialize;
use utoipa::IntoParams;

use super::extract::{Path, Query};
use super::guard::check_origin;
use super::problem::Failure;
use super::{App, blocking};
use crate::catalog::Job;
use crate::session::{LabError, Scenery};
use crate::stream::{LARGEST_MESSAGE, serve};
use crate::wire::Problem;

/// Where a client that was here before goes on.
#[derive(Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
pub(super) struct StreamQuery {
    /// Number of the last event it has seen.
    since: Option<u64>,
}

/// Watch a session over a WebSocket
#[utoipa::path(get, path = "/sessions/{id}/stream", tag = "results",
    params(("id" = String, Path, description = "Identifier"), StreamQuery),
    responses((status = 101, description = "The stream; its first message is `hello`"),
        (status = 404, body = Problem), (status = 426, body = Problem)))]
pub(super) async fn open(
    State(app): State<App>,
    Path(id): Path<String>,
    Query(query): Query<StreamQuery>,
    headers: HeaderMap,
    upgrade: Result<WebSocketUpgrade, WebSocketUpgradeRejection>,
) -> Result<Response, Failure> {
    check_origin(&headers)?;
    let (feed, scenery) = {
        let lab = app.lab.clone();
        blocking(move || -> Result<_, LabError> {
            let scenery = match lab.job(&id)? {
                Job::Path(plan) => Some(Arc::new(Scenery::new(&plan))),
                Job::Plain(_) => None,
            };
            Ok((lab.feed(&id)?, scenery))
        })
        .await?
    };
    let upgrade = upgrade.map_err(|rejection| {
        let title = "This is a WebSocket";
        Failure::new(StatusCode::UPGRADE_REQUIRED, "upgrade-required", title, rejection.body_text())
    })?;
    let upgrade = upgrade.max_message_size(LARGEST_MESSAGE).max_frame_size(LARGEST_MESSAGE);
    Ok(upgrade.on_upgrade(async move |socket| {
        let goodbye = serve(socket, feed, scenery, app.frames, query.since).await;
        tracing::debug!("a viewer left: {goodbye}");
    }))
}
