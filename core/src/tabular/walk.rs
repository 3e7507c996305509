//! A learner in a world, one step at a time: the machine that `gridworld`, `labyrinth` and `continual` run.

mod setup;
mod step;

use std::sync::Arc;

use rand_chacha::ChaCha8Rng;
use serde::{Deserialize, Serialize};

pub use setup::{Anneal, Exploration, Explorer, WalkError, WalkSetup};
pub use step::{Reward, Trial, WalkStep};

use super::{
    Advisor, AdvisorMemory, AnyLearner, AnyWorld, Experience, Learner, Transition, ValuesError,
    World, chances, choose, unit,
};
use crate::fuzzy::advice::AdviceError;
use crate::rng::{Purpose, stream};

/// Everything that outlives a trial. Plain data.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WalkMemory {
    learner: AnyLearner,
    /// How often each action was tried in each state.
    tried: Vec<u32>,
    advice: Option<AdvisorMemory>,
    /// τ or ε of the next trial.
    exploration: f64,
    trials: u32,
    ticks: u64,
}

impl WalkMemory {
    /// The learner.
    #[must_use]
    pub fn learner(&self) -> &AnyLearner {
        &self.learner
    }

    /// Trials done.
    #[must_use]
    pub fn trials(&self) -> u32 {
        self.trials
    }
}

/// The state of a trial under way.
#[derive(Clone, Debug)]
struct Now {
    state: usize,
    step: u32,
    reward: f64,
    bumps: u32,
    visited: Vec<bool>,
    first_tick: u64,
    selection: ChaCha8Rng,
    transition: ChaCha8Rng,
    planning: ChaCha8Rng,
}

/// A learner in a world.
#[derive(Debug)]
pub struct Walk {
    setup: WalkSetup,
    seed: u64,
    /// Number of the first trial's random streams.
    first_stream: u32,
    memory: WalkMemory,
    advisor: Option<Advisor>,
    now: Option<Now>,
    /// Room for the running sums of the chances.
    sums: Vec<f64>,
    pulls: Vec<f64>,
    step: Option<WalkStep>,
    trial: Option<Trial>,
}

impl Walk {
    /// A new walk. Trial t (from 0) draws from the streams numbered `first_stream + t` of the seed.
    ///
    /// # Errors
    /// When the setup contradicts itself.
    pub fn new(setup: WalkSetup, seed: u64, first_stream: u32) -> Result<Self, WalkError> {
        setup.check()?;
        let learner = setup.learner()?;
        let mdp = setup.world.mdp();
        let memory = WalkMemory {
            learner,
            tried: vec![0; mdp.states() * mdp.actions()],
            advice: None,
            exploration: setup.exploration.anneal.first,
            trials: 0,
            ticks: 0,
        };
        let advice = setup.advice.clone();
        let mut walk = Self::with(setup, seed, first_stream, memory, None);
        walk.advise(&advice)?;
        Ok(walk)
    }

    /// Goes on from what was kept between trials, to the same bits.
    ///
    /// # Errors
    /// When the setup contradicts itself, or what was kept is of another world.
    pub fn resume(
        setup: WalkSetup,
        seed: u64,
        first_stream: u32,
        memory: WalkMemory,
    ) -> Result<Self, WalkError> {
        setup.check()?;
        let mdp = setup.world.mdp();
        if memory.tried.len() != mdp.states() * mdp.actions() {
            return Err(WalkError::OtherWorld);
        }
        let advisor = match memory.advice.clone() {
            Some(kept) => Some(Advisor::remember(kept, setup.advisor, setup.world.as_ref())?),
            None => None,
        };
        Ok(Self::with(setup, seed, first_stream, memory, advisor))
    }

    fn with(
        setup: WalkSetup,
        seed: u64,
        first_stream: u32,
        memory: WalkMemory,
        advisor: Option<Advisor>,
    ) -> Self {
        let actions = setup.world.mdp().actions();
        Self {
            setup,
            seed,
            first_stream,
            memory,
            advisor,
            now: None,
            sums: Vec::with_capacity(actions),
            pulls: vec![0.0; actions],
            step: None,
            trial: None,
        }
    }

    /// One step: choose, act, learn. The second part is there when the trial ended with it.
    pub fn step(&mut self) -> (&WalkStep, Option<&Trial>) {
        let mut now = self.now.take().unwrap_or_else(|| self.begin_trial());
        let (step, ended) = self.walk(&mut now);
        let over = ended || now.step >= self.setup.cap;
        self.trial = over.then(|| self.end_trial(&now, ended));
        if !over {
            self.now = Some(now);
        }
        (self.step.insert(step), self.trial.as_ref())
    }

