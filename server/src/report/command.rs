//! The command that repeats a run.

use serde_json::Value;

use super::RunInfo;
use super::differences::same_value;
use super::number::value_text;

/// The command line that gives the same trials to the bit on the same build.
///
/// It names the preset, the world and every value that is not the preset's; one setting a line, so
/// that it can be read, printed and pasted into a POSIX shell.
pub(super) fn repeat_command(run: RunInfo) -> String {
    let session = run.session;
    let (seed, trials) = (session.seed, session.trials);
    let first =
        format!("sonarium run {} --seed {seed} --trials {trials}", word(&session.experiment));
    let mut lines = vec![first, set("preset", &session.preset)];
    // A tabular experiment may have no choice of worlds.
    if session.settings.contains_key("world") {
        lines.push(set("world", &session.world));
    }
    if session.settings.contains_key("network") {
        // The zip holds the file under this name.
        lines.push("--network network.json".to_owned());
    }
    for (key, value) in &session.settings {
        let named = matches!(key.as_str(), "preset" | "world" | "network");
        if !named && !preset_gives(run, key, value) {
            lines.push(set(key, &value_text(value)));
        }
    }
    lines.join(" \\\n    ")
}

fn set(key: &str, value: &str) -> String {
    format!("--set {}", word(&format!("{key}={value}")))
}

fn preset_gives(run: RunInfo, key: &str, value: &Value) -> bool {
    let default = || run.settings.iter().find(|info| info.key == key).map(|info| &info.default);
    let given = run.preset.settings.get(key).or_else(default);
    given.is_some_and(|given| same_value(given, value))
}

/// The text as one word of a POSIX shell.
fn word(text: &str) -> String {
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
        let command = repeat_command(sample::session_report().run());
        let lines: Vec<&str> = command.split(" \\\n    ").collect();
        assert_eq!(
            lines,
            [
                "sonarium run minimum-cost-path --seed 7 --trials 20",
                "--set preset=learner",
                "--set world=laboratory",
                "--set goal.radius=0.4",
            ]
        );
    }

    #[test]
    fn what_a_preset_gives_is_left_out_and_what_undoes_it_is_named() {
        let mut report = sample::session_report();
        report.preset.settings.insert("shortcut.push".into(), Value::from(false));
        assert!(repeat_command(report.run()).contains("--set shortcut.push=true"));
        report.session.settings.insert("shortcut.push".into(), Value::from(false));
        assert!(!repeat_command(report.run()).contains("shortcut.push"));
    }

    #[test]
    fn a_word_is_quoted_for_the_shell_only_when_it_must_be() {
        let table = [
            ("goal.radius=0.05", "goal.radius=0.05"),
            ("", "''"),
            ("two words", "'two words'"),
            ("it's; rm", r"'it'\''s; rm'"),
        ];
        for (text, in_the_shell) in table {
            assert_eq!(word(text), in_the_shell);
        }
    }
}
