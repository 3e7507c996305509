//! Figure 5.10: the first and the last trajectory, and the three behaviours its caption names.

use sonarium_core::stats::Estimate;

use super::{
    Findings, PRESETS, PUBLISHED, Picture, ReproductionError, Row, SEEDS, Sample, Set, Sets,
    Target, Unit,
};
use crate::catalog::{DEFAULT_TRIALS, MINIMUM_COST_PATH};
use crate::render::ArenaView;
use crate::session::Scenery;
use crate::wire::{ReproductionRow, Trial};

/// Figure 5.10.
pub static FIGURE_5_10: Target = Target {
    name: "figure-5.10",
    title: "Trajectories of the first and the final trial",
    compares: "The three things the caption says the robot has learned, each as a number over 200 sets \
               a preset: to skip the concave region, to pass in the middle of the door, and to head \
               directly to the goal after it; reflex, which never learns, is the control",
    source: "Figure 5.10, section 5.11",
    readings: &[
        "The caption gives words only; each was turned into a number, and its share of sets is held \
         against all of them",
        "The pictures show the set of the first seed, whatever it looks like",
        "The door is crossed where the true path passes the middle of the wall for the last time",
        "A trial that does not reach the goal skips nothing, passes nothing and heads nowhere: it \
         counts against the shares, and not in the means over crossings",
    ],
    rules: &[PUBLISHED],
    experiment: MINIMUM_COST_PATH,
    arms: PRESETS,
    unit: Unit::Set,
    trials: DEFAULT_TRIALS,
    seeds: SEEDS,
    find,
};

/// Middle of the laboratory's door, metres.
const DOOR_M: [f64; 2] = [3.625, -0.35];
/// Width of its opening, metres.
const DOOR_WIDTH_M: f64 = 1.3;

fn find(target: &Target, sets: &Sets<'_>) -> Result<Findings, ReproductionError> {
    let mut findings = Findings::default();
    for arm in target.arms {
        let sample = sets.shared(target, arm)?;
        findings.rows.extend(rows(&sample));
        findings.pictures.extend(pictures(&sample));
    }
    Ok(findings)
}

fn rows(sample: &Sample) -> Vec<ReproductionRow> {
    let first = |of: fn(&Way<'_>) -> Option<f64>| sample.mean(move |set| of(&Way::first(set)?));
    let last = |of: fn(&Way<'_>) -> Option<f64>| sample.mean(move |set| of(&Way::last(set)?));
    let share = |is_so: fn(&Way<'_>) -> bool| {
        sample.share_pct(move |set| Way::last(set).is_some_and(|way| is_so(&way)))
    };
    let rows: [(Row<'_>, Option<Estimate>); 8] = [
        (CONCAVE_FIRST, first(|way| way.concave_steps())),
        (CONCAVE_LAST, last(|way| way.concave_steps())),
        (CONCAVE_SKIPPED, share(|way| way.skips_the_concave_region())),
        (OFFSET_FIRST, first(|way| way.door_offset_m())),
        (OFFSET_LAST, last(|way| way.door_offset_m())),
        (MIDDLE_PASSED, share(|way| way.passes_mid_door())),
        (DETOUR_FIRST, first(|way| way.detour())),
        (DETOUR_LAST, last(|way| way.detour())),
    ];
    rows.iter().filter_map(|(row, ours)| row.of(sample, *ours)).collect()
}

const CONCAVE_FIRST: Row<'_> = Row {
    name: "steps in the concave region, first trial",
    published: None,
    unit: "",
    reading: "control steps decided upon while the robot believed to be in the region \"concave\"; the \
              figure shows the fold, and prints no number",
};
const CONCAVE_LAST: Row<'_> = Row {
    name: "steps in the concave region, last trial",
    published: Some(0.0),
    unit: "",
    reading: "\"to skip the concave region\" read as no step in it",
};
const CONCAVE_SKIPPED: Row<'_> = Row {
    name: "sets whose last trial skips the concave region",
    published: Some(100.0),
    unit: "%",
    reading: "\"the robot has learned to skip the concave region\" read as: the last trial of every set \
              reaches the goal without a step in it",
};
const OFFSET_FIRST: Row<'_> = Row {
    name: "distance from the middle of the door, first trial",
    published: None,
    unit: "m",
    reading: "distance of the true path from the middle of the opening, where it passes the middle of \
              the wall; the figure prints no number",
};
const OFFSET_LAST: Row<'_> = Row {
    name: "distance from the middle of the door, last trial",
    published: None,
    unit: "m",
    reading: "as for the first trial; \"in the middle\" comes without a tolerance, so the distance \
              itself is not judged, the share below is",
};
const MIDDLE_PASSED: Row<'_> = Row {
    name: "sets whose last trial passes mid-door",
    published: Some(100.0),
    unit: "%",
    reading: "\"to pass in the middle of the door\" read as: the last trial of every set crosses the \
              door within its middle third, 0.22 m to either side of the middle",
};
const DETOUR_FIRST: Row<'_> = Row {
    name: "way after the door over the straight distance, first trial",
    published: None,
    unit: "",
    reading: "length of the true path from the crossing of the door to its end, over the straight \
              distance between the two; the figure prints no number",
};
const DETOUR_LAST: Row<'_> = Row {
    name: "way after the door over the straight distance, last trial",
    published: Some(1.0),
    unit: "",
    reading: "\"to head directly to the goal after it has passed the door\" read as a ratio of 1; a body \
              of 0.265 m has to round the door's jamb, so 1 itself cannot be had from everywhere",
};

