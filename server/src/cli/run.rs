//! `sonarium run`.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use clap::Args;
use indicatif::ProgressBar;
use serde::Deserialize;
use serde_json::Value as Json;
use sonarium_core::experiment::{PEOPLE_FILE, RULES_FILE};

use super::{Failure, cores, default_data, output, world};
use crate::batch;
use crate::catalog::{Catalog, FieldError, Plan, Trained, flatten, from_text, starts_from_text};
use crate::session::{Run, check_starts};
use crate::wire::{Family, NewSession, RunResult};

mod drive;
mod network;
mod recorded;
mod table;

/// Most seeds in one call.
const MOST_SEEDS: u64 = 100_000;

#[derive(Args, Debug)]
pub(super) struct Arguments {
    /// Name of the experiment; `sonarium experiments` lists them
    experiment: String,
    /// Seed, 0 to 2^53-1; drawn by chance when missing
    #[arg(long, conflicts_with = "seeds")]
    seed: Option<u64>,
    /// Several seeds, both ends included: 1..20 is twenty runs, printed in this order
    #[arg(long, value_name = "A..B")]
    seeds: Option<Seeds>,
    /// A setting, e.g. --set sonar.noise=0.05 or --set preset=thesis; may be given again
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<Setting>,
    /// TOML file with `seed`, `trials` and a table `settings`; what is given here comes first
    #[arg(long, value_name = "FILE")]
    config: Option<PathBuf>,
    /// Trials, 1 to 100000; those of each episode in a tabular experiment, runs of each
    /// method in one of chapter 2
    #[arg(long)]
    trials: Option<u32>,
    /// World of this run: a TOML file, or the YAML file of a ROS map; a maze or a process for `gridworld`;
    /// `--set world=NAME` takes one by name
    #[arg(long, value_name = "FILE")]
    world: Option<PathBuf>,
    #[command(flatten)]
    placing: world::Placing,
    /// People of one's own in `corridor`: a TOML file, a table [[people]] each
    #[arg(long, value_name = "FILE")]
    people: Option<PathBuf>,
    /// Rules of one's own in `block-world` and `corridor`: a rule file or FLL
    #[arg(long, value_name = "FILE")]
    rules: Option<PathBuf>,
    /// Pose to start the trained networks from afterwards, x and y in metres and heading in degrees, e.g.
    /// --start 1,0.5,90; may be given again. When missing, those of the experiment, if it has any
    #[arg(long, value_name = "X,Y,DEG", allow_hyphen_values = true)]
    start: Vec<String>,
    /// File of trained networks to begin with instead of empty ones
    #[arg(long, value_name = "FILE")]
    network: Option<PathBuf>,
    /// File to write the trained networks to; with several seeds its name must hold {seed}
    #[arg(long, value_name = "FILE")]
    save_network: Option<String>,
    /// Folder for logs and reports; `sonarium serve --data DIR` shows them
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print one JSON object a run
    #[arg(long)]
    json: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let own_worlds = arguments.out.clone().unwrap_or_else(default_data).join("worlds");
    let mut catalog = Catalog::load(Some(&own_worlds))?;
    let mut requests = requests(arguments)?;
    let family = catalog.experiment(&arguments.experiment).map(|experiment| experiment.family);
    match family {
        Some(Family::Table) => return table::run(arguments, catalog, requests),
        Some(Family::Drive) => return drive::run(arguments, catalog, &requests),
        Some(Family::Path) | None => {}
    }
    match &arguments.world {
        Some(file) => give_world(&mut catalog, &mut requests, file, &arguments.placing)?,
        None => arguments.placing.refuse_without_world()?,
    }
    let mut plans: Vec<Plan> = requests
        .iter()
        .map(|request| catalog.resolve(request))
        .collect::<Result<_, FieldError>>()?;
    if !arguments.start.is_empty() {
        let starts = starts_from_text(&arguments.start.join(";"))?;
        plans.iter_mut().for_each(|plan| plan.starts.clone_from(&starts));
    }
    // The same settings and starts fit or do not fit for every seed.
    if let Some(plan) = plans.first() {
        Run::new(plan)?;
        check_starts(plan, &plan.starts)?;
    }
    let save = network::Target::new(arguments.save_network.as_deref(), plans.len())?;
    let trials = plans.iter().map(|plan| u64::from(plan.trials)).sum();
    let progress = output::progress(trials, "trials");
    let take = |result: RunResult, network: &Trained| {
        save.as_ref().map_or(Ok(()), |save| save.write(network))?;
        progress.suspend(|| print(&result, arguments.json))
    };
    match &arguments.out {
        Some(folder) => recorded::run(catalog, &requests, &plans, folder, &progress, take)?,
        None => run_all(&plans, &progress, take)?,
    }
    progress.finish_and_clear();
    Ok(())
}

