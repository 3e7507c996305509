//! Figure 2.5: the distance of a wall that comes nearer, by the minimum filter and by the median and
//! Algorithm 1.

use sonarium_core::perception::Method;
use sonarium_core::stats::{Bound, Estimate};

use super::curve::unsampled;
use super::{
    Arm, Drive, Drives, Findings, Moment, ReproductionError, Row, Sets, Target, Unit, required,
};
use crate::catalog::PlainPlan;
use crate::wire::{DriveOutcome, MethodScoreView, ReproductionCurve, ReproductionRow};

/// Figure 2.5.
pub static FIGURE_2_5: Target = Target {
    name: "figure-2.5",
    title: "The distance of a wall by two filters",
    compares: "A robot glides from 2 m to 0.2 m towards a wall; the depth of the middle region by the minimum \
               filter and by the median and the Kalman filter, and by each half of the latter, against the \
               distance itself, over 300 runs at each level of noise and in each order of firing",
    source: "Figure 2.5, section 2.5",
    readings: &[
        "The figure's curves are lost; the text says that the minimum \"practically failed to deliver a distance \
         variation that corresponds to the motion\" while the other \"successfully generated the expected linear \
         variation\". Linear is read as: a straight line in time explains at least 0.95 of the variation; \
         failed as: it explains at most 0.9",
        "The velocity, 0.1 m/s, and the noise are not in the thesis; its sonars were real. All filters are given \
         the same readings",
        "The window of four readings lags a robot that moves by 1.5 cycles, 6 cm at this velocity. The error \
         counts that lag, the line does not",
    ],
    rules: &[Bound::RULE],
    experiment: "wall-approach",
    arms: ARMS,
    unit: Unit::Run,
    trials: 1,
    seeds: 700_000..=700_299,
    find,
};

const ARMS: &[Arm] = &[
    Arm { name: "ideal", settings: &[("noise.ideal", "true")] },
    Arm { name: "x0", settings: &[("noise.level", "0")] },
    Arm { name: "x1", settings: &[("noise.level", "1")] },
    Arm { name: "x4", settings: &[("noise.level", "4")] },
    Arm { name: "x1, naive order", settings: &[("noise.level", "1"), ("sonar.order", "naive")] },
    Arm { name: "x4, naive order", settings: &[("noise.level", "4"), ("sonar.order", "naive")] },
];

/// The filters, as settings and pictures name them, and for people; the two of the figure first.
const FILTERS: [(Method, &str, &str); 4] = [
    (Method::Minimum, MINIMUM, "minimum"),
    (Method::MedianKalman, MEDIAN_KALMAN, "median and Kalman"),
    (Method::MinimumKalman, "minimum-kalman", "minimum and Kalman"),
    (Method::Median, "median", "median alone"),
];
const MINIMUM: &str = "minimum";
const MEDIAN_KALMAN: &str = "median-kalman";

/// What the thesis says about the line of each of the figure's filters.
const FAILED: Bound = Bound::AtMost(0.9);
const LINEAR: Bound = Bound::AtLeast(0.95);
/// Upward steps that are still small: a tenth of the way.
const SMALL_M: f64 = 0.18;

fn find(target: &Target, sets: &Sets<'_>) -> Result<Findings, ReproductionError> {
    let mut findings = Findings::default();
    for arm in target.arms {
        let drives = sets.drives(target, arm, None)?;
        findings.rows.extend(rows(&drives));
        findings.curves.extend(curves(arm, &sets.drive_plan(target, arm)?)?);
    }
    Ok(findings)
}

