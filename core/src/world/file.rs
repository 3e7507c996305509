//! What a world's file says, before anything is checked.

use serde::{Deserialize, Serialize};

/// A world as written down in a file. Lengths in metres, angles in degrees.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WorldFile {
    /// Name, the value of the setting `world`.
    pub name: String,
    /// Title for people.
    pub title: String,
    /// One sentence on what the world is like.
    pub summary: String,
    /// Where it comes from.
    pub source: String,
    /// Open polylines, each a list of points `[x, y]`.
    #[serde(default)]
    pub walls: Vec<Vec<[f64; 2]>>,
    /// Closed solid polygons: obstacles, and walls that have a thickness.
    #[serde(default)]
    pub blocks: Vec<Vec<[f64; 2]>>,
    /// Closed rings that bound the free floor by the even-odd rule, as traced from a map; where there
    /// are any, everything off the floor is solid.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub floor: Vec<Vec<[f64; 2]>>,
    /// Regions; the first whose rules all hold wins.
    pub regions: Vec<RegionFile>,
    /// Where every trial starts.
    pub home: HomeFile,
    /// Where every trial should end.
    pub goal: GoalFile,
}

/// A named region.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RegionFile {
    /// Name, e.g. "corridor".
    pub name: String,
    /// Rules that must all hold; none means everywhere else.
    #[serde(default)]
    pub rules: Vec<RuleFile>,
}

/// A half-plane: `axis` (or `a` and `b`) with exactly one of `above` and `below`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RuleFile {
    /// The coordinate compared.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axis: Option<Axis>,
    /// Factor of x in the general form `a·x + b·y`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub a: Option<f64>,
    /// Factor of y in the general form `a·x + b·y`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub b: Option<f64>,
    /// The coordinate or form must be greater than this.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub above: Option<f64>,
    /// The coordinate or form must be less than this.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub below: Option<f64>,
}

/// A coordinate axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Axis {
    /// The x axis.
    X,
    /// The y axis.
    Y,
}

/// Where every trial starts.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HomeFile {
    /// Metres.
    pub x: f64,
    /// Metres.
    pub y: f64,
    /// Degrees from the x axis, counter-clockwise.
    pub heading_deg: f64,
}

/// Where every trial should end.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GoalFile {
    /// Metres.
    pub x: f64,
    /// Metres.
    pub y: f64,
    /// The goal is reached when the robot's centre is nearer than this, metres.
    pub radius_m: f64,
}
