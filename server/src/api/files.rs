//! Reports and logs to download.

use std::fs::File;
use std::io::{self, Read};

use axum::body::Body;
use axum::extract::State;
use axum::http::header;
use axum::response::{IntoResponse, Response};
use serde::Deserialize;

use super::extract::Path;
use super::problem::Failure;
use super::{App, blocking};
use crate::report;
use crate::session::ReportError;
use crate::wire::Problem;

/// Formats of a session's report.
const SESSION_FILES: [&str; 4] = ["report.html", "report.json", "report.csv", "report.zip"];
/// Formats of a trial's report.
const TRIAL_FILES: [&str; 4] = ["report.html", "report.json", "report.csv", "report.png"];

/// A report of a session: `report.html`, `report.json`, `report.csv` or `report.zip` with everything
#[utoipa::path(get, path = "/sessions/{id}/{file}", tag = "reports",
    params(("id" = String, Path, description = "Identifier"),
        ("file" = String, Path, description = "`report.html`, `report.json`, `report.csv` or `report.zip`")),
    responses((status = 200, description = "The file"), (status = 404, body = Problem)))]
pub(super) async fn session(
    State(app): State<App>,
    Path((id, file)): Path<(String, String)>,
) -> Result<Response, Failure> {
    let Some(format) = format_of(&file, &SESSION_FILES) else {
        return Err(no_such_file(
            &file,
            &[&SESSION_FILES[..], &["log.mcap", "arena.png", "network"]].concat(),
        ));
    };
    app.lab.flush(&id).await;
    let name = format!("sonarium-{id}.{format}");
    let bytes = blocking(move || session_file(&app, &id, format)).await?;
    Ok(download(&name, format, Body::from(bytes)))
}

/// A file of a trial.
#[derive(Deserialize)]
pub(super) struct TrialFile {
    id: String,
    trial: u32,
    file: String,
}

/// A report of a trial: `report.html`, `report.json`, `report.csv` or `report.png`
#[utoipa::path(get, path = "/sessions/{id}/trials/{trial}/{file}", tag = "reports",
    params(("id" = String, Path, description = "Identifier"),
        ("trial" = u32, Path, description = "Number, from 1"),
        ("file" = String, Path, description = "`report.html`, `report.json`, `report.csv` or `report.png`")),
    responses((status = 200, description = "The file"), (status = 404, body = Problem)))]
pub(super) async fn trial(
    State(app): State<App>,
    Path(TrialFile { id, trial, file }): Path<TrialFile>,
) -> Result<Response, Failure> {
    let Some(format) = format_of(&file, &TRIAL_FILES) else {
        return Err(no_such_file(&file, &TRIAL_FILES));
    };
    app.lab.flush(&id).await;
    let name = format!("sonarium-{id}-trial-{trial:03}.{format}");
    let bytes = blocking(move || trial_file(&app, &id, trial, format)).await?;
    Ok(download(&name, format, Body::from(bytes)))
}

/// The session's log: every control step with its explanation, as MCAP
#[utoipa::path(get, path = "/sessions/{id}/log.mcap", tag = "reports",
    params(("id" = String, Path, description = "Identifier")),
    responses((status = 200, content_type = "application/octet-stream", body = [u8]),
        (status = 404, body = Problem)))]
pub(super) async fn log(
    State(app): State<App>,
    Path(id): Path<String>,
) -> Result<Response, Failure> {
    app.lab.flush(&id).await;
    let name = format!("sonarium-{id}.mcap");
    let bytes = blocking(move || read_log(&app, &id)).await?;
    let bytes =
        bytes.ok_or_else(|| Failure::not_found("the session has no log before its first tick"))?;
    Ok(download(&name, "mcap", Body::from(bytes)))
}

