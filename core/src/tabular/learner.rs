//! What learners have in common, and the closed list of them.

use rand_chacha::ChaCha8Rng;
use serde::{Deserialize, Serialize};

use super::{ActionValues, Ahc, Dyna, Gate, Gated, MdpError, Model, QLearning, Sweeping};

/// An experience tuple ⟨x, u, y, r⟩ with what learning needs beside it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Experience {
    /// x.
    pub state: usize,
    /// u.
    pub action: usize,
    /// Chance with which u was chosen.
    pub chance: f64,
    /// r.
    pub reward: f64,
    /// y.
    pub next: usize,
    /// State whose value is looked ahead to: y, or at the end of a trial what [`Transport`] says.
    pub ahead: Option<usize>,
    /// The trial ended.
    pub ended: bool,
}

/// What one experience changed: the numbers of one update.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Update {
    /// r.
    pub reward: f64,
    /// Value looked ahead to: max Q(y,·), or V(y) for a critic; 0 at an end without transport.
    pub ahead: f64,
    /// Discount γ.
    pub discount: f64,
    /// Learning rate β (α for a critic); 1 where a whole backup takes its place.
    pub rate: f64,
    /// Temporal difference: r + γ · ahead − before.
    pub delta: f64,
    /// Q(x,u) before, or V(x) for a critic.
    pub before: f64,
    /// The same after.
    pub after: f64,
    /// Further backups made by planning.
    pub planned: u32,
}

/// A backup made while planning, for looking at.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Backup {
    /// x.
    pub state: usize,
    /// u.
    pub action: usize,
    /// Q(x,u) before.
    pub before: f64,
    /// The same after.
    pub after: f64,
}

crate::choice! {
    /// What is learned when the goal is reached ("transported back to the start state", section 4.4).
    pub enum Transport {
        Terminal = "terminal": "T1: r alone; the trial ends there",
        GoalState = "goal-state": "T2: r + γ max Q of the goal state, whose values nobody changes",
        StartState = "start-state": "T3: r + γ max Q of the start state, where the agent finds itself next",
    }
}

impl Transport {
    /// The state whose value is looked ahead to after a transition.
    #[must_use]
    pub fn ahead(self, next: usize, start: usize, ended: bool) -> Option<usize> {
        match (ended, self) {
            (false, _) | (true, Self::GoalState) => Some(next),
            (true, Self::Terminal) => None,
            (true, Self::StartState) => Some(start),
        }
    }
}

crate::choice! {
    /// Which learner.
    pub enum LearnerKind {
        Q = "q": "Q-learning, Algorithm 6",
        Ahc = "ahc": "adaptive heuristic critic: TD(λ) critic and actor, Algorithm 5",
        Dyna = "dyna": "Dyna: Q-learning, and planning on a learned model, Algorithm 7",
        Sweeping = "sweeping": "prioritised sweeping on a learned model, Eq. (3.24)",
    }
}

crate::choice! {
    /// What a learned model keeps of an action in a state.
    pub enum ModelKind {
        Last = "last": "the last outcome: right for deterministic worlds",
        Counts = "counts": "counts of all outcomes: right for stochastic worlds too",
    }
}

/// Parameters of a learner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LearnerRule {
    /// Which one.
    pub kind: LearnerKind,
    /// Learning rate: β of Q, α of the critic.
    pub rate: f64,
    /// Discount γ.
    pub discount: f64,
    /// Learning rate of the actor.
    pub actor_rate: f64,
    /// λ of the critic.
    pub lambda: f64,
    /// Planning steps n a real step.
    pub planning: u32,
    /// What the model keeps.
    pub model: ModelKind,
    /// Greatest priority Δ_max.
    pub priority_cap: f64,
    /// Priority at or below which nothing is queued.
    pub priority_least: f64,
    /// What is learned at the goal; the modules of a gate need it.
    pub transport: Transport,
}

impl Default for LearnerRule {
    fn default() -> Self {
        Self {
            kind: LearnerKind::Q,
            rate: 0.5,
            discount: 0.95,
            actor_rate: 0.5,
            lambda: 0.7,
            planning: 5,
            model: ModelKind::Counts,
            priority_cap: 1.0,
            priority_least: 1e-4,
            transport: Transport::Terminal,
        }
    }
}

/// A tabular learner.
pub trait Learner {
    /// What selection compares in a state: Q-values, or an actor's preferences.
    fn preferences(&self, state: usize) -> &[f64];
    /// V(x).
    fn value(&self, state: usize) -> f64;
    /// A trial begins: what belongs to one trial is forgotten.
    fn begin_trial(&mut self);
    /// Learns from one experience; `rng` is for planning.
    fn learn(&mut self, experience: &Experience, rng: &mut ChaCha8Rng) -> Update;
}

/// One of the learners. Plain data, so that a checkpoint holds it whole.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum AnyLearner {
    /// Q-learning.
    Q(QLearning),
    /// Adaptive heuristic critic.
    Ahc(Ahc),
    /// Dyna.
    Dyna(Dyna),
    /// Prioritised sweeping.
    Sweeping(Sweeping),
    /// Q-learning in modules behind a gate.
    Gated(Gated),
}

