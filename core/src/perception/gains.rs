//! The linear recursive Kalman filter over a window (Algorithm 1), and over a random walk.
//!
//! The gains of a scalar filter do not depend on what is measured, so they are computed once. NOTE:
//! Algorithm 1 prints `Δσ² = −Gσ²`; with σ² = ς² at first its mean is exactly that of the window, and its
//! variance ς² / the number of readings, whatever ς is.

use crate::simd::*;

/// The gains of a scalar filter, reading by reading, and the variances they leave.
#[derive(Clone, Debug, PartialEq)]
pub struct Gains {
    /// Gain of each reading; 1 of the first, which the estimate starts from.
    gains: Vec<f64>,
    /// Variance after each reading, m².
    variances: Vec<f64>,
}

impl Gains {
    /// The gains of up to so many readings of a quantity that walks at random: the variance after the
    /// first reading, what it grows by between two, and that of a reading, m².
    ///
    /// # Panics
    /// When there is no reading, or a variance is below 0 or that of a reading is 0.
    #[must_use]
    pub fn new(first: f64, process: f64, measurement: f64, readings: usize) -> Self {
        assert!(readings > 0, "a window holds at least one reading");
        assert!(first >= 0.0 && process >= 0.0 && measurement > 0.0, "variances");
        let (mut gains, mut variances) = (vec![1.0], vec![first]);
        for _ in 1..readings {
            // Eq. (1.8) for one dimension: P(t+1|t) = P(t|t) + Q
            let variance = variances[variances.len() - 1] + process;
            // Algorithm 1: G = σ² (σ² + ς²)⁻¹
            let gain = variance / (variance + measurement);
            gains.push(gain);
            // Algorithm 1: Δσ² = −G σ²
            variances.push(variance - gain * variance);
        }
        Self { gains, variances }
    }

    /// The gains of Algorithm 1 for up to so many readings of variance ς², m².
    #[must_use]
    pub fn algorithm_1(variance: f64, readings: usize) -> Self {
        // Eq. (2.7): σ = ς
        Self::new(variance, 0.0, variance, readings)
    }

    /// Readings of a full window.
    #[must_use]
    pub fn readings(&self) -> usize {
        self.gains.len()
    }

    /// Variance after so many readings, at least 1 and at most those of a full window, m².
    #[must_use]
    pub fn variance(&self, readings: usize) -> f64 {
        self.variances[readings.clamp(1, self.variances.len()) - 1]
    }

    /// Estimates of several quantities at once from a window of readings, the oldest first.
    ///
    /// # Panics
    /// When the window is empty or longer than a full one.
    #[must_use]
    #[inline]
    pub fn estimate<const N: usize>(&self, window: &[[f64; N]]) -> [f64; N] {
        let gains = &self.gains[..window.len()];
        // Eq. (2.6): μ = z(t − n)
        let mut mean = window[0];
        for (reading, gain) in window.iter().zip(gains).skip(1) {
            for (mean, reading) in mean.iter_mut().zip(reading) {
                // Algorithm 1: Δμ = G (z(t − n + i) − μ)
                *mean += gain * (reading - *mean);
            }
        }
        mean
    }

    /// The same for many windows of one length, as fast as the processor can.
    ///
    /// # Panics
    /// When windows are longer than a full one, or there are not as many estimates as windows.
    pub fn estimate_each<const N: usize, const W: usize>(
        &self,
        windows: &[[[f64; N]; W]],
        estimates: &mut [[f64; N]],
    ) {
        assert_eq!(windows.len(), estimates.len(), "one estimate for each window");
        let gains: [f64; W] = self.gains[..W].try_into().expect("as many as were asked for");
        dispatch!(Level::new(), simd => {
            for (window, estimate) in windows.iter().zip(estimates.iter_mut()) {
                recursion(simd, &gains, window, estimate);
            }
        });
    }
}

