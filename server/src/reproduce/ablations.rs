//! What the default preset has to achieve, and what is lost when each of its differences from the thesis
//! is switched off alone.

use std::ops::RangeInclusive;

use sonarium_core::stats::{Bound, Estimate};

use super::office;
use super::required::{row, success_pct};
use super::{Arm, Findings, ReproductionError, Sample, Set, Sets, Target, Unit, curve};
use crate::catalog::{DEFAULT_TRIALS, MINIMUM_COST_PATH};
use crate::wire::{ReproductionRow, Trial};

/// The claim, and each difference switched off.
pub static ABLATIONS: Target = Target {
    name: "ablations",
    title: "The claim, and what each difference is worth",
    compares: "The default preset against what is required of it, and, on the same seeds, the same \
               learner with one of its differences from the thesis switched off",
    source: "The claim of chapter 5; the requirements are this project's own",
    readings: &[
        "An arm is compared with the default preset in the same world and under the same flaws set by set, on the same seeds: \
         the difference is worth its place when all of the interval of what is lost without it is above 0",
        "Trials needed: the first trial that reaches the goal in at most 1.1 times the steps that the \
         default preset needs in the last trial in that world, in the median; one more than there are \
         where none does",
        office::READING,
    ],
    rules: &[Bound::RULE],
    experiment: MINIMUM_COST_PATH,
    arms: ARMS,
    unit: Unit::Set,
    trials: DEFAULT_TRIALS,
    seeds: ABLATION_SEEDS,
    find,
};

/// Seeds, one a set. Fewer than 368 sets could not tell a success of 99 % even if all succeeded.
const ABLATION_SEEDS: RangeInclusive<u64> = 700_000..=700_399;

/// Each world, and each flaw of the sensors, begins with the default preset.
const ARMS: &[Arm] = &[
    Arm { name: "default", settings: &[] },
    Arm { name: "bare reflex", settings: &[("preset", "reflex")] },
    Arm {
        name: "no critic (5.20, 5.25, 5.26)",
        settings: &[("learner.temporal_difference", "false"), ("learner.backtrack", "false")],
    },
    Arm {
        name: "no TD learning (5.20, 5.25)",
        settings: &[("learner.temporal_difference", "false")],
    },
    Arm { name: "no back-tracking (5.26)", settings: &[("learner.backtrack", "false")] },
    Arm { name: "no replacement (5.28)", settings: &[("learner.replacement", "off")] },
    Arm { name: "R1: rotations stored", settings: &[("learner.action_frame", "rotation")] },
    Arm { name: "D1: whole σ", settings: &[("learner.sigma_scale", "1")] },
    Arm { name: "D2: new neurons ask the reflex", settings: &[("learner.new_neuron", "reflex")] },
    Arm { name: "D3: nothing forgotten", settings: &[("learner.forget_unrecorded", "false")] },
    Arm { name: "D4: always exploring", settings: &[("learner.exploit_from", "0")] },
    Arm { name: "A1: no shortcuts", settings: &[("learner.mean_update", "off")] },
    Arm { name: "A1: Eq. (5.24) instead", settings: &[("learner.mean_update", "gradient")] },
    Arm { name: "A1: farthest in view, no critic", settings: &[("shortcut.judge", "farthest")] },
    Arm { name: "A1: not moved off walls", settings: &[("shortcut.push", "false")] },
    Arm { name: "A2: shortcuts not carried on", settings: &[("shortcut.carry", "off")] },
    Arm { name: "A2: carried on, not handed over", settings: &[("shortcut.carry", "way")] },
    Arm { name: "A3: no bends", settings: &[("shortcut.bend", "false")] },
    Arm { name: "A4: no steps aside", settings: &[("learner.sidestep", "0")] },
    Arm { name: "A5: no escape", settings: &[("learner.escape_after", "0")] },
    Arm { name: "A6: no scouts", settings: &[("learner.scout_from", "0")] },
    Arm { name: "A7: near echoes forgotten", settings: &[("shortcut.near_echoes", "0")] },
    Arm { name: "A8: nothing withdrawn", settings: &[("shortcut.withdraw", "off")] },
    Arm { name: "A8: all withdrawn", settings: &[("shortcut.withdraw", "followed")] },
    Arm { name: "A9: strays not called back", settings: &[("learner.keep_to_record", "false")] },
    Arm { name: "A11: no sharper than T(n)", settings: &[("shortcut.sharp", "false")] },
    Arm { name: "two obstacles, default", settings: &[("world", "two-obstacles")] },
    Arm {
        name: "two obstacles, no critic",
        settings: &[
            ("world", "two-obstacles"),
            ("learner.temporal_difference", "false"),
            ("learner.backtrack", "false"),
        ],
    },
    Arm {
        name: "two obstacles, no scouts",
        settings: &[("world", "two-obstacles"), ("learner.scout_from", "0")],
    },
    Arm {
        name: "two obstacles, nothing withdrawn",
        settings: &[("world", "two-obstacles"), ("shortcut.withdraw", "off")],
    },
    Arm { name: "door of 0.9 m, default", settings: &[("world", "laboratory-narrow-door")] },
    Arm {
        name: "door of 0.9 m, no critic",
        settings: &[
            ("world", "laboratory-narrow-door"),
            ("learner.temporal_difference", "false"),
            ("learner.backtrack", "false"),
        ],
    },
    Arm { name: "hall with pillars, default", settings: &[PILLARS] },
    Arm { name: "hall with pillars, no bends", settings: &[PILLARS, ("shortcut.bend", "false")] },
    Arm { name: "hall with pillars, no scouts", settings: &[PILLARS, ("learner.scout_from", "0")] },
    Arm { name: "two baffles, default", settings: &[BAFFLES] },
    Arm {
        name: "two baffles, nothing withdrawn",
        settings: &[BAFFLES, ("shortcut.withdraw", "off")],
    },
    Arm {
        name: "two baffles, all withdrawn",
        settings: &[BAFFLES, ("shortcut.withdraw", "followed")],
    },
    Arm { name: "two baffles, no escape", settings: &[BAFFLES, ("learner.escape_after", "0")] },
    Arm { name: "drift 2 %, default", settings: &[DRIFT] },
    Arm { name: "drift 2 %, no steps aside", settings: &[DRIFT, ("learner.sidestep", "0")] },
    Arm {
        name: "drift 2 %, odometry as it is",
        settings: &[DRIFT, ("odometry.correction", "false")],
    },
    Arm { name: "no echo beyond 25°, default", settings: &[LOSSY] },
    Arm {
        name: "no echo beyond 25°, near echoes forgotten",
        settings: &[LOSSY, ("shortcut.near_echoes", "0")],
    },
    Arm {
        name: "no echo beyond 25°, strays not called back",
        settings: &[LOSSY, ("learner.keep_to_record", "false")],
    },
];

