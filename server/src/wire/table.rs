//! Tabular experiments: one step with its explanation, one episode, how the competitors stand, and the
//! tables behind it. Symbols as in chapter 3: x state, u action, y next state, r reward.

use serde::{Deserialize, Serialize};
use ts_rs::TS;
use utoipa::ToSchema;

/// One step of a tabular experiment.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum StepView {
    /// A learner's step in its world (`labyrinth`, `continual`, `gridworld`).
    Walk(Box<WalkView>),
    /// A pull of a lever (`bandit`).
    Pull(Box<PullView>),
    /// A point of a plot (`horizon`).
    Point(PointView),
}

impl StepView {
    /// Number in the session, from 1.
    #[must_use]
    pub fn tick(&self) -> u64 {
        match self {
            Self::Walk(step) => step.tick,
            Self::Pull(step) => step.tick,
            Self::Point(step) => step.tick,
        }
    }

    /// Round of the session that it belongs to, from 1.
    #[must_use]
    pub fn round(&self) -> u32 {
        match self {
            Self::Walk(step) => step.round,
            Self::Pull(step) => step.round,
            Self::Point(step) => step.round,
        }
    }
}

/// A learner's step: chosen, done, learned from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct WalkView {
    /// Number in the session, from 1.
    pub tick: u64,
    /// Round of the session, from 1: one episode of one competitor.
    pub round: u32,
    /// Episode, from 1.
    pub episode: u32,
    /// Competitor whose turn it is.
    pub entrant: String,
    /// It trains on the first task, before the one it is scored in (`continual`).
    pub training: bool,
    /// Trial of the episode, from 1.
    pub trial: u32,
    /// Step of the trial, from 1.
    pub step: u32,
    /// x.
    pub state: u32,
    /// Q(x,·), or an actor's preferences, before the step.
    pub values: Vec<f64>,
    /// What advice and reflex added to each action, log-odds.
    pub pulls: Vec<f64>,
    /// Share of the reflex in that.
    pub reflex_pull: f64,
    /// Chance of each action, Eq. (4.11).
    pub chances: Vec<f64>,
    /// Temperature τ, or ε.
    pub exploration: f64,
    /// u.
    pub action: u32,
    /// y.
    pub next: u32,
    /// The action changed nothing.
    pub bumped: bool,
    /// r and its parts.
    pub reward: RewardView,
    /// What was learned.
    pub update: UpdateView,
    /// The trial that ended with this step.
    pub trial_end: Option<TableTrialView>,
}

/// A reward and its parts.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct RewardView {
    /// r.
    pub total: f64,
    /// The task's own.
    pub task: f64,
    /// For a subgoal.
    pub subgoal: f64,
    /// For running into a wall.
    pub bump: f64,
    /// Of the progress estimator.
    pub progress: f64,
}

/// What one experience changed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct UpdateView {
    /// Value looked ahead to: max Q(y,·), or V(y) for a critic; 0 at an end without transport.
    pub ahead: f64,
    /// γ.
    pub discount: f64,
    /// Learning rate; 1 where a whole backup takes its place.
    pub rate: f64,
    /// r + γ · ahead − before.
    pub delta: f64,
    /// Q(x,u) before, or V(x) for a critic.
    pub before: f64,
    /// The same after.
    pub after: f64,
    /// Further backups made by planning.
    pub planned: u32,
}

/// One trial of an episode.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct TableTrialView {
    /// Actions taken.
    pub steps: u32,
    /// An absorbing state was reached; otherwise the trial was broken off at the cap.
    pub reached_end: bool,
    /// Sum of the task's own rewards.
    pub total_reward: f64,
    /// Actions that changed nothing.
    pub bumps: u32,
}

/// A pull of a lever.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct PullView {
    /// Number in the session, from 1.
    pub tick: u64,
    /// Round of the session, from 1: one episode of one strategy.
    pub round: u32,
    /// Episode, from 1: another row of levers.
    pub episode: u32,
    /// Strategy whose turn it is.
    pub entrant: String,
    /// Pull of the episode, from 1.
    pub pull: u32,
    /// The lever, from 0.
    pub lever: u32,
    /// What was compared of each lever: a mean, or an upper bound; none for one that must be tried first.
    pub scores: Vec<Option<f64>>,
    /// Chance of each lever.
    pub chances: Vec<f64>,
    /// What the lever paid.
    pub paid: f64,
    /// What it pays in the mean, which the agent does not know.
    pub mean: f64,
    /// Regret of this pull, section 3.4.
    pub regret: f64,
    /// Regret of the episode so far.
    pub total_regret: f64,
}

