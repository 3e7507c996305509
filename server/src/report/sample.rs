//! A session as the tests of the reports need one: 20 trials that learn, the second of which fails.

use std::collections::BTreeMap;

use serde_json::Value;

use super::{Picture, SessionReport, TrialReport};
use crate::wire::*;

/// Steps, safety part, goal part, neurons, added, deleted, collisions of each trial.
const TRIALS: [(u32, f64, f64, u32, u32, u32, u32); 20] = [
    (39, -21.31, -8.79, 39, 39, 0, 6),
    (200, -112.4, -61.02, 39, 41, 41, 38),
    (32, -6.2, -7.51, 64, 25, 0, 3),
    (29, -1.05, -8.1, 88, 24, 0, 1),
    (29, -3.4, -6.6, 88, 22, 22, 1),
    (30, -8.2, -7.3, 88, 21, 21, 2),
    (29, -4.1, -4.77, 107, 19, 0, 2),
    (29, -9.0, -7.1, 107, 19, 19, 3),
    (29, -7.7, -7.2, 107, 18, 18, 2),
    (28, -2.2, -5.62, 119, 12, 0, 1),
    (29, -5.3, -7.2, 119, 17, 17, 2),
    (29, -8.8, -7.2, 119, 17, 17, 3),
    (30, -9.1, -7.4, 119, 16, 16, 3),
    (29, -5.4, -7.2, 119, 18, 18, 2),
    (29, -5.9, -7.2, 119, 17, 17, 2),
    (27, -0.31, -6.12, 128, 9, 0, 0),
    (27, -0.29, -6.13, 128, 0, 0, 0),
    (27, -0.3, -6.11, 128, 0, 0, 0),
    (27, -0.33, -6.15, 128, 0, 0, 0),
    (27, -0.28, -6.12, 128, 0, 0, 0),
];

/// A finished session with one setting of each standing; the goal's radius is not the default.
pub(super) fn session_report() -> SessionReport {
    let trials = trials();
    SessionReport {
        title: "Minimum-cost path".into(),
        session: session(),
        summary: summary(&trials),
        trials,
        settings: settings(),
        preset: PresetInfo {
            name: "learner".into(),
            title: "The learner".into(),
            summary: "The smallest set of additions under which the robot really learns.".into(),
            settings: BTreeMap::new(),
        },
        world: world(),
        events: events(),
        pictures: vec![picture(1), picture(20)],
        build: "0.1.0 (a47fe4c)".into(),
    }
}

/// Trial 4 with all its ticks.
pub(super) fn trial_report() -> TrialReport {
    let trial = trials().swap_remove(3);
    let change = |neuron, before, after| ChangeView { neuron, before, after };
    TrialReport {
        title: "Minimum-cost path".into(),
        session: session(),
        ticks: (1..=trial.steps).map(|step| tick(&trial, step)).collect(),
        end: TrialEndView {
            trial,
            backed_up: (60..88).map(|n| change(n, -0.31, -0.21 * f64::from(88 - n))).collect(),
            replaced: (60..88).map(|n| change(n, 12.5, 9.75 + f64::from(n % 7))).collect(),
            proposed: (64..88).map(|n| change(n, 0.0, -4.5 + f64::from(n % 5))).collect(),
            forgotten: Vec::new(),
            neurons: vec![neuron(1), neuron(2)],
        },
        picture: Some(picture(4)),
    }
}

fn trials() -> Vec<Trial> {
    let mut tick = 0;
    let mut best = f64::NEG_INFINITY;
    let mut trials = Vec::new();
    for (number, row) in (1..).zip(TRIALS) {
        let (steps, safety, goal, neurons, born, forgotten, collisions) = row;
        let first_tick = tick + 1;
        tick += u64::from(steps);
        let (total, reached_goal) = (safety + goal, steps < 200);
        let record = reached_goal && total > best;
        best = if record { total } else { best };
        trials.push(Trial {
            trial: number,
            steps,
            total_reinforcement: total,
            safety,
            goal,
            neurons,
            born,
            forgotten,
            collisions,
            reached_goal,
            record,
            temperature_deg: if number < 16 {
                10.0 + 90.0 * 0.8f64.powi(number as i32 - 1)
            } else {
                0.0
            },
            path_m: 0.2 * f64::from(steps) - 0.07,
            region_steps: [("room".into(), steps - 8), ("corridor".into(), 8)].into(),
            first_tick,
            last_tick: tick,
        });
    }
    trials
}

