//! The default preset with nothing retuned, under other disturbances and in other worlds.

use sonarium_core::stats::{Bound, Estimate};

use super::office;
use super::required::{excess_pct, row, success_pct, yardstick_of};
use super::{Arm, Findings, ReproductionError, SEEDS, Sample, Sets, Target, Unit, curve};
use crate::catalog::{DEFAULT_TRIALS, MINIMUM_COST_PATH};
use crate::wire::{ReproductionRow, Yardstick};

/// The default preset elsewhere.
pub static ROBUSTNESS: Target = Target {
    name: "robustness",
    title: "Not only here",
    compares: "The default preset, nothing retuned, under sonar noise, odometry drift and specular \
               loss, and in other worlds, each held against the best path that a planner finds there on \
               the same cost",
    source: "Not in the thesis; the cost is Eq. (5.6), (5.7) and (5.27)",
    readings: &[
        "The planner knows the world and the cost beforehand, and its sensors and odometry never err, \
         so that nobody who has to sense and to learn can be expected to be as good",
        "Success is required in 95 % of the last five trials, and a cost of the last trial at most 15 % \
         above that of the planned path; a capped trial counts with what it had paid until then, and one \
         under drift with the goal where it truly was, not where the robot took it to be",
        office::READING,
    ],
    rules: &[Bound::RULE],
    experiment: MINIMUM_COST_PATH,
    arms: ARMS,
    unit: Unit::Set,
    trials: DEFAULT_TRIALS,
    seeds: SEEDS,
    find,
};

const ARMS: &[Arm] = &[
    Arm { name: "laboratory", settings: &[] },
    Arm { name: "no sonar noise", settings: &[("sonar.noise", "0")] },
    Arm { name: "sonar noise 2 %", settings: &[("sonar.noise", "0.02")] },
    Arm { name: "sonar noise 3 %", settings: &[("sonar.noise", "0.03")] },
    Arm { name: "odometry drift 0.5 %", settings: &[("odometry.drift", "0.005")] },
    Arm { name: "odometry drift 1 %", settings: &[("odometry.drift", "0.01")] },
    Arm { name: "odometry drift 2 %", settings: &[("odometry.drift", "0.02")] },
    Arm { name: "odometry drift 5 %", settings: &[("odometry.drift", "0.05")] },
    Arm {
        name: "sonar noise 3 % and drift 2 %",
        settings: &[("sonar.noise", "0.03"), ("odometry.drift", "0.02")],
    },
    Arm { name: "no echo beyond 40°", settings: &[("sonar.critical_angle", "40")] },
    Arm { name: "no echo beyond 25°", settings: &[("sonar.critical_angle", "25")] },
    Arm { name: "door moved", settings: &[("world", "laboratory-shifted-door")] },
    Arm { name: "door of 0.9 m", settings: &[("world", "laboratory-narrow-door")] },
    Arm { name: "two obstacles", settings: &[("world", "two-obstacles")] },
    Arm { name: "L-shaped corridor", settings: &[("world", "l-corridor")] },
    Arm { name: "three rooms", settings: &[("world", "three-rooms")] },
    Arm { name: "two baffles", settings: &[("world", "two-baffles")] },
    Arm { name: "hall with pillars", settings: &[("world", "pillars")] },
];

fn find(target: &Target, sets: &Sets<'_>) -> Result<Findings, ReproductionError> {
    let mut findings = Findings::default();
    let mut samples = Vec::with_capacity(target.arms.len());
    for arm in target.arms {
        samples.push(sets.of(target, arm)?);
    }
    samples.extend(office::samples(target, sets, &office::PAIRS)?);
    for sample in samples {
        let yardstick = yardstick_of(&sample);
        findings.rows.extend(rows(&sample, &yardstick));
        let excess = |trial: &_| excess_pct(trial, &yardstick);
        findings.curves.push(curve(&sample, "cost above the best path's", "%", excess));
    }
    Ok(findings)
}

fn rows(sample: &Sample, yardstick: &Yardstick) -> Vec<ReproductionRow> {
    let excess = sample.values(|set| excess_pct(set.last()?, yardstick));
    let best = yardstick.ready().map_or_else(
        || "a planner finds no way".to_owned(),
        |path| {
            format!(
                "the best path has R* = {:.2} in {} steps",
                path.total_reinforcement, path.steps
            )
        },
    );
    let rows = [
        row(
            sample,
            ("success in the last five trials", "%"),
            success_pct(sample),
            Some(Bound::AtLeast(95.0)),
            "share of the trials that reached the goal; exact interval of Clopper and Pearson, as if \
             each set were one observation",
        ),
        row(
            sample,
            ("cost of the last trial above the best path's, mean", "%"),
            Estimate::mean(&excess),
            Some(Bound::AtMost(15.0)),
            &format!("(R* − R(n)) / −R*, where {best}; Student's t interval"),
        ),
        row(
            sample,
            ("cost of the last trial above the best path's, median", "%"),
            Estimate::median(&excess),
            None,
            "the same, median over sets, not judged; interval of order statistics",
        ),
        row(
            sample,
            ("steps of the last trial, median", ""),
            Estimate::median(&sample.values(|set| Some(f64::from(set.last()?.steps)))),
            None,
            "control steps, the cap where the goal was not reached; interval of order statistics",
        ),
    ];
    rows.into_iter().flatten().collect()
}
