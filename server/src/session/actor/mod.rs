//! The actor that owns one session. Only its loop changes the session; everybody else sends commands
//! and reads the feed.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender};
use std::time::{Duration, Instant};

use tokio::sync::oneshot;

use crate::catalog::FieldError;
use crate::session::feed::Feed;
use crate::session::lab::Lab;
use crate::session::machine::Machine;
use crate::session::pace::Pace;
use crate::session::present::Present;
use crate::session::slots::Permit;
use crate::session::state::{Condition, Control, Refused};
use crate::session::table_run::Intervention;
use crate::store::{LogWriter, StoreError};
use crate::wire::{Ack, LogEntry, NeuronView, Round, Session, State, TableFile};

/// Longest time between two looks at the commands.
const ATTENTION: Duration = Duration::from_millis(4);
/// Least time between two snapshots while somebody watches, and while nobody does.
const SNAPSHOT_EVERY: [Duration; 2] = [Duration::from_micros(16_600), Duration::from_millis(250)];
/// Least time between two events about trials; those that end sooner travel together.
const EVENTS_EVERY: Duration = Duration::from_millis(100);

mod control;
mod face;
mod intervention;
mod tick;

/// What an actor is told.
pub(in crate::session) enum Command {
    /// An operator asks for something.
    Control(Control, oneshot::Sender<Result<Ack, ControlError>>),
    /// A core is free for this session.
    Admit(Permit),
    /// Somebody looks at a neuron, its centre included.
    Look(u32, oneshot::Sender<Option<NeuronView>>),
    /// An operator does something to the learner whose turn it is.
    Intervene(Intervention, oneshot::Sender<Result<Ack, ControlError>>),
    /// Somebody wants the learner's table.
    Table(oneshot::Sender<Option<Result<TableFile, FieldError>>>),
    /// Somebody is about to read the log.
    Flush(oneshot::Sender<()>),
    /// The server ends.
    Close(oneshot::Sender<()>),
    /// A test wants to see what a mistake in this program does.
    #[cfg(test)]
    Panic,
}

/// Why a control did not happen.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ControlError {
    /// The state does not allow it.
    #[error(transparent)]
    Refused(#[from] Refused),
    /// The session's settings or checkpoint cannot be used by this program.
    #[error(transparent)]
    Field(#[from] FieldError),
    /// The disk refused.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// There is nothing to change.
    #[error("the session is {}; it can be changed while it runs or is paused", crate::session::state_name(*.state))]
    NotUnderWay {
        /// The state.
        state: State,
    },
    /// The actor ended without an answer.
    #[error("the session ended before it could answer; look at its state")]
    Gone,
}

/// How far the session goes before it holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Until {
    Finished,
    TrialEnd,
}

/// One session and all that belongs to it.
pub(in crate::session) struct Actor {
    lab: Lab,
    feed: Arc<Feed>,
    sender: Sender<Command>,
    commands: Receiver<Command>,
    session: Session,
    condition: Condition,
    until: Until,
    pace: Pace,
    permit: Option<Permit>,
    /// The machine, from the first tick to the end or the next stop.
    run: Option<Machine>,
    log: Option<LogWriter>,
    /// Lines that wait for a log to be written to.
    unlogged: Vec<LogEntry>,
    /// When a checkpoint was last handed to the log.
    checkpointed: Instant,
    present: Present,
    /// Rounds and lines that viewers have not been told of.
    untold_rounds: Vec<Round>,
    untold_lines: Vec<LogEntry>,
    published: Instant,
    told: Instant,
}

impl Actor {
    /// An actor for what the feed shows.
    pub(in crate::session) fn new(
        lab: Lab,
        feed: Arc<Feed>,
        (sender, commands): (Sender<Command>, Receiver<Command>),
        checkpoint: bool,
        unlogged: Vec<LogEntry>,
    ) -> Self {
        let snapshot = feed.snapshot();
        let session = snapshot.session.clone();
        let now = Instant::now();
        Self {
            condition: Condition { state: session.state, waiting: false, checkpoint },
            until: Until::Finished,
            pace: Pace::new(session.speed, now),
            permit: None,
            run: None,
            log: None,
            unlogged,
            checkpointed: now,
            present: snapshot.present.clone(),
            untold_rounds: Vec::new(),
            untold_lines: Vec::new(),
            published: now,
            told: now,
            session,
            lab,
            feed,
            sender,
            commands,
        }
    }

