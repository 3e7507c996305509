//! The text that explains the files of an archive.

use std::collections::BTreeSet;

use super::command::repeat_command;
use super::csv::column_meanings;
use super::number::state_text;
use super::{FORMAT_VERSION, SessionReport};

/// What each file is, which trials are missing, and how to run it again.
pub(super) fn text(report: &SessionReport, names: &BTreeSet<String>, missing: &[u32]) -> String {
    let session = &report.session;
    let mut text = format!(
        "{}: report of session {}\n\
         State {}, seed {}, preset {}, world {}, build {}\n\n\
         Files\n",
        report.title,
        session.id,
        state_text(session.state).to_lowercase(),
        session.seed,
        session.preset,
        session.world,
        session.build,
    );
    for (name, meaning) in explained(names) {
        text += &format!("  {name:<24} {meaning}\n");
    }
    if !missing.is_empty() {
        let list: Vec<String> = missing.iter().map(u32::to_string).collect();
        text += &format!("\nThe log no longer holds the ticks of trials {}.\n", list.join(", "));
    }
    text += &format!("\nRun it again\n  {}\n", repeat_command(report.run()));
    text += "  The same build gives the same trials to the bit.\n";
    text += &format!("\nColumns (format version {FORMAT_VERSION})\n");
    text += "Lengths are metres, angles degrees; a cell without a value is empty.\n\n";
    text + &column_meanings()
}

/// The files that are there, those of the trials as one line a kind.
fn explained(names: &BTreeSet<String>) -> Vec<(&str, &'static str)> {
    let mut lines = vec![("README.txt", "this text")];
    let single = [
        ("report.html", "the report, for reading and printing"),
        ("report.json", "the report, complete, for programs"),
        ("trials.csv", "the trial table, for spreadsheets"),
        ("network.json", "the networks the session began with"),
        ("log.mcap", "every control step with its explanation (MCAP, JSON messages)"),
    ];
    lines.extend(single.into_iter().filter(|(name, _)| names.contains(*name)));
    for name in names.iter().filter(|name| name.starts_with("pictures/")) {
        lines.push((name, "a picture of the report"));
    }
    let kinds = [
        (".html", "trials/NNN.html", "report of trial NNN, for reading and printing"),
        (".json", "trials/NNN.json", "trial NNN, complete, with the neurons after it"),
        (".csv", "trials/NNN.csv", "control steps of trial NNN"),
        (".png", "trials/NNN.png", "path of trial NNN"),
    ];
    for (ending, name, meaning) in kinds {
        if names.iter().any(|name| name.starts_with("trials/") && name.ends_with(ending)) {
            lines.push((name, meaning));
        }
    }
    lines
}
