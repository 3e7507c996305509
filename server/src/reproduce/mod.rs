//! What the thesis shows and claims, computed again and held against what it prints.
//!
//! A target is data and a function: which experiment runs, with which arms (presets, settings, worlds),
//! what one seed gives ([`Unit`]) and over which seeds, and what is found in all that: rows, curves and
//! pictures. The seeds of targets, 700000 upwards, were used for nothing else: no setting was chosen on
//! them, and none may be.
//!
//! To add one, write a file with a `static` [`Target`] and name it in [`TARGETS`].

mod ablations;
mod carry_over;
mod csv;
mod curve;
mod drives;
mod episodes;
mod experiments_2_9;
mod figure_2_10;
mod figure_2_5;
mod figure_3_3;
mod figure_4_12;
mod figure_5_10;
mod figure_5_8;
mod figure_5_9;
mod figures_4;
mod findings;
mod learning_curves;
mod office;
mod required;
mod robustness;
mod search_space;
mod sets;
mod shelf;
mod table_4_3;
mod table_5_1;

#[cfg(test)]
mod tests;

pub use ablations::ABLATIONS;
pub use carry_over::CARRY_OVER;
pub use csv::{curves_csv, rows_csv};
pub use curve::curve;
pub use drives::{Drive, Drives, Moment};
pub use episodes::Course;
pub use experiments_2_9::EXPERIMENTS_2_9;
pub use figure_2_5::FIGURE_2_5;
pub use figure_2_10::FIGURE_2_10;
pub use figure_3_3::FIGURE_3_3;
pub use figure_4_12::FIGURE_4_12;
pub use figure_5_8::FIGURE_5_8;
pub use figure_5_9::FIGURE_5_9;
pub use figure_5_10::FIGURE_5_10;
pub use figures_4::{FIGURE_4_10, FIGURE_4_11};
pub use findings::{Findings, Origin, Picture, Row};
pub use learning_curves::{FIGURE_5_11, FIGURE_5_12, FIGURE_5_13};
pub use robustness::ROBUSTNESS;
pub use search_space::SEARCH_SPACE_4_9;
pub use sets::{Kept, Sample, Set, Sets};
pub use shelf::Shelf;
pub use table_4_3::TABLE_4_3;
pub use table_5_1::TABLE_5_1;

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use serde_json::Value;
use sonarium_core::labyrinth::EPISODES;
use sonarium_core::stats::Verdict;

use crate::catalog::{Catalog, CatalogError, FieldError, from_text};
use crate::wire::{ReproductionArm, ReproductionTarget};

/// Everything that can be reproduced.
pub static TARGETS: &[&Target] = &[
    &TABLE_5_1,
    &FIGURE_5_8,
    &FIGURE_5_9,
    &FIGURE_5_10,
    &FIGURE_5_11,
    &FIGURE_5_12,
    &FIGURE_5_13,
    &ABLATIONS,
    &ROBUSTNESS,
    &CARRY_OVER,
    &TABLE_4_3,
    &FIGURE_4_10,
    &FIGURE_4_11,
    &FIGURE_4_12,
    &SEARCH_SPACE_4_9,
    &FIGURE_3_3,
    &FIGURE_2_5,
    &FIGURE_2_10,
    &EXPERIMENTS_2_9,
];

/// How verdicts on published figures are found.
pub const PUBLISHED: &str = Verdict::RULE;

/// Seeds of the chapter-5 targets: 200 sets.
pub const SEEDS: RangeInclusive<u64> = 700_000..=700_199;

/// Seeds of a target in which nothing is drawn at random.
pub const NO_SEEDS: RangeInclusive<u64> = RangeInclusive::new(1, 0);

/// The presets of the minimum-cost path, each an arm; `reflex` is the control.
pub const PRESETS: &[Arm] = &[
    Arm { name: "default", settings: &[("preset", "default")] },
    Arm { name: "thesis", settings: &[("preset", "thesis")] },
    Arm { name: "reflex", settings: &[("preset", "reflex")] },
];

/// A table, a figure or a claim of the thesis.
#[derive(Clone, Debug)]
pub struct Target {
    /// Name used in the interface.
    pub name: &'static str,
    /// Title for people.
    pub title: &'static str,
    /// What is held against what.
    pub compares: &'static str,
    /// Where the thesis has it.
    pub source: &'static str,
    /// How its words and figures were read, a sentence each.
    pub readings: &'static [&'static str],
    /// How its verdicts are found.
    pub rules: &'static [&'static str],
    /// Experiment that is run.
    pub experiment: &'static str,
    /// What is run, each over all seeds.
    pub arms: &'static [Arm],
    /// What one seed gives.
    pub unit: Unit,
    /// Trials of a set, or of an episode.
    pub trials: u32,
    /// Seeds, one a set, experiment or run; [`NO_SEEDS`] where nothing is drawn.
    pub seeds: RangeInclusive<u64>,
    /// Runs the arms and says what is found in them.
    pub find: fn(&Target, &Sets<'_>) -> Result<Findings, ReproductionError>,
}

/// What one seed gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// A set of trials, begun with an empty network unless the target carries one over.
    Set,
    /// An experiment of ten episodes, as behind every point of figures 4.10-4.12.
    Experiment,
    /// A run of chapter 2.
    Run,
}

/// One of the learners, or one of the worlds, that a target compares.
#[derive(Clone, Copy, Debug)]
pub struct Arm {
    /// Name, with which the names of its rows begin.
    pub name: &'static str,
    /// Preset, world and other settings, as after `--set`.
    pub settings: &'static [(&'static str, &'static str)],
}

