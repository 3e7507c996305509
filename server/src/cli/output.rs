//! Results on stdout, progress on stderr.

use std::io::{self, IsTerminal, Write, stderr};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde::Serialize;

use super::Failure;
use crate::wire::{AlteredStartView, ExcursionView, RunResult, Trial};

/// Writes one line.
pub(super) fn line(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    writeln!(out, "{text}")?;
    Ok(out.flush()?)
}

/// Writes one JSON object on one line.
pub(super) fn json(value: &impl Serialize) -> Result<(), Failure> {
    line(&serde_json::to_string(value).map_err(|error| Failure::Failed(error.to_string()))?)
}

/// A bar over so many of something, when stderr is a terminal.
pub(super) fn progress(total: u64, of_what: &str) -> ProgressBar {
    if !stderr().is_terminal() {
        return ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::hidden());
    }
    let template = format!("{{bar:40}} {{pos}}/{{len}} {of_what}, {{eta}} left");
    let style = ProgressStyle::with_template(&template);
    ProgressBar::new(total).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

/// The trials of a run as a table for people.
pub(super) fn table(result: &RunResult) -> String {
    let preset = result.settings.get("preset").and_then(|preset| preset.as_str());
    let mut text = format!(
        "{}, preset {}, seed {}, build {}\n",
        result.experiment,
        preset.unwrap_or("default"),
        result.seed,
        result.build
    );
    text += "trial   steps  total reinforcement  regret  neurons  collisions  temperature (deg)  goal\n";
    for trial in &result.trials {
        text += &row(trial);
    }
    let summary = &result.summary;
    text += &format!("{} of {} trials reached the goal", summary.reached, summary.trials);
    if let (Some(best), Some(trial)) = (summary.best_total_reinforcement, summary.best_trial) {
        text += &format!("; best total reinforcement {best:.2} in trial {trial}");
    }
    if let Some(planned) = summary.planned_total_reinforcement {
        text += &format!("; the best path a planner finds has {planned:.2}");
    }
    text += &format!("; {} control steps, {} neurons", summary.steps, summary.neurons);
    text + &starts(&result.starts)
}

/// The altered starts as a table for people; nothing when there are none.
fn starts(starts: &[AlteredStartView]) -> String {
    if starts.is_empty() {
        return String::new();
    }
    let mut text = "\naltered starts: the trained network alone | with the reflex where no neuron is active\n\
                    start                          neuron active  goal         steps  silent (%) | goal         steps\n"
        .to_owned();
    for AlteredStartView { start, inside, alone, guided, .. } in starts {
        text += &format!(
            "{:<30} {:<14} {:<11} {:>6} {:>11.1} | {:<11} {:>6}\n",
            start.name,
            if *inside { "yes" } else { "no" },
            ending(alone),
            alone.steps,
            alone.silent_pct,
            ending(guided),
            guided.steps,
        );
    }
    text.trim_end().to_owned()
}

fn ending(excursion: &ExcursionView) -> &'static str {
    match (excursion.reached_goal, excursion.collisions) {
        (true, _) => "reached",
        (false, 0) => "not reached",
        (false, _) => "collided",
    }
}

fn row(trial: &Trial) -> String {
    format!(
        "{:>5}  {:>6}  {:>19.2}  {:>6}  {:>7}  {:>10}  {:>17.1}  {}\n",
        trial.trial,
        trial.steps,
        trial.total_reinforcement,
        trial.regret.map_or_else(|| "-".into(), |regret| format!("{regret:.2}")),
        trial.neurons,
        trial.collisions,
        trial.temperature_deg,
        match (trial.reached_goal, trial.record) {
            (true, true) => "reached, best so far",
            (true, false) => "reached",
            (false, _) => "not reached",
        }
    )
}
