//! Experiments I and II of section 2.9: the corridor with the minimum filter, and with the median and
//! Algorithm 1.

use sonarium_core::stats::{Bound, Estimate};

use super::curve::mean_at;
use super::{
    Arm, Drives, Findings, Origin, PUBLISHED, ReproductionError, Row, Sets, Target, Unit, required,
};
use crate::wire::{DriveScore, ReproductionCurve, ReproductionPoint, ReproductionRow};

/// Experiments I and II.
pub static EXPERIMENTS_2_9: Target = Target {
    name: "experiments-2.9",
    title: "A corridor by two ways of processing sonars",
    compares: "What the thesis observed in a corridor of 100 m with three doors and people, by the minimum \
               filter (Experiment I) and by the median and the Kalman filter (Experiment II), against 40 \
               simulated runs an arm at four levels of noise; then each half of the filter alone, each \
               kind of noise alone, sonars fired from the left to the right, and a narrower corridor",
    source: "Section 2.9, Experiments I and II",
    readings: &[
        "The thesis saw one robot in one corridor and printed no number; every row reads its words by a rule \
         that its reading states. What is said of Experiment I is asked of the minimum filter at every level \
         of noise, since the level in the laboratory is not known",
        "Noise x0 is echoes that vary, specular surfaces and edges that are sometimes not heard; each level \
         adds 0.1 for the onset of crosstalk, which lasts 2 s on average, 0.01 for a spurious reading and \
         0.02 for a lost echo. All three are chosen, not measured",
        "The corridor's width of 2.4 m, its people and the 1500 s after which a run is broken off are not in \
         the thesis. It calls doors of 1.8 m comparable to the width of the robot, which is 0.70 m wide",
        "Between walls 2.1 m apart, as if the 2.4 m held walls of the partitions' 0.15 m on both sides, the turning \
         is nearer to that of an independent reconstruction than between walls 2.4 m apart; the width was found \
         by trying 2.0 to 2.4 m against its figures",
        "Both methods drive the same seeds: the same start, people and noise until their ways part",
    ],
    rules: &[PUBLISHED, Bound::RULE],
    experiment: "corridor",
    arms: ARMS,
    unit: Unit::Run,
    trials: 1,
    seeds: 700_000..=700_039,
    find,
};

const MINIMUM: (&str, &str) = (METHOD, "minimum");
const MEDIAN_KALMAN: (&str, &str) = (METHOD, "median-kalman");
const METHOD: &str = "fusion.method";
const LEVEL: &str = "noise.level";
const NAIVE: (&str, &str) = ("sonar.order", "naive");
const NO_CROSSTALK: (&str, &str) = ("noise.crosstalk", "false");
const NO_SPURIOUS: (&str, &str) = ("noise.spurious", "false");
const NO_DROPOUT: (&str, &str) = ("noise.dropout", "false");
const WIDTH: &str = "corridor.width";
const NARROW: (&str, &str) = (WIDTH, "2.1");

const ARMS: &[Arm] = &[
    Arm { name: "minimum, x0", settings: &[MINIMUM, (LEVEL, "0")] },
    Arm { name: "median and Kalman, x0", settings: &[MEDIAN_KALMAN, (LEVEL, "0")] },
    Arm { name: "minimum, x2", settings: &[MINIMUM, (LEVEL, "2")] },
    Arm { name: "median and Kalman, x2", settings: &[MEDIAN_KALMAN, (LEVEL, "2")] },
    Arm { name: "minimum, x4", settings: &[MINIMUM, (LEVEL, "4")] },
    Arm { name: "median and Kalman, x4", settings: &[MEDIAN_KALMAN, (LEVEL, "4")] },
    Arm { name: "minimum, x6", settings: &[MINIMUM, (LEVEL, "6")] },
    Arm { name: "median and Kalman, x6", settings: &[MEDIAN_KALMAN, (LEVEL, "6")] },
    Arm { name: "minimum and Kalman, x4", settings: &[(METHOD, "minimum-kalman"), (LEVEL, "4")] },
    Arm { name: "median alone, x4", settings: &[(METHOD, "median"), (LEVEL, "4")] },
    Arm {
        name: "minimum, x4, crosstalk only",
        settings: &[MINIMUM, (LEVEL, "4"), NO_SPURIOUS, NO_DROPOUT],
    },
    Arm {
        name: "minimum, x4, spurious readings only",
        settings: &[MINIMUM, (LEVEL, "4"), NO_CROSSTALK, NO_DROPOUT],
    },
    Arm {
        name: "minimum, x4, lost echoes only",
        settings: &[MINIMUM, (LEVEL, "4"), NO_CROSSTALK, NO_SPURIOUS],
    },
    Arm { name: "minimum, x1, naive order", settings: &[MINIMUM, (LEVEL, "1"), NAIVE] },
    Arm {
        name: "median and Kalman, x1, naive order",
        settings: &[MEDIAN_KALMAN, (LEVEL, "1"), NAIVE],
    },
    Arm { name: "minimum, x4, naive order", settings: &[MINIMUM, (LEVEL, "4"), NAIVE] },
    Arm {
        name: "median and Kalman, x4, naive order",
        settings: &[MEDIAN_KALMAN, (LEVEL, "4"), NAIVE],
    },
    Arm { name: "minimum, x0, 2.1 m wide", settings: &[MINIMUM, (LEVEL, "0"), NARROW] },
    Arm { name: "minimum, x4, 2.1 m wide", settings: &[MINIMUM, (LEVEL, "4"), NARROW] },
    Arm {
        name: "minimum and Kalman, x4, 2.1 m wide",
        settings: &[(METHOD, "minimum-kalman"), (LEVEL, "4"), NARROW],
    },
    Arm {
        name: "median alone, x4, 2.1 m wide",
        settings: &[(METHOD, "median"), (LEVEL, "4"), NARROW],
    },
    Arm {
        name: "median and Kalman, x4, 2.1 m wide",
        settings: &[MEDIAN_KALMAN, (LEVEL, "4"), NARROW],
    },
];

