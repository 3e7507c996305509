//! Figures 5.11-5.13: neurons, steps and total reinforcement over 20 trials, and what section 5.11 says
//! about them.

use std::sync::Arc;

use sonarium_core::stats::{self, Estimate};

use super::{
    Findings, PRESETS, PUBLISHED, ReproductionError, Row, SEEDS, Sample, Set, Sets, Target, Unit,
    curve,
};
use crate::catalog::{DEFAULT_TRIALS, MINIMUM_COST_PATH};
use crate::wire::{ReproductionRow, Trial};

const COMPARES: &str = "Ten sets of 20 trials of the physical B21 in the thesis, whose figure prints \
    curves and no numbers; 200 simulated sets a preset here; reflex, which never learns, is the control";

const READINGS: &[&str] = &[
    "The figures are curves without printed values, so what is judged is what section 5.11 says about \
     them; each sentence was turned into a number",
    "A trial that does not reach the goal counts with the full cap of steps and with what it had earned \
     until then",
    "The bars are drawn over the first ten sets, as in the thesis; how the variation changes is judged \
     over all blocks of ten sets",
];

/// What the three have in common.
const CURVES: Target = Target {
    name: "figure-5.11",
    title: "Number of neurons",
    compares: COMPARES,
    source: "Figure 5.11, sections 5.11 and 5.12",
    readings: READINGS,
    rules: &[PUBLISHED],
    experiment: MINIMUM_COST_PATH,
    arms: PRESETS,
    unit: Unit::Set,
    trials: DEFAULT_TRIALS,
    seeds: SEEDS,
    find: find_neurons,
};

/// Figure 5.11.
pub static FIGURE_5_11: Target = CURVES;

/// Figure 5.12.
pub static FIGURE_5_12: Target = Target {
    name: "figure-5.12",
    title: "Steps taken before the robot arrived at the goal",
    source: "Figure 5.12, section 5.11",
    find: find_steps,
    ..CURVES
};

/// Figure 5.13.
pub static FIGURE_5_13: Target = Target {
    name: "figure-5.13",
    title: "Total reinforcement of each trial",
    source: "Figure 5.13, section 5.11",
    find: find_reinforcement,
    ..CURVES
};

/// Sets that are compared as the ten of the thesis are.
const BLOCK: usize = 10;

fn find_neurons(target: &Target, sets: &Sets<'_>) -> Result<Findings, ReproductionError> {
    find(target, sets, "number of neurons", neurons, |sample, _| {
        let early = |set: &Set| Some(value(set, neurons, 5)? / 5.0);
        let late = |set: &Set| Some((value(set, neurons, 20)? - value(set, neurons, 15)?) / 5.0);
        vec![
            (GROWTH_EARLY, sample.mean(early)),
            (GROWTH_LATE, sample.mean(late)),
            (GROWTH_SLOWS, sample.share_pct(|set| late(set) < early(set))),
            (GROWTH_GOES_ON, sample.share_pct(|set| late(set) > Some(0.0))),
        ]
    })
}

fn find_steps(target: &Target, sets: &Sets<'_>) -> Result<Findings, ReproductionError> {
    find(target, sets, "number of steps", steps, |sample, reflex| {
        let unfolds = |set: &Set| value(set, steps, 6) < value(set, steps, 1);
        vec![
            (FIRST_OVER_REFLEX, first_over_reflex(sample, reflex)),
            (UNFOLDS, sample.share_pct(unfolds)),
            (SIXTH_OVER_LAST, sample.mean(|set| ratio(set, steps, 6))),
            (EIGHTH_OVER_SEVENTH, sample.mean(eighth_over_seventh)),
            (REST_OVER_LAST, sample.mean(|set| rest_over_last(set, steps))),
        ]
    })
}

fn find_reinforcement(target: &Target, sets: &Sets<'_>) -> Result<Findings, ReproductionError> {
    find(target, sets, "total reinforcement", reinforcement, |sample, _| {
        let early = |set: &Set| mean_over(set, reinforcement, 1, 3);
        vec![
            (EARLY_REINFORCEMENT, sample.mean(early)),
            (EARLY_IS_WORSE, sample.share_pct(|set| early(set) < value(set, reinforcement, 20))),
            (SIXTH_OVER_LAST, sample.mean(|set| ratio(set, reinforcement, 6))),
            (REST_OVER_LAST, sample.mean(|set| rest_over_last(set, reinforcement))),
        ]
    })
}

