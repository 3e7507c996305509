//! Numbers and short values as people read them.

use serde_json::Value;

use crate::wire::State;

/// What stands where there is no value.
pub(super) const NOTHING: &str = "–";

/// A number with a fixed count of decimals and a real minus sign; `-0.00` reads `0.00`.
pub(super) fn fixed(value: f64, decimals: usize) -> String {
    if !value.is_finite() {
        return NOTHING.to_owned();
    }
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.chars().all(|c| c == '0' || c == '.') => digits.to_owned(),
        Some(digits) => format!("−{digits}"),
        None => text,
    }
}

/// [`fixed`], or a dash where there is no value.
pub(super) fn fixed_or_nothing(value: Option<f64>, decimals: usize) -> String {
    value.map_or_else(|| NOTHING.to_owned(), |value| fixed(value, decimals))
}

/// A count, or a dash where there is no value.
pub(super) fn count_or_nothing(value: Option<impl ToString>) -> String {
    value.map_or_else(|| NOTHING.to_owned(), |value| value.to_string())
}

/// A whole number with thin spaces between its thousands.
pub(super) fn grouped(value: u64) -> String {
    let digits = value.to_string();
    let mut text = String::with_capacity(digits.len() + digits.len() / 3 * 3);
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

/// The value of a setting as it is typed.
pub(super) fn value_text(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        other => other.to_string(),
    }
}

/// The value of a setting as it is read: switches say on or off.
pub(super) fn value_for_people(value: &Value) -> String {
    match value {
        Value::Bool(true) => "on".to_owned(),
        Value::Bool(false) => "off".to_owned(),
        Value::Number(number) if number.is_f64() => plain(number.as_f64().unwrap_or(f64::NAN)),
        Value::Number(number) => number.to_string().replace('-', "−"),
        other => value_text(other),
    }
}

/// A number without decimals that say nothing: `90`, not `90.0`.
fn plain(value: f64) -> String {
    value.to_string().replace('-', "−")
}

/// The state in sentence case.
pub(super) fn state_text(state: State) -> &'static str {
    match state {
        State::Queued => "Queued",
        State::Starting => "Starting",
        State::Running => "Running",
        State::Paused => "Paused",
        State::Stopping => "Stopping",
        State::Stopped => "Stopped",
        State::Finished => "Finished",
        State::Failed => "Failed",
        State::Interrupted => "Interrupted",
    }
}

/// An RFC 3339 time in UTC as it is read: `2026-01-31 09:05:00 UTC`.
pub(super) fn time_text(rfc3339: &str) -> String {
    let seconds = rfc3339.get(..19).zip(rfc3339.get(10..11)).filter(|(_, t)| *t == "T");
    match seconds {
        Some((text, _)) if rfc3339.ends_with('Z') => format!("{} UTC", text.replace('T', " ")),
        _ => rfc3339.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_as_people_write_them() {
        assert_eq!(fixed(-6.404, 2), "−6.40");
        assert_eq!(fixed(-0.001, 2), "0.00");
        assert_eq!(fixed(12.0, 0), "12");
        assert_eq!(fixed(f64::NAN, 2), NOTHING);
        assert_eq!(fixed_or_nothing(None, 2), NOTHING);
        assert_eq!(grouped(999), "999");
        assert_eq!(grouped(1_234_567), "1\u{202f}234\u{202f}567");
    }

    #[test]
    fn values_read_as_people_write_them() {
        assert_eq!(value_for_people(&Value::from(true)), "on");
        assert_eq!(value_for_people(&Value::from(-0.4)), "−0.4");
        assert_eq!(value_for_people(&Value::from(90.0)), "90");
        assert_eq!(value_for_people(&Value::from(-3)), "−3");
        assert_eq!(value_text(&Value::from(-0.4)), "-0.4");
        assert_eq!(value_text(&Value::from("laboratory")), "laboratory");
    }

    #[test]
    fn a_time_loses_its_letters_and_what_is_no_time_stays() {
        assert_eq!(time_text("2026-01-31T09:05:00.125Z"), "2026-01-31 09:05:00 UTC");
        assert_eq!(time_text("2026-01-31T09:05:00+01:00"), "2026-01-31T09:05:00+01:00");
        assert_eq!(time_text("yesterday"), "yesterday");
    }
}
