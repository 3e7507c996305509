//! The experiment `labyrinth` of chapter 4: what each bias is worth, section 4.9 and table 4.3.

use std::sync::Arc;

use super::contest::{Contest, ContestCheckpoint, Entrant};
use super::tabular_bias::Biases;
use crate::labyrinth::{
    Bias, EnvironmentRule, EpisodeRule, GoalActions, InsightRule, Labyrinth, LabyrinthError,
    Readings, matrix, walk_setup,
};
use crate::tabular::{
    AdvisorRule, Anneal, AnyWorld, Belief, BeliefError, Exclusion, Explorer, LearnerKind,
    LearnerRule, ModelKind, Transport, WalkError, WalkSetup, World,
};

crate::settings! {
    /// Settings of the experiment `labyrinth`.
    pub struct LabyrinthSettings {
        start: u32 = 7, "start" [0.0, 15.0] "", Literal, "section 4.9", "State every trial starts in";
        goal: u32 = 15, "goal" [0.0, 15.0] "", Literal, "section 4.9", "State that ends a trial";
        episodes: u32 = 10, "episodes" [1.0, 100_000.0] "", Literal, "table 4.3", "Episodes, each begun with nothing learned; every competitor does each";
        trials: u32 = 100, "trials" [1.0, 10_000.0] "", Literal, "section 4.9", "Trials an episode";
        cap: u32 = 10_000, "trial.step_cap" [1.0, 1_000_000.0] "", Simulation, "reading", "Actions after which a trial is broken off";
        rate: f64 = 0.9, "learner.rate" [0.0, 1.0] "", Literal, "table 4.2, β", "Learning rate";
        discount: f64 = 1.0, "learner.discount" [0.0, 1.0] "", Literal, "table 4.2, γ", "Discount";
        transport: Transport = Transport::StartState, "learner.transport" "", Reading, "section 4.4", "What is learned at the goal, from where the robot is transported back to the start";
        kind: LearnerKind = LearnerKind::Q, "learner.kind" "", Literal, "section 4.7", "Which learner";
        actor_rate: f64 = 0.5, "learner.actor_rate" [0.0, 10.0] "", Gap, "Algorithm 5", "Learning rate of the actor (ahc)";
        lambda: f64 = 0.7, "learner.lambda" [0.0, 1.0] "", Gap, "Eq. (3.20), λ", "Decay of the eligibility (ahc)";
        planning: u32 = 5, "learner.planning" [0.0, 1000.0] "", Gap, "Algorithm 7, n", "Planning steps a real step (dyna, sweeping)";
        explorer: Explorer = Explorer::Softmax, "exploration.rule" "", Literal, "section 4.8", "How actions are chosen";
        first: f64 = 30.0, "exploration.first" [0.001, 1000.0] "", Gap, "Eq. (4.11), τ; fitted", "Temperature (or ε) of the first trial";
        least: f64 = 0.05, "exploration.least" [0.001, 1000.0] "", Gap, "Eq. (4.11), τ; fitted", "Temperature (or ε) it falls to";
        keep: f64 = 0.95, "exploration.keep" [0.0, 1.0] "", Gap, "Eq. (5.17), β; fitted", "Share of the distance to it that is kept from trial to trial";
        exclusion: Exclusion = Exclusion::Strict, "belief.exclusion" "", Reading, "section 4.5", "What beliefs do";
        b10: bool = true, "bias.b10" "", Literal, "section 4.6", "B10, environment: collisions left out";
        b11: bool = true, "bias.b11" "", Literal, "section 4.6", "B11, environment: and less preference for what may collide next";
        b2: bool = true, "bias.b2" "", Literal, "section 4.6", "B2, insight: one of two ways to turn round left out";
        b30: bool = true, "bias.b30" "", Literal, "section 4.6", "B30, goal: near vector fields supplied";
        b31: bool = true, "bias.b31" "", Literal, "section 4.6", "B31, goal: far vector fields supplied";
        environment: EnvironmentRule = EnvironmentRule::Figure, "belief.environment" "", Reading, "figure 4.7 (c)", "Where B11 lowers a belief";
        lowered: f64 = 0.5, "belief.lowered" [0.0, 1.0] "", Literal, "figure 4.7 (c)", "Belief that B11 gives to potential consequences";
        insight: InsightRule = InsightRule::GoalDirected, "belief.insight" "", Reading, "figure 4.8", "Which half turns B2 leaves out";
        goal_actions: GoalActions = GoalActions::Both, "belief.goal_actions" "", Reading, "figure 4.9", "What B30 and B31 leave where two actions are equally good";
        reflex: bool = false, "bias.reflex" "", Addition, "section 4.3", "Reflex: forward if free, else left, where experience is lacking";
        reflex_strength: f64 = 4.0, "reflex.strength" [0.0, 20.0] "", Addition, "section 4.3", "Log-odds that the reflex adds to its action in a state never met";
        reflex_half_life: f64 = 10.0, "reflex.half_life" [0.1, 1e6] "", Addition, "section 4.3", "Visits after which half of that is left";
        advice: bool = false, "bias.advice" "", Addition, "section 4.3", "Advice in words";
        advice_strength: f64 = 2.0, "advice.strength" [0.0, 20.0] "", Addition, "section 4.3", "Log-odds that a rule adds to its action at first";
        advice_half_life: f64 = 10.0, "advice.half_life" [0.1, 1e6] "", Addition, "section 4.3", "Trials of an action after which half of that is left";
        advice_refinement: f64 = 0.1, "advice.refinement" [0.0, 0.9] "", Addition, "section 4.3", "Share by which a rule's weight changes after a trial";
        advice_patience: u32 = 5, "advice.patience" [1.0, 100_000.0] "", Addition, "section 4.3", "Times a rule is followed, and not followed, before it is judged";
        heterogeneous: bool = false, "bias.heterogeneous" "", Addition, "section 4.3", "Heterogeneous rewards: for facing and reaching the goal's cell, against walls";
        subgoal_reward: f64 = 0.5, "reward.subgoal" [-100.0, 100.0] "", Addition, "section 4.3", "Reward of the first arrival in a subgoal";
        bump_reward: f64 = -0.1, "reward.bump" [-100.0, 100.0] "", Addition, "section 4.3", "Reward of an action that changes nothing";
        progress: bool = false, "bias.progress" "", Addition, "section 4.3", "Progress estimator: reward for every step of the estimated way";
        progress_reward: f64 = 0.2, "reward.progress" [-100.0, 100.0] "", Addition, "section 4.3", "Reward of one step of it";
        modules: bool = false, "bias.modules" "", Addition, "section 4.3", "Modularisation: three behaviours behind a gate";
    }
}

