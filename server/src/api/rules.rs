//! `rules/{name}`: a rule base, rule by rule or as a file.

use axum::Json;
use axum::body::Body;
use axum::extract::State;
use axum::response::{IntoResponse, Response};

use super::App;
use super::extract::Path;
use super::files::download;
use super::problem::Failure;
use crate::session::rule_list;
use crate::wire::{Problem, RuleList};

/// A rule base, rule by rule; with `.rules` or `.fll` after its name, as a file
#[utoipa::path(get, path = "/rules/{name}", tag = "experiments",
    params(("name" = String, Path, description = "Name, e.g. `navigator`, `navigator.rules` or `navigator.fll`")),
    responses((status = 200, body = RuleList), (status = 404, body = Problem)))]
pub(super) async fn one(
    State(app): State<App>,
    Path(name): Path<String>,
) -> Result<Response, Failure> {
    let (base, form) = match name.rsplit_once('.') {
        Some((base, form @ ("rules" | "fll"))) => (base, Some(form)),
        _ => (name.as_str(), None),
    };
    let known = app.lab.catalog().rules();
    let Some(rules) = known.iter().find(|rules| rules.name() == base) else {
        let names: Vec<&str> = known.iter().map(|rules| rules.name()).collect();
        let detail = format!("there is no rule base {base}; there is {}", names.join(", "));
        return Err(Failure::not_found(detail).at("name"));
    };
    Ok(match form {
        None => Json(rule_list(rules)).into_response(),
        Some("fll") => download(&name, "txt", Body::from(rules.to_fll())),
        Some(_) => download(&name, "txt", Body::from(rules.to_text())),
    })
}

#[cfg(test)]
mod tests {
    use sonarium_core::fuzzy::RuleBase;

    use crate::testing::House;

    #[tokio::test]
    async fn the_files_hold_the_rules_that_are_listed() {
        let house = House::new();
        let listed = house.get("/api/v1/rules/navigator").await.json();
        assert_eq!(listed["rules"].as_array().map(Vec::len), Some(972));
        for form in ["rules", "fll"] {
            let file = house.get(&format!("/api/v1/rules/navigator.{form}")).await;
            assert!(file.kind.starts_with("text/plain"), "{}", file.kind);
            let rules = RuleBase::from_text(&String::from_utf8_lossy(&file.bytes));
            let rules = rules.expect("sound rules");
            assert_eq!(rules.rules().len(), 972);
            let first = rules.evaluate(&[2.0, 2.0, 2.0, 2.0, 2.0, 12.0]);
            assert_eq!(first, [15.0, 0.0], "all is safe and it drives fast");
        }
        let missing = house.get("/api/v1/rules/nobody.fll").await;
        assert_eq!((missing.status.as_u16(), &missing.json()["field"]), (404, &"name".into()));
    }
}
