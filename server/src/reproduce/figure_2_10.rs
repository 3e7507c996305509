//! Figure 2.10: two block worlds.

use sonarium_core::stats::{Bound, Estimate};

use super::{
    Arm, Drive, Drives, Findings, PUBLISHED, Picture, ReproductionError, Row, Sets, Target, Unit,
    required,
};
use crate::catalog::PlainPlan;
use crate::render::view::{ArenaView, PathOf, RobotPose};
use crate::session::course;
use crate::wire::{DriveScore, ReproductionRow};

/// Figure 2.10.
pub static FIGURE_2_10: Target = Target {
    name: "figure-2.10",
    title: "A robot driven by rules among blocks",
    compares: "A simulated robot with ideal sonars and the minimum filter, driven by the 972 rules through two \
               block worlds: 40 random starts of 600 s in each, and a run that is drawn as the figure draws \
               one; and what the median and the Kalman filter do there",
    source: "Figure 2.10, section 2.9",
    readings: &[
        "The figure is lost; the size of its world, of the robot and its range are printed. The blocks and the \
         starts here are ours, sparse in one world and in rows in the other",
        "The thesis takes the sonars of its simulator to be ideal; here they are all read at the end of a cycle. \
         Fired one after the other while the robot moves, they are up to 0.4 s old, and it backs up more",
        "The controller's constants are not printed either. They were chosen in such worlds, on other seeds",
        "The thesis's words are read by rules: safely as no contact, smoothly as a turn that changes by at most \
         1 deg/s from cycle to cycle, a tenth of the greatest, and as backing up in at most 5 % of the \
         cycles, slowing down rarely as at most 20 % of the cycles slower than 5 cm/s",
    ],
    rules: &[PUBLISHED, Bound::RULE],
    experiment: "block-world",
    arms: ARMS,
    unit: Unit::Run,
    trials: 1,
    seeds: 700_000..=700_039,
    find,
};

const SPARSE: (&str, &str) = ("world.blocks", "sparse");
const DENSE: (&str, &str) = ("world.blocks", "dense");
const ANYWHERE: (&str, &str) = ("start.place", "random");
const LIMIT: (&str, &str) = ("trial.time_limit", "600");
const MEDIAN_KALMAN: (&str, &str) = ("fusion.method", "median-kalman");

const ARMS: &[Arm] = &[
    Arm { name: "sparse", settings: &[SPARSE, ANYWHERE, LIMIT] },
    Arm { name: "dense", settings: &[DENSE, ANYWHERE, LIMIT] },
    Arm { name: "sparse, median and Kalman", settings: &[SPARSE, ANYWHERE, LIMIT, MEDIAN_KALMAN] },
    Arm { name: "dense, median and Kalman", settings: &[DENSE, ANYWHERE, LIMIT, MEDIAN_KALMAN] },
];

/// The runs that are drawn, and the arms that they belong to. Nothing in them is drawn at random.
const SHOWN: [(&str, &[(&str, &str)]); 2] = [("sparse", &[SPARSE]), ("dense", &[DENSE])];

/// A unit of the thesis's world, metres.
const UNIT_M: f64 = 0.2;

fn find(target: &Target, sets: &Sets<'_>) -> Result<Findings, ReproductionError> {
    let mut findings = Findings::default();
    for arm in target.arms {
        let shown = SHOWN.iter().find(|(name, _)| *name == arm.name);
        let drives = sets.drives(target, arm, shown.map(|_| 1))?;
        let Some(&(name, settings)) = shown else {
            findings.rows.extend(touching(&drives));
            continue;
        };
        findings.rows.extend(rows(&drives));
        let plan = sets.drive_plan(target, &Arm { name, settings })?;
        let run = Drive::run(&plan, Some(1))?;
        findings.rows.extend(run.score().map(|score| shown_rows(arm, score)).unwrap_or_default());
        findings.pictures.push(picture(arm, &plan, &run)?);
    }
    Ok(findings)
}

/// What the thesis says about the controller in its simulation.
fn rows(drives: &Drives) -> Vec<ReproductionRow> {
    let bounded = |name, ours, most, reading| {
        required::row(drives, name, ours, Some(Bound::AtMost(most)), reading)
    };
    let change = Estimate::mean(&drives.values(|run| Some(turn_change_deg_s(run))));
    let rows = vec![
        Row { published: Some(100.0), reading: SAFELY, ..UNTOUCHED }.of(drives, untouched(drives)),
        CLEARANCE.of(drives, drives.mean(|score| score.clearance_m)),
        VELOCITY.of(drives, drives.mean(|score| 100.0 * score.speed_m_s)),
        bounded(
            ("cycles slower than 5 cm/s", "%"),
            drives.mean(|score| score.slow_pct),
            20.0,
            RARELY,
        ),
        bounded(("change of the turn in a cycle", "deg/s"), change, 1.0, SMOOTHLY),
        bounded(
            ("cycles that back up", "%"),
            drives.mean(|score| score.reverse_pct),
            5.0,
            FORWARDS,
        ),
    ];
    rows.into_iter().flatten().collect()
}

