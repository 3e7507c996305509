//! Biases that act on what is tried: belief matrices, reflex, and rewards rich in knowledge of the domain.

use super::{Mdp, ValuesError, check_table};

crate::choice! {
    /// What a belief does.
    pub enum Exclusion {
        Strict = "strict": "a belief below 0 excludes its action; all are first Q-values",
        InitialOnly = "initial-only": "beliefs are first Q-values and nothing else",
        Weight = "weight": "strict, and a belief from 0 to 1 multiplies its action's chance too",
    }
}

/// A belief matrix made ready for a learner, section 4.5.
#[derive(Clone, Debug, PartialEq)]
pub struct Belief {
    /// First Q-values.
    pub initial: Vec<Vec<f64>>,
    /// Factors of the chances; 0 excludes.
    pub weights: Vec<Vec<f64>>,
}

/// A belief matrix that cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BeliefError {
    /// Wrong shape, or a number that is none.
    #[error("belief matrix: {0}")]
    Shape(#[from] ValuesError),
    /// Nothing is left to do in a state that can be reached.
    #[error(
        "belief matrix: every action of state {state} is excluded, and the state can be reached; leave \
         one at 0 or above"
    )]
    NothingLeft {
        /// The state.
        state: usize,
    },
}

impl Belief {
    /// Reads a matrix for a world.
    ///
    /// # Errors
    /// When the matrix has the wrong shape, or leaves nothing to do in a state that can be reached from
    /// the start.
    pub fn new(
        matrix: &[Vec<f64>],
        exclusion: Exclusion,
        mdp: &Mdp,
        start: usize,
    ) -> Result<Self, BeliefError> {
        check_table(matrix, mdp.states(), mdp.actions())?;
        let weight = |belief: f64| match exclusion {
            Exclusion::InitialOnly => 1.0,
            Exclusion::Strict => f64::from(u8::from(belief >= 0.0)),
            Exclusion::Weight => belief.clamp(0.0, 1.0),
        };
        let mut weights: Vec<Vec<f64>> =
            matrix.iter().map(|row| row.iter().map(|belief| weight(*belief)).collect()).collect();
        for (state, row) in weights.iter_mut().enumerate() {
            for (action, weight) in row.iter_mut().enumerate() {
                if !mdp.is_possible(state, action) {
                    *weight = 0.0;
                }
            }
        }
        let reached = reached(mdp, start, &weights);
        for (state, row) in weights.iter_mut().enumerate() {
            if row.iter().all(|weight| *weight <= 0.0) {
                if reached[state] {
                    return Err(BeliefError::NothingLeft { state });
                }
                row.fill(1.0);
            }
        }
        Ok(Self { initial: matrix.to_vec(), weights })
    }

    /// No belief: one first value for all, nothing excluded but what is impossible.
    #[must_use]
    pub fn none(mdp: &Mdp, value: f64) -> Self {
        let row = |state| {
            (0..mdp.actions())
                .map(move |action| f64::from(u8::from(mdp.is_possible(state, action))))
        };
        Self {
            initial: vec![vec![value; mdp.actions()]; mdp.states()],
            weights: (0..mdp.states()).map(|state| row(state).collect()).collect(),
        }
    }

    /// Pairs of state and action that are left to try: the effective search space of section 4.9.
    #[must_use]
    pub fn search_space(&self) -> usize {
        self.weights.iter().flatten().filter(|weight| **weight > 0.0).count()
    }
}

/// States that can be reached by what is left.
fn reached(mdp: &Mdp, start: usize, weights: &[Vec<f64>]) -> Vec<bool> {
    let mut reached = vec![false; mdp.states()];
    let mut front = vec![start];
    reached[start] = true;
    while let Some(state) = front.pop() {
        if mdp.is_absorbing(state) {
            continue;
        }
        for (action, weight) in weights[state].iter().enumerate() {
            if *weight <= 0.0 {
                continue;
            }
            for outcome in mdp.outcomes(state, action) {
                if !reached[outcome.next] {
                    reached[outcome.next] = true;
                    front.push(outcome.next);
                }
            }
        }
    }
    reached
}

