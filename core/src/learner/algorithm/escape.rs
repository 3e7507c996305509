//! The escape (addition A5): along an obstacle until the goal is nearer than ever.
//!
//! NOTE (A5): the thesis has the reflex lead the robot to the goal in its first trial. Where it cannot,
//! nothing is ever recorded and nothing learned. When the goal has not come nearer for a number of steps,
//! the robot turns from the obstacle on its way as far as it must, and goes along it, like the "Bug"
//! algorithms: in odd trials to the left, so that the obstacle stays on its right, and in even ones to
//! the right, until a trial succeeds, whose side is kept. What is executed is recorded like any other action.

use super::room::FAN_RAD;
use super::{Learner, Situation};
use crate::geometry::{Pose, Vec2, unit, wrap_angle};

/// Directions in a full turn.
const FAN: u32 = 24;
/// Directions in a right angle.
const RIGHT_ANGLE: f64 = 6.0;
/// Clearance kept along an obstacle, metres; a virtual collision is reported at 0.1.
const ALONG_M: f64 = 0.12;
/// So many collisions in a row show that the robot is stuck without more waiting.
const MOST_COLLISIONS: u32 = 4;
/// An obstacle that so many right angles in a row do not meet is lost.
const MOST_OPEN: u32 = 2;
/// Where a surface that no sonar heard is taken to be after a collision, metres ahead of the shell:
/// the distance of a virtual collision and the least way backed off.
const TOUCHED_M: f64 = 0.2;

/// What a trial remembers for its escapes.
#[derive(Clone, Debug, Default)]
pub(super) struct Escape {
    /// Least distance to the goal so far, metres.
    least_m: Option<f64>,
    /// Steps since then.
    without: u32,
    /// Collisions in a row.
    collisions: u32,
    /// An escape is under way.
    under_way: bool,
    /// Heading of the last step along an obstacle, radians, while one is followed.
    along_rad: Option<f64>,
    /// Steps in a row that found nothing where the obstacle should be.
    open: u32,
    /// Where collisions were during the escape.
    touched: Vec<Vec2>,
}

impl Escape {
    /// Surfaces known from collisions only, odometry frame, metres.
    pub(super) fn touched(&self) -> &[Vec2] {
        &self.touched
    }

    /// Counts a step at a distance from the goal; whether it is the least so far.
    fn comes_nearer(&mut self, distance_m: f64) -> bool {
        let nearer = self.least_m.is_none_or(|least_m| distance_m < least_m);
        if nearer {
            self.least_m = Some(distance_m);
        }
        self.without = if nearer { 0 } else { self.without.saturating_add(1) };
        nearer
    }

    fn end(&mut self) {
        self.under_way = false;
        self.along_rad = None;
        self.touched.clear();
    }

    /// The heading where the sweep for room begins: on the side of the obstacle, or to the goal while
    /// none is followed.
    fn begin_sweep(&mut self, goal_rad: f64, turn_rad: f64) -> f64 {
        if self.open >= MOST_OPEN {
            self.along_rad = None;
            self.open = 0;
        }
        self.along_rad.map_or(goal_rad, |along_rad| along_rad - RIGHT_ANGLE * turn_rad)
    }

    /// Takes the heading found after some turns. What makes the robot turn is an obstacle, from there
    /// on followed.
    fn take(&mut self, heading_rad: f64, turns: u32) {
        let follows = self.along_rad.is_some();
        self.open = if follows && turns == 0 { self.open + 1 } else { 0 };
        self.along_rad = (follows || turns > 0).then_some(heading_rad);
    }
}

impl Learner {
    /// The heading along the obstacle, radians; none while the robot makes progress. A scout (addition A6),
    /// of which it is told which way it turns, is always led: to the goal where there is room.
    pub(super) fn escape(&mut self, situation: &Situation<'_>, scout: Option<bool>) -> Option<f64> {
        if self.settings.escape_after == 0 && scout.is_none() {
            return None;
        }
        let pose = situation.observation.pose;
        let goal_rad = pose.heading_rad + situation.bearing_rad;
        let nearer = self.escape.comes_nearer(pose.distance_to(self.goal));
        if self.escape.under_way {
            if nearer && self.room(situation, ALONG_M).is_free(goal_rad) {
                self.escape.end();
            } else if situation.collided() {
                self.escape.touched.push(self.touched_at(pose));
            }
        }
        self.escape.collisions = if situation.collided() { self.escape.collisions + 1 } else { 0 };
        if scout.is_some() && !self.escape.under_way {
            if self.room(situation, ALONG_M).is_free(goal_rad) {
                return Some(goal_rad);
            }
            self.escape.under_way = true;
        }
        self.escape.under_way |= self.escape.without >= self.settings.escape_after
            || self.escape.collisions >= MOST_COLLISIONS;
        let trial = self.memory.first_success.unwrap_or(self.memory.trials + 1);
        let left = scout.unwrap_or(!trial.is_multiple_of(2));
        self.escape.under_way.then(|| self.follow(situation, goal_rad, left))
    }

    fn touched_at(&self, pose: Pose) -> Vec2 {
        pose.position() + unit(pose.heading_rad) * (self.robot.body().reach_m() + TOUCHED_M)
    }

    /// The first heading with room, counted from the side where the obstacle is; where none has, or what has
    /// ended in one collision after another, each in turn from collision to collision.
    fn follow(&mut self, situation: &Situation<'_>, goal_rad: f64, left: bool) -> f64 {
        let turn_rad = if left { FAN_RAD } else { -FAN_RAD };
        let first_rad = self.escape.begin_sweep(goal_rad, turn_rad);
        let room = self.room(situation, ALONG_M);
        let heading_rad = |turns: u32| wrap_angle(first_rad + f64::from(turns) * turn_rad);
        let free = (0..FAN).find(|turns| room.is_free(heading_rad(*turns)));
        let collisions = self.escape.collisions;
        let turns = free.filter(|_| collisions < MOST_COLLISIONS).unwrap_or(collisions % FAN);
        self.escape.take(heading_rad(turns), turns);
        heading_rad(turns)
    }
}
