//! What can be run: experiments, robots, presets and worlds, and how a request becomes full settings.

mod experiments;
mod network;
mod plain;
mod plan;
mod presets;
mod robots;
mod starts;
mod values;
mod worlds;

pub use experiments::Experiment;
pub use network::{LARGEST_NETWORK, Trained};
pub use plain::{Equipment, NamedTask, PlainPlan, PlainSettings, Texts};
pub use plan::{FieldError, Job, Plan, speed as check_speed};
pub use presets::Preset;
pub use starts::starts_from_text;
pub use values::{flatten, from_text};
pub use worlds::{
    BrokenWorld, DEFAULT_WORLD, NamedWorld, Worlds, WorldsError, map_beside, map_file,
    parse as parse_world, read as read_world, region_shapes, robot_radius_m, to_toml, world_name,
};

use std::path::Path;
use std::sync::Arc;

use sonarium_core::fuzzy::RuleBase;
use sonarium_core::robot::{self, Robot};

use crate::wire::ExperimentInfo;

/// Chapter 5 on the B21.
pub const MINIMUM_COST_PATH: &str = "minimum-cost-path";
/// The experiment of section 5.11's simulation.
pub const MINIMUM_COST_PATH_TRC: &str = "minimum-cost-path-trc";
/// Most trials a session may have.
pub const MAX_TRIALS: u32 = 100_000;
/// Trials of a session unless told otherwise: the set of section 5.10.
pub const DEFAULT_TRIALS: u32 = 20;

/// Everything that can be run.
#[derive(Debug)]
pub struct Catalog {
    worlds: Worlds,
    tasks: plain::Tasks,
    experiments: Vec<Experiment>,
    plain: Vec<plain::PlainExperiment>,
    infos: Vec<ExperimentInfo>,
}

/// The files that came with the program are broken.
#[derive(Debug, thiserror::Error)]
#[error("{file}: {message}")]
pub struct CatalogError {
    /// The file at fault.
    pub file: String,
    /// What is wrong with it.
    pub message: String,
}

impl Catalog {
    /// The files embedded in the program, and the worlds in a folder of the user's, if it exists.
    ///
    /// # Errors
    /// When an embedded file is broken. A broken world of the user's is kept and refused when chosen.
    pub fn load(own_worlds: Option<&Path>) -> Result<Self, CatalogError> {
        let worlds = Worlds::load(own_worlds)?;
        let tasks = plain::Tasks::embedded()?;
        let (experiments, plain) =
            experiments::embedded(&robots::embedded()?, &worlds, presets::embedded()?, &tasks)?;
        let mut catalog = Self { worlds, tasks, experiments, plain, infos: Vec::new() };
        catalog.infos = catalog.experiments();
        Ok(catalog)
    }

    /// All experiments, with the worlds that there are now.
    #[must_use]
    pub fn experiments(&self) -> Vec<ExperimentInfo> {
        let paths = self.experiments.iter().map(|experiment| experiment.info(&self.worlds));
        paths.chain(self.plain.iter().map(|table| table.info(&self.tasks))).collect()
    }

    /// An experiment by name, as a user sees it, with the worlds that there were when the program started.
    #[must_use]
    pub fn experiment(&self, name: &str) -> Option<&ExperimentInfo> {
        self.infos.iter().find(|experiment| experiment.name == name)
    }

    /// All worlds.
    #[must_use]
    pub fn worlds(&self) -> &Worlds {
        &self.worlds
    }

    /// Adds a world for this run, before all others of its name.
    pub fn give_world(&mut self, world: NamedWorld) {
        self.worlds.give(world);
    }

    /// What the robot of chapter 2 carries: its sonars are those that are calibrated.
    #[must_use]
    pub fn equipment(&self) -> Option<&robot::Equipment> {
        self.plain.iter().find_map(plain::PlainExperiment::robot).and_then(Robot::equipment)
    }

    /// The rule bases that drive robots, each once.
    #[must_use]
    pub fn rules(&self) -> Vec<Arc<RuleBase>> {
        let mut rules: Vec<Arc<RuleBase>> = Vec::new();
        for found in self.plain.iter().filter_map(plain::PlainExperiment::rules) {
            if rules.iter().all(|known| known.name() != found.name()) {
                rules.push(found);
            }
        }
        rules
    }

    /// Adds a maze or a process for this run, before all others of its name.
    pub fn give_task(&mut self, task: NamedTask) {
        self.tasks.give(task);
    }
}
