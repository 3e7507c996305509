//! Figure 5.8: trajectories of the simulated TRC, and what its trained network does from elsewhere.

use std::sync::Arc;

use sonarium_core::geometry::Vec2;
use sonarium_core::stats::{self, Estimate};

use super::figure_5_9::{TRC_SEEDS, TRIALS, first_reached};
use super::{
    Arm, Findings, PRESETS, PUBLISHED, Picture, ReproductionError, Row, Sample, Set, Sets, Target,
    Unit,
};
use crate::catalog::{MINIMUM_COST_PATH_TRC, Plan};
use crate::render::ArenaView;
use crate::session::{Run, Scenery, starts_arena};
use crate::wire::{AlteredStartView, StartView, Trial};

/// Figure 5.8.
pub static FIGURE_5_8: Target = Target {
    name: "figure-5.8",
    title: "Trajectories of the simulated robot, and altered starts",
    compares: "The first, the ninth and the final trial of the simulated TRC, and what its trained \
               network does from other starts: one run and four starts in the thesis, 50 sets of 50 \
               trials a preset here, each tried from twelve starts; reflex, which never learns, has no \
               network to be tried",
    source: "Figure 5.8, section 5.11",
    readings: &[
        "The pictures show the set of the first seed, whatever it looks like",
        "A start lies inside the explored region when a neuron is active there; the starts were laid \
         over the free floor before anything was run from them, facing the goal",
        "From an altered start the network neither explores, grows nor adapts; where no neuron is \
         active, the nearest acts, and a collision ends the way",
        "The world is our own, since the figure is lost",
    ],
    rules: &[PUBLISHED],
    experiment: MINIMUM_COST_PATH_TRC,
    arms: PRESETS,
    unit: Unit::Set,
    trials: TRIALS,
    seeds: TRC_SEEDS,
    find,
};

/// Altered starts, metres: four around home, then others over the free floor.
const STARTS_M: [[f64; 2]; 12] = [
    [0.8, 0.8],
    [1.6, 0.8],
    [0.8, 1.6],
    [1.5, 1.5],
    [4.6, 1.0],
    [4.6, 3.4],
    [1.0, 4.2],
    [3.2, 4.2],
    [3.2, 7.0],
    [6.2, 3.8],
    [8.6, 3.8],
    [8.6, 1.0],
];

fn find(target: &Target, sets: &Sets<'_>) -> Result<Findings, ReproductionError> {
    let mut findings = Findings::default();
    for arm in target.arms {
        let sample = sample(target, sets, arm)?;
        let rows = rows(&sample);
        findings.rows.extend(rows.iter().filter_map(|(row, ours)| row.of(&sample, *ours)));
        findings.pictures.extend(pictures(&sample)?);
    }
    Ok(findings)
}

/// The sets of an arm, each tried from the starts; both figures of the simulated robot look at them.
pub(super) fn sample(
    target: &Target,
    sets: &Sets<'_>,
    arm: &Arm,
) -> Result<Arc<Sample>, ReproductionError> {
    let plan = sets.plan(target, arm)?;
    sets.shared_from(target, arm, &starts(&plan))
}

/// The starts, facing the goal; none for what has no network.
fn starts(plan: &Plan) -> Vec<StartView> {
    if plan.values.get("learner.learning") == Some(&false.into()) {
        return Vec::new();
    }
    let goal = plan.world.world.goal().centre;
    let facing = |[x_m, y_m]: [f64; 2]| {
        let way = goal - Vec2::new(x_m, y_m);
        let name = format!("({x_m}, {y_m})");
        StartView { name, x_m, y_m, heading_deg: way.y.atan2(way.x).to_degrees().round() }
    };
    STARTS_M.map(facing).to_vec()
}

fn rows(sample: &Sample) -> Vec<(Row<'static>, Option<Estimate>)> {
    vec![
        (SHORTER, sample.mean(last_over_first)),
        (INSIDE, sample.mean(|set| reached_pct(&set.starts, true))),
        (OUTSIDE, sample.mean(|set| reached_pct(&set.starts, false))),
        (DETERIORATES, deteriorates(sample)),
    ]
}

/// Way of the last trial over that of the first that reached the goal.
fn last_over_first(set: &Set) -> Option<f64> {
    let (first, last) = (first_reached(set)?, set.last().filter(|trial| trial.reached_goal)?);
    Some(last.path_m / first.path_m)
}

/// Share of the starts inside or outside the explored region from which the network reaches the goal.
fn reached_pct(starts: &[AlteredStartView], inside: bool) -> Option<f64> {
    let there = starts.iter().filter(|start| start.inside == inside);
    let reached: Vec<f64> =
        there.map(|start| if start.alone.reached_goal { 100.0 } else { 0.0 }).collect();
    stats::mean(&reached)
}

