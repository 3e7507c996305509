//! Reports for programs: complete, floats in the shortest form that reads back to the same bits.

use std::collections::BTreeMap;

use serde::Serialize;
use serde_json::Value;

use super::differences::Differences;
use super::{SessionReport, TrialReport};
use crate::wire::{
    AlteredStartView, LogEntry, PresetInfo, Session, SettingInfo, Summary, TickView, Trial,
    TrialEndView, WorldView, Yardstick,
};

/// Version of both JSON files, in `format_version`.
pub const FORMAT_VERSION: u32 = 1;

/// The session as JSON: the fields of a [`crate::wire::RunResult`] first, then all the rest.
#[must_use]
pub fn json(report: &SessionReport) -> String {
    let session = &report.session;
    pretty(&SessionFile {
        experiment: &session.experiment,
        seed: session.seed,
        build: &session.build,
        settings: &session.settings,
        trials: &report.trials,
        summary: &report.summary,
        yardstick: &report.yardstick,
        starts: &report.starts,
        differences: Differences::of(report.run()),
        events: &report.events,
        settings_info: &report.settings,
        format_version: FORMAT_VERSION,
        report_build: &report.build,
        title: &report.title,
        preset: &report.preset,
        world: &report.world,
        session,
    })
}

/// The trial as JSON: the run it belongs to, its record, what the learner did at its end, all ticks.
#[must_use]
pub fn trial_json(report: &TrialReport) -> String {
    let session = &report.session;
    compact(&TrialFile {
        experiment: &session.experiment,
        seed: session.seed,
        build: &session.build,
        settings: &session.settings,
        trial: &report.end.trial,
        format_version: FORMAT_VERSION,
        title: &report.title,
        session_id: &session.id,
        end: &report.end,
        ticks: &report.ticks,
    })
}

#[derive(Serialize)]
struct SessionFile<'a> {
    experiment: &'a str,
    seed: u64,
    build: &'a str,
    settings: &'a BTreeMap<String, Value>,
    trials: &'a [Trial],
    summary: &'a Summary,
    yardstick: &'a Yardstick,
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    starts: &'a [AlteredStartView],
    differences: Differences,
    events: &'a [LogEntry],
    settings_info: &'a [SettingInfo],
    format_version: u32,
    report_build: &'a str,
    title: &'a str,
    preset: &'a PresetInfo,
    world: &'a WorldView,
    session: &'a Session,
}

#[derive(Serialize)]
struct TrialFile<'a> {
    experiment: &'a str,
    seed: u64,
    build: &'a str,
    settings: &'a BTreeMap<String, Value>,
    trial: &'a Trial,
    format_version: u32,
    title: &'a str,
    session_id: &'a str,
    end: &'a TrialEndView,
    ticks: &'a [TickView],
}

/// A session's file is short and people look into it.
pub(super) fn pretty(file: &impl Serialize) -> String {
    serde_json::to_string_pretty(file).expect("plain data with text keys always serialises")
}

/// A trial's file holds thousands of numbers; one number a line would help nobody.
fn compact(file: &impl Serialize) -> String {
    serde_json::to_string(file).expect("plain data with text keys always serialises")
}
