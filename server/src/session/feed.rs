//! What viewers read: the latest snapshot and the last events. The actor writes and never waits.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{SystemTime, UNIX_EPOCH};

use axum::extract::ws::Utf8Bytes;
use tokio::sync::watch;

use super::present::Present;
use crate::wire::{
    CourseView, CurvePoint, DriveScores, EpisodeView, HELLO_EPISODES, HELLO_TRIALS, Hello,
    LogEntry, Round, STREAM_VERSION, ScoresView, ServerMessage, Session, TaskView, Trial,
    WorldView, Yardstick,
};

/// Events a late client can still catch up on.
const RING: usize = 4096;
/// Log lines that `hello` carries.
const LOG_LINES: usize = 500;

/// The present of a session, as seen from outside. Cheap to clone, never changed once published.
#[derive(Clone, Debug)]
pub struct Snapshot {
    /// The session.
    pub session: Session,
    /// What changes with every step.
    pub present: Present,
}

/// Where a session takes place.
#[derive(Clone, Debug)]
pub enum Scene {
    /// A robot's world.
    World(Arc<WorldView>),
    /// The world of a tabular experiment.
    Task(Arc<TaskView>),
    /// Where the robot of chapter 2 drives.
    Course(Arc<CourseView>),
}

/// What happened since the last snapshot.
#[derive(Debug, Default)]
pub struct News {
    /// Rounds that ended.
    pub rounds: Vec<Round>,
    /// Lines for the event log.
    pub log: Vec<LogEntry>,
    /// The session's state, pace or progress changed.
    pub state: bool,
}

/// An event as it is sent: serialised once, for everybody.
#[derive(Clone, Debug)]
pub struct Event {
    /// Its number.
    pub seq: u64,
    /// The message.
    pub text: Utf8Bytes,
}

/// What a client that has seen events up to some number still needs.
pub enum Missed {
    /// These, in order.
    Events(Vec<Event>),
    /// More than is still held; the oldest one held is named.
    Gap {
        /// Number of the oldest event held.
        oldest: u64,
    },
}

/// One session's public face.
pub struct Feed {
    scene: Scene,
    inner: Mutex<Inner>,
    changed: watch::Sender<u64>,
    viewers: AtomicUsize,
}

struct Inner {
    snapshot: Arc<Snapshot>,
    yardstick: Yardstick,
    rounds: Vec<Arc<Round>>,
    log: VecDeque<LogEntry>,
    ring: VecDeque<Event>,
    seq: u64,
}

impl Feed {
    /// A feed over what is already known of a session.
    #[must_use]
    pub fn new(scene: Scene, snapshot: Snapshot, rounds: Vec<Round>, log: Vec<LogEntry>) -> Self {
        let surplus = log.len().saturating_sub(LOG_LINES);
        let inner = Inner {
            snapshot: Arc::new(snapshot),
            yardstick: Yardstick::Computing,
            rounds: rounds.into_iter().map(Arc::new).collect(),
            log: log.into_iter().skip(surplus).collect(),
            ring: VecDeque::new(),
            seq: first_seq(),
        };
        Self {
            scene,
            inner: Mutex::new(inner),
            changed: watch::Sender::new(1),
            viewers: AtomicUsize::new(0),
        }
    }

    /// The latest snapshot.
    #[must_use]
    pub fn snapshot(&self) -> Arc<Snapshot> {
        self.lock().snapshot.clone()
    }

    /// All rounds so far.
    #[must_use]
    pub fn rounds(&self) -> Vec<Arc<Round>> {
        self.lock().rounds.clone()
    }

    /// Number of the last event.
    #[must_use]
    pub fn seq(&self) -> u64 {
        self.lock().seq
    }

