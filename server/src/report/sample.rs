//! A session as the tests of the reports need one: 20 trials that learn, the second of which fails.

use std::collections::BTreeMap;

use serde_json::Value;

use super::{Picture, SessionReport};
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
        yardstick: Yardstick::Ready(PlannedPath {
            total_reinforcement: -4.75,
            steps: 27,
            collisions: 0,
            resolution: 0.01,
            path_m: vec![[0.0, 0.0], [4.0, -2.0]],
        }),
        trials,
        settings: settings(),
        preset: PresetInfo {
            name: "learner".into(),
            title: "The learner".into(),
            summary: "The smallest set of additions under which the robot really learns.".into(),
            settings: BTreeMap::new(),
        },
        world: world(),
        network: None,
        starts: Vec::new(),
        events: events(),
        pictures: vec![picture(1), picture(20)],
        build: "0.1.0 (a47fe4c)".into(),
    }
}

pub(super) fn trials() -> Vec<Trial> {
    let mut tick = 0;
    let mut best = f64::NEG_INFINITY;
    let mut trials = Vec::new();
    for (number, row) in (1..).zip(TRIALS) {
        let (steps, safety, goal, neurons, born, forgotten, collisions) = row;
        // Digits that only the shortest exact form keeps.
        let (safety, goal) = (safety + 1e-9 / 3.0, goal - 1e-9 / 7.0);
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
            true_goal: Some(goal),
            neurons,
            born,
            forgotten,
            collisions,
            reached_goal,
            record,
            scout: number == 9,
            temperature_deg: if number < 16 {
                10.0 + 90.0 * 0.8f64.powi(number as i32 - 1)
            } else {
                0.0
            },
            path_m: 0.2 * f64::from(steps) - 0.07,
            regret: reached_goal.then_some(-4.75 - total),
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
        planned_total_reinforcement: Some(-4.75),
        last_regret: last.and_then(|trial| trial.regret),
        last_regret_pct: last.and_then(|trial| trial.regret).map(|regret| regret / 0.0475),
        neurons: last.map_or(0, |trial| trial.neurons),
        collisions: trials.iter().map(|trial| trial.collisions).sum(),
        steps: trials.iter().map(|trial| u64::from(trial.steps)).sum(),
    }
}

pub(super) fn session() -> Session {
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
        family: Family::Path,
        trials_done: 20,
        rounds: 20,
        rounds_done: 20,
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
            "shortcut.push",
            "Move the points aimed at off the obstacle that cost clearance",
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
        robot_corners_m: Vec::new(),
        sonar_range_m: 8.0,
        sonars: Vec::new(),
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

pub(super) fn picture(trial: u32) -> Picture {
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
