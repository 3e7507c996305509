//! A controlled run as a state machine: the block world and the corridor.

use std::sync::Arc;

use super::checkpoint::{NavigationCheckpoint, Progress};
use super::cycle::Cycle;
use super::error::NavigationError;
use super::score::{RunEnd, Tally};
use super::vehicle::{Outfit, Vehicle};
use super::{BlockWorldSettings, CorridorSettings, HASHING_SETS};
use crate::fuzzy::{Explained, RuleBase};
use crate::geometry::Pose;
use crate::perception::{Fusion, FusionRule, Hashing, Method};
use crate::rng::{Purpose, stream};
use crate::robot::{
    Command, Drive, DriveSpec, FiringOrder, Mount, NoiseLevel, Robot, Scanner, ScannerSpec,
};
use crate::world::{Arena, PERSON_RADIUS_M, Passage, People, PeopleError, Person, PersonFile};
use rand_chacha::ChaCha8Rng;

/// Where a run starts.
#[derive(Clone, Debug)]
pub(super) enum Starts {
    /// Round a pose, spread evenly by so much to the side, in metres, and in heading, in radians.
    Round { pose: Pose, aside_m: f64, turned_rad: f64 },
    /// Anywhere on the floor with so much clearance, metres.
    Anywhere { clearance_m: f64 },
}

/// Who walks about.
#[derive(Clone, Debug)]
pub(super) enum Crowd {
    /// So many, anywhere.
    Anywhere(usize),
    /// People of a file, checked.
    Placed(Vec<PersonFile>),
}

/// What a controlled run is made of.
#[derive(Clone, Debug)]
pub(super) struct Setup {
    pub(super) outfit: Outfit,
    pub(super) mounts: Vec<Mount>,
    pub(super) scanner: ScannerSpec,
    pub(super) order: FiringOrder,
    pub(super) noise: NoiseLevel,
    pub(super) drive: DriveSpec,
    pub(super) hashing: Hashing,
    pub(super) fusion: FusionRule,
    pub(super) method: Method,
    pub(super) starts: Starts,
    pub(super) doors: Vec<Passage>,
    pub(super) people: Crowd,
    /// Length and half width of the corridor that people walk in, metres.
    pub(super) corridor_m: [f64; 2],
    /// x at which the run is done, metres; none where it has no end.
    pub(super) finish_m: Option<f64>,
    pub(super) limit_s: f64,
}

/// A controlled robot as a state machine, one cycle at a time; after a run the next begins.
#[derive(Debug)]
pub struct NavigationRun {
    setup: Setup,
    rules: Arc<RuleBase>,
    seed: u64,
    progress: Progress,
    /// The run under way.
    vehicle: Option<Vehicle>,
    tally: Tally,
    command: Command,
    cycle: Option<Cycle>,
    end: Option<RunEnd>,
}

impl NavigationRun {
    /// The experiment `corridor`.
    ///
    /// # Errors
    /// When the robot, the rules or two settings do not fit together.
    pub fn corridor(
        robot: &Robot,
        rules: Arc<RuleBase>,
        settings: &CorridorSettings,
        seed: u64,
    ) -> Result<Self, NavigationError> {
        Self::new(settings.setup(robot)?, rules, seed)
    }

    /// The experiment `block-world`.
    ///
    /// # Errors
    /// When the robot, the rules or two settings do not fit together.
    pub fn block_world(
        robot: &Robot,
        rules: Arc<RuleBase>,
        settings: &BlockWorldSettings,
        seed: u64,
    ) -> Result<Self, NavigationError> {
        Self::new(settings.setup(robot)?, rules, seed)
    }

    fn new(setup: Setup, rules: Arc<RuleBase>, seed: u64) -> Result<Self, NavigationError> {
        check(&rules)?;
        Ok(Self {
            rules,
            seed,
            progress: Progress::new(setup.method, setup.mounts.len()),
            vehicle: None,
            tally: Tally::default(),
            command: Command::default(),
            cycle: None,
            end: None,
            setup,
        })
    }

    /// The same with regions of its own in place of those of the settings.
    ///
    /// # Errors
    /// When there are not as many as the rules have depths.
    pub fn hashed_into(mut self, hashing: Hashing) -> Result<Self, NavigationError> {
        let (wanted, found) = (self.setup.hashing.regions().len(), hashing.regions().len());
        if found != wanted {
            return Err(NavigationError::Contradiction {
                key: HASHING_SETS,
                expected: format!("{wanted} regions, one for each depth in the rules"),
                found: found.to_string(),
            });
        }
        self.setup.hashing = hashing;
        Ok(self)
    }

