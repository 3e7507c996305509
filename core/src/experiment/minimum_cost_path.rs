//! The minimum-cost path of chapter 5: a robot learns its way from home to the goal.

mod altered_start;

pub use altered_start::{AlteredStart, Excursion};

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::{OnCollision, Settings};
use crate::control::Reflex;
use crate::geometry::{Pose, Vec2};
use crate::learner::{
    Birth, CarryError, Consequence, DISTANCE_UNITS, Decision, Learner, LearnerSettings, Memory,
    Neuron, NeuronId, Observation, Outcome, Partition, RewardSettings, SonarFrame, Tick, TrialEnd,
    TrialRecord, goal_part, reinforcement,
};
use crate::perception::{Fix, Localiser, Sighting};
use crate::rng::{Purpose, stream};
use crate::robot::{Contact, Motion, Robot, Sensed, SimulatedRobot};
use crate::world::World;

/// A neuron as others may look at it.
#[derive(Clone, Copy, Debug)]
pub struct NeuronRef<'a> {
    /// Its number in the session.
    pub id: NeuronId,
    /// Index of the network it belongs to; that of its region, unless there is one network only.
    pub region: usize,
    /// Centre `c`: one input a sonar, then 8 distance units.
    pub centre: &'a [f64],
    /// Prototypical action `p`, radians, in the frame of the setting `learner.action_frame`.
    pub prototypical_rad: f64,
    /// Heading that `p` meant at its birth pose, radians.
    pub heading_rad: f64,
    /// Mean `μ`, degrees.
    pub mean_deg: f64,
    /// Utility `u`; none while pending.
    pub utility: Option<f64>,
    /// Times it won.
    pub wins: u32,
    /// Birth certificate.
    pub birth: &'a Birth,
}

/// Everything needed to go on after a finished trial. Random streams are derived anew.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Checkpoint {
    memory: Memory,
    /// What was heard where (addition A10).
    sightings: Vec<Sighting>,
}

impl Checkpoint {
    /// Trials done.
    #[must_use]
    pub fn trials_done(&self) -> u32 {
        self.memory.trials()
    }

    /// Ticks done.
    #[must_use]
    pub fn tick(&self) -> u64 {
        self.memory.ticks()
    }
}

/// Settings or a checkpoint that do not fit.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SetupError {
    /// Two settings that contradict each other.
    #[error("`{key}` must be {expected}, not {found}")]
    Contradiction {
        /// The setting at fault.
        key: &'static str,
        /// What would be right.
        expected: String,
        /// What it is.
        found: String,
    },
    /// There are networks for another number of regions.
    #[error("there are {found} networks, but the world has {expected} regions")]
    OtherWorld {
        /// Regions of the world.
        expected: usize,
        /// Networks there are.
        found: usize,
    },
    /// The trained networks are damaged.
    #[error(transparent)]
    Networks(#[from] CarryError),
}

impl SetupError {
    /// The field at fault.
    #[must_use]
    pub fn field(&self) -> &str {
        match self {
            Self::Contradiction { key, .. } => key,
            Self::OtherWorld { .. } => "checkpoint",
            Self::Networks(error) => &error.place,
        }
    }
}

/// What is known at an observation and not told to the learner.
struct Known {
    true_pose: Pose,
    reflectance_pct: f64,
    fix: Option<Fix>,
}

/// What is counted during a trial.
#[derive(Clone, Debug, Default)]
struct Tally {
    steps: u32,
    safety: f64,
    goal: f64,
    collisions: u32,
    /// What `goal` would be, had the robot known where it was.
    true_goal: f64,
    path_m: f64,
    region_steps: Vec<u32>,
    first_tick: u64,
}

impl Tally {
    fn new(regions: usize) -> Self {
        Self { region_steps: vec![0; regions], ..Self::default() }
    }
}

/// The experiment as a state machine, one control step at a time.
#[derive(Debug)]
pub struct MinimumCostPath {
    world: Arc<World>,
    reward: RewardSettings,
    step_cap: u32,
    on_collision: OnCollision,
    seed: u64,
    robot: SimulatedRobot,
    /// Corrects odometry that errs (addition A10).
    localiser: Option<Localiser>,
    /// Where the robot takes itself to be.
    believed: Pose,
    /// How that was found, where odometry is corrected.
    fix: Option<Fix>,
    /// Inputs of a neuron that the robot's sonars and the distance units fill.
    inputs: usize,
    learner: Learner,
    /// What is sensed and not yet decided upon; none between trials.
    observation: Option<Observation>,
    reflectance_pct: f64,
    tally: Tally,
    tick: Option<Tick>,
    end: Option<TrialEnd>,
}

