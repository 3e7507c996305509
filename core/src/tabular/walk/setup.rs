//! What a walk is run with.

use std::sync::Arc;

use super::super::{
    ActionValues, AdvisorRule, AnyLearner, AnyWorld, Belief, LearnerError, LearnerRule, MdpError,
    Reflex, Selection, SelectionError, Shaping, ValuesError, World,
};
use crate::fuzzy::advice::AdviceError;

crate::choice! {
    /// How actions are chosen.
    pub enum Explorer {
        Softmax = "softmax": "Eq. (4.11), with temperature τ",
        EpsilonGreedy = "epsilon-greedy": "the best, or with chance ε any",
        Greedy = "greedy": "always the best",
    }
}

/// How τ or ε falls from trial to trial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anneal {
    /// Value of the first trial.
    pub first: f64,
    /// Value it falls to.
    pub least: f64,
    /// Share of the distance to it that is kept from trial to trial.
    pub keep: f64,
}

impl Anneal {
    /// Value of the trial after one with this value, in the form of Eq. (5.17).
    ///
    /// NOTE: chapter 4 prints no temperature; without annealing its table cannot be had at all.
    #[must_use]
    pub fn next(&self, value: f64) -> f64 {
        // Eq. (5.17): T(n) = T_min + β (T(n-1) − T_min)
        self.least + self.keep * (value - self.least)
    }
}

/// The rule of selection and its course.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exploration {
    /// Which rule.
    pub explorer: Explorer,
    /// The course of τ or ε.
    pub anneal: Anneal,
}

impl Exploration {
    /// The rule with the value of the moment.
    #[must_use]
    pub fn selection(&self, value: f64) -> Selection {
        match self.explorer {
            Explorer::Softmax => Selection::Softmax { temperature: value },
            Explorer::EpsilonGreedy => Selection::EpsilonGreedy { epsilon: value },
            Explorer::Greedy => Selection::Greedy,
        }
    }
}

/// All that a walk is run with.
#[derive(Clone, Debug)]
pub struct WalkSetup {
    /// The world.
    pub world: Arc<AnyWorld>,
    /// The learner's parameters.
    pub rule: LearnerRule,
    /// How actions are chosen.
    pub exploration: Exploration,
    /// First values and what is excluded.
    pub belief: Belief,
    /// Learns in the modules of the world's gate.
    pub modules: bool,
    /// Reflex.
    pub reflex: Option<Reflex>,
    /// Rewards beside the task's own.
    pub shaping: Shaping,
    /// Advice given before the first trial; empty for none.
    pub advice: String,
    /// How advice is taken, then or later.
    pub advisor: AdvisorRule,
    /// Steps after which a trial is broken off.
    pub cap: u32,
}

/// A setup that cannot be run, or a change that cannot be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum WalkError {
    /// The learner's parameters.
    #[error(transparent)]
    Learner(#[from] LearnerError),
    /// The world and the discount.
    #[error(transparent)]
    World(#[from] MdpError),
    /// The parameter of selection.
    #[error(transparent)]
    Selection(#[from] SelectionError),
    /// A table.
    #[error(transparent)]
    Table(#[from] ValuesError),
    /// The advice.
    #[error(transparent)]
    Advice(#[from] AdviceError),
    /// What was kept is of another world.
    #[error("what was kept is of a world with other states or actions")]
    OtherWorld,
    /// The learner keeps no single table.
    #[error("behaviours behind a gate have a table each; there is no single one to load or edit")]
    NoTable,
    /// The world knows no modules.
    #[error("this world has no modules; mark its rooms with letters a to z")]
    NoModules,
    /// The world does not offer what a bias needs.
    #[error("this world does not offer {what}; take another world or switch `{setting}` off")]
    NoKnowledge {
        /// What is missing.
        what: &'static str,
        /// Key of the bias that needs it.
        setting: &'static str,
    },
    /// A trial is under way.
    #[error("a trial is under way; the world can be changed between trials")]
    UnderWay,
    /// A limit of nothing.
    #[error("a trial must be allowed at least one step")]
    NoSteps,
}

impl WalkSetup {
    /// Pairs that are left to try: of state and action, or of what the modules see and an action.
    #[must_use]
    pub fn search_space(&self) -> usize {
        match &self.world.knowledge().gate {
            Some(gate) if self.modules => gate.hypotheses(self.world.mdp().actions()),
            _ => self.belief.search_space(),
        }
    }

    pub(super) fn check(&self) -> Result<(), WalkError> {
        self.rule.check()?;
        self.world.mdp().check_discount(self.rule.discount)?;
        let Anneal { first, least, keep } = self.exploration.anneal;
        self.exploration.selection(first).check()?;
        self.exploration.selection(least).check()?;
        if !(0.0..=1.0).contains(&keep) {
            let expected = "from 0 to 1";
            return Err(LearnerError::Range { name: "keep", expected, found: keep }.into());
        }
        if self.cap == 0 {
            return Err(WalkError::NoSteps);
        }
        Ok(())
    }

    pub(super) fn learner(&self) -> Result<AnyLearner, WalkError> {
        let mdp = self.world.mdp();
        if self.modules {
            let gate = self.world.knowledge().gate.as_ref().ok_or(WalkError::NoModules)?;
            let first = self.belief.initial[self.world.start()][0];
            return Ok(AnyLearner::gated(&self.rule, mdp.actions(), gate, first));
        }
        let allowed = self.belief.weights.iter().flatten().map(|weight| *weight > 0.0).collect();
        let table = ActionValues::new(mdp.actions(), allowed, 0.0);
        Ok(AnyLearner::new(&self.rule, table.with_values(&self.belief.initial)?))
    }
}
