//! Targets as their readers rely on them.

use std::collections::BTreeSet;
use std::sync::Barrier;
use std::sync::atomic::{AtomicU32, Ordering};

use super::*;
use crate::wire::Verdict;

/// Table 5.1 over a few of its sets.
fn few_sets() -> Target {
    Target { seeds: 700_000..=700_005, ..TABLE_5_1.clone() }
}

fn run(target: &Target, threads: usize) -> Reproduction {
    target.run(threads, &|| ()).expect("the embedded files fit")
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
    let target = few_sets();
    let trials = |threads, done: &(dyn Fn() + Sync)| {
        sets::last_trials(&catalog, &target, "default", threads, done).expect("they fit")
    };
    // Each waits for the other after a set, so that two threads take the seeds by turns.
    let turn = Barrier::new(2);
    let by_turns = || {
        turn.wait();
    };
    assert_eq!(trials(2, &by_turns), trials(1, &|| ()));
}

#[test]
fn every_set_is_told_and_counts() {
    let sets = AtomicU32::new(0);
    let target = few_sets();
    let count = || {
        sets.fetch_add(1, Ordering::Relaxed);
    };
    let result = target.run(2, &count).expect("the embedded files fit");
    assert_eq!(sets.into_inner(), 3 * target.sets());
    assert!(result.rows.iter().all(|row| row.n == 6), "{:?}", result.rows);
}

#[test]
fn the_seeds_make_the_result() {
    let others = Target { seeds: 700_006..=700_011, ..TABLE_5_1.clone() };
    let figures =
        |target: &Target| run(target, 2).rows.iter().map(|row| row.ours).collect::<Vec<f64>>();
    assert_ne!(figures(&others), figures(&few_sets()), "other seeds, other figures");
    let steps = run(&few_sets(), 2).rows.into_iter().find(|row| row.name.contains("steps, var"));
    assert!(steps.is_some_and(|row| row.ours > 0.0), "each set has a seed of its own");
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
    let target = Target { presets: &["reflex"], seeds: 700_000..=700_011, ..TABLE_5_1.clone() };
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
