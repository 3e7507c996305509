//! The present of a session, as viewers see it between two snapshots.

use std::sync::Arc;

use super::machine::{Machine, Stepped};
use super::paths::Paths;
use crate::wire::{Family, NeuronView, ScoresView, StepView, TableView, TickView};

/// What of a session changes with every step. Cheap to clone.
#[derive(Clone, Debug)]
pub enum Present {
    /// Of a robot.
    Path(PathPresent),
    /// Of a tabular experiment.
    Table(TablePresent),
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
    /// How the competitors stand.
    pub scores: Arc<ScoresView>,
}

impl Present {
    /// Before the first step.
    #[must_use]
    pub fn empty(family: Family) -> Self {
        match family {
            Family::Path => Self::Path(PathPresent::default()),
            Family::Table => Self::Table(TablePresent::default()),
        }
    }

    /// The present of a robot, if it is one.
    #[must_use]
    pub fn path(&self) -> Option<&PathPresent> {
        match self {
            Self::Path(path) => Some(path),
            Self::Table(_) => None,
        }
    }

    /// The present of a tabular experiment, if it is one.
    #[must_use]
    pub fn table(&self) -> Option<&TablePresent> {
        match self {
            Self::Table(table) => Some(table),
            Self::Path(_) => None,
        }
    }

    /// Number of the last step, if there was one.
    #[must_use]
    pub fn step(&self) -> Option<u64> {
        match self {
            Self::Path(path) => path.tick.as_ref().map(|tick| tick.tick),
            Self::Table(table) => table.step.as_ref().map(|step| step.tick()),
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
            // A session has one family from its creation on.
            (Self::Path(_), Stepped::Table(..)) | (Self::Table(_), Stepped::Path(..)) => {}
        }
    }

    /// Looks at what is too large to look at in every step.
    pub(super) fn look(&mut self, machine: &mut Machine) {
        match (self, machine) {
            (Self::Path(path), Machine::Path(run)) => path.neurons = Arc::new(run.neurons()),
            (Self::Table(table), Machine::Table(run)) => {
                table.table = Some(Arc::new(run.table(table.step.as_deref())));
            }
            (Self::Path(_), Machine::Table(_)) | (Self::Table(_), Machine::Path(_)) => {}
        }
    }

    /// Counts how competitors stand after an episode.
    pub(super) fn count(&mut self, machine: &Machine) {
        if let (Self::Table(table), Machine::Table(run)) = (self, machine) {
            table.scores = Arc::new(run.scores());
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
        }
    }
}
