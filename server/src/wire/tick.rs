//! One control step with its explanation, and the neurons behind it.
//!
//! These are the messages of the log; the page, the reports and the replay read nothing else.

use serde::{Deserialize, Serialize};
use ts_rs::TS;
use utoipa::ToSchema;

/// Position and heading.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct PoseView {
    /// Metres.
    pub x_m: f64,
    /// Metres.
    pub y_m: f64,
    /// Degrees, counter-clockwise from the x axis, in [-180, 180).
    pub heading_deg: f64,
}

/// One control step: sensed, adapted, decided, moved.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct TickView {
    /// Number in the session, from 1.
    pub tick: u64,
    /// Trial, from 1.
    pub trial: u32,
    /// Step within the trial, from 1.
    pub step: u32,
    /// True pose when sensing.
    pub true_pose: PoseView,
    /// Believed pose when sensing: by odometry, and by the sonars where it is corrected (A10).
    pub pose: PoseView,
    /// How that was found; none where odometry is not corrected.
    #[serde(default)]
    pub fix: Option<FixView>,
    /// One reading a sonar, metres from where it sits; `hello` and the robot's file say where each looks.
    pub sonar_m: Vec<f64>,
    /// Strongest infrared reflectance, percent.
    pub reflectance_pct: f64,
    /// Believed distance to the goal, metres.
    pub goal_distance_m: f64,
    /// Believed bearing of the goal from the heading, degrees.
    pub goal_bearing_deg: f64,
    /// Region the robot believes to be in.
    pub region: String,
    /// Nearest neuron of the region's network, Eq. (5.10).
    pub winner: Option<WinnerView>,
    /// Neuron added at this situation.
    pub born: Option<u32>,
    /// Place of the record path that the action makes for, metres: that of a new neuron (D2), or of one that is
    /// not of the record path (A9).
    #[serde(default)]
    pub toward_m: Option<[f64; 2]>,
    /// The reflex, when it was asked, Eq. (5.8).
    pub reflex: Option<ReflexView>,
    /// What happened to the past neuron, section 5.9.
    pub adaptation: AdaptationView,
    /// Neuron in charge; none when learning is off.
    pub neuron: Option<u32>,
    /// Its prototypical action p, degrees.
    pub prototypical_deg: f64,
    /// Its utility u; none while pending.
    pub utility: Option<f64>,
    /// Where its mean points, when it aims along a shortcut (addition A1).
    #[serde(default)]
    pub aim: Option<AimView>,
    /// The stochastic unit, Eq. (5.12)-(5.16).
    pub exploration: ExplorationView,
    /// `network`, `reflex`, `bend`, `pursuit`, `sidestep`, `escape` or `scout`.
    pub source: String,
    /// Action α, degrees, Eq. (5.15).
    pub action_deg: f64,
    /// Frame of p and α: `heading`, `rotation` or `goal`.
    pub action_frame: String,
    /// Rotation executed before the advance, degrees.
    pub rotation_deg: f64,
    /// What came of it.
    pub outcome: OutcomeView,
    /// Neurons in all networks after this tick.
    pub neurons: u32,
    /// Total reinforcement of the trial so far.
    pub total_reinforcement: f64,
}

/// A pose found by odometry and sonars (A10).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct FixView {
    /// The pose by odometry alone.
    pub odometry: PoseView,
    /// Echoes that agreed with what was heard here before; 0 where nothing was.
    pub echoes: u32,
    /// Standard deviation of the position, metres.
    pub spread_m: f64,
}

/// The nearest neuron.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct WinnerView {
    /// Its number.
    pub neuron: u32,
    /// ‖x − c‖.
    pub distance: f64,
}

/// The fuzzy reflex at work: activations of left, forward and right.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct ReflexView {
    /// Nearest reading ahead, to the left and to the right, metres.
    pub nearest_m: [f64; 3],
    /// Membership of "near" ahead, left and right, 0 to 1.
    pub near: [f64; 3],
    /// Obstacle avoidance: left, forward, right.
    pub avoid: [f64; 3],
    /// Goal following: left, forward, right.
    pub goal: [f64; 3],
    /// Fused, Eq. (5.8): left, forward, right.
    pub fused: [f64; 3],
    /// Defuzzified rotation, degrees.
    pub rotation_deg: f64,
}

/// The stochastic unit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct ExplorationView {
    /// T(n), degrees.
    pub temperature_deg: f64,
    /// μ of the winner, degrees.
    pub mean_deg: f64,
    /// σ = T(n) / (1 + exp(u)), degrees.
    pub sigma_deg: f64,
    /// Standard deviation of the draw, degrees.
    pub deviation_deg: f64,
    /// ξ as drawn, degrees.
    pub drawn_deg: f64,
    /// Most that ξ may be, degrees: T(n), or |μ| along a shortcut that turns by more (addition A11); none in logs
    /// of older programs, where it was T(n).
    #[serde(default)]
    pub most_deg: Option<f64>,
    /// ξ clipped to that, degrees.
    pub xi_deg: f64,
}

