//! The band proposal (addition A1): where the next trial should explore.
//!
//! The thesis sets the mean `μ` by the TD error and the eligibility, Eq. (5.21)-(5.24); in twenty
//! trials that finds nothing. Here each neuron on the record path aims along a discounted chord of
//! that path, pushed off walls where the safety penalty was paid: a contracting elastic band. A
//! proposal only moves the *exploration*; what is kept is still decided by Eq. (5.28).

use super::LearnerSettings;
use super::trial_end::PathStep;
use crate::geometry::{Vec2, angle};

/// Length below which a chord points nowhere, metres.
const NO_CHORD_M: f64 = 1e-9;

/// The direction each step of a path should aim along, radians in the odometry frame; none where the
/// chord vanishes.
#[must_use]
pub(super) fn chords(settings: &LearnerSettings, path: &[PathStep]) -> Vec<Option<f64>> {
    let mut directions = vec![None; path.len()];
    let mut chord = Vec2::zeros();
    for (step, direction) in path.iter().zip(&mut directions).rev() {
        // A1: ρ_t = κ l min(-f₁, 1) away from the nearest obstacle
        let push = step.away * (settings.band_repulsion * settings.advance_m * step.paid());
        // A1: z_t = Δ_t + ρ_t + λ z_{t+1}
        chord = step.moved + push + settings.band_decay * chord;
        *direction = (chord.norm() > NO_CHORD_M).then(|| angle(chord));
    }
    directions
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_4;

    use super::*;
    use crate::experiment::Settings;
    use crate::learner::NeuronId;

    fn step(x_m: f64, y_m: f64) -> PathStep {
        PathStep {
            network: 0,
            neuron: NeuronId(0),
            action_rad: 0.0,
            frame_rad: 0.0,
            reinforcement: 0.0,
            safety: 0.0,
            moved: Vec2::new(x_m, y_m),
            away: Vec2::zeros(),
        }
    }

    #[test]
    fn a_straight_path_aims_along_itself_and_a_corner_is_cut() {
        let mut settings = LearnerSettings::from(&Settings::default());
        let straight = chords(&settings, &[step(0.2, 0.0), step(0.2, 0.0), step(0.2, 0.0)]);
        assert_eq!(straight, vec![Some(0.0); 3]);
        // With λ = 1 the first step of a right angle aims along its diagonal.
        settings.band_decay = 1.0;
        let corner = chords(&settings, &[step(0.2, 0.0), step(0.0, 0.2)]);
        assert!((corner[0].unwrap_or(f64::NAN) - FRAC_PI_4).abs() < 1e-12);
        assert!(chords(&settings, &[step(0.0, 0.0)])[0].is_none());
    }

    #[test]
    fn paying_for_safety_pushes_off_the_wall() {
        let settings = LearnerSettings::from(&Settings::default());
        let close = PathStep { safety: -0.5, away: Vec2::new(0.0, 1.0), ..step(0.2, 0.0) };
        let found = chords(&settings, &[close])[0].unwrap_or(f64::NAN);
        // κ l min(-f₁, 1) = 1.6 · 0.2 · 0.5 = 0.16 m sideways for 0.2 m ahead.
        assert!((found - (0.16f64 / 0.2).atan()).abs() < 1e-12, "{found}");
        let collided = PathStep { safety: -3.0, ..close };
        let found = chords(&settings, &[collided])[0].unwrap_or(f64::NAN);
        assert!((found - (0.32f64 / 0.2).atan()).abs() < 1e-12, "a collision counts as 1: {found}");
    }
}
