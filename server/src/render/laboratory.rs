//! A made-up but realistic view of the laboratory, for measurements and tests of pictures.

use super::view::{ArenaView, ConeView, NeuronMark, PathOf, RegionView, RobotPose, RobotView};
use std::f64::consts::{PI, TAU};

/// The laboratory in the middle of a trial: `ghosts` earlier trials, `neurons` neurons, a robot
/// with all its sonar cones. The same numbers give the same view.
pub(super) fn laboratory(ghosts: usize, neurons: usize) -> ArenaView {
    let path_m: Vec<[f64; 2]> = trial(3.0, 0.10).into_iter().take(26).collect();
    let robot = path_m.last().copied().unwrap_or_default();
    ArenaView {
        bounds_m: [-1.5, -3.5, 5.55, 2.5],
        walls_m: walls(),
        blocks_m: vec![rectangle([3.5, 0.3, 3.75, 2.5]), rectangle([3.5, -2.5, 3.75, -1.0])],
        regions: regions(),
        home: RobotPose { at_m: [0.0, 0.0], heading_rad: 0.0 },
        goal_m: [4.0, -2.0],
        goal_radius_m: 0.5,
        earlier_paths_m: (0..ghosts).map(|n| trial(n as f64, 0.16)).collect(),
        best_path_m: trial(0.4, 0.02),
        planned_path_m: trial(0.0, 0.0),
        collisions_m: vec![[3.32, -0.66], [4.6, -0.9]],
        neurons: won((0..neurons).map(neuron).collect(), robot),
        robot: Some(robot_at(robot)),
        path_m,
        path_of: PathOf::Trial,
        caption: "Trial 21, step 25 · total reinforcement −23.5".to_owned(),
    }
}

fn rectangle([x0, y0, x1, y1]: [f64; 4]) -> Vec<[f64; 2]> {
    vec![[x0, y0], [x1, y0], [x1, y1], [x0, y1]]
}

fn walls() -> Vec<[f64; 4]> {
    vec![
        [-1.5, -2.5, -1.5, 2.5],
        [-1.5, 2.5, 5.55, 2.5],
        [-1.5, -2.5, 3.5, -2.5],
        [3.75, -2.5, 3.75, -3.5],
        [3.75, -3.5, 5.55, -3.5],
        [5.55, -3.5, 5.55, 2.5],
    ]
}

fn regions() -> Vec<RegionView> {
    [
        ("corridor", [3.75, -3.5, 5.55, 2.5]),
        ("concave", [-1.5, -2.5, 3.5, -1.0]),
        ("room", [-1.5, -1.0, 3.5, 2.5]),
        ("door", [3.5, -1.0, 3.75, 0.3]),
    ]
    .map(|(name, part)| RegionView { name: name.into(), polygons_m: vec![rectangle(part)] })
    .into()
}

/// A wobbling way from home through the door to the goal.
fn trial(number: f64, wobble_m: f64) -> Vec<[f64; 2]> {
    let way = [[0.0, 0.0], [1.8, 0.25], [3.1, -0.25], [4.1, -0.55], [4.5, -1.2], [4.1, -1.75]];
    let at = |t: f64| {
        let leg = (t.floor() as usize).min(way.len() - 2);
        let (a, b, share) = (way[leg], way[leg + 1], t - leg as f64);
        [a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share]
    };
    let steps = 34;
    let legs = (way.len() - 1) as f64;
    (0..=steps)
        .map(|step| {
            let t = f64::from(step) / f64::from(steps) * legs;
            let [x, y] = at(t);
            let swing = wobble_m * (t * PI / legs).sin();
            let (phase, slow) = (1.7 * number, 0.9 + 0.13 * (number % 5.0));
            [
                x + swing * (t * 2.3 * slow + phase).sin(),
                y + 2.2 * swing * (t * slow + 2.0 * phase).cos(),
            ]
        })
        .collect()
}

/// The neuron nearest to the robot wins.
fn won(mut neurons: Vec<NeuronMark>, [x, y]: [f64; 2]) -> Vec<NeuronMark> {
    let apart = |n: &NeuronMark| (n.at_m[0] - x).hypot(n.at_m[1] - y);
    let decided = neurons.iter_mut().filter(|neuron| neuron.utility.is_some());
    if let Some(nearest) = decided.min_by(|a, b| apart(a).total_cmp(&apart(b))) {
        nearest.winner = true;
    }
    neurons
}

fn neuron(number: usize) -> NeuronMark {
    // Places spread evenly over the way by the golden ratio, and around it by its square root.
    let spread = |share: f64| (number as f64 * share).fract();
    let way = trial(number as f64 * 0.37, 0.1);
    let place = (spread(0.618) * (way.len() - 1) as f64) as usize;
    let beside = |share: f64| 1.3 * (spread(share) - 0.5) * (1.0 - place as f64 / 60.0);
    let [x, y] = way[place];
    let at_m = [(x + beside(0.786)).clamp(-1.3, 5.3), y + beside(0.414)];
    let next = way[(place + 3).min(way.len() - 1)];
    NeuronMark {
        at_m,
        heading_rad: (next[1] - at_m[1]).atan2(next[0] - at_m[0]),
        region: usize::from(at_m[0] < 3.5),
        utility: (number % 9 != 4)
            .then(|| (place as f64 / 34.0 + 0.1 * (number as f64).cos()).clamp(0.0, 1.0)),
        winner: false,
    }
}

fn cone(index: usize) -> ConeView {
    let axis_rad = TAU * index as f64 / 24.0;
    ConeView { at_m: [0.265 * axis_rad.cos(), 0.265 * axis_rad.sin()], axis_rad }
}

fn robot_at(at_m: [f64; 2]) -> RobotView {
    let reading = |i: usize| {
        let heading = -0.9 + TAU * i as f64 / 24.0;
        let across = if heading.cos() > 0.0 { 5.55 - at_m[0] } else { at_m[0] - 3.75 };
        let along = if heading.sin() > 0.0 { 2.5 - at_m[1] } else { at_m[1] + 3.5 };
        let wall = (across / heading.cos().abs()).min(along / heading.sin().abs());
        (wall - 0.265 + 0.03 * (i as f64).sin()).clamp(0.05, 4.0)
    };
    RobotView {
        pose: RobotPose { at_m, heading_rad: -0.9 },
        believed: RobotPose { at_m: [at_m[0] + 0.12, at_m[1] + 0.07], heading_rad: -0.75 },
        radius_m: 0.265,
        corners_m: Vec::new(),
        cone_rad: 15_f64.to_radians(),
        range_m: 4.0,
        cones: (0..24).map(cone).collect(),
        sonar_m: (0..24).map(reading).collect(),
        collided: false,
    }
}
