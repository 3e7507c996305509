//! Room for the next step, as the echoes show it, and the step aside (addition A4).

use std::f64::consts::FRAC_PI_2;

use super::{Learner, Situation};
use crate::geometry::{Pose, unit, wrap_angle};
use crate::learner::echoes::{Cone, Echoes, SLACK_M};

/// Directions tried lie this far apart, radians: as the sonars of the ring do.
pub(super) const FAN_RAD: f64 = FRAC_PI_2 / 6.0;
/// Directions tried to either side, up to a right angle.
const ASIDE: u32 = 6;
/// Steps whose near echoes a robot without a ring remembers: it does not see what is beside it.
const REMEMBERED: usize = 20;
/// Echoes are remembered up to here, metres: the farther off, the less a cone tells where it was.
const NEAR_M: f64 = 0.5;
/// Shares of a rotation, and of the advance after it, at which the room is looked at.
const SHARES: [f64; 2] = [0.5, 1.0];

/// What the robot takes to be around it.
pub(super) struct Room<'a> {
    echoes: Echoes<'a>,
    pose: Pose,
    advance_m: f64,
    /// Clearance asked for, metres.
    least_m: f64,
}

impl Room<'_> {
    /// Whether turning to a heading and advancing keeps the clearance asked for, or where there is
    /// less, does not lessen it.
    pub(super) fn is_free(&self, heading_rad: f64) -> bool {
        let here = self.pose.position();
        let rotation_rad = wrap_angle(heading_rad - self.pose.heading_rad);
        let clearance_m = |at, heading_rad| self.echoes.outline_m(at, heading_rad);
        let asked_m = self.least_m.min(clearance_m(here, self.pose.heading_rad));
        let turns = |share: &f64| {
            clearance_m(here, self.pose.heading_rad + share * rotation_rad) >= asked_m
        };
        let advances = |share: &f64| {
            let at = here + unit(heading_rad) * (share * self.advance_m);
            clearance_m(at, heading_rad) >= asked_m
        };
        SHARES.iter().all(advances) && SHARES.iter().all(turns)
    }
}

impl Learner {
    /// What is around the robot, with a clearance asked for.
    pub(super) fn room<'a>(&'a self, situation: &'a Situation<'_>, least_m: f64) -> Room<'a> {
        let observation = situation.observation;
        let (pose, advance_m) = (observation.pose, self.settings.advance_m);
        // What no sonar hears up to here is farther than asked for from every place that is looked at.
        let matters_m = self.robot.reading_beyond_m(least_m + advance_m) + SLACK_M;
        let mut echoes =
            self.settings.echoes(&self.robot, pose, &observation.sonar_m, matters_m, Cone::Whole);
        if !self.robot.has_even_ring() {
            for past in self.path.iter().rev().take(REMEMBERED) {
                echoes.hear(past.pose, &past.sonar_m, NEAR_M);
            }
        }
        for place in self.escape.touched() {
            echoes.touch(*place);
        }
        Room { echoes, pose, advance_m, least_m }
    }

    /// NOTE (A4): the thesis lets the winner act whatever the sonars say, and pays for the collision;
    /// here the heading nearest to its own that leaves room for the next step is taken, once a trial
    /// has succeeded. None when its own does, or no other is better.
    pub(super) fn sidestep(&self, situation: &Situation<'_>, heading_rad: f64) -> Option<f64> {
        if self.settings.sidestep_m <= 0.0 || self.memory.best.is_none() {
            return None;
        }
        let room = self.room(situation, self.settings.sidestep_m);
        if room.is_free(heading_rad) {
            return None;
        }
        let aside = (1..=ASIDE).map(f64::from).flat_map(|k| [k * FAN_RAD, -k * FAN_RAD]);
        aside.map(|by_rad| wrap_angle(heading_rad + by_rad)).find(|turned| room.is_free(*turned))
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::control::Reflex;
    use crate::experiment::Settings;
    use crate::geometry::Vec2;
    use crate::learner::{LearnerSettings, Observation};
    use crate::rng::{Purpose, stream};
    use crate::robot::{Contact, Readings, examples::b21};

    #[test]
    fn an_echo_may_come_from_the_edge_of_its_cone() {
        let (settings, robot) = (Settings::default(), Arc::new(b21()));
        let learner = Learner::new(
            LearnerSettings::from(&settings),
            Arc::clone(&robot),
            Reflex::new(settings.reflex(), robot.sonars()),
            1,
            Vec2::new(3.0, 0.0),
            stream(1, 0, Purpose::Exploration),
        );
        let least_m = 0.15;
        let is_free = |reading_m: f64| {
            let mut sonar_m = Readings::from_iter([8.0; 24]);
            // 30° to the left of the way.
            sonar_m[2] = reading_m;
            let pose = Pose::default();
            let observation = Observation { sonar_m, pose, region: 0, contact: Contact::None };
            let situation = learner.situate(&observation);
            learner.room(&situation, least_m).is_free(0.0)
        };
        let radius_m = robot.body().reach_m();
        let end = Vec2::new(learner.settings.advance_m, 0.0);
        let clearance_m = |reading_m: f64, edge_deg: f64| {
            let place = unit(30f64.to_radians()) * radius_m;
            let echo = place + unit((30.0 + edge_deg).to_radians()) * reading_m;
            (echo - end).norm() - radius_m
        };
        // From the axis there would be room, from the near edge there is none; and 5 cm farther there is.
        assert!(clearance_m(0.32, 0.0) > least_m && clearance_m(0.32, -7.5) < least_m);
        assert!(!is_free(0.32));
        assert!(clearance_m(0.37, -7.5) > least_m && is_free(0.37));
    }
}
