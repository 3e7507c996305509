//! Sessions: what is asked for, what is answered.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use ts_rs::TS;
use utoipa::ToSchema;

use super::PlaceView;

/// The state of a session. It is never a lie: after a crash it reads `interrupted`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, TS, ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum State {
    /// Created, or asked to start while all cores are busy.
    Queued,
    /// Loading its world or checkpoint.
    Starting,
    /// Taking control steps.
    Running,
    /// Held between two ticks.
    Paused,
    /// Writing its last checkpoint and closing its log.
    Stopping,
    /// Ended by an operator before its last trial.
    Stopped,
    /// All trials done.
    Finished,
    /// Could not go on; the reason is given.
    Failed,
    /// The server ended while it ran; it can be resumed from its last checkpoint.
    Interrupted,
}

/// Which kind of experiment a session runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum Family {
    /// A robot learns a path.
    #[default]
    Path,
    /// Learners with tables compete.
    Table,
    /// A robot is driven by rules (chapter 2).
    Drive,
}

/// Pace of a session.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
#[serde(untagged)]
pub enum Speed {
    /// Control steps a second, 0.1 to 10000.
    TicksPerSecond(f64),
    /// As fast as it goes.
    Named(NamedSpeed),
}

/// A pace with a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, TS, ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum NamedSpeed {
    /// As fast as it goes.
    Max,
}

/// Body of `POST /api/v1/sessions`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct NewSession {
    /// Name of the experiment.
    pub experiment: String,
    /// Seed, 0 to 2⁵³ − 1; drawn when missing, and always shown.
    #[serde(default)]
    #[ts(optional)]
    pub seed: Option<u64>,
    /// Settings that differ from the preset's; `preset` and `world` are settings too.
    #[serde(default)]
    #[ts(optional, type = "Record<string, number | string | boolean>")]
    #[schema(value_type = Object)]
    pub settings: BTreeMap<String, Value>,
    /// Number of trials; in a tabular experiment those of each episode (the pulls of a bandit).
    #[serde(default)]
    #[ts(optional)]
    pub trials: Option<u32>,
    /// Pace; 30 ticks a second when missing.
    #[serde(default)]
    #[ts(optional)]
    pub speed: Option<Speed>,
    /// Trained networks to begin with instead of empty ones: a network file, or the identifier of a
    /// session, whose networks are taken as its last finished trial left them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[ts(optional, type = "string | NetworkFile")]
    #[schema(value_type = Option<NetworkSource>)]
    pub network: Option<Value>,
}

/// Where trained networks come from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(untagged)]
pub enum NetworkSource {
    /// A session's identifier.
    Session(String),
    /// A network file.
    File(Box<super::NetworkFile>),
}

/// A session.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct Session {
    /// Identifier.
    pub id: String,
    /// Name of the experiment.
    pub experiment: String,
    /// State.
    pub state: State,
    /// Why it failed or was interrupted.
    pub reason: Option<String>,
    /// Seed.
    pub seed: u64,
    /// Preset the settings started from.
    pub preset: String,
    /// World it runs in.
    pub world: String,
    /// Every setting with its value, `preset` and `world` included.
    #[ts(type = "Record<string, number | string | boolean>")]
    #[schema(value_type = Object)]
    pub settings: BTreeMap<String, Value>,
    /// Keys whose value is not the default's.
    pub changed: Vec<String>,
    /// Which kind of experiment it runs.
    pub family: Family,
    /// Trials asked for: of the session, of each episode of a tabular experiment, or runs of each method.
    pub trials: u32,
    /// Trials done; in a tabular experiment, of all episodes that ended.
    pub trials_done: u32,
    /// What the session goes through: its trials, episodes of one competitor each, or runs of one method each.
    pub rounds: u32,
    /// Rounds done.
    pub rounds_done: u32,
    /// Trials that reached the goal.
    pub reached: u32,
    /// Best total reinforcement of a trial that reached the goal.
    pub best: Option<f64>,
    /// Last tick.
    pub tick: u64,
    /// Pace.
    pub speed: Speed,
    /// Program version and commit it runs on.
    pub build: String,
    /// When it was created, RFC 3339, UTC.
    pub created_at: String,
    /// When it last changed state, RFC 3339, UTC.
    pub changed_at: String,
    /// Controls that would be accepted now: `start`, `pause`, `resume`, `step`, `stop`, `reset`.
    pub controls: Vec<String>,
}

/// Answer to a control: the state it led to and the tick at which it took effect.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, TS, ToSchema)]
pub struct Ack {
    /// State after the control.
    pub state: State,
    /// Last tick done when it took effect.
    pub tick: u64,
}

