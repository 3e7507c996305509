//! The experiment `block-world`: the simulation of section 2.9, figure 2.10.
//!
//! The thesis prints the size of the world, 47.5 by 40 units, and of the robot, 4 by 4 units with a
//! range of 10. NOTE: the range of 2 m makes a unit 0.2 m; the blocks of the two worlds, which the
//! lost figure shows, are ours.

use std::sync::Arc;

use super::run::{Crowd, Setup, Starts};
use super::vehicle::{Outfit, hashed};
use super::{NavigationError, NoiseChoice, fusion_rule};
use crate::geometry::{Pose, Vec2};
use crate::perception::{MedianRank, Method};
use crate::robot::{Body, DriveSpec, FiringOrder, Mount, Robot, ScannerSpec};
use crate::world::{Arena, Ring, Surface};

crate::choice! {
    /// The blocks.
    pub enum BlockLayout {
        Sparse = "sparse": "five blocks, figure 2.10 above",
        Dense = "dense": "ten blocks in rows, figure 2.10 below",
    }
}

crate::choice! {
    /// Where a run starts.
    pub enum BlockStart {
        Shown = "shown": "where the run that is shown starts",
        Random = "random": "anywhere on the floor",
    }
}

crate::settings! {
    /// Settings of the experiment `block-world`.
    pub struct BlockWorldSettings {
        layout: BlockLayout = BlockLayout::Sparse, "world.blocks" "", Gap, "figure 2.10, lost", "Which blocks there are";
        start: BlockStart = BlockStart::Shown, "start.place" "", Simulation, "figure 2.10, lost", "Where a run starts";
        limit_s: f64 = 300.0, "trial.time_limit" [10.0, 100_000.0] "s", Simulation, "reading", "Length of a run";
        compare: bool = false, "compare" "", Simulation, "section 2.9, Experiments I and II", "Each run is driven twice, by the minimum and by the median and Algorithm 1, from the same random numbers";
        method: Method = Method::Minimum, "fusion.method" "", Literal, "section 2.9", "How a region's depth is made";
        rank: MedianRank = MedianRank::Lower, "fusion.median" "", Reading, "Eq. (2.2)", "Which of an even number of readings is the median";
        window: u32 = 3, "fusion.window" [1.0, 20.0] "", Literal, "section 2.4; Algorithm 1, n", "Length of the window: n + 1 readings, z(t-n) to z(t)";
        deviation_m: f64 = 0.32, "fusion.sonar_deviation" [0.001, 10.0] "m", Gap, "Eq. (2.8), ς; calibrated", "Standard deviation of a reading";
        walk_m: f64 = 0.08, "fusion.walk" [0.0, 10.0] "m", Addition, "Eq. (1.8)", "Standard deviation by which a depth walks from cycle to cycle (median-walk)";
        overlap: bool = true, "hashing.overlap" "", Literal, "section 2.3", "Sonars next to another region belong to both";
        ideal: bool = true, "noise.ideal" "", Literal, "section 2.9", "Ideal sonars: no noise, every ray comes back, no least reading";
        noise: f64 = 4.0, "noise.level" [0.0, 20.0] "", Simulation, "section 2.2", "Times the noise in the robot's file; at 0 echoes vary and surfaces are specular, and that is all";
        crosstalk: bool = true, "noise.crosstalk" "", Simulation, "section 2.2", "There is crosstalk";
        spurious: bool = true, "noise.spurious" "", Simulation, "section 2.2", "There are spurious readings";
        dropout: bool = true, "noise.dropout" "", Simulation, "section 2.2", "Echoes are lost";
        neighbours: f64 = 0.0, "noise.neighbours" [0.0, 1.0] "", Simulation, "section 2.2", "Probability that a ghost is heard by a neighbour too";
        order: FiringOrder = FiringOrder::Staggered, "sonar.order" "", Literal, "section 2.2", "The order in which the sonars are fired";
        at_once: bool = true, "sonar.at_once" "", Reading, "section 2.9, ideal sensors", "Ideal sonars are all read at the end of a cycle; off, each in its slot while the robot moves";
        inertia_s: f64 = 0.5, "drive.time_constant" [0.01, 10.0] "s", Gap, "section 2.9, simplified dynamics", "Time constant with which velocities follow commands";
    }
}

/// Section 2.9: width and length of the world and side of the robot, units; a unit in metres.
const WORLD: [f64; 2] = [47.5, 40.0];
const ROBOT: f64 = 4.0;
const UNIT_M: f64 = 0.2;
/// Clearance of a random start, metres.
const START_M: f64 = 0.2;