    /// The first message for a new client: state and history.
    #[must_use]
    pub fn hello(&self) -> Hello {
        let (seq, snapshot, yardstick, rounds, log) = {
            let inner = self.lock();
            let log: Vec<LogEntry> = inner.log.iter().cloned().collect();
            let newest = inner.rounds.len().saturating_sub(HELLO_TRIALS);
            let rounds = inner.rounds[newest..].to_vec();
            (inner.seq, inner.snapshot.clone(), inner.yardstick.clone(), rounds, log)
        };
        let episodes: Vec<&EpisodeView> =
            rounds.iter().filter_map(|round| round.episode()).collect();
        let newest = episodes.len().saturating_sub(HELLO_EPISODES);
        let runs: Vec<_> = rounds.iter().filter_map(|round| round.run()).collect();
        let newest_run = runs.len().saturating_sub(HELLO_EPISODES);
        let present = &snapshot.present;
        let (path, table, drive) = (present.path(), present.table(), present.drive());
        let (world, task, course) = match &self.scene {
            Scene::World(world) => (Some(WorldView::clone(world)), None, None),
            Scene::Task(task) => (None, Some(TaskView::clone(task)), None),
            Scene::Course(course) => (None, None, Some(CourseView::clone(course))),
        };
        let cycles =
            drive.map(|drive| drive.cycles.iter().map(|cycle| (**cycle).clone()).collect());
        Hello {
            version: STREAM_VERSION,
            seq,
            session: snapshot.session.clone(),
            yardstick: world.is_some().then_some(yardstick),
            world,
            task,
            table: table.and_then(|table| table.table.as_deref().cloned()),
            scores: table.map(|table| ScoresView::clone(&table.scores)),
            episodes: episodes[newest..].iter().map(|episode| (*episode).clone()).collect(),
            course,
            cycles: cycles.unwrap_or_default(),
            runs: runs[newest_run..].iter().map(|run| (*run).clone()).collect(),
            summary: drive.map(|drive| DriveScores::clone(&drive.scores)),
            trials: rounds.iter().filter_map(|round| round.trial().cloned()).collect(),
            neurons: path.map(|path| path.neurons.to_vec()).unwrap_or_default(),
            tick: path.and_then(|path| path.tick.as_deref().cloned()).map(Box::new),
            log,
        }
    }

    /// The events after `since`.
    #[must_use]
    pub fn after(&self, since: u64) -> Missed {
        let inner = self.lock();
        let oldest = inner.ring.front().map_or(inner.seq + 1, |event| event.seq);
        if since > inner.seq || since + 1 < oldest {
            return Missed::Gap { oldest };
        }
        let first = usize::try_from(since + 1 - oldest).unwrap_or(usize::MAX);
        Missed::Events(inner.ring.iter().skip(first).cloned().collect())
    }

    /// Wakes up whenever something was published.
    #[must_use]
    pub fn subscribe(&self) -> watch::Receiver<u64> {
        self.changed.subscribe()
    }

    /// Counts what was published; grows with everything a viewer could see.
    #[must_use]
    pub fn version(&self) -> u64 {
        *self.changed.borrow()
    }

    /// Counts a viewer for as long as the guard lives.
    #[must_use]
    pub fn watch(self: &Arc<Self>) -> Viewer {
        self.viewers.fetch_add(1, Ordering::Relaxed);
        Viewer(self.clone())
    }

    /// Viewers connected now.
    #[must_use]
    pub fn viewers(&self) -> usize {
        self.viewers.load(Ordering::Relaxed)
    }

    /// Shows a new present and tells what led to it, all at once: nobody sees one without the other.
    pub fn publish(&self, snapshot: Snapshot, news: News) {
        let mut inner = self.lock();
        inner.tell_rounds(news.rounds, &snapshot.present);
        inner.tell_log(news.log);
        if news.state {
            let session = Box::new(snapshot.session.clone());
            inner.push(|seq| ServerMessage::State { seq, session });
        }
        inner.snapshot = Arc::new(snapshot);
        drop(inner);
        self.changed.send_modify(|version| *version += 1);
    }

    /// Tells of the best path that a planner found, and what the trials before it regret.
    pub fn measure(&self, yardstick: Yardstick) {
        let mut inner = self.lock();
        for round in &mut inner.rounds {
            if let Round::Trial(trial) = &**round {
                *round = Arc::new(Round::Trial(Box::new(yardstick.mark(Trial::clone(trial)))));
            }
        }
        inner.yardstick = yardstick.clone();
        inner.push(|seq| ServerMessage::Yardstick { seq, yardstick: Box::new(yardstick) });
        drop(inner);
        self.changed.send_modify(|version| *version += 1);
    }

