//! Logs that were cut off: bringing the index in line, and going on from a checkpoint.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use super::chunk::Chunk;
use super::log_file::LogFile;
use super::read::{Blocks, LogReader};
use super::record::{LogHeader, RawMessage, Topic};
use super::{LogWriter, Store, StoreError};
use crate::wire::{Round, State};

/// What a log holds after all.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Recovered {
    /// Last tick; 0 when there is none.
    pub tick: u64,
    /// Trials that ended.
    pub trials_done: u32,
    /// The log was not finished: its writer was killed, or the disk was full.
    pub cut_off: bool,
    /// Why the log could not be read to its end, if it is damaged.
    pub damage: Option<String>,
}

impl Store {
    /// Rebuilds the index of a session from its log. A log that is cut off or damaged counts as far
    /// as it can be read.
    pub fn recover(&self, id: &str) -> Result<Recovered, StoreError> {
        self.existing(id)?;
        remove_if_there(&resumed_path(self, id))?;
        let path = self.log_path(id);
        let (chunks, recovered) = if path.exists() { scan(&path)? } else { Default::default() };
        self.replace_chunks(id, &chunks, || Ok(()))?;
        Ok(recovered)
    }

    /// Puts the log aside as `log-<n>.mcap` and empties the index, so that the session can start
    /// again from its first tick. Gives the file the log went to, if there was a log.
    pub fn reset(&self, id: &str) -> Result<Option<PathBuf>, StoreError> {
        self.existing(id)?;
        self.drop_checkpoint(id)?;
        let log = self.log_path(id);
        let aside = log.exists().then(|| free_name(&self.session_folder(id)));
        self.replace_chunks(id, &[], || match &aside {
            Some(aside) => {
                fs::rename(&log, aside).map_err(|e| StoreError::file("put aside", &log, &e))
            }
            None => Ok(()),
        })?;
        Ok(aside)
    }

    /// Sessions that were alive when the last server ended become `interrupted`.
    pub(super) fn interrupt_left_over_sessions(&self) -> Result<(), StoreError> {
        for row in self.sessions()? {
            match row.state {
                State::Starting | State::Running | State::Paused | State::Stopping => {
                    self.interrupt_left_over(&row.id)?;
                }
                State::Queued if self.log_path(&row.id).exists() => {
                    self.interrupt_left_over(&row.id)?;
                }
                // A resume may have been cut off just after it swapped the log.
                State::Interrupted => drop(self.recover_if_readable(&row.id)?),
                State::Queued | State::Stopped | State::Finished | State::Failed => {}
            }
        }
        Ok(())
    }

    fn interrupt_left_over(&self, id: &str) -> Result<(), StoreError> {
        let reason = match self.recover_if_readable(id)? {
            None => self.interruption(id)?,
            Some(unreadable) => {
                format!("The server ended while the session was in use; {unreadable}")
            }
        };
        self.interrupt(id, &reason)
    }

    /// Recovers a session, or gives the reason why its log cannot be read: one bad log must not
    /// keep the others from being served.
    fn recover_if_readable(&self, id: &str) -> Result<Option<StoreError>, StoreError> {
        match self.recover(id) {
            Ok(_) => Ok(None),
            Err(unreadable @ (StoreError::NotALog { .. } | StoreError::File { .. })) => {
                Ok(Some(unreadable))
            }
            Err(other) => Err(other),
        }
    }

    fn interruption(&self, id: &str) -> Result<String, StoreError> {
        let way_on = match self.checkpoint(id)? {
            Some(checkpoint) => {
                format!("it can be resumed from its checkpoint at tick {}", checkpoint.tick)
            }
            None => "there is no checkpoint yet, so a resume begins with its first trial".into(),
        };
        Ok(format!("The server ended while the session was in use; {way_on}"))
    }
}

