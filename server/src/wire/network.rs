//! The file of trained networks: what they were trained with, then the networks themselves.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use sonarium_core::learner::Neuron;
use ts_rs::TS;
use utoipa::ToSchema;

use super::SonarView;

/// What every network file says it is.
pub const NETWORK_FORMAT: &str = "sonarium-network";
/// Version of the network file. It grows when an older program could no longer use a file.
pub const NETWORK_VERSION: u32 = 1;

/// Trained networks with everything that decides where they can be used.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct NetworkFile {
    /// `sonarium-network`.
    pub format: String,
    /// [`NETWORK_VERSION`].
    pub version: u32,
    /// Program version and commit that trained them.
    pub build: String,
    /// Experiment they were trained in.
    pub experiment: String,
    /// Robot they were trained on.
    pub robot: String,
    /// Its sonars, in the order of the inputs.
    pub sonars: Vec<SonarView>,
    /// How readings became inputs.
    pub input: InputSpans,
    /// Frame of the prototypical actions: `heading`, `rotation` or `goal`.
    pub action_frame: String,
    /// World they were trained in.
    pub world: String,
    /// Regions of that world, one network each; `all` when there was one network for all.
    pub regions: Vec<String>,
    /// Goal they were trained for.
    pub goal: GoalView,
    /// Every setting of the training.
    #[ts(type = "Record<string, number | string | boolean>")]
    #[schema(value_type = Object)]
    pub settings: BTreeMap<String, Value>,
    /// Seed of the training.
    pub seed: u64,
    /// Trials of the training.
    pub trials: u32,
    /// The neurons of each network, in the order of the regions. Angles are radians where the name says
    /// so, since a file must give back every bit.
    #[ts(type = "unknown[][]")]
    #[schema(value_type = Vec<Vec<Object>>)]
    pub networks: Vec<Vec<Neuron>>,
}

/// How readings became inputs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct InputSpans {
    /// Sonar reading that becomes 1, metres.
    pub sonar_span_m: f64,
    /// Distance to the goal that becomes 1, metres.
    pub distance_span_m: f64,
    /// Frame of the sonars: `robot` or `odometry`.
    pub sonar_frame: String,
}

/// A goal.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct GoalView {
    /// Metres.
    pub x_m: f64,
    /// Metres.
    pub y_m: f64,
    /// Metres.
    pub radius_m: f64,
}
