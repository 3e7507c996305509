//! A robot on the floor of an arena: sonars, body, bumpers and drive.

use std::sync::Arc;

use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

use super::checkpoint::Progress;
use super::cycle::{Bump, Contact, Cycle, RegionState};
use crate::geometry::{Pose, Vec2};
use crate::perception::{Fusion, Hashing, Method, RegionDepth};
use crate::robot::{Body, BumperSpec, Command, CompassSpec, Drive, Scanner};
use crate::world::{Arena, Near, Obstacle, People, Round};

/// How far beyond the range of the sonars things are noted, metres: more than the robot moves in a cycle.
const NOTED_M: f64 = 0.5;
/// Load on the motor of a robot that drives at constant speed, and what an acceleration adds, s²/m.
const DRIVING_LOAD: f64 = 0.2;
const LOAD_PER_ACCELERATION: f64 = 1.5;

/// What a robot is like, for one run.
#[derive(Clone, Debug)]
pub(super) struct Outfit {
    pub(super) arena: Arc<Arena>,
    pub(super) body: Body,
    pub(super) bumper: BumperSpec,
    pub(super) compass: CompassSpec,
    /// All sonars are read at the end of a cycle, not each in its slot. NOTE: section 2.9 calls the
    /// simulator's sonars ideal and does not say when they are read.
    pub(super) at_once: bool,
}

/// How a robot backs off by itself after a contact.
#[derive(Clone, Copy, Debug)]
struct BackOff {
    until_s: f64,
    v_m_s: f64,
}

/// A robot during a run.
#[derive(Debug)]
pub(super) struct Vehicle {
    outfit: Outfit,
    pub(super) drive: Drive,
    pub(super) scanner: Scanner,
    pub(super) fusion: Fusion,
    pub(super) people: People,
    compass: ChaCha8Rng,
    near: Near,
    rounds: Vec<Round>,
    /// Clearance of the body to what stands still, at least, metres.
    room_m: f64,
    /// Whether the last contact is not over.
    touching: bool,
    backing_off: Option<BackOff>,
    slots_done: u64,
    load: f64,
}

impl Vehicle {
    pub(super) fn new(
        outfit: Outfit,
        drive: Drive,
        scanner: Scanner,
        fusion: Fusion,
        people: People,
        compass: ChaCha8Rng,
    ) -> Self {
        let mut vehicle = Self {
            outfit,
            drive,
            scanner,
            fusion,
            people,
            compass,
            near: Near::default(),
            rounds: Vec::new(),
            room_m: 0.0,
            touching: false,
            backing_off: None,
            slots_done: 0,
            load: 0.0,
        };
        vehicle.look_round();
        vehicle
    }

    /// Everything there is to say at the end of a cycle, but for what was decided and touched.
    pub(super) fn observe(&mut self, progress: &Progress, cycle: u32) -> Cycle {
        let regions = self.regions();
        Cycle {
            tick: progress.ticks,
            run: progress.runs + 1,
            cycle,
            time_s: self.time_s(),
            method: progress.method,
            pose: self.drive.pose,
            speed: self.drive.speed,
            compass_rad: self.compass_rad(),
            motor_load: self.load,
            readings: self.scanner.readings().to_vec(),
            blind: regions.iter().position(|region| region.depth.is_none()),
            regions,
            inference: None,
            command: Command::default(),
            bump: None,
            backing_off: self.backing_off.is_some(),
            clearance_m: self.clearance_m(),
            people: self.people.everybody().to_vec(),
        }
    }

    /// Time since the start of the run, seconds.
    #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
    fn time_s(&self) -> f64 {
        self.slots_done as f64 * self.scanner.slot_s()
    }

