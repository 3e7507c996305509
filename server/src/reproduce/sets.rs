//! What runs the arms of a target, one set a seed; and sets of trials, run once for all targets that look
//! at them.

use std::any::Any;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use sonarium_core::stats::Estimate;

use super::{Arm, Origin, ReproductionError, Target};
use crate::batch;
use crate::catalog::{Catalog, FieldError, Plan};
use crate::session::Run;
use crate::wire::{AlteredStartView, NewSession, StartView, Trial};

/// What runs the arms of a target: sets of trials, or with [`Sets::each`] whatever else a seed gives.
#[derive(Clone, Copy)]
pub struct Sets<'a> {
    /// What came with the program.
    pub catalog: &'a Catalog,
    /// Threads to run on.
    pub threads: usize,
    /// Samples of other targets.
    pub kept: &'a Kept,
    /// To be called after each set.
    pub done: &'a (dyn Fn() + Sync),
}

/// Samples that several targets look at, by what was run.
#[derive(Debug, Default)]
pub struct Kept(Mutex<BTreeMap<String, Arc<dyn Any + Send + Sync>>>);

/// All sets of one arm.
#[derive(Clone, Debug)]
pub struct Sample {
    /// The arm.
    pub arm: Arm,
    /// What was run, with the first seed: world, settings.
    pub plan: Plan,
    /// First and last seed.
    pub seeds: [u64; 2],
    /// The sets, in the order of their seeds.
    pub sets: Vec<Set>,
}

/// A set of trials, begun with empty networks or with those of its plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Set {
    /// Its seed.
    pub seed: u64,
    /// The trials.
    pub trials: Vec<Trial>,
    /// True path of the first trial, metres, from home.
    pub first_path_m: Vec<[f64; 2]>,
    /// True path of the last trial, metres, from home.
    pub last_path_m: Vec<[f64; 2]>,
    /// What the trained networks do from the plan's altered starts, without the paths.
    pub starts: Vec<AlteredStartView>,
}

impl Sets<'_> {
    /// The sets of an arm; run once for all targets that share what is kept.
    ///
    /// # Errors
    /// When the arm's settings do not fit.
    pub fn shared(&self, target: &Target, arm: &Arm) -> Result<Arc<Sample>, ReproductionError> {
        self.shared_from(target, arm, &[])
    }

    /// The same, its trained networks tried from altered starts.
    ///
    /// # Errors
    /// When the arm's settings do not fit.
    pub fn shared_from(
        &self,
        target: &Target,
        arm: &Arm,
        starts: &[StartView],
    ) -> Result<Arc<Sample>, ReproductionError> {
        let Target { experiment, trials, seeds, .. } = target;
        let key = format!("{experiment} {arm:?} {trials} {seeds:?} {starts:?}");
        self.once(target, key, || self.run_from(target, arm, starts))
    }

    /// What an arm gives, from what is kept under this key or run now, and kept for the next target that
    /// asks for it. What is kept counts as run.
    ///
    /// # Errors
    /// When it has to be run and fails.
    pub fn once<Given: Any + Send + Sync>(
        &self,
        target: &Target,
        key: String,
        run: impl FnOnce() -> Result<Given, ReproductionError>,
    ) -> Result<Arc<Given>, ReproductionError> {
        if let Some(given) = self.kept.get(&key) {
            (0..target.sets()).for_each(|_| (self.done)());
            return Ok(given);
        }
        let given = Arc::new(run()?);
        self.kept.put(key, given.clone());
        Ok(given)
    }

    /// The sets of an arm, run now and kept by nobody else.
    ///
    /// # Errors
    /// When the arm's settings do not fit.
    pub fn of(&self, target: &Target, arm: &Arm) -> Result<Sample, ReproductionError> {
        self.run_from(target, arm, &[])
    }

    fn run_from(
        &self,
        target: &Target,
        arm: &Arm,
        starts: &[StartView],
    ) -> Result<Sample, ReproductionError> {
        let plan = Plan { starts: starts.to_vec(), ..self.plan(target, arm)? };
        self.with(target, arm, plan)
    }

    /// The sets of an arm whose plan is given, for a world or a network that no setting names.
    ///
    /// # Errors
    /// When the plan's settings do not fit its world.
    pub fn with(
        &self,
        target: &Target,
        arm: &Arm,
        plan: Plan,
    ) -> Result<Sample, ReproductionError> {
        let seeds: Vec<u64> = target.seeds.clone().collect();
        let sets = self.each(&seeds, |&seed| Set::run(&Plan { seed, ..plan.clone() }))?;
        let seeds = [*target.seeds.start(), *target.seeds.end()];
        Ok(Sample { arm: *arm, plan, seeds, sets })
    }

    /// Does something else than run sets, once for each job, each counted as a set; the results are in
    /// the order of the jobs.
    ///
    /// # Errors
    /// The first in the order of the jobs.
    pub fn each<Job: Sync, Done: Send, Error: Send>(
        &self,
        jobs: &[Job],
        work: impl Fn(&Job) -> Result<Done, Error> + Sync,
    ) -> Result<Vec<Done>, Error> {
        batch::all(jobs, self.threads, |job| {
            let result = work(job);
            (self.done)();
            result
        })
    }

    /// What an arm runs, with the first seed.
    ///
    /// # Errors
    /// When the arm's settings do not fit.
    pub fn plan(&self, target: &Target, arm: &Arm) -> Result<Plan, ReproductionError> {
        Ok(self.catalog.resolve(&request(target, arm))?)
    }
}

