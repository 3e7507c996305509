//! The experiment `continual`, section 4.10: train, move the goal, and compare with learning from scratch.

use super::contest::{Contest, ContestCheckpoint, Entrant};
use super::labyrinth::ContestError;
use crate::labyrinth::{
    Bias, ContinualRule, EpisodeRule, Labyrinth, LabyrinthError, Readings, STATES, matrix,
    walk_setup,
};
use crate::tabular::{Anneal, Exclusion, Transport, WalkSetup};

crate::settings! {
    /// Settings of the experiment `continual`.
    pub struct ContinualSettings {
        start: u32 = 7, "start" [0.0, 15.0] "", Literal, "section 4.10", "State every trial starts in";
        goal: u32 = 15, "goal" [0.0, 15.0] "", Literal, "section 4.10", "Goal that is trained for";
        new_goal: u32 = 2, "new_goal" [0.0, 15.0] "", Literal, "section 4.10", "Goal that it moves to";
        all_goals: bool = false, "all_goals" "", Literal, "section 4.10", "Move it to every state but the start and the first goal, one after the other";
        episodes: u32 = 10, "episodes" [1.0, 100_000.0] "", Literal, "section 4.9", "Episodes, each begun with nothing learned; every competitor does each";
        trials: u32 = 100, "trials" [1.0, 10_000.0] "", Literal, "section 4.9", "Trials of each task";
        cap: u32 = 300, "trial.step_cap" [1.0, 1_000_000.0] "", Simulation, "reading", "Actions after which a trial is broken off";
        rate: f64 = 0.9, "learner.rate" [0.0, 1.0] "", Literal, "table 4.2, β", "Learning rate";
        discount: f64 = 1.0, "learner.discount" [0.0, 1.0] "", Literal, "table 4.2, γ", "Discount";
        transport: Transport = Transport::StartState, "learner.transport" "", Reading, "section 4.4", "What is learned at the goal, from where the robot is transported back to the start";
        first: f64 = 30.0, "exploration.first" [0.001, 1000.0] "", Gap, "Eq. (4.11), τ; fitted", "Temperature of the first trial";
        least: f64 = 0.05, "exploration.least" [0.001, 1000.0] "", Gap, "Eq. (4.11), τ; fitted", "Temperature it falls to";
        keep: f64 = 0.95, "exploration.keep" [0.0, 1.0] "", Gap, "Eq. (5.17), β; fitted", "Share of the distance to it that is kept from trial to trial";
        restart: bool = true, "exploration.restart" "", Gap, "section 4.10", "The temperature begins anew with the new goal; off: it stays at its least";
    }
}

impl ContinualSettings {
    /// The rule, for [`crate::labyrinth::continual`].
    #[must_use]
    pub fn rule(&self) -> ContinualRule {
        let episode = EpisodeRule {
            rate: self.rate,
            discount: self.discount,
            anneal: Anneal { first: self.first, least: self.least, keep: self.keep },
            transport: self.transport,
            exclusion: Exclusion::Strict,
            trials: self.trials,
            cap: self.cap,
        };
        ContinualRule { episode, restart: self.restart }
    }

    /// The goals that it moves to.
    #[must_use]
    pub fn new_goals(&self) -> Vec<usize> {
        if !self.all_goals {
            return vec![self.new_goal as usize];
        }
        let taken = [self.start as usize, self.goal as usize];
        (0..STATES).filter(|state| !taken.contains(state)).collect()
    }

    /// Two entrants a goal: from scratch, and continual, which is compared with it.
    ///
    /// # Errors
    /// When a goal is the start.
    pub fn entrants(&self) -> Result<Vec<Entrant>, ContestError> {
        let rule = self.rule();
        let first = self.setup(self.goal as usize, &rule.episode)?;
        let mut entrants = Vec::new();
        for goal in self.new_goals() {
            let setup = self.setup(goal, &rule.episode)?;
            let mut later = setup.clone();
            if !self.restart {
                later.exploration.anneal.first = self.least;
            }
            let reference = entrants.len();
            entrants.push(Entrant {
                name: format!("scratch, goal {goal}"),
                setup,
                training: None,
                reference,
            });
            entrants.push(Entrant {
                name: format!("continual, goal {goal}"),
                setup: later,
                training: Some(first.clone()),
                reference,
            });
        }
        Ok(entrants)
    }

    /// The world with its first goal.
    ///
    /// # Errors
    /// When start and goal are the same.
    pub fn labyrinth(&self) -> Result<Labyrinth, LabyrinthError> {
        Labyrinth::new(self.start as usize, self.goal as usize)
    }

    fn setup(&self, goal: usize, rule: &EpisodeRule) -> Result<WalkSetup, ContestError> {
        let labyrinth = Labyrinth::new(self.start as usize, goal)?;
        let unbiased = matrix(Bias::B0, goal, &Readings::default());
        walk_setup(&labyrinth, &unbiased, rule)
            .map_err(|error| ContestError::Belief { name: "B0".into(), error })
    }

    /// The experiment from its beginning.
    ///
    /// # Errors
    /// See [`Self::entrants`].
    pub fn contest(&self, seed: u64) -> Result<Contest, ContestError> {
        Ok(Contest::new(self.entrants()?, self.trials, seed)?)
    }

    /// The experiment after a checkpoint.
    ///
    /// # Errors
    /// See [`Self::entrants`]; and when the checkpoint is of other settings.
    pub fn resume(
        &self,
        seed: u64,
        checkpoint: &ContestCheckpoint,
    ) -> Result<Contest, ContestError> {
        Ok(Contest::resume(self.entrants()?, self.trials, seed, checkpoint)?)
    }
}
