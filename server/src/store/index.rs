//! The index over the logs, and the checkpoints.

use std::fs::File;

use rusqlite::{OptionalExtension, Transaction, params};

use super::chunk::Chunk;
use super::session_row::{from_text, to_text};
use super::{Store, StoreError};
use crate::wire::{LogEntry, Round, Trial};

/// The newest state a session can be resumed from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StoredCheckpoint {
    /// Rounds done.
    pub trials_done: u32,
    /// Last tick done.
    pub tick: u64,
    /// The state, as its owner encoded it.
    pub bytes: Vec<u8>,
}

/// Bytes of a log: first and number.
pub(super) type Extent = (u64, u64);

impl Store {
    /// The newest checkpoint of a session.
    pub fn checkpoint(&self, id: &str) -> Result<Option<StoredCheckpoint>, StoreError> {
        let found = self.database().query_row(
            "SELECT trials_done, tick, bytes FROM checkpoint WHERE session = ?1",
            [id],
            |row| {
                Ok(StoredCheckpoint {
                    trials_done: row.get(0)?,
                    tick: row.get::<_, i64>(1)?.cast_unsigned(),
                    bytes: row.get(2)?,
                })
            },
        );
        found.optional().map_err(StoreError::index("read a checkpoint"))
    }

    /// The rows of all trials of a robot that ended, in order.
    pub fn trials(&self, id: &str) -> Result<Vec<Trial>, StoreError> {
        let rounds = self.rounds(id)?.into_iter();
        let trial = |round| match round {
            Round::Trial(trial) => Some(*trial),
            Round::Episode(_) | Round::Run(_) => None,
        };
        Ok(rounds.filter_map(trial).collect())
    }

    /// The rows of all rounds that ended, in order.
    pub fn rounds(&self, id: &str) -> Result<Vec<Round>, StoreError> {
        let read = || {
            let database = self.database();
            let mut statement = database
                .prepare_cached("SELECT row FROM trial WHERE session = ?1 ORDER BY trial")?;
            statement.query_map([id], |row| from_text(row, 0))?.collect::<rusqlite::Result<_>>()
        };
        read().map_err(StoreError::index("read the trials"))
    }

    /// The newest `limit` events, oldest of them first.
    pub fn events(&self, id: &str, limit: usize) -> Result<Vec<LogEntry>, StoreError> {
        let limit = i64::try_from(limit).unwrap_or(i64::MAX);
        let read = || -> rusqlite::Result<Vec<LogEntry>> {
            let database = self.database();
            let mut statement = database.prepare_cached(
                "SELECT entry FROM event WHERE session = ?1 ORDER BY number DESC LIMIT ?2",
            )?;
            statement
                .query_map(params![id, limit], |row| from_text(row, 0))?
                .collect::<rusqlite::Result<_>>()
        };
        let mut newest_first = read().map_err(StoreError::index("read the events"))?;
        newest_first.reverse();
        Ok(newest_first)
    }

    /// Adds closed chunks, and the checkpoint that covers no more than they hold.
    pub(super) fn add_chunks(
        &self,
        id: &str,
        chunks: &[Chunk],
        checkpoint: Option<&StoredCheckpoint>,
    ) -> Result<(), StoreError> {
        self.change("add a chunk", |change| {
            for chunk in chunks {
                add_chunk(change, id, chunk)?;
            }
            checkpoint.map_or(Ok(()), |checkpoint| put_checkpoint(change, id, checkpoint))
        })
    }

    /// Puts other chunks in place of all that is known about a session's log. `swap` changes the
    /// file; no reader looks between the two.
    pub(super) fn replace_chunks(
        &self,
        id: &str,
        chunks: &[Chunk],
        swap: impl FnOnce() -> Result<(), StoreError>,
    ) -> Result<(), StoreError> {
        const DOING: &str = "replace the chunks of a session";
        let mut database = self.database();
        let change = database.transaction().map_err(StoreError::index(DOING))?;
        let replace = || {
            clear(&change, id)?;
            chunks.iter().try_for_each(|chunk| add_chunk(&change, id, chunk))
        };
        replace().map_err(StoreError::index(DOING))?;
        swap()?;
        change.commit().map_err(StoreError::index(DOING))
    }

    /// Forgets the checkpoint of a session.
    pub(super) fn drop_checkpoint(&self, id: &str) -> Result<(), StoreError> {
        self.change("drop a checkpoint", |change| {
            change.execute("DELETE FROM checkpoint WHERE session = ?1", [id]).map(drop)
        })
    }

