// Generated from server/src/wire/*.rs, do not edit. To write it again:
//   UPDATE_PROTOCOL=1 cargo test -p sonarium --lib wire

/** One experiment that can be run. */
export type ExperimentInfo = {
/** Name used in the interface, e.g. `minimum-cost-path`. */
name: string,
/** Title for people. */
title: string,
/** What it shows, a sentence or two. */
summary: string,
/** Where the thesis describes it. */
source: string,
/** Which kind of experiment it is. */
family: Family,
/** The robot that runs it; none in a tabular experiment. */
robot: RobotInfo | null,
/** Trials of a session, or of each episode of a tabular experiment, unless told otherwise. */
default_trials: number,
/** Most trials a session may have. */
max_trials: number,
/** Sets of settings with a name; the first is the default. */
presets: Array<PresetInfo>,
/** Worlds it can run in; the first is the default. None where there is but one. */
worlds: Array<WorldInfo>,
/** Altered starts in the default world, which trained networks are tried from. */
starts: Array<StartView>,
/** Every setting. */
settings: Array<SettingInfo>, };

/** A robot. */
export type RobotInfo = {
/** Name, that of its file. */
name: string,
/** Title for people. */
title: string,
/** What it is. */
summary: string,
/** Where it comes from. */
source: string, };

/** A named set of settings. */
export type PresetInfo = {
/** Value of the setting `preset`. */
name: string,
/** Title for people. */
title: string,
/** What it stands for. */
summary: string,
/** Settings that differ from the defaults. */
settings: Record<string, number | string | boolean>, };

/** A world that can be chosen. */
export type WorldInfo = {
/** Value of the setting `world`. */
name: string,
/** Title for people. */
title: string,
/** What it is. */
summary: string, };

/** One setting: what it means and what it may be. */
export type SettingInfo = {
/** Key, e.g. `sonar.noise`. */
key: string,
/** What it means. */
meaning: string,
/** `number`, `integer`, `switch`, `choice` or `text`. */
kind: string,
/** Unit; empty for a choice, a switch or a pure number. */
unit: string,
/** Default. */
default: number | string | boolean,
/** Least value of a number. */
min: number | null,
/** Greatest value of a number. */
max: number | null,
/** What a choice can be. */
choices: Array<Choice>,
/** Equation, section or reading it comes from. */
source: string,
/** `literal`, `reading`, `gap`, `deviation`, `addition` or `simulation`. */
standing: string, };

/** One value of a choice. */
export type Choice = {
/** The value. */
value: string,
/** What it means. */
meaning: string, };

/** The state of a session. It is never a lie: after a crash it reads `interrupted`. */
export type State = "queued" | "starting" | "running" | "paused" | "stopping" | "stopped" | "finished" | "failed" | "interrupted";

/** Which kind of experiment a session runs. */
export type Family = "path" | "table" | "drive";

/** Pace of a session. */
export type Speed = number | NamedSpeed;

/** A pace with a name. */
export type NamedSpeed = "max";

/** Body of `POST /api/v1/sessions`. */
export type NewSession = {
/** Name of the experiment. */
experiment: string,
/** Seed, 0 to 2⁵³ − 1; drawn when missing, and always shown. */
seed?: number,
/** Settings that differ from the preset's; `preset` and `world` are settings too. */
settings?: Record<string, number | string | boolean>,
/** Number of trials; in a tabular experiment those of each episode (the pulls of a bandit). */
trials?: number,
/** Pace; 30 ticks a second when missing. */
speed?: Speed,
/** Trained networks to begin with instead of empty ones: a network file, or the identifier of a
 * session, whose networks are taken as its last finished trial left them. */
network?: string | NetworkFile, };

/** A session. */
export type Session = {
/** Identifier. */
id: string,
/** Name of the experiment. */
experiment: string,
/** State. */
state: State,
/** Why it failed or was interrupted. */
reason: string | null,
/** Seed. */
seed: number,
/** Preset the settings started from. */
preset: string,
/** World it runs in. */
world: string,
/** Every setting with its value, `preset` and `world` included. */
settings: Record<string, number | string | boolean>,
/** Keys whose value is not the default's. */
changed: Array<string>,
/** Which kind of experiment it runs. */
family: Family,
/** Trials asked for: of the session, of each episode of a tabular experiment, or runs of each method. */
trials: number,
/** Trials done; in a tabular experiment, of all episodes that ended. */
trials_done: number,
/** What the session goes through: its trials, episodes of one competitor each, or runs of one method each. */
rounds: number,
/** Rounds done. */
rounds_done: number,
/** Trials that reached the goal. */
reached: number,
/** Best total reinforcement of a trial that reached the goal. */
best: number | null,
/** Last tick. */
tick: number,
/** Pace. */
speed: Speed,
/** Program version and commit it runs on. */
build: string,
/** When it was created, RFC 3339, UTC. */
created_at: string,
/** When it last changed state, RFC 3339, UTC. */
changed_at: string,
/** Controls that would be accepted now: `start`, `pause`, `resume`, `step`, `stop`, `reset`. */
controls: Array<string>, };

/** Answer to a control: the state it led to and the tick at which it took effect. */
export type Ack = {
/** State after the control. */
state: State,
/** Last tick done when it took effect. */
tick: number, };

/** Body of `POST sessions/{id}/step`; may be left out. */
export type StepRequest = {
/** How far to go before holding again. */
unit: StepUnit, };

/** How far one step goes. */
export type StepUnit = "tick" | "trial";

/** Body of `POST sessions/{id}/speed`. */
export type SpeedRequest = {
/** The new pace. */
speed: Speed, };

/** One trial: a row of the trial table and a point of each learning curve. */
export type Trial = {
/** Trial, from 1. */
trial: number,
/** Control steps taken. */
steps: number,
/** Total reinforcement R(n), Eq. (5.27). */
total_reinforcement: number,
/** Share of R(n) from the safety part, Eq. (5.6). */
safety: number,
/** Share of R(n) from the goal part, Eq. (5.7). */
goal: number,
/** What `goal` would be, had the robot known where it was; none in logs of older programs. */
true_goal: number | null,
/** Neurons after the trial. */
neurons: number,
/** Neurons added. */
born: number,
/** Neurons deleted at its end. */
forgotten: number,
/** Real and virtual collisions. */
collisions: number,
/** The goal was reached; otherwise the trial was capped. */
reached_goal: boolean,
/** It beat every earlier successful trial. */
record: boolean,
/** A scout set out in it (A6). */
scout: boolean,
/** Temperature T(n), degrees. */
temperature_deg: number,
/** Length of the true path, metres. */
path_m: number,
/** Regret R* − R(n): what the best path that a planner finds would have earned more, with the goal where it
 * truly was. None when the goal was not reached, no way was planned, or planning is not done yet; never in the log. */
regret: number | null,
/** Steps taken in each region, by the region's name. */
region_steps: { [key in string]: number },
/** First tick. */
first_tick: number,
/** Last tick. */
last_tick: number, };

/** Summary over trials. */
export type Summary = {
/** Trials done. */
trials: number,
/** Trials that reached the goal. */
reached: number,
/** Best total reinforcement of a successful trial. */
best_total_reinforcement: number | null,
/** The trial that holds it. */
best_trial: number | null,
/** Steps of the last trial. */
last_steps: number | null,
/** Total reinforcement of the last trial. */
last_total_reinforcement: number | null,
/** Total reinforcement R* of the best path that a planner finds; none when it finds no way. */
planned_total_reinforcement: number | null,
/** Regret of the last trial, R* − R(n); none when it did not reach the goal. */
last_regret: number | null,
/** The same in percent of R*; none when the best path costs nothing. */
last_regret_pct: number | null,
/** Neurons after the last trial. */
neurons: number,
/** Collisions over all trials. */
collisions: number,
/** Control steps over all trials. */
steps: number, };

/** The whole result of a run: what `run --json` prints and `report.json` starts with. */
export type RunResult = {
/** Name of the experiment. */
experiment: string,
/** Seed. */
seed: number,
/** Program version and commit. */
build: string,
/** Every setting with its value. */
settings: Record<string, number | string | boolean>,
/** The trials. */
trials: Array<Trial>,
/** Their summary. */
summary: Summary,
/** What the networks do afterwards from altered starts, where there are any. */
starts?: Array<AlteredStartView>, };

