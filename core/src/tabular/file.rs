//! What the files of tabular worlds say, and what can be wrong with them.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::MdpError;

/// A maze drawn in characters.
///
/// `#` wall, `.` floor, `S` start, `G` goal, `X` pit, `a` to `z` floor of a room; beyond the drawing is wall.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MazeFile {
    /// Name, as settings give it.
    pub name: String,
    /// Title for people.
    pub title: String,
    /// One sentence on what it is like.
    pub summary: String,
    /// Where it comes from.
    pub source: String,
    /// The drawing, a row a line.
    pub map: String,
    /// Reward of entering a goal.
    #[serde(default = "one")]
    pub goal_reward: f64,
    /// Reward of entering a pit, which ends a trial like a goal.
    #[serde(default = "minus_one")]
    pub pit_reward: f64,
    /// Reward of every other step.
    #[serde(default)]
    pub step_reward: f64,
    /// Reward of walking against a wall, in place of the step's.
    #[serde(default)]
    pub bump_reward: f64,
    /// Chance that a step goes astray, half to each side.
    #[serde(default)]
    pub slip: f64,
}

fn one() -> f64 {
    1.0
}

fn minus_one() -> f64 {
    -1.0
}

/// A process written down row by row.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TableFile {
    /// Name, as settings give it.
    pub name: String,
    /// Title for people.
    pub title: String,
    /// One sentence on what it is like.
    pub summary: String,
    /// Where it comes from.
    pub source: String,
    /// Names of the states.
    pub states: Vec<String>,
    /// Names of the actions.
    pub actions: Vec<String>,
    /// State in which trials start.
    pub start: String,
    /// States that end a trial.
    #[serde(default)]
    pub absorbing: Vec<String>,
    /// Rows P(· | x, u).
    pub rows: Vec<RowFile>,
}

/// What one action in one state leads to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RowFile {
    /// State x.
    pub state: String,
    /// Action u.
    pub action: String,
    /// Chance of each next state.
    pub to: BTreeMap<String, f64>,
    /// Reward R(x,u); 0 when left out.
    #[serde(default)]
    pub reward: f64,
    /// Rewards R(x,u,y) of some next states, in place of `reward`.
    #[serde(default)]
    pub rewards: BTreeMap<String, f64>,
}

/// A refusal: what is wrong, where in the file, and what would be right.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FileError {
    /// A character that means nothing.
    #[error(
        "`map`, line {line}, column {column}: `{found}` means nothing; use # wall, . floor, S start, \
         G goal, X pit, a to z for rooms"
    )]
    Character {
        /// From 1.
        line: usize,
        /// From 1.
        column: usize,
        /// The character.
        found: char,
    },
    /// Something must stand in the map once, or at least once.
    #[error("`map` must have {expected}, not {found}")]
    Count {
        /// What.
        expected: &'static str,
        /// How many there are.
        found: usize,
    },
    /// Two starts.
    #[error("`map`, line {line}, column {column}: a second start; a maze has one")]
    SecondStart {
        /// From 1.
        line: usize,
        /// From 1.
        column: usize,
    },
    /// No way from start to goal.
    #[error("`map`: no way leads from the start at line {line}, column {column} to a goal")]
    UnreachableGoal {
        /// From 1.
        line: usize,
        /// From 1.
        column: usize,
    },
    /// The drawing is too large.
    #[error("`map` must have at most {limit} cells that are not wall, not {found}")]
    TooLarge {
        /// The limit.
        limit: usize,
        /// What there is.
        found: usize,
    },
    /// A number out of range.
    #[error("`{field}` must be {expected}, not {found}")]
    Number {
        /// Where.
        field: String,
        /// What would be right.
        expected: &'static str,
        /// What was given.
        found: f64,
    },
    /// A name that is not declared.
    #[error("`{field}` is `{found}`, which is none of `{among}`")]
    Unknown {
        /// Where.
        field: String,
        /// The name.
        found: String,
        /// Where names are declared.
        among: &'static str,
    },
    /// A name that is declared twice.
    #[error("`{field}` declares `{found}` twice")]
    Twice {
        /// Where.
        field: &'static str,
        /// The name.
        found: String,
    },
    /// The rows do not make a process.
    #[error("`{field}`: {error}")]
    Process {
        /// Where.
        field: String,
        /// What is wrong.
        error: MdpError,
    },
    /// The end cannot be reached.
    #[error("`absorbing`: no way leads from the start `{start}` to any of these states")]
    UnreachableEnd {
        /// The start.
        start: String,
    },
}

impl FileError {
    /// The field at fault.
    #[must_use]
    pub fn field(&self) -> &str {
        match self {
            Self::Number { field, .. }
            | Self::Unknown { field, .. }
            | Self::Process { field, .. } => field,
            Self::Twice { field, .. } => field,
            Self::UnreachableEnd { .. } => "absorbing",
            Self::Character { .. }
            | Self::Count { .. }
            | Self::SecondStart { .. }
            | Self::UnreachableGoal { .. }
            | Self::TooLarge { .. } => "map",
        }
    }
}

pub(super) fn finite(field: &str, found: f64) -> Result<(), FileError> {
    if found.is_finite() {
        return Ok(());
    }
    Err(FileError::Number { field: field.to_owned(), expected: "a finite number", found })
}
