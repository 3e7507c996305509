//! The experiment as a whole: what it promises, on the laboratory of the thesis.

use std::collections::BTreeMap;
use std::sync::Arc;

use sonarium_core::experiment::{Checkpoint, MinimumCostPath, Settings};
use sonarium_core::geometry::{Vec2, angle, wrap_angle};
use sonarium_core::learner::{
    ActionSource, Adaptation, Aim, BirthCause, NeuronId, Origin, Tick, TrialEnd, TrialRecord,
};
use sonarium_core::robot::{Contact, Robot, RobotFile};
use sonarium_core::settings::Value;
use sonarium_core::world::{World, WorldFile};

fn laboratory() -> Arc<World> {
    world("laboratory")
}

fn world(name: &str) -> Arc<World> {
    let path = format!("{}/../assets/worlds/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).expect("the world is among the assets");
    let file: WorldFile = toml::from_str(&text).expect("a world file");
    let radius_m = b21().body().reach_m();
    Arc::new(World::new(&file, radius_m).expect("a good world"))
}

fn b21() -> Arc<Robot> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/robots/b21.toml");
    let text = std::fs::read_to_string(path).expect("the B21 is among the assets");
    let file: RobotFile = toml::from_str(&text).expect("the B21 is a robot file");
    Arc::new(Robot::new(&file).expect("the B21 is a good robot"))
}

fn with(changes: &[(&str, Value)]) -> Settings {
    let mut settings = Settings::default();
    for (key, value) in changes {
        settings.set(key, value).expect("a good setting");
    }
    settings
}

fn choice(name: &str) -> Value {
    Value::Choice(name.into())
}

/// Runs trials and hands every tick and trial end to the caller.
fn run(
    experiment: &mut MinimumCostPath,
    trials: u32,
    mut look: impl FnMut(&Tick, Option<&TrialEnd>),
) -> Vec<TrialRecord> {
    let mut records = Vec::new();
    while experiment.trials_done() < trials {
        let (tick, end) = experiment.step();
        look(tick, end);
        records.extend(end.map(|end| end.record.clone()));
    }
    records
}

fn records(settings: &Settings, seed: u64, trials: u32) -> Vec<TrialRecord> {
    let mut experiment = MinimumCostPath::new(laboratory(), b21(), settings, seed).expect("fits");
    run(&mut experiment, trials, |_, _| {})
}

/// Mean over seeds of something in the last of 20 trials.
fn mean_at_the_end(
    settings: &Settings,
    seeds: std::ops::Range<u64>,
    of: fn(&TrialRecord) -> f64,
) -> f64 {
    let values: Vec<f64> =
        seeds.map(|seed| of(records(settings, seed, 20).last().expect("20 trials"))).collect();
    values.iter().sum::<f64>() / values.len() as f64
}

#[test]
fn the_same_seed_gives_the_same_bits_and_another_seed_does_not() {
    let settings = Settings::default();
    let ticks = |seed| {
        let mut ticks = Vec::new();
        let mut experiment =
            MinimumCostPath::new(laboratory(), b21(), &settings, seed).expect("fits");
        run(&mut experiment, 6, |tick, _| ticks.push(tick.clone()));
        ticks
    };
    let first = ticks(11);
    assert_eq!(first, ticks(11));
    assert_ne!(first, ticks(12));
}

#[test]
fn a_run_resumed_from_any_trial_goes_on_to_the_same_bits() {
    let settings = with(&[("odometry.drift", Value::Number(0.01))]);
    let world = laboratory();
    let mut whole = MinimumCostPath::new(Arc::clone(&world), b21(), &settings, 5).expect("fits");
    let mut ticks = Vec::new();
    let mut checkpoints: Vec<Checkpoint> = Vec::new();
    // Trials 3 to 6 are those of scouts, with what was learned before laid aside.
    while whole.trials_done() < 8 {
        let (tick, end) = whole.step();
        let ended = end.is_some();
        ticks.push(tick.clone());
        assert_eq!(whole.checkpoint().is_some(), ended, "checkpoints exist between trials only");
        checkpoints.extend(whole.checkpoint());
    }
    for checkpoint in checkpoints {
        let text = serde_json::to_string(&checkpoint).expect("a checkpoint can be written");
        let read: Checkpoint = serde_json::from_str(&text).expect("and read");
        let mut resumed =
            MinimumCostPath::resume(Arc::clone(&world), b21(), &settings, 5, &read).expect("fits");
        let from = read.tick() as usize;
        let mut rest = Vec::new();
        run(&mut resumed, 8, |tick, _| rest.push(tick.clone()));
        assert_eq!(rest, ticks[from..], "resumed after trial {}", read.trials_done());
    }
}

