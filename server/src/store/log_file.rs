//! Writing one MCAP file: messages in, closed chunks out.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use mcap::records::MessageHeader;
use mcap::write::NoSeek;
use mcap::{Compression, McapError, WriteOptions, Writer};
use serde::Serialize;

use super::chunk::{Chunk, Contents};
use super::record::{LogHeader, RawMessage, TICK_NS, Topic};
use super::{StoreError, json_schema};
use crate::wire::{
    CycleView, DriveRunView, EpisodeView, Family, LogEntry, StepView, TickView, TrialEndView,
};

/// zstd's cheapest ordinary level; its "fast" levels double the size and save no time here.
const ZSTD_LEVEL: u32 = 1;

/// Start size of the buffer a chunk is compressed into.
const BUFFER_BYTES: u64 = 1 << 20;

/// A log being written.
pub(super) struct LogFile {
    path: PathBuf,
    writer: Writer<NoSeek<Counted>>,
    /// The same file, to sync and to trim it.
    file: File,
    /// Bytes handed to the system.
    written: Arc<AtomicU64>,
    /// Bytes up to the end of the last chunk that was closed.
    closed: u64,
    open: Contents,
    open_bytes: usize,
    json: Vec<u8>,
    /// Sequence number of the next trial end or event.
    sequence: u32,
}

impl LogFile {
    /// Starts a log at `path` with its header. An old file there is replaced.
    pub(super) fn create(path: &Path, header: &LogHeader) -> Result<(Self, Chunk), StoreError> {
        let failed = |e| StoreError::file("create", path, &e);
        let file = File::create(path).map_err(failed)?;
        let disk = file.try_clone().map_err(failed)?;
        Self::on_disk(path, file, Box::new(disk), header)
    }

    /// Starts a log on something that takes bytes for `file`.
    pub(super) fn on_disk(
        path: &Path,
        file: File,
        disk: Box<dyn Write + Send>,
        header: &LogHeader,
    ) -> Result<(Self, Chunk), StoreError> {
        let written = Arc::new(AtomicU64::new(0));
        let counted = Counted { disk, written: Arc::clone(&written) };
        let writer = options().create(NoSeek::new(counted));
        let mut log = Self {
            path: path.to_path_buf(),
            writer: writer.map_err(|e| failure(path, e))?,
            file,
            closed: written.load(Ordering::Relaxed),
            written,
            open: Contents::default(),
            open_bytes: 0,
            json: Vec::new(),
            sequence: 0,
        };
        log.declare_channels(header.family).map_err(|e| failure(path, e))?;
        log.encode(Topic::Session, 0, 0, header)?;
        let first = log.close_chunk()?.unwrap_or_default();
        Ok((log, first))
    }

    pub(super) fn write_tick(&mut self, tick: &TickView) -> Result<(), StoreError> {
        self.open.add_tick(tick);
        self.encode(Topic::Tick, tick.tick, low_bits(tick.tick), tick)
    }

    pub(super) fn write_trial_end(&mut self, end: &TrialEndView) -> Result<(), StoreError> {
        self.open.add_trial_end(end);
        let sequence = self.next_sequence();
        self.encode(Topic::Trial, end.trial.last_tick, sequence, end)
    }

    pub(super) fn write_step(&mut self, step: &StepView) -> Result<(), StoreError> {
        self.open.add_step(step);
        self.encode(Topic::Step, step.tick(), low_bits(step.tick()), step)
    }

    pub(super) fn write_cycle(&mut self, cycle: &CycleView) -> Result<(), StoreError> {
        self.open.add_cycle(cycle);
        self.encode(Topic::Cycle, cycle.tick, low_bits(cycle.tick), cycle)
    }

    pub(super) fn write_run(&mut self, run: &DriveRunView) -> Result<(), StoreError> {
        self.open.add_run(run);
        let sequence = self.next_sequence();
        self.encode(Topic::Run, run.last_tick, sequence, run)
    }

    pub(super) fn write_episode(&mut self, episode: &EpisodeView) -> Result<(), StoreError> {
        self.open.add_episode(episode);
        let sequence = self.next_sequence();
        self.encode(Topic::Episode, episode.last_tick, sequence, episode)
    }

    pub(super) fn write_event(&mut self, entry: &LogEntry) -> Result<(), StoreError> {
        self.open.add_event(entry);
        let sequence = self.next_sequence();
        self.encode(Topic::Event, entry.tick, sequence, entry)
    }

