//! The tabular experiments as wholes: what they promise to whoever runs them.

use std::sync::Arc;

use sonarium_core::experiment::{
    BanditRun, BanditSettings, Contest, ContestStep, ContinualSettings, EpisodeEnd,
    GridworldSettings, HorizonRun, HorizonSettings, LabyrinthExtras, LabyrinthSettings, Learners,
    Model, Phase, Score,
};
use sonarium_core::labyrinth::{Bias, episodes, matrix};
use sonarium_core::settings::Value;
use sonarium_core::tabular::{AnyWorld, LearnerKind, Maze, MazeFile};

fn maze(name: &str) -> Arc<AnyWorld> {
    let path = format!("{}/../assets/mazes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).expect(&path);
    let file: MazeFile = toml::from_str(&text).expect("a maze file");
    Arc::new(AnyWorld::Maze(Maze::new(&file).expect("a good maze")))
}

/// Everything on, everything short.
fn labyrinth() -> (LabyrinthSettings, LabyrinthExtras) {
    let settings = LabyrinthSettings {
        trials: 20,
        cap: 2_000,
        reflex: true,
        advice: true,
        heterogeneous: true,
        progress: true,
        modules: true,
        ..LabyrinthSettings::default()
    };
    let extras = LabyrinthExtras {
        advice: "if goal is ahead then forward\nif wall is ahead then not forward".into(),
        matrix: Some(vec![vec![1.0, 1.0, 0.5]; 16]),
        table: None,
    };
    (settings, extras)
}

/// Runs until all have done so many episodes; every step and end is handed over.
fn run(contest: &mut Contest, count: u32, mut look: impl FnMut(&ContestStep, Option<&EpisodeEnd>)) {
    while contest.episodes_done() < count {
        let (step, end) = contest.step();
        look(step, end);
    }
}

#[test]
fn every_bias_of_the_labyrinth_competes_and_is_scored() {
    let (settings, extras) = labyrinth();
    let mut contest = settings.contest(&extras, 3).expect("good settings");
    run(&mut contest, 2, |_, _| {});
    let scores = contest.scores();
    let names: Vec<&str> = scores.iter().map(|score| score.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "B0",
            "B10",
            "B11",
            "B2",
            "B30",
            "B31",
            "reflex",
            "advice",
            "heterogeneous reward",
            "progress estimator",
            "modules",
            "own matrix",
        ]
    );
    for (at, score) in scores.iter().enumerate() {
        assert_eq!((score.gain.is_some(), score.index.is_some()), (at > 0, true), "{}", score.name);
        assert_eq!(contest.curve(at).len(), 20);
    }
    assert_eq!(
        scores[..4].iter().map(|score| score.search_space).collect::<Vec<_>>(),
        [48, 38, 38, 40]
    );
}

