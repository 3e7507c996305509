//! An episode: so many trials of Q-learning from a belief matrix, section 4.9.

use std::ops::Range;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::belief::Matrix;
use super::world::{ACTIONS, Action, Labyrinth, STATES, next};
use crate::rng::{Purpose, stream};
use crate::tabular::{
    AdvisorRule, Anneal, AnyWorld, Belief, BeliefError, Compact, CompactRule, CompactTable,
    Exclusion, Exploration, Explorer, LearnerRule, Shaping, Transport, Units, WalkSetup, World,
};

/// What an episode is run with. The default is the one scheme found that both learns and reproduces three
/// of the five published indices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EpisodeRule {
    /// Learning rate β; table 4.2.
    pub rate: f64,
    /// Discount γ; table 4.2.
    pub discount: f64,
    /// Course of τ over the trials of an episode.
    pub anneal: Anneal,
    /// What is learned at the goal.
    pub transport: Transport,
    /// What beliefs do.
    pub exclusion: Exclusion,
    /// Trials an episode; section 4.9.
    pub trials: u32,
    /// Actions after which a trial is broken off.
    pub cap: u32,
}

impl Default for EpisodeRule {
    /// NOTE: chapter 4 prints β, γ and the trials of an episode. The temperature is a gap: τ falls from 30 to
    /// 0.05, by 5 % of the distance a trial, in the form of Eq. (5.17); the three constants are fitted to the
    /// published table, since with a small fixed τ an unbiased learner is far too quick for it and with a
    /// large one it never learns.
    fn default() -> Self {
        Self {
            rate: 0.9,
            discount: 1.0,
            anneal: Anneal { first: 30.0, least: 0.05, keep: 0.95 },
            transport: Transport::StartState,
            exclusion: Exclusion::Strict,
            trials: 100,
            cap: 10_000,
        }
    }
}

/// The trials of one episode.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Episode {
    /// Actions of each trial.
    pub steps: Vec<u32>,
    /// Trials that were broken off at the limit.
    pub capped: u32,
}

impl Episode {
    /// J of one episode, Eq. (4.12): mean actions a trial.
    #[must_use]
    pub fn index(&self) -> f64 {
        // Eq. (4.12), discrete: J = 1/N Σ_i φ_i
        self.tail(self.steps.len())
    }

    /// Eventual time to converge, section 3.4: the first trial (from 1) from which on none takes more than the
    /// best number of actions; none if the last one does.
    #[must_use]
    pub fn converged(&self, best: u32) -> Option<usize> {
        let late = self.steps.iter().rposition(|steps| *steps > best).map_or(0, |last| last + 1);
        (late < self.steps.len()).then_some(late + 1)
    }

    /// Mean actions over the last few trials: the final policy's.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "far fewer trials than 2^53")]
    pub fn tail(&self, trials: usize) -> f64 {
        let last = &self.steps[self.steps.len().saturating_sub(trials)..];
        let sum: u64 = last.iter().map(|steps| u64::from(*steps)).sum();
        sum as f64 / last.len().max(1) as f64
    }
}

/// The labyrinth, packed for [`CompactTable`].
#[must_use]
pub fn compact(labyrinth: &Labyrinth) -> Compact<STATES, ACTIONS> {
    let mut world = Compact {
        next: [[0; ACTIONS]; STATES],
        reward: [[0.0; ACTIONS]; STATES],
        ends: [[false; ACTIONS]; STATES],
    };
    for state in 0..STATES {
        for (action, way) in Action::ALL.iter().enumerate() {
            let to = next(state, *way);
            world.next[state][action] = u8::try_from(to).expect("a state below 16");
            world.ends[state][action] = to == labyrinth.goal();
            world.reward[state][action] = f64::from(u8::from(to == labyrinth.goal()));
        }
    }
    world
}

