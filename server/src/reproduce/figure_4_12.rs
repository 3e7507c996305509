//! Figure 4.12: continual learning, section 4.10, and its promise of no interference.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use sonarium_core::experiment::ContinualSettings;
use sonarium_core::labyrinth::{EPISODES, Episode, Labyrinth, continual, gain, gains};
use sonarium_core::stats::{Bound, Estimate};

use super::episodes::{broken, curve, last_ten, value};
use super::table_4_3::TRIALS;
use super::{
    Arm, Findings, Origin, PUBLISHED, ReproductionError, Row, Sets, Target, Unit, required,
};
use crate::wire::ReproductionRow;

/// Figure 4.12.
pub static FIGURE_4_12: Target = Target {
    name: "figure-4.12",
    title: "Learning from scratch and going on",
    compares: "A learner trained for goal 15 that goes on with goal 2, against one that begins there, and the \
               same for each of the other goals: one experiment of ten episodes in the thesis, 100 such \
               experiments in each of four ways to choose what the thesis leaves open here",
    source: "Figure 4.12, section 4.10",
    readings: &[
        "Chapter 4 prints no temperature and does not say what becomes of it when the goal moves. \
         \"annealed anew\": the scheme fitted to table 4.3, which begins anew with the new goal. \"kept cold\": \
         the same, its temperature left at 0.05; goal 2 only. The other two have a small fixed temperature, \
         a discount of 0.95 instead of the printed 1, and end a trial at the goal",
        "With γ = 1 loops of equal value are never unlearned at a small temperature: trials run into the \
         limit of 300 actions, so that the loss there is a lower bound",
        "\"in no instance did earlier training interfered\" is read twice: for each goal, as a gain that is \
         not below 0; and as no loss for any of the 14 goals in one experiment",
        "A published gain comes from one experiment of ten episodes: it is held against our mean and against \
         the interval in which one such experiment lies with 95 %",
    ],
    rules: &[PUBLISHED, Bound::RULE],
    experiment: "continual",
    arms: ARMS,
    unit: Unit::Experiment,
    trials: TRIALS,
    seeds: 700_000..=700_099,
    find,
};

const ARMS: &[Arm] = &[
    Arm { name: "annealed anew", settings: &[("all_goals", "true")] },
    Arm { name: "kept cold", settings: &[("exploration.restart", "false")] },
    Arm {
        name: "γ 0.95, τ 0.05",
        settings: &[
            ("all_goals", "true"),
            ("learner.transport", "terminal"),
            ("learner.discount", "0.95"),
            ("exploration.first", "0.05"),
            ("exploration.least", "0.05"),
        ],
    },
    Arm {
        name: "γ 0.95, τ 0.1",
        settings: &[
            ("all_goals", "true"),
            ("learner.transport", "terminal"),
            ("learner.discount", "0.95"),
            ("exploration.first", "0.1"),
            ("exploration.least", "0.1"),
        ],
    },
];

/// Episodes for one new goal, seed by seed.
#[derive(Debug, Default)]
struct Shift {
    scratch: Vec<Episode>,
    continual: Vec<Episode>,
}

/// All experiments of one arm.
struct Shifts {
    arm: Arm,
    seeds: RangeInclusive<u64>,
    /// By new goal.
    goals: BTreeMap<usize, Shift>,
}

impl Origin for Shifts {
    fn arm(&self) -> &str {
        self.arm.name
    }

    fn words(&self) -> String {
        let settings: Vec<String> =
            self.arm.settings.iter().map(|(key, value)| format!("{key}={value}")).collect();
        let (first, last) = (self.seeds.start(), self.seeds.end());
        format!("Continual learning with {}, seeds {first}..{last}", settings.join(", "))
    }
}

fn find(target: &Target, sets: &Sets<'_>) -> Result<Findings, ReproductionError> {
    let mut findings = Findings::default();
    for arm in target.arms {
        let shifts = run(target, sets, arm)?;
        if let Some(shift) = shifts.goals.get(&PUBLISHED_GOAL) {
            findings.rows.extend(rows(&shifts, shift));
            for (quantity, episodes) in
                [("actions from scratch", &shift.scratch), ("actions going on", &shift.continual)]
            {
                findings.curves.push(curve(arm.name, quantity, episodes));
            }
        }
        if shifts.goals.len() > 1 {
            findings.rows.extend(interference(&shifts));
        }
    }
    Ok(findings)
}

/// The goal of figure 4.12.
const PUBLISHED_GOAL: usize = 2;

fn run(target: &Target, sets: &Sets<'_>, arm: &Arm) -> Result<Shifts, ReproductionError> {
    let mut settings = ContinualSettings { trials: target.trials, ..ContinualSettings::default() };
    for (key, text) in arm.settings {
        settings.set(key, &value(arm, text)?).map_err(|error| broken(arm, error))?;
    }
    let labyrinth =
        |goal| Labyrinth::new(settings.start as usize, goal).map_err(|error| broken(arm, error));
    let first = labyrinth(settings.goal as usize)?;
    let new: Vec<(usize, Labyrinth)> = (settings.new_goals().into_iter())
        .map(|goal| Ok((goal, labyrinth(goal)?)))
        .collect::<Result<_, ReproductionError>>()?;
    let (rule, range) = (settings.rule(), 0..u32::try_from(EPISODES).unwrap_or(u32::MAX));
    let seeds: Vec<u64> = target.seeds.clone().collect();
    let experiments = sets.each(&seeds, |&seed| {
        let tasks = new.iter().map(|(goal, second)| {
            let found = continual(&first, second, &rule, seed, range.clone());
            found.map(|found| (*goal, found)).map_err(|error| broken(arm, error))
        });
        tasks.collect::<Result<Vec<_>, _>>()
    })?;
    let mut goals: BTreeMap<usize, Shift> = BTreeMap::new();
    for (goal, found) in experiments.into_iter().flatten() {
        let shift = goals.entry(goal).or_default();
        for episode in found {
            shift.scratch.push(episode.scratch);
            shift.continual.push(episode.continual);
        }
    }
    Ok(Shifts { arm: *arm, seeds: target.seeds.clone(), goals })
}

