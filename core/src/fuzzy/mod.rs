//! Fuzzy sets, rules and inference, section 2.6.

pub mod advice;
mod mamdani;
mod norms;
mod rules;
mod sets;

pub use mamdani::{
    Defuzzifier, Inference, centre_of_area, centre_of_values, mean_of_greatest, mean_of_maximum,
};
pub use norms::Norms;
pub use rules::{
    Consequent, Explained, Firing, Input, MOST_INPUTS, MOST_OUTPUTS, MOST_SETS, NamedSet, Output,
    Rule, RuleBase, RuleError,
};
pub use sets::{Set, Shape, Trapezoid, Triangle, falling};
