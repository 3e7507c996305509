//! What a decision was made of: every number between the observation and the action.
//!
//! These are plain data, filled while the learner computes; nothing is recomputed for display.

use serde::{Deserialize, Serialize};

use super::Decision;
use crate::geometry::{Pose, Vec2};
use crate::perception::Fix;
use crate::robot::{Contact, Readings};

/// Number of a neuron in a session: unique, never used again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct NeuronId(pub u32);

/// The immediate reinforcement and its two parts, section 5.5.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reinforcement {
    /// Safety part `f₁` in `[-3, 0]`, Eq. (5.6).
    pub safety: f64,
    /// Goal part `f₂` in `[-1, 0]`, Eq. (5.7).
    pub goal: f64,
    /// The close flag of Eq. (5.6): some sonar read less than `d_c`.
    pub close: bool,
}

impl Reinforcement {
    /// `r = f₁ + f₂`.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.safety + self.goal
    }
}

/// Why a neuron was added, section 5.7 and 5.9.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum BirthCause {
    /// The region's network was empty.
    Empty,
    /// Distance-driven: the winner was farther than ς, Eq. (5.10).
    Distance {
        /// Distance to the nearest centre, in the metric of the novelty setting.
        distance: f64,
    },
    /// Error-driven: the TD error of Eq. (5.19) exceeded Δ.
    Error {
        /// The TD error.
        delta: f64,
    },
}

/// Where a neuron's first prototypical action came from.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Origin {
    /// The fuzzy reflex was asked (the thesis).
    Reflex,
    /// Towards a place of the record path (deviation D2).
    Pursuit {
        /// The place, metres.
        x_m: f64,
        /// The place, metres.
        y_m: f64,
    },
    /// Copied: from the neuron before it on a shortcut, or from the one in charge where the shortcut ends
    /// (addition A2).
    Inherited {
        /// The neuron copied from.
        parent: NeuronId,
    },
}

/// A neuron's birth certificate.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Birth {
    /// Trial of birth, from 1.
    pub trial: u32,
    /// Step within the trial, from 1.
    pub step: u32,
    /// Tick of the session, from 1.
    pub tick: u64,
    /// Why it was added.
    pub cause: BirthCause,
    /// Where its first action came from.
    pub origin: Origin,
    /// Believed pose of the robot at that moment.
    pub pose: Pose,
}

/// Who chose the action of a tick.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ActionSource {
    /// The winner's prototypical action and the stochastic unit, Eq. (5.15).
    Network,
    /// The bare reflex, because learning is off.
    Reflex,
    /// Along a way that bends, past a neuron that would do something else (addition A3).
    Bend,
    /// Back to the record path, where a neuron won that is not of it (addition A9).
    Pursuit,
    /// Turned aside, because the echoes left no room for the next step (addition A4).
    Sidestep,
    /// Along an obstacle, because the robot came no nearer to the goal (addition A5).
    Escape,
    /// A scout's step: for the goal, or along an obstacle (addition A6).
    Scout,
}

/// What leads a known neuron past its own action.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Guide {
    /// [`ActionSource::Bend`] or [`ActionSource::Pursuit`].
    pub source: ActionSource,
    /// Where to, odometry frame, metres.
    pub place: Vec2,
}

/// The stochastic unit at work, Eq. (5.12)-(5.16). Degrees, as the thesis counts them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Exploration {
    /// `T(n)`, degrees.
    pub temperature_deg: f64,
    /// `μ`, the mean of the winner, degrees.
    pub mean_deg: f64,
    /// `σ = T(n) / (1 + exp(u))`, degrees.
    pub sigma_deg: f64,
    /// Standard deviation the draw really used, degrees.
    pub deviation_deg: f64,
    /// The draw `ξ` before clipping, degrees.
    pub drawn_deg: f64,
    /// Most that `ξ` may be, degrees: `T(n)`, or `|μ|` along a shortcut that turns by more (addition A11).
    pub most_deg: f64,
    /// `ξ` after clipping to that, degrees.
    pub xi_deg: f64,
}