const PILLARS: (&str, &str) = ("world", "pillars");
const BAFFLES: (&str, &str) = ("world", "two-baffles");
const LOSSY: (&str, &str) = ("sonar.critical_angle", "25");
const DRIFT: (&str, &str) = ("odometry.drift", "0.02");

fn find(target: &Target, sets: &Sets<'_>) -> Result<Findings, ReproductionError> {
    let mut findings = Findings::default();
    let mut samples = Vec::with_capacity(target.arms.len());
    for arm in target.arms {
        samples.push(sets.of(target, arm)?);
    }
    samples.extend(office::samples(target, sets, &office::DIFFERENCES)?);
    let mut base: Option<Sample> = None;
    for sample in samples {
        match base.as_ref().filter(|_| !is_default(&sample.arm)) {
            Some(base) => findings.rows.extend(compared(&sample, base)),
            None => {
                if base.is_none() {
                    findings.rows.extend(claim(&sample));
                }
                findings.rows.extend(measured(&sample, &sample));
                base = Some(sample.clone());
            }
        }
        let total = |trial: &Trial| trial.reached_goal.then_some(trial.total_reinforcement);
        findings.curves.push(curve(&sample, "total reinforcement", "", total));
    }
    Ok(findings)
}

/// Whether an arm is the default preset itself, which those after it are held against.
fn is_default(arm: &Arm) -> bool {
    arm.name == "default" || arm.name.ends_with(", default")
}