/** The best path a planner finds in the world and on the cost of a session. */
export type Yardstick = { "state": "computing" } | { "state": "none" } | { "state": "ready" } & PlannedPath;

/** A path that the robot could drive, were its sensors and odometry without error. */
export type PlannedPath = {
/** Its total reinforcement R*, Eq. (5.27). */
total_reinforcement: number,
/** Control steps. */
steps: number,
/** Steps that end in a collision. */
collisions: number,
/** What the planner's finest search still gained: R* may be better by about as much again. */
resolution: number,
/** Its places, metres, home first. */
path_m: Array<[number, number]>, };

/** RFC 9457 problem details. */
export type Problem = {
/** What kind of problem, as a relative reference, e.g. `/problems/out-of-range`. */
type: string,
/** What is wrong, in a few words. */
title: string,
/** HTTP status. */
status: number,
/** What is wrong here, and what would be right. */
detail: string,
/** The field at fault, e.g. `settings.sonar.noise`. */
field: string | null,
/** The place at fault in a world. */
place?: PlaceView, };

/** Position and heading. */
export type PoseView = {
/** Metres. */
x_m: number,
/** Metres. */
y_m: number,
/** Degrees, counter-clockwise from the x axis, in [-180, 180). */
heading_deg: number, };

/** One control step: sensed, adapted, decided, moved. */
export type TickView = {
/** Number in the session, from 1. */
tick: number,
/** Trial, from 1. */
trial: number,
/** Step within the trial, from 1. */
step: number,
/** True pose when sensing. */
true_pose: PoseView,
/** Believed pose when sensing: by odometry, and by the sonars where it is corrected (A10). */
pose: PoseView,
/** How that was found; none where odometry is not corrected. */
fix: FixView | null,
/** One reading a sonar, metres from where it sits; `hello` and the robot's file say where each looks. */
sonar_m: Array<number>,
/** Strongest infrared reflectance, percent. */
reflectance_pct: number,
/** Believed distance to the goal, metres. */
goal_distance_m: number,
/** Believed bearing of the goal from the heading, degrees. */
goal_bearing_deg: number,
/** Region the robot believes to be in. */
region: string,
/** Nearest neuron of the region's network, Eq. (5.10). */
winner: WinnerView | null,
/** Neuron added at this situation. */
born: number | null,
/** Place of the record path that the action makes for, metres: that of a new neuron (D2), or of one that is
 * not of the record path (A9). */
toward_m: [number, number] | null,
/** The reflex, when it was asked, Eq. (5.8). */
reflex: ReflexView | null,
/** What happened to the past neuron, section 5.9. */
adaptation: AdaptationView,
/** Neuron in charge; none when learning is off. */
neuron: number | null,
/** Its prototypical action p, degrees. */
prototypical_deg: number,
/** Its utility u; none while pending. */
utility: number | null,
/** Where its mean points, when it aims along a shortcut (addition A1). */
aim: AimView | null,
/** The stochastic unit, Eq. (5.12)-(5.16). */
exploration: ExplorationView,
/** `network`, `reflex`, `bend`, `pursuit`, `sidestep`, `escape` or `scout`. */
source: string,
/** Action α, degrees, Eq. (5.15). */
action_deg: number,
/** Frame of p and α: `heading`, `rotation` or `goal`. */
action_frame: string,
/** Rotation executed before the advance, degrees. */
rotation_deg: number,
/** What came of it. */
outcome: OutcomeView,
/** Neurons in all networks after this tick. */
neurons: number,
/** Total reinforcement of the trial so far. */
total_reinforcement: number, };

/** A pose found by odometry and sonars (A10). */
export type FixView = {
/** The pose by odometry alone. */
odometry: PoseView,
/** Echoes that agreed with what was heard here before; 0 where nothing was. */
echoes: number,
/** Standard deviation of the position, metres. */
spread_m: number, };

/** The nearest neuron. */
export type WinnerView = {
/** Its number. */
neuron: number,
/** ‖x − c‖. */
distance: number, };

/** The fuzzy reflex at work: activations of left, forward and right. */
export type ReflexView = {
/** Nearest reading ahead, to the left and to the right, metres. */
nearest_m: [number, number, number],
/** Membership of "near" ahead, left and right, 0 to 1. */
near: [number, number, number],
/** Obstacle avoidance: left, forward, right. */
avoid: [number, number, number],
/** Goal following: left, forward, right. */
goal: [number, number, number],
/** Fused, Eq. (5.8): left, forward, right. */
fused: [number, number, number],
/** Defuzzified rotation, degrees. */
rotation_deg: number, };

/** The stochastic unit. */
export type ExplorationView = {
/** T(n), degrees. */
temperature_deg: number,
/** μ of the winner, degrees. */
mean_deg: number,
/** σ = T(n) / (1 + exp(u)), degrees. */
sigma_deg: number,
/** Standard deviation of the draw, degrees. */
deviation_deg: number,
/** ξ as drawn, degrees. */
drawn_deg: number,
/** Most that ξ may be, degrees: T(n), or |μ| along a shortcut that turns by more (addition A11); none in logs
 * of older programs, where it was T(n). */
most_deg: number | null,
/** ξ clipped to that, degrees. */
xi_deg: number, };

/** What happened to the past neuron. */
export type AdaptationView = { "kind": "no-past" } | { "kind": "off" } | { "kind": "pending",
/** Past neuron. */
past: number, } | { "kind": "split",
/** Past neuron. */
past: number,
/** TD error. */
delta: number,
/** Neuron added at the past situation. */
added: number, } | { "kind": "updated",
/** Past neuron i. */
past: number,
/** r(t+1). */
reinforcement: number,
/** u_j of the present neuron. */
present_utility: number,
/** u_i before. */
utility_before: number,
/** δ(t+1), Eq. (5.19). */
delta: number,
/** η_r or η_p, Eq. (5.20). */
utility_rate: number,
/** u_i after. */
utility_after: number,
/** Eligibility, Eq. (5.23), per degree. */
eligibility: number,
/** μ_i before, degrees. */
mean_before_deg: number,
/** μ_i after, degrees. */
mean_after_deg: number,
/** Way the centre moved, Eq. (5.25). */
centre_shift: number, };

/** The consequence of an action. */
export type OutcomeView = {
/** True pose after the motion and any rescue. */
true_pose: PoseView,
/** Believed pose after it. */
pose: PoseView,
/** `none`, `virtual` (infrared) or `real` (tactile). */
contact: string,
/** Way backed off, metres. */
backed_m: number,
/** r(t+1) = f₁ + f₂. */
reinforcement: number,
/** f₁, Eq. (5.6). */
safety: number,
/** f₂, Eq. (5.7). */
goal: number,
/** Close flag of Eq. (5.6). */
close: boolean,
/** The robot is at the goal. */
reached_goal: boolean, };

/** A neuron: its four parameters and its birth certificate. */
export type NeuronView = {
/** Its number in the session. */
id: number,
/** Region whose network it belongs to. */
region: string,
/** Centre c: normalised sonars, then 8 distance units. Left out of the live stream, and
 * at the end of a trial that did not change it. */
centre?: Array<number>,
/** Prototypical action p, degrees. */
prototypical_deg: number,
/** Heading that p meant at its birth pose, degrees, for drawing. */
heading_deg: number,
/** Mean μ, degrees. */
mean_deg: number,
/** Utility u; none while pending. */
utility: number | null,
/** Times it won. */
wins: number,
/** Birth certificate. */
birth: BirthView, };

/** When and why a neuron was added. */
export type BirthView = {
/** Trial. */
trial: number,
/** Step within the trial. */
step: number,
/** Tick. */
tick: number,
/** `empty`, `distance`, `error` or `rescue`. */
cause: string,
/** The distance or the TD error that caused it. */
value: number | null,
/** Neuron its action was copied from. */
parent: number | null,
/** Place of the record path that its action made for, metres (D2); with no parent either, the reflex was
 * asked. */
toward_m: [number, number] | null,
/** Believed pose at that moment. */
pose: PoseView, };