    /// A whole trial.
    pub fn trial(&mut self) -> Trial {
        loop {
            if let (_, Some(trial)) = self.step() {
                return trial.clone();
            }
        }
    }

    fn begin_trial(&mut self) -> Now {
        self.memory.learner.begin_trial();
        let number = self.first_stream + self.memory.trials;
        let of = |purpose| stream(self.seed, number, purpose);
        Now {
            state: self.setup.world.start(),
            step: 0,
            reward: 0.0,
            bumps: 0,
            visited: vec![false; self.setup.world.mdp().states()],
            first_tick: self.memory.ticks + 1,
            selection: of(Purpose::Selection),
            transition: of(Purpose::Transition),
            planning: of(Purpose::Planning),
        }
    }

    fn walk(&mut self, now: &mut Now) -> (WalkStep, bool) {
        let world = Arc::clone(&self.setup.world);
        let (state, mdp) = (now.state, world.mdp());
        let reflex_pull = self.pull(state);
        let selection = self.setup.exploration.selection(self.memory.exploration);
        let weights = &self.setup.belief.weights[state];
        let preferences = self.memory.learner.preferences(state);
        selection.sums(preferences, weights, &self.pulls, &mut self.sums);
        let values = preferences.to_vec();
        let action = choose(&self.sums, unit(&mut now.selection));
        let chances = chances(&self.sums);
        let transition = mdp.sample(state, action, &mut now.transition);
        let ended = mdp.is_absorbing(transition.next);
        let ahead = self.setup.rule.transport.ahead(transition.next, world.start(), ended);
        let reward = self.reward(now, action, &transition, ahead);
        let experience = Experience {
            state,
            action,
            chance: chances[action],
            reward: reward.total(),
            next: transition.next,
            ahead,
            ended,
        };
        let update = self.memory.learner.learn(&experience, &mut now.planning);
        self.count(now, &experience, &reward);
        let step = WalkStep {
            tick: self.memory.ticks,
            trial: self.memory.trials + 1,
            step: now.step,
            state,
            values,
            pulls: self.pulls.clone(),
            reflex_pull,
            chances,
            exploration: self.memory.exploration,
            action,
            next: transition.next,
            bumped: transition.next == state,
            reward,
            update,
            ended,
        };
        (step, ended)
    }

    /// Fills in what advice and reflex add to the exponents; the share of the reflex is returned.
    fn pull(&mut self, state: usize) -> f64 {
        self.pulls.fill(0.0);
        let actions = self.pulls.len();
        let tried = &self.memory.tried[state * actions..(state + 1) * actions];
        if let Some(advisor) = &self.advisor {
            advisor.pull(state, tried, &mut self.pulls);
        }
        let Some(reflex) = &self.setup.reflex else { return 0.0 };
        let pull = reflex.pull(tried.iter().sum());
        self.pulls[reflex.actions[state]] += pull;
        pull
    }

    fn reward(
        &self,
        now: &mut Now,
        action: usize,
        transition: &Transition,
        ahead: Option<usize>,
    ) -> Reward {
        let (state, next) = (now.state, transition.next);
        let mut reward = Reward { task: transition.reward, ..Reward::default() };
        let deterministic = self.setup.world.mdp().outcomes(state, action).len() == 1;
        if let Some(subgoals) = &self.setup.shaping.subgoals {
            if subgoals.states[next] && !now.visited[next] {
                now.visited[next] = true;
                reward.subgoal = subgoals.reward;
            }
            if next == state && deterministic {
                reward.bump = subgoals.bump;
            }
        }
        if let Some((estimate, per_step)) = &self.setup.shaping.progress {
            // NOTE: the thesis gives no formula. Progress is the discounted change of the way that is already
            // behind, counted from the farthest state: walking to and fro earns nothing, staying costs, and the
            // best way stays the best. Counted from the goal instead, an action that changes nothing would
            // earn something, and a learner that knows nothing yet would repeat it for ever.
            let farthest = estimate.iter().copied().fold(0.0, f64::max);
            let behind = |state: usize| farthest - estimate[state];
            let then = ahead.map_or(0.0, behind);
            reward.progress = per_step * (self.setup.rule.discount * then - behind(state));
        }
        reward
    }

    fn count(&mut self, now: &mut Now, experience: &Experience, reward: &Reward) {
        let Experience { state, action, next, .. } = *experience;
        let at = state * self.pulls.len() + action;
        self.memory.tried[at] = self.memory.tried[at].saturating_add(1);
        if let Some(advisor) = &mut self.advisor {
            advisor.note(state, action, now.step);
        }
        now.step += 1;
        now.reward += reward.task;
        now.bumps += u32::from(next == state);
        now.state = next;
        self.memory.ticks += 1;
    }

