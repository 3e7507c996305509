//! Figure 5.9: learning curves of the simulated TRC, which fails at first and then learns.

use std::ops::RangeInclusive;

use sonarium_core::stats::{self, Estimate};

use super::figure_5_8::sample;
use super::{
    Findings, PRESETS, PUBLISHED, ReproductionError, Row, Sample, Set, Sets, Target, Unit, curve,
};
use crate::catalog::MINIMUM_COST_PATH_TRC;
use crate::wire::Trial;

/// Trials of a set: the text tells of trial 41 and of those after it.
pub(super) const TRIALS: u32 = 50;
/// Seeds of both figures of the simulated robot; its sets are long, and the thesis tells of one run.
pub(super) const TRC_SEEDS: RangeInclusive<u64> = 700_000..=700_049;

/// Figure 5.9.
pub static FIGURE_5_9: Target = Target {
    name: "figure-5.9",
    title: "Learning curves of a simulated robot",
    compares: "One run of the simulated TRC in the thesis, whose figure prints curves and no numbers, \
               and 50 sets of 50 trials a preset here, in a world of our own, since the figure that \
               shows the thesis's is lost; reflex, which never learns, is the control",
    source: "Figure 5.9, section 5.11",
    readings: &[
        "The curves have no printed values, so what is judged is what section 5.11 says about them; it \
         tells of one run, so each number is held against the mean over our sets, or against all of \
         them",
        "Moves and total reinforcement of a trial that does not reach the goal are undefined, as in the \
         thesis; their curves are over the sets that reached it, and n says how many",
        "A collision, real or virtual, ends the trial",
    ],
    rules: &[PUBLISHED],
    experiment: MINIMUM_COST_PATH_TRC,
    arms: PRESETS,
    unit: Unit::Set,
    trials: TRIALS,
    seeds: TRC_SEEDS,
    find,
};

fn find(target: &Target, sets: &Sets<'_>) -> Result<Findings, ReproductionError> {
    let mut findings = Findings::default();
    for arm in target.arms {
        let sample = sample(target, sets, arm)?;
        findings.curves.extend([
            curve(&sample, "number of neurons", "", |trial| Some(f64::from(trial.neurons))),
            curve(&sample, "number of moves", "", |trial| reached(trial).map(moves)),
            curve(&sample, "total reinforcement", "", |trial| reached(trial).map(reinforcement)),
            curve(&sample, "sets that reached the goal", "%", |trial| {
                Some(if trial.reached_goal { 100.0 } else { 0.0 })
            }),
        ]);
        let rows = rows(&sample);
        findings.rows.extend(rows.iter().filter_map(|(row, ours)| row.of(&sample, *ours)));
    }
    // The curves of one quantity stand together.
    let order = |quantity: &str| findings_order().iter().position(|known| *known == quantity);
    findings.curves.sort_by_key(|curve| order(&curve.quantity));
    Ok(findings)
}

fn findings_order() -> [&'static str; 4] {
    ["number of neurons", "number of moves", "total reinforcement", "sets that reached the goal"]
}

fn rows(sample: &Sample) -> Vec<(Row<'static>, Option<Estimate>)> {
    vec![
        (FIRST_REACHED, sample.mean(|set| first_reached(set).map(|trial| f64::from(trial.trial)))),
        (EIGHT_FAIL, sample.share_pct(|set| set.trials.iter().take(8).all(|t| !t.reached_goal))),
        (FIRST_IS_WORST, sample.share_pct(first_is_worst)),
        (FAILS_AFTER, sample.mean(fails_after_first)),
        (SATURATED, sample.mean(twelfth_over_last)),
        (CONSTANT, sample.share_pct(|set| late(set).all(|trial| trial.reached_goal))),
        (LATE_REACHED, sample.mean(late_reached_pct)),
        (LATE_MOVES, sample.mean(|set| stats::mean(&late_values(set, moves)))),
        (LATE_SPREAD, sample.mean(half_range)),
    ]
}

/// A trial that reached the goal.
fn reached(trial: &Trial) -> Option<&Trial> {
    trial.reached_goal.then_some(trial)
}

fn moves(trial: &Trial) -> f64 {
    f64::from(trial.steps)
}

fn reinforcement(trial: &Trial) -> f64 {
    trial.total_reinforcement
}

/// The first trial that reached the goal.
pub(super) fn first_reached(set: &Set) -> Option<&Trial> {
    set.trials.iter().find_map(reached)
}

/// Whether no trial at the goal earned less than the first.
fn first_is_worst(set: &Set) -> bool {
    let mut earned = set.trials.iter().filter_map(reached).map(reinforcement);
    earned.next().is_some_and(|first| earned.all(|later| later > first))
}

fn fails_after_first(set: &Set) -> Option<f64> {
    let first = first_reached(set)?.trial;
    let fails = set.trials.iter().filter(|trial| trial.trial > first && !trial.reached_goal);
    Some(fails.map(|_| 1.0).sum())
}

fn twelfth_over_last(set: &Set) -> Option<f64> {
    let neurons = |trial: &Trial| f64::from(trial.neurons);
    let last = set.last().map(neurons).filter(|&neurons| neurons > 0.0)?;
    Some(neurons(set.trial(12)?) / last)
}

/// Trials from 30 on.
fn late(set: &Set) -> impl Iterator<Item = &Trial> {
    set.trials.iter().filter(|trial| trial.trial >= 30)
}

