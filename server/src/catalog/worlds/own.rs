//! The user's own worlds: one TOML file each in a folder, read again whenever it changed.

use std::collections::BTreeMap;
use std::fs;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::time::SystemTime;

use super::map_file::{LARGEST_FILE, map_beside, read_map};
use super::{BrokenWorld, NamedWorld, WorldsError, read};
use crate::catalog::FieldError;
use crate::wire::MapPicture;

/// A world, or why it cannot be used.
pub(super) type Entry = Result<NamedWorld, Box<BrokenWorld>>;

/// A folder of worlds.
#[derive(Debug)]
pub(super) struct OwnWorlds {
    folder: Option<PathBuf>,
    /// What was read, and the state of the file then.
    read: Mutex<BTreeMap<String, (Stamp, Entry)>>,
}

/// Tells one state of a file from another.
type Stamp = (Option<SystemTime>, u64);

impl OwnWorlds {
    pub(super) fn new(folder: Option<&Path>) -> Self {
        Self { folder: folder.map(Path::to_owned), read: Mutex::default() }
    }

    /// All worlds by name.
    pub(super) fn all(&self) -> Vec<(String, Entry)> {
        let Some(folder) = &self.folder else { return Vec::new() };
        let files = match fs::read_dir(folder) {
            Ok(files) => files,
            Err(error) => {
                if error.kind() != io::ErrorKind::NotFound {
                    tracing::warn!("cannot read the worlds in {}: {error}", folder.display());
                }
                return Vec::new();
            }
        };
        let paths = files.flatten().map(|file| file.path());
        let worlds = paths.filter(|path| path.extension().is_some_and(|e| e == "toml"));
        let mut names: Vec<String> =
            worlds.filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned())).collect();
        names.sort();
        let entry = |name: String| Some((name.clone(), self.get(&name).ok()??));
        names.into_iter().filter_map(entry).collect()
    }

    /// A world as its file is now; none when there is no such file.
    pub(super) fn get(&self, name: &str) -> Result<Option<Entry>, WorldsError> {
        let Some(path) = self.path(name) else { return Ok(None) };
        let Some(stamp) = stamp(&path) else { return Ok(None) };
        let mut known = self.read.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, entry)) = known.get(name).filter(|(then, _)| *then == stamp) {
            return Ok(Some(entry.clone()));
        }
        let text = fs::read_to_string(&path).map_err(|error| refused(&path, error))?;
        let entry = read(name, text);
        if let Err(broken) = &entry {
            let why = &broken.problem.message;
            tracing::warn!("the world {} cannot be used: {why}", path.display());
        }
        known.insert(name.to_owned(), (stamp, entry.clone()));
        Ok(Some(entry))
    }

    /// The text of a world's file; none when there is none.
    pub(super) fn text(&self, name: &str) -> Result<Option<String>, WorldsError> {
        let Some(path) = self.path(name) else { return Ok(None) };
        match fs::read_to_string(&path) {
            Ok(text) => Ok(Some(text)),
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
            Err(error) => Err(refused(&path, error)),
        }
    }

    /// Writes a world's file whole or not at all.
    pub(super) fn save(&self, world: &NamedWorld) -> Result<(), WorldsError> {
        let path = self.path(&world.name).ok_or(WorldsError::NoFolder)?;
        write_whole(&path, world.text.as_bytes())?;
        if let Some(stamp) = stamp(&path) {
            let mut known = self.read.lock().unwrap_or_else(PoisonError::into_inner);
            known.insert(world.name.clone(), (stamp, Ok(world.clone())));
        }
        Ok(())
    }

    /// Deletes a world's file and the picture beside it; false when there is no such world.
    pub(super) fn delete(&self, name: &str) -> Result<bool, WorldsError> {
        let Some(path) = self.path(name) else { return Ok(false) };
        let was_there = remove(&path)?;
        // Also one that was left alone, so that no later world of the name takes it for its own.
        remove(&map_beside(&path))?;
        Ok(was_there)
    }

    /// The picture of a world's map; none when there is none.
    pub(super) fn map(&self, name: &str) -> Result<Option<MapPicture>, WorldsError> {
        let Some(path) = self.path(name).map(|path| map_beside(&path)) else { return Ok(None) };
        let mut bytes = Vec::new();
        // One byte more tells that a file is too large.
        let read = fs::File::open(&path)
            .and_then(|file| file.take(LARGEST_FILE as u64 + 1).read_to_end(&mut bytes));
        match read {
            Ok(_) => {}
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            Err(error) => return Err(refused(&path, error)),
        }
        let broken = |why| WorldsError::Map(FieldError::new(file_name(&path), why));
        read_map(&bytes).map(Some).map_err(broken)
    }

    /// Writes the picture of a world's map whole or not at all.
    pub(super) fn save_map(&self, name: &str, file: &[u8]) -> Result<(), WorldsError> {
        let path = self.path(name).ok_or(WorldsError::NoFolder)?;
        write_whole(&map_beside(&path), file)
    }

    /// Deletes the picture of a world's map, if there is one.
    pub(super) fn delete_map(&self, name: &str) -> Result<(), WorldsError> {
        let Some(path) = self.path(name) else { return Ok(()) };
        remove(&map_beside(&path)).map(|_| ())
    }

    /// The file of a world; none for a name that would lead out of the folder.
    fn path(&self, name: &str) -> Option<PathBuf> {
        let plain =
            !name.is_empty() && !name.starts_with('.') && !name.contains(['/', '\\', ':', '\0']);
        let folder = self.folder.as_ref().filter(|_| plain)?;
        Some(folder.join(format!("{name}.toml")))
    }
}

/// Writes a file whole or not at all.
fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), WorldsError> {
    let write = || -> io::Result<()> {
        let folder = path.parent().unwrap_or(Path::new("."));
        fs::create_dir_all(folder)?;
        // A name that no world can have.
        let beside = folder.join(format!(".{}.part", file_name(path)));
        let mut file = fs::File::create(&beside)?;
        file.write_all(bytes)?;
        file.sync_all()?;
        fs::rename(&beside, path)
    };
    write().map_err(|error| refused(path, error))
}

/// Deletes a file; false when there is none.
fn remove(path: &Path) -> Result<bool, WorldsError> {
    match fs::remove_file(path) {
        Ok(()) => Ok(true),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(false),
        Err(error) => Err(refused(path, error)),
    }
}

fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

fn stamp(path: &Path) -> Option<Stamp> {
    let metadata = fs::metadata(path).ok().filter(fs::Metadata::is_file)?;
    Some((metadata.modified().ok(), metadata.len()))
}

fn refused(path: &Path, error: io::Error) -> WorldsError {
    WorldsError::Folder { path: path.display().to_string(), error }
}
