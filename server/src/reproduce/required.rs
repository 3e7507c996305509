//! Rows of what is required of the learner, not published: judged by a bound, beside a yardstick.

use sonarium_core::stats::{Bound, Estimate};

use super::{Origin, Row, Sample, Set};
use crate::wire::{ReproductionRow, Trial, Yardstick};
use crate::yardstick;

/// Last trials of a set in which the goal has to be reached.
const LAST: usize = 5;

/// A row of an arm with the bound it has to keep.
pub(super) fn row(
    origin: &dyn Origin,
    (name, unit): (&str, &str),
    ours: Option<Estimate>,
    bound: Option<Bound>,
    reading: &str,
) -> Option<ReproductionRow> {
    let row = Row { name, published: None, unit, reading };
    let ours = ours?;
    let found = row.of(origin, Some(ours))?;
    let Some(bound) = bound else { return Some(found) };
    Some(ReproductionRow {
        required: Some(words(bound)),
        verdict: bound.judge(&ours).into(),
        ..found
    })
}

/// A bound for people.
fn words(bound: Bound) -> String {
    match bound {
        Bound::AtLeast(least) => format!("≥ {least}"),
        Bound::AtMost(most) => format!("≤ {most}"),
    }
}

/// Share of the last five trials that reached the goal, percent. Trials of a set are alike, so the
/// interval is as wide as if each set were one observation.
pub(super) fn success_pct(sample: &Sample) -> Option<Estimate> {
    let last = |set: &Set| set.trials.len().saturating_sub(LAST);
    let shares: Vec<f64> = sample.values(|set| {
        let trials = &set.trials[last(set)..];
        let reached = trials.iter().filter(|trial| trial.reached_goal).count();
        (!trials.is_empty()).then(|| reached as f64 / trials.len() as f64)
    });
    let (sum, n) = (shares.iter().sum::<f64>(), shares.len());
    let end = |sets: f64| Estimate::proportion(sets as usize, n);
    let (low, high) = (end(sum.floor())?, end(sum.ceil())?);
    Some(Estimate { value: sum / n as f64, low: low.low, high: high.high, n }.scaled(100.0))
}

/// What the best path a planner finds costs less, for a trial, percent of what that path costs. A trial
/// that was capped counts with what it had paid until then, and each with the goal where it truly was.
pub(super) fn excess_pct(trial: &Trial, yardstick: &Yardstick) -> Option<f64> {
    let best = yardstick.ready()?.total_reinforcement;
    (best < 0.0).then(|| 100.0 * (best - trial.true_total_reinforcement()) / -best)
}

/// The best path a planner finds for the arm of a sample.
pub(super) fn yardstick_of(sample: &Sample) -> Yardstick {
    yardstick::compute(&sample.plan)
}
