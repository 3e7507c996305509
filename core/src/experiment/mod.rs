//! Every experiment as data: name, settings, seed, result.

mod minimum_cost_path;
mod settings;

pub use minimum_cost_path::{
    AlteredStart, Checkpoint, Excursion, MinimumCostPath, NeuronRef, SetupError,
};
pub use settings::{OnCollision, Settings};