/// A point of a plot of figure 3.3.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct PointView {
    /// Number in the session, from 1.
    pub tick: u64,
    /// Always 1.
    pub round: u32,
    /// `finite-horizon` (3.1), `discounted` (3.3) or `average` (3.4).
    pub model: String,
    /// h or γ; 0 for the average reward, which has none.
    pub parameter: f64,
    /// J of each policy.
    pub values: Vec<f64>,
    /// The best policy, from 0; the first of several.
    pub best: u32,
    /// Where the best policy changed since the last point.
    pub crossing: Option<CrossingView>,
}

/// A place where the best policy changes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct CrossingView {
    /// h or γ.
    pub at: f64,
    /// The best policy before, from 0.
    pub from: u32,
    /// The best policy after.
    pub to: u32,
}

/// One episode of one competitor.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct EpisodeView {
    /// Round of the session, from 1.
    pub round: u32,
    /// Episode, from 1.
    pub episode: u32,
    /// The competitor.
    pub entrant: String,
    /// It trained on the first task, before the one it is scored in (`continual`).
    pub training: bool,
    /// Steps taken.
    pub steps: u64,
    /// First tick.
    pub first_tick: u64,
    /// Last tick.
    pub last_tick: u64,
    /// What came of it.
    pub outcome: OutcomeOfEpisode,
    /// What an operator did to it, in order.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub interventions: Vec<InterventionView>,
}

/// What a session goes through, one after the other: a row of its table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Round {
    /// A trial of a robot.
    Trial(Box<super::Trial>),
    /// An episode of one competitor.
    Episode(Box<EpisodeView>),
    /// A run of chapter 2.
    Run(Box<super::DriveRunView>),
}

impl Round {
    /// Its number in the session, from 1.
    #[must_use]
    pub fn number(&self) -> u32 {
        match self {
            Self::Trial(trial) => trial.trial,
            Self::Episode(episode) => episode.round,
            Self::Run(run) => run.round,
        }
    }

    /// Its last tick.
    #[must_use]
    pub fn last_tick(&self) -> u64 {
        match self {
            Self::Trial(trial) => trial.last_tick,
            Self::Episode(episode) => episode.last_tick,
            Self::Run(run) => run.last_tick,
        }
    }

    /// The trial, if it is one.
    #[must_use]
    pub fn trial(&self) -> Option<&super::Trial> {
        match self {
            Self::Trial(trial) => Some(trial),
            Self::Episode(_) | Self::Run(_) => None,
        }
    }

    /// The episode, if it is one.
    #[must_use]
    pub fn episode(&self) -> Option<&EpisodeView> {
        match self {
            Self::Episode(episode) => Some(episode),
            Self::Trial(_) | Self::Run(_) => None,
        }
    }

    /// The run of chapter 2, if it is one.
    #[must_use]
    pub fn run(&self) -> Option<&super::DriveRunView> {
        match self {
            Self::Run(run) => Some(run),
            Self::Trial(_) | Self::Episode(_) => None,
        }
    }
}

/// What came of an episode.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum OutcomeOfEpisode {
    /// Of trials.
    Walk {
        /// J, Eq. (4.12): actions a trial, on average.
        index: f64,
        /// Actions of each trial.
        trials: Vec<u32>,
        /// Trials broken off at the cap.
        capped: u32,
    },
    /// Of pulls.
    Pull {
        /// Regret.
        regret: f64,
        /// What was paid.
        paid: f64,
        /// Share of pulls of a best lever, 0 to 1.
        best_share: f64,
        /// Regret so far at each hundredth of the pulls.
        course: Vec<f64>,
    },
    /// Of the plots of figure 3.3.
    Plot {
        /// All points.
        points: Vec<PointView>,
    },
}

/// What an operator did during an episode or a run. It holds until that ends.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct InterventionView {
    /// Last tick done before it.
    pub tick: u64,
    /// Trial or cycle it fell into, from 1.
    pub trial: u32,
    /// `advice`, `value`, `table`, `method` or `sonar`.
    pub kind: String,
    /// The advice as it was given, or what was changed.
    pub text: String,
}

/// How the competitors stand.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct ScoresView {
    /// Episodes that every competitor has done.
    pub episodes_done: u32,
    /// `actions a trial` (J, Eq. 4.12) or `regret` (section 3.4); less is better.
    pub measure: String,
    /// What the curves run over: `trial` or `pull`.
    pub over: String,
    /// The competitors, in their order.
    pub scores: Vec<ScoreView>,
    /// Their learning curves, in the same order.
    pub curves: Vec<CompetitorCurve>,
}

