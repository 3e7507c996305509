//! What the controls do.

use std::time::Instant;

use super::{Actor, Command, ControlError, Until};
use crate::session::pace::Pace;
use crate::session::prepare::Prepared;
use crate::session::present::Present;
use crate::session::slots::Permit;
use crate::session::state::Control;
use crate::store::{LogRecord, LogWriter, StoreError};
use crate::wire::{Family, NamedSpeed, Speed, State, StepUnit};

impl Actor {
    pub(super) fn control(&mut self, control: Control) -> Result<(), ControlError> {
        self.condition.check(control)?;
        match control {
            Control::Start => {
                self.say("operator", "Started");
                self.ask_to_run(Until::Finished)
            }
            Control::Resume => {
                self.say("operator", "Resumed");
                self.ask_to_run(Until::Finished)
            }
            Control::Step(StepUnit::Trial) => {
                let round = match self.session.family {
                    Family::Path => "trial",
                    Family::Table => "episode",
                    Family::Drive => "run",
                };
                self.say("operator", &format!("Stepped to the end of the {round}"));
                self.ask_to_run(Until::TrialEnd)
            }
            Control::Step(StepUnit::Tick) => self.step(),
            Control::Pause => {
                self.say("operator", "Paused");
                self.hold()
            }
            Control::Stop => self.stop(),
            Control::Reset => self.reset(),
            Control::Speed(speed) => self.set_speed(speed),
        }
    }

    /// A control that broke off half-way leaves nothing to go on with.
    pub(super) fn fail_after(&mut self, control: Control, result: &Result<(), ControlError>) {
        match result {
            Err(ControlError::Store(_) | ControlError::Field(_))
                if matches!(control, Control::Speed(_)) => {}
            Err(error @ (ControlError::Store(_) | ControlError::Field(_))) => {
                self.fail(&error.to_string());
            }
            Ok(())
            | Err(
                ControlError::Refused(_) | ControlError::NotUnderWay { .. } | ControlError::Gone,
            ) => {}
        }
    }

    pub(super) fn ask_to_run(&mut self, until: Until) -> Result<(), ControlError> {
        self.until = until;
        let sender = self.sender.clone();
        let deliver = move |permit| drop(sender.send(Command::Admit(permit)));
        match self.lab.slots().request(&self.session.id, deliver) {
            Some(permit) => self.begin(permit),
            None => {
                self.condition.waiting = true;
                self.say("session", "Waits for a free core");
                self.enter(State::Queued, None)
            }
        }
    }

    pub(super) fn begin(&mut self, permit: Permit) -> Result<(), ControlError> {
        self.condition.waiting = false;
        self.permit = Some(permit);
        self.enter(State::Starting, None)?;
        self.prepare()?;
        self.pace = Pace::new(self.session.speed, Instant::now());
        self.enter(State::Running, None)
    }

    /// Builds the machine and opens the log, unless they are there already.
    pub(super) fn prepare(&mut self) -> Result<(), ControlError> {
        if self.run.is_some() {
            return Ok(());
        }
        let prepared = Prepared::new(&self.lab, &self.session.id)?;
        if prepared.tick < self.session.tick || prepared.rounds_done < self.session.rounds_done {
            self.rewind(prepared.tick, prepared.rounds_done);
        }
        let run = self.run.insert(prepared.run);
        self.present.count(run);
        self.present.look(run);
        let log = self.log.insert(prepared.log);
        for entry in prepared.lost.into_iter().chain(self.unlogged.drain(..)) {
            log.write(LogRecord::Entry(entry))?;
        }
        Ok(())
    }

    /// Forgets what came after the checkpoint; it is about to be done again.
    pub(super) fn rewind(&mut self, tick: u64, rounds_done: u32) {
        let kept = self.feed.rewind(rounds_done);
        self.session.count(kept.iter().map(|round| &**round));
        self.session.tick = tick;
        self.present.drop_trial();
        let text = match self.session.family {
            Family::Path => format!("Goes on from the checkpoint after trial {rounds_done}"),
            Family::Table => format!("Goes on from the checkpoint at tick {tick}"),
            Family::Drive => format!("Goes on from the checkpoint after run {rounds_done}"),
        };
        if tick > 0 {
            self.say("session", &text);
        }
    }

    pub(super) fn step(&mut self) -> Result<(), ControlError> {
        self.prepare()?;
        self.say("operator", "Stepped one tick");
        self.take_tick()?;
        self.lab.count_ticks(1);
        if self.condition.state == State::Finished { Ok(()) } else { self.hold() }
    }