/** What the learner did at the end of a trial. */
export type TrialEndView = {
/** The trial's row. */
trial: Trial,
/** Utilities set by back-tracking, Eq. (5.26). */
backed_up: Array<ChangeView>,
/** Prototypical actions replaced, Eq. (5.28), degrees. */
replaced: Array<ChangeView>,
/** Shortcuts proposed (addition A1), with their reason. */
proposed: Array<ProposalView>,
/** What came of the shortcuts followed without a record (addition A8). */
judged: Array<VerdictView>,
/** Neurons deleted (addition D3). */
forgotten: Array<number>,
/** All neurons after the trial; centres only where the trial set or moved them. */
neurons: Array<NeuronView>, };

/** A value changed at the end of a trial. */
export type ChangeView = {
/** The neuron. */
neuron: number,
/** Before. */
before: number,
/** After. */
after: number, };

/** A place a neuron aims at (addition A1), odometry frame. */
export type AimView = {
/** Metres. */
x_m: number,
/** Metres. */
y_m: number,
/** Where the way leads on from there, metres, if it bends there (addition A3). */
beyond_m: [number, number] | null,
/** Neuron in charge at its end on the record path; none at the goal. */
then: number | null, };

/** A shortcut proposed at the end of a record trial (addition A1), and why. */
export type ProposalView = {
/** The neuron. */
neuron: number,
/** Its mean before, degrees. */
before: number,
/** Its mean after, from its prototypical action to the aim, degrees. */
after: number,
/** Where it aims. */
aim: AimView,
/** Step of the record path that ended there. */
step: number,
/** Reinforcement predicted for driving straight there. */
straight: number,
/** Utility there; 0 at the goal. */
utility: number, };

/** What came of a shortcut that was followed in a trial without a record (addition A8). */
export type VerdictView = {
/** The neuron whose shortcut it is. */
neuron: number,
/** δ over the way, Eq. (5.19) over several steps; none where it began off the record path or never came back
 * to it. */
delta: number | null,
/** It is not followed again. */
withdrawn: boolean, };

/** A pose to start from. */
export type StartView = {
/** Name for people. */
name: string,
/** Metres. */
x_m: number,
/** Metres. */
y_m: number,
/** Degrees, counter-clockwise from the x axis. */
heading_deg: number, };

/** What the networks of a run, as they are after its last trial, do from an altered start: without
 * exploring, growing or adapting. */
export type AlteredStartView = {
/** The start. */
start: StartView,
/** A neuron is active at the start: the situation lies in its receptive field. */
inside: boolean,
/** Distance to the nearest place where a neuron was born, metres; none without neurons. */
explored_m: number | null,
/** The network alone: where no neuron is active, the nearest acts. */
alone: ExcursionView,
/** The network with the reflex where no neuron is active. */
guided: ExcursionView, };

/** One way from an altered start. */
export type ExcursionView = {
/** It ended at the goal. */
reached_goal: boolean,
/** Control steps taken. */
steps: number,
/** Total reinforcement R, Eq. (5.27). */
total_reinforcement: number,
/** Real and virtual collisions. */
collisions: number,
/** Share of the steps at which no neuron was active, percent. */
silent_pct: number,
/** True positions, metres, the start first; left out of `run --json`. */
path_m?: Array<[number, number]>, };

/** Trained networks with everything that decides where they can be used. */
export type NetworkFile = {
/** `sonarium-network`. */
format: string,
/** [`NETWORK_VERSION`]. */
version: number,
/** Program version and commit that trained them. */
build: string,
/** Experiment they were trained in. */
experiment: string,
/** Robot they were trained on. */
robot: string,
/** Its sonars, in the order of the inputs. */
sonars: Array<SonarView>,
/** How readings became inputs. */
input: InputSpans,
/** Frame of the prototypical actions: `heading`, `rotation` or `goal`. */
action_frame: string,
/** World they were trained in. */
world: string,
/** Regions of that world, one network each; `all` when there was one network for all. */
regions: Array<string>,
/** Goal they were trained for. */
goal: GoalView,
/** Every setting of the training. */
settings: Record<string, number | string | boolean>,
/** Seed of the training. */
seed: number,
/** Trials of the training. */
trials: number,
/** The neurons of each network, in the order of the regions. Angles are radians where the name says
 * so, since a file must give back every bit. */
networks: unknown[][], };

/** How readings became inputs. */
export type InputSpans = {
/** Sonar reading that becomes 1, metres. */
sonar_span_m: number,
/** Distance to the goal that becomes 1, metres. */
distance_span_m: number,
/** Frame of the sonars: `robot` or `odometry`. */
sonar_frame: string, };

/** A goal. */
export type GoalView = {
/** Metres. */
x_m: number,
/** Metres. */
y_m: number,
/** Metres. */
radius_m: number, };

/** A message from the server. `seq` counts the session's events (`state`, `trial`, `curve`, `episode`,
 * `scores`, `log`, `yardstick`); `tick`, `depths`, `neurons`, `step` and `table` are samples of the present
 * and repeat the number of the last event. Tabular experiments send `step`, `table`, `episode` and `scores`
 * in the place of `tick`, `neurons`, `trial` and `curve`; those of chapter 2 `cycles`, `run` and `summary`.
 * Arena pictures are binary frames: whole PNG files. */
export type ServerMessage = { "type": "hello" } & Hello | { "type": "state",
/** Event number. */
seq: number,
/** The session now. */
session: Session, } | { "type": "tick",
/** Number of the last event. */
seq: number,
/** The step. */
tick: TickView, } | { "type": "depths",
/** Number of the last event. */
seq: number,
/** Tick they belong to. */
tick: number,
/** Metres. */
sonar_m: Array<number>, } | { "type": "neurons",
/** Number of the last event. */
seq: number,
/** Tick they belong to. */
tick: number,
/** The neurons. */
neurons: Array<NeuronView>, } | { "type": "trial",
/** Event number. */
seq: number,
/** One or more, in order. */
trials: Array<Trial>, } | { "type": "curve",
/** Event number. */
seq: number,
/** One or more, in order. */
points: Array<CurvePoint>, } | { "type": "step",
/** Number of the last event. */
seq: number,
/** The step. */
step: StepView, } | { "type": "table",
/** Number of the last event. */
seq: number,
/** Tick they belong to. */
tick: number,
/** The tables. */
table: TableView, } | { "type": "episode",
/** Event number. */
seq: number,
/** One or more, in order. */
episodes: Array<EpisodeView>, } | { "type": "scores",
/** Event number. */
seq: number,
/** How they stand. */
scores: ScoresView, } | { "type": "cycles",
/** Number of the last event. */
seq: number,
/** In order; the last is the present. */
cycles: Array<CycleView>, } | { "type": "run",
/** Event number. */
seq: number,
/** One or more, in order. */
runs: Array<DriveRunView>, } | { "type": "summary",
/** Event number. */
seq: number,
/** How they stand. */
summary: DriveScores, } | { "type": "log",
/** Event number. */
seq: number,
/** One or more, in order. */
entries: Array<LogEntry>, } | { "type": "yardstick",
/** Event number. */
seq: number,
/** The yardstick. */
yardstick: Yardstick, } | { "type": "gap",
/** What the client had. */
since: number,
/** Oldest event still held. */
oldest: number, } | { "type": "error",
/** What was wrong and what would be right. */
message: string,
/** The field at fault. */
field: string | null, };

/** The history a late page needs. */
export type Hello = {
/** [`STREAM_VERSION`]. */
version: number,
/** Number of the last event contained. */
seq: number,
/** The session. */
session: Session,
/** The world it runs in; none for a tabular experiment. */
world: WorldView | null,
/** The best path a planner finds there; none for a tabular experiment. */
yardstick: Yardstick | null,
/** The world of a tabular experiment. */
task: TaskView | null,
/** The tables of a tabular experiment; none before it has started. */
table: TableView | null,
/** How its competitors stand. */
scores: ScoresView | null,
/** Its newest episodes, at most [`HELLO_EPISODES`]. */
episodes: Array<EpisodeView>,
/** Where the robot of chapter 2 drives; none elsewhere. */
course: CourseView | null,
/** The latest cycles of chapter 2, at most [`HELLO_CYCLES`]. */
cycles: Array<CycleView>,
/** Its newest runs, at most [`HELLO_EPISODES`]. */
runs: Array<DriveRunView>,
/** How its methods stand. */
summary: DriveScores | null,
/** The newest trials, at most [`HELLO_TRIALS`]. */
trials: Array<Trial>,
/** All neurons, without their centres. */
neurons: Array<NeuronView>,
/** The last control step, if there was one. */
tick: TickView | null,
/** The event log, newest last, at most 500 lines. */
log: Array<LogEntry>, };

