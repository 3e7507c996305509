//! What the sonars of one place show of the ground around it.

use crate::geometry::{Pose, Vec2, rotate, unit, wrap_angle};
use crate::robot::{Readings, Robot};

/// Where in its cone an echo may have come from, in half cones.
const IN_CONE: [f64; 3] = [-1.0, 0.0, 1.0];

/// Slack on a direction that lies on the edge of a cone, radians.
const SLACK_RAD: f64 = 1e-9;

/// The echoes heard at one believed pose, as points in the odometry frame.
#[derive(Clone, Debug)]
pub(super) struct Echoes<'a> {
    robot: &'a Robot,
    pose: Pose,
    sonar_m: &'a Readings,
    half_cone_rad: f64,
    points: Vec<Vec2>,
}

impl<'a> Echoes<'a> {
    /// The echoes of a robot's sonars; a reading of the full range is no echo.
    pub(super) fn new(
        robot: &'a Robot,
        pose: Pose,
        sonar_m: &'a Readings,
        range_m: f64,
        cone_rad: f64,
    ) -> Self {
        let half_cone_rad = cone_rad / 2.0;
        let mut points = Vec::with_capacity(IN_CONE.len() * sonar_m.len());
        let direction = pose.direction();
        for (mount, reading_m) in robot.sonars().iter().zip(sonar_m.iter()) {
            if *reading_m < range_m {
                let place = pose.position() + rotate(mount.place, direction);
                let axis_rad = pose.heading_rad + mount.axis_rad;
                points.extend(
                    IN_CONE.map(|edge| place + unit(axis_rad + edge * half_cone_rad) * *reading_m),
                );
            }
        }
        Self { robot, pose, sonar_m, half_cone_rad, points }
    }

    /// Where they were heard.
    pub(super) fn from(&self) -> Vec2 {
        self.pose.position()
    }

    /// Way that the sonar looking in a direction shows free, metres; 0 where none looks.
    pub(super) fn free_m(&self, direction_rad: f64) -> f64 {
        let bearing_rad = direction_rad - self.pose.heading_rad;
        let mut least = (self.half_cone_rad + SLACK_RAD, 0.0);
        for (mount, reading_m) in self.robot.sonars().iter().zip(self.sonar_m.iter()) {
            let off_rad = wrap_angle(bearing_rad - mount.axis_rad).abs();
            if off_rad < least.0 {
                least = (off_rad, *reading_m);
            }
        }
        least.1
    }

    /// Distance of the body, as the circle it turns in, to the nearest echo when it stands at a
    /// place, metres.
    pub(super) fn clearance_m(&self, at: Vec2) -> f64 {
        let nearest = self.points.iter().map(|echo| (echo - at).norm_squared());
        nearest.fold(f64::INFINITY, f64::min).sqrt() - self.robot.body().reach_m()
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use super::*;
    use crate::robot::examples::b21;

    #[test]
    fn a_wall_ahead_is_as_far_as_its_sonar_says() {
        let robot = b21();
        let mut sonar_m = Readings::from_iter([8.0; 24]);
        sonar_m[0] = 1.0;
        // Heading north, so the sonar ahead looks along y.
        let pose = Pose::new(1.0, 2.0, FRAC_PI_2);
        let echoes = Echoes::new(&robot, pose, &sonar_m, 8.0, 15f64.to_radians());
        assert!((echoes.free_m(FRAC_PI_2) - 1.0).abs() < 1e-12);
        assert!((echoes.free_m(FRAC_PI_2 + 0.2) - 8.0).abs() < 1e-12, "the sonar to its left");
        assert!((echoes.free_m(-PI) - 8.0).abs() < 1e-12, "the sonar to the west");
        // The echo may have come from the axis, 1 m from the shell, or from an edge of the cone, which is
        // the nearer one from afar.
        let (radius_m, edge_rad) = (robot.body().reach_m(), 7.5f64.to_radians());
        let edge_m = (radius_m + edge_rad.cos()).hypot(edge_rad.sin()) - radius_m;
        for (ahead_m, expected_m) in [(0.0, edge_m), (0.5, 0.5), (1.0, 0.0)] {
            let found_m = echoes.clearance_m(Vec2::new(1.0, 2.0 + ahead_m));
            assert!((found_m - expected_m).abs() < 1e-12, "{ahead_m}: {found_m}");
        }
        let silent = Readings::from_iter([8.0; 24]);
        let none = Echoes::new(&robot, pose, &silent, 8.0, 15f64.to_radians());
        assert!(none.clearance_m(pose.position()).is_infinite());
    }
}
