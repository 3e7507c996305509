//! Figures 4.10 and 4.11: the learning curves of the biases, and what section 4.9 says about them.

use std::sync::Arc;

use sonarium_core::labyrinth::Bias;
use sonarium_core::stats::{Bound, Estimate};

use super::episodes::{
    B0, B2, B2_AWAY, B2_TURNS, B2_WEST, B10, B11, B11_CHANCE, B11_FITTED, B30, B31, LABYRINTH,
    READ_B2, READ_B11, READ_GOAL, SCHEME, SIGN, curve, last_ten, settled,
};
use super::table_4_3::{EXPERIMENTS, TRIALS, more};
use super::{Course, Findings, PUBLISHED, ReproductionError, Row, Sets, Target, Unit, required};
use crate::wire::ReproductionRow;

const DRAWN: &str = "A point is the mean of ten episodes in the thesis (\"cumulative averages of ten \
    episodes\" is read as the plain mean of each trial); the line here is the mean of 400 such points, and \
    the bars are where single ones lie";

/// What the two have in common.
const CURVES: Target = Target {
    name: "figure-4.10",
    title: "Learning curves of the two environment biases",
    compares: "Actions of each trial with B10 and B11 beside the unbiased learner, and what section 4.9 says \
               about these curves: one experiment of ten episodes in the thesis, whose figure prints no \
               numbers; 400 such experiments for each reading here",
    source: "Figure 4.10, section 4.9",
    readings: &[DRAWN, SCHEME, SIGN, READ_B11],
    rules: &[PUBLISHED, Bound::RULE],
    experiment: LABYRINTH,
    arms: &[B0, B10, B11, B11_CHANCE, B11_FITTED],
    unit: Unit::Experiment,
    trials: TRIALS,
    seeds: EXPERIMENTS,
    find,
};

/// Figure 4.10.
pub static FIGURE_4_10: Target = CURVES;

/// Figure 4.11.
pub static FIGURE_4_11: Target = Target {
    name: "figure-4.11",
    title: "Learning curves of the insight and goal biases",
    compares: "Actions of each trial with B2, B30 and B31 beside the unbiased learner, and what section 4.9 \
               says about these curves: one experiment of ten episodes in the thesis, whose figure prints \
               no numbers; 400 such experiments for each reading here",
    source: "Figure 4.11, section 4.9",
    readings: &[DRAWN, SCHEME, SIGN, READ_B2, READ_GOAL],
    arms: &[B0, B2, B30, B31, B2_WEST, B2_AWAY, B2_TURNS],
    ..CURVES
};

/// Actions at or below which a curve counts as settled: twice the fewest there are.
const SETTLED: f64 = 10.0;

fn find(target: &Target, sets: &Sets<'_>) -> Result<Findings, ReproductionError> {
    let courses = target.arms.iter().map(|arm| sets.course(target, arm));
    let courses: Vec<Arc<Course>> = courses.collect::<Result<_, ReproductionError>>()?;
    let mut findings = Findings::default();
    let of = |bias| courses.iter().find(move |course| course.bias() == bias);
    let Some(unbiased) = of(Bias::B0) else { return Ok(findings) };
    for course in &courses {
        findings.curves.push(curve(course.arm.name, "number of actions", &course.episodes));
        findings.rows.extend(final_rows(course, unbiased));
        findings.rows.extend(early_rows(course, unbiased));
        if let Some(near) = of(Bias::B30).filter(|_| course.bias() == Bias::B2) {
            findings.rows.extend(MORE_THAN_B30.of(course, more(near, course, unbiased)));
        }
    }
    Ok(findings)
}

/// How it ends.
fn final_rows(course: &Course, unbiased: &Course) -> Vec<ReproductionRow> {
    let ours = course.mean(last_ten);
    if course.bias() != Bias::B11 {
        return LAST_TEN.of(course, ours).into_iter().collect();
    }
    let open = Row { published: None, reading: LAST_TEN_B11, ..LAST_TEN };
    let pairs = course.values(last_ten).into_iter().zip(unbiased.values(last_ten));
    let more: Vec<f64> = pairs.map(|(biased, unbiased)| biased - unbiased).collect();
    let name = ("actions of the last ten trials more than B0's", "");
    let bound = Some(Bound::AtLeast(0.0));
    let worse = required::row(course, name, Estimate::mean(&more), bound, WORSE);
    [open.of(course, ours), worse].into_iter().flatten().collect()
}

/// How soon it is there.
fn early_rows(course: &Course, unbiased: &Course) -> Vec<ReproductionRow> {
    let trials = |course: &Course| course.values(|experiment| settled(experiment, SETTLED));
    let ours = Estimate::mean(&trials(course));
    let ratios = || {
        let pairs = trials(course).into_iter().zip(trials(unbiased));
        pairs.map(|(biased, unbiased)| biased / unbiased).collect::<Vec<f64>>()
    };
    let as_many =
        (course.bias() == Bias::B10).then(|| AS_MANY.of(course, Estimate::mean(&ratios())));
    [SETTLING.of(course, ours), as_many.flatten()].into_iter().flatten().collect()
}

const LAST_TEN: Row<'_> = Row {
    name: "actions of the last ten trials",
    published: Some(5.0),
    unit: "",
    reading: "\"until it settles to the optimum action\" read as the fewest there are, 5; mean over trials 91 \
              to 100, then over experiments, Student's t interval; a softmax learner still tries other \
              actions there now and then",
};
const LAST_TEN_B11: &str = "\"its steady state policy was even poorer than the unbiased policy\" gives no number; \
    mean over trials 91 to 100, then over experiments, Student's t interval";
const WORSE: &str = "\"with bias B11 the agent failed to learn the optimal policy\" read as: it takes more actions \
    than the unbiased learner in trials 91 to 100, on average over experiments, seed by seed; Student's t \
    interval";
const SETTLING: Row<'_> = Row {
    name: "trials until the curve stays at or below 10 actions",
    published: None,
    unit: "",
    reading: "the first trial from which on the mean of an experiment's ten episodes never exceeds twice the \
              fewest actions, 101 where there is none; the figure prints no number; mean over experiments, \
              Student's t interval",
};
const AS_MANY: Row<'_> = Row {
    name: "trials until the curve settles over those of B0",
    published: Some(1.0),
    unit: "",
    reading: "\"took almost the same number of trials as when it was unbiased\" read as a ratio of 1; how much \
              \"almost\" would allow is not said; settled at or below 10 actions; mean over experiments, seed \
              by seed, Student's t interval",
};
const MORE_THAN_B30: Row<'_> = Row {
    name: "experiments in which it gains more than B30",
    published: Some(100.0),
    unit: "%",
    reading: "\"the near goal bias B30 performed even worse than B2\" read as: B2 gains more, Eq. (4.13), in every \
              experiment; exact interval of Clopper and Pearson",
};
