//! A model of the world, learned from experience: what an action was seen to lead to.

use std::collections::BTreeSet;

use rand::Rng;
use serde::{Deserialize, Serialize};

use super::{Experience, ModelKind, unit};

/// One thing that an action was seen to lead to.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Seen {
    /// State whose value follows; none where the trial ended for good.
    pub ahead: Option<usize>,
    /// How often.
    pub count: u32,
    /// Mean reward.
    pub reward: f64,
}

/// Estimates of P_xu(y) and of the rewards, with the predecessors of every state.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Model {
    actions: usize,
    counting: bool,
    /// What each pair was seen to lead to.
    seen: Vec<Vec<Seen>>,
    /// Pairs tried, in the order of their first trial.
    tried: Vec<(usize, usize)>,
    /// Pairs from which a state was reached.
    before: Vec<BTreeSet<(usize, usize)>>,
}

impl Model {
    /// A model of nothing.
    #[must_use]
    pub fn new(kind: ModelKind, states: usize, actions: usize) -> Self {
        Self {
            actions,
            counting: kind == ModelKind::Counts,
            seen: vec![Vec::new(); states * actions],
            tried: Vec::new(),
            before: vec![BTreeSet::new(); states],
        }
    }

    /// Adapts the model to one experience.
    pub fn learn(&mut self, experience: &Experience) {
        let Experience { state, action, reward, ahead, .. } = *experience;
        let seen = &mut self.seen[state * self.actions + action];
        if seen.is_empty() {
            self.tried.push((state, action));
        }
        if !self.counting {
            for ahead in seen.drain(..).filter_map(|seen| seen.ahead) {
                self.before[ahead].remove(&(state, action));
            }
        }
        match seen.iter_mut().find(|seen| seen.ahead == ahead) {
            Some(seen) => {
                seen.count += 1;
                seen.reward += (reward - seen.reward) / f64::from(seen.count);
            }
            None => seen.push(Seen { ahead, count: 1, reward }),
        }
        if let Some(ahead) = ahead {
            self.before[ahead].insert((state, action));
        }
    }

    /// What a pair was seen to lead to.
    #[must_use]
    pub fn seen(&self, state: usize, action: usize) -> &[Seen] {
        &self.seen[state * self.actions + action]
    }

    /// Pairs tried, in the order of their first trial.
    #[must_use]
    pub fn tried(&self) -> &[(usize, usize)] {
        &self.tried
    }

    /// Pairs from which a state was reached.
    #[must_use]
    pub fn before(&self, state: usize) -> &BTreeSet<(usize, usize)> {
        &self.before[state]
    }

    /// Estimated chance that a pair leads to a state.
    #[must_use]
    pub fn chance(&self, state: usize, action: usize, ahead: usize) -> f64 {
        let seen = self.seen(state, action);
        let total: u32 = seen.iter().map(|seen| seen.count).sum();
        let count: u32 =
            seen.iter().filter(|seen| seen.ahead == Some(ahead)).map(|seen| seen.count).sum();
        if total == 0 { 0.0 } else { f64::from(count) / f64::from(total) }
    }

    /// A pair that was tried, each as likely; none before the first experience.
    pub fn pick(&self, rng: &mut impl Rng) -> Option<(usize, usize)> {
        #[expect(
            clippy::cast_precision_loss,
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "there are far fewer pairs than 2^53, and the product is below their number"
        )]
        let at = (unit(rng) * self.tried.len() as f64) as usize;
        self.tried.get(at).copied()
    }

    /// Draws what a tried pair leads to.
    pub fn sample(&self, state: usize, action: usize, rng: &mut impl Rng) -> Seen {
        let seen = self.seen(state, action);
        if let [only] = seen {
            return *only;
        }
        let total: u32 = seen.iter().map(|seen| seen.count).sum();
        let mut left = unit(rng) * f64::from(total);
        let mut drawn = seen[0];
        for outcome in seen {
            drawn = *outcome;
            left -= f64::from(outcome.count);
            if left < 0.0 {
                break;
            }
        }
        drawn
    }

    /// Expectation of r + γ V over what a tried pair was seen to lead to.
    pub fn expected(
        &self,
        state: usize,
        action: usize,
        discount: f64,
        value: impl Fn(usize) -> f64,
    ) -> f64 {
        let seen = self.seen(state, action);
        let total: u32 = seen.iter().map(|seen| seen.count).sum();
        let sum: f64 = seen
            .iter()
            .map(|seen| {
                f64::from(seen.count) * (seen.reward + discount * seen.ahead.map_or(0.0, &value))
            })
            .sum();
        sum / f64::from(total)
    }
}
