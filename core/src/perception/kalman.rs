//! The linear Kalman filter of section 1.3 in general form, and its example, lost at sea.
//!
//! | symbol | meaning | shape |
//! |---|---|---|
//! | x | state | m |
//! | u | input | p |
//! | w, Q | process noise and its covariance | q, q×q |
//! | z, v, R | measurement, its noise and covariance | n, n, n×n |
//! | φ, B, G, H | transition, input, noise and measurement matrix | m×m, m×p, m×q, n×m |
//! | P | covariance of the error of x | m×m |
//! | K | gain | m×n |

use nalgebra::{DMatrix, DVector};

/// How the state moves and how it is measured, Eq. (1.1)-(1.4).
#[derive(Clone, Debug, PartialEq)]
pub struct LinearModel {
    /// φ, m×m.
    pub transition: DMatrix<f64>,
    /// B, m×p; p may be 0.
    pub input: DMatrix<f64>,
    /// G, m×q; q may be 0.
    pub noise: DMatrix<f64>,
    /// Q, q×q.
    pub process_covariance: DMatrix<f64>,
    /// H, n×m.
    pub measurement: DMatrix<f64>,
    /// R, n×n.
    pub measurement_covariance: DMatrix<f64>,
}

/// Why a filter cannot be built or go on.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum KalmanError {
    /// A matrix or vector has the wrong shape.
    #[error("`{name}` must be {expected}, not {found}")]
    Shape {
        /// Its symbol.
        name: &'static str,
        /// Rows × columns that would be right.
        expected: String,
        /// Rows × columns it has.
        found: String,
    },
    /// A number is infinite or not a number.
    #[error("`{name}` must hold finite numbers only")]
    NotFinite {
        /// Its symbol.
        name: &'static str,
    },
    /// A covariance is not symmetric with a diagonal of at least 0.
    #[error("`{name}` must be symmetric with no negative number on its diagonal")]
    Covariance {
        /// Its symbol.
        name: &'static str,
    },
    /// The innovation has a direction without any variance, so the gain is undetermined.
    #[error(
        "`R` must be greater where `H P Hᵀ` is 0: a measurement without any uncertainty of an estimate \
         without any uncertainty determines no gain"
    )]
    Singular,
}

fn shape(
    name: &'static str,
    found: &DMatrix<f64>,
    rows: usize,
    columns: usize,
) -> Result<(), KalmanError> {
    if found.shape() == (rows, columns) {
        return finite(name, found.iter());
    }
    Err(KalmanError::Shape {
        name,
        expected: format!("{rows} × {columns}"),
        found: format!("{} × {}", found.nrows(), found.ncols()),
    })
}

fn length(name: &'static str, found: &DVector<f64>, rows: usize) -> Result<(), KalmanError> {
    if found.len() == rows {
        return finite(name, found.iter());
    }
    Err(KalmanError::Shape {
        name,
        expected: format!("{rows} × 1"),
        found: format!("{} × 1", found.len()),
    })
}

fn finite<'a>(
    name: &'static str,
    mut numbers: impl Iterator<Item = &'a f64>,
) -> Result<(), KalmanError> {
    if numbers.all(|number| number.is_finite()) {
        Ok(())
    } else {
        Err(KalmanError::NotFinite { name })
    }
}

fn covariance(name: &'static str, found: &DMatrix<f64>, size: usize) -> Result<(), KalmanError> {
    shape(name, found, size, size)?;
    let good = (0..size).all(|row| {
        found[(row, row)] >= 0.0
            && (0..row).all(|column| {
                let (a, b) = (found[(row, column)], found[(column, row)]);
                (a - b).abs() <= 1e-9 * (a.abs() + b.abs())
            })
    });
    if good { Ok(()) } else { Err(KalmanError::Covariance { name }) }
}

impl LinearModel {
    fn check(&self) -> Result<(), KalmanError> {
        let (m, p) = (self.transition.nrows(), self.input.ncols());
        let (q, n) = (self.noise.ncols(), self.measurement.nrows());
        shape("φ", &self.transition, m, m)?;
        shape("B", &self.input, m, p)?;
        shape("G", &self.noise, m, q)?;
        covariance("Q", &self.process_covariance, q)?;
        shape("H", &self.measurement, n, m)?;
        covariance("R", &self.measurement_covariance, n)
    }
}

/// What one measurement changed.
#[derive(Clone, Debug, PartialEq)]
pub struct Correction {
    /// `z − H x`, n.
    pub innovation: DVector<f64>,
    /// Gain K, m×n.
    pub gain: DMatrix<f64>,
}

