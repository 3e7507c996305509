//! Worlds: those that come with the program, and the user's own.

mod check;
mod map_file;
mod own;
#[cfg(test)]
mod tests;
mod text;

pub use check::region_shapes;
pub use map_file::{map_beside, map_file};
pub use text::to_toml;

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use rust_embed::Embed;
use sonarium_core::robot::Robot;
use sonarium_core::world::{World, WorldFile};

use super::{CatalogError, FieldError};
use crate::wire::{MapPicture, WorldInfo, WorldProblem, WorldSummary};
use own::OwnWorlds;

/// The world a session runs in unless told otherwise.
pub const DEFAULT_WORLD: &str = "laboratory";

/// Radius of the B21, metres: every world has room for at least that robot.
const RADIUS_M: f64 = 0.265;

/// Checked worlds that are kept: those of stored sessions and for larger robots, which are asked for
/// again and again.
const MOST_KEPT: usize = 64;

#[derive(Embed)]
#[folder = "$CARGO_MANIFEST_DIR/../assets/worlds"]
struct Files;

/// All worlds by name, the usable and the broken.
#[derive(Debug)]
pub struct Worlds {
    built_in: BTreeMap<String, NamedWorld>,
    own: OwnWorlds,
    /// Worlds given for this run alone; they come before all others.
    given: BTreeMap<String, NamedWorld>,
    /// Worlds checked before, the latest last.
    kept: Mutex<Vec<Kept>>,
}

/// A world checked for a robot of a radius.
#[derive(Debug)]
struct Kept {
    name: String,
    text: String,
    radius_m: f64,
    checked: Result<NamedWorld, String>,
}

/// A world and the text it was read from.
#[derive(Clone, Debug)]
pub struct NamedWorld {
    /// Name, the value of the setting `world`.
    pub name: String,
    /// The file.
    pub text: String,
    /// What it says, checked.
    pub world: Arc<World>,
}

/// A text that no session can run in.
#[derive(Clone, Debug)]
pub struct BrokenWorld {
    /// What the text says, if it can be read.
    pub file: Option<WorldFile>,
    /// What is wrong.
    pub problem: WorldProblem,
}

/// Why a world was not saved, shown or deleted.
#[derive(Debug, thiserror::Error)]
pub enum WorldsError {
    /// There is none.
    #[error("there is no world `{name}`; there are {names}")]
    Missing {
        /// What was asked for.
        name: String,
        /// All names.
        names: String,
    },
    /// It came with the program.
    #[error("`{name}` came with the program and cannot be changed; save yours under another name")]
    BuiltIn {
        /// Its name.
        name: String,
    },
    /// One of the name is there already.
    #[error("there already is a world `{name}`")]
    Exists {
        /// Its name.
        name: String,
    },
    /// The name cannot be that of a file.
    #[error(
        "must be 1 to 64 small letters, digits, `-` and `_` that begin with a letter or digit, not \
         {name:?}"
    )]
    Name {
        /// What was given.
        name: String,
    },
    /// It cannot be used.
    #[error("{}", .0.problem.message)]
    Broken(Box<BrokenWorld>),
    /// The picture of its map cannot be kept or read.
    #[error("{0}")]
    Map(FieldError),
    /// There is no folder to save it in.
    #[error("this server keeps no worlds; start it with a data folder")]
    NoFolder,
    /// The folder refused.
    #[error("{path}: {error}")]
    Folder {
        /// The file.
        path: String,
        /// What the system says.
        error: std::io::Error,
    },
}

impl Worlds {
    /// The worlds in the program, and those in a folder of the user's; a missing folder is an empty one.
    ///
    /// # Errors
    /// When an embedded world is broken.
    pub fn load(own: Option<&Path>) -> Result<Self, CatalogError> {
        let mut built_in = BTreeMap::new();
        for file in Files::iter() {
            let name = file.trim_end_matches(".toml").to_owned();
            let text =
                Files::get(&file).map(|file| String::from_utf8_lossy(&file.data).into_owned());
            let world = read(&name, text.unwrap_or_default()).map_err(|broken| CatalogError {
                file: format!("worlds/{file}"),
                message: broken.problem.message,
            })?;
            built_in.insert(name, world);
        }
        let (given, kept) = (BTreeMap::new(), Mutex::default());
        Ok(Self { built_in, own: OwnWorlds::new(own), given, kept })
    }

