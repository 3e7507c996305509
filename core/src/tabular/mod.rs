//! Learning in tables: chapter 3.
//!
//! Symbols throughout: x state, u action, y next state, r reward, γ discount, β and α learning rates,
//! τ temperature, Δ change of a value.

mod advisor;
mod bandit;
mod bias;
mod compact;
mod critic;
mod dyna;
mod error;
mod exponential;
mod file;
mod gated;
mod learner;
mod maze;
mod mdp;
mod model;
mod optimality;
mod planning;
mod q_learning;
mod selection;
mod sweeping;
mod table;
mod values;
mod walk;
mod world;

pub use advisor::{Advisor, AdvisorMemory, AdvisorRule, RuleRecord, vocabulary};
pub use bandit::{Arm, Bandit, BanditError, Estimates, Payoff, Pull, Strategy, StrategyRule};
pub use bias::{Belief, BeliefError, Exclusion, Reflex, Shaping, Subgoals};
pub use compact::{Compact, CompactRule, CompactTable, Units};
pub use critic::{Ahc, Critic};
pub use dyna::Dyna;
pub use error::MdpError;
pub use exponential::Exponential;
pub use file::{FileError, MazeFile, RowFile, TableFile};
pub use gated::{Gate, Gated};
pub use learner::{
    AnyLearner, Backup, Experience, Learner, LearnerError, LearnerKind, LearnerRule, ModelKind,
    Transport, Update,
};
pub use maze::{Cell, Maze};
pub use mdp::{MOST_ACTIONS, MOST_STATES, Mdp, Outcome, Row, Transition};
pub use model::{Model, Seen};
pub use optimality::{
    Average, Chain, Crossing, Horizon, average, crossings, finite_horizon, first_best, receding,
};
pub use planning::{
    PolicySolution, Solution, Sweep, evaluate, greedy, policy_iteration, value_iteration,
};
pub use q_learning::QLearning;
pub use selection::{Selection, SelectionError, chances, choose};
pub use sweeping::Sweeping;
pub use table::Table;
pub use values::{ActionValues, ValuesError, check_table};
pub use walk::{
    Anneal, Exploration, Explorer, Reward, Trial, Walk, WalkError, WalkMemory, WalkSetup, WalkStep,
};
pub use world::{AnyWorld, Degrees, Feature, Knowledge, World};

use rand::Rng;

/// A number from 0 (in) to 1 (out), in steps of 2⁻⁵³.
#[inline]
pub fn unit(rng: &mut impl Rng) -> f64 {
    unit_of(rng.next_u64())
}

/// The number that 64 random bits stand for.
#[inline(always)]
#[expect(clippy::cast_precision_loss, reason = "53 bits fit")]
fn unit_of(bits: u64) -> f64 {
    (bits >> 11) as f64 * (1.0 / 9_007_199_254_740_992.0)
}
