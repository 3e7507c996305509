//! What is counted during a run, and what it comes to.

use super::cycle::{Contact, Cycle};
use crate::perception::{Consistency, Method};
use crate::world::{Passage, Surface};

/// Turns slower than this have no side, deg/s.
const STRAIGHT_DEG_S: f64 = 1.5;
/// Velocities below this are slow, m/s.
const SLOW_M_S: f64 = 0.05;
/// How far beyond a door the robot has passed it, and within which a contact belongs to it, metres.
const PASSED_M: f64 = 0.5;
const AT_DOOR_M: f64 = 1.5;

/// One run.
#[derive(Clone, Debug, PartialEq)]
pub struct RunEnd {
    /// Run, from 1.
    pub run: u32,
    /// The method that drove when it ended.
    pub method: Method,
    /// Cycles.
    pub cycles: u32,
    /// Seconds.
    pub time_s: f64,
    /// Whether the end of the way was reached; false where there is none.
    pub done: bool,
    /// Way gained along x, metres.
    pub progress_m: f64,
    /// Length of the path, metres.
    pub path_m: f64,
    /// Way gained in a second, m/s.
    pub forward_m_s: f64,
    /// Way gained over length of the path.
    pub straightness: f64,
    /// Root of the mean square of the heading from the x axis, degrees.
    pub heading_rms_deg: f64,
    /// Mean velocity, m/s.
    pub speed_m_s: f64,
    /// Share of the cycles slower than 5 cm/s.
    pub slow: f64,
    /// Share of the cycles that back up.
    pub reverse: f64,
    /// Changes of side of the turn in a minute.
    pub flips_per_min: f64,
    /// Mean turn, deg/s, whatever its side.
    pub turn_deg_s: f64,
    /// Mean change of the turn from cycle to cycle, deg/s.
    pub turn_change_deg_s: f64,
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
    /// Normalised innovations of median and Algorithm 1 over all regions.
    pub nis: Consistency,
    /// Normalised errors of the same.
    pub nees: Consistency,
    /// The region whose sonars were all silent, which ended the run.
    pub blind: Option<usize>,
}

/// What is counted so far.
#[derive(Clone, Debug, Default)]
pub(super) struct Tally {
    cycles: u32,
    path_m: f64,
    heading_squares: f64,
    speeds: f64,
    slow: u32,
    reverse: u32,
    flips: u32,
    side: f64,
    turns: f64,
    turn_changes: f64,
    turn_deg_s: f64,
    contacts: [u32; 4],
    /// For each door, whether it was passed and whether something was touched there.
    doors: Vec<(bool, bool)>,
    clearance_m: f64,
    nis: Consistency,
    nees: Consistency,
    start: crate::geometry::Pose,
    last: crate::geometry::Pose,
}

impl Tally {
    pub(super) fn new(start: crate::geometry::Pose, doors: usize) -> Self {
        let doors = vec![(false, false); doors];
        Self { doors, clearance_m: f64::INFINITY, start, last: start, ..Self::default() }
    }

    /// Takes in a cycle.
    pub(super) fn take(&mut self, cycle: &Cycle, doors: &[Passage]) {
        self.cycles += 1;
        self.path_m += cycle.pose.distance_to(self.last.position());
        self.last = cycle.pose;
        self.heading_squares += cycle.pose.heading_rad * cycle.pose.heading_rad;
        self.speeds += cycle.speed.v_m_s;
        self.slow += u32::from(cycle.speed.v_m_s < SLOW_M_S);
        self.reverse += u32::from(cycle.speed.v_m_s < 0.0);
        self.take_turn(cycle.speed.w_rad_s.to_degrees());
        self.clearance_m = self.clearance_m.min(cycle.clearance_m);
        self.take_doors(cycle, doors);
        for region in &cycle.regions {
            if let Some(nis) = region.depth.and_then(|depth| depth.nis) {
                self.nis.take(nis);
            }
            if let Some(nees) = region.nees {
                self.nees.take(nees);
            }
        }
    }

    fn take_turn(&mut self, turn_deg_s: f64) {
        self.turns += turn_deg_s.abs();
        self.turn_changes += (turn_deg_s - self.turn_deg_s).abs();
        self.turn_deg_s = turn_deg_s;
        if turn_deg_s.abs() > STRAIGHT_DEG_S {
            self.flips += u32::from(self.side * turn_deg_s < 0.0);
            self.side = turn_deg_s.signum();
        }
    }

    fn take_doors(&mut self, cycle: &Cycle, doors: &[Passage]) {
        if let Some(bump) = cycle.bump {
            self.contacts[kind(bump.contact)] += 1;
        }
        for (door, (passed, touched)) in doors.iter().zip(&mut self.doors) {
            let beyond_m = cycle.pose.x_m - door.x_m;
            *touched |= !*passed && cycle.bump.is_some() && beyond_m.abs() < AT_DOOR_M;
            *passed |= beyond_m > PASSED_M;
        }
    }

    /// What it comes to.
    pub(super) fn end(&self, last: &Cycle, done: bool) -> RunEnd {
        let cycles = f64::from(self.cycles.max(1));
        let progress_m = last.pose.x_m - self.start.x_m;
        let [wall_contacts, door_contacts, block_contacts, people_contacts] = self.contacts;
        let count = |doors: usize| u32::try_from(doors).unwrap_or(u32::MAX);
        RunEnd {
            run: last.run,
            method: last.method,
            cycles: self.cycles,
            time_s: last.time_s,
            done,
            progress_m,
            path_m: self.path_m,
            forward_m_s: progress_m / last.time_s,
            straightness: if self.path_m > 0.0 { progress_m / self.path_m } else { 0.0 },
            heading_rms_deg: libm::sqrt(self.heading_squares / cycles).to_degrees(),
            speed_m_s: self.speeds / cycles,
            slow: f64::from(self.slow) / cycles,
            reverse: f64::from(self.reverse) / cycles,
            flips_per_min: f64::from(self.flips) * 60.0 / last.time_s,
            turn_deg_s: self.turns / cycles,
            turn_change_deg_s: self.turn_changes / cycles,
            wall_contacts,
            door_contacts,
            block_contacts,
            people_contacts,
            doors: count(self.doors.iter().filter(|(passed, _)| *passed).count()),
            clean_doors: count(self.doors.iter().filter(|door| **door == (true, false)).count()),
            clearance_m: self.clearance_m,
            nis: self.nis,
            nees: self.nees,
            blind: last.blind,
        }
    }
}

fn kind(contact: Contact) -> usize {
    match contact {
        Contact::Surface(Surface::Wall) => 0,
        Contact::Surface(Surface::Door) => 1,
        Contact::Surface(Surface::Block) => 2,
        Contact::Person => 3,
    }
}
