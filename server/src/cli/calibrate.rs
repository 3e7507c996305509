//! `sonarium calibrate`.

use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;

use super::{Failure, output, refused};
use crate::calibration::calibrate;
use crate::catalog::Catalog;
use crate::report::{
    calibration_csv, calibration_html, calibration_json, calibration_markdown, calibration_text,
};
use crate::wire::{CalibrationQuestion, CalibrationView};

#[derive(Args, Debug)]
pub(super) struct Arguments {
    /// Times the noise in the robot's file, 0 to 20; there is no crosstalk, as the sonar is alone
    #[arg(long, value_name = "LEVEL", default_value_t = CalibrationQuestion::default().noise)]
    noise: f64,
    /// An ideal sonar: no noise, every ray comes back
    #[arg(long, conflicts_with = "noise")]
    ideal: bool,
    /// Pairs of the true and the measured distance at each of the five places, 2 to 100000
    #[arg(long, value_name = "N", default_value_t = CalibrationQuestion::default().pairs)]
    pairs: u32,
    /// Factor k of Eq. (2.8), 1 to 10
    #[arg(long, value_name = "K", default_value_t = CalibrationQuestion::default().factor)]
    factor: f64,
    /// Seed
    #[arg(long, default_value_t = CalibrationQuestion::default().seed)]
    seed: u64,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
    /// Print a Markdown table
    #[arg(long, conflicts_with = "json")]
    markdown: bool,
    /// Folder for the report as a page, CSV and JSON
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let catalog = Catalog::load(None)?;
    let equipment = catalog.equipment().ok_or_else(|| Failure::Failed("no robot".to_owned()))?;
    let asked = CalibrationQuestion {
        noise: arguments.noise,
        ideal: arguments.ideal,
        pairs: arguments.pairs,
        factor: arguments.factor,
        seed: arguments.seed,
    };
    let view = calibrate(equipment, asked)?;
    if let Some(folder) = &arguments.out {
        write(folder, &view)?;
    }
    if arguments.json {
        output::json(&view)
    } else if arguments.markdown {
        output::line(calibration_markdown(&view).trim_end())
    } else {
        output::line(&calibration_text(&view))
    }
}

fn write(folder: &Path, view: &CalibrationView) -> Result<(), Failure> {
    fs::create_dir_all(folder).map_err(|error| refused(folder, &error))?;
    for (name, text) in [
        ("report.html", calibration_html(view)),
        ("report.csv", calibration_csv(view)),
        ("report.json", calibration_json(view)),
    ] {
        let path = folder.join(name);
        fs::write(&path, text).map_err(|error| refused(&path, &error))?;
    }
    Ok(())
}
