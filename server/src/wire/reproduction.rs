//! Published figures beside ours.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use ts_rs::TS;
use utoipa::ToSchema;

/// Something the thesis shows or claims that can be computed again.
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
    /// How its words and figures were read, a sentence each.
    pub readings: Vec<String>,
    /// Name of the experiment that is run.
    pub experiment: String,
    /// What is run, side by side.
    pub arms: Vec<ReproductionArm>,
    /// What one seed gives: `set` (of trials) or `experiment` (of ten episodes of trials).
    pub unit: String,
    /// Trials of a set, or of an episode.
    pub trials: u32,
    /// Sets or experiments for each arm; 0 where nothing is drawn at random.
    pub sets: u32,
    /// First seed; the sets take one each, upwards; none where nothing is drawn.
    pub first_seed: Option<u64>,
    /// Last seed.
    pub last_seed: Option<u64>,
    /// What is run for each arm, e.g. `200 sets of 20 trials an arm, seeds 700000..700199`.
    pub extent: String,
    /// How the verdicts are found.
    pub rule: String,
    /// The command that computes the same.
    pub command: String,
}

/// One of the learners, or one of the worlds, that a target compares.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct ReproductionArm {
    /// Name, with which the names of its rows begin.
    pub name: String,
    /// Preset, world and settings that differ from the preset's.
    #[ts(type = "Record<string, number | string | boolean>")]
    #[schema(value_type = Object)]
    pub settings: BTreeMap<String, Value>,
}

/// How far a target is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct ReproductionProgress {
    /// Name of the target.
    pub target: String,
    /// Where it stands.
    pub state: ReproductionState,
    /// Sets or experiments done.
    pub done: u32,
    /// Sets or experiments to do.
    pub of: u32,
    /// Why it failed.
    pub reason: Option<String>,
}

/// Where the computation of a target stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum ReproductionState {
    /// Nobody has asked for it since the server started.
    #[default]
    Idle,
    /// Another target is being computed first.
    Waiting,
    /// Sets are being run.
    Running,
    /// The result is there.
    Done,
    /// It could not be computed; asking again tries again.
    Failed,
}

/// Something the thesis shows or claims, computed again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct Reproduction {
    /// Name of the target.
    pub target: String,
    /// One row a figure.
    pub rows: Vec<ReproductionRow>,
    /// Curves, several arms of one quantity after each other.
    #[serde(default)]
    pub curves: Vec<ReproductionCurve>,
    /// Pictures, those of one arm after each other.
    #[serde(default)]
    pub pictures: Vec<ReproductionPicture>,
    /// Program version and commit.
    pub build: String,
}

/// One quantity of one arm over trials.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct ReproductionCurve {
    /// Name of the arm.
    pub arm: String,
    /// What is drawn, e.g. `number of steps`.
    pub quantity: String,
    /// Its unit; empty for a pure number.
    pub unit: String,
    /// What is counted along x, e.g. `trial`.
    pub x_name: String,
    /// What the band is, e.g. `95 % interval of the mean over 200 sets`.
    pub band: String,
    /// What the bars are, e.g. `minimum and maximum over the first ten sets`; empty without bars.
    pub bars: String,
    /// The points, by rising x.
    pub points: Vec<ReproductionPoint>,
}

/// One point of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct ReproductionPoint {
    /// Place along x.
    pub x: f64,
    /// Mean; none when no set has a value here.
    pub mean: Option<f64>,
    /// Lower end of the 95 % interval of the mean; none of fewer than two values.
    pub low: Option<f64>,
    /// Upper end.
    pub high: Option<f64>,
    /// Least value among the sets of the bars.
    pub least: Option<f64>,
    /// Greatest value among them.
    pub greatest: Option<f64>,
    /// Sets behind the mean.
    pub n: u32,
}

/// A picture of a target: `GET reproductions/{target}/pictures/{name}`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct ReproductionPicture {
    /// Name, unique in the target, e.g. `default-first`.
    pub name: String,
    /// Name of the arm.
    pub arm: String,
    /// What it shows, a line.
    pub caption: String,
    /// What is to be seen, for those who cannot see it.
    pub alt: String,
}

/// One figure, published and ours.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct ReproductionRow {
    /// Preset and quantity.
    pub name: String,
    /// What the thesis prints; none when it prints nothing.
    pub published: Option<f64>,
    /// What is required where nothing is published, e.g. `≥ 95`; then the verdict says whether the whole
    /// interval keeps it.
    #[serde(default)]
    pub required: Option<String>,
    /// What came out here.
    pub ours: f64,
    /// Lower end of our 95 % interval.
    pub low: f64,
    /// Upper end of our 95 % interval.
    pub high: f64,
    /// Sample size behind ours; 0 for what was computed exactly, without a sample.
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
