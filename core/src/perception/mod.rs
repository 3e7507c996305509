//! Estimates from noisy readings.

mod calibration;
mod consistency;
mod fusion;
mod gains;
mod hashing;
mod kalman;
mod localiser;

pub use calibration::{Calibration, CalibrationReport, Pair, Place, PlaceError};
pub use consistency::Consistency;
pub use fusion::{Fusion, FusionRule, Method, RegionDepth};
pub use gains::Gains;
pub use hashing::{Hashing, HashingError, MOST_REGIONS, MedianRank, ReadingError, Snapshot};
pub use kalman::{Correction, Kalman, KalmanError, LinearModel, lost_at_sea};
pub use localiser::{Fix, Localiser, Sighting};