/// Goes on with the log of an interrupted session after `checkpoint_tick`.
///
/// All records up to that tick, the end of its trial included, are copied to a new file, which then
/// takes the old one's place. A crash before that leaves the old log as it was.
pub fn resume_log(store: &Store, id: &str, checkpoint_tick: u64) -> Result<LogWriter, StoreError> {
    store.existing(id)?;
    let old = store.log_path(id);
    let new = resumed_path(store, id);
    let header = LogReader::open(&old)?.header().cloned();
    let header = header.ok_or_else(|| StoreError::LogTooShort {
        path: old.clone(),
        last_tick: 0,
        checkpoint: checkpoint_tick,
    })?;
    let (log, chunks) = copy_through(&old, &new, &header, checkpoint_tick)?;
    store.replace_chunks(id, &chunks, || {
        fs::rename(&new, &old).map_err(|e| StoreError::file("replace", &old, &e))
    })?;
    LogWriter::start(store, id, log)
}

fn copy_through(
    old: &Path,
    new: &Path,
    header: &LogHeader,
    checkpoint_tick: u64,
) -> Result<(LogFile, Vec<Chunk>), StoreError> {
    let (mut log, first) = LogFile::create(new, header)?;
    let mut chunks = vec![first];
    let mut blocks = Blocks::open(old)?;
    let mut last_tick = 0;
    while last_tick <= checkpoint_tick {
        let Some(mut block) = blocks.next_block()? else { break };
        block.messages.retain(|message| message.topic != Topic::Session);
        let is_beyond = |m: &RawMessage| m.topic.is_tick() && m.tick > checkpoint_tick;
        let end = block.messages.iter().position(is_beyond);
        block.messages.truncate(end.unwrap_or(block.messages.len()));
        let contents = block.contents().map_err(|e| blocks.damaged(&e.to_string()))?;
        last_tick = contents.ticks.map_or(last_tick, |(_, last)| last);
        log.copy(&block.messages, contents)?;
        chunks.extend(log.close_chunk()?);
        if end.is_some() {
            break;
        }
    }
    if last_tick != checkpoint_tick {
        log.abandon();
        remove_if_there(new)?;
        let path = old.to_path_buf();
        return Err(StoreError::LogTooShort { path, last_tick, checkpoint: checkpoint_tick });
    }
    log.sync()?;
    Ok((log, chunks))
}

/// Reads a log as far as it goes.
fn scan(path: &Path) -> Result<(Vec<Chunk>, Recovered), StoreError> {
    let mut blocks = Blocks::open(path)?;
    let mut chunks = Vec::new();
    let mut recovered = Recovered::default();
    loop {
        match next_chunk(&mut blocks) {
            Ok(Some(chunk)) => {
                recovered.add(&chunk);
                chunks.push(chunk);
            }
            Ok(None) => break,
            Err(damage @ StoreError::Damaged { .. }) => {
                recovered.damage = Some(damage.to_string());
                break;
            }
            Err(other) => return Err(other),
        }
    }
    recovered.cut_off = blocks.is_cut_off();
    Ok((chunks, recovered))
}

fn next_chunk(blocks: &mut Blocks) -> Result<Option<Chunk>, StoreError> {
    let Some(block) = blocks.next_block()? else { return Ok(None) };
    let contents = block.contents().map_err(|e| blocks.damaged(&e.to_string()))?;
    Ok(Some(Chunk { offset: block.offset, length: block.length, contents }))
}

impl Recovered {
    fn add(&mut self, chunk: &Chunk) {
        self.tick = chunk.contents.ticks.map_or(self.tick, |(_, last)| last);
        self.trials_done = chunk.contents.rounds.last().map_or(self.trials_done, Round::number);
    }
}

/// Where a resumed log is built before it takes the old one's place.
fn resumed_path(store: &Store, id: &str) -> PathBuf {
    store.session_folder(id).join("log.resumed.mcap")
}

fn free_name(folder: &Path) -> PathBuf {
    let names = (1_u32..).map(|n| folder.join(format!("log-{n}.mcap")));
    let mut free = names.filter(|path| !path.exists());
    free.next().expect("a folder holds fewer than four thousand million files")
}

fn remove_if_there(path: &Path) -> Result<(), StoreError> {
    match fs::remove_file(path) {
        Err(e) if e.kind() != ErrorKind::NotFound => Err(StoreError::file("remove", path, &e)),
        _ => Ok(()),
    }
}