/// What is required of the default preset in the laboratory.
fn claim(sample: &Sample) -> Vec<ReproductionRow> {
    let last = |of: fn(&Trial) -> f64| sample.values(|set| set.last().map(of));
    let steps = last(|trial| f64::from(trial.steps));
    let neurons = last(|trial| f64::from(trial.neurons));
    let reached = sample.share_pct(|set| set.last().is_some_and(|trial| trial.reached_goal));
    let rows = [
        row(
            sample,
            ("steps of trial 1 over those of the last, median", ""),
            Estimate::median(
                &sample.values(|set| {
                    Some(f64::from(set.trial(1)?.steps) / f64::from(set.last()?.steps))
                }),
            ),
            Some(Bound::AtLeast(1.3)),
            "ratio of one set's trials; interval of order statistics",
        ),
        row(
            sample,
            ("sets that enter the concave region in trial 1", "%"),
            sample.share_pct(|set| set.trial(1).is_some_and(folds)),
            None,
            "the robot takes some step of trial 1 from the concave region; exact interval of Clopper \
             and Pearson",
        ),
        row(
            sample,
            ("sets that enter the concave region in the last trial", "%"),
            sample.share_pct(|set| set.last().is_some_and(folds)),
            None,
            "the same of the last trial",
        ),
        row(
            sample,
            ("steps of trial 8, median", ""),
            Estimate::median(&sample.values(|set| Some(f64::from(set.trial(8)?.steps)))),
            Some(Bound::AtMost(30.0)),
            "control steps; interval of order statistics",
        ),
        row(
            sample,
            ("last trials that reach the goal", "%"),
            reached,
            Some(Bound::AtLeast(99.0)),
            "share of sets; exact interval of Clopper and Pearson, which keeps the bound from 368 sets \
             without a failure on",
        ),
        row(
            sample,
            ("steps of the last trial, mean", ""),
            Estimate::mean(&steps),
            Some(Bound::AtMost(28.5)),
            "Student's t interval",
        ),
        row(
            sample,
            ("steps of the last trial, variance", ""),
            Estimate::variance(&steps),
            Some(Bound::AtMost(3.0)),
            "χ² interval",
        ),
        row(
            sample,
            ("total reinforcement of the last trial, mean", ""),
            Estimate::mean(&last(|trial| trial.total_reinforcement)),
            Some(Bound::AtLeast(-7.0)),
            "R(n), Eq. (5.27); Student's t interval",
        ),
        row(
            sample,
            ("neurons after the last trial, mean, at least", ""),
            Estimate::mean(&neurons),
            Some(Bound::AtLeast(60.0)),
            "Student's t interval",
        ),
        row(
            sample,
            ("neurons after the last trial, mean, at most", ""),
            Estimate::mean(&neurons),
            Some(Bound::AtMost(120.0)),
            "Student's t interval",
        ),
        row(
            sample,
            ("neurons added a trial over the last five, mean", ""),
            Estimate::mean(&sample.values(growth)),
            Some(Bound::AtMost(1.0)),
            "neurons after the last trial less those five trials before, over five; Student's t interval",
        ),
    ];
    rows.into_iter().flatten().collect()
}

/// Whether a trial went through the concave region.
fn folds(trial: &Trial) -> bool {
    trial.region_steps.get("concave").is_some_and(|&steps| steps > 0)
}

/// Neurons added a trial over the last five.
fn growth(set: &Set) -> Option<f64> {
    let last = set.last()?;
    let before = set.trial(last.trial.checked_sub(5)?)?;
    Some((f64::from(last.neurons) - f64::from(before.neurons)) / 5.0)
}

/// An arm beside the default preset of its world.
fn compared(sample: &Sample, base: &Sample) -> Vec<ReproductionRow> {
    let mut rows = measured(sample, base);
    let total = |set: &Set| set.last().map(Trial::true_total_reinforcement);
    let needed = |set: &Set| Some(trials_needed(set, goal_steps(base)));
    rows.extend(row(
        sample,
        ("total reinforcement lost", ""),
        Estimate::mean(&base.differences(sample, total)),
        Some(Bound::AtLeast(0.0)),
        "R(n) of the last trial of the default preset less that without it, by seeds, with the goal where \
         it truly was; Student's t interval",
    ));
    rows.extend(row(
        sample,
        ("trials lost", ""),
        Estimate::mean(&sample.differences(base, needed)),
        None,
        "trials needed without it less those of the default preset, by seeds; Student's t interval",
    ));
    rows
}

/// What an arm does, by itself.
fn measured(sample: &Sample, base: &Sample) -> Vec<ReproductionRow> {
    let mean = |of: fn(&Trial) -> f64| sample.mean(|set| set.last().map(of));
    let limit = goal_steps(base);
    let rows = [
        ("success in the last five trials", "%", success_pct(sample)),
        ("steps", "", mean(|trial| f64::from(trial.steps))),
        ("total reinforcement", "", mean(|trial| trial.total_reinforcement)),
        ("trials needed", "", sample.mean(|set| Some(trials_needed(set, limit)))),
        ("neurons", "", mean(|trial| f64::from(trial.neurons))),
        ("collisions", "", mean(|trial| f64::from(trial.collisions))),
    ];
    let rows = rows.into_iter().map(|(name, unit, ours)| {
        let reading =
            "mean over sets, of the last trial where nothing else is said; Student's t interval";
        row(sample, (name, unit), ours, None, reading)
    });
    rows.flatten().collect()
}

/// Steps that count as having learned the way of a sample's world.
fn goal_steps(base: &Sample) -> f64 {
    let last = base.values(|set| Some(f64::from(set.last()?.steps)));
    1.1 * sonarium_core::stats::median(&last).unwrap_or(f64::INFINITY)
}

fn trials_needed(set: &Set, limit: f64) -> f64 {
    let learned = |trial: &&Trial| trial.reached_goal && f64::from(trial.steps) <= limit;
    let first = set.trials.iter().find(learned).map(|trial| trial.trial);
    f64::from(first.unwrap_or(set.trials.len() as u32 + 1))
}
