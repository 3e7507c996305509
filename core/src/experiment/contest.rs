//! Learners with different biases on one task, episode by episode, scored with one index.

use serde::{Deserialize, Serialize};

use crate::labyrinth::{Episode, Gain, TRAINING_STREAMS, gain};
use crate::stats::Estimate;
use crate::tabular::{Trial, Walk, WalkError, WalkMemory, WalkSetup, WalkStep};

/// One learner with its biases.
#[derive(Clone, Debug)]
pub struct Entrant {
    /// Its name.
    pub name: String,
    /// What it is run with.
    pub setup: WalkSetup,
    /// A task that it learns before; what it learned there it keeps.
    pub training: Option<WalkSetup>,
    /// Entrant that it is compared with, by number; itself if with none.
    pub reference: usize,
}

/// Which part of an entrant's episode runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Phase {
    /// The task it trains on.
    Training,
    /// The task it is scored in.
    Task,
}

/// Where a contest stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Position {
    /// Episode, from 1.
    pub episode: u32,
    /// Entrant, by number.
    pub entrant: usize,
    /// Part of its episode.
    pub phase: Phase,
}

/// One step of one entrant.
#[derive(Clone, Debug, PartialEq)]
pub struct ContestStep {
    /// Step of the contest, from 1.
    pub tick: u64,
    /// Where in the contest.
    pub position: Position,
    /// The step.
    pub step: WalkStep,
    /// The trial that ended with it.
    pub trial: Option<Trial>,
}

/// One entrant's episode.
#[derive(Clone, Debug, PartialEq)]
pub struct EpisodeEnd {
    /// Where in the contest.
    pub position: Position,
    /// Actions of each trial.
    pub episode: Episode,
    /// J, Eq. (4.12).
    pub index: f64,
}

/// Everything needed to go on between trials.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ContestCheckpoint {
    position: Position,
    ticks: u64,
    memory: Option<WalkMemory>,
    current: Episode,
    done: Vec<Vec<Episode>>,
}

impl ContestCheckpoint {
    /// Where the contest stands; at an episode that has ended until the next begins.
    #[must_use]
    pub fn position(&self) -> Position {
        self.position
    }

    /// Steps done.
    #[must_use]
    pub fn ticks(&self) -> u64 {
        self.ticks
    }
}

/// How an entrant did so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Score {
    /// Its name.
    pub name: String,
    /// Name of the one it is compared with; none if with none.
    pub reference: Option<String>,
    /// J with its 95 % interval; none of fewer than two episodes.
    pub index: Option<Estimate>,
    /// Eq. (4.13), percent, from the episodes that both have done; none before the first.
    pub gain: Option<f64>,
    /// The same with its spread over experiments of ten episodes; none of fewer than two of them.
    pub spread: Option<Gain>,
    /// Mean actions of the last tenth of the trials: the final policy's.
    pub last: Option<f64>,
    /// Trials that were broken off at the limit.
    pub capped: u32,
    /// Pairs of state and action that it may try.
    pub search_space: usize,
}

/// A contest as a state machine.
#[derive(Debug)]
pub struct Contest {
    entrants: Vec<Entrant>,
    trials: u32,
    seed: u64,
    position: Position,
    ticks: u64,
    walk: Walk,
    current: Episode,
    done: Vec<Vec<Episode>>,
    step: Option<ContestStep>,
    end: Option<EpisodeEnd>,
}

impl Contest {
    /// A new contest of at least one entrant, with so many trials an episode.
    ///
    /// # Errors
    /// When an entrant's setup contradicts itself.
    ///
    /// # Panics
    /// When there is no entrant or no trial.
    pub fn new(entrants: Vec<Entrant>, trials: u32, seed: u64) -> Result<Self, WalkError> {
        assert!(!entrants.is_empty() && trials > 0, "someone must do something");
        let position = first_phase(&entrants, 1, 0);
        let walk = fresh(&entrants, position, trials, seed)?;
        // Every setup is tried now, so that a contradiction is not found after hours.
        for (entrant, of) in entrants.iter().enumerate() {
            fresh(&entrants, first_phase(&entrants, 1, entrant), trials, seed)?;
            Walk::new(of.setup.clone(), seed, 0)?;
        }
        let done = vec![Vec::new(); entrants.len()];
        let current = Episode { steps: Vec::new(), capped: 0 };
        Ok(Self {
            entrants,
            trials,
            seed,
            position,
            ticks: 0,
            walk,
            current,
            done,
            step: None,
            end: None,
        })
    }

