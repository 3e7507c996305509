//! What the index knows about one chunk of a log.

use super::record::{RawMessage, Topic};
use crate::wire::{
    CycleView, DriveRunView, EpisodeView, LogEntry, Round, StepView, TickView, TrialEndView,
};
use serde::Deserialize;

/// Where a chunk lies and what is in it.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Chunk {
    /// First byte of the chunk in the log.
    pub(super) offset: u64,
    /// Bytes, its message index included.
    pub(super) length: u64,
    pub(super) contents: Contents,
}

/// What is in a chunk.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Contents {
    /// First and last tick, if there are any.
    pub(super) ticks: Option<(u64, u64)>,
    /// First and last round that a tick or a round's end belongs to.
    pub(super) in_trials: Option<(u32, u32)>,
    /// Rows of the rounds that end here.
    pub(super) rounds: Vec<Round>,
    /// Events.
    pub(super) events: Vec<LogEntry>,
}

/// The start of a tick: enough to index it.
#[derive(Deserialize)]
struct TickNumbers {
    tick: u64,
    trial: u32,
}

/// The start of a tabular step, or of a cycle.
#[derive(Deserialize)]
struct StepNumbers {
    tick: u64,
    round: u32,
}

impl Contents {
    pub(super) fn add_tick(&mut self, tick: &TickView) {
        self.add_tick_numbers(tick.tick, tick.trial);
    }

    pub(super) fn add_trial_end(&mut self, end: &TrialEndView) {
        self.add_trial(end.trial.trial);
        self.rounds.push(Round::Trial(Box::new(end.trial.clone())));
    }

    pub(super) fn add_step(&mut self, step: &StepView) {
        self.add_tick_numbers(step.tick(), step.round());
    }

    pub(super) fn add_cycle(&mut self, cycle: &CycleView) {
        self.add_tick_numbers(cycle.tick, cycle.round);
    }

    pub(super) fn add_run(&mut self, run: &DriveRunView) {
        self.add_trial(run.round);
        self.rounds.push(Round::Run(Box::new(run.clone())));
    }

    pub(super) fn add_episode(&mut self, episode: &EpisodeView) {
        self.add_trial(episode.round);
        self.rounds.push(Round::Episode(Box::new(episode.clone())));
    }

    pub(super) fn add_event(&mut self, entry: &LogEntry) {
        self.events.push(entry.clone());
    }

    /// The contents of a chunk that was read. Ticks stand in order, so only the first and the last
    /// are looked at.
    pub(super) fn of_messages(messages: &[RawMessage]) -> serde_json::Result<Self> {
        let mut contents = Self::default();
        let ticks = || messages.iter().filter(|message| message.topic.is_tick());
        for message in ticks().next().into_iter().chain(ticks().next_back()) {
            if message.topic == Topic::Tick {
                let numbers: TickNumbers = serde_json::from_slice(&message.data)?;
                contents.add_tick_numbers(numbers.tick, numbers.trial);
            } else {
                let numbers: StepNumbers = serde_json::from_slice(&message.data)?;
                contents.add_tick_numbers(numbers.tick, numbers.round);
            }
        }
        for message in messages {
            match message.topic {
                Topic::Session | Topic::Tick | Topic::Step | Topic::Cycle => {}
                Topic::Run => contents.add_run(&serde_json::from_slice(&message.data)?),
                Topic::Trial => contents.add_trial_end(&serde_json::from_slice(&message.data)?),
                Topic::Episode => contents.add_episode(&serde_json::from_slice(&message.data)?),
                Topic::Event => contents.events.push(serde_json::from_slice(&message.data)?),
            }
        }
        Ok(contents)
    }

    fn add_tick_numbers(&mut self, tick: u64, trial: u32) {
        let first = self.ticks.map_or(tick, |(first, _)| first);
        self.ticks = Some((first, tick));
        self.add_trial(trial);
    }

    fn add_trial(&mut self, trial: u32) {
        let first = self.in_trials.map_or(trial, |(first, _)| first);
        self.in_trials = Some((first, trial));
    }
}
