//! Experiments of chapter 2: a robot driven by rules, cycle by cycle, and what it comes to.

use serde::{Deserialize, Serialize};
use ts_rs::TS;
use utoipa::ToSchema;

use super::{IntervalView, InterventionView, PoseView, SonarView};

/// One cycle of the sonars: read, fused, decided.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct CycleView {
    /// Number in the session, from 1.
    pub tick: u64,
    /// Round of the session, from 1: one run with one method.
    pub round: u32,
    /// Run, from 1; with two methods each run is driven twice, from the same random numbers.
    pub run: u32,
    /// Cycle of the run, from 1.
    pub cycle: u32,
    /// Time from the start of the run to the end of the cycle, seconds.
    pub time_s: f64,
    /// The method that drives.
    pub method: String,
    /// True pose at the end of the cycle.
    pub pose: PoseView,
    /// Velocity, m/s; below 0 it backs up.
    pub speed_m_s: f64,
    /// Turn, deg/s; above 0 to the left.
    pub turn_deg_s: f64,
    /// What the compass says, degrees.
    pub compass_deg: f64,
    /// Load on the motor, 0 at rest to 1 where the robot pushes against something.
    pub motor_load: f64,
    /// The latest reading of each sonar.
    pub readings: Vec<ReadingView>,
    /// The regions, from the left to the right.
    pub regions: Vec<RegionDepthView>,
    /// The rules at work; none where nothing decides.
    pub inference: Option<InferenceView>,
    /// Velocity commanded for the next cycle, m/s.
    pub command_m_s: f64,
    /// Turn commanded for the next cycle, deg/s.
    pub command_deg_s: f64,
    /// A contact that began.
    pub bump: Option<BumpView>,
    /// The robot is backing off by itself.
    pub backing_off: bool,
    /// Clearance of the body at the end of the cycle, metres.
    pub clearance_m: f64,
    /// Where people are, metres.
    pub people_m: Vec<[f64; 2]>,
    /// The first region without a sonar that answers, from 0; it stops the robot.
    pub blind: Option<u32>,
}

/// One reading.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct ReadingView {
    /// Metres; the greatest reading where there is no echo.
    pub range_m: f64,
    /// What it is made of: `echo`, `edge`, `none`, `dropped`, `ghost`, `spurious` or `silent`.
    pub echo: String,
}

/// A region in a cycle. What every method makes of it is there, whichever drives.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct RegionDepthView {
    /// Sonars that answer.
    pub live: u32,
    /// Depth by each method of the course, metres, in their order; empty where every sonar is silent.
    pub depths_m: Vec<f64>,
    /// σ of Algorithm 1, metres.
    pub sigma_m: Option<f64>,
    /// σ of the filter whose depth walks at random, metres.
    pub walk_sigma_m: Option<f64>,
    /// Distance of the nearest surface in the cones of its sonars, metres.
    pub truth_m: f64,
    /// Normalised innovation squared of the median, χ² with one degree of freedom where the filter's
    /// assumptions hold; none of the first reading.
    pub nis: Option<f64>,
    /// Error of the median and Algorithm 1, squared and over its variance.
    pub nees: Option<f64>,
}

/// The rules at work in a cycle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct InferenceView {
    /// The inputs: depths in metres, then the velocity in cm/s.
    pub inputs: Vec<f64>,
    /// Membership of each input in each of its sets, Eq. (2.20).
    pub memberships: Vec<Vec<f64>>,
    /// Rules that fire.
    pub fired: u32,
    /// The strongest of them, at most 12, the strongest first.
    pub firings: Vec<FiringView>,
    /// The outputs, Algorithm 2: velocity in cm/s, turn in deg/s.
    pub outputs: Vec<f64>,
}

/// A rule that fires.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct FiringView {
    /// Its number in the rule base, from 0.
    pub rule: u32,
    /// Its strength, Eq. (2.26).
    pub strength: f64,
    /// The set of each input that it speaks of.
    pub when: Vec<String>,
    /// What it concludes: velocity in cm/s, turn in deg/s.
    pub then: Vec<f64>,
    /// The principles that gave its consequents.
    pub because: String,
}