fn session_file(app: &App, id: &str, format: &str) -> Result<Vec<u8>, Failure> {
    if let Some(report) = app.reporter().drive(id)? {
        return Ok(match format {
            "html" => report::drive_html(&report).into_bytes(),
            "json" => report::drive_json(&report).into_bytes(),
            "csv" => report::drive_csv(&report).into_bytes(),
            _ => {
                let mut log = open_log(app, id)?;
                let log = log.as_mut().map(|file| file as &mut dyn Read);
                let written = report::drive_zip(&report, log, io::Cursor::new(Vec::new()));
                let written = written.map(io::Cursor::into_inner);
                written.map_err(|error| Failure::internal(error.to_string()))?
            }
        });
    }
    if let Some(report) = app.reporter().table(id)? {
        return Ok(match format {
            "html" => report::table_html(&report).into_bytes(),
            "json" => report::table_json(&report).into_bytes(),
            "csv" => report::table_csv(&report).into_bytes(),
            _ => table_zip(app, id, &report)?,
        });
    }
    let report = app.reporter().session(id)?;
    Ok(match format {
        "html" => report::html(&report).into_bytes(),
        "json" => report::json(&report).into_bytes(),
        "csv" => report::csv(&report).into_bytes(),
        _ => zip(app, id, &report)?,
    })
}

fn zip(app: &App, id: &str, session: &report::SessionReport) -> Result<Vec<u8>, Failure> {
    let trial = |trial: u32| match app.reporter().trial(id, trial) {
        Ok(report) => Ok(Some(report)),
        Err(ReportError::NoTrial { .. }) => Ok(None),
        Err(error) => Err(io::Error::other(error)),
    };
    let mut log = open_log(app, id)?;
    let log = log.as_mut().map(|file| file as &mut dyn Read);
    let target = io::Cursor::new(Vec::new());
    let written = report::zip(session, trial, log, target);
    written.map(io::Cursor::into_inner).map_err(|error| Failure::internal(error.to_string()))
}

fn table_zip(app: &App, id: &str, session: &report::TableReport) -> Result<Vec<u8>, Failure> {
    let mut log = open_log(app, id)?;
    let log = log.as_mut().map(|file| file as &mut dyn Read);
    let written = report::table_zip(session, log, io::Cursor::new(Vec::new()));
    written.map(io::Cursor::into_inner).map_err(|error| Failure::internal(error.to_string()))
}

fn open_log(app: &App, id: &str) -> Result<Option<File>, Failure> {
    match File::open(app.lab.store().log_path(id)) {
        Ok(file) => Ok(Some(file)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(Failure::internal(error.to_string())),
    }
}

fn trial_file(app: &App, id: &str, trial: u32, format: &str) -> Result<Vec<u8>, Failure> {
    let report = app.reporter().trial(id, trial)?;
    Ok(match format {
        "html" => report::trial_html(&report).into_bytes(),
        "json" => report::trial_json(&report).into_bytes(),
        "csv" => report::trial_csv(&report).into_bytes(),
        _ => report.picture.map(|picture| picture.png).unwrap_or_default(),
    })
}

fn read_log(app: &App, id: &str) -> Result<Option<Vec<u8>>, Failure> {
    app.lab.session(id)?;
    match std::fs::read(app.lab.store().log_path(id)) {
        Ok(bytes) => Ok(Some(bytes)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(Failure::internal(error.to_string())),
    }
}

/// The ending of a file that there is.
pub(super) fn format_of(file: &str, known: &[&'static str]) -> Option<&'static str> {
    let known = known.iter().find(|known| **known == file)?;
    known.rsplit_once('.').map(|(_, ending)| ending)
}

pub(super) fn no_such_file(file: &str, known: &[&str]) -> Failure {
    Failure::not_found(format!("there is no {file}; there are {}", known.join(", "))).at("file")
}

/// A file that a browser shows if it can and saves under a good name.
pub(super) fn download(name: &str, format: &str, body: Body) -> Response {
    let (kind, way) = match format {
        "html" => ("text/html; charset=utf-8", "inline"),
        "png" => ("image/png", "inline"),
        "json" => ("application/json", "attachment"),
        "csv" => ("text/csv; charset=utf-8", "attachment"),
        "txt" => ("text/plain; charset=utf-8", "attachment"),
        "zip" => ("application/zip", "attachment"),
        _ => ("application/octet-stream", "attachment"),
    };
    let disposition = format!("{way}; filename=\"{name}\"");
    let headers = [
        (header::CONTENT_TYPE, kind.to_owned()),
        (header::CONTENT_DISPOSITION, disposition),
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff".to_owned()),
    ];
    (headers, body).into_response()
}

impl From<ReportError> for Failure {
    fn from(error: ReportError) -> Self {
        match error {
            ReportError::Lab(error) => error.into(),
            ReportError::Render(error) => error.into(),
            ReportError::NoTrial { .. } | ReportError::NoRun { .. } => {
                Self::not_found(error.to_string()).at("trial")
            }
        }
    }
}
