//! `reproductions`: what the thesis shows and claims, computed again.

use std::sync::Arc;
use std::thread::available_parallelism;

use axum::Json;
use axum::extract::State;
use axum::http::header;
use axum::response::{IntoResponse, Response};
use serde::Deserialize;
use utoipa::IntoParams;

use super::App;
use super::arena::{Size, png};
use super::extract::{Path, Query};
use super::problem::Failure;
use crate::render::Quality;
use crate::reproduce::{
    Findings, ReproductionError, Shelf, TARGETS, Target, curves_csv, rows_csv, target,
};
use crate::wire::{Problem, Reproduction, ReproductionProgress, ReproductionTarget, ThemeName};

/// How a picture is drawn.
#[derive(Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(super) struct PictureQuery {
    /// Pixels, 1 to 4096; 720 when missing.
    width: Option<u32>,
    /// Pixels, 1 to 4096; 640 when missing.
    height: Option<u32>,
    /// Theme.
    #[serde(default)]
    #[param(inline)]
    theme: ThemeName,
}

/// All tables and figures that can be computed again
#[utoipa::path(get, path = "/reproductions", tag = "reproductions",
    responses((status = 200, body = [ReproductionTarget])))]
pub(super) async fn list() -> Json<Vec<ReproductionTarget>> {
    Json(TARGETS.iter().map(|target| target.info()).collect())
}

/// One of them, published figures beside ours
///
/// The first request computes it, in seconds to minutes; others wait for the same result. The
/// computation goes on when the one who asked leaves.
#[utoipa::path(get, path = "/reproductions/{target}", tag = "reproductions",
    params(("target" = String, Path, description = "Name of the target")),
    responses((status = 200, body = Reproduction), (status = 404, body = Problem)))]
pub(super) async fn one(Path(name): Path<String>) -> Result<Json<Reproduction>, Failure> {
    let (target, findings) = findings(&name).await?;
    Ok(Json(findings.wire(target)))
}

/// How far it is; starts nothing
#[utoipa::path(get, path = "/reproductions/{target}/progress", tag = "reproductions",
    params(("target" = String, Path, description = "Name of the target")),
    responses((status = 200, body = ReproductionProgress), (status = 404, body = Problem)))]
pub(super) async fn progress(
    Path(name): Path<String>,
) -> Result<Json<ReproductionProgress>, Failure> {
    Ok(Json(Shelf::of_process().progress(target(&name)?)?))
}

/// Its rows for a spreadsheet
#[utoipa::path(get, path = "/reproductions/{target}/rows.csv", tag = "reproductions",
    params(("target" = String, Path, description = "Name of the target")),
    responses((status = 200, content_type = "text/csv", body = String),
        (status = 404, body = Problem)))]
pub(super) async fn rows(Path(name): Path<String>) -> Result<Response, Failure> {
    let (target, findings) = findings(&name).await?;
    Ok(csv(target, "rows", rows_csv(&findings.rows)))
}

/// Its curves for a spreadsheet
#[utoipa::path(get, path = "/reproductions/{target}/curves.csv", tag = "reproductions",
    params(("target" = String, Path, description = "Name of the target")),
    responses((status = 200, content_type = "text/csv", body = String),
        (status = 404, body = Problem)))]
pub(super) async fn curves(Path(name): Path<String>) -> Result<Response, Failure> {
    let (target, findings) = findings(&name).await?;
    Ok(csv(target, "curves", curves_csv(&findings.curves)))
}

/// One of its pictures
#[utoipa::path(get, path = "/reproductions/{target}/pictures/{name}", tag = "reproductions",
    params(("target" = String, Path, description = "Name of the target"),
        ("name" = String, Path, description = "Name of the picture, with or without `.png`"),
        PictureQuery),
    responses((status = 200, content_type = "image/png", body = [u8]), (status = 404, body = Problem),
        (status = 422, body = Problem)))]
pub(super) async fn picture(
    State(app): State<App>,
    Path((target, name)): Path<(String, String)>,
    Query(query): Query<PictureQuery>,
) -> Result<Response, Failure> {
    let size = Size::new(query.width.unwrap_or(720), query.height.unwrap_or(640))?;
    let (_, findings) = findings(&target).await?;
    let view = findings.picture(name.trim_end_matches(".png"))?.view.clone();
    png(&app, view, size, query.theme, Quality::Balanced).await
}

async fn findings(name: &str) -> Result<(&'static Target, Arc<Findings>), Failure> {
    let target = target(name)?;
    Ok((target, Shelf::of_process().findings(target, threads()).await?))
}

/// Half of what there is: sessions go on meanwhile.
fn threads() -> usize {
    available_parallelism().map_or(1, |cores| cores.get() / 2)
}

fn csv(target: &Target, what: &str, text: String) -> Response {
    let disposition = format!("attachment; filename=\"{}-{what}.csv\"", target.name);
    let headers = [
        (header::CONTENT_TYPE, "text/csv; charset=utf-8".to_owned()),
        (header::CONTENT_DISPOSITION, disposition),
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff".to_owned()),
    ];
    (headers, text).into_response()
}

impl From<ReproductionError> for Failure {
    fn from(error: ReproductionError) -> Self {
        match error {
            ReproductionError::Unknown { .. } => Self::not_found(error.to_string()).at("target"),
            ReproductionError::NoPicture { .. } => Self::not_found(error.to_string()).at("name"),
            ReproductionError::Broken(_) => Self::internal(error.to_string()),
        }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::testing::House;

    #[tokio::test]
    async fn a_result_is_computed_once_for_all_who_ask() {
        let house = House::new();
        let path = "/api/v1/reproductions/table-5.1";
        let (one, other) = tokio::join!(house.get(path), house.get(path));
        assert_eq!(one.status, 200, "{}", one.json());
        assert_eq!(one.json()["target"], "table-5.1");
        assert_eq!(one.json()["rows"].as_array().map(Vec::len), Some(21));
        assert_eq!(one.bytes, other.bytes);
        let progress = house.get("/api/v1/reproductions/table-5.1/progress").await.json();
        assert_eq!(progress["state"], "done");
        assert_eq!((&progress["done"], &progress["of"]), (&json!(600), &json!(600)), "once");
        let csv = house.get("/api/v1/reproductions/table-5.1/rows.csv").await;
        assert_eq!(String::from_utf8_lossy(&csv.bytes).lines().count(), 22, "a header and 21 rows");
    }

    #[tokio::test]
    async fn targets_are_listed_and_unknown_ones_refused() {
        let house = House::new();
        let list = house.get("/api/v1/reproductions").await.json();
        assert_eq!(list[0]["name"], "table-5.1");
        assert_eq!(
            (&list[0]["first_seed"], &list[0]["last_seed"]),
            (&json!(700_000), &json!(700_199))
        );
        for end in ["", "/progress", "/rows.csv", "/curves.csv", "/pictures/default-first"] {
            let answer = house.get(&format!("/api/v1/reproductions/table-9.9{end}")).await;
            assert_eq!((answer.status.as_u16(), &answer.json()["field"]), (404, &json!("target")));
        }
    }
}
