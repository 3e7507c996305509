//! The command line.
//!
//! Results go to stdout, everything else to stderr. Exit codes: 0 success, 1 failed, 2 bad input, with a
//! message that names the field and what would be right.

mod bench;
mod calibrate;
mod experiments;
mod output;
mod reproduce;
mod rules;
mod run;
mod serve;
mod world;

use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Parser, Subcommand};
use sonarium_core::world::WorldError;
use tracing_subscriber::EnvFilter;

use crate::catalog::{CatalogError, FieldError};
use crate::session::{ControlError, LabError, ReportError};
use crate::store::StoreError;

/// A robot-learning laboratory served to the browser
#[derive(Debug, Parser)]
#[command(name = "sonarium", version, args_conflicts_with_subcommands = true)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    serve: serve::Arguments,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Serve the page and the interface (what happens without a command)
    Serve(serve::Arguments),
    /// Run an experiment without a page
    Run(run::Arguments),
    /// Compute a table or figure of the thesis again and hold it against what is printed
    Reproduce(reproduce::Arguments),
    /// Take the deviation ς of a sonar for a level of noise, Eq. (2.8)
    Calibrate(calibrate::Arguments),
    /// List the experiments with their settings
    Experiments(experiments::Arguments),
    /// List, print, check and convert rule bases
    Rules(rules::Arguments),
    /// Trace a world from a map, or check one
    World(world::Arguments),
    /// Measure speed and memory
    Bench(bench::Arguments),
}

/// Why a command did not succeed.
#[derive(Debug, thiserror::Error)]
enum Failure {
    /// What was asked for cannot be done; exit code 2.
    #[error("{0}")]
    Input(String),
    /// It was tried and failed; exit code 1.
    #[error("{0}")]
    Failed(String),
    /// Nobody reads the output any more.
    #[error("the output was closed")]
    Closed,
}

/// Runs the command line of this process.
#[must_use]
pub fn main() -> ExitCode {
    let filter = EnvFilter::try_from_default_env().unwrap_or_else(|_| EnvFilter::new("warn"));
    tracing_subscriber::fmt().with_env_filter(filter).with_writer(std::io::stderr).init();
    let cli = Cli::parse();
    let result = match cli.command {
        None => serve::serve(&cli.serve),
        Some(Command::Serve(arguments)) => serve::serve(&arguments),
        Some(Command::Run(arguments)) => run::run(&arguments),
        Some(Command::Reproduce(arguments)) => reproduce::reproduce(&arguments),
        Some(Command::Calibrate(arguments)) => calibrate::run(&arguments),
        Some(Command::Experiments(arguments)) => experiments::list(&arguments),
        Some(Command::Rules(arguments)) => rules::rules(&arguments),
        Some(Command::World(arguments)) => world::world(&arguments),
        Some(Command::Bench(arguments)) => bench::bench(&arguments),
    };
    match result {
        Ok(()) | Err(Failure::Closed) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("sonarium: {failure}");
            ExitCode::from(if matches!(failure, Failure::Input(_)) { 2 } else { 1 })
        }
    }
}

/// Where sessions are kept unless told otherwise: the user's data folder of this program
/// (`~/.local/share/sonarium` on Linux), or `sonarium-data` here when the system names none.
fn default_data() -> PathBuf {
    let folders = directories::ProjectDirs::from("", "", "sonarium");
    folders.map_or_else(|| "sonarium-data".into(), |folders| folders.data_dir().to_owned())
}

/// Why nothing can be written where `--out` says.
fn refused(path: &Path, error: &std::io::Error) -> Failure {
    let text = format!("--out: {}: {error}", path.display());
    match error.kind() {
        ErrorKind::StorageFull => Failure::Failed(text),
        _ => Failure::Input(text),
    }
}

/// Threads that can work at once.
fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, std::num::NonZero::get)
}

impl From<FieldError> for Failure {
    fn from(error: FieldError) -> Self {
        Self::Input(error.to_string())
    }
}

impl From<WorldError> for Failure {
    fn from(error: WorldError) -> Self {
        Self::Failed(error.to_string())
    }
}

impl From<CatalogError> for Failure {
    fn from(error: CatalogError) -> Self {
        Self::Failed(error.to_string())
    }
}

impl From<StoreError> for Failure {
    fn from(error: StoreError) -> Self {
        match error {
            StoreError::Folder { .. } | StoreError::InUse { .. } | StoreError::Newer { .. } => {
                Self::Input(error.to_string())
            }
            _ => Self::Failed(error.to_string()),
        }
    }
}

impl From<LabError> for Failure {
    fn from(error: LabError) -> Self {
        match error {
            LabError::Field(error) => error.into(),
            LabError::Store(error) => error.into(),
            LabError::Busy(_) => Self::Failed(error.to_string()),
        }
    }
}

impl From<ControlError> for Failure {
    fn from(error: ControlError) -> Self {
        Self::Failed(error.to_string())
    }
}

impl From<ReportError> for Failure {
    fn from(error: ReportError) -> Self {
        Self::Failed(error.to_string())
    }
}

impl From<std::io::Error> for Failure {
    fn from(error: std::io::Error) -> Self {
        match error.kind() {
            ErrorKind::BrokenPipe => Self::Closed,
            _ => Self::Failed(error.to_string()),
        }
    }
}