/// How one competitor stands.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct ScoreView {
    /// Its name.
    pub name: String,
    /// The one it is compared with; none if with none.
    pub reference: Option<String>,
    /// Episodes it has done.
    pub n: u32,
    /// The measure with its 95 % interval; none of fewer than two episodes.
    pub index: Option<IntervalView>,
    /// Gain r over the reference, Eq. (4.13), percent; none before both have done an episode.
    pub gain_pct: Option<f64>,
    /// Mean of that gain over experiments of ten episodes each, with its 95 % interval.
    pub gain: Option<IntervalView>,
    /// Mean of the last tenth of the trials: what the final policy needs. For strategies, the share of pulls
    /// of a best lever, percent.
    pub last: Option<f64>,
    /// Trials broken off at the cap.
    pub capped: u32,
    /// Pairs of state and action left to try; none where there are no states.
    pub search_space: Option<u32>,
}

/// An estimate with its 95 % interval.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct IntervalView {
    /// The estimate.
    pub value: f64,
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

/// A learning curve with its 95 % band.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct CompetitorCurve {
    /// The competitor.
    pub name: String,
    /// Episodes behind it.
    pub n: u32,
    /// Trial or pull of each point.
    pub at: Vec<f64>,
    /// Mean of each point.
    pub mean: Vec<f64>,
    /// Lower ends; empty of fewer than two episodes.
    pub low: Vec<f64>,
    /// Upper ends.
    pub high: Vec<f64>,
}

/// The present of a tabular session: the tables of the competitor whose turn it is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum TableView {
    /// A learner.
    Walk(Box<LearnerView>),
    /// A strategy.
    Pull(Box<BanditView>),
    /// The plots of figure 3.3.
    Plot(HorizonView),
}

/// A learner at work.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct LearnerView {
    /// Last tick done.
    pub tick: u64,
    /// Episode, from 1.
    pub episode: u32,
    /// Whose turn it is.
    pub entrant: String,
    /// It trains on the first task.
    pub training: bool,
    /// Trial under way, from 1.
    pub trial: u32,
    /// State the agent is in.
    pub state: u32,
    /// State every trial starts in.
    pub start: u32,
    /// Absorbing states.
    pub ends: Vec<u32>,
    /// τ or ε of this trial.
    pub exploration: f64,
    /// The last step; none before the first.
    pub step: Option<Box<WalkView>>,
    /// Q, or an actor's preferences: a row a state, a column an action.
    pub values: Vec<Vec<f64>>,
    /// What the values began with: the belief matrix, where there is one.
    pub beliefs: Vec<Vec<f64>>,
    /// Factor of each chance; 0 excludes an action.
    pub weights: Vec<Vec<f64>>,
    /// Chance of each action in each state, as it would be chosen now.
    pub chances: Vec<Vec<f64>>,
    /// V of each state.
    pub state_values: Vec<f64>,
    /// The values can be edited; behaviours behind a gate have a table each.
    pub editable: bool,
    /// What planning knows and did; none without planning.
    pub planning: Option<PlanningView>,
    /// The advice in force, and what has become of each rule.
    pub advice: Vec<AdviceView>,
}

/// Planning at work.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct PlanningView {
    /// Pairs of state and action that the model knows.
    pub known: u32,
    /// The model: what each known pair led to.
    pub model: Vec<ModelView>,
    /// Backups of the last step, in order.
    pub backups: Vec<BackupView>,
    /// Queue of prioritised sweeping, most urgent first, at most 50: state and priority, Eq. (3.24).
    pub queue: Vec<QueueView>,
}

/// What a pair of state and action has led to.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct ModelView {
    /// x.
    pub state: u32,
    /// u.
    pub action: u32,
    /// y, what is looked ahead to; none at an end.
    pub ahead: Option<u32>,
    /// Share of the times.
    pub chance: f64,
    /// Mean reward.
    pub reward: f64,
}

/// A backup made while planning.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct BackupView {
    /// x.
    pub state: u32,
    /// u.
    pub action: u32,
    /// Q(x,u) before.
    pub before: f64,
    /// The same after.
    pub after: f64,
}

/// A state that waits for a sweep.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct QueueView {
    /// x.
    pub state: u32,
    /// Its priority.
    pub priority: f64,
}

/// A rule of advice, and what has become of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct AdviceView {
    /// As it was written.
    pub text: String,
    /// Weight of the moment, log-odds; 0 once discarded.
    pub weight: f64,
    /// Weight it was given.
    pub first_weight: f64,
    /// How far it holds in the agent's state, 0 to 1.
    pub degree: f64,
    /// Decisions at which it spoke and was followed.
    pub followed: u32,
    /// Decisions at which it spoke and was not.
    pub ignored: u32,
    /// Mean way to the goal after following it, steps; recent trials count more.
    pub steps_followed: f64,
    /// The same after not following it.
    pub steps_ignored: f64,
    /// Trial in which it was given, from 1.
    pub given: u32,
    /// Trial after which it was discarded.
    pub discarded: Option<u32>,
}

