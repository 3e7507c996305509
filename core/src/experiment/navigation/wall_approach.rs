//! The experiment `wall-approach`: the simple experiment of section 2.5, figure 2.5.
//!
//! The robot drives towards a wall at constant speed; nothing controls it. All methods see the same
//! readings, and each is scored against the distance that is known.

use std::sync::Arc;

use super::checkpoint::{NavigationCheckpoint, Progress};
use super::cycle::Cycle;
use super::error::NavigationError;
use super::vehicle::{Outfit, Vehicle, hashed};
use super::{NoiseChoice, fusion_rule};
use crate::geometry::{Pose, Vec2};
use crate::perception::{Fusion, FusionRule, Hashing, MedianRank, Method};
use crate::rng::{Purpose, stream};
use crate::robot::{
    Body, Command, Drive, DriveSpec, FiringOrder, Mount, NoiseLevel, Robot, Scanner, ScannerSpec,
};
use crate::world::{Arena, People, Ring, Surface};

crate::settings! {
    /// Settings of the experiment `wall-approach`.
    pub struct WallApproachSettings {
        start_m: f64 = 2.0, "approach.start" [0.3, 10.0] "m", Literal, "section 2.5", "Distance of the robot's front from the wall at the start";
        end_m: f64 = 0.2, "approach.end" [0.05, 5.0] "m", Reading, "section 2.5, close to the wall", "Distance at which a run ends";
        speed_m_s: f64 = 0.1, "approach.speed" [0.01, 0.5] "m/s", Gap, "section 2.5, a constant velocity", "Velocity of the robot";
        method: Method = Method::MedianKalman, "fusion.method" "", Literal, "section 2.4", "The method that is looked at first; all are scored";
        rank: MedianRank = MedianRank::Lower, "fusion.median" "", Reading, "Eq. (2.2)", "Which of an even number of readings is the median";
        window: u32 = 3, "fusion.window" [1.0, 20.0] "", Literal, "section 2.4; Algorithm 1, n", "Length of the window: n + 1 readings, z(t-n) to z(t)";
        deviation_m: f64 = 0.32, "fusion.sonar_deviation" [0.001, 10.0] "m", Gap, "Eq. (2.8), ς; calibrated", "Standard deviation of a reading";
        walk_m: f64 = 0.08, "fusion.walk" [0.0, 10.0] "m", Addition, "Eq. (1.8)", "Standard deviation by which a depth walks from cycle to cycle (median-walk)";
        regions: u32 = 5, "hashing.regions" [1.0, 10.0] "", Literal, "section 2.3", "Regions that the sonars are hashed into; the middle one is scored";
        overlap: bool = true, "hashing.overlap" "", Literal, "section 2.3", "Sonars next to another region belong to both";
        ideal: bool = false, "noise.ideal" "", Simulation, "section 2.9", "Ideal sonars: no noise, every ray comes back";
        noise: f64 = 4.0, "noise.level" [0.0, 20.0] "", Simulation, "section 2.2", "Times the noise in the robot's file; at 0 echoes vary and surfaces are specular, and that is all";
        crosstalk: bool = true, "noise.crosstalk" "", Simulation, "section 2.2", "There is crosstalk";
        spurious: bool = true, "noise.spurious" "", Simulation, "section 2.2", "There are spurious readings";
        dropout: bool = true, "noise.dropout" "", Simulation, "section 2.2", "Echoes are lost";
        neighbours: f64 = 0.0, "noise.neighbours" [0.0, 1.0] "", Simulation, "section 2.2", "Probability that a ghost is heard by a neighbour too";
        order: FiringOrder = FiringOrder::Staggered, "sonar.order" "", Literal, "section 2.2", "The order in which the sonars are fired";
    }
}

/// Half the length of the wall, and of the room behind the robot, metres.
const FAR_M: f64 = 30.0;

/// How well one method told the distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MethodScore {
    /// The method.
    pub method: Method,
    /// Root of the mean square of the error, metres.
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

/// One approach.
#[derive(Clone, Debug, PartialEq)]
pub struct ApproachEnd {
    /// Run, from 1.
    pub run: u32,
    /// Cycles.
    pub cycles: u32,
    /// Sum of all changes of the distance itself, metres.
    pub true_variation_m: f64,
    /// Mean number of sonars that hear a ghost, as a share of all.
    pub haunted: f64,
    /// Each method of [`Method::ALL`].
    pub scores: Vec<MethodScore>,
}

