//! Sonars: where they sit, and what they read.

use std::ops::{Deref, DerefMut};

use crate::geometry::Vec2;
use crate::world::RayFan;

/// Most sonars a robot may have: as many as the learner's input has room for.
pub const MOST_SONARS: usize = 24;

/// Where a sonar sits and where it looks, robot frame: x ahead, y to the left, origin where the robot
/// turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mount {
    /// Place, metres.
    pub place: Vec2,
    /// Axis of the cone from the heading, counter-clockwise, radians.
    pub axis_rad: f64,
    /// The same in degrees, as the robot's file and the screen have it.
    ///
    /// It is kept beside the radians because neither is the other to the last bit.
    pub axis_deg: f64,
}

impl Mount {
    /// The fan of rays that stands for its cone.
    pub(crate) fn fan(&self) -> RayFan {
        RayFan { place: self.place, axis_rad: self.axis_rad }
    }
}

/// One reading a sonar, metres, in the order of the robot's [`Mount`]s; kept in place, so that an
/// observation needs no memory of its own.
#[derive(Clone, Copy)]
pub struct Readings {
    metres: [f64; MOST_SONARS],
    count: usize,
}

impl Readings {
    /// So many readings of 0 m, at most [`MOST_SONARS`].
    #[must_use]
    pub fn zero(count: usize) -> Self {
        Self { metres: [0.0; MOST_SONARS], count: count.min(MOST_SONARS) }
    }

    /// Index of the least reading, the first of equals; 0 when there is none.
    #[must_use]
    pub fn nearest(&self) -> usize {
        (1..self.count)
            .fold(0, |least, sonar| if self[sonar] < self[least] { sonar } else { least })
    }
}

impl FromIterator<f64> for Readings {
    /// The first [`MOST_SONARS`] of these readings.
    fn from_iter<I: IntoIterator<Item = f64>>(metres: I) -> Self {
        let mut readings = Self::zero(0);
        for reading_m in metres.into_iter().take(MOST_SONARS) {
            readings.metres[readings.count] = reading_m;
            readings.count += 1;
        }
        readings
    }
}

impl Deref for Readings {
    type Target = [f64];

    fn deref(&self) -> &[f64] {
        &self.metres[..self.count]
    }
}

impl DerefMut for Readings {
    fn deref_mut(&mut self) -> &mut [f64] {
        &mut self.metres[..self.count]
    }
}

impl PartialEq for Readings {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl std::fmt::Debug for Readings {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn readings_are_as_many_as_were_taken_and_never_more_than_fit() {
        for (taken, kept) in [(0, 0), (10, 10), (24, 24), (99, 24)] {
            let readings: Readings = (0..taken).map(f64::from).collect();
            assert_eq!((readings.len(), Readings::zero(taken as usize).len()), (kept, kept));
        }
        let few: Readings = [3.0, 1.0, 2.0, 1.0].into_iter().collect();
        assert_eq!(few.nearest(), 1, "the first of equals");
        let fewer: Readings = [3.0, 1.0, 2.0].into_iter().collect();
        assert!(few != fewer, "what is beyond the count does not make them equal");
    }
}
