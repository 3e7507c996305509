//! What goes into the learner and what comes out of it.

use super::{ActionSource, Adaptation, Exploration, NeuronId, Reinforcement, Winner};
use crate::control::ReflexTrace;
use crate::geometry::{Pose, Vec2};
use crate::robot::Contact;

/// What the learner is told before it decides.
#[derive(Clone, Debug, PartialEq)]
pub struct Observation {
    /// The 24 sonar readings, metres.
    pub sonar_m: [f64; 24],
    /// Believed pose.
    pub pose: Pose,
    /// Region the robot believes to be in.
    pub region: usize,
    /// Contact of the motion that led here.
    pub contact: Contact,
}

/// What the learner decided, with its reasons; the fields are those of [`super::Tick`].
#[derive(Clone, Debug, PartialEq)]
#[expect(missing_docs, reason = "each is documented in Tick")]
pub struct Decision {
    pub goal_distance_m: f64,
    pub goal_bearing_rad: f64,
    pub winner: Option<Winner>,
    pub born: Option<NeuronId>,
    pub reflex: Option<ReflexTrace>,
    pub adaptation: Adaptation,
    pub neuron: Option<NeuronId>,
    pub prototypical_rad: f64,
    pub utility: Option<f64>,
    pub exploration: Exploration,
    pub source: ActionSource,
    pub action_rad: f64,
    pub rotation_rad: f64,
}

/// What came of a decision.
#[derive(Clone, Debug, PartialEq)]
pub struct Consequence {
    /// Readings after the motion, metres.
    pub sonar_m: [f64; 24],
    /// Believed pose after the motion.
    pub pose: Pose,
    /// Believed displacement, metres.
    pub moved: Vec2,
    /// `r(t+1)`.
    pub reinforcement: Reinforcement,
}
