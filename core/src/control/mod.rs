//! Controllers: the navigator of chapter 2 and the reflex of chapter 5.

mod navigator;
mod reflex;

pub use navigator::{REGIONS, navigator};
pub use reflex::{Reflex, ReflexSettings, ReflexTrace};