#[test]
fn the_default_preset_learns_and_holds_what_it_learned() {
    let settings = Settings::default();
    let seeds = 40_000..40_030;
    let mut last_five_failed = 0;
    for seed in seeds.clone() {
        let trials = records(&settings, seed, 20);
        last_five_failed += trials[15..].iter().filter(|trial| !trial.reached_goal).count();
        let first = trials[0].steps;
        assert!((30..=50).contains(&first), "trial 1 is reflex-like: {first} steps (seed {seed})");
    }
    assert_eq!(last_five_failed, 0);
    let steps = mean_at_the_end(&settings, seeds.clone(), |trial| f64::from(trial.steps));
    assert!(steps <= 28.5, "{steps} steps in the last trial");
    let learned = mean_at_the_end(&settings, seeds.clone(), |trial| trial.total_reinforcement);
    assert!(learned >= -7.0, "R = {learned} in the last trial");
    let reflex = with(&[("learner.learning", Value::Switch(false))]);
    let control = mean_at_the_end(&reflex, seeds, |trial| trial.total_reinforcement);
    assert!(learned > control + 15.0, "learned {learned}, reflex {control}");
}

#[test]
fn without_replacement_the_best_path_is_not_held() {
    let seeds = 41_000..41_010;
    let steps = |changes: &[(&str, Value)]| {
        mean_at_the_end(&with(changes), seeds.clone(), |trial| f64::from(trial.steps))
    };
    let off = ("learner.replacement", choice("off"));
    let (lost, held) = (steps(std::slice::from_ref(&off)), steps(&[]));
    assert!(lost > held + 4.0, "{lost} steps, held {held}");
    // Without steps aside (A4) the robot pays for it with collisions, too.
    let literal = with(&[off, ("learner.sidestep", Value::Number(0.0))]);
    let total = mean_at_the_end(&literal, seeds.clone(), |trial| trial.total_reinforcement);
    assert!(total < -20.0, "{total}");
}

#[test]
fn utilities_earn_their_place() {
    let without = with(&[
        ("learner.temporal_difference", Value::Switch(false)),
        ("learner.backtrack", Value::Switch(false)),
    ]);
    let seeds = 42_000..42_020;
    let steps = |settings: &Settings| {
        mean_at_the_end(settings, seeds.clone(), |trial| f64::from(trial.steps))
    };
    let (blind, learned) = (steps(&without), steps(&Settings::default()));
    assert!(blind > learned + 2.0, "without utilities {blind} steps, with them {learned}");
}

#[test]
fn a_shortcut_is_followed_to_where_it_leads() {
    let mut experiment =
        MinimumCostPath::new(laboratory(), b21(), &Settings::default(), 12).expect("fits");
    let mut proposed = Vec::new();
    let (mut followed, mut carried, mut bent) = (0, 0, 0);
    run(&mut experiment, 8, |tick, end| {
        let decision = &tick.decision;
        if let Some(aim) = decision.aim.filter(|_| decision.exploration.mean_deg != 0.0) {
            // A1: the mean leads from p to the direction of the aim.
            let mean_rad = decision.exploration.mean_deg.to_radians();
            let way = aim.point() - tick.pose.position();
            let off_rad = decision.prototypical_rad + mean_rad - angle(way);
            assert!(wrap_angle(off_rad).abs() < 1e-9, "tick {}", tick.tick);
            assert!(proposed.contains(&aim), "what is followed was proposed, tick {}", tick.tick);
            followed += 1;
            carried += u32::from(decision.born.is_some());
        }
        if decision.source == ActionSource::Bend {
            // A3: past a known neuron the way goes on, with nothing but the draw added.
            let aim = decision.aim.expect("a leg");
            let way = aim.point() - tick.pose.position();
            let drawn_rad = decision.exploration.xi_deg.to_radians();
            let off_rad = decision.action_rad - drawn_rad - angle(way);
            assert!(wrap_angle(off_rad).abs() < 1e-9, "tick {}", tick.tick);
            assert!(decision.born.is_none() && proposed.contains(&aim), "tick {}", tick.tick);
            bent += 1;
        }
        if let Some(end) = end {
            // What a scout finds is learned from whether it is the best of all or not.
            let learned = end.record.record || !end.replaced.is_empty();
            assert!(learned || end.proposed.is_empty(), "only a record proposes");
            let aims = end.proposed.iter().map(|proposal| proposal.aim);
            // A3: where a way bends, its second leg is followed next.
            proposed.extend(aims.flat_map(|aim| [Some(aim), aim.after_bend()]).flatten());
        }
    });
    assert!(followed > carried && carried > 0, "{followed} followed, {carried} by new neurons");
    assert!(bent > 0, "no bend was kept to past a known neuron");
}

