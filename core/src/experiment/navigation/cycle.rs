//! Everything there is to say about one cycle.

use crate::fuzzy::Explained;
use crate::geometry::Pose;
use crate::perception::{Method, RegionDepth};
use crate::robot::{Command, Reading};
use crate::world::{Person, Surface};

/// What the robot ran into.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Contact {
    /// A surface.
    Surface(Surface),
    /// A person.
    Person,
}

/// A contact that began in a cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bump {
    /// With what.
    pub contact: Contact,
    /// When, seconds from the start of the run.
    pub time_s: f64,
    /// Whether the front bumper answered; else the rear one.
    pub front: bool,
}

/// A region in a cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RegionState {
    /// What is made of its readings; none when all its sonars are silent.
    pub depth: Option<RegionDepth>,
    /// Distance of the nearest surface in the cones of its sonars, metres.
    pub truth_m: f64,
    /// Error of median and Algorithm 1, squared and over its variance.
    pub nees: Option<f64>,
}

/// One cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct Cycle {
    /// Cycle of the session, from 1.
    pub tick: u64,
    /// Run, from 1.
    pub run: u32,
    /// Cycle of the run, from 1.
    pub cycle: u32,
    /// Time from the start of the run to the end of the cycle, seconds.
    pub time_s: f64,
    /// The method that drives.
    pub method: Method,
    /// True pose at the end of the cycle.
    pub pose: Pose,
    /// Velocities at the end of the cycle.
    pub speed: Command,
    /// What the compass says, radians.
    pub compass_rad: f64,
    /// Load on the motor, 0 at rest to 1 where the robot pushes against something.
    pub motor_load: f64,
    /// The latest reading of each sonar.
    pub readings: Vec<Reading>,
    /// The regions, from the left to the right.
    pub regions: Vec<RegionState>,
    /// Memberships, rules that fire and outputs; none where nothing decides.
    pub inference: Option<Explained>,
    /// What was decided, for the next cycle.
    pub command: Command,
    /// A contact that began.
    pub bump: Option<Bump>,
    /// Whether the robot is backing off by itself.
    pub backing_off: bool,
    /// Clearance of the body at the end of the cycle, metres.
    pub clearance_m: f64,
    /// Where people are.
    pub people: Vec<Person>,
    /// The first region without a sonar that answers, which stops the robot.
    pub blind: Option<usize>,
}
