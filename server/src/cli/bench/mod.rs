//! `sonarium bench`: what the program promises about speed and memory, measured.

mod client;
mod cpu;
mod headless;
mod navigation;
mod nn;
mod room;
mod server;
mod sonar;
mod tabular;

use clap::Args;
use serde::Serialize;

use super::{Failure, output};
use crate::render;

/// What can be measured.
const TASKS: [&str; 13] = [
    "run", "run-log", "office", "maze", "dyna", "sonar", "fuzzy", "kalman", "corridor", "nn",
    "render", "live", "memory",
];

#[derive(Args, Debug)]
pub(super) struct Arguments {
    /// What to measure: run (control steps, and the CPU time of a set of 20 trials), run-log (with
    /// the log), office (a step among thousands of walls), maze (Q-learning with softmax in 16 states),
    /// dyna (backups with 50 planning steps), sonar (a robot with 24 sonars in a room of 30 walls), fuzzy (a base of 972 rules), kalman (the filter over a window), corridor (a run of chapter 2), nn (the nearest of up to 10,000 centres), render, live, memory or all
    task: String,
    /// Results are always one JSON object a line; taken so that every command takes it
    #[arg(long)]
    json: bool,
}

/// One result.
#[derive(Debug, Serialize)]
struct Line {
    task: String,
    name: String,
    version: &'static str,
    metric: &'static str,
    /// Median.
    value: f64,
    min: f64,
    max: f64,
    runs: usize,
    note: String,
}

pub(super) fn bench(arguments: &Arguments) -> Result<(), Failure> {
    let task = arguments.task.as_str();
    if task != "all" && !TASKS.contains(&task) {
        let tasks = TASKS.join(", ");
        return Err(Failure::Input(format!(
            "TASK: there is no task `{task}`; there are {tasks}, all"
        )));
    }
    for known in TASKS.into_iter().filter(|known| task == "all" || task == *known) {
        for line in measure(known)? {
            output::json(&line)?;
        }
    }
    Ok(())
}

fn measure(task: &'static str) -> Result<Vec<Line>, Failure> {
    match task {
        "run" => headless::run(),
        "run-log" => headless::run_with_log(),
        "office" => headless::office(),
        "maze" => tabular::maze(),
        "dyna" => tabular::dyna(),
        "sonar" => sonar::run(),
        "fuzzy" => navigation::fuzzy(),
        "kalman" => navigation::kalman(),
        "corridor" => navigation::corridor(),
        "nn" => nn::run(),
        "live" => server::live(),
        "memory" => server::memory(),
        _ => Ok(render::bench().into_iter().map(render_line).collect()),
    }
}

fn render_line(measured: render::Measurement) -> Line {
    Line {
        task: "render".to_owned(),
        name: format!("sonarium {}", measured.name),
        version: env!("CARGO_PKG_VERSION"),
        metric: measured.metric,
        value: measured.value,
        min: measured.min,
        max: measured.max,
        runs: measured.runs,
        note: measured.note,
    }
}

impl Line {
    /// A line over several measurements.
    fn new(
        task: &'static str,
        name: &str,
        metric: &'static str,
        mut measured: Vec<f64>,
        note: &str,
    ) -> Self {
        measured.sort_by(f64::total_cmp);
        let at = |index: usize| measured.get(index).copied().unwrap_or_default();
        Self {
            task: task.to_owned(),
            name: format!("sonarium {name}"),
            version: env!("CARGO_PKG_VERSION"),
            metric,
            value: at(measured.len() / 2),
            min: at(0),
            max: at(measured.len().saturating_sub(1)),
            runs: measured.len(),
            note: note.to_owned(),
        }
    }
}
