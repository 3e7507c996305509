//! Targets as their readers rely on them.

use std::collections::BTreeSet;
use std::sync::Barrier;
use std::sync::atomic::{AtomicU32, Ordering};

use super::*;
use crate::catalog::{MINIMUM_COST_PATH, MINIMUM_COST_PATH_TRC};
use crate::wire::{Reproduction, Verdict};

/// Table 5.1 over a few of its sets.
fn few_sets() -> Target {
    Target { seeds: 700_000..=700_005, ..TABLE_5_1.clone() }
}

fn run(target: &Target, threads: usize) -> Reproduction {
    let findings = target.run(threads, &Kept::default(), &|| ()).expect("the embedded files fit");
    findings.wire(target)
}

#[test]
fn the_result_does_not_depend_on_threads() {
    let alone = run(&few_sets(), 1);
    assert_eq!(run(&few_sets(), 1), alone, "a second time");
    assert_eq!(run(&few_sets(), 5), alone, "five threads");
    assert_eq!(run(&few_sets(), 0), alone, "no thread asked for");
}

#[test]
fn sets_stand_in_the_order_of_their_seeds() {
    let catalog = Catalog::load(None).expect("the embedded files are fine");
    let (target, kept) = (few_sets(), Kept::default());
    let sample = |threads, done: &(dyn Fn() + Sync)| {
        let sets = Sets { catalog: &catalog, threads, kept: &kept, done };
        sets.of(&target, &PRESETS[0]).expect("they fit").sets
    };
    // Each waits for the other after a set, so that two threads take the seeds by turns.
    let turn = Barrier::new(2);
    let by_turns = || {
        turn.wait();
    };
    let sets = sample(2, &by_turns);
    assert_eq!(sets, sample(1, &|| ()));
    let seeds: Vec<u64> = sets.iter().map(|set| set.seed).collect();
    assert_eq!(seeds, (700_000..=700_005).collect::<Vec<u64>>());
}

#[test]
fn every_set_is_told_and_counts() {
    let sets = AtomicU32::new(0);
    let target = few_sets();
    let count = || {
        sets.fetch_add(1, Ordering::Relaxed);
    };
    let kept = Kept::default();
    let result = target.run(2, &kept, &count).expect("the embedded files fit");
    assert_eq!(sets.load(Ordering::Relaxed), target.work());
    assert!(result.rows.iter().all(|row| row.n == 6), "{:?}", result.rows);
    let again = target.run(2, &kept, &count).expect("the embedded files fit");
    assert_eq!(again, result, "from what was kept");
    assert_eq!(sets.into_inner(), 2 * target.work(), "those kept are told too");
}

#[test]
fn what_is_kept_serves_nobody_who_asks_for_something_else() {
    let kept = Kept::default();
    let run = |target: &Target| target.run(2, &kept, &|| ()).expect("the embedded files fit").rows;
    let target = Target { arms: &PRESETS[..1], ..few_sets() };
    let rows = run(&target);
    for other in [
        Target { seeds: 700_006..=700_011, ..target.clone() },
        Target { trials: 3, ..target.clone() },
        Target {
            arms: &[Arm { name: "default", settings: &[("sonar.noise", "0.03")] }],
            ..target.clone()
        },
    ] {
        assert_ne!(run(&other), rows, "{other:?}");
    }
}

#[test]
fn a_set_is_the_run_of_its_seed_with_the_way_of_two_trials() {
    let catalog = Catalog::load(None).expect("the embedded files are fine");
    let target = Target { trials: 3, seeds: 700_002..=700_002, ..few_sets() };
    let kept = Kept::default();
    let sets = Sets { catalog: &catalog, threads: 1, kept: &kept, done: &|| () };
    let sample = sets.of(&target, &PRESETS[0]).expect("it fits");
    let set = &sample.sets[0];
    let alone = crate::batch::set(&sample.plan, || ()).expect("it fits");
    let unmeasured =
        |trial: &crate::wire::Trial| crate::wire::Trial { regret: None, ..trial.clone() };
    let trials: Vec<_> = alone.trials.iter().map(unmeasured).collect();
    assert_eq!((set.seed, &set.trials), (alone.seed, &trials));
    for (path_m, trial) in [(&set.first_path_m, &set.trials[0]), (&set.last_path_m, &set.trials[2])]
    {
        assert_eq!(path_m.len(), trial.steps as usize + 1, "home and one place a step");
        assert_eq!(path_m[0], [0.0, 0.0], "from home");
    }
    assert_ne!(set.first_path_m, set.last_path_m);
}

