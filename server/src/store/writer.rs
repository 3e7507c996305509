//! The thread that writes a session's log, and the queue in front of it.
//!
//! The session's loop hands over records and goes on; encoding, compression, files and index are
//! this thread's. It takes whole batches, so that at full speed neither side waits for the other.

use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use super::index::StoredCheckpoint;
use super::log_file::LogFile;
use super::record::{LogHeader, LogRecord};
use super::{Store, StoreError};

/// A chunk is closed when it holds this much JSON.
const CHUNK_BYTES: usize = 1 << 20;

/// A chunk is closed when it has been open this long. With [`LOOK_EVERY`] it stays under a second.
const CHUNK_TIME: Duration = Duration::from_millis(600);

/// How often the thread looks into a queue that fills slowly.
const LOOK_EVERY: Duration = Duration::from_millis(200);

/// Records in the queue at which the thread is woken before its time.
const WAKE_AT: usize = 256;

/// Records in the queue at which the session has to wait.
const QUEUE_LIMIT: usize = 4096;

/// A session's log while it is being written; each session has at most one.
#[derive(Debug)]
pub struct LogWriter {
    shared: Arc<Shared>,
    thread: Option<JoinHandle<()>>,
}

impl LogWriter {
    /// Starts the log of a session that has none, or one without ticks.
    pub fn create(store: &Store, id: &str, header: &LogHeader) -> Result<Self, StoreError> {
        let row = store.existing(id)?;
        if row.tick > 0 {
            return Err(StoreError::LogExists { id: id.into(), tick: row.tick });
        }
        let (log, first) = LogFile::create(&store.log_path(id), header)?;
        store.replace_chunks(id, &[first], || Ok(()))?;
        store.drop_checkpoint(id)?;
        Self::start(store, id, log)
    }

    /// Puts a thread behind a log that holds its header already.
    pub(super) fn start(store: &Store, id: &str, log: LogFile) -> Result<Self, StoreError> {
        let shared = Arc::new(Shared::default());
        let desk = Desk::new(store.clone(), id.into(), log);
        let ended = EndedGuard(Arc::clone(&shared));
        let spawned = thread::Builder::new()
            .name(format!("log {id}"))
            .spawn(move || ended.0.end(desk.work(&ended.0).err()));
        match spawned {
            Ok(thread) => Ok(Self { shared, thread: Some(thread) }),
            Err(e) => Err(StoreError::file("start the writer of", &store.log_path(id), &e)),
        }
    }

    /// Hands over one record. It returns at once, unless the writer is thousands of records behind.
    ///
    /// An error is the writer's: from then on nothing is stored any more.
    pub fn write(&self, record: LogRecord) -> Result<(), StoreError> {
        let mut queue = self.shared.lock();
        while queue.records.len() >= QUEUE_LIMIT && !queue.ended {
            queue = wait(&self.shared.changed, queue);
        }
        queue.failure()?;
        queue.records.push(record);
        if queue.records.len() == WAKE_AT {
            self.shared.wanted.notify_one();
        }
        Ok(())
    }

    /// Waits until the disk has everything given so far, the newest checkpoint included.
    pub fn flush(&self) -> Result<(), StoreError> {
        let mut queue = self.shared.lock();
        queue.flushes_asked += 1;
        let mine = queue.flushes_asked;
        self.shared.wanted.notify_one();
        while queue.flushes_done < mine && !queue.ended {
            queue = wait(&self.shared.changed, queue);
        }
        if queue.flushes_done < mine { queue.failure() } else { Ok(()) }
    }

    /// Writes what is left, ends the file with its summary and waits for the thread.
    ///
    /// Dropping the writer does the same, but cannot say whether it worked.
    pub fn finish(mut self) -> Result<(), StoreError> {
        self.close();
        self.shared.lock().failure.clone().map_or(Ok(()), Err)
    }

    fn close(&mut self) {
        self.shared.lock().closing = true;
        self.shared.wanted.notify_one();
        if let Some(thread) = self.thread.take() {
            // A panic of the thread is already in the queue, as a failure.
            let _ = thread.join();
        }
    }
}

impl Drop for LogWriter {
    fn drop(&mut self) {
        self.close();
    }
}

#[derive(Debug, Default)]
struct Shared {
    queue: Mutex<Queue>,
    /// The thread has something to do.
    wanted: Condvar,
    /// The thread has done something.
    changed: Condvar,
}

#[derive(Debug, Default)]
struct Queue {
    records: Vec<LogRecord>,
    flushes_asked: u64,
    flushes_done: u64,
    closing: bool,
    /// The thread takes nothing any more.
    ended: bool,
    failure: Option<StoreError>,
}

impl Queue {
    fn failure(&self) -> Result<(), StoreError> {
        match &self.failure {
            Some(failure) => Err(failure.clone()),
            None if self.ended => Err(StoreError::WriterGone),
            None => Ok(()),
        }
    }

    fn is_pressing(&self) -> bool {
        self.records.len() >= WAKE_AT || self.flushes_asked > self.flushes_done || self.closing
    }
}

/// What the thread was asked besides writing records.
struct Order {
    /// Number of the newest flush asked for.
    flush: Option<u64>,
    close: bool,
}

