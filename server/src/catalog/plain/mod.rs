//! Plain experiments: those that are wholly given by their settings. The tabular ones, learners that compete
//! in a world of states, strategies at levers and the plots of figure 3.3; and those of chapter 2, a robot
//! driven by rules.

mod settings;
mod tasks;

use std::collections::BTreeMap;
use std::sync::Arc;

use rust_embed::Embed;
use serde::Deserialize;
use serde_json::Value as Json;
use sonarium_core::fuzzy::RuleBase;
use sonarium_core::robot::Robot;
use sonarium_core::settings::{SettingError, Standing};

pub use settings::{PlainSettings, Texts};
pub use tasks::NamedTask;
pub(super) use tasks::Tasks;

use super::presets::{self, Preset};
use super::{Catalog, FieldError, MAX_TRIALS, experiments, plan, values};
use crate::store::SessionRow;
use crate::wire::{ExperimentInfo, Family, NewSession, SettingInfo, Speed};

/// Names of all plain experiments, in the order they are shown.
pub(super) const NAMES: [&str; 8] = [
    "wall-approach",
    "block-world",
    "corridor",
    "labyrinth",
    "continual",
    "gridworld",
    "bandit",
    "horizon",
];

/// A plain experiment that can be run.
#[derive(Clone, Debug)]
pub(super) struct PlainExperiment {
    pub(super) name: String,
    equipment: Option<Equipment>,
    defaults: PlainSettings,
    presets: Vec<Preset>,
    file: PlainFile,
}

/// What its file says.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct PlainFile {
    title: String,
    summary: String,
    source: String,
    /// World unless told otherwise, where there is a choice.
    #[serde(default)]
    world: Option<String>,
    /// The robot that is driven, in chapter 2.
    #[serde(default)]
    robot: Option<String>,
}

/// What drives, and by what, in chapter 2.
#[derive(Clone, Debug)]
pub struct Equipment {
    /// The robot.
    pub robot: Arc<Robot>,
    /// The rules.
    pub rules: Arc<RuleBase>,
}

/// Everything a plain run needs, checked.
#[derive(Clone, Debug)]
pub struct PlainPlan {
    /// Name of the experiment.
    pub experiment: String,
    /// Title for people.
    pub title: String,
    /// Preset the settings started from.
    pub preset: String,
    /// Its world, where there is a choice.
    pub task: Option<NamedTask>,
    /// The robot and the rules of chapter 2.
    pub equipment: Option<Equipment>,
    /// The settings.
    pub settings: PlainSettings,
    /// Advice, matrix and table.
    pub texts: Texts,
    /// Every setting by key.
    pub values: BTreeMap<String, Json>,
    /// Keys whose value is not the default's.
    pub changed: Vec<String>,
    /// Seed.
    pub seed: u64,
    /// Trials of an episode; in chapter 2, runs of each method.
    pub trials: u32,
    /// Pace.
    pub speed: Speed,
}

impl PlainPlan {
    /// Name of the world: that of the experiment where there is no choice.
    #[must_use]
    pub fn world_name(&self) -> &str {
        self.task.as_ref().map_or(&self.experiment, |task| &task.name)
    }
}

impl PlainExperiment {
    /// Reads and checks the file of a plain experiment and its presets.
    pub(super) fn read(
        name: &str,
        text: &str,
        presets: Vec<Preset>,
        tasks: &Tasks,
        robots: &BTreeMap<String, Arc<Robot>>,
    ) -> Result<Self, String> {
        let file: PlainFile = toml::from_str(text).map_err(|error| error.to_string())?;
        let defaults = PlainSettings::of(name).ok_or_else(|| {
            let known = plan::listed(&NAMES);
            format!("an experiment of its own settings must be one of {known}")
        })?;
        if presets.is_empty() {
            return Err(format!("there is no preset in presets/{name}"));
        }
        if let Some(world) = &file.world {
            tasks.get(world).map_err(|error| format!("`world`: {}", error.message))?;
        }
        for preset in &presets {
            let mut settings = defaults.clone();
            for (key, value) in &preset.settings {
                assign(&mut settings, &mut Texts::default(), key, value)
                    .map_err(|error| format!("preset `{}`: {error}", preset.name))?;
            }
        }
        let equipment = file.robot.as_deref().map(|robot| equipment(robot, robots)).transpose()?;
        if equipment.is_none() && defaults.family() == Family::Drive {
            return Err("`robot` must name the robot that is driven".into());
        }
        Ok(Self { name: name.to_owned(), equipment, defaults, presets, file })
    }

