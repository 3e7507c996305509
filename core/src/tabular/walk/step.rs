//! What one step and one trial were made of.

use serde::{Deserialize, Serialize};

use super::super::Update;

/// A reward and its parts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Reward {
    /// The task's own.
    pub task: f64,
    /// For a subgoal.
    pub subgoal: f64,
    /// For running into a wall.
    pub bump: f64,
    /// Of the progress estimator.
    pub progress: f64,
}

impl Reward {
    /// r.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.task + (self.subgoal + self.bump + self.progress)
    }
}

/// One step with every number that it was made of.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WalkStep {
    /// Number of the step in the walk, from 1.
    pub tick: u64,
    /// Trial, from 1.
    pub trial: u32,
    /// Step of the trial, from 1.
    pub step: u32,
    /// x.
    pub state: usize,
    /// Q(x,·), or an actor's preferences, before the step.
    pub values: Vec<f64>,
    /// What advice and reflex added to each action, log-odds.
    pub pulls: Vec<f64>,
    /// Share of the reflex in that.
    pub reflex_pull: f64,
    /// p(u).
    pub chances: Vec<f64>,
    /// τ or ε.
    pub exploration: f64,
    /// u.
    pub action: usize,
    /// y.
    pub next: usize,
    /// The action changed nothing.
    pub bumped: bool,
    /// r and its parts.
    pub reward: Reward,
    /// The update that followed.
    pub update: Update,
    /// The trial ended by itself.
    pub ended: bool,
}

/// One trial, from the start to an end or the limit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Trial {
    /// Number, from 1.
    pub trial: u32,
    /// Actions taken.
    pub steps: u32,
    /// An absorbing state was reached; otherwise the limit of steps was.
    pub reached_end: bool,
    /// Sum of the task's own rewards.
    pub total_reward: f64,
    /// Actions that changed nothing.
    pub bumps: u32,
    /// τ or ε.
    pub exploration: f64,
    /// First step's tick.
    pub first_tick: u64,
    /// Last step's tick.
    pub last_tick: u64,
}
