//! Runs of tabular experiments.

use std::path::Path;

use indicatif::ProgressBar;

use super::super::{Failure, cores, output};
use super::{Arguments, recorded};
use crate::batch;
use crate::catalog::{Catalog, FieldError, Job, NamedTask, PlainPlan};
use crate::session::TableRun;
use crate::wire::{EpisodeView, NewSession, OutcomeOfEpisode, ScoreView, TableResult};

/// Runs a tabular experiment, one result a seed.
pub(super) fn run(
    arguments: &Arguments,
    mut catalog: Catalog,
    mut requests: Vec<NewSession>,
) -> Result<(), Failure> {
    refuse_what_robots_have(arguments)?;
    if let Some(file) = &arguments.world {
        give_task(&mut catalog, &mut requests, file)?;
    }
    let plans = requests.iter().map(|request| match catalog.job(request)? {
        Job::Plain(plan) => Ok(*plan),
        Job::Path(_) => Err(FieldError::new("experiment", "must be a tabular one")),
    });
    let plans: Vec<PlainPlan> = plans.collect::<Result<_, FieldError>>()?;
    // The same settings fit or do not fit for every seed.
    let rounds = plans.first().map(TableRun::new).transpose()?.map_or(0, |run| run.rounds());
    let progress = output::progress(u64::from(rounds) * plans.len() as u64, "episodes");
    let take = |result: TableResult| progress.suspend(|| print(&result, arguments.json));
    match &arguments.out {
        Some(folder) => recorded::run_tables(catalog, &requests, &plans, folder, &progress, take)?,
        None => run_all(&plans, &progress, take)?,
    }
    progress.finish_and_clear();
    Ok(())
}

pub(super) fn refuse_what_robots_have(arguments: &Arguments) -> Result<(), Failure> {
    arguments.placing.refuse_without_world()?;
    let refused = [
        ("--network", arguments.network.is_some()),
        ("--save-network", arguments.save_network.is_some()),
        ("--start", !arguments.start.is_empty()),
    ];
    match refused.iter().find(|(_, given)| *given) {
        Some((option, _)) => Err(Failure::Input(format!(
            "{option}: `{}` has no networks to learn with; leave it out",
            arguments.experiment
        ))),
        None => Ok(()),
    }
}

/// Takes the maze or process of a file for these runs.
fn give_task(
    catalog: &mut Catalog,
    requests: &mut [NewSession],
    file: &Path,
) -> Result<(), Failure> {
    let bad = |error: String| Failure::Input(format!("--world {}: {error}", file.display()));
    let text = std::fs::read_to_string(file).map_err(|error| bad(error.to_string()))?;
    let task = NamedTask::read(&text).map_err(|error| bad(error.to_string()))?;
    for request in requests {
        if request.settings.insert("world".to_owned(), task.name.clone().into()).is_some() {
            return Err(Failure::Input("give either --world or --set world=NAME".to_owned()));
        }
    }
    catalog.give_task(task);
    Ok(())
}

fn run_all(
    plans: &[PlainPlan],
    progress: &ProgressBar,
    mut take: impl FnMut(TableResult) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let work = |plan: &PlainPlan| batch::table(plan, || progress.inc(1));
    batch::in_order(plans, cores(), work, |done| take(done?))
}

fn print(result: &TableResult, json: bool) -> Result<(), Failure> {
    if json { output::json(result) } else { output::line(&text(result)) }
}

/// The result as tables for people.
fn text(result: &TableResult) -> String {
    let mut text = format!("{}, seed {}, build {}\n", result.experiment, result.seed, result.build);
    if let Some(points) = result.episodes.iter().find_map(points) {
        return (text + &points).trim_end().to_owned();
    }
    let summary = &result.summary;
    text += &format!(
        "competitor              episodes  {:>16}  95 % interval       gain (%)  95 % interval    final  search space\n",
        summary.measure
    );
    for score in &summary.scores {
        text += &row(score);
    }
    let steps: u64 = result.episodes.iter().map(|episode| episode.steps).sum();
    text += &format!("{} episodes of each, {steps} steps", summary.episodes_done);
    text
}

fn row(score: &ScoreView) -> String {
    let number = |value: Option<f64>, decimals: usize| {
        value.map_or_else(|| "-".to_owned(), |value| format!("{value:.decimals$}"))
    };
    let ends = |interval: Option<crate::wire::IntervalView>, decimals: usize| {
        interval.map_or_else(
            || "-".to_owned(),
            |of| format!("{:.decimals$} to {:.decimals$}", of.low, of.high),
        )
    };
    format!(
        "{:<22}  {:>8}  {:>16}  {:<18}  {:>8}  {:<15}  {:>6}  {:>12}\n",
        score.name,
        score.n,
        number(score.index.map(|index| index.value), 2),
        ends(score.index, 2),
        number(score.gain_pct, 1),
        ends(score.gain, 1),
        number(score.last, 2),
        score.search_space.map_or_else(|| "-".to_owned(), |pairs| pairs.to_string()),
    )
}

/// The plots of figure 3.3, where an episode is one.
fn points(episode: &EpisodeView) -> Option<String> {
    let OutcomeOfEpisode::Plot { points } = &episode.outcome else { return None };
    let mut text = "model           parameter  J of each policy                best\n".to_owned();
    for point in points {
        let values: Vec<String> = point.values.iter().map(|value| format!("{value:9.2}")).collect();
        text += &format!(
            "{:<14}  {:>9.3}  {}  {:>4}",
            point.model,
            point.parameter,
            values.join(" "),
            point.best + 1
        );
        if let Some(crossing) = point.crossing {
            let (at, from, to) = (crossing.at, crossing.from + 1, crossing.to + 1);
            text += &format!("  policy {to} overtakes policy {from} at {at:.4}");
        }
        text += "\n";
    }
    Some(text)
}
