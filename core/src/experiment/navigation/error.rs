//! Why an experiment of chapter 2 cannot be run.

use crate::perception::HashingError;
use crate::world::{ArenaError, PeopleError};

/// A robot, rules, settings or a checkpoint that do not fit.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NavigationError {
    /// The robot's file lacks what is needed.
    #[error("`robot` must have `equipment` and a rectangular body in its file; {0} has not")]
    Unequipped(String),
    /// The rules are for something else.
    #[error("`rules.file` must be for {expected}, not {found}")]
    Rules {
        /// Inputs and outputs that would be right.
        expected: String,
        /// What they are for.
        found: String,
    },
    /// The sonars cannot be hashed so.
    #[error("`hashing.regions`: {0}")]
    Hashing(#[from] HashingError),
    /// The rings bound no floor.
    #[error("`world`: {0}")]
    World(#[from] ArenaError),
    /// Somebody stands in a wall.
    #[error(transparent)]
    People(#[from] PeopleError),
    /// Two settings that contradict each other.
    #[error("`{key}` must be {expected}, not {found}")]
    Contradiction {
        /// The setting at fault.
        key: &'static str,
        /// What would be right.
        expected: String,
        /// What it is.
        found: String,
    },
    /// The checkpoint is of a robot with other sonars, or damaged.
    #[error("`checkpoint` must be of this robot and name a method there is")]
    Checkpoint,
}

impl NavigationError {
    /// The field at fault.
    #[must_use]
    pub fn field(&self) -> &str {
        match self {
            Self::Unequipped(_) => "robot",
            Self::Rules { .. } => super::RULES_FILE,
            Self::Hashing(_) => "hashing.regions",
            Self::World(_) => "world",
            Self::People(_) => super::PEOPLE_FILE,
            Self::Contradiction { key, .. } => key,
            Self::Checkpoint => "checkpoint",
        }
    }
}
