//! The reflex: two fuzzy behaviours with constant desirability, section 5.6.
//!
//! The thesis names the behaviours, their common output sets and the two desirabilities; the inputs'
//! sets and the rules are not printed. NOTE: the eight avoidance rules, the three sectors and their
//! widths are our reading, chosen so that the reflex is safe, goal directed and folds its path into
//! the concave region, as the thesis describes.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::fuzzy::{Inference, Triangle, centre_of_area, falling};
use crate::geometry::wrap_angle;
use crate::robot::Mount;

/// `left`, `forward`, `right`: overlapping triangles that span `[-π, π]`.
const DIRECTIONS: [Triangle; 3] = [
    Triangle { left: 0.0, peak: FRAC_PI_2, right: PI },
    Triangle { left: -FRAC_PI_2, peak: 0.0, right: FRAC_PI_2 },
    Triangle { left: -PI, peak: -FRAC_PI_2, right: 0.0 },
];

/// Greatest bearings of the sonars that look ahead, and of those that look to a side, degrees.
const AHEAD_DEG: f64 = 30.0;
const SIDE_DEG: f64 = 75.0;

/// Settings of the reflex.
#[derive(Clone, Debug, PartialEq)]
pub struct ReflexSettings {
    /// Desirability of obstacle avoidance, `d_a`.
    pub avoid: f64,
    /// Desirability of goal following, `d_g`.
    pub goal: f64,
    /// How activations become an area.
    pub inference: Inference,
    /// Avoidance votes for forward when nothing is near.
    pub idle_forward: bool,
    /// Readings ahead that are wholly near and wholly free, metres.
    pub front_m: (f64, f64),
    /// Readings to a side that are wholly near and wholly free, metres.
    pub side_m: (f64, f64),
    /// Bearing of the goal at which goal following is all turning, radians.
    pub goal_span_rad: f64,
}

/// The reflex at work: activations are `[left, forward, right]`, section 5.6.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ReflexTrace {
    /// Nearest reading ahead, to the left and to the right, metres.
    pub nearest_m: [f64; 3],
    /// Membership of "near" ahead, left and right.
    pub near: [f64; 3],
    /// `α_a`, obstacle avoidance.
    pub avoid: [f64; 3],
    /// `α_g`, goal following.
    pub goal: [f64; 3],
    /// `α_f`, Eq. (5.8).
    pub fused: [f64; 3],
    /// `α_r`, the defuzzified rotation, radians.
    pub rotation_rad: f64,
}

/// The fuzzy reflex.
#[derive(Clone, Debug, PartialEq)]
pub struct Reflex {
    settings: ReflexSettings,
    /// Sonars that look ahead, to the left and to the right.
    sectors: [Vec<usize>; 3],
}

impl Reflex {
    /// A reflex with these settings for a robot with these sonars.
    #[must_use]
    pub fn new(settings: ReflexSettings, sonars: &[Mount]) -> Self {
        Self { settings, sectors: sectors(sonars) }
    }

    /// The rotation it advises, with every activation on the way.
    ///
    /// `sonar_m` is one reading for each sonar; `goal_bearing_rad` is in `[-π, π)`.
    #[must_use]
    pub fn advise(&self, sonar_m: &[f64], goal_bearing_rad: f64) -> ReflexTrace {
        let settings = &self.settings;
        let nearest_m = self
            .sectors
            .each_ref()
            .map(|sector| sector.iter().map(|&sonar| sonar_m[sonar]).fold(f64::INFINITY, f64::min));
        let near = [
            falling(nearest_m[0], settings.front_m.0, settings.front_m.1),
            falling(nearest_m[1], settings.side_m.0, settings.side_m.1),
            falling(nearest_m[2], settings.side_m.0, settings.side_m.1),
        ];
        let avoid = self.avoidance(near);
        let goal = self.goal_following(goal_bearing_rad);
        // Eq. (5.8): α_f = d_a α_a + d_g α_g
        let fused: [f64; 3] = std::array::from_fn(|direction| {
            settings.avoid * avoid[direction] + settings.goal * goal[direction]
        });
        let rotation_rad = centre_of_area(settings.inference, &DIRECTIONS, &fused).unwrap_or(0.0);
        ReflexTrace { nearest_m, near, avoid, goal, fused, rotation_rad }
    }