impl MinimumCostPath {
    /// A new run with empty networks.
    ///
    /// # Errors
    /// When two settings contradict each other.
    pub fn new(
        world: Arc<World>,
        robot: Arc<Robot>,
        settings: &Settings,
        seed: u64,
    ) -> Result<Self, SetupError> {
        check(settings, &robot)?;
        let learner = Learner::new(
            LearnerSettings::from(settings),
            Arc::clone(&robot),
            Reflex::new(settings.reflex(), robot.sonars()),
            world.regions().len(),
            world.goal().centre,
            stream(seed, 0, Purpose::Exploration),
        );
        Ok(Self::with(world, robot, settings, seed, learner, Vec::new()))
    }

    /// A new run with trained networks, one a region (one in all with `learner.regions = one`).
    ///
    /// # Errors
    /// When two settings contradict each other, or the networks do not fit the world or are damaged.
    pub fn carry_on(
        world: Arc<World>,
        robot: Arc<Robot>,
        settings: &Settings,
        seed: u64,
        networks: &[Vec<Neuron>],
    ) -> Result<Self, SetupError> {
        let regions = world.regions().len();
        let expected = if settings.partition == Partition::One { 1 } else { regions };
        if networks.len() != expected {
            return Err(SetupError::OtherWorld { expected, found: networks.len() });
        }
        // One network for all is that of the first region; those of the others stay empty.
        let mut networks = networks.to_vec();
        networks.resize(regions, Vec::new());
        let inputs = robot.sonars().len() + DISTANCE_UNITS;
        let memory = Memory::carrying(&LearnerSettings::from(settings), &networks, inputs)?;
        let checkpoint = Checkpoint { memory, sightings: Vec::new() };
        Self::resume(world, robot, settings, seed, &checkpoint)
    }

    /// Goes on after a checkpoint, to the same bits that a run never stopped gives.
    ///
    /// # Errors
    /// When two settings contradict each other, or the checkpoint is of a world with other regions.
    pub fn resume(
        world: Arc<World>,
        robot: Arc<Robot>,
        settings: &Settings,
        seed: u64,
        checkpoint: &Checkpoint,
    ) -> Result<Self, SetupError> {
        check(settings, &robot)?;
        let memory = checkpoint.memory.clone();
        let (expected, found) = (world.regions().len(), memory.networks().len());
        if expected != found {
            return Err(SetupError::OtherWorld { expected, found });
        }
        let rng = stream(seed, memory.trials(), Purpose::Exploration);
        let learner = Learner::remember(
            LearnerSettings::from(settings),
            Arc::clone(&robot),
            Reflex::new(settings.reflex(), robot.sonars()),
            world.goal().centre,
            memory,
            rng,
        );
        let sightings = checkpoint.sightings.clone();
        Ok(Self::with(world, robot, settings, seed, learner, sightings))
    }

    fn with(
        world: Arc<World>,
        robot: Arc<Robot>,
        settings: &Settings,
        seed: u64,
        learner: Learner,
        sightings: Vec<Sighting>,
    ) -> Self {
        // What the robot's odometry is good for is known, as a robot's maker tells it.
        let (error, range_m) = (settings.odometry_drift, settings.sonar_range_m);
        let radius_m = robot.body().reach_m();
        let corrects = settings.odometry_correction && error > 0.0 && robot.has_even_ring();
        let localiser = || Localiser::new(error, range_m, radius_m, sightings);
        Self {
            localiser: corrects.then(localiser),
            believed: world.home(),
            fix: None,
            inputs: robot.sonars().len() + DISTANCE_UNITS,
            robot: SimulatedRobot::new(Arc::clone(&world), robot, settings.simulation(), seed),
            reward: LearnerSettings::from(settings).reward,
            step_cap: settings.step_cap,
            on_collision: settings.on_collision,
            seed,
            learner,
            observation: None,
            reflectance_pct: 0.0,
            tally: Tally::new(world.regions().len()),
            world,
            tick: None,
            end: None,
        }
    }

