//! The present of a session, as viewers see it between two snapshots.

use std::collections::VecDeque;
use std::sync::Arc;

use super::machine::{Machine, Stepped};
use super::paths::Paths;
use crate::wire::{
    CycleView, DriveScores, Family, HELLO_CYCLES, NeuronView, ScoresView, StepView, TableView,
    TickView,
};

/// What of a session changes with every step. Cheap to clone.
#[derive(Clone, Debug)]
pub enum Present {
    /// Of a robot.
    Path(PathPresent),
    /// Of a tabular experiment.
    Table(TablePresent),
    /// Of a robot driven by rules.
    Drive(DrivePresent),
}

/// A robot's step, its learner's neurons, and where it has been.
#[derive(Clone, Debug, Default)]
pub struct PathPresent {
    /// The last control step, if there was one.
    pub tick: Option<Arc<TickView>>,
    /// All neurons, without their centres.
    pub neurons: Arc<Vec<NeuronView>>,
    /// Where the robot has been.
    pub paths: Paths,
}

/// A tabular step and the tables behind it.
#[derive(Clone, Debug, Default)]
pub struct TablePresent {
    /// The last step, if there was one.
    pub step: Option<Arc<StepView>>,
    /// The tables, once there are some.
    pub table: Option<Arc<TableView>>,
    /// Counts how often the tables were looked at: an operator may change them between two steps.
    pub revision: u64,
    /// How the competitors stand.
    pub scores: Arc<ScoresView>,
}

/// The latest cycles of a robot driven by rules.
#[derive(Clone, Debug, Default)]
pub struct DrivePresent {
    /// The newest last, at most [`HELLO_CYCLES`].
    pub cycles: Arc<VecDeque<Arc<CycleView>>>,
    /// How the methods stand.
    pub scores: Arc<DriveScores>,
}

impl Present {
    /// Before the first step.
    #[must_use]
    pub fn empty(family: Family) -> Self {
        match family {
            Family::Path => Self::Path(PathPresent::default()),
            Family::Table => Self::Table(TablePresent::default()),
            Family::Drive => Self::Drive(DrivePresent::default()),
        }
    }

    /// The present of a robot, if it is one.
    #[must_use]
    pub fn path(&self) -> Option<&PathPresent> {
        match self {
            Self::Path(path) => Some(path),
            Self::Table(_) | Self::Drive(_) => None,
        }
    }

    /// The present of a tabular experiment, if it is one.
    #[must_use]
    pub fn table(&self) -> Option<&TablePresent> {
        match self {
            Self::Table(table) => Some(table),
            Self::Path(_) | Self::Drive(_) => None,
        }
    }

    /// The present of a robot driven by rules, if it is one.
    #[must_use]
    pub fn drive(&self) -> Option<&DrivePresent> {
        match self {
            Self::Drive(drive) => Some(drive),
            Self::Path(_) | Self::Table(_) => None,
        }
    }

    /// Number of the last step, if there was one.
    #[must_use]
    pub fn step(&self) -> Option<u64> {
        match self {
            Self::Path(path) => path.tick.as_ref().map(|tick| tick.tick),
            Self::Table(table) => table.step.as_ref().map(|step| step.tick()),
            Self::Drive(drive) => drive.cycles.back().map(|cycle| cycle.tick),
        }
    }

    /// Takes a step in.
    pub(super) fn follow(&mut self, stepped: &Stepped) {
        match (self, stepped) {
            (Self::Path(path), Stepped::Path(tick, end)) => {
                path.paths.follow(tick);
                path.tick = Some(Arc::new((**tick).clone()));
                if let Some(end) = end {
                    path.paths.end_trial(end.trial.record);
                }
            }
            (Self::Table(table), Stepped::Table(step, _)) => {
                table.step = Some(Arc::new(step.clone()));
            }
            (Self::Drive(drive), Stepped::Drive(cycle, _)) => drive.take((**cycle).clone()),
            // A session has one family from its creation on.
            _ => {}
        }
    }

    /// Looks at what is too large to look at in every step.
    pub(super) fn look(&mut self, machine: &mut Machine) {
        match (self, machine) {
            (Self::Path(path), Machine::Path(run)) => path.neurons = Arc::new(run.neurons()),
            (Self::Table(table), Machine::Table(run)) => {
                table.table = Some(Arc::new(run.table(table.step.as_deref())));
                table.revision += 1;
            }
            _ => {}
        }
    }

    /// Counts how competitors stand after an episode.
    pub(super) fn count(&mut self, machine: &Machine) {
        match (self, machine) {
            (Self::Table(table), Machine::Table(run)) => table.scores = Arc::new(run.scores()),
            (Self::Drive(drive), Machine::Drive(run)) => drive.scores = Arc::new(run.scores()),
            _ => {}
        }
    }

    /// Forgets the trial under way.
    pub(super) fn drop_trial(&mut self) {
        match self {
            Self::Path(path) => {
                path.paths.drop_trial();
                path.tick = None;
            }
            Self::Table(table) => table.step = None,
            Self::Drive(drive) => drive.cycles = Arc::default(),
        }
    }
}

impl DrivePresent {
    /// Takes a cycle in; the oldest goes when there are too many.
    pub(super) fn take(&mut self, cycle: CycleView) {
        let cycles = Arc::make_mut(&mut self.cycles);
        cycles.push_back(Arc::new(cycle));
        if cycles.len() > HELLO_CYCLES {
            cycles.pop_front();
        }
    }
}
