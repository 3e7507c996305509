//! Dyna, Algorithm 7: learning from the world, and planning on a learned model of it.

use rand_chacha::ChaCha8Rng;
use serde::{Deserialize, Serialize};

use super::{ActionValues, Backup, Experience, Learner, LearnerRule, Model, QLearning, Update};

/// Q-learning that repeats what it remembers.
///
/// NOTE: Algorithm 7 is written with a critic and an actor, AHC(x) and RL(x); here one table Q takes the
/// place of both, as section 3.6 says it may ("unified into a single Q-function").
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Dyna {
    learner: QLearning,
    model: Model,
    planning: u32,
    planned: Vec<Backup>,
}

impl Dyna {
    /// A learner that starts from a table and knows nothing of the world.
    #[must_use]
    pub fn new(rule: &LearnerRule, table: ActionValues) -> Self {
        let model = Model::new(rule.model, table.states(), table.actions());
        let learner = QLearning::new(rule, table);
        Self { learner, model, planning: rule.planning, planned: Vec::new() }
    }

    /// Q(x,u).
    #[must_use]
    pub fn table(&self) -> &ActionValues {
        self.learner.table()
    }

    /// Q(x,u), to be edited.
    pub fn table_mut(&mut self) -> &mut ActionValues {
        self.learner.table_mut()
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

    fn plan(&mut self, rng: &mut ChaCha8Rng) {
        self.planned.clear();
        for _ in 0..self.planning {
            let Some((state, action)) = self.model.pick(rng) else { return };
            let seen = self.model.sample(state, action, rng);
            let update = self.learner.backup(state, action, seen.reward, seen.ahead);
            let Update { before, after, .. } = update;
            self.planned.push(Backup { state, action, before, after });
        }
    }
}

impl Learner for Dyna {
    fn preferences(&self, state: usize) -> &[f64] {
        self.learner.preferences(state)
    }

    fn value(&self, state: usize) -> f64 {
        self.learner.value(state)
    }

    fn begin_trial(&mut self) {}

    fn learn(&mut self, experience: &Experience, rng: &mut ChaCha8Rng) -> Update {
        let update = self.learner.learn(experience, rng);
        self.model.learn(experience);
        self.plan(rng);
        Update { planned: self.planning, ..update }
    }
}
