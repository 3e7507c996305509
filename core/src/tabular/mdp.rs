//! Markov decision processes, section 3.6.
//!
//! Symbols: x state, u action, y next state, P_xu(y) chance of y, r reward, U(x) actions possible in x.

use rand::Rng;

use super::{MdpError, unit};

/// Greatest number of states or of actions.
pub const MOST_STATES: usize = 20_000;
/// Greatest number of actions.
pub const MOST_ACTIONS: usize = 64;
/// How far the chances of a row may be from 1.
const ROUNDING: f64 = 1e-9;

/// One of the things an action may lead to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// Next state y.
    pub next: usize,
    /// Its chance P_xu(y), above 0.
    pub chance: f64,
    /// Reward R(x,u,y).
    pub reward: f64,
}

/// What taking an action in a state leads to.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// State x.
    pub state: usize,
    /// Action u.
    pub action: usize,
    /// The outcomes; their chances sum to 1.
    pub outcomes: Vec<Outcome>,
}

/// What was drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transition {
    /// Next state.
    pub next: usize,
    /// Reward.
    pub reward: f64,
}

/// A finite Markov decision process, checked.
#[derive(Clone, Debug, PartialEq)]
pub struct Mdp {
    states: usize,
    actions: usize,
    /// Where the outcomes of a row begin; one more than there are rows.
    begins: Vec<usize>,
    outcomes: Vec<Outcome>,
    absorbing: Vec<bool>,
}

impl Mdp {
    /// A process from its rows, in any order.
    ///
    /// A pair of state and action without a row is not in U(x), Eq. (3.9). An absorbing state needs no
    /// rows: Eq. (3.10), whatever is done there leads back to it, without reward.
    ///
    /// # Errors
    /// When a row does not sum to 1, names a state or action that does not exist, comes twice, or
    /// holds a number that is not finite; when a state has no action; when there are too many states.
    pub fn new(
        states: usize,
        actions: usize,
        absorbing: &[usize],
        rows: &[Row],
    ) -> Result<Self, MdpError> {
        if !(1..=MOST_STATES).contains(&states) {
            return Err(MdpError::States { found: states });
        }
        if !(1..=MOST_ACTIONS).contains(&actions) {
            return Err(MdpError::Actions { found: actions });
        }
        let mut ends = vec![false; states];
        for &state in absorbing {
            *ends.get_mut(state).ok_or(MdpError::NoSuchState { state })? = true;
        }
        let mut table: Vec<Option<&Row>> = vec![None; states * actions];
        for row in rows {
            check(row, states, actions)?;
            let place = &mut table[row.state * actions + row.action];
            if place.replace(row).is_some() {
                return Err(MdpError::Repeated { state: row.state, action: row.action });
            }
        }
        let mut mdp =
            Self { states, actions, begins: vec![0], outcomes: Vec::new(), absorbing: ends };
        for state in 0..states {
            mdp.add_state(state, &table[state * actions..(state + 1) * actions])?;
        }
        Ok(mdp)
    }

    fn add_state(&mut self, state: usize, rows: &[Option<&Row>]) -> Result<(), MdpError> {
        let ends = self.absorbing[state];
        if !ends && rows.iter().all(Option::is_none) {
            return Err(MdpError::NoAction { state });
        }
        for row in rows {
            if ends {
                self.outcomes.push(Outcome { next: state, chance: 1.0, reward: 0.0 });
            } else if let Some(row) = row {
                self.outcomes.extend(row.outcomes.iter().filter(|outcome| outcome.chance > 0.0));
            }
            self.begins.push(self.outcomes.len());
        }
        Ok(())
    }

    /// Number of states |X|.
    #[must_use]
    pub fn states(&self) -> usize {
        self.states
    }

    /// Number of actions |U|.
    #[must_use]
    pub fn actions(&self) -> usize {
        self.actions
    }

    /// Whether learning ends in a state.
    #[must_use]
    pub fn is_absorbing(&self, state: usize) -> bool {
        self.absorbing[state]
    }

    /// Outcomes of an action; none when it is not in U(x).
    #[must_use]
    pub fn outcomes(&self, state: usize, action: usize) -> &[Outcome] {
        let row = state * self.actions + action;
        &self.outcomes[self.begins[row]..self.begins[row + 1]]
    }

    /// Whether an action is in U(x).
    #[must_use]
    pub fn is_possible(&self, state: usize, action: usize) -> bool {
        !self.outcomes(state, action).is_empty()
    }

