use super::*;
use crate::experiment::Settings;
use crate::geometry::{Pose, unit};
use crate::learner::memory::Start;
use crate::learner::{Birth, BirthCause, NeuronId, Origin};
use crate::robot::examples::b21;
use crate::robot::{Readings, Robot};

/// Steps of 0.2 m through these points, with nothing around but what `ahead_m` tells of the first.
fn path(points: &[[f64; 2]], ahead_m: f64) -> Vec<PathStep> {
    let places: Vec<Vec2> = points.iter().map(|[x, y]| Vec2::new(*x, *y)).collect();
    let steps = places.windows(2).enumerate();
    steps
        .map(|(t, way)| {
            let mut sonar_m = Readings::from_iter([8.0; 24]);
            if t == 0 {
                sonar_m[0] = ahead_m;
            }
            PathStep {
                network: 0,
                neuron: NeuronId(t as u32),
                mean_deg: 0.0,
                aim: None,
                pose: Pose::new(way[0].x, way[0].y, 0.0),
                sonar_m,
                action_rad: 0.0,
                frame_rad: 0.0,
                reinforcement: 0.0,
                safety: 0.0,
                reached: way[1],
                away: Vec2::zeros(),
            }
        })
        .collect()
}

/// A memory with one neuron a step, of these utilities.
fn memory(settings: &LearnerSettings, utilities: &[f64]) -> Memory {
    let mut memory = Memory::empty(settings, 1);
    for utility in utilities {
        let birth = Birth {
            trial: 1,
            step: 1,
            tick: 1,
            cause: BirthCause::Empty,
            origin: Origin::Reflex,
            pose: Pose::default(),
        };
        let start = Start { prototypical_rad: 0.0, mean_deg: 0.0, aim: None, utility: *utility };
        memory.add(0, [0.0; 32], start, birth);
    }
    memory
}

fn first(settings: &LearnerSettings, utilities: &[f64], path: &[PathStep]) -> Option<Proposal> {
    first_to(settings, utilities, path, Vec2::new(1.0, 0.0))
}

fn first_to(
    settings: &LearnerSettings,
    utilities: &[f64],
    path: &[PathStep],
    goal: Vec2,
) -> Option<Proposal> {
    let (robot, memory): (_, Memory) = (b21(), memory(settings, utilities));
    let robot: &Robot = &robot;
    let surveyor = Surveyor::new(settings, robot, goal, &memory, path);
    surveyor.survey().into_iter().find(|(t, _)| *t == 0).map(|(_, proposal)| proposal)
}

/// A detour: the second step ends beside the straight way to the goal, the third is on it again.
const DETOUR: [[f64; 2]; 4] = [[0.0, 0.0], [0.15, 0.15], [0.4, 0.2], [0.8, 0.0]];

#[test]
fn the_goal_in_view_is_the_best_point() {
    let settings = LearnerSettings::from(&Settings::default());
    let found = first(&settings, &[-3.0, -2.0, -1.0], &path(&DETOUR, 8.0)).expect("a proposal");
    assert_eq!((found.aim.x_m, found.aim.y_m, found.aim.then), (1.0, 0.0, None));
    // Driving straight to the goal costs nothing, and nothing is left to expect there.
    assert_eq!((found.straight, found.utility, found.after_deg), (0.0, 0.0, 0.0));
}

#[test]
fn with_the_way_blocked_the_critic_chooses_among_the_points_in_view() {
    let settings = LearnerSettings::from(&Settings::default());
    // A wall 0.5 m ahead of the shell hides the last point and the goal.
    let path = path(&DETOUR, 0.5);
    let found = first(&settings, &[-3.0, -2.0, -0.2], &path).expect("a proposal");
    assert_eq!((found.step, found.utility), (2, -0.2));
    assert_eq!(found.aim.then, Some((0, NeuronId(2))));
    // Eq. (5.7): the mean bearing error on the way is below a right angle, so it costs below 1/2 a step.
    assert!((-1.2..0.0).contains(&found.straight), "{}", found.straight);
    // A critic that expects little of the farther point prefers the nearer one.
    let found = first(&settings, &[-3.0, -2.0, -9.0], &path).expect("a proposal");
    assert_eq!((found.step, found.utility), (1, -2.0));
    // Without a critic the farthest in view is chosen all the same.
    let blind = LearnerSettings { shortcut_judge: Judge::Farthest, ..settings };
    assert_eq!(first(&blind, &[-3.0, -2.0, -9.0], &path).map(|found| found.step), Some(2));
}

