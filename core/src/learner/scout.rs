//! A second look (addition A6): scouts that look for another way altogether.
//!
//! NOTE (A6): shortcuts better the record path piece by piece and seldom lead to the other side of an
//! obstacle. Two scouts set out with empty networks, what was learned laid aside: straight for the goal,
//! and where there is no room along the obstacle, the first with the obstacle on its right and the second
//! with it on its left. What a scout finds is a record path like any other and is bettered in the trial
//! after it; then the better of the two memories is kept. A scout that needs half as many steps again as the
//! record gives up, takes up what was laid aside, and goes back to the record path.

use serde::{Deserialize, Serialize};

use super::{LearnerSettings, Memory, Network};

/// Scouts, one after the other.
const SCOUTS: u32 = 2;
/// Trials of each: the scout's own, and one that betters what it found.
const TRIALS: u32 = 2;
/// So many times the steps of the record a scout may take; tuned, as are the two above.
const PATIENCE: f64 = 1.5;

/// A scout's search.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Scouting {
    /// The trial in which the scout sets out.
    trial: u32,
    /// It turns to the left where there is no room.
    left: bool,
    /// What was learned before.
    aside: Box<Memory>,
}

impl Memory {
    /// Which way the scout turns, in the trial in which it is under way: to the left or not.
    pub(super) fn scout_turns_left(&self) -> Option<bool> {
        let scouting = self.scouting.as_ref();
        scouting.filter(|scouting| scouting.trial == self.trials + 1).map(|scouting| scouting.left)
    }

    /// Whether a scout has searched too long after so many steps.
    pub(super) fn has_scouted_enough(&self, steps: u32) -> bool {
        let scouting = self.scouting.as_ref().filter(|_| self.scout_turns_left().is_some());
        scouting.is_some_and(|scouting| {
            f64::from(steps) > PATIENCE * scouting.aside.record.len() as f64
        })
    }

    /// Takes up what was laid aside; what only counts goes on.
    pub(super) fn stop_scouting(&mut self) {
        let Some(scouting) = self.scouting.take() else { return };
        let Self { next_neuron, temperature_deg, first_success, trials, ticks, .. } = *self;
        *self =
            Self { next_neuron, temperature_deg, first_success, trials, ticks, ..*scouting.aside };
    }

    /// After a trial: ends a search that is over; its find is kept if it is the better one.
    pub(super) fn judge_scout(&mut self) {
        let over = |scouting: &Scouting| self.trials + 1 >= scouting.trial + TRIALS;
        if self.scouting.as_ref().is_some_and(over) {
            if self.is_better_than_aside() {
                self.scouting = None;
            } else {
                self.stop_scouting();
            }
        }
    }

    /// Before a trial: sends out a scout if one is due.
    pub(super) fn send_scout(&mut self, settings: &LearnerSettings) {
        let since = (self.trials + 1).checked_sub(settings.scout_from);
        let is_due = |since: &u32| since.is_multiple_of(TRIALS) && since / TRIALS < SCOUTS;
        let Some(since) = since.filter(|since| settings.scout_from > 0 && is_due(since)) else {
            return;
        };
        if self.scouting.is_none() && !self.record.is_empty() {
            let networks = vec![Network::default(); self.networks.len()];
            let aside = Box::new(self.clone());
            let (trial, left) = (self.trials + 1, since < TRIALS);
            self.scouting = Some(Scouting { trial, left, aside });
            (self.networks, self.best) = (networks, None);
            self.record.clear();
        }
    }

    /// Whether the best path found since is better than that laid aside, if any was.
    fn is_better_than_aside(&self) -> bool {
        let before = self.scouting.as_ref().and_then(|scouting| scouting.aside.best);
        self.best.is_some_and(|best| before.is_none_or(|before| best > before))
    }

    /// The networks with the best path: those laid aside, while the search has found no better one.
    pub(crate) fn best_networks(&self) -> &[Network] {
        match &self.scouting {
            Some(scouting) if !self.is_better_than_aside() => &scouting.aside.networks,
            _ => &self.networks,
        }
    }

    /// Whether a record of these networks is one of all trials. What a scout finds is learned from as a record
    /// whether it is or not.
    pub(super) fn holds_the_record(&self) -> bool {
        self.scouting.is_none() || self.is_better_than_aside()
    }
}
