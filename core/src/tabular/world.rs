//! Worlds for tabular learners, and the closed list of them.

use serde::{Deserialize, Serialize};

use super::{Gate, Maze, Mdp, Table};
use crate::labyrinth::Labyrinth;

/// A term of a feature, like `near` of `goal`: how far it holds in each state.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Degrees {
    /// The term.
    pub term: String,
    /// Degree of each state, 0 to 1.
    pub degrees: Vec<f64>,
}

/// Something the agent can tell about where it is, in words for advice.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Feature {
    /// Its name.
    pub name: String,
    /// What it is about.
    pub meaning: String,
    /// Its terms.
    pub terms: Vec<Degrees>,
}

/// What a designer may know of a world and put into a learner as a bias, section 4.3.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Knowledge {
    /// Features that advice may speak of.
    pub features: Vec<Feature>,
    /// Action of the reflex in each state; empty where there is no reflex.
    pub reflex: Vec<usize>,
    /// Estimated way to the goal of each state, in steps; empty where nobody can estimate it.
    pub estimate: Vec<f64>,
    /// States that are subgoals; empty where there are none.
    pub subgoals: Vec<bool>,
    /// Behaviours and their gate.
    pub gate: Option<Gate>,
}

/// A world that can be learned in a table.
pub trait World {
    /// Transitions and rewards.
    fn mdp(&self) -> &Mdp;
    /// State in which every trial starts.
    fn start(&self) -> usize;
    /// A state, in words.
    fn state_name(&self, state: usize) -> String;
    /// The actions' names.
    fn action_names(&self) -> &[String];
    /// What a designer may know of it.
    fn knowledge(&self) -> &Knowledge;
}

/// One of the worlds.
#[derive(Clone, Debug, PartialEq)]
pub enum AnyWorld {
    /// A process written down row by row.
    Table(Table),
    /// A maze drawn in characters.
    Maze(Maze),
    /// The labyrinth of chapter 4.
    Labyrinth(Labyrinth),
}

impl AnyWorld {
    fn inner(&self) -> &dyn World {
        match self {
            Self::Table(world) => world,
            Self::Maze(world) => world,
            Self::Labyrinth(world) => world,
        }
    }
}

impl World for AnyWorld {
    fn mdp(&self) -> &Mdp {
        self.inner().mdp()
    }

    fn start(&self) -> usize {
        self.inner().start()
    }

    fn state_name(&self, state: usize) -> String {
        self.inner().state_name(state)
    }

    fn action_names(&self) -> &[String] {
        self.inner().action_names()
    }

    fn knowledge(&self) -> &Knowledge {
        self.inner().knowledge()
    }
}