/// A contact that began.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct BumpView {
    /// `wall`, `door`, `block` or `person`.
    pub what: String,
    /// When, seconds from the start of the run.
    pub time_s: f64,
    /// The front bumper answered; else the rear one.
    pub front: bool,
}

/// One run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct DriveRunView {
    /// Round of the session, from 1.
    pub round: u32,
    /// Run, from 1.
    pub run: u32,
    /// The method that drove when it ended.
    pub method: String,
    /// Cycles.
    pub cycles: u32,
    /// First tick.
    pub first_tick: u64,
    /// Last tick.
    pub last_tick: u64,
    /// What came of it.
    pub outcome: DriveOutcome,
    /// What an operator did during it, in order.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub interventions: Vec<InterventionView>,
}

/// What came of a run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum DriveOutcome {
    /// Of the approach to a wall.
    Approach {
        /// Sum of all changes of the distance itself, metres.
        true_variation_m: f64,
        /// Mean share of sonars that heard a ghost, percent.
        haunted_pct: f64,
        /// How well each method told the distance.
        scores: Vec<MethodScoreView>,
    },
    /// Of a controlled run.
    Drive(Box<DriveScore>),
}

/// How well one method told a distance.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct MethodScoreView {
    /// The method.
    pub method: String,
    /// Root of the mean square of its error, metres.
    pub rms_m: f64,
    /// R² of a straight line in time.
    pub r2: f64,
    /// Sum of all changes from cycle to cycle, metres.
    pub variation_m: f64,
    /// Sum of the changes upwards, metres; the distance itself never rises.
    pub rise_m: f64,
    /// Greatest change, metres.
    pub jump_m: f64,
}

/// What a controlled run came to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct DriveScore {
    /// Seconds.
    pub time_s: f64,
    /// The end of the way was reached; false where there is none.
    pub done: bool,
    /// Way gained, metres.
    pub progress_m: f64,
    /// Length of the path, metres.
    pub path_m: f64,
    /// Way gained in a second, m/s.
    pub forward_m_s: f64,
    /// Way gained over length of the path.
    pub straightness: f64,
    /// Root of the mean square of the heading from the corridor's, degrees.
    pub heading_rms_deg: f64,
    /// Mean velocity, m/s.
    pub speed_m_s: f64,
    /// Share of the cycles slower than 5 cm/s, percent.
    pub slow_pct: f64,
    /// Share of the cycles that back up, percent.
    pub reverse_pct: f64,
    /// Changes of side of the turn in a minute.
    pub flips_per_min: f64,
    /// Mean turn, deg/s, whatever its side.
    pub turn_deg_s: f64,
    /// Contacts with walls.
    pub wall_contacts: u32,
    /// Contacts with door frames.
    pub door_contacts: u32,
    /// Contacts with blocks.
    pub block_contacts: u32,
    /// Contacts with people.
    pub people_contacts: u32,
    /// Doors passed.
    pub doors: u32,
    /// Doors passed without a contact.
    pub clean_doors: u32,
    /// Least clearance, metres.
    pub clearance_m: f64,
    /// Mean normalised innovation of the median over all regions; 1 where the filter is consistent.
    pub nis: Option<f64>,
    /// Mean normalised error of the median and Algorithm 1.
    pub nees: Option<f64>,
    /// Region whose sonars were all silent, from 0, which ended the run.
    pub blind: Option<u32>,
}

/// How the methods stand.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct DriveScores {
    /// Runs that every method has done, without those that an operator changed.
    pub runs_done: u32,
    /// The methods, in their order.
    pub methods: Vec<MethodSummary>,
}

/// How one method stands over those of its runs that no operator changed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct MethodSummary {
    /// The method.
    pub method: String,
    /// Runs.
    pub n: u32,
    /// Runs that reached the end of the way; none where there is no end.
    pub done: Option<u32>,
    /// Measures with their names and 95 % intervals, in a fixed order.
    pub measures: Vec<MeasureView>,
}

/// A measure over the runs of a method.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct MeasureView {
    /// Name for people.
    pub name: String,
    /// Unit; empty for a pure number.
    pub unit: String,
    /// Mean over the runs.
    pub mean: f64,
    /// 95 % interval of the mean; none of fewer than two runs.
    pub interval: Option<IntervalView>,
}