    /// U(x).
    pub fn possible(&self, state: usize) -> impl Iterator<Item = usize> {
        (0..self.actions).filter(move |action| self.is_possible(state, *action))
    }

    /// Which actions are possible, states × actions.
    #[must_use]
    pub fn possibilities(&self) -> Vec<bool> {
        (0..self.states * self.actions).map(|row| self.begins[row] < self.begins[row + 1]).collect()
    }

    /// Expected reward of an action, Eq. (3.13).
    #[must_use]
    pub fn expected_reward(&self, state: usize, action: usize) -> f64 {
        // Eq. (3.13): E(r) = Σ_y R(x,y) P_xu(y)
        self.outcomes(state, action).iter().map(|outcome| outcome.chance * outcome.reward).sum()
    }

    /// Draws what an action leads to. A certain outcome draws nothing from the generator.
    ///
    /// # Panics
    /// When the action is not in U(x).
    pub fn sample(&self, state: usize, action: usize, rng: &mut impl Rng) -> Transition {
        let outcomes = self.outcomes(state, action);
        let mut drawn = &outcomes[0];
        if outcomes.len() > 1 {
            let mut left = unit(rng);
            for outcome in outcomes {
                drawn = outcome;
                left -= outcome.chance;
                if left < 0.0 {
                    break;
                }
            }
        }
        Transition { next: drawn.next, reward: drawn.reward }
    }

    /// Whether every row has one outcome.
    #[must_use]
    pub fn is_deterministic(&self) -> bool {
        self.begins.windows(2).all(|ends| ends[1] - ends[0] <= 1)
    }

    /// Fewest transitions from each state to an absorbing one, when chance is kind; none where there is
    /// no way.
    #[must_use]
    pub fn distances(&self) -> Vec<Option<u32>> {
        let ends: Vec<usize> = (0..self.states).filter(|&state| self.absorbing[state]).collect();
        self.distances_to(&ends)
    }

    /// Fewest transitions from each state to one of `ends`, when chance is kind.
    #[must_use]
    pub fn distances_to(&self, ends: &[usize]) -> Vec<Option<u32>> {
        let mut before: Vec<Vec<usize>> = vec![Vec::new(); self.states];
        for state in 0..self.states {
            for action in 0..self.actions {
                for outcome in self.outcomes(state, action) {
                    before[outcome.next].push(state);
                }
            }
        }
        let mut distances = vec![None; self.states];
        let mut front = std::collections::VecDeque::new();
        for &end in ends {
            distances[end] = Some(0);
            front.push_back((end, 0));
        }
        while let Some((state, distance)) = front.pop_front() {
            for &earlier in &before[state] {
                if distances[earlier].is_none() {
                    distances[earlier] = Some(distance + 1);
                    front.push_back((earlier, distance + 1));
                }
            }
        }
        distances
    }

    /// Checks that a discount gives every state a value: below 1 always, and 1 only when an absorbing
    /// state can be reached from everywhere.
    ///
    /// # Errors
    /// Names the discount, or the first state from which no way ends.
    pub fn check_discount(&self, discount: f64) -> Result<(), MdpError> {
        if !(0.0..=1.0).contains(&discount) {
            return Err(MdpError::Discount { found: discount });
        }
        if discount < 1.0 {
            return Ok(());
        }
        match self.distances().iter().position(Option::is_none) {
            Some(state) => Err(MdpError::Endless { state }),
            None => Ok(()),
        }
    }
}

fn check(row: &Row, states: usize, actions: usize) -> Result<(), MdpError> {
    let Row { state, action, outcomes } = row;
    let (state, action) = (*state, *action);
    if state >= states {
        return Err(MdpError::NoSuchState { state });
    }
    if action >= actions {
        return Err(MdpError::NoSuchAction { state, action });
    }
    for outcome in outcomes {
        if outcome.next >= states {
            return Err(MdpError::NoSuchState { state: outcome.next });
        }
        if !(0.0..=1.0).contains(&outcome.chance) {
            return Err(MdpError::Chance {
                state,
                action,
                next: outcome.next,
                found: outcome.chance,
            });
        }
        if !outcome.reward.is_finite() {
            return Err(MdpError::Reward { state, action, next: outcome.next });
        }
    }
    // Eq. (3.5): Σ_y P_xu(y) = 1
    let sum: f64 = outcomes.iter().map(|outcome| outcome.chance).sum();
    if (sum - 1.0).abs() > ROUNDING {
        return Err(MdpError::Sum { state, action, found: sum });
    }
    Ok(())
}