impl AnyLearner {
    /// A learner that starts from a table; for an actor these are its first preferences.
    #[must_use]
    pub fn new(rule: &LearnerRule, table: ActionValues) -> Self {
        match rule.kind {
            LearnerKind::Q => Self::Q(QLearning::new(rule, table)),
            LearnerKind::Ahc => Self::Ahc(Ahc::new(rule, table)),
            LearnerKind::Dyna => Self::Dyna(Dyna::new(rule, table)),
            LearnerKind::Sweeping => Self::Sweeping(Sweeping::new(rule, table)),
        }
    }

    /// Q-learning in the modules of a gate.
    #[must_use]
    pub fn gated(rule: &LearnerRule, actions: usize, gate: &Gate, value: f64) -> Self {
        Self::Gated(Gated::new(rule, actions, gate.clone(), value))
    }

    fn inner(&self) -> &dyn Learner {
        match self {
            Self::Q(learner) => learner,
            Self::Ahc(learner) => learner,
            Self::Dyna(learner) => learner,
            Self::Sweeping(learner) => learner,
            Self::Gated(learner) => learner,
        }
    }

    fn inner_mut(&mut self) -> &mut dyn Learner {
        match self {
            Self::Q(learner) => learner,
            Self::Ahc(learner) => learner,
            Self::Dyna(learner) => learner,
            Self::Sweeping(learner) => learner,
            Self::Gated(learner) => learner,
        }
    }

    /// The table that selection reads, if there is one for all states.
    #[must_use]
    pub fn table(&self) -> Option<&ActionValues> {
        match self {
            Self::Q(learner) => Some(learner.table()),
            Self::Ahc(learner) => Some(learner.actor()),
            Self::Dyna(learner) => Some(learner.table()),
            Self::Sweeping(learner) => Some(learner.table()),
            Self::Gated(_) => None,
        }
    }

    /// The same, to be edited.
    pub fn table_mut(&mut self) -> Option<&mut ActionValues> {
        match self {
            Self::Q(learner) => Some(learner.table_mut()),
            Self::Ahc(learner) => Some(learner.actor_mut()),
            Self::Dyna(learner) => Some(learner.table_mut()),
            Self::Sweeping(learner) => Some(learner.table_mut()),
            Self::Gated(_) => None,
        }
    }

    /// The learned model, where there is one.
    #[must_use]
    pub fn model(&self) -> Option<&Model> {
        match self {
            Self::Dyna(learner) => Some(learner.model()),
            Self::Sweeping(learner) => Some(learner.model()),
            Self::Q(_) | Self::Ahc(_) | Self::Gated(_) => None,
        }
    }

    /// The states that wait for a backup, most urgent first, with their priorities.
    #[must_use]
    pub fn queue(&self) -> Vec<(usize, f64)> {
        match self {
            Self::Sweeping(learner) => learner.queue(),
            _ => Vec::new(),
        }
    }

    /// The backups that planning made after the last experience.
    #[must_use]
    pub fn planned(&self) -> &[Backup] {
        match self {
            Self::Dyna(learner) => learner.planned(),
            Self::Sweeping(learner) => learner.planned(),
            _ => &[],
        }
    }

    /// The greedy policy, where it takes the first of several best actions.
    #[must_use]
    pub fn policy(&self, states: usize, possible: impl Fn(usize, usize) -> bool) -> Vec<usize> {
        (0..states)
            .map(|state| {
                let mut best = (0, f64::NEG_INFINITY);
                for (action, value) in self.preferences(state).iter().enumerate() {
                    if possible(state, action) && *value > best.1 {
                        best = (action, *value);
                    }
                }
                best.0
            })
            .collect()
    }
}

impl Learner for AnyLearner {
    fn preferences(&self, state: usize) -> &[f64] {
        self.inner().preferences(state)
    }

    fn value(&self, state: usize) -> f64 {
        self.inner().value(state)
    }

    fn begin_trial(&mut self) {
        self.inner_mut().begin_trial();
    }

    fn learn(&mut self, experience: &Experience, rng: &mut ChaCha8Rng) -> Update {
        self.inner_mut().learn(experience, rng)
    }
}

/// Parameters that no learner can use.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LearnerError {
    /// A parameter is out of range.
    #[error("`{name}` must be {expected}, not {found}")]
    Range {
        /// Its name.
        name: &'static str,
        /// What would be right.
        expected: &'static str,
        /// What was given.
        found: f64,
    },
    /// The discount and the world do not fit.
    #[error(transparent)]
    World(#[from] MdpError),
}

impl LearnerRule {
    /// Checks the parameters.
    ///
    /// # Errors
    /// Names the one that is out of range.
    pub fn check(&self) -> Result<(), LearnerError> {
        let share = "from 0 to 1";
        let above = "above 0";
        for (name, found, good, expected) in [
            ("rate", self.rate, (0.0..=1.0).contains(&self.rate), share),
            ("discount", self.discount, (0.0..=1.0).contains(&self.discount), share),
            ("lambda", self.lambda, (0.0..=1.0).contains(&self.lambda), share),
            ("actor_rate", self.actor_rate, self.actor_rate >= 0.0, "at least 0"),
            ("priority_cap", self.priority_cap, self.priority_cap > 0.0, above),
            ("priority_least", self.priority_least, self.priority_least > 0.0, above),
        ] {
            if !(good && found.is_finite()) {
                return Err(LearnerError::Range { name, expected, found });
            }
        }
        Ok(())
    }
}
