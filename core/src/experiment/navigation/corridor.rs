//! The experiment `corridor`: Experiments I and II of section 2.9, at a glance.
//!
//! NOTE: the thesis prints a corridor of 100 m with three doors of 1.8 m and people moving around; its
//! width, the doors' places and thickness, and how people move are ours.

use std::sync::Arc;

use super::run::{Crowd, Setup, Starts};
use super::vehicle::{Outfit, hashed};
use super::{NavigationError, NoiseChoice, fusion_rule};
use crate::geometry::{Pose, Vec2};
use crate::perception::{MedianRank, Method};
use crate::robot::{FiringOrder, Robot};
use crate::world::{Arena, Passage, Ring, Surface};

crate::settings! {
    /// Settings of the experiment `corridor`.
    pub struct CorridorSettings {
        compare: bool = false, "compare" "", Simulation, "section 2.9, Experiments I and II", "Each run is driven twice, by the minimum and by the median and Algorithm 1, from the same random numbers";
        method: Method = Method::MedianKalman, "fusion.method" "", Literal, "sections 2.4 and 2.9", "How a region's depth is made; `minimum` is Experiment I, `median-kalman` Experiment II";
        rank: MedianRank = MedianRank::Lower, "fusion.median" "", Reading, "Eq. (2.2)", "Which of an even number of readings is the median";
        window: u32 = 3, "fusion.window" [1.0, 20.0] "", Literal, "section 2.4; Algorithm 1, n", "Length of the window: n + 1 readings, z(t-n) to z(t)";
        deviation_m: f64 = 0.32, "fusion.sonar_deviation" [0.001, 10.0] "m", Gap, "Eq. (2.8), ς; calibrated", "Standard deviation of a reading";
        walk_m: f64 = 0.08, "fusion.walk" [0.0, 10.0] "m", Addition, "Eq. (1.8)", "Standard deviation by which a depth walks from cycle to cycle (median-walk)";
        overlap: bool = true, "hashing.overlap" "", Literal, "section 2.3", "Sonars next to another region belong to both";
        ideal: bool = false, "noise.ideal" "", Simulation, "section 2.9", "Ideal sonars: no noise, every ray comes back";
        noise: f64 = 4.0, "noise.level" [0.0, 20.0] "", Simulation, "section 2.2", "Times the noise in the robot's file; at 0 echoes vary and surfaces are specular, and that is all";
        crosstalk: bool = true, "noise.crosstalk" "", Simulation, "section 2.2", "There is crosstalk";
        spurious: bool = true, "noise.spurious" "", Simulation, "section 2.2", "There are spurious readings";
        dropout: bool = true, "noise.dropout" "", Simulation, "section 2.2", "Echoes are lost";
        neighbours: f64 = 0.0, "noise.neighbours" [0.0, 1.0] "", Simulation, "section 2.2", "Probability that a ghost is heard by a neighbour too";
        order: FiringOrder = FiringOrder::Staggered, "sonar.order" "", Literal, "section 2.2", "The order in which the sonars are fired";
        length_m: f64 = 100.0, "corridor.length" [6.0, 1000.0] "m", Literal, "section 2.9", "Length of the corridor";
        width_m: f64 = 2.4, "corridor.width" [1.2, 20.0] "m", Gap, "section 2.9", "Width of the corridor";
        doors: u32 = 3, "corridor.doors" [0.0, 20.0] "", Literal, "section 2.9", "Doors across it, evenly spread";
        door_width_m: f64 = 1.8, "corridor.door_width" [0.8, 20.0] "m", Literal, "section 2.9", "Width of a door";
        thickness_m: f64 = 0.15, "corridor.wall" [0.02, 1.0] "m", Gap, "section 2.9", "Thickness of the wall that a door is in";
        people: u32 = 5, "people.count" [0.0, 50.0] "", Gap, "section 2.9", "People who walk up and down";
        start_m: f64 = 1.2, "start.place" [0.6, 100.0] "m", Simulation, "reading", "Where along the corridor a run starts";
        aside_m: f64 = 0.25, "start.aside" [0.0, 10.0] "m", Simulation, "reading", "Greatest distance of a start from the middle";
        turned_deg: f64 = 10.0, "start.turned" [0.0, 180.0] "deg", Simulation, "reading", "Greatest heading of a start from the corridor's";
        limit_s: f64 = 1500.0, "trial.time_limit" [10.0, 100_000.0] "s", Simulation, "reading", "Time after which a run is broken off";
    }
}