/// Where a robot drives, and what it drives by.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct CourseView {
    /// `wall-approach`, `block-world` or `corridor`.
    pub kind: String,
    /// Title for people.
    pub title: String,
    /// Least and greatest x and y, metres: `[x0, y0, x1, y1]`.
    pub bounds_m: [f64; 4],
    /// Surfaces.
    pub faces: Vec<FaceView>,
    /// Corners of the robot, counter-clockwise, robot frame, metres.
    pub robot_corners_m: Vec<[f64; 2]>,
    /// The sonars, in the order of their readings.
    pub sonars: Vec<SonarView>,
    /// Half the opening of a sonar's cone, degrees.
    pub half_cone_deg: f64,
    /// Range of the sonars, metres.
    pub sonar_range_m: f64,
    /// Sonars of each region, from the left to the right.
    pub regions: Vec<Vec<u32>>,
    /// Methods by which a depth is made, in the order of `depths_m`, with what each means.
    pub methods: Vec<MethodView>,
    /// Methods that drive, by turns.
    pub drivers: Vec<String>,
    /// Doors across a corridor.
    pub doors: Vec<DoorView>,
    /// x at which a run is done, metres; none where it has no end.
    pub finish_m: Option<f64>,
    /// Radius of a person, metres.
    pub person_radius_m: f64,
    /// Bounds within which 95 % of single NIS and NEES values lie where the filter is consistent: χ² with one
    /// degree of freedom.
    pub chi_square: [f64; 2],
    /// The rules that drive; none in the approach to a wall.
    pub rules: Option<RuleBaseView>,
}

/// A piece of surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct FaceView {
    /// `[x0, y0, x1, y1]`, metres.
    pub segment_m: [f64; 4],
    /// `wall`, `door` or `block`.
    pub surface: String,
}

/// A way of making a depth.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct MethodView {
    /// Value of the setting `fusion.method`.
    pub name: String,
    /// What it is.
    pub meaning: String,
}

/// A door across a corridor.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct DoorView {
    /// Where along the corridor, metres.
    pub x_m: f64,
    /// Half its width, metres.
    pub half_width_m: f64,
}

/// A rule base without its rules.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct RuleBaseView {
    /// Name.
    pub name: String,
    /// Title for people.
    pub title: String,
    /// The inputs with their sets.
    pub inputs: Vec<VariableView>,
    /// The outputs.
    pub outputs: Vec<VariableView>,
    /// Rules.
    pub rules: u32,
}

/// A variable of a rule base.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct VariableView {
    /// Its name.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Least and greatest value.
    pub range: [f64; 2],
    /// Its sets; none of an output that rules conclude numbers about.
    pub sets: Vec<SetView>,
}

/// A fuzzy set.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct SetView {
    /// Its linguistic value.
    pub name: String,
    /// Where membership begins to rise, is 1, begins to fall and is 0; cut at the variable's range.
    pub corners: [f64; 4],
}

/// A rule base, rule by rule: `GET rules/{name}`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct RuleList {
    /// What it is about.
    pub base: RuleBaseView,
    /// Its rules, in their order.
    pub rules: Vec<RuleView>,
}

/// A rule.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct RuleView {
    /// Its number, from 0.
    pub rule: u32,
    /// The set of each input.
    pub when: Vec<String>,
    /// What it concludes about each output.
    pub then: Vec<f64>,
    /// The principles that gave its consequents.
    pub because: String,
}

/// The whole result of a run of chapter 2: what `run --json` prints and `report.json` holds.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct DriveResult {
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
    /// The runs; an episode is a run of one method.
    pub episodes: Vec<DriveRunView>,
    /// How the methods stand after the last.
    pub summary: DriveScores,
}

/// Body of `POST sessions/{id}/method`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, TS, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct MethodRequest {
    /// The method that drives from the next cycle on, until the run ends.
    pub method: String,
}

/// Body of `POST sessions/{id}/sonars`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, TS, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct SonarRequest {
    /// Which sonar, from 0.
    pub sonar: u32,
    /// Whether it falls silent, or answers again.
    pub silent: bool,
}
