//! Reports of sessions of chapter 2: page, JSON, CSV, and all of them in one zip file.

use std::collections::BTreeMap;
use std::io::{Read, Seek, Write};

use maud::{Markup, html};
use serde::Serialize;
use serde_json::Value;

use super::archive::{Archive, ArchiveError};
use super::closing::closing;
use super::command::repeat_command;
use super::csv::line;
use super::differences::Differences;
use super::number::{NOTHING, fixed, fixed_or_nothing, state_text, time_text};
use super::page::{Heading, facts, number, numbers, page, pictures, table, words};
use super::{FORMAT_VERSION, Picture, RunInfo};
use crate::wire::{
    DriveOutcome, DriveRunView, DriveScore, DriveScores, LogEntry, MeasureView, MethodScoreView,
    PresetInfo, Session, SettingInfo,
};

/// Everything the report of a session of chapter 2 is made from.
#[derive(Clone, Debug)]
pub struct DriveReport {
    /// Title of the experiment, for people.
    pub title: String,
    /// The session.
    pub session: Session,
    /// How the methods stand.
    pub scores: DriveScores,
    /// The runs, in order.
    pub runs: Vec<DriveRunView>,
    /// Ways of some of the runs.
    pub pictures: Vec<Picture>,
    /// Every setting of the experiment.
    pub settings: Vec<SettingInfo>,
    /// The preset the settings started from.
    pub preset: PresetInfo,
    /// The event log, oldest first.
    pub events: Vec<LogEntry>,
    /// Program version and commit that wrote the report.
    pub build: String,
}

impl DriveReport {
    fn run(&self) -> RunInfo<'_> {
        RunInfo { session: &self.session, settings: &self.settings, preset: &self.preset }
    }
}

/// The session as one HTML file that needs nothing else.
#[must_use]
pub fn drive_html(report: &DriveReport) -> String {
    let title = format!("{}, seed {}", report.title, report.session.seed);
    let body = html! {
        (heading(report))
        section { h2 { "Methods" } (methods_table(&report.scores)) }
        section { h2 { "Runs" } (runs_table(&report.runs)) }
        (pictures("Ways", &report.pictures))
        (closing(report.run(), "runs", "changes the method or silences a sonar", &report.events, &report.build))
    };
    page(&title, body)
}

fn heading(report: &DriveReport) -> Markup {
    let session = &report.session;
    html! {
        header {
            h1 { (report.title) ", seed " (session.seed) }
            p class="lead" { "Report of session " code { (session.id) } }
            (facts(&[
                ("State", html! { (state_text(session.state)) }),
                ("Experiment", html! { code { (session.experiment) } }),
                ("Seed", html! { (session.seed) }),
                ("Preset", html! { (report.preset.title) " (" code { (session.preset) } ")" }),
                ("Runs", html! { (session.rounds_done) " of " (session.rounds) }),
                ("Build", html! { code { (session.build) } }),
                ("Created", html! { (time_text(&session.created_at)) }),
                ("Last change of state", html! { (time_text(&session.changed_at)) }),
            ]))
        }
        @if let Some(reason) = &session.reason { p { b { "Why: " } (reason) } }
        @if !report.preset.summary.is_empty() { p { b { "Preset: " } (report.preset.summary) } }
    }
}

/// A measure a row, a method a column.
fn methods_table(scores: &DriveScores) -> Markup {
    let mut headings = vec![words("Measure")];
    let names: Vec<String> = scores.methods.iter().map(|of| of.method.clone()).collect();
    headings.extend(names.iter().map(|_| numbers("", "")));
    let measures = scores.methods.first().map(|of| of.measures.as_slice()).unwrap_or_default();
    let rows = html! {
        tr { th scope="row" { "Method" } @for name in &names { td class="n" { b { (name) } } } }
        tr { th scope="row" { "Runs" } @for of in &scores.methods { (number(of.n.to_string())) } }
        @if scores.methods.iter().any(|of| of.done.is_some()) {
            tr {
                th scope="row" { "Reached the end" }
                @for of in &scores.methods {
                    (number(of.done.map_or_else(|| NOTHING.to_owned(), |done| done.to_string())))
                }
            }
        }
        @for (index, measure) in measures.iter().enumerate() {
            tr {
                th scope="row" {
                    (measure.name)
                    @if !measure.unit.is_empty() { " " small { (measure.unit) } }
                }
                @for of in &scores.methods { (number(of.measures.get(index).map_or_else(String::new, value))) }
            }
        }
        @if names.is_empty() { tr { td { "No run has ended yet" } } }
    };
    table(
        "methods",
        "Means over the runs, with the 95 % interval from two runs on",
        &headings,
        rows,
    )
}

