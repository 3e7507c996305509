//! Taking a control step.

use std::sync::Arc;

use super::{Actor, ControlError, Until};
use crate::store::LogRecord;
use crate::wire::{Session, State, Trial, TrialEndView};

impl Actor {
    /// One control step into the log and the snapshot.
    pub(super) fn take_tick(&mut self) -> Result<(), ControlError> {
        let (Some(run), Some(log)) = (&mut self.run, &self.log) else { return Ok(()) };
        let stepped = run.step();
        self.paths.follow(&stepped.tick);
        self.session.tick = stepped.tick.tick;
        self.tick = Some(Arc::new(stepped.tick.clone()));
        log.write(LogRecord::Tick(Box::new(stepped.tick)))?;
        match stepped.end {
            Some(end) => self.end_trial(end),
            None => Ok(()),
        }
    }

    pub(super) fn end_trial(&mut self, end: TrialEndView) -> Result<(), ControlError> {
        let trial = end.trial.clone();
        self.paths.end_trial(trial.record);
        self.session.add(&trial);
        self.say("trial", &trial_text(&trial));
        if let (Some(run), Some(log)) = (&self.run, &self.log) {
            log.write(LogRecord::TrialEnd(Box::new(end)))?;
            if let Some(checkpoint) = run.checkpoint() {
                log.write(checkpoint)?;
                self.condition.checkpoint = true;
            }
        }
        self.untold_trials.push(trial);
        if self.session.trials_done >= self.session.trials {
            self.say("session", "Finished");
            return self.settle(State::Finished, None);
        }
        if self.until == Until::TrialEnd && self.condition.state == State::Running {
            return self.hold();
        }
        Ok(())
    }
}

fn trial_text(trial: &Trial) -> String {
    let Trial { trial: number, steps, total_reinforcement, .. } = trial;
    if trial.reached_goal {
        let record = if trial.record { ", the best so far" } else { "" };
        format!(
            "Trial {number} reached the goal in {steps} steps, R = {total_reinforcement:.2}{record}"
        )
    } else {
        format!("Trial {number} ended without the goal after {steps} steps")
    }
}

impl Session {
    /// Counts a trial that ended.
    pub(super) fn add(&mut self, trial: &Trial) {
        self.trials_done = trial.trial;
        if trial.reached_goal {
            self.reached += 1;
            let best = self
                .best
                .map_or(trial.total_reinforcement, |best| best.max(trial.total_reinforcement));
            self.best = Some(best);
        }
    }

    /// Counts all trials anew.
    pub(in crate::session) fn count<'a>(&mut self, trials: impl IntoIterator<Item = &'a Trial>) {
        (self.trials_done, self.reached, self.best) = (0, 0, None);
        for trial in trials {
            self.add(trial);
        }
    }
}