/// What cannot be a setting: words and tables.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LabyrinthExtras {
    /// Advice, when `bias.advice` is on.
    pub advice: String,
    /// A belief matrix of one's own, which then competes too.
    pub matrix: Option<Vec<Vec<f64>>>,
    /// Q-values that the matrix's learner begins with; without them it begins with the matrix.
    pub table: Option<Vec<Vec<f64>>>,
}

/// Why the experiment cannot be run.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ContestError {
    /// Start and goal.
    #[error(transparent)]
    Labyrinth(#[from] LabyrinthError),
    /// A belief matrix.
    #[error("{name}: {error}")]
    Belief {
        /// Whose.
        name: String,
        /// What is wrong.
        error: BeliefError,
    },
    /// An entrant's setup.
    #[error(transparent)]
    Walk(#[from] WalkError),
}

impl LabyrinthSettings {
    /// The rule of episodes, for [`crate::labyrinth::episodes`].
    #[must_use]
    pub fn rule(&self) -> EpisodeRule {
        EpisodeRule {
            rate: self.rate,
            discount: self.discount,
            anneal: Anneal { first: self.first, least: self.least, keep: self.keep },
            transport: self.transport,
            exclusion: self.exclusion,
            trials: self.trials,
            cap: self.cap,
        }
    }

    /// How the definitions of the matrices are read.
    #[must_use]
    pub fn readings(&self) -> Readings {
        Readings {
            environment: self.environment,
            lowered: self.lowered,
            insight: self.insight,
            goal: self.goal_actions,
        }
    }

    /// The world.
    ///
    /// # Errors
    /// When start and goal are the same.
    pub fn labyrinth(&self) -> Result<Labyrinth, LabyrinthError> {
        Labyrinth::new(self.start as usize, self.goal as usize)
    }

    fn biases(&self) -> Biases {
        Biases {
            reflex: self.reflex.then_some((self.reflex_strength, self.reflex_half_life)),
            advice: self.advice,
            heterogeneous: self.heterogeneous.then_some((self.subgoal_reward, self.bump_reward)),
            progress: self.progress.then_some(self.progress_reward),
            modules: self.modules,
            advisor: AdvisorRule {
                strength: self.advice_strength,
                half_life: self.advice_half_life,
                refinement: self.advice_refinement,
                patience: self.advice_patience,
            },
        }
    }

    /// All entrants: the unbiased learner first, with which the others are compared.
    ///
    /// # Errors
    /// Names the matrix, the character of the advice or the setting that is wrong.
    pub fn entrants(&self, extras: &LabyrinthExtras) -> Result<Vec<Entrant>, ContestError> {
        let labyrinth = self.labyrinth()?;
        let base = self.setup(&labyrinth, Bias::B0)?;
        let on = [true, self.b10, self.b11, self.b2, self.b30, self.b31];
        let mut entrants = Vec::new();
        for (bias, _) in Bias::ALL.into_iter().zip(on).filter(|(_, on)| *on) {
            let setup = self.setup(&labyrinth, bias)?;
            entrants.push(Entrant {
                name: bias.name().into(),
                setup,
                training: None,
                reference: 0,
            });
        }
        entrants.extend(self.biases().entrants(&base, &extras.advice, 0)?);
        if let Some(matrix) = &extras.matrix {
            let name = "own matrix";
            let mut belief =
                Belief::new(matrix, self.exclusion, labyrinth.mdp(), labyrinth.start())
                    .map_err(|error| ContestError::Belief { name: name.into(), error })?;
            if let Some(table) = &extras.table {
                crate::tabular::check_table(
                    table,
                    labyrinth.mdp().states(),
                    labyrinth.mdp().actions(),
                )
                .map_err(WalkError::from)?;
                belief.initial.clone_from(table);
            }
            let setup = WalkSetup { belief, ..base };
            entrants.push(Entrant { name: name.into(), setup, training: None, reference: 0 });
        }
        Ok(entrants)
    }

    fn setup(&self, labyrinth: &Labyrinth, bias: Bias) -> Result<WalkSetup, ContestError> {
        let matrix = matrix(bias, labyrinth.goal(), &self.readings());
        let name = bias.name().to_owned();
        let mut setup = walk_setup(labyrinth, &matrix, &self.rule())
            .map_err(|error| ContestError::Belief { name, error })?;
        setup.rule = LearnerRule {
            kind: self.kind,
            actor_rate: self.actor_rate,
            lambda: self.lambda,
            planning: self.planning,
            model: ModelKind::Last,
            ..setup.rule
        };
        setup.exploration.explorer = self.explorer;
        setup.world = Arc::new(AnyWorld::Labyrinth(labyrinth.clone()));
        Ok(setup)
    }

    /// The experiment from its beginning.
    ///
    /// # Errors
    /// See [`Self::entrants`].
    pub fn contest(&self, extras: &LabyrinthExtras, seed: u64) -> Result<Contest, ContestError> {
        Ok(Contest::new(self.entrants(extras)?, self.trials, seed)?)
    }

    /// The experiment after a checkpoint.
    ///
    /// # Errors
    /// See [`Self::entrants`]; and when the checkpoint is of other settings.
    pub fn resume(
        &self,
        extras: &LabyrinthExtras,
        seed: u64,
        checkpoint: &ContestCheckpoint,
    ) -> Result<Contest, ContestError> {
        Ok(Contest::resume(self.entrants(extras)?, self.trials, seed, checkpoint)?)
    }
}
