//! The labyrinth of chapter 4: sixteen states, three actions, and the beliefs that bias a learner in it.

mod belief;
mod continual;
mod episode;
mod index;
mod knowledge;
mod world;

pub use belief::{Bias, EnvironmentRule, GoalActions, InsightRule, Matrix, Readings, matrix};
pub use continual::{Continual, ContinualRule, TRAINING_STREAMS, continual};
pub use episode::{Episode, EpisodeRule, belief, compact, episodes, walk_setup};
pub use index::{Contestant, EPISODES, Gain, gain, gains, published, table_4_3};
pub use world::{
    ACTIONS, Action, Labyrinth, LabyrinthError, STATES, collides, distances, next, place,
};
