use std::ops::RangeInclusive;
use std::sync::{Arc, LazyLock};

use super::*;
use crate::experiment::MinimumCostPath;
use crate::geometry::{Vec2, wrap_angle};
use crate::learner::{LearnerSettings, reinforcement};
use crate::robot::SimulatedRobot;
use crate::robot::examples::{b21, trc};
use crate::world::WorldFile;
use crate::world::examples::{all_files, laboratory_file, room_file, world};

fn planned(file: &WorldFile, settings: &Settings) -> BestPath {
    best_path(&world(file), &b21(), settings).expect("there is a way")
}

/// Some worlds with the best path in each, planned once for all tests.
static PLANNED: LazyLock<Vec<(WorldFile, BestPath)>> = LazyLock::new(|| {
    let files = all_files().into_iter().take(5);
    files.map(|file| (file.clone(), planned(&file, &exact()))).collect()
});

/// Settings under which the simulator errs as little as the planner.
fn exact() -> Settings {
    Settings { sonar_noise: 0.0, ..Settings::default() }
}

/// What the simulator itself pays for driving along headings, and whether it arrives.
fn driven(
    file: &WorldFile,
    settings: &Settings,
    headings: impl Iterator<Item = f64>,
) -> (f64, bool) {
    let world = Arc::new(world(file));
    let reward = LearnerSettings::from(settings).reward;
    let mut robot = SimulatedRobot::new(Arc::clone(&world), b21(), settings.simulation(), 1);
    let mut total = 0.0;
    for heading_rad in headings {
        let motion = robot.act(wrap_angle(heading_rad - robot.true_pose().heading_rad));
        let bearing_rad = robot.true_pose().bearing_to(world.goal().centre);
        total +=
            reinforcement(&reward, &robot.sense().sonar_m, motion.contact, bearing_rad).total();
    }
    (total, robot.at_goal())
}

/// A room with a wall across it, up to `y`, between home and the goal.
fn barred(y: f64) -> WorldFile {
    let mut file = room_file(6.0, 4.0);
    file.blocks = vec![vec![[-0.05, -2.0], [0.05, -2.0], [0.05, y], [-0.05, y]]];
    (file.home.x, file.home.y) = (-0.7, -0.2);
    (file.goal.x, file.goal.y, file.goal.radius_m) = (0.9, -0.2, 0.4);
    file
}

#[test]
fn an_open_way_costs_nothing_and_takes_the_fewest_steps() {
    // Steps of 0.2 m until nearer than the radius, and none of them beyond the centre.
    for (x, y, radius_m, steps) in [(1.55, 0.0, 0.2, 7), (0.25, 0.0, 0.1, 1), (-1.2, 1.2, 0.35, 7)]
    {
        let mut file = room_file(6.0, 5.0);
        (file.goal.x, file.goal.y, file.goal.radius_m) = (x, y, radius_m);
        let path = planned(&file, &exact());
        assert!(path.total_reinforcement() > -1e-9, "({x}, {y}): {path:?}");
        assert_eq!(path.steps(), steps, "({x}, {y})");
        assert_eq!((path.collisions, path.poses.len()), (0, steps + 1));
    }
}

#[test]
fn of_all_pairs_of_headings_none_is_cheaper() {
    let settings = Settings { advance_m: 1.0, ..exact() };
    let file = barred(-0.1);
    let path = planned(&file, &settings);
    let headings =
        |range: RangeInclusive<i32>| range.map(|half| (0.5 * f64::from(half)).to_radians());
    let pairs =
        headings(0..=180).flat_map(|first| headings(-180..=0).map(move |second| [first, second]));
    let driven = pairs.map(|pair| driven(&file, &settings, pair.into_iter()));
    let best = driven.filter(|(_, arrived)| *arrived).map(|(total, _)| total);
    let best = best.fold(f64::NEG_INFINITY, f64::max);
    // A pair is at most 0.25° off in each heading, and 1.5° in a bearing from 0.2 m before the centre:
    // 2/180 in Eq. (5.7).
    let gain = path.total_reinforcement() - best;
    assert!((-1e-9..0.012).contains(&gain), "planned {path:?}, all pairs {best}");
}

#[test]
fn the_simulator_pays_for_the_planned_path_what_the_planner_says() {
    for (file, path) in PLANNED.iter() {
        let headings = path.poses[1..].iter().map(|pose| pose.heading_rad);
        let (total, arrived) = driven(file, &exact(), headings);
        assert!(arrived, "{}", file.name);
        assert!((total - path.total_reinforcement()).abs() < 1e-9, "{}: {total}", file.name);
        assert_eq!(path.collisions, 0, "{}", file.name);
    }
}

#[test]
fn no_trial_is_better_than_the_planned_path() {
    for (file, path) in PLANNED.iter() {
        for seed in 1..=4 {
            let run = MinimumCostPath::new(Arc::new(world(file)), b21(), &exact(), seed);
            let mut run = run.expect("the defaults fit");
            while run.trials_done() < 12 {
                let Some(end) = run.step().1 else { continue };
                let record = &end.record;
                let regret = path.total_reinforcement() - record.total_reinforcement;
                assert!(!record.reached_goal || regret >= 0.0, "{}: {record:?}", file.name);
            }
        }
    }
}

#[test]
fn the_refinement_gains_little() {
    for (file, path) in PLANNED.iter() {
        let share = path.resolution / -path.total_reinforcement();
        assert!((0.0..0.02).contains(&share), "{}: {share}", file.name);
    }
}

#[test]
fn dear_walls_are_kept_away_from() {
    let file = barred(0.3);
    let near = planned(&file, &Settings { close_m: 0.12, ..exact() });
    let far = planned(&file, &Settings { close_m: 0.5, ..exact() });
    let corner = Vec2::new(0.0, 0.3);
    let least_m = |path: &BestPath| {
        path.poses.iter().map(|pose| pose.distance_to(corner)).fold(f64::INFINITY, f64::min)
    };
    assert!(least_m(&far) > least_m(&near) + 0.05, "{} {}", least_m(&far), least_m(&near));
    assert!(far.total_reinforcement() < near.total_reinforcement());
}

#[test]
fn a_passage_too_narrow_even_to_back_off_in_is_no_way() {
    let mut file = room_file(6.0, 4.0);
    // 0.54 m wide: the robot of 0.53 m fits, but a rescue keeps 0.01 m from what it could touch.
    file.blocks = vec![
        vec![[0.4, -2.0], [0.6, -2.0], [0.6, -0.27], [0.4, -0.27]],
        vec![[0.4, 0.27], [0.6, 0.27], [0.6, 2.0], [0.4, 2.0]],
    ];
    (file.goal.x, file.goal.radius_m) = (1.5, 0.3);
    assert_eq!(best_path(&world(&file), &b21(), &exact()), None);
}

#[test]
fn noise_and_drift_change_nothing() {
    let noisy = Settings {
        sonar_noise: 0.03,
        sonar_dropout: 0.1,
        odometry_drift: 0.02,
        ..Settings::default()
    };
    assert_eq!(planned(&laboratory_file(), &noisy), planned(&laboratory_file(), &exact()));
}

#[test]
fn a_body_that_is_not_round_is_left_alone() {
    assert_eq!(best_path(&world(&laboratory_file()), &trc(), &exact()), None);
}