/// The adaptation of the past neuron, section 5.9.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Adaptation {
    /// There is no past in this trial yet.
    NoPast,
    /// Temporal-difference learning is switched off.
    Off,
    /// The past or the present neuron has no utility yet (section 5.9, Exceptions).
    Pending {
        /// The past neuron.
        past: NeuronId,
    },
    /// The past situation was split off because δ > Δ (error-driven growth).
    Split {
        /// The past neuron.
        past: NeuronId,
        /// The TD error, Eq. (5.19).
        delta: f64,
        /// The neuron added at the past situation.
        added: NeuronId,
    },
    /// Utility, mean and centre of the past neuron were adapted.
    Updated(Update),
}

/// The numbers of one adaptation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Update {
    /// The past neuron `i`.
    pub past: NeuronId,
    /// `r(t+1)`.
    pub reinforcement: f64,
    /// `u_j` of the present neuron.
    pub present_utility: f64,
    /// `u_i` before.
    pub utility_before: f64,
    /// `δ(t+1)`, Eq. (5.19).
    pub delta: f64,
    /// `η_r` or `η_p`, Eq. (5.20).
    pub utility_rate: f64,
    /// `u_i` after.
    pub utility_after: f64,
    /// Characteristic eligibility, Eq. (5.23), per degree; 0 when the mean is not learned this way.
    pub eligibility: f64,
    /// `μ_i` before, degrees.
    pub mean_before_deg: f64,
    /// `μ_i` after, Eq. (5.24), degrees.
    pub mean_after_deg: f64,
    /// How far the centre moved, Eq. (5.25), in input units.
    pub centre_shift: f64,
}

/// The winner of the competition in the region's network, Eq. (5.10).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Winner {
    /// The nearest neuron.
    pub neuron: NeuronId,
    /// `‖x − c‖`, input units.
    pub distance: f64,
}

/// Everything about one control step: what was sensed, how the past was adapted, what was decided,
/// and what came of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Number of this tick in the session, from 1.
    pub tick: u64,
    /// Trial, from 1.
    pub trial: u32,
    /// Step within the trial, from 1.
    pub step: u32,
    /// True pose when sensing.
    pub true_pose: Pose,
    /// Believed pose when sensing: by odometry, and by the sonars where it is corrected (addition A10).
    pub pose: Pose,
    /// How that was found; none where odometry is not corrected.
    pub fix: Option<Fix>,
    /// Sonar readings, metres from each sonar, in the order of the robot's mounts.
    pub sonar_m: Readings,
    /// Strongest infrared reflectance, percent of full reflection.
    pub reflectance_pct: f64,
    /// Index of the region the robot believes to be in.
    pub region: usize,
    /// What was decided, and why.
    pub decision: Decision,
    /// What came of it.
    pub outcome: Outcome,
    /// Neurons in all networks after this tick.
    pub neurons: usize,
    /// Sum of reinforcements of this trial so far.
    pub total_reinforcement: f64,
}

/// The consequence of an action.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// True pose after the motion and any rescue.
    pub true_pose: Pose,
    /// Believed pose after it.
    pub pose: Pose,
    /// Collision, if there was one.
    pub contact: Contact,
    /// Way backed off during the rescue, metres.
    pub backed_m: f64,
    /// Believed displacement, metres.
    pub moved: Vec2,
    /// `r(t+1)` and its parts.
    pub reinforcement: Reinforcement,
    /// The robot is at the goal.
    pub reached_goal: bool,
}

