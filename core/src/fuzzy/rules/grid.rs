//! The fast path of inference: at most two sets of each input are active, and next to each other.
//!
//! Where the sets of every input lie side by side, each falling exactly where the next rises, the
//! memberships of a value add up to 1, so the weighted mean of Algorithm 2 needs no division and is
//! an interpolation between the 2⁶ corners of the cell that the inputs lie in. Lanes are computed by
//! themselves, so no result depends on the instructions the compiler chooses.

use super::{Consequent, Input, MOST_INPUTS, MOST_OUTPUTS, Norms, Output, Rule};
use crate::fuzzy::Shape;
use crate::simd::{Level, dispatch};

/// Most sets of an input here.
const SETS: usize = 4;
/// Places between neighbouring sets.
const RAMPS: usize = SETS - 1;
/// Corners of a cell, two and two along the last input.
const PAIRS: usize = 1 << (MOST_INPUTS - 1);
/// Consequents of two neighbouring rules.
const PAIR: usize = 2 * MOST_OUTPUTS;

/// A table of consequents and where the inputs lie in it. Inputs that are missing have one set.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Grid {
    inputs: usize,
    least: [f64; MOST_INPUTS],
    most: [f64; MOST_INPUTS],
    /// Where membership begins to pass from a set to the next, and 1 / the way until it has.
    start: [[f64; MOST_INPUTS]; RAMPS],
    slope: [[f64; MOST_INPUTS]; RAMPS],
    /// Share of the way at which the next ramp counts: 1, or never.
    passed: [[f64; MOST_INPUTS]; RAMPS],
    /// Way from a set of an input to the next, in consequents.
    stride: [usize; MOST_INPUTS],
    /// Way from the first pair of a cell to each pair.
    offsets: [usize; PAIRS],
    consequents: Vec<f64>,
}

impl Grid {
    /// The table of a rule base; none where sets overlap in another way, the norms are not algebraic
    /// or consequents are sets.
    pub(super) fn new(
        norms: Norms,
        inputs: &[Input],
        outputs: &[Output],
        rules: &[Rule],
    ) -> Option<Self> {
        let numbers = outputs.iter().all(|output| output.sets.is_empty());
        if norms != Norms::Algebraic || !numbers {
            return None;
        }
        let mut grid = Self {
            inputs: inputs.len(),
            least: [0.0; MOST_INPUTS],
            most: [0.0; MOST_INPUTS],
            start: [[0.0; MOST_INPUTS]; RAMPS],
            slope: [[0.0; MOST_INPUTS]; RAMPS],
            passed: [[f64::INFINITY; MOST_INPUTS]; RAMPS],
            stride: [0; MOST_INPUTS],
            offsets: [0; PAIRS],
            consequents: consequents(rules),
        };
        // The last input comes last here too, since its pairs lie side by side.
        let first = MOST_INPUTS - inputs.len();
        let mut stride = MOST_OUTPUTS;
        for (index, input) in inputs.iter().enumerate().rev() {
            grid.put_input(first + index, input)?;
            grid.stride[first + index] = if input.sets.len() > 1 { stride } else { 0 };
            stride *= input.sets.len();
        }
        if grid.stride[MOST_INPUTS - 1] == 0 {
            return None;
        }
        grid.offsets = std::array::from_fn(|pair| {
            let bit = |input: usize| pair >> (MOST_INPUTS - 2 - input) & 1;
            (0..MOST_INPUTS - 1).map(|input| bit(input) * grid.stride[input]).sum()
        });
        Some(grid)
    }

    fn put_input(&mut self, lane: usize, input: &Input) -> Option<()> {
        [self.least[lane], self.most[lane]] = input.range;
        if input.sets.len() > SETS {
            return None;
        }
        let corners: Vec<[f64; 4]> = input.sets.iter().map(|named| named.set.corners()).collect();
        let ramps = ramps(input.range, &corners)?;
        for (ramp, (start, end)) in ramps.iter().copied().enumerate() {
            self.start[ramp][lane] = start;
            self.slope[ramp][lane] = 1.0 / (end - start);
            self.passed[ramp][lane] = if ramp + 1 < ramps.len() { 1.0 } else { f64::INFINITY };
        }
        Some(())
    }

    /// The outputs for the inputs there are.
    pub(super) fn evaluate_some(&self, inputs: &[f64]) -> [f64; MOST_OUTPUTS] {
        let mut all = [0.0; MOST_INPUTS];
        all[MOST_INPUTS - self.inputs..].copy_from_slice(inputs);
        self.evaluate(&all)
    }