/// Takes the world of a file for these runs, whatever else has its name.
fn give_world(
    catalog: &mut Catalog,
    requests: &mut [NewSession],
    file: &Path,
    placing: &world::Placing,
) -> Result<(), Failure> {
    let world = world::read(file, placing)?.checked(file)?;
    for request in requests {
        let chosen = request.settings.insert("world".to_owned(), world.name.clone().into());
        if chosen.is_some() {
            return Err(Failure::Input("give either --world or --set world=NAME".to_owned()));
        }
    }
    catalog.give_world(world);
    Ok(())
}

fn print(result: &RunResult, json: bool) -> Result<(), Failure> {
    if json { output::json(result) } else { output::line(&output::table(result)) }
}

/// Runs the plans on all cores and hands over the results in the order of the plans.
fn run_all(
    plans: &[Plan],
    progress: &ProgressBar,
    mut take: impl FnMut(RunResult, &Trained) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let work = |plan: &Plan| batch::trained_set(plan, || progress.inc(1));
    batch::in_order(plans, cores(), work, |done| {
        let (result, network) = done?;
        take(result, &network)
    })
}

/// What a configuration file says.
#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct Config {
    seed: Option<u64>,
    trials: Option<u32>,
    #[serde(default)]
    settings: toml::Table,
}

/// One request a seed.
fn requests(arguments: &Arguments) -> Result<Vec<NewSession>, Failure> {
    let config = arguments.config.as_ref().map(read_config).transpose()?.unwrap_or_default();
    let mut settings = flatten(config.settings);
    settings.extend(arguments.set.iter().map(|set| (set.key.clone(), set.value.clone())));
    if let Some(file) = &arguments.people {
        take_file(&mut settings, PEOPLE_FILE, "people", file)?;
    }
    if let Some(file) = &arguments.rules {
        take_file(&mut settings, RULES_FILE, "rules", file)?;
    }
    let network = arguments.network.as_deref().map(network::read).transpose()?;
    let request = |seed| NewSession {
        experiment: arguments.experiment.clone(),
        seed,
        settings: settings.clone(),
        trials: arguments.trials.or(config.trials),
        speed: None,
        network: network.clone(),
    };
    Ok(match arguments.seeds {
        Some(Seeds { first, last }) => (first..=last).map(|seed| request(Some(seed))).collect(),
        None => vec![request(arguments.seed.or(config.seed))],
    })
}

/// Takes the text of a file as a setting.
fn take_file(
    settings: &mut BTreeMap<String, Json>,
    key: &str,
    flag: &str,
    path: &Path,
) -> Result<(), Failure> {
    let text = fs::read_to_string(path)
        .map_err(|error| Failure::Input(format!("--{flag} {}: {error}", path.display())))?;
    if text.trim().is_empty() {
        return Err(Failure::Input(format!("--{flag} {}: the file is empty", path.display())));
    }
    match settings.insert(key.to_owned(), text.into()) {
        None => Ok(()),
        Some(_) => Err(Failure::Input(format!("give either --{flag} or --set {key}=TEXT"))),
    }
}

fn read_config(path: &PathBuf) -> Result<Config, Failure> {
    let bad = |error: String| Failure::Input(format!("--config {}: {error}", path.display()));
    let text = fs::read_to_string(path).map_err(|error| bad(error.to_string()))?;
    toml::from_str(&text).map_err(|error| bad(error.to_string()))
}

/// `key=value`.
#[derive(Clone, Debug)]
struct Setting {
    key: String,
    value: Json,
}

impl FromStr for Setting {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (key, value) = text
            .split_once('=')
            .ok_or_else(|| format!("`{text}` must be KEY=VALUE, e.g. sonar.noise=0.05"))?;
        Ok(Self { key: key.trim().to_owned(), value: from_text(value.trim()) })
    }
}

/// `A..B`, both included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Seeds {
    first: u64,
    last: u64,
}

impl FromStr for Seeds {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let ends = text.split_once("..").and_then(|(first, last)| {
            Some(Self { first: first.trim().parse().ok()?, last: last.trim().parse().ok()? })
        });
        match ends {
            Some(Self { first, last }) if first > last => {
                Err(format!("{first} is greater than {last}; give the smaller seed first"))
            }
            Some(Self { first, last }) if last - first >= MOST_SEEDS => {
                Err(format!("at most {MOST_SEEDS} seeds at once"))
            }
            Some(seeds) => Ok(seeds),
            None => Err(format!("`{text}` must be two whole numbers, e.g. 1..20")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seed_ranges_include_both_ends() {
        for (text, expected) in [
            ("1..20", Some((1, 20))),
            ("7..7", Some((7, 7))),
            ("20..1", None),
            ("1..", None),
            ("-1..2", None),
            ("1..=3", None),
            ("0..100000", None),
        ] {
            let seeds = text.parse::<Seeds>().ok();
            assert_eq!(seeds, expected.map(|(first, last)| Seeds { first, last }), "{text}");
        }
    }
}
