//! The experiment `gridworld`: the learners of chapter 3 and the biases of section 4.3 in a maze or any
//! other tabular world.

use std::sync::Arc;

use super::contest::{Contest, ContestCheckpoint, Entrant};
use super::labyrinth::ContestError;
use super::tabular_bias::Biases;
use crate::tabular::{
    AdvisorRule, Anneal, AnyWorld, Belief, Exploration, Explorer, LearnerKind, LearnerRule,
    ModelKind, Shaping, Transport, WalkSetup, World,
};

crate::choice! {
    /// Which learners compete.
    pub enum Learners {
        One = "one": "the one that `learner.kind` names",
        All = "all": "all four, each compared with Q-learning",
    }
}

crate::settings! {
    /// Settings of the experiment `gridworld`.
    pub struct GridworldSettings {
        episodes: u32 = 10, "episodes" [1.0, 100_000.0] "", Gap, "chapter 3", "Episodes, each begun with nothing learned; every competitor does each";
        trials: u32 = 50, "trials" [1.0, 10_000.0] "", Gap, "chapter 3", "Trials an episode";
        cap: u32 = 10_000, "trial.step_cap" [1.0, 1_000_000.0] "", Simulation, "reading", "Actions after which a trial is broken off";
        learners: Learners = Learners::One, "learners" "", Addition, "chapter 3", "Which learners compete";
        kind: LearnerKind = LearnerKind::Q, "learner.kind" "", Gap, "sections 3.6 and 3.7", "Which learner";
        rate: f64 = 0.5, "learner.rate" [0.0, 1.0] "", Gap, "Algorithms 5 and 6, β and α", "Learning rate";
        discount: f64 = 0.95, "learner.discount" [0.0, 1.0] "", Gap, "Eq. (3.15), γ", "Discount";
        actor_rate: f64 = 0.5, "learner.actor_rate" [0.0, 10.0] "", Gap, "Algorithm 5", "Learning rate of the actor (ahc)";
        lambda: f64 = 0.7, "learner.lambda" [0.0, 1.0] "", Gap, "Eq. (3.20), λ", "Decay of the eligibility (ahc)";
        planning: u32 = 5, "learner.planning" [0.0, 1000.0] "", Gap, "Algorithm 7, n", "Planning steps a real step (dyna, sweeping)";
        model: ModelKind = ModelKind::Counts, "learner.model" "", Gap, "section 3.7", "What a learned model keeps (dyna, sweeping)";
        priority_cap: f64 = 1.0, "learner.priority_cap" [1e-6, 1e9] "", Gap, "Eq. (3.24), Δ_max", "Greatest priority (sweeping)";
        priority_least: f64 = 1e-4, "learner.priority_least" [1e-12, 1e9] "", Gap, "section 3.7", "Priority at or below which nothing is queued (sweeping)";
        transport: Transport = Transport::Terminal, "learner.transport" "", Gap, "section 4.4", "What is learned at an end";
        initial: f64 = 0.0, "learner.initial" [-1e6, 1e6] "", Literal, "Algorithm 6", "First value of every pair";
        explorer: Explorer = Explorer::EpsilonGreedy, "exploration.rule" "", Gap, "section 3.5", "How actions are chosen";
        first: f64 = 0.1, "exploration.first" [0.001, 1000.0] "", Gap, "section 4.8", "ε or temperature of the first trial";
        least: f64 = 0.1, "exploration.least" [0.001, 1000.0] "", Gap, "section 4.8", "ε or temperature it falls to";
        keep: f64 = 0.95, "exploration.keep" [0.0, 1.0] "", Gap, "Eq. (5.17), β", "Share of the distance to it that is kept from trial to trial";
        reflex: bool = false, "bias.reflex" "", Addition, "section 4.3", "Reflex: towards the goal if that is free, else clockwise, where experience is lacking";
        reflex_strength: f64 = 4.0, "reflex.strength" [0.0, 20.0] "", Addition, "section 4.3", "Log-odds that the reflex adds to its action in a state never met";
        reflex_half_life: f64 = 10.0, "reflex.half_life" [0.1, 1e6] "", Addition, "section 4.3", "Visits after which half of that is left";
        advice: bool = false, "bias.advice" "", Addition, "section 4.3", "Advice in words";
        advice_strength: f64 = 2.0, "advice.strength" [0.0, 20.0] "", Addition, "section 4.3", "Log-odds that a rule adds to its action at first";
        advice_half_life: f64 = 10.0, "advice.half_life" [0.1, 1e6] "", Addition, "section 4.3", "Trials of an action after which half of that is left";
        advice_refinement: f64 = 0.1, "advice.refinement" [0.0, 0.9] "", Addition, "section 4.3", "Share by which a rule's weight changes after a trial";
        advice_patience: u32 = 5, "advice.patience" [1.0, 100_000.0] "", Addition, "section 4.3", "Times a rule is followed, and not followed, before it is judged";
        heterogeneous: bool = false, "bias.heterogeneous" "", Addition, "section 4.3", "Heterogeneous rewards: for the doors between rooms, against walls";
        subgoal_reward: f64 = 0.5, "reward.subgoal" [-100.0, 100.0] "", Addition, "section 4.3", "Reward of the first arrival in a subgoal";
        bump_reward: f64 = -0.1, "reward.bump" [-100.0, 100.0] "", Addition, "section 4.3", "Reward of an action that changes nothing";
        progress: bool = false, "bias.progress" "", Addition, "section 4.3", "Progress estimator: reward for every step of the estimated way";
        progress_reward: f64 = 0.05, "reward.progress" [-100.0, 100.0] "", Addition, "section 4.3", "Reward of one step of it";
        modules: bool = false, "bias.modules" "", Addition, "section 4.3", "Modularisation: a behaviour for each room";
    }
}

