//! Fuzzy sets and inference, section 2.6.

pub mod advice;
mod mamdani;
mod sets;

pub use mamdani::{Inference, centre_of_area};
pub use sets::{Triangle, falling};
