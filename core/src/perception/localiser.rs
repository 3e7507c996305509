//! Odometry corrected by what the sonars heard in the same place before.
//!
//! NOTE (A10): the thesis trusts its odometry. Where it errs, a path that was learned is driven beside itself:
//! neither the heading that a neuron stores nor the place that a new one makes for is where it was. Here the
//! robot keeps what its sonars read along its ways, and where it comes by again, what they read now tells how
//! far it has drifted: an extended Kalman filter over the pose, predicted by odometry and corrected echo by echo.
//! Nothing is known of the world beforehand; the map is in the frame of the trial that first came by.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};

use crate::geometry::{Pose, Vec2, angle, rotate, unit, wrap_angle};
use crate::robot::{Readings, STRAIGHT_RAD};

// Tuned, up to where it is said otherwise.

/// Sightings are compared with what is heard up to this far from where they were made, metres.
const NEAR_M: f64 = 0.3;
/// A place farther than this from all sightings gets one of its own, metres.
const APART_M: f64 = 0.15;
/// So many sightings, the nearest ones, are compared with.
const COMPARED: usize = 2;
/// Echoes from farther are not compared, metres: a slight turn moves them much.
const FAR_M: f64 = 5.0;
/// Standard deviation of a reading against what a sighting lets expect: so much, metres,
const SPREAD_M: f64 = 0.02;
/// and so much of the reading.
const SPREAD: f64 = 0.02;

// Not tuned.

/// Neighbouring echoes that differ by more than this share come from different surfaces.
const SAME_SURFACE: f64 = 0.3;
/// What lies farther off than so many standard deviations is not what was heard then.
const GATE: f64 = 3.0;
/// A surface met at a greater slant tells nothing: cosine of the angle from its normal.
const GRAZING: f64 = 0.1;
/// No more sightings are kept.
const MOST: usize = 2000;

/// What the sonars read at a place, and where the robot took itself to be.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sighting {
    /// Pose in the map's frame.
    pub pose: Pose,
    /// Readings of an even ring, counter-clockwise from the heading, metres.
    pub sonar_m: Vec<f64>,
}

/// How a pose was found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Fix {
    /// The pose by odometry alone.
    pub odometry: Pose,
    /// Echoes that agreed with the nearest of what was heard here before; 0 where nothing was.
    pub echoes: u32,
    /// Standard deviation of the position, metres: the root of the sum of both variances.
    pub spread_m: f64,
}

/// A robot with an even ring of sonars that finds out where it is.
#[derive(Clone, Debug)]
pub struct Localiser {
    error: f64,
    range_m: f64,
    radius_m: f64,
    sightings: Vec<Sighting>,
    odometry: Pose,
    pose: Pose,
    covariance: Matrix3<f64>,
}

impl Localiser {
    /// A localiser of a robot whose odometry errs by a share of each rotation and advance, with sonars of
    /// a range that sit on a circle, both in metres, and what was sighted before.
    #[must_use]
    pub fn new(error: f64, range_m: f64, radius_m: f64, sightings: Vec<Sighting>) -> Self {
        let (odometry, pose, covariance) = Default::default();
        Self { error, range_m, radius_m, sightings, odometry, pose, covariance }
    }

    /// All that was sighted, the first first.
    #[must_use]
    pub fn sightings(&self) -> &[Sighting] {
        &self.sightings
    }

    /// The robot is put where it knows to be.
    pub fn begin(&mut self, odometry: Pose) {
        (self.odometry, self.pose, self.covariance) = (odometry, odometry, Matrix3::zeros());
    }

