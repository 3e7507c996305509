//! Experiments in the labyrinth of chapter 4, one a seed: ten episodes each, as behind every point of
//! figures 4.10 and 4.11.

use std::fmt::Display;
use std::ops::Range;
use std::sync::Arc;

use serde_json::Value as Json;
use sonarium_core::experiment::LabyrinthSettings;
use sonarium_core::labyrinth::{
    Bias, Contestant, EPISODES, Episode, EpisodeRule, episodes, matrix, table_4_3,
};
use sonarium_core::settings::Value;
use sonarium_core::stats::{self, Estimate};

use super::curve::mean_at;
use super::{Arm, Origin, ReproductionError, Sets, Target};
use crate::catalog::from_text;
use crate::wire::{ReproductionCurve, ReproductionPoint};

/// Name of the experiment.
pub(super) const LABYRINTH: &str = "labyrinth";

/// The unbiased learner, with which every bias is compared.
pub(super) const B0: Arm = Arm { name: "B0", settings: &[] };
pub(super) const B10: Arm = Arm { name: "B10", settings: &[] };
pub(super) const B11: Arm = Arm { name: "B11", settings: &[] };
pub(super) const B11_CHANCE: Arm =
    Arm { name: "B11, chance 0.5", settings: &[("belief.exclusion", "weight")] };
pub(super) const B11_FITTED: Arm = Arm {
    name: "B11, chance 0.75",
    settings: &[("belief.exclusion", "weight"), ("belief.lowered", "0.75")],
};
pub(super) const B2: Arm = Arm { name: "B2", settings: &[] };
pub(super) const B2_WEST: Arm =
    Arm { name: "B2, west to east", settings: &[("belief.insight", "west-to-east")] };
pub(super) const B2_AWAY: Arm = Arm { name: "B2, away", settings: &[("belief.insight", "away")] };
pub(super) const B2_TURNS: Arm =
    Arm { name: "B2, turns away", settings: &[("belief.insight", "turns-away")] };
pub(super) const B30: Arm = Arm { name: "B30", settings: &[] };
pub(super) const B31: Arm = Arm { name: "B31", settings: &[] };

/// How the biases are read, and what else chapter 4 leaves open.
pub(super) const SCHEME: &str = "The temperature is a gap: chapter 4 prints none. It falls from 30 to 0.05, \
    by 5 % of the distance a trial, in the form of Eq. (5.17); the three constants were fitted to table \
    4.3 on other seeds, since at a small fixed temperature the unbiased learner is far too quick for the \
    table and at a great one it never learns";
pub(super) const SIGN: &str = "Eq. (4.11) is read with e^{+Q/τ}: as printed it prefers the worst action, and no \
    learner learns anything; a belief below 0 excludes its action for good; at the goal the value of the \
    start is looked ahead to, where the robot is transported";
pub(super) const READ_B11: &str = "B11 is the printed matrix as first Q-values; in \"B11, chance 0.5\" the 0.5 \
    multiplies the chance of its action too, and in \"B11, chance 0.75\" 0.75 does, which is fitted: both \
    were chosen because the literal reading does not come out";
pub(super) const READ_B2: &str = "B2 is printed for one cell: it leaves {right right} out where that turns \
    towards the goal, in every cell; \"B2, west to east\" repeats the printed example instead of continuing \
    it. \"B2, away\" leaves {right right} out where it turns away from the goal, and \"B2, turns away\" the \
    turn away from the goal wherever the robot faces a wall: both contradict the printed example and were \
    chosen because the literal ones do not come out";
pub(super) const READ_GOAL: &str =
    "B30 and B31 exclude what they do not supply; the figure's other entries are not in the text";

/// All experiments of one arm.
#[derive(Clone, Debug)]
pub struct Course {
    /// The arm; its name begins with that of its bias.
    pub arm: Arm,
    /// First and last seed.
    pub seeds: [u64; 2],
    /// The bias and how it is read.
    pub contestant: Contestant,
    /// Ten episodes a seed, in the order of the seeds.
    pub episodes: Vec<Episode>,
}

impl Sets<'_> {
    /// The experiments of an arm; run once for all targets that share what is kept.
    ///
    /// # Errors
    /// When the arm's settings do not fit, or name no reading that is known.
    pub fn course(&self, target: &Target, arm: &Arm) -> Result<Arc<Course>, ReproductionError> {
        let Target { experiment, trials, seeds, .. } = target;
        let key = format!("{experiment} {arm:?} {trials} {seeds:?}");
        self.once(target, key, || self.run_course(target, arm))
    }

    fn run_course(&self, target: &Target, arm: &Arm) -> Result<Course, ReproductionError> {
        let settings = settings(arm)?;
        let (place, contestant) = contestant(arm, &settings)?;
        let rule = EpisodeRule { trials: target.trials, ..settings.rule() };
        let labyrinth = settings.labyrinth().map_err(|error| broken(arm, error))?;
        let beliefs = matrix(contestant.bias, labyrinth.goal(), &contestant.readings);
        let seeds: Vec<u64> = target.seeds.clone().collect();
        let range = own_episodes(place);
        let experiments = self.each(&seeds, |&seed| {
            episodes(&labyrinth, &beliefs, &rule, seed, range.clone())
                .map_err(|error| broken(arm, error))
        })?;
        let seeds = [*target.seeds.start(), *target.seeds.end()];
        Ok(Course { arm: *arm, seeds, contestant, episodes: experiments.concat() })
    }
}

