//! Values of settings, between JSON, TOML, the command line and the core.

use std::collections::BTreeMap;

use serde_json::Value as Json;
use sonarium_core::settings::Value;

/// A setting's value as JSON.
#[must_use]
pub(super) fn to_json(value: Option<&Value>) -> Json {
    match value {
        Some(Value::Switch(on)) => Json::from(*on),
        Some(Value::Integer(number)) => Json::from(*number),
        Some(Value::Number(number)) => Json::from(*number),
        Some(Value::Choice(name)) => Json::from(name.as_str()),
        None => Json::Null,
    }
}

/// JSON as a setting's value; none for what no setting can be.
#[must_use]
pub(super) fn from_json(json: &Json) -> Option<Value> {
    match json {
        Json::Bool(on) => Some(Value::Switch(*on)),
        Json::Number(number) => match number.as_i64() {
            Some(whole) => Some(Value::Integer(whole)),
            None => number.as_f64().map(Value::Number),
        },
        Json::String(name) => Some(Value::Choice(name.clone())),
        Json::Null | Json::Array(_) | Json::Object(_) => None,
    }
}

/// The value in `--set key=value`: a switch or a number where it reads as one, else a name.
#[must_use]
pub fn from_text(text: &str) -> Json {
    if let Ok(on) = text.parse::<bool>() {
        return Json::from(on);
    }
    if let Ok(whole) = text.parse::<i64>() {
        return Json::from(whole);
    }
    match text.parse::<f64>() {
        Ok(number) if number.is_finite() => Json::from(number),
        _ => Json::from(text),
    }
}

/// A TOML table as settings: `sonar.noise = 0.1` is a table in a table and becomes one key.
#[must_use]
pub fn flatten(table: toml::Table) -> BTreeMap<String, Json> {
    let mut settings = BTreeMap::new();
    flatten_into(&mut settings, "", table);
    settings
}

fn flatten_into(settings: &mut BTreeMap<String, Json>, prefix: &str, table: toml::Table) {
    for (name, value) in table {
        let key = if prefix.is_empty() { name } else { format!("{prefix}.{name}") };
        match value {
            toml::Value::Table(inner) => flatten_into(settings, &key, inner),
            value => {
                settings.insert(key, from_toml(value));
            }
        }
    }
}

/// TOML as JSON. No setting is a list, a table or a date; as null it is refused with the key's name.
pub(super) fn from_toml(value: toml::Value) -> Json {
    match value {
        toml::Value::Boolean(on) => Json::from(on),
        toml::Value::Integer(whole) => Json::from(whole),
        toml::Value::Float(number) => Json::from(number),
        toml::Value::String(name) => Json::from(name),
        toml::Value::Array(_) | toml::Value::Table(_) | toml::Value::Datetime(_) => Json::Null,
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn text_reads_as_the_nearest_type() {
        for (text, expected) in [
            ("true", json!(true)),
            ("7", json!(7)),
            ("0.05", json!(0.05)),
            ("-3", json!(-3)),
            ("heading", json!("heading")),
            ("NaN", json!("NaN")),
            ("", json!("")),
        ] {
            assert_eq!(from_text(text), expected, "{text:?}");
        }
    }

    #[test]
    fn tables_become_dotted_keys() {
        let table =
            "world = \"laboratory\"\nsonar.noise = 0.1\n[learner]\nlearning = false\n\"x.y\" = 1"
                .parse::<toml::Table>()
                .expect("valid TOML");
        let settings = flatten(table);
        assert_eq!(
            json!(settings),
            json!({
                "world": "laboratory", "sonar.noise": 0.1, "learner.learning": false, "learner.x.y": 1,
            })
        );
    }
}
