//! The command that repeats a run.

use std::fmt::Write;

use serde_json::Value;

use super::SessionReport;
use super::differences::same_value;
use super::number::value_text;

/// The command line that gives the same trials to the bit on the same build.
///
/// It names the preset, the world and every value that is not the preset's.
pub(super) fn repeat_command(report: &SessionReport) -> String {
    let session = &report.session;
    let mut line = format!("sonarium run {}", quoted(&session.experiment));
    let _ = write!(line, " --seed {} --trials {}", session.seed, session.trials);
    let named = [("preset", &session.preset), ("world", &session.world)];
    for (key, name) in named {
        let _ = write!(line, " --set {key}={}", quoted(name));
    }
    for (key, value) in &session.settings {
        if key != "preset" && key != "world" && !preset_gives(report, key, value) {
            let _ = write!(line, " --set {key}={}", quoted(&value_text(value)));
        }
    }
    line
}

fn preset_gives(report: &SessionReport, key: &str, value: &Value) -> bool {
    let default = || report.settings.iter().find(|info| info.key == key).map(|info| &info.default);
    let given = report.preset.settings.get(key).or_else(default);
    given.is_some_and(|given| same_value(given, value))
}

/// The text as one word of a POSIX shell.
fn quoted(text: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "._-+/:,=@%".contains(c);
    if !text.is_empty() && text.chars().all(plain) {
        text.to_owned()
    } else {
        format!("'{}'", text.replace('\'', r"'\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::sample;

    #[test]
    fn the_command_names_what_the_preset_does_not_give() {
        assert_eq!(
            repeat_command(&sample::session_report()),
            "sonarium run minimum-cost-path --seed 7 --trials 20 --set preset=learner \
             --set world=laboratory --set goal.radius=0.4"
        );
    }

    #[test]
    fn what_a_preset_gives_is_left_out_and_what_undoes_it_is_named() {
        let mut report = sample::session_report();
        report.preset.settings.insert("band.proposal".into(), Value::from(false));
        assert!(
            repeat_command(&report).ends_with("--set band.proposal=true --set goal.radius=0.4")
        );
        report.session.settings.insert("band.proposal".into(), Value::from(false));
        assert!(!repeat_command(&report).contains("band.proposal"));
    }

    #[test]
    fn a_word_is_quoted_for_the_shell_only_when_it_must_be() {
        let table = [
            ("laboratory", "laboratory"),
            ("0.05", "0.05"),
            ("", "''"),
            ("two words", "'two words'"),
            ("it's; rm", r"'it'\''s; rm'"),
        ];
        for (text, word) in table {
            assert_eq!(quoted(text), word);
        }
    }
}
