//! A scanner: sonars fired one after the other, and what each hears (section 2.2).
//!
//! NOTE: the thesis names what makes sonars unreliable (specular reflection, crosstalk that persists
//! until some random time, echoes that are lost) without a model. This one is parametric, not
//! acoustic, and its numbers are chosen, not measured; they are data in the robot's file.

use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, Exp1, StandardNormal};

use super::{FiringOrder, Mount, ScannerSpec};
use crate::geometry::{Pose, Vec2, rotate, unit};
use crate::world::{Cone, Near, Round, Sight};

/// What a reading is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Echo {
    /// An echo of a surface or of the corner of a room.
    Surface,
    /// An echo scattered back by an edge.
    Edge,
    /// Nothing in range: the greatest reading.
    None,
    /// An echo was lost: the greatest reading.
    Dropped,
    /// Crosstalk: the sound of another sonar.
    Ghost,
    /// Too short by chance.
    Spurious,
    /// The sonar does not answer.
    Silent,
}

impl Echo {
    /// Name for files and screen.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Surface => "echo",
            Self::Edge => "edge",
            Self::None => "none",
            Self::Dropped => "dropped",
            Self::Ghost => "ghost",
            Self::Spurious => "spurious",
            Self::Silent => "silent",
        }
    }
}

/// One reading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Metres; the greatest reading where there is no echo, and of a silent sonar.
    pub range_m: f64,
    /// What it is made of.
    pub echo: Echo,
}

/// How much noise there is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoiseLevel {
    /// Echoes vary, surfaces are specular and edges do not always answer; off: every ray comes back.
    pub real: bool,
    /// Times the probability of crosstalk in the robot's file.
    pub crosstalk: f64,
    /// Times that of spurious readings.
    pub spurious: f64,
    /// Times that of lost echoes.
    pub dropout: f64,
    /// Probability that a ghost is heard by a neighbour too.
    pub neighbours: f64,
}

impl NoiseLevel {
    /// No noise at all: the simulator of section 2.9.
    pub const IDEAL: Self =
        Self { real: false, crosstalk: 0.0, spurious: 0.0, dropout: 0.0, neighbours: 0.0 };

    /// The level k: all noises k times as frequent as in the robot's file; at 0 echoes vary and
    /// surfaces are specular, and that is all.
    #[must_use]
    pub fn times(k: f64) -> Self {
        Self { real: true, crosstalk: k, spurious: k, dropout: k, neighbours: 0.0 }
    }
}

/// A sound of another sonar that a sonar goes on hearing.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Ghost {
    range_m: f64,
    until_s: f64,
}

/// One sonar.
#[derive(Clone, Debug, PartialEq)]
struct Ear {
    place: Vec2,
    /// Unit vector along its axis, robot frame.
    axis: Vec2,
    /// Probability that it begins to hear the sonar that the slot before fires.
    crosstalk: f64,
    ghost: Option<Ghost>,
    /// Whether there was one when it was last fired.
    haunted: bool,
    silent: bool,
}

/// A scanner at work.
#[derive(Clone, Debug)]
pub struct Scanner {
    spec: ScannerSpec,
    noise: NoiseLevel,
    /// Which sonar each slot fires, if it is one that is used.
    slots: Vec<Option<usize>>,
    ears: Vec<Ear>,
    /// What echoes come by.
    cone: Cone,
    /// The same cone with nothing lost: what there is.
    truth: Cone,
    readings: Vec<Reading>,
    rng: ChaCha8Rng,
}

