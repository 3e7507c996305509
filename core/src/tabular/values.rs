//! Q(x,u) as a table, with what is possible where.

use serde::{Deserialize, Serialize};

/// Values of all pairs of state and action. Plain data: it can be saved, edited and loaded again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ActionValues {
    actions: usize,
    values: Vec<f64>,
    allowed: Vec<bool>,
}

/// Why a table cannot be taken.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ValuesError {
    /// Too many or too few rows.
    #[error("the table must have {expected} rows, one a state, not {found}")]
    Rows {
        /// States of the world.
        expected: usize,
        /// Rows given.
        found: usize,
    },
    /// A row has too many or too few numbers.
    #[error("row {row} of the table must have {expected} numbers, one an action, not {found}")]
    Columns {
        /// The row, which is the state.
        row: usize,
        /// Actions of the world.
        expected: usize,
        /// Numbers given.
        found: usize,
    },
    /// A number is infinite or not a number.
    #[error("row {row}, action {column} of the table must be a finite number")]
    NotFinite {
        /// The row, which is the state.
        row: usize,
        /// The column, which is the action.
        column: usize,
    },
}

/// Checks that a table read from outside has one finite number a pair.
///
/// # Errors
/// Names the row, and the column.
pub fn check_table(table: &[Vec<f64>], states: usize, actions: usize) -> Result<(), ValuesError> {
    if table.len() != states {
        return Err(ValuesError::Rows { expected: states, found: table.len() });
    }
    for (row, numbers) in table.iter().enumerate() {
        if numbers.len() != actions {
            return Err(ValuesError::Columns { row, expected: actions, found: numbers.len() });
        }
        if let Some(column) = numbers.iter().position(|number| !number.is_finite()) {
            return Err(ValuesError::NotFinite { row, column });
        }
    }
    Ok(())
}

impl ActionValues {
    /// One value everywhere, and which pairs are allowed (states × actions).
    ///
    /// # Panics
    /// When a state has no allowed action.
    #[must_use]
    pub fn new(actions: usize, allowed: Vec<bool>, value: f64) -> Self {
        assert!(
            allowed.chunks(actions).all(|row| row.contains(&true)),
            "every state needs an action that is allowed"
        );
        Self { actions, values: vec![value; allowed.len()], allowed }
    }

    /// The same table with other values, state by state.
    ///
    /// # Errors
    /// Names the row, and the column.
    pub fn with_values(mut self, table: &[Vec<f64>]) -> Result<Self, ValuesError> {
        check_table(table, self.states(), self.actions)?;
        self.values = table.concat();
        Ok(self)
    }

    /// Number of states.
    #[must_use]
    pub fn states(&self) -> usize {
        self.values.len() / self.actions
    }

    /// Number of actions.
    #[must_use]
    pub fn actions(&self) -> usize {
        self.actions
    }

    /// Q(x, ·).
    #[must_use]
    pub fn row(&self, state: usize) -> &[f64] {
        &self.values[state * self.actions..(state + 1) * self.actions]
    }

    /// Which actions are allowed in a state.
    #[must_use]
    pub fn allowed(&self, state: usize) -> &[bool] {
        &self.allowed[state * self.actions..(state + 1) * self.actions]
    }

    /// Q(x,u).
    #[must_use]
    pub fn get(&self, state: usize, action: usize) -> f64 {
        self.values[state * self.actions + action]
    }

    /// Changes Q(x,u).
    pub fn set(&mut self, state: usize, action: usize, value: f64) {
        self.values[state * self.actions + action] = value;
    }

    /// The allowed action of greatest value, the first of several, and that value.
    #[must_use]
    pub fn best(&self, state: usize) -> (usize, f64) {
        let mut best = (usize::MAX, f64::NEG_INFINITY);
        for (action, (value, allowed)) in
            self.row(state).iter().zip(self.allowed(state)).enumerate()
        {
            if *allowed && (*value > best.1 || best.0 == usize::MAX) {
                best = (action, *value);
            }
        }
        best
    }

    /// Eq. (3.23): V(x) = max_u Q(x,u)
    #[must_use]
    pub fn max(&self, state: usize) -> f64 {
        self.best(state).1
    }

    /// Eq. (3.19): the greedy action of every state.
    #[must_use]
    pub fn greedy(&self) -> Vec<usize> {
        (0..self.states()).map(|state| self.best(state).0).collect()
    }

    /// All rows, for saving.
    #[must_use]
    pub fn rows(&self) -> Vec<Vec<f64>> {
        self.values.chunks(self.actions).map(<[f64]>::to_vec).collect()
    }
}