    /// Copies messages of another log as they are, with what is known about them.
    pub(super) fn copy(
        &mut self,
        messages: &[RawMessage],
        contents: Contents,
    ) -> Result<(), StoreError> {
        for message in messages {
            let sequence = match message.topic {
                topic if topic.is_tick() => low_bits(message.tick),
                _ => self.next_sequence(),
            };
            let header = message_header(message.topic, message.tick, sequence);
            let written = self.writer.write_to_known_channel(&header, &message.data);
            written.map_err(|e| failure(&self.path, e))?;
            self.open_bytes += message.data.len();
        }
        self.open = contents;
        Ok(())
    }

    /// Uncompressed bytes of the open chunk; 0 when none is open.
    pub(super) fn open_bytes(&self) -> usize {
        self.open_bytes
    }

    /// Closes the open chunk, if there is one, and hands it to the system.
    pub(super) fn close_chunk(&mut self) -> Result<Option<Chunk>, StoreError> {
        if self.open_bytes == 0 {
            return Ok(None);
        }
        self.writer.flush().map_err(|e| failure(&self.path, e))?;
        let end = self.written.load(Ordering::Relaxed);
        let contents = std::mem::take(&mut self.open);
        let chunk = Chunk { offset: self.closed, length: end - self.closed, contents };
        self.closed = end;
        self.open_bytes = 0;
        Ok(Some(chunk))
    }

    /// Waits until the disk has what was handed to the system.
    pub(super) fn sync(&self) -> Result<(), StoreError> {
        self.file.sync_data().map_err(|e| StoreError::file("write", &self.path, &e))
    }

    /// Ends the file with its summary. Chunks must have been closed before.
    pub(super) fn finish(mut self) -> Result<(), StoreError> {
        self.writer.finish().map_err(|e| failure(&self.path, e))?;
        self.sync()
    }

    /// Gives the log up after a failure: what was handed over in part is cut off, so that the file
    /// ends with the last whole chunk. The file is readable without this, too.
    pub(super) fn abandon(self) {
        let _ = self.file.set_len(self.closed);
        drop(self.writer.into_inner());
    }

    fn declare_channels(&mut self, family: Family) -> Result<(), McapError> {
        for topic in Topic::of(family) {
            let number = topic.number();
            let (name, schema) = json_schema::of_topic(topic);
            self.writer.add_schema_with_id(number, &name, "jsonschema", &schema)?;
            let metadata = BTreeMap::new();
            self.writer.add_channel_with_id(number, number, topic.name(), "json", &metadata)?;
        }
        Ok(())
    }

    fn encode(
        &mut self,
        topic: Topic,
        tick: u64,
        sequence: u32,
        value: &impl Serialize,
    ) -> Result<(), StoreError> {
        self.json.clear();
        let encoded = serde_json::to_writer(&mut self.json, value);
        encoded.map_err(|e| StoreError::file("write", &self.path, &e.into()))?;
        let header = message_header(topic, tick, sequence);
        let written = self.writer.write_to_known_channel(&header, &self.json);
        written.map_err(|e| failure(&self.path, e))?;
        self.open_bytes += self.json.len();
        Ok(())
    }

    fn next_sequence(&mut self) -> u32 {
        self.sequence = self.sequence.wrapping_add(1);
        self.sequence
    }
}

/// Chunks are closed by the caller, and each goes out in one piece, so that a log that was cut off
/// ends in a record whose length says that bytes are missing.
fn options() -> WriteOptions {
    WriteOptions::new()
        .library(concat!("sonarium ", env!("CARGO_PKG_VERSION")))
        .compression(Some(Compression::Zstd))
        .compression_level(ZSTD_LEVEL)
        .compression_threads(0)
        .chunk_size(Some(BUFFER_BYTES * 64))
        .disable_seeking(true)
}

fn message_header(topic: Topic, tick: u64, sequence: u32) -> MessageHeader {
    let log_time = tick.saturating_mul(TICK_NS);
    MessageHeader { channel_id: topic.number(), sequence, log_time, publish_time: log_time }
}

/// MCAP's sequence numbers have 32 bits and may wrap.
fn low_bits(tick: u64) -> u32 {
    (tick & u64::from(u32::MAX)) as u32
}

fn failure(path: &Path, e: McapError) -> StoreError {
    let e = match e {
        McapError::Io(e) => e,
        other => io::Error::other(other),
    };
    StoreError::file("write", path, &e)
}

/// Counts what was handed on.
struct Counted {
    disk: Box<dyn Write + Send>,
    written: Arc<AtomicU64>,
}

impl Write for Counted {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let taken = self.disk.write(bytes)?;
        self.written.fetch_add(taken as u64, Ordering::Relaxed);
        Ok(taken)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.disk.flush()
    }
}