    /// The log and the chunks in it that hold ticks `from` to `to`, in order.
    pub(super) fn chunks_with_ticks(
        &self,
        id: &str,
        from: u64,
        to: u64,
    ) -> Result<Option<(File, Vec<Extent>)>, StoreError> {
        let database = self.database();
        let read = || {
            let mut statement = database.prepare_cached(
                "SELECT offset, length FROM chunk \
                 WHERE session = ?1 AND last_tick >= ?2 AND first_tick <= ?3 ORDER BY offset",
            )?;
            let range = params![id, signed(from), signed(to)];
            statement
                .query_map(range, |row| Ok((unsigned(row, 0)?, unsigned(row, 1)?)))?
                .collect::<rusqlite::Result<_>>()
        };
        let extents: Vec<Extent> = read().map_err(StoreError::index("find ticks"))?;
        // The file is opened under the lock: a resume that swaps the log cannot come between.
        self.open_log(id, !extents.is_empty()).map(|log| log.map(|log| (log, extents)))
    }

    /// The log and the chunk in it where a trial ends.
    pub(super) fn chunk_with_trial_end(
        &self,
        id: &str,
        trial: u32,
    ) -> Result<Option<(File, Extent)>, StoreError> {
        let database = self.database();
        let found = database.query_row(
            "SELECT chunk_offset, chunk_length FROM trial WHERE session = ?1 AND trial = ?2",
            params![id, trial],
            |row| Ok((unsigned(row, 0)?, unsigned(row, 1)?)),
        );
        let extent = found.optional().map_err(StoreError::index("find a trial"))?;
        let log = self.open_log(id, extent.is_some())?;
        Ok(log.zip(extent))
    }

    fn open_log(&self, id: &str, wanted: bool) -> Result<Option<File>, StoreError> {
        let path = self.log_path(id);
        let open = || File::open(&path).map_err(|e| StoreError::file("open", &path, &e));
        wanted.then(open).transpose()
    }

    fn change(
        &self,
        doing: &'static str,
        body: impl FnOnce(&Transaction<'_>) -> rusqlite::Result<()>,
    ) -> Result<(), StoreError> {
        let mut database = self.database();
        let change = || {
            let change = database.transaction()?;
            body(&change)?;
            change.commit()
        };
        change().map_err(StoreError::index(doing))
    }
}

fn clear(change: &Transaction<'_>, id: &str) -> rusqlite::Result<()> {
    for table in ["chunk", "trial", "event"] {
        change.execute(&format!("DELETE FROM {table} WHERE session = ?1"), [id])?;
    }
    change.execute("UPDATE session SET tick = 0, trials_done = 0 WHERE id = ?1", [id])?;
    Ok(())
}

fn add_chunk(change: &Transaction<'_>, id: &str, chunk: &Chunk) -> rusqlite::Result<()> {
    let Chunk { offset, length, contents } = chunk;
    let (offset, length) = (signed(*offset), signed(*length));
    let ticks = contents.ticks.map(|(first, last)| (signed(first), signed(last)));
    change.prepare_cached("INSERT INTO chunk VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7)")?.execute(
        params![
            id,
            offset,
            length,
            ticks.map(|(first, _)| first),
            ticks.map(|(_, last)| last),
            contents.in_trials.map(|(first, _)| first),
            contents.in_trials.map(|(_, last)| last),
        ],
    )?;
    for round in &contents.rounds {
        change
            .prepare_cached("INSERT OR REPLACE INTO trial VALUES (?1, ?2, ?3, ?4, ?5)")?
            .execute(params![id, round.number(), to_text(round), offset, length])?;
    }
    for event in &contents.events {
        change
            .prepare_cached("INSERT INTO event (session, entry) VALUES (?1, ?2)")?
            .execute(params![id, to_text(event)])?;
    }
    change
        .prepare_cached(
            "UPDATE session SET tick = COALESCE(?2, tick), trials_done = COALESCE(?3, trials_done) \
             WHERE id = ?1",
        )?
        .execute(params![
            id,
            ticks.map(|(_, last)| last),
            contents.rounds.last().map(Round::number),
        ])?;
    Ok(())
}

fn put_checkpoint(
    change: &Transaction<'_>,
    id: &str,
    checkpoint: &StoredCheckpoint,
) -> rusqlite::Result<()> {
    change
        .prepare_cached("INSERT OR REPLACE INTO checkpoint VALUES (?1, ?2, ?3, ?4)")?
        .execute(params![id, signed(checkpoint.tick), checkpoint.trials_done, checkpoint.bytes])?;
    Ok(())
}

/// SQLite's integers are signed; the numbers here stay far below 2⁶³, except for an open end of a
/// range, which means "to the last".
fn signed(number: u64) -> i64 {
    i64::try_from(number).unwrap_or(i64::MAX)
}

fn unsigned(row: &rusqlite::Row<'_>, column: usize) -> rusqlite::Result<u64> {
    row.get(column).map(i64::cast_unsigned)
}