/** A world as the page needs it for its own drawings. */
export type WorldView = {
/** Name. */
name: string,
/** Title for people. */
title: string,
/** Least and greatest x and y of all walls, metres: `[x0, y0, x1, y1]`. */
bounds_m: [number, number, number, number],
/** Walls as segments `[x0, y0, x1, y1]`, metres. */
walls_m: Array<[number, number, number, number]>,
/** Names of the regions, in their fixed order. */
regions: Array<string>,
/** Where every trial starts. */
home: PoseView,
/** Centre of the goal, metres. */
goal_m: [number, number],
/** Radius of the goal, metres. */
goal_radius_m: number,
/** Radius of the robot, metres; of the circle around it, when it is not round. */
robot_radius_m: number,
/** Corners of a robot that is not round, counter-clockwise, robot frame, metres. */
robot_corners_m: Array<[number, number]>,
/** Range of the sonars, metres. */
sonar_range_m: number,
/** The sonars, in the order of their readings. */
sonars: Array<SonarView>, };

/** Where a sonar sits and looks, robot frame: x ahead, y to the left. */
export type SonarView = {
/** Metres. */
x_m: number,
/** Metres. */
y_m: number,
/** Axis of its cone from the heading, counter-clockwise, degrees. */
bearing_deg: number, };

/** One point of each learning curve. */
export type CurvePoint = {
/** Trial, from 1. */
trial: number,
/** Neurons after it. */
neurons: number,
/** Steps taken. */
steps: number,
/** R(n). */
total_reinforcement: number,
/** A capped trial has no defined steps or R(n) (section 5.11). */
reached_goal: boolean, };

/** A line of the event log. */
export type LogEntry = {
/** When, RFC 3339, UTC. */
at: string,
/** Last tick done. */
tick: number,
/** `operator`, `session`, `trial` or `warning`. */
kind: string,
/** What happened, a sentence. */
text: string, };

/** A message from a client. */
export type ClientMessage = { "type": "subscribe",
/** Most `tick` messages a second, 0 (none) to 60. */
tick?: number,
/** Most `depths` messages a second, 0 to 60. */
depths?: number,
/** Most `neurons` messages a second, 0 to 30. */
neurons?: number,
/** Most `step` messages a second, 0 to 60. */
step?: number,
/** Most `cycles` messages a second, 0 to 60. */
cycles?: number,
/** Most `table` messages a second, 0 to 30. */
table?: number,
/** Arena pictures. */
arena?: ArenaRequest, };

/** What arena pictures to send. */
export type ArenaRequest = {
/** Most pictures a second, 0 (none) to 30. */
rate: number,
/** Pixels, 64 to 2048. */
width: number,
/** Pixels, 64 to 2048. */
height: number,
/** `light` or `dark`. */
theme: ThemeName, };

/** Colour theme of a picture. */
export type ThemeName = "light" | "dark";

/** One step of a tabular experiment. */
export type StepView = { "kind": "walk" } & WalkView | { "kind": "pull" } & PullView | { "kind": "point" } & PointView;

/** A learner's step: chosen, done, learned from. */
export type WalkView = {
/** Number in the session, from 1. */
tick: number,
/** Round of the session, from 1: one episode of one competitor. */
round: number,
/** Episode, from 1. */
episode: number,
/** Competitor whose turn it is. */
entrant: string,
/** It trains on the first task, before the one it is scored in (`continual`). */
training: boolean,
/** Trial of the episode, from 1. */
trial: number,
/** Step of the trial, from 1. */
step: number,
/** x. */
state: number,
/** Q(x,·), or an actor's preferences, before the step. */
values: Array<number>,
/** What advice and reflex added to each action, log-odds. */
pulls: Array<number>,
/** Share of the reflex in that. */
reflex_pull: number,
/** Chance of each action, Eq. (4.11). */
chances: Array<number>,
/** Temperature τ, or ε. */
exploration: number,
/** u. */
action: number,
/** y. */
next: number,
/** The action changed nothing. */
bumped: boolean,
/** r and its parts. */
reward: RewardView,
/** What was learned. */
update: UpdateView,
/** The trial that ended with this step. */
trial_end: TableTrialView | null, };

/** A reward and its parts. */
export type RewardView = {
/** r. */
total: number,
/** The task's own. */
task: number,
/** For a subgoal. */
subgoal: number,
/** For running into a wall. */
bump: number,
/** Of the progress estimator. */
progress: number, };

/** What one experience changed. */
export type UpdateView = {
/** Value looked ahead to: max Q(y,·), or V(y) for a critic; 0 at an end without transport. */
ahead: number,
/** γ. */
discount: number,
/** Learning rate; 1 where a whole backup takes its place. */
rate: number,
/** r + γ · ahead − before. */
delta: number,
/** Q(x,u) before, or V(x) for a critic. */
before: number,
/** The same after. */
after: number,
/** Further backups made by planning. */
planned: number, };

/** One trial of an episode. */
export type TableTrialView = {
/** Actions taken. */
steps: number,
/** An absorbing state was reached; otherwise the trial was broken off at the cap. */
reached_end: boolean,
/** Sum of the task's own rewards. */
total_reward: number,
/** Actions that changed nothing. */
bumps: number, };

/** A pull of a lever. */
export type PullView = {
/** Number in the session, from 1. */
tick: number,
/** Round of the session, from 1: one episode of one strategy. */
round: number,
/** Episode, from 1: another row of levers. */
episode: number,
/** Strategy whose turn it is. */
entrant: string,
/** Pull of the episode, from 1. */
pull: number,
/** The lever, from 0. */
lever: number,
/** What was compared of each lever: a mean, or an upper bound; none for one that must be tried first. */
scores: Array<number | null>,
/** Chance of each lever. */
chances: Array<number>,
/** What the lever paid. */
paid: number,
/** What it pays in the mean, which the agent does not know. */
mean: number,
/** Regret of this pull, section 3.4. */
regret: number,
/** Regret of the episode so far. */
total_regret: number, };

/** A point of a plot of figure 3.3. */
export type PointView = {
/** Number in the session, from 1. */
tick: number,
/** Always 1. */
round: number,
/** `finite-horizon` (3.1), `discounted` (3.3) or `average` (3.4). */
model: string,
/** h or γ; 0 for the average reward, which has none. */
parameter: number,
/** J of each policy. */
values: Array<number>,
/** The best policy, from 0; the first of several. */
best: number,
/** Where the best policy changed since the last point. */
crossing: CrossingView | null, };

/** A place where the best policy changes. */
export type CrossingView = {
/** h or γ. */
at: number,
/** The best policy before, from 0. */
from: number,
/** The best policy after. */
to: number, };

/** One episode of one competitor. */
export type EpisodeView = {
/** Round of the session, from 1. */
round: number,
/** Episode, from 1. */
episode: number,
/** The competitor. */
entrant: string,
/** It trained on the first task, before the one it is scored in (`continual`). */
training: boolean,
/** Steps taken. */
steps: number,
/** First tick. */
first_tick: number,
/** Last tick. */
last_tick: number,
/** What came of it. */
outcome: OutcomeOfEpisode,
/** What an operator did to it, in order. */
interventions?: Array<InterventionView>, };

/** What came of an episode. */
export type OutcomeOfEpisode = { "kind": "walk",
/** J, Eq. (4.12): actions a trial, on average. */
index: number,
/** Actions of each trial. */
trials: Array<number>,
/** Trials broken off at the cap. */
capped: number, } | { "kind": "pull",
/** Regret. */
regret: number,
/** What was paid. */
paid: number,
/** Share of pulls of a best lever, 0 to 1. */
best_share: number,
/** Regret so far at each hundredth of the pulls. */
course: Array<number>, } | { "kind": "plot",
/** All points. */
points: Array<PointView>, };

