//! Published figures beside ours.

use serde::{Deserialize, Serialize};
use ts_rs::TS;
use utoipa::ToSchema;

/// A table or figure of the thesis that can be computed again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct ReproductionTarget {
    /// Name used in the interface, e.g. `table-5.1`.
    pub name: String,
    /// Title for people.
    pub title: String,
    /// What is held against what.
    pub compares: String,
    /// Where the thesis has it.
    pub source: String,
    /// Sets of trials run for each preset.
    pub sets: u32,
    /// First seed; the sets take one each, upwards.
    pub first_seed: u64,
    /// Last seed.
    pub last_seed: u64,
    /// How the verdicts are found.
    pub rule: String,
}

/// A table or figure of the thesis, computed again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct Reproduction {
    /// Name of the target.
    pub target: String,
    /// One row a figure.
    pub rows: Vec<ReproductionRow>,
}

/// One figure, published and ours.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct ReproductionRow {
    /// Preset and quantity.
    pub name: String,
    /// What the thesis prints; none when it prints nothing.
    pub published: Option<f64>,
    /// What came out here.
    pub ours: f64,
    /// Lower end of our 95 % interval.
    pub low: f64,
    /// Upper end of our 95 % interval.
    pub high: f64,
    /// Sample size behind ours.
    pub n: u32,
    /// Unit; empty for a pure number.
    pub unit: String,
    /// Whether the published value lies in our interval.
    pub verdict: Verdict,
    /// How we read the thesis, with preset and seeds.
    pub reading: String,
}

/// How a published value stands to ours.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, TS, ToSchema)]
pub enum Verdict {
    /// It lies inside our 95 % interval.
    #[serde(rename = "agrees")]
    Agrees,
    /// It lies outside.
    #[serde(rename = "differs")]
    Differs,
    /// Nothing was published, the sample is too small or the interval too wide.
    #[serde(rename = "cannot tell")]
    CannotTell,
}

impl Verdict {
    /// The word for it.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Agrees => "agrees",
            Self::Differs => "differs",
            Self::CannotTell => "cannot tell",
        }
    }
}

impl From<sonarium_core::stats::Verdict> for Verdict {
    fn from(verdict: sonarium_core::stats::Verdict) -> Self {
        match verdict {
            sonarium_core::stats::Verdict::Agrees => Self::Agrees,
            sonarium_core::stats::Verdict::Differs => Self::Differs,
            sonarium_core::stats::Verdict::CannotTell => Self::CannotTell,
        }
    }
}