#[test]
fn only_a_shortcut_turns_by_more_than_the_temperature() {
    let sharp_steps = |sharp: bool| {
        // A low temperature, under which many shortcuts are sharp.
        let low = ("learner.temperature_max", Value::Number(15.0));
        let settings = with(&[low, ("shortcut.sharp", Value::Switch(sharp))]);
        let mut count = 0;
        for seed in 61..64 {
            let mut experiment =
                MinimumCostPath::new(laboratory(), b21(), &settings, seed).expect("fits");
            run(&mut experiment, 20, |tick, _| {
                let unit = &tick.decision.exploration;
                assert!(unit.xi_deg.abs() <= unit.most_deg, "tick {}", tick.tick);
                if unit.most_deg > unit.temperature_deg {
                    // A11: as far as the shortcut leads, and at temperature 0 nothing is followed.
                    assert_eq!(unit.most_deg.to_bits(), unit.mean_deg.abs().to_bits());
                    assert!(tick.decision.aim.is_some() && unit.temperature_deg > 0.0);
                    count += 1;
                } else {
                    assert_eq!(unit.most_deg.to_bits(), unit.temperature_deg.to_bits());
                }
            });
        }
        count
    };
    let (sharp, clipped) = (sharp_steps(true), sharp_steps(false));
    assert!(sharp > 10 && clipped == 0, "{sharp} sharp steps, {clipped} without A11");
}

#[test]
fn only_home_looks_for_bends_and_not_on_a_scout_s_way() {
    let (mut bends, mut found) = (0, 0);
    for seed in 71..75 {
        let mut experiment =
            MinimumCostPath::new(world("pillars"), b21(), &Settings::default(), seed)
                .expect("fits");
        let mut home = None;
        run(&mut experiment, 8, |tick, end| {
            if tick.step == 1 {
                home = tick.decision.neuron;
            }
            let Some(end) = end else { return };
            for proposal in end.proposed.iter().filter(|proposal| proposal.aim.beyond.is_some()) {
                assert_eq!(Some(proposal.neuron), home, "trial {}", end.record.trial);
                assert!(!end.record.scout, "trial {} of seed {seed}", end.record.trial);
                bends += 1;
            }
            found += u32::from(end.record.scout && !end.proposed.is_empty());
        });
    }
    assert!(bends > 0 && found > 0, "{bends} bends, {found} ways found by scouts");
}

/// What a trial's steps were, for the shortcuts it followed.
struct Followed {
    neuron: NeuronId,
    aim: Option<Aim>,
    reinforcement: f64,
}

/// Reinforcement of the record trial from the last step of each neuron on.
fn to_go(path: &[Followed]) -> BTreeMap<NeuronId, f64> {
    let mut sum = 0.0;
    let mut found = BTreeMap::new();
    for step in path.iter().rev() {
        sum += step.reinforcement;
        found.entry(step.neuron).or_insert(sum);
    }
    found
}

