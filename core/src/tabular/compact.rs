//! Q-learning with softmax on a small deterministic world, packed for thousands of runs.
//!
//! It computes what [`super::QLearning`] and [`super::Selection`] compute, in the same order and to the
//! same bits; tests hold them together. Three things make it fast. The chances of a state are computed when
//! one of its values changes, not when the state is met, so that the processor works on them while it
//! already walks on. They are kept as plain numbers in units of one power of two for the whole table, as long
//! as they are near enough to it that nothing is lost: then only the changed one has to be computed, and
//! which action a number falls on does not depend on the unit. And random numbers are drawn some at a time.

use rand::Rng;

use super::exponential::power_of_two;
use super::{Exponential, Transport, unit_of};

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

/// Powers of two on either side of the origin within which chances are plain numbers.
const PLAIN: i64 = 480;
/// Least weight with which a chance is a plain number.
const LEAST_WEIGHT: f64 = 1e-18;

/// Q-values with the chances they give.
#[derive(Clone, Debug, PartialEq)]
pub struct CompactTable<const S: usize, const A: usize> {
    rows: [Row<A>; S],
    /// Values of what is excluded: they never change and count nowhere.
    excluded: [[f64; A]; S],
    scale: Scale,
}

/// What turns values into chances.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Scale {
    /// 1/τ; not a number while nothing is computed.
    inverse: f64,
    /// Power of two that is the unit of all plain chances.
    origin: i64,
}

/// Numbers drawn at a time: a block of the generator's.
const BATCH: usize = 32;

/// The numbers that [`super::unit`] draws, some at a time; what is drawn and not used is lost to others.
#[derive(Clone, Debug)]
pub struct Units<R> {
    rng: R,
    drawn: [f64; BATCH],
    used: usize,
}

impl<R: Rng> Units<R> {
    /// Numbers from a generator.
    #[must_use]
    pub fn new(rng: R) -> Self {
        Self { rng, drawn: [0.0; BATCH], used: BATCH }
    }

    /// A number from 0 (in) to 1 (out), in steps of 2⁻⁵³.
    #[inline(always)]
    pub fn draw(&mut self) -> f64 {
        if self.used >= BATCH {
            self.refill();
        }
        let unit = self.drawn[self.used];
        self.used += 1;
        unit
    }
    #[cold]
    #[inline(never)]
    fn refill(&mut self) {
        let mut bytes = [0; 8 * BATCH];
        self.rng.fill_bytes(&mut bytes);
        for (unit, word) in self.drawn.iter_mut().zip(bytes.as_chunks().0) {
            *unit = unit_of(u64::from_le_bytes(*word));
        }
        self.used = 0;
    }
}

/// What belongs to one state, side by side.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
struct Row<const A: usize> {
    /// Q(x,u); minus infinity for what is excluded.
    open: [f64; A],
    /// e^{Q(x,u)/τ}, times the weight, in units of 2^origin; of no meaning in a wild row.
    chances: [f64; A],
    /// Running sums of the chances, in some power of two.
    sums: [f64; A],
    /// Factor of each action's chance; 0 excludes it.
    weights: [f64; A],
    /// Some chance is too far from the origin to be a plain number.
    wild: bool,
}

impl<const S: usize, const A: usize> CompactTable<S, A> {
    /// A table with its first values and weights.
    #[must_use]
    pub fn new(values: [[f64; A]; S], weights: [[f64; A]; S]) -> Self {
        const { assert!(S.is_power_of_two() && S <= 256, "states are found by masking a byte") };
        let row = |state: usize| Row {
            open: std::array::from_fn(|action| {
                if weights[state][action] > 0.0 { values[state][action] } else { f64::NEG_INFINITY }
            }),
            chances: [0.0; A],
            sums: [0.0; A],
            weights: weights[state],
            wild: false,
        };
        let scale = Scale { inverse: f64::NAN, origin: 0 };
        Self { rows: std::array::from_fn(row), excluded: values, scale }
    }

