//! The stochastic unit of section 5.8.

use std::f64::consts::FRAC_1_SQRT_2;

use rand::Rng;
use rand_distr::{Distribution, StandardNormal};

use super::{Deviation, Exploration, LearnerSettings};

/// Draws `ξ` for a neuron with utility `u` and mean `μ` at a temperature, unless an earlier draw holds, and clips
/// it to the most that is allowed.
#[must_use]
pub(super) fn explore(
    settings: &LearnerSettings,
    utility: f64,
    mean_deg: f64,
    temperature_deg: f64,
    most_deg: f64,
    held_deg: Option<f64>,
    rng: &mut impl Rng,
) -> Exploration {
    // Eq. (5.14): σ = T(n) / (1 + exp(u))
    let sigma_deg = temperature_deg / (1.0 + libm::exp(utility));
    // NOTE (D1): only a share of σ is used; at 1 the walk never settles.
    let used_deg = settings.sigma_scale * sigma_deg;
    let deviation_deg = match settings.deviation {
        // Eq. (5.12) lacks the 2 of a normal density: exp(-x²/σ²) has deviation σ/√2.
        Deviation::Half => used_deg * FRAC_1_SQRT_2,
        Deviation::Whole => used_deg,
    };
    // Eq. (5.12)-(5.13): ξ ~ N(μ_i, σ)
    let drawn_deg = if let Some(held_deg) = held_deg {
        held_deg
    } else if deviation_deg > 0.0 {
        let normal: f64 = StandardNormal.sample(rng);
        mean_deg + deviation_deg * normal
    } else {
        mean_deg
    };
    // Eq. (5.15): -T(n) ≤ ξ ≤ T(n); along a shortcut as far as that turns (A11)
    let xi_deg = drawn_deg.clamp(-most_deg, most_deg);
    Exploration { temperature_deg, mean_deg, sigma_deg, deviation_deg, drawn_deg, most_deg, xi_deg }
}

/// Characteristic eligibility of the mean, per degree; 0 when nothing was drawn.
#[must_use]
pub(super) fn eligibility(settings: &LearnerSettings, exploration: &Exploration) -> f64 {
    let used_deg = settings.sigma_scale * exploration.sigma_deg;
    if used_deg > 0.0 {
        // Eq. (5.23): e_i(t) = (ξ(t) - μ_i(t)) / σ_i²(t)
        (exploration.drawn_deg - exploration.mean_deg) / (used_deg * used_deg)
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::Settings;
    use crate::rng::{Purpose, stream};

    fn literal() -> LearnerSettings {
        LearnerSettings {
            sigma_scale: 1.0,
            deviation: Deviation::Whole,
            ..LearnerSettings::from(&Settings::default())
        }
    }

    #[test]
    fn a_low_utility_explores_and_a_high_one_does_not() {
        let mut rng = stream(1, 0, Purpose::Exploration);
        for (utility, expected_deg) in [(0.0, 50.0), (-800.0, 100.0), (800.0, 0.0)] {
            let found = explore(&literal(), utility, 0.0, 100.0, 100.0, None, &mut rng);
            assert!((found.sigma_deg - expected_deg).abs() < 1e-9, "u = {utility}");
        }
    }

    #[test]
    fn draws_have_the_mean_and_deviation_asked_for() {
        let mut rng = stream(7, 0, Purpose::Exploration);
        let n = 20_000;
        let draws: Vec<f64> = (0..n)
            .map(|_| explore(&literal(), 0.0, 5.0, 20.0, 20.0, None, &mut rng).drawn_deg)
            .collect();
        let mean = draws.iter().sum::<f64>() / f64::from(n);
        let variance = draws.iter().map(|draw| (draw - mean).powi(2)).sum::<f64>() / f64::from(n);
        // σ = 10: the mean of 20,000 draws is within 5 standard errors of 5, the deviation within 3 %.
        assert!((mean - 5.0).abs() < 5.0 * 10.0 / f64::from(n).sqrt(), "{mean}");
        assert!((variance.sqrt() - 10.0).abs() < 0.3, "{}", variance.sqrt());
    }

    #[test]
    fn actions_are_clipped_to_what_is_allowed() {
        let mut rng = stream(3, 0, Purpose::Exploration);
        for (mean_deg, temperature_deg, most_deg, expected_deg) in [
            (500.0, 10.0, 10.0, 10.0),
            (-500.0, 10.0, 10.0, -10.0),
            (500.0, 10.0, 50.0, 50.0),
            (30.0, 0.0, 0.0, 0.0),
        ] {
            let found =
                explore(&literal(), 0.0, mean_deg, temperature_deg, most_deg, None, &mut rng);
            assert!((found.xi_deg - expected_deg).abs() < 1e-12, "{mean_deg} {most_deg}");
        }
    }

    #[test]
    fn eligibility_is_the_distance_from_the_mean_over_the_variance() {
        let exploration =
            Exploration { mean_deg: 2.0, drawn_deg: 6.0, sigma_deg: 4.0, ..Exploration::default() };
        assert!((eligibility(&literal(), &exploration) - 0.25).abs() < 1e-15);
        let still = Exploration { sigma_deg: 0.0, ..exploration };
        assert_eq!(eligibility(&literal(), &still).to_bits(), 0.0f64.to_bits());
    }
}
