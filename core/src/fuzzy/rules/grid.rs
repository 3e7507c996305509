//! The fast path of inference: at most two sets of each input are active, and next to each other.
//!
//! Where the sets of every input lie side by side, each falling exactly where the next rises, the
//! memberships of a value add up to 1, so the weighted mean of Algorithm 2 needs no division and is
//! an interpolation between the 2⁶ corners of the cell that the inputs lie in. Lanes are computed by
//! themselves, so no result depends on the instructions the compiler chooses.

use super::{Consequent, Input, MOST_INPUTS, MOST_OUTPUTS, Norms, Output, Rule};
use crate::fuzzy::Shape;
use crate::simd::*;

/// Most sets of an input here.
const SETS: usize = 4;
/// Places between neighbouring sets.
const RAMPS: usize = SETS - 1;
/// Inputs as two vectors of four.
const LANES: usize = 8;
/// Consequents of the four rules at the corners of a cell of the last two inputs.
const CELL: usize = 4 * MOST_OUTPUTS;
/// The number from which on a float has no digits behind the point, so that its last bits count.
const WHOLE: f64 = (1_u64 << 52) as f64;

/// A table of consequents and where the inputs lie in it. Inputs that are missing have one set.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Grid {
    inputs: usize,
    least: [f64; LANES],
    most: [f64; LANES],
    /// Where membership begins to pass from a set to the next, and 1 / the way until it has.
    start: [[f64; LANES]; RAMPS],
    slope: [[f64; LANES]; RAMPS],
    /// Share of the way at which the next ramp counts: 1, or never.
    passed: [[f64; LANES]; RAMPS],
    /// Way from a set of an input to the next, in cells; as numbers too, to be added up in lanes.
    stride: [usize; MOST_INPUTS],
    steps: [f64; LANES],
    /// For each set of the first inputs and each cell of the last two: the consequents at the corners near
    /// along the last input but one, two and two along the last, and how far it is to those beyond.
    cells: Vec<[f64; CELL]>,
}

/// The cell of the table that inputs lie in.
struct Cell<'a, S: Simd> {
    simd: S,
    cells: &'a [[f64; CELL]],
    stride: &'a [usize; MOST_INPUTS],
    /// How far each input is on its way to the next set, 0 to 1.
    share: [f64; LANES],
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
            least: [0.0; LANES],
            most: [0.0; LANES],
            start: [[0.0; LANES]; RAMPS],
            slope: [[0.0; LANES]; RAMPS],
            passed: [[f64::INFINITY; LANES]; RAMPS],
            stride: [0; MOST_INPUTS],
            steps: [0.0; LANES],
            cells: Vec::new(),
        };
        // The last inputs come last here too.
        let first = MOST_INPUTS - inputs.len();
        let mut sets = [1; MOST_INPUTS];
        for (index, input) in inputs.iter().enumerate() {
            sets[first + index] = input.sets.len();
            grid.put_input(first + index, input)?;
        }
        let mut stride = 1;
        for lane in (0..MOST_INPUTS).rev() {
            grid.stride[lane] = if sets[lane] > 1 { stride } else { 0 };
            grid.steps[lane] = grid.stride[lane] as f64;
            stride *= if lane < MOST_INPUTS - 2 { sets[lane] } else { (sets[lane] - 1).max(1) };
        }
        grid.cells = (0..stride).map(|cell| corners(cell, &sets, rules)).collect();
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
        dispatch!(Level::new(), simd => self.evaluate(simd, &all))
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
        dispatch!(level, simd => {
            for (input, output) in inputs.iter().zip(outputs.iter_mut()) {
                *output = self.evaluate(simd, input);
            }
        });
    }

    #[inline(always)]
    fn evaluate<S: Simd>(&self, simd: S, inputs: &[f64; MOST_INPUTS]) -> [f64; MOST_OUTPUTS] {
        // What is not a number would be lost where inputs are kept within their ranges.
        if inputs.iter().fold(false, |none, input| none | input.is_nan()) {
            return [f64::NAN; MOST_OUTPUTS];
        }
        let (first, share) = self.locate(simd, inputs);
        let cell = Cell { simd, cells: &self.cells, stride: &self.stride, share };
        let last = share[MOST_INPUTS - 1];
        let [near_0, near_1, far_0, far_1] = <[f64; 4]>::from(cell.five(first));
        [near_0 + last * (far_0 - near_0), near_1 + last * (far_1 - near_1)]
    }

    /// Where the cell begins that the inputs lie in, and how far each is on its way to the next set.
    #[inline(always)]
    fn locate<S: Simd>(&self, simd: S, inputs: &[f64; MOST_INPUTS]) -> (usize, [f64; LANES]) {
        let [a, b, c, d, e, f] = *inputs;
        let values = [[a, b, c, d], [e, f, 0.0, 0.0]];
        let mut share = [0.0; LANES];
        let mut cell = f64x4::splat(simd, 0.0);
        for (half, values) in values.into_iter().enumerate() {
            let first = half * 4;
            let four = |from: &[f64; LANES]| f64x4::from_slice(simd, &from[first..first + 4]);
            let value = f64x4::simd_from(simd, values).max(four(&self.least)).min(four(&self.most));
            let way = |ramp: usize| (value - four(&self.start[ramp])) * four(&self.slope[ramp]);
            let (near, middle, far) = (way(0), way(1), way(2));
            let second = near.simd_ge(four(&self.passed[0]));
            let third = middle.simd_ge(four(&self.passed[1]));
            let way = third.select(far, second.select(middle, near));
            let way = way.max(f64x4::splat(simd, 0.0)).min(f64x4::splat(simd, 1.0));
            share[first..first + 4].copy_from_slice(&<[f64; 4]>::from(way));
            let (step, stay) = (four(&self.steps), f64x4::splat(simd, 0.0));
            cell = cell + second.select(step, stay) + third.select(step, stay);
        }
        let [a, b, c, d] = <[f64; 4]>::from(cell);
        let cell = ((a + b) + (c + d) + WHOLE).to_bits() & u64::from(u16::MAX);
        (cell as usize, share)
    }
}