/// What an arm asks for, with the first seed.
pub(super) fn request(target: &Target, arm: &Arm) -> NewSession {
    NewSession {
        experiment: target.experiment.into(),
        seed: Some(*target.seeds.start()),
        settings: arm.values(),
        trials: Some(target.trials),
        speed: None,
        network: None,
    }
}

impl Kept {
    fn get<Given: Any + Send + Sync>(&self, key: &str) -> Option<Arc<Given>> {
        let kept = self.0.lock().unwrap_or_else(PoisonError::into_inner).get(key).cloned();
        kept?.downcast().ok()
    }

    fn put(&self, key: String, given: Arc<dyn Any + Send + Sync>) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).insert(key, given);
    }
}

impl Set {
    /// Runs a set, keeping the way of its first and last trial.
    pub(super) fn run(plan: &Plan) -> Result<Self, FieldError> {
        let mut run = Run::new(plan)?;
        let mut set = Self {
            seed: plan.seed,
            trials: Vec::with_capacity(plan.trials as usize),
            first_path_m: Vec::new(),
            last_path_m: Vec::new(),
            starts: Vec::new(),
        };
        for trial in 1..=plan.trials {
            let mut path_m = Vec::new();
            let watched = trial == 1 || trial == plan.trials;
            let end = std::iter::repeat_with(|| {
                if watched { run.step_along(&mut path_m) } else { run.step_silently() }
            });
            set.trials.extend(end.flatten().next());
            if trial == 1 {
                set.first_path_m.clone_from(&path_m);
            }
            if watched {
                set.last_path_m = path_m;
            }
        }
        let starts = run.altered_starts(&plan.starts).into_iter();
        set.starts = starts.map(AlteredStartView::without_paths).collect();
        Ok(set)
    }

    /// A trial, from 1.
    #[must_use]
    pub fn trial(&self, number: u32) -> Option<&Trial> {
        self.trials.get(number.checked_sub(1)? as usize)
    }

    /// The last trial.
    #[must_use]
    pub fn last(&self) -> Option<&Trial> {
        self.trials.last()
    }
}

impl Origin for Sample {
    fn arm(&self) -> &str {
        self.arm.name
    }

    fn words(&self) -> String {
        let [first, last] = self.seeds;
        format!("{}, seeds {first}..{last}", self.arm.words())
    }
}

impl Sample {
    /// One number a set, where the set has it.
    #[must_use]
    pub fn values(&self, of: impl Fn(&Set) -> Option<f64>) -> Vec<f64> {
        self.sets.iter().filter_map(of).collect()
    }

    /// A number of a set less that of the other sample's set with the same seed, where both have it;
    /// both samples have the same seeds.
    #[must_use]
    pub fn differences(&self, less: &Self, of: impl Fn(&Set) -> Option<f64>) -> Vec<f64> {
        let pairs = self.sets.iter().zip(&less.sets);
        pairs.filter_map(|(set, other)| Some(of(set)? - of(other)?)).collect()
    }

    /// Mean of one number a set.
    #[must_use]
    pub fn mean(&self, of: impl Fn(&Set) -> Option<f64>) -> Option<Estimate> {
        Estimate::mean(&self.values(of))
    }

    /// Share of sets of which something is true, percent.
    #[must_use]
    pub fn share_pct(&self, is_so: impl Fn(&Set) -> bool) -> Option<Estimate> {
        let successes = self.sets.iter().filter(|set| is_so(set)).count();
        Some(Estimate::proportion(successes, self.sets.len())?.scaled(100.0))
    }
}
