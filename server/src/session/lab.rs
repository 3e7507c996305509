//! The laboratory: all sessions, the live and the stored.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, Weak};
use std::thread;

use serde_json::Value as Json;
use tokio::sync::oneshot;

use super::actor::{Actor, Command, ControlError};
use super::feed::Feed;
use super::history;
use super::machine::Machine;
use super::run::Run;
use super::slots::Slots;
use super::starts::check_starts;
use super::state::{Control, name};
use super::table_run::Intervention;
use crate::catalog::{Catalog, FieldError, Job, Plan, Trained};
use crate::store::{SessionRow, Store, StoreError};
use crate::wire::{
    Ack, AlteredStartView, LogEntry, NeuronView, NewSession, Session, StartView, State, TableFile,
    Yardstick,
};
use crate::yardstick;

/// All sessions. A clone is the same laboratory.
#[derive(Clone)]
pub struct Lab(Arc<Inner>);

struct Inner {
    catalog: Catalog,
    store: Store,
    slots: Slots,
    desks: Mutex<BTreeMap<String, Desk>>,
    ticks: AtomicU64,
}

/// What is in memory of one session.
#[derive(Default)]
struct Desk {
    /// Where to send commands, while an actor is at work.
    actor: Option<Sender<Command>>,
    /// Alive as long as the actor or a viewer holds it.
    feed: Weak<Feed>,
    /// The session as it came to rest.
    session: Option<Session>,
    /// Lines that no log was open for.
    unlogged: Vec<LogEntry>,
}

