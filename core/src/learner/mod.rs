//! The growing, localized actor-critic of chapter 5.
//!
//! | symbol | here | meaning |
//! |---|---|---|
//! | `x` | [`Input`] | inputs: sonars, 8 distance units, Eq. (5.5) |
//! | `c, p, u, μ` | [`Neuron`] | centre, prototypical action, utility, mean |
//! | `ς` | `novelty` | width of a receptive field, Eq. (5.9) |
//! | `T(n)` | `temperature_deg` | computational temperature, Eq. (5.16)-(5.17) |
//! | `σ, ξ, α` | [`Exploration`] | spread, draw and action, Eq. (5.12)-(5.15) |
//! | `δ` | [`Update`] | temporal-difference error, Eq. (5.19) |
//! | `q` | [`Aim`] | later point of the record path that a neuron aims at (A1) |
//! | `R(n)` | [`TrialRecord`] | total reinforcement of trial `n`, Eq. (5.27) |
//!
//! One [`Learner`] runs Algorithm 9 as a state machine: [`Learner::decide`] takes an observation and
//! gives a rotation; [`Learner::consequence`] takes what came of it; [`Learner::end_trial`] closes a
//! trial. It never sees the true pose.

mod algorithm;
mod annealing;
mod carry;
mod critic;
mod echoes;
mod exchange;
mod explanation;
mod input;
mod memory;
mod network;
mod reward;
mod scout;
mod settings;
mod shortcut;
mod sketch;
mod stochastic;
mod trial_end;

pub use algorithm::{Learner, Recall, Silence};
pub use carry::CarryError;
pub use exchange::{Consequence, Decision, Observation};
pub use explanation::*;
pub use input::{DISTANCE_UNITS, INPUTS, Input, InputSettings, SonarFrame};
pub use memory::Memory;
pub use network::{Network, Neuron, NoveltyMetric, Partition};
pub use reward::{RewardSettings, goal_part, reinforcement};
pub use settings::{
    ActionFrame, Carry, Deviation, Draw, FirstAction, Judge, LearnerSettings, MeanUpdate,
    Replacement, Withdrawal,
};
