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
mod drive_arena;
mod drive_run;
mod drive_view;
mod feed;
mod history;
mod lab;
mod machine;
mod pace;
mod paths;
mod prepare;
mod present;
mod reporting;
mod run;
mod slots;
mod starts;
mod state;
mod table_run;
mod table_view;
mod view;

#[cfg(test)]
mod drive_tests;
#[cfg(test)]
mod network_tests;
#[cfg(test)]
mod table_tests;
#[cfg(test)]
mod tests;

pub use actor::ControlError;
pub use arena::{Scenery, empty_arena, world_view};
pub use drive_run::{DriveRun, course};
pub use drive_view::rule_list;
pub use feed::{Event, Feed, Missed, News, Scene, Snapshot, Viewer, text};
pub(crate) use history::{log_header, new_row};
pub use lab::{Lab, LabError};
pub use paths::Paths;
pub use present::{DrivePresent, PathPresent, Present, TablePresent};
pub use reporting::{ReportError, Reporter, summary};
pub use run::{Run, Stepped};
pub use starts::{MOST_STARTS, check_starts, starts_arena};
pub use state::{Condition, Control, Refused, name as state_name};
pub use table_run::{Intervention, TableRun};
pub use table_view::task_view;
pub use view::Names;
