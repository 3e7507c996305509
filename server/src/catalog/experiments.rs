//! Experiments, from `assets/experiments`: each is the minimum-cost path with a robot, a world and
//! defaults of its own.

use std::collections::BTreeMap;
use std::sync::Arc;

use rust_embed::Embed;
use serde::Deserialize;
use serde_json::Value as Json;
use sonarium_core::experiment::Settings;
use sonarium_core::robot::Robot;
use sonarium_core::settings::{Kind, Spec, Standing};

use super::plain::{self, PlainExperiment, Tasks};
use super::presets::{self, Preset};
use super::{CatalogError, DEFAULT_TRIALS, FieldError, MAX_TRIALS, Worlds, plan, values};
use crate::wire::{Choice, ExperimentInfo, Family, RobotInfo, SettingInfo, StartView};

#[derive(Embed)]
#[folder = "$CARGO_MANIFEST_DIR/../assets/experiments"]
struct Files;

/// An experiment that can be run.
#[derive(Clone, Debug)]
pub struct Experiment {
    /// Name, the file's.
    pub name: String,
    /// The robot that runs it.
    pub robot: Arc<Robot>,
    /// The world it runs in unless told otherwise.
    pub world: String,
    /// Trials of a session unless told otherwise.
    pub trials: u32,
    /// Its defaults: the program's, and what its file says over them.
    pub defaults: Settings,
    /// Its presets; the first is the default.
    pub presets: Vec<Preset>,
    file: ExperimentFile,
}

/// What an experiment's file says.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct ExperimentFile {
    title: String,
    summary: String,
    source: String,
    robot: String,
    world: String,
    #[serde(default = "default_trials")]
    trials: u32,
    /// Altered starts for the networks trained in the default world.
    #[serde(default)]
    starts: Vec<StartView>,
    /// Settings whose default, standing or source differ from the program's.
    #[serde(default)]
    settings: BTreeMap<String, SettingFile>,
}

/// How a setting of an experiment differs from the program's.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct SettingFile {
    default: Option<toml::Value>,
    standing: Option<String>,
    source: Option<String>,
}

fn default_trials() -> u32 {
    DEFAULT_TRIALS
}

impl Experiment {
    /// The experiment as a user sees it, with the worlds its robot fits into.
    pub(super) fn info(&self, worlds: &Worlds) -> ExperimentInfo {
        ExperimentInfo {
            name: self.name.clone(),
            title: self.file.title.clone(),
            summary: self.file.summary.clone(),
            source: self.file.source.clone(),
            family: Family::Path,
            robot: Some(robot_info(&self.robot)),
            default_trials: self.trials,
            max_trials: MAX_TRIALS,
            presets: self.presets.iter().map(Preset::info).collect(),
            worlds: worlds.infos(&self.world, &self.robot),
            starts: self.file.starts.clone(),
            settings: Settings::specs().iter().map(|spec| self.setting(spec)).collect(),
        }
    }

    /// The altered starts in a world; there are some in the default one only.
    pub(super) fn starts_in(&self, world: &str) -> &[StartView] {
        if world == self.world { &self.file.starts } else { &[] }
    }

    fn setting(&self, spec: &Spec) -> SettingInfo {
        let own = self.file.settings.get(spec.key);
        let or = |own: Option<&String>, program: String| own.cloned().unwrap_or(program);
        let default = values::to_json(self.defaults.get(spec.key).as_ref());
        let program = setting_info(spec, default);
        SettingInfo {
            source: or(own.and_then(|own| own.source.as_ref()), program.source),
            standing: or(own.and_then(|own| own.standing.as_ref()), program.standing),
            ..program
        }
    }

    /// A preset's settings by its name.
    pub(super) fn preset(&self, name: &str) -> Result<&BTreeMap<String, Json>, FieldError> {
        presets::find(&self.presets, name)
    }
}

/// A robot as a user sees it.
pub(super) fn robot_info(robot: &Robot) -> RobotInfo {
    RobotInfo {
        name: robot.name().to_owned(),
        title: robot.title().to_owned(),
        summary: robot.summary().to_owned(),
        source: robot.source().to_owned(),
    }
}

