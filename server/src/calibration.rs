//! Calibration of a sonar's deviation ς for the noise that somebody drives with: Eq. (2.8).

use sonarium_core::perception::{Calibration, CalibrationReport, PlaceError};
use sonarium_core::robot::{Equipment, NoiseLevel};
use sonarium_core::stats::Estimate;

use crate::catalog::FieldError;
use crate::wire::{
    CalibratedSetting, CalibrationPlace, CalibrationQuestion, CalibrationView, IntervalView,
};

/// Greatest seed: all up to it are exact in JSON.
const MOST_SEED: u64 = (1 << 53) - 1;
/// Least value that the setting of a run takes, metres.
const LEAST_DEVIATION_M: f64 = 0.001;
/// What `factor` is unless told otherwise. NOTE: the thesis wants k > 1 and prints no number.
const FACTOR: f64 = 1.5;

impl Default for CalibrationQuestion {
    fn default() -> Self {
        Self { noise: 1.0, ideal: false, pairs: 2000, factor: FACTOR, seed: 1 }
    }
}

/// Takes all pairs.
///
/// # Errors
/// Names the field of the question that is out of range.
pub fn calibrate(
    equipment: &Equipment,
    asked: CalibrationQuestion,
) -> Result<CalibrationView, FieldError> {
    check(&asked)?;
    let noise = if asked.ideal { NoiseLevel::IDEAL } else { NoiseLevel::times(asked.noise) };
    let pairs = u64::from(asked.pairs);
    let mut calibration = Calibration::new(equipment, noise, pairs, asked.factor, asked.seed);
    while calibration.step().is_some() {}
    let report = calibration.report();
    report.map(|report| view(asked, &report)).ok_or_else(|| too_few("pairs", asked.pairs))
}

fn check(asked: &CalibrationQuestion) -> Result<(), FieldError> {
    let within = |field: &str, value: f64, [least, most]: [f64; 2]| {
        if (least..=most).contains(&value) {
            return Ok(());
        }
        Err(FieldError::new(field, format!("must be from {least} to {most}, not {value}")))
    };
    within("noise", asked.noise, [0.0, 20.0])?;
    within("pairs", f64::from(asked.pairs), [2.0, 100_000.0])?;
    within("factor", asked.factor, [1.0, 10.0])?;
    if asked.seed > MOST_SEED {
        let message = format!("must be up to {MOST_SEED}, not {}", asked.seed);
        return Err(FieldError::new("seed", message));
    }
    Ok(())
}

fn too_few(field: &str, found: u32) -> FieldError {
    FieldError::new(field, format!("must be at least 2, not {found}"))
}

fn view(asked: CalibrationQuestion, report: &CalibrationReport) -> CalibrationView {
    let place = |place: &PlaceError| row(place.place.name(), &place.mean_square);
    let deviation_m = interval(&report.deviation_m);
    CalibrationView {
        asked,
        places: report.places.iter().map(place).collect(),
        all: row("all", &report.mean_square),
        settings: settings(&asked, deviation_m.value),
        deviation_m,
        build: crate::build(),
    }
}

fn row(place: &str, mean_square: &Estimate) -> CalibrationPlace {
    CalibrationPlace {
        place: place.to_owned(),
        n: u32::try_from(mean_square.n).unwrap_or(u32::MAX),
        mean_square: interval(mean_square),
        rms_m: mean_square.value.sqrt(),
    }
}

fn interval(of: &Estimate) -> IntervalView {
    // A mean of squares cannot be below 0, though its symmetric interval may be.
    IntervalView { value: of.value, low: of.low.max(0.0), high: of.high }
}

/// ς, to the millimetre, and the noise that it is for.
fn settings(asked: &CalibrationQuestion, deviation_m: f64) -> Vec<CalibratedSetting> {
    let setting = |key: &str, value: String| CalibratedSetting { key: key.to_owned(), value };
    let noise = if asked.ideal {
        setting("noise.ideal", "true".to_owned())
    } else {
        setting("noise.level", asked.noise.to_string())
    };
    let deviation_m = format!("{:.3}", deviation_m.max(LEAST_DEVIATION_M));
    vec![setting("fusion.sonar_deviation", deviation_m), noise]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::Catalog;

    fn asked(change: impl FnOnce(&mut CalibrationQuestion)) -> Result<CalibrationView, FieldError> {
        let catalog = Catalog::load(None).expect("the embedded files");
        let mut question = CalibrationQuestion { pairs: 50, ..CalibrationQuestion::default() };
        change(&mut question);
        calibrate(catalog.equipment().expect("the TRC is equipped"), question)
    }

    #[test]
    fn the_deviation_is_the_root_of_k_times_the_mean_square_of_the_places() {
        let view = asked(|question| question.factor = 2.0).expect("acceptable");
        let squares = view.places.iter().map(|place| place.mean_square.value).sum::<f64>();
        assert!((view.deviation_m.value.powi(2) - 2.0 * squares / 5.0).abs() < 1e-12);
        assert!((view.all.rms_m.powi(2) - squares / 5.0).abs() < 1e-12);
        assert_eq!(view.all.n, 250);
        assert_eq!(view.settings[0].value, format!("{:.3}", view.deviation_m.value));
        assert_eq!(view.settings[1].key, "noise.level");
    }

    #[test]
    fn what_cannot_be_calibrated_is_named() {
        let named =
            |change: fn(&mut CalibrationQuestion)| asked(change).expect_err("refused").field;
        assert_eq!(named(|question| question.noise = -1.0), "noise");
        assert_eq!(named(|question| question.noise = f64::NAN), "noise");
        assert_eq!(named(|question| question.pairs = 1), "pairs");
        assert_eq!(named(|question| question.factor = 0.5), "factor");
        assert_eq!(named(|question| question.seed = u64::MAX), "seed");
    }

    #[test]
    fn a_run_takes_the_settings_that_carry_the_value() {
        use crate::wire::NewSession;
        let catalog = Catalog::load(None).expect("the embedded files");
        for ideal in [false, true] {
            let view = asked(|question| question.ideal = ideal).expect("acceptable");
            for experiment in ["wall-approach", "block-world", "corridor"] {
                let settings = view.settings.iter().map(|setting| {
                    let value = serde_json::from_str(&setting.value).expect("a number or a switch");
                    (setting.key.clone(), value)
                });
                let request = NewSession {
                    experiment: experiment.to_owned(),
                    seed: Some(1),
                    settings: settings.collect(),
                    trials: None,
                    speed: None,
                    network: None,
                };
                catalog.job(&request).expect(experiment);
            }
        }
    }
}
