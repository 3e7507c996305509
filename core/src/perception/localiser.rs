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

use crate::geometry::{Pose, Vec2, rotate, unit, wrap_angle};
use crate::robot::Readings;

/// Sightings are compared with what is heard up to this far from where they were made, metres.
const NEAR_M: f64 = 0.3;
/// A place farther than this from all sightings gets one of its own, metres.
const APART_M: f64 = 0.15;
/// So many sightings, the nearest ones, are compared with.
const COMPARED: usize = 2;
/// No more sightings are kept.
const MOST: usize = 2000;
/// Echoes from farther are not compared, metres: a slight turn moves them much.
const FAR_M: f64 = 5.0;
/// Standard deviation of a reading against what a sighting lets expect: so much, metres,
const SPREAD_M: f64 = 0.02;
/// and so much of the reading. Tuned, as are the five above.
const SPREAD: f64 = 0.02;
/// Neighbouring echoes that differ by more than this share come from different surfaces.
const SAME_SURFACE: f64 = 0.3;
/// What lies farther off than so many standard deviations is not what was heard then.
const GATE: f64 = 3.0;
/// Share of the odometry's error by which a heading errs in a step without a rotation, radians.
const STRAIGHT_RAD: f64 = 0.2;

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
    /// Echoes that agreed with what was heard here before; 0 where nothing was.
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
        let mut estimate = Estimate { pose: self.pose, covariance: self.covariance, echoes: 0 };
        for (_, sighting) in &near {
            // Two sightings of one place tell little more than one: each counts for its share.
            let echoes = self.expected(&estimate, sighting, sonar_m, near.len() as f64);
            estimate.correct(&echoes);
        }
        (self.pose, self.covariance) = (estimate.pose, estimate.covariance);
        if is_new && self.sightings.len() < MOST {
            self.sightings.push(Sighting { pose: self.pose, sonar_m: sonar_m.to_vec() });
        }
        let spread_m = (self.covariance[(0, 0)] + self.covariance[(1, 1)]).max(0.0).sqrt();
        (self.pose, Fix { odometry, echoes: estimate.echoes, spread_m })
    }

    /// Moves the estimate as the odometry moved: a rotation, then an advance, each with its error.
    fn predict(&mut self, odometry: Pose) {
        let turned_rad = wrap_angle(odometry.heading_rad - self.odometry.heading_rad);
        let moved = odometry.position() - self.odometry.position();
        let off_rad = self.pose.heading_rad - self.odometry.heading_rad;
        let moved = rotate(moved, unit(off_rad));
        let here = self.pose.position() + moved;
        self.pose = Pose::new(here.x, here.y, self.pose.heading_rad + turned_rad);
        self.odometry = odometry;
        let variance = |spread: f64| (self.error * spread) * (self.error * spread);
        self.covariance[(2, 2)] += variance(turned_rad) + variance(STRAIGHT_RAD);
        // P ← F P Fᵀ + Q: a heading that errs turns the advance.
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
        let turned = (estimate.pose.heading_rad - sighting.pose.heading_rad) / apart_rad;
        let is_echo = |reading_m: f64| reading_m < self.range_m.min(FAR_M);
        let echo = |(sonar, reading_m): (usize, &f64)| {
            let between = (sonar as f64 + turned).rem_euclid(sonars as f64);
            let (first, share) = (between as usize % sonars, between.fract());
            let (a_m, b_m) = (sighting.sonar_m[first], sighting.sonar_m[(first + 1) % sonars]);
            let same = (a_m - b_m).abs() <= SAME_SURFACE * a_m.min(b_m);
            if !(same && is_echo(a_m) && is_echo(b_m) && is_echo(*reading_m)) {
                return None;
            }
            let then_m = a_m + share * (b_m - a_m);
            // A flat surface in the direction φ reads r(φ) with r' / r = tan ψ, where ψ is the angle from its
            // normal to φ; a displacement d brings it nearer by d·n / cos ψ.
            let slope = (b_m - a_m) / apart_rad;
            let incidence_rad = libm::atan2(slope, then_m + self.radius_m);
            let direction_rad = estimate.pose.heading_rad + sonar as f64 * apart_rad;
            let normal = unit(direction_rad - incidence_rad) / libm::cos(incidence_rad);
            let spread_m = SPREAD_M + SPREAD * then_m;
            Some(Echo {
                innovation_m: reading_m - (then_m - offset.dot(&normal)),
                gradient: Vector3::new(-normal.x, -normal.y, slope),
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
    echoes: u32,
}

impl Estimate {
    /// Takes echoes in, one after the other.
    fn correct(&mut self, echoes: &[Echo]) {
        let mut shift = Vector3::zeros();
        for Echo { innovation_m, gradient, variance } in echoes {
            let innovation_m = innovation_m - gradient.dot(&shift);
            let spread = self.covariance * gradient;
            let total = gradient.dot(&spread) + variance;
            if innovation_m * innovation_m > GATE * GATE * total {
                continue;
            }
            // K = P h / (hᵀ P h + r), x ← x + K ν, P ← P − K hᵀ P
            let gain = spread / total;
            shift += gain * innovation_m;
            self.covariance -= gain * spread.transpose();
            self.echoes += 1;
        }
        let here = self.pose.position() + Vec2::new(shift.x, shift.y);
        self.pose = Pose::new(here.x, here.y, self.pose.heading_rad + shift.z);
    }
}