    /// Product rules over near and free; a blocked way ahead prefers the left.
    fn avoidance(&self, near: [f64; 3]) -> [f64; 3] {
        let [front, left, right] = near;
        let [no_front, no_left, no_right] = near.map(|degree| 1.0 - degree);
        let turn_left = no_front * no_left * right
            + front * no_left * right
            + front * no_left * no_right
            + front * left * right;
        let turn_right = no_front * left * no_right + front * left * no_right;
        let mut forward = no_front * left * right
            + 0.5 * (no_front * left * no_right + no_front * no_left * right);
        if self.settings.idle_forward {
            forward += no_front * no_left * no_right;
        }
        [turn_left, forward, turn_right]
    }

    /// Turns towards the goal in proportion to its bearing, up to the span.
    fn goal_following(&self, bearing_rad: f64) -> [f64; 3] {
        let turn = (bearing_rad.abs() / self.settings.goal_span_rad).min(1.0);
        if bearing_rad >= 0.0 { [turn, 1.0 - turn, 0.0] } else { [0.0, 1.0 - turn, turn] }
    }
}

/// Sonars ahead (within 30°), to the left (beyond, to 75°) and to the right.
fn sectors(sonars: &[Mount]) -> [Vec<usize>; 3] {
    // A bearing on a border counts as inside, however its degrees were rounded.
    let within = |bearing_deg: f64, limit_deg: f64| bearing_deg <= limit_deg + 1e-9;
    let mut sectors = [Vec::new(), Vec::new(), Vec::new()];
    for (sonar, mount) in sonars.iter().enumerate() {
        let bearing_deg = wrap_angle(mount.axis_rad).to_degrees();
        if within(bearing_deg.abs(), AHEAD_DEG) {
            sectors[0].push(sonar);
        } else if within(bearing_deg.abs(), SIDE_DEG) {
            sectors[if bearing_deg > 0.0 { 1 } else { 2 }].push(sonar);
        }
    }
    sectors
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::experiment::Settings;
    use crate::robot::examples::{b21, trc};

    fn reflex() -> Reflex {
        Reflex::new(Settings::default().reflex(), b21().sonars())
    }

    fn readings(front: f64, left: f64, right: f64) -> [f64; 24] {
        let mut sonar_m = [8.0; 24];
        for (sector, reading) in reflex().sectors.iter().zip([front, left, right]) {
            for &sonar in sector {
                sonar_m[sonar] = reading;
            }
        }
        sonar_m
    }

    #[test]
    fn the_sectors_are_those_of_the_bearings() {
        let ahead_left_right = [vec![0, 1, 2, 22, 23], vec![3, 4, 5], vec![19, 20, 21]];
        assert_eq!(sectors(b21().sonars()), ahead_left_right);
        let front = [vec![3, 4, 5, 6], vec![0, 1, 2], vec![7, 8, 9]];
        assert_eq!(sectors(trc().sonars()), front);
    }

    #[test]
    fn what_it_does_in_plain_situations() {
        let quarter = FRAC_PI_2.to_degrees();
        for (name, sonar_m, bearing_deg, expected_deg) in [
            ("free, goal ahead", readings(8.0, 8.0, 8.0), 0.0, 0.0),
            ("free, goal to the left", readings(8.0, 8.0, 8.0), 30.0, quarter / 2.0),
            ("free, goal behind", readings(8.0, 8.0, 8.0), -170.0, -quarter),
            ("wall ahead, goal ahead", readings(0.1, 8.0, 8.0), 0.0, 0.9 * quarter),
            ("wall to the left, goal ahead", readings(8.0, 0.05, 8.0), 0.0, -0.9 * quarter / 1.45),
            ("narrow way", readings(8.0, 0.05, 0.05), 0.0, 0.0),
        ] {
            let found = reflex().advise(&sonar_m, f64::to_radians(bearing_deg));
            let found_deg = found.rotation_rad.to_degrees();
            assert!((found_deg - expected_deg).abs() < 1e-9, "{name}: {found_deg}");
        }
    }

    proptest! {
        #[test]
        fn the_advice_is_a_quarter_turn_at_most(
            sonar_m in proptest::array::uniform24(0.0..8.0f64),
            bearing_rad in -PI..PI,
        ) {
            let trace = reflex().advise(&sonar_m, bearing_rad);
            prop_assert!(trace.rotation_rad.abs() <= FRAC_PI_2 + 1e-12);
            for activation in trace.avoid.iter().chain(&trace.goal).chain(&trace.near) {
                prop_assert!((0.0..=1.0).contains(activation), "{activation}");
            }
        }
    }
}
