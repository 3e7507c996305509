//! Sessions: one actor owns one session, everybody else sends commands and reads snapshots.
//!
//! ```text
//! Lab ── Command ──▶ Actor ── LogRecord ──▶ store
//!                      │
//!                      ▼ publishes, never waits
//!                     Feed ◀── reads ── viewers
//! ```
//!
//! **Invariant: only the actor's loop changes a session.** The [`Lab`] finds or starts the actor and
//! hands over commands; a session at rest has no actor, no thread and no feed in memory.
//!
//! **Invariant: a viewer never slows a run.** The [`Feed`] keeps the latest snapshot and a bounded ring
//! of events; nothing in it waits for a reader.

mod actor;
mod arena;
mod feed;
mod history;
mod lab;
mod pace;
mod paths;
mod prepare;
mod reporting;
mod run;
mod slots;
mod starts;
mod state;
mod view;

#[cfg(test)]
mod network_tests;
#[cfg(test)]
mod tests;

pub use actor::ControlError;
pub use arena::{Scenery, empty_arena, world_view};
pub use feed::{Event, Feed, Missed, News, Snapshot, Viewer, text};
pub(crate) use history::{log_header, new_row};
pub use lab::{Lab, LabError};
pub use paths::Paths;
pub use reporting::{ReportError, Reporter, summary};
pub use run::{Run, Stepped};
pub use starts::{MOST_STARTS, check_starts, starts_arena};
pub use state::{Condition, Control, Refused, name as state_name};
pub use view::Names;