/// What an approach is made of.
#[derive(Clone, Debug)]
struct Setup {
    outfit: Outfit,
    mounts: Vec<Mount>,
    scanner: ScannerSpec,
    order: FiringOrder,
    noise: NoiseLevel,
    drive: DriveSpec,
    hashing: Hashing,
    fusion: FusionRule,
    speed: Command,
    start_m: f64,
    cycles: u32,
    /// Way from the middle of the robot to its front, metres.
    front_m: f64,
}

/// The experiment as a state machine, one cycle at a time.
#[derive(Debug)]
pub struct ApproachRun {
    setup: Setup,
    seed: u64,
    progress: Progress,
    vehicle: Option<Vehicle>,
    /// The distance itself, then by each method, cycle by cycle, metres.
    series: Vec<[f64; Method::ALL.len() + 1]>,
    haunted: usize,
    cycle: Option<Cycle>,
    end: Option<ApproachEnd>,
}

impl ApproachRun {
    /// A new run.
    ///
    /// # Errors
    /// When the robot or two settings do not fit together.
    pub fn new(
        robot: &Robot,
        settings: &WallApproachSettings,
        seed: u64,
    ) -> Result<Self, NavigationError> {
        let setup = settings.setup(robot)?;
        Ok(Self {
            seed,
            progress: Progress::new(settings.method, setup.mounts.len()),
            vehicle: None,
            series: Vec::new(),
            haunted: 0,
            cycle: None,
            end: None,
            setup,
        })
    }