    /// Adds a world for this run, before all others of its name.
    pub fn give(&mut self, world: NamedWorld) {
        self.given.insert(world.name.clone(), world);
    }

    /// A world by name, as its file is now.
    ///
    /// # Errors
    /// When there is none, or it is broken; the field is `settings.world`.
    pub fn get(&self, name: &str) -> Result<NamedWorld, FieldError> {
        self.find(name).map_err(|error| {
            let message = match error {
                WorldsError::Broken(broken) => {
                    format!("the world `{name}` cannot be used: {}", broken.problem.message)
                }
                other => other.to_string(),
            };
            FieldError::new("settings.world", message)
        })
    }

    /// A world by name, checked for a robot.
    ///
    /// # Errors
    /// When there is none, it is broken, or the robot does not fit; the field is `settings.world`.
    pub fn fitting(&self, name: &str, robot: &Robot) -> Result<NamedWorld, FieldError> {
        self.for_robot(self.get(name)?, robot)
    }

    /// The world of a stored session, from the text it was stored with, checked for its robot.
    ///
    /// # Errors
    /// When this program cannot read it, or the robot does not fit.
    pub fn stored(&self, name: &str, text: &str, robot: &Robot) -> Result<NamedWorld, FieldError> {
        let built_in = self.built_in.get(name).filter(|world| world.text == text).cloned();
        let world = match built_in {
            Some(world) => world,
            None => self
                .checked(name, text, RADIUS_M)
                .map_err(|why| FieldError::new("settings.world", why))?,
        };
        self.for_robot(world, robot)
    }

    /// The worlds that a robot fits into, the default first.
    #[must_use]
    pub fn infos(&self, default: &str, robot: &Robot) -> Vec<WorldInfo> {
        let usable = self.summaries().into_iter().filter(|world| world.problem.is_none());
        let fitting = usable.filter(|world| self.fitting(&world.name, robot).is_ok());
        let mut infos: Vec<WorldInfo> = fitting
            .map(|WorldSummary { name, title, summary, .. }| WorldInfo { name, title, summary })
            .collect();
        infos.sort_by_key(|info| info.name != default);
        infos
    }

    fn for_robot(&self, world: NamedWorld, robot: &Robot) -> Result<NamedWorld, FieldError> {
        let reach_m = robot.body().reach_m();
        if reach_m <= RADIUS_M {
            return Ok(world);
        }
        self.checked(&world.name, &world.text, reach_m).map_err(|why| {
            let (name, title) = (&world.name, robot.title());
            let message = format!("the world `{name}` does not fit the {title}: {why}");
            FieldError::new("settings.world", message)
        })
    }

    /// A world checked for a robot that needs this radius to turn on the spot.
    fn checked(&self, name: &str, text: &str, radius_m: f64) -> Result<NamedWorld, String> {
        let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        let same = |kept: &&Kept| {
            kept.name == name && kept.text == text && kept.radius_m.total_cmp(&radius_m).is_eq()
        };
        if let Some(found) = kept.iter().find(same) {
            return found.checked.clone();
        }
        let world = read_for(name, text.to_owned(), radius_m);
        let checked = world.map_err(|broken| broken.problem.message);
        if kept.len() == MOST_KEPT {
            kept.remove(0);
        }
        let (name, text) = (name.to_owned(), text.to_owned());
        kept.push(Kept { name, text, radius_m, checked: checked.clone() });
        checked
    }

