//! Models of optimality, section 3.3: finite horizon, receding horizon, discounted sum, average reward.

use super::{Mdp, MdpError, planning};

/// A policy's rewards: some at first, then one for ever, as in figure 3.2.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// Name of the policy.
    pub name: String,
    /// Rewards r_0, r_1, ... of the first steps.
    pub lead: Vec<f64>,
    /// Reward of every step after them.
    pub then: f64,
}

impl Chain {
    /// The three policies of figure 3.2: 0, 0 and then 2; five times 0 and then 10; six times 0 and then 11.
    #[must_use]
    pub fn figure_3_2() -> [Self; 3] {
        [("a0", 2, 2.0), ("a1", 5, 10.0), ("a2", 6, 11.0)].map(|(name, zeros, then)| Self {
            name: name.to_owned(),
            lead: vec![0.0; zeros],
            then,
        })
    }

    /// Reward of step t.
    #[must_use]
    pub fn reward(&self, step: usize) -> f64 {
        self.lead.get(step).copied().unwrap_or(self.then)
    }

    /// Finite horizon: what the first h steps pay, linear in between.
    ///
    /// NOTE: Eq. (3.1) sums to t = h, which is h + 1 rewards; the thesis's own numbers (and those of the
    /// paper the example is from) sum h rewards, t = 0 to h − 1.
    #[must_use]
    pub fn finite(&self, horizon: f64) -> f64 {
        let horizon = horizon.max(0.0);
        let mut sum = 0.0;
        let mut left = horizon;
        for reward in &self.lead {
            let share = left.clamp(0.0, 1.0);
            // Eq. (3.1): J = Σ r_t
            sum += share * reward;
            left -= share;
        }
        sum + left * self.then
    }

    /// Infinite horizon, discounted; infinite at γ = 1 where the last reward is not 0.
    #[must_use]
    pub fn discounted(&self, discount: f64) -> f64 {
        let mut factor = 1.0;
        let mut sum = 0.0;
        for reward in &self.lead {
            // Eq. (3.3): J = Σ γᵗ r_t
            sum += factor * reward;
            factor *= discount;
        }
        if self.then.abs() > 0.0 { sum + factor * self.then / (1.0 - discount) } else { sum }
    }

    /// Eq. (3.4): average reward, the limit of the mean; what is paid at first does not count.
    #[must_use]
    pub fn average(&self) -> f64 {
        self.then
    }
}

/// A place where another policy becomes the best.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Value of the parameter.
    pub at: f64,
    /// The best before, by number.
    pub from: usize,
    /// The best after.
    pub to: usize,
}

/// The first of the best of several.
#[must_use]
pub fn first_best(count: usize, of: impl Fn(usize) -> f64) -> usize {
    (1..count).fold(0, |best, other| if of(other) > of(best) { other } else { best })
}

/// Where, between two bounds, the best of `count` curves changes; `grid` places are looked at, and each
/// change is then found by bisection.
#[must_use]
pub fn crossings(
    count: usize,
    bounds: (f64, f64),
    grid: u32,
    curve: impl Fn(usize, f64) -> f64,
) -> Vec<Crossing> {
    let (low, high) = bounds;
    let place = |step: u32| low + (high - low) * f64::from(step) / f64::from(grid);
    let best = |at: f64| first_best(count, |which| curve(which, at));
    let mut found = Vec::new();
    for step in 0..grid {
        let (mut left, mut right) = (place(step), place(step + 1));
        let (from, to) = (best(left), best(right));
        if from == to {
            continue;
        }
        for _ in 0..100 {
            let middle = f64::midpoint(left, right);
            if curve(to, middle) > curve(from, middle) { right = middle } else { left = middle }
        }
        found.push(Crossing { at: f64::midpoint(left, right), from, to });
    }
    found
}

/// Values and policies with n steps to go, n = 0 to h: the non-stationary policy of Eq. (3.1).
#[derive(Clone, Debug, PartialEq)]
pub struct Horizon {
    /// Expected reward of the next n steps, by n and state.
    pub values: Vec<Vec<f64>>,
    /// Action with n steps to go, by n − 1 and state.
    pub policies: Vec<Vec<usize>>,
}

