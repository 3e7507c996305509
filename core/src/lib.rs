//! The science of Sonarium, without input or output.
//!
//! Everything here is a state machine: an observation goes in, a decision comes out, with its
//! explanation. Time and randomness are parameters; there is no clock, no file, no thread.
//! Data flows one way: [`world`] → [`robot`] → [`fuzzy`] → [`control`] → [`learner`] → [`experiment`].
//!
//! Equation and section numbers are those of the thesis "Towards Real Learning Robots" (1999).

pub mod control;
pub mod experiment;
pub mod fuzzy;
pub mod geometry;
pub mod learner;
pub mod rng;
pub mod robot;
pub mod settings;
pub mod world;
