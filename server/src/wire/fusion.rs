//! Two measurements of one position fused: lost at sea, section 1.3.

use serde::{Deserialize, Serialize};
use ts_rs::TS;
use utoipa::ToSchema;

/// A normal distribution over a position.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct GaussianView {
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub sigma: f64,
}

/// Lost at sea: what a star and a light beacon say, and what both say together.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct LostAtSea {
    /// Measurement z₁ of the star with σ₁; the estimate before the beacon is seen.
    pub star: GaussianView,
    /// Measurement z₂ of the beacon with σ₂.
    pub beacon: GaussianView,
    /// z₂ − x̂, what the beacon says that was not expected.
    pub innovation: f64,
    /// Gain K = σ₁² / (σ₁² + σ₂²): the share of the innovation that is believed.
    pub gain: f64,
    /// The estimate after both, recursively: Eq. (1.10) and (1.11).
    pub fused: GaussianView,
    /// The same in one batch: (σ₂² z₁ + σ₁² z₂) / (σ₁² + σ₂²).
    pub batch: GaussianView,
}
