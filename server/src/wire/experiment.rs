//! Experiments as a user sees them: names, settings, presets, worlds.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use ts_rs::TS;
use utoipa::ToSchema;

/// One experiment that can be run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct ExperimentInfo {
    /// Name used in the interface, e.g. `minimum-cost-path`.
    pub name: String,
    /// Title for people.
    pub title: String,
    /// What it shows, a sentence or two.
    pub summary: String,
    /// Where the thesis describes it.
    pub source: String,
    /// Which kind of experiment it is.
    pub family: super::Family,
    /// The robot that runs it; none in a tabular experiment.
    pub robot: Option<RobotInfo>,
    /// Trials of a session, or of each episode of a tabular experiment, unless told otherwise.
    pub default_trials: u32,
    /// Most trials a session may have.
    pub max_trials: u32,
    /// Sets of settings with a name; the first is the default.
    pub presets: Vec<PresetInfo>,
    /// Worlds it can run in; the first is the default. None where there is but one.
    pub worlds: Vec<WorldInfo>,
    /// Altered starts in the default world, which trained networks are tried from.
    pub starts: Vec<super::StartView>,
    /// Every setting.
    pub settings: Vec<SettingInfo>,
}

/// A robot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct RobotInfo {
    /// Name, that of its file.
    pub name: String,
    /// Title for people.
    pub title: String,
    /// What it is.
    pub summary: String,
    /// Where it comes from.
    pub source: String,
}

/// A named set of settings.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct PresetInfo {
    /// Value of the setting `preset`.
    pub name: String,
    /// Title for people.
    pub title: String,
    /// What it stands for.
    pub summary: String,
    /// Settings that differ from the defaults.
    #[ts(type = "Record<string, number | string | boolean>")]
    #[schema(value_type = Object)]
    pub settings: BTreeMap<String, Value>,
}

/// A world that can be chosen.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct WorldInfo {
    /// Value of the setting `world`.
    pub name: String,
    /// Title for people.
    pub title: String,
    /// What it is.
    pub summary: String,
}

/// One setting: what it means and what it may be.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct SettingInfo {
    /// Key, e.g. `sonar.noise`.
    pub key: String,
    /// What it means.
    pub meaning: String,
    /// `number`, `integer`, `switch`, `choice` or `text`.
    pub kind: String,
    /// Unit; empty for a choice, a switch or a pure number.
    pub unit: String,
    /// Default.
    #[ts(type = "number | string | boolean")]
    #[schema(value_type = Object)]
    pub default: Value,
    /// Least value of a number.
    pub min: Option<f64>,
    /// Greatest value of a number.
    pub max: Option<f64>,
    /// What a choice can be.
    pub choices: Vec<Choice>,
    /// Equation, section or reading it comes from.
    pub source: String,
    /// `literal`, `reading`, `gap`, `deviation`, `addition` or `simulation`.
    pub standing: String,
}

/// One value of a choice.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct Choice {
    /// The value.
    pub value: String,
    /// What it means.
    pub meaning: String,
}