/** What an operator did during an episode or a run. It holds until that ends. */
export type InterventionView = {
/** Last tick done before it. */
tick: number,
/** Trial or cycle it fell into, from 1. */
trial: number,
/** `advice`, `value`, `table`, `method` or `sonar`. */
kind: string,
/** The advice as it was given, or what was changed. */
text: string, };

/** How the competitors stand. */
export type ScoresView = {
/** Episodes that every competitor has done. */
episodes_done: number,
/** `actions a trial` (J, Eq. 4.12) or `regret` (section 3.4); less is better. */
measure: string,
/** What the curves run over: `trial` or `pull`. */
over: string,
/** The competitors, in their order. */
scores: Array<ScoreView>,
/** Their learning curves, in the same order. */
curves: Array<CompetitorCurve>, };

/** How one competitor stands. */
export type ScoreView = {
/** Its name. */
name: string,
/** The one it is compared with; none if with none. */
reference: string | null,
/** Episodes it has done. */
n: number,
/** The measure with its 95 % interval; none of fewer than two episodes. */
index: IntervalView | null,
/** Gain r over the reference, Eq. (4.13), percent; none before both have done an episode. */
gain_pct: number | null,
/** Mean of that gain over experiments of ten episodes each, with its 95 % interval. */
gain: IntervalView | null,
/** Mean of the last tenth of the trials: what the final policy needs. For strategies, the share of pulls
 * of a best lever, percent. */
last: number | null,
/** Trials broken off at the cap. */
capped: number,
/** Pairs of state and action left to try; none where there are no states. */
search_space: number | null, };

/** An estimate with its 95 % interval. */
export type IntervalView = {
/** The estimate. */
value: number,
/** Lower end. */
low: number,
/** Upper end. */
high: number, };

/** A learning curve with its 95 % band. */
export type CompetitorCurve = {
/** The competitor. */
name: string,
/** Episodes behind it. */
n: number,
/** Trial or pull of each point. */
at: Array<number>,
/** Mean of each point. */
mean: Array<number>,
/** Lower ends; empty of fewer than two episodes. */
low: Array<number>,
/** Upper ends. */
high: Array<number>, };

/** The present of a tabular session: the tables of the competitor whose turn it is. */
export type TableView = { "kind": "walk" } & LearnerView | { "kind": "pull" } & BanditView | { "kind": "plot" } & HorizonView;

/** A learner at work. */
export type LearnerView = {
/** Last tick done. */
tick: number,
/** Episode, from 1. */
episode: number,
/** Whose turn it is. */
entrant: string,
/** It trains on the first task. */
training: boolean,
/** Trial under way, from 1. */
trial: number,
/** State the agent is in. */
state: number,
/** State every trial starts in. */
start: number,
/** Absorbing states. */
ends: Array<number>,
/** τ or ε of this trial. */
exploration: number,
/** The last step; none before the first. */
step: WalkView | null,
/** Q, or an actor's preferences: a row a state, a column an action. */
values: Array<Array<number>>,
/** What the values began with: the belief matrix, where there is one. */
beliefs: Array<Array<number>>,
/** Factor of each chance; 0 excludes an action. */
weights: Array<Array<number>>,
/** Chance of each action in each state, as it would be chosen now. */
chances: Array<Array<number>>,
/** V of each state. */
state_values: Array<number>,
/** The values can be edited; behaviours behind a gate have a table each. */
editable: boolean,
/** What planning knows and did; none without planning. */
planning: PlanningView | null,
/** The advice in force, and what has become of each rule. */
advice: Array<AdviceView>, };

/** Planning at work. */
export type PlanningView = {
/** Pairs of state and action that the model knows. */
known: number,
/** The model: what each known pair led to. */
model: Array<ModelView>,
/** Backups of the last step, in order. */
backups: Array<BackupView>,
/** Queue of prioritised sweeping, most urgent first, at most 50: state and priority, Eq. (3.24). */
queue: Array<QueueView>, };

/** What a pair of state and action has led to. */
export type ModelView = {
/** x. */
state: number,
/** u. */
action: number,
/** y, what is looked ahead to; none at an end. */
ahead: number | null,
/** Share of the times. */
chance: number,
/** Mean reward. */
reward: number, };

/** A backup made while planning. */
export type BackupView = {
/** x. */
state: number,
/** u. */
action: number,
/** Q(x,u) before. */
before: number,
/** The same after. */
after: number, };

/** A state that waits for a sweep. */
export type QueueView = {
/** x. */
state: number,
/** Its priority. */
priority: number, };

/** A rule of advice, and what has become of it. */
export type AdviceView = {
/** As it was written. */
text: string,
/** Weight of the moment, log-odds; 0 once discarded. */
weight: number,
/** Weight it was given. */
first_weight: number,
/** How far it holds in the agent's state, 0 to 1. */
degree: number,
/** Decisions at which it spoke and was followed. */
followed: number,
/** Decisions at which it spoke and was not. */
ignored: number,
/** Mean way to the goal after following it, steps; recent trials count more. */
steps_followed: number,
/** The same after not following it. */
steps_ignored: number,
/** Trial in which it was given, from 1. */
given: number,
/** Trial after which it was discarded. */
discarded: number | null, };

/** A strategy at work. */
export type BanditView = {
/** Last tick done. */
tick: number,
/** Episode, from 1. */
episode: number,
/** Strategy whose turn it is. */
entrant: string,
/** Pulls done of this episode. */
pull: number,
/** The last pull; none before the first. */
step: PullView | null,
/** What each lever pays in the mean, which the agent does not know. */
means: Array<number>,
/** What the agent believes of it; 0 where never pulled. */
estimates: Array<number>,
/** How often it was pulled. */
pulls: Array<number>, };

/** The plots of figure 3.3 so far. */
export type HorizonView = {
/** Last tick done. */
tick: number,
/** Points of all plots. */
of: number,
/** The points so far. */
points: Array<PointView>, };

/** The world of a tabular experiment. */
export type TaskView = {
/** `labyrinth`, `maze`, `process`, `levers` or `policies`. */
kind: string,
/** Name. */
name: string,
/** Title for people. */
title: string,
/** The states; none for levers and policies. */
states: Array<StateView>,
/** Names of the actions, of the levers or of the policies. */
actions: Array<string>,
/** Rows of the drawing; 0 where there is none. */
rows: number,
/** Columns of the drawing. */
columns: number,
/** Where the actions lead; none for levers and policies. */
transitions: Array<TransitionView>,
/** What advice may speak of. */
features: Array<FeatureView>,
/** The policies of figure 3.2; none elsewhere. */
policies: Array<PolicyView>, };

/** A state and its place in the drawing. */
export type StateView = {
/** In words. */
name: string,
/** Row, from 0 at the top; none where there is no drawing. */
row: number | null,
/** Column, from 0 at the left. */
column: number | null,
/** Heading in degrees, counter-clockwise from east; none where it has none. */
heading_deg: number | null,
/** What stands there in the drawing: `S`, `G`, `X`, a room's letter, or nothing. */
mark: string, };

/** One outcome of an action in a state. */
export type TransitionView = {
/** x. */
state: number,
/** u. */
action: number,
/** y. */
next: number,
/** Its chance. */
chance: number,
/** r. */
reward: number, };

/** Something that advice may speak of. */
export type FeatureView = {
/** Its name. */
name: string,
/** What it is about. */
meaning: string,
/** Its terms, e.g. `near`. */
terms: Array<string>, };

/** A policy of figure 3.2. */
export type PolicyView = {
/** Its name. */
name: string,
/** Rewards of the first steps. */
lead: Array<number>,
/** Reward of every step after them. */
then: number, };