/// Finite horizon on any process, by backward induction.
#[must_use]
pub fn finite_horizon(mdp: &Mdp, horizon: u32) -> Horizon {
    let mut values = vec![vec![0.0; mdp.states()]];
    let mut policies = Vec::new();
    for to_go in 0..horizon as usize {
        let policy = planning::greedy(mdp, 1.0, &values[to_go]);
        let next = (0..mdp.states())
            .map(|state| planning::backup(mdp, state, policy[state], 1.0, &values[to_go]))
            .collect();
        values.push(next);
        policies.push(policy);
    }
    Horizon { values, policies }
}

/// Receding horizon, Eq. (3.2): the agent acts for ever as with h steps to go. h of at least 1.
#[must_use]
pub fn receding(mdp: &Mdp, horizon: u32) -> Vec<usize> {
    finite_horizon(mdp, horizon.max(1)).policies.pop().unwrap_or_default()
}

/// The best average reward and a policy that gains it.
#[derive(Clone, Debug, PartialEq)]
pub struct Average {
    /// Gain of each state: mean reward a step in the long run.
    pub gains: Vec<f64>,
    /// A gain-optimal policy.
    pub policy: Vec<usize>,
}

/// Share of each step that is really taken, so that no cycle has a beat.
const LAZY: f64 = 0.5;
/// Sweeps after which gains that do not settle are given up.
const MOST_SWEEPS: u32 = 100_000;

