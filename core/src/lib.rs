//! The science of Sonarium, without input or output.
//!
//! Everything here is a state machine: an observation goes in, a decision comes out, with its
//! explanation. Time and randomness are parameters; there is no clock, no file, no thread.
//! Data flows one way: [`world`] → [`robot`] → [`perception`] → [`fuzzy`] → [`control`] → [`learner`] →
//! [`experiment`]; [`planner`] finds the path that a learner could not better; [`stats`] judges what came
//! out. Chapters 3 and 4 are [`tabular`] and [`labyrinth`], with experiments of the same form.
//!
//! ```
//! use std::sync::Arc;
//! use sonarium_core::experiment::{MinimumCostPath, Settings};
//! use sonarium_core::robot::{Robot, RobotFile};
//! use sonarium_core::world::{World, WorldFile};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let robot: RobotFile = toml::from_str(include_str!("../../assets/robots/b21.toml"))?;
//! let world: WorldFile = toml::from_str(include_str!("../../assets/worlds/laboratory.toml"))?;
//! let robot = Arc::new(Robot::new(&robot)?);
//! let world = Arc::new(World::new(&world, robot.body().reach_m())?);
//! let mut run = MinimumCostPath::new(world, robot, &Settings::default(), 1)?;
//! while run.trials_done() < 20 {
//!     if let (_, Some(end)) = run.step() {
//!         assert!(end.record.steps > 0);
//!     }
//! }
//! # Ok(())
//! # }
//! ```
//!
//! Equation and section numbers are those of the thesis "Towards Real Learning Robots" (1999).

pub mod control;
pub mod experiment;
pub mod fuzzy;
pub mod geometry;
pub mod labyrinth;
pub mod learner;
pub mod perception;
pub mod planner;
pub mod rng;
pub mod robot;
pub mod settings;
mod simd;
pub mod stats;
pub mod tabular;
pub mod world;