/** One cycle of the sonars: read, fused, decided. */
export type CycleView = {
/** Number in the session, from 1. */
tick: number,
/** Round of the session, from 1: one run with one method. */
round: number,
/** Run, from 1; with two methods each run is driven twice, from the same random numbers. */
run: number,
/** Cycle of the run, from 1. */
cycle: number,
/** Time from the start of the run to the end of the cycle, seconds. */
time_s: number,
/** The method that drives. */
method: string,
/** True pose at the end of the cycle. */
pose: PoseView,
/** Velocity, m/s; below 0 it backs up. */
speed_m_s: number,
/** Turn, deg/s; above 0 to the left. */
turn_deg_s: number,
/** What the compass says, degrees. */
compass_deg: number,
/** Load on the motor, 0 at rest to 1 where the robot pushes against something. */
motor_load: number,
/** The latest reading of each sonar. */
readings: Array<ReadingView>,
/** The regions, from the left to the right. */
regions: Array<RegionDepthView>,
/** The rules at work; none where nothing decides. */
inference: InferenceView | null,
/** Velocity commanded for the next cycle, m/s. */
command_m_s: number,
/** Turn commanded for the next cycle, deg/s. */
command_deg_s: number,
/** A contact that began. */
bump: BumpView | null,
/** The robot is backing off by itself. */
backing_off: boolean,
/** Clearance of the body at the end of the cycle, metres. */
clearance_m: number,
/** Where people are, metres. */
people_m: Array<[number, number]>,
/** The first region without a sonar that answers, from 0; it stops the robot. */
blind: number | null, };

/** One reading. */
export type ReadingView = {
/** Metres; the greatest reading where there is no echo. */
range_m: number,
/** What it is made of: `echo`, `edge`, `none`, `dropped`, `ghost`, `spurious` or `silent`. */
echo: string, };

/** A region in a cycle. What every method makes of it is there, whichever drives. */
export type RegionDepthView = {
/** Sonars that answer. */
live: number,
/** Depth by each method of the course, metres, in their order; empty where every sonar is silent. */
depths_m: Array<number>,
/** σ of Algorithm 1, metres. */
sigma_m: number | null,
/** σ of the filter whose depth walks at random, metres. */
walk_sigma_m: number | null,
/** Distance of the nearest surface in the cones of its sonars, metres. */
truth_m: number,
/** Normalised innovation squared of the median, χ² with one degree of freedom where the filter's
 * assumptions hold; none of the first reading. */
nis: number | null,
/** Error of the median and Algorithm 1, squared and over its variance. */
nees: number | null, };

/** The rules at work in a cycle. */
export type InferenceView = {
/** The inputs: depths in metres, then the velocity in cm/s. */
inputs: Array<number>,
/** Membership of each input in each of its sets, Eq. (2.20). */
memberships: Array<Array<number>>,
/** Rules that fire. */
fired: number,
/** The strongest of them, at most 12, the strongest first. */
firings: Array<FiringView>,
/** The outputs, Algorithm 2: velocity in cm/s, turn in deg/s. */
outputs: Array<number>, };

/** A rule that fires. */
export type FiringView = {
/** Its number in the rule base, from 0. */
rule: number,
/** Its strength, Eq. (2.26). */
strength: number,
/** The set of each input that it speaks of. */
when: Array<string>,
/** What it concludes: velocity in cm/s, turn in deg/s. */
then: Array<number>,
/** The principles that gave its consequents. */
because: string, };

/** A contact that began. */
export type BumpView = {
/** `wall`, `door`, `block` or `person`. */
what: string,
/** When, seconds from the start of the run. */
time_s: number,
/** The front bumper answered; else the rear one. */
front: boolean, };

/** One run. */
export type DriveRunView = {
/** Round of the session, from 1. */
round: number,
/** Run, from 1. */
run: number,
/** The method that drove when it ended. */
method: string,
/** Cycles. */
cycles: number,
/** First tick. */
first_tick: number,
/** Last tick. */
last_tick: number,
/** What came of it. */
outcome: DriveOutcome,
/** What an operator did during it, in order. */
interventions?: Array<InterventionView>, };

/** What came of a run. */
export type DriveOutcome = { "kind": "approach",
/** Sum of all changes of the distance itself, metres. */
true_variation_m: number,
/** Mean share of sonars that heard a ghost, percent. */
haunted_pct: number,
/** How well each method told the distance. */
scores: Array<MethodScoreView>, } | { "kind": "drive" } & DriveScore;

/** How well one method told a distance. */
export type MethodScoreView = {
/** The method. */
method: string,
/** Root of the mean square of its error, metres. */
rms_m: number,
/** R² of a straight line in time. */
r2: number,
/** Sum of all changes from cycle to cycle, metres. */
variation_m: number,
/** Sum of the changes upwards, metres; the distance itself never rises. */
rise_m: number,
/** Greatest change, metres. */
jump_m: number, };

/** What a controlled run came to. */
export type DriveScore = {
/** Seconds. */
time_s: number,
/** The end of the way was reached; false where there is none. */
done: boolean,
/** Way gained, metres. */
progress_m: number,
/** Length of the path, metres. */
path_m: number,
/** Way gained in a second, m/s. */
forward_m_s: number,
/** Way gained over length of the path. */
straightness: number,
/** Root of the mean square of the heading from the corridor's, degrees. */
heading_rms_deg: number,
/** Mean velocity, m/s. */
speed_m_s: number,
/** Share of the cycles slower than 5 cm/s, percent. */
slow_pct: number,
/** Share of the cycles that back up, percent. */
reverse_pct: number,
/** Changes of side of the turn in a minute. */
flips_per_min: number,
/** Mean turn, deg/s, whatever its side. */
turn_deg_s: number,
/** Contacts with walls. */
wall_contacts: number,
/** Contacts with door frames. */
door_contacts: number,
/** Contacts with blocks. */
block_contacts: number,
/** Contacts with people. */
people_contacts: number,
/** Doors passed. */
doors: number,
/** Doors passed without a contact. */
clean_doors: number,
/** Least clearance, metres. */
clearance_m: number,
/** Mean normalised innovation of the median over all regions; 1 where the filter is consistent. */
nis: number | null,
/** Mean normalised error of the median and Algorithm 1. */
nees: number | null,
/** Region whose sonars were all silent, from 0, which ended the run. */
blind: number | null, };

/** How the methods stand. */
export type DriveScores = {
/** Runs that every method has done, without those that an operator changed. */
runs_done: number,
/** The methods, in their order. */
methods: Array<MethodSummary>, };

/** How one method stands over those of its runs that no operator changed. */
export type MethodSummary = {
/** The method. */
method: string,
/** Runs. */
n: number,
/** Runs that reached the end of the way; none where there is no end. */
done: number | null,
/** Measures with their names and 95 % intervals, in a fixed order. */
measures: Array<MeasureView>, };

/** A measure over the runs of a method. */
export type MeasureView = {
/** Name for people. */
name: string,
/** Unit; empty for a pure number. */
unit: string,
/** Mean over the runs. */
mean: number,
/** 95 % interval of the mean; none of fewer than two runs. */
interval: IntervalView | null, };

/** Where a robot drives, and what it drives by. */
export type CourseView = {
/** `wall-approach`, `block-world` or `corridor`. */
kind: string,
/** Title for people. */
title: string,
/** Least and greatest x and y, metres: `[x0, y0, x1, y1]`. */
bounds_m: [number, number, number, number],
/** Surfaces. */
faces: Array<FaceView>,
/** Corners of the robot, counter-clockwise, robot frame, metres. */
robot_corners_m: Array<[number, number]>,
/** The sonars, in the order of their readings. */
sonars: Array<SonarView>,
/** Half the opening of a sonar's cone, degrees. */
half_cone_deg: number,
/** Range of the sonars, metres. */
sonar_range_m: number,
/** Sonars of each region, from the left to the right. */
regions: Array<Array<number>>,
/** Methods by which a depth is made, in the order of `depths_m`, with what each means. */
methods: Array<MethodView>,
/** Methods that drive, by turns. */
drivers: Array<string>,
/** Doors across a corridor. */
doors: Array<DoorView>,
/** x at which a run is done, metres; none where it has no end. */
finish_m: number | null,
/** Radius of a person, metres. */
person_radius_m: number,
/** Bounds within which 95 % of single NIS and NEES values lie where the filter is consistent: χ² with one
 * degree of freedom. */
chi_square: [number, number],
/** The rules that drive; none in the approach to a wall. */
rules: RuleBaseView | null, };

/** A piece of surface. */
export type FaceView = {
/** `[x0, y0, x1, y1]`, metres. */
segment_m: [number, number, number, number],
/** `wall`, `door` or `block`. */
surface: string, };