#[test]
fn the_seeds_make_the_result() {
    let others = Target { seeds: 700_006..=700_011, ..TABLE_5_1.clone() };
    let figures =
        |target: &Target| run(target, 2).rows.iter().map(|row| row.ours).collect::<Vec<f64>>();
    assert_ne!(figures(&others), figures(&few_sets()), "other seeds, other figures");
    let spread =
        run(&few_sets(), 2).rows.into_iter().find(|row| row.name.contains("reinforcement, var"));
    assert!(spread.is_some_and(|row| row.ours > 0.0), "each set has a seed of its own");
}

#[test]
fn the_rows_are_table_5_1_under_each_preset() {
    let rows = run(&few_sets(), 2).rows;
    let names: BTreeSet<&str> = rows.iter().map(|row| row.name.as_str()).collect();
    assert_eq!(
        (rows.len(), names.len()),
        (21, 21),
        "three presets, seven rows, each with its name"
    );
    for preset in ["default", "thesis", "reflex"] {
        for (name, published) in [
            ("number of neurons, mean", Some(82.5)),
            ("number of neurons, variance", Some(4.7286)),
            ("number of steps, mean", Some(27.7)),
            ("number of steps, variance", Some(1.9)),
            ("total reinforcement, mean", Some(-6.24)),
            ("total reinforcement, variance", Some(0.8752)),
            ("sets that reached the goal", None),
        ] {
            let row = rows.iter().find(|row| row.name == format!("{preset}: {name}"));
            let row = row.unwrap_or_else(|| panic!("{preset}: {name} is missing"));
            assert_eq!(row.published, published, "{}", row.name);
            assert!(row.low <= row.ours && row.ours <= row.high, "{row:?}");
            assert!(row.reading.contains(preset) && row.reading.contains("700000..700005"));
            assert_eq!(row.verdict, Verdict::CannotTell, "six sets are too few: {row:?}");
        }
    }
}

#[test]
fn the_control_does_not_pass_for_a_learner() {
    let target = Target { arms: &PRESETS[2..], seeds: 700_000..=700_011, ..TABLE_5_1.clone() };
    for row in run(&target, 2).rows {
        let differs = row.name.ends_with("mean");
        assert!(!differs || row.verdict == Verdict::Differs, "{row:?}");
    }
}

#[test]
fn an_unknown_target_is_refused_with_those_there_are() {
    let error = target("table-9.9").expect_err("no such table").to_string();
    assert!(error.contains("table-9.9") && error.contains("`table-5.1`"), "{error}");
}

#[test]
fn names_are_unique_and_every_arm_fits() {
    let catalog = Catalog::load(None).expect("the embedded files are fine");
    let kept = Kept::default();
    let sets = Sets { catalog: &catalog, threads: 1, kept: &kept, done: &|| () };
    let mut names = BTreeSet::new();
    for target in TARGETS {
        assert!(names.insert(target.name), "{} stands twice", target.name);
        let chosen_on = target.seeds.clone().find(|seed| *seed < 700_000);
        assert_eq!(chosen_on, None, "{}: settings were chosen there", target.name);
        let mut arms = BTreeSet::new();
        for arm in target.arms {
            assert!(arms.insert(arm.name), "{}: {} stands twice", target.name, arm.name);
            if [MINIMUM_COST_PATH, MINIMUM_COST_PATH_TRC].contains(&target.experiment) {
                sets.plan(target, arm).unwrap_or_else(|error| panic!("{}: {error}", target.name));
            }
            if target.unit == Unit::Run {
                let plan = sets.drive_plan(target, arm);
                plan.unwrap_or_else(|error| panic!("{}: {error}", target.name));
            }
        }
    }
}

#[test]
fn an_arm_says_what_it_is() {
    let arm = |settings| Arm { name: "", settings }.words();
    assert_eq!(arm(&[]), "Preset default");
    assert_eq!(arm(&[("preset", "thesis")]), "Preset thesis");
    assert_eq!(
        arm(&[("world", "two-obstacles"), ("sonar.noise", "0.03")]),
        "Preset default with world=two-obstacles, sonar.noise=0.03"
    );
}