    /// One cycle of all slots under a command. The contact that began in it, if one did.
    pub(super) fn cycle(&mut self, command: Command) -> Option<Bump> {
        self.look_round();
        let mut bump = None;
        for slot in 0..self.scanner.slots() {
            self.slots_done += 1;
            self.people.step(self.scanner.slot_s(), &self.obstacle());
            self.rounds.clear();
            let place = self.drive.pose.position();
            let reach_m = self.scanner.range_m() + NOTED_M;
            let rounds = self.people.everybody().iter().map(|person| person.round());
            self.rounds.extend(rounds.filter(|round| (round.centre - place).norm() < reach_m));
            let command = self.backing_off_or(command);
            let began = self.advance(command);
            bump = bump.or(began);
            if !self.outfit.at_once {
                self.fire(slot);
            }
        }
        if self.outfit.at_once {
            (0..self.scanner.slots()).for_each(|slot| self.fire(slot));
        }
        bump
    }

    /// Fires the sonar of a slot from where the robot is now.
    fn fire(&mut self, slot: usize) {
        let time_s = self.time_s();
        self.scanner.fire(slot, time_s, &self.drive.pose, &self.near, &self.rounds);
    }

    /// Drives as told, whatever is in the way: an approach at constant speed.
    pub(super) fn glide(&mut self, speed: Command) {
        self.look_round();
        for slot in 0..self.scanner.slots() {
            self.slots_done += 1;
            self.drive.speed = speed;
            self.drive = self.drive.after(speed, self.scanner.slot_s());
            self.fire(slot);
        }
    }

    /// Notes what is near, for a cycle.
    fn look_round(&mut self) {
        let within_m = self.scanner.range_m() + self.outfit.body.reach_m() + NOTED_M;
        self.outfit.arena.note_near(self.drive.pose.position(), within_m, &mut self.near);
    }

    fn obstacle(&self) -> Obstacle {
        let pose = self.drive.pose;
        let half = match self.outfit.body {
            Body::Box { half_length_m, half_width_m } => Vec2::new(half_length_m, half_width_m),
            Body::Round { radius_m } => Vec2::new(radius_m, radius_m),
        };
        Obstacle { place: pose.position(), direction: pose.direction(), half }
    }

    /// The command, unless the robot backs off by itself.
    fn backing_off_or(&mut self, command: Command) -> Command {
        let now_s = self.time_s();
        self.backing_off = self.backing_off.filter(|back_off| back_off.until_s >= now_s);
        let v_m_s = self.backing_off.map(|back_off| back_off.v_m_s);
        v_m_s.map_or(command, |v_m_s| Command { v_m_s, w_rad_s: 0.0 })
    }

    /// One slot's motion; a motion into something is not made. The contact, if it is a new one.
    fn advance(&mut self, command: Command) -> Option<Bump> {
        let before = self.drive.speed;
        let next = self.drive.after(command, self.scanner.slot_s());
        let contact = self.contact_of(&next);
        if contact.is_none() {
            self.drive = next;
        } else {
            self.drive.speed = Command::default();
        }
        let gained = (self.drive.speed.v_m_s - before.v_m_s).abs() / self.scanner.slot_s();
        let driving = if command.v_m_s == 0.0 { 0.0 } else { DRIVING_LOAD };
        self.load = match contact {
            Some(_) => 1.0,
            None => (driving + LOAD_PER_ACCELERATION * gained).min(1.0),
        };
        self.note_contact(contact, next.speed.v_m_s)
    }

    /// What a body would touch where it would be.
    fn contact_of(&mut self, next: &Drive) -> Option<Contact> {
        let (place, direction) = (next.pose.position(), next.pose.direction());
        let body = self.outfit.body;
        // The clearance is at least what it was less the way that any point of the body makes.
        let slot_s = self.scanner.slot_s();
        let way_m = (next.speed.v_m_s.abs() + next.speed.w_rad_s.abs() * body.reach_m()) * slot_s;
        if self.room_m - way_m <= 1e-9 {
            let nearest = self.near.nearest(|wall| body.wall_distance_m(place, direction, wall));
            if nearest.distance_m <= 0.0 {
                self.room_m = 0.0;
                return Some(Contact::Surface(nearest.surface));
            }
            self.room_m = nearest.distance_m;
        } else {
            self.room_m -= way_m;
        }
        let person = self.rounds.iter().any(|round| {
            (round.centre - place).norm() < body.reach_m() + round.radius_m
                && body.point_distance_m(place, direction, round.centre) <= round.radius_m
        });
        person.then_some(Contact::Person)
    }