    /// Serves the session until nothing is left to do.
    pub(in crate::session) fn serve(mut self) {
        while !self.retire() {
            let turn = catch_unwind(AssertUnwindSafe(|| self.turn()));
            match turn {
                Ok(Ok(())) => {}
                Ok(Err(error)) => self.fail(&error.to_string()),
                Err(panic) => self.fail(&format!("internal error: {}", panic_text(&*panic))),
            }
        }
    }

    /// Leaves when the session is at rest and no command is on its way.
    fn retire(&mut self) -> bool {
        if !self.condition.at_rest() {
            return false;
        }
        let unlogged = &mut self.unlogged;
        let left = self.lab.retire(&self.session, &self.commands, || std::mem::take(unlogged));
        match left {
            None => true,
            Some(command) => {
                self.handle(command);
                self.retire()
            }
        }
    }

    /// One round: some ticks, or one command.
    fn turn(&mut self) -> Result<(), ControlError> {
        if self.condition.state != State::Running {
            let command = self.commands.recv();
            if let Ok(command) = command {
                self.handle(command);
            }
            return Ok(());
        }
        let wait = self.pace.wait(Instant::now());
        if wait.is_zero() {
            self.advance()?;
            self.publish_when_due();
            while let Ok(command) = self.commands.try_recv() {
                self.handle(command);
            }
            return Ok(());
        }
        match self.commands.recv_timeout(wait) {
            Ok(command) => self.handle(command),
            Err(RecvTimeoutError::Timeout | RecvTimeoutError::Disconnected) => {}
        }
        Ok(())
    }

    /// The ticks that are due, but not for longer than commands may wait.
    fn advance(&mut self) -> Result<(), ControlError> {
        let end = Instant::now() + ATTENTION;
        let before = self.session.tick;
        while self.condition.state == State::Running {
            self.take_tick()?;
            let now = Instant::now();
            self.pace.done(now);
            if now >= end || !self.pace.wait(now).is_zero() {
                break;
            }
        }
        self.lab.count_ticks(self.session.tick.saturating_sub(before));
        Ok(())
    }

    fn handle(&mut self, command: Command) {
        match command {
            Command::Control(control, reply) => {
                let result = self.control(control);
                self.fail_after(control, &result);
                let ack = Ack { state: self.condition.state, tick: self.session.tick };
                // Whoever asked may have left; the control has happened all the same.
                let _ = reply.send(result.map(|()| ack));
            }
            Command::Admit(permit) => {
                if self.condition.waiting
                    && let Err(error) = self.begin(permit)
                {
                    self.fail(&error.to_string());
                }
            }
            Command::Look(neuron, reply) => {
                let found = self.run.as_ref().and_then(|run| run.neuron(neuron));
                let _ = reply.send(found);
            }
            Command::Intervene(intervention, reply) => {
                let result = self.intervene(&intervention);
                let ack = Ack { state: self.condition.state, tick: self.session.tick };
                let _ = reply.send(result.map(|()| ack));
            }
            Command::Table(reply) => {
                let _ = reply.send(self.table_file());
            }
            Command::Flush(reply) => {
                // A log that refuses is noticed with the next tick, and then the session fails.
                let _ = self.log.as_ref().map(LogWriter::flush);
                let _ = reply.send(());
            }
            Command::Close(reply) => {
                self.close();
                let _ = reply.send(());
            }
            #[cfg(test)]
            Command::Panic => panic!("a mistake"),
        }
    }
}

fn panic_text(panic: &(dyn std::any::Any + Send)) -> &str {
    let text = panic.downcast_ref::<&str>().copied();
    text.or_else(|| panic.downcast_ref::<String>().map(String::as_str)).unwrap_or("a panic")
}
