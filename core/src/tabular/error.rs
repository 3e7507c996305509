//! Why a process cannot be used.

use super::mdp::{MOST_ACTIONS, MOST_STATES};

/// A refusal by numbers; world files give the names (see [`super::FileError`]).
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MdpError {
    /// No states, or too many.
    #[error("there must be from 1 to {MOST_STATES} states, not {found}")]
    States {
        /// How many there are.
        found: usize,
    },
    /// No actions, or too many.
    #[error("there must be from 1 to {MOST_ACTIONS} actions, not {found}")]
    Actions {
        /// How many there are.
        found: usize,
    },
    /// A state is named that does not exist.
    #[error("there is no state {state}")]
    NoSuchState {
        /// Its number.
        state: usize,
    },
    /// An action is named that does not exist.
    #[error("there is no action {action}, which state {state} has a row for")]
    NoSuchAction {
        /// The state.
        state: usize,
        /// The action's number.
        action: usize,
    },
    /// Two rows for one pair.
    #[error("state {state}, action {action} has two rows; keep one")]
    Repeated {
        /// The state.
        state: usize,
        /// The action.
        action: usize,
    },
    /// The chances of a row do not sum to 1.
    #[error("the chances of state {state}, action {action} must sum to 1, not {found}")]
    Sum {
        /// The state.
        state: usize,
        /// The action.
        action: usize,
        /// What they sum to.
        found: f64,
    },
    /// A chance is none.
    #[error(
        "the chance from state {state} by action {action} to state {next} must be from 0 to 1, not {found}"
    )]
    Chance {
        /// The state.
        state: usize,
        /// The action.
        action: usize,
        /// The next state.
        next: usize,
        /// What was given.
        found: f64,
    },
    /// A reward is infinite or not a number.
    #[error(
        "the reward from state {state} by action {action} to state {next} must be a finite number"
    )]
    Reward {
        /// The state.
        state: usize,
        /// The action.
        action: usize,
        /// The next state.
        next: usize,
    },
    /// Nothing can be done in a state.
    #[error("state {state} must have a row for at least one action, or be absorbing")]
    NoAction {
        /// The state.
        state: usize,
    },
    /// A discount outside its range.
    #[error("the discount must be from 0 to 1, not {found}")]
    Discount {
        /// What was given.
        found: f64,
    },
    /// With γ = 1 a state has no finite value, because no way from it ends.
    #[error(
        "with a discount of 1 an absorbing state must be reachable from everywhere, but not from state \
         {state}; add one or take a discount below 1"
    )]
    Endless {
        /// The first state from which no way ends.
        state: usize,
    },
    /// Sweeps that do not settle.
    #[error(
        "the values have not settled after {sweeps} sweeps: with a discount of 1 a way without end \
         gathers reward without end; take a discount below 1 or a larger precision"
    )]
    Unsettled {
        /// Sweeps done.
        sweeps: u32,
    },
    /// A precision that can never be met.
    #[error("the precision must be above 0, not {found}")]
    Precision {
        /// What was given.
        found: f64,
    },
    /// A policy takes an action that is not possible.
    #[error("the policy takes action {action} in state {state}, which is not possible there")]
    Policy {
        /// The state.
        state: usize,
        /// The action.
        action: usize,
    },
}
