//! What the actor shows: state, snapshot, events.

use std::time::Instant;

use super::{Actor, ControlError, EVENTS_EVERY, SNAPSHOT_EVERY};
use crate::clock;
use crate::session::feed::{News, Snapshot};
use crate::store::LogRecord;
use crate::wire::{LogEntry, Session, State};

impl Actor {
    /// Shows and stores a new state.
    pub(super) fn enter(&mut self, state: State, reason: Option<&str>) -> Result<(), ControlError> {
        self.condition.state = state;
        self.session.state = state;
        self.session.reason = reason.map(str::to_owned);
        self.session.changed_at = clock::now();
        self.show();
        let Session { id, changed_at, .. } = &self.session;
        Ok(self.lab.store().update_state(id, state, reason, changed_at)?)
    }

    /// Tells viewers everything at once.
    pub(super) fn show(&mut self) {
        self.session.controls =
            self.condition.controls().iter().map(|control| (*control).to_owned()).collect();
        self.look();
        let news = self.news(true);
        self.publish(news);
    }

    /// Shows the present from time to time, and tells of trials even less often.
    pub(super) fn publish_when_due(&mut self) {
        let watched = self.feed.viewers() > 0;
        let every = SNAPSHOT_EVERY[usize::from(!watched)];
        if self.published.elapsed() < every || self.condition.state != State::Running {
            return;
        }
        if watched {
            self.look();
        }
        let due = !self.untold_rounds.is_empty() && self.told.elapsed() >= EVENTS_EVERY;
        let news = if due { self.news(true) } else { News::default() };
        self.publish(news);
    }

    fn publish(&mut self, news: News) {
        self.published = Instant::now();
        let snapshot = Snapshot { session: self.session.clone(), present: self.present.clone() };
        self.feed.publish(snapshot, news);
    }

    pub(super) fn news(&mut self, state: bool) -> News {
        self.told = Instant::now();
        if let (Some(run), false) = (&self.run, self.untold_rounds.is_empty()) {
            self.present.count(run);
        }
        News {
            rounds: std::mem::take(&mut self.untold_rounds),
            log: std::mem::take(&mut self.untold_lines),
            state,
        }
    }

    /// Looks at neurons or tables.
    pub(super) fn look(&mut self) {
        if let Some(run) = &mut self.run {
            self.present.look(run);
        }
    }

    /// A line for the log and for viewers.
    pub(super) fn say(&mut self, kind: &str, text: &str) {
        let entry = LogEntry {
            at: clock::now(),
            tick: self.session.tick,
            kind: kind.to_owned(),
            text: text.to_owned(),
        };
        self.untold_lines.push(entry.clone());
        match &self.log {
            // A log that refuses is noticed with the next tick, and then the session fails.
            Some(log) => drop(log.write(LogRecord::Entry(entry))),
            None => self.unlogged.push(entry),
        }
    }
}