    /// The experiment as a user sees it.
    pub(super) fn info(&self, tasks: &Tasks) -> ExperimentInfo {
        let numbers = self.defaults.specs().iter().map(|spec| {
            let default = values::to_json(self.defaults.get(spec.key).as_ref());
            experiments::setting_info(spec, default)
        });
        let texts = self.defaults.texts().iter().map(|text| SettingInfo {
            key: text.key.into(),
            meaning: text.meaning.into(),
            kind: "text".into(),
            unit: String::new(),
            default: Json::from(""),
            min: None,
            max: None,
            choices: Vec::new(),
            source: text.source.into(),
            standing: Standing::Addition.name().into(),
        });
        ExperimentInfo {
            name: self.name.clone(),
            title: self.file.title.clone(),
            summary: self.file.summary.clone(),
            source: self.file.source.clone(),
            family: self.defaults.family(),
            robot: self.equipment.as_ref().map(|of| experiments::robot_info(&of.robot)),
            default_trials: self.defaults.trials(),
            max_trials: MAX_TRIALS,
            presets: self.presets.iter().map(Preset::info).collect(),
            worlds: self.file.world.as_deref().map(|world| tasks.infos(world)).unwrap_or_default(),
            starts: Vec::new(),
            settings: numbers.chain(texts).collect(),
        }
    }

    /// The rules that drive its robot, if any do.
    pub(super) fn rules(&self) -> Option<Arc<RuleBase>> {
        self.equipment.as_ref().map(|equipment| Arc::clone(&equipment.rules))
    }

    /// The robot that drives, if one does.
    pub(super) fn robot(&self) -> Option<&Robot> {
        self.equipment.as_ref().map(|equipment| equipment.robot.as_ref())
    }

    fn preset(&self, name: &str) -> Result<&BTreeMap<String, Json>, FieldError> {
        presets::find(&self.presets, name)
    }

    fn resolve(
        &self,
        task: Option<NamedTask>,
        request: &NewSession,
    ) -> Result<PlainPlan, FieldError> {
        let preset = plan::name_in(&request.settings, "preset")?.unwrap_or(presets::DEFAULT);
        let (mut settings, mut texts) = (self.defaults.clone(), Texts::default());
        for (key, value) in self.preset(preset)?.iter().chain(&request.settings) {
            if !matches!(key.as_str(), "preset" | "world") {
                assign(&mut settings, &mut texts, key, value)?;
            }
        }
        let trials = match (request.trials, self.defaults.family()) {
            (Some(runs), Family::Drive) => plan::trials(runs)?,
            (Some(trials), _) => self.set_trials(&mut settings, trials)?,
            (None, _) => settings.trials(),
        };
        if request.network.is_some() {
            let message = format!("`{}` has no networks to begin with", self.name);
            return Err(FieldError::new("network", message));
        }
        let (mut values, mut changed) = self.differences(&settings, &texts);
        values.insert("preset".into(), preset.into());
        if preset != presets::DEFAULT {
            changed.insert(0, "preset".into());
        }
        if let Some(task) = &task {
            values.insert("world".into(), task.name.clone().into());
            if self.file.world.as_ref() != Some(&task.name) {
                changed.insert(0, "world".into());
            }
        }
        Ok(PlainPlan {
            experiment: self.name.clone(),
            title: self.file.title.clone(),
            preset: preset.to_owned(),
            task,
            trials,
            equipment: self.equipment.clone(),
            settings,
            texts,
            values,
            changed,
            seed: plan::seed(request.seed)?,
            speed: plan::speed(request.speed.unwrap_or(plan::DEFAULT_SPEED))?,
        })
    }

    fn set_trials(&self, settings: &mut PlainSettings, trials: u32) -> Result<u32, FieldError> {
        let Some(key) = settings.trials_key() else {
            let message = format!("`{}` has no trials; leave it out, or give 1", self.name);
            return if trials == 1 { Ok(1) } else { Err(FieldError::new("trials", message)) };
        };
        let set = settings.set(key, &sonarium_core::settings::Value::Integer(trials.into()));
        set.map_err(|error| FieldError::new("trials", error.to_string()))?;
        Ok(trials)
    }

