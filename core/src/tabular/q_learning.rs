//! Q-learning, Algorithm 6.

use rand_chacha::ChaCha8Rng;
use serde::{Deserialize, Serialize};

use super::{ActionValues, Experience, Learner, LearnerRule, Update};

/// The learner of Algorithm 6.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct QLearning {
    table: ActionValues,
    rate: f64,
    discount: f64,
}

impl QLearning {
    /// A learner that starts from a table.
    #[must_use]
    pub fn new(rule: &LearnerRule, table: ActionValues) -> Self {
        Self { table, rate: rule.rate, discount: rule.discount }
    }

    /// Q(x,u).
    #[must_use]
    pub fn table(&self) -> &ActionValues {
        &self.table
    }

    /// Q(x,u), to be edited.
    pub fn table_mut(&mut self) -> &mut ActionValues {
        &mut self.table
    }

    /// One sample backup, of a real or a planned experience.
    pub(super) fn backup(
        &mut self,
        state: usize,
        action: usize,
        reward: f64,
        ahead: Option<usize>,
    ) -> Update {
        let ahead = ahead.map_or(0.0, |state| self.table.max(state));
        let before = self.table.get(state, action);
        // Eq. (4.10): Q(x,u) ← Q(x,u) + β (r + γ max_u Q(y,u) − Q(x,u))
        let delta = reward + self.discount * ahead - before;
        let after = before + self.rate * delta;
        self.table.set(state, action, after);
        let (discount, rate) = (self.discount, self.rate);
        Update { reward, ahead, discount, rate, delta, before, after, planned: 0 }
    }
}

impl Learner for QLearning {
    fn preferences(&self, state: usize) -> &[f64] {
        self.table.row(state)
    }

    fn value(&self, state: usize) -> f64 {
        self.table.max(state)
    }

    fn begin_trial(&mut self) {}

    fn learn(&mut self, experience: &Experience, _: &mut ChaCha8Rng) -> Update {
        let Experience { state, action, reward, ahead, .. } = *experience;
        self.backup(state, action, reward, ahead)
    }
}