/// Average reward, Eq. (3.4), by value iteration without discount: V grows by the gain each sweep.
///
/// # Errors
/// When the precision is not above 0, or the gains do not settle.
pub fn average(mdp: &Mdp, precision: f64) -> Result<Average, MdpError> {
    if precision.is_nan() || precision <= 0.0 {
        return Err(MdpError::Precision { found: precision });
    }
    let states = mdp.states();
    let least = u32::try_from(4 * states).unwrap_or(MOST_SWEEPS).min(MOST_SWEEPS / 2);
    let mut values = vec![0.0; states];
    let mut growth = vec![f64::INFINITY; states];
    for sweep in 0..MOST_SWEEPS {
        let last = values.clone();
        let mut unsettled: f64 = 0.0;
        for state in 0..states {
            let best = mdp
                .possible(state)
                .map(|action| planning::backup(mdp, state, action, 1.0, &last))
                .fold(f64::NEG_INFINITY, f64::max);
            // NOTE: half of each step is waiting, which halves the gain and takes the beat out of cycles.
            let grown = LAZY * (best - last[state]);
            unsettled = unsettled.max((grown - growth[state]).abs());
            growth[state] = grown;
            values[state] = last[state] + grown;
        }
        if sweep >= least && unsettled < precision * LAZY {
            let gains = growth.iter().map(|grown| grown / LAZY).collect();
            return Ok(Average { gains, policy: planning::greedy(mdp, 1.0, &values) });
        }
    }
    Err(MdpError::Unsettled { sweeps: MOST_SWEEPS })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::tabular::{Outcome, Row};

    /// Figure 3.2 as a process: the start, and behind each policy its chain with a last state that goes
    /// round.
    fn figure_3_2() -> Mdp {
        let mut rows = Vec::new();
        let mut states = 1;
        for (action, chain) in Chain::figure_3_2().iter().enumerate() {
            let mut state = 0;
            for (step, reward) in chain.lead.iter().enumerate() {
                let outcomes = vec![Outcome { next: states, chance: 1.0, reward: *reward }];
                rows.push(Row { state, action: if step == 0 { action } else { 0 }, outcomes });
                state = states;
                states += 1;
            }
            let outcomes = vec![Outcome { next: state, chance: 1.0, reward: chain.then }];
            rows.push(Row { state, action: 0, outcomes });
        }
        Mdp::new(states, 3, &[], &rows).expect("rows sum to 1")
    }

    #[test]
    fn figure_3_3_at_the_printed_parameters() {
        let chains = Chain::figure_3_2();
        for (h, expected) in [(5.0, [6.0, 0.0, 0.0]), (2.0, [0.0; 3]), (20.0, [36.0, 150.0, 154.0])]
        {
            assert_eq!(chains.clone().map(|chain| chain.finite(h)), expected, "h = {h}");
        }
        for (chain, expected) in chains.iter().zip([16.2, 59.049, 58.4585]) {
            assert!((chain.discounted(0.9) - expected).abs() < 5e-5, "{}", chain.name);
        }
        assert_eq!(chains.map(|chain| chain.average()), [2.0, 10.0, 11.0]);
    }

    #[test]
    fn the_best_policy_changes_where_the_closed_forms_cross() {
        let chains = Chain::figure_3_2();
        let at_horizon = crossings(3, (0.0, 30.0), 120, |which, h| chains[which].finite(h));
        let at_discount =
            crossings(3, (0.0, 0.999), 200, |which, gamma| chains[which].discounted(gamma));
        for (found, expected) in
            [(at_horizon, [5.75, 16.0]), (at_discount, [libm::cbrt(0.2), 10.0 / 11.0])]
        {
            let changes: Vec<_> =
                found.iter().map(|crossing| (crossing.from, crossing.to)).collect();
            assert_eq!(changes, [(0, 1), (1, 2)]);
            for (crossing, at) in found.iter().zip(expected) {
                assert!((crossing.at - at).abs() < 1e-9, "{crossing:?}, expected {at}");
            }
        }
    }

    #[test]
    fn the_process_agrees_with_the_chains() {
        let (mdp, chains) = (figure_3_2(), Chain::figure_3_2());
        let horizon = finite_horizon(&mdp, 20);
        for h in 0..=20 {
            let best = chains.iter().map(|chain| chain.finite(h.into())).fold(0.0, f64::max);
            assert!((horizon.values[h as usize][0] - best).abs() < 1e-12, "h = {h}");
        }
        for (h, action) in [(3, 0), (5, 0), (6, 1), (15, 1), (17, 2)] {
            assert_eq!(receding(&mdp, h)[0], action, "h = {h}");
        }
        let best = average(&mdp, 1e-9).expect("settles");
        assert_eq!(best.policy[0], 2);
        assert!((best.gains[0] - 11.0).abs() < 1e-6, "{}", best.gains[0]);
        assert!((best.gains[1] - 2.0).abs() < 1e-6, "the upper chain can only gain 2");
        for (discount, action) in [(0.5, 0), (0.7, 1), (0.9, 1), (0.95, 2)] {
            let found = planning::policy_iteration(&mdp, discount).expect("γ < 1");
            assert_eq!(found.policy[0], action, "γ = {discount}");
            assert!((found.values[0] - chains[action].discounted(discount)).abs() < 1e-9);
        }
    }

    #[test]
    fn a_cycle_with_a_beat_has_its_mean_as_gain() {
        let row = |state, next, reward| Row {
            state,
            action: 0,
            outcomes: vec![Outcome { next, chance: 1.0, reward }],
        };
        let mdp =
            Mdp::new(3, 1, &[], &[row(0, 1, 3.0), row(1, 2, 0.0), row(2, 0, 6.0)]).expect("good");
        let found = average(&mdp, 1e-10).expect("settles");
        assert!(found.gains.iter().all(|gain| (gain - 3.0).abs() < 1e-6), "{:?}", found.gains);
    }

    proptest! {
        #[test]
        fn finite_sums_agree_with_adding_up(
            lead in proptest::collection::vec(-5.0..5.0f64, 0..8), then in -5.0..5.0f64, h in 0..20usize,
        ) {
            let chain = Chain { name: String::new(), lead, then };
            let sum: f64 = (0..h).map(|step| chain.reward(step)).sum();
            prop_assert!((chain.finite(h as f64) - sum).abs() < 1e-9);
            let gamma: f64 = 0.5;
            let sum: f64 = (0..200).map(|t| libm::pow(gamma, f64::from(t)) * chain.reward(t as usize)).sum();
            prop_assert!((chain.discounted(gamma) - sum).abs() < 1e-9);
        }
    }
}