/// One trial with its true path.
struct Way<'a> {
    trial: &'a Trial,
    path_m: &'a [[f64; 2]],
}

impl<'a> Way<'a> {
    fn first(set: &'a Set) -> Option<Self> {
        Some(Self { trial: set.trial(1)?, path_m: &set.first_path_m })
    }

    fn last(set: &'a Set) -> Option<Self> {
        Some(Self { trial: set.last()?, path_m: &set.last_path_m })
    }

    #[expect(
        clippy::unnecessary_wraps,
        reason = "one of several measures; others may have no value"
    )]
    fn concave_steps(&self) -> Option<f64> {
        Some(f64::from(self.trial.region_steps.get("concave").copied().unwrap_or(0)))
    }

    fn skips_the_concave_region(&self) -> bool {
        self.trial.reached_goal && self.trial.region_steps.get("concave").is_none_or(|&n| n == 0)
    }

    fn passes_mid_door(&self) -> bool {
        self.door_offset_m().is_some_and(|offset_m| offset_m <= DOOR_WIDTH_M / 6.0)
    }

    /// Distance from the middle of the door where it is crossed.
    fn door_offset_m(&self) -> Option<f64> {
        let (_, [_, y_m]) = self.crossing()?;
        Some((y_m - DOOR_M[1]).abs())
    }

    /// Way from the door to the end over the straight distance.
    fn detour(&self) -> Option<f64> {
        let (next, crossing_m) = self.crossing()?;
        let mut length_m = 0.0;
        let mut at_m = crossing_m;
        for &point_m in &self.path_m[next..] {
            length_m += distance_m(at_m, point_m);
            at_m = point_m;
        }
        Some(length_m / distance_m(crossing_m, at_m))
    }

    /// Where a trial that reached the goal passes the middle of the wall for the last time, and the
    /// index of the next point of its path.
    fn crossing(&self) -> Option<(usize, [f64; 2])> {
        if !self.trial.reached_goal {
            return None;
        }
        let crosses = |pair: &[[f64; 2]]| pair[0][0] < DOOR_M[0] && pair[1][0] >= DOOR_M[0];
        let before = self.path_m.windows(2).rposition(crosses)?;
        let [from, to] = [self.path_m[before], self.path_m[before + 1]];
        let share = (DOOR_M[0] - from[0]) / (to[0] - from[0]);
        Some((before + 1, [DOOR_M[0], from[1] + share * (to[1] - from[1])]))
    }
}

