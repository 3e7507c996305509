//! Chapter 2: fuzzy inference, the filter over a window, and whole runs down the corridor.

use std::fmt::Write;
use std::hint::black_box;

use rand::RngExt;
use sonarium_core::fuzzy::{MOST_INPUTS, MOST_OUTPUTS, RuleBase};
use sonarium_core::perception::Gains;
use sonarium_core::rng::{Purpose, stream};

use super::{Failure, Line, cpu};
use crate::batch;
use crate::catalog::{Catalog, Job, PlainPlan};
use crate::wire::NewSession;

/// Inputs of the rule base and windows at a time, as many as in the comparison, and passes over them between
/// two looks at the time.
const INPUTS: usize = 4096;
const WINDOWS: usize = 1024;
const PASSES: u64 = 16;

/// Rules of the comparison: five inputs with three sets, one with four.
const RULES: u64 = 972;
/// An input whose outputs every engine of the comparison agrees on: 0.30037 and 0.03106.
const KNOWN: [f64; MOST_INPUTS] = [0.25, 0.5, 0.7, 0.33, 0.9, 0.45];

/// The workload of the comparison: 972 rules with two outputs, inputs spread evenly.
pub(super) fn fuzzy() -> Result<Vec<Line>, Failure> {
    let base = RuleBase::parse(&rules()).map_err(failed)?;
    let inputs = evenly::<MOST_INPUTS>(INPUTS);
    let mut outputs = vec![[0.0; MOST_OUTPUTS]; INPUTS];
    let measured = cpu::per_second(|| {
        for _ in 0..PASSES {
            base.evaluate_each(black_box(&inputs), &mut outputs);
            black_box(&outputs);
        }
        Ok(PASSES * INPUTS as u64)
    })?;
    let [y0, y1] = base.evaluate(&KNOWN);
    let note = format!(
        "972 rules, product, weighted mean, two outputs, f64; {INPUTS} inputs at a time; one thread, CPU time; \
         check {y0:.5} {y1:.5}"
    );
    Ok(vec![Line::new("3-fuzzy", "972 rules", "evals/s", measured, &note)])
}

/// The rule base as text; consequents by formula.
fn rules() -> String {
    let three = "  s0 trapezoid -1 -0.5 0.2 0.4\n  s1 trapezoid 0.2 0.4 0.6 0.8\n  \
                 s2 trapezoid 0.6 0.8 1.5 2\n";
    let four = "  s0 trapezoid -1 -0.5 0.1 0.25\n  s1 trapezoid 0.1 0.25 0.4 0.55\n  \
                s2 trapezoid 0.4 0.55 0.7 0.9\n  s3 trapezoid 0.7 0.9 1.5 2\n";
    let mut text = String::from("rules comparison\nnorms algebraic\n");
    for input in 0..MOST_INPUTS {
        let sets = if input + 1 < MOST_INPUTS { three } else { four };
        put(&mut text, &format!("input x{input} - 0 1\n{sets}"));
    }
    text += "output y0 - -1 1\noutput y1 - -1 1\ntable x0 x1 x2 x3 x4 x5 -> y0 y1\n";
    for rule in 0..RULES {
        let [a, b, c, d, e] = [324, 108, 36, 12, 4].map(|below| rule / below % 3);
        let then = |output: u64| ((rule * 7919 + output * 104_729) % 2001) as f64 / 1000.0 - 1.0;
        let when = format!("s{a} s{b} s{c} s{d} s{e} s{}", rule % 4);
        put(&mut text, &format!("{when} -> {} {}\n", then(0), then(1)));
    }
    text
}

fn put(text: &mut String, more: &str) {
    write!(text, "{more}").expect("a string takes any text");
}

/// Regions and readings of a window of the comparison.
const REGIONS: usize = 5;
const WINDOW: usize = 3;

