//! The growing, localized actor-critic of chapter 5.

mod explanation;

pub use explanation::*;