fn value(measure: &MeasureView) -> String {
    match &measure.interval {
        Some(interval) => format!(
            "{} [{}, {}]",
            fixed(measure.mean, 3),
            fixed(interval.low, 3),
            fixed(interval.high, 3)
        ),
        None => fixed(measure.mean, 3),
    }
}

fn runs_table(runs: &[DriveRunView]) -> Markup {
    let is_approach = |run: &&DriveRunView| matches!(run.outcome, DriveOutcome::Approach { .. });
    if runs.iter().any(|run| is_approach(&run)) {
        approaches_table(runs)
    } else {
        drives_table(runs)
    }
}

fn drives_table(runs: &[DriveRunView]) -> Markup {
    const HEADINGS: [Heading; 12] = [
        numbers("Run", ""),
        words("Method"),
        words("End"),
        numbers("Progress", "m"),
        numbers("Time", "s"),
        numbers("Velocity", "m/s"),
        numbers("Straightness", ""),
        numbers("Changes of side", "1/min"),
        numbers("Contacts", "wall, door, block, person"),
        numbers("Doors", "passed"),
        numbers("NIS", "mean"),
        numbers("NEES", "mean"),
    ];
    let rows = html! {
        @for run in runs {
            @if let DriveOutcome::Drive(score) = &run.outcome { (drive_row(run, score)) }
        }
        @if runs.is_empty() { tr { td colspan="12" { "No run has ended yet" } } }
    };
    table("runs", "One row a run of one method", &HEADINGS, rows)
}

fn drive_row(run: &DriveRunView, score: &DriveScore) -> Markup {
    let end = match (score.done, score.blind) {
        (true, _) => "reached",
        (false, Some(_)) => "blind",
        (false, None) => "time",
    };
    html! {
        tr {
            th scope="row" class="n" { (run.run) }
            td {
                (run.method)
                @for what in &run.interventions { br; small { (what.text) } }
            }
            td { (end) }
            (number(fixed(score.progress_m, 1)))
            (number(fixed(score.time_s, 0)))
            (number(fixed(score.speed_m_s, 3)))
            (number(fixed(score.straightness, 3)))
            (number(fixed(score.flips_per_min, 1)))
            (number(format!(
                "{}, {}, {}, {}",
                score.wall_contacts, score.door_contacts, score.block_contacts, score.people_contacts
            )))
            (number(score.doors.to_string()))
            (number(fixed_or_nothing(score.nis, 2)))
            (number(fixed_or_nothing(score.nees, 2)))
        }
    }
}

fn approaches_table(runs: &[DriveRunView]) -> Markup {
    const HEADINGS: [Heading; 7] = [
        numbers("Run", ""),
        words("Method"),
        numbers("RMS", "m"),
        numbers("R²", "of a line"),
        numbers("Variation", "m"),
        numbers("Rise", "m"),
        numbers("Jump", "m"),
    ];
    let rows = html! {
        @for run in runs {
            @if let DriveOutcome::Approach { scores, .. } = &run.outcome {
                @for score in scores {
                    tr {
                        th scope="row" class="n" { (run.run) }
                        td { (score.method) }
                        (number(fixed(score.rms_m, 3)))
                        (number(fixed(score.r2, 3)))
                        (number(fixed(score.variation_m, 2)))
                        (number(fixed(score.rise_m, 2)))
                        (number(fixed(score.jump_m, 2)))
                    }
                }
            }
        }
    };
    table("runs", "How well each method told the distance", &HEADINGS, rows)
}

/// The session as JSON: the fields of a [`crate::wire::DriveResult`] first, then all the rest.
#[must_use]
pub fn drive_json(report: &DriveReport) -> String {
    let session = &report.session;
    let file = DriveFile {
        experiment: &session.experiment,
        seed: session.seed,
        build: &session.build,
        settings: &session.settings,
        episodes: &report.runs,
        summary: &report.scores,
        differences: Differences::of(report.run()),
        events: &report.events,
        settings_info: &report.settings,
        format_version: FORMAT_VERSION,
        report_build: &report.build,
        title: &report.title,
        preset: &report.preset,
        session,
    };
    serde_json::to_string_pretty(&file).expect("plain data with text keys always serialises")
}

#[derive(Serialize)]
struct DriveFile<'a> {
    experiment: &'a str,
    seed: u64,
    build: &'a str,
    settings: &'a BTreeMap<String, Value>,
    episodes: &'a [DriveRunView],
    summary: &'a DriveScores,
    differences: Differences,
    events: &'a [LogEntry],
    settings_info: &'a [SettingInfo],
    format_version: u32,
    report_build: &'a str,
    title: &'a str,
    preset: &'a PresetInfo,
    session: &'a Session,
}