/// A strategy at work.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct BanditView {
    /// Last tick done.
    pub tick: u64,
    /// Episode, from 1.
    pub episode: u32,
    /// Strategy whose turn it is.
    pub entrant: String,
    /// Pulls done of this episode.
    pub pull: u32,
    /// The last pull; none before the first.
    pub step: Option<Box<PullView>>,
    /// What each lever pays in the mean, which the agent does not know.
    pub means: Vec<f64>,
    /// What the agent believes of it; 0 where never pulled.
    pub estimates: Vec<f64>,
    /// How often it was pulled.
    pub pulls: Vec<u32>,
}

/// The plots of figure 3.3 so far.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct HorizonView {
    /// Last tick done.
    pub tick: u64,
    /// Points of all plots.
    pub of: u64,
    /// The points so far.
    pub points: Vec<PointView>,
}

/// The world of a tabular experiment.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct TaskView {
    /// `labyrinth`, `maze`, `process`, `levers` or `policies`.
    pub kind: String,
    /// Name.
    pub name: String,
    /// Title for people.
    pub title: String,
    /// The states; none for levers and policies.
    pub states: Vec<StateView>,
    /// Names of the actions, of the levers or of the policies.
    pub actions: Vec<String>,
    /// Rows of the drawing; 0 where there is none.
    pub rows: u32,
    /// Columns of the drawing.
    pub columns: u32,
    /// Where the actions lead; none for levers and policies.
    pub transitions: Vec<TransitionView>,
    /// What advice may speak of.
    pub features: Vec<FeatureView>,
    /// The policies of figure 3.2; none elsewhere.
    pub policies: Vec<PolicyView>,
}

/// A state and its place in the drawing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct StateView {
    /// In words.
    pub name: String,
    /// Row, from 0 at the top; none where there is no drawing.
    pub row: Option<u32>,
    /// Column, from 0 at the left.
    pub column: Option<u32>,
    /// Heading in degrees, counter-clockwise from east; none where it has none.
    pub heading_deg: Option<f64>,
    /// What stands there in the drawing: `S`, `G`, `X`, a room's letter, or nothing.
    pub mark: String,
}

/// One outcome of an action in a state.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct TransitionView {
    /// x.
    pub state: u32,
    /// u.
    pub action: u32,
    /// y.
    pub next: u32,
    /// Its chance.
    pub chance: f64,
    /// r.
    pub reward: f64,
}

/// Something that advice may speak of.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct FeatureView {
    /// Its name.
    pub name: String,
    /// What it is about.
    pub meaning: String,
    /// Its terms, e.g. `near`.
    pub terms: Vec<String>,
}

/// A policy of figure 3.2.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct PolicyView {
    /// Its name.
    pub name: String,
    /// Rewards of the first steps.
    pub lead: Vec<f64>,
    /// Reward of every step after them.
    pub then: f64,
}

/// The whole result of a tabular run: what `run --json` prints and `report.json` holds.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct TableResult {
    /// Name of the experiment.
    pub experiment: String,
    /// Seed.
    pub seed: u64,
    /// Program version and commit.
    pub build: String,
    /// Every setting with its value.
    #[ts(type = "Record<string, number | string | boolean>")]
    #[schema(value_type = Object)]
    pub settings: std::collections::BTreeMap<String, serde_json::Value>,
    /// The episodes.
    pub episodes: Vec<EpisodeView>,
    /// How the competitors stand after the last.
    pub summary: ScoresView,
}

/// Body of `POST sessions/{id}/advice`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, TS, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct AdviceRequest {
    /// Rules, one a line; an empty text takes all advice back.
    pub text: String,
}

/// Body of `POST sessions/{id}/table`: one value, or a whole table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
#[serde(untagged)]
pub enum TableRequest {
    /// One value.
    Value {
        /// x.
        state: u32,
        /// u.
        action: u32,
        /// Q(x,u).
        value: f64,
    },
    /// All values: a row a state, a column an action.
    Table {
        /// Q.
        values: Vec<Vec<f64>>,
    },
}

/// A table of values as it is saved: `GET sessions/{id}/table`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct TableFile {
    /// Name of the experiment.
    pub experiment: String,
    /// Competitor whose values they are.
    pub entrant: String,
    /// Last tick done.
    pub tick: u64,
    /// Names of the states.
    pub states: Vec<String>,
    /// Names of the actions.
    pub actions: Vec<String>,
    /// Q, or an actor's preferences: a row a state, a column an action.
    pub values: Vec<Vec<f64>>,
}
