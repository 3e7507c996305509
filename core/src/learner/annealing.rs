//! Annealing of the computational temperature, section 5.8.

use super::LearnerSettings;

/// `T(0)`, degrees.
#[must_use]
pub(super) fn initial(settings: &LearnerSettings) -> f64 {
    // Eq. (5.16): T(0) = T_max
    settings.temperature_max_deg
}

/// `T(n)` from `T(n-1)`, degrees.
#[must_use]
pub(super) fn cooled(settings: &LearnerSettings, temperature_deg: f64) -> f64 {
    // Eq. (5.17): T(n) = T_min + β (T(n-1) - T_min)
    settings.temperature_min_deg
        + settings.cooling * (temperature_deg - settings.temperature_min_deg)
}

/// The temperature a trial (from 1) really uses.
///
/// NOTE (D4): the thesis never cools below `T_min`; from the trial `exploit_from` on we use 0, so that
/// the best path is replayed exactly.
#[must_use]
pub(super) fn effective(settings: &LearnerSettings, temperature_deg: f64, trial: u32) -> f64 {
    let exploits = settings.exploit_from > 0 && trial >= settings.exploit_from;
    if exploits { 0.0 } else { temperature_deg }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::Settings;

    #[test]
    fn the_temperature_of_each_trial() {
        let settings = LearnerSettings::from(&Settings::default());
        let mut temperature_deg = initial(&settings);
        for (trial, expected_deg) in [(1, 100.0), (2, 82.0), (3, 67.6), (4, 56.08)] {
            assert!((temperature_deg - expected_deg).abs() < 1e-12, "trial {trial}");
            temperature_deg = cooled(&settings, temperature_deg);
        }
        for _ in 0..100 {
            temperature_deg = cooled(&settings, temperature_deg);
        }
        assert!((temperature_deg - 10.0).abs() < 1e-6);
        assert_eq!(effective(&settings, temperature_deg, 17).to_bits(), temperature_deg.to_bits());
        assert_eq!(effective(&settings, temperature_deg, 18).to_bits(), 0.0f64.to_bits());
        let never = LearnerSettings { exploit_from: 0, ..settings };
        assert_eq!(effective(&never, temperature_deg, 999).to_bits(), temperature_deg.to_bits());
    }
}