#[test]
fn a_shortcut_that_gained_nothing_is_withdrawn() {
    // Without bends a shortcut is followed under one aim.
    let alone =
        [("learner.scout_from", Value::Integer(0)), ("shortcut.bend", Value::Switch(false))];
    let counts = |withdrawal: &str| {
        let choice = ("shortcut.withdraw", Value::Choice(withdrawal.into()));
        let settings = with(&[alone.to_vec(), vec![choice]].concat());
        let (mut kept, mut withdrawn) = (0, 0);
        for seed in 15..21 {
            let mut experiment =
                MinimumCostPath::new(laboratory(), b21(), &settings, seed).expect("fits");
            let (mut open, mut record) = (BTreeMap::new(), BTreeMap::new());
            let mut path: Vec<Followed> = Vec::new();
            run(&mut experiment, 20, |tick, end| {
                let decision = &tick.decision;
                let neuron = decision.neuron.expect("it learns");
                let reinforcement = tick.outcome.reinforcement.total();
                path.push(Followed { neuron, aim: decision.aim, reinforcement });
                let Some(end) = end else { return };
                let path = std::mem::take(&mut path);
                let at = (seed, end.record.trial);
                let explored = decision.exploration.temperature_deg > 0.0;
                assert!(explored || end.judged.is_empty(), "nothing was followed: {at:?}");
                assert!(!end.record.record || end.judged.is_empty(), "a record: {at:?}");
                for verdict in &end.judged {
                    let neuron = verdict.neuron;
                    let begin = path.iter().position(|step| step.neuron == neuron);
                    let begin = begin.expect("only what was followed is judged");
                    assert_eq!(open.get(&neuron), path[begin].aim.as_ref(), "{at:?}: {neuron:?}");
                    // What was got until another neuron of the record path, and from there on the record.
                    let mut sum = path[begin].reinforcement;
                    let mut then = Some(0.0).filter(|_| end.record.reached_goal);
                    for step in &path[begin + 1..] {
                        let other = step.neuron != neuron && step.aim != path[begin].aim;
                        if let Some(there) = record.get(&step.neuron).filter(|_| other) {
                            then = Some(*there);
                            break;
                        }
                        sum += step.reinforcement;
                    }
                    let before = record.get(&neuron).copied();
                    let delta = before.zip(then).map(|(before, then)| sum + then - before);
                    assert_eq!(verdict.delta.is_some(), delta.is_some(), "{at:?}: {neuron:?}");
                    let off = verdict.delta.zip(delta).map_or(0.0, |(a, b): (f64, f64)| a - b);
                    assert!(off.abs() < 1e-9, "{at:?}: {neuron:?} off by {off}");
                    let gained = delta.is_some_and(|delta| delta > 0.0);
                    assert_eq!(verdict.withdrawn, withdrawal == "followed" || !gained, "{at:?}");
                    if verdict.withdrawn {
                        open.remove(&neuron);
                    }
                    kept += u32::from(!verdict.withdrawn);
                    withdrawn += u32::from(verdict.withdrawn);
                }
                if end.record.record {
                    record = to_go(&path);
                }
                open.extend(end.proposed.iter().map(|proposal| (proposal.neuron, proposal.aim)));
            });
        }
        (kept, withdrawn)
    };
    let (kept, withdrawn) = counts("losing");
    assert!(kept > 20 && withdrawn > 20, "{kept} kept, {withdrawn} withdrawn");
    let (kept, withdrawn) = counts("followed");
    assert!(kept == 0 && withdrawn > 20, "{kept} kept, {withdrawn} withdrawn");
    assert_eq!(counts("off"), (0, 0));
}

#[test]
fn at_the_end_only_neurons_of_the_record_path_act() {
    let lossy = ("sonar.critical_angle", Value::Number(25.0));
    let strays = |keep: bool, seed: u64| {
        // Without scouts there is one record path, and none is laid aside.
        let alone = ("learner.scout_from", Value::Integer(0));
        let keep = ("learner.keep_to_record", Value::Switch(keep));
        let settings = with(&[lossy.clone(), alone, keep]);
        let mut experiment =
            MinimumCostPath::new(laboratory(), b21(), &settings, seed).expect("fits");
        let (mut path, mut record, mut replaced) = (Vec::new(), Vec::new(), 0);
        let mut strays = [0, 0];
        run(&mut experiment, 20, |tick, end| {
            let decision = &tick.decision;
            path.push(decision.neuron.expect("it learns"));
            let known = decision.born.is_none() && decision.exploration.temperature_deg == 0.0;
            let stray = known && !record.contains(&path[path.len() - 1]);
            strays[0] += usize::from(stray && decision.source == ActionSource::Network);
            if decision.source == ActionSource::Pursuit {
                assert!(stray, "tick {}", tick.tick);
                strays[1] += 1;
            }
            if let Some(end) = end {
                let path = std::mem::take(&mut path);
                if end.record.record {
                    record = path;
                    replaced += 1;
                }
            }
        });
        assert!(replaced > 1);
        strays
    };
    let sum = |keep| {
        (47_000..47_010)
            .map(|seed| strays(keep, seed))
            .fold([0, 0], |a, b| [a[0] + b[0], a[1] + b[1]])
    };
    let (kept, free) = (sum(true), sum(false));
    assert!(kept[0] == 0 && kept[1] > 0, "{kept:?}");
    assert!(free[0] > 0 && free[1] == 0, "{free:?}");
}

