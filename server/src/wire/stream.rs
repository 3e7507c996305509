//! The stream: what a page and the server say to each other over the WebSocket.

use serde::{Deserialize, Serialize};
use ts_rs::TS;

use super::{
    CourseView, CycleView, DriveRunView, DriveScores, EpisodeView, NeuronView, ScoresView, Session,
    StepView, TableView, TaskView, TickView, Trial, Yardstick,
};

/// Version of the stream, in `hello`.
pub const STREAM_VERSION: u32 = 1;

/// Trials in `hello`; all of them are at `sessions/{id}/trials`.
pub const HELLO_TRIALS: usize = 1000;

/// Episodes in `hello`; all of them are at `sessions/{id}/episodes`.
pub const HELLO_EPISODES: usize = 400;

/// Cycles of chapter 2 in `hello`.
pub const HELLO_CYCLES: usize = 300;

/// A message from the server. `seq` counts the session's events (`state`, `trial`, `curve`, `episode`,
/// `scores`, `log`, `yardstick`); `tick`, `depths`, `neurons`, `step` and `table` are samples of the present
/// and repeat the number of the last event. Tabular experiments send `step`, `table`, `episode` and `scores`
/// in the place of `tick`, `neurons`, `trial` and `curve`; those of chapter 2 `cycles`, `run` and `summary`.
/// Arena pictures are binary frames: whole PNG files.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS)]
#[serde(tag = "type", rename_all = "lowercase")]
pub enum ServerMessage {
    /// The first message: state and history.
    Hello(Box<Hello>),
    /// State, speed or progress changed.
    State {
        /// Event number.
        seq: u64,
        /// The session now.
        session: Box<Session>,
    },
    /// The present control step.
    Tick {
        /// Number of the last event.
        seq: u64,
        /// The step.
        tick: Box<TickView>,
    },
    /// The sonar readings of the present step.
    Depths {
        /// Number of the last event.
        seq: u64,
        /// Tick they belong to.
        tick: u64,
        /// Metres.
        sonar_m: Vec<f64>,
    },
    /// All neurons, without their centres.
    Neurons {
        /// Number of the last event.
        seq: u64,
        /// Tick they belong to.
        tick: u64,
        /// The neurons.
        neurons: Vec<NeuronView>,
    },
    /// Trials that ended.
    Trial {
        /// Event number.
        seq: u64,
        /// One or more, in order.
        trials: Vec<Trial>,
    },
    /// New points of the learning curves, one per trial that ended.
    Curve {
        /// Event number.
        seq: u64,
        /// One or more, in order.
        points: Vec<CurvePoint>,
    },
    /// The present step of a tabular experiment.
    Step {
        /// Number of the last event.
        seq: u64,
        /// The step.
        step: StepView,
    },
    /// The tables of a tabular experiment.
    Table {
        /// Number of the last event.
        seq: u64,
        /// Tick they belong to.
        tick: u64,
        /// The tables.
        table: TableView,
    },
    /// Episodes that ended.
    Episode {
        /// Event number.
        seq: u64,
        /// One or more, in order.
        episodes: Vec<EpisodeView>,
    },
    /// How the competitors stand after the last of these episodes.
    Scores {
        /// Event number.
        seq: u64,
        /// How they stand.
        scores: ScoresView,
    },
    /// The latest cycles of an experiment of chapter 2: those since the last message, at most the newest 50.
    Cycles {
        /// Number of the last event.
        seq: u64,
        /// In order; the last is the present.
        cycles: Vec<CycleView>,
    },
    /// Runs of chapter 2 that ended.
    Run {
        /// Event number.
        seq: u64,
        /// One or more, in order.
        runs: Vec<DriveRunView>,
    },
    /// How the methods stand after the last of these runs.
    Summary {
        /// Event number.
        seq: u64,
        /// How they stand.
        summary: DriveScores,
    },
    /// New lines of the event log.
    Log {
        /// Event number.
        seq: u64,
        /// One or more, in order.
        entries: Vec<LogEntry>,
    },
    /// The best path a planner finds is known; the regret of trials told before follows from it.
    Yardstick {
        /// Event number.
        seq: u64,
        /// The yardstick.
        yardstick: Box<Yardstick>,
    },
    /// Events between `since` and the first still held are lost; a `hello` with the whole history follows.
    Gap {
        /// What the client had.
        since: u64,
        /// Oldest event still held.
        oldest: u64,
    },
    /// The client's last message could not be used; the connection stays.
    Error {
        /// What was wrong and what would be right.
        message: String,
        /// The field at fault.
        field: Option<String>,
    },
}

