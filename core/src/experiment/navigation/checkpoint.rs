//! What is kept between runs.

use serde::{Deserialize, Serialize};

use super::NavigationError;
use crate::perception::Method;
use crate::settings::{Field, Value};

/// Everything needed to go on between runs; random streams are derived anew.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NavigationCheckpoint {
    runs: u32,
    ticks: u64,
    /// The method's name: a tagged choice would not survive every format.
    method: String,
    silent: Vec<bool>,
}

/// How far a session has come, and what an operator has changed.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Progress {
    /// Runs done.
    pub(super) runs: u32,
    /// Cycles done.
    pub(super) ticks: u64,
    /// The method that drives.
    pub(super) method: Method,
    /// Whether each sonar is silent.
    pub(super) silent: Vec<bool>,
}

impl NavigationCheckpoint {
    /// Runs done.
    #[must_use]
    pub fn runs_done(&self) -> u32 {
        self.runs
    }

    /// Cycles done.
    #[must_use]
    pub fn ticks(&self) -> u64 {
        self.ticks
    }
}

impl Progress {
    pub(super) fn new(method: Method, sonars: usize) -> Self {
        Self { runs: 0, ticks: 0, method, silent: vec![false; sonars] }
    }

    pub(super) fn checkpoint(&self) -> NavigationCheckpoint {
        let Self { runs, ticks, method, silent } = self.clone();
        NavigationCheckpoint { runs, ticks, method: method.to_value().to_string(), silent }
    }

    /// What a checkpoint says, for a robot with as many sonars as this one.
    pub(super) fn resumed(
        &self,
        checkpoint: &NavigationCheckpoint,
    ) -> Result<Self, NavigationError> {
        let NavigationCheckpoint { runs, ticks, method, silent } = checkpoint.clone();
        let method =
            Method::from_value(&Value::Choice(method)).ok_or(NavigationError::Checkpoint)?;
        if silent.len() != self.silent.len() {
            return Err(NavigationError::Checkpoint);
        }
        Ok(Self { runs, ticks, method, silent })
    }
}