/// What the thesis does not say: the other filter in the same worlds.
fn touching(drives: &Drives) -> Vec<ReproductionRow> {
    let rows = [
        UNTOUCHED.of(drives, untouched(drives)),
        CONTACTS.of(drives, drives.mean(|score| contacts(score).into())),
        VELOCITY.of(drives, drives.mean(|score| 100.0 * score.speed_m_s)),
    ];
    rows.into_iter().flatten().collect()
}

fn shown_rows(arm: &Arm, score: &DriveScore) -> Vec<ReproductionRow> {
    let name = Some(arm.name);
    vec![
        SHOWN_CONTACTS.exact(name, contacts(score).into(), 1.0),
        SHOWN_PATH.exact(name, score.path_m / UNIT_M, 1.0),
        SHOWN_VELOCITY.exact(name, 100.0 * score.speed_m_s, 0.1),
        SHOWN_REVERSE.exact(name, score.reverse_pct, 1.0),
    ]
}

fn contacts(score: &DriveScore) -> u32 {
    score.wall_contacts + score.block_contacts
}

fn untouched(drives: &Drives) -> Option<Estimate> {
    drives.share_pct(|score| contacts(score) == 0)
}

/// Mean change of the turn from one cycle to the next, deg/s, whatever its side.
fn turn_change_deg_s(run: &Drive) -> f64 {
    let pairs = run.moments.windows(2);
    let changes = pairs.map(|pair| (pair[1].turn_deg_s - pair[0].turn_deg_s).abs());
    sonarium_core::stats::mean(&changes.collect::<Vec<f64>>()).unwrap_or(0.0)
}

/// The way of the run that is shown.
fn picture(arm: &Arm, plan: &PlainPlan, run: &Drive) -> Result<Picture, ReproductionError> {
    let course = course(plan)?;
    let contacts = run.score().map_or(0, contacts);
    let caption = format!("{}, 300 s with ideal sonars: {contacts} contacts", arm.name);
    let view = ArenaView {
        path_of: PathOf::Run,
        bounds_m: course.bounds_m,
        walls_m: course.faces.iter().map(|face| face.segment_m).collect(),
        home: RobotPose { at_m: [f64::NAN; 2], heading_rad: 0.0 },
        path_m: run.moments.iter().map(|moment| moment.at_m).collect(),
        collisions_m: (run.moments.iter().filter(|moment| moment.bumped))
            .map(|moment| moment.at_m)
            .collect(),
        caption,
        ..ArenaView::default()
    };
    let alt = format!("Map of the block world with the robot's way. {}", view.caption);
    Ok(Picture { name: format!("{}-shown", arm.name), arm: arm.name.into(), alt, view })
}

const UNTOUCHED: Row<'_> = Row {
    name: "runs without a contact",
    published: None,
    unit: "%",
    reading: "of 600 s from a random start; exact interval of Clopper and Pearson",
};
const SAFELY: &str = "\"our fuzzy controller drove the simulated robot safely\" read as: in every run of 600 s from a \
    random start; exact interval of Clopper and Pearson";
const CONTACTS: Row<'_> = Row {
    name: "contacts",
    published: None,
    unit: "",
    reading: "in 600 s; the median drops the few sonars that hear a block's corner; mean over runs, Student's t \
              interval",
};
const CLEARANCE: Row<'_> = Row {
    name: "least clearance of a run",
    published: None,
    unit: "m",
    reading: "mean over runs, Student's t interval",
};
const VELOCITY: Row<'_> = Row {
    name: "velocity",
    published: None,
    unit: "cm/s",
    reading: "of at most 15 cm/s; mean over runs, Student's t interval",
};
const RARELY: &str = "\"slowing down rarely in areas where obstacles were tight\" read as: at most 20 % of the cycles; \
    mean over runs, Student's t interval";
const SMOOTHLY: &str = "\"smoothly\" read as: by at most 1 deg/s on average, a tenth of the greatest turn; mean over \
    runs, Student's t interval";
const FORWARDS: &str = "\"smoothly\" read as: at most 5 % of the cycles; the rules back up and turn when a wall is met \
    head-on; mean over runs, Student's t interval";
const SHOWN_CONTACTS: Row<'_> = Row {
    name: "contacts of the run shown",
    published: Some(0.0),
    unit: "",
    reading: "300 s from the start that is drawn; nothing is drawn at random",
};
const SHOWN_PATH: Row<'_> = Row {
    name: "way of the run shown",
    published: None,
    unit: "unit",
    reading: "the world is 47.5 units wide; a unit is 0.2 m",
};
const SHOWN_VELOCITY: Row<'_> = Row {
    name: "velocity of the run shown",
    published: None,
    unit: "cm/s",
    reading: "mean over its cycles",
};
const SHOWN_REVERSE: Row<'_> = Row {
    name: "cycles of the run shown that back up",
    published: None,
    unit: "%",
    reading: "share of its cycles",
};

#[cfg(test)]
mod tests;