/// Why something could not be done with a session.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LabError {
    /// It is in use.
    #[error("the session is {}; stop it before it is deleted", name(*.0))]
    Busy(State),
    /// A value cannot be taken.
    #[error(transparent)]
    Field(#[from] FieldError),
    /// The disk refused, or there is no such session.
    #[error(transparent)]
    Store(#[from] StoreError),
}

impl From<LabError> for ControlError {
    fn from(error: LabError) -> Self {
        match error {
            LabError::Field(error) => Self::Field(error),
            LabError::Store(error) => Self::Store(error),
            LabError::Busy(_) => Self::Gone,
        }
    }
}

impl Lab {
    /// A laboratory over a data folder, with places for so many running sessions.
    #[must_use]
    pub fn new(catalog: Catalog, store: Store, places: usize) -> Self {
        Self(Arc::new(Inner {
            catalog,
            store,
            slots: Slots::new(places),
            desks: Mutex::default(),
            ticks: AtomicU64::new(0),
        }))
    }

    /// What can be run.
    #[must_use]
    pub fn catalog(&self) -> &Catalog {
        &self.0.catalog
    }

    /// What is kept.
    #[must_use]
    pub fn store(&self) -> &Store {
        &self.0.store
    }

    pub(super) fn slots(&self) -> &Slots {
        &self.0.slots
    }

    /// Control steps taken by all sessions since the server started.
    #[must_use]
    pub fn ticks(&self) -> u64 {
        self.0.ticks.load(Ordering::Relaxed)
    }

    pub(super) fn count_ticks(&self, ticks: u64) {
        self.0.ticks.fetch_add(ticks, Ordering::Relaxed);
    }

    /// Viewers connected now.
    #[must_use]
    pub fn viewers(&self) -> usize {
        self.desks()
            .values()
            .filter_map(|desk| desk.feed.upgrade())
            .map(|feed| feed.viewers())
            .sum()
    }

    /// Creates a session, `queued`.
    ///
    /// # Errors
    /// The first field that cannot be taken, or the disk's refusal.
    pub fn create(&self, request: &NewSession) -> Result<Session, LabError> {
        let request = self.with_network(request)?;
        let job = self.catalog().job(&request)?;
        Machine::new(&job)?;
        let row = history::new_row(&job)?;
        if let Job::Path(plan) = &job
            && let Some(network) = &plan.network
        {
            self.store().keep_network(&row.id, &network.text)?;
        }
        self.store().insert_session(&row)?;
        Ok(history::session(self.store(), row, job.changed().to_vec())?)
    }

    /// The request with the networks of a session in the place of its identifier.
    fn with_network<'a>(&self, request: &'a NewSession) -> Result<Cow<'a, NewSession>, LabError> {
        let Some(Json::String(id)) = &request.network else { return Ok(Cow::Borrowed(request)) };
        let refuse = |message: String| LabError::Field(FieldError::new("network", message));
        let trained = match self.trained(id) {
            Ok(Some(trained)) => trained,
            Ok(None) => {
                let why =
                    format!("no trial of the session {id} has ended, so it has no networks yet");
                return Err(refuse(why));
            }
            Err(LabError::Store(StoreError::NoSession { .. })) => {
                return Err(refuse(format!("there is no session `{id}`")));
            }
            Err(error) => return Err(error),
        };
        let file = serde_json::to_value(&trained.file).expect("plain data with text keys");
        Ok(Cow::Owned(NewSession { network: Some(file), ..request.clone() }))
    }

    /// The networks of a session as its last finished trial left them; none before the first.
    ///
    /// # Errors
    /// When there is no such session, or it cannot be read.
    pub fn trained(&self, id: &str) -> Result<Option<Trained>, LabError> {
        let plan = self.plan(id)?;
        let Some(stored) = self.store().checkpoint(id)? else { return Ok(None) };
        Ok(Some(Run::resume(&plan, &stored)?.trained(&plan)))
    }

    /// All sessions, newest first.
    ///
    /// # Errors
    /// When the store cannot be read.
    pub fn sessions(&self) -> Result<Vec<Session>, LabError> {
        let rows = self.store().sessions()?;
        let mut desks = self.desks();
        rows.into_iter().map(|row| self.look(&mut desks, row)).collect()
    }

    /// One session.
    ///
    /// # Errors
    /// When there is none of that name.
    pub fn session(&self, id: &str) -> Result<Session, LabError> {
        let row = self.row(id)?;
        self.look(&mut self.desks(), row)
    }

    /// What viewers see of a session.
    ///
    /// # Errors
    /// When there is none of that name, or it cannot be read.
    pub fn feed(&self, id: &str) -> Result<Arc<Feed>, LabError> {
        let row = self.row(id)?;
        self.open_feed(&mut self.desks(), row)
    }

    /// The full settings of a stored session, in its own world.
    ///
    /// # Errors
    /// When there is none of that name, or this program no longer knows its settings.
    pub fn plan(&self, id: &str) -> Result<Plan, LabError> {
        match self.job(id)? {
            Job::Path(plan) => Ok(*plan),
            Job::Plain(plan) => Err(LabError::Field(FieldError::new(
                "experiment",
                format!("a session of `{}` has no robot, arena or networks", plan.experiment),
            ))),
        }
    }

    /// What a stored session runs, in its own world.
    ///
    /// # Errors
    /// When there is none of that name, or this program no longer knows its settings.
    pub fn job(&self, id: &str) -> Result<Job, LabError> {
        self.restore(&self.row(id)?)
    }

    /// Does something to the learner of a tabular session under way.
    ///
    /// # Errors
    /// When nothing is under way, or the field that is wrong; nothing is changed then.
    pub async fn intervene(&self, id: &str, what: Intervention) -> Result<Ack, ControlError> {
        let (reply, answer) = oneshot::channel();
        if self.tell(id, Command::Intervene(what, reply)) {
            return answer.await.map_err(|_| ControlError::Gone)?;
        }
        Err(ControlError::NotUnderWay { state: self.session(id)?.state })
    }

    /// The table of the learner whose turn it is, or as the last checkpoint left it.
    ///
    /// # Errors
    /// When there is no such session, or its learner has no table of its own.
    pub async fn table(&self, id: &str) -> Result<TableFile, LabError> {
        let (reply, answer) = oneshot::channel();
        if self.tell(id, Command::Table(reply))
            && let Ok(Some(table)) = answer.await
        {
            return Ok(table?);
        }
        let job = self.job(id)?;
        let machine = match self.store().checkpoint(id)? {
            Some(stored) => Machine::resume(&job, &stored)?,
            None => Machine::new(&job)?,
        };
        Ok(machine.table_file(&job)?)
    }

    /// Asks something of a session and waits until it has taken effect.
    ///
    /// # Errors
    /// When its state does not allow it, or the disk refused.
    pub async fn control(&self, id: &str, control: Control) -> Result<Ack, ControlError> {
        let (reply, answer) = oneshot::channel();
        let (lab, id) = (self.clone(), id.to_owned());
        // Opening a session reads from the disk.
        let sent =
            tokio::task::spawn_blocking(move || lab.send(&id, Command::Control(control, reply)));
        sent.await.map_err(|_| ControlError::Gone)??;
        answer.await.map_err(|_| ControlError::Gone)?
    }

    /// A neuron of a session as it is now, its centre included.
    ///
    /// # Errors
    /// When the session cannot be read.
    pub async fn neuron(&self, id: &str, number: u32) -> Result<Option<NeuronView>, LabError> {
        let (reply, answer) = oneshot::channel();
        if self.tell(id, Command::Look(number, reply))
            && let Ok(Some(neuron)) = answer.await
        {
            return Ok(Some(neuron));
        }
        // A session at rest is as its last checkpoint left it.
        let job = self.job(id)?;
        let Some(stored) = self.store().checkpoint(id)? else { return Ok(None) };
        Ok(Machine::resume(&job, &stored).ok().and_then(|machine| machine.neuron(number)))
    }

    /// What a session's networks do from altered starts, as its last finished trial left them: from
    /// these, or from those of its experiment. There is nothing to tell before a trial has ended.
    ///
    /// # Errors
    /// When there is no such session, it cannot be read, or its robot cannot stand at a start.
    pub fn altered_starts(
        &self,
        id: &str,
        starts: Option<&[StartView]>,
    ) -> Result<Vec<AlteredStartView>, LabError> {
        let plan = self.plan(id)?;
        let starts = starts.unwrap_or(&plan.starts);
        check_starts(&plan, starts)?;
        match self.store().checkpoint(id)? {
            Some(stored) if !starts.is_empty() => {
                Ok(Run::resume(&plan, &stored)?.altered_starts(starts))
            }
            _ => Ok(Vec::new()),
        }
    }

    /// Brings the log of a session under way up to the present, before it is read.
    pub async fn flush(&self, id: &str) {
        let (reply, answer) = oneshot::channel();
        if self.tell(id, Command::Flush(reply)) {
            // An actor that ended meanwhile has closed its log.
            let _ = answer.await;
        }
    }

    /// Deletes a session that is not in use.
    ///
    /// # Errors
    /// When it is in use, or there is none of that name.
    pub fn delete(&self, id: &str) -> Result<(), LabError> {
        let row = self.row(id)?;
        let mut desks = self.desks();
        let session = self.look(&mut desks, row)?;
        if desks.get(id).is_some_and(|desk| desk.actor.is_some()) {
            return Err(LabError::Busy(session.state));
        }
        self.store().delete_session(id)?;
        desks.remove(id);
        Ok(())
    }

    /// Ends all sessions so that they can be taken up again.
    pub async fn close(&self) {
        let answers: Vec<_> = {
            let desks = self.desks();
            let actors = desks.values().filter_map(|desk| desk.actor.as_ref());
            let close = |actor: &Sender<Command>| {
                let (reply, answer) = oneshot::channel();
                actor.send(Command::Close(reply)).ok().map(|()| answer)
            };
            actors.filter_map(close).collect()
        };
        for answer in answers {
            // An actor that ended meanwhile has nothing to close.
            let _ = answer.await;
        }
    }

    /// Sends a command to an actor at work; says whether there is one.
    fn tell(&self, id: &str, command: Command) -> bool {
        let desks = self.desks();
        let actor = desks.get(id).and_then(|desk| desk.actor.as_ref());
        actor.is_some_and(|actor| actor.send(command).is_ok())
    }

    /// Makes the actor of a session panic.
    #[cfg(test)]
    pub(super) fn panic(&self, id: &str) {
        assert!(self.tell(id, Command::Panic), "the session has an actor");
    }

    fn send(&self, id: &str, command: Command) -> Result<(), LabError> {
        let row = self.row(id)?;
        let mut desks = self.desks();
        let actor = desks.get(id).and_then(|desk| desk.actor.clone());
        let actor = match actor {
            Some(actor) => actor,
            None => self.employ(&mut desks, row)?,
        };
        // Sent while the desks are locked, so that the actor cannot retire in between.
        drop(actor.send(command));
        Ok(())
    }

    /// Starts an actor for a session at rest.
    fn employ(
        &self,
        desks: &mut BTreeMap<String, Desk>,
        row: SessionRow,
    ) -> Result<Sender<Command>, LabError> {
        self.check_runs(&row)?;
        let id = row.id.clone();
        let checkpoint = self.store().checkpoint(&id)?.is_some();
        let feed = self.open_feed(desks, row)?;
        let desk = desks.entry(id.clone()).or_default();
        let (sender, commands) = channel();
        let unlogged = std::mem::take(&mut desk.unlogged);
        let channel = (sender.clone(), commands);
        let actor = Actor::new(self.clone(), feed, channel, checkpoint, unlogged);
        thread::Builder::new().name(format!("session {id}")).spawn(move || actor.serve()).map_err(
            |error| StoreError::Index { doing: "start a thread", reason: error.to_string() },
        )?;
        desk.actor = Some(sender.clone());
        desk.session = None;
        Ok(sender)
    }

    /// Lets an actor go, unless a command is on its way.
    pub(super) fn retire(
        &self,
        session: &Session,
        commands: &Receiver<Command>,
        unlogged: impl FnOnce() -> Vec<LogEntry>,
    ) -> Option<Command> {
        let mut desks = self.desks();
        if let Ok(command) = commands.try_recv() {
            return Some(command);
        }
        let desk = desks.entry(session.id.clone()).or_default();
        desk.actor = None;
        desk.session = Some(session.clone());
        desk.unlogged = unlogged();
        None
    }

    /// A session as it is now, from memory where it is there.
    fn look(
        &self,
        desks: &mut BTreeMap<String, Desk>,
        row: SessionRow,
    ) -> Result<Session, LabError> {
        let desk = desks.entry(row.id.clone()).or_default();
        if let Some(feed) = desk.feed.upgrade() {
            return Ok(feed.snapshot().session.clone());
        }
        if let Some(session) = &desk.session {
            return Ok(session.clone());
        }
        // A session this program cannot run can still be listed.
        let changed = self.restore(&row).map(|job| job.changed().to_vec()).unwrap_or_default();
        let session = history::session(self.store(), row, changed)?;
        desk.session = Some(session.clone());
        Ok(session)
    }

    fn open_feed(
        &self,
        desks: &mut BTreeMap<String, Desk>,
        row: SessionRow,
    ) -> Result<Arc<Feed>, LabError> {
        let id = row.id.clone();
        if let Some(feed) = desks.get(&id).and_then(|desk| desk.feed.upgrade()) {
            return Ok(feed);
        }
        let job = self.restore(&row)?;
        let session = self.look(desks, row)?;
        let feed = Arc::new(history::feed(self.store(), &job, session)?);
        if let Job::Path(plan) = job {
            measure(&feed, *plan);
        }
        desks.entry(id).or_default().feed = Arc::downgrade(&feed);
        Ok(feed)
    }

    /// Refuses what this program can read and not run, before anything is changed.
    fn check_runs(&self, row: &SessionRow) -> Result<(), LabError> {
        let network = self.store().network(&row.id)?;
        let job = self.catalog().restore(row, network.as_deref());
        job.map(drop).map_err(|FieldError { field, message }| {
            let made = format!("made by Sonarium {} and can be read, not run", row.build);
            FieldError::new(field, format!("{message}; the session was {made}")).into()
        })
    }

    fn restore(&self, row: &SessionRow) -> Result<Job, LabError> {
        let network = self.store().network(&row.id)?;
        Ok(self.catalog().restore_to_read(row, network.as_deref())?)
    }

    fn row(&self, id: &str) -> Result<SessionRow, LabError> {
        let row = self.store().session(id)?;
        Ok(row.ok_or_else(|| StoreError::NoSession { id: id.to_owned() })?)
    }

    fn desks(&self) -> MutexGuard<'_, BTreeMap<String, Desk>> {
        self.0.desks.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Tells a feed of the best path that a planner finds, at once if it is known, else when it is.
fn measure(feed: &Arc<Feed>, plan: Plan) {
    match yardstick::known(&plan) {
        Yardstick::Computing => {
            let feed = Arc::downgrade(feed);
            let work = move || {
                let yardstick = yardstick::compute(&plan);
                if let Some(feed) = feed.upgrade() {
                    feed.measure(yardstick);
                }
            };
            // Without a thread the session runs as well; only its yardstick stays unknown.
            let started = thread::Builder::new().name("planner".into()).spawn(work);
            if let Err(error) = started {
                tracing::warn!("cannot start a thread for the planner: {error}");
            }
        }
        known => feed.measure(known),
    }
}
