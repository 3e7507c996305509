//! What a log holds: its records, their channels and their times.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use utoipa::ToSchema;

use crate::wire::{
    CycleView, DriveRunView, EpisodeView, Family, LogEntry, StepView, TickView, TrialEndView,
};

/// Log time of one tick, nanoseconds: a tenth of a second, the pace of the real robot, so that a
/// viewer of MCAP files plays a log as the robot would have driven it.
///
/// Every record's log time is its tick times this, never the time of day: the same run writes the
/// same records. Only the texts of events hold the time of day.
pub const TICK_NS: u64 = 100_000_000;

/// The first record of a log: all that is needed to run the session again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct LogHeader {
    /// Name of the experiment.
    pub experiment: String,
    /// Which kind of experiment it is, and so which channels the log has.
    #[serde(default)]
    pub family: Family,
    /// Seed.
    pub seed: u64,
    /// Every setting with its value, `preset` and `world` included.
    #[schema(value_type = Object)]
    pub settings: BTreeMap<String, Value>,
    /// Trials asked for; of each episode in a tabular experiment.
    pub trials: u32,
    /// Program version and commit.
    pub build: String,
    /// The world's file as it was used.
    pub world_text: String,
    /// The file of the networks it began with; none when they were empty.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub network_text: Option<String>,
}

/// One thing to put in a log.
#[derive(Clone, Debug, PartialEq)]
pub enum LogRecord {
    /// A control step.
    Tick(Box<TickView>),
    /// A step of a tabular experiment.
    Step(Box<StepView>),
    /// The end of an episode of a tabular experiment.
    EpisodeEnd(Box<EpisodeView>),
    /// The end of a trial.
    TrialEnd(Box<TrialEndView>),
    /// A cycle of an experiment of chapter 2.
    Cycle(Box<CycleView>),
    /// The end of a run of it.
    RunEnd(Box<DriveRunView>),
    /// A line of the event log.
    Entry(LogEntry),
    /// State to resume from, after everything given before it. It goes to the index, not to the
    /// log, and is never read from one.
    Checkpoint {
        /// Rounds done.
        trials_done: u32,
        /// Last tick done.
        tick: u64,
        /// The state, as its owner encodes it.
        bytes: Vec<u8>,
    },
}

/// A channel of the log. The numbers are fixed, so that one chunk can be read without the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Topic {
    Session = 1,
    Tick = 2,
    Trial = 3,
    Event = 4,
    Step = 5,
    Episode = 6,
    Cycle = 7,
    Run = 8,
}

impl Topic {
    pub(super) const ALL: [Self; 8] = [
        Self::Session,
        Self::Tick,
        Self::Trial,
        Self::Event,
        Self::Step,
        Self::Episode,
        Self::Cycle,
        Self::Run,
    ];

    /// The channels of a log.
    pub(super) fn of(family: Family) -> [Self; 4] {
        let (ticks, ends) = match family {
            Family::Path => (Self::Tick, Self::Trial),
            Family::Table => (Self::Step, Self::Episode),
            Family::Drive => (Self::Cycle, Self::Run),
        };
        [Self::Session, ticks, ends, Self::Event]
    }

    /// It holds ticks, whichever kind of experiment runs.
    pub(super) fn is_tick(self) -> bool {
        matches!(self, Self::Tick | Self::Step | Self::Cycle)
    }

    /// Number of the channel and of its schema.
    pub(super) fn number(self) -> u16 {
        self as u16
    }

    pub(super) fn from_number(number: u16) -> Option<Self> {
        Self::ALL.into_iter().find(|topic| topic.number() == number)
    }

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Session => "/session",
            Self::Tick => "/tick",
            Self::Trial => "/trial",
            Self::Event => "/event",
            Self::Step => "/step",
            Self::Episode => "/episode",
            Self::Cycle => "/cycle",
            Self::Run => "/run",
        }
    }
}

/// A message as it stands in a log.
#[derive(Clone, Debug)]
pub(super) struct RawMessage {
    pub(super) topic: Topic,
    /// Tick it belongs to.
    pub(super) tick: u64,
    /// JSON.
    pub(super) data: Vec<u8>,
}

impl RawMessage {
    /// What it says; none for the header.
    pub(super) fn decode(&self) -> serde_json::Result<Option<LogRecord>> {
        Ok(match self.topic {
            Topic::Session => None,
            Topic::Tick => Some(LogRecord::Tick(serde_json::from_slice(&self.data)?)),
            Topic::Trial => Some(LogRecord::TrialEnd(serde_json::from_slice(&self.data)?)),
            Topic::Step => Some(LogRecord::Step(serde_json::from_slice(&self.data)?)),
            Topic::Episode => Some(LogRecord::EpisodeEnd(serde_json::from_slice(&self.data)?)),
            Topic::Cycle => Some(LogRecord::Cycle(serde_json::from_slice(&self.data)?)),
            Topic::Run => Some(LogRecord::RunEnd(serde_json::from_slice(&self.data)?)),
            Topic::Event => Some(LogRecord::Entry(serde_json::from_slice(&self.data)?)),
        })
    }
}