    /// The same with regions of its own in place of those of the settings; the middle one is scored.
    #[must_use]
    pub fn hashed_into(mut self, hashing: Hashing) -> Self {
        self.setup.hashing = hashing;
        self
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

    /// Changes the method that is looked at.
    pub fn set_method(&mut self, method: Method) {
        self.progress.method = method;
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

    /// One cycle. The second part is there when the run ended with it; the next then begins the next. A
    /// run also ends when the scored region has no sonar left that answers.
    pub fn step(&mut self) -> (&Cycle, Option<&ApproachEnd>) {
        let mut vehicle = match self.vehicle.take() {
            Some(vehicle) => vehicle,
            None => self.begin(),
        };
        vehicle.glide(self.setup.speed);
        self.progress.ticks += 1;
        let number = self.cycles() + 1;
        let command = self.setup.speed;
        let cycle = Cycle { command, ..vehicle.observe(&self.progress, number) };
        let middle = cycle.regions[cycle.regions.len() / 2].depth;
        if let Some(depth) = middle {
            let mut row = [-(cycle.pose.x_m + self.setup.front_m); Method::ALL.len() + 1];
            row[1..].copy_from_slice(&depth.depths_m);
            self.series.push(row);
        }
        self.haunted += vehicle.scanner.haunted();
        let over = middle.is_none() || number >= self.setup.cycles;
        self.end = over.then(|| self.score(number));
        match self.end {
            Some(_) => self.progress.runs += 1,
            None => self.vehicle = Some(vehicle),
        }
        (self.cycle.insert(cycle), self.end.as_ref())
    }

    fn cycles(&self) -> u32 {
        let last = self.cycle.as_ref().filter(|cycle| cycle.run == self.progress.runs + 1);
        last.map_or(0, |cycle| cycle.cycle)
    }

    fn begin(&mut self) -> Vehicle {
        let setup = &self.setup;
        let rng = |purpose| stream(self.seed, self.progress.runs, purpose);
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
        self.series.clear();
        self.haunted = 0;
        // The wall is at x = 0.
        let pose = Pose::new(-setup.start_m - setup.front_m, 0.0, 0.0);
        Vehicle::new(
            setup.outfit.clone(),
            Drive::new(&setup.drive, pose),
            scanner,
            Fusion::new(setup.hashing.clone(), setup.fusion),
            People::anywhere(0, [FAR_M, FAR_M], Vec::new(), rng(Purpose::People)),
            rng(Purpose::Compass),
        )
    }

    fn score(&self, cycles: u32) -> ApproachEnd {
        let column = |index: usize| self.series.iter().map(|row| row[index]).collect::<Vec<f64>>();
        let truth_m = column(0);
        let methods = Method::ALL.iter().enumerate();
        #[expect(clippy::cast_precision_loss, reason = "a few hundred at most")]
        let haunted = self.haunted as f64 / (f64::from(cycles) * self.progress.silent.len() as f64);
        ApproachEnd {
            run: self.progress.runs + 1,
            cycles,
            true_variation_m: changes(&truth_m).map(f64::abs).sum(),
            haunted,
            scores: methods
                .map(|(index, &method)| method_score(method, &truth_m, &column(index + 1)))
                .collect(),
        }
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

    /// The floor: the wall is at x = 0.
    #[must_use]
    pub fn arena(&self) -> &Arena {
        &self.setup.outfit.arena
    }

    /// The sonars of each region.
    #[must_use]
    pub fn hashing(&self) -> &Hashing {
        &self.setup.hashing
    }
}

impl WallApproachSettings {
    fn setup(&self, robot: &Robot) -> Result<Setup, NavigationError> {
        let unequipped = || NavigationError::Unequipped(robot.name().to_owned());
        let equipment = robot.equipment().ok_or_else(unequipped)?;
        let Body::Box { half_length_m: front_m, .. } = robot.body() else {
            return Err(unequipped());
        };
        if self.end_m >= self.start_m {
            return Err(NavigationError::Contradiction {
                key: "approach.end",
                expected: format!("less than `approach.start`, {}", self.start_m),
                found: self.end_m.to_string(),
            });
        }
        let corners = [[-FAR_M, -FAR_M], [0.0, -FAR_M], [0.0, FAR_M], [-FAR_M, FAR_M]];
        let points = corners.map(Vec2::from).to_vec();
        let ring = Ring { points, surfaces: vec![Surface::Wall; 4] };
        let cycle_s = equipment.scanner.slot_s * f64::from(equipment.scanner.slots);
        let cycles = (self.start_m - self.end_m) / (self.speed_m_s * cycle_s);
        let noise = NoiseChoice {
            ideal: self.ideal,
            level: self.noise,
            crosstalk: self.crosstalk,
            spurious: self.spurious,
            dropout: self.dropout,
            neighbours: self.neighbours,
        };
        Ok(Setup {
            outfit: Outfit {
                arena: Arc::new(Arena::new(vec![ring])?),
                body: robot.body(),
                bumper: equipment.bumper,
                compass: equipment.compass,
                at_once: false,
            },
            mounts: robot.sonars().to_vec(),
            scanner: equipment.scanner.clone(),
            order: self.order,
            noise: noise.level(),
            drive: equipment.drive,
            hashing: hashed(self.regions, robot.sonars().len(), self.overlap)?,
            fusion: fusion_rule(self.rank, self.window, self.deviation_m, self.walk_m),
            speed: Command { v_m_s: self.speed_m_s, w_rad_s: 0.0 },
            start_m: self.start_m,
            cycles: (libm::round(cycles) as u32).max(2),
            front_m,
        })
    }
}

fn changes(series: &[f64]) -> impl Iterator<Item = f64> + '_ {
    series.windows(2).map(|pair| pair[1] - pair[0])
}

fn method_score(method: Method, truth_m: &[f64], depth_m: &[f64]) -> MethodScore {
    let errors = truth_m.iter().zip(depth_m).map(|(truth_m, depth_m)| depth_m - truth_m);
    let squares: Vec<f64> = errors.map(|error| error * error).collect();
    MethodScore {
        method,
        rms_m: libm::sqrt(crate::stats::mean(&squares).unwrap_or(f64::NAN)),
        r2: straightness(depth_m),
        variation_m: changes(depth_m).map(f64::abs).sum(),
        rise_m: changes(depth_m).map(|change| change.max(0.0)).sum(),
        jump_m: changes(depth_m).map(f64::abs).fold(0.0, f64::max),
    }
}

/// R² of the line of least squares through values at equal times; 1 when they do not vary.
#[expect(clippy::cast_precision_loss, reason = "a few hundred at most")]
fn straightness(values: &[f64]) -> f64 {
    let mean_time = 0.5 * (values.len() as f64 - 1.0);
    let mean = crate::stats::mean(values).unwrap_or(0.0);
    let (mut times2, mut products, mut values2) = (0.0, 0.0, 0.0);
    for (time, value) in values.iter().enumerate() {
        let (time, value) = (time as f64 - mean_time, value - mean);
        times2 += time * time;
        products += time * value;
        values2 += value * value;
    }
    if values2 > 0.0 { products * products / (times2 * values2) } else { 1.0 }
}
