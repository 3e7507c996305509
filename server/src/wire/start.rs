//! A trained network started from elsewhere (figure 5.8, below right).

use serde::{Deserialize, Serialize};
use ts_rs::TS;
use utoipa::ToSchema;

/// A pose to start from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct StartView {
    /// Name for people.
    pub name: String,
    /// Metres.
    pub x_m: f64,
    /// Metres.
    pub y_m: f64,
    /// Degrees, counter-clockwise from the x axis.
    pub heading_deg: f64,
}

/// What the networks of a run, as they are after its last trial, do from an altered start: without
/// exploring, growing or adapting.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct AlteredStartView {
    /// The start.
    pub start: StartView,
    /// A neuron is active at the start: the situation lies in its receptive field.
    pub inside: bool,
    /// Distance to the nearest place where a neuron was born, metres; none without neurons.
    pub explored_m: Option<f64>,
    /// The network alone: where no neuron is active, the nearest acts.
    pub alone: ExcursionView,
    /// The network with the reflex where no neuron is active.
    pub guided: ExcursionView,
}

/// One way from an altered start.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct ExcursionView {
    /// It ended at the goal.
    pub reached_goal: bool,
    /// Control steps taken.
    pub steps: u32,
    /// Total reinforcement R, Eq. (5.27).
    pub total_reinforcement: f64,
    /// Real and virtual collisions.
    pub collisions: u32,
    /// Share of the steps at which no neuron was active, percent.
    pub silent_pct: f64,
    /// True positions, metres, the start first; left out of `run --json`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub path_m: Vec<[f64; 2]>,
}