impl Scanner {
    /// A scanner that has not read anything yet.
    #[must_use]
    pub fn new(
        spec: &ScannerSpec,
        mounts: &[Mount],
        order: FiringOrder,
        noise: NoiseLevel,
        rng: ChaCha8Rng,
    ) -> Self {
        let fired = spec.orders.of(order);
        let slots: Vec<_> = (0..spec.slots as usize).map(|slot| fired.get(slot).copied()).collect();
        let before =
            |sonar: usize| loud_before(&slots, slots.iter().position(|&s| s == Some(sonar))?);
        let ear = |(sonar, mount): (usize, &Mount)| Ear {
            place: mount.place,
            axis: unit(mount.axis_rad),
            crosstalk: before(sonar).map_or(0.0, |other| {
                let fall = (mount.axis_rad - mounts[other].axis_rad).abs();
                let fall = fall / spec.crosstalk_angle_deg.to_radians();
                noise.crosstalk * spec.crosstalk * libm::exp(-fall)
            }),
            ghost: None,
            haunted: false,
            silent: false,
        };
        let critical_deg = if noise.real { spec.critical_deg } else { 90.0 };
        let cone = |critical_deg: f64| {
            let half_rad = (0.5 * spec.cone_deg).to_radians();
            Cone::new(half_rad, spec.rays as usize, spec.range_m, critical_deg.to_radians())
        };
        Self {
            noise,
            ears: mounts.iter().enumerate().map(ear).collect(),
            slots,
            cone: cone(critical_deg),
            truth: cone(90.0),
            readings: vec![Reading { range_m: spec.range_m, echo: Echo::None }; mounts.len()],
            rng,
            spec: spec.clone(),
        }
    }

    /// Slots of a cycle.
    #[must_use]
    pub fn slots(&self) -> usize {
        self.slots.len()
    }

    /// Time of a slot, seconds.
    #[must_use]
    pub fn slot_s(&self) -> f64 {
        self.spec.slot_s
    }

    /// Greatest reading, metres.
    #[must_use]
    pub fn range_m(&self) -> f64 {
        self.spec.range_m
    }

    /// The latest reading of each sonar.
    #[must_use]
    pub fn readings(&self) -> &[Reading] {
        &self.readings
    }

    /// Lets a sonar fall silent, or answer again.
    pub fn silence(&mut self, sonar: usize, silent: bool) {
        if let Some(ear) = self.ears.get_mut(sonar) {
            ear.silent = silent;
        }
    }

    /// Whether each sonar is silent.
    #[must_use]
    pub fn silent(&self) -> Vec<bool> {
        self.ears.iter().map(|ear| ear.silent).collect()
    }

    /// Fires the sonar of a slot from where the robot is, at a time in seconds.
    pub fn fire(&mut self, slot: usize, time_s: f64, pose: &Pose, near: &Near, rounds: &[Round]) {
        let Some(sonar) = self.slots[slot] else { return };
        if self.ears[sonar].silent {
            self.readings[sonar] = Reading { range_m: self.spec.range_m, echo: Echo::Silent };
            return;
        }
        let heard = self.hear(sonar, pose, near, rounds);
        let loud = loud_before(&self.slots, slot).filter(|&other| !self.ears[other].silent);
        self.cross_talk(sonar, loud.is_some(), time_s);
        let heard = self.haunt(sonar, time_s, heard);
        self.readings[sonar] = self.distort(heard);
    }

    /// What a sonar hears of its own sound: the nearest echo, which may be lost, and varies.
    fn hear(&mut self, sonar: usize, pose: &Pose, near: &Near, rounds: &[Round]) -> Reading {
        let heading = pose.direction();
        let ear = &self.ears[sonar];
        let place = pose.position() + rotate(ear.place, heading);
        let sight = Sight { near, rounds, place, axis: rotate(ear.axis, heading) };
        let nothing = Reading { range_m: self.spec.range_m, echo: Echo::None };
        let mut nearest = sight
            .echo_m(&self.cone)
            .map_or(nothing, |range_m| Reading { range_m, echo: Echo::Surface });
        let edge_echo = if self.noise.real { self.spec.edge_echo } else { 1.0 };
        for (corner, range_m) in sight.corners(&self.cone) {
            let nearer = range_m < nearest.range_m;
            // Corners of rooms throw sound back whence it came; edges scatter it, now and then here.
            if nearer && (!corner.is_edge || self.rng.random_bool(edge_echo)) {
                let echo = if corner.is_edge { Echo::Edge } else { Echo::Surface };
                nearest = Reading { range_m, echo };
            }
        }
        if nearest.echo == Echo::None {
            return nothing;
        }
        if self.by_chance(self.noise.dropout * self.spec.dropout) {
            return Reading { echo: Echo::Dropped, ..nothing };
        }
        if self.noise.real {
            let deviation_m = self.spec.deviation_m + self.spec.deviation_share * nearest.range_m;
            nearest.range_m += deviation_m * self.normal();
        }
        nearest
    }