    /// Goes on after a checkpoint, to the same bits.
    ///
    /// # Errors
    /// When a setup contradicts itself or the checkpoint is of other entrants.
    pub fn resume(
        entrants: Vec<Entrant>,
        trials: u32,
        seed: u64,
        checkpoint: &ContestCheckpoint,
    ) -> Result<Self, WalkError> {
        let mut contest = Self::new(entrants, trials, seed)?;
        let ContestCheckpoint { position, ticks, memory, current, done } = checkpoint.clone();
        if done.len() != contest.entrants.len() || position.entrant >= done.len() {
            return Err(WalkError::OtherWorld);
        }
        contest.walk = match memory {
            Some(memory) => {
                let setup = setup(&contest.entrants, position).clone();
                Walk::resume(setup, seed, first_stream(position, trials), memory)?
            }
            None => fresh(&contest.entrants, position, trials, seed)?,
        };
        Ok(Self { position, ticks, current, done, ..contest })
    }

    /// One step of the entrant whose turn it is. The second part is there when its episode ended with it.
    ///
    /// # Panics
    /// Never: what could go wrong was tried at the start.
    pub fn step(&mut self) -> (&ContestStep, Option<&EpisodeEnd>) {
        self.begin();
        let (step, trial) = self.walk.step();
        let (step, trial) = (step.clone(), trial.cloned());
        self.ticks += 1;
        self.end = trial.as_ref().and_then(|trial| self.count(trial));
        let step = ContestStep { tick: self.ticks, position: self.position, step, trial };
        (self.step.insert(step), self.end.as_ref())
    }

    /// Gives the turn to the next entrant, if an episode has ended. The first step after it does so by itself;
    /// until then the tables of the episode that ended can be looked at.
    ///
    /// # Panics
    /// Never: what could go wrong was tried at the start.
    pub fn begin(&mut self) {
        if self.walk.trials_done() >= self.trials {
            self.turn().expect("every setup was tried at the start");
        }
    }

    /// Takes in a trial; the end of the episode, if it was its last.
    fn count(&mut self, trial: &Trial) -> Option<EpisodeEnd> {
        self.current.steps.push(trial.steps);
        self.current.capped += u32::from(!trial.reached_end);
        if trial.trial < self.trials {
            return None;
        }
        let episode =
            std::mem::replace(&mut self.current, Episode { steps: Vec::new(), capped: 0 });
        if self.position.phase == Phase::Task {
            self.done[self.position.entrant].push(episode.clone());
        }
        Some(EpisodeEnd { position: self.position, index: episode.index(), episode })
    }

    /// Gives the turn to the next phase, entrant or episode.
    fn turn(&mut self) -> Result<(), WalkError> {
        let Position { episode, entrant, phase } = self.position;
        if phase == Phase::Training {
            self.position.phase = Phase::Task;
            let setup = setup(&self.entrants, self.position).clone();
            let memory = self.walk.memory().cloned().ok_or(WalkError::UnderWay)?;
            let stream = first_stream(self.position, self.trials);
            self.walk = Walk::moved(setup, self.seed, stream, memory)?;
            return Ok(());
        }
        let next = entrant + 1;
        self.position = if next < self.entrants.len() {
            first_phase(&self.entrants, episode, next)
        } else {
            first_phase(&self.entrants, episode + 1, 0)
        };
        self.walk = fresh(&self.entrants, self.position, self.trials, self.seed)?;
        Ok(())
    }

    /// State after the last finished trial; none while one is under way.
    #[must_use]
    pub fn checkpoint(&self) -> Option<ContestCheckpoint> {
        let memory = self.walk.memory()?.clone();
        Some(ContestCheckpoint {
            position: self.position,
            ticks: self.ticks,
            memory: Some(memory),
            current: self.current.clone(),
            done: self.done.clone(),
        })
    }

