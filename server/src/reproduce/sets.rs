//! Sets of trials, one a seed, on several threads.

use std::ops::RangeInclusive;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use super::Target;
use crate::catalog::{Catalog, FieldError, Plan};
use crate::session::Run;
use crate::wire::{NewSession, Trial};

/// The last trial of every set of a preset, in the order of the seeds.
pub(super) fn last_trials(
    catalog: &Catalog,
    target: &Target,
    preset: &str,
    threads: usize,
    done: &(dyn Fn() + Sync),
) -> Result<Vec<Trial>, FieldError> {
    let plan = catalog.resolve(&request(target, preset))?;
    let next = AtomicU64::new(*target.seeds.start());
    let work = || claim_and_run(&plan, &target.seeds, &next, done);
    let mut sets = thread::scope(|scope| {
        let workers: Vec<_> = (0..threads.max(1)).map(|_| scope.spawn(work)).collect();
        let sets = workers
            .into_iter()
            .map(|worker| worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)));
        sets.collect::<Result<Vec<_>, FieldError>>()
    })?
    .concat();
    sets.sort_by_key(|(seed, _)| *seed);
    Ok(sets.into_iter().map(|(_, trial)| trial).collect())
}

fn request(target: &Target, preset: &str) -> NewSession {
    NewSession {
        experiment: target.experiment.into(),
        seed: Some(*target.seeds.start()),
        settings: [("preset".to_owned(), preset.into())].into(),
        trials: Some(target.trials),
        speed: None,
    }
}

/// Runs sets until every seed is taken.
fn claim_and_run(
    plan: &Plan,
    seeds: &RangeInclusive<u64>,
    next: &AtomicU64,
    done: &(dyn Fn() + Sync),
) -> Result<Vec<(u64, Trial)>, FieldError> {
    let mut sets = Vec::new();
    loop {
        let seed = next.fetch_add(1, Ordering::Relaxed);
        if !seeds.contains(&seed) {
            return Ok(sets);
        }
        let mut run = Run::new(&Plan { seed, ..plan.clone() })?;
        let trials = std::iter::repeat_with(|| run.step_silently()).flatten();
        sets.extend(trials.take(plan.trials as usize).last().map(|trial| (seed, trial)));
        done();
    }
}