    /// The best path that a planner finds, as far as it is known.
    #[must_use]
    pub fn yardstick(&self) -> Yardstick {
        self.lock().yardstick.clone()
    }

    /// Keeps the first rounds only, because the rest is about to be done again. What clients hold is
    /// void, so the events before are given up and every client gets a new `hello`.
    pub fn rewind(&self, rounds_done: u32) -> Vec<Arc<Round>> {
        let mut inner = self.lock();
        inner.rounds.truncate(rounds_done as usize);
        inner.ring.clear();
        inner.seq += 1;
        inner.rounds.clone()
    }

    fn lock(&self) -> MutexGuard<'_, Inner> {
        self.inner.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Inner {
    fn tell_rounds(&mut self, rounds: Vec<Round>, present: &Present) {
        let (mut trials, mut episodes, mut runs) = (Vec::new(), Vec::new(), Vec::new());
        for round in rounds {
            match round {
                Round::Trial(trial) => trials.push(self.yardstick.mark(*trial)),
                Round::Episode(episode) => episodes.push(*episode),
                Round::Run(run) => runs.push(*run),
            }
        }
        if !trials.is_empty() {
            let points = trials.iter().map(CurvePoint::from).collect();
            let rounds = trials.iter().map(|trial| Round::Trial(Box::new(trial.clone())));
            self.rounds.extend(rounds.map(Arc::new));
            self.push(|seq| ServerMessage::Trial { seq, trials });
            self.push(|seq| ServerMessage::Curve { seq, points });
        }
        if !runs.is_empty() {
            let rounds = runs.iter().map(|run| Round::Run(Box::new(run.clone())));
            self.rounds.extend(rounds.map(Arc::new));
            self.push(|seq| ServerMessage::Run { seq, runs });
            if let Some(drive) = present.drive() {
                let summary = DriveScores::clone(&drive.scores);
                self.push(|seq| ServerMessage::Summary { seq, summary });
            }
        }
        if !episodes.is_empty() {
            let rounds = episodes.iter().map(|episode| Round::Episode(Box::new(episode.clone())));
            self.rounds.extend(rounds.map(Arc::new));
            self.push(|seq| ServerMessage::Episode { seq, episodes });
            if let Some(table) = present.table() {
                let scores = ScoresView::clone(&table.scores);
                self.push(|seq| ServerMessage::Scores { seq, scores });
            }
        }
    }

    fn tell_log(&mut self, entries: Vec<LogEntry>) {
        if entries.is_empty() {
            return;
        }
        self.log.extend(entries.iter().cloned());
        let surplus = self.log.len().saturating_sub(LOG_LINES);
        self.log.drain(..surplus);
        self.push(|seq| ServerMessage::Log { seq, entries });
    }

    fn push(&mut self, message: impl FnOnce(u64) -> ServerMessage) {
        self.seq += 1;
        let text = text(&message(self.seq));
        self.ring.push_back(Event { seq: self.seq, text });
        if self.ring.len() > RING {
            self.ring.pop_front();
        }
    }
}

/// A connected viewer, counted while this lives.
pub struct Viewer(Arc<Feed>);

impl Drop for Viewer {
    fn drop(&mut self) {
        self.0.viewers.fetch_sub(1, Ordering::Relaxed);
    }
}

/// A message as it is sent.
#[must_use]
pub fn text(message: &ServerMessage) -> Utf8Bytes {
    serde_json::to_string(message)
        .expect("messages have string keys and finite or null numbers")
        .into()
}

impl From<&Trial> for CurvePoint {
    fn from(trial: &Trial) -> Self {
        Self {
            trial: trial.trial,
            neurons: trial.neurons,
            steps: trial.steps,
            total_reinforcement: trial.total_reinforcement,
            reached_goal: trial.reached_goal,
        }
    }
}

/// Numbers start at the clock's milliseconds: a client that comes back after a restart of the server
/// holds a smaller number and is told of the gap, instead of being taken for up to date.
fn first_seq() -> u64 {
    let since_epoch = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
    u64::try_from(since_epoch.as_millis()).unwrap_or(0)
}