/// The filter: an estimate, its covariance, and the model they follow.
#[derive(Clone, Debug, PartialEq)]
pub struct Kalman {
    model: LinearModel,
    state: DVector<f64>,
    covariance: DMatrix<f64>,
}

impl Kalman {
    /// A filter that starts from `x(0|0)` and `P(0|0)`.
    ///
    /// # Errors
    /// When shapes do not fit, a number is not finite or a covariance is none.
    pub fn new(
        model: LinearModel,
        state: DVector<f64>,
        covariance_0: DMatrix<f64>,
    ) -> Result<Self, KalmanError> {
        model.check()?;
        length("x", &state, model.transition.nrows())?;
        covariance("P", &covariance_0, model.transition.nrows())?;
        Ok(Self { model, state, covariance: covariance_0 })
    }

    /// The estimate x.
    #[must_use]
    pub fn state(&self) -> &DVector<f64> {
        &self.state
    }

    /// Its covariance P.
    #[must_use]
    pub fn covariance(&self) -> &DMatrix<f64> {
        &self.covariance
    }

    /// One step of time, with the input u.
    ///
    /// # Errors
    /// When u has the wrong length or is not finite.
    pub fn predict(&mut self, input: &DVector<f64>) -> Result<(), KalmanError> {
        let model = &self.model;
        length("u", input, model.input.ncols())?;
        // Eq. (1.6): x(t+1|t) = φ x(t|t) + B u(t)
        self.state = &model.transition * &self.state + &model.input * input;
        // Eq. (1.8): P(t+1|t) = φ P(t|t) φᵀ + G Q Gᵀ
        self.covariance = symmetric(
            &model.transition * &self.covariance * model.transition.transpose()
                + &model.noise * &model.process_covariance * model.noise.transpose(),
        );
        Ok(())
    }

    /// Takes in a measurement z.
    ///
    /// # Errors
    /// When z has the wrong length or is not finite, or the gain is undetermined; the estimate stays
    /// as it was then.
    pub fn correct(&mut self, measurement: &DVector<f64>) -> Result<Correction, KalmanError> {
        let model = &self.model;
        length("z", measurement, model.measurement.nrows())?;
        let seen = &model.measurement * &self.covariance;
        let innovation_covariance =
            &seen * model.measurement.transpose() + &model.measurement_covariance;
        // Eq. (1.7): K = P Hᵀ (H P Hᵀ + R)⁻¹, as the solution of (H P Hᵀ + R) Kᵀ = H P
        let gain = symmetric(innovation_covariance)
            .cholesky()
            .ok_or(KalmanError::Singular)?
            .solve(&seen)
            .transpose();
        let innovation = measurement - &model.measurement * &self.state;
        // Eq. (1.5): x(t|t) = x(t|t-1) + K (z − H x(t|t-1))
        self.state += &gain * &innovation;
        // NOTE: below Eq. (1.8) the thesis prints P(t|t) = P(t|t-1) − K H P(t|t-1), with one index lost.
        self.covariance = symmetric(&self.covariance - &gain * seen);
        Ok(Correction { innovation, gain })
    }
}

/// Takes off what rounding has made unsymmetric.
fn symmetric(matrix: DMatrix<f64>) -> DMatrix<f64> {
    (&matrix + matrix.transpose()) * 0.5
}

/// Lost at sea: one position, measured by a star (z₁, σ₁) and then by a light beacon (z₂, σ₂).
///
/// Returns the filter as the star left it and as the beacon did.
///
/// # Errors
/// When a number is not finite, or both deviations are 0.
pub fn lost_at_sea(star: [f64; 2], beacon: [f64; 2]) -> Result<[Kalman; 2], KalmanError> {
    let number = |value: f64| DMatrix::from_element(1, 1, value);
    // Eq. (1.9), the half of it that is measured last: z₂ = x + v₂
    let model = LinearModel {
        transition: number(1.0),
        input: DMatrix::zeros(1, 0),
        noise: DMatrix::zeros(1, 0),
        process_covariance: DMatrix::zeros(0, 0),
        measurement: number(1.0),
        measurement_covariance: number(beacon[1] * beacon[1]),
    };
    let by_star = Kalman::new(model, DVector::from_element(1, star[0]), number(star[1] * star[1]))?;
    let mut by_both = by_star.clone();
    by_both.correct(&DVector::from_element(1, beacon[0]))?;
    Ok([by_star, by_both])
}

#[cfg(test)]
mod tests;
