//! Estimates from noisy readings.

mod kalman;

pub use kalman::{Correction, Kalman, KalmanError, LinearModel, lost_at_sea};
