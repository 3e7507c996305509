//! One step's motion along the heading, and the rescue after a collision (sections 5.4 and 5.5).
//!
//! The robot advances in increments and looks at its infrared and tactile sensors after each. A
//! clearance is at least what it was less the way travelled since, so it is computed only where it
//! could matter; the outcome is that of computing it after every increment, to the bit.

use crate::geometry::Vec2;
use crate::world::World;

use super::simulated::SimulationSettings;
use super::{Body, Contact};

/// Slack on a clearance known from an earlier place, metres; far more than rounding can add up to.
const SLACK_M: f64 = 1e-9;

/// What became of one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// Collision, if there was one.
    pub contact: Contact,
    /// Way advanced before any rescue, metres.
    pub advanced_m: f64,
    /// Way backed off in the rescue, metres.
    pub backed_m: f64,
    /// Displacement as the odometry measured it, net of the rescue, metres.
    pub moved: Vec2,
}

/// How far a rotation came before the body would have touched something.
pub(super) struct Turn {
    /// Share of the rotation executed.
    pub(super) share: f64,
    /// Real, when it was cut short.
    pub(super) contact: Contact,
    /// Clearance of the body after it, metres.
    pub(super) clearance_m: f64,
}

/// A straight way ahead of the robot.
pub(crate) struct Course<'a> {
    pub(crate) world: &'a World,
    pub(crate) body: Body,
    pub(crate) settings: &'a SimulationSettings,
    pub(crate) start: Vec2,
    /// Unit vector of the heading.
    pub(crate) direction: Vec2,
    /// Clearance of the body at the start, metres.
    pub(crate) start_clearance_m: f64,
}

/// How far the robot came.
pub(crate) struct Way {
    pub(crate) contact: Contact,
    pub(crate) advanced_m: f64,
    pub(crate) backed_m: f64,
    /// Clearance of the body at the end, metres.
    pub(crate) clearance_m: f64,
}