    /// One control step: sense, adapt, decide, move. The second part is there when the trial ended
    /// with it; the next step then begins the next trial at home.
    pub fn step(&mut self) -> (&Tick, Option<&TrialEnd>) {
        let observation = match self.observation.take() {
            Some(observation) => observation,
            None => self.begin_trial(),
        };
        let known = Known {
            true_pose: self.robot.true_pose(),
            reflectance_pct: self.reflectance_pct,
            fix: self.fix,
        };
        let decision = self.learner.decide(&observation);
        let motion = self.robot.act(decision.rotation_rad);
        let sensed = self.robot.sense();
        self.locate(&sensed);
        self.reflectance_pct = sensed.reflectance_pct;
        let outcome = self.judge(&sensed, &motion);
        self.count(&observation, &outcome, known.true_pose.position());
        let tick = self.explain(&observation, decision, outcome, known);
        let over = self.is_over(outcome.reached_goal, outcome.contact, self.tally.steps);
        self.end = over.then(|| self.end_trial(outcome.reached_goal, tick.tick));
        if !over {
            self.observation = Some(self.observe(&sensed, motion.contact));
        }
        (self.tick.insert(tick), self.end.as_ref())
    }

    /// State after the last finished trial; none while a trial is under way.
    #[must_use]
    pub fn checkpoint(&self) -> Option<Checkpoint> {
        let between = self.observation.is_none();
        between.then(|| Checkpoint {
            memory: self.learner.memory().clone(),
            sightings: self.localiser.as_ref().map_or_else(Vec::new, |l| l.sightings().to_vec()),
        })
    }

    /// Trials done.
    #[must_use]
    pub fn trials_done(&self) -> u32 {
        self.learner.memory().trials()
    }

    /// Last tick done.
    #[must_use]
    pub fn tick(&self) -> u64 {
        self.learner.memory().ticks()
    }

    /// True pose of the robot; home before the first step of a trial.
    #[must_use]
    pub fn true_pose(&self) -> Pose {
        if self.observation.is_some() { self.robot.true_pose() } else { self.world.home() }
    }

    /// The trained networks, in the order of the world's regions; while a scout is looking for another way
    /// (addition A6) those laid aside, unless it has found a better one.
    #[must_use]
    pub fn networks(&self) -> Vec<Vec<Neuron>> {
        let networks = self.learner.memory().best_networks().iter();
        networks.map(|network| network.neurons().to_vec()).collect()
    }

