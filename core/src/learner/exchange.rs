//! What goes into the learner and what comes out of it.

use super::{
    ActionSource, Adaptation, Aim, Exploration, Guide, NeuronId, Origin, Reinforcement, Winner,
};
use crate::control::ReflexTrace;
use crate::geometry::Pose;
use crate::robot::{Contact, Readings};

/// What the learner is told before it decides.
#[derive(Clone, Debug, PartialEq)]
pub struct Observation {
    /// The sonar readings, metres.
    pub sonar_m: Readings,
    /// Believed pose.
    pub pose: Pose,
    /// Region the robot believes to be in.
    pub region: usize,
    /// Contact of the motion that led here.
    pub contact: Contact,
}

/// What the learner decided, with every number that led to it.
#[derive(Clone, Debug, PartialEq)]
pub struct Decision {
    /// Distance to the goal as believed, metres.
    pub goal_distance_m: f64,
    /// Bearing of the goal from the heading as believed, radians.
    pub goal_bearing_rad: f64,
    /// The nearest neuron of the region's network, if it has any.
    pub winner: Option<Winner>,
    /// The neuron added at this situation, if any.
    pub born: Option<NeuronId>,
    /// Where the action of that neuron came from.
    pub origin: Option<Origin>,
    /// What leads a known neuron past its own action.
    pub guide: Option<Guide>,
    /// The reflex, when it was asked.
    pub reflex: Option<ReflexTrace>,
    /// What happened to the past neuron.
    pub adaptation: Adaptation,
    /// The neuron in charge; none when learning is off.
    pub neuron: Option<NeuronId>,
    /// Its prototypical action `p`, radians, in the frame of the setting `learner.action_frame`.
    pub prototypical_rad: f64,
    /// Its utility `u`; none while it is pending.
    pub utility: Option<f64>,
    /// Where its mean points, when it aims along a shortcut (addition A1).
    pub aim: Option<Aim>,
    /// The stochastic unit.
    pub exploration: Exploration,
    /// Who chose.
    pub source: ActionSource,
    /// `α`, radians, in the frame of the setting `learner.action_frame`, Eq. (5.15).
    pub action_rad: f64,
    /// Rotation the robot executes before it advances, radians.
    pub rotation_rad: f64,
}

/// What came of a decision.
#[derive(Clone, Debug, PartialEq)]
pub struct Consequence {
    /// Readings after the motion, metres.
    pub sonar_m: Readings,
    /// Believed pose after the motion.
    pub pose: Pose,
    /// `r(t+1)`.
    pub reinforcement: Reinforcement,
}