/// Half the way from the start to where a run is done, metres.
const HALF_WAY_M: f64 = 0.5 * (97.5 - 1.2);
/// A tenth of it.
const TENTH_M: f64 = 0.2 * HALF_WAY_M;
/// Doors of the corridor.
const DOORS: u32 = 3;

/// Cycles between two points of a curve, 30 s.
const EVERY: u32 = 75;
/// Seconds between two points of a curve, and points until a run is broken off.
const EVERY_S: f64 = 30.0;
const POINTS: u32 = 50;

/// What the thesis says of an arm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Claim {
    /// It is Experiment I.
    First,
    /// It is Experiment II.
    Second,
    /// One of the two filters of Experiment II is left out.
    Half,
    /// Nothing: it shows what the outcome hangs on.
    Control,
    /// Nothing: it shows what the turning hangs on.
    Width,
}

impl Claim {
    fn of(arm: &Arm) -> Self {
        let method = setting(arm, METHOD);
        match (arm.settings.len(), method) {
            (2, "minimum") => Self::First,
            (2, "median-kalman") => Self::Second,
            (2, _) => Self::Half,
            _ if !setting(arm, WIDTH).is_empty() => Self::Width,
            _ => Self::Control,
        }
    }
}

fn setting(arm: &Arm, key: &str) -> &'static str {
    let found = arm.settings.iter().find(|(name, _)| *name == key);
    found.map(|(_, value)| *value).unwrap_or_default()
}

fn find(target: &Target, sets: &Sets<'_>) -> Result<Findings, ReproductionError> {
    let run = |arm: &Arm| {
        let watched = [Claim::First, Claim::Second].contains(&Claim::of(arm));
        sets.drives(target, arm, watched.then_some(EVERY))
    };
    let arms: Vec<Drives> = target.arms.iter().map(run).collect::<Result<_, _>>()?;
    let mut findings = Findings::default();
    for drives in &arms {
        findings.rows.extend(rows(drives));
        findings.rows.extend(contrast(drives, &arms));
        findings.curves.extend(curve(drives));
    }
    Ok(findings)
}

/// The rows of an arm by itself.
fn rows(drives: &Drives) -> Vec<ReproductionRow> {
    let found = match Claim::of(&drives.arm) {
        Claim::First => first(drives),
        Claim::Second => second(drives),
        Claim::Half => half(drives),
        Claim::Control => control(drives),
        Claim::Width => width(drives),
    };
    found.into_iter().flatten().collect()
}

type Rows = Vec<Option<ReproductionRow>>;

/// Experiment I.
fn first(drives: &Drives) -> Rows {
    let bounded =
        |name, ours, bound, reading| required::row(drives, name, ours, Some(bound), reading);
    vec![
        ENDS.of(drives, ends_pct(drives)),
        bounded((WAY, "m"), drives.mean(way_m), Bound::AtMost(HALF_WAY_M), HARDLY_MOVED),
        SPEED.of(drives, drives.mean(speed_cm_s)),
        bounded((FORWARD, ""), drives.mean(forward), Bound::AtMost(0.5), NOT_FORWARD),
        FLIPS.of(drives, drives.mean(flips)),
        bounded((PASSED, ""), drives.mean(doors), Bound::AtMost(1.0), NO_DOORS),
        bounded((AT_DOORS, ""), drives.mean(at_doors), Bound::AtLeast(1.0), OFTEN),
        ELSEWHERE.of(drives, drives.share_pct(|score| elsewhere(score) == 0)),
    ]
}