fn square(rows: &[Vec<f64>]) -> Matrix {
    let mut matrix = [[0.0; ACTIONS]; STATES];
    for (to, from) in matrix.iter_mut().zip(rows) {
        to.copy_from_slice(from);
    }
    matrix
}

/// A belief matrix made ready for a labyrinth.
///
/// # Errors
/// When a number is not finite, or a state that can be reached is left without an action.
pub fn belief(
    matrix: &Matrix,
    labyrinth: &Labyrinth,
    exclusion: Exclusion,
) -> Result<Belief, BeliefError> {
    let rows: Vec<Vec<f64>> = matrix.iter().map(|row| row.to_vec()).collect();
    Belief::new(&rows, exclusion, labyrinth.mdp(), labyrinth.start())
}

impl EpisodeRule {
    fn compact(&self, labyrinth: &Labyrinth) -> CompactRule {
        CompactRule {
            rate: self.rate,
            discount: self.discount,
            temperature: self.anneal.first,
            transport: self.transport,
            start: u8::try_from(labyrinth.start()).expect("a state below 16"),
            cap: self.cap,
        }
    }

    /// Trials from a table, which is left as they made it; `first_stream` numbers the random streams.
    pub(super) fn trials(
        &self,
        labyrinth: &Labyrinth,
        table: &mut CompactTable<STATES, ACTIONS>,
        seed: u64,
        first_stream: u32,
    ) -> Episode {
        let world = compact(labyrinth);
        let mut rule = self.compact(labyrinth);
        let mut episode = Episode { steps: Vec::with_capacity(self.trials as usize), capped: 0 };
        for trial in 0..self.trials {
            let mut units = Units::new(stream(seed, first_stream + trial, Purpose::Selection));
            let (steps, ended) = table.trial(&world, &rule, &mut units);
            episode.steps.push(steps);
            episode.capped += u32::from(!ended);
            rule.temperature = self.anneal.next(rule.temperature);
        }
        episode
    }
}

pub(super) fn table(belief: &Belief) -> CompactTable<STATES, ACTIONS> {
    CompactTable::new(square(&belief.initial), square(&belief.weights))
}

/// Runs episodes, each from the belief matrix anew. Episode e draws from the streams of trials
/// `e · trials` on, whatever the range it is run in, so that ranges can be shared among threads.
///
/// # Errors
/// When a state that can be reached is left without an action.
///
/// # Panics
/// When a temperature is not above 0.
pub fn episodes(
    labyrinth: &Labyrinth,
    matrix: &Matrix,
    rule: &EpisodeRule,
    seed: u64,
    range: Range<u32>,
) -> Result<Vec<Episode>, BeliefError> {
    assert!(rule.anneal.first > 0.0 && rule.anneal.least > 0.0, "temperatures are above 0");
    let belief = belief(matrix, labyrinth, rule.exclusion)?;
    let run = |episode| rule.trials(labyrinth, &mut table(&belief), seed, episode * rule.trials);
    Ok(range.map(run).collect())
}

/// The same episode as a walk, one step at a time and with every number of each update.
///
/// # Errors
/// When a state that can be reached is left without an action.
pub fn walk_setup(
    labyrinth: &Labyrinth,
    matrix: &Matrix,
    rule: &EpisodeRule,
) -> Result<WalkSetup, BeliefError> {
    Ok(WalkSetup {
        rule: LearnerRule {
            rate: rule.rate,
            discount: rule.discount,
            transport: rule.transport,
            ..LearnerRule::default()
        },
        exploration: Exploration { explorer: Explorer::Softmax, anneal: rule.anneal },
        belief: belief(matrix, labyrinth, rule.exclusion)?,
        world: Arc::new(AnyWorld::Labyrinth(labyrinth.clone())),
        modules: false,
        reflex: None,
        shaping: Shaping::default(),
        advice: String::new(),
        advisor: AdvisorRule::default(),
        cap: rule.cap,
    })
}

#[cfg(test)]
mod tests {
    use super::super::belief::{Bias, Readings, matrix};
    use super::*;
    use crate::tabular::Walk;

