//! Calibration of a sonar's deviation ς: Eq. (2.8).

use serde::{Deserialize, Serialize};
use ts_rs::TS;
use utoipa::{IntoParams, ToSchema};

use super::IntervalView;

/// What to calibrate.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema, IntoParams)]
#[serde(default, deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub struct CalibrationQuestion {
    /// Times the noise in the robot's file, 0 to 20; 1 when missing.
    pub noise: f64,
    /// An ideal sonar: no noise, every ray comes back; `false` when missing.
    pub ideal: bool,
    /// Pairs of the true and the measured distance at each place, 2 to 100000; 2000 when missing.
    pub pairs: u32,
    /// Factor k, 1 to 10; 1.5 when missing.
    pub factor: f64,
    /// Seed, up to 2⁵³ − 1; 1 when missing.
    pub seed: u64,
}

/// What a place comes to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct CalibrationPlace {
    /// Where the sonar stood.
    pub place: String,
    /// Pairs taken.
    pub n: u32,
    /// Mean square of d − r, m², with its 95 % interval.
    pub mean_square: IntervalView,
    /// Its root, metres.
    pub rms_m: f64,
}

/// The deviation of a sonar, and what it comes from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct CalibrationView {
    /// What was asked.
    pub asked: CalibrationQuestion,
    /// Place by place.
    pub places: Vec<CalibrationPlace>,
    /// All places together.
    pub all: CalibrationPlace,
    /// ς, the root of k times the mean square over all places, metres, with its 95 % interval.
    pub deviation_m: IntervalView,
    /// Settings that carry it into a run of the wall approach or the corridor.
    pub settings: Vec<CalibratedSetting>,
    /// Program version and commit that computed it.
    pub build: String,
}

/// A setting of a run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct CalibratedSetting {
    /// Key.
    pub key: String,
    /// Value, as it is typed.
    pub value: String,
}