    /// The same with people of its own in place of those of the settings.
    ///
    /// # Errors
    /// The first who stands in a wall, outside the corridor or where the robot may start, or whose lane
    /// leads through a wall.
    pub fn peopled_by(mut self, people: Vec<PersonFile>) -> Result<Self, NavigationError> {
        let in_the_way = people.iter().position(|person| self.setup.may_start_at(person.start_m));
        let crowd = Crowd::Placed(people);
        self.setup.crowd(&crowd, stream(self.seed, 0, Purpose::People))?;
        if let Some(person) = in_the_way {
            let problem =
                "stands where the robot may start; they must stand clear of it".to_owned();
            return Err(PeopleError { person, problem }.into());
        }
        self.setup.people = crowd;
        Ok(self)
    }

    /// Goes on after a checkpoint, to the same bits that a run never stopped gives.
    ///
    /// # Errors
    /// When the checkpoint is of a robot with other sonars or names a method that there is not.
    pub fn resumed(self, checkpoint: &NavigationCheckpoint) -> Result<Self, NavigationError> {
        Ok(Self { progress: self.progress.resumed(checkpoint)?, ..self })
    }

    /// State after the last finished run; none while one is under way.
    #[must_use]
    pub fn checkpoint(&self) -> Option<NavigationCheckpoint> {
        self.vehicle.is_none().then(|| self.progress.checkpoint())
    }

    /// Changes the method that drives, from the next cycle on.
    pub fn set_method(&mut self, method: Method) {
        self.progress.method = method;
    }

    /// The method that drives.
    #[must_use]
    pub fn method(&self) -> Method {
        self.progress.method
    }

    /// Lets a sonar fall silent, or answer again, from the next cycle on.
    pub fn silence(&mut self, sonar: usize, silent: bool) {
        if let Some(state) = self.progress.silent.get_mut(sonar) {
            *state = silent;
        }
        if let Some(vehicle) = &mut self.vehicle {
            vehicle.scanner.silence(sonar, silent);
        }
    }

    /// One cycle. The second part is there when the run ended with it; the next then begins the next.
    pub fn step(&mut self) -> (&Cycle, Option<&RunEnd>) {
        let mut vehicle = match self.vehicle.take() {
            Some(vehicle) => vehicle,
            None => self.begin(),
        };
        let bump = vehicle.cycle(self.command);
        self.progress.ticks += 1;
        let mut cycle = Cycle { bump, ..vehicle.observe(&self.progress, self.cycles() + 1) };
        cycle.inference = cycle.blind.is_none().then(|| self.infer(&cycle));
        cycle.command = cycle.inference.as_ref().map(command).unwrap_or_default();
        self.command = cycle.command;
        self.tally.take(&cycle, &self.setup.doors);
        self.end = self.end_of_run(&cycle);
        match self.end {
            Some(_) => self.progress.runs += 1,
            None => self.vehicle = Some(vehicle),
        }
        (self.cycle.insert(cycle), self.end.as_ref())
    }

    /// What a run comes to if it is over.
    fn end_of_run(&self, cycle: &Cycle) -> Option<RunEnd> {
        let done = self.setup.finish_m.is_some_and(|finish_m| cycle.pose.x_m > finish_m);
        // A blind robot has been told to stop, and does so within a few cycles.
        let stopped = cycle.blind.is_some() && cycle.speed.v_m_s.abs() < 1e-3;
        let over = done || stopped || cycle.time_s >= self.setup.limit_s - 1e-9;
        over.then(|| self.tally.end(cycle, done))
    }

    fn cycles(&self) -> u32 {
        let last = self.cycle.as_ref().filter(|cycle| cycle.run == self.progress.runs + 1);
        last.map_or(0, |cycle| cycle.cycle)
    }

    fn infer(&self, cycle: &Cycle) -> Explained {
        let depths = cycle.regions.iter().filter_map(|region| region.depth);
        let depths = depths.map(|depth| depth.by(cycle.method));
        let inputs: Vec<f64> = depths.chain([cycle.speed.v_m_s * 100.0]).collect();
        self.rules.explain(&inputs)
    }

    fn begin(&mut self) -> Vehicle {
        let setup = &self.setup;
        let rng = |purpose| stream(self.seed, self.progress.runs, purpose);
        let pose = setup.start(&mut rng(Purpose::Start));
        let mut scanner = Scanner::new(
            &setup.scanner,
            &setup.mounts,
            setup.order,
            setup.noise,
            rng(Purpose::Echo),
        );
        for (sonar, &silent) in self.progress.silent.iter().enumerate() {
            scanner.silence(sonar, silent);
        }
        let people = setup
            .crowd(&setup.people, rng(Purpose::People))
            .expect("people of a file were checked when they were taken");
        self.tally = Tally::new(pose, setup.doors.len());
        self.command = Command::default();
        Vehicle::new(
            setup.outfit.clone(),
            Drive::new(&setup.drive, pose),
            scanner,
            Fusion::new(setup.hashing.clone(), setup.fusion),
            people,
            rng(Purpose::Compass),
        )
    }

