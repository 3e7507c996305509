//! What the sonars of one place show of the ground around it.

use crate::geometry::{Pose, Vec2, rotate, unit, wrap_angle};
use crate::robot::{Readings, Robot};

/// Slack on a direction that lies on the edge of a cone, radians.
const SLACK_RAD: f64 = 1e-9;

/// Slack on what is too far off a way to count, metres; far above rounding.
pub(super) const SLACK_M: f64 = 1e-6;

/// Where in its cone an echo is taken to come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Cone {
    /// From its axis: what is likely, for plans.
    Axis,
    /// From anywhere in it, so from its edges, too: what is possible, for the next step.
    Whole,
}

/// How sonars hear.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hearing {
    /// Greatest reading, metres; it is no echo.
    pub(super) range_m: f64,
    /// Full angle of a cone, radians.
    pub(super) cone_rad: f64,
    /// Where in it an echo comes from.
    pub(super) cone: Cone,
}

/// The echoes heard at one believed pose, as points in the odometry frame.
#[derive(Clone, Debug)]
pub(super) struct Echoes<'a> {
    robot: &'a Robot,
    pose: Pose,
    sonar_m: &'a Readings,
    hearing: Hearing,
    points: Vec<Vec2>,
}

impl<'a> Echoes<'a> {
    /// The echoes of a robot's sonars; a reading of the full range is no echo.
    pub(super) fn new(
        robot: &'a Robot,
        pose: Pose,
        sonar_m: &'a Readings,
        hearing: Hearing,
    ) -> Self {
        let points = Vec::with_capacity(sonar_m.len());
        let mut echoes = Self { robot, pose, sonar_m, hearing, points };
        echoes.hear(pose, sonar_m, hearing.range_m);
        echoes
    }

    /// Adds the echoes heard from a pose at less than a range.
    pub(super) fn hear(&mut self, pose: Pose, sonar_m: &Readings, range_m: f64) {
        let (direction, half_rad) = (pose.direction(), self.hearing.cone_rad / 2.0);
        for (mount, reading_m) in self.robot.sonars().iter().zip(sonar_m.iter()) {
            if *reading_m < range_m {
                let place = pose.position() + rotate(mount.place, direction);
                let axis_rad = pose.heading_rad + mount.axis_rad;
                let echo = |off_rad: f64| place + unit(axis_rad + off_rad) * *reading_m;
                self.points.push(echo(0.0));
                if self.hearing.cone == Cone::Whole {
                    self.points.extend([echo(-half_rad), echo(half_rad)]);
                }
            }
        }
    }

    /// Adds places where something was heard elsewhere.
    pub(super) fn add(&mut self, places: &[Vec2]) {
        self.points.extend(places);
    }

    /// Where the echoes may have come from, odometry frame, metres.
    pub(super) fn into_points(self) -> Vec<Vec2> {
        self.points
    }

    /// Adds a place where something was touched.
    pub(super) fn touch(&mut self, place: Vec2) {
        self.points.push(place);
    }

    /// Distance of the body, as it is outlined, to the nearest echo when it stands at a place with a
    /// heading, metres.
    pub(super) fn outline_m(&self, at: Vec2, heading_rad: f64) -> f64 {
        let (body, direction) = (self.robot.body(), unit(heading_rad));
        let distances = self.points.iter().map(|echo| body.distance_m(at, direction, *echo));
        distances.fold(f64::INFINITY, f64::min)
    }

    /// Where they were heard.
    pub(super) fn from(&self) -> Vec2 {
        self.pose.position()
    }

    /// Way that the sonar looking in a direction shows free, metres; 0 where none looks.
    pub(super) fn free_m(&self, direction_rad: f64) -> f64 {
        let bearing_rad = direction_rad - self.pose.heading_rad;
        let mut least = (self.hearing.cone_rad / 2.0 + SLACK_RAD, 0.0);
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
        clearance_m(&self.points, at, self.robot.body().reach_m())
    }
}

/// The echoes that lie near a straight way; all others are farther from any place on it than asked.
pub(super) struct Beside {
    points: Vec<Vec2>,
    /// Radius of the circle in which the body turns, metres.
    reach_m: f64,
}

