//! What a robot's file says, before anything is checked.

use serde::{Deserialize, Serialize};

use super::Equipment;

/// A robot as written down in a file. Lengths in metres, angles in degrees; the frame is the robot's:
/// x ahead, y to the left, origin where it turns.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RobotFile {
    /// Name, that of the file.
    pub name: String,
    /// Title for people.
    pub title: String,
    /// One sentence on what it is like.
    pub summary: String,
    /// Where it comes from.
    pub source: String,
    /// Number of sonars spread evenly round a round body, the first ahead, then counter-clockwise.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ring: Option<u32>,
    /// The outline on the floor.
    pub body: BodyFile,
    /// Sonars one by one, counter-clockwise; instead of `ring`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub sonars: Vec<SonarFile>,
    /// What the experiments of chapter 2 need beside.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub equipment: Option<Equipment>,
}

/// A circle (`radius_m`) or a rectangle (`length_m` along the heading and `width_m`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BodyFile {
    /// Radius of a round body.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub radius_m: Option<f64>,
    /// Length of a rectangular body.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub length_m: Option<f64>,
    /// Width of a rectangular body.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub width_m: Option<f64>,
}

/// One sonar.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SonarFile {
    /// Metres ahead of the centre.
    pub x_m: f64,
    /// Metres to the left of the centre.
    pub y_m: f64,
    /// Axis of the cone from the heading, counter-clockwise, -180 to 180.
    pub axis_deg: f64,
}