/** A way of making a depth. */
export type MethodView = {
/** Value of the setting `fusion.method`. */
name: string,
/** What it is. */
meaning: string, };

/** A door across a corridor. */
export type DoorView = {
/** Where along the corridor, metres. */
x_m: number,
/** Half its width, metres. */
half_width_m: number, };

/** A rule base without its rules. */
export type RuleBaseView = {
/** Name. */
name: string,
/** Title for people. */
title: string,
/** The inputs with their sets. */
inputs: Array<VariableView>,
/** The outputs. */
outputs: Array<VariableView>,
/** Rules. */
rules: number, };

/** A variable of a rule base. */
export type VariableView = {
/** Its name. */
name: string,
/** Its unit. */
unit: string,
/** Least and greatest value. */
range: [number, number],
/** Its sets; none of an output that rules conclude numbers about. */
sets: Array<SetView>, };

/** A fuzzy set. */
export type SetView = {
/** Its linguistic value. */
name: string,
/** Where membership begins to rise, is 1, begins to fall and is 0; cut at the variable's range. */
corners: [number, number, number, number], };

/** A rule base, rule by rule: `GET rules/{name}`. */
export type RuleList = {
/** What it is about. */
base: RuleBaseView,
/** Its rules, in their order. */
rules: Array<RuleView>, };

/** A rule. */
export type RuleView = {
/** Its number, from 0. */
rule: number,
/** The set of each input. */
when: Array<string>,
/** What it concludes about each output. */
then: Array<number>,
/** The principles that gave its consequents. */
because: string, };

/** The whole result of a run of chapter 2: what `run --json` prints and `report.json` holds. */
export type DriveResult = {
/** Name of the experiment. */
experiment: string,
/** Seed. */
seed: number,
/** Program version and commit. */
build: string,
/** Every setting with its value. */
settings: Record<string, number | string | boolean>,
/** The runs; an episode is a run of one method. */
episodes: Array<DriveRunView>,
/** How the methods stand after the last. */
summary: DriveScores, };

/** Body of `POST sessions/{id}/method`. */
export type MethodRequest = {
/** The method that drives from the next cycle on, until the run ends. */
method: string, };

/** Body of `POST sessions/{id}/sonars`. */
export type SonarRequest = {
/** Which sonar, from 0. */
sonar: number,
/** Whether it falls silent, or answers again. */
silent: boolean, };

/** What to calibrate. */
export type CalibrationQuestion = {
/** Times the noise in the robot's file, 0 to 20; 1 when missing. */
noise: number,
/** An ideal sonar: no noise, every ray comes back; `false` when missing. */
ideal: boolean,
/** Pairs of the true and the measured distance at each place, 2 to 100000; 2000 when missing. */
pairs: number,
/** Factor k, 1 to 10; 1.5 when missing. */
factor: number,
/** Seed, up to 2⁵³ − 1; 1 when missing. */
seed: number, };

/** What a place comes to. */
export type CalibrationPlace = {
/** Where the sonar stood. */
place: string,
/** Pairs taken. */
n: number,
/** Mean square of d − r, m², with its 95 % interval. */
mean_square: IntervalView,
/** Its root, metres. */
rms_m: number, };

/** The deviation of a sonar, and what it comes from. */
export type CalibrationView = {
/** What was asked. */
asked: CalibrationQuestion,
/** Place by place. */
places: Array<CalibrationPlace>,
/** All places together. */
all: CalibrationPlace,
/** ς, the root of k times the mean square over all places, metres, with its 95 % interval. */
deviation_m: IntervalView,
/** Settings that carry it into a run of the wall approach or the corridor. */
settings: Array<CalibratedSetting>,
/** Program version and commit that computed it. */
build: string, };

/** A setting of a run. */
export type CalibratedSetting = {
/** Key. */
key: string,
/** Value, as it is typed. */
value: string, };

/** A normal distribution over a position. */
export type GaussianView = {
/** Mean. */
mean: number,
/** Standard deviation. */
sigma: number, };

/** Lost at sea: what a star and a light beacon say, and what both say together. */
export type LostAtSea = {
/** Measurement z₁ of the star with σ₁; the estimate before the beacon is seen. */
star: GaussianView,
/** Measurement z₂ of the beacon with σ₂. */
beacon: GaussianView,
/** z₂ − x̂, what the beacon says that was not expected. */
innovation: number,
/** Gain K = σ₁² / (σ₁² + σ₂²): the share of the innovation that is believed. */
gain: number,
/** The estimate after both, recursively: Eq. (1.10) and (1.11). */
fused: GaussianView,
/** The same in one batch: (σ₂² z₁ + σ₁² z₂) / (σ₁² + σ₂²). */
batch: GaussianView, };

/** The whole result of a tabular run: what `run --json` prints and `report.json` holds. */
export type TableResult = {
/** Name of the experiment. */
experiment: string,
/** Seed. */
seed: number,
/** Program version and commit. */
build: string,
/** Every setting with its value. */
settings: Record<string, number | string | boolean>,
/** The episodes. */
episodes: Array<EpisodeView>,
/** How the competitors stand after the last. */
summary: ScoresView, };

/** Body of `POST sessions/{id}/advice`. */
export type AdviceRequest = {
/** Rules, one a line; an empty text takes all advice back. */
text: string, };

/** Body of `POST sessions/{id}/table`: one value, or a whole table. */
export type TableRequest = {
/** x. */
state: number,
/** u. */
action: number,
/** Q(x,u). */
value: number, } | {
/** Q. */
values: Array<Array<number>>, };

/** A table of values as it is saved: `GET sessions/{id}/table`. */
export type TableFile = {
/** Name of the experiment. */
experiment: string,
/** Competitor whose values they are. */
entrant: string,
/** Last tick done. */
tick: number,
/** Names of the states. */
states: Array<string>,
/** Names of the actions. */
actions: Array<string>,
/** Q, or an actor's preferences: a row a state, a column an action. */
values: Array<Array<number>>, };

/** Something the thesis shows or claims that can be computed again. */
export type ReproductionTarget = {
/** Name used in the interface, e.g. `table-5.1`. */
name: string,
/** Title for people. */
title: string,
/** What is held against what. */
compares: string,
/** Where the thesis has it. */
source: string,
/** How its words and figures were read, a sentence each. */
readings: Array<string>,
/** Name of the experiment that is run. */
experiment: string,
/** What is run, side by side. */
arms: Array<ReproductionArm>,
/** What one seed gives: `set` (of trials) or `experiment` (of ten episodes of trials). */
unit: string,
/** Trials of a set, or of an episode. */
trials: number,
/** Sets or experiments for each arm; 0 where nothing is drawn at random. */
sets: number,
/** First seed; the sets take one each, upwards; none where nothing is drawn. */
first_seed: number | null,
/** Last seed. */
last_seed: number | null,
/** What is run for each arm, e.g. `200 sets of 20 trials an arm, seeds 700000..700199`. */
extent: string,
/** How the verdicts are found. */
rule: string,
/** The command that computes the same. */
command: string, };

/** One of the learners, or one of the worlds, that a target compares. */
export type ReproductionArm = {
/** Name, with which the names of its rows begin. */
name: string,
/** Preset, world and settings that differ from the preset's. */
settings: Record<string, number | string | boolean>, };

/** How far a target is. */
export type ReproductionProgress = {
/** Name of the target. */
target: string,
/** Where it stands. */
state: ReproductionState,
/** Sets or experiments done. */
done: number,
/** Sets or experiments to do. */
of: number,
/** Why it failed. */
reason: string | null, };

/** Where the computation of a target stands. */
export type ReproductionState = "idle" | "waiting" | "running" | "done" | "failed";

/** Something the thesis shows or claims, computed again. */
export type Reproduction = {
/** Name of the target. */
target: string,
/** One row a figure. */
rows: Array<ReproductionRow>,
/** Curves, several arms of one quantity after each other. */
curves: Array<ReproductionCurve>,
/** Pictures, those of one arm after each other. */
pictures: Array<ReproductionPicture>,
/** Program version and commit. */
build: string, };