/// The result of one trial, and the row of the trial table.
#[derive(Clone, Debug, PartialEq)]
pub struct TrialRecord {
    /// Trial, from 1.
    pub trial: u32,
    /// Control steps taken.
    pub steps: u32,
    /// `R(n)`, Eq. (5.27).
    pub total_reinforcement: f64,
    /// Share of `R(n)` from Eq. (5.6).
    pub safety: f64,
    /// Share of `R(n)` from Eq. (5.7).
    pub goal: f64,
    /// What that would be, had the robot known where it was; the same unless odometry errs.
    pub true_goal: f64,
    /// Neurons after the trial.
    pub neurons: usize,
    /// Neurons added during the trial.
    pub born: u32,
    /// Neurons deleted at its end (addition D3).
    pub forgotten: u32,
    /// Real and virtual collisions.
    pub collisions: u32,
    /// The goal was reached; otherwise the trial was capped.
    pub reached_goal: bool,
    /// `R(n)` exceeded that of every earlier successful trial.
    pub record: bool,
    /// A scout set out in it (addition A6).
    pub scout: bool,
    /// `T(n)` during the trial, degrees.
    pub temperature_deg: f64,
    /// Length of the true path, metres.
    pub path_m: f64,
    /// Steps taken in each region, in the world's order.
    pub region_steps: Vec<u32>,
    /// First tick of the trial.
    pub first_tick: u64,
    /// Last tick of the trial.
    pub last_tick: u64,
}

/// A place a neuron aims at (addition A1), odometry frame.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Aim {
    /// Metres.
    pub x_m: f64,
    /// Metres.
    pub y_m: f64,
    /// Where the way leads on from there, if it bends there (addition A3).
    #[serde(default)]
    pub beyond: Option<Beyond>,
    /// Network and neuron in charge at its end on the record path; none at the goal.
    pub then: Option<(usize, NeuronId)>,
}

/// The end of a way that bends once (addition A3), odometry frame.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Beyond {
    /// Metres.
    pub x_m: f64,
    /// Metres.
    pub y_m: f64,
}

impl Aim {
    /// The place.
    #[must_use]
    pub fn point(&self) -> Vec2 {
        Vec2::new(self.x_m, self.y_m)
    }

    /// The second leg of a way that bends here (addition A3).
    #[must_use]
    pub fn after_bend(&self) -> Option<Self> {
        let Beyond { x_m, y_m } = self.beyond?;
        Some(Self { x_m, y_m, beyond: None, then: self.then })
    }
}

/// A shortcut proposed at the end of a record trial (addition A1), and why.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Proposal {
    /// The neuron.
    pub neuron: NeuronId,
    /// Its mean before, degrees.
    pub before_deg: f64,
    /// Its mean after: from its prototypical action to the aim, degrees.
    pub after_deg: f64,
    /// Where it aims.
    pub aim: Aim,
    /// Step of the record path, from 1, that ended there.
    pub step: u32,
    /// Reinforcement predicted for driving straight there.
    pub straight: f64,
    /// Utility there; 0 at the goal.
    pub utility: f64,
}

/// What came of a shortcut that was followed in a trial without a record (addition A8).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verdict {
    /// The neuron whose shortcut it is.
    pub neuron: NeuronId,
    /// `δ`, the TD error over the way, until a neuron of the record path was in charge again; none where that
    /// never was, or the neuron is not of the record path.
    pub delta: Option<f64>,
    /// It is not followed again.
    pub withdrawn: bool,
}

/// A change made to a neuron at the end of a trial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change {
    /// The neuron.
    pub neuron: NeuronId,
    /// Value before.
    pub before: f64,
    /// Value after.
    pub after: f64,
}

/// What the learner did when a trial ended.
#[derive(Clone, Debug, PartialEq)]
pub struct TrialEnd {
    /// The trial's result.
    pub record: TrialRecord,
    /// Utilities set by back-tracking, Eq. (5.26).
    pub backed_up: Vec<Change>,
    /// Prototypical actions replaced, Eq. (5.28), radians.
    pub replaced: Vec<Change>,
    /// Shortcuts proposed (addition A1).
    pub proposed: Vec<Proposal>,
    /// What came of the shortcuts followed without a record (addition A8).
    pub judged: Vec<Verdict>,
    /// Neurons deleted (addition D3).
    pub forgotten: Vec<NeuronId>,
    /// Neurons whose centre was set or moved during the trial, in the order of their numbers.
    pub recentred: Vec<NeuronId>,
}