/// Share of sets that reach the goal from fewer starts outside than inside, of those with both.
fn deteriorates(sample: &Sample) -> Option<Estimate> {
    let shares =
        |set: &Set| Some((reached_pct(&set.starts, true)?, reached_pct(&set.starts, false)?));
    let pairs: Vec<(f64, f64)> = sample.sets.iter().filter_map(shares).collect();
    let worse = pairs.iter().filter(|(inside, outside)| outside < inside).count();
    Some(Estimate::proportion(worse, pairs.len())?.scaled(100.0))
}

const SHORTER: Row<'_> = Row {
    name: "way of the last trial over the first at the goal",
    published: Some(0.9),
    unit: "",
    reading: "\"10% shorter than figure 5.8, top-right\", the ninth trial, the first at the goal; mean \
              over the sets whose last trial reaches it",
};
const INSIDE: Row<'_> = Row {
    name: "starts inside the explored region that lead to the goal",
    published: Some(100.0),
    unit: "%",
    reading: "\"the robot was still able to produce feasible paths [...] provided that the new starting \
              locations were within the region that the robot had already explored\" read as: from every \
              start where a neuron is active; mean over sets",
};
const OUTSIDE: Row<'_> = Row {
    name: "starts outside the explored region that lead to the goal",
    published: None,
    unit: "%",
    reading: "\"the controller generalization ability drastically deteriorated\" gives no number; mean \
              over sets",
};
const DETERIORATES: Row<'_> = Row {
    name: "sets that do worse outside than inside",
    published: Some(100.0),
    unit: "%",
    reading: "\"when an initial robot location outside the explored region was chosen, the controller \
              generalization ability drastically deteriorated\" read as: a smaller share of the starts \
              outside leads to the goal than of those inside, in every set that has both",
};

/// The first trial, the ninth, the last, and the ways from the altered starts, of the first set.
fn pictures(sample: &Sample) -> Result<Vec<Picture>, ReproductionError> {
    let mut run = Run::new(&sample.plan)?;
    let scenery = Scenery::new(&sample.plan);
    let mut pictures = Vec::new();
    for number in 1..=sample.plan.trials {
        let mut path_m = Vec::new();
        let end = std::iter::repeat_with(|| run.step_along(&mut path_m)).flatten().next();
        let word = match number {
            1 => "first",
            9 => "ninth",
            TRIALS => "last",
            _ => continue,
        };
        let Some(trial) = end else { continue };
        let caption = caption(sample, &trial);
        pictures.push(picture(sample, word, ArenaView { path_m, caption, ..scenery.empty() }));
    }
    let found = run.altered_starts(&sample.plan.starts);
    if !found.is_empty() {
        pictures.push(picture(sample, "starts", starts_arena(&scenery, &found)));
    }
    Ok(pictures)
}

fn picture(sample: &Sample, word: &str, view: ArenaView) -> Picture {
    Picture {
        name: format!("{}-{word}", sample.arm.name),
        arm: sample.arm.name.into(),
        alt: format!("Map of the world with the robot's way. {}", view.caption),
        view,
    }
}

fn caption(sample: &Sample, trial: &Trial) -> String {
    let result = if trial.reached_goal { "goal reached" } else { "goal not reached" };
    format!(
        "{}, trial {}: {result}, {} moves, R = {:.2}, seed {}",
        sample.arm.name, trial.trial, trial.steps, trial.total_reinforcement, sample.seeds[0]
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::Catalog;
    use crate::reproduce::Kept;
    use crate::session::check_starts;
    use crate::wire::ExcursionView;

    #[test]
    fn the_robot_can_stand_at_every_start() {
        let catalog = Catalog::load(None).expect("the embedded files are fine");
        let sets = Sets { catalog: &catalog, threads: 1, kept: &Kept::default(), done: &|| () };
        let plan = sets.plan(&FIGURE_5_8, &PRESETS[0]).expect("it fits");
        assert_eq!(check_starts(&plan, &starts(&plan)), Ok(()));
    }

    #[test]
    fn starts_inside_and_outside_are_counted_apart() {
        let start = |inside, reached_goal| {
            let way = ExcursionView {
                reached_goal,
                steps: 1,
                total_reinforcement: 0.0,
                collisions: 0,
                silent_pct: 0.0,
                path_m: Vec::new(),
            };
            let start = StartView { name: String::new(), x_m: 0.0, y_m: 0.0, heading_deg: 0.0 };
            AlteredStartView { start, inside, explored_m: None, alone: way.clone(), guided: way }
        };
        let starts =
            [start(true, true), start(true, false), start(false, false), start(false, false)];
        assert_eq!(reached_pct(&starts, true), Some(50.0));
        assert_eq!(reached_pct(&starts, false), Some(0.0));
        assert_eq!(reached_pct(&starts[..2], false), None);
    }
}