    /// The Q-values.
    #[must_use]
    pub fn values(&self) -> [[f64; A]; S] {
        let mut values = self.excluded;
        for (state, row) in self.rows.iter().enumerate() {
            for (action, value) in
                row.open.iter().enumerate().filter(|(_, value)| value.is_finite())
            {
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
        units: &mut Units<impl Rng>,
    ) -> (u32, bool) {
        let start = usize::from(rule.start) & (S - 1);
        self.cool(1.0 / rule.temperature, start);
        let scale = self.scale;
        let mut state = start;
        for step in 1..=rule.cap {
            let action = self.rows[state].choose(units.draw());
            let next = usize::from(world.next[state][action]) & (S - 1);
            let ends = world.ends[state][action];
            let ahead = match (ends, rule.transport) {
                (false, _) | (true, Transport::GoalState) => self.rows[next].best(),
                (true, Transport::Terminal) => 0.0,
                (true, Transport::StartState) => self.rows[start].best(),
            };
            let row = &mut self.rows[state];
            // Eq. (4.10): Q(x,u) ← Q(x,u) + β (r + γ max_u Q(y,u) − Q(x,u))
            let value = row.open[action];
            let delta = world.reward[state][action] + rule.discount * ahead - value;
            row.open[action] = value + rule.rate * delta;
            row.weigh(action, scale);
            if ends {
                return (step, true);
            }
            state = next;
        }
        (rule.cap, false)
    }

    /// Brings all chances to another temperature, or to another origin when the values have moved away from
    /// theirs.
    fn cool(&mut self, inverse: f64, start: usize) {
        let power = Exponential::of(self.rows[start].best() * inverse).power;
        let near = (power - self.scale.origin).abs() < PLAIN / 2;
        if near && self.scale.inverse.to_bits() == inverse.to_bits() {
            return;
        }
        self.scale = Scale { inverse, origin: power };
        let scale = self.scale;
        for state in 0..S {
            // A learner begins with many rows alike.
            let like_last = state > 0 && self.rows[state].is_like(&self.rows[state - 1]);
            if like_last {
                self.rows[state] = self.rows[state - 1];
            } else {
                self.rows[state].weigh_all(scale);
            }
        }
    }
}

impl<const A: usize> Row<A> {
    #[inline(always)]
    fn choose(&self, unit: f64) -> usize {
        let mark = unit * self.sums[A - 1];
        self.sums[..A - 1].iter().map(|sum| usize::from(mark >= *sum)).sum()
    }

    /// Whether another row gives the same chances.
    fn is_like(&self, other: &Self) -> bool {
        let alike = |a: &[f64; A], b: &[f64; A]| a.map(f64::to_bits) == b.map(f64::to_bits);
        alike(&self.open, &other.open) && alike(&self.weights, &other.weights)
    }

    /// Greatest value of the actions that are not excluded.
    #[inline(always)]
    fn best(&self) -> f64 {
        self.open[1..].iter().fold(self.open[0], |best, v| if *v > best { *v } else { best })
    }

    /// Brings an action's chance up to date, and the sums with it.
    #[inline(always)]
    fn weigh(&mut self, action: usize, scale: Scale) {
        let chance = Exponential::within(self.open[action] * scale.inverse);
        let power = chance.power.wrapping_sub(scale.origin);
        if self.wild || !(-PLAIN..=PLAIN).contains(&power) {
            self.weigh_all(scale);
            return;
        }
        // The weight times a power of two is exact, so it may come first, while the mantissa is not there yet.
        self.chances[action] = chance.mantissa * (self.weights[action] * power_of_two(power));
        self.add_up();
    }

    #[inline(always)]
    fn add_up(&mut self) {
        let mut sum = self.chances[0];
        self.sums[0] = sum;
        for (total, chance) in self.sums[1..].iter_mut().zip(&self.chances[1..]) {
            sum += chance;
            *total = sum;
        }
    }

    /// The same from the values of all actions, however great or small.
    #[cold]
    #[inline(never)]
    fn weigh_all(&mut self, scale: Scale) {
        let of = |action: usize| {
            if self.weights[action] > 0.0 {
                let chance = Exponential::of(self.open[action] * scale.inverse);
                Exponential { mantissa: self.weights[action] * chance.mantissa, ..chance }
            } else {
                Exponential::NOTHING
            }
        };
        let chances: [Exponential; A] = std::array::from_fn(of);
        let tame = |action: usize| {
            let (weight, power) = (self.weights[action], chances[action].power);
            weight <= 0.0 || (weight >= LEAST_WEIGHT && (power - scale.origin).abs() <= PLAIN)
        };
        self.wild = !(0..A).all(tame);
        let unit = if self.wild {
            chances.iter().fold(i64::MIN, |most, c| if c.power > most { c.power } else { most })
        } else {
            scale.origin
        };
        for (chance, exponential) in self.chances.iter_mut().zip(&chances) {
            *chance = exponential.beside(unit);
        }
        self.add_up();
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::{Selection, choose, unit};
    use super::*;
    use crate::rng::{Purpose, stream};

    #[test]
    fn units_are_those_that_are_drawn_one_by_one() {
        let rng = || stream(3, 1, Purpose::Selection);
        let (mut one, mut some) = (rng(), Units::new(rng()));
        for at in 0..3 * BATCH {
            assert_eq!(unit(&mut one).to_bits(), some.draw().to_bits(), "number {at}");
        }
    }

    /// Whether a row chooses what the explained selection chooses, at the edges of its sums too.
    fn chooses_alike(row: &Row<3>, temperature: f64) -> Result<(), TestCaseError> {
        let mut sums = Vec::new();
        let rule = Selection::Softmax { temperature };
        rule.sums(&row.open, &row.weights, &[0.0; 3], &mut sums);
        const STEP: f64 = f64::EPSILON / 2.0;
        let edges = sums.iter().map(|sum| libm::floor(sum / sums[2] / STEP) * STEP);
        let around = edges.flat_map(|at| [at - STEP, at, at + STEP]);
        for at in around.chain([0.1, 0.5, 0.9]).filter(|at| (0.0..1.0).contains(at)) {
            prop_assert_eq!(row.choose(at), choose(&sums, at), "{:?} at {}", row, at);
        }
        Ok(())
    }

    proptest! {
        #[test]
        fn a_row_chooses_as_the_explained_selection_does(
            values in prop::array::uniform2(prop::array::uniform3(-50.0..50.0f64)),
            weights in prop::array::uniform3(prop::sample::select(vec![0.0, 1e-30, 1e-12, 0.5, 1.0])),
            changes in prop::collection::vec((0..3usize, -1e3..1e3f64), 0..8),
            stretch in prop::sample::select(vec![1.0, 1e3, 1e9, 1e15]),
            temperature in 0.001..100.0f64,
        ) {
            let weights = if weights.iter().all(|weight| *weight <= 0.0) { [1.0; 3] } else { weights };
            let stretched = values.map(|row| row.map(|value| value * stretch));
            let mut table = CompactTable::new(stretched, [weights; 2]);
            table.cool(1.0 / temperature, 0);
            for row in &table.rows {
                chooses_alike(row, temperature)?;
            }
            for (action, value) in changes {
                if weights[action] > 0.0 {
                    table.rows[1].open[action] = value;
                    table.rows[1].weigh(action, table.scale);
                    chooses_alike(&table.rows[1], temperature)?;
                }
            }
        }
    }
}