    /// All worlds, the default first and the user's own last.
    #[must_use]
    pub fn summaries(&self) -> Vec<WorldSummary> {
        let mut summaries: Vec<WorldSummary> =
            self.built_in.values().map(|world| summary(world, true)).collect();
        summaries.sort_by_key(|world| world.name != DEFAULT_WORLD);
        let own = self.own.all().into_iter();
        let own = own.filter(|(name, _)| !self.built_in.contains_key(name));
        summaries.extend(own.map(|(name, world)| match world {
            Ok(world) => summary(&world, false),
            Err(broken) => broken_summary(name, *broken),
        }));
        summaries
    }

    /// The text of a world, usable or not.
    ///
    /// # Errors
    /// When there is none.
    pub fn text(&self, name: &str) -> Result<String, WorldsError> {
        match self.built_in.get(name) {
            Some(world) => Ok(world.text.clone()),
            None => self.own.text(name)?.ok_or_else(|| self.missing(name)),
        }
    }

    /// Whether a name is taken, and by whom: `built_in` or `own`.
    #[must_use]
    pub fn taken(&self, name: &str) -> Option<&'static str> {
        if self.built_in.contains_key(name) {
            return Some("built_in");
        }
        matches!(self.own.text(name), Ok(Some(_))).then_some("own")
    }

    /// Checks a world and saves it; says whether it is new.
    ///
    /// # Errors
    /// When the name is not acceptable or taken by a built-in world, when the world cannot be used, or
    /// when the folder refuses. With `only_new` also when there is one of the name.
    pub fn save(
        &self,
        name: &str,
        text: String,
        only_new: bool,
    ) -> Result<(WorldSummary, bool), WorldsError> {
        if !is_name(name) {
            return Err(WorldsError::Name { name: name.to_owned() });
        }
        let taken = self.taken(name);
        if taken == Some("built_in") {
            return Err(WorldsError::BuiltIn { name: name.to_owned() });
        }
        if taken.is_some() && only_new {
            return Err(WorldsError::Exists { name: name.to_owned() });
        }
        let world = read(name, text).map_err(WorldsError::Broken)?;
        self.own.save(&world)?;
        Ok((summary(&world, false), taken.is_none()))
    }

    /// Deletes a world of the user's. Sessions keep the text that they were created with.
    ///
    /// # Errors
    /// When there is none, or it came with the program.
    pub fn delete(&self, name: &str) -> Result<(), WorldsError> {
        if self.built_in.contains_key(name) {
            return Err(WorldsError::BuiltIn { name: name.to_owned() });
        }
        if self.own.delete(name)? { Ok(()) } else { Err(self.missing(name)) }
    }

    /// The picture of the map that a world was traced from; none when none is kept.
    ///
    /// # Errors
    /// When there is no such world, or its picture cannot be read.
    pub fn map(&self, name: &str) -> Result<Option<MapPicture>, WorldsError> {
        match self.taken(name) {
            Some("own") => self.own.map(name),
            Some(_) => Ok(None),
            None => Err(self.missing(name)),
        }
    }

    /// Keeps the picture of the map that a world of the user's was traced from, beside it.
    ///
    /// # Errors
    /// When there is no such world, it came with the program, or the picture is none that can be kept.
    pub fn keep_map(&self, name: &str, picture: &MapPicture) -> Result<(), WorldsError> {
        self.check_own(name)?;
        let file = map_file(picture).map_err(WorldsError::Map)?;
        self.own.save_map(name, &file)
    }

    /// Deletes the picture of a world's map; that there is none is no error.
    ///
    /// # Errors
    /// When there is no such world, or it came with the program.
    pub fn delete_map(&self, name: &str) -> Result<(), WorldsError> {
        self.check_own(name)?;
        self.own.delete_map(name)
    }

    fn check_own(&self, name: &str) -> Result<(), WorldsError> {
        match self.taken(name) {
            Some("own") => Ok(()),
            Some(_) => Err(WorldsError::BuiltIn { name: name.to_owned() }),
            None => Err(self.missing(name)),
        }
    }

    /// A world as its file is now.
    ///
    /// # Errors
    /// When there is none, or it is broken.
    pub fn find(&self, name: &str) -> Result<NamedWorld, WorldsError> {
        if let Some(world) = self.given.get(name).or_else(|| self.built_in.get(name)) {
            return Ok(world.clone());
        }
        let world = self.own.get(name)?.ok_or_else(|| self.missing(name))?;
        world.map_err(WorldsError::Broken)
    }

    fn missing(&self, name: &str) -> WorldsError {
        let names = self.summaries().into_iter().map(|world| format!("`{}`", world.name));
        let names = names.collect::<Vec<_>>().join(", ");
        WorldsError::Missing { name: name.to_owned(), names }
    }
}