    /// Where the robot is after its odometry has come to a pose and its sonars have been read.
    pub fn locate(&mut self, odometry: Pose, sonar_m: &Readings) -> (Pose, Fix) {
        self.predict(odometry);
        let mut near: Vec<(f64, &Sighting)> = self
            .sightings
            .iter()
            .map(|sighting| (sighting.pose.distance_to(self.pose.position()), sighting))
            .filter(|(away_m, _)| *away_m < NEAR_M)
            .collect();
        near.sort_by(|a, b| a.0.total_cmp(&b.0));
        near.truncate(COMPARED);
        let is_new = near.first().is_none_or(|(away_m, _)| *away_m > APART_M);
        let mut estimate = Estimate { pose: self.pose, covariance: self.covariance };
        let mut agreed = Vec::with_capacity(COMPARED);
        for (_, sighting) in &near {
            // Two sightings of one place tell little more than one: each counts for its share.
            let echoes = self.expected(&estimate, sighting, sonar_m, near.len() as f64);
            agreed.push(estimate.correct(&echoes));
        }
        (self.pose, self.covariance) = (estimate.pose, estimate.covariance);
        if is_new && self.sightings.len() < MOST {
            self.sightings.push(Sighting { pose: self.pose, sonar_m: sonar_m.to_vec() });
        }
        let spread_m = (self.covariance[(0, 0)] + self.covariance[(1, 1)]).max(0.0).sqrt();
        let echoes = agreed.first().copied().unwrap_or(0);
        (self.pose, Fix { odometry, echoes, spread_m })
    }

    /// Moves the estimate as the odometry moved: a rotation, then an advance, each with its error.
    fn predict(&mut self, odometry: Pose) {
        let turned_rad = wrap_angle(odometry.heading_rad - self.odometry.heading_rad);
        let moved = odometry.position() - self.odometry.position();
        let off_rad = self.pose.heading_rad - self.odometry.heading_rad;
        let moved = rotate(moved, unit(off_rad));
        let here = self.pose.position() + moved;
        // Eq. (1.6), not linear: x(t+1|t) = f(x(t|t), u(t))
        self.pose = Pose::new(here.x, here.y, self.pose.heading_rad + turned_rad);
        self.odometry = odometry;
        let variance = |spread: f64| (self.error * spread) * (self.error * spread);
        self.covariance[(2, 2)] += variance(turned_rad) + variance(STRAIGHT_RAD);
        // Eq. (1.8): P(t+1|t) = φ P(t|t) φᵀ + G Q Gᵀ, with φ = ∂f/∂x: a heading that errs turns the advance.
        let turns = Matrix3::new(1.0, 0.0, -moved.y, 0.0, 1.0, moved.x, 0.0, 0.0, 1.0);
        let along = Vector3::new(moved.x, moved.y, 0.0) * self.error;
        self.covariance = turns * self.covariance * turns.transpose() + along * along.transpose();
    }

    /// The echoes of now that a sighting lets expect, with what it expects.
    fn expected(
        &self,
        estimate: &Estimate,
        sighting: &Sighting,
        sonar_m: &Readings,
        sharing: f64,
    ) -> Vec<Echo> {
        let sonars = sonar_m.len();
        let apart_rad = TAU / sonars as f64;
        let offset = estimate.pose.position() - sighting.pose.position();
        let is_echo = |reading_m: f64| reading_m < self.range_m.min(FAR_M);
        let echo = |(sonar, reading_m): (usize, &f64)| {
            // Between which of the echoes heard then this one lies.
            let ray = unit(estimate.pose.heading_rad + sonar as f64 * apart_rad);
            let bearing_rad = angle(offset + ray * (reading_m + self.radius_m));
            let between = wrap_angle(bearing_rad - sighting.pose.heading_rad) / apart_rad;
            let first = between.rem_euclid(sonars as f64) as usize % sonars;
            let (a_m, b_m) = (sighting.sonar_m[first], sighting.sonar_m[(first + 1) % sonars]);
            let same = (a_m - b_m).abs() <= SAME_SURFACE * a_m.min(b_m);
            if !(same && is_echo(a_m) && is_echo(b_m) && is_echo(*reading_m)) {
                return None;
            }
            // A flat surface through both echoes, n·p = D about where they were heard.
            let heard = |reading_m: f64, sonar: f64| {
                let direction_rad = sighting.pose.heading_rad + sonar * apart_rad;
                unit(direction_rad) * (reading_m + self.radius_m)
            };
            let (a, b) = (heard(a_m, first as f64), heard(b_m, first as f64 + 1.0));
            let normal = Vec2::new(b.y - a.y, a.x - b.x).normalize();
            let distance_m = normal.dot(&a) - normal.dot(&offset);
            // Along u it is D / (n·u) off.
            let towards = normal.dot(&ray);
            let expected_m = distance_m / towards - self.radius_m;
            if towards.abs() < GRAZING || expected_m <= 0.0 {
                return None;
            }
            let turning = normal.dot(&Vec2::new(-ray.y, ray.x));
            let spread_m = SPREAD_M + SPREAD * expected_m;
            Some(Echo {
                innovation_m: reading_m - expected_m,
                gradient: Vector3::new(
                    -normal.x / towards,
                    -normal.y / towards,
                    -distance_m * turning / (towards * towards),
                ),
                variance: spread_m * spread_m * sharing,
            })
        };
        sonar_m.iter().enumerate().filter_map(echo).collect()
    }
}

