//! Levers and lights: the k-armed bandit, and regret, sections 3.2, 3.4 and 3.5.

use rand::Rng;
use rand_distr::{Distribution, StandardNormal};
use serde::{Deserialize, Serialize};

use super::{Selection, unit};

crate::choice! {
    /// How a lever pays.
    pub enum Payoff {
        Bernoulli = "bernoulli": "1 or 0; the mean is the chance of 1",
        Gaussian = "gaussian": "normal around the mean, with standard deviation 1",
    }
}

crate::choice! {
    /// How the agent decides which lever to pull.
    pub enum Strategy {
        Greedy = "greedy": "the lever that has paid best, each tried once",
        EpsilonGreedy = "epsilon-greedy": "greedy, but any lever with chance ε",
        Softmax = "softmax": "chances in the proportion of e^(mean/τ)",
        Ucb = "ucb": "greatest mean + c √(2 ln t / n)",
        Interval = "interval": "greatest upper end of an interval of z standard errors (interval estimation)",
    }
}

/// One lever.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arm {
    /// What it pays in the mean.
    pub mean: f64,
}

/// A row of levers.
#[derive(Clone, Debug, PartialEq)]
pub struct Bandit {
    arms: Vec<Arm>,
    payoff: Payoff,
}

/// Levers or a strategy that cannot be.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BanditError {
    /// No lever at all.
    #[error("a bandit must have at least one arm")]
    NoArm,
    /// A mean that cannot be.
    #[error("the mean of arm {arm} must be {expected}, not {found}")]
    Mean {
        /// Which.
        arm: usize,
        /// What would be right.
        expected: &'static str,
        /// What was given.
        found: f64,
    },
}

impl Bandit {
    /// Levers with their means.
    ///
    /// # Errors
    /// When there is none, or a mean is not finite, or no chance where it should be one.
    pub fn new(means: &[f64], payoff: Payoff) -> Result<Self, BanditError> {
        if means.is_empty() {
            return Err(BanditError::NoArm);
        }
        for (arm, &mean) in means.iter().enumerate() {
            let (good, expected) = match payoff {
                Payoff::Bernoulli => ((0.0..=1.0).contains(&mean), "from 0 to 1"),
                Payoff::Gaussian => (mean.is_finite(), "a finite number"),
            };
            if !good {
                return Err(BanditError::Mean { arm, expected, found: mean });
            }
        }
        Ok(Self { arms: means.iter().map(|&mean| Arm { mean }).collect(), payoff })
    }

    /// Levers with means drawn evenly from 0 to 1, or normally around 0.
    pub fn draw(count: usize, payoff: Payoff, rng: &mut impl Rng) -> Self {
        let arms = (0..count.max(1))
            .map(|_| Arm {
                mean: match payoff {
                    Payoff::Bernoulli => unit(rng),
                    Payoff::Gaussian => StandardNormal.sample(rng),
                },
            })
            .collect();
        Self { arms, payoff }
    }

    /// The levers.
    #[must_use]
    pub fn arms(&self) -> &[Arm] {
        &self.arms
    }

    /// The best mean there is.
    #[must_use]
    pub fn best(&self) -> f64 {
        self.arms.iter().map(|arm| arm.mean).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Pulls a lever.
    pub fn pull(&self, arm: usize, rng: &mut impl Rng) -> f64 {
        let mean = self.arms[arm].mean;
        match self.payoff {
            Payoff::Bernoulli => f64::from(u8::from(unit(rng) < mean)),
            Payoff::Gaussian => {
                let noise: f64 = StandardNormal.sample(rng);
                mean + noise
            }
        }
    }

    /// Regret of one pull, section 3.4: what is lost in the mean by not pulling the best lever.
    #[must_use]
    pub fn regret(&self, arm: usize) -> f64 {
        self.best() - self.arms[arm].mean
    }
}

/// What an agent knows of its levers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Estimates {
    pulls: Vec<u32>,
    means: Vec<f64>,
}

