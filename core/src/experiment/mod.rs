//! Every experiment as data: name, settings, seed, result.

mod minimum_cost_path;

pub use minimum_cost_path::{Checkpoint, MinimumCostPath, NeuronRef, Settings, SetupError};
