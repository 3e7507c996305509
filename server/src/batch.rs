//! Independent pieces of work on several threads: sets of trials, one a seed.
//!
//! The results come in the order of the jobs, whatever the threads, so that nothing that is computed
//! from them depends on how many there were.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

use crate::catalog::{FieldError, PlainPlan, Plan, Trained};
use crate::session::{DriveRun, Run, TableRun, summary};
use crate::wire::{
    AlteredStartView, DriveResult, DriveRunView, DriveScores, EpisodeView, RunResult, ScoresView,
    TableResult, Trial,
};
use crate::yardstick;

/// Does the jobs on so many threads and hands over each result as soon as all before it are there.
/// When `take` refuses one, no further job is begun.
///
/// # Errors
/// What `take` refused with.
pub fn in_order<Job: Sync, Done: Send, Error>(
    jobs: &[Job],
    threads: usize,
    work: impl Fn(&Job) -> Done + Sync,
    mut take: impl FnMut(Done) -> Result<(), Error>,
) -> Result<(), Error> {
    let next = AtomicUsize::new(0);
    let (sender, results) = mpsc::channel();
    thread::scope(|scope| {
        for _ in 0..threads.clamp(1, jobs.len().max(1)) {
            let (next, sender, work) = (&next, sender.clone(), &work);
            scope.spawn(move || {
                while let Some((index, job)) = claim(next, jobs) {
                    if sender.send((index, work(job))).is_err() {
                        break;
                    }
                }
            });
        }
        drop(sender);
        let mut early = BTreeMap::new();
        let mut due = 0;
        // Taken by value, so that a refusal drops the channel and the threads see it.
        for (index, result) in results {
            early.insert(index, result);
            while let Some(result) = early.remove(&due) {
                take(result)?;
                due += 1;
            }
        }
        Ok(())
    })
}

/// The same, all results at once.
///
/// # Errors
/// The first in the order of the jobs.
pub fn all<Job: Sync, Done: Send, Error: Send>(
    jobs: &[Job],
    threads: usize,
    work: impl Fn(&Job) -> Result<Done, Error> + Sync,
) -> Result<Vec<Done>, Error> {
    let mut done = Vec::with_capacity(jobs.len());
    in_order(jobs, threads, work, |result| {
        done.push(result?);
        Ok(())
    })?;
    Ok(done)
}

/// A set: all trials of a plan, begun with empty networks or those of the plan. Says `done` after each
/// trial.
///
/// # Errors
/// When the settings do not fit the world.
pub fn set(plan: &Plan, done: impl Fn()) -> Result<RunResult, FieldError> {
    run(plan, done).map(|(result, _)| result)
}

/// The same with the trained networks.
///
/// # Errors
/// When the settings do not fit the world.
pub fn trained_set(plan: &Plan, done: impl Fn()) -> Result<(RunResult, Trained), FieldError> {
    run(plan, done).map(|(result, run)| (result, run.trained(plan)))
}

fn run(plan: &Plan, done: impl Fn()) -> Result<(RunResult, Run), FieldError> {
    let mut run = Run::new(plan)?;
    let trials = std::iter::repeat_with(|| run.step_silently()).flatten();
    let trials = trials.take(plan.trials as usize).inspect(|_| done()).collect();
    Ok((result(plan, trials, run.altered_starts(&plan.starts)), run))
}

/// The whole result of a plan that was run, each trial with its regret, and with what its networks did
/// from altered starts.
#[must_use]
pub fn result(plan: &Plan, trials: Vec<Trial>, starts: Vec<AlteredStartView>) -> RunResult {
    let yardstick = yardstick::compute(plan);
    let trials: Vec<Trial> = trials.into_iter().map(|trial| yardstick.mark(trial)).collect();
    RunResult {
        experiment: plan.experiment.clone(),
        seed: plan.seed,
        build: crate::build(),
        settings: plan.values.clone(),
        summary: summary(&trials, &yardstick),
        trials,
        starts: starts.into_iter().map(AlteredStartView::without_paths).collect(),
    }
}

/// All episodes of a tabular plan. Says `done` after each.
///
/// # Errors
/// The setting that contradicts itself or another.
pub fn table(plan: &PlainPlan, done: impl Fn()) -> Result<TableResult, FieldError> {
    let mut run = TableRun::new(plan)?;
    let episodes = std::iter::repeat_with(|| run.step_silently()).flatten();
    let rounds = TableRun::new(plan)?.rounds() as usize;
    let episodes = episodes.take(rounds).inspect(|_| done()).collect();
    Ok(table_result(plan, episodes, run.scores()))
}

/// The whole result of a tabular plan that was run.
#[must_use]
pub fn table_result(
    plan: &PlainPlan,
    episodes: Vec<EpisodeView>,
    summary: ScoresView,
) -> TableResult {
    TableResult {
        experiment: plan.experiment.clone(),
        seed: plan.seed,
        build: crate::build(),
        settings: plan.values.clone(),
        episodes,
        summary,
    }
}

/// All runs of a plan of chapter 2. Says `done` after each.
///
/// # Errors
/// The setting that contradicts itself or another.
pub fn drive(plan: &PlainPlan, done: impl Fn()) -> Result<DriveResult, FieldError> {
    let mut run = DriveRun::new(plan)?;
    let rounds = run.rounds() as usize;
    let runs = std::iter::repeat_with(|| run.step_silently()).flatten();
    let runs = runs.take(rounds).inspect(|_| done()).collect();
    Ok(drive_result(plan, runs, run.scores()))
}

/// The whole result of a plan of chapter 2 that was run.
#[must_use]
pub fn drive_result(
    plan: &PlainPlan,
    episodes: Vec<DriveRunView>,
    summary: DriveScores,
) -> DriveResult {
    DriveResult {
        experiment: plan.experiment.clone(),
        seed: plan.seed,
        build: crate::build(),
        settings: plan.values.clone(),
        episodes,
        summary,
    }
}

fn claim<'a, Job>(next: &AtomicUsize, jobs: &'a [Job]) -> Option<(usize, &'a Job)> {
    let index = next.fetch_add(1, Ordering::Relaxed);
    jobs.get(index).map(|job| (index, job))
}

#[cfg(test)]
mod tests {
    use std::sync::Barrier;

    use super::*;

    #[test]
    fn results_come_in_the_order_of_the_jobs() {
        // Each waits for another after a job, so that two threads take the jobs by turns.
        let turn = Barrier::new(2);
        let squares = all(&[3, 1, 2, 7, 5, 6], 2, |job| {
            turn.wait();
            Ok::<i32, ()>(job * job)
        });
        assert_eq!(squares, Ok(vec![9, 1, 4, 49, 25, 36]));
    }

    #[test]
    fn any_number_of_threads_does() {
        for threads in [0, 1, 3, 50] {
            assert_eq!(all(&[1, 2, 3], threads, |job| Ok::<_, ()>(*job)), Ok(vec![1, 2, 3]));
            assert_eq!(all(&[], threads, |job: &i32| Ok::<_, ()>(*job)), Ok(vec![]));
        }
    }

    #[test]
    fn the_first_failure_in_order_ends_it() {
        let work = |job: &u32| if *job % 2 == 1 { Err(*job) } else { Ok(*job) };
        assert_eq!(all(&[2, 4, 7, 6, 9], 3, work), Err(7));
    }
}