/// Mean over seeds of what the last of 20 trials earned, with the goal where it truly was.
fn true_mean(settings: &Settings, seeds: std::ops::Range<u64>) -> f64 {
    mean_at_the_end(settings, seeds, |trial| trial.safety + trial.true_goal)
}

#[test]
fn the_sonars_correct_an_odometry_that_errs() {
    let drift = ("odometry.drift", Value::Number(0.02));
    let corrected = with(std::slice::from_ref(&drift));
    let alone = with(&[drift, ("odometry.correction", Value::Switch(false))]);
    // The map is in the frame of the first trial, which errs, too; what is learned needs the same belief at the
    // same place. How much the error of the heading at the end differs between trials that drive one path:
    let spread = |errors: &[f64]| {
        let mean = errors.iter().sum::<f64>() / errors.len() as f64;
        errors.iter().map(|error| (error - mean).powi(2)).sum::<f64>() / errors.len() as f64
    };
    let (mut believed, mut odometry) = (0.0, 0.0);
    for seed in 48_000..48_010 {
        let mut experiment =
            MinimumCostPath::new(laboratory(), b21(), &corrected, seed).expect("fits");
        let (mut by_sonars, mut alone) = (Vec::new(), Vec::new());
        run(&mut experiment, 20, |tick, end| {
            let fix = tick.fix.expect("odometry is corrected");
            assert!(tick.trial == 1 || tick.step > 1 || fix.echoes > 0, "home is known");
            if end.is_some() && tick.trial > 15 {
                by_sonars.push(wrap_angle(tick.pose.heading_rad - tick.true_pose.heading_rad));
                alone.push(wrap_angle(fix.odometry.heading_rad - tick.true_pose.heading_rad));
            }
        });
        believed += spread(&by_sonars);
        odometry += spread(&alone);
    }
    assert!(believed < odometry / 4.0, "variance of headings {believed}, by odometry {odometry}");
    let seeds = 48_000..48_030;
    let (held, lost) = (true_mean(&corrected, seeds.clone()), true_mean(&alone, seeds));
    assert!(held > lost + 0.05, "corrected {held}, as it is {lost}");
    // Where nothing errs nothing is corrected, to the bit.
    let never = with(&[("odometry.correction", Value::Switch(false))]);
    assert_eq!(records(&never, 16, 8), records(&Settings::default(), 16, 8));
    let mut experiment =
        MinimumCostPath::new(laboratory(), b21(), &Settings::default(), 16).expect("fits");
    run(&mut experiment, 2, |tick, end| {
        assert_eq!(tick.fix, None);
        assert!(end.is_none_or(|end| end.record.goal == end.record.true_goal));
    });
}

/// Trials that reach the goal, of a run in a world.
fn successes(world: &Arc<World>, settings: &Settings, seed: u64, trials: u32) -> usize {
    let mut experiment =
        MinimumCostPath::new(Arc::clone(world), b21(), settings, seed).expect("fits");
    let records = run(&mut experiment, trials, |_, _| {});
    records.iter().filter(|trial| trial.reached_goal).count()
}

/// Mean total reinforcement in the last of 20 trials in a world.
fn mean_total(name: &str, settings: &Settings, seeds: std::ops::Range<u64>) -> f64 {
    let world = world(name);
    let totals = seeds.map(|seed| {
        let experiment = MinimumCostPath::new(Arc::clone(&world), b21(), settings, seed);
        let records = run(&mut experiment.expect("fits"), 20, |_, _| {});
        records.last().expect("20 trials").total_reinforcement
    });
    let totals: Vec<f64> = totals.collect();
    totals.iter().sum::<f64>() / totals.len() as f64
}

#[test]
fn a_scout_finds_the_way_between_two_obstacles() {
    let without = with(&[("learner.scout_from", Value::Integer(0))]);
    let seeds = 45_000..45_010;
    let (alone, found) = (
        mean_total("two-obstacles", &without, seeds.clone()),
        mean_total("two-obstacles", &Settings::default(), seeds),
    );
    // The planner's way costs 4.93, and the way round both obstacles that is found without scouts a third more.
    assert!(alone < -6.3, "without scouts {alone}");
    assert!(found > -6.0, "with scouts {found}");
}