    /// Begins and ends crosstalk.
    fn cross_talk(&mut self, sonar: usize, is_loud: bool, time_s: f64) {
        if self.ears[sonar].ghost.is_some_and(|ghost| ghost.until_s <= time_s) {
            self.ears[sonar].ghost = None;
        }
        let deaf = !is_loud || self.ears[sonar].ghost.is_some();
        if deaf || !self.by_chance(self.ears[sonar].crosstalk) {
            return;
        }
        let ScannerSpec { least_m, range_m, crosstalk_mean_s, .. } = self.spec;
        let lasts: f64 = Exp1.sample(&mut self.rng);
        let ghost = Ghost {
            range_m: self.rng.random_range(least_m..=range_m),
            until_s: time_s + crosstalk_mean_s * lasts,
        };
        self.ears[sonar].ghost = Some(ghost);
        if self.by_chance(self.noise.neighbours) {
            let right = sonar + 1 < self.ears.len() && (sonar == 0 || self.rng.random_bool(0.5));
            let neighbour = if right { sonar + 1 } else { sonar.saturating_sub(1) };
            self.ears[neighbour].ghost = Some(ghost);
        }
    }

    /// Lets a ghost be heard where it is nearer.
    fn haunt(&mut self, sonar: usize, time_s: f64, heard: Reading) -> Reading {
        let ghost = self.ears[sonar].ghost.filter(|ghost| ghost.until_s > time_s);
        self.ears[sonar].haunted = ghost.is_some();
        let Some(ghost) = ghost else { return heard };
        let range_m = ghost.range_m + self.spec.crosstalk_deviation_m * self.normal();
        if range_m < heard.range_m { Reading { range_m, echo: Echo::Ghost } } else { heard }
    }

    /// Shortens a reading by chance, and keeps it within what the scanner can give.
    fn distort(&mut self, heard: Reading) -> Reading {
        let ScannerSpec { least_m, range_m, .. } = self.spec;
        let mut reading = heard;
        if heard.range_m > least_m && self.by_chance(self.noise.spurious * self.spec.spurious) {
            let short_m = self.rng.random_range(least_m..=heard.range_m);
            reading = Reading { range_m: short_m, echo: Echo::Spurious };
        }
        Reading { range_m: reading.range_m.clamp(least_m, range_m), ..reading }
    }

    /// Distance of the nearest surface in the cone of a sonar, metres; the range where there is none.
    #[must_use]
    pub fn truth_m(&self, sonar: usize, pose: &Pose, near: &Near, rounds: &[Round]) -> f64 {
        let heading = pose.direction();
        let ear = &self.ears[sonar];
        let place = pose.position() + rotate(ear.place, heading);
        Sight { near, rounds, place, axis: rotate(ear.axis, heading) }.nearest_m(&self.truth)
    }

    /// How many sonars were hearing the sound of another when they were last fired, nearer or not.
    #[must_use]
    pub fn haunted(&self) -> usize {
        self.ears.iter().filter(|ear| ear.haunted).count()
    }

    fn by_chance(&mut self, probability: f64) -> bool {
        probability > 0.0 && self.rng.random::<f64>() < probability
    }

    fn normal(&mut self) -> f64 {
        StandardNormal.sample(&mut self.rng)
    }
}

/// The sonar that the slot before one fires, if it is another of those that are used.
fn loud_before(slots: &[Option<usize>], slot: usize) -> Option<usize> {
    slots[(slot + slots.len() - 1) % slots.len()].filter(|&other| Some(other) != slots[slot])
}

#[cfg(test)]
mod tests;
