//! `calibration`: the deviation ς of a sonar for a level of noise, Eq. (2.8).

use axum::Json;
use axum::body::Body;
use axum::extract::State;
use axum::response::Response;

use super::extract::{Path, Query};
use super::files::{download, format_of, no_such_file};
use super::problem::Failure;
use super::{App, blocking};
use crate::calibration::calibrate;
use crate::report;
use crate::wire::{CalibrationQuestion, CalibrationView, Problem};

const FILES: [&str; 3] = ["report.html", "report.json", "report.csv"];

/// The deviation ς of a sonar that is alone, at five places: Eq. (2.8)
#[utoipa::path(get, path = "/calibration", tag = "examples", params(CalibrationQuestion),
    responses((status = 200, body = CalibrationView), (status = 400, body = Problem),
        (status = 422, body = Problem)))]
pub(super) async fn one(
    State(app): State<App>,
    Query(asked): Query<CalibrationQuestion>,
) -> Result<Json<CalibrationView>, Failure> {
    Ok(Json(take(app, asked).await?))
}

/// Its report: `report.html`, `report.json` or `report.csv`
#[utoipa::path(get, path = "/calibration/{file}", tag = "examples",
    params(("file" = String, Path, description = "`report.html`, `report.json` or `report.csv`"),
        CalibrationQuestion),
    responses((status = 200, description = "The file"), (status = 404, body = Problem),
        (status = 422, body = Problem)))]
pub(super) async fn file(
    State(app): State<App>,
    Path(file): Path<String>,
    Query(asked): Query<CalibrationQuestion>,
) -> Result<Response, Failure> {
    let format = format_of(&file, &FILES).ok_or_else(|| no_such_file(&file, &FILES))?;
    let view = take(app, asked).await?;
    let text = match format {
        "html" => report::calibration_html(&view),
        "json" => report::calibration_json(&view),
        _ => report::calibration_csv(&view),
    };
    Ok(download(&format!("sonarium-calibration.{format}"), format, Body::from(text)))
}

async fn take(app: App, asked: CalibrationQuestion) -> Result<CalibrationView, Failure> {
    blocking(move || -> Result<CalibrationView, Failure> {
        let catalog = app.lab.catalog();
        let equipment = catalog.equipment().ok_or_else(|| Failure::internal("no robot"))?;
        Ok(calibrate(equipment, asked)?)
    })
    .await
}

#[cfg(test)]
mod tests {
    use axum::http::StatusCode;

    use crate::testing::House;
    use crate::wire::CalibrationView;

    #[tokio::test]
    async fn a_calibration_and_its_reports_are_of_the_same_pairs() {
        let house = House::new();
        let answer = house.get("/api/v1/calibration?pairs=30&noise=2&seed=7").await;
        let view: CalibrationView = serde_json::from_slice(&answer.bytes).expect("an answer");
        assert_eq!((view.asked.noise, view.asked.seed, view.all.n), (2.0, 7, 150));
        let path = "/api/v1/calibration/report.json?pairs=30&noise=2&seed=7";
        let report = house.get(path).await;
        assert_eq!(report.json()["deviation_m"]["value"], view.deviation_m.value);
        for (file, kind) in [("report.html", "text/html"), ("report.csv", "text/csv")] {
            let answer = house.get(&format!("/api/v1/calibration/{file}?pairs=2")).await;
            assert!(answer.kind.starts_with(kind), "{file}: {}", answer.kind);
        }
    }

    #[tokio::test]
    async fn what_cannot_be_calibrated_is_named() {
        let house = House::new();
        for (address, status, field) in [
            ("calibration?noise=21", 422, "noise"),
            ("calibration?pairs=1", 422, "pairs"),
            ("calibration?factor=0.9", 422, "factor"),
            ("calibration/report.csv?pairs=200000", 422, "pairs"),
            ("calibration?pairs=many", 400, "pairs"),
            ("calibration/report.doc", 404, "file"),
        ] {
            let answer = house.get(&format!("/api/v1/{address}")).await;
            assert_eq!(answer.status, StatusCode::from_u16(status).expect("a status"), "{address}");
            assert_eq!(answer.json()["field"], field, "{address}");
        }
    }
}