/// What happened to the past neuron.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum AdaptationView {
    /// No past in this trial yet.
    NoPast,
    /// Temporal-difference learning is off.
    Off,
    /// A utility is still pending (section 5.9, Exceptions).
    Pending {
        /// Past neuron.
        past: u32,
    },
    /// Error-driven growth: δ > Δ.
    Split {
        /// Past neuron.
        past: u32,
        /// TD error.
        delta: f64,
        /// Neuron added at the past situation.
        added: u32,
    },
    /// Utility, mean and centre adapted.
    Updated {
        /// Past neuron i.
        past: u32,
        /// r(t+1).
        reinforcement: f64,
        /// u_j of the present neuron.
        present_utility: f64,
        /// u_i before.
        utility_before: f64,
        /// δ(t+1), Eq. (5.19).
        delta: f64,
        /// η_r or η_p, Eq. (5.20).
        utility_rate: f64,
        /// u_i after.
        utility_after: f64,
        /// Eligibility, Eq. (5.23), per degree.
        eligibility: f64,
        /// μ_i before, degrees.
        mean_before_deg: f64,
        /// μ_i after, degrees.
        mean_after_deg: f64,
        /// Way the centre moved, Eq. (5.25).
        centre_shift: f64,
    },
}

/// The consequence of an action.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct OutcomeView {
    /// True pose after the motion and any rescue.
    pub true_pose: PoseView,
    /// Believed pose after it.
    pub pose: PoseView,
    /// `none`, `virtual` (infrared) or `real` (tactile).
    pub contact: String,
    /// Way backed off, metres.
    pub backed_m: f64,
    /// r(t+1) = f₁ + f₂.
    pub reinforcement: f64,
    /// f₁, Eq. (5.6).
    pub safety: f64,
    /// f₂, Eq. (5.7).
    pub goal: f64,
    /// Close flag of Eq. (5.6).
    pub close: bool,
    /// The robot is at the goal.
    pub reached_goal: bool,
}

/// A neuron: its four parameters and its birth certificate.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct NeuronView {
    /// Its number in the session.
    pub id: u32,
    /// Region whose network it belongs to.
    pub region: String,
    /// Centre c: normalised sonars, then 8 distance units. Left out of the live stream, and
    /// at the end of a trial that did not change it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub centre: Vec<f64>,
    /// Prototypical action p, degrees.
    pub prototypical_deg: f64,
    /// Heading that p meant at its birth pose, degrees, for drawing.
    pub heading_deg: f64,
    /// Mean μ, degrees.
    pub mean_deg: f64,
    /// Utility u; none while pending.
    pub utility: Option<f64>,
    /// Times it won.
    pub wins: u32,
    /// Birth certificate.
    pub birth: BirthView,
}

/// When and why a neuron was added.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct BirthView {
    /// Trial.
    pub trial: u32,
    /// Step within the trial.
    pub step: u32,
    /// Tick.
    pub tick: u64,
    /// `empty`, `distance`, `error` or `rescue`.
    pub cause: String,
    /// The distance or the TD error that caused it.
    pub value: Option<f64>,
    /// Neuron its action was copied from.
    pub parent: Option<u32>,
    /// Place of the record path that its action made for, metres (D2); with no parent either, the reflex was
    /// asked.
    #[serde(default)]
    pub toward_m: Option<[f64; 2]>,
    /// Believed pose at that moment.
    pub pose: PoseView,
}

/// What the learner did at the end of a trial.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct TrialEndView {
    /// The trial's row.
    pub trial: super::Trial,
    /// Utilities set by back-tracking, Eq. (5.26).
    pub backed_up: Vec<ChangeView>,
    /// Prototypical actions replaced, Eq. (5.28), degrees.
    pub replaced: Vec<ChangeView>,
    /// Shortcuts proposed (addition A1), with their reason.
    pub proposed: Vec<ProposalView>,
    /// What came of the shortcuts followed without a record (addition A8).
    #[serde(default)]
    pub judged: Vec<VerdictView>,
    /// Neurons deleted (addition D3).
    pub forgotten: Vec<u32>,
    /// All neurons after the trial; centres only where the trial set or moved them.
    pub neurons: Vec<NeuronView>,
}

/// What came of a shortcut that was followed in a trial without a record (addition A8).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct VerdictView {
    /// The neuron whose shortcut it is.
    pub neuron: u32,
    /// δ over the way, Eq. (5.19) over several steps; none where it began off the record path or never came back
    /// to it.
    pub delta: Option<f64>,
    /// It is not followed again.
    pub withdrawn: bool,
}

/// A place a neuron aims at (addition A1), odometry frame.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct AimView {
    /// Metres.
    pub x_m: f64,
    /// Metres.
    pub y_m: f64,
    /// Where the way leads on from there, metres, if it bends there (addition A3).
    #[serde(default)]
    pub beyond_m: Option<[f64; 2]>,
    /// Neuron in charge at its end on the record path; none at the goal.
    pub then: Option<u32>,
}

/// A shortcut proposed at the end of a record trial (addition A1), and why.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct ProposalView {
    /// The neuron.
    pub neuron: u32,
    /// Its mean before, degrees.
    pub before: f64,
    /// Its mean after, from its prototypical action to the aim, degrees.
    pub after: f64,
    /// Where it aims.
    pub aim: AimView,
    /// Step of the record path that ended there.
    pub step: u32,
    /// Reinforcement predicted for driving straight there.
    pub straight: f64,
    /// Utility there; 0 at the goal.
    pub utility: f64,
}

/// A value changed at the end of a trial.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct ChangeView {
    /// The neuron.
    pub neuron: u32,
    /// Before.
    pub before: f64,
    /// After.
    pub after: f64,
}
