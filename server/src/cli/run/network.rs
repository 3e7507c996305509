//! `--network` and `--save-network`.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value as Json;

use super::super::Failure;
use crate::catalog::Trained;

/// The part of `--save-network` that stands for the seed.
const SEED: &str = "{seed}";

/// Reads a network file. Whether it fits the run is seen when the request is resolved.
pub(super) fn read(path: &Path) -> Result<Json, Failure> {
    let bad = |error: String| Failure::Input(format!("--network {}: {error}", path.display()));
    let text = fs::read_to_string(path).map_err(|error| bad(error.to_string()))?;
    let trained = Trained::read(&text).map_err(|error| bad(error.to_string()))?;
    serde_json::to_value(&trained.file).map_err(|error| bad(error.to_string()))
}

/// Where trained networks are written.
#[derive(Clone, Debug)]
pub(super) struct Target(String);

impl Target {
    /// Checks that several runs get files of their own.
    pub(super) fn new(name: Option<&str>, runs: usize) -> Result<Option<Self>, Failure> {
        let Some(name) = name else { return Ok(None) };
        if runs > 1 && !name.contains(SEED) {
            return Err(Failure::Input(format!(
                "--save-network: `{name}` must hold {SEED}, since there are {runs} runs, e.g. \
                 net-{SEED}.json"
            )));
        }
        Ok(Some(Self(name.to_owned())))
    }

    /// Writes the networks of a run.
    pub(super) fn write(&self, network: &Trained) -> Result<(), Failure> {
        let path = PathBuf::from(self.0.replace(SEED, &network.file.seed.to_string()));
        fs::write(&path, &network.text)
            .map_err(|error| Failure::Failed(format!("--save-network {}: {error}", path.display())))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn several_runs_need_files_of_their_own() {
        for (name, runs, fine) in [
            (None, 5, true),
            (Some("net.json"), 1, true),
            (Some("net.json"), 2, false),
            (Some("net-{seed}.json"), 2, true),
        ] {
            assert_eq!(Target::new(name, runs).is_ok(), fine, "{name:?}, {runs} runs");
        }
    }
}