/// A setting as a user sees it.
pub(super) fn setting_info(spec: &Spec, default: Json) -> SettingInfo {
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
        default,
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

fn stem(file: &str) -> &str {
    file.trim_end_matches(".toml")
}

/// The experiments in the program: those with a robot in the order of their names, then the tabular ones.
pub(super) fn embedded(
    robots: &BTreeMap<String, Arc<Robot>>,
    worlds: &Worlds,
    mut presets: BTreeMap<String, Vec<Preset>>,
    tasks: &Tasks,
) -> Result<(Vec<Experiment>, Vec<PlainExperiment>), CatalogError> {
    let mut files: Vec<String> = Files::iter().map(|file| file.into_owned()).collect();
    // By name without the ending, so that a variant of an experiment comes after it.
    files.sort_unstable_by(|a, b| stem(a).cmp(stem(b)));
    let (mut experiments, mut tabular) = (Vec::new(), Vec::new());
    for file in files {
        let broken =
            |message: String| CatalogError { file: format!("experiments/{file}"), message };
        let name = stem(&file);
        let text = Files::get(&file).map(|file| String::from_utf8_lossy(&file.data).into_owned());
        let (text, presets) = (text.unwrap_or_default(), presets.remove(name).unwrap_or_default());
        if plain::NAMES.contains(&name) {
            let read =
                PlainExperiment::read(name, &text, presets, tasks, robots).map_err(broken)?;
            tabular.push(read);
        } else {
            experiments.push(read(name, &text, robots, worlds, presets).map_err(broken)?);
        }
    }
    tabular.sort_by_key(|table| plain::NAMES.iter().position(|name| *name == table.name));
    match presets.into_keys().next() {
        None => Ok((experiments, tabular)),
        Some(name) => Err(CatalogError {
            file: format!("presets/{name}"),
            message: "must be named after an experiment".into(),
        }),
    }
}

/// Reads and checks an experiment: its robot, world, settings and presets exist and fit.
fn read(
    name: &str,
    text: &str,
    robots: &BTreeMap<String, Arc<Robot>>,
    worlds: &Worlds,
    presets: Vec<Preset>,
) -> Result<Experiment, String> {
    let file: ExperimentFile = toml::from_str(text).map_err(|error| error.to_string())?;
    let robot = robots.get(&file.robot).cloned().ok_or_else(|| {
        let names: Vec<&str> = robots.keys().map(String::as_str).collect();
        format!("`robot`: there is no `{}`; there are {}", file.robot, plan::listed(&names))
    })?;
    worlds.fitting(&file.world, &robot).map_err(|error| format!("`world`: {}", error.message))?;
    if presets.is_empty() {
        return Err(format!("there is no preset in presets/{name}"));
    }
    let defaults = defaults(&file.settings)?;
    for preset in &presets {
        let mut settings = defaults.clone();
        for (key, value) in &preset.settings {
            plan::assign(&mut settings, key, value)
                .map_err(|error| format!("preset `{}`: {error}", preset.name))?;
        }
    }
    let (name, world, trials) = (name.to_owned(), file.world.clone(), file.trials);
    Ok(Experiment { name, robot, world, trials, defaults, presets, file })
}

fn defaults(own: &BTreeMap<String, SettingFile>) -> Result<Settings, String> {
    let standings: Vec<&str> = Standing::ALL.iter().map(|standing| standing.name()).collect();
    let mut settings = Settings::default();
    for (key, setting) in own {
        if let Some(standing) = setting.standing.as_deref().filter(|own| !standings.contains(own)) {
            let known = plan::listed(&standings);
            return Err(format!(
                "`settings.{key}.standing` must be one of {known}, not `{standing}`"
            ));
        }
        let value = match &setting.default {
            Some(value) => values::from_toml(value.clone()),
            None => values::to_json(settings.get(key).as_ref()),
        };
        // Also says when there is no such setting.
        plan::assign(&mut settings, key, &value).map_err(|error| error.to_string())?;
    }
    Ok(settings)
}

#[cfg(test)]
mod tests {
    use super::super::{presets, robots};
    use super::*;

    fn read_with(changed: &str) -> Result<Experiment, String> {
        let text = format!(
            "title = \"\"\nsummary = \"\"\nsource = \"\"\nrobot = \"b21\"\nworld = \"laboratory\"\n{changed}"
        );
        let worlds = Worlds::load(None).expect("the embedded ones are fine");
        let robots = robots::embedded().expect("the embedded ones are fine");
        let mut presets = presets::embedded().expect("the embedded ones are fine");
        let presets = presets.remove("minimum-cost-path").expect("there are some");
        read("x", &text, &robots, &worlds, presets)
    }

    #[test]
    fn an_experiment_has_defaults_of_its_own_with_their_standing() {
        let own = "[settings.\"learner.regions\"]\ndefault = \"one\"\nstanding = \"reading\"";
        let experiment = read_with(own).expect("a good experiment");
        let worlds = Worlds::load(None).expect("the embedded ones are fine");
        let info = experiment.info(&worlds);
        let regions = info.settings.iter().find(|setting| setting.key == "learner.regions");
        let regions = regions.expect("a setting");
        assert_eq!((regions.default.as_str(), regions.standing.as_str()), (Some("one"), "reading"));
        assert_eq!(regions.source, "Algorithm 8", "what is not said stays the program's");
    }

    #[test]
    fn a_broken_experiment_is_refused_with_the_place() {
        for (changed, says) in [
            ("robto = 1", "robto"),
            ("[settings.\"learner.regions\"]\ndefault = 7", "settings.learner.regions"),
            ("[settings.\"learner.regoins\"]\ndefault = 7", "did you mean `learner.regions`?"),
            ("[settings.\"learner.regions\"]\nstanding = \"guess\"", "`literal`, `reading`"),
        ] {
            let error = read_with(changed).expect_err(says);
            assert!(error.contains(says), "{error}");
        }
    }
}
