//! From a request to everything a run needs, or to a refusal that names the field.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde_json::Value as Json;
use sonarium_core::experiment::Settings;
use sonarium_core::robot::Robot;
use sonarium_core::settings::{SettingError, Spec};

use super::worlds::NamedWorld;
use super::{
    Catalog, Experiment, MAX_TRIALS, PlainPlan, Trained, network, presets, values, worlds,
};
use crate::clock;
use crate::session::Names;
use crate::store::SessionRow;
use crate::wire::{NewSession, Speed, StartView};

/// Key under which the values of a run say which networks it began with.
const NETWORK: &str = "network";
/// Greatest seed: every whole number up to it survives JSON in every language.
const MAX_SEED: u64 = (1 << 53) - 1;
/// Slowest and fastest pace in ticks a second.
const SPEEDS: std::ops::RangeInclusive<f64> = 0.1..=10_000.0;
/// Pace unless told otherwise.
pub(super) const DEFAULT_SPEED: Speed = Speed::TicksPerSecond(30.0);

/// Everything a run needs, checked.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Name of the experiment.
    pub experiment: String,
    /// Preset the settings started from.
    pub preset: String,
    /// The robot.
    pub robot: Arc<Robot>,
    /// The world.
    pub world: NamedWorld,
    /// The settings.
    pub settings: Settings,
    /// Every setting by key, `preset` and `world` included.
    pub values: BTreeMap<String, Json>,
    /// Keys whose value is not the default's.
    pub changed: Vec<String>,
    /// Trained networks it begins with instead of empty ones.
    pub network: Option<Arc<Trained>>,
    /// Altered starts to try the trained networks from.
    pub starts: Vec<StartView>,
    /// Seed.
    pub seed: u64,
    /// Trials.
    pub trials: u32,
    /// Pace.
    pub speed: Speed,
}

/// What a session runs.
#[derive(Clone, Debug)]
pub enum Job {
    /// A robot that learns a path.
    Path(Box<Plan>),
    /// An experiment that is wholly given by its settings.
    Plain(Box<PlainPlan>),
}

impl Job {
    /// Keys whose value is not the default's.
    #[must_use]
    pub fn changed(&self) -> &[String] {
        match self {
            Self::Path(plan) => &plan.changed,
            Self::Plain(plan) => &plan.changed,
        }
    }

    /// Pace.
    #[must_use]
    pub fn speed(&self) -> Speed {
        match self {
            Self::Path(plan) => plan.speed,
            Self::Plain(plan) => plan.speed,
        }
    }

    /// Seed.
    #[must_use]
    pub fn seed(&self) -> u64 {
        match self {
            Self::Path(plan) => plan.seed,
            Self::Plain(plan) => plan.seed,
        }
    }
}

/// A field that cannot be taken.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{field}: {message}")]
pub struct FieldError {
    /// The field, e.g. `settings.sonar.noise`.
    pub field: String,
    /// What is wrong and what would be right.
    pub message: String,
}

impl FieldError {
    /// A field and what is wrong with it.
    pub fn new(field: impl Into<String>, message: impl Into<String>) -> Self {
        Self { field: field.into(), message: message.into() }
    }
}

impl Catalog {
    /// Fills a request of any experiment up.
    ///
    /// # Errors
    /// The first field that is unknown, of the wrong type or out of range.
    pub fn job(&self, request: &NewSession) -> Result<Job, FieldError> {
        match self.resolve_plain(request) {
            Some(plan) => Ok(Job::Plain(Box::new(plan?))),
            None => Ok(Job::Path(Box::new(self.resolve(request)?))),
        }
    }

    /// What a stored session runs, in the world as it was when the session was created and with the
    /// networks it began with.
    ///
    /// # Errors
    /// When this program no longer knows its experiment, its world or one of its settings.
    pub fn restore(&self, row: &SessionRow, network: Option<&str>) -> Result<Job, FieldError> {
        match self.restore_plain(row) {
            Some(plan) => Ok(Job::Plain(Box::new(plan?))),
            None => Ok(Job::Path(Box::new(self.restore_path(row, network)?))),
        }
    }