/// Rows of which the estimates are known.
type Found = Vec<(Row<'static>, Option<Estimate>)>;

/// The curve of every arm, its own rows and that of its variation. `rows` is given the control too.
fn find(
    target: &Target,
    sets: &Sets<'_>,
    quantity: &str,
    of: fn(&Trial) -> f64,
    rows: impl Fn(&Sample, &Sample) -> Found,
) -> Result<Findings, ReproductionError> {
    let samples = target.arms.iter().map(|arm| sets.shared(target, arm));
    let samples: Vec<Arc<Sample>> = samples.collect::<Result<_, ReproductionError>>()?;
    let mut findings = Findings::default();
    for sample in &samples {
        let reflex = samples.iter().find(|sample| sample.arm.name == "reflex").unwrap_or(sample);
        findings.curves.push(curve(sample, quantity, "", |trial| Some(of(trial))));
        let mut found = rows(sample, reflex);
        found.push((VARIATION, variation_decreases(sample, of)));
        let judged = found.iter().filter_map(|(row, ours)| row.of(sample, *ours));
        findings.rows.extend(judged.collect::<Vec<ReproductionRow>>());
    }
    Ok(findings)
}

fn neurons(trial: &Trial) -> f64 {
    f64::from(trial.neurons)
}

fn steps(trial: &Trial) -> f64 {
    f64::from(trial.steps)
}

fn reinforcement(trial: &Trial) -> f64 {
    trial.total_reinforcement
}

/// A quantity of one trial.
fn value(set: &Set, of: fn(&Trial) -> f64, trial: u32) -> Option<f64> {
    set.trial(trial).map(of)
}

/// One trial over the last.
fn ratio(set: &Set, of: fn(&Trial) -> f64, trial: u32) -> Option<f64> {
    Some(value(set, of, trial)? / of(set.last()?))
}

fn mean_over(set: &Set, of: fn(&Trial) -> f64, first: u32, last: u32) -> Option<f64> {
    let values: Vec<f64> = (first..=last).filter_map(|trial| value(set, of, trial)).collect();
    stats::mean(&values)
}

fn rest_over_last(set: &Set, of: fn(&Trial) -> f64) -> Option<f64> {
    Some(mean_over(set, of, 9, 19)? / of(set.last()?))
}

fn eighth_over_seventh(set: &Set) -> Option<f64> {
    Some(value(set, steps, 8)? / value(set, steps, 7)?)
}

/// Steps of the first trial over those of the reflex with the same seed.
fn first_over_reflex(sample: &Sample, reflex: &Sample) -> Option<Estimate> {
    let pairs = sample.sets.iter().zip(&reflex.sets);
    let ratios =
        pairs.filter_map(|(set, reflex)| Some(value(set, steps, 1)? / value(reflex, steps, 1)?));
    Estimate::mean(&ratios.collect::<Vec<f64>>())
}

/// Share of blocks of ten sets whose bars are shorter in the last five trials than in the first five.
fn variation_decreases(sample: &Sample, of: fn(&Trial) -> f64) -> Option<Estimate> {
    let (blocks, _) = sample.sets.as_chunks::<BLOCK>();
    let bars = |block: &[Set], first: u32, last: u32| -> f64 {
        (first..=last).filter_map(|trial| bar(block, of, trial)).sum()
    };
    let shorter = blocks.iter().filter(|block| bars(&block[..], 16, 20) < bars(&block[..], 1, 5));
    Some(Estimate::proportion(shorter.count(), blocks.len())?.scaled(100.0))
}

/// Greatest less least value of a trial.
fn bar(block: &[Set], of: fn(&Trial) -> f64, trial: u32) -> Option<f64> {
    let values = || block.iter().filter_map(|set| value(set, of, trial));
    Some(values().reduce(f64::max)? - values().reduce(f64::min)?)
}

const GROWTH_EARLY: Row<'_> = Row {
    name: "neurons added a trial, trials 1-5",
    published: None,
    unit: "",
    reading: "neurons after trial 5 over 5; \"the neurons added to the network grew sharply\" gives no \
              number",
};
const GROWTH_LATE: Row<'_> = Row {
    name: "neurons added a trial, trials 16-20",
    published: None,
    unit: "",
    reading: "neurons after trial 20 less those after trial 15, over 5; \"at a more reduced slope\" \
              gives no number",
};
const GROWTH_SLOWS: Row<'_> = Row {
    name: "sets that grow less in trials 16-20 than in trials 1-5",
    published: Some(100.0),
    unit: "%",
    reading: "\"neurons were added to the network at a more reduced slope than the earlier trials\" read \
              as: fewer in the last five trials than in the first five, in every set",
};
const GROWTH_GOES_ON: Row<'_> = Row {
    name: "sets that still grow in trials 16-20",
    published: Some(100.0),
    unit: "%",
    reading: "\"in the last few trials the network did not abate to grow\" (section 5.12) read as: some \
              neuron is added in the last five trials, in every set; a learner that has settled differs \
              here",
};
const FIRST_OVER_REFLEX: Row<'_> = Row {
    name: "steps of trial 1 over those of the reflex",
    published: Some(1.0),
    unit: "",
    reading: "\"in the first trial, the controller produced a trajectory that was no better than what \
              the basic reflex had produced\" read as: as many steps as the reflex with the same seed",
};
const UNFOLDS: Row<'_> = Row {
    name: "sets whose trial 6 is shorter than trial 1",
    published: Some(100.0),
    unit: "%",
    reading: "\"the robot gradually started to unfold its path\" read as: trial 6 takes fewer steps than \
              trial 1, in every set",
};
const SIXTH_OVER_LAST: Row<'_> = Row {
    name: "trial 6 over the last trial",
    published: Some(1.0),
    unit: "",
    reading: "\"by the sixth trial and afterwards the robot had practically straightened its path\" read \
              as a ratio of 1; how much less \"practically\" would allow is not said",
};
const EIGHTH_OVER_SEVENTH: Row<'_> = Row {
    name: "steps of trial 8 over those of trial 7",
    published: None,
    unit: "",
    reading: "\"by the eighth trial [...] the robot left the optimum path in search for a better one\" \
              tells of one run and gives no number, so nothing is judged",
};
const REST_OVER_LAST: Row<'_> = Row {
    name: "mean of trials 9-19 over the last trial",
    published: Some(1.0),
    unit: "",
    reading: "\"followed the same path through out the remaining trials with out significant divergence\" \
              read as a ratio of 1",
};
const EARLY_REINFORCEMENT: Row<'_> = Row {
    name: "mean of trials 1-3",
    published: None,
    unit: "",
    reading: "\"a high payoff in the first few trials\", which is a penalty here, gives no number",
};
const EARLY_IS_WORSE: Row<'_> = Row {
    name: "sets whose trials 1-3 earn less than the last trial",
    published: Some(100.0),
    unit: "%",
    reading: "\"the robot also incurred a high payoff in the first few trials\" read as: R(n) of trials \
              1 to 3 is on average below that of the last trial, in every set",
};
const VARIATION: Row<'_> = Row {
    name: "blocks of ten sets whose variation decreases",
    published: Some(100.0),
    unit: "%",
    reading: "\"as the trial increases, the variation in the value decreases\" read as: the bars from \
              minimum to maximum over ten sets are shorter in trials 16-20 than in trials 1-5, in every \
              block of ten sets; n counts blocks",
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::{Arm, Kept};

    fn set(steps: [u32; 20]) -> Set {
        let sample = crate::testing::undisturbed(1).remove(0);
        let trials =
            (1..).zip(steps).map(|(trial, steps)| Trial { trial, steps, ..sample.clone() });
        Set {
            seed: 1,
            trials: trials.collect(),
            first_path_m: Vec::new(),
            last_path_m: Vec::new(),
            starts: Vec::new(),
        }
    }

    #[test]
    fn ratios_are_to_the_last_trial() {
        let mut counts = [40; 20];
        counts[5] = 30;
        counts[19] = 20;
        let set = set(counts);
        assert_eq!(ratio(&set, steps, 6), Some(1.5));
        assert_eq!(rest_over_last(&set, steps), Some(2.0));
        assert_eq!(mean_over(&set, steps, 5, 7), Some(110.0 / 3.0));
        assert_eq!(eighth_over_seventh(&set), Some(1.0));
    }

    #[test]
    fn a_block_s_bars_are_compared_early_and_late() {
        // Ten sets that scatter by 9 steps at first and by none at last, then ten the other way round.
        let settling = |k: u32| set(std::array::from_fn(|n| if n < 5 { 30 + k } else { 30 }));
        let unsettled = |k: u32| set(std::array::from_fn(|n| if n < 15 { 30 } else { 30 + k }));
        let sets: Vec<Set> = (0..10).map(settling).chain((0..10).map(unsettled)).collect();
        let catalog = crate::catalog::Catalog::load(None).expect("the embedded files are fine");
        let runner = Sets { catalog: &catalog, threads: 1, kept: &Kept::default(), done: &|| () };
        let arm = Arm { name: "default", settings: &[] };
        let plan = runner.plan(&FIGURE_5_12, &arm).expect("it fits");
        let sample = Sample { arm, plan, seeds: [1, 20], sets };
        let share = variation_decreases(&sample, steps).expect("two blocks");
        assert_eq!((share.value, share.n), (50.0, 2));
        assert_eq!(bar(&sample.sets[..10], steps, 1), Some(9.0));
        assert_eq!(bar(&sample.sets[..10], steps, 20), Some(0.0));
    }
}