    /// The outputs for many; inputs beyond those there are come last and are ignored.
    pub(super) fn evaluate_each(
        &self,
        inputs: &[[f64; MOST_INPUTS]],
        outputs: &mut [[f64; MOST_OUTPUTS]],
    ) {
        if self.inputs < MOST_INPUTS {
            for (input, output) in inputs.iter().zip(outputs) {
                *output = self.evaluate_some(&input[..self.inputs]);
            }
            return;
        }
        self.evaluate_each_at(Level::new(), inputs, outputs);
    }

    /// The same with the vector instructions of a level, which change nothing but the time it takes.
    pub(super) fn evaluate_each_at(
        &self,
        level: Level,
        inputs: &[[f64; MOST_INPUTS]],
        outputs: &mut [[f64; MOST_OUTPUTS]],
    ) {
        dispatch!(level, _ => {
            for (input, output) in inputs.iter().zip(outputs.iter_mut()) {
                *output = self.evaluate(input);
            }
        });
    }

    #[inline(always)]
    fn evaluate(&self, inputs: &[f64; MOST_INPUTS]) -> [f64; MOST_OUTPUTS] {
        let (cell, share) = self.locate(inputs);
        let mut pairs: [[f64; PAIR]; PAIRS] = std::array::from_fn(|pair| {
            let at = cell + self.offsets[pair];
            let four = &self.consequents[at..at + PAIR];
            [four[0], four[1], four[2], four[3]]
        });
        // Algorithm 2 with Σ r_i = 1: each input halves the corners left.
        let mut left = PAIRS;
        for share in &share[..MOST_INPUTS - 1] {
            left /= 2;
            for pair in 0..left {
                let (near, far) = (pairs[pair], pairs[pair + left]);
                pairs[pair] = std::array::from_fn(|k| near[k] + share * (far[k] - near[k]));
            }
        }
        let last = share[MOST_INPUTS - 1];
        std::array::from_fn(|output| {
            let (near, far) = (pairs[0][output], pairs[0][output + MOST_OUTPUTS]);
            near + last * (far - near)
        })
    }

    /// The first pair of the cell that the inputs lie in, and how far each is on its way to the next
    /// set, 0 to 1.
    #[inline(always)]
    fn locate(&self, inputs: &[f64; MOST_INPUTS]) -> (usize, [f64; MOST_INPUTS]) {
        let mut cell = 0;
        let mut share = [0.0; MOST_INPUTS];
        let mut passed = [0; MOST_INPUTS];
        for lane in 0..MOST_INPUTS {
            let value = inputs[lane].max(self.least[lane]).min(self.most[lane]);
            let value = if inputs[lane].is_nan() { f64::NAN } else { value };
            let way = |ramp: usize| (value - self.start[ramp][lane]) * self.slope[ramp][lane];
            share[lane] = way(0);
            for ramp in 1..RAMPS {
                let beyond = way(ramp - 1) >= self.passed[ramp - 1][lane];
                share[lane] = if beyond { way(ramp) } else { share[lane] };
                passed[lane] += usize::from(beyond);
            }
            share[lane] = share[lane].clamp(0.0, 1.0);
        }
        for lane in 0..MOST_INPUTS {
            cell += passed[lane] * self.stride[lane];
        }
        (cell, share)
    }
}

/// Where membership passes from each set to the next, listed upwards or downwards: `(start, end)`.
/// None where the sets do not lie side by side over the whole range.
fn ramps([least, most]: [f64; 2], corners: &[[f64; 4]]) -> Option<Vec<(f64, f64)>> {
    let (first, last) = (corners.first()?, corners.last()?);
    let upwards = first[1] <= last[1];
    let (low, high) = if upwards { (first, last) } else { (last, first) };
    if low[1] > least || high[2] < most {
        return None;
    }
    let pairs = corners.windows(2).map(|pair| {
        let (low, high) = if upwards { (pair[0], pair[1]) } else { (pair[1], pair[0]) };
        let side_by_side = low[2] == high[0] && low[3] == high[1] && low[2] < low[3];
        let (start, end) = (low[2], low[3]);
        side_by_side.then_some(if upwards { (start, end) } else { (end, start) })
    });
    pairs.collect()
}

/// The consequents of all rules, [`MOST_OUTPUTS`] each.
fn consequents(rules: &[Rule]) -> Vec<f64> {
    let each = rules.iter().flat_map(|rule| {
        (0..MOST_OUTPUTS).map(|output| match rule.then.get(output) {
            Some(Consequent::Value(value)) => *value,
            _ => 0.0,
        })
    });
    each.collect()
}
