//! TD(λ): the critic of Algorithm 5, and the actor that it guides.

use rand_chacha::ChaCha8Rng;
use serde::{Deserialize, Serialize};

use super::{ActionValues, Experience, Learner, LearnerRule, Update};

/// Below this an eligibility is 0.
const FORGOTTEN: f64 = 1e-9;

/// Values of states learned by TD(λ) with accumulating traces.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Critic {
    values: Vec<f64>,
    /// States with some eligibility e(x), in the order of their last rise from 0.
    traces: Vec<(usize, f64)>,
    rate: f64,
    discount: f64,
    lambda: f64,
}

impl Critic {
    /// A critic that knows nothing: V and e are 0.
    #[must_use]
    pub fn new(rule: &LearnerRule, states: usize) -> Self {
        Self {
            values: vec![0.0; states],
            traces: Vec::new(),
            rate: rule.rate,
            discount: rule.discount,
            lambda: rule.lambda,
        }
    }

    /// V(x).
    #[must_use]
    pub fn value(&self, state: usize) -> f64 {
        self.values[state]
    }

    /// The states with some eligibility, and how much.
    #[must_use]
    pub fn traces(&self) -> &[(usize, f64)] {
        &self.traces
    }

    /// Forgets which states were visited.
    pub fn begin_trial(&mut self) {
        self.traces.clear();
    }

    /// Learns from the transition from `state` with reward r to a state that `ahead` stands for.
    pub fn learn(&mut self, state: usize, reward: f64, ahead: Option<usize>) -> Update {
        // Eq. (3.21): e(x) = γλ e(x), and 1 more for the current state
        for (_, trace) in &mut self.traces {
            *trace *= self.discount * self.lambda;
        }
        self.traces.retain(|(_, trace)| *trace > FORGOTTEN);
        match self.traces.iter_mut().find(|(visited, _)| *visited == state) {
            Some((_, trace)) => *trace += 1.0,
            None => self.traces.push((state, 1.0)),
        }
        let ahead = ahead.map_or(0.0, |state| self.values[state]);
        let before = self.values[state];
        // Eq. (3.22): V(z) = V(z) + α (r + γ V(y) − V(x)) e(z)
        // NOTE: Algorithm 5 writes the difference inside the loop over z, where V(x) itself changes; it
        // has to be computed once, before.
        let delta = reward + self.discount * ahead - before;
        for &(visited, trace) in &self.traces {
            self.values[visited] += self.rate * delta * trace;
        }
        let (rate, discount, after) = (self.rate, self.discount, self.values[state]);
        Update { reward, ahead, discount, rate, delta, before, after, planned: 0 }
    }
}

/// Adaptive heuristic critic: critic and actor learn at the same time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ahc {
    critic: Critic,
    actor: ActionValues,
    actor_rate: f64,
}

impl Ahc {
    /// A critic that knows nothing and an actor with first preferences.
    #[must_use]
    pub fn new(rule: &LearnerRule, actor: ActionValues) -> Self {
        let critic = Critic::new(rule, actor.states());
        Self { critic, actor, actor_rate: rule.actor_rate }
    }

    /// The critic.
    #[must_use]
    pub fn critic(&self) -> &Critic {
        &self.critic
    }

    /// The actor's preferences.
    #[must_use]
    pub fn actor(&self) -> &ActionValues {
        &self.actor
    }

    /// The actor's preferences, to be edited.
    pub fn actor_mut(&mut self) -> &mut ActionValues {
        &mut self.actor
    }
}

impl Learner for Ahc {
    fn preferences(&self, state: usize) -> &[f64] {
        self.actor.row(state)
    }

    fn value(&self, state: usize) -> f64 {
        self.critic.value(state)
    }

    fn begin_trial(&mut self) {
        self.critic.begin_trial();
    }

    /// NOTE: the thesis leaves the actor's rule open ("adjust the critic and the action networks using
    /// local learning algorithms"). Here the preference of the action taken moves by η δ (1 − p(u)), so
    /// that a choice that was nearly certain changes little.
    fn learn(&mut self, experience: &Experience, _: &mut ChaCha8Rng) -> Update {
        let Experience { state, action, chance, reward, ahead, .. } = *experience;
        let update = self.critic.learn(state, reward, ahead);
        let preference = self.actor.get(state, action);
        let moved = preference + self.actor_rate * update.delta * (1.0 - chance);
        self.actor.set(state, action, moved);
        update
    }
}