/// A column of the CSV file: its name with its unit, and its value.
type Column<Of> = (&'static str, fn(&Of) -> String);

const DRIVE: [Column<DriveScore>; 20] = [
    ("time_s", |of| of.time_s.to_string()),
    ("done", |of| of.done.to_string()),
    ("progress_m", |of| of.progress_m.to_string()),
    ("path_m", |of| of.path_m.to_string()),
    ("forward_m_s", |of| of.forward_m_s.to_string()),
    ("straightness", |of| of.straightness.to_string()),
    ("heading_rms_deg", |of| of.heading_rms_deg.to_string()),
    ("speed_m_s", |of| of.speed_m_s.to_string()),
    ("slow_pct", |of| of.slow_pct.to_string()),
    ("reverse_pct", |of| of.reverse_pct.to_string()),
    ("flips_per_min", |of| of.flips_per_min.to_string()),
    ("turn_deg_s", |of| of.turn_deg_s.to_string()),
    ("wall_contacts", |of| of.wall_contacts.to_string()),
    ("door_contacts", |of| of.door_contacts.to_string()),
    ("block_contacts", |of| of.block_contacts.to_string()),
    ("people_contacts", |of| of.people_contacts.to_string()),
    ("doors", |of| of.doors.to_string()),
    ("clearance_m", |of| of.clearance_m.to_string()),
    ("nis", |of| of.nis.map(|nis| nis.to_string()).unwrap_or_default()),
    ("nees", |of| of.nees.map(|nees| nees.to_string()).unwrap_or_default()),
];

const APPROACH: [Column<MethodScoreView>; 5] = [
    ("rms_m", |of| of.rms_m.to_string()),
    ("r2", |of| of.r2.to_string()),
    ("variation_m", |of| of.variation_m.to_string()),
    ("rise_m", |of| of.rise_m.to_string()),
    ("jump_m", |of| of.jump_m.to_string()),
];

/// The runs as CSV: a row a run, or a run and method of the approach to a wall.
#[must_use]
pub fn drive_csv(report: &DriveReport) -> String {
    let first = report.runs.first().map(|run| &run.outcome);
    let names: Vec<&str> = match first {
        Some(DriveOutcome::Approach { .. }) => APPROACH.iter().map(|(name, _)| *name).collect(),
        _ => DRIVE.iter().map(|(name, _)| *name).collect(),
    };
    let header = ["round", "run", "method", "cycles"].into_iter().chain(names);
    let mut text = line(&header.map(str::to_owned).collect::<Vec<_>>());
    for run in &report.runs {
        let row = |method: &str, values: Vec<String>| {
            let head = [
                run.round.to_string(),
                run.run.to_string(),
                method.to_owned(),
                run.cycles.to_string(),
            ];
            line(&head.into_iter().chain(values).collect::<Vec<_>>())
        };
        match &run.outcome {
            DriveOutcome::Drive(score) => {
                text += &row(&run.method, DRIVE.iter().map(|(_, of)| of(score)).collect());
            }
            DriveOutcome::Approach { scores, .. } => {
                for score in scores {
                    text += &row(&score.method, APPROACH.iter().map(|(_, of)| of(score)).collect());
                }
            }
        }
    }
    text
}

/// Writes all reports of a session of chapter 2 into `target` and gives it back.
///
/// # Errors
/// When the log cannot be read, or the target cannot be written.
pub fn drive_zip<W: Write + Seek>(
    report: &DriveReport,
    log: Option<&mut dyn Read>,
    target: W,
) -> Result<W, ArchiveError> {
    let mut archive = Archive::new(target);
    archive.text("report.html", &drive_html(report))?;
    archive.text("report.json", &drive_json(report))?;
    archive.text("runs.csv", &drive_csv(report))?;
    archive.pictures(&report.pictures)?;
    if let Some(log) = log {
        archive.log(log)?;
    }
    archive.text("README.txt", &readme(report))?;
    archive.finish()
}

fn readme(report: &DriveReport) -> String {
    let session = &report.session;
    format!(
        "{}: report of session {}\n\
         State {}, seed {}, preset {}, build {}\n\n\
         Files\n  \
         report.html    the report, for reading and printing\n  \
         report.json    the report, complete, for programs\n  \
         runs.csv       the runs, for spreadsheets\n  \
         pictures/      the ways of some runs, as drawn in the report\n  \
         log.mcap       every cycle with its explanation (MCAP, JSON messages)\n\n\
         Run it again\n  {}\n  \
         The same build gives the same runs to the bit, unless somebody changed the method or silenced a\n  \
         sonar on the way; the events say so.\n",
        report.title,
        session.id,
        state_text(session.state).to_lowercase(),
        session.seed,
        session.preset,
        session.build,
        repeat_command(report.run()),
    )
}