#[test]
fn only_a_sharp_shortcut_turns_by_more_than_the_temperature() {
    let mut settings = LearnerSettings::from(&Settings::default());
    // Both points in view lie more than 20° to the left of p = 0.
    settings.temperature_max_deg = 20.0;
    settings.shortcut_sharp = false;
    let found = first(&settings, &[-3.0, -2.0, -0.2], &path(&DETOUR, 0.5)).expect("a bend");
    assert!(found.aim.beyond.is_some() && found.after_deg.abs() <= 20.0, "{found:?}");
    settings.shortcut_bend = false;
    assert_eq!(first(&settings, &[-3.0, -2.0, -0.2], &path(&DETOUR, 0.5)), None);
    settings.shortcut_sharp = true;
    let found = first(&settings, &[-3.0, -2.0, -0.2], &path(&DETOUR, 0.5)).expect("a sharp turn");
    assert!(found.after_deg.abs() > 20.0, "{found:?}");
    // Nothing is followed at temperature 0, so nothing is proposed for it.
    settings.exploit_from = 2;
    assert_eq!(first(&settings, &[-3.0, -2.0, -0.2], &path(&DETOUR, 0.5)), None);
}

#[test]
fn a_point_that_cost_clearance_is_moved_off_the_wall() {
    let settings = LearnerSettings::from(&Settings::default());
    let mut path = path(&DETOUR, 0.5);
    path[1].safety = -0.5;
    path[1].away = Vec2::new(0.0, 1.0);
    // d_c min(-f₁, 1) = 0.2 · 0.5 = 0.1 m.
    let found = first(&settings, &[-3.0, -9.0, -0.2], &path).expect("a proposal");
    assert!((found.aim.x_m - 0.4).abs() < 1e-12 && (found.aim.y_m - 0.3).abs() < 1e-12);
    let still = LearnerSettings { shortcut_push: false, ..settings };
    let found = first(&still, &[-3.0, -9.0, -0.2], &path).expect("a proposal");
    assert!((found.aim.y_m - 0.2).abs() < 1e-12);
}

#[test]
fn what_was_heard_close_by_elsewhere_stands_in_the_way() {
    let settings = LearnerSettings::from(&Settings::default());
    // Silent from home, an obstacle beside the straight way is heard 0.15 m south of where the second step
    // begins: its echo touches the body on that way.
    let mut passed = path(&DETOUR, 8.0);
    passed[1].sonar_m[18] = 0.15;
    let found = first(&settings, &[-3.0, -2.0, -1.0], &passed).expect("a proposal");
    assert_ne!((found.aim.x_m, found.aim.y_m), (1.0, 0.0));
    // Nobody remembers it, or it is too far for its place to be known.
    for near_echo_m in [0.0, 0.1] {
        let settings = LearnerSettings { near_echo_m, ..settings.clone() };
        let found = first(&settings, &[-3.0, -2.0, -1.0], &passed).expect("a proposal");
        assert_eq!((found.aim.x_m, found.aim.y_m), (1.0, 0.0), "{near_echo_m}");
    }
}

/// Up, and then past a wall to the right; the goal lies beyond the end.
const ROUND: [[f64; 2]; 4] = [[0.0, 0.0], [0.2, 1.0], [2.0, 1.0], [3.0, 0.6]];

/// The round path, with an echo 1.265 m from the centre that hides its third point from the first.
fn round() -> Vec<PathStep> {
    let mut path = path(&ROUND, 0.5);
    path[0].sonar_m[2] = 1.0;
    path
}

#[test]
fn a_way_bends_where_both_ends_see_the_bend() {
    let settings = LearnerSettings::from(&Settings::default());
    let (utilities, goal) = ([-9.0, -8.0, -0.1], Vec2::new(4.0, 0.0));
    let found = first_to(&settings, &utilities, &round(), goal).expect("a proposal");
    let straight = LearnerSettings { shortcut_bend: false, ..settings.clone() };
    let known = first_to(&straight, &utilities, &round(), goal).expect("a proposal");
    assert_eq!(known.aim.beyond, None);
    assert!(found.straight + found.utility > known.straight + known.utility + 0.1);
    let end = found.aim.after_bend().expect("it bends");
    assert_eq!((end.point(), found.utility), (Vec2::new(2.0, 1.0), -0.1));
    // Neither leg comes nearer to the echoes than the body's radius and the clearance asked for.
    for (reading_m, bearing_deg) in [(0.5, 0.0_f64), (1.0, 30.0)] {
        let echo = unit(bearing_deg.to_radians()) * (0.265 + reading_m);
        for (from, to) in [(Vec2::zeros(), found.aim.point()), (found.aim.point(), end.point())] {
            let near_m = (0..=100)
                .map(|k| (from + (to - from) * (f64::from(k) / 100.0) - echo).norm())
                .fold(f64::INFINITY, f64::min);
            assert!(near_m >= 0.265 + 0.1 - 0.01, "{near_m} m from {from} to {to}");
        }
    }
    // Blind at its end, nobody saw the second leg.
    let mut blind = round();
    blind[2].sonar_m = Readings::from_iter([0.1; 24]);
    let found = first_to(&settings, &utilities, &blind, goal).expect("a proposal");
    assert_eq!(found.aim.beyond, None);
}
