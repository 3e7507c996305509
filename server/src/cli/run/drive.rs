//! Runs of the experiments of chapter 2.

use indicatif::ProgressBar;

use super::super::{Failure, cores, output};
use super::table::refuse_what_robots_have;
use super::{Arguments, recorded};
use crate::batch;
use crate::catalog::{Catalog, FieldError, Job, PlainPlan};
use crate::session::DriveRun;
use crate::wire::{DriveResult, DriveScores, MeasureView, NewSession};

/// Runs an experiment of chapter 2, one result a seed.
pub(super) fn run(
    arguments: &Arguments,
    catalog: Catalog,
    requests: &[NewSession],
) -> Result<(), Failure> {
    refuse_what_robots_have(arguments)?;
    if arguments.world.is_some() {
        return Err(Failure::Input(format!(
            "--world: `{}` has a world of its own; its settings change it",
            arguments.experiment
        )));
    }
    let plans = requests.iter().map(|request| match catalog.job(request)? {
        Job::Plain(plan) => Ok(*plan),
        Job::Path(_) => Err(FieldError::new("experiment", "must be one of chapter 2")),
    });
    let plans: Vec<PlainPlan> = plans.collect::<Result<_, FieldError>>()?;
    // The same settings fit or do not fit for every seed.
    let rounds = plans.first().map(DriveRun::new).transpose()?.map_or(0, |run| run.rounds());
    let progress = output::progress(u64::from(rounds) * plans.len() as u64, "runs");
    let take = |result: DriveResult| progress.suspend(|| print(&result, arguments.json));
    match &arguments.out {
        Some(folder) => recorded::run_drives(catalog, requests, &plans, folder, &progress, take)?,
        None => run_all(&plans, &progress, take)?,
    }
    progress.finish_and_clear();
    Ok(())
}

fn run_all(
    plans: &[PlainPlan],
    progress: &ProgressBar,
    mut take: impl FnMut(DriveResult) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let work = |plan: &PlainPlan| batch::drive(plan, || progress.inc(1));
    batch::in_order(plans, cores(), work, |done| take(done?))
}

fn print(result: &DriveResult, json: bool) -> Result<(), Failure> {
    if json { output::json(result) } else { output::line(&text(result)) }
}

/// The result as a table for people: a measure a row, a method a column.
fn text(result: &DriveResult) -> String {
    let heading = format!("{}, seed {}, build {}\n", result.experiment, result.seed, result.build);
    heading + table(&result.summary).trim_end()
}

fn table(summary: &DriveScores) -> String {
    let mut text = format!("{:<24}", "");
    for of in &summary.methods {
        text += &format!("{:>28}", of.method);
    }
    text += &format!("\n{:<24}", "runs");
    for of in &summary.methods {
        text += &format!("{:>28}", of.n);
    }
    if summary.methods.iter().any(|of| of.done.is_some()) {
        text += &format!("\n{:<24}", "reached the end");
        for of in &summary.methods {
            text += &format!("{:>28}", of.done.map_or_else(|| "-".into(), |done| done.to_string()));
        }
    }
    let measures = summary.methods.first().map(|of| of.measures.as_slice()).unwrap_or_default();
    for (index, measure) in measures.iter().enumerate() {
        let unit =
            if measure.unit.is_empty() { String::new() } else { format!(" ({})", measure.unit) };
        text += &format!("\n{:<24}", format!("{}{unit}", measure.name));
        for of in &summary.methods {
            text += &format!("{:>28}", of.measures.get(index).map_or_else(String::new, value));
        }
    }
    text
}

fn value(measure: &MeasureView) -> String {
    match &measure.interval {
        Some(of) => format!("{:.3} [{:.3}, {:.3}]", measure.mean, of.low, of.high),
        None => format!("{:.3}", measure.mean),
    }
}
