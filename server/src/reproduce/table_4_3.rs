//! Table 4.3: the gain in the reduction of the average number of actions.

use std::ops::RangeInclusive;
use std::sync::Arc;

use sonarium_core::labyrinth::{Bias, Gain, gain, gains, published};
use sonarium_core::stats::Estimate;

use super::episodes::{
    B0, B2, B2_AWAY, B2_TURNS, B2_WEST, B10, B11, B11_CHANCE, B11_FITTED, B30, B31, LABYRINTH,
    READ_B2, READ_B11, READ_GOAL, SCHEME, SIGN, index,
};
use super::{Arm, Course, Findings, PUBLISHED, ReproductionError, Row, Sets, Target, Unit};
use crate::wire::ReproductionRow;

/// Table 4.3.
pub static TABLE_4_3: Target = Target {
    name: "table-4.3",
    title: "What each bias gains",
    compares: "The gain in the reduction of actions of each bias over the unbiased learner, Eq. (4.13): one \
               experiment of ten episodes in the thesis, 400 such experiments for each bias and reading \
               here; the literal readings first, then those that were chosen because the literal ones \
               do not come out",
    source: "Table 4.3, section 4.9",
    readings: &[
        "The published figures come from one experiment of ten episodes, and the mean of 400 is known far \
         better than that: so each is held against our mean, as the rule says, and also against the \
         interval in which a single experiment of ten episodes lies with 95 %; the 5th and the 95th \
         percentile of such experiments stand beside it",
        "The experiments of the biases draw from streams of their own and are held against each other seed by \
         seed: the thesis does not say that its biases shared any numbers. An order that it states is read \
         as holding in every experiment",
        SCHEME,
        SIGN,
        READ_B11,
        READ_B2,
        READ_GOAL,
    ],
    rules: &[PUBLISHED],
    experiment: LABYRINTH,
    arms: ARMS,
    unit: Unit::Experiment,
    trials: TRIALS,
    seeds: EXPERIMENTS,
    find,
};

/// Every bias in its literal reading, then the alternatives.
pub(super) const ARMS: &[Arm] =
    &[B0, B10, B11, B2, B30, B31, B2_WEST, B11_CHANCE, B11_FITTED, B2_AWAY, B2_TURNS];

/// "An episode in turn consists of a set of 100 trials" (section 4.9).
pub(super) const TRIALS: u32 = 100;

/// Seeds of the experiments: 400, which are 4,000 episodes.
pub(super) const EXPERIMENTS: RangeInclusive<u64> = 700_000..=700_399;

fn find(target: &Target, sets: &Sets<'_>) -> Result<Findings, ReproductionError> {
    let courses = target.arms.iter().map(|arm| sets.course(target, arm));
    let courses: Vec<Arc<Course>> = courses.collect::<Result<_, ReproductionError>>()?;
    let mut rows = Vec::new();
    if let Some(unbiased) = courses.iter().find(|course| course.bias() == Bias::B0) {
        for course in &courses {
            rows.extend(rows_of(course, unbiased, &courses));
        }
        rows.extend(orders(&courses, unbiased));
    }
    Ok(Findings { rows, ..Findings::default() })
}

fn rows_of(course: &Course, unbiased: &Course, courses: &[Arc<Course>]) -> Vec<ReproductionRow> {
    let mut rows = gain_rows(course, unbiased);
    rows.extend(INDEX.of(course, course.mean(index)));
    let b10 = courses.iter().find(|course| course.bias() == Bias::B10);
    if let Some(b10) = b10.filter(|_| course.bias() == Bias::B2) {
        rows.extend(MORE_THAN_B10.of(course, more(b10, course, unbiased)));
    }
    rows
}

/// The gain of a bias, over all experiments and in a single one; nothing for the unbiased learner.
fn gain_rows(course: &Course, unbiased: &Course) -> Vec<ReproductionRow> {
    let Some(published) = published(course.bias()) else { return Vec::new() };
    let Some(Gain { mean, .. }) = gain(&course.episodes, &unbiased.episodes) else {
        return Vec::new();
    };
    let single = gains(&course.episodes, &unbiased.episodes);
    let found = [
        (Row { published: Some(published), ..GAIN }, Some(mean)),
        (Row { published: Some(published), ..SINGLE }, Estimate::single(&single)),
        (LOW, Estimate::quantile(&single, 0.05)),
        (HIGH, Estimate::quantile(&single, 0.95)),
    ];
    found.iter().filter_map(|(row, ours)| row.of(course, *ours)).collect()
}

