//! One step's motion along the heading, and the rescue after a collision (sections 5.4 and 5.5).
//!
//! The robot advances in increments and looks at its infrared and tactile sensors after each. A
//! clearance is at least what it was less the way travelled since, so it is computed only where it
//! could matter; the outcome is that of computing it after every increment, to the bit.

use crate::geometry::Vec2;
use crate::world::World;

use super::Contact;
use super::b21::B21Settings;

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

/// A straight way ahead of the robot.
pub(super) struct Course<'a> {
    pub(super) world: &'a World,
    pub(super) settings: &'a B21Settings,
    pub(super) start: Vec2,
    /// Unit vector of the heading.
    pub(super) direction: Vec2,
    /// Clearance of the shell at the start, metres.
    pub(super) start_clearance_m: f64,
}

/// How far the robot came.
pub(super) struct Way {
    pub(super) contact: Contact,
    pub(super) advanced_m: f64,
    pub(super) backed_m: f64,
    /// Clearance of the shell at the end, metres.
    pub(super) clearance_m: f64,
}

impl Course<'_> {
    /// Advances one step's way, with the rescue if that ends in a collision.
    pub(super) fn travel(&self) -> Way {
        let (contact, advanced_m) = self.advance();
        let backed_m = if contact == Contact::None { 0.0 } else { self.back_off(advanced_m) };
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
        let B21Settings { clear_to_m, back_min_m, back_max_m, touch_m, .. } = *self.settings;
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

    /// Clearance of the shell after a way along the heading, metres.
    fn clearance_m(&self, way_m: f64) -> f64 {
        let position = self.start + self.direction * way_m;
        self.world.surface_distance_m(position) - self.settings.radius_m
    }
}
