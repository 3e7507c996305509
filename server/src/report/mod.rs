//! Reports: what a session or a trial did, as files that need nothing else to be read.
//!
//! A report is made from the types that travel and from pictures drawn by the caller; it reads no
//! clock and no store, so the same session always gives the same bytes. Each kind of file has its
//! module: [`html`], [`csv`], [`json`], and [`zip`] for all of them together.

mod archive;
mod calibration;
mod closing;
mod command;
mod csv;
mod curve;
mod differences;
mod drive;
mod json;
mod number;
mod page;
mod readme;
mod session_page;
mod session_tables;
mod table;
mod trial_page;
mod trial_tables;

#[cfg(test)]
mod sample;
#[cfg(test)]
mod sample_trial;

pub use archive::{ArchiveError, zip};
pub use calibration::{
    calibration_csv, calibration_html, calibration_json, calibration_markdown, calibration_text,
};
pub use csv::{csv, line as csv_line, trial_csv};
pub use differences::{Difference, Differences};
pub use drive::{DriveReport, drive_csv, drive_html, drive_json, drive_zip};
pub use json::{FORMAT_VERSION, json, trial_json};
pub use session_page::html;
pub use table::{TableReport, table_csv, table_html, table_json, table_zip};
pub use trial_page::trial_html;

use crate::wire::{
    AlteredStartView, LogEntry, PresetInfo, Session, SettingInfo, Summary, TickView, Trial,
    TrialEndView, WorldView, Yardstick,
};

/// Everything the report of a session is made from.
#[derive(Clone, Debug)]
pub struct SessionReport {
    /// Title of the experiment, for people.
    pub title: String,
    /// The session.
    pub session: Session,
    /// Summary over its trials.
    pub summary: Summary,
    /// The best path a planner finds.
    pub yardstick: Yardstick,
    /// Its trials, in order.
    pub trials: Vec<Trial>,
    /// Every setting of the experiment.
    pub settings: Vec<SettingInfo>,
    /// The preset the settings started from.
    pub preset: PresetInfo,
    /// The world it runs in.
    pub world: WorldView,
    /// The file of the networks it began with, if it began with some.
    pub network: Option<String>,
    /// What the networks do from altered starts, where there are any.
    pub starts: Vec<AlteredStartView>,
    /// The event log, oldest first.
    pub events: Vec<LogEntry>,
    /// Stills, e.g. of the first and the last trial; drawn light, so that they print.
    pub pictures: Vec<Picture>,
    /// Program version and commit that wrote the report; the session names the one that ran it.
    pub build: String,
}

/// What the reports of both families of experiments say of a run.
#[derive(Clone, Copy, Debug)]
pub struct RunInfo<'a> {
    /// The session.
    pub session: &'a Session,
    /// Every setting of the experiment.
    pub settings: &'a [SettingInfo],
    /// The preset the settings started from.
    pub preset: &'a PresetInfo,
}

impl SessionReport {
    /// What it says of the run.
    #[must_use]
    pub fn run(&self) -> RunInfo<'_> {
        RunInfo { session: &self.session, settings: &self.settings, preset: &self.preset }
    }
}

/// Everything the report of one trial is made from.
#[derive(Clone, Debug)]
pub struct TrialReport {
    /// Title of the experiment, for people.
    pub title: String,
    /// The session.
    pub session: Session,
    /// The trial's row, and what the learner did at its end.
    pub end: TrialEndView,
    /// Its control steps, in order.
    pub ticks: Vec<TickView>,
    /// The path; drawn light, so that it prints.
    pub picture: Option<Picture>,
}

/// A still with its words.
#[derive(Clone, Debug)]
pub struct Picture {
    /// File name without ending, e.g. `trial-001`; what a file name should not hold becomes `-`.
    pub name: String,
    /// What stands below it.
    pub caption: String,
    /// What it shows, for those who cannot see it.
    pub alt: String,
    /// A whole PNG file.
    pub png: Vec<u8>,
}

#[cfg(test)]
mod tests;
