//! A drive with inertia: velocities follow their commands with a lag, and no faster than they can.
//!
//! NOTE: the thesis speaks of "a simplified dynamics to account for the inertia of the robot" (section 2.9)
//! and prints no equation; this one is ours.

use super::DriveSpec;
use crate::geometry::{Pose, Vec2};

/// What a controller wants.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Command {
    /// Velocity along the heading, m/s; below 0 backwards.
    pub v_m_s: f64,
    /// Turn, rad/s, to the left above 0.
    pub w_rad_s: f64,
}

/// Where a robot is and how it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drive {
    /// Where it is.
    pub pose: Pose,
    /// How fast it is.
    pub speed: Command,
    time_constant_s: f64,
    acceleration_m_s2: f64,
    turn_acceleration_rad_s2: f64,
}

impl Drive {
    /// A robot that stands at a pose.
    #[must_use]
    pub fn new(spec: &DriveSpec, pose: Pose) -> Self {
        Self {
            pose,
            speed: Command::default(),
            time_constant_s: spec.time_constant_s,
            acceleration_m_s2: spec.acceleration_m_s2,
            turn_acceleration_rad_s2: spec.turn_acceleration_deg_s2.to_radians(),
        }
    }

    /// Where it is after a time in seconds, if nothing is in its way.
    #[must_use]
    pub fn after(&self, command: Command, dt_s: f64) -> Self {
        let follow = |now: f64, wanted: f64, most: f64| {
            now + ((wanted - now) / self.time_constant_s).clamp(-most, most) * dt_s
        };
        let v_m_s = follow(self.speed.v_m_s, command.v_m_s, self.acceleration_m_s2);
        let w_rad_s = follow(self.speed.w_rad_s, command.w_rad_s, self.turn_acceleration_rad_s2);
        let speed = Command { v_m_s, w_rad_s };
        Self { pose: moved(self.pose, speed, dt_s), speed, ..*self }
    }
}

/// A pose after a time at a constant speed: along the middle of the arc.
fn moved(pose: Pose, speed: Command, dt_s: f64) -> Pose {
    let turned_rad = speed.w_rad_s * dt_s;
    let along = crate::geometry::unit(pose.heading_rad + 0.5 * turned_rad);
    let place: Vec2 = pose.position() + along * (speed.v_m_s * dt_s);
    Pose::new(place.x, place.y, pose.heading_rad + turned_rad)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPEC: DriveSpec =
        DriveSpec { time_constant_s: 0.3, acceleration_m_s2: 0.25, turn_acceleration_deg_s2: 40.0 };

    #[test]
    fn a_velocity_follows_its_command_within_the_limits() {
        let command = Command { v_m_s: 0.15, w_rad_s: 0.0 };
        let mut drive = Drive::new(&SPEC, Pose::default());
        for step in 1..=200 {
            let before = drive.speed.v_m_s;
            drive = drive.after(command, 0.025);
            let gained = (drive.speed.v_m_s - before) / 0.025;
            let expected = ((0.15 - before) / 0.3).min(0.25);
            assert!((gained - expected).abs() < 1e-12, "step {step}: {gained} {expected}");
        }
        assert!((drive.speed.v_m_s - 0.15).abs() < 1e-6);
    }

    #[test]
    fn a_constant_speed_drives_a_circle() {
        let speed = Command { v_m_s: 0.1, w_rad_s: 0.1 };
        let mut drive = Drive { speed, ..Drive::new(&SPEC, Pose::default()) };
        for _ in 0..400 {
            drive = drive.after(speed, 0.025);
        }
        // One radian of a circle of radius 1 m.
        let expected = Pose::new(1_f64.sin(), 1.0 - 1_f64.cos(), 1.0);
        assert!(drive.pose.distance_to(expected.position()) < 1e-5, "{drive:?}");
        assert!((drive.pose.heading_rad - 1.0).abs() < 1e-9);
    }
}