fn summary(trials: &[Trial]) -> Summary {
    let best = trials.iter().rfind(|trial| trial.record);
    let last = trials.last();
    Summary {
        trials: trials.len() as u32,
        reached: trials.iter().filter(|trial| trial.reached_goal).count() as u32,
        best_total_reinforcement: best.map(|trial| trial.total_reinforcement),
        best_trial: best.map(|trial| trial.trial),
        last_steps: last.map(|trial| trial.steps),
        last_total_reinforcement: last.map(|trial| trial.total_reinforcement),
        neurons: last.map_or(0, |trial| trial.neurons),
        collisions: trials.iter().map(|trial| trial.collisions).sum(),
        steps: trials.iter().map(|trial| u64::from(trial.steps)).sum(),
    }
}

fn session() -> Session {
    let mut values: BTreeMap<String, Value> =
        settings().into_iter().map(|info| (info.key, info.default)).collect();
    values.insert("goal.radius".into(), Value::from(0.4));
    Session {
        id: "k7f2q9".into(),
        experiment: "minimum-cost-path".into(),
        state: State::Finished,
        reason: None,
        seed: 7,
        preset: "learner".into(),
        world: "laboratory".into(),
        settings: values,
        changed: vec!["goal.radius".into()],
        trials: 20,
        trials_done: 20,
        reached: 19,
        best: Some(-6.4),
        tick: 756,
        speed: Speed::TicksPerSecond(30.0),
        build: "0.1.0 (a47fe4c)".into(),
        created_at: "2026-11-22T09:31:52.118Z".into(),
        changed_at: "2026-11-22T09:32:21.004Z".into(),
        controls: vec!["reset".into()],
    }
}

fn settings() -> Vec<SettingInfo> {
    let choices = [
        ("heading", "Heading in the odometry frame"),
        ("rotation", "Rotation from the present heading"),
        ("goal", "Angle from the bearing of the goal"),
    ];
    let frames =
        choices.map(|(value, meaning)| Choice { value: value.into(), meaning: meaning.into() });
    let mut frame =
        setting("action.frame", "Frame of p and α", "heading".into(), "", "R1", "reading");
    frame.choices = frames.to_vec();
    vec![
        setting("preset", "Set of settings to start from", "learner".into(), "", "", "simulation"),
        setting("world", "World the robot moves in", "laboratory".into(), "", "", "simulation"),
        setting("td.discount", "Discount γ of Eq. (5.19)", 0.7.into(), "", "Eq. (5.19)", "literal"),
        frame,
        setting("reflex.turn", "Rotation at full activation", 90.0.into(), "deg", "R4", "gap"),
        setting(
            "exploration.scale",
            "Factor on σ in the draw of ξ; the thesis has 1",
            0.05.into(),
            "",
            "Eq. (5.12), D1",
            "deviation",
        ),
        setting(
            "band.proposal",
            "Set μ from the record trajectory at the end of a record trial; replaces Eq. (5.21)-(5.24)",
            true.into(),
            "",
            "A1",
            "addition",
        ),
        setting(
            "goal.radius",
            "Distance at which the goal is reached",
            0.5.into(),
            "m",
            "Section 5.2",
            "literal",
        ),
        setting(
            "sonar.noise",
            "Relative standard deviation of a reading",
            0.01.into(),
            "",
            "",
            "simulation",
        ),
        setting("odometry.drift", "Relative error of odometry", 0.0.into(), "", "", "simulation"),
    ]
}

fn setting(
    key: &str,
    meaning: &str,
    default: Value,
    unit: &str,
    source: &str,
    standing: &str,
) -> SettingInfo {
    SettingInfo {
        key: key.into(),
        meaning: meaning.into(),
        kind: "number".into(),
        unit: unit.into(),
        default,
        min: Some(0.0),
        max: None,
        choices: Vec::new(),
        source: source.into(),
        standing: standing.into(),
    }
}

fn world() -> WorldView {
    WorldView {
        name: "laboratory".into(),
        title: "Laboratory and corridor".into(),
        bounds_m: [-1.5, -3.5, 5.55, 2.5],
        walls_m: vec![[-1.5, -2.5, 3.5, -2.5]],
        regions: vec!["corridor".into(), "concave".into(), "room".into(), "door".into()],
        home: PoseView::default(),
        goal_m: [4.0, -2.0],
        goal_radius_m: 0.5,
        robot_radius_m: 0.265,
        sonar_range_m: 8.0,
    }
}

fn events() -> Vec<LogEntry> {
    let event = |at: &str, tick, kind: &str, text: &str| LogEntry {
        at: format!("2026-11-22T09:{at}Z"),
        tick,
        kind: kind.into(),
        text: text.into(),
    };
    vec![
        event("31:52.118", 0, "operator", "Created by the page"),
        event("31:54.902", 0, "operator", "Start"),
        event("31:58.310", 239, "warning", "Trial 2 was capped after 200 steps"),
        event("32:21.004", 756, "session", "Finished: 20 trials"),
    ]
}

