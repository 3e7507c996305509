//! `rules/{name}`: a rule base, rule by rule.

use axum::Json;
use axum::extract::State;

use super::App;
use super::extract::Path;
use super::problem::Failure;
use crate::session::rule_list;
use crate::wire::{Problem, RuleList};

/// A rule base, rule by rule
#[utoipa::path(get, path = "/rules/{name}", tag = "experiments",
    params(("name" = String, Path, description = "Name, e.g. `navigator`")),
    responses((status = 200, body = RuleList), (status = 404, body = Problem)))]
pub(super) async fn one(
    State(app): State<App>,
    Path(name): Path<String>,
) -> Result<Json<RuleList>, Failure> {
    let rules = app.lab.catalog().rules();
    match rules.iter().find(|rules| rules.name() == name) {
        Some(rules) => Ok(Json(rule_list(rules))),
        None => {
            let names: Vec<&str> = rules.iter().map(|rules| rules.name()).collect();
            let detail = format!("there is no rule base {name}; there is {}", names.join(", "));
            Err(Failure::not_found(detail).at("name"))
        }
    }
}