    fn end_trial(&mut self, now: &Now, reached_end: bool) -> Trial {
        self.memory.trials += 1;
        let trial = Trial {
            trial: self.memory.trials,
            steps: now.step,
            reached_end,
            total_reward: now.reward,
            bumps: now.bumps,
            exploration: self.memory.exploration,
            first_tick: now.first_tick,
            last_tick: self.memory.ticks,
        };
        if let Some(advisor) = &mut self.advisor {
            advisor.end_trial(now.step, trial.trial);
            self.memory.advice = Some(advisor.memory().clone());
        }
        self.memory.exploration = self.setup.exploration.anneal.next(self.memory.exploration);
        trial
    }

    /// What was kept after the last finished trial; none while a trial is under way.
    #[must_use]
    pub fn memory(&self) -> Option<&WalkMemory> {
        self.now.is_none().then_some(&self.memory)
    }

    /// The learner, at any time.
    #[must_use]
    pub fn learner(&self) -> &AnyLearner {
        &self.memory.learner
    }

    /// The setup.
    #[must_use]
    pub fn setup(&self) -> &WalkSetup {
        &self.setup
    }

    /// Trials done.
    #[must_use]
    pub fn trials_done(&self) -> u32 {
        self.memory.trials
    }

    /// τ or ε of the trial under way, or of the next.
    #[must_use]
    pub fn exploration(&self) -> f64 {
        self.memory.exploration
    }

    /// State the agent is in; the start between trials.
    #[must_use]
    pub fn state(&self) -> usize {
        self.now.as_ref().map_or_else(|| self.setup.world.start(), |now| now.state)
    }

    /// The advice, if there is any.
    #[must_use]
    pub fn advisor(&self) -> Option<&Advisor> {
        self.advisor.as_ref()
    }

    /// Chances of the actions in a state, as they would be now.
    pub fn chances(&mut self, state: usize) -> Vec<f64> {
        self.pull(state);
        let selection = self.setup.exploration.selection(self.memory.exploration);
        let weights = &self.setup.belief.weights[state];
        let preferences = self.memory.learner.preferences(state);
        selection.sums(preferences, weights, &self.pulls, &mut self.sums);
        chances(&self.sums)
    }

    /// Takes advice, from the next step on; an empty text takes all advice back.
    ///
    /// # Errors
    /// At the first character that is wrong; the advice that was there stays then.
    pub fn advise(&mut self, text: &str) -> Result<(), AdviceError> {
        let trial = self.memory.trials + 1;
        let rule = self.setup.advisor;
        let advisor = Advisor::new(text, rule, self.setup.world.as_ref(), trial)?;
        let silent = advisor.memory().rules.is_empty();
        self.memory.advice = (!silent).then(|| advisor.memory().clone());
        self.advisor = (!silent).then_some(advisor);
        Ok(())
    }

    /// Puts a table in the place of the learner's.
    ///
    /// # Errors
    /// When the table has the wrong shape, or the learner has no single table.
    pub fn load(&mut self, table: &[Vec<f64>]) -> Result<(), WalkError> {
        let Some(values) = self.memory.learner.table_mut() else {
            return Err(WalkError::NoTable);
        };
        *values = values.clone().with_values(table)?;
        Ok(())
    }

    /// Changes one value of the table.
    ///
    /// # Errors
    /// When there is no such pair, the number is not finite, or the learner has no single table.
    pub fn edit(&mut self, state: usize, action: usize, value: f64) -> Result<(), WalkError> {
        let Some(values) = self.memory.learner.table_mut() else {
            return Err(WalkError::NoTable);
        };
        if state >= values.states() {
            return Err(ValuesError::Rows { expected: values.states(), found: state + 1 }.into());
        }
        if action >= values.actions() {
            let (expected, found) = (values.actions(), action + 1);
            return Err(ValuesError::Columns { row: state, expected, found }.into());
        }
        if !value.is_finite() {
            return Err(ValuesError::NotFinite { row: state, column: action }.into());
        }
        values.set(state, action, value);
        Ok(())
    }

    /// A learner that learned elsewhere, in a world of the same size: its exploration begins anew, and so
    /// does the count of trials.
    ///
    /// # Errors
    /// When the worlds differ in size or the new setup contradicts itself.
    pub fn moved(
        setup: WalkSetup,
        seed: u64,
        first_stream: u32,
        memory: WalkMemory,
    ) -> Result<Self, WalkError> {
        let exploration = setup.exploration.anneal.first;
        let memory = WalkMemory { exploration, trials: 0, ..memory };
        Self::resume(setup, seed, first_stream, memory)
    }

    /// The world.
    #[must_use]
    pub fn world(&self) -> &Arc<AnyWorld> {
        &self.setup.world
    }
}