fn picture(trial: u32) -> Picture {
    Picture {
        name: format!("trial-{trial:03}"),
        caption: format!("Trial {trial}: the true path from home to the goal"),
        alt: format!("Plan of the laboratory with the path of trial {trial}"),
        png: png(),
    }
}

/// A PNG file of the size of a still.
fn png() -> Vec<u8> {
    let (width, height) = (960, 640);
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Grayscale);
    let pixels: Vec<u8> = (0..width * height)
        .map(|pixel| if (pixel % width) % 80 == 0 || (pixel / width) % 80 == 0 { 190 } else { 250 })
        .collect();
    let mut writer = encoder.write_header().expect("the header of a small grey picture");
    writer.write_image_data(&pixels).expect("as many pixels as the header says");
    writer.finish().expect("a whole file");
    bytes
}

fn tick(trial: &Trial, step: u32) -> TickView {
    let turn = f64::from(step);
    let (x_m, y_m) = (0.18 * turn, -0.02 * turn * (0.3 * turn).sin());
    let pose = PoseView { x_m, y_m, heading_deg: 8.0 * (0.4 * turn).sin() };
    let collided = step == 11;
    let safety = if collided {
        -3.0
    } else if step % 9 == 0 {
        -0.25
    } else {
        0.0
    };
    let goal = -0.28 - 0.1 * (0.5 * turn).cos();
    TickView {
        tick: trial.first_tick + u64::from(step) - 1,
        trial: trial.trial,
        step,
        true_pose: pose,
        pose,
        sonar_m: (0..24).map(|sonar| 0.3 + 0.11 * f64::from((sonar * 7 + step) % 24)).collect(),
        reflectance_pct: 12.5,
        goal_distance_m: 4.4 - 0.14 * turn,
        goal_bearing_deg: -26.5,
        region: if step < 20 { "room" } else { "corridor" }.into(),
        winner: (step > 1)
            .then(|| WinnerView { neuron: 40 + step, distance: 0.031 + 0.004 * turn }),
        born: (step % 4 == 0).then_some(60 + step),
        reflex: None,
        adaptation: adaptation(step),
        neuron: Some(40 + step),
        prototypical_deg: 35.0 * (0.2 * turn).sin(),
        utility: (step % 4 != 0).then_some(-0.4 * (29.0 - turn)),
        exploration: ExplorationView {
            temperature_deg: trial.temperature_deg,
            mean_deg: -6.5,
            sigma_deg: 51.3,
            deviation_deg: 1.8,
            drawn_deg: -7.1,
            xi_deg: -7.1,
        },
        source: if step == 12 { "after-rescue" } else { "network" }.into(),
        action_deg: 35.0 * (0.2 * turn).sin() - 7.1,
        action_frame: "heading".into(),
        rotation_deg: -3.4,
        outcome: OutcomeView {
            true_pose: pose,
            pose,
            contact: if collided { "virtual" } else { "none" }.into(),
            backed_m: if collided { 0.12 } else { 0.0 },
            reinforcement: safety + goal,
            safety,
            goal,
            close: safety < 0.0,
            reached_goal: step == trial.steps,
        },
        neurons: 64 + step / 4,
        total_reinforcement: (safety + goal) * turn,
    }
}

fn adaptation(step: u32) -> AdaptationView {
    match step {
        1 => AdaptationView::NoPast,
        step if step % 4 == 0 => AdaptationView::Pending { past: 39 + step },
        step => AdaptationView::Updated {
            past: 39 + step,
            reinforcement: -0.3,
            present_utility: -4.4,
            utility_before: -4.6,
            delta: 0.1 + 1.0 / 3.0 * f64::from(step),
            utility_rate: 0.5,
            utility_after: -4.45,
            eligibility: 0.02,
            mean_before_deg: 0.0,
            mean_after_deg: 0.1,
            centre_shift: 0.003,
        },
    }
}

fn neuron(id: u32) -> NeuronView {
    NeuronView {
        id,
        region: "room".into(),
        centre: (0..32).map(|input| f64::from(input) / 32.0).collect(),
        prototypical_deg: 12.0,
        heading_deg: 12.0,
        mean_deg: -3.0,
        utility: Some(-5.5),
        wins: 4,
        birth: BirthView {
            trial: 1,
            step: id,
            tick: u64::from(id),
            cause: "distance".into(),
            value: Some(0.13),
            parent: None,
            pose: PoseView::default(),
        },
    }
}
