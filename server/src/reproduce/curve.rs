//! Learning curves: a quantity over trials, with the interval of its mean and the bars of the thesis.

use sonarium_core::stats::{self, Estimate};

use super::Sample;
use crate::wire::{ReproductionCurve, ReproductionPoint, Trial};

/// Sets behind a bar: "ten sets of experiments, each consisting of 20 trials" (section 5.11).
const BAR_SETS: usize = 10;

/// A quantity of every trial: its mean over all sets with a 95 % band, and, as in figures 5.11-5.13, the
/// least and greatest value over the first ten sets. A trial of which `value` is none does not count.
#[must_use]
pub fn curve(
    sample: &Sample,
    quantity: &str,
    unit: &str,
    value: impl Fn(&Trial) -> Option<f64>,
) -> ReproductionCurve {
    let trials = sample.plan.trials;
    let point = |number: u32| {
        let values: Vec<Option<f64>> =
            sample.sets.iter().map(|set| set.trial(number).and_then(&value)).collect();
        point(number, &values)
    };
    ReproductionCurve {
        arm: sample.arm.name.into(),
        quantity: quantity.into(),
        unit: unit.into(),
        x_name: "trial".into(),
        band: format!("95 % interval of the mean over {} sets", sample.sets.len()),
        bars: format!(
            "minimum and maximum over the first {} sets",
            sample.sets.len().min(BAR_SETS)
        ),
        points: (1..=trials).map(point).collect(),
    }
}

fn point(trial: u32, values: &[Option<f64>]) -> ReproductionPoint {
    let sample: Vec<f64> = values.iter().flatten().copied().collect();
    let bar = || values.iter().take(BAR_SETS).flatten().copied();
    ReproductionPoint {
        least: bar().reduce(f64::min),
        greatest: bar().reduce(f64::max),
        ..mean_at(trial.into(), &sample)
    }
}

/// A point that nothing was sampled for.
pub(super) fn unsampled(x: f64, value: f64) -> ReproductionPoint {
    let mean = Some(value);
    ReproductionPoint { x, mean, low: None, high: None, least: None, greatest: None, n: 0 }
}

/// A point without bars: the mean of a sample with its interval.
pub(super) fn mean_at(x: f64, sample: &[f64]) -> ReproductionPoint {
    let mean = Estimate::mean(sample);
    ReproductionPoint {
        x,
        mean: stats::mean(sample),
        low: mean.map(|mean| mean.low),
        high: mean.map(|mean| mean.high),
        least: None,
        greatest: None,
        n: u32::try_from(sample.len()).unwrap_or(u32::MAX),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_holds_mean_interval_and_the_range_of_ten() {
        let mut values: Vec<Option<f64>> = (1..=9).map(|k| Some(f64::from(k))).collect();
        values.extend([None, Some(11.0)]);
        let point = point(4, &values);
        assert_eq!((point.x, point.mean, point.n), (4.0, Some(5.6), 10));
        assert_eq!(
            (point.least, point.greatest),
            (Some(1.0), Some(9.0)),
            "the eleventh has no bar"
        );
        let (low, high) = (point.low.expect("ten values"), point.high.expect("ten values"));
        // s² = 92.4/9; t₀.₉₇₅(9) = 2.262157 from a table; half the width is t s/√10.
        assert!((low - 3.3079).abs() < 1e-3 && (high - 7.8921).abs() < 1e-3, "{low} {high}");
    }

    #[test]
    fn a_trial_without_values_is_a_gap() {
        let point = point(1, &[None, None]);
        assert_eq!((point.mean, point.low, point.least, point.n), (None, None, None, 0));
    }
}