/// Algorithm 2 with Σ r_i = 1, input by input from the last but one to the first: each lies somewhere
/// between two sets, and halves the corners that are left.
impl<S: Simd> Cell<'_, S> {
    #[inline(always)]
    fn between(&self, input: usize, near: f64x4<S>, far: f64x4<S>) -> f64x4<S> {
        near + (far - near) * f64x4::splat(self.simd, self.share[input])
    }

    #[inline(always)]
    fn one(&self, at: usize) -> f64x4<S> {
        let (near, way) = self.cells[at].split_at(CELL / 2);
        let near = f64x4::from_slice(self.simd, near);
        near + f64x4::from_slice(self.simd, way) * f64x4::splat(self.simd, self.share[4])
    }

    #[inline(always)]
    fn two(&self, at: usize) -> f64x4<S> {
        self.between(3, self.one(at), self.one(at + self.stride[3]))
    }

    #[inline(always)]
    fn three(&self, at: usize) -> f64x4<S> {
        self.between(2, self.two(at), self.two(at + self.stride[2]))
    }

    #[inline(always)]
    fn four(&self, at: usize) -> f64x4<S> {
        self.between(1, self.three(at), self.three(at + self.stride[1]))
    }

    #[inline(always)]
    fn five(&self, at: usize) -> f64x4<S> {
        self.between(0, self.four(at), self.four(at + self.stride[0]))
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

/// The consequents at the corners of a cell that are near along the last input but one, near and far along
/// the last, and the ways from these to those that are far.
fn corners(cell: usize, sets: &[usize; MOST_INPUTS], rules: &[Rule]) -> [f64; CELL] {
    let [.., along, last] = *sets;
    let (cells_along, cells_last) = ((along - 1).max(1), (last - 1).max(1));
    let (first, place) = (cell / (cells_along * cells_last), cell % (cells_along * cells_last));
    let (at_along, at_last) = (place / cells_last, place % cells_last);
    let rule = |far_along: usize, far_last: usize| {
        let along_set = (at_along + far_along).min(along - 1);
        &rules[(first * along + along_set) * last + (at_last + far_last).min(last - 1)]
    };
    let mut consequents = [0.0; CELL];
    for (corner, values) in consequents.chunks_mut(MOST_OUTPUTS).enumerate() {
        for (value, consequent) in values.iter_mut().zip(&rule(corner / 2, corner % 2).then) {
            if let Consequent::Value(number) = consequent {
                *value = *number;
            }
        }
    }
    let (near, far) = consequents.split_at_mut(CELL / 2);
    for (near, far) in near.iter().zip(far) {
        *far -= near;
    }
    consequents
}
