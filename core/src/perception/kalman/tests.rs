use proptest::prelude::*;

use super::*;

fn vector(numbers: &[f64]) -> DVector<f64> {
    DVector::from_column_slice(numbers)
}

/// Position and velocity, of which the position is measured.
fn tracker() -> LinearModel {
    LinearModel {
        transition: DMatrix::from_row_slice(2, 2, &[1.0, 1.0, 0.0, 1.0]),
        input: DMatrix::from_row_slice(2, 1, &[0.5, 1.0]),
        noise: DMatrix::from_row_slice(2, 1, &[0.5, 1.0]),
        process_covariance: DMatrix::from_element(1, 1, 0.04),
        measurement: DMatrix::from_row_slice(1, 2, &[1.0, 0.0]),
        measurement_covariance: DMatrix::from_element(1, 1, 0.25),
    }
}

#[test]
fn two_steps_by_hand() {
    let mut filter =
        Kalman::new(tracker(), vector(&[0.0, 1.0]), DMatrix::identity(2, 2)).expect("shapes fit");
    filter.predict(&vector(&[2.0])).expect("one input");
    // x = [0 + 1 + 0.5·2, 1 + 2]; P = [[2, 1], [1, 1]] + 0.04 [[0.25, 0.5], [0.5, 1]]
    assert_eq!(filter.state(), &vector(&[2.0, 3.0]));
    let p = [2.01, 1.02, 1.02, 1.04];
    assert!((filter.covariance() - DMatrix::from_row_slice(2, 2, &p)).norm() < 1e-12);
    let correction = filter.correct(&vector(&[3.0])).expect("one measurement");
    // K = [2.01, 1.02] / (2.01 + 0.25), innovation 1
    let gain = [2.01 / 2.26, 1.02 / 2.26];
    assert!((correction.gain.column(0) - vector(&gain)).norm() < 1e-12);
    assert!((filter.state() - vector(&[2.0 + gain[0], 3.0 + gain[1]])).norm() < 1e-12);
    let p = [2.01 - gain[0] * 2.01, 1.02 - gain[0] * 1.02, 1.04 - gain[1] * 1.02];
    let expected = DMatrix::from_row_slice(2, 2, &[p[0], p[1], p[1], p[2]]);
    assert!((filter.covariance() - expected).norm() < 1e-12);
}

#[test]
fn what_does_not_fit_is_named() {
    let wide = LinearModel { input: DMatrix::zeros(3, 1), ..tracker() };
    let skew =
        LinearModel { measurement_covariance: DMatrix::from_element(1, 1, -1.0), ..tracker() };
    let holed = LinearModel {
        transition: DMatrix::from_row_slice(2, 2, &[1.0, f64::NAN, 0.0, 1.0]),
        ..tracker()
    };
    for (model, message) in [
        (wide, "`B` must be 2 × 1, not 3 × 1"),
        (skew, "`R` must be symmetric with no negative number on its diagonal"),
        (holed, "`φ` must hold finite numbers only"),
    ] {
        let error =
            Kalman::new(model, vector(&[0.0, 0.0]), DMatrix::identity(2, 2)).expect_err(message);
        assert_eq!(error.to_string(), message);
    }
    let error = Kalman::new(tracker(), vector(&[0.0]), DMatrix::identity(2, 2)).expect_err("short");
    assert_eq!(error.to_string(), "`x` must be 2 × 1, not 1 × 1");
    let mut filter =
        Kalman::new(tracker(), vector(&[0.0, 0.0]), DMatrix::identity(2, 2)).expect("shapes fit");
    assert!(filter.predict(&vector(&[1.0, 2.0])).is_err());
    assert!(filter.correct(&vector(&[f64::NAN])).is_err());
}

#[test]
fn two_exact_measurements_determine_nothing() {
    assert_eq!(lost_at_sea([1.0, 0.0], [2.0, 0.0]), Err(KalmanError::Singular));
}

proptest! {
    #[test]
    fn lost_at_sea_gives_the_batch_answer(
        z1 in -100.0..100.0f64, z2 in -100.0..100.0f64,
        sigma1 in 0.01..10.0f64, sigma2 in 0.01..10.0f64,
    ) {
        let [star, both] = lost_at_sea([z1, sigma1], [z2, sigma2]).expect("finite");
        let (v1, v2) = (sigma1 * sigma1, sigma2 * sigma2);
        prop_assert_eq!((star.state()[0], star.covariance()[(0, 0)]), (z1, v1));
        // Eq. (1.10): x₁ = (σ₂² z₁ + σ₁² z₂) / (σ₁² + σ₂²)
        prop_assert!((both.state()[0] - (v2 * z1 + v1 * z2) / (v1 + v2)).abs() < 1e-9);
        // Eq. (1.11): σ² = σ₁² σ₂² / (σ₁² + σ₂²), less than either
        let variance = both.covariance()[(0, 0)];
        prop_assert!((variance / (v1 * v2 / (v1 + v2)) - 1.0).abs() < 1e-6);
        prop_assert!(variance < v1.min(v2));
    }
}