/// Why a target cannot be computed.
#[derive(Clone, Debug, thiserror::Error)]
pub enum ReproductionError {
    /// There is no such target.
    #[error("TARGET: there is no target `{name}`; there are {known}")]
    Unknown {
        /// What was asked for.
        name: String,
        /// What there is.
        known: String,
    },
    /// There is no such picture.
    #[error("there is no picture `{name}`; there are {known}")]
    NoPicture {
        /// What was asked for.
        name: String,
        /// What there is.
        known: String,
    },
    /// The embedded files, or the settings of an arm, are broken.
    #[error("{0}")]
    Broken(String),
}

impl From<CatalogError> for ReproductionError {
    fn from(error: CatalogError) -> Self {
        Self::Broken(error.to_string())
    }
}

impl From<FieldError> for ReproductionError {
    fn from(error: FieldError) -> Self {
        Self::Broken(error.to_string())
    }
}

/// The target with a name.
///
/// # Errors
/// When there is none; the error names those there are.
pub fn target(name: &str) -> Result<&'static Target, ReproductionError> {
    let found = TARGETS.iter().find(|target| target.name == name);
    found
        .copied()
        .ok_or_else(|| ReproductionError::Unknown { name: name.to_owned(), known: known_targets() })
}

/// The names of all targets, for people.
#[must_use]
pub fn known_targets() -> String {
    let names: Vec<String> = TARGETS.iter().map(|target| format!("`{}`", target.name)).collect();
    names.join(", ")
}

impl Unit {
    /// Its name, one of it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Set => "set",
            Self::Experiment => "experiment",
            Self::Run => "run",
        }
    }
}

impl Target {
    /// Sets, experiments or runs for each arm; none where nothing is drawn.
    #[must_use]
    pub fn sets(&self) -> u32 {
        u32::try_from(self.seeds.clone().count()).unwrap_or(u32::MAX)
    }

    /// What is run for each arm, for people: `200 sets of 20 trials an arm, seeds 700000..700199`.
    #[must_use]
    pub fn extent(&self) -> String {
        let (name, trials) = (self.unit.name(), self.trials);
        let (first, last) = (self.seeds.start(), self.seeds.end());
        let inside = match self.unit {
            Unit::Set => format!(" of {trials} trials"),
            Unit::Experiment => format!(" of {EPISODES} episodes of {trials} trials"),
            Unit::Run => String::new(),
        };
        match self.sets() {
            0 => "computed exactly, nothing is drawn at random".to_owned(),
            sets => format!("{sets} {name}s{inside} an arm, seeds {first}..{last}"),
        }
    }

    /// How its verdicts are found, for people.
    #[must_use]
    pub fn rule(&self) -> String {
        self.rules.join(". ")
    }

    /// Sets, experiments or runs of all arms.
    #[must_use]
    pub fn work(&self) -> u32 {
        self.sets() * u32::try_from(self.arms.len()).unwrap_or(u32::MAX)
    }

    /// The target as a user sees it.
    #[must_use]
    pub fn info(&self) -> ReproductionTarget {
        ReproductionTarget {
            name: self.name.into(),
            title: self.title.into(),
            compares: self.compares.into(),
            source: self.source.into(),
            readings: self.readings.iter().map(|&reading| reading.into()).collect(),
            experiment: self.experiment.into(),
            arms: self.arms.iter().map(Arm::info).collect(),
            trials: self.trials,
            unit: self.unit.name().into(),
            sets: self.sets(),
            first_seed: self.seeds.clone().next(),
            last_seed: self.seeds.clone().next_back(),
            extent: self.extent(),
            rule: self.rule(),
            command: format!("sonarium reproduce {}", self.name),
        }
    }

    /// Runs everything on `threads` threads, saying `done` after each set, experiment or run, and judges
    /// the outcome. The result depends neither on the threads nor on their order, on what is kept, nor on
    /// worlds of the user's.
    ///
    /// # Errors
    /// When an embedded preset or world is broken.
    pub fn run(
        &self,
        threads: usize,
        kept: &Kept,
        done: &(dyn Fn() + Sync),
    ) -> Result<Findings, ReproductionError> {
        let catalog = Catalog::load(None)?;
        (self.find)(self, &Sets { catalog: &catalog, threads, kept, done })
    }
}

impl Arm {
    /// Its settings by key.
    #[must_use]
    pub fn values(&self) -> BTreeMap<String, Value> {
        self.settings.iter().map(|&(key, value)| (key.to_owned(), from_text(value))).collect()
    }

    /// What it is, for people: `Preset default with sonar.noise=0.03`.
    #[must_use]
    pub fn words(&self) -> String {
        let named = |wanted: bool| {
            let settings =
                self.settings.iter().filter(move |(key, _)| (*key == "preset") == wanted);
            settings.map(
                move |(key, value)| {
                    if wanted { (*value).to_owned() } else { format!("{key}={value}") }
                },
            )
        };
        let preset = named(true).next().unwrap_or_else(|| "default".to_owned());
        let others: Vec<String> = named(false).collect();
        match others.as_slice() {
            [] => format!("Preset {preset}"),
            others => format!("Preset {preset} with {}", others.join(", ")),
        }
    }

    fn info(&self) -> ReproductionArm {
        ReproductionArm { name: self.name.into(), settings: self.values() }
    }
}
