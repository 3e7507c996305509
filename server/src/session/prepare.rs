//! Getting a session ready: its machine and its log, new or from the last checkpoint.

use super::actor::ControlError;
use super::history;
use super::lab::Lab;
use super::machine::Machine;
use crate::store::{LogWriter, SessionRow, Store, StoreError, resume_log};
use crate::wire::LogEntry;

/// A session ready for its next tick.
pub(super) struct Prepared {
    pub(super) run: Machine,
    pub(super) log: LogWriter,
    /// Last tick that counts.
    pub(super) tick: u64,
    /// Rounds that count.
    pub(super) rounds_done: u32,
    /// What was said after the checkpoint. The log goes on from there, but these things happened.
    pub(super) lost: Vec<LogEntry>,
}

impl Prepared {
    /// Reads what is stored of a session and opens it.
    pub(super) fn new(lab: &Lab, id: &str) -> Result<Self, ControlError> {
        let store = lab.store();
        let row = store.session(id)?.ok_or_else(|| StoreError::NoSession { id: id.to_owned() })?;
        let network = store.network(id)?;
        let job = lab.catalog().restore(&row, network.as_deref())?;
        let checkpoint = store.checkpoint(id)?;
        let run = match &checkpoint {
            Some(checkpoint) => Machine::resume(&job, checkpoint)?,
            None => Machine::new(&job)?,
        };
        let (tick, rounds_done) = checkpoint.map_or((0, 0), |c| (c.tick, c.trials_done));
        let said = store.events(id, usize::MAX)?;
        let log = open_log(store, &row, network, tick)?;
        let kept = store.events(id, usize::MAX)?.len();
        let lost = said.into_iter().skip(kept).filter(|entry| entry.kind != "trial").collect();
        Ok(Self { run, log, tick, rounds_done, lost })
    }
}

fn open_log(
    store: &Store,
    row: &SessionRow,
    network: Option<String>,
    tick: u64,
) -> Result<LogWriter, StoreError> {
    if store.log_path(&row.id).exists() {
        return resume_log(store, &row.id, tick);
    }
    LogWriter::create(store, &row.id, &history::log_header(row, network))
}
