//! What can go wrong on disk, said so that a person can act on it.

use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use thiserror::Error;

/// Why something could not be stored or read. It is cheap to clone, because a failure of the log's
/// writer thread is reported to every later caller.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum StoreError {
    /// A session whose settings this program cannot use any more.
    #[error("session {id} cannot be opened by this program: {reason}")]
    Unfit {
        /// Its identifier.
        id: String,
        /// Why.
        reason: String,
    },
    /// The data folder cannot be used.
    #[error("cannot use the data folder {path}: {reason}; {advice}", path = path.display())]
    Folder {
        /// The folder.
        path: PathBuf,
        /// What the system said.
        reason: String,
        /// What to do.
        advice: String,
    },
    /// Another process has the data folder.
    #[error(
        "the data folder {path} is in use by another Sonarium{}; stop that one, or choose another folder with --data",
        process(holder),
        path = path.display()
    )]
    InUse {
        /// The folder.
        path: PathBuf,
        /// Process number of the other one; empty when unknown.
        holder: String,
    },
    /// The index was written by a newer program.
    #[error(
        "the index {path} has format {found}, written by a newer Sonarium (this one knows format {known}); update Sonarium, or choose another folder with --data",
        path = path.display()
    )]
    Newer {
        /// The index.
        path: PathBuf,
        /// Its format.
        found: i64,
        /// Newest format known here.
        known: i64,
    },
    /// The index could not be read or written.
    #[error("cannot {doing} in the index: {reason}")]
    Index {
        /// What was being done.
        doing: &'static str,
        /// What SQLite said.
        reason: String,
    },
    /// A file of a session could not be read or written.
    #[error("cannot {doing} {path}: {reason}", path = path.display())]
    File {
        /// What was being done.
        doing: &'static str,
        /// The file.
        path: PathBuf,
        /// What the system said, and what to do where that is known.
        reason: String,
    },
    /// A log holds bytes that cannot be read; everything before them can.
    #[error("the log {path} is damaged at byte {offset}: {reason}; what comes before can be read", path = path.display())]
    Damaged {
        /// The log.
        path: PathBuf,
        /// Where the damaged part starts.
        offset: u64,
        /// What is wrong with it.
        reason: String,
    },
    /// A file is not a log of this program.
    #[error("{path} is not a Sonarium log: {reason}", path = path.display())]
    NotALog {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// A session has a log already.
    #[error("session {id} has a log through tick {tick} already; resume it or reset it first")]
    LogExists {
        /// The session.
        id: String,
        /// Last tick in the log.
        tick: u64,
    },
    /// A log ends before the checkpoint to resume from.
    #[error(
        "the log {path} ends at tick {last_tick}, before the checkpoint at tick {checkpoint}; reset the session to run it again",
        path = path.display()
    )]
    LogTooShort {
        /// The log.
        path: PathBuf,
        /// Last tick it holds.
        last_tick: u64,
        /// Tick of the checkpoint.
        checkpoint: u64,
    },
    /// There is no such session.
    #[error("there is no session {id}")]
    NoSession {
        /// What was asked for.
        id: String,
    },
    /// The thread that writes the log is gone.
    #[error("the log's writer ended unexpectedly; what it had written before can be read")]
    WriterGone,
}

impl StoreError {
    /// The data folder at `path` cannot be used because of `e`.
    pub(super) fn folder(path: &Path, e: &io::Error) -> Self {
        let advice = match e.kind() {
            ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem => {
                "make it writable for this user, or choose another folder with --data"
            }
            ErrorKind::NotADirectory | ErrorKind::AlreadyExists => {
                "a file stands in its place: move it away, or choose another folder with --data"
            }
            ErrorKind::StorageFull | ErrorKind::QuotaExceeded => {
                "free some space, or choose another folder with --data"
            }
            _ => "choose another folder with --data",
        };
        Self::Folder { path: path.to_path_buf(), reason: e.to_string(), advice: advice.into() }
    }

    /// The file at `path` cannot be read or written because of `e`.
    pub(super) fn file(doing: &'static str, path: &Path, e: &io::Error) -> Self {
        let full = matches!(e.kind(), ErrorKind::StorageFull | ErrorKind::QuotaExceeded);
        let advice = if full {
            "; free some space, then resume the session, or reset it where no checkpoint was stored yet"
        } else {
            ""
        };
        Self::File { doing, path: path.to_path_buf(), reason: format!("{e}{advice}") }
    }

    /// SQLite refused something.
    pub(super) fn index(doing: &'static str) -> impl FnOnce(rusqlite::Error) -> Self {
        move |e| Self::Index { doing, reason: e.to_string() }
    }
}

/// " (process 12)", or nothing when the number is unknown.
fn process(holder: &str) -> String {
    let holder = holder.trim();
    if holder.is_empty() { String::new() } else { format!(" (process {holder})") }
}
