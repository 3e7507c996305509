//! Taking a step.

use std::time::{Duration, Instant};

use super::{Actor, ControlError, Until};
use crate::wire::{
    DriveOutcome, DriveRunView, EpisodeView, OutcomeOfEpisode, Round, Session, State, Trial,
};

/// Least time between two checkpoints within a round.
const CHECKPOINT_EVERY: Duration = Duration::from_millis(500);

impl Actor {
    /// One step into the log and the snapshot.
    pub(super) fn take_tick(&mut self) -> Result<(), ControlError> {
        let (Some(run), Some(log)) = (&mut self.run, &self.log) else { return Ok(()) };
        let stepped = run.step();
        self.present.follow(&stepped);
        self.session.tick = stepped.number();
        let round = stepped.round();
        if let Some(round) = &round {
            self.session.add(round);
        }
        for record in stepped.records() {
            log.write(record)?;
        }
        match round {
            Some(round) => self.end_round(round),
            None => self.keep_when_due(),
        }
    }

    fn end_round(&mut self, round: Round) -> Result<(), ControlError> {
        self.say("trial", &round_text(&round));
        self.keep()?;
        self.untold_rounds.push(round);
        if self.session.rounds_done >= self.session.rounds {
            self.say("session", "Finished");
            return self.settle(State::Finished, None);
        }
        if self.until == Until::TrialEnd && self.condition.state == State::Running {
            return self.hold();
        }
        Ok(())
    }

    /// A checkpoint now and then, within a round that has trials of its own.
    fn keep_when_due(&mut self) -> Result<(), ControlError> {
        if self.checkpointed.elapsed() < CHECKPOINT_EVERY {
            return Ok(());
        }
        self.keep()
    }

    /// A checkpoint, if the machine can give one now.
    fn keep(&mut self) -> Result<(), ControlError> {
        let (Some(run), Some(log)) = (&self.run, &self.log) else { return Ok(()) };
        if let Some(checkpoint) = run.checkpoint() {
            log.write(checkpoint)?;
            self.condition.checkpoint = true;
            self.checkpointed = Instant::now();
        }
        Ok(())
    }
}

fn round_text(round: &Round) -> String {
    match round {
        Round::Trial(trial) => trial_text(trial),
        Round::Episode(episode) => episode_text(episode),
        Round::Run(run) => run_text(run),
    }
}

fn run_text(run: &DriveRunView) -> String {
    let DriveRunView { run: number, method, cycles, .. } = run;
    match &run.outcome {
        DriveOutcome::Approach { .. } => {
            format!("Run {number} ended at the wall after {cycles} cycles")
        }
        DriveOutcome::Drive(score) => {
            let end = match (score.done, score.blind) {
                (true, _) => "reached the end".to_owned(),
                (false, Some(region)) => format!("stopped: no sonar of region {region} answers"),
                (false, None) => format!("ended {:.1} m on", score.progress_m),
            };
            let contacts = score.wall_contacts
                + score.door_contacts
                + score.block_contacts
                + score.people_contacts;
            format!(
                "Run {number}, {method}: {end} after {:.0} s, contacts {contacts}",
                score.time_s
            )
        }
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

fn episode_text(episode: &EpisodeView) -> String {
    let EpisodeView { episode: number, entrant, training, .. } = episode;
    let training = if *training { ", training" } else { "" };
    match &episode.outcome {
        OutcomeOfEpisode::Walk { index, capped, .. } => {
            let capped = match capped {
                0 => String::new(),
                capped => format!(", {capped} trials broken off at the cap"),
            };
            format!("Episode {number}, {entrant}{training}: {index:.2} actions a trial{capped}")
        }
        OutcomeOfEpisode::Pull { regret, .. } => {
            format!("Episode {number}, {entrant}: regret {regret:.1}")
        }
        OutcomeOfEpisode::Plot { points } => format!("All {} points are computed", points.len()),
    }
}

impl Session {
    /// Counts a round that ended.
    pub(super) fn add(&mut self, round: &Round) {
        self.rounds_done = round.number();
        match round {
            Round::Trial(trial) => {
                self.trials_done = trial.trial;
                if trial.reached_goal {
                    self.reached += 1;
                    let best = self.best.map_or(trial.total_reinforcement, |best| {
                        best.max(trial.total_reinforcement)
                    });
                    self.best = Some(best);
                }
            }
            Round::Run(run) => {
                self.trials_done = run.round;
                self.reached +=
                    u32::from(matches!(&run.outcome, DriveOutcome::Drive(of) if of.done));
            }
            Round::Episode(episode) => {
                if let OutcomeOfEpisode::Walk { trials, capped, .. } = &episode.outcome {
                    let done = u32::try_from(trials.len()).unwrap_or(u32::MAX);
                    self.trials_done = self.trials_done.saturating_add(done);
                    self.reached = self.reached.saturating_add(done.saturating_sub(*capped));
                }
            }
        }
    }

    /// Counts all rounds anew.
    pub(in crate::session) fn count<'a>(&mut self, rounds: impl IntoIterator<Item = &'a Round>) {
        (self.trials_done, self.rounds_done, self.reached, self.best) = (0, 0, 0, None);
        for round in rounds {
            self.add(round);
        }
    }
}