    /// Episodes that every entrant has done.
    #[must_use]
    pub fn episodes_done(&self) -> u32 {
        let least = self.done.iter().map(Vec::len).min().unwrap_or(0);
        u32::try_from(least).unwrap_or(u32::MAX)
    }

    /// Steps done.
    #[must_use]
    pub fn ticks(&self) -> u64 {
        self.ticks
    }

    /// Where the contest stands; at an episode that has ended until the next begins.
    #[must_use]
    pub fn position(&self) -> Position {
        self.position
    }

    /// Trials of an episode.
    #[must_use]
    pub fn trials(&self) -> u32 {
        self.trials
    }

    /// The entrants.
    #[must_use]
    pub fn entrants(&self) -> &[Entrant] {
        &self.entrants
    }

    /// The walk of the entrant whose turn it is.
    #[must_use]
    pub fn walk(&self) -> &Walk {
        &self.walk
    }

    /// The same, to give advice, load or edit a table; it holds until the end of the episode.
    pub fn walk_mut(&mut self) -> &mut Walk {
        &mut self.walk
    }

    /// Episodes done by an entrant.
    #[must_use]
    pub fn episodes(&self, entrant: usize) -> &[Episode] {
        &self.done[entrant]
    }

    /// Learning curve of an entrant: mean actions of each trial over its episodes, with the 95 % interval.
    /// Empty of fewer than two episodes.
    #[must_use]
    pub fn curve(&self, entrant: usize) -> Vec<Estimate> {
        let of_trial = |trial: usize| {
            let steps = self.done[entrant].iter().map(|episode| f64::from(episode.steps[trial]));
            Estimate::mean(&steps.collect::<Vec<f64>>())
        };
        (0..self.trials as usize).filter_map(of_trial).collect()
    }

    /// How all did so far, in their order.
    #[must_use]
    pub fn scores(&self) -> Vec<Score> {
        (0..self.entrants.len()).map(|entrant| self.score(entrant)).collect()
    }

    fn score(&self, entrant: usize) -> Score {
        let of = &self.entrants[entrant];
        let compared = of.reference != entrant;
        let (mine, theirs) = (&self.done[entrant], &self.done[of.reference]);
        let both = mine.len().min(theirs.len());
        let indices: Vec<f64> = mine.iter().map(Episode::index).collect();
        let last = (self.trials as usize).div_ceil(10);
        let lasts: Vec<f64> = mine.iter().map(|episode| episode.tail(last)).collect();
        let sum = |episodes: &[Episode]| episodes.iter().map(Episode::index).sum::<f64>();
        // Eq. (4.13): r = 1 − J(B_i)/J(B_0)
        let share = || 100.0 * (1.0 - sum(&mine[..both]) / sum(&theirs[..both]));
        Score {
            name: of.name.clone(),
            reference: compared.then(|| self.entrants[of.reference].name.clone()),
            index: Estimate::mean(&indices),
            gain: (compared && both > 0).then(share),
            spread: if compared { gain(mine, theirs) } else { None },
            last: crate::stats::mean(&lasts),
            capped: mine.iter().map(|episode| episode.capped).sum(),
            search_space: of.setup.search_space(),
        }
    }
}

fn first_phase(entrants: &[Entrant], episode: u32, entrant: usize) -> Position {
    let phase = if entrants[entrant].training.is_some() { Phase::Training } else { Phase::Task };
    Position { episode, entrant, phase }
}

fn setup(entrants: &[Entrant], position: Position) -> &WalkSetup {
    let entrant = &entrants[position.entrant];
    match (position.phase, &entrant.training) {
        (Phase::Training, Some(training)) => training,
        _ => &entrant.setup,
    }
}

/// All entrants draw the same numbers in the same episode; training and task never do.
fn first_stream(position: Position, trials: u32) -> u32 {
    let part = match position.phase {
        Phase::Task => 0,
        Phase::Training => TRAINING_STREAMS,
    };
    (position.episode - 1).wrapping_mul(trials).wrapping_add(part)
}

fn fresh(
    entrants: &[Entrant],
    position: Position,
    trials: u32,
    seed: u64,
) -> Result<Walk, WalkError> {
    Walk::new(setup(entrants, position).clone(), seed, first_stream(position, trials))
}
