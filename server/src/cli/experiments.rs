//! `sonarium experiments`.

use clap::Args;

use super::{Failure, output};
use crate::catalog::Catalog;
use crate::wire::{ExperimentInfo, SettingInfo};

#[derive(Args, Debug)]
pub(super) struct Arguments {
    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub(super) fn list(arguments: &Arguments) -> Result<(), Failure> {
    let catalog = Catalog::load(Some(&super::default_data().join("worlds")))?;
    if arguments.json {
        return output::json(&catalog.experiments());
    }
    catalog.experiments().iter().try_for_each(|experiment| output::line(&text(experiment)))
}

fn text(experiment: &ExperimentInfo) -> String {
    let mut text = format!("{}  {} ({})\n", experiment.name, experiment.summary, experiment.source);
    text += &format!(
        "  trials: 1 to {}, {} unless told otherwise\n",
        experiment.max_trials, experiment.default_trials
    );
    for preset in &experiment.presets {
        text += &format!("  preset={}  {}\n", preset.name, preset.summary);
    }
    for world in &experiment.worlds {
        text += &format!("  world={}  {}\n", world.name, world.summary);
    }
    text += "  settings, with default, range, unit, standing and source:\n";
    for setting in &experiment.settings {
        text += &setting_text(setting);
    }
    text.trim_end().to_owned()
}

fn setting_text(setting: &SettingInfo) -> String {
    let range = match (setting.min, setting.max) {
        (Some(min), Some(max)) => format!(" [{min} to {max}]"),
        _ if setting.choices.is_empty() => String::new(),
        _ => {
            let choices: Vec<&str> = setting.choices.iter().map(|c| c.value.as_str()).collect();
            format!(" [{}]", choices.join(" | "))
        }
    };
    let unit = match setting.unit.as_str() {
        "" | "1" => String::new(),
        unit => format!(" {unit}"),
    };
    let default =
        setting.default.as_str().map_or_else(|| setting.default.to_string(), str::to_owned);
    format!(
        "    {}={default}{unit}{range}  {} ({}; {})\n",
        setting.key, setting.meaning, setting.standing, setting.source
    )
}