/// What the thesis says about goal 2.
fn rows(shifts: &Shifts, shift: &Shift) -> Vec<ReproductionRow> {
    let Shift { scratch, continual } = shift;
    let single = gains(continual, scratch);
    let end = |episodes: &[Episode]| {
        Estimate::mean(&episodes.chunks_exact(EPISODES).map(last_ten).collect::<Vec<f64>>())
    };
    let found = [
        (GAIN, gain(continual, scratch).map(|gain| gain.mean)),
        (SINGLE, Estimate::single(&single)),
        (LOW, Estimate::quantile(&single, 0.05)),
        (HIGH, Estimate::quantile(&single, 0.95)),
        (LAST_SCRATCH, end(scratch)),
        (LAST_CONTINUAL, end(continual)),
        (BROKEN_OFF, broken_off_pct(continual)),
    ];
    found.iter().filter_map(|(row, ours)| row.of(shifts, *ours)).collect()
}

/// Share of trials that ran into the limit of actions, percent.
fn broken_off_pct(episodes: &[Episode]) -> Option<Estimate> {
    let share = |experiment: &[Episode]| {
        let trials: usize = experiment.iter().map(|episode| episode.steps.len()).sum();
        let capped: u32 = experiment.iter().map(|episode| episode.capped).sum();
        100.0 * f64::from(capped) / trials.max(1) as f64
    };
    Estimate::mean(&episodes.chunks_exact(EPISODES).map(share).collect::<Vec<f64>>())
}

/// The gain of each goal, which must not be a loss, and of all together.
fn interference(shifts: &Shifts) -> Vec<ReproductionRow> {
    let mut rows = Vec::new();
    let mut worst: Vec<f64> = Vec::new();
    for (goal, Shift { scratch, continual }) in &shifts.goals {
        let ours = gain(continual, scratch).map(|gain| gain.mean);
        let name = format!("gain, goal {goal}");
        let bound = Some(Bound::AtLeast(0.0));
        rows.extend(required::row(shifts, (&name, "%"), ours, bound, NO_LOSS));
        let single = gains(continual, scratch);
        worst.resize(single.len(), f64::INFINITY);
        worst.iter_mut().zip(single).for_each(|(worst, gain)| *worst = worst.min(gain));
    }
    let unharmed = worst.iter().filter(|gain| **gain >= 0.0).count();
    let share = Estimate::proportion(unharmed, worst.len()).map(|share| share.scaled(100.0));
    rows.extend(NONE_LOSES.of(shifts, share));
    rows
}

const GAIN: Row<'_> = Row {
    name: "gain of going on, goal 2",
    published: Some(31.9),
    unit: "%",
    reading: "Eq. (4.13) with the learner from scratch in the place of the unbiased one, from the mean J of all \
              experiments; interval of its mean over experiments, Student's t",
};
const SINGLE: Row<'_> = Row {
    name: "gain of one experiment of ten episodes, goal 2",
    published: Some(31.9),
    unit: "%",
    reading: "the same of single experiments: their median, and the interval that holds the middle 95 % of \
              them",
};
const LOW: Row<'_> = Row {
    name: "gain of one experiment, goal 2, 5th percentile",
    published: None,
    unit: "%",
    reading: "one experiment in twenty gains less; interval of order statistics",
};
const HIGH: Row<'_> = Row {
    name: "gain of one experiment, goal 2, 95th percentile",
    published: None,
    unit: "%",
    reading: "one experiment in twenty gains more; interval of order statistics",
};
const LAST_SCRATCH: Row<'_> = Row {
    name: "actions of the last ten trials from scratch, goal 2",
    published: Some(2.0),
    unit: "",
    reading: "\"at steady state both experiments arrived at this same value\" read as a mean of 2 over trials 91 \
              to 100; mean over experiments, Student's t interval; a softmax learner still tries other \
              actions there now and then",
};
const LAST_CONTINUAL: Row<'_> =
    Row { name: "actions of the last ten trials going on, goal 2", ..LAST_SCRATCH };
const BROKEN_OFF: Row<'_> = Row {
    name: "trials broken off at 300 actions going on, goal 2",
    published: None,
    unit: "%",
    reading: "the thesis knows of none; where there are any, the gain is only a bound; mean over experiments, \
              Student's t interval",
};
const NO_LOSS: &str = "\"in no instance did earlier training interfered and caused continual learning to perform \
    inferior\" read as a gain that is not below 0; Eq. (4.13) from the mean J of all experiments, interval of \
    its mean over experiments, Student's t";
const NONE_LOSES: Row<'_> = Row {
    name: "experiments in which no goal loses",
    published: Some(100.0),
    unit: "%",
    reading: "the same read as: the gain of none of the 14 goals is below 0, in every experiment of ten \
              episodes a goal; exact interval of Clopper and Pearson",
};

#[cfg(test)]
mod tests;