impl GridworldSettings {
    fn rule(&self) -> LearnerRule {
        LearnerRule {
            kind: self.kind,
            rate: self.rate,
            discount: self.discount,
            actor_rate: self.actor_rate,
            lambda: self.lambda,
            planning: self.planning,
            model: self.model,
            priority_cap: self.priority_cap,
            priority_least: self.priority_least,
            transport: self.transport,
        }
    }

    fn setup(&self, world: &Arc<AnyWorld>, kind: LearnerKind) -> WalkSetup {
        WalkSetup {
            world: Arc::clone(world),
            rule: LearnerRule { kind, ..self.rule() },
            exploration: Exploration {
                explorer: self.explorer,
                anneal: Anneal { first: self.first, least: self.least, keep: self.keep },
            },
            belief: Belief::none(world.mdp(), self.initial),
            modules: false,
            reflex: None,
            shaping: Shaping::default(),
            advice: String::new(),
            advisor: AdvisorRule::default(),
            cap: self.cap,
        }
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

    /// All entrants: first the learners without a bias, then the first of them with each.
    ///
    /// # Errors
    /// Names the bias that the world does not offer, or the character of the advice that is wrong.
    pub fn entrants(
        &self,
        world: &Arc<AnyWorld>,
        advice: &str,
    ) -> Result<Vec<Entrant>, ContestError> {
        let kinds = match self.learners {
            Learners::One => vec![self.kind],
            Learners::All => {
                vec![LearnerKind::Q, LearnerKind::Ahc, LearnerKind::Dyna, LearnerKind::Sweeping]
            }
        };
        let entrant = |kind: &LearnerKind| Entrant {
            name: kind_name(*kind).into(),
            setup: self.setup(world, *kind),
            training: None,
            reference: 0,
        };
        let mut entrants: Vec<Entrant> = kinds.iter().map(entrant).collect();
        let base = entrants[0].setup.clone();
        entrants.extend(self.biases().entrants(&base, advice, 0)?);
        Ok(entrants)
    }

    /// The experiment from its beginning.
    ///
    /// # Errors
    /// See [`Self::entrants`]; and when the world has no value at this discount.
    pub fn contest(
        &self,
        world: &Arc<AnyWorld>,
        advice: &str,
        seed: u64,
    ) -> Result<Contest, ContestError> {
        Ok(Contest::new(self.entrants(world, advice)?, self.trials, seed)?)
    }

    /// The experiment after a checkpoint.
    ///
    /// # Errors
    /// See [`Self::contest`]; and when the checkpoint is of other settings.
    pub fn resume(
        &self,
        world: &Arc<AnyWorld>,
        advice: &str,
        seed: u64,
        checkpoint: &ContestCheckpoint,
    ) -> Result<Contest, ContestError> {
        Ok(Contest::resume(self.entrants(world, advice)?, self.trials, seed, checkpoint)?)
    }
}

fn kind_name(kind: LearnerKind) -> &'static str {
    match kind {
        LearnerKind::Q => "q-learning",
        LearnerKind::Ahc => "ahc",
        LearnerKind::Dyna => "dyna",
        LearnerKind::Sweeping => "sweeping",
    }
}
