//! What an actor drives: a robot's run or a tabular one.

use super::drive_run::DriveRun;
use super::run::Run;
use super::table_run::{Intervention, TableRun};
use crate::catalog::{FieldError, Job, PlainPlan};
use crate::store::{LogRecord, StoredCheckpoint};
use crate::wire::{
    CycleView, DriveRunView, EpisodeView, Family, NeuronView, Round, StepView, TableFile, TickView,
    TrialEndView,
};

/// A run of any family.
pub(super) enum Machine {
    /// A robot that learns a path.
    Path(Box<Run>),
    /// Learners with tables.
    Table(Box<TableRun>),
    /// A robot driven by rules.
    Drive(Box<DriveRun>),
}

/// What one step gave.
pub(super) enum Stepped {
    /// Of a robot; with the end of the trial.
    Path(Box<TickView>, Option<Box<TrialEndView>>),
    /// Of a table; with the end of the episode.
    Table(StepView, Option<Box<EpisodeView>>),
    /// Of a robot driven by rules; with the end of the run.
    Drive(Box<CycleView>, Option<Box<DriveRunView>>),
}

impl Machine {
    /// A new run.
    pub(super) fn new(job: &Job) -> Result<Self, FieldError> {
        Ok(match job {
            Job::Path(plan) => Self::Path(Box::new(Run::new(plan)?)),
            Job::Plain(plan) if is_drive(plan) => Self::Drive(Box::new(DriveRun::new(plan)?)),
            Job::Plain(plan) => Self::Table(Box::new(TableRun::new(plan)?)),
        })
    }

    /// Goes on from a checkpoint.
    pub(super) fn resume(job: &Job, stored: &StoredCheckpoint) -> Result<Self, FieldError> {
        Ok(match job {
            Job::Path(plan) => Self::Path(Box::new(Run::resume(plan, stored)?)),
            Job::Plain(plan) if is_drive(plan) => {
                Self::Drive(Box::new(DriveRun::resume(plan, stored)?))
            }
            Job::Plain(plan) => Self::Table(Box::new(TableRun::resume(plan, stored)?)),
        })
    }

    pub(super) fn step(&mut self) -> Stepped {
        match self {
            Self::Path(run) => {
                let stepped = run.step();
                Stepped::Path(Box::new(stepped.tick), stepped.end.map(Box::new))
            }
            Self::Table(run) => {
                let stepped = run.step();
                Stepped::Table(stepped.step, stepped.end.map(Box::new))
            }
            Self::Drive(run) => {
                let stepped = run.step();
                Stepped::Drive(Box::new(stepped.cycle), stepped.end.map(Box::new))
            }
        }
    }

    pub(super) fn checkpoint(&self) -> Option<LogRecord> {
        match self {
            Self::Path(run) => run.checkpoint(),
            Self::Table(run) => run.checkpoint(),
            Self::Drive(run) => run.checkpoint(),
        }
    }

    pub(super) fn neuron(&self, number: u32) -> Option<NeuronView> {
        match self {
            Self::Path(run) => run.neuron(number),
            Self::Table(_) | Self::Drive(_) => None,
        }
    }

    pub(super) fn intervene(&mut self, intervention: &Intervention) -> Result<String, FieldError> {
        match self {
            Self::Table(run) => run.intervene(intervention),
            Self::Drive(run) => run.intervene(intervention),
            Self::Path(_) => Err(no_table()),
        }
    }

    pub(super) fn table_file(&self, job: &Job) -> Result<TableFile, FieldError> {
        match (self, job) {
            (Self::Table(run), Job::Plain(plan)) => run.table_file(plan),
            _ => Err(no_table()),
        }
    }
}

fn is_drive(plan: &PlainPlan) -> bool {
    plan.settings.family() == Family::Drive
}

fn no_table() -> FieldError {
    FieldError::new("experiment", "a robot's session has networks, and no table of values")
}

impl Job {
    /// What a session goes through: trials, or episodes of one competitor each.
    pub(super) fn rounds(&self) -> Result<u32, FieldError> {
        match self {
            Self::Path(plan) => Ok(plan.trials),
            Self::Plain(plan) if is_drive(plan) => DriveRun::new(plan).map(|run| run.rounds()),
            Self::Plain(plan) => TableRun::new(plan).map(|run| run.rounds()),
        }
    }
}

impl Stepped {
    /// Number of the step in the session.
    pub(super) fn number(&self) -> u64 {
        match self {
            Self::Path(tick, _) => tick.tick,
            Self::Table(step, _) => step.tick(),
            Self::Drive(cycle, _) => cycle.tick,
        }
    }

    /// The row of the round that ended with it.
    pub(super) fn round(&self) -> Option<Round> {
        match self {
            Self::Path(_, end) => end.as_ref().map(|end| Round::Trial(Box::new(end.trial.clone()))),
            Self::Table(_, end) => end.as_ref().map(|end| Round::Episode(end.clone())),
            Self::Drive(_, end) => end.as_ref().map(|end| Round::Run(end.clone())),
        }
    }

    /// Its records, the step first.
    pub(super) fn records(self) -> impl Iterator<Item = LogRecord> {
        let (step, end) = match self {
            Self::Path(tick, end) => (LogRecord::Tick(tick), end.map(LogRecord::TrialEnd)),
            Self::Table(step, end) => {
                (LogRecord::Step(Box::new(step)), end.map(LogRecord::EpisodeEnd))
            }
            Self::Drive(cycle, end) => (LogRecord::Cycle(cycle), end.map(LogRecord::RunEnd)),
        };
        std::iter::once(step).chain(end)
    }
}
