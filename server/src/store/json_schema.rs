//! JSON schemas of the log's channels, from the same types the records are written with.

use std::collections::BTreeMap;

use serde_json::{Map, Value, json};
use utoipa::ToSchema;

use super::record::{LogHeader, Topic};
use crate::wire::{
    CycleView, DriveRunView, EpisodeView, LogEntry, StepView, TickView, TrialEndView,
};

/// Name and text of a channel's JSON schema.
pub(super) fn of_topic(topic: Topic) -> (String, Vec<u8>) {
    match topic {
        Topic::Session => of_type::<LogHeader>(),
        Topic::Tick => of_type::<TickView>(),
        Topic::Trial => of_type::<TrialEndView>(),
        Topic::Event => of_type::<LogEntry>(),
        Topic::Step => of_type::<StepView>(),
        Topic::Episode => of_type::<EpisodeView>(),
        Topic::Cycle => of_type::<CycleView>(),
        Topic::Run => of_type::<DriveRunView>(),
    }
}

/// Name and text of a type's JSON schema, with every reference replaced by what it refers to:
/// viewers of MCAP files differ in the references they follow.
fn of_type<T: ToSchema>() -> (String, Vec<u8>) {
    let mut parts = Vec::new();
    T::schemas(&mut parts);
    let parts: BTreeMap<String, Value> =
        parts.into_iter().map(|(name, schema)| (name, json!(schema))).collect();
    let mut schema = Map::new();
    schema.insert("$schema".into(), json!("https://json-schema.org/draft/2020-12/schema"));
    schema.insert("title".into(), json!(T::name()));
    if let Value::Object(body) = inlined(json!(T::schema()), &parts) {
        schema.extend(body);
    }
    (T::name().into_owned(), Value::Object(schema).to_string().into_bytes())
}

fn inlined(schema: Value, parts: &BTreeMap<String, Value>) -> Value {
    match schema {
        Value::Object(map) => match referred(&map, parts) {
            Some(part) => inlined(part, parts),
            None => map.into_iter().map(|(key, value)| (key, inlined(value, parts))).collect(),
        },
        Value::Array(items) => items.into_iter().map(|item| inlined(item, parts)).collect(),
        plain => plain,
    }
}

fn referred(map: &Map<String, Value>, parts: &BTreeMap<String, Value>) -> Option<Value> {
    let name = map.get("$ref")?.as_str()?.rsplit('/').next()?;
    let mut part = parts.get(name)?.clone();
    if let (Some(description), Some(part)) = (map.get("description"), part.as_object_mut()) {
        part.insert("description".into(), description.clone());
    }
    Some(part)
}