    /// Holds between two ticks; the machine stays in memory.
    pub(super) fn hold(&mut self) -> Result<(), ControlError> {
        self.permit = None;
        if let Some(log) = &self.log {
            log.flush()?;
        }
        self.enter(State::Paused, None)
    }

    pub(super) fn stop(&mut self) -> Result<(), ControlError> {
        self.lab.slots().withdraw(&self.session.id);
        self.condition.waiting = false;
        self.say("operator", "Stopped");
        if self.log.is_some() {
            self.enter(State::Stopping, None)?;
        }
        self.settle(State::Stopped, None)
    }

    pub(super) fn reset(&mut self) -> Result<(), ControlError> {
        self.say("operator", "Reset");
        self.finish_log()?;
        self.lab.store().reset(&self.session.id)?;
        self.run = None;
        self.condition.checkpoint = false;
        self.present = Present::empty(self.session.family);
        self.untold_rounds.clear();
        self.feed.rewind(0);
        self.session.count([]);
        self.session.tick = 0;
        self.enter(State::Queued, None)
    }

    pub(super) fn set_speed(&mut self, speed: Speed) -> Result<(), ControlError> {
        self.lab.store().update_speed(&self.session.id, speed)?;
        self.session.speed = speed;
        self.pace = Pace::new(speed, Instant::now());
        let text = match speed {
            Speed::TicksPerSecond(rate_hz) => format!("Speed set to {rate_hz} ticks a second"),
            Speed::Named(NamedSpeed::Max) => "Speed set to as fast as it goes".into(),
        };
        self.say("operator", &text);
        self.show();
        Ok(())
    }

    /// Ends the run for now: the log is closed, the machine goes, the core is free.
    pub(super) fn settle(
        &mut self,
        state: State,
        reason: Option<&str>,
    ) -> Result<(), ControlError> {
        self.permit = None;
        self.look();
        if let Some(run) = self.run.take() {
            self.present.count(&run);
        }
        self.finish_log()?;
        self.enter(state, reason)
    }

    pub(super) fn finish_log(&mut self) -> Result<(), StoreError> {
        self.log.take().map_or(Ok(()), LogWriter::finish)
    }

    /// Cannot go on. What fails on the way down has nowhere else to be told.
    pub(super) fn fail(&mut self, reason: &str) {
        tracing::error!("session {} failed: {reason}", self.session.id);
        self.lab.slots().withdraw(&self.session.id);
        self.condition.waiting = false;
        self.say("warning", &format!("Failed: {reason}"));
        self.permit = None;
        self.run = None;
        if let Err(error) = self.finish_log() {
            tracing::error!("the log of session {} could not be closed: {error}", self.session.id);
        }
        self.believe_the_log();
        if let Err(error) = self.enter(State::Failed, Some(reason)) {
            tracing::error!("session {}: {error}", self.session.id);
        }
    }

    /// What did not reach the disk did not happen: it is gone for a resume and for every reader.
    fn believe_the_log(&mut self) {
        let (store, id) = (self.lab.store(), &self.session.id);
        if let Ok(checkpoint) = store.checkpoint(id) {
            self.condition.checkpoint = checkpoint.is_some();
        }
        let Ok(Some(row)) = store.session(id) else { return };
        if row.tick < self.session.tick {
            let told = usize::try_from(row.rounds_done).unwrap_or(usize::MAX);
            let before = self.feed.rounds().len();
            self.untold_rounds.truncate(told.saturating_sub(before));
            let kept = self.feed.rewind(row.rounds_done);
            let untold = self.untold_rounds.iter();
            self.session.count(kept.iter().map(|round| &**round).chain(untold));
            self.session.tick = row.tick;
        }
    }

    /// The server ends: what was under way can be taken up again.
    pub(super) fn close(&mut self) {
        const REASON: &str = "the server was shut down";
        self.lab.slots().withdraw(&self.session.id);
        if self.condition.at_rest() {
            return;
        }
        self.condition.waiting = false;
        let begun = self.session.tick > 0;
        let (state, reason) =
            if begun { (State::Interrupted, Some(REASON)) } else { (State::Queued, None) };
        if begun {
            self.say("session", "Interrupted: the server was shut down");
        }
        if let Err(error) = self.settle(state, reason) {
            self.fail(&error.to_string());
        }
    }
}
