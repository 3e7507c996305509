//! The input vector of section 5.4: normalised sonars and 8 distance units.
//!
//! It has room for the most sonars a robot may have. With fewer, zeros stand at its end, which change no
//! distance: the same 32 lanes serve every robot.

use crate::geometry::Pose;
use crate::robot::MOST_SONARS;

/// Number of distance units.
pub const DISTANCE_UNITS: usize = 8;

/// Greatest number of inputs.
pub const INPUTS: usize = MOST_SONARS + DISTANCE_UNITS;

/// The input vector `x`, Eq. (5.5): sonars, distance units, zeros.
pub type Input = [f64; INPUTS];

/// Centres `μ_i` of the eight processing units, Eq. (5.4) and fig. 5.3.
const UNITS: [f64; DISTANCE_UNITS] =
    [0.0625, 0.1875, 0.3125, 0.4375, 0.5625, 0.6875, 0.8125, 0.9375];

crate::choice! {
    /// Frame in which the sonars enter the input.
    pub enum SonarFrame {
        Robot = "robot": "counter-clockwise from the heading; the B21 has no turret",
        Odometry = "odometry": "shifted by whole sonars against the heading: a virtual turret",
    }
}

/// How readings are normalised.
#[derive(Clone, Debug, PartialEq)]
pub struct InputSettings {
    /// Reading that becomes 1, metres.
    pub sonar_span_m: f64,
    /// Distance to the goal that becomes 1, metres.
    pub distance_span_m: f64,
    /// Frame of the sonars.
    pub sonar_frame: SonarFrame,
}

impl InputSettings {
    /// The input at a situation.
    #[must_use]
    pub fn encode(&self, sonar_m: &[f64], pose: Pose, goal_distance_m: f64) -> Input {
        // Eq. (5.5): x = (s, ρ)
        let mut x = [0.0; INPUTS];
        let sonars = sonar_m.len();
        let shift = self.shift(pose, sonars);
        // Eq. (5.3): s_i in [0, 1]
        for (i, s) in x[..sonars].iter_mut().enumerate() {
            *s = (sonar_m[(i + shift) % sonars] / self.sonar_span_m).min(1.0);
        }
        let rho = (goal_distance_m / self.distance_span_m).min(1.0);
        // Eq. (5.4): φ_i = exp(-(μ_i - ρ)²)
        for (phi, unit) in x[sonars..].iter_mut().zip(UNITS) {
            *phi = libm::exp(-(unit - rho) * (unit - rho));
        }
        x
    }

    /// Sonars to shift by so that input 0 looks along the frame's x axis; the sonars are an even ring
    /// unless the frame is the robot's.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in 0..2 sonars")]
    fn shift(&self, pose: Pose, sonars: usize) -> usize {
        match self.sonar_frame {
            SonarFrame::Robot => 0,
            SonarFrame::Odometry => {
                let ring = sonars as f64;
                let turned = libm::round(pose.heading_rad.to_degrees() / (360.0 / ring));
                (ring - turned) as usize % sonars
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn settings(sonar_frame: SonarFrame) -> InputSettings {
        InputSettings { sonar_span_m: 8.0, distance_span_m: 6.0, sonar_frame }
    }

    #[test]
    fn sonars_are_normalised_and_distances_coded() {
        let mut sonar_m = [8.0; 24];
        sonar_m[1] = 2.0;
        sonar_m[2] = 80.0;
        let x = settings(SonarFrame::Robot).encode(&sonar_m, Pose::default(), 3.0);
        assert_eq!((x[0], x[1], x[2]), (1.0, 0.25, 1.0));
        // ρ = 0.5 lies midway between units 3 and 4, 0.0625 from each.
        assert_eq!(x[27].to_bits(), x[28].to_bits());
        assert!((x[27] - (-0.062_5f64 * 0.062_5).exp()).abs() < 1e-15);
        assert!(x[24] < x[25] && x[31] < x[30]);
    }

    #[test]
    fn fewer_sonars_leave_zeros_at_the_end() {
        let x = settings(SonarFrame::Robot).encode(&[4.0; 10], Pose::default(), 3.0);
        let full = settings(SonarFrame::Robot).encode(&[4.0; 24], Pose::default(), 3.0);
        assert_eq!(x[..10], [0.5; 10]);
        assert_eq!(x[10..18], full[24..], "the distance units follow the sonars");
        assert_eq!(x[18..], [0.0; 14]);
    }

    #[test]
    fn a_virtual_turret_undoes_whole_turns_of_a_sonar() {
        let world_m: [f64; 24] = std::array::from_fn(|i| i as f64 / 10.0);
        for turned in [0usize, 1, 7, 12, 23] {
            // Turned by k sonars, sonar i of the robot looks where sonar i + k of the world does.
            let sonar_m: [f64; 24] = std::array::from_fn(|i| world_m[(i + turned) % 24]);
            let pose = Pose::new(0.0, 0.0, (15.0 * turned as f64).to_radians());
            let x = settings(SonarFrame::Odometry).encode(&sonar_m, pose, 1.0);
            for i in 0..24 {
                assert!((x[i] - world_m[i] / 8.0).abs() < 1e-15, "turned by {turned}, input {i}");
            }
        }
    }
}
