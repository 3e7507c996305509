//! Everything a session leaves on disk: one append-only MCAP log a session, and an SQLite index.
//!
//! ```text
//! DATA/sonarium.sqlite            sessions, and the index over their logs
//! DATA/sonarium.lock              held while a server uses the folder
//! DATA/sessions/{id}/log.mcap     the log: header, ticks, trial ends, events
//! DATA/sessions/{id}/log-1.mcap   a log put aside by a reset
//! ```
//!
//! **Invariant: the log is the truth.** The index holds nothing about a run that the log does not,
//! except the newest checkpoint, and can be rebuilt from it ([`Store::recover`]).
//!
//! **Invariant: what was closed stays readable.** A chunk is handed to the system whole, at least
//! every second, and is indexed afterwards. A log that ends in the middle of a chunk, because the
//! process was killed or the disk is full, gives everything before that chunk.

mod chunk;
mod database;
mod error;
mod index;
mod json_schema;
mod log_file;
mod network_file;
mod query;
mod read;
mod record;
mod recover;
mod session_row;
mod writer;

#[cfg(test)]
mod tests;

use std::fs::{self, File, TryLockError};
use std::io::{Read, Seek, Write};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use rusqlite::Connection;

pub use error::StoreError;
pub use index::StoredCheckpoint;
pub use read::{LogReader, read_log};
pub use record::{LogHeader, LogRecord, TICK_NS};
pub use recover::{Recovered, resume_log};
pub use session_row::SessionRow;
pub use writer::LogWriter;

/// A data folder in use by this process. Clones share it; the folder is free again when the last
/// one is dropped.
#[derive(Clone, Debug)]
pub struct Store {
    inner: Arc<Inner>,
}

#[derive(Debug)]
struct Inner {
    folder: PathBuf,
    connection: Mutex<Connection>,
    /// Held, not used: the system lets go of the lock when the file closes, even after a crash.
    _lock: File,
}

impl Store {
    /// Opens a data folder, creating it when it is missing.
    ///
    /// Sessions that were alive when the last server ended become `interrupted`, and their index is
    /// brought in line with their log.
    pub fn open(data: &Path) -> Result<Self, StoreError> {
        let sessions = data.join("sessions");
        fs::create_dir_all(&sessions).map_err(|e| StoreError::folder(data, &e))?;
        let lock = lock_folder(data)?;
        let connection = database::open(&data.join("sonarium.sqlite"))?;
        let store = Self {
            inner: Arc::new(Inner {
                folder: data.to_path_buf(),
                connection: Mutex::new(connection),
                _lock: lock,
            }),
        };
        store.interrupt_left_over_sessions()?;
        Ok(store)
    }

    /// The data folder.
    pub fn folder(&self) -> &Path {
        &self.inner.folder
    }

    /// Folder of a session's files.
    pub fn session_folder(&self, id: &str) -> PathBuf {
        self.inner.folder.join("sessions").join(id)
    }

    /// A session's log; it exists once the session has started.
    pub fn log_path(&self, id: &str) -> PathBuf {
        self.session_folder(id).join("log.mcap")
    }

    /// The database. A panic elsewhere cannot leave it half changed, since every change is one
    /// transaction, so a poisoned lock is used as it is.
    fn database(&self) -> MutexGuard<'_, Connection> {
        self.inner.connection.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Takes the folder for this process, or says who has it.
fn lock_folder(data: &Path) -> Result<File, StoreError> {
    let path = data.join("sonarium.lock");
    let mut file = File::options()
        .create(true)
        .truncate(false)
        .read(true)
        .write(true)
        .open(&path)
        .map_err(|e| StoreError::folder(data, &e))?;
    match file.try_lock() {
        Ok(()) => {}
        Err(TryLockError::WouldBlock) => {
            let mut holder = String::new();
            // The number only helps the message; without it the message still stands.
            let _ = file.read_to_string(&mut holder);
            return Err(StoreError::InUse { path: data.to_path_buf(), holder });
        }
        Err(TryLockError::Error(e)) => return Err(StoreError::folder(data, &e)),
    }
    let written = file
        .set_len(0)
        .and_then(|()| file.rewind())
        .and_then(|()| write!(file, "{}", std::process::id()));
    written.map_err(|e| StoreError::folder(data, &e))?;
    Ok(file)
}