#[test]
fn a_scout_that_searches_too_long_goes_back_to_the_record_path() {
    let mut experiment =
        MinimumCostPath::new(laboratory(), b21(), &Settings::default(), 13).expect("fits");
    let (mut scouted, mut followed) = (Vec::new(), Vec::new());
    let (mut record, mut limit) = ((0, f64::NEG_INFINITY), 0);
    let trials = run(&mut experiment, 6, |tick, end| {
        match tick.decision.source {
            ActionSource::Scout => scouted.push((tick.trial, tick.step)),
            _ if tick.trial == 5 => followed.push(tick.step),
            _ => {}
        }
        if let Some(end) = end.filter(|end| end.record.record) {
            let total = end.record.total_reinforcement;
            assert!(total > record.1, "trial {} is no record", end.record.trial);
            record = (end.record.steps, total);
        }
        if tick.trial == 4 {
            limit = 3 * record.0 / 2;
        }
    });
    assert!(scouted.iter().all(|(trial, _)| [3, 5].contains(trial)), "{scouted:?}");
    let scouts: Vec<u32> =
        trials.iter().filter(|trial| trial.scout).map(|trial| trial.trial).collect();
    assert_eq!(scouts, [3, 5]);
    assert!(trials.iter().all(|trial| trial.neurons > 20), "none ends with what was laid aside");
    // To the right the way leads round the whole room; the scout gives up and something else decides.
    let last = scouted.iter().filter(|(trial, _)| *trial == 5).map(|(_, step)| *step).max();
    let last = last.expect("the second scout set out");
    assert!(last <= limit && followed.iter().all(|step| *step > last), "{last}");
    assert!(trials[4].reached_goal && trials[4].steps > last && !trials[4].record);
    // What was learned before is there again.
    assert!((trials[5].total_reinforcement - record.1).abs() < 1.5, "{:?}", trials[5]);
}

#[test]
fn what_was_learned_is_there_while_a_scout_looks_for_more() {
    let mut experiment =
        MinimumCostPath::new(laboratory(), b21(), &Settings::default(), 13).expect("fits");
    let neurons = |experiment: &MinimumCostPath| -> usize {
        experiment.networks().iter().map(Vec::len).sum()
    };
    run(&mut experiment, 2, |_, _| {});
    let learned = experiment.networks();
    run(&mut experiment, 3, |_, _| {});
    assert_eq!(experiment.networks(), learned, "the scout's way is longer");
    assert!(experiment.neurons().count() < neurons(&experiment), "which is the one under way");
}

#[test]
fn new_neurons_go_back_to_the_record_path() {
    let drift = ("odometry.drift", Value::Number(0.02));
    let pursue = with(&[drift, ("learner.scout_from", Value::Integer(0))]);
    let mut experiment = MinimumCostPath::new(laboratory(), b21(), &pursue, 14).expect("fits");
    let (mut path, mut record) = (Vec::new(), Vec::new());
    let mut pursued = 0;
    run(&mut experiment, 20, |tick, end| {
        let here = tick.pose.position();
        path.push(here);
        if let Some(Origin::Pursuit { x_m, y_m }) = tick.decision.origin {
            let nearest = |a: &&Vec2, b: &&Vec2| {
                let away = |place: &Vec2| (place - here).norm();
                away(a).total_cmp(&away(b))
            };
            let at = record
                .iter()
                .min_by(nearest)
                .and_then(|near| record.iter().position(|p| p == near));
            let next = record.get(at.expect("a record path") + 1);
            let next = next.copied().unwrap_or_else(|| laboratory().goal().centre);
            assert_eq!([x_m, y_m], [next.x, next.y], "tick {}", tick.tick);
            let way_rad = angle(next - here);
            let off_rad = wrap_angle(tick.decision.prototypical_rad - way_rad);
            assert!(off_rad.abs() < 1e-9, "tick {}", tick.tick);
            pursued += 1;
        }
        if let Some(end) = end {
            let path = std::mem::take(&mut path);
            if end.record.record {
                record = path;
            }
        }
    });
    assert!(pursued > 10, "{pursued} new neurons went back");
}

#[test]
fn an_escape_leads_where_the_reflex_never_comes() {
    let baffles = world("two-baffles");
    let without = with(&[("learner.escape_after", Value::Integer(0))]);
    for seed in 44_000..44_004 {
        assert_eq!(successes(&baffles, &without, seed, 3), 0, "the reflex alone, seed {seed}");
        let found = successes(&baffles, &Settings::default(), seed, 12);
        assert!(found > 0, "no trial of twelve escaped, seed {seed}");
    }
}