/// The workload of the comparison: five regions, a window of three readings, P₀ = 1, Q = 0.01, R = 0.1.
pub(super) fn kalman() -> Result<Vec<Line>, Failure> {
    // The comparison lets the first reading correct as well: it leaves x = z(0), and this variance.
    let (process, measurement) = (0.01, 0.1);
    let expected = 1.0 + process;
    let first = expected * (1.0 - expected / (expected + measurement));
    let gains = Gains::new(first, process, measurement, WINDOW);
    let windows: Vec<[[f64; REGIONS]; WINDOW]> = {
        let readings = evenly::<{ REGIONS * WINDOW }>(WINDOWS);
        let window = |all: &[f64; REGIONS * WINDOW]| {
            std::array::from_fn(|k| std::array::from_fn(|region| all[k * REGIONS + region]))
        };
        readings.iter().map(window).collect()
    };
    let mut estimates = vec![[0.0; REGIONS]; WINDOWS];
    let measured = cpu::per_second(|| {
        for _ in 0..PASSES {
            gains.estimate_each(black_box(&windows), &mut estimates);
            black_box(&estimates);
        }
        Ok(PASSES * WINDOWS as u64)
    })?;
    let known: [[f64; REGIONS]; WINDOW] = std::array::from_fn(|k| {
        std::array::from_fn(|region| (REGIONS * k + region + 1) as f64 / 16.0)
    });
    let check = gains.estimate(&known);
    let note = format!(
        "5 regions, a window of 3 readings, the gains computed once, f64; {WINDOWS} windows at a time; one thread, \
         CPU time; check {:.5} {:.5}",
        check[0],
        check[REGIONS - 1]
    );
    Ok(vec![Line::new("4-kalman", "precomputed gains", "5x3 windows/s", measured, &note)])
}

/// Numbers from 0 to 1, the same in every measurement.
fn evenly<const N: usize>(count: usize) -> Vec<[f64; N]> {
    let mut rng = stream(7, 0, Purpose::Start);
    (0..count).map(|_| std::array::from_fn(|_| rng.random_range(0.0..1.0))).collect()
}

/// Seeds of the runs down the corridor.
const SEEDS: u64 = 20;

/// Whole runs of Experiment II, with people, doors and noise x4.
pub(super) fn corridor() -> Result<Vec<Line>, Failure> {
    let catalog = Catalog::load(None)?;
    let plans: Vec<PlainPlan> =
        (1..=SEEDS).map(|seed| plan(&catalog, seed)).collect::<Result<_, Failure>>()?;
    let mut next = plans.iter().cycle();
    let runs = cpu::per_second(|| {
        if let Some(plan) = next.next() {
            black_box(batch::drive(plan, || ())?);
        }
        Ok(1)
    })?;
    let measured = runs.iter().map(|runs| 1e3 / runs).collect();
    let note = "100 m, three doors, five people, the full sonar model at noise x4, all filters computed in every \
                cycle, median-kalman drives by 972 rules; seeds 1 to 20, one thread, CPU time, log off";
    Ok(vec![Line::new("corridor", "run of 100 m", "ms", measured, note)])
}

fn plan(catalog: &Catalog, seed: u64) -> Result<PlainPlan, Failure> {
    let job = catalog.job(&NewSession {
        experiment: "corridor".into(),
        seed: Some(seed),
        settings: std::collections::BTreeMap::new(),
        trials: Some(1),
        speed: None,
        network: None,
    })?;
    match job {
        Job::Plain(plan) => Ok(*plan),
        Job::Path(_) => Err(failed("the corridor is not wholly given by its settings")),
    }
}

fn failed(error: impl std::fmt::Display) -> Failure {
    Failure::Failed(error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rules_are_those_of_the_comparison() {
        let base = RuleBase::parse(&rules()).expect("sound");
        let [y0, y1] = base.evaluate(&KNOWN);
        assert!((y0 - 0.30037).abs() < 5e-6 && (y1 - 0.03106).abs() < 5e-6, "{y0} {y1}");
    }
}