/// Body of `POST sessions/{id}/step`; may be left out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct StepRequest {
    /// How far to go before holding again.
    #[serde(default)]
    pub unit: StepUnit,
}

/// How far one step goes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum StepUnit {
    /// One control step.
    #[default]
    Tick,
    /// To the end of the trial, or of the episode of a tabular experiment.
    Trial,
}

/// Body of `POST sessions/{id}/speed`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct SpeedRequest {
    /// The new pace.
    pub speed: Speed,
}

/// One trial: a row of the trial table and a point of each learning curve.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct Trial {
    /// Trial, from 1.
    pub trial: u32,
    /// Control steps taken.
    pub steps: u32,
    /// Total reinforcement R(n), Eq. (5.27).
    pub total_reinforcement: f64,
    /// Share of R(n) from the safety part, Eq. (5.6).
    pub safety: f64,
    /// Share of R(n) from the goal part, Eq. (5.7).
    pub goal: f64,
    /// What `goal` would be, had the robot known where it was; none in logs of older programs.
    #[serde(default)]
    pub true_goal: Option<f64>,
    /// Neurons after the trial.
    pub neurons: u32,
    /// Neurons added.
    pub born: u32,
    /// Neurons deleted at its end.
    pub forgotten: u32,
    /// Real and virtual collisions.
    pub collisions: u32,
    /// The goal was reached; otherwise the trial was capped.
    pub reached_goal: bool,
    /// It beat every earlier successful trial.
    pub record: bool,
    /// A scout set out in it (A6).
    #[serde(default)]
    pub scout: bool,
    /// Temperature T(n), degrees.
    pub temperature_deg: f64,
    /// Length of the true path, metres.
    pub path_m: f64,
    /// Regret R* − R(n): what the best path that a planner finds would have earned more, with the goal where it
    /// truly was. None when the goal was not reached, no way was planned, or planning is not done yet; never in the log.
    #[serde(default)]
    pub regret: Option<f64>,
    /// Steps taken in each region, by the region's name.
    pub region_steps: BTreeMap<String, u32>,
    /// First tick.
    pub first_tick: u64,
    /// Last tick.
    pub last_tick: u64,
}

impl Trial {
    /// R(n) as it was, had the robot known where the goal was; R(n) itself in logs of older programs.
    #[must_use]
    pub fn true_total_reinforcement(&self) -> f64 {
        self.safety + self.true_goal.unwrap_or(self.goal)
    }
}

/// Summary over trials.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct Summary {
    /// Trials done.
    pub trials: u32,
    /// Trials that reached the goal.
    pub reached: u32,
    /// Best total reinforcement of a successful trial.
    pub best_total_reinforcement: Option<f64>,
    /// The trial that holds it.
    pub best_trial: Option<u32>,
    /// Steps of the last trial.
    pub last_steps: Option<u32>,
    /// Total reinforcement of the last trial.
    pub last_total_reinforcement: Option<f64>,
    /// Total reinforcement R* of the best path that a planner finds; none when it finds no way.
    #[serde(default)]
    pub planned_total_reinforcement: Option<f64>,
    /// Regret of the last trial, R* − R(n); none when it did not reach the goal.
    #[serde(default)]
    pub last_regret: Option<f64>,
    /// The same in percent of R*; none when the best path costs nothing.
    #[serde(default)]
    pub last_regret_pct: Option<f64>,
    /// Neurons after the last trial.
    pub neurons: u32,
    /// Collisions over all trials.
    pub collisions: u32,
    /// Control steps over all trials.
    pub steps: u64,
}

/// The whole result of a run: what `run --json` prints and `report.json` starts with.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct RunResult {
    /// Name of the experiment.
    pub experiment: String,
    /// Seed.
    pub seed: u64,
    /// Program version and commit.
    pub build: String,
    /// Every setting with its value.
    #[ts(type = "Record<string, number | string | boolean>")]
    #[schema(value_type = Object)]
    pub settings: BTreeMap<String, Value>,
    /// The trials.
    pub trials: Vec<Trial>,
    /// Their summary.
    pub summary: Summary,
    /// What the networks do afterwards from altered starts, where there are any.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub starts: Vec<super::AlteredStartView>,
}

/// RFC 9457 problem details.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct Problem {
    /// What kind of problem, as a relative reference, e.g. `/problems/out-of-range`.
    #[serde(rename = "type")]
    pub kind: String,
    /// What is wrong, in a few words.
    pub title: String,
    /// HTTP status.
    pub status: u16,
    /// What is wrong here, and what would be right.
    pub detail: String,
    /// The field at fault, e.g. `settings.sonar.noise`.
    pub field: Option<String>,
    /// The place at fault in a world.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[ts(optional)]
    pub place: Option<PlaceView>,
}