/// An echo, against what is expected at a pose.
struct Echo {
    /// Reading less what is expected, metres.
    innovation_m: f64,
    /// Change of what is expected with `x`, `y` (metres a metre) and heading (metres a radian).
    gradient: Vector3<f64>,
    /// Variance of the innovation at a pose that is known, square metres.
    variance: f64,
}

struct Estimate {
    pose: Pose,
    covariance: Matrix3<f64>,
}

impl Estimate {
    /// Takes echoes in, one after the other, and says how many agreed.
    fn correct(&mut self, echoes: &[Echo]) -> u32 {
        let mut agreed = 0;
        let mut shift = Vector3::zeros();
        for Echo { innovation_m, gradient, variance } in echoes {
            let innovation_m = innovation_m - gradient.dot(&shift);
            let spread = self.covariance * gradient;
            let total = gradient.dot(&spread) + variance;
            if innovation_m * innovation_m > GATE * GATE * total {
                continue;
            }
            // Eq. (1.7): K = P Hᵀ (H P Hᵀ + R)⁻¹, with H = ∂z/∂x and one echo as z
            let gain = spread / total;
            // Eq. (1.5): x(t|t) = x(t|t-1) + K (z − ẑ)
            shift += gain * innovation_m;
            // NOTE: as in the linear filter, P(t|t) = P(t|t-1) − K H P(t|t-1); the thesis lost an index.
            self.covariance -= gain * spread.transpose();
            agreed += 1;
        }
        let here = self.pose.position() + Vec2::new(shift.x, shift.y);
        self.pose = Pose::new(here.x, here.y, self.pose.heading_rad + shift.z);
        agreed
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use proptest::prelude::*;

    use super::*;

    const SONARS: u32 = 24;
    const RADIUS_M: f64 = 0.265;

    /// What sonars without a cone read in a room from (-2, -1.5) to (3, 2), whose walls are moved out.
    fn sense(pose: Pose, moved_m: f64) -> Readings {
        let read = |sonar: u32| {
            let ray = unit(pose.heading_rad + TAU * f64::from(sonar) / f64::from(SONARS));
            let to = |at: f64, along: f64, low: f64, high: f64| {
                let wall = if along > 0.0 { high + moved_m } else { low - moved_m };
                if along.abs() < 1e-12 { f64::INFINITY } else { (wall - at) / along }
            };
            to(pose.x_m, ray.x, -2.0, 3.0).min(to(pose.y_m, ray.y, -1.5, 2.0)) - RADIUS_M
        };
        (0..SONARS).map(read).collect()
    }

    /// A localiser that has seen the room from the origin, and begins there anew.
    fn localiser(error: f64) -> Localiser {
        let mut localiser = Localiser::new(error, 8.0, RADIUS_M, Vec::new());
        localiser.begin(Pose::default());
        localiser.locate(Pose::default(), &sense(Pose::default(), 0.0));
        localiser.begin(Pose::default());
        localiser
    }

    /// A step of 0.2 m to the east by odometry.
    const STEP: Pose = Pose { x_m: 0.2, y_m: 0.0, heading_rad: 0.0 };

    proptest! {
        #[test]
        fn what_was_heard_before_tells_where_the_robot_is(
            advanced_m in 0.14..0.26f64, turned_rad in -0.06..0.06f64,
        ) {
            let to = unit(turned_rad) * advanced_m;
            let truly = Pose::new(to.x, to.y, turned_rad);
            let (found, fix) = localiser(0.2).locate(STEP, &sense(truly, 0.0));
            prop_assert_eq!(fix.odometry, STEP);
            prop_assert!(fix.echoes > 12, "{} echoes", fix.echoes);
            let off_m = |pose: Pose| pose.distance_to(truly.position());
            prop_assert!(off_m(found) < 0.2 * off_m(STEP) + 0.012, "{} of {} m", off_m(found), off_m(STEP));
            let off_rad = (found.heading_rad - turned_rad).abs();
            prop_assert!(off_rad < 0.2 * turned_rad.abs() + 0.012, "{} of {} rad", off_rad, turned_rad);
        }
    }

    proptest! {
        #[test]
        fn nothing_that_can_be_heard_loses_the_robot(
            heard_m in prop::collection::vec(prop::collection::vec(0.0..=8.0f64, 24), 2..6),
            turned_rad in prop::collection::vec(-3.0..3.0f64, 6), advanced_m in -0.2..0.2f64,
        ) {
            let mut localiser = Localiser::new(0.2, 8.0, RADIUS_M, Vec::new());
            localiser.begin(Pose::default());
            let mut odometry = Pose::default();
            for (sonar_m, turned_rad) in heard_m.into_iter().zip(turned_rad) {
                let heading_rad = odometry.heading_rad + turned_rad;
                let here = odometry.position() + unit(heading_rad) * advanced_m;
                odometry = Pose::new(here.x, here.y, heading_rad);
                let (found, fix) = localiser.locate(odometry, &Readings::from_iter(sonar_m));
                let off_m = found.distance_to(odometry.position());
                prop_assert!(off_m.is_finite() && off_m < 1.5, "{off_m} m off");
                prop_assert!(found.heading_rad.is_finite() && fix.spread_m.is_finite());
            }
        }
    }

    #[test]
    fn what_was_not_there_before_tells_nothing() {
        let (found, fix) = localiser(0.01).locate(STEP, &sense(STEP, 0.5));
        assert_eq!(fix.echoes, 0, "every wall is half a metre farther off");
        assert_eq!(found, STEP);
    }

    #[test]
    fn a_place_is_sighted_once_and_the_first_time_says_where_it_is() {
        let mut localiser = localiser(0.01);
        let east = |x_m| Pose { x_m, y_m: 0.0, heading_rad: 0.0 };
        for x_m in [0.0, 0.1, 0.2, 0.3, 0.4] {
            localiser.locate(east(x_m), &sense(east(x_m), 0.0));
        }
        let sighted: Vec<f64> = localiser.sightings().iter().map(|s| s.pose.x_m).collect();
        assert_eq!(sighted.len(), 3, "0.15 m apart: {sighted:?}");
        for (found, expected) in sighted.iter().zip([0.0, 0.2, 0.4]) {
            assert!((found - expected).abs() < 0.01, "{sighted:?}");
        }
    }

    #[test]
    fn without_anything_heard_before_odometry_is_believed_and_doubt_grows() {
        let mut localiser = Localiser::new(0.01, 8.0, RADIUS_M, Vec::new());
        localiser.begin(Pose::default());
        let mut doubt_m = -1.0;
        for step in 0..10 {
            let pose = Pose::new(0.5 * f64::from(step), 0.0, 0.0);
            let (found, fix) = localiser.locate(pose, &sense(Pose::default(), 0.0));
            assert_eq!((found, fix.echoes), (pose, 0));
            assert!(fix.spread_m > doubt_m);
            doubt_m = fix.spread_m;
        }
        // Along: 9 advances of 0.5 m, each by 1 %; across: headings by 0.002 rad a step, added up and up. The
        // first call adds no advance, but a heading.
        let along = 9.0 * (0.01f64 * 0.5).powi(2);
        let across: f64 = (1..=9).map(|k| (0.5 * 0.002 * f64::from(10 - k)).powi(2)).sum();
        let first = (0.5 * 0.002 * 9.0f64).powi(2);
        assert!((doubt_m - (along + across + first).sqrt()).abs() < 1e-9, "{doubt_m}");
    }
}