/// How far before the end of the corridor a run is done, metres.
const END_M: f64 = 2.5;

impl CorridorSettings {
    /// The doors.
    #[must_use]
    pub fn passages(&self) -> Vec<Passage> {
        let x_m = |door: u32| self.length_m * f64::from(door) / f64::from(self.doors + 1);
        let half_width_m = 0.5 * self.door_width_m;
        (1..=self.doors).map(|door| Passage { x_m: x_m(door), half_width_m }).collect()
    }

    /// The floor: one ring, the walls that hold doors jutting into it from both sides.
    ///
    /// # Errors
    /// When the settings leave no floor.
    pub fn arena(&self) -> Result<Arena, NavigationError> {
        self.check()?;
        let half_m = 0.5 * self.width_m;
        let mut side = vec![Vec2::new(0.0, -half_m)];
        for Passage { x_m, half_width_m } in self.passages() {
            let (from_m, to_m) = (x_m - 0.5 * self.thickness_m, x_m + 0.5 * self.thickness_m);
            side.extend([
                Vec2::new(from_m, -half_m),
                Vec2::new(from_m, -half_width_m),
                Vec2::new(to_m, -half_width_m),
                Vec2::new(to_m, -half_m),
            ]);
        }
        side.push(Vec2::new(self.length_m, -half_m));
        let other = side.iter().rev().map(|point| Vec2::new(point.x, -point.y));
        let points: Vec<Vec2> = side.iter().copied().chain(other).collect();
        let surface = |index: usize| {
            // Of each door's four points the first three begin an edge of its frame.
            let index = index % side.len();
            let last = side.len() - 1;
            if index == 0 || index == last || index.is_multiple_of(4) {
                Surface::Wall
            } else {
                Surface::Door
            }
        };
        let surfaces = (0..points.len()).map(surface).collect();
        Ok(Arena::new(vec![Ring { points, surfaces }])?)
    }

    fn check(&self) -> Result<(), NavigationError> {
        let contradiction = |key, expected: String, found: f64| {
            Err(NavigationError::Contradiction { key, expected, found: found.to_string() })
        };
        if self.doors > 0 && self.door_width_m > self.width_m - 0.01 {
            let expected = format!("less than `corridor.width`, {}", self.width_m);
            return contradiction("corridor.door_width", expected, self.door_width_m);
        }
        let apart_m = self.length_m / f64::from(self.doors + 1);
        if apart_m < 2.0 {
            let expected = format!("at most {} for this length", (0.5 * self.length_m) as u32 - 1);
            return contradiction("corridor.doors", expected, f64::from(self.doors));
        }
        if self.start_m > self.length_m - END_M {
            let expected = format!("at most {}, before the end", self.length_m - END_M);
            return contradiction("start.place", expected, self.start_m);
        }
        let most_m = (0.5 * self.width_m - 0.5).max(0.0);
        if self.aside_m > most_m {
            let expected = format!("at most {most_m} for this width");
            return contradiction("start.aside", expected, self.aside_m);
        }
        Ok(())
    }

    pub(super) fn setup(&self, robot: &Robot) -> Result<Setup, NavigationError> {
        let unequipped = || NavigationError::Unequipped(robot.name().to_owned());
        let equipment = robot.equipment().ok_or_else(unequipped)?;
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
                arena: Arc::new(self.arena()?),
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
            hashing: hashed(5, robot.sonars().len(), self.overlap)?,
            fusion: fusion_rule(self.rank, self.window, self.deviation_m, self.walk_m),
            method: self.method,
            starts: Starts::Round {
                pose: Pose::new(self.start_m, 0.0, 0.0),
                aside_m: self.aside_m,
                turned_rad: self.turned_deg.to_radians(),
            },
            doors: self.passages(),
            people: Crowd::Anywhere(self.people as usize),
            corridor_m: [self.length_m, 0.5 * self.width_m],
            finish_m: Some(self.length_m - END_M),
            limit_s: self.limit_s,
        })
    }
}