/// The history a late page needs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS)]
pub struct Hello {
    /// [`STREAM_VERSION`].
    pub version: u32,
    /// Number of the last event contained.
    pub seq: u64,
    /// The session.
    pub session: Session,
    /// The world it runs in; none for a tabular experiment.
    pub world: Option<WorldView>,
    /// The best path a planner finds there; none for a tabular experiment.
    pub yardstick: Option<Yardstick>,
    /// The world of a tabular experiment.
    pub task: Option<TaskView>,
    /// The tables of a tabular experiment; none before it has started.
    pub table: Option<TableView>,
    /// How its competitors stand.
    pub scores: Option<ScoresView>,
    /// Its newest episodes, at most [`HELLO_EPISODES`].
    pub episodes: Vec<EpisodeView>,
    /// Where the robot of chapter 2 drives; none elsewhere.
    pub course: Option<CourseView>,
    /// The latest cycles of chapter 2, at most [`HELLO_CYCLES`].
    pub cycles: Vec<CycleView>,
    /// Its newest runs, at most [`HELLO_EPISODES`].
    pub runs: Vec<DriveRunView>,
    /// How its methods stand.
    pub summary: Option<DriveScores>,
    /// The newest trials, at most [`HELLO_TRIALS`].
    pub trials: Vec<Trial>,
    /// All neurons, without their centres.
    pub neurons: Vec<NeuronView>,
    /// The last control step, if there was one.
    pub tick: Option<Box<TickView>>,
    /// The event log, newest last, at most 500 lines.
    pub log: Vec<LogEntry>,
}

/// A world as the page needs it for its own drawings.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS)]
pub struct WorldView {
    /// Name.
    pub name: String,
    /// Title for people.
    pub title: String,
    /// Least and greatest x and y of all walls, metres: `[x0, y0, x1, y1]`.
    pub bounds_m: [f64; 4],
    /// Walls as segments `[x0, y0, x1, y1]`, metres.
    pub walls_m: Vec<[f64; 4]>,
    /// Names of the regions, in their fixed order.
    pub regions: Vec<String>,
    /// Where every trial starts.
    pub home: super::PoseView,
    /// Centre of the goal, metres.
    pub goal_m: [f64; 2],
    /// Radius of the goal, metres.
    pub goal_radius_m: f64,
    /// Radius of the robot, metres; of the circle around it, when it is not round.
    pub robot_radius_m: f64,
    /// Corners of a robot that is not round, counter-clockwise, robot frame, metres.
    pub robot_corners_m: Vec<[f64; 2]>,
    /// Range of the sonars, metres.
    pub sonar_range_m: f64,
    /// The sonars, in the order of their readings.
    pub sonars: Vec<SonarView>,
}

/// Where a sonar sits and looks, robot frame: x ahead, y to the left.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, utoipa::ToSchema)]
#[serde(deny_unknown_fields)]
pub struct SonarView {
    /// Metres.
    pub x_m: f64,
    /// Metres.
    pub y_m: f64,
    /// Axis of its cone from the heading, counter-clockwise, degrees.
    pub bearing_deg: f64,
}

/// One point of each learning curve.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS)]
pub struct CurvePoint {
    /// Trial, from 1.
    pub trial: u32,
    /// Neurons after it.
    pub neurons: u32,
    /// Steps taken.
    pub steps: u32,
    /// R(n).
    pub total_reinforcement: f64,
    /// A capped trial has no defined steps or R(n) (section 5.11).
    pub reached_goal: bool,
}

/// A line of the event log.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, utoipa::ToSchema)]
pub struct LogEntry {
    /// When, RFC 3339, UTC.
    pub at: String,
    /// Last tick done.
    pub tick: u64,
    /// `operator`, `session`, `trial` or `warning`.
    pub kind: String,
    /// What happened, a sentence.
    pub text: String,
}

/// A message from a client.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS)]
#[serde(tag = "type", rename_all = "lowercase", deny_unknown_fields)]
pub enum ClientMessage {
    /// What to send and how often. Events are always sent.
    Subscribe {
        /// Most `tick` messages a second, 0 (none) to 60.
        #[serde(default)]
        #[ts(optional)]
        tick: Option<f64>,
        /// Most `depths` messages a second, 0 to 60.
        #[serde(default)]
        #[ts(optional)]
        depths: Option<f64>,
        /// Most `neurons` messages a second, 0 to 30.
        #[serde(default)]
        #[ts(optional)]
        neurons: Option<f64>,
        /// Most `step` messages a second, 0 to 60.
        #[serde(default)]
        #[ts(optional)]
        step: Option<f64>,
        /// Most `cycles` messages a second, 0 to 60.
        #[serde(default)]
        #[ts(optional)]
        cycles: Option<f64>,
        /// Most `table` messages a second, 0 to 30.
        #[serde(default)]
        #[ts(optional)]
        table: Option<f64>,
        /// Arena pictures.
        #[serde(default)]
        #[ts(optional)]
        arena: Option<ArenaRequest>,
    },
}

/// What arena pictures to send.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS)]
#[serde(deny_unknown_fields)]
pub struct ArenaRequest {
    /// Most pictures a second, 0 (none) to 30.
    pub rate: f64,
    /// Pixels, 64 to 2048.
    pub width: u32,
    /// Pixels, 64 to 2048.
    pub height: u32,
    /// `light` or `dark`.
    pub theme: ThemeName,
}

/// Colour theme of a picture.
#[derive(
    Clone,
    Copy,
    Debug,
    Default,
    PartialEq,
    Eq,
    Hash,
    PartialOrd,
    Ord,
    Serialize,
    Deserialize,
    TS,
    utoipa::ToSchema,
)]
#[serde(rename_all = "lowercase")]
pub enum ThemeName {
    /// Dark strokes on a light ground; also for print.
    #[default]
    Light,
    /// Light strokes on a dark ground.
    Dark,
}