/// Reads a world and checks it for the least robot there is.
///
/// # Errors
/// What is wrong with it: where, and what would be right.
pub fn read(name: &str, text: String) -> Result<NamedWorld, Box<BrokenWorld>> {
    read_for(name, text, RADIUS_M)
}

/// Reads a world and checks it for a robot that needs this radius to turn on the spot.
fn read_for(name: &str, text: String, radius_m: f64) -> Result<NamedWorld, Box<BrokenWorld>> {
    let file = parse(&text).map_err(|problem| BrokenWorld { file: None, problem })?;
    let problem = if file.name == name {
        match World::new(&file, radius_m) {
            Ok(world) => {
                return Ok(NamedWorld { name: name.to_owned(), text, world: Arc::new(world) });
            }
            Err(error) => WorldProblem::from(&error),
        }
    } else {
        let message =
            format!("`name` must be \"{name}\", the name of its file, not {:?}", file.name);
        WorldProblem { field: "name".to_owned(), message, place: None, nearest: None }
    };
    Err(Box::new(BrokenWorld { file: Some(file), problem }))
}

/// Reads the text of a world without checking what it says.
///
/// # Errors
/// What cannot be read, with its line.
pub fn parse(text: &str) -> Result<WorldFile, WorldProblem> {
    toml::from_str(text).map_err(|error| WorldProblem {
        field: "toml".to_owned(),
        message: error.to_string().trim_end().to_owned(),
        place: None,
        nearest: None,
    })
}

/// Radius of the robot that every world has room for, metres.
#[must_use]
pub fn robot_radius_m() -> f64 {
    RADIUS_M
}

/// The name of a world that comes nearest to a text.
#[must_use]
pub fn world_name(text: &str) -> String {
    let allowed = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '-' };
    let name: String = text.chars().map(allowed).take(64).collect();
    let name = name.trim_matches('-');
    if name.is_empty() { "map".to_owned() } else { name.to_owned() }
}

/// Names of a world's regions, in their fixed order.
#[must_use]
pub(super) fn regions(world: &World) -> Vec<String> {
    world.regions().iter().map(|region| region.name.clone()).collect()
}

/// Whether a name can be that of a file everywhere.
fn is_name(name: &str) -> bool {
    let inner = |byte: u8| matches!(byte, b'a'..=b'z' | b'0'..=b'9' | b'-' | b'_');
    (1..=64).contains(&name.len()) && name.bytes().all(inner) && !name.starts_with(['-', '_'])
}

fn summary(world: &NamedWorld, built_in: bool) -> WorldSummary {
    WorldSummary {
        name: world.name.clone(),
        title: world.world.title().to_owned(),
        summary: world.world.summary().to_owned(),
        built_in,
        problem: None,
        bounds_m: Some(world.world.bounds_m()),
        walls: world.world.walls().len() as u32,
        regions: regions(&world.world),
    }
}

fn broken_summary(name: String, broken: BrokenWorld) -> WorldSummary {
    let (title, summary) = match broken.file {
        Some(file) => (file.title, file.summary),
        None => (name.clone(), String::new()),
    };
    WorldSummary {
        name,
        title,
        summary,
        built_in: false,
        problem: Some(broken.problem.message),
        bounds_m: None,
        walls: 0,
        regions: Vec::new(),
    }
}