    /// Runs done.
    #[must_use]
    pub fn runs_done(&self) -> u32 {
        self.progress.runs
    }

    /// Cycles done.
    #[must_use]
    pub fn ticks(&self) -> u64 {
        self.progress.ticks
    }

    /// The floor.
    #[must_use]
    pub fn arena(&self) -> &Arena {
        &self.setup.outfit.arena
    }

    /// The doors.
    #[must_use]
    pub fn doors(&self) -> &[Passage] {
        &self.setup.doors
    }

    /// x at which a run is done, metres; none where it has no end.
    #[must_use]
    pub fn finish_m(&self) -> Option<f64> {
        self.setup.finish_m
    }

    /// The rules.
    #[must_use]
    pub fn rules(&self) -> &RuleBase {
        &self.rules
    }

    /// The sonars of each region.
    #[must_use]
    pub fn hashing(&self) -> &Hashing {
        &self.setup.hashing
    }

    /// The sonars where they sit on this robot.
    #[must_use]
    pub fn mounts(&self) -> &[Mount] {
        &self.setup.mounts
    }

    /// Outline of this robot.
    #[must_use]
    pub fn body(&self) -> crate::robot::Body {
        self.setup.outfit.body
    }

    /// People as they are; none between runs.
    #[must_use]
    pub fn people(&self) -> &[Person] {
        self.vehicle.as_ref().map_or(&[], |vehicle| vehicle.people.everybody())
    }
}

impl Setup {
    /// Everybody at the start of a run.
    fn crowd(&self, crowd: &Crowd, rng: ChaCha8Rng) -> Result<People, PeopleError> {
        let (size_m, doors) = (self.corridor_m, self.doors.clone());
        match crowd {
            Crowd::Anywhere(count) => Ok(People::anywhere(*count, size_m, doors, rng)),
            Crowd::Placed(people) => People::placed(people, size_m, doors, rng),
        }
    }

    /// Whether a person at a place may touch the robot at the start, however it is turned.
    fn may_start_at(&self, [x_m, y_m]: [f64; 2]) -> bool {
        let Starts::Round { pose, aside_m, .. } = self.starts else {
            return false;
        };
        let beyond_m = ((y_m - pose.y_m).abs() - aside_m).max(0.0);
        libm::hypot(x_m - pose.x_m, beyond_m) < self.outfit.body.reach_m() + PERSON_RADIUS_M
    }

    fn start(&self, rng: &mut ChaCha8Rng) -> Pose {
        use rand::RngExt;
        match self.starts {
            Starts::Round { pose, aside_m, turned_rad } => {
                let aside_m = rng.random_range(-aside_m..=aside_m);
                let turned_rad = rng.random_range(-turned_rad..=turned_rad);
                Pose::new(pose.x_m, pose.y_m + aside_m, pose.heading_rad + turned_rad)
            }
            Starts::Anywhere { clearance_m } => {
                let [x0, y0, x1, y1] = self.outfit.arena.bounds_m();
                let pi = std::f64::consts::PI;
                loop {
                    let (x, y) = (rng.random_range(x0..x1), rng.random_range(y0..y1));
                    let pose = Pose::new(x, y, rng.random_range(-pi..pi));
                    let Outfit { arena, body, .. } = &self.outfit;
                    if super::vehicle::stands_free(arena, *body, pose, clearance_m) {
                        return pose;
                    }
                }
            }
        }
    }
}

/// The outputs of the rules as a command.
fn command(inference: &Explained) -> Command {
    let [v_cm_s, w_deg_s] = inference.outputs;
    Command { v_m_s: v_cm_s / 100.0, w_rad_s: w_deg_s.to_radians() }
}

/// What the rules are told, with its unit: a depth a region, from the left to the right, and the velocity.
const INPUTS: [(&str, &str); 6] = [
    ("far_left", "m"),
    ("left", "m"),
    ("centre", "m"),
    ("right", "m"),
    ("far_right", "m"),
    ("velocity", "cm/s"),
];
/// What they say.
const OUTPUTS: [(&str, &str); 2] = [("v", "cm/s"), ("w", "deg/s")];

/// Whether rules are for what the robot tells and does.
fn check(rules: &RuleBase) -> Result<(), NavigationError> {
    let list = |of: Vec<(&str, &str)>| {
        of.iter().map(|(name, unit)| format!("{name} ({unit})")).collect::<Vec<_>>().join(", ")
    };
    let inputs = rules.inputs().iter().map(|input| (input.name.as_str(), input.unit.as_str()));
    let outputs = rules.outputs().iter().map(|output| (output.name.as_str(), output.unit.as_str()));
    let found = format!("{} -> {}", list(inputs.collect()), list(outputs.collect()));
    let expected = format!("{} -> {}", list(INPUTS.to_vec()), list(OUTPUTS.to_vec()));
    if found == expected { Ok(()) } else { Err(NavigationError::Rules { expected, found }) }
}
