//! The best path a planner finds: what a learning curve is held against.

use serde::{Deserialize, Serialize};
use ts_rs::TS;
use utoipa::ToSchema;

/// The best path a planner finds in the world and on the cost of a session.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
#[serde(tag = "state", rename_all = "lowercase")]
pub enum Yardstick {
    /// The planner is at work.
    Computing,
    /// The planner finds no way to the goal, or cannot plan for this robot.
    None,
    /// It is known.
    Ready(PlannedPath),
}

/// A path that the robot could drive, were its sensors and odometry without error.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct PlannedPath {
    /// Its total reinforcement R*, Eq. (5.27).
    pub total_reinforcement: f64,
    /// Control steps.
    pub steps: u32,
    /// Steps that end in a collision.
    pub collisions: u32,
    /// What the planner's finest search still gained: R* may be better by about as much again.
    pub resolution: f64,
    /// Its places, metres, home first.
    pub path_m: Vec<[f64; 2]>,
}