/** One figure, published and ours. */
export type ReproductionRow = {
/** Preset and quantity. */
name: string,
/** What the thesis prints; none when it prints nothing. */
published: number | null,
/** What is required where nothing is published, e.g. `≥ 95`; then the verdict says whether the whole
 * interval keeps it. */
required: string | null,
/** What came out here. */
ours: number,
/** Lower end of our 95 % interval. */
low: number,
/** Upper end of our 95 % interval. */
high: number,
/** Sample size behind ours; 0 for what was computed exactly, without a sample. */
n: number,
/** Unit; empty for a pure number. */
unit: string,
/** Whether the published value lies in our interval. */
verdict: Verdict,
/** How we read the thesis, with preset and seeds. */
reading: string, };

/** How a published value stands to ours. */
export type Verdict = "agrees" | "differs" | "cannot tell";

/** One quantity of one arm over trials. */
export type ReproductionCurve = {
/** Name of the arm. */
arm: string,
/** What is drawn, e.g. `number of steps`. */
quantity: string,
/** Its unit; empty for a pure number. */
unit: string,
/** What is counted along x, e.g. `trial`. */
x_name: string,
/** What the band is, e.g. `95 % interval of the mean over 200 sets`. */
band: string,
/** What the bars are, e.g. `minimum and maximum over the first ten sets`; empty without bars. */
bars: string,
/** The points, by rising x. */
points: Array<ReproductionPoint>, };

/** One point of a curve. */
export type ReproductionPoint = {
/** Place along x. */
x: number,
/** Mean; none when no set has a value here. */
mean: number | null,
/** Lower end of the 95 % interval of the mean; none of fewer than two values. */
low: number | null,
/** Upper end. */
high: number | null,
/** Least value among the sets of the bars. */
least: number | null,
/** Greatest value among them. */
greatest: number | null,
/** Sets behind the mean. */
n: number, };

/** A picture of a target: `GET reproductions/{target}/pictures/{name}`. */
export type ReproductionPicture = {
/** Name, unique in the target, e.g. `default-first`. */
name: string,
/** Name of the arm. */
arm: string,
/** What it shows, a line. */
caption: string,
/** What is to be seen, for those who cannot see it. */
alt: string, };

/** A world as its file says it. Lengths in metres, angles in degrees. */
export type WorldFile = {
/** Name, the value of the setting `world`. */
name: string,
/** Title for people. */
title: string,
/** One sentence on what the world is like. */
summary: string,
/** Where it comes from. */
source: string,
/** Open polylines, each a list of points `[x, y]`. */
walls: Array<Array<[number, number]>>,
/** Closed solid polygons. */
blocks: Array<Array<[number, number]>>,
/** Closed rings that bound the free floor by the even-odd rule; where there are any, everything off
 * the floor is solid. */
floor: Array<Array<[number, number]>>,
/** Regions; the first whose rules all hold wins, and the last has none. */
regions: Array<WorldRegion>,
/** Where every trial starts. */
home: WorldHome,
/** Where every trial should end. */
goal: WorldGoal, };

/** A named region. */
export type WorldRegion = {
/** Name, e.g. "corridor". */
name: string,
/** Rules that must all hold; none means everywhere else. */
rules: Array<WorldRule>, };

/** A half-plane: `axis` (or `a` and `b`, for `a·x + b·y`) with exactly one of `above` and `below`. */
export type WorldRule = {
/** `x` or `y`. */
axis?: AxisName,
/** Factor of x. */
a?: number,
/** Factor of y. */
b?: number,
/** Must be greater than this. */
above?: number,
/** Must be less than this. */
below?: number, };

/** A coordinate axis. */
export type AxisName = "x" | "y";

/** Where every trial starts. */
export type WorldHome = {
/** Metres. */
x: number,
/** Metres. */
y: number,
/** Degrees from the x axis, counter-clockwise. */
heading_deg: number, };

/** Where every trial should end. */
export type WorldGoal = {
/** Metres. */
x: number,
/** Metres. */
y: number,
/** The goal is reached when the robot's centre is nearer than this, metres. */
radius_m: number, };

/** A place in the world. */
export type PlaceView = {
/** Metres. */
x_m: number,
/** Metres. */
y_m: number, };

/** Something wrong with a world. */
export type WorldProblem = {
/** The field at fault, e.g. `home` or `regions[1].rules[0]`. */
field: string,
/** What is wrong, and what would be right. */
message: string,
/** The place at fault: a home in a wall, a goal that cannot be reached. */
place: PlaceView | null,
/** The reachable place nearest to an unreachable goal. */
nearest: PlaceView | null, };

/** A world in the list of all. */
export type WorldSummary = {
/** Value of the setting `world`. */
name: string,
/** Title for people; the name when the file cannot be read. */
title: string,
/** What it is. */
summary: string,
/** It came with the program and cannot be changed. */
built_in: boolean,
/** Why no session can run in it. */
problem: string | null,
/** Least and greatest x and y, `[x0, y0, x1, y1]`, metres. */
bounds_m: [number, number, number, number] | null,
/** Wall surfaces. */
walls: number,
/** Names of the regions. */
regions: Array<string>, };

/** What a world is like, and everything wrong with it. */
export type WorldCheck = {
/** A session can run in it. */
ok: boolean,
/** What was read. */
world: WorldFile,
/** What is wrong. */
problems: Array<WorldProblem>,
/** Least and greatest x and y, `[x0, y0, x1, y1]`, metres; none when something is wrong. */
bounds_m: [number, number, number, number] | null,
/** Wall surfaces; 0 when something is wrong. */
walls: number,
/** What each region covers; empty when something is wrong. */
regions: Array<RegionShape>,
/** From home to the nearest surface, metres. */
clearance_m: number | null,
/** From home straight to the goal's centre, metres. */
distance_m: number,
/** A short way that the robot fits through, metres, found on a grid of 10 cm and pulled taut. */
way_m: number | null,
/** Radius of the robot that has to fit, metres. */
robot_radius_m: number,
/** A world of this name exists already: `own` or `built_in`. */
taken: string | null, };

/** What a region covers within the bounds. */
export type RegionShape = {
/** Its name. */
name: string,
/** Convex polygons, metres. */
polygons_m: Array<Array<[number, number]>>, };

/** Regions proposed for a world. */
export type RegionProposal = {
/** The regions, for the world's file. */
regions: Array<WorldRegion>,
/** What each covers. */
shapes: Array<RegionShape>, };

/** A ROS map to be traced. */
export type TraceRequest = {
/** The PGM or PNG file in base 64. */
image_base64: string,
/** The text of the YAML file. */
yaml: string,
/** Patches of cells smaller than this are dropped, square metres; none unless told otherwise. */
speck_m2?: number,
/** The part of the world to keep, `[x0, y0, x1, y1]`, metres; all unless told otherwise. */
crop?: [number, number, number, number],
/** Name of the world; that of the image unless told otherwise. */
name?: string, };

/** A world traced from a map, to be finished by its user. */
export type TraceDraft = {
/** The floor with one region and a suggested home and goal. */
world: WorldFile,
/** Edge of a cell, metres. */
resolution_m: number,
/** Cells along x. */
width_cells: number,
/** Cells along y. */
height_cells: number,
/** Free cells. */
free_cells: number,
/** Occupied cells. */
occupied_cells: number,
/** Unknown cells. */
unknown_cells: number,
/** Area of the free cells, square metres. */
free_area_m2: number,
/** Pieces of wall before they were simplified within half a cell. */
segments_before: number,
/** Pieces of wall after that. */
segments_after: number,
/** Patches of cells dropped. */
specks_dropped: number,
/** Least and greatest x and y of the floor, `[x0, y0, x1, y1]`, metres. */
bounds_m: [number, number, number, number],
/** The cells as a picture. */
picture: MapPicture, };

/** The cells of a map as a picture: white is free, black occupied, grey unknown. */
export type MapPicture = {
/** A PNG file in base 64. */
png_base64: string,
/** Pixels; fewer than cells for a large map. */
width_px: number,
/** Pixels. */
height_px: number,
/** The lower left corner, metres. */
corner: PlaceView,
/** How far the picture is turned about that corner, degrees counter-clockwise. */
yaw_deg: number,
/** Width of the map, metres. */
width_m: number,
/** Height of the map, metres. */
height_m: number, };