    /// All neurons, by network and then by age.
    pub fn neurons(&self) -> impl Iterator<Item = NeuronRef<'_>> {
        let networks = self.learner.memory().networks().iter().enumerate();
        networks.flat_map(move |(region, network)| {
            network.neurons().iter().map(move |neuron| self.look_at(region, neuron))
        })
    }

    fn look_at<'a>(&'a self, region: usize, neuron: &'a Neuron) -> NeuronRef<'a> {
        NeuronRef {
            id: neuron.id,
            region,
            centre: &neuron.centre[..self.inputs],
            prototypical_rad: neuron.prototypical_rad,
            heading_rad: self.learner.heading_of(neuron),
            mean_deg: neuron.mean_deg,
            utility: neuron.known_utility(),
            wins: neuron.wins,
            birth: &neuron.birth,
        }
    }

    fn begin_trial(&mut self) -> Observation {
        self.robot.begin_trial(self.learner.memory().trials());
        self.tally = Tally::new(self.world.regions().len());
        self.tally.first_tick = self.learner.memory().ticks() + 1;
        let sensed = self.robot.sense();
        if let Some(localiser) = &mut self.localiser {
            localiser.begin(self.robot.pose());
        }
        self.locate(&sensed);
        self.reflectance_pct = sensed.reflectance_pct;
        self.observe(&sensed, Contact::None)
    }

    /// Finds out where the robot is after it has moved.
    fn locate(&mut self, sensed: &Sensed) {
        let odometry = self.robot.pose();
        let found = self.localiser.as_mut().map(|l| l.locate(odometry, &sensed.sonar_m));
        self.believed = found.map_or(odometry, |(pose, _)| pose);
        self.fix = found.map(|(_, fix)| fix);
    }

    /// Whether a trial is over. Section 5.11, Simulation vs. Reality: the simulated robot was killed at a
    /// collision, the real one rescued.
    fn is_over(&self, reached_goal: bool, contact: Contact, steps: u32) -> bool {
        let killed = self.on_collision == OnCollision::End && contact != Contact::None;
        reached_goal || killed || steps >= self.step_cap
    }

    fn observe(&self, sensed: &Sensed, contact: Contact) -> Observation {
        self.observe_from(self.believed, sensed, contact)
    }

    fn observe_from(&self, pose: Pose, sensed: &Sensed, contact: Contact) -> Observation {
        Observation {
            sonar_m: sensed.sonar_m,
            pose,
            region: self.world.region_at(pose.position()),
            contact,
        }
    }

    /// The reinforcement of what the last action led to.
    fn judge(&mut self, sensed: &Sensed, motion: &Motion) -> Outcome {
        let pose = self.believed;
        let bearing_rad = pose.bearing_to(self.world.goal().centre);
        let reinforcement =
            reinforcement(&self.reward, &sensed.sonar_m, motion.contact, bearing_rad);
        self.learner.consequence(&Consequence { sonar_m: sensed.sonar_m, pose, reinforcement });
        Outcome {
            true_pose: self.robot.true_pose(),
            pose,
            contact: motion.contact,
            backed_m: motion.backed_m,
            moved: motion.moved,
            reinforcement,
            reached_goal: self.robot.at_goal(),
        }
    }

    fn count(&mut self, observation: &Observation, outcome: &Outcome, from: Vec2) {
        let tally = &mut self.tally;
        tally.steps += 1;
        tally.safety += outcome.reinforcement.safety;
        tally.goal += outcome.reinforcement.goal;
        tally.true_goal += goal_part(outcome.true_pose.bearing_to(self.world.goal().centre));
        tally.collisions += u32::from(outcome.contact != Contact::None);
        tally.path_m += outcome.true_pose.distance_to(from);
        tally.region_steps[observation.region] += 1;
    }

    fn explain(
        &self,
        observation: &Observation,
        decision: Decision,
        outcome: Outcome,
        Known { true_pose, reflectance_pct, fix }: Known,
    ) -> Tick {
        let memory = self.learner.memory();
        Tick {
            tick: memory.ticks(),
            trial: memory.trials() + 1,
            step: self.learner.step(),
            true_pose,
            pose: observation.pose,
            fix,
            sonar_m: observation.sonar_m,
            reflectance_pct,
            region: observation.region,
            decision,
            outcome,
            neurons: memory.neurons(),
            total_reinforcement: self.tally.safety + self.tally.goal,
        }
    }

    #[expect(clippy::cast_possible_truncation, reason = "at most two neurons a step")]
    fn end_trial(&mut self, reached_goal: bool, last_tick: u64) -> TrialEnd {
        let memory = self.learner.memory();
        let trial = memory.trials() + 1;
        let temperature_deg = self.learner.temperature_deg();
        let (born, scout) = (self.learner.born() as u32, self.learner.is_scouting());
        let next = stream(self.seed, trial, Purpose::Exploration);
        let changes = self.learner.end_trial(reached_goal, next);
        let tally = std::mem::take(&mut self.tally);
        let record = TrialRecord {
            trial,
            steps: tally.steps,
            total_reinforcement: tally.safety + tally.goal,
            safety: tally.safety,
            goal: tally.goal,
            true_goal: tally.true_goal,
            neurons: self.learner.memory().neurons(),
            born,
            forgotten: changes.forgotten.len() as u32,
            collisions: tally.collisions,
            reached_goal,
            record: changes.record,
            scout,
            temperature_deg,
            path_m: tally.path_m,
            region_steps: tally.region_steps,
            first_tick: tally.first_tick,
            last_tick,
        };
        TrialEnd {
            record,
            backed_up: changes.backed_up,
            replaced: changes.replaced,
            proposed: changes.proposed,
            judged: changes.judged,
            forgotten: changes.forgotten,
            recentred: changes.recentred,
        }
    }
}

/// Checks what no single setting can.
fn check(settings: &Settings, robot: &Robot) -> Result<(), SetupError> {
    if settings.sonar_frame == SonarFrame::Odometry && !robot.has_even_ring() {
        return Err(SetupError::Contradiction {
            key: "input.sonar_frame",
            expected: format!(
                "`robot`, since the sonars of the {} are no even ring that could be shifted",
                robot.title()
            ),
            found: "`odometry`".to_owned(),
        });
    }
    let below = |key, least: f64, most: f64, than: &str| {
        if least < most {
            return Ok(());
        }
        Err(SetupError::Contradiction {
            key,
            expected: format!("less than `{than}` ({most})"),
            found: format!("{least}"),
        })
    };
    below("reflex.front_near", settings.front_near_m, settings.front_free_m, "reflex.front_free")?;
    below("sonar.least", settings.sonar_least_m, settings.sonar_range_m, "sonar.range")?;
    below("reflex.side_near", settings.side_near_m, settings.side_free_m, "reflex.side_free")?;
    if settings.temperature_min_deg > settings.temperature_max_deg {
        return Err(SetupError::Contradiction {
            key: "learner.temperature_min",
            expected: format!(
                "at most `learner.temperature_max` ({})",
                settings.temperature_max_deg
            ),
            found: format!("{}", settings.temperature_min_deg),
        });
    }
    Ok(())
}
