//! The experiment `bandit`: levers and lights, and what each strategy of exploration regrets (section 3.5).

use rand_chacha::ChaCha8Rng;
use serde::{Deserialize, Serialize};

use crate::rng::{Purpose, stream};
use crate::settings::SettingError;
use crate::stats::Estimate;
use crate::tabular::{Bandit, Estimates, Payoff, Pull, Strategy, StrategyRule};

crate::settings! {
    /// Settings of the experiment `bandit`.
    pub struct BanditSettings {
        arms: u32 = 10, "arms" [2.0, 1_000.0] "", Gap, "section 3.5, k", "Levers";
        payoff: Payoff = Payoff::Bernoulli, "payoff" "", Gap, "section 3.5, p_i", "How a lever pays";
        episodes: u32 = 10, "episodes" [1.0, 100_000.0] "", Gap, "section 3.5", "Episodes, each begun with nothing learned; every competitor does each";
        pulls: u32 = 1_000, "pulls" [1.0, 1_000_000.0] "", Gap, "section 3.5, h", "Pulls an episode";
        greedy: bool = true, "strategy.greedy" "", Literal, "section 3.5", "Greedy competes";
        epsilon_greedy: bool = true, "strategy.epsilon_greedy" "", Literal, "section 4.8", "ε-greedy competes";
        softmax: bool = true, "strategy.softmax" "", Literal, "section 4.8", "Softmax competes";
        ucb: bool = true, "strategy.ucb" "", Addition, "after the thesis (2002)", "Upper confidence bounds compete";
        interval: bool = true, "strategy.interval" "", Literal, "section 3.5, survey [60]", "Interval estimation competes";
        epsilon: f64 = 0.1, "epsilon" [0.0, 1.0] "", Gap, "section 4.8, ε", "Chance of any lever";
        temperature: f64 = 0.1, "temperature" [0.001, 1000.0] "", Gap, "Eq. (4.11), τ", "Temperature of softmax";
        confidence: f64 = 1.0, "confidence" [0.0, 100.0] "", Addition, "c", "Factor of the bound of UCB";
        deviations: f64 = 1.96, "deviations" [0.0, 100.0] "", Gap, "z", "Standard errors of interval estimation";
    }
}

/// One pull.
#[derive(Clone, Debug, PartialEq)]
pub struct BanditStep {
    /// Pull of the experiment, from 1.
    pub tick: u64,
    /// Episode, from 1: another row of levers.
    pub episode: u32,
    /// Strategy whose turn it is, by number.
    pub strategy: usize,
    /// Pull of the episode, from 1.
    pub pull: u32,
    /// The decision.
    pub decision: Pull,
    /// What the lever paid.
    pub paid: f64,
    /// What it pays in the mean, which the agent does not know.
    pub mean: f64,
    /// Regret of this pull, section 3.4.
    pub regret: f64,
    /// Regret of the episode so far.
    pub total_regret: f64,
}

/// One strategy's episode.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BanditEpisode {
    /// Episode, from 1.
    pub episode: u32,
    /// Strategy, by number.
    pub strategy: usize,
    /// Regret.
    pub regret: f64,
    /// What was paid.
    pub paid: f64,
    /// Share of pulls of a best lever.
    pub best_share: f64,
    /// Regret so far at each hundredth of the pulls.
    pub course: Vec<f64>,
}

/// Everything needed to go on between episodes.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct BanditCheckpoint {
    ticks: u64,
    done: Vec<BanditEpisode>,
    last: Option<Levers>,
}

/// The levers of an episode and what the agent knows of them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Levers {
    /// Episode, from 1.
    pub episode: u32,
    /// Strategy, by number.
    pub strategy: usize,
    /// What each pays in the mean, which the agent does not know.
    pub means: Vec<f64>,
    /// What the agent knows.
    pub estimates: Estimates,
}

/// How a strategy did so far.
#[derive(Clone, Debug, PartialEq)]
pub struct BanditScore {
    /// The strategy.
    pub strategy: Strategy,
    /// Regret of an episode; none of fewer than two.
    pub regret: Option<Estimate>,
    /// Share of pulls of a best lever.
    pub best_share: Option<Estimate>,
}

/// What an episode under way holds.
#[derive(Debug)]
struct Now {
    bandit: Bandit,
    estimates: Estimates,
    rng: ChaCha8Rng,
    pull: u32,
    regret: f64,
    paid: f64,
    best: u32,
    course: Vec<f64>,
}

/// The experiment as a state machine.
#[derive(Debug)]
pub struct BanditRun {
    settings: BanditSettings,
    strategies: Vec<Strategy>,
    seed: u64,
    memory: BanditCheckpoint,
    now: Option<Now>,
    step: Option<BanditStep>,
    end: Option<BanditEpisode>,
}

impl BanditSettings {
    /// The strategies that compete.
    #[must_use]
    pub fn strategies(&self) -> Vec<Strategy> {
        [
            (self.greedy, Strategy::Greedy),
            (self.epsilon_greedy, Strategy::EpsilonGreedy),
            (self.softmax, Strategy::Softmax),
            (self.ucb, Strategy::Ucb),
            (self.interval, Strategy::Interval),
        ]
        .into_iter()
        .filter_map(|(on, strategy)| on.then_some(strategy))
        .collect()
    }

    fn rule(&self, strategy: Strategy) -> StrategyRule {
        StrategyRule {
            strategy,
            epsilon: self.epsilon,
            temperature: self.temperature,
            confidence: self.confidence,
            deviations: self.deviations,
        }
    }
}

