//! Figure 3.3: which of three policies is the best, under each model of optimality.

use sonarium_core::experiment::{HorizonRun, HorizonSettings, Model};
use sonarium_core::stats::Verdict;
use sonarium_core::tabular::{Chain, Crossing};

use super::curve::unsampled;
use super::{Arm, Findings, NO_SEEDS, ReproductionError, Row, Sets, Target, Unit};
use crate::wire::{ReproductionCurve, ReproductionRow};

/// Figure 3.3.
pub static FIGURE_3_3: Target = Target {
    name: "figure-3.3",
    title: "Three policies under three models of optimality",
    compares: "Total reward of the three policies of figure 3.2 over the horizon and over the discount, and \
               where another becomes the best; the figure prints curves, its text says what is best where, \
               and the numbers are those of the paper that the example is from",
    source: "Figures 3.2 and 3.3, section 3.3",
    readings: &[
        "The example is from Kaelbling, Littman and Moore (1996), which prints the rewards at h = 5, γ = 0.9 \
         and in the long run; the thesis prints 11 for the last of a2",
        "Eq. (3.1) sums h + 1 rewards; the numbers of the example sum h, which is what is done here",
        "The caption calls the broken line of the right plot a0; it is a2",
    ],
    rules: &[Verdict::EXACT_RULE],
    experiment: "horizon",
    arms: &[
        Arm { name: "a0", settings: &[] },
        Arm { name: "a1", settings: &[] },
        Arm { name: "a2", settings: &[] },
    ],
    unit: Unit::Set,
    trials: 0,
    seeds: NO_SEEDS,
    find,
};

/// Printed for h = 5, γ = 0.9 and the average, by policy.
const PRINTED: [[f64; 3]; 3] = [[6.0, 0.0, 0.0], [16.2, 59.0, 58.5], [2.0, 10.0, 11.0]];

fn find(target: &Target, _: &Sets<'_>) -> Result<Findings, ReproductionError> {
    let mut findings = Findings::default();
    let run = HorizonRun::new(HorizonSettings::default(), 0);
    for (policy, (arm, chain)) in target.arms.iter().zip(run.chains()).enumerate() {
        findings.rows.extend(rows(arm, policy, chain, &run));
        findings.curves.extend(curves(arm, policy));
    }
    findings.rows.extend(told(&run));
    Ok(findings)
}

/// A policy's rewards, and from where on it is the best.
fn rows(arm: &Arm, policy: usize, chain: &Chain, run: &HorizonRun) -> Vec<ReproductionRow> {
    let found = [
        (FINITE, chain.finite(5.0)),
        (DISCOUNTED, chain.discounted(0.9)),
        (AVERAGE, chain.average()),
    ];
    let printed = PRINTED.iter().map(|figures| figures[policy]);
    let values = found.into_iter().zip(printed).map(|((row, ours), published)| {
        Row { published: Some(published), ..row }.exact(Some(arm.name), ours, 0.1)
    });
    let leads = [(Model::FiniteHorizon, BEST_FROM_H), (Model::Discounted, BEST_FROM_GAMMA)];
    let leads = leads.into_iter().filter_map(|(model, row)| {
        let crossing = run.crossings(model).iter().find(|crossing| crossing.to == policy)?;
        Some(row.exact(Some(arm.name), crossing.at, 0.01))
    });
    values.chain(leads).collect()
}

/// What the text says about the order in which the policies are the best.
fn told(run: &HorizonRun) -> Vec<ReproductionRow> {
    let occurs = |model: Model, told: &[(usize, usize)]| {
        let passed: Vec<(usize, usize)> =
            run.crossings(model).iter().map(|Crossing { from, to, .. }| (*from, *to)).collect();
        told.iter().zip(&passed).take_while(|(told, passed)| told == passed).count() as f64
    };
    vec![
        TOLD_H.exact(None, occurs(Model::FiniteHorizon, &[(0, 1), (1, 2)]), 1.0),
        TOLD_GAMMA.exact(None, occurs(Model::Discounted, &[(0, 1)]), 1.0),
    ]
}

/// The curves of a policy in both plots.
fn curves(arm: &Arm, policy: usize) -> Vec<ReproductionCurve> {
    let mut run = HorizonRun::new(HorizonSettings::default(), 0);
    let steps: Vec<_> = std::iter::from_fn(|| run.step()).collect();
    let plots = [
        (Model::FiniteHorizon, "total reward", "horizon h"),
        (Model::Discounted, "discounted reward", "discount γ"),
    ];
    let curve = |(model, quantity, x_name): (Model, &str, &str)| ReproductionCurve {
        arm: arm.name.into(),
        quantity: quantity.into(),
        unit: String::new(),
        x_name: x_name.into(),
        band: String::new(),
        bars: String::new(),
        points: steps
            .iter()
            .filter(|step| step.model == model)
            .map(|step| unsampled(step.parameter, step.values[policy]))
            .collect(),
    };
    plots.map(curve).into()
}

const FINITE: Row<'_> = Row {
    name: "total reward of h = 5 steps",
    published: None,
    unit: "",
    reading: "Eq. (3.1) over t = 0 to h − 1",
};
const DISCOUNTED: Row<'_> =
    Row { name: "discounted reward at γ = 0.9", published: None, unit: "", reading: "Eq. (3.3)" };
const AVERAGE: Row<'_> =
    Row { name: "average reward", published: None, unit: "", reading: "Eq. (3.4)" };
const BEST_FROM_H: Row<'_> = Row {
    name: "horizon from which it is the best",
    published: None,
    unit: "step",
    reading: "where the curves cross, linear between whole horizons; no number is printed",
};
const BEST_FROM_GAMMA: Row<'_> = Row {
    name: "discount from which it is the best",
    published: None,
    unit: "",
    reading: "where the curves cross; no number is printed",
};
const TOLD_H: Row<'_> = Row {
    name: "changes of the best policy that the text tells and that occur, as h rises",
    published: Some(2.0),
    unit: "",
    reading: "\"as the horizon increases the optimum policy changes to a1, for still higher values of h, a2 \
              becomes the optimum policy\"",
};
const TOLD_GAMMA: Row<'_> = Row {
    name: "changes of the best policy that the text tells and that occur, as γ rises",
    published: Some(1.0),
    unit: "",
    reading: "\"small value of γ yields a0 as an optimum policy, when γ increases, a1 takes lead of a0\"",
};

#[cfg(test)]
mod tests;