    /// The same to read what a session did: settings that this program does not have, or takes no more at their
    /// values, are left at their defaults. To run it, [`Self::restore`] is right.
    ///
    /// # Errors
    /// When this program no longer knows its experiment or its world.
    pub fn restore_to_read(
        &self,
        row: &SessionRow,
        network: Option<&str>,
    ) -> Result<Job, FieldError> {
        let mut row = row.clone();
        loop {
            let error = match self.restore(&row, network) {
                Ok(job) => return Ok(job),
                Err(error) => error,
            };
            let known = error.field.strip_prefix("settings.");
            if known.and_then(|key| row.settings.remove(key)).is_none() {
                return Err(error);
            }
        }
    }

    /// Fills a request for a robot's experiment up: defaults, then the preset, then what was given.
    ///
    /// # Errors
    /// The first field that is unknown, of the wrong type or out of range.
    pub fn resolve(&self, request: &NewSession) -> Result<Plan, FieldError> {
        let experiment = self.find(&request.experiment)?;
        let name = name_in(&request.settings, "world")?.unwrap_or(&experiment.world);
        let world = self.worlds().fitting(name, &experiment.robot)?;
        if request.settings.contains_key(NETWORK) {
            let message = "is no setting; give the networks as `network` (--network FILE)";
            return Err(FieldError::new("settings.network", message));
        }
        resolve_in(experiment, world, network::asked(request)?, request)
    }

    fn restore_path(&self, row: &SessionRow, network: Option<&str>) -> Result<Plan, FieldError> {
        let experiment = self.find(&row.experiment)?;
        let world = self.worlds().stored(&row.world, &row.world_text, &experiment.robot)?;
        if network.is_none() && row.settings.contains_key(NETWORK) {
            let message = "the networks that the session began with are missing from its folder";
            return Err(FieldError::new("network", message));
        }
        let network = network.map(Trained::read).transpose()?.map(Arc::new);
        resolve_in(
            experiment,
            world,
            network,
            &NewSession {
                experiment: row.experiment.clone(),
                seed: Some(row.seed),
                settings: row.settings.clone(),
                trials: Some(row.trials_each),
                speed: Some(row.speed),
                network: None,
            },
        )
    }

    fn find(&self, name: &str) -> Result<&Experiment, FieldError> {
        let found = self.experiments.iter().find(|experiment| experiment.name == name);
        found.ok_or_else(|| {
            let paths = self.experiments.iter().map(|experiment| experiment.name.as_str());
            let tables = self.plain.iter().map(|table| table.name.as_str());
            let names: Vec<&str> = paths.chain(tables).collect();
            let message = format!("there is no experiment `{name}`; there are {}", listed(&names));
            FieldError::new("experiment", message)
        })
    }
}

fn resolve_in(
    experiment: &Experiment,
    world: NamedWorld,
    network: Option<Arc<Trained>>,
    request: &NewSession,
) -> Result<Plan, FieldError> {
    let preset = name_in(&request.settings, "preset")?.unwrap_or(presets::DEFAULT);
    let mut settings = experiment.defaults.clone();
    for (key, value) in experiment.preset(preset)?.iter().chain(&request.settings) {
        if !matches!(key.as_str(), "preset" | "world" | NETWORK) {
            assign(&mut settings, key, value)?;
        }
    }
    let (mut values, mut changed) = differences(&settings, &experiment.defaults);
    for (key, name, default) in [
        ("world", world.name.as_str(), experiment.world.as_str()),
        ("preset", preset, presets::DEFAULT),
    ] {
        values.insert(key.into(), name.into());
        if name != default {
            changed.insert(0, key.into());
        }
    }
    if let Some(network) = &network {
        values.insert(NETWORK.into(), network.label().into());
        changed.insert(0, NETWORK.into());
    }
    let plan = Plan {
        experiment: experiment.name.clone(),
        preset: preset.to_owned(),
        robot: Arc::clone(&experiment.robot),
        network: network.clone(),
        starts: experiment.starts_in(&world.name).to_vec(),
        world,
        settings,
        values,
        changed,
        seed: seed(request.seed)?,
        trials: trials(request.trials.unwrap_or(experiment.trials))?,
        speed: speed(request.speed.unwrap_or(DEFAULT_SPEED))?,
    };
    network.map_or(Ok(()), |network| network.check(&plan))?;
    Ok(plan)
}

