//! Logs and their index.
