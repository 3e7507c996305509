//! Q-learning with softmax on a small deterministic world, packed for thousands of runs.
//!
//! It computes what [`super::QLearning`] and [`super::Selection`] compute, in the same order and to the
//! same bits; a test holds them together. The one difference: the chances of a state are computed when
//! one of its values changes, not when the state is met, so that the processor works on them while it
//! already walks on.

use rand::Rng;

use super::{Exponential, Transport, unit};

/// A world of `S` states (a power of two, at most 256) and `A` actions whose transitions are certain.
#[derive(Clone, Debug, PartialEq)]
pub struct Compact<const S: usize, const A: usize> {
    /// State that an action leads to.
    pub next: [[u8; A]; S],
    /// Reward on the way.
    pub reward: [[f64; A]; S],
    /// The trial ends with this transition.
    pub ends: [[bool; A]; S],
}

/// What one trial is run with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CompactRule {
    /// Learning rate β.
    pub rate: f64,
    /// Discount γ.
    pub discount: f64,
    /// Temperature τ, above 0.
    pub temperature: f64,
    /// What is learned at the end of a trial.
    pub transport: Transport,
    /// State every trial starts in.
    pub start: u8,
    /// Steps after which a trial is broken off.
    pub cap: u32,
}

/// Q-values with the chances they give.
#[derive(Clone, Debug, PartialEq)]
pub struct CompactTable<const S: usize, const A: usize> {
    /// Q(x,u); minus infinity for what is excluded.
    open: [[f64; A]; S],
    /// Values of what is excluded: they never change and count nowhere.
    excluded: [[f64; A]; S],
    /// Factor of each action's chance; 0 excludes it.
    weights: [[f64; A]; S],
    /// e^{Q(x,u)/τ}, times the weight.
    chances: [[Exponential; A]; S],
    /// Running sums of the chances, in units of the greatest power of two.
    sums: [[f64; A]; S],
    /// 1/τ of the sums; not a number while they are not computed.
    inverse: f64,
}

impl<const S: usize, const A: usize> CompactTable<S, A> {
    /// A table with its first values and weights.
    #[must_use]
    pub fn new(values: [[f64; A]; S], weights: [[f64; A]; S]) -> Self {
        const { assert!(S.is_power_of_two() && S <= 256, "states are found by masking a byte") };
        let mut open = values;
        for (open, weights) in open.iter_mut().zip(&weights) {
            for (value, weight) in open.iter_mut().zip(weights) {
                *value = if *weight > 0.0 { *value } else { f64::NEG_INFINITY };
            }
        }
        Self {
            open,
            excluded: values,
            weights,
            chances: [[Exponential::NOTHING; A]; S],
            sums: [[0.0; A]; S],
            inverse: f64::NAN,
        }
    }

    /// The Q-values.
    #[must_use]
    pub fn values(&self) -> [[f64; A]; S] {
        let mut values = self.excluded;
        for (state, open) in self.open.iter().enumerate() {
            for (action, value) in open.iter().enumerate().filter(|(_, value)| value.is_finite()) {
                values[state][action] = *value;
            }
        }
        values
    }

    /// One trial; the actions it took, and whether it ended by itself.
    pub fn trial(
        &mut self,
        world: &Compact<S, A>,
        rule: &CompactRule,
        rng: &mut impl Rng,
    ) -> (u32, bool) {
        self.cool(1.0 / rule.temperature);
        let start = usize::from(rule.start) & (S - 1);
        let mut state = start;
        for step in 1..=rule.cap {
            let action = self.choose(state, unit(rng));
            let next = usize::from(world.next[state][action]) & (S - 1);
            let ends = world.ends[state][action];
            let ahead = match (ends, rule.transport) {
                (false, _) | (true, Transport::GoalState) => self.best(next),
                (true, Transport::Terminal) => 0.0,
                (true, Transport::StartState) => self.best(start),
            };
            // Eq. (4.10): Q(x,u) ← Q(x,u) + β (r + γ max_u Q(y,u) − Q(x,u))
            let value = self.open[state][action];
            let delta = world.reward[state][action] + rule.discount * ahead - value;
            self.open[state][action] = value + rule.rate * delta;
            self.weigh(state, action);
            self.add_up(state);
            if ends {
                return (step, true);
            }
            state = next;
        }
        (rule.cap, false)
    }

    #[inline(always)]
    fn choose(&self, state: usize, unit: f64) -> usize {
        let sums = &self.sums[state];
        let mark = unit * sums[A - 1];
        sums[..A - 1].iter().map(|sum| usize::from(mark >= *sum)).sum()
    }

    /// Greatest value of the actions that are not excluded.
    #[inline(always)]
    fn best(&self, state: usize) -> f64 {
        self.open[state].iter().fold(f64::NEG_INFINITY, |best, v| if *v > best { *v } else { best })
    }

    /// Brings all chances to another temperature.
    fn cool(&mut self, inverse: f64) {
        if self.inverse.to_bits() == inverse.to_bits() {
            return;
        }
        self.inverse = inverse;
        for state in 0..S {
            for action in 0..A {
                if self.weights[state][action] > 0.0 {
                    self.weigh(state, action);
                }
            }
            self.add_up(state);
        }
    }

    #[inline(always)]
    fn weigh(&mut self, state: usize, action: usize) {
        let chance = Exponential::of(self.open[state][action] * self.inverse);
        let mantissa = self.weights[state][action] * chance.mantissa;
        self.chances[state][action] = Exponential { mantissa, ..chance };
    }

    #[inline(always)]
    fn add_up(&mut self, state: usize) {
        let chances = &self.chances[state];
        let greatest =
            chances.iter().fold(i64::MIN, |most, c| if c.power > most { c.power } else { most });
        let mut sum = 0.0;
        for (total, chance) in self.sums[state].iter_mut().zip(chances) {
            sum += chance.beside(greatest);
            *total = sum;
        }
    }
}
