//! Modularisation, section 4.3: gated behaviours (figure 4.1).
//!
//! The gate is wired by hand: it says which behaviour acts in which state. Each behaviour has a small
//! table of its own over what matters to it, and is rewarded when the gate hands on to a later behaviour.

use rand_chacha::ChaCha8Rng;
use serde::{Deserialize, Serialize};

use super::{ActionValues, Experience, Learner, LearnerRule, Transport, Update};

/// Which behaviour acts in which state, and what it sees of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Gate {
    /// Names of the behaviours, in the order of progress.
    pub names: Vec<String>,
    /// Behaviour of each state.
    pub behaviour: Vec<usize>,
    /// What the behaviour sees of each state, from 0.
    pub seen: Vec<usize>,
}

impl Gate {
    /// How many things a behaviour can see.
    #[must_use]
    pub fn size(&self, behaviour: usize) -> usize {
        let seen = self.behaviour.iter().zip(&self.seen);
        seen.filter(|(of, _)| **of == behaviour).map(|(_, seen)| seen + 1).max().unwrap_or(0)
    }

    /// Pairs of what is seen and what can be done, over all behaviours: the search space that is left.
    #[must_use]
    pub fn hypotheses(&self, actions: usize) -> usize {
        let seen: std::collections::BTreeSet<(&usize, &usize)> =
            self.behaviour.iter().zip(&self.seen).collect();
        seen.len() * actions
    }
}

/// Q-learning in every behaviour of a gate.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Gated {
    gate: Gate,
    tables: Vec<ActionValues>,
    /// What the acting behaviour saw when it began; none between behaviours.
    entry: Option<(usize, usize)>,
    rate: f64,
    discount: f64,
    restarts: bool,
}

impl Gated {
    /// Behaviours whose tables all hold one value.
    #[must_use]
    pub fn new(rule: &LearnerRule, actions: usize, gate: Gate, value: f64) -> Self {
        let tables = (0..gate.names.len())
            .map(|behaviour| {
                let pairs = gate.size(behaviour).max(1) * actions;
                ActionValues::new(actions, vec![true; pairs], value)
            })
            .collect();
        Self {
            gate,
            tables,
            entry: None,
            rate: rule.rate,
            discount: rule.discount,
            restarts: rule.transport != Transport::Terminal,
        }
    }

    /// The gate.
    #[must_use]
    pub fn gate(&self) -> &Gate {
        &self.gate
    }

    /// The table of each behaviour.
    #[must_use]
    pub fn tables(&self) -> &[ActionValues] {
        &self.tables
    }

    fn place(&self, state: usize) -> (usize, usize) {
        (self.gate.behaviour[state], self.gate.seen[state])
    }
}

impl Learner for Gated {
    fn preferences(&self, state: usize) -> &[f64] {
        let (behaviour, seen) = self.place(state);
        self.tables[behaviour].row(seen)
    }

    fn value(&self, state: usize) -> f64 {
        let (behaviour, seen) = self.place(state);
        self.tables[behaviour].max(seen)
    }

    fn begin_trial(&mut self) {
        self.entry = None;
    }

    /// A behaviour's own reward is 1 when it hands on to a later one or ends the trial, and 0 otherwise.
    /// Where the agent is transported back at the goal, a behaviour is transported back to its entry.
    fn learn(&mut self, experience: &Experience, _: &mut ChaCha8Rng) -> Update {
        let (behaviour, seen) = self.place(experience.state);
        let (_, entry) = *self.entry.get_or_insert((behaviour, seen));
        let (next_behaviour, next_seen) = self.place(experience.next);
        let stays = next_behaviour == behaviour && !experience.ended;
        let done = experience.ended || next_behaviour > behaviour;
        let table = &mut self.tables[behaviour];
        let ahead = match (stays, self.restarts) {
            (true, _) => table.max(next_seen),
            (false, true) => table.max(entry),
            (false, false) => 0.0,
        };
        let before = table.get(seen, experience.action);
        let reward = f64::from(u8::from(done));
        // Eq. (4.10), within the behaviour
        let delta = reward + self.discount * ahead - before;
        let after = before + self.rate * delta;
        table.set(seen, experience.action, after);
        if !stays {
            self.entry = None;
        }
        let (discount, rate) = (self.discount, self.rate);
        Update { reward, ahead, discount, rate, delta, before, after, planned: 0 }
    }
}
