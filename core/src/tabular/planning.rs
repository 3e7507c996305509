//! Model based learning: value iteration (Algorithm 4) and policy iteration, section 3.6.

use nalgebra::{DMatrix, DVector};

use super::{ActionValues, Mdp, MdpError};

/// Most states for which a policy is evaluated by a linear solve; beyond, by iteration.
const MOST_SOLVED: usize = 1_000;
/// Change at which iterated evaluation stops.
const SETTLED: f64 = 1e-12;
/// Share of the values' size that counts as an improvement.
const IMPROVES: f64 = 1e-9;
/// Sweeps after which values that do not settle are given up.
const MOST_SWEEPS: u32 = 1_000_000;

crate::choice! {
    /// In which order value iteration uses new values.
    pub enum Sweep {
        Synchronous = "synchronous": "all states from the values of the last sweep",
        InPlace = "in-place": "each state from the newest values, as Algorithm 4 is written",
    }
}

/// The outcome of value iteration.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// V(x).
    pub values: Vec<f64>,
    /// Greedy policy; the first of several best actions.
    pub policy: Vec<usize>,
    /// Sweeps made.
    pub sweeps: u32,
    /// Largest change of the last sweep.
    pub change: f64,
    /// What the greedy policy loses at most in any state, 2εγ/(1 − γ); none for γ = 1.
    pub bound: Option<f64>,
}

/// The outcome of policy iteration.
#[derive(Clone, Debug, PartialEq)]
pub struct PolicySolution {
    /// Value of the policy.
    pub values: Vec<f64>,
    /// The policy.
    pub policy: Vec<usize>,
    /// Improvements made.
    pub improvements: u32,
}

/// Q(x,u) for given values of the next states.
pub(super) fn backup(mdp: &Mdp, state: usize, action: usize, discount: f64, values: &[f64]) -> f64 {
    // Q(x,u) = Σ_r r P_xu(r) + γ Σ_y V(y) P_xu(y)
    let outcomes = mdp.outcomes(state, action).iter();
    outcomes
        .map(|outcome| outcome.chance * (outcome.reward + discount * values[outcome.next]))
        .sum()
}

/// The best action in a state for given values of the next states, and its Q(x,u).
fn best(mdp: &Mdp, state: usize, discount: f64, values: &[f64]) -> (usize, f64) {
    let mut best = (0, f64::NEG_INFINITY);
    for action in mdp.possible(state) {
        let value = backup(mdp, state, action, discount, values);
        if value > best.1 {
            best = (action, value);
        }
    }
    best
}

/// Eq. (3.19): the greedy policy for given values.
#[must_use]
pub fn greedy(mdp: &Mdp, discount: f64, values: &[f64]) -> Vec<usize> {
    (0..mdp.states()).map(|state| best(mdp, state, discount, values).0).collect()
}

/// Algorithm 4, until no value changes by `precision` ε or more.
///
/// # Errors
/// When the discount or the precision is out of range, a discount of 1 gives some state no value, or
/// the values do not settle.
pub fn value_iteration(
    mdp: &Mdp,
    discount: f64,
    precision: f64,
    sweep: Sweep,
) -> Result<Solution, MdpError> {
    mdp.check_discount(discount)?;
    if precision.is_nan() || precision <= 0.0 {
        return Err(MdpError::Precision { found: precision });
    }
    let mut values = vec![0.0; mdp.states()];
    let mut last = values.clone();
    let budget = most_sweeps(mdp);
    for sweeps in 1..=budget {
        let mut change: f64 = 0.0;
        last.copy_from_slice(&values);
        for state in (0..mdp.states()).filter(|&state| !mdp.is_absorbing(state)) {
            let from = if sweep == Sweep::InPlace { &values } else { &last };
            // Eq. (3.17): V(x) = max_u Q(x,u)
            let value = best(mdp, state, discount, from).1;
            change = change.max((value - values[state]).abs());
            values[state] = value;
        }
        if change < precision {
            let policy = greedy(mdp, discount, &values);
            // Section 3.6: the greedy policy loses at most 2εγ/(1 − γ).
            let bound = (discount < 1.0).then(|| 2.0 * precision * discount / (1.0 - discount));
            return Ok(Solution { values, policy, sweeps, change, bound });
        }
    }
    Err(MdpError::Unsettled { sweeps: budget })
}

/// So many sweeps that large worlds do not take hours.
fn most_sweeps(mdp: &Mdp) -> u32 {
    let pairs = u32::try_from(mdp.states() * mdp.actions()).unwrap_or(u32::MAX).max(1);
    (1_000_000_000 / pairs).clamp(1_000, MOST_SWEEPS)
}