#[test]
fn a_step_tells_how_its_update_was_made() {
    let (settings, extras) = labyrinth();
    let mut contest = settings.contest(&extras, 3).expect("good settings");
    let mut next_tick = 1;
    let mut follows: Option<ContestStep> = None;
    run(&mut contest, 1, |step, _| {
        assert_eq!(step.tick, next_tick);
        next_tick += 1;
        let update = &step.step.update;
        // Eq. (4.10), recomputed from the numbers shown.
        let delta = update.reward + update.discount * update.ahead - update.before;
        assert!((update.delta - delta).abs() < 1e-12);
        assert!((update.after - (update.before + update.rate * delta)).abs() < 1e-12);
        assert!((step.step.chances.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        assert!(step.step.chances[step.step.action] > 0.0);
        assert!((step.step.values[step.step.action] - update.before).abs() < 1e-12);
        if let Some(before) = follows.take().filter(|before| before.trial.is_none()) {
            assert_eq!(before.step.next, step.step.state, "a trial has no gap");
        }
        follows = Some(step.clone());
    });
}

#[test]
fn the_contest_and_the_packed_runs_agree() {
    let settings = LabyrinthSettings::default();
    let mut contest = settings.contest(&LabyrinthExtras::default(), 8).expect("good settings");
    run(&mut contest, 2, |_, _| {});
    let labyrinth = settings.labyrinth().expect("start and goal differ");
    for (at, bias) in Bias::ALL.into_iter().enumerate() {
        let beliefs = matrix(bias, 15, &settings.readings());
        let packed = episodes(&labyrinth, &beliefs, &settings.rule(), 8, 0..2).expect("left");
        assert_eq!(contest.episodes(at), packed, "{bias:?}");
    }
}

#[test]
fn a_resumed_contest_runs_to_the_same_bits() {
    let (settings, extras) = labyrinth();
    let mut whole = settings.contest(&extras, 5).expect("good settings");
    let mut checkpoints = Vec::new();
    let mut steps = Vec::new();
    while whole.episodes_done() < 1 {
        steps.push(whole.step().0.clone());
        if steps.last().is_some_and(|step| step.trial.is_some()) {
            checkpoints.push(whole.checkpoint().expect("between trials"));
        } else {
            assert_eq!(whole.checkpoint(), None, "a trial is under way");
        }
    }
    assert!(checkpoints.len() >= 12 * 20);
    for checkpoint in checkpoints.iter().step_by(17) {
        let json = serde_json::to_string(checkpoint).expect("plain data");
        let checkpoint = serde_json::from_str(&json).expect("plain data");
        let mut resumed = settings.resume(&extras, 5, &checkpoint).expect("its own checkpoint");
        let done = usize::try_from(checkpoint.ticks()).expect("small");
        for expected in steps.iter().skip(done).take(200) {
            assert_eq!(resumed.step().0, expected);
        }
    }
}

#[test]
fn advice_given_during_a_run_changes_it_and_is_kept() {
    let settings = LabyrinthSettings { trials: 30, ..LabyrinthSettings::default() };
    let run = |advice: Option<&str>| {
        let mut contest = settings.contest(&LabyrinthExtras::default(), 2).expect("good");
        for _ in 0..20 {
            contest.step();
        }
        if let Some(text) = advice {
            contest.walk_mut().advise(text).expect("good advice");
        }
        loop {
            if let (_, Some(end)) = contest.step() {
                return end.index;
            }
        }
    };
    let good = "if goal is behind then left\nif goal is ahead then forward\nif goal is right then right\n\
        if goal is left then left\nif goal is here and heading is not west then left";
    let (without, with) = (run(None), run(Some(good)));
    assert!(with < 0.7 * without, "{with} against {without}");
    let mut contest = settings.contest(&LabyrinthExtras::default(), 2).expect("good");
    let error =
        contest.walk_mut().advise("if goal is ahead then jump").expect_err("no such action");
    assert_eq!((error.line, error.column), (1, 23));
}

#[test]
fn each_class_of_bias_competes_in_a_maze() {
    let settings = GridworldSettings {
        trials: 30,
        reflex: true,
        advice: true,
        heterogeneous: true,
        progress: true,
        modules: true,
        ..GridworldSettings::default()
    };
    let advice = "if goal is east and wall is not east then east\n\
        if goal is south and wall is not south then south";
    let mut contest = settings.contest(&maze("four-rooms"), advice, 1).expect("a good world");
    run(&mut contest, 4, |_, _| {});
    let scores = contest.scores();
    let names: Vec<&str> = scores.iter().map(|score| score.name.as_str()).collect();
    assert_eq!(
        names[1..],
        ["reflex", "advice", "heterogeneous reward", "progress estimator", "modules"]
    );
    for score in &scores {
        assert!(score.index.is_some_and(|index| index.n == 4), "{}", score.name);
        // Four rooms and three doors: the shortest way takes 18 steps.
        assert!(score.last.is_some_and(|last| last >= 18.0), "{}", score.name);
    }
    // Rewarded room by room, the way is found many times as fast.
    let (flat, modules) = (&scores[0], scores.last().expect("modules"));
    let low = |score: &Score| score.index.map_or(f64::NAN, |index| index.value);
    assert!(low(modules) < 0.5 * low(flat), "{} against {}", low(modules), low(flat));
}

#[test]
fn all_learners_can_compete() {
    let settings =
        GridworldSettings { learners: Learners::All, trials: 20, ..GridworldSettings::default() };
    let mut contest = settings.contest(&maze("dyna"), "", 1).expect("a good world");
    run(&mut contest, 2, |step, _| {
        let planned = contest_planned(step);
        assert!(planned == 0 || step.position.entrant >= 2);
    });
    let scores = contest.scores();
    assert_eq!(
        scores.iter().map(|score| &score.name[..]).collect::<Vec<_>>(),
        ["q-learning", "ahc", "dyna", "sweeping"]
    );
    for at in [2, 3] {
        assert!(scores[at].gain.expect("compared") > 0.0, "{:?}", scores[at]);
    }
    let sweeping = GridworldSettings {
        kind: LearnerKind::Sweeping,
        learners: Learners::One,
        planning: 1,
        ..settings
    };
    let mut contest = sweeping.contest(&maze("dyna"), "", 1).expect("a good world");
    let mut waited = false;
    while contest.episodes_done() < 1 {
        contest.step();
        let learner = contest.walk().learner();
        let queue = learner.queue();
        assert!(queue.windows(2).all(|pair| pair[0].1 >= pair[1].1), "most urgent first");
        waited |= !queue.is_empty();
    }
    assert!(waited, "a sweep of one state leaves the others waiting");
}

fn contest_planned(step: &ContestStep) -> u32 {
    step.step.update.planned
}

#[test]
fn continual_runs_both_ways_for_every_goal() {
    let settings =
        ContinualSettings { all_goals: true, trials: 10, ..ContinualSettings::default() };
    assert_eq!(settings.new_goals().len(), 14);
    let mut contest = settings.contest(4).expect("good settings");
    let mut phases = Vec::new();
    run(&mut contest, 1, |_, end| phases.extend(end.map(|end| end.position.phase)));
    let expected = [Phase::Task, Phase::Training, Phase::Task];
    assert_eq!(phases, expected.repeat(14), "scratch; then training, and its task");
    let scores = contest.scores();
    assert_eq!(scores.len(), 28);
    assert_eq!(scores[5].reference.as_deref(), Some("scratch, goal 2"));
    let packed = sonarium_core::labyrinth::continual(
        &sonarium_core::labyrinth::Labyrinth::of_the_thesis(),
        &sonarium_core::labyrinth::Labyrinth::new(7, 2).expect("differ"),
        &settings.rule(),
        4,
        0..1,
    )
    .expect("nothing is excluded");
    assert_eq!(contest.episodes(4), [packed[0].scratch.clone()]);
    assert_eq!(contest.episodes(5), [packed[0].continual.clone()]);
}

#[test]
fn the_horizon_decides_as_figure_3_3_says() {
    let mut horizon = HorizonRun::new(HorizonSettings::default(), 0);
    let mut steps = Vec::new();
    while let Some(step) = horizon.step() {
        steps.push(step);
    }
    assert_eq!(steps.len() as u64, horizon.points());
    let best = |model: Model, parameter: f64| {
        let at = steps.iter().filter(|step| step.model == model);
        at.min_by(|a, b| {
            (a.parameter - parameter).abs().total_cmp(&(b.parameter - parameter).abs())
        })
        .expect("a point")
        .best
    };
    for (h, expected) in [(5.0, 0), (6.0, 1), (15.0, 1), (17.0, 2)] {
        assert_eq!(best(Model::FiniteHorizon, h), expected, "h = {h}");
    }
    for (gamma, expected) in [(0.5, 0), (0.6, 1), (0.9, 1), (0.92, 2)] {
        assert_eq!(best(Model::Discounted, gamma), expected, "γ = {gamma}");
    }
    assert_eq!(steps.last().map(|step| (step.model, step.best)), Some((Model::Average, 2)));
    let crossings: Vec<f64> =
        steps.iter().filter_map(|step| step.crossing).map(|crossing| crossing.at).collect();
    let expected = [5.75, 16.0, 0.2f64.cbrt(), 10.0 / 11.0];
    assert_eq!(crossings.len(), 4);
    assert!(crossings.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{crossings:?}");
    let mut resumed = HorizonRun::new(HorizonSettings::default(), 40);
    assert_eq!(resumed.step().as_ref(), steps.get(40));
}

#[test]
fn bandits_meet_the_same_levers_and_go_on_after_a_checkpoint() {
    let settings = BanditSettings { pulls: 200, ..BanditSettings::default() };
    let mut whole = BanditRun::new(settings.clone(), 6, None).expect("five strategies");
    let mut steps = Vec::new();
    let mut checkpoint = None;
    while whole.episodes_done() < 4 {
        let (step, _) = whole.step();
        steps.push(step.clone());
        if whole.episodes().len() == 7 && checkpoint.is_none() {
            checkpoint = whole.checkpoint();
        }
    }
    let mut resumed = BanditRun::new(settings, 6, checkpoint).expect("five strategies");
    for expected in &steps[7 * 200..] {
        assert_eq!(resumed.step().0, expected);
    }
    let scores = whole.scores();
    assert!(scores.iter().all(|score| score.regret.is_some_and(|regret| regret.n == 4)));
    let first_means: Vec<f64> = (0..5).map(|strategy| steps[strategy * 200].mean).collect();
    assert!(
        first_means.windows(2).all(|pair| pair[0].to_bits() == pair[1].to_bits()),
        "same levers"
    );
    let none = BanditSettings {
        greedy: false,
        epsilon_greedy: false,
        softmax: false,
        ucb: false,
        interval: false,
        ..BanditSettings::default()
    };
    assert_eq!(BanditRun::new(none, 1, None).expect_err("nobody").key(), "strategy.greedy");
}

#[test]
fn bad_settings_are_named() {
    let mut settings = LabyrinthSettings::default();
    for (key, value) in [
        ("exploration.first", Value::Number(0.0)),
        ("exploration.least", Value::Number(-1.0)),
        ("goal", Value::Integer(16)),
        ("learner.discount", Value::Number(1.1)),
    ] {
        assert_eq!(settings.set(key, &value).expect_err(key).key(), key);
    }
    let same = LabyrinthSettings { goal: 7, ..LabyrinthSettings::default() };
    let extras = LabyrinthExtras::default();
    let message = same.contest(&extras, 1).expect_err("same").to_string();
    assert_eq!(message, "`goal` must differ from the start, which is 7");
    let own = LabyrinthExtras { matrix: Some(vec![vec![-1.0; 3]; 16]), ..extras.clone() };
    let message = settings.contest(&own, 1).expect_err("nothing left").to_string();
    assert!(message.starts_with("own matrix: belief matrix: every action of state 7"), "{message}");
    let advised = LabyrinthSettings { advice: true, ..LabyrinthSettings::default() };
    let own = LabyrinthExtras { advice: "if goal is blue then left".into(), ..extras };
    let message = advised.contest(&own, 1).expect_err("no such term").to_string();
    assert!(
        message.starts_with("advice, line 1, column 12: `goal` has no term `blue`"),
        "{message}"
    );
    let rooms = GridworldSettings { modules: true, ..GridworldSettings::default() };
    let message = rooms.contest(&maze("dyna"), "", 1).expect_err("no rooms").to_string();
    assert!(message.contains("no modules"), "{message}");
}
