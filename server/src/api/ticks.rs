//! `sessions/{id}/trials`, `ticks`, `neurons`: what happened, in numbers.

use axum::Json;
use axum::extract::State;
use axum::http::header;
use axum::response::{IntoResponse, Response};
use serde::Deserialize;
use utoipa::IntoParams;

use super::extract::{Path, Query};
use super::problem::Failure;
use super::{App, blocking};
use crate::wire::{
    CycleView, DriveRunView, EpisodeView, NeuronView, Problem, StepView, TickView, Trial,
    TrialEndView,
};

/// Most ticks in one answer.
const MOST_TICKS: u64 = 10_000;

/// The trials that ended, in order
#[utoipa::path(get, path = "/sessions/{id}/trials", tag = "results",
    params(("id" = String, Path, description = "Identifier")),
    responses((status = 200, body = [Trial]), (status = 404, body = Problem)))]
pub(super) async fn trials(
    State(app): State<App>,
    Path(id): Path<String>,
) -> Result<Json<Vec<Trial>>, Failure> {
    let feed = blocking(move || app.lab.feed(&id)).await?;
    Ok(Json(feed.rounds().iter().filter_map(|round| round.trial().cloned()).collect()))
}

/// The episodes of a tabular session that ended, in order
#[utoipa::path(get, path = "/sessions/{id}/episodes", tag = "results",
    params(("id" = String, Path, description = "Identifier")),
    responses((status = 200, body = [EpisodeView]), (status = 404, body = Problem)))]
pub(super) async fn episodes(
    State(app): State<App>,
    Path(id): Path<String>,
) -> Result<Json<Vec<EpisodeView>>, Failure> {
    let feed = blocking(move || app.lab.feed(&id)).await?;
    Ok(Json(feed.rounds().iter().filter_map(|round| round.episode().cloned()).collect()))
}

/// The runs of a session of chapter 2 that ended, in order
#[utoipa::path(get, path = "/sessions/{id}/runs", tag = "results",
    params(("id" = String, Path, description = "Identifier")),
    responses((status = 200, body = [DriveRunView]), (status = 404, body = Problem)))]
pub(super) async fn runs(
    State(app): State<App>,
    Path(id): Path<String>,
) -> Result<Json<Vec<DriveRunView>>, Failure> {
    let feed = blocking(move || app.lab.feed(&id)).await?;
    Ok(Json(feed.rounds().iter().filter_map(|round| round.run().cloned()).collect()))
}

/// A trial of a session.
#[derive(Deserialize)]
pub(super) struct TrialPath {
    id: String,
    trial: u32,
}

/// A neuron of a session.
#[derive(Deserialize)]
pub(super) struct NeuronPath {
    id: String,
    neuron: u32,
}

/// One trial, with what the learner did at its end
#[utoipa::path(get, path = "/sessions/{id}/trials/{trial}", tag = "results",
    params(("id" = String, Path, description = "Identifier"),
        ("trial" = u32, Path, description = "Number, from 1")),
    responses((status = 200, body = TrialEndView), (status = 404, body = Problem)))]
pub(super) async fn trial(
    State(app): State<App>,
    Path(TrialPath { id, trial }): Path<TrialPath>,
) -> Result<Json<TrialEndView>, Failure> {
    app.lab.flush(&id).await;
    let done = {
        let (app, id) = (app.clone(), id.clone());
        blocking(move || app.lab.session(&id)).await?.trials_done
    };
    let end = blocking(move || app.lab.store().trial_end(&id, trial)).await?;
    end.map(Json).ok_or_else(|| {
        Failure::not_found(format!("trial {trial} has not ended; {done} trials have")).at("trial")
    })
}

/// Which ticks.
#[derive(Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(super) struct TicksQuery {
    /// First tick; 1 when missing.
    from: Option<u64>,
    /// Last tick, at most 9,999 after the first; as far as that goes when missing.
    to: Option<u64>,
}

/// What `ticks` answers with, by the kind of session.
#[derive(utoipa::ToSchema)]
#[schema(as = TickOrStep)]
#[serde(untagged)]
#[expect(dead_code, reason = "it describes an answer that is copied from the log as it is")]
pub(super) enum TickOrStep {
    /// Of a robot's session.
    Ticks(Vec<TickView>),
    /// Of a tabular session.
    Steps(Vec<StepView>),
    /// Of a session of chapter 2.
    Cycles(Vec<CycleView>),
}

/// Control steps with their explanations
#[utoipa::path(get, path = "/sessions/{id}/ticks", tag = "results",
    params(("id" = String, Path, description = "Identifier"), TicksQuery),
    responses((status = 200, description = "`TickView`s; `StepView`s of a tabular session, `CycleView`s of one of chapter 2",
            body = TickOrStep), (status = 404, body = Problem), (status = 422, body = Problem)))]
pub(super) async fn ticks(
    State(app): State<App>,
    Path(id): Path<String>,
    Query(query): Query<TicksQuery>,
) -> Result<Response, Failure> {
    let from = query.from.unwrap_or(1);
    let to = query.to.unwrap_or(from.saturating_add(MOST_TICKS - 1));
    if from == 0 {
        return Err(Failure::not_acceptable("from", "ticks are counted from 1"));
    }
    if to < from {
        let detail = format!("must be at least `from`, which is {from}, not {to}");
        return Err(Failure::not_acceptable("to", detail));
    }
    if to - from >= MOST_TICKS {
        let detail = format!("at most {MOST_TICKS} ticks at once: up to {}", from + MOST_TICKS - 1);
        return Err(Failure::not_acceptable("to", detail));
    }
    app.lab.flush(&id).await;
    let json = blocking(move || {
        app.lab.session(&id)?;
        app.lab.store().ticks_json(&id, from, to).map_err(crate::session::LabError::from)
    });
    Ok(([(header::CONTENT_TYPE, "application/json")], json.await?).into_response())
}

/// All neurons as they are now, without their centres
#[utoipa::path(get, path = "/sessions/{id}/neurons", tag = "results",
    params(("id" = String, Path, description = "Identifier")),
    responses((status = 200, body = [NeuronView]), (status = 404, body = Problem)))]
pub(super) async fn neurons(
    State(app): State<App>,
    Path(id): Path<String>,
) -> Result<Json<Vec<NeuronView>>, Failure> {
    let feed = blocking(move || app.lab.feed(&id)).await?;
    let snapshot = feed.snapshot();
    let neurons = snapshot.present.path().map(|path| path.neurons.to_vec());
    Ok(Json(neurons.unwrap_or_default()))
}

/// One neuron as it is now: four parameters and birth certificate
#[utoipa::path(get, path = "/sessions/{id}/neurons/{neuron}", tag = "results",
    params(("id" = String, Path, description = "Identifier"),
        ("neuron" = u32, Path, description = "Its number in the session")),
    responses((status = 200, body = NeuronView), (status = 404, body = Problem)))]
pub(super) async fn neuron(
    State(app): State<App>,
    Path(NeuronPath { id, neuron }): Path<NeuronPath>,
) -> Result<Json<NeuronView>, Failure> {
    let found = app.lab.neuron(&id, neuron).await?;
    found.map(Json).ok_or_else(|| {
        Failure::not_found(format!("the session has no neuron {neuron} now")).at("neuron")
    })
}