/// Values V^π(x) of a policy, Eq. (3.15).
///
/// # Errors
/// When the policy takes an impossible action, or with γ = 1 never ends from some state.
pub fn evaluate(mdp: &Mdp, policy: &[usize], discount: f64) -> Result<Vec<f64>, MdpError> {
    if !(0.0..=1.0).contains(&discount) {
        return Err(MdpError::Discount { found: discount });
    }
    for (state, &action) in policy.iter().enumerate() {
        if action >= mdp.actions() || !mdp.is_possible(state, action) {
            return Err(MdpError::Policy { state, action });
        }
    }
    if discount >= 1.0 {
        ends_from_everywhere(mdp, policy)?;
    }
    if mdp.states() <= MOST_SOLVED {
        Ok(solve(mdp, policy, discount))
    } else {
        settle(mdp, policy, discount)
    }
}

fn ends_from_everywhere(mdp: &Mdp, policy: &[usize]) -> Result<(), MdpError> {
    let mut ends: Vec<bool> = (0..mdp.states()).map(|state| mdp.is_absorbing(state)).collect();
    loop {
        let more: Vec<usize> = (0..mdp.states())
            .filter(|&state| !ends[state])
            .filter(|&state| mdp.outcomes(state, policy[state]).iter().any(|to| ends[to.next]))
            .collect();
        if more.is_empty() {
            break;
        }
        more.into_iter().for_each(|state| ends[state] = true);
    }
    match ends.iter().position(|ends| !ends) {
        Some(state) => Err(MdpError::Endless { state }),
        None => Ok(()),
    }
}

/// (I − γ P_π) V = R_π, with V = 0 in absorbing states.
fn solve(mdp: &Mdp, policy: &[usize], discount: f64) -> Vec<f64> {
    let states = mdp.states();
    let mut matrix = DMatrix::identity(states, states);
    let mut rewards = DVector::zeros(states);
    for state in (0..states).filter(|&state| !mdp.is_absorbing(state)) {
        rewards[state] = mdp.expected_reward(state, policy[state]);
        for outcome in mdp.outcomes(state, policy[state]) {
            matrix[(state, outcome.next)] -= discount * outcome.chance;
        }
    }
    let solution = matrix.lu().solve(&rewards);
    solution.expect("regular: γ < 1, or every state leads to an end").iter().copied().collect()
}

fn settle(mdp: &Mdp, policy: &[usize], discount: f64) -> Result<Vec<f64>, MdpError> {
    let mut values = vec![0.0; mdp.states()];
    let budget = most_sweeps(mdp);
    for _ in 0..budget {
        let mut change: f64 = 0.0;
        for state in (0..mdp.states()).filter(|&state| !mdp.is_absorbing(state)) {
            let value = backup(mdp, state, policy[state], discount, &values);
            change = change.max((value - values[state]).abs());
            values[state] = value;
        }
        if change < SETTLED {
            return Ok(values);
        }
    }
    Err(MdpError::Unsettled { sweeps: budget })
}

/// Policy iteration: evaluate, improve where an action is strictly better, until none is.
///
/// # Errors
/// When the discount is out of range or, with γ = 1, gives some state no value.
pub fn policy_iteration(mdp: &Mdp, discount: f64) -> Result<PolicySolution, MdpError> {
    mdp.check_discount(discount)?;
    let mut policy = first_policy(mdp);
    let mut improvements = 0;
    loop {
        let values = evaluate(mdp, &policy, discount)?;
        let mut improved = false;
        for (state, action) in policy.iter_mut().enumerate() {
            let (better, value) = best(mdp, state, discount, &values);
            let now = backup(mdp, state, *action, discount, &values);
            if value > now + IMPROVES * (1.0 + now.abs()) {
                *action = better;
                improved = true;
            }
        }
        if !improved {
            return Ok(PolicySolution { values, policy, improvements });
        }
        improvements += 1;
    }
}

/// A policy that ends from wherever any does: each action may lead nearer to an absorbing state.
fn first_policy(mdp: &Mdp) -> Vec<usize> {
    let distances = mdp.distances();
    let far = |state: usize| distances[state].unwrap_or(u32::MAX);
    (0..mdp.states())
        .map(|state| {
            let nearest = |action: &usize| {
                mdp.outcomes(state, *action).iter().map(|outcome| far(outcome.next)).min()
            };
            mdp.possible(state).min_by_key(nearest).unwrap_or(0)
        })
        .collect()
}

/// Optimal Q(x,u) as a table, from values.
impl Solution {
    /// Q(x,u) for these values; impossible pairs hold 0 and are not allowed.
    #[must_use]
    pub fn action_values(&self, mdp: &Mdp, discount: f64) -> ActionValues {
        let mut table = ActionValues::new(mdp.actions(), mdp.possibilities(), 0.0);
        for state in 0..mdp.states() {
            for action in mdp.possible(state) {
                table.set(state, action, backup(mdp, state, action, discount, &self.values));
            }
        }
        table
    }
}

#[cfg(test)]
mod tests;
