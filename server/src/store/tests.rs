//! Facts about storage.

mod crash;
mod fixture;
mod folder;
mod full_disk;
mod log;
mod resume;
