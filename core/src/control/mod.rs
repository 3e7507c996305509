//! Controllers: the fuzzy reflex.

mod reflex;

pub use reflex::{Reflex, ReflexSettings, ReflexTrace};
