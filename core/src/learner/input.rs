//! The input vector of section 5.4: 24 normalised sonars and 8 distance units.

use crate::geometry::Pose;

/// Number of inputs.
pub const INPUTS: usize = 32;

/// The input vector `x`, Eq. (5.5).
pub type Input = [f64; INPUTS];

/// Centres `μ_i` of the eight processing units, Eq. (5.4) and fig. 5.3.
const UNITS: [f64; 8] = [0.0625, 0.1875, 0.3125, 0.4375, 0.5625, 0.6875, 0.8125, 0.9375];

crate::choice! {
    /// Frame in which the 24 sonars enter the input.
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
    pub fn encode(&self, sonar_m: &[f64; 24], pose: Pose, goal_distance_m: f64) -> Input {
        // Eq. (5.5): x = (s, ρ)
        let mut x = [0.0; INPUTS];
        let shift = self.shift(pose);
        // Eq. (5.3): s_i in [0, 1]
        for (i, s) in x[..24].iter_mut().enumerate() {
            *s = (sonar_m[(i + shift) % 24] / self.sonar_span_m).min(1.0);
        }
        let rho = (goal_distance_m / self.distance_span_m).min(1.0);
        // Eq. (5.4): φ_i = exp(-(μ_i - ρ)²)
        for (phi, unit) in x[24..].iter_mut().zip(UNITS) {
            *phi = libm::exp(-(unit - rho) * (unit - rho));
        }
        x
    }

    /// Sonars to shift by so that input 0 looks along the frame's x axis.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in 0..24")]
    fn shift(&self, pose: Pose) -> usize {
        match self.sonar_frame {
            SonarFrame::Robot => 0,
            SonarFrame::Odometry => {
                let turned = libm::round(pose.heading_rad.to_degrees() / 15.0);
                (24.0 - turned) as usize % 24
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