fn rows(drives: &Drives) -> Vec<ReproductionRow> {
    let mut rows = Vec::new();
    for (_, method, name) in FILTERS {
        let row = |quantity: &str, unit, of: fn(&MethodScoreView) -> f64, bound, reading| {
            let ours = mean(drives, method, of);
            required::row(drives, (&format!("{name}, {quantity}"), unit), ours, bound, reading)
        };
        let (straight, reading) = match method {
            MINIMUM => (Some(FAILED), IT_FAILED),
            MEDIAN_KALMAN => (Some(LINEAR), IT_IS_LINEAR),
            _ => (None, LINE),
        };
        let rise = (method == MEDIAN_KALMAN).then_some(Bound::AtMost(SMALL_M));
        rows.extend(row("R² of a line", "", |score| score.r2, straight, reading));
        rows.extend(row("upward steps", "m", |score| score.rise_m, rise, RISE));
        rows.extend(row("error", "m", |score| score.rms_m, None, ERROR));
    }
    rows.extend(better(drives));
    rows.extend(HAUNTED.of(drives, Estimate::mean(&drives.values(haunted_pct))));
    rows
}

fn mean(drives: &Drives, method: &str, of: fn(&MethodScoreView) -> f64) -> Option<Estimate> {
    Estimate::mean(&drives.values(|run| run.told(method).map(of)))
}

/// How much greater the error of the minimum is than that of the median and the Kalman filter.
fn better(drives: &Drives) -> Option<ReproductionRow> {
    let less = drives.values(|run| Some(run.told(MINIMUM)?.rms_m - run.told(MEDIAN_KALMAN)?.rms_m));
    let name = ("error of the minimum less that of the median and Kalman", "m");
    let least = Some(Bound::AtLeast(0.0));
    required::row(drives, name, Estimate::mean(&less), least, BETTER)
}

fn haunted_pct(run: &Drive) -> Option<f64> {
    match &run.outcome {
        DriveOutcome::Approach { haunted_pct, .. } => Some(*haunted_pct),
        DriveOutcome::Drive(_) => None,
    }
}

/// The depths of the first seed's run by the filters of the figure, and the distance itself.
fn curves(arm: &Arm, plan: &PlainPlan) -> Result<Vec<ReproductionCurve>, ReproductionError> {
    let moments = Drive::run(plan, Some(1))?.moments;
    let curve = |quantity: String, of: &dyn Fn(&Moment) -> Option<f64>| ReproductionCurve {
        arm: arm.name.into(),
        quantity,
        unit: "m".into(),
        x_name: "time, s".into(),
        band: String::new(),
        bars: String::new(),
        points: moments.iter().filter_map(|now| Some(unsampled(now.time_s, of(now)?))).collect(),
    };
    let mut curves = vec![curve("distance of the wall".into(), &|now| Some(now.truth_m))];
    for (method, _, name) in FILTERS.into_iter().take(2) {
        let place = Method::ALL.iter().position(|each| *each == method);
        let depth = |now: &Moment| now.depths_m.get(place?).copied();
        curves.push(curve(format!("depth by the {name}"), &depth));
    }
    Ok(curves)
}

const LINE: &str = "a straight line in time, least squares; mean over runs, Student's t interval";
const IT_FAILED: &str = "\"practically failed to deliver a distance variation that corresponds to the motion\" read \
    as: a straight line in time explains at most 0.9 of it; mean over runs, Student's t interval";
const IT_IS_LINEAR: &str = "\"successfully generated the expected linear variation\" read as: a straight line in time \
    explains at least 0.95 of it; mean over runs, Student's t interval";
const RISE: &str = "their sum in a run; the distance itself only falls. \"without much swing\" is read as at most a \
    tenth of the 1.8 m, of the filter that it is said of; mean over runs, Student's t interval";
const ERROR: &str =
    "root of the mean square against the distance; mean over runs, Student's t interval";
const BETTER: &str = "\"successfully removed the noise and delivered a clean depth estimate\" read as: the error is not \
    greater than the minimum's; differences of the same runs, Student's t interval";
const HAUNTED: Row<'_> = Row {
    name: "sonars that hear a ghost",
    published: None,
    unit: "%",
    reading: "\"sonars that are fired consecutively are placed, as much as possible, far apart\" gives no number; \
              share of cycles and sonars, mean over runs, Student's t interval",
};

#[cfg(test)]
mod tests;
