//! Every experiment as data: name, settings, seed, result.

mod bandit;
mod contest;
mod continual;
mod gridworld;
mod horizon;
mod labyrinth;
mod minimum_cost_path;
mod navigation;
mod settings;
mod tabular_bias;

pub use bandit::{
    BanditCheckpoint, BanditEpisode, BanditRun, BanditScore, BanditSettings, BanditStep, Levers,
};
pub use contest::{
    Contest, ContestCheckpoint, ContestStep, Entrant, EpisodeEnd, Phase, Position, Score,
};
pub use continual::ContinualSettings;
pub use gridworld::{GridworldSettings, Learners};
pub use horizon::{HorizonRun, HorizonSettings, HorizonStep, Model};
pub use labyrinth::{ContestError, LabyrinthExtras, LabyrinthSettings};
pub use minimum_cost_path::{
    AlteredStart, Checkpoint, Excursion, MinimumCostPath, NeuronRef, SetupError,
};
pub use navigation::{
    ApproachEnd, ApproachRun, BlockLayout, BlockStart, BlockWorldSettings, Bump, Contact,
    CorridorSettings, Cycle, HASHING_SETS, MethodScore, NavigationCheckpoint, NavigationError,
    NavigationRun, PEOPLE_FILE, RULES_FILE, RegionState, RunEnd, WallApproachSettings,
};
pub use settings::{OnCollision, Settings};
