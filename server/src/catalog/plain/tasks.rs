//! Mazes and processes for `gridworld`, from `assets/mazes` and `assets/processes`.

use std::sync::Arc;

use rust_embed::Embed;
use serde::Deserialize;
use sonarium_core::tabular::{AnyWorld, FileError, Maze, MazeFile, Table, TableFile};

use super::super::{CatalogError, FieldError, plan::listed};
use crate::wire::WorldInfo;

#[derive(Embed)]
#[folder = "$CARGO_MANIFEST_DIR/../assets/mazes"]
struct Mazes;

#[derive(Embed)]
#[folder = "$CARGO_MANIFEST_DIR/../assets/processes"]
struct Processes;

/// A tabular world with its file.
#[derive(Clone, Debug)]
pub struct NamedTask {
    /// Name.
    pub name: String,
    /// Title for people.
    pub title: String,
    /// What it is.
    pub summary: String,
    /// The file.
    pub text: String,
    /// The world.
    pub world: Arc<AnyWorld>,
}

/// What both kinds of file begin with.
#[derive(Deserialize)]
struct Heading {
    name: String,
    title: String,
    summary: String,
}

impl NamedTask {
    /// Reads and checks a maze or a process.
    ///
    /// # Errors
    /// Names the field, the line of the drawing or the row that is wrong.
    pub fn read(text: &str) -> Result<Self, FieldError> {
        let refuse = |error: toml::de::Error| FieldError::new("world", error.to_string());
        let file: toml::Table = toml::from_str(text).map_err(refuse)?;
        let is_maze = file.contains_key("map");
        let heading: Heading = toml::from_str(text).map_err(refuse)?;
        let unfit = |error: FileError| {
            FieldError::new(format!("world.{}", error.field()), error.to_string())
        };
        let world = if is_maze {
            let file: MazeFile = toml::from_str(text).map_err(refuse)?;
            AnyWorld::Maze(Maze::new(&file).map_err(unfit)?)
        } else {
            let file: TableFile = toml::from_str(text).map_err(refuse)?;
            AnyWorld::Table(Table::new(&file).map_err(unfit)?)
        };
        let Heading { name, title, summary } = heading;
        Ok(Self { name, title, summary, text: text.to_owned(), world: Arc::new(world) })
    }

    fn info(&self) -> WorldInfo {
        WorldInfo {
            name: self.name.clone(),
            title: self.title.clone(),
            summary: self.summary.clone(),
        }
    }
}

/// All mazes and processes.
#[derive(Clone, Debug)]
pub(in crate::catalog) struct Tasks(Vec<NamedTask>);

impl Tasks {
    /// Those in the program, mazes first.
    pub(in crate::catalog) fn embedded() -> Result<Self, CatalogError> {
        let read = |folder: &str, file: &str, data: &[u8]| {
            NamedTask::read(&String::from_utf8_lossy(data)).map_err(|error| CatalogError {
                file: format!("{folder}/{file}"),
                message: error.to_string(),
            })
        };
        let of = |folder: &'static str,
                  names: Vec<String>,
                  get: fn(&str) -> Option<rust_embed::EmbeddedFile>| {
            let mut names = names;
            names.sort_unstable();
            names
                .into_iter()
                .filter_map(move |name| Some((name.clone(), get(&name)?)))
                .map(move |(name, file)| read(folder, &name, &file.data))
                .collect::<Result<Vec<_>, _>>()
        };
        let mut tasks = of("mazes", Mazes::iter().map(Into::into).collect(), Mazes::get)?;
        tasks.extend(of("processes", Processes::iter().map(Into::into).collect(), Processes::get)?);
        Ok(Self(tasks))
    }

    /// Adds one for this run, before all others of its name.
    pub(in crate::catalog) fn give(&mut self, task: NamedTask) {
        self.0.retain(|known| known.name != task.name);
        self.0.push(task);
    }

    pub(super) fn get(&self, name: &str) -> Result<NamedTask, FieldError> {
        let found = self.0.iter().find(|task| task.name == name).cloned();
        found.ok_or_else(|| {
            let names: Vec<&str> = self.0.iter().map(|task| task.name.as_str()).collect();
            let message = format!("there is no world `{name}`; there are {}", listed(&names));
            FieldError::new("settings.world", message)
        })
    }

    /// As a user sees them, the default first.
    pub(super) fn infos(&self, default: &str) -> Vec<WorldInfo> {
        let is_default = |task: &&NamedTask| task.name == default;
        let first = self.0.iter().filter(is_default);
        first.chain(self.0.iter().filter(|task| !is_default(task))).map(NamedTask::info).collect()
    }
}