#[test]
fn an_escape_does_not_run_into_the_same_thing_again_and_again() {
    let baffles = world("two-baffles");
    for seed in 44_000..44_010 {
        let mut experiment =
            MinimumCostPath::new(Arc::clone(&baffles), b21(), &Settings::default(), seed)
                .expect("fits");
        let (mut before, mut again) = (None, 0);
        run(&mut experiment, 4, |tick, _| {
            let hit = tick.outcome.contact != Contact::None;
            let escape = tick.decision.source == ActionSource::Escape && hit;
            let heading_deg = escape.then(|| tick.decision.action_rad.to_degrees().round());
            again = if heading_deg.is_some() && heading_deg == before { again + 1 } else { 0 };
            before = heading_deg;
            assert!(again < 6, "seed {seed}, tick {}: {heading_deg:?} again", tick.tick);
        });
    }
}

#[test]
fn an_escape_begins_without_progress_and_ends_nearer_than_ever() {
    let settings = Settings::default();
    let mut experiment =
        MinimumCostPath::new(world("two-baffles"), b21(), &settings, 44_000).expect("fits");
    let (mut begun, mut ended) = (0, 0);
    let (mut least_m, mut without, mut collisions, mut escaping) = (f64::INFINITY, 0, 0, false);
    run(&mut experiment, 8, |tick, _| {
        if tick.step == 1 {
            (least_m, without, collisions, escaping) = (f64::INFINITY, 0, 0, false);
        }
        let distance_m = tick.decision.goal_distance_m;
        without = if distance_m < least_m { 0 } else { without + 1 };
        let escapes = tick.decision.source == ActionSource::Escape;
        if escapes && !escaping {
            let stuck = without >= settings.escape_after || collisions >= 4;
            assert!(stuck, "begun at step {}", tick.step);
            begun += 1;
        }
        if escaping && !escapes {
            assert!(distance_m < least_m, "ended at step {}", tick.step);
            ended += 1;
        }
        (least_m, escaping) = (least_m.min(distance_m), escapes);
        collisions = if tick.outcome.contact == Contact::None { 0 } else { collisions + 1 };
        assert!(tick.step <= settings.step_cap);
    });
    assert!(begun > 0 && ended > 0, "{begun} begun, {ended} ended");
}

#[test]
fn an_escape_that_never_begins_changes_no_bit() {
    let ticks = |after| {
        let settings = with(&[("learner.escape_after", Value::Integer(after))]);
        let mut experiment =
            MinimumCostPath::new(laboratory(), b21(), &settings, 13).expect("fits");
        let mut ticks = Vec::new();
        run(&mut experiment, 4, |tick, _| ticks.push(tick.clone()));
        ticks
    };
    // A trial is capped at 200 steps.
    assert_eq!(ticks(0), ticks(1000));
}

#[test]
fn a_step_aside_waits_for_a_success_and_explores_nothing() {
    let settings = with(&[("odometry.drift", Value::Number(0.02))]);
    let (mut succeeded, mut aside) = (false, 0);
    let mut experiment = MinimumCostPath::new(laboratory(), b21(), &settings, 14).expect("fits");
    run(&mut experiment, 12, |tick, end| {
        let decision = &tick.decision;
        if decision.source == ActionSource::Sidestep {
            assert!(succeeded, "tick {}", tick.tick);
            assert_eq!(decision.exploration.xi_deg, 0.0, "nothing is explored");
            aside += 1;
        }
        succeeded |= end.is_some_and(|end| end.record.reached_goal);
    });
    assert!(aside > 0, "with drift something is in the way in twelve trials");
}

#[test]
fn stepping_aside_spares_collisions_when_the_odometry_drifts() {
    let collisions = |aside_m| {
        let settings = with(&[
            ("odometry.drift", Value::Number(0.02)),
            ("odometry.correction", Value::Switch(false)),
            ("learner.sidestep", Value::Number(aside_m)),
        ]);
        mean_at_the_end(&settings, 45_000..45_040, |trial| f64::from(trial.collisions))
    };
    let (with_it, without) = (collisions(0.15), collisions(0.0));
    assert!(with_it < without / 2.0, "{with_it} collisions, without it {without}");
}

#[test]
fn the_bare_reflex_grows_no_network() {
    let settings = with(&[("learner.learning", Value::Switch(false))]);
    for trial in records(&settings, 3, 3) {
        assert_eq!((trial.neurons, trial.born), (0, 0));
    }
}

