//! Tables and figures of the thesis, computed again and held against what it prints.
//!
//! A target is data: which experiment runs, under which presets and seeds, and which published figures
//! its last trials are held against. The seeds of targets, 700000 upwards, were used for nothing else:
//! no setting was chosen on them, and none may be.

mod sets;
mod table_5_1;

#[cfg(test)]
mod tests;

pub use table_5_1::TABLE_5_1;

use std::ops::RangeInclusive;

use sonarium_core::stats::Verdict;

use crate::catalog::{Catalog, CatalogError, FieldError};
use crate::wire::{Reproduction, ReproductionRow, ReproductionTarget, Trial};

/// Everything that can be reproduced.
pub static TARGETS: [&Target; 1] = [&TABLE_5_1];

/// A table or figure of the thesis.
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
    /// Experiment that is run.
    pub experiment: &'static str,
    /// Presets that are run, each over all seeds.
    pub presets: &'static [&'static str],
    /// Trials of a set; a set begins with an empty network.
    pub trials: u32,
    /// Seeds, one a set.
    pub seeds: RangeInclusive<u64>,
    /// The rows of one preset, from the last trial of each set.
    rows: fn(&Target, &str, &[Trial]) -> Vec<ReproductionRow>,
}

/// Why a target cannot be computed.
#[derive(Debug, thiserror::Error)]
pub enum ReproductionError {
    /// There is no such target.
    #[error("TARGET: there is no target `{name}`; there are {known}")]
    Unknown {
        /// What was asked for.
        name: String,
        /// What there is.
        known: String,
    },
    /// The embedded files are broken.
    #[error(transparent)]
    Catalog(#[from] CatalogError),
    /// A preset does not fit the world.
    #[error(transparent)]
    Field(#[from] FieldError),
}

/// The target with a name.
///
/// # Errors
/// When there is none; the error names those there are.
pub fn target(name: &str) -> Result<&'static Target, ReproductionError> {
    let found = TARGETS.iter().find(|target| target.name == name);
    found.copied().ok_or_else(|| ReproductionError::Unknown {
        name: name.to_owned(),
        known: TARGETS.map(|target| format!("`{}`", target.name)).join(", "),
    })
}

impl Target {
    /// Sets of trials for each preset.
    #[must_use]
    pub fn sets(&self) -> u32 {
        u32::try_from(self.seeds.clone().count()).unwrap_or(u32::MAX)
    }

    /// The target as a user sees it.
    #[must_use]
    pub fn info(&self) -> ReproductionTarget {
        ReproductionTarget {
            name: self.name.into(),
            title: self.title.into(),
            compares: self.compares.into(),
            source: self.source.into(),
            sets: self.sets(),
            first_seed: *self.seeds.start(),
            last_seed: *self.seeds.end(),
            rule: Verdict::RULE.into(),
        }
    }

    /// Runs every set on `threads` threads, saying `done` after each, and judges the outcome. The result
    /// depends neither on the threads nor on their order, nor on worlds of the user's.
    ///
    /// # Errors
    /// When an embedded preset or world is broken.
    pub fn run(
        &self,
        threads: usize,
        done: &(dyn Fn() + Sync),
    ) -> Result<Reproduction, ReproductionError> {
        let catalog = Catalog::load(None)?;
        let mut rows = Vec::new();
        for preset in self.presets {
            let last = sets::last_trials(&catalog, self, preset, threads, done)?;
            rows.extend((self.rows)(self, preset, &last));
        }
        Ok(Reproduction { target: self.name.into(), rows })
    }
}