    fn differences(
        &self,
        settings: &PlainSettings,
        texts: &Texts,
    ) -> (BTreeMap<String, Json>, Vec<String>) {
        let (mut values, mut changed) = (BTreeMap::new(), Vec::new());
        for spec in settings.specs() {
            let value = settings.get(spec.key);
            values.insert(spec.key.to_owned(), values::to_json(value.as_ref()));
            if value != self.defaults.get(spec.key) {
                changed.push(spec.key.to_owned());
            }
        }
        for text in settings.texts() {
            values.insert(text.key.to_owned(), texts.get(text.key).into());
            if !texts.get(text.key).is_empty() {
                changed.push(text.key.to_owned());
            }
        }
        (values, changed)
    }
}

#[derive(Embed)]
#[folder = "$CARGO_MANIFEST_DIR/../assets/rules"]
struct Rules;

/// The rule base in the program that drives the robot of chapter 2.
const NAVIGATOR: &str = "navigator.rules";

fn equipment(robot: &str, robots: &BTreeMap<String, Arc<Robot>>) -> Result<Equipment, String> {
    let found = robots.get(robot).cloned().ok_or_else(|| {
        let names: Vec<&str> = robots.keys().map(String::as_str).collect();
        format!("`robot`: there is no `{robot}`; there are {}", plan::listed(&names))
    })?;
    let file = Rules::get(NAVIGATOR).ok_or_else(|| format!("rules/{NAVIGATOR} is missing"))?;
    let rules = RuleBase::parse(&String::from_utf8_lossy(&file.data))
        .map_err(|error| format!("rules/{NAVIGATOR}: {error}"))?;
    Ok(Equipment { robot: found, rules: Arc::new(rules) })
}

fn assign(
    settings: &mut PlainSettings,
    texts: &mut Texts,
    key: &str,
    json: &Json,
) -> Result<(), FieldError> {
    if let Some(text) = settings.texts().iter().find(|text| text.key == key) {
        return texts.set(text.key, json);
    }
    let field = || format!("settings.{key}");
    let Some(value) = values::from_json(json) else {
        let spec = settings.specs().iter().find(|spec| spec.key == key);
        let expected = spec.map_or("a number, a switch or a name".into(), |spec| spec.expected());
        return Err(FieldError::new(field(), format!("must be {expected}, not `{json}`")));
    };
    settings.set(key, &value).map_err(|error| match error {
        SettingError::Unknown { .. } => {
            FieldError::new(field(), format!("{error}; `sonarium experiments` lists them all"))
        }
        SettingError::Invalid { .. } => FieldError::new(field(), error.to_string()),
    })
}

impl Catalog {
    /// Fills the request of a plain experiment up; none when it is of another kind.
    pub(super) fn resolve_plain(
        &self,
        request: &NewSession,
    ) -> Option<Result<PlainPlan, FieldError>> {
        let experiment = self.plain.iter().find(|table| table.name == request.experiment)?;
        let task = || {
            let asked = plan::name_in(&request.settings, "world")?;
            match (&experiment.file.world, asked) {
                (Some(default), asked) => self.tasks.get(asked.unwrap_or(default)).map(Some),
                (None, None) => Ok(None),
                (None, Some(_)) => {
                    let message =
                        format!("`{}` has a world of its own; leave it out", experiment.name);
                    Err(FieldError::new("settings.world", message))
                }
            }
        };
        Some(task().and_then(|task| experiment.resolve(task, request)))
    }

    /// The plan of a stored session of a plain experiment, in the world as it was.
    pub(super) fn restore_plain(&self, row: &SessionRow) -> Option<Result<PlainPlan, FieldError>> {
        let experiment = self.plain.iter().find(|table| table.name == row.experiment)?;
        let stored = !row.world_text.is_empty();
        let task = stored.then(|| NamedTask::read(&row.world_text)).transpose();
        let request = NewSession {
            experiment: row.experiment.clone(),
            seed: Some(row.seed),
            settings: row.settings.clone(),
            // Trials of an episode are among the settings; runs are not.
            trials: (row.family == Family::Drive).then_some(row.trials_each),
            speed: Some(row.speed),
            network: None,
        };
        Some(task.and_then(|task| experiment.resolve(task, &request)))
    }
}