/// Parameters of the strategies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrategyRule {
    /// Which one.
    pub strategy: Strategy,
    /// ε of ε-greedy.
    pub epsilon: f64,
    /// τ of softmax, above 0.
    pub temperature: f64,
    /// c of UCB.
    pub confidence: f64,
    /// z of interval estimation.
    pub deviations: f64,
}

/// What the agent decided, and from what.
#[derive(Clone, Debug, PartialEq)]
pub struct Pull {
    /// The lever.
    pub arm: usize,
    /// What was compared: means, or upper bounds; none for a lever that must be tried first.
    pub scores: Vec<Option<f64>>,
    /// Chance of each lever.
    pub chances: Vec<f64>,
}

impl Estimates {
    /// Knows nothing of `count` levers.
    #[must_use]
    pub fn new(count: usize) -> Self {
        Self { pulls: vec![0; count], means: vec![0.0; count] }
    }

    /// How often each was pulled.
    #[must_use]
    pub fn pulls(&self) -> &[u32] {
        &self.pulls
    }

    /// Mean of what each has paid; 0 where never pulled.
    #[must_use]
    pub fn means(&self) -> &[f64] {
        &self.means
    }

    /// Takes in what a lever paid.
    pub fn learn(&mut self, arm: usize, paid: f64) {
        self.pulls[arm] += 1;
        self.means[arm] += (paid - self.means[arm]) / f64::from(self.pulls[arm]);
    }

    /// Decides which lever to pull; each is tried once first.
    pub fn decide(&self, rule: &StrategyRule, payoff: Payoff, rng: &mut impl Rng) -> Pull {
        let scores: Vec<Option<f64>> =
            (0..self.pulls.len()).map(|arm| self.score(arm, rule, payoff)).collect();
        if let Some(arm) = scores.iter().position(Option::is_none) {
            let chances =
                (0..scores.len()).map(|other| f64::from(u8::from(other == arm))).collect();
            return Pull { arm, scores, chances };
        }
        let preferences: Vec<f64> = scores.iter().map(|score| score.unwrap_or(0.0)).collect();
        let (weights, pulls) = (vec![1.0; preferences.len()], vec![0.0; preferences.len()]);
        let mut sums = Vec::new();
        rule.selection().sums(&preferences, &weights, &pulls, &mut sums);
        let arm = super::choose(&sums, unit(rng));
        Pull { arm, scores, chances: super::chances(&sums) }
    }

    fn score(&self, arm: usize, rule: &StrategyRule, payoff: Payoff) -> Option<f64> {
        let n = f64::from(self.pulls[arm]);
        let total: u32 = self.pulls.iter().sum();
        let mean = self.means[arm];
        if self.pulls[arm] == 0 {
            return None;
        }
        Some(match rule.strategy {
            Strategy::Greedy | Strategy::EpsilonGreedy | Strategy::Softmax => mean,
            Strategy::Ucb => {
                mean + rule.confidence * libm::sqrt(2.0 * libm::log(f64::from(total)) / n)
            }
            Strategy::Interval if payoff == Payoff::Bernoulli => {
                share_bound(mean, n, rule.deviations)
            }
            Strategy::Interval => mean + rule.deviations * libm::sqrt(1.0 / n),
        })
    }
}

/// Upper end of the interval of z standard errors for a share, as interval estimation takes it.
fn share_bound(share: f64, n: f64, z: f64) -> f64 {
    let z2 = z * z;
    let spread = z / libm::sqrt(n) * libm::sqrt(share * (1.0 - share) + z2 / (4.0 * n));
    (share + z2 / (2.0 * n) + spread) / (1.0 + z2 / n)
}