impl BanditRun {
    /// The experiment from its beginning, or after a checkpoint.
    ///
    /// # Errors
    /// When no strategy competes.
    pub fn new(
        settings: BanditSettings,
        seed: u64,
        checkpoint: Option<BanditCheckpoint>,
    ) -> Result<Self, SettingError> {
        let strategies = settings.strategies();
        if strategies.is_empty() {
            return Err(SettingError::Invalid {
                key: "strategy.greedy",
                expected: "true for at least one of the strategies".into(),
                found: "`false` for all".into(),
            });
        }
        let memory = checkpoint.unwrap_or_default();
        Ok(Self { settings, strategies, seed, memory, now: None, step: None, end: None })
    }

    /// One pull. The second part is there when the strategy's episode ended with it.
    pub fn step(&mut self) -> (&BanditStep, Option<&BanditEpisode>) {
        let strategy = self.memory.done.len() % self.strategies.len();
        let episode = self.episodes_done() + 1;
        let mut now = self.now.take().unwrap_or_else(|| self.begin(episode));
        let rule = self.settings.rule(self.strategies[strategy]);
        let decision = now.estimates.decide(&rule, self.settings.payoff, &mut now.rng);
        let paid = now.pull(decision.arm, self.settings.pulls);
        self.memory.ticks += 1;
        let step = BanditStep {
            tick: self.memory.ticks,
            episode,
            strategy,
            pull: now.pull,
            paid,
            mean: now.bandit.arms()[decision.arm].mean,
            regret: now.bandit.regret(decision.arm),
            total_regret: now.regret,
            decision,
        };
        self.end = None;
        if now.pull < self.settings.pulls {
            self.now = Some(now);
        } else {
            self.memory.last = Some(now.levers(episode, strategy));
            let end = now.end(episode, strategy);
            self.memory.done.push(end.clone());
            self.end = Some(end);
        }
        (self.step.insert(step), self.end.as_ref())
    }

    /// All strategies meet the same levers in the same episode, and the same luck as long as they pull alike.
    fn begin(&self, episode: u32) -> Now {
        let mut levers = stream(self.seed, episode - 1, Purpose::Levers);
        let bandit = Bandit::draw(self.settings.arms as usize, self.settings.payoff, &mut levers);
        Now {
            estimates: Estimates::new(bandit.arms().len()),
            bandit,
            rng: stream(self.seed, episode - 1, Purpose::Payoff),
            pull: 0,
            regret: 0.0,
            paid: 0.0,
            best: 0,
            course: Vec::new(),
        }
    }

    /// Episodes that all strategies have done.
    #[must_use]
    pub fn episodes_done(&self) -> u32 {
        u32::try_from(self.memory.done.len() / self.strategies.len()).unwrap_or(u32::MAX)
    }

    /// What must be kept; none while an episode is under way.
    #[must_use]
    pub fn checkpoint(&self) -> Option<BanditCheckpoint> {
        self.now.is_none().then(|| self.memory.clone())
    }

    /// Pulls done.
    #[must_use]
    pub fn ticks(&self) -> u64 {
        self.memory.ticks
    }

    /// The levers of the episode under way, or of the last; none before the first pull.
    #[must_use]
    pub fn levers(&self) -> Option<Levers> {
        let strategy = self.memory.done.len() % self.strategies.len();
        match &self.now {
            Some(now) => Some(now.levers(self.episodes_done() + 1, strategy)),
            None => self.memory.last.clone(),
        }
    }

    /// Pulls at which [`BanditEpisode::course`] was taken.
    #[must_use]
    pub fn course_pulls(&self) -> Vec<u32> {
        let of = u64::from(self.settings.pulls);
        let hundredth = |pull: u32| u64::from(pull) * 100 / of;
        (1..=self.settings.pulls).filter(|pull| hundredth(*pull) > hundredth(pull - 1)).collect()
    }

    /// The strategies that compete.
    #[must_use]
    pub fn strategies(&self) -> &[Strategy] {
        &self.strategies
    }

    /// Episodes done, in their order.
    #[must_use]
    pub fn episodes(&self) -> &[BanditEpisode] {
        &self.memory.done
    }

    /// How each strategy did so far.
    #[must_use]
    pub fn scores(&self) -> Vec<BanditScore> {
        let score = |(number, &strategy): (usize, &Strategy)| {
            let sample = |of: fn(&BanditEpisode) -> f64| {
                let mine = self.memory.done.iter().filter(|episode| episode.strategy == number);
                Estimate::mean(&mine.map(of).collect::<Vec<f64>>())
            };
            BanditScore {
                strategy,
                regret: sample(|episode| episode.regret),
                best_share: sample(|episode| episode.best_share),
            }
        };
        self.strategies.iter().enumerate().map(score).collect()
    }
}

impl Now {
    fn pull(&mut self, arm: usize, of: u32) -> f64 {
        let paid = self.bandit.pull(arm, &mut self.rng);
        self.estimates.learn(arm, paid);
        self.pull += 1;
        let regret = self.bandit.regret(arm);
        self.regret += regret;
        self.paid += paid;
        self.best += u32::from(regret <= 0.0);
        if u64::from(self.pull) * 100 / u64::from(of)
            > u64::from(self.pull - 1) * 100 / u64::from(of)
        {
            self.course.push(self.regret);
        }
        paid
    }

    fn levers(&self, episode: u32, strategy: usize) -> Levers {
        Levers {
            episode,
            strategy,
            means: self.bandit.arms().iter().map(|arm| arm.mean).collect(),
            estimates: self.estimates.clone(),
        }
    }

    fn end(self, episode: u32, strategy: usize) -> BanditEpisode {
        BanditEpisode {
            episode,
            strategy,
            regret: self.regret,
            paid: self.paid,
            best_share: f64::from(self.best) / f64::from(self.pull),
            course: self.course,
        }
    }
}