    #[test]
    fn the_packed_and_the_explained_run_agree_to_the_bit() {
        let labyrinth = Labyrinth::of_the_thesis();
        let fitted = EpisodeRule::default().anneal;
        // Cold enough that chances lie hundreds of powers of two apart, and grow away from the first ones.
        let cold = Anneal { first: 0.002, least: 0.002, keep: 1.0 };
        for (bias, transport, exclusion, anneal) in [
            (Bias::B0, Transport::StartState, Exclusion::Strict, fitted),
            (Bias::B11, Transport::StartState, Exclusion::Weight, fitted),
            (Bias::B31, Transport::GoalState, Exclusion::Strict, fitted),
            (Bias::B10, Transport::Terminal, Exclusion::InitialOnly, fitted),
            (Bias::B0, Transport::StartState, Exclusion::Strict, cold),
            (Bias::B11, Transport::GoalState, Exclusion::Weight, cold),
        ] {
            let beliefs = matrix(bias, 15, &Readings::default());
            let rule = EpisodeRule {
                anneal,
                transport,
                exclusion,
                trials: 40,
                cap: 2_000,
                ..EpisodeRule::default()
            };
            let packed = episodes(&labyrinth, &beliefs, &rule, 5, 3..4).expect("actions are left");
            let setup = walk_setup(&labyrinth, &beliefs, &rule).expect("actions are left");
            let mut walk = Walk::new(setup, 5, 120).expect("good");
            let steps: Vec<u32> = (0..40).map(|_| walk.trial().steps).collect();
            assert_eq!(packed[0].steps, steps, "{bias:?} {transport:?} {exclusion:?} {anneal:?}");
            let mut table = table(&belief(&beliefs, &labyrinth, exclusion).expect("left"));
            rule.trials(&labyrinth, &mut table, 5, 120);
            let values = walk.learner().table().expect("Q").rows();
            assert_eq!(square(&values), table.values(), "{bias:?} {anneal:?}");
        }
    }

    #[test]
    fn the_time_to_converge_is_that_after_the_last_long_trial() {
        let of = |steps: &[u32]| Episode { steps: steps.to_vec(), capped: 0 }.converged(5);
        let found = [of(&[9, 5, 7, 5, 5]), of(&[5, 5]), of(&[5, 6]), of(&[])];
        assert_eq!(found, [Some(4), Some(1), None, None]);
    }

    #[test]
    fn an_episode_does_not_depend_on_its_range() {
        let labyrinth = Labyrinth::of_the_thesis();
        let (beliefs, rule) = (matrix(Bias::B0, 15, &Readings::default()), EpisodeRule::default());
        let all = episodes(&labyrinth, &beliefs, &rule, 9, 0..4).expect("left");
        assert_eq!(all[2..], episodes(&labyrinth, &beliefs, &rule, 9, 2..4).expect("left"));
        assert_ne!(all, episodes(&labyrinth, &beliefs, &rule, 10, 0..4).expect("left"));
    }

    #[test]
    fn a_trial_that_cannot_end_is_broken_off_and_counted() {
        let labyrinth = Labyrinth::of_the_thesis();
        // Only turns are left, so no cell is ever changed.
        let mut beliefs = [[1.0; ACTIONS]; STATES];
        beliefs.iter_mut().for_each(|row| row[1] = -1.0);
        let rule = EpisodeRule { cap: 50, trials: 3, ..EpisodeRule::default() };
        let found = episodes(&labyrinth, &beliefs, &rule, 1, 0..1).expect("turns are left");
        assert_eq!(found, [Episode { steps: vec![50; 3], capped: 3 }]);
        beliefs[7] = [-1.0; ACTIONS];
        let error =
            episodes(&labyrinth, &beliefs, &rule, 1, 0..1).expect_err("nothing left at the start");
        assert_eq!(error, BeliefError::NothingLeft { state: 7 });
    }
}
