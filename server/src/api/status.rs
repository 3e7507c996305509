//! `/healthz` and `/metrics`.

use std::collections::BTreeMap;
use std::fmt::Write;

use axum::extract::State;
use axum::http::header;
use axum::response::{IntoResponse, Response};

use super::problem::Failure;
use super::{App, blocking};
use crate::process;
use crate::session::state_name;
use crate::wire::State as SessionState;

const STATES: [SessionState; 9] = [
    SessionState::Queued,
    SessionState::Starting,
    SessionState::Running,
    SessionState::Paused,
    SessionState::Stopping,
    SessionState::Stopped,
    SessionState::Finished,
    SessionState::Failed,
    SessionState::Interrupted,
];

/// Says that the server answers and can read its data folder.
pub(super) async fn health(State(app): State<App>) -> Result<&'static str, Failure> {
    blocking(move || app.lab.store().session("")).await.map(|_| "ok\n")
}

/// Numbers for Prometheus.
pub(super) async fn metrics(State(app): State<App>) -> Result<Response, Failure> {
    let lab = app.lab.clone();
    let sessions = blocking(move || lab.sessions()).await?;
    let mut text = String::new();
    let mut by_state: BTreeMap<&str, usize> =
        STATES.iter().map(|state| (state_name(*state), 0)).collect();
    for session in sessions {
        *by_state.entry(state_name(session.state)).or_default() += 1;
    }
    header_lines(&mut text, "sonarium_sessions", "gauge", "Sessions by state");
    for (state, count) in by_state {
        line(&mut text, &format!("sonarium_sessions{{state=\"{state}\"}}"), count);
    }
    let (ticks, frames) = (app.lab.ticks(), app.frames.drawn());
    metric(&mut text, "sonarium_ticks_total", "counter", "Control steps taken", ticks);
    metric(&mut text, "sonarium_viewers", "gauge", "Viewers connected", app.lab.viewers());
    metric(
        &mut text,
        "sonarium_frames_total",
        "counter",
        "Arena pictures drawn for viewers",
        frames,
    );
    if let Some(bytes) = process::resident_bytes() {
        metric(&mut text, "process_resident_memory_bytes", "gauge", "Resident memory", bytes);
    }
    if let Some(seconds) = process::cpu_seconds() {
        metric(&mut text, "process_cpu_seconds_total", "counter", "CPU time used", seconds);
    }
    let kind = "text/plain; version=0.0.4; charset=utf-8";
    Ok(([(header::CONTENT_TYPE, kind)], text).into_response())
}

fn metric(text: &mut String, name: &str, kind: &str, help: &str, value: impl std::fmt::Display) {
    header_lines(text, name, kind, help);
    line(text, name, value);
}

fn header_lines(text: &mut String, name: &str, kind: &str, help: &str) {
    // Writing to a string cannot fail.
    let _ = writeln!(text, "# HELP {name} {help}\n# TYPE {name} {kind}");
}

fn line(text: &mut String, name: &str, value: impl std::fmt::Display) {
    let _ = writeln!(text, "{name} {value}");
}
