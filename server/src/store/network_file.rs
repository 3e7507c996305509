//! The networks a session began with, kept beside its log so that it can be repeated.

use std::fs;
use std::io::ErrorKind;
use std::path::PathBuf;

use super::{Store, StoreError};

impl Store {
    /// Where the networks that a session began with are kept, if it began with some.
    pub fn network_path(&self, id: &str) -> PathBuf {
        self.session_folder(id).join("network.json")
    }

    /// Keeps the networks of a session that is about to be added.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn keep_network(&self, id: &str, text: &str) -> Result<(), StoreError> {
        let folder = self.session_folder(id);
        fs::create_dir_all(&folder).map_err(|e| StoreError::file("create", &folder, &e))?;
        let path = self.network_path(id);
        fs::write(&path, text).map_err(|e| StoreError::file("write", &path, &e))
    }

    /// The networks that a session began with; none when it began with empty ones.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn network(&self, id: &str) -> Result<Option<String>, StoreError> {
        let path = self.network_path(id);
        match fs::read_to_string(&path) {
            Ok(text) => Ok(Some(text)),
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
            Err(error) => Err(StoreError::file("read", &path, &error)),
        }
    }
}
