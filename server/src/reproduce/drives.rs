//! Runs of chapter 2, one a seed: an approach to a wall, or a robot driven by rules.

use sonarium_core::stats::Estimate;

use super::{Arm, Origin, ReproductionError, Sets, Target};
use crate::batch;
use crate::catalog::{FieldError, Job, PlainPlan};
use crate::session::DriveRun;
use crate::wire::{CycleView, DriveOutcome, DriveRunView, DriveScore, MethodScoreView};

/// All runs of one arm.
#[derive(Clone, Debug)]
pub struct Drives {
    /// The arm.
    pub arm: Arm,
    /// First and last seed.
    pub seeds: [u64; 2],
    /// The runs, in the order of their seeds.
    pub runs: Vec<Drive>,
}

/// One run.
#[derive(Clone, Debug, PartialEq)]
pub struct Drive {
    /// Its seed.
    pub seed: u64,
    /// What came of it.
    pub outcome: DriveOutcome,
    /// Cycles that were watched; none unless asked for.
    pub moments: Vec<Moment>,
}

/// What is kept of a cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// Seconds from the start of the run.
    pub time_s: f64,
    /// True place, metres.
    pub at_m: [f64; 2],
    /// Turn, deg/s.
    pub turn_deg_s: f64,
    /// Distance of the nearest surface in the middle region, metres.
    pub truth_m: f64,
    /// Depth of the middle region by each method, metres, in the order of
    /// [`Method::ALL`](sonarium_core::perception::Method::ALL).
    pub depths_m: Vec<f64>,
    /// A contact began.
    pub bumped: bool,
}

impl Sets<'_> {
    /// The runs of an arm, of which every so many cycles are kept, and the last.
    ///
    /// # Errors
    /// When the arm's settings do not fit.
    pub fn drives(
        &self,
        target: &Target,
        arm: &Arm,
        every: Option<u32>,
    ) -> Result<Drives, ReproductionError> {
        let plan = self.drive_plan(target, arm)?;
        let seeds: Vec<u64> = target.seeds.clone().collect();
        let runs =
            self.each(&seeds, |&seed| Drive::run(&PlainPlan { seed, ..plan.clone() }, every))?;
        Ok(Drives { arm: *arm, seeds: [*target.seeds.start(), *target.seeds.end()], runs })
    }

    /// What an arm runs, with the first seed.
    ///
    /// # Errors
    /// When the arm's settings do not fit, or the experiment is not wholly given by settings.
    pub fn drive_plan(&self, target: &Target, arm: &Arm) -> Result<PlainPlan, ReproductionError> {
        match self.catalog.job(&super::sets::request(target, arm))? {
            Job::Plain(plan) => Ok(*plan),
            Job::Path(_) => {
                let message = format!("{}: {} is not of chapter 2", arm.name, target.experiment);
                Err(ReproductionError::Broken(message))
            }
        }
    }
}

impl Drive {
    /// One run, of which every so many cycles are kept, and the last.
    ///
    /// # Errors
    /// The setting that contradicts itself or another, or an experiment that drives nothing.
    pub fn run(plan: &PlainPlan, every: Option<u32>) -> Result<Self, FieldError> {
        let (end, moments) = match every {
            Some(every) => watched(plan, every)?,
            None => (headless(plan)?, Vec::new()),
        };
        Ok(Self { seed: plan.seed, outcome: end.outcome, moments })
    }

    /// What a controlled run came to.
    #[must_use]
    pub fn score(&self) -> Option<&DriveScore> {
        match &self.outcome {
            DriveOutcome::Drive(score) => Some(score),
            DriveOutcome::Approach { .. } => None,
        }
    }

    /// How well a method told the distance in an approach.
    #[must_use]
    pub fn told(&self, method: &str) -> Option<&MethodScoreView> {
        match &self.outcome {
            DriveOutcome::Approach { scores, .. } => {
                scores.iter().find(|score| score.method == method)
            }
            DriveOutcome::Drive(_) => None,
        }
    }
}

fn headless(plan: &PlainPlan) -> Result<DriveRunView, FieldError> {
    let ends = batch::drive(plan, || ())?.episodes;
    ends.into_iter().next().ok_or_else(|| FieldError::new("trials", "must be at least 1"))
}

fn watched(plan: &PlainPlan, every: u32) -> Result<(DriveRunView, Vec<Moment>), FieldError> {
    let mut run = DriveRun::new(plan)?;
    let mut moments = Vec::new();
    loop {
        let stepped = run.step();
        if stepped.end.is_some() || stepped.cycle.cycle.is_multiple_of(every) {
            moments.push(Moment::from(&stepped.cycle));
        }
        if let Some(end) = stepped.end {
            return Ok((end, moments));
        }
    }
}

impl From<&CycleView> for Moment {
    fn from(cycle: &CycleView) -> Self {
        let middle = cycle.regions.get(cycle.regions.len() / 2);
        Self {
            time_s: cycle.time_s,
            at_m: [cycle.pose.x_m, cycle.pose.y_m],
            turn_deg_s: cycle.turn_deg_s,
            truth_m: middle.map_or(f64::NAN, |region| region.truth_m),
            depths_m: middle.map(|region| region.depths_m.clone()).unwrap_or_default(),
            bumped: cycle.bump.is_some(),
        }
    }
}

impl Origin for Drives {
    fn arm(&self) -> &str {
        self.arm.name
    }

    fn words(&self) -> String {
        let [first, last] = self.seeds;
        format!("{}, seeds {first}..{last}", self.arm.words())
    }
}

impl Drives {
    /// One number a run, where the run has it.
    #[must_use]
    pub fn values(&self, of: impl Fn(&Drive) -> Option<f64>) -> Vec<f64> {
        self.runs.iter().filter_map(of).collect()
    }

    /// A number of a run less that of the other arm's run with the same seed, where both have it; both
    /// arms have the same seeds.
    #[must_use]
    pub fn differences(&self, less: &Self, of: impl Fn(&Drive) -> Option<f64>) -> Vec<f64> {
        let pairs = self.runs.iter().zip(&less.runs);
        pairs.filter_map(|(run, other)| Some(of(run)? - of(other)?)).collect()
    }

    /// Mean of a number that a controlled run came to.
    #[must_use]
    pub fn mean(&self, of: impl Fn(&DriveScore) -> f64) -> Option<Estimate> {
        Estimate::mean(&self.values(|run| run.score().map(&of)))
    }

    /// Share of controlled runs of which something is true, percent.
    #[must_use]
    pub fn share_pct(&self, is_so: impl Fn(&DriveScore) -> bool) -> Option<Estimate> {
        let scores = || self.runs.iter().filter_map(Drive::score);
        let successes = scores().filter(|score| is_so(score)).count();
        Some(Estimate::proportion(successes, scores().count())?.scaled(100.0))
    }
}