/// Experiment II.
fn second(drives: &Drives) -> Rows {
    let straight = Bound::AtLeast(0.95);
    let clean = |score: &DriveScore| score.clean_doors == DOORS && score.door_contacts == 0;
    vec![
        Row { published: Some(100.0), reading: SUCCEEDS, ..ENDS }.of(drives, ends_pct(drives)),
        PROGRESS.of(drives, drives.mean(way_m)),
        SPEED.of(drives, drives.mean(speed_cm_s)),
        required::row(drives, (FORWARD, ""), drives.mean(forward), Some(straight), STRAIGHT),
        FLIPS.of(drives, drives.mean(flips)),
        CLEAN.of(drives, drives.share_pct(clean)),
        Row { published: Some(100.0), reading: SIDEWAYS, ..ELSEWHERE }
            .of(drives, drives.share_pct(|score| elsewhere(score) == 0)),
    ]
}

/// One of the two filters alone.
fn half(drives: &Drives) -> Rows {
    let ends = if setting(&drives.arm, METHOD) == "median" {
        let most = Some(Bound::AtMost(50.0));
        required::row(drives, (ENDS.name, "%"), ends_pct(drives), most, WITHOUT_KALMAN)
    } else {
        let all = Row { published: Some(100.0), reading: WITH_KALMAN, ..ENDS };
        all.of(drives, ends_pct(drives))
    };
    vec![
        ends,
        PROGRESS.of(drives, drives.mean(way_m)),
        FLIPS.of(drives, drives.mean(flips)),
        TURN.of(drives, drives.mean(|score| score.turn_deg_s)),
    ]
}

/// What the outcome hangs on.
fn control(drives: &Drives) -> Rows {
    vec![
        ENDS.of(drives, ends_pct(drives)),
        PROGRESS.of(drives, drives.mean(way_m)),
        ALONG.of(drives, drives.mean(forward)),
    ]
}

/// What the turning hangs on.
fn width(drives: &Drives) -> Rows {
    vec![
        ENDS.of(drives, ends_pct(drives)),
        SPEED.of(drives, drives.mean(speed_cm_s)),
        FLIPS.of(drives, drives.mean(flips)),
        TURN.of(drives, drives.mean(|score| score.turn_deg_s)),
    ]
}

/// What an arm is held against seed by seed: the arm that differs in the method alone.
fn contrast(drives: &Drives, arms: &[Drives]) -> Option<ReproductionRow> {
    let other = |method: &str| arms.iter().find(|other| differs_in_method(other, drives, method));
    let (name, differences, least, reading) = match setting(&drives.arm, METHOD) {
        "median-kalman" => {
            let gained = drives.differences(other("minimum")?, |run| run.score().map(way_m));
            ((GAINED, "m"), gained, TENTH_M, INFLUENCE)
        }
        "median" => {
            let more = drives.differences(other("median-kalman")?, |run| run.score().map(flips));
            ((MORE_FLIPS, "/min"), more, 0.0, SMOOTHER)
        }
        _ => return None,
    };
    let least = Some(Bound::AtLeast(least));
    required::row(drives, name, Estimate::mean(&differences), least, reading)
}

/// Whether an arm is another's with this method in the place of its own.
fn differs_in_method(arm: &Drives, other: &Drives, method: &str) -> bool {
    let rest =
        |arm: &Arm| arm.settings.iter().filter(|(key, _)| *key != METHOD).collect::<Vec<_>>();
    setting(&arm.arm, METHOD) == method && rest(&arm.arm) == rest(&other.arm)
}

fn ends_pct(drives: &Drives) -> Option<Estimate> {
    drives.share_pct(|score| score.done)
}

fn way_m(score: &DriveScore) -> f64 {
    score.progress_m
}

fn speed_cm_s(score: &DriveScore) -> f64 {
    100.0 * score.forward_m_s
}

fn forward(score: &DriveScore) -> f64 {
    score.straightness
}

fn flips(score: &DriveScore) -> f64 {
    score.flips_per_min
}

fn doors(score: &DriveScore) -> f64 {
    score.doors.into()
}

fn at_doors(score: &DriveScore) -> f64 {
    score.door_contacts.into()
}

fn elsewhere(score: &DriveScore) -> u32 {
    score.wall_contacts + score.people_contacts
}

/// Where the runs of an arm are, over time; nothing of an arm that was not watched.
fn curve(drives: &Drives) -> Option<ReproductionCurve> {
    let watched = drives.runs.iter().all(|run| !run.moments.is_empty());
    watched.then(|| ReproductionCurve {
        arm: drives.arm().into(),
        quantity: "place along the corridor".into(),
        unit: "m".into(),
        x_name: "time, s".into(),
        band: format!("95 % interval of the mean over {} runs", drives.runs.len()),
        bars: "least and greatest of all runs".into(),
        points: (1..=POINTS).map(|point| place(drives, EVERY_S * f64::from(point))).collect(),
    })
}