/// The settings of the experiment `labyrinth` for an arm.
pub(super) fn settings(arm: &Arm) -> Result<LabyrinthSettings, ReproductionError> {
    let mut settings = LabyrinthSettings::default();
    for (key, text) in arm.settings {
        settings.set(key, &value(arm, text)?).map_err(|error| broken(arm, error))?;
    }
    Ok(settings)
}

/// A setting's value as the core takes it.
pub(super) fn value(arm: &Arm, text: &str) -> Result<Value, ReproductionError> {
    let json: Json = from_text(text);
    serde_json::from_value(json).map_err(|error| broken(arm, error))
}

/// Numbers of the episodes of an experiment. Every bias and reading has its own, so that no two draw the same
/// numbers: what they have in common would make single experiments look more alike than they are.
fn own_episodes(place: usize) -> Range<u32> {
    let episodes = |places: usize| u32::try_from(places * EPISODES).unwrap_or(u32::MAX);
    episodes(place)..episodes(place + 1)
}

/// The bias an arm is named after, in the reading of its settings, with its place among all there are.
pub(super) fn contestant(
    arm: &Arm,
    settings: &LabyrinthSettings,
) -> Result<(usize, Contestant), ReproductionError> {
    let name = arm.name.split(", ").next().unwrap_or_default();
    let found = table_4_3().into_iter().enumerate().find(|(_, contestant)| {
        contestant.bias.name() == name
            && contestant.readings == settings.readings()
            && contestant.exclusion == settings.exclusion
    });
    found.ok_or_else(|| broken(arm, "no such bias and reading"))
}

/// An arm that cannot be run.
pub(super) fn broken(arm: &Arm, error: impl Display) -> ReproductionError {
    ReproductionError::Broken(format!("{}: {error}", arm.name))
}

impl Origin for Course {
    fn arm(&self) -> &str {
        self.arm.name
    }

    fn words(&self) -> String {
        let Contestant { bias, reading, literal, .. } = self.contestant;
        let [first, last] = self.seeds;
        let chosen = if literal { "" } else { ", chosen after the fact" };
        format!("{}, {reading}{chosen}, seeds {first}..{last}", bias.name())
    }
}

impl Course {
    /// The bias.
    #[must_use]
    pub fn bias(&self) -> Bias {
        self.contestant.bias
    }

    /// One number an experiment.
    #[must_use]
    pub fn values(&self, of: impl Fn(&[Episode]) -> f64) -> Vec<f64> {
        self.episodes.chunks_exact(EPISODES).map(of).collect()
    }

    /// Mean of one number an experiment.
    #[must_use]
    pub fn mean(&self, of: impl Fn(&[Episode]) -> f64) -> Option<Estimate> {
        Estimate::mean(&self.values(of))
    }
}

/// J, Eq. (4.12): mean actions a trial of an experiment's episodes.
pub(super) fn index(experiment: &[Episode]) -> f64 {
    mean_of(experiment, Episode::index)
}

/// Mean actions over the last ten trials of an experiment's episodes.
pub(super) fn last_ten(experiment: &[Episode]) -> f64 {
    mean_of(experiment, |episode| episode.tail(10))
}

fn mean_of(experiment: &[Episode], of: impl Fn(&Episode) -> f64) -> f64 {
    stats::mean(&experiment.iter().map(of).collect::<Vec<f64>>()).unwrap_or(f64::NAN)
}

/// Mean actions of one trial, from 0, over an experiment's episodes: a point of the thesis's curves.
fn actions(experiment: &[Episode], trial: usize) -> f64 {
    mean_of(experiment, |episode| episode.steps.get(trial).copied().map_or(f64::NAN, f64::from))
}

/// The first trial, from 1, from which on an experiment's curve stays at or below so many actions; one
/// more than there are where it does not.
pub(super) fn settled(experiment: &[Episode], most: f64) -> f64 {
    let trials = experiment.first().map_or(0, |episode| episode.steps.len());
    let above = (0..trials).rev().find(|trial| actions(experiment, *trial) > most);
    above.map_or(1.0, |last| last as f64 + 2.0)
}

/// The learning curve of experiments: actions a trial.
pub(super) fn curve(arm: &str, quantity: &str, episodes: &[Episode]) -> ReproductionCurve {
    let trials = episodes.first().map_or(0, |episode| episode.steps.len());
    let point = |trial: usize| {
        let experiments = episodes.chunks_exact(EPISODES);
        let sample: Vec<f64> = experiments.map(|experiment| actions(experiment, trial)).collect();
        let end = |share| Estimate::quantile(&sample, share).map(|quantile| quantile.value);
        ReproductionPoint {
            least: end(0.05),
            greatest: end(0.95),
            ..mean_at((trial + 1) as f64, &sample)
        }
    };
    ReproductionCurve {
        arm: arm.into(),
        quantity: quantity.into(),
        unit: String::new(),
        x_name: "trial".into(),
        band: format!("95 % interval of the mean over {} experiments", episodes.len() / EPISODES),
        bars: "5th to 95th percentile of single experiments of ten episodes".into(),
        points: (0..trials).map(point).collect(),
    }
}