impl StrategyRule {
    /// The rule of selection that compares the scores.
    #[must_use]
    pub fn selection(&self) -> Selection {
        match self.strategy {
            Strategy::EpsilonGreedy => Selection::EpsilonGreedy { epsilon: self.epsilon },
            Strategy::Softmax => Selection::Softmax { temperature: self.temperature },
            Strategy::Greedy | Strategy::Ucb | Strategy::Interval => Selection::Greedy,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::{Purpose, stream};

    fn rule(strategy: Strategy) -> StrategyRule {
        StrategyRule { strategy, epsilon: 0.1, temperature: 0.1, confidence: 1.0, deviations: 1.96 }
    }

    /// Regret after a number of pulls.
    fn regret(strategy: Strategy, means: &[f64], pulls: u32, seed: u64) -> f64 {
        let bandit = Bandit::new(means, Payoff::Bernoulli).expect("chances");
        let mut estimates = Estimates::new(means.len());
        let mut rng = stream(seed, 0, Purpose::Payoff);
        let mut regret = 0.0;
        for _ in 0..pulls {
            let pull = estimates.decide(&rule(strategy), Payoff::Bernoulli, &mut rng);
            estimates.learn(pull.arm, bandit.pull(pull.arm, &mut rng));
            regret += bandit.regret(pull.arm);
        }
        regret
    }

    #[test]
    fn every_strategy_beats_chance_and_ucb_keeps_its_promise() {
        let means = [0.2, 0.5, 0.8];
        let by_chance = 2000.0 * 0.3;
        for strategy in [
            Strategy::Greedy,
            Strategy::EpsilonGreedy,
            Strategy::Softmax,
            Strategy::Ucb,
            Strategy::Interval,
        ] {
            let mean = (0..20).map(|seed| regret(strategy, &means, 2000, seed)).sum::<f64>() / 20.0;
            assert!(mean < by_chance, "{strategy:?}: {mean}");
            if strategy == Strategy::Ucb {
                // Auer et al. (2002): at most Σ 8 ln n / Δ + (1 + π²/3) Σ Δ
                let bound = 8.0 * libm::log(2000.0) * (1.0 / 0.6 + 1.0 / 0.3) + 4.29 * 0.9;
                assert!(mean < bound, "{mean} against {bound}");
            }
        }
    }

    #[test]
    fn ucb_and_intervals_do_not_stay_with_an_unlucky_lever() {
        // The greedy agent that sees the good lever fail first never comes back; the others do, interval
        // estimation with the confidence of its interval.
        let stuck = |strategy| {
            (0..100).filter(|&seed| regret(strategy, &[0.4, 0.6], 1000, seed) > 150.0).count()
        };
        assert!(stuck(Strategy::Greedy) > 10, "{}", stuck(Strategy::Greedy));
        assert_eq!(stuck(Strategy::Ucb), 0);
        assert!(stuck(Strategy::Interval) <= 5, "{}", stuck(Strategy::Interval));
    }

    #[test]
    fn bounds_and_means_in_closed_form() {
        let mut estimates = Estimates::new(2);
        for paid in [1.0, 0.0, 1.0, 0.0] {
            estimates.learn(0, paid);
        }
        estimates.learn(1, 1.0);
        assert_eq!((estimates.means(), estimates.pulls()), (&[0.5, 1.0][..], &[4, 1][..]));
        let ucb = estimates.score(0, &rule(Strategy::Ucb), Payoff::Bernoulli).expect("pulled");
        assert!((ucb - (0.5 + libm::sqrt(2.0 * libm::log(5.0) / 4.0))).abs() < 1e-12);
        // Wilson's upper end: (p + z²/2n + z √(p(1−p)/n + z²/4n²)) / (1 + z²/n)
        let z2 = 1.96 * 1.96;
        let expected =
            (0.5 + z2 / 8.0 + 1.96 * libm::sqrt(0.25 / 4.0 + z2 / 64.0)) / (1.0 + z2 / 4.0);
        let found =
            estimates.score(0, &rule(Strategy::Interval), Payoff::Bernoulli).expect("pulled");
        assert!((found - expected).abs() < 1e-12);
        assert_eq!(
            Bandit::new(&[0.1, 0.7], Payoff::Bernoulli).map(|bandit| bandit.regret(0)),
            Ok(0.7 - 0.1)
        );
        assert!(Bandit::new(&[], Payoff::Gaussian).is_err());
        assert!(Bandit::new(&[0.5, 1.5], Payoff::Bernoulli).is_err());
    }
}