impl Plan {
    /// What turns the run's indices into names.
    #[must_use]
    pub fn names(&self) -> Names {
        let choice = |key: &str| self.values.get(key).and_then(Json::as_str).unwrap_or_default();
        Names {
            regions: worlds::regions(&self.world.world),
            one_network: choice("learner.regions") == "one",
            action_frame: choice("learner.action_frame").to_owned(),
        }
    }
}

/// Checks a pace.
///
/// # Errors
/// When it is out of range.
pub fn speed(speed: Speed) -> Result<Speed, FieldError> {
    match speed {
        Speed::TicksPerSecond(rate_hz) if !SPEEDS.contains(&rate_hz) => {
            let message = format!(
                "{rate_hz} is out of range; ticks a second from {} to {}, or \"max\"",
                SPEEDS.start(),
                SPEEDS.end()
            );
            Err(FieldError::new("speed", message))
        }
        fine => Ok(fine),
    }
}

/// Checks a seed, or draws one.
pub(super) fn seed(seed: Option<u64>) -> Result<u64, FieldError> {
    match seed {
        Some(seed) if seed > MAX_SEED => {
            let message = format!("{seed} is out of range; a whole number from 0 to {MAX_SEED}");
            Err(FieldError::new("seed", message))
        }
        Some(seed) => Ok(seed),
        // Short enough to be read out and typed.
        None => Ok(clock::entropy() % 1_000_000),
    }
}

pub(super) fn trials(trials: u32) -> Result<u32, FieldError> {
    match trials {
        fine @ 1..=MAX_TRIALS => Ok(fine),
        wrong => {
            let message = format!("{wrong} is out of range; a whole number from 1 to {MAX_TRIALS}");
            Err(FieldError::new("trials", message))
        }
    }
}

pub(super) fn name_in<'a>(
    settings: &'a BTreeMap<String, Json>,
    key: &str,
) -> Result<Option<&'a str>, FieldError> {
    match settings.get(key) {
        None => Ok(None),
        Some(Json::String(name)) => Ok(Some(name)),
        Some(other) => {
            Err(FieldError::new(format!("settings.{key}"), format!("must be a name, not {other}")))
        }
    }
}

pub(super) fn assign(settings: &mut Settings, key: &str, json: &Json) -> Result<(), FieldError> {
    let field = || format!("settings.{key}");
    let Some(value) = values::from_json(json) else {
        let expected = spec(key).map_or("a number, a switch or a name".into(), Spec::expected);
        return Err(FieldError::new(field(), format!("must be {expected}, not `{json}`")));
    };
    settings.set(key, &value).map_err(|error| match error {
        SettingError::Unknown { .. } => {
            FieldError::new(field(), format!("{error}; `sonarium experiments` lists them all"))
        }
        SettingError::Invalid { .. } => FieldError::new(field(), error.to_string()),
    })
}

fn spec(key: &str) -> Option<&'static Spec> {
    Settings::specs().iter().find(|spec| spec.key == key)
}

/// All values, and the keys of those that are not the default.
fn differences(settings: &Settings, defaults: &Settings) -> (BTreeMap<String, Json>, Vec<String>) {
    let mut values = BTreeMap::new();
    let mut changed = Vec::new();
    for spec in Settings::specs() {
        let value = settings.get(spec.key);
        values.insert(spec.key.to_owned(), values::to_json(value.as_ref()));
        if value != defaults.get(spec.key) {
            changed.push(spec.key.to_owned());
        }
    }
    (values, changed)
}

pub(super) fn listed(names: &[&str]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}