/// Blocks as `[x0, y0, x1, y1]`, units.
const SPARSE: [[f64; 4]; 5] = [
    [11.0, 9.0, 17.0, 15.0],
    [30.0, 8.0, 36.0, 13.0],
    [20.0, 22.0, 27.0, 28.0],
    [36.0, 24.0, 40.0, 32.0],
    [8.0, 27.0, 12.0, 32.0],
];
const DENSE: [[f64; 4]; 10] = [
    [8.5, 8.5, 12.5, 12.5],
    [21.5, 8.5, 26.0, 12.0],
    [35.0, 8.5, 39.0, 12.5],
    [0.0, 18.5, 3.0, 21.5],
    [14.0, 18.5, 18.5, 21.5],
    [28.5, 18.5, 33.0, 21.5],
    [44.5, 18.5, 47.5, 21.5],
    [8.5, 27.5, 12.5, 31.5],
    [21.5, 28.0, 26.0, 31.5],
    [35.0, 27.5, 39.0, 31.5],
];

impl BlockLayout {
    fn blocks(self) -> &'static [[f64; 4]] {
        match self {
            Self::Sparse => &SPARSE,
            Self::Dense => &DENSE,
        }
    }

    /// Where the run that is shown starts.
    fn shown(self) -> Pose {
        let (x, y) = match self {
            Self::Sparse => (22.0, 18.0),
            Self::Dense => (27.0, 4.0),
        };
        Pose::new(x * UNIT_M, y * UNIT_M, (-15.0_f64).to_radians())
    }

    /// The floor.
    ///
    /// # Panics
    /// Never: the blocks are sound.
    #[must_use]
    pub fn arena(self) -> Arena {
        let room = rectangle([0.0, 0.0, WORLD[0], WORLD[1]], Surface::Wall);
        let block = |&block: &[f64; 4]| {
            let mut ring = rectangle(block, Surface::Block);
            ring.points.reverse();
            ring
        };
        let rings = [room].into_iter().chain(self.blocks().iter().map(block)).collect();
        Arena::new(rings).expect("rings that bound a floor")
    }
}

fn rectangle([x0, y0, x1, y1]: [f64; 4], surface: Surface) -> Ring {
    let points = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
    let points = points.map(|point| Vec2::from(point) * UNIT_M).to_vec();
    Ring { points, surfaces: vec![surface; 4] }
}

impl BlockWorldSettings {
    pub(super) fn setup(&self, robot: &Robot) -> Result<Setup, NavigationError> {
        let unequipped = || NavigationError::Unequipped(robot.name().to_owned());
        let equipment = robot.equipment().ok_or_else(unequipped)?;
        let Body::Box { half_length_m, half_width_m } = robot.body() else {
            return Err(unequipped());
        };
        // Section 2.9: the robot's size was reduced proportionally, the sonars keep their orientation.
        let half_m = 0.5 * ROBOT * UNIT_M;
        let (along, across) = (half_m / half_length_m, half_m / half_width_m);
        let mounts = robot.sonars().iter().map(|mount| Mount {
            place: Vec2::new(mount.place.x * along, mount.place.y * across),
            ..*mount
        });
        let least_m = if self.ideal { 0.0 } else { equipment.scanner.least_m };
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
                arena: Arc::new(self.layout.arena()),
                body: Body::Box { half_length_m: half_m, half_width_m: half_m },
                bumper: equipment.bumper,
                compass: equipment.compass,
                at_once: self.at_once && self.ideal,
            },
            mounts: mounts.collect(),
            scanner: ScannerSpec { least_m, ..equipment.scanner.clone() },
            order: self.order,
            noise: noise.level(),
            drive: DriveSpec { time_constant_s: self.inertia_s, ..equipment.drive },
            hashing: hashed(5, robot.sonars().len(), self.overlap)?,
            fusion: fusion_rule(self.rank, self.window, self.deviation_m, self.walk_m),
            method: self.method,
            starts: match self.start {
                BlockStart::Shown => {
                    Starts::Round { pose: self.layout.shown(), aside_m: 0.0, turned_rad: 0.0 }
                }
                BlockStart::Random => Starts::Anywhere { clearance_m: START_M },
            },
            doors: Vec::new(),
            people: Crowd::Anywhere(0),
            corridor_m: [0.0, 0.0],
            finish_m: None,
            limit_s: self.limit_s,
        })
    }
}