impl Shared {
    /// A panic while the queue was locked cannot leave it half changed.
    fn lock(&self) -> MutexGuard<'_, Queue> {
        self.queue.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Waits until there is enough to do or it is time to look, and takes all records.
    fn take(&self, batch: &mut Vec<LogRecord>) -> Order {
        let queue = self.lock();
        let waited = self.wanted.wait_timeout_while(queue, LOOK_EVERY, |q| !q.is_pressing());
        let (mut queue, _) = waited.unwrap_or_else(PoisonError::into_inner);
        std::mem::swap(&mut queue.records, batch);
        self.changed.notify_all();
        let flush = (queue.flushes_asked > queue.flushes_done).then_some(queue.flushes_asked);
        Order { flush, close: queue.closing }
    }

    fn flushed(&self, number: u64) {
        self.lock().flushes_done = number;
        self.changed.notify_all();
    }

    fn end(&self, failure: Option<StoreError>) {
        let mut queue = self.lock();
        if !queue.ended {
            queue.ended = true;
            queue.failure = failure;
            queue.records = Vec::new();
        }
        self.changed.notify_all();
    }
}

fn wait<'a>(changed: &Condvar, queue: MutexGuard<'a, Queue>) -> MutexGuard<'a, Queue> {
    changed.wait(queue).unwrap_or_else(PoisonError::into_inner)
}

/// Wakes everybody who waits for the thread, even when it panicked.
struct EndedGuard(Arc<Shared>);

impl Drop for EndedGuard {
    fn drop(&mut self) {
        self.0.end(Some(StoreError::WriterGone));
    }
}

/// The thread's side.
struct Desk {
    store: Store,
    id: String,
    log: LogFile,
    /// When the open chunk got its first record.
    opened: Option<Instant>,
    /// The newest checkpoint not yet stored.
    checkpoint: Option<StoredCheckpoint>,
    checkpoint_stored: Instant,
}

impl Desk {
    fn new(store: Store, id: String, log: LogFile) -> Self {
        let checkpoint_stored = Instant::now();
        Self { store, id, log, opened: None, checkpoint: None, checkpoint_stored }
    }

    fn work(mut self, shared: &Shared) -> Result<(), StoreError> {
        match self.serve(shared) {
            Ok(()) => self.log.finish(),
            Err(failure) => {
                self.log.abandon();
                Err(failure)
            }
        }
    }

    fn serve(&mut self, shared: &Shared) -> Result<(), StoreError> {
        let mut batch = Vec::new();
        loop {
            let order = shared.take(&mut batch);
            for record in batch.drain(..) {
                self.write(record)?;
            }
            if order.flush.is_some() || order.close {
                self.close_chunk(true)?;
                self.log.sync()?;
            } else if self.is_due() {
                self.close_chunk(false)?;
            }
            if let Some(number) = order.flush {
                shared.flushed(number);
            }
            if order.close {
                return Ok(());
            }
        }
    }

    fn write(&mut self, record: LogRecord) -> Result<(), StoreError> {
        match record {
            LogRecord::Tick(tick) => self.log.write_tick(&tick)?,
            LogRecord::TrialEnd(end) => self.log.write_trial_end(&end)?,
            LogRecord::Cycle(cycle) => self.log.write_cycle(&cycle)?,
            LogRecord::RunEnd(run) => self.log.write_run(&run)?,
            LogRecord::Step(step) => self.log.write_step(&step)?,
            LogRecord::EpisodeEnd(episode) => self.log.write_episode(&episode)?,
            LogRecord::Entry(entry) => self.log.write_event(&entry)?,
            LogRecord::Checkpoint { trials_done, tick, bytes } => {
                self.checkpoint = Some(StoredCheckpoint { trials_done, tick, bytes });
                return Ok(());
            }
        }
        if self.opened.is_none() {
            self.opened = Some(Instant::now());
        }
        if self.log.open_bytes() >= CHUNK_BYTES {
            self.close_chunk(false)?;
        }
        Ok(())
    }

    fn is_due(&self) -> bool {
        self.opened.is_some_and(|opened| opened.elapsed() >= CHUNK_TIME)
            || (self.checkpoint.is_some() && self.checkpoint_is_due())
    }

    fn checkpoint_is_due(&self) -> bool {
        self.checkpoint_stored.elapsed() >= CHUNK_TIME
    }

    /// Closes the open chunk and indexes it. The checkpoint goes with it when it is time or
    /// `settle` asks for it: only now does the log hold all that the checkpoint covers.
    fn close_chunk(&mut self, settle: bool) -> Result<(), StoreError> {
        let chunk = self.log.close_chunk()?;
        self.opened = None;
        let store_checkpoint = settle || self.checkpoint_is_due();
        let checkpoint = self.checkpoint.take_if(|_| store_checkpoint);
        if chunk.is_none() && checkpoint.is_none() {
            return Ok(());
        }
        if checkpoint.is_some() {
            self.checkpoint_stored = Instant::now();
        }
        self.store.add_chunks(&self.id, chunk.as_slice(), checkpoint.as_ref())
    }
}