/// What the thesis says about the order of the biases, with the literal readings and with others.
fn orders(courses: &[Arc<Course>], unbiased: &Course) -> Vec<ReproductionRow> {
    // Gains of one experiment, in the order in which the table has them fall.
    let falls = |gains: &[f64]| gains.windows(2).all(|pair| pair[0] > pair[1]);
    let first = |gains: &[f64]| gains[1..].iter().all(|other| gains[0] > *other);
    let but_last = |gains: &[f64]| falls(&gains[..4]) && gains[2] > gains[4];
    let literal = &[B31, B2, B11, B30, B10];
    let chosen = &[B31, B2_AWAY, B11_FITTED, B30, B10];
    let share = |arms: &[Arm], is_so: &dyn Fn(&[f64]) -> bool| {
        let find = |arm: &Arm| courses.iter().find(|course| course.arm.name == arm.name);
        let named: Option<Vec<&Course>> =
            arms.iter().map(|arm| find(arm).map(Arc::as_ref)).collect();
        share(&named?, unbiased, is_so)
    };
    let rows = [
        (BEST, share(literal, &first)),
        (ORDER, share(literal, &falls)),
        (ORDER_CHOSEN, share(chosen, &falls)),
        (ORDER_BUT_LAST, share(chosen, &but_last)),
    ];
    rows.iter().filter_map(|(row, ours)| row.over_arms(*ours)).collect()
}

/// Share of experiments in which one course gains more than another, percent.
pub(super) fn more(than: &Course, course: &Course, unbiased: &Course) -> Option<Estimate> {
    share(&[course, than], unbiased, &|gains| gains[0] > gains[1])
}

/// Share of experiments whose gains, one a course, are so, percent.
fn share(
    courses: &[&Course],
    unbiased: &Course,
    is_so: &dyn Fn(&[f64]) -> bool,
) -> Option<Estimate> {
    let of = |course: &&Course| gains(&course.episodes, &unbiased.episodes);
    let gains: Vec<Vec<f64>> = courses.iter().map(of).collect();
    let experiments = gains.first()?.len();
    let one = |at: usize| gains.iter().map(|gains| gains[at]).collect::<Vec<f64>>();
    let count = (0..experiments).filter(|at| is_so(&one(*at))).count();
    Some(Estimate::proportion(count, experiments)?.scaled(100.0))
}

const GAIN: Row<'_> = Row {
    name: "gain in the reduction of actions",
    published: None,
    unit: "%",
    reading: "Eq. (4.13) from the mean J of all experiments; interval of its mean over experiments, \
              Student's t, which a published figure from one experiment need not keep",
};
const SINGLE: Row<'_> = Row {
    name: "gain of one experiment of ten episodes",
    published: None,
    unit: "%",
    reading: "Eq. (4.13) of single experiments: their median, and the interval that holds the middle 95 % \
              of them, in which one experiment like the thesis's would lie; where it is wider than half \
              the published figure, agreement says nothing",
};
const LOW: Row<'_> = Row {
    name: "gain of one experiment, 5th percentile",
    published: None,
    unit: "%",
    reading: "one experiment in twenty gains less; interval of order statistics",
};
const HIGH: Row<'_> = Row {
    name: "gain of one experiment, 95th percentile",
    published: None,
    unit: "%",
    reading: "one experiment in twenty gains more; interval of order statistics",
};
const INDEX: Row<'_> = Row {
    name: "J, actions a trial",
    published: None,
    unit: "",
    reading: "Eq. (4.12), mean over the 100 trials of an episode; mean over experiments, Student's t \
              interval; the thesis prints no J, but the gain of 75.9 % demands at least 20.75 of B0, since \
              no trial takes fewer than 5 actions",
};
const MORE_THAN_B10: Row<'_> = Row {
    name: "experiments in which it gains more than B10",
    published: Some(100.0),
    unit: "%",
    reading: "\"the former bias (insight bias) is far better than the latter\" read as: in every experiment; \
              exact interval of Clopper and Pearson",
};
const BEST: Row<'_> = Row {
    name: "experiments in which B31 gains most, literal readings",
    published: Some(100.0),
    unit: "%",
    reading: "\"only bias B31 produced a significant leap\" read as its gaining most in every experiment; \
              exact interval of Clopper and Pearson",
};
const ORDER: Row<'_> = Row {
    name: "experiments in the order B31, B2, B11, B30, B10, literal readings",
    published: Some(100.0),
    unit: "%",
    reading: "the order of the table read as holding in every experiment; exact interval of Clopper and \
              Pearson",
};
const ORDER_CHOSEN: Row<'_> = Row {
    name: "experiments in the order B31, B2, B11, B30, B10, with B2 away and B11 chance 0.75",
    published: Some(100.0),
    unit: "%",
    reading: "the same with the two readings chosen after the fact; exact interval of Clopper and Pearson",
};
const ORDER_BUT_LAST: Row<'_> = Row {
    name: "experiments in the same order but for B30 and B10",
    published: None,
    unit: "%",
    reading: "B30 and B10, which the table has 1.2 apart, in either order; exact interval of Clopper and \
              Pearson",
};

#[cfg(test)]
mod tests;