/// A point of the curve; a run that has ended stays where it was.
fn place(drives: &Drives, time_s: f64) -> ReproductionPoint {
    let x_m = drives.values(|run| {
        let so_far = run.moments.iter().take_while(|moment| moment.time_s <= time_s + 1e-6);
        so_far.last().or(run.moments.first()).map(|moment| moment.at_m[0])
    });
    ReproductionPoint {
        least: x_m.iter().copied().reduce(f64::min),
        greatest: x_m.iter().copied().reduce(f64::max),
        ..mean_at(time_s, &x_m)
    }
}

const ENDS: Row<'_> = Row {
    name: "runs that reach the end of the corridor",
    published: None,
    unit: "%",
    reading: "of 96.3 m from the start, in 1500 s; exact interval of Clopper and Pearson",
};
const SUCCEEDS: &str = "\"the robot moved successfully through the long corridor way\" read as: every run reaches \
    the end, 96.3 m from the start, in 1500 s; exact interval of Clopper and Pearson";
const WITHOUT_KALMAN: &str = "\"the Kalman filter has showed a good success\" read as: without it, with the median \
    alone, at most half of the runs reach the end; exact interval of Clopper and Pearson";
const WITH_KALMAN: &str = "the same read as: with it every run reaches the end, whatever it filters; exact \
    interval of Clopper and Pearson";
const WAY: &str = "way gained along the corridor";
const HARDLY_MOVED: &str = "\"hardly moved through the long corridor\" read as: at most half of the 96.3 m on \
    average; mean over runs, Student's t interval";
const PROGRESS: Row<'_> = Row {
    name: WAY,
    published: None,
    unit: "m",
    reading: "96.3 m at most; mean over runs, Student's t interval",
};
const SPEED: Row<'_> = Row {
    name: "speed along the corridor",
    published: None,
    unit: "cm/s",
    reading: "way gained over time, of at most 15 cm/s; mean over runs, Student's t interval",
};
const FORWARD: &str = "way gained over length of the path";
const NOT_FORWARD: &str = "\"haphazardly without a clear forward motion\" read as: at most half of the path leads \
    forward; mean over runs, Student's t interval";
const STRAIGHT: &str = "\"moving straight down the corridor\" read as: at least 0.95 of the path leads forward; mean \
    over runs, Student's t interval";
const ALONG: Row<'_> = Row {
    name: FORWARD,
    published: None,
    unit: "",
    reading: "1 when it drives straight; mean over runs, Student's t interval",
};
const FLIPS: Row<'_> = Row {
    name: "changes of side of the turn",
    published: None,
    unit: "/min",
    reading: "between turns faster than 1.5 deg/s; \"it turned now and then left or right\" gives no number; mean \
              over runs, Student's t interval",
};
const TURN: Row<'_> = Row {
    name: "turn, whatever its side",
    published: None,
    unit: "deg/s",
    reading: "mean over cycles and runs, Student's t interval over runs",
};
const PASSED: &str = "doors passed, of three";
const NO_DOORS: &str = "\"it couldn't pass through the doors\" read as: at most one of the three on average; mean over \
    runs, Student's t interval";
const AT_DOORS: &str = "contacts with door frames";
const OFTEN: &str = "\"it was seen often colliding with door edges\" read as: at least once a run; mean over runs, \
    Student's t interval";
const CLEAN: Row<'_> = Row {
    name: "runs that pass all three doors without touching a frame",
    published: Some(100.0),
    unit: "%",
    reading: "\"it also passed through the narrow doors without touching the edges\" read as: in every run; exact \
              interval of Clopper and Pearson",
};
const ELSEWHERE: Row<'_> = Row {
    name: "runs without contact with walls and people",
    published: None,
    unit: "%",
    reading: "exact interval of Clopper and Pearson",
};
const SIDEWAYS: &str = "\"turning sideways when it detected obstacle or human\" read as: every run; exact interval of \
    Clopper and Pearson";
const GAINED: &str = "way gained more than by the minimum filter";
const INFLUENCE: &str = "\"the type of sensor processing employed has made a significant influence\" read as: at least a \
    tenth of the 96.3 m, on average; differences of runs of the same seed, Student's t interval";
const MORE_FLIPS: &str = "changes of side of the turn more than with the Kalman filter";
const SMOOTHER: &str = "what the Kalman filter adds to the median: read as not more changes of side; differences of \
    runs of the same seed, Student's t interval";

#[cfg(test)]
mod tests;
