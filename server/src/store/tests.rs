//! Facts about storage.
