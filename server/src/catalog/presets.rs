//! Named sets of settings, from `assets/presets`: one folder an experiment.

use std::collections::BTreeMap;

use rust_embed::Embed;
use serde::Deserialize;
use serde_json::Value as Json;

use super::plan::listed;
use super::{CatalogError, FieldError, values};
use crate::wire::PresetInfo;

/// The preset a session starts from unless told otherwise.
pub(super) const DEFAULT: &str = "default";

#[derive(Embed)]
#[folder = "$CARGO_MANIFEST_DIR/../assets/presets"]
struct Files;

/// A named set of settings.
#[derive(Clone, Debug)]
pub struct Preset {
    /// Name, the file's.
    pub name: String,
    /// Title for people.
    pub title: String,
    /// What it stands for.
    pub summary: String,
    /// Settings that differ from the defaults.
    pub settings: BTreeMap<String, Json>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PresetFile {
    title: String,
    summary: String,
    #[serde(default)]
    settings: toml::Table,
}

impl Preset {
    pub(super) fn info(&self) -> PresetInfo {
        PresetInfo {
            name: self.name.clone(),
            title: self.title.clone(),
            summary: self.summary.clone(),
            settings: self.settings.clone(),
        }
    }
}

/// A preset's settings by its name.
pub(super) fn find<'a>(
    presets: &'a [Preset],
    name: &str,
) -> Result<&'a BTreeMap<String, Json>, FieldError> {
    let found = presets.iter().find(|preset| preset.name == name);
    found.map(|preset| &preset.settings).ok_or_else(|| {
        let names: Vec<&str> = presets.iter().map(|preset| preset.name.as_str()).collect();
        let message = format!("there is no preset `{name}`; there are {}", listed(&names));
        FieldError::new("settings.preset", message)
    })
}

/// The presets in the program by their experiment, the default first.
pub(super) fn embedded() -> Result<BTreeMap<String, Vec<Preset>>, CatalogError> {
    let mut presets: BTreeMap<String, Vec<Preset>> = BTreeMap::new();
    for file in Files::iter() {
        let (experiment, preset) = read(&file)?;
        presets.entry(experiment).or_default().push(preset);
    }
    for presets in presets.values_mut() {
        presets.sort_by_key(|preset| (preset.name != DEFAULT, preset.name.clone()));
    }
    Ok(presets)
}

fn read(file: &str) -> Result<(String, Preset), CatalogError> {
    let broken = |message: String| CatalogError { file: format!("presets/{file}"), message };
    let (experiment, name) = file
        .split_once('/')
        .ok_or_else(|| broken("must lie in a folder named after its experiment".into()))?;
    let embedded = Files::get(file).ok_or_else(|| broken("is missing".into()))?;
    let text = std::str::from_utf8(&embedded.data).map_err(|error| broken(error.to_string()))?;
    let preset: PresetFile = toml::from_str(text).map_err(|error| broken(error.to_string()))?;
    let preset = Preset {
        name: name.trim_end_matches(".toml").to_owned(),
        title: preset.title,
        summary: preset.summary,
        settings: values::flatten(preset.settings),
    };
    Ok((experiment.to_owned(), preset))
}