    /// A contact is one until the body is free again; a new one makes the robot back off.
    fn note_contact(&mut self, contact: Option<Contact>, v_m_s: f64) -> Option<Bump> {
        if self.touching {
            let free = contact.is_none() && self.clearance_m() >= self.outfit.bumper.free_m;
            self.touching = !free;
            return None;
        }
        let contact = contact?;
        let BumperSpec { back_off_m_s, back_off_s, .. } = self.outfit.bumper;
        let (time_s, front) = (self.time_s(), v_m_s >= 0.0);
        let v_m_s = if front { -back_off_m_s } else { back_off_m_s };
        self.touching = true;
        self.backing_off = Some(BackOff { until_s: time_s + back_off_s, v_m_s });
        Some(Bump { contact, time_s, front })
    }

    /// Clearance of the body to surfaces and people, metres.
    fn clearance_m(&self) -> f64 {
        let pose = self.drive.pose;
        let (place, direction) = (pose.position(), pose.direction());
        let body = self.outfit.body;
        let nearest = self.near.nearest(|wall| body.wall_distance_m(place, direction, wall));
        let people = self
            .rounds
            .iter()
            .map(|round| body.point_distance_m(place, direction, round.centre) - round.radius_m);
        people.fold(nearest.distance_m, f64::min).max(0.0)
    }

    /// What the readings say about each region. Sonars of this scanner give distances only.
    fn regions(&mut self) -> Vec<RegionState> {
        let readings_m: Vec<f64> =
            self.scanner.readings().iter().map(|reading| reading.range_m).collect();
        let depths = self.fusion.take(&readings_m, &self.scanner.silent());
        let depths = depths.expect("a scanner gives finite distances");
        let pose = self.drive.pose;
        let truths_m: Vec<f64> = (0..readings_m.len())
            .map(|sonar| self.scanner.truth_m(sonar, &pose, &self.near, &self.rounds))
            .collect();
        let regions = depths.into_iter().zip(self.fusion.hashing().regions());
        regions.map(|(depth, members)| region_state(depth, members, &truths_m)).collect()
    }

    /// What the compass says, radians.
    fn compass_rad(&mut self) -> f64 {
        let error: f64 = StandardNormal.sample(&mut self.compass);
        let deviation_rad = self.outfit.compass.deviation_deg.to_radians();
        crate::geometry::wrap_angle(self.drive.pose.heading_rad + deviation_rad * error)
    }
}

fn region_state(depth: Option<RegionDepth>, members: &[usize], truths_m: &[f64]) -> RegionState {
    let truth_m = members.iter().map(|&sonar| truths_m[sonar]).fold(f64::INFINITY, f64::min);
    let nees = depth.map(|depth| {
        let error = (depth.by(Method::MedianKalman) - truth_m) / depth.deviation_m;
        error * error
    });
    RegionState { depth, truth_m, nees }
}

/// Whether a body stands free at a pose, by so much at least, metres.
pub(super) fn stands_free(arena: &Arena, body: Body, pose: Pose, by_m: f64) -> bool {
    let (place, direction) = (pose.position(), pose.direction());
    let mut near = Near::default();
    arena.note_near(place, body.reach_m() + by_m + NOTED_M, &mut near);
    let nearest = near.nearest(|wall| body.wall_distance_m(place, direction, wall));
    arena.is_floor(place) && nearest.distance_m > by_m
}

/// Regions for so many sonars, checked.
pub(super) fn hashed(
    count: u32,
    sonars: usize,
    overlap: bool,
) -> Result<Hashing, super::NavigationError> {
    Ok(Hashing::even(count as usize, sonars, overlap)?)
}