/// Algorithm 1 over a window of a length known when the program is built, four quantities at a time.
#[inline(always)]
fn recursion<S: Simd, const N: usize, const W: usize>(
    simd: S,
    gains: &[f64; W],
    window: &[[f64; N]; W],
    estimate: &mut [f64; N],
) {
    let whole = N / 4 * 4;
    let later = || window[1..].iter().zip(&gains[1..]);
    for first in (0..whole).step_by(4) {
        let four = |reading: &[f64; N]| f64x4::from_slice(simd, &reading[first..first + 4]);
        let mut mean = four(&window[0]);
        for (reading, &gain) in later() {
            // Algorithm 1: Δμ = G (z(t − n + i) − μ)
            mean += f64x4::splat(simd, gain) * (four(reading) - mean);
        }
        estimate[first..first + 4].copy_from_slice(&<[f64; 4]>::from(mean));
    }
    for lane in whole..N {
        let mut mean = window[0][lane];
        for (reading, gain) in later() {
            // Algorithm 1: Δμ = G (z(t − n + i) − μ)
            mean += gain * (reading[lane] - mean);
        }
        estimate[lane] = mean;
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{DMatrix, DVector};
    use proptest::prelude::*;

    use super::super::{Kalman, LinearModel};
    use super::*;

    /// The same by the general filter of chapter 1.
    fn general(first: f64, process: f64, measurement: f64, window: &[f64]) -> (f64, f64) {
        let number = |value: f64| DMatrix::from_element(1, 1, value);
        let model = LinearModel {
            transition: number(1.0),
            input: DMatrix::zeros(1, 0),
            noise: number(1.0),
            process_covariance: number(process),
            measurement: number(1.0),
            measurement_covariance: number(measurement),
        };
        let start = DVector::from_element(1, window[0]);
        let mut filter = Kalman::new(model, start, number(first)).expect("shapes fit");
        for &reading in &window[1..] {
            filter.predict(&DVector::zeros(0)).expect("no input");
            filter.correct(&DVector::from_element(1, reading)).expect("finite");
        }
        (filter.state()[0], filter.covariance()[(0, 0)])
    }

    proptest! {
        #[test]
        fn the_mean_is_that_of_the_window_for_every_variance(
            window in proptest::collection::vec(0.0..2.0f64, 1..12), exponent in -12.0..12.0f64,
        ) {
            let variance = libm::exp10(exponent);
            let gains = Gains::algorithm_1(variance, 12);
            let readings: Vec<[f64; 1]> = window.iter().map(|&reading| [reading]).collect();
            let mean = window.iter().sum::<f64>() / window.len() as f64;
            prop_assert!((gains.estimate(&readings)[0] - mean).abs() < 1e-12);
            let expected = variance / window.len() as f64;
            prop_assert!((gains.variance(window.len()) / expected - 1.0).abs() < 1e-12);
        }

        #[test]
        fn it_is_the_general_filter_of_chapter_1(
            window in proptest::collection::vec(0.0..2.0f64, 1..8),
            first in 0.01..2.0f64, process in 0.0..0.1f64, measurement in 0.01..1.0f64,
        ) {
            let gains = Gains::new(first, process, measurement, 8);
            let readings: Vec<[f64; 2]> = window.iter().map(|&reading| [0.0, reading]).collect();
            let (mean, variance) = general(first, process, measurement, &window);
            let [none, found] = gains.estimate(&readings);
            prop_assert!(none == 0.0 && (found - mean).abs() < 1e-12, "{found} {mean}");
            prop_assert!((gains.variance(window.len()) - variance).abs() < 1e-12);
        }
    }

    #[test]
    fn five_regions_over_a_window_of_three() {
        // The workload that filters are compared on: P₀ = 1, Q = 0.01, R = 0.1, the first reading
        // correcting too. Plain recursion, written out.
        let (process, measurement) = (0.01, 0.1);
        let mut variance = 1.0_f64;
        let mut gains = [0.0; 3];
        for gain in &mut gains {
            variance += process;
            *gain = variance / (variance + measurement);
            variance *= 1.0 - *gain;
        }
        let window: [[f64; 5]; 3] =
            std::array::from_fn(|k| std::array::from_fn(|r| (5 * k + r + 1) as f64 / 16.0));
        let first = 1.01 * (1.0 - gains[0]);
        let found = Gains::new(first, process, measurement, 3).estimate(&window);
        let mut each = [[0.0; 5]];
        Gains::new(first, process, measurement, 3).estimate_each(&[window], &mut each);
        assert_eq!(each[0], found, "many at once, to the bit");
        for (region, found) in found.into_iter().enumerate() {
            let mut expected = window[0][region];
            for (reading, gain) in window.iter().zip(gains) {
                expected += gain * (reading[region] - expected);
            }
            assert!((found - expected).abs() < 1e-12, "region {region}: {found} {expected}");
        }
    }
}
