//! Rough copies of centres in small whole numbers, to tell quickly which can be the nearest at all.

use wide::{i16x8, i32x4};

use super::{INPUTS, Input};

/// Steps in a unit of input. 32 squares of it fit into 31 bits.
const STEPS: f64 = 8000.0;

/// Most by which the distance of two sketches exceeds that of what they stand for, in steps: half a
/// step each in 32 dimensions are √32, and the rest is for rounding.
const BLUR: f64 = 5.7;

/// An input in whole steps. What lies outside of [0, 1] is drawn at the edge, which brings nothing
/// farther apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Sketch([i16x8; INPUTS / 8]);

impl Sketch {
    #[expect(clippy::cast_possible_truncation, reason = "0 to 8000")]
    pub(super) fn new(input: &Input) -> Self {
        let step = |x: f64| (x.clamp(0.0, 1.0) * STEPS + 0.5) as i16;
        Self(std::array::from_fn(|row| {
            i16x8::new(std::array::from_fn(|column| step(input[8 * row + column])))
        }))
    }

    /// Squared distance, in steps.
    #[inline(always)]
    pub(super) fn squared_distance(&self, other: &Self) -> i32 {
        let mut squared = i32x4::ZERO;
        for (a, b) in self.0.iter().zip(&other.0) {
            let difference = *a - *b;
            squared += difference.dot(difference);
        }
        squared.reduce_add()
    }
}

/// Greatest squared distance of the sketches of two inputs whose squared distance is `squared`, in
/// steps.
#[inline(always)]
#[expect(clippy::cast_possible_truncation, reason = "saturates")]
pub(super) fn greatest(squared: f64) -> i32 {
    let distance = squared.sqrt() * STEPS + BLUR;
    (distance * distance) as i32
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn sketches_are_no_farther_apart_than_said(
            a in proptest::array::uniform32(-0.3..1.3f64), b in proptest::array::uniform32(0.0..1.0f64),
            near in 0.0..=1.0f64,
        ) {
            let c: Input = std::array::from_fn(|k| a[k] + (b[k] - a[k]) * near);
            let squared = a.iter().zip(&c).map(|(a, c)| (a - c) * (a - c)).sum();
            let rough = Sketch::new(&a).squared_distance(&Sketch::new(&c));
            prop_assert!(rough <= greatest(squared), "{} {}", rough, squared);
        }
    }

    #[test]
    fn the_farthest_inputs_fit() {
        let corners = [0.0, 1.0].map(|x| Sketch::new(&[x; INPUTS]));
        assert_eq!(corners[0].squared_distance(&corners[1]), 32 * 8000 * 8000);
        assert_eq!(greatest(f64::INFINITY), i32::MAX);
    }
}
