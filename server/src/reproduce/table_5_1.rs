//! Table 5.1: the last of 20 trials, mean and variance over sets.

use sonarium_core::stats::{self, Estimate};

use super::Target;
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
    experiment: MINIMUM_COST_PATH,
    presets: &["default", "thesis", "reflex"],
    trials: DEFAULT_TRIALS,
    seeds: 700_000..=700_199,
    rows,
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

fn rows(target: &Target, preset: &str, last: &[Trial]) -> Vec<ReproductionRow> {
    let seeds = format!("seeds {}..{}", target.seeds.start(), target.seeds.end());
    let row =
        |name: &str, published, unit: &str, ours: Estimate, reading: String| ReproductionRow {
            name: format!("{preset}: {name}"),
            published,
            ours: ours.value,
            low: ours.low,
            high: ours.high,
            n: u32::try_from(ours.n).unwrap_or(u32::MAX),
            unit: unit.into(),
            verdict: stats::Verdict::of(published, &ours).into(),
            reading: format!("Preset {preset}, {seeds}: {reading}"),
        };
    let mut rows = Vec::new();
    for quantity in &QUANTITIES {
        let sample: Vec<f64> = last.iter().map(quantity.of).collect();
        for (moment, published, estimate, interval) in [
            ("mean", quantity.mean, Estimate::mean(&sample), "Student's t interval"),
            ("variance", quantity.variance, Estimate::variance(&sample), "χ² interval"),
        ] {
            let name = format!("{}, {moment}", quantity.name);
            let reading = format!("{moment} over all sets of the {}; {interval}", quantity.meaning);
            rows.extend(estimate.map(|ours| row(&name, Some(published), "", ours, reading)));
        }
    }
    let reached = last.iter().filter(|trial| trial.reached_goal).count();
    let share = Estimate::proportion(reached, last.len()).map(|share| share.scaled(100.0));
    rows.extend(
        share.map(|ours| row("sets that reached the goal", None, "%", ours, SUCCESS.into())),
    );
    rows
}

const SUCCESS: &str = "share of sets whose last trial reached the goal; the thesis prints no such \
    figure, so nothing is judged; exact interval of Clopper and Pearson";
