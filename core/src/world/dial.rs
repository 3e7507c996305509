//! Which fans of rays look where: a dial round the body, each of its hours with the fans whose rays
//! may be met there.

use std::f64::consts::{PI, TAU};

use super::bearing::Sector;
use super::tree::LANES;

/// Hours of the dial, 2.8° each; a power of two.
const HOURS: usize = 128;
/// Runs of 1, 2, 4, … 128 hours.
const LEVELS: usize = HOURS.ilog2() as usize + 1;

/// A set of fans, one bit each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Fans(u64);

/// For every run of a power of two of hours, the fans that look there. Any run is two of these,
/// which may overlap.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Dial {
    runs: [[Fans; HOURS]; LEVELS],
}

impl Fans {
    /// Most fans there may be.
    pub(super) const LIMIT: usize = 64;

    /// Of four fans of a block those whose bit is set.
    #[inline(always)]
    pub(super) fn of_block(block: usize, bits: u64) -> Self {
        Self(bits << (block * LANES))
    }

    /// The fans that are in both sets.
    #[inline(always)]
    pub(super) fn and(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    /// The fans that are in either set.
    #[inline(always)]
    pub(super) fn or(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    #[inline(always)]
    pub(super) fn is_empty(self) -> bool {
        self.0 == 0
    }
}

/// The blocks that have a fan in the set.
impl Iterator for Fans {
    type Item = usize;

    #[inline(always)]
    fn next(&mut self) -> Option<usize> {
        if self.is_empty() {
            return None;
        }
        let block = self.0.trailing_zeros() as usize / LANES;
        self.0 &= !(((1 << LANES) - 1) << (block * LANES));
        Some(block)
    }
}

impl Dial {
    /// A dial for fans that each look into a sector, or anywhere.
    pub(super) fn new(sectors: &[Option<Sector>]) -> Self {
        let mut runs = [[Fans::default(); HOURS]; LEVELS];
        for (fan, sector) in sectors.iter().enumerate() {
            let (first, count) = sector.map_or((0, HOURS), hours);
            (first..first + count).for_each(|hour| runs[0][hour % HOURS].0 |= 1 << fan);
        }
        for level in 1..LEVELS {
            let half = 1 << (level - 1);
            for hour in 0..HOURS {
                let halves = [hour, hour + half].map(|start| runs[level - 1][start % HOURS].0);
                runs[level][hour].0 = halves[0] | halves[1];
            }
        }
        Self { runs }
    }

    /// The fans that may look into a sector.
    #[inline(always)]
    pub(super) fn fans(&self, sector: Sector) -> Fans {
        let (first, count) = hours(sector);
        let level = count.ilog2() as usize;
        let last = first + count - (1 << level);
        let runs = &self.runs[level];
        Fans(runs[first % HOURS].0 | runs[last % HOURS].0)
    }
}

/// The hours that a sector touches: the first, and how many, at least one and at most all.
#[inline(always)]
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a few hundred, positive"
)]
fn hours(sector: Sector) -> (usize, usize) {
    // Turned on by two rounds, so that both ends are positive and are rounded down.
    let hour = |angle_rad: f64| ((angle_rad + 2.0 * TAU) * (HOURS as f64 / TAU)) as u32 as usize;
    let (first, last) = (hour(sector.from_rad), hour(sector.to_rad));
    (first, (last - first + 1).min(HOURS))
}

/// The sector in which rays are seen that leave a place at an angle, seen from the centre of the
/// body, in directions up to `half_rad` from an axis; none when that may be anywhere. A ray stays
/// between where it starts and where it goes.
pub(super) fn sector_of_fan(place_rad: f64, axis_rad: f64, half_rad: f64) -> Option<Sector> {
    let off_rad = crate::geometry::wrap_angle(place_rad - axis_rad);
    let axis_rad = crate::geometry::wrap_angle(axis_rad);
    let (from_rad, to_rad) = (axis_rad + off_rad.min(-half_rad), axis_rad + off_rad.max(half_rad));
    // Rays that may pass the centre on either side are seen anywhere.
    (off_rad.abs() + half_rad < PI - 1e-6).then_some(Sector { from_rad, to_rad })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn sector() -> impl Strategy<Value = Sector> {
        (-PI..PI, 0.0..3.0f64)
            .prop_map(|(from_rad, width_rad)| Sector { from_rad, to_rad: from_rad + width_rad })
    }

    proptest! {
        #[test]
        fn fans_that_look_into_a_sector_are_found(
            sectors in proptest::collection::vec(sector(), 1..20), sought in sector(),
            share in 0.0..=1.0f64,
        ) {
            let dial = Dial::new(&sectors.iter().copied().map(Some).collect::<Vec<_>>());
            let found = dial.fans(sought);
            let angle_rad = sought.from_rad + share * (sought.to_rad - sought.from_rad);
            for (fan, sector) in sectors.iter().enumerate() {
                let turns = [-TAU, 0.0, TAU].map(|turn| angle_rad + turn);
                let looks = turns.iter().any(|a| (sector.from_rad..=sector.to_rad).contains(a));
                prop_assert!(!looks || found.0 & (1 << fan) != 0, "{} {:?}", fan, found);
            }
        }

        #[test]
        fn a_fan_is_seen_in_its_sector(
            x in -1.0..1.0f64, y in -1.0..1.0f64, axis_rad in -7.0..7.0f64, half_rad in 0.0..0.8f64,
            share in -1.0..=1.0f64, way in 0.0..9.0f64,
        ) {
            use crate::geometry::{Vec2, angle, unit};
            let place = Vec2::new(x, y);
            let point = place + unit(axis_rad + half_rad * share) * way;
            let Some(sector) = sector_of_fan(angle(place), axis_rad, half_rad) else {
                return Ok(());
            };
            let turns = [-TAU, 0.0, TAU].map(|turn| angle(point) + turn);
            let held = turns.iter().any(|a| {
                (sector.from_rad - 1e-9..=sector.to_rad + 1e-9).contains(a)
            });
            prop_assert!(held, "{:?} {}", sector, angle(point));
        }
    }
}
