//! Ticks and trial ends from the log, by the chunks that hold them.

use std::ops::{ControlFlow, RangeInclusive};

use serde::de::DeserializeOwned;

use super::read::read_extent;
use super::record::{LogRecord, RawMessage, Topic};
use super::{Store, StoreError};
use crate::wire::{CycleView, StepView, TickView, TrialEndView};

impl Store {
    /// Ticks `from` to `to`, both included, as far as they have been closed into chunks. It works
    /// while the log is being written.
    pub fn ticks(&self, id: &str, from: u64, to: u64) -> Result<Vec<TickView>, StoreError> {
        self.parsed(id, from, to)
    }

    /// The same of a tabular session.
    pub fn steps(&self, id: &str, from: u64, to: u64) -> Result<Vec<StepView>, StoreError> {
        self.parsed(id, from, to)
    }

    /// The same of a session of chapter 2.
    pub fn cycles(&self, id: &str, from: u64, to: u64) -> Result<Vec<CycleView>, StoreError> {
        self.parsed(id, from, to)
    }

    fn parsed<T: DeserializeOwned>(
        &self,
        id: &str,
        from: u64,
        to: u64,
    ) -> Result<Vec<T>, StoreError> {
        let mut ticks = Vec::new();
        let mut unreadable = None;
        self.each_tick_json(id, from..=to, |tick, json| match serde_json::from_slice(json) {
            Ok(view) => {
                ticks.push(view);
                ControlFlow::Continue(())
            }
            Err(e) => {
                unreadable = Some(self.unreadable(id, &format!("tick {tick}: {e}")));
                ControlFlow::Break(())
            }
        })?;
        unreadable.map_or(Ok(ticks), Err)
    }

    /// The same as one JSON array, without parsing the ticks.
    pub fn ticks_json(&self, id: &str, from: u64, to: u64) -> Result<Vec<u8>, StoreError> {
        let mut array = vec![b'['];
        self.each_tick_json(id, from..=to, |_, json| {
            if array.len() > 1 {
                array.push(b',');
            }
            array.extend_from_slice(json);
            ControlFlow::Continue(())
        })?;
        array.push(b']');
        Ok(array)
    }

    /// Hands each tick's number and JSON to `take`, in order, until it breaks off. Memory stays at
    /// one chunk, so that whole sessions can be exported.
    pub fn each_tick_json(
        &self,
        id: &str,
        ticks: RangeInclusive<u64>,
        mut take: impl FnMut(u64, &[u8]) -> ControlFlow<()>,
    ) -> Result<(), StoreError> {
        let found = self.chunks_with_ticks(id, *ticks.start(), *ticks.end())?;
        let Some((mut log, extents)) = found else { return Ok(()) };
        let path = self.log_path(id);
        let wanted =
            |message: &RawMessage| message.topic.is_tick() && ticks.contains(&message.tick);
        for extent in extents {
            for message in read_extent(&mut log, &path, extent)?.iter().filter(|m| wanted(m)) {
                if take(message.tick, &message.data).is_break() {
                    return Ok(());
                }
            }
        }
        Ok(())
    }

    /// What the learner did at the end of a trial; none when the trial has not ended.
    pub fn trial_end(&self, id: &str, trial: u32) -> Result<Option<TrialEndView>, StoreError> {
        let Some((mut log, extent)) = self.chunk_with_trial_end(id, trial)? else {
            return Ok(None);
        };
        let messages = read_extent(&mut log, &self.log_path(id), extent)?;
        for message in messages.iter().filter(|message| message.topic == Topic::Trial) {
            let decoded = message.decode();
            let decoded =
                decoded.map_err(|e| self.unreadable(id, &format!("end of trial {trial}: {e}")))?;
            match decoded {
                Some(LogRecord::TrialEnd(end)) if end.trial.trial == trial => {
                    return Ok(Some(*end));
                }
                _ => {}
            }
        }
        Ok(None)
    }

    fn unreadable(&self, id: &str, reason: &str) -> StoreError {
        let path = self.log_path(id);
        StoreError::File { doing: "understand", path, reason: reason.into() }
    }
}
