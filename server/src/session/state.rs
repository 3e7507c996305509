//! Which control a session takes in which state. The table is here and nowhere else.

use crate::wire::{Speed, State, StepUnit};

/// What an operator can ask of a session.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Control {
    /// Begin, as soon as a core is free.
    Start,
    /// Hold between two ticks.
    Pause,
    /// Go on: from where it was paused, or from the last checkpoint.
    Resume,
    /// Go one tick or one trial, then hold.
    Step(StepUnit),
    /// End for good before the last trial; it can be taken up again.
    Stop,
    /// Back to tick 0 with an empty network.
    Reset,
    /// Change the pace.
    Speed(Speed),
}

impl Control {
    /// Its name in the interface.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Start => "start",
            Self::Pause => "pause",
            Self::Resume => "resume",
            Self::Step(_) => "step",
            Self::Stop => "stop",
            Self::Reset => "reset",
            Self::Speed(_) => "speed",
        }
    }
}

/// What decides which controls are acceptable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Condition {
    /// The state shown.
    pub state: State,
    /// A queued session was asked to start and waits for a free core.
    pub waiting: bool,
    /// There is a checkpoint to go on from.
    pub checkpoint: bool,
}

impl Condition {
    /// Names of the controls that would be accepted now, in the order of [`Control`].
    #[must_use]
    pub fn controls(self) -> &'static [&'static str] {
        match (self.state, self.waiting) {
            (State::Queued, false) => &["start", "step", "stop"],
            (State::Queued, true) => &["stop"],
            (State::Running, _) => &["pause", "stop"],
            (State::Paused, _) => &["resume", "step", "stop", "reset"],
            (State::Stopped | State::Interrupted, _) => &["resume", "reset"],
            (State::Failed, _) if self.checkpoint => &["resume", "reset"],
            (State::Failed | State::Finished, _) => &["reset"],
            (State::Starting | State::Stopping, _) => &[],
        }
    }

    /// Whether a control would be accepted now. The pace can be changed unless the run is over.
    #[must_use]
    pub fn accepts(self, control: Control) -> bool {
        match control {
            Control::Speed(_) => !matches!(self.state, State::Finished | State::Failed),
            _ => self.controls().contains(&control.name()),
        }
    }

    /// Refuses a control that is not acceptable now.
    ///
    /// # Errors
    /// When the table says no; the text names the state and what is possible.
    pub fn check(self, control: Control) -> Result<(), Refused> {
        if self.accepts(control) {
            return Ok(());
        }
        Err(Refused { control: control.name(), state: self.state, possible: self.controls() })
    }

    /// Nothing will happen until an operator asks for it, and nothing is kept in memory.
    #[must_use]
    pub fn at_rest(self) -> bool {
        match self.state {
            State::Queued => !self.waiting,
            State::Stopped | State::Finished | State::Failed | State::Interrupted => true,
            State::Starting | State::Running | State::Paused | State::Stopping => false,
        }
    }
}

/// A control that the session's state does not allow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Refused {
    /// What was asked.
    pub control: &'static str,
    /// The state it was asked in.
    pub state: State,
    /// What would have been accepted.
    pub possible: &'static [&'static str],
}

impl std::error::Error for Refused {}

impl std::fmt::Display for Refused {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "the session is {} and cannot {}; ", name(self.state), self.control)?;
        match self.possible {
            [] => write!(f, "wait until it has settled"),
            possible => write!(f, "possible now: {}", possible.join(", ")),
        }
    }
}

/// A state's name as it travels.
#[must_use]
pub fn name(state: State) -> &'static str {
    match state {
        State::Queued => "queued",
        State::Starting => "starting",
        State::Running => "running",
        State::Paused => "paused",
        State::Stopping => "stopping",
        State::Stopped => "stopped",
        State::Finished => "finished",
        State::Failed => "failed",
        State::Interrupted => "interrupted",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wire::NamedSpeed;

    const CONTROLS: [Control; 7] = [
        Control::Start,
        Control::Pause,
        Control::Resume,
        Control::Step(StepUnit::Tick),
        Control::Stop,
        Control::Reset,
        Control::Speed(Speed::Named(NamedSpeed::Max)),
    ];

    #[test]
    fn every_state_takes_exactly_these_controls() {
        //                      state              waiting checkpoint  st pa re step stop reset speed
        for (state, waiting, checkpoint, expected) in [
            (State::Queued, false, false, [1, 0, 0, 1, 1, 0, 1]),
            (State::Queued, true, false, [0, 0, 0, 0, 1, 0, 1]),
            (State::Starting, false, false, [0, 0, 0, 0, 0, 0, 1]),
            (State::Running, false, true, [0, 1, 0, 0, 1, 0, 1]),
            (State::Paused, false, true, [0, 0, 1, 1, 1, 1, 1]),
            (State::Stopping, false, true, [0, 0, 0, 0, 0, 0, 1]),
            (State::Stopped, false, true, [0, 0, 1, 0, 0, 1, 1]),
            (State::Stopped, false, false, [0, 0, 1, 0, 0, 1, 1]),
            (State::Finished, false, true, [0, 0, 0, 0, 0, 1, 0]),
            (State::Failed, false, true, [0, 0, 1, 0, 0, 1, 0]),
            (State::Failed, false, false, [0, 0, 0, 0, 0, 1, 0]),
            (State::Interrupted, false, false, [0, 0, 1, 0, 0, 1, 1]),
        ] {
            let condition = Condition { state, waiting, checkpoint };
            let accepted = CONTROLS.map(|control| i32::from(condition.accepts(control)));
            assert_eq!(accepted, expected, "{condition:?}");
        }
    }

    #[test]
    fn a_refusal_says_the_state_and_what_is_possible() {
        let stopped = Condition { state: State::Stopped, waiting: false, checkpoint: true };
        let refused = stopped.check(Control::Stop).expect_err("a stop when stopped");
        assert_eq!(
            refused.to_string(),
            "the session is stopped and cannot stop; possible now: resume, reset"
        );
    }
}