#[test]
fn every_tick_adds_up() {
    let settings = Settings::default();
    let mut experiment = MinimumCostPath::new(laboratory(), b21(), &settings, 8).expect("fits");
    let mut total = 0.0;
    let mut last_tick = 0;
    run(&mut experiment, 10, |tick, end| {
        assert_eq!(tick.tick, last_tick + 1);
        last_tick = tick.tick;
        total += tick.outcome.reinforcement.total();
        assert!((tick.total_reinforcement - total).abs() < 1e-9, "R so far, tick {}", tick.tick);
        let decision = &tick.decision;
        if decision.source == ActionSource::Network {
            let alpha = decision.prototypical_rad + decision.exploration.xi_deg.to_radians();
            assert!(wrap_angle(alpha - decision.action_rad).abs() < 1e-12, "Eq. (5.15)");
            let heading = tick.pose.heading_rad + decision.rotation_rad;
            assert!(wrap_angle(heading - decision.action_rad).abs() < 1e-12, "the action frame");
        }
        if let Adaptation::Updated(update) = decision.adaptation {
            let delta = update.reinforcement + 0.7 * update.present_utility - update.utility_before;
            assert!((update.delta - delta).abs() < 1e-12, "Eq. (5.19)");
            let after = update.utility_before + update.utility_rate * update.delta;
            assert!((update.utility_after - after).abs() < 1e-12, "Eq. (5.20)");
        }
        if end.is_some() {
            total = 0.0;
        }
    });
}

#[test]
fn a_situation_that_turns_out_far_better_gets_its_own_neuron() {
    let settings = with(&[("learner.split_threshold", Value::Number(1.0))]);
    let mut experiment = MinimumCostPath::new(laboratory(), b21(), &settings, 2).expect("fits");
    let mut splits = Vec::new();
    run(&mut experiment, 3, |tick, _| {
        if let Adaptation::Split { past, delta, added } = tick.decision.adaptation {
            assert!(delta > 1.0 && past != added, "tick {}", tick.tick);
            splits.push((added, tick.tick, delta));
        }
    });
    assert!(!splits.is_empty(), "a threshold of 1 splits something in three trials");
    for neuron in experiment.neurons() {
        if let BirthCause::Error { delta } = neuron.birth.cause {
            assert!(splits.contains(&(neuron.id, neuron.birth.tick, delta)), "{:?}", neuron.id);
        }
    }
}

#[test]
fn back_tracking_gives_the_reinforcement_to_the_goal() {
    let mut experiment =
        MinimumCostPath::new(laboratory(), b21(), &Settings::default(), 21).expect("fits");
    let mut path = Vec::new();
    loop {
        let (tick, end) = experiment.step();
        path.push((tick.decision.neuron, tick.outcome.reinforcement.total()));
        if let Some(end) = end {
            assert!(end.record.reached_goal && end.record.record, "the first success is a record");
            break;
        }
    }
    // Eq. (5.26): u of the first neuron is R(1), u of the last is the last reinforcement.
    for (position, (neuron, _)) in path.iter().enumerate() {
        let to_goal: f64 = path[position..].iter().map(|(_, r)| r).sum();
        let first_visit = path.iter().position(|(other, _)| other == neuron) == Some(position);
        let utility = experiment
            .neurons()
            .find(|candidate| Some(candidate.id) == *neuron)
            .and_then(|neuron| neuron.utility);
        if first_visit {
            assert!((utility.unwrap_or(f64::NAN) - to_goal).abs() < 1e-9, "step {}", position + 1);
        }
    }
}

#[test]
fn a_trial_that_does_not_end_is_capped_and_failed() {
    let settings = with(&[("trial.step_cap", Value::Integer(10))]);
    for trial in records(&settings, 1, 3) {
        assert_eq!((trial.steps, trial.reached_goal, trial.record), (10, false, false));
    }
}

#[test]
fn contradictions_name_the_setting() {
    for (key, value, field) in [
        ("reflex.front_near", 1.0, "reflex.front_near"),
        ("reflex.side_free", 0.05, "reflex.side_near"),
        ("learner.temperature_min", 200.0, "learner.temperature_min"),
    ] {
        let settings = with(&[(key, Value::Number(value))]);
        let error = MinimumCostPath::new(laboratory(), b21(), &settings, 1).expect_err(key);
        assert_eq!(error.field(), field, "{error}");
    }
}
