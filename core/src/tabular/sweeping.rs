//! Prioritised sweeping: planning goes first where values have just changed, Eq. (3.24).

use std::collections::{BTreeMap, BTreeSet};

use rand_chacha::ChaCha8Rng;
use serde::{Deserialize, Serialize};

use super::{ActionValues, Backup, Experience, Learner, LearnerRule, Model, Update};

/// A learner whose every backup is a whole expectation over a learned model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sweeping {
    table: ActionValues,
    model: Model,
    queue: Queue,
    discount: f64,
    planning: u32,
    cap: f64,
    least: f64,
    planned: Vec<Backup>,
}

/// States by priority, the greatest first; of equals the first state.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
struct Queue {
    order: BTreeSet<(u64, usize)>,
    priorities: BTreeMap<usize, f64>,
}

impl Queue {
    /// Positive numbers keep their order in their bits; turned round, the greatest comes first.
    fn key(priority: f64, state: usize) -> (u64, usize) {
        (!priority.to_bits(), state)
    }

    fn promote(&mut self, state: usize, priority: f64) {
        let before = self.priorities.get(&state).copied();
        if before.is_some_and(|before| before >= priority) {
            return;
        }
        if let Some(before) = before {
            self.order.remove(&Self::key(before, state));
        }
        self.order.insert(Self::key(priority, state));
        self.priorities.insert(state, priority);
    }

    fn pop(&mut self) -> Option<usize> {
        let (_, state) = self.order.pop_first()?;
        self.priorities.remove(&state);
        Some(state)
    }
}

impl Sweeping {
    /// A learner that starts from a table and knows nothing of the world.
    #[must_use]
    pub fn new(rule: &LearnerRule, table: ActionValues) -> Self {
        let model = Model::new(rule.model, table.states(), table.actions());
        Self {
            table,
            model,
            queue: Queue::default(),
            discount: rule.discount,
            planning: rule.planning,
            cap: rule.priority_cap,
            least: rule.priority_least,
            planned: Vec::new(),
        }
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

    /// The learned model.
    #[must_use]
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// The backups of the last planning.
    #[must_use]
    pub fn planned(&self) -> &[Backup] {
        &self.planned
    }

    /// The states that wait, most urgent first, with their priorities.
    #[must_use]
    pub fn queue(&self) -> Vec<(usize, f64)> {
        self.queue.order.iter().map(|&(_, state)| (state, self.queue.priorities[&state])).collect()
    }

    /// Algorithm 4's backup of one pair, over the learned model.
    fn backup(&mut self, state: usize, action: usize) -> Backup {
        let before = self.table.get(state, action);
        // Q(x,u) = Σ_r r P_xu(r) + γ Σ_y V(y) P_xu(y)
        let table = &self.table;
        let after = self.model.expected(state, action, self.discount, |ahead| table.max(ahead));
        self.table.set(state, action, after);
        Backup { state, action, before, after }
    }

    /// Promotes the predecessors of a state whose value changed by Δ.
    ///
    /// NOTE: Eq. (3.24) speaks of the predecessors only; the change of the first state, which experience
    /// itself makes, starts the sweep.
    fn promote(&mut self, state: usize, change: f64) {
        for &(before, action) in self.model.before(state) {
            // Eq. (3.24): P_x̀ = max_u p_x̀u(x) · Δ, but at most Δ_max
            let priority = (self.model.chance(before, action, state) * change).min(self.cap);
            if priority > self.least {
                self.queue.promote(before, priority);
            }
        }
    }

    fn plan(&mut self) {
        self.planned.clear();
        for _ in 0..self.planning {
            let Some(state) = self.queue.pop() else { return };
            let value = self.table.max(state);
            for action in 0..self.table.actions() {
                if !self.model.seen(state, action).is_empty() {
                    let backup = self.backup(state, action);
                    self.planned.push(backup);
                }
            }
            let change = (self.table.max(state) - value).abs();
            self.promote(state, change);
        }
    }
}

impl Learner for Sweeping {
    fn preferences(&self, state: usize) -> &[f64] {
        self.table.row(state)
    }

    fn value(&self, state: usize) -> f64 {
        self.table.max(state)
    }

    fn begin_trial(&mut self) {}

    #[expect(clippy::cast_possible_truncation, reason = "a backlog is far below 2^32")]
    fn learn(&mut self, experience: &Experience, _: &mut ChaCha8Rng) -> Update {
        let Experience { state, action, reward, ahead, .. } = *experience;
        self.model.learn(experience);
        let value = self.table.max(state);
        let ahead = ahead.map_or(0.0, |state| self.table.max(state));
        let Backup { before, after, .. } = self.backup(state, action);
        let change = (self.table.max(state) - value).abs();
        self.promote(state, change);
        self.plan();
        Update {
            reward,
            ahead,
            discount: self.discount,
            rate: 1.0,
            delta: reward + self.discount * ahead - before,
            before,
            after,
            planned: self.planned.len() as u32,
        }
    }
}
