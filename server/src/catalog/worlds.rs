//! Worlds, from `assets/worlds` and from a folder of the user's.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::Path;
use std::sync::Arc;

use rust_embed::Embed;
use sonarium_core::robot::Robot;
use sonarium_core::world::{World, WorldFile};

use super::{CatalogError, FieldError};
use crate::wire::WorldInfo;

/// The world a session runs in unless told otherwise.
pub const DEFAULT_WORLD: &str = "laboratory";

/// Radius of the B21, metres: every world has room for at least that robot.
const RADIUS_M: f64 = 0.265;

#[derive(Embed)]
#[folder = "$CARGO_MANIFEST_DIR/../assets/worlds"]
struct Files;

/// All worlds by name, the usable and the broken.
#[derive(Debug)]
pub struct Worlds(BTreeMap<String, Entry>);

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

/// A world, or why it cannot be used.
type Entry = Result<NamedWorld, String>;

impl Worlds {
    /// The worlds in the program, and those in `own` over them; a missing folder is an empty one.
    ///
    /// # Errors
    /// When an embedded world is broken.
    pub fn load(own: Option<&Path>) -> Result<Self, CatalogError> {
        let mut worlds = BTreeMap::new();
        for file in Files::iter() {
            let name = file.trim_end_matches(".toml").to_owned();
            let text =
                Files::get(&file).map(|file| String::from_utf8_lossy(&file.data).into_owned());
            let entry = read(&name, text.unwrap_or_default())
                .map_err(|message| CatalogError { file: format!("worlds/{file}"), message })?;
            worlds.insert(name, Ok(entry));
        }
        if let Some(folder) = own {
            worlds.extend(own_worlds(folder));
        }
        Ok(Self(worlds))
    }

    /// A world by name.
    ///
    /// # Errors
    /// When there is none, or it is broken; the field is `settings.world`.
    pub fn get(&self, name: &str) -> Result<&NamedWorld, FieldError> {
        let refuse = |message: String| FieldError::new("settings.world", message);
        match self.0.get(name) {
            Some(Ok(world)) => Ok(world),
            Some(Err(why)) => Err(refuse(format!("the world `{name}` cannot be used: {why}"))),
            None => {
                let names: Vec<String> = self.0.keys().map(|name| format!("`{name}`")).collect();
                let names = names.join(", ");
                Err(refuse(format!("there is no world `{name}`; there are {names}")))
            }
        }
    }

    /// A world by name, checked for a robot.
    ///
    /// # Errors
    /// When there is none, it is broken, or the robot does not fit; the field is `settings.world`.
    pub fn fitting(&self, name: &str, robot: &Robot) -> Result<NamedWorld, FieldError> {
        self.get(name)?.fitting(robot)
    }

    /// The worlds that a robot fits into, the default first.
    #[must_use]
    pub fn infos(&self, default: &str, robot: &Robot) -> Vec<WorldInfo> {
        let usable = self.0.values().flatten();
        let mut infos: Vec<WorldInfo> =
            usable.filter(|world| world.fitting(robot).is_ok()).map(info).collect();
        infos.sort_by_key(|info| info.name != default);
        infos
    }
}

impl NamedWorld {
    /// The same world, checked for a robot.
    ///
    /// # Errors
    /// When the robot does not fit; the field is `settings.world`.
    pub(super) fn fitting(&self, robot: &Robot) -> Result<Self, FieldError> {
        if robot.body().reach_m() <= RADIUS_M {
            return Ok(self.clone());
        }
        read_for(&self.name, self.text.clone(), robot.body().reach_m()).map_err(|why| {
            let title = robot.title();
            let message = format!("the world `{}` does not fit the {title}: {why}", self.name);
            FieldError::new("settings.world", message)
        })
    }
}

/// Reads and checks a world for the least robot there is.
///
/// # Errors
/// What is wrong with it: where, and what would be right.
pub(super) fn read(name: &str, text: String) -> Result<NamedWorld, String> {
    read_for(name, text, RADIUS_M)
}

/// Reads a world and checks it for a robot that needs this radius to turn on the spot.
fn read_for(name: &str, text: String, radius_m: f64) -> Result<NamedWorld, String> {
    let file: WorldFile = toml::from_str(&text).map_err(|error| error.to_string())?;
    if file.name != name {
        return Err(format!(
            "`name` must be \"{name}\", the name of its file, not {:?}",
            file.name
        ));
    }
    let world = World::new(&file, radius_m).map_err(|error| error.to_string())?;
    Ok(NamedWorld { name: name.to_owned(), text, world: Arc::new(world) })
}

/// Names of a world's regions, in their fixed order.
#[must_use]
pub(super) fn regions(world: &World) -> Vec<String> {
    world.regions().iter().map(|region| region.name.clone()).collect()
}

fn info(world: &NamedWorld) -> WorldInfo {
    WorldInfo {
        name: world.name.clone(),
        title: world.world.title().to_owned(),
        summary: world.world.summary().to_owned(),
    }
}

fn own_worlds(folder: &Path) -> Vec<(String, Entry)> {
    let files = match fs::read_dir(folder) {
        Ok(files) => files,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Vec::new(),
        Err(error) => {
            tracing::warn!("cannot read the worlds in {}: {error}", folder.display());
            return Vec::new();
        }
    };
    let paths = files.flatten().map(|file| file.path());
    let worlds = paths.filter(|path| path.extension().is_some_and(|e| e == "toml"));
    worlds.filter_map(|path| own_world(&path)).collect()
}

fn own_world(path: &Path) -> Option<(String, Entry)> {
    let name = path.file_stem()?.to_str()?.to_owned();
    let entry = fs::read_to_string(path)
        .map_err(|error| error.to_string())
        .and_then(|text| read(&name, text));
    if let Err(why) = &entry {
        tracing::warn!("the world {} cannot be used: {why}", path.display());
    }
    Some((name, entry))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_broken_world_of_the_users_is_refused_when_chosen() {
        let folder = tempfile::tempdir().expect("a folder");
        fs::write(folder.path().join("bad.toml"), "name = ").expect("written");
        let worlds = Worlds::load(Some(folder.path())).expect("the embedded ones are fine");
        let robots = super::super::robots::embedded().expect("the embedded ones are fine");
        let infos = worlds.infos(DEFAULT_WORLD, &robots["b21"]);
        assert!(!infos.is_empty() && infos.iter().all(|info| info.name != "bad"));
        let error = worlds.get("bad").expect_err("it is broken");
        assert_eq!(error.field, "settings.world");
        assert!(error.message.starts_with("the world `bad` cannot be used: "), "{error}");
        assert!(worlds.get(DEFAULT_WORLD).is_ok());
    }

    #[test]
    fn an_unknown_world_is_refused_with_the_known_ones() {
        let worlds = Worlds::load(None).expect("the embedded ones are fine");
        let error = worlds.get("moon").expect_err("there is none");
        assert!(error.message.contains("`laboratory`"), "{error}");
    }
}