impl Course<'_> {
    /// Advances one step's way, unless the rotation before it was cut short, with the rescue if that
    /// ends in a collision.
    pub(crate) fn travel(&self, turned_into: Contact) -> Way {
        let (contact, advanced_m) = match turned_into {
            Contact::None => self.advance(),
            stopped => (stopped, 0.0),
        };
        let rescued = contact != Contact::None && self.settings.rescue;
        let backed_m = if rescued { self.back_off(advanced_m) } else { 0.0 };
        let clearance_m = self.clearance_m(advanced_m - backed_m);
        Way { contact, advanced_m, backed_m, clearance_m }
    }

    /// Advances until a collision or the end of the step. An increment that would press the shell
    /// against a surface is not taken.
    fn advance(&self) -> (Contact, f64) {
        let virtual_m = self.settings.virtual_collision_m();
        // What was last computed, and where.
        let (mut known_m, mut known_at_m) = (self.start_clearance_m, 0.0);
        let mut advanced_m = 0.0;
        for increment in 1..=self.increments(self.settings.advance_m) {
            let next_m = self.way_m(increment).min(self.settings.advance_m);
            if known_m - (next_m - known_at_m) < virtual_m.max(0.0) + SLACK_M {
                (known_m, known_at_m) = (self.clearance_m(next_m), next_m);
                if known_m <= 0.0 {
                    return (Contact::Real, advanced_m);
                }
                if known_m < virtual_m {
                    return (Contact::Virtual, next_m);
                }
            }
            advanced_m = next_m;
        }
        (Contact::None, advanced_m)
    }

    /// Backs off along the heading until the shell is clear, and at least the least way. Stops
    /// before it would touch something behind, or become unclear again, or exceed the greatest way.
    fn back_off(&self, advanced_m: f64) -> f64 {
        let SimulationSettings { clear_to_m, back_min_m, back_max_m, touch_m, .. } = *self.settings;
        let mut clearance_m = self.clearance_m(advanced_m);
        let mut backed_m = 0.0;
        for increment in 1..=self.increments(back_max_m) {
            if clearance_m >= clear_to_m && backed_m >= back_min_m - SLACK_M {
                break;
            }
            let next_m = self.way_m(increment).min(back_max_m);
            let next_clearance_m = self.clearance_m(advanced_m - next_m);
            let touches = next_clearance_m < touch_m && next_clearance_m <= clearance_m;
            if touches || (clearance_m >= clear_to_m && next_clearance_m < clear_to_m) {
                break;
            }
            (clearance_m, backed_m) = (next_clearance_m, next_m);
        }
        backed_m
    }

    /// Increments needed for a way.
    fn increments(&self, way_m: f64) -> u32 {
        libm::ceil(way_m / self.settings.increment_m - SLACK_M) as u32
    }

    fn way_m(&self, increments: u32) -> f64 {
        f64::from(increments) * self.settings.increment_m
    }

    /// Clearance of the body after a way along the heading, metres.
    fn clearance_m(&self, way_m: f64) -> f64 {
        let position = self.start + self.direction * way_m;
        self.body.clearance_m(self.world, position, self.direction)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::geometry::unit;
    use crate::robot::examples::{b21, trc};
    use crate::world::examples::{all_files, room_file, world};

    /// The same motion with the clearance computed after every increment.
    fn looking_every_time(course: &Course) -> (Contact, f64) {
        let increments = course.increments(course.settings.advance_m);
        for increment in 1..=increments {
            let way_m = course.way_m(increment).min(course.settings.advance_m);
            let clearance_m = course.clearance_m(way_m);
            if clearance_m <= 0.0 {
                return (Contact::Real, course.way_m(increment - 1));
            }
            if clearance_m < course.settings.virtual_collision_m() {
                return (Contact::Virtual, way_m);
            }
        }
        (Contact::None, course.settings.advance_m)
    }

    proptest! {
        #[test]
        fn looking_only_where_it_matters_changes_no_bit(
            world_index in 0..3usize, robot_index in 0..2usize,
            x in -1.2..5.3f64, y in -3.2..2.2f64, heading_rad in -3.2..3.2f64, threshold_pct in 50.0..90.0f64, advance_m in 0.05..0.6f64,
        ) {
            let world = world(&all_files()[world_index]);
            let settings = SimulationSettings {
                infrared_threshold_pct: threshold_pct, advance_m, ..Default::default()
            };
            let start = Vec2::new(x, y);
            let direction = unit(heading_rad);
            let body = [b21(), trc()][robot_index].body();
            let start_clearance_m = body.clearance_m(&world, start, direction);
            prop_assume!(world.clearance_m(start) > 0.0 && start_clearance_m > 0.0);
            let settings = &settings;
            let course =
                Course { world: &world, body, settings, start, direction, start_clearance_m };
            prop_assert_eq!(course.advance(), looking_every_time(&course));
        }
    }

    /// Drives east in a room of the given width from `x`, and tells what happened:
    /// contact, way advanced, way backed off, clearance at the end.
    fn east(width_m: f64, x: f64, settings: &SimulationSettings) -> (Contact, [f64; 3]) {
        let world = world(&room_file(width_m, 4.0));
        let start = Vec2::new(x, 0.0);
        let (body, direction) = (b21().body(), Vec2::x());
        let start_clearance_m = body.clearance_m(&world, start, direction);
        let course = Course { world: &world, body, settings, start, direction, start_clearance_m };
        let way = course.travel(Contact::None);
        (way.contact, [way.advanced_m, way.backed_m, way.clearance_m])
    }

    #[test]
    fn a_collision_and_its_rescue_are_as_specified() {
        let normal = SimulationSettings::default();
        let dark = SimulationSettings { infrared_reflectance: 0.5, ..normal.clone() };
        let long = SimulationSettings { back_min_m: 0.3, ..normal.clone() };
        let short = SimulationSettings { back_min_m: 0.0, back_max_m: 0.03, ..normal.clone() };
        // The shell touches the east wall at half the width less 0.265 m.
        for (case, width_m, x, settings, contact, expected) in [
            ("free way", 4.0, 0.0, &normal, Contact::None, [0.2, 0.0, 1.535]),
            ("stops below 10 cm", 4.0, 1.6, &normal, Contact::Virtual, [0.04, 0.1, 0.195]),
            ("starts below 10 cm", 4.0, 1.65, &normal, Contact::Virtual, [0.01, 0.1, 0.175]),
            ("touches what is dark", 4.0, 1.6, &dark, Contact::Real, [0.13, 0.15, 0.155]),
            ("backs off the least way", 4.0, 1.6, &long, Contact::Virtual, [0.04, 0.3, 0.395]),
            (
                "backs off no more than allowed",
                4.0,
                1.6,
                &short,
                Contact::Virtual,
                [0.04, 0.03, 0.125],
            ),
            (
                "stays off what is behind",
                0.735,
                0.0,
                &normal,
                Contact::Virtual,
                [0.01, 0.1, 0.0125],
            ),
            ("stays clear", 0.84, 0.0, &normal, Contact::Virtual, [0.06, 0.06, 0.155]),
        ] {
            let (found, lengths_m) = east(width_m, x, settings);
            assert_eq!(found, contact, "{case}");
            for (length_m, expected_m) in lengths_m.into_iter().zip(expected) {
                assert!((length_m - expected_m).abs() < 1e-12, "{case}: {lengths_m:?}");
            }
        }
    }
}