/// A quantity of the late trials that reached the goal.
fn late_values(set: &Set, of: fn(&Trial) -> f64) -> Vec<f64> {
    late(set).filter_map(reached).map(of).collect()
}

fn late_reached_pct(set: &Set) -> Option<f64> {
    let reached: Vec<f64> = late(set).map(|t| if t.reached_goal { 100.0 } else { 0.0 }).collect();
    stats::mean(&reached)
}

/// Half the range of R(n) from trial 30 on, the worst trial left out as the thesis leaves out trial 41.
fn half_range(set: &Set) -> Option<f64> {
    let mut earned = late_values(set, reinforcement);
    earned.sort_by(f64::total_cmp);
    let [_, kept @ ..] = earned.as_slice() else { return None };
    Some((kept.last()? - kept.first()?) / 2.0)
}

const FIRST_REACHED: Row<'_> = Row {
    name: "first trial that reached the goal",
    published: Some(9.0),
    unit: "",
    reading: "\"at trial nine the robot reached the goal for the first time\"; mean over the sets that \
              reach it at all",
};
const EIGHT_FAIL: Row<'_> = Row {
    name: "sets that fail in all of the first eight trials",
    published: Some(100.0),
    unit: "%",
    reading: "\"the robot totally failed to reach the target during the first eight trials\" read as: in \
              every set",
};
const FIRST_IS_WORST: Row<'_> = Row {
    name: "sets whose first trial at the goal earns the least",
    published: Some(100.0),
    unit: "%",
    reading: "\"it is during this trial the controller received the lowest total reinforcement\" read as: \
              every later trial at the goal earns more, in every set; a set that never reaches it counts \
              against",
};
const FAILS_AFTER: Row<'_> = Row {
    name: "failed trials after the first at the goal",
    published: Some(8.0),
    unit: "",
    reading: "\"after the robot had reached the goal by the ninth trial, it had chosen eight times non \
              optimal actions that ultimately led to real or virtual collisions\" read as eight failed \
              trials, up to trial 50 here; mean over the sets that reach the goal at all",
};
const SATURATED: Row<'_> = Row {
    name: "neurons after trial 12 over those after the last",
    published: Some(1.0),
    unit: "",
    reading: "\"in the twelfth trial and afterwards, the size of network was almost saturated\" read as a \
              ratio of 1; how many \"only few neurons\" are is not said",
};
const CONSTANT: Row<'_> = Row {
    name: "sets that reach the goal in every trial from 30 on",
    published: Some(100.0),
    unit: "%",
    reading: "\"beginning with trial 30, the robot visited the goal constantly\" read as: in every set",
};
const LATE_REACHED: Row<'_> = Row {
    name: "trials from 30 on that reach the goal",
    published: Some(100.0),
    unit: "%",
    reading: "the same sentence, as the share of trials in a set; mean over sets",
};
const LATE_MOVES: Row<'_> = Row {
    name: "moves from trial 30 on",
    published: Some(145.5),
    unit: "",
    reading: "\"the total number of moves fluctuated only within the range of 143 - 148\" read as its \
              middle; mean over the trials that reach the goal, then over sets; the way is as long as \
              our world makes it",
};
const LATE_SPREAD: Row<'_> = Row {
    name: "half the range of the total reinforcement from trial 30 on",
    published: Some(3.0),
    unit: "",
    reading: "\"the total reinforcement value remained stable within ± 3, except in trial 41\" read as \
              half the range over the trials that reach the goal, the worst one left out; mean over sets",
};

#[cfg(test)]
mod tests {
    use super::*;

    /// A set whose trials reach the goal with this total reinforcement, or fail.
    fn set(earned: &[Option<f64>]) -> Set {
        let sample = crate::testing::undisturbed(1).remove(0);
        let trials = (1..).zip(earned).map(|(trial, earned)| Trial {
            trial,
            reached_goal: earned.is_some(),
            total_reinforcement: earned.unwrap_or(-500.0),
            neurons: 10 * trial,
            ..sample.clone()
        });
        Set {
            seed: 1,
            trials: trials.collect(),
            first_path_m: Vec::new(),
            last_path_m: Vec::new(),
            starts: Vec::new(),
        }
    }

    #[test]
    fn the_first_trial_at_the_goal_is_told_from_the_failures_around_it() {
        let set = set(&[None, None, Some(-90.0), None, Some(-40.0), None]);
        assert_eq!(first_reached(&set).map(|trial| trial.trial), Some(3));
        assert_eq!(fails_after_first(&set), Some(2.0));
        assert!(first_is_worst(&set));
        assert!(!first_is_worst(&self::set(&[Some(-40.0), Some(-90.0)])));
        assert!(!first_is_worst(&self::set(&[None, None])), "it never came there");
        assert_eq!(fails_after_first(&self::set(&[None])), None);
    }

    #[test]
    fn the_late_trials_leave_out_the_worst_and_the_failed() {
        let mut earned = vec![Some(-100.0); 29];
        earned.extend([Some(-30.0), None, Some(-34.0), Some(-80.0), Some(-31.0)]);
        let set = set(&earned);
        assert_eq!(half_range(&set), Some(2.0));
        assert_eq!(late_reached_pct(&set), Some(80.0));
        assert_eq!(twelfth_over_last(&set), Some(120.0 / 340.0));
        assert_eq!(half_range(&self::set(&[Some(-1.0)])), None, "no late trial");
    }
}
