//! `reproductions`: the thesis's tables, computed again.

use std::thread::available_parallelism;

use axum::Json;
use tokio::sync::OnceCell;

use super::blocking;
use super::extract::Path;
use super::problem::Failure;
use crate::reproduce::{ReproductionError, TARGETS, Target, target};
use crate::wire::{Problem, Reproduction, ReproductionTarget};

/// Results in the order of [`TARGETS`]. They follow from the build alone, so one computation serves the
/// whole process.
static RESULTS: [OnceCell<Reproduction>; TARGETS.len()] =
    [const { OnceCell::const_new() }; TARGETS.len()];

/// All tables and figures that can be computed again
#[utoipa::path(get, path = "/reproductions", tag = "reproductions",
    responses((status = 200, body = [ReproductionTarget])))]
pub(super) async fn list() -> Json<Vec<ReproductionTarget>> {
    Json(TARGETS.map(Target::info).to_vec())
}

/// One of them, published figures beside ours
///
/// The first request computes it, in seconds; others wait for the same result.
#[utoipa::path(get, path = "/reproductions/{target}", tag = "reproductions",
    params(("target" = String, Path, description = "Name of the target")),
    responses((status = 200, body = Reproduction), (status = 404, body = Problem)))]
pub(super) async fn one(Path(name): Path<String>) -> Result<Json<Reproduction>, Failure> {
    let target = target(&name)?;
    // A task of its own, so that a visitor who leaves does not undo the work for those who wait.
    let result = tokio::spawn(result(target)).await;
    result.map_err(|error| Failure::internal(error.to_string()))?.map(Json)
}

async fn result(target: &'static Target) -> Result<Reproduction, Failure> {
    let place = TARGETS.iter().position(|known| known.name == target.name);
    let cell = place.and_then(|place| RESULTS.get(place));
    let cell = cell.ok_or_else(|| Failure::internal("a target without a place"))?;
    let compute = || blocking(|| target.run(threads(), &|| ()));
    cell.get_or_try_init(compute).await.cloned()
}

/// Half of what there is: sessions go on meanwhile.
fn threads() -> usize {
    available_parallelism().map_or(1, |cores| cores.get() / 2)
}

impl From<ReproductionError> for Failure {
    fn from(error: ReproductionError) -> Self {
        match error {
            ReproductionError::Unknown { .. } => Self::not_found(error.to_string()).at("target"),
            ReproductionError::Catalog(_) | ReproductionError::Field(_) => {
                Self::internal(error.to_string())
            }
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
        assert!(super::RESULTS[0].initialized(), "kept for the next");
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
        let answer = house.get("/api/v1/reproductions/table-9.9").await;
        assert_eq!((answer.status.as_u16(), &answer.json()["field"]), (404, &json!("target")));
    }
}