impl Beside {
    /// The echoes of some views to which the body may come as near as a clearance in metres, on the
    /// way from a place along a unit vector.
    pub(super) fn new(
        views: &[&Echoes<'_>],
        from: Vec2,
        direction: Vec2,
        length_m: f64,
        clearance_m: f64,
    ) -> Self {
        let reach_m = views.iter().map(|view| view.robot.body().reach_m()).fold(0.0, f64::max);
        let near_m = reach_m + clearance_m + SLACK_M;
        let is_near = |echo: Vec2| {
            let offset = echo - from;
            let along = direction.dot(&offset);
            let across = direction.x * offset.y - direction.y * offset.x;
            (across.abs() <= near_m) & (along >= -near_m) & (along <= length_m + near_m)
        };
        // Without a branch for each echo: every place is written, and kept by counting on.
        let mut points = vec![Vec2::zeros(); views.iter().map(|view| view.points.len()).sum()];
        let mut count = 0;
        for echo in views.iter().flat_map(|view| &view.points) {
            points[count] = *echo;
            count += usize::from(is_near(*echo));
        }
        points.truncate(count);
        Self { points, reach_m }
    }

    /// Distance of the body, as the circle it turns in, to the nearest of these echoes when it
    /// stands at a place on the way, metres.
    pub(super) fn clearance_m(&self, at: Vec2) -> f64 {
        clearance_m(&self.points, at, self.reach_m)
    }
}

/// Distance of a circle round a place to the nearest of some points, metres.
fn clearance_m(points: &[Vec2], at: Vec2, radius_m: f64) -> f64 {
    // Lanes side by side: a least value does not depend on the order in which it is taken.
    let mut nearest = [f64::INFINITY; 4];
    for four in points.chunks(nearest.len()) {
        for (least, point) in nearest.iter_mut().zip(four) {
            let squared = (point - at).norm_squared();
            *least = if squared < *least { squared } else { *least };
        }
    }
    nearest.into_iter().fold(f64::INFINITY, f64::min).sqrt() - radius_m
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use proptest::prelude::*;

    use super::*;
    use crate::robot::examples::b21;

    fn hearing(range_m: f64, cone: Cone) -> Hearing {
        Hearing { range_m, cone_rad: 15f64.to_radians(), cone }
    }

    proptest! {
        #[test]
        fn what_lies_beside_a_way_tells_all_that_is_near(
            near_m in prop::collection::vec(0.2..4.0f64, 24), far_m in prop::collection::vec(0.2..4.0f64, 24),
            x in -1.0..1.0f64, y in -1.0..1.0f64, heading_rad in -3.0..3.0f64, length_m in 0.0..4.0f64,
            asked_m in 0.01..0.6f64, share in 0.0..=1.0f64,
        ) {
            let robot = b21();
            let readings = [near_m, far_m].map(Readings::from_iter);
            let hearing = hearing(3.0, Cone::Whole);
            let poses = [Pose::new(0.0, 0.0, 0.3), Pose::new(x, y, heading_rad)];
            let views = [0, 1].map(|k| Echoes::new(&robot, poses[k], &readings[k], hearing));
            let (from, direction) = (Vec2::new(y, x), unit(2.0 * heading_rad));
            let beside = Beside::new(&[&views[0], &views[1]], from, direction, length_m, asked_m);
            let at = from + direction * (share * length_m);
            let all_m = views[0].clearance_m(at).min(views[1].clearance_m(at));
            // What is asked for is told to the bit, and what is farther is told to be farther.
            if all_m <= asked_m {
                prop_assert_eq!(beside.clearance_m(at), all_m);
            } else {
                prop_assert!(beside.clearance_m(at) > asked_m);
            }
        }
    }

    #[test]
    fn a_wall_ahead_is_as_far_as_its_sonar_says() {
        let robot = b21();
        let mut sonar_m = Readings::from_iter([8.0; 24]);
        sonar_m[0] = 1.0;
        // Heading north, so the sonar ahead looks along y.
        let pose = Pose::new(1.0, 2.0, FRAC_PI_2);
        let hearing = |cone| hearing(8.0, cone);
        let echoes = Echoes::new(&robot, pose, &sonar_m, hearing(Cone::Axis));
        assert!((echoes.free_m(FRAC_PI_2) - 1.0).abs() < 1e-12);
        assert!((echoes.free_m(FRAC_PI_2 + 0.2) - 8.0).abs() < 1e-12, "the sonar to its left");
        assert!((echoes.free_m(-PI) - 8.0).abs() < 1e-12, "the sonar to the west");
        for (ahead_m, expected_m) in [(0.0, 1.0), (0.5, 0.5), (1.0, 0.0)] {
            let found_m = echoes.clearance_m(Vec2::new(1.0, 2.0 + ahead_m));
            assert!((found_m - expected_m).abs() < 1e-12, "{ahead_m}: {found_m}");
        }
        // From an edge of the cone it would be nearer from afar.
        let whole = Echoes::new(&robot, pose, &sonar_m, hearing(Cone::Whole));
        let (radius_m, edge_rad) = (robot.body().reach_m(), 7.5f64.to_radians());
        let edge_m = (radius_m + edge_rad.cos()).hypot(edge_rad.sin()) - radius_m;
        assert!((whole.clearance_m(pose.position()) - edge_m).abs() < 1e-12);
        let silent = Readings::from_iter([8.0; 24]);
        let none = Echoes::new(&robot, pose, &silent, hearing(Cone::Whole));
        assert!(none.clearance_m(pose.position()).is_infinite());
    }
}
