//! What can be run: experiments, presets and worlds, and how a request becomes full settings.

mod plan;
mod presets;
mod values;
mod worlds;

pub use plan::{FieldError, Plan, speed as check_speed};
pub use presets::Preset;
pub use values::{flatten, from_text};
pub use worlds::{
    BrokenWorld, DEFAULT_WORLD, NamedWorld, Worlds, WorldsError, parse as parse_world,
    read as read_world, region_shapes, robot_radius_m, to_toml, world_name,
};

use std::path::Path;

use sonarium_core::experiment::Settings;
use sonarium_core::settings::{Kind, Spec};

use crate::wire::{Choice, ExperimentInfo, SettingInfo};

/// The one experiment there is so far.
pub const MINIMUM_COST_PATH: &str = "minimum-cost-path";
/// Most trials a session may have.
pub const MAX_TRIALS: u32 = 100_000;
/// Trials of a session unless told otherwise: the set of section 5.10.
pub const DEFAULT_TRIALS: u32 = 20;

/// Everything that can be run.
#[derive(Debug)]
pub struct Catalog {
    presets: Vec<Preset>,
    worlds: Worlds,
    experiments: Vec<ExperimentInfo>,
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
        let presets = presets::embedded()?;
        let worlds = Worlds::load(own_worlds)?;
        let experiments = vec![minimum_cost_path(&presets)];
        Ok(Self { presets, worlds, experiments })
    }

    /// All experiments, with the worlds that there are now.
    #[must_use]
    pub fn experiments(&self) -> Vec<ExperimentInfo> {
        let worlds = self.worlds.infos();
        let experiments = self.experiments.iter().cloned();
        experiments.map(|info| ExperimentInfo { worlds: worlds.clone(), ..info }).collect()
    }

    /// An experiment by name, without its worlds, which [`Catalog::experiments`] fills in.
    #[must_use]
    pub fn experiment(&self, name: &str) -> Option<&ExperimentInfo> {
        self.experiments.iter().find(|experiment| experiment.name == name)
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

    /// All presets; the first is the default.
    #[must_use]
    pub fn presets(&self) -> &[Preset] {
        &self.presets
    }
}

/// Its worlds are filled in when somebody asks.
fn minimum_cost_path(presets: &[Preset]) -> ExperimentInfo {
    let defaults = Settings::default();
    ExperimentInfo {
        name: MINIMUM_COST_PATH.into(),
        title: "Minimum-cost path".into(),
        summary: "A robot with 24 sonars learns the way from its home to a goal out of sight, \
                  safe and short, from reinforcement alone"
            .into(),
        source: "Chapter 5".into(),
        default_trials: DEFAULT_TRIALS,
        max_trials: MAX_TRIALS,
        presets: presets.iter().map(Preset::info).collect(),
        worlds: Vec::new(),
        settings: Settings::specs().iter().map(|spec| setting(spec, &defaults)).collect(),
    }
}

fn setting(spec: &Spec, defaults: &Settings) -> SettingInfo {
    let (kind, min, max, choices) = match spec.kind {
        Kind::Switch => ("switch", None, None, Vec::new()),
        #[expect(clippy::cast_precision_loss, reason = "bounds are far below 2^53")]
        Kind::Integer(least, most) => {
            ("integer", Some(least as f64), Some(most as f64), Vec::new())
        }
        Kind::Number(least, most) => ("number", Some(least), Some(most), Vec::new()),
        Kind::Choice(names) => ("choice", None, None, names.iter().map(choice).collect()),
    };
    SettingInfo {
        key: spec.key.into(),
        meaning: spec.meaning.into(),
        kind: kind.into(),
        unit: spec.unit.into(),
        default: values::to_json(defaults.get(spec.key).as_ref()),
        min,
        max,
        choices,
        source: spec.source.into(),
        standing: spec.standing.name().into(),
    }
}

fn choice((value, meaning): &(&str, &str)) -> Choice {
    Choice { value: (*value).into(), meaning: (*meaning).into() }
}
