//! What a client asks for, and whether it can have it.

use std::ops::RangeInclusive;

use serde_json::Value as Json;

use crate::catalog::FieldError;
use crate::wire::{ArenaRequest, ClientMessage};

/// Largest message a client may send, bytes.
pub const LARGEST_MESSAGE: usize = 64 << 10;

/// Rates a client gets before it asks.
const DEFAULT: Subscription = Subscription {
    tick: 10.0,
    depths: 10.0,
    neurons: 2.0,
    step: 10.0,
    table: 5.0,
    cycles: 10.0,
    arena: None,
};

/// Samples and pictures a second.
#[derive(Clone, Debug, PartialEq)]
pub struct Subscription {
    /// Most `tick` messages a second.
    pub tick: f64,
    /// Most `depths` messages a second.
    pub depths: f64,
    /// Most `neurons` messages a second.
    pub neurons: f64,
    /// Most `step` messages a second.
    pub step: f64,
    /// Most `table` messages a second.
    pub table: f64,
    /// Most `cycles` messages a second.
    pub cycles: f64,
    /// Arena pictures.
    pub arena: Option<ArenaRequest>,
}

impl Default for Subscription {
    fn default() -> Self {
        DEFAULT
    }
}

impl Subscription {
    /// Takes a client's message; what it does not name stays as it was.
    ///
    /// # Errors
    /// When the message cannot be read or asks for what there is not; nothing changes then. The field
    /// is empty when the message as a whole is at fault.
    pub fn apply(&mut self, text: &str) -> Result<(), FieldError> {
        let ClientMessage::Subscribe { tick, depths, neurons, step, table, cycles, arena } =
            read(text)?;
        let asked = Self {
            tick: rate("tick", tick.unwrap_or(self.tick), 0.0..=60.0)?,
            depths: rate("depths", depths.unwrap_or(self.depths), 0.0..=60.0)?,
            neurons: rate("neurons", neurons.unwrap_or(self.neurons), 0.0..=30.0)?,
            step: rate("step", step.unwrap_or(self.step), 0.0..=60.0)?,
            table: rate("table", table.unwrap_or(self.table), 0.0..=30.0)?,
            cycles: rate("cycles", cycles.unwrap_or(self.cycles), 0.0..=60.0)?,
            arena: arena.map(picture).transpose()?.or_else(|| self.arena.clone()),
        };
        *self = asked;
        Ok(())
    }
}

fn read(text: &str) -> Result<ClientMessage, FieldError> {
    let json: Json = serde_json::from_str(text)
        .map_err(|error| FieldError::new("", format!("the message is not JSON: {error}")))?;
    serde_json::from_value(json.clone()).map_err(|error| {
        let message = format!(
            "{error}; send e.g. {{\"type\":\"subscribe\",\"tick\":10,\"arena\":\
             {{\"rate\":15,\"width\":960,\"height\":640,\"theme\":\"light\"}}}}"
        );
        FieldError::new(culprit(&json), message)
    })
}

/// The field that alone makes the message unreadable.
fn culprit(json: &Json) -> String {
    let Json::Object(fields) = json else { return String::new() };
    if fields.get("type") != Some(&Json::from("subscribe")) {
        return "type".into();
    }
    let alone = |key: &String, value: &Json| serde_json::json!({ "type": "subscribe", key: value });
    let unreadable = |(key, value): &(&String, &Json)| {
        serde_json::from_value::<ClientMessage>(alone(key, value)).is_err()
    };
    let others = fields.iter().filter(|(key, _)| *key != "type");
    others.into_iter().find(unreadable).map_or_else(String::new, |(key, _)| key.clone())
}

fn picture(arena: ArenaRequest) -> Result<ArenaRequest, FieldError> {
    rate("arena.rate", arena.rate, 0.0..=30.0)?;
    for (field, pixels) in [("arena.width", arena.width), ("arena.height", arena.height)] {
        if !(64..=2048).contains(&pixels) {
            let message = format!("must be 64 to 2048 pixels, not {pixels}");
            return Err(FieldError::new(field, message));
        }
    }
    Ok(arena)
}

fn rate(field: &str, rate_hz: f64, allowed: RangeInclusive<f64>) -> Result<f64, FieldError> {
    if allowed.contains(&rate_hz) {
        return Ok(rate_hz);
    }
    let message =
        format!("must be {} to {} a second, not {rate_hz}", allowed.start(), allowed.end());
    Err(FieldError::new(field, message))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_are_taken_or_refused_by_field() {
        let picture = |fields: &str| {
            format!(r#"{{"type":"subscribe","arena":{{"rate":15,"theme":"dark",{fields}}}}}"#)
        };
        for (message, expected) in [
            (r#"{"type":"subscribe","tick":60}"#.to_owned(), Ok(())),
            (picture(r#""width":960,"height":640"#), Ok(())),
            (picture(r#""width":960,"height":63"#), Err("arena.height")),
            (picture(r#""width":960"#), Err("arena")),
            (r#"{"type":"subscribe","tick":61}"#.to_owned(), Err("tick")),
            (r#"{"type":"subscribe","tick":-1}"#.to_owned(), Err("tick")),
            (r#"{"type":"subscribe","depths":"fast"}"#.to_owned(), Err("depths")),
            (r#"{"type":"subscribe","sound":1}"#.to_owned(), Err("sound")),
            (r#"{"type":"order"}"#.to_owned(), Err("type")),
            (r#"{"tick":1}"#.to_owned(), Err("type")),
            ("[]".to_owned(), Err("")),
            ("not json".to_owned(), Err("")),
        ] {
            let mut subscription = Subscription::default();
            let result = subscription.apply(&message).map_err(|error| error.field);
            assert_eq!(result, expected.map_err(str::to_owned), "{message}");
            assert_eq!(subscription == DEFAULT, result.is_err(), "{message}");
        }
    }

    #[test]
    fn what_a_message_does_not_name_stays() {
        let mut subscription = Subscription::default();
        for message in [r#"{"type":"subscribe","tick":60}"#, r#"{"type":"subscribe","neurons":0}"#]
        {
            subscription.apply(message).expect("a good message");
        }
        let expected = Subscription { tick: 60.0, neurons: 0.0, ..DEFAULT };
        assert_eq!(subscription, expected);
    }
}