fn distance_m([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> f64 {
    ((ax - bx) * (ax - bx) + (ay - by) * (ay - by)).sqrt()
}

/// First and last trial of the first set.
fn pictures(sample: &Sample) -> Vec<Picture> {
    let Some(set) = sample.sets.first() else { return Vec::new() };
    let scenery = Scenery::new(&sample.plan);
    let ways = [("first", Way::first(set)), ("last", Way::last(set))];
    let picture = |(word, way): (&str, Option<Way<'_>>)| {
        let Way { trial, path_m } = way?;
        let caption = caption(sample.arm.name, set.seed, trial);
        Some(Picture {
            name: format!("{}-{word}", sample.arm.name),
            arm: sample.arm.name.into(),
            alt: format!("Map of the laboratory with the robot's path. {caption}"),
            view: ArenaView { path_m: path_m.to_vec(), caption, ..scenery.empty() },
        })
    };
    ways.into_iter().filter_map(picture).collect()
}

fn caption(arm: &str, seed: u64, trial: &Trial) -> String {
    let Trial { trial, steps, total_reinforcement, reached_goal, .. } = trial;
    let result = if *reached_goal { "goal reached" } else { "goal not reached" };
    format!(
        "{arm}, trial {trial}: {result}, {steps} steps, R = {total_reinforcement:.2}, seed {seed}"
    )
}

#[cfg(test)]
mod tests {
    use sonarium_core::geometry::Vec2;

    use super::*;
    use crate::catalog::{Catalog, DEFAULT_WORLD};

    fn trial(concave: u32, reached_goal: bool) -> Trial {
        let trial = crate::testing::undisturbed(1).remove(0);
        Trial { reached_goal, region_steps: [("concave".to_owned(), concave)].into(), ..trial }
    }

    #[test]
    fn the_door_is_where_the_laboratory_has_it() {
        let catalog = Catalog::load(None).expect("the embedded files are fine");
        let world = &catalog.worlds().get(DEFAULT_WORLD).expect("it is there").world;
        for direction in [1.0, -1.0] {
            let middle = Vec2::new(DOOR_M[0], DOOR_M[1]);
            let hit = world.nearest_m(middle, Vec2::new(0.0, direction), 5.0).expect("a jamb");
            assert!((hit.distance_m - DOOR_WIDTH_M / 2.0).abs() < 1e-9, "{hit:?}");
        }
    }

    #[test]
    fn the_last_crossing_counts_and_is_interpolated() {
        let trial = trial(0, true);
        // Through the door at y = 0.2, back, through it half-way between -0.5 and -0.3, then a corner:
        // 1 m east and 1 m south of the crossing, 2 m of way over √2 m.
        let path_m =
            [[3.0, 0.2], [4.0, 0.2], [3.525, -0.5], [3.725, -0.3], [4.625, -0.4], [4.625, -1.4]];
        let way = Way { trial: &trial, path_m: &path_m };
        let offset_m = way.door_offset_m().expect("it crosses");
        assert!((offset_m - 0.05).abs() < 1e-9, "{offset_m}");
        assert!(way.passes_mid_door());
        let straight =
            Way { trial: &trial, path_m: &[[3.125, -0.1], [4.125, -0.1], [4.625, -0.1]] };
        assert!((straight.detour().expect("it crosses") - 1.0).abs() < 1e-9);
        let corner = [[3.525, -0.4], [3.725, -0.4], [4.625, -0.4], [4.625, -1.4]];
        let detour = Way { trial: &trial, path_m: &corner }.detour().expect("it crosses");
        assert!((detour - 2.0_f64.sqrt()).abs() < 1e-9, "{detour}");
    }

    #[test]
    fn a_failure_passes_for_nothing() {
        let path_m = [[3.0, -0.35], [4.0, -0.35]];
        let failed = trial(0, false);
        let way = Way { trial: &failed, path_m: &path_m };
        assert!(!way.skips_the_concave_region() && !way.passes_mid_door());
        assert_eq!((way.door_offset_m(), way.detour()), (None, None));
        let (clean, folded) = (trial(0, true), trial(1, true));
        assert!(Way { trial: &clean, path_m: &path_m }.skips_the_concave_region());
        assert!(!Way { trial: &folded, path_m: &path_m }.skips_the_concave_region());
    }
}