/// Reflex: what to do where experience is lacking (figure 4.4).
#[derive(Clone, Debug, PartialEq)]
pub struct Reflex {
    /// Action of each state.
    pub actions: Vec<usize>,
    /// Log-odds that it adds to its action in a state never met.
    pub strength: f64,
    /// Visits after which half of the strength is left.
    pub half_life: f64,
}

impl Reflex {
    /// Log-odds for the action of the reflex after so many visits to a state.
    #[must_use]
    pub fn pull(&self, visits: u32) -> f64 {
        self.strength * self.half_life / (self.half_life + f64::from(visits))
    }
}

/// Rewards beside the task's own: heterogeneous rewards and a progress estimator, section 4.3.
///
/// NOTE: section 4.11 itself doubts the place ("the reward signal is not the right place to impart prior
/// knowledge"); the index counts actions, so that these rewards cannot praise themselves.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shaping {
    /// Subgoals, if they are rewarded.
    pub subgoals: Option<Subgoals>,
    /// Estimated way to the goal of each state, and the reward of one step of it.
    pub progress: Option<(Vec<f64>, f64)>,
}

/// Heterogeneous rewards: subgoals reached, and walls run into.
#[derive(Clone, Debug, PartialEq)]
pub struct Subgoals {
    /// States that are subgoals.
    pub states: Vec<bool>,
    /// Reward of the first arrival in each, once a trial.
    pub reward: f64,
    /// Reward of an action that changes nothing.
    pub bump: f64,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tabular::{Outcome, Row};

    fn mdp() -> Mdp {
        let to = |next| vec![Outcome { next, chance: 1.0, reward: 0.0 }];
        let rows = [
            Row { state: 0, action: 0, outcomes: to(1) },
            Row { state: 0, action: 1, outcomes: to(2) },
            Row { state: 1, action: 0, outcomes: to(2) },
            Row { state: 1, action: 1, outcomes: to(0) },
        ];
        Mdp::new(3, 2, &[2], &rows).expect("rows sum to 1")
    }

    #[test]
    fn beliefs_exclude_weigh_or_only_begin() {
        let matrix = vec![vec![-1.0, 0.5], vec![-1.0, -1.0], vec![1.0, 1.0]];
        // State 1 can only be reached by what state 0 excludes.
        for (exclusion, row, space) in [
            (Exclusion::Strict, [0.0, 1.0], 5),
            (Exclusion::Weight, [0.0, 0.5], 5),
            (Exclusion::InitialOnly, [1.0, 1.0], 6),
        ] {
            let belief = Belief::new(&matrix, exclusion, &mdp(), 0).expect("something is left");
            assert_eq!((&belief.weights[0][..], belief.search_space()), (&row[..], space));
            assert_eq!(belief.initial, matrix);
        }
    }

    #[test]
    fn what_cannot_be_used_is_named() {
        let good = vec![vec![1.0, 1.0], vec![-1.0, -1.0], vec![1.0, 1.0]];
        for (matrix, message) in [
            (
                good.clone(),
                "belief matrix: every action of state 1 is excluded, and the state can be \
                reached; leave one at 0 or above",
            ),
            (good[..2].to_vec(), "belief matrix: the table must have 3 rows, one a state, not 2"),
            (
                vec![vec![1.0], vec![1.0, 1.0], vec![1.0, 1.0]],
                "belief matrix: row 0 of the table must have 2 numbers, one an action, not 1",
            ),
            (
                vec![vec![1.0, 1.0], vec![f64::NAN, 1.0], vec![1.0, 1.0]],
                "belief matrix: row 1, action 0 of the table must be a finite number",
            ),
        ] {
            let error = Belief::new(&matrix, Exclusion::Strict, &mdp(), 0).expect_err(message);
            assert_eq!(error.to_string(), message);
        }
    }

    #[test]
    fn a_reflex_gives_way_to_experience() {
        let reflex = Reflex { actions: vec![0], strength: 4.0, half_life: 10.0 };
        for (visits, expected) in [(0, 4.0), (10, 2.0), (30, 1.0)] {
            assert!((reflex.pull(visits) - expected).abs() < 1e-12);
        }
    }
}
