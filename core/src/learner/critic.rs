//! Adaptation of the past neuron by the temporal-difference error, section 5.9.

use super::{Input, LearnerSettings, MeanUpdate, Neuron, Update};

/// The TD error of a past utility.
#[must_use]
pub(super) fn td_error(
    settings: &LearnerSettings,
    reinforcement: f64,
    past_utility: f64,
    present_utility: f64,
) -> f64 {
    // Eq. (5.19): δ(t+1) = r(t+1) + γ u_j(t+1) - u_i(t)
    // NOTE: Eq. (5.18) prints u_i on both sides; the second must be u_j, as in (5.19).
    reinforcement + settings.discount * present_utility - past_utility
}

/// Adapts utility, mean and centre of the neuron that won the past situation.
pub(super) fn adapt(
    settings: &LearnerSettings,
    neuron: &mut Neuron,
    past: &PastSituation,
    delta: f64,
    present_utility: f64,
) -> Update {
    let rewarded = delta > 0.0;
    let choose = |rates: (f64, f64)| if rewarded { rates.0 } else { rates.1 };
    let (utility_before, mean_before_deg) = (neuron.utility, neuron.mean_deg);
    let utility_rate = choose(settings.utility_rates);
    let mut eligibility = 0.0;
    let mut centre_shift = 0.0;
    if settings.temporal_difference {
        // Eq. (5.20): u_i(t+1) = u_i(t) + η_{r,p} δ(t+1)
        neuron.utility += utility_rate * delta;
        // Eq. (5.25): c_i(t+1) = c_i(t) + ε_{r,p} (x(t) - c_i(t))
        centre_shift = shift_centre(neuron, &past.input, choose(settings.centre_rates));
    }
    if matches!(settings.mean_update, MeanUpdate::Gradient) {
        eligibility = past.eligibility;
        // Eq. (5.22), (5.24): μ_i(t+1) = μ_i(t) + β_{r,p} δ(t+1) e_i(t)
        neuron.mean_deg += choose(settings.mean_rates) * delta * eligibility;
    }
    Update {
        past: neuron.id,
        reinforcement: past.reinforcement,
        present_utility,
        utility_before,
        delta,
        utility_rate,
        utility_after: neuron.utility,
        eligibility,
        mean_before_deg,
        mean_after_deg: neuron.mean_deg,
        centre_shift,
    }
}

/// What the critic must remember of the past situation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PastSituation {
    /// `x(t)`.
    pub(super) input: Input,
    /// `e_i(t)`, Eq. (5.23), per degree.
    pub(super) eligibility: f64,
    /// `r(t+1)`.
    pub(super) reinforcement: f64,
}

fn shift_centre(neuron: &mut Neuron, input: &Input, rate: f64) -> f64 {
    let mut squared = 0.0;
    for (c, x) in neuron.centre.iter_mut().zip(input) {
        let step = rate * (x - *c);
        *c += step;
        squared += step * step;
    }
    squared.sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::Settings;

    #[test]
    fn reward_and_penalty_use_their_own_rates() {
        let mut settings = LearnerSettings::from(&Settings::default());
        settings.mean_update = MeanUpdate::Gradient;
        let past = PastSituation { input: [1.0; 32], eligibility: 0.5, reinforcement: -1.0 };
        // δ = -1 + 0.7 u_j - u_i, worked by hand; the centre moves by ε √32.
        for (u_i, u_j, delta, utility, mean_deg, shift) in
            [(-4.0, -2.0, 1.6, -3.2, 0.16, 0.01), (0.0, -2.0, -2.4, -0.12, -0.024, 0.001)]
        {
            let mut neuron = Neuron::example(0, [0.0; 32], u_i);
            let found = td_error(&settings, past.reinforcement, u_i, u_j);
            let update = adapt(&settings, &mut neuron, &past, found, u_j);
            assert!((update.delta - delta).abs() < 1e-12, "{update:?}");
            assert!((neuron.utility - utility).abs() < 1e-12, "{update:?}");
            assert!((neuron.mean_deg - mean_deg).abs() < 1e-12, "{update:?}");
            assert!((neuron.centre[31] - shift).abs() < 1e-12, "{update:?}");
            assert!((update.centre_shift - shift * 32f64.sqrt()).abs() < 1e-12, "{update:?}");
        }
    }

    #[test]
    fn the_shortcut_leaves_the_mean_to_the_end_of_the_trial() {
        let settings = LearnerSettings::from(&Settings::default());
        let past = PastSituation { input: [1.0; 32], eligibility: 0.5, reinforcement: -1.0 };
        let mut neuron = Neuron::example(0, [0.0; 32], -4.0);
        let update = adapt(&settings, &mut neuron, &past, 1.6, -2.0);
        assert_eq!((update.mean_after_deg, update.eligibility), (0.0, 0.0));
    }
}
