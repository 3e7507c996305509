//! Table 5.1: the last of 20 trials, mean and variance over sets.

use sonarium_core::stats::Estimate;

use super::{
    Findings, PRESETS, PUBLISHED, ReproductionError, Row, SEEDS, Sample, Sets, Target, Unit,
};
use crate::catalog::{DEFAULT_TRIALS, MINIMUM_COST_PATH};
use crate::wire::{ReproductionRow, Trial};

/// Table 5.1.
pub static TABLE_5_1: Target = Target {
    name: "table-5.1",
    title: "Final network performance",
    compares: "The last of 20 trials over sets begun with an empty network: ten sets of the physical \
               B21 in the thesis, 200 simulated sets a preset here, in our reading of its laboratory; \
               reflex, which never learns, is the control",
    source: "Table 5.1, section 5.11",
    readings: &[
        "The table prints mean and variance \"computed from the last trial in the set of ten \
         experiments\"; the variance is taken with the divisor n − 1",
        "A last trial that does not reach the goal counts with the full cap of steps and with what \
         it had earned until then",
    ],
    rules: &[PUBLISHED],
    experiment: MINIMUM_COST_PATH,
    arms: PRESETS,
    unit: Unit::Set,
    trials: DEFAULT_TRIALS,
    seeds: SEEDS,
    find,
};

/// One quantity of the table.
struct Quantity {
    name: &'static str,
    meaning: &'static str,
    mean: f64,
    variance: f64,
    of: fn(&Trial) -> f64,
}

/// What the table prints.
const QUANTITIES: [Quantity; 3] = [
    Quantity {
        name: "number of neurons",
        meaning: "neurons of all networks after the last trial",
        mean: 82.5,
        variance: 4.7286,
        of: |trial| f64::from(trial.neurons),
    },
    Quantity {
        name: "number of steps",
        meaning: "control steps of the last trial, the full cap where the goal was not reached",
        mean: 27.7,
        variance: 1.9,
        of: |trial| f64::from(trial.steps),
    },
    Quantity {
        name: "total reinforcement",
        meaning: "R(n) of the last trial, Eq. (5.27), the goal step included",
        mean: -6.24,
        variance: 0.8752,
        of: |trial| trial.total_reinforcement,
    },
];

fn find(target: &Target, sets: &Sets<'_>) -> Result<Findings, ReproductionError> {
    let mut rows = Vec::new();
    for arm in target.arms {
        rows.extend(last_trial(&*sets.shared(target, arm)?));
    }
    Ok(Findings { rows, ..Findings::default() })
}

fn last_trial(sample: &Sample) -> Vec<ReproductionRow> {
    let mut rows = Vec::new();
    for quantity in &QUANTITIES {
        let values = sample.values(|set| set.last().map(quantity.of));
        for (moment, published, ours, interval) in [
            ("mean", quantity.mean, Estimate::mean(&values), "Student's t interval"),
            ("variance", quantity.variance, Estimate::variance(&values), "χ² interval"),
        ] {
            let row = Row {
                name: &format!("{}, {moment}", quantity.name),
                published: Some(published),
                unit: "",
                reading: &format!("{moment} over all sets of the {}; {interval}", quantity.meaning),
            };
            rows.extend(row.of(sample, ours));
        }
    }
    let reached = sample.share_pct(|set| set.last().is_some_and(|trial| trial.reached_goal));
    rows.extend(REACHED.of(sample, reached));
    rows
}

const REACHED: Row<'_> = Row {
    name: "sets that reached the goal",
    published: None,
    unit: "%",
    reading: "share of sets whose last trial reached the goal; the thesis prints no such figure, so \
              nothing is judged; exact interval of Clopper and Pearson",
};
