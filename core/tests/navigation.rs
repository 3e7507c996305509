//! The experiments of chapter 2 against figures measured with an independent prototype.
//!
//! The figures, means and standard deviations over 300 approaches and 40 corridors, come from another
//! program with random numbers of its own; ours must lie as near to them as two samples of that size do.
#![expect(clippy::unwrap_used, reason = "a test says where it fails")]

use std::sync::Arc;

use sonarium_core::control::navigator;
use sonarium_core::experiment::{
    ApproachEnd, ApproachRun, BlockLayout, BlockStart, BlockWorldSettings, CorridorSettings, Cycle,
    NavigationError, NavigationRun, RunEnd, WallApproachSettings,
};
use sonarium_core::fuzzy::RuleBase;
use sonarium_core::perception::{MedianRank, Method};
use sonarium_core::robot::{Echo, FiringOrder, Robot, RobotFile};
use sonarium_core::settings::Value;

fn trc() -> Robot {
    let file: RobotFile = toml::from_str(include_str!("../../assets/robots/trc.toml")).unwrap();
    Robot::new(&file).unwrap()
}

fn rules() -> Arc<RuleBase> {
    Arc::new(RuleBase::parse(include_str!("../../assets/rules/navigator.rules")).unwrap())
}

fn mean_and_deviation(sample: &[f64]) -> (f64, f64) {
    let count = sample.len() as f64;
    let mean = sample.iter().sum::<f64>() / count;
    let squares: f64 = sample.iter().map(|value| (value - mean) * (value - mean)).sum();
    (mean, (squares / (count - 1.0)).sqrt())
}

// ---- wall-approach ----

fn approaches(settings: &WallApproachSettings, seeds: u64) -> Vec<ApproachEnd> {
    let robot = trc();
    let approach = |seed| {
        let mut run = ApproachRun::new(&robot, settings, 1000 + seed).unwrap();
        loop {
            if let (_, Some(end)) = run.step() {
                return end.clone();
            }
        }
    };
    (0..seeds).map(approach).collect()
}

/// Mean and standard deviation of RMS error and R², and mean of the total variation with its deviation.
type Row = (Method, [(f64, f64); 3]);

/// Section 2.5 by the prototype, with the last half unit of what is printed as slack.
fn check_approach(name: &str, settings: &WallApproachSettings, rows: &[Row], seeds: u64) {
    let ends = approaches(settings, seeds);
    for end in &ends {
        assert_eq!(end.cycles, 45, "{name}");
        assert!((end.true_variation_m - 1.76).abs() < 1e-9, "{name}");
    }
    for (method, expected) in rows {
        let scores = || ends.iter().map(|end| end.scores[*method as usize]);
        let found: [Vec<f64>; 3] = [
            scores().map(|score| score.rms_m).collect(),
            scores().map(|score| score.r2).collect(),
            scores().map(|score| score.variation_m).collect(),
        ];
        for (which, (found, (expected, deviation))) in found.iter().zip(expected).enumerate() {
            let (mean, _) = mean_and_deviation(found);
            let slack = if which == 2 { 0.005 } else { 0.0005 };
            let spread = deviation * (1.0 / seeds as f64 + 1.0 / 300.0).sqrt();
            // Four deviations of the difference of two means, for three figures of some thirty rows.
            assert!(
                (mean - expected).abs() <= 4.0 * spread + 2.0 * slack,
                "{name} {method:?} figure {which}: {mean} against {expected} ± {spread}"
            );
        }
    }
}

fn level(noise: f64) -> WallApproachSettings {
    WallApproachSettings { noise, ..WallApproachSettings::default() }
}

fn check_approaches(seeds: u64) {
    use Method::{Median, MedianKalman, Minimum, MinimumKalman};
    let ideal = WallApproachSettings { ideal: true, ..level(0.0) };
    let naive = WallApproachSettings { order: FiringOrder::Naive, ..level(4.0) };
    let upper = WallApproachSettings { rank: MedianRank::Upper, ..level(4.0) };
    let short = WallApproachSettings { window: 2, ..level(4.0) };
    let tables: [(&str, WallApproachSettings, &[Row]); 8] = [
        (
            "ideal",
            ideal,
            &[
                (Minimum, [(0.015, 0.0), (1.0, 0.0), (1.76, 0.0)]),
                (MinimumKalman, [(0.073, 0.0), (1.0, 0.0), (1.70, 0.0)]),
                (Median, [(0.035, 0.0), (1.0, 0.0), (1.77, 0.0)]),
                (MedianKalman, [(0.093, 0.0), (1.0, 0.0), (1.71, 0.0)]),
            ],
        ),
        (
            "x0",
            level(0.0),
            &[
                (Minimum, [(0.019, 0.002), (0.999, 0.0), (1.81, 0.05)]),
                (MinimumKalman, [(0.067, 0.002), (0.999, 0.0), (1.70, 0.02)]),
                (Median, [(0.032, 0.002), (0.999, 0.0), (1.79, 0.03)]),
                (MedianKalman, [(0.088, 0.002), (0.999, 0.0), (1.71, 0.01)]),
            ],
        ),
        (
            "x1",
            level(1.0),
            &[
                (Minimum, [(0.151, 0.126), (0.890, 0.155), (3.68, 1.65)]),
                (MinimumKalman, [(0.118, 0.095), (0.937, 0.128), (2.26, 0.64)]),
                (Median, [(0.038, 0.023), (0.996, 0.017), (1.88, 0.34)]),
                (MedianKalman, [(0.088, 0.005), (0.998, 0.006), (1.73, 0.10)]),
            ],
        ),
        (
            "x2",
            level(2.0),
            &[
                (Minimum, [(0.232, 0.139), (0.805, 0.190), (5.22, 1.93)]),
                (MedianKalman, [(0.089, 0.015), (0.995, 0.020), (1.77, 0.20)]),
            ],
        ),
        (
            "x4",
            level(4.0),
            &[
                (Minimum, [(0.350, 0.143), (0.663, 0.210), (7.38, 2.34)]),
                (MinimumKalman, [(0.258, 0.145), (0.784, 0.206), (3.34, 0.79)]),
                (Median, [(0.087, 0.068), (0.960, 0.066), (2.87, 1.24)]),
                (MedianKalman, [(0.095, 0.029), (0.985, 0.037), (1.94, 0.34)]),
            ],
        ),
        ("x4, upper", upper, &[(MedianKalman, [(0.145, 0.042), (0.977, 0.028), (2.12, 0.43)])]),
        ("x4, three", short, &[(MedianKalman, [(0.084, 0.037), (0.982, 0.041), (2.05, 0.44)])]),
        (
            "x4, naive",
            naive,
            &[
                (Minimum, [(0.679, 0.119), (0.254, 0.186), (6.80, 2.03)]),
                (MedianKalman, [(0.302, 0.130), (0.722, 0.210), (3.19, 0.73)]),
            ],
        ),
    ];
    for (name, settings, rows) in tables {
        check_approach(name, &settings, rows, seeds);
    }
}

#[test]
fn approaches_are_those_of_the_prototype() {
    check_approaches(30);
}

#[test]
#[ignore = "300 approaches at eight levels; run in release"]
fn three_hundred_approaches_are_those_of_the_prototype() {
    check_approaches(300);
}

#[test]
fn staggering_keeps_crosstalk_away() {
    // Shares of time in crosstalk by the prototype: 3.0 % against 23 %, and 11.6 against 57.
    for (noise, order, expected) in [
        (1.0, FiringOrder::Staggered, 0.030),
        (1.0, FiringOrder::Naive, 0.23),
        (4.0, FiringOrder::Staggered, 0.116),
        (4.0, FiringOrder::Naive, 0.57),
    ] {
        let settings = WallApproachSettings { order, ..level(noise) };
        let ends = approaches(&settings, 100);
        let haunted: Vec<f64> = ends.iter().map(|end| end.haunted).collect();
        let (mean, deviation) = mean_and_deviation(&haunted);
        let spread = deviation * (1.0_f64 / 100.0 + 1.0 / 300.0).sqrt();
        assert!((mean - expected).abs() < 4.0 * spread + 0.005, "x{noise} {order:?}: {mean}");
    }
}

// ---- corridor ----

fn end_of(mut run: NavigationRun) -> RunEnd {
    loop {
        if let (_, Some(end)) = run.step() {
            return end.clone();
        }
    }
}

fn corridors(settings: &CorridorSettings, seeds: u64) -> Vec<RunEnd> {
    let (robot, rules) = (trc(), rules());
    let drive = |seed| {
        end_of(NavigationRun::corridor(&robot, Arc::clone(&rules), settings, 100 + seed).unwrap())
    };
    (0..seeds).map(drive).collect()
}

fn corridor(noise: f64, method: Method) -> CorridorSettings {
    CorridorSettings { noise, method, ..CorridorSettings::default() }
}

/// Whether two shares differ no more than two samples of one share do, once in some thousand.
fn same_share(found: usize, of: usize, expected: usize, of_expected: usize) -> bool {
    let share = |count: usize, of: usize| count as f64 / of as f64;
    let pooled = share(found + expected, of + of_expected);
    let spread = (pooled * (1.0 - pooled) * (1.0 / of as f64 + 1.0 / of_expected as f64)).sqrt();
    (share(found, of) - share(expected, of_expected)).abs() <= 3.3 * spread + 1e-12
}

/// Runs done of 40 by the prototype, at each level, by the minimum.
const MINIMUM_DONE: [(f64, usize); 8] =
    [(0.0, 40), (0.5, 38), (1.0, 32), (2.0, 25), (3.0, 22), (4.0, 10), (6.0, 1), (8.0, 0)];

fn check_corridors(levels: &[f64], seeds: u64) {
    for (noise, done) in MINIMUM_DONE.into_iter().filter(|(noise, _)| levels.contains(noise)) {
        let ends = corridors(&corridor(noise, Method::MedianKalman), seeds);
        for end in &ends {
            assert!(end.done && end.doors == 3 && end.straightness > 0.98, "x{noise}: {end:?}");
            assert!((end.progress_m - 96.3).abs() < 0.1, "x{noise}: {end:?}");
        }
        let ends = corridors(&corridor(noise, Method::Minimum), seeds);
        let found = ends.iter().filter(|end| end.done).count();
        assert!(same_share(found, ends.len(), done, 40), "x{noise} minimum: {found} of {seeds}");
    }
}

#[test]
fn median_and_kalman_drive_down_the_corridor_and_the_minimum_does_not() {
    check_corridors(&[0.0, 6.0], 4);
}

#[test]
#[ignore = "40 corridors by two methods at eight levels; run in release"]
fn forty_corridors_are_those_of_the_prototype() {
    check_corridors(&MINIMUM_DONE.map(|(noise, _)| noise), 40);
}

#[test]
fn a_run_is_repeated_to_the_bit_whatever_was_before() {
    let settings =
        CorridorSettings { length_m: 12.0, doors: 1, ..corridor(4.0, Method::MedianKalman) };
    let (robot, rules) = (trc(), rules());
    let new = || NavigationRun::corridor(&robot, Arc::clone(&rules), &settings, 7).unwrap();
    let second_run = |mut run: NavigationRun| {
        let mut cycles: Vec<Cycle> = Vec::new();
        while run.runs_done() < 2 {
            cycles.push(run.step().0.clone());
        }
        cycles
    };
    let mut run = new();
    assert_eq!(run.checkpoint().unwrap().runs_done(), 0);
    while run.runs_done() < 1 {
        run.step();
        assert!(run.checkpoint().is_none() || run.runs_done() == 1);
    }
    let checkpoint = run.checkpoint().unwrap();
    let text = serde_json::to_string(&checkpoint).unwrap();
    let resumed = new().resumed(&serde_json::from_str(&text).unwrap()).unwrap();
    assert_eq!(second_run(run), second_run(resumed));
}

#[test]
fn the_method_can_be_changed_during_a_run() {
    let settings = corridor(4.0, Method::Minimum);
    let mut run = NavigationRun::corridor(&trc(), rules(), &settings, 3).unwrap();
    let driven = |cycle: &Cycle| {
        let depths = cycle.regions.iter().map(|region| region.depth.unwrap().by(cycle.method));
        let inputs: Vec<f64> = depths.chain([cycle.speed.v_m_s * 100.0]).collect();
        (navigator().evaluate(&inputs), cycle.inference.as_ref().unwrap().outputs)
    };
    for cycle in 0..40 {
        if cycle == 20 {
            run.set_method(Method::MedianKalman);
        }
        let (cycle, _) = run.step();
        let expected = if cycle.cycle <= 20 { Method::Minimum } else { Method::MedianKalman };
        assert_eq!(cycle.method, expected);
        let (again, found) = driven(cycle);
        for (again, found) in again.into_iter().zip(found) {
            assert!((again - found).abs() < 1e-9, "{cycle:?}");
        }
    }
}

#[test]
fn a_silent_sonar_is_left_out_and_a_blind_region_stops_the_robot() {
    let mut run =
        NavigationRun::corridor(&trc(), rules(), &corridor(1.0, Method::MedianKalman), 3).unwrap();
    for _ in 0..20 {
        run.step();
    }
    run.silence(0, true);
    let (cycle, _) = run.step();
    assert_eq!(cycle.readings[0].echo, Echo::Silent);
    assert_eq!(cycle.regions[0].depth.unwrap().live, 2);
    assert_eq!(cycle.blind, None);
    run.silence(1, true);
    run.silence(2, true);
    let (cycle, end) = run.step();
    assert!(cycle.blind == Some(0) && cycle.inference.is_none() && end.is_none());
    assert_eq!((cycle.command.v_m_s, cycle.command.w_rad_s), (0.0, 0.0));
    let stopped = (0..20).find_map(|_| run.step().1.cloned()).unwrap();
    assert!(stopped.blind == Some(0) && !stopped.done);
}

#[test]
fn what_does_not_fit_is_named() {
    let b21: RobotFile = toml::from_str(include_str!("../../assets/robots/b21.toml")).unwrap();
    let b21 = Robot::new(&b21).unwrap();
    let with = |change: fn(&mut CorridorSettings)| {
        let mut settings = CorridorSettings::default();
        change(&mut settings);
        NavigationRun::corridor(&trc(), rules(), &settings, 1)
    };
    let small = "rules small\ninput x m 0 2\n all trapezoid -inf -inf inf inf\noutput v cm/s -10 15\ntable x -> v\nall -> 0\n";
    let other = Arc::new(RuleBase::parse(&small.replace("-inf -inf inf inf", "0 0 2 2")).unwrap());
    let errors: [(Result<NavigationRun, NavigationError>, &str); 6] = [
        (with(|s| s.door_width_m = 2.4), "corridor.door_width"),
        (with(|s| (s.length_m, s.doors) = (6.0, 3)), "corridor.doors"),
        (with(|s| s.start_m = 99.0), "start.place"),
        (with(|s| s.aside_m = 1.0), "start.aside"),
        (NavigationRun::corridor(&b21, rules(), &CorridorSettings::default(), 1), "robot"),
        (NavigationRun::corridor(&trc(), other, &CorridorSettings::default(), 1), "rules.file"),
    ];
    for (result, field) in errors {
        let error = result.err().unwrap();
        assert_eq!(error.field(), field, "{error}");
        assert!(error.to_string().contains(field), "{error}");
    }
    let mut settings = WallApproachSettings::default();
    assert!(settings.set("fusion.window", &Value::Integer(0)).is_err(), "a window of 0");
    settings.end_m = 3.0;
    let error = ApproachRun::new(&trc(), &settings, 1).err().unwrap();
    assert_eq!(error.field(), "approach.end");
}

#[test]
fn every_number_of_a_cycle_is_kept() {
    let mut run =
        NavigationRun::corridor(&trc(), rules(), &corridor(4.0, Method::MedianKalman), 5).unwrap();
    let mut seen: Vec<Echo> = Vec::new();
    for number in 1..=600 {
        let (cycle, _) = run.step();
        assert_eq!((cycle.tick, cycle.cycle, cycle.run), (number, number as u32, 1));
        assert!((cycle.time_s - 0.4 * number as f64).abs() < 1e-9);
        assert_eq!((cycle.readings.len(), cycle.regions.len(), cycle.people.len()), (10, 5, 5));
        for (region, members) in cycle.regions.iter().zip([0..3, 1..5, 3..7, 5..9, 7..10]) {
            let minimum_m = members.map(|sonar| cycle.readings[sonar].range_m);
            let minimum_m = minimum_m.fold(f64::INFINITY, f64::min);
            assert_eq!(region.depth.unwrap().by(Method::Minimum), minimum_m);
            assert!((0.0..=2.0).contains(&region.truth_m) && region.nees.is_some());
            assert!((region.depth.unwrap().nis.is_some()) == (number > 1));
        }
        let inference = cycle.inference.as_ref().unwrap();
        assert_eq!(inference.memberships.len(), 5 * 3 + 4);
        let strengths: f64 = inference.firings.iter().map(|firing| firing.strength).sum();
        assert!((strengths - 1.0).abs() < 1e-12);
        assert!((cycle.command.v_m_s * 100.0 - inference.outputs[0]).abs() < 1e-12);
        seen.extend(cycle.readings.iter().map(|reading| reading.echo));
    }
    for echo in [Echo::Surface, Echo::None, Echo::Dropped, Echo::Ghost, Echo::Spurious] {
        assert!(seen.contains(&echo), "{echo:?}");
    }
}

// ---- block-world ----

fn blocks(settings: &BlockWorldSettings, seeds: u64) -> Vec<RunEnd> {
    let (robot, rules) = (trc(), rules());
    let drive = |seed| {
        let run = NavigationRun::block_world(&robot, Arc::clone(&rules), settings, 100 + seed);
        end_of(run.unwrap())
    };
    (0..seeds).map(drive).collect()
}

fn random(layout: BlockLayout) -> BlockWorldSettings {
    let start = BlockStart::Random;
    BlockWorldSettings { layout, start, limit_s: 600.0, ..BlockWorldSettings::default() }
}

fn check_blocks(layout: BlockLayout, seeds: u64) -> Vec<RunEnd> {
    let ends = blocks(&random(layout), seeds);
    for end in &ends {
        let contacts = end.wall_contacts + end.block_contacts;
        assert_eq!((contacts, end.cycles), (0, 1500), "{layout:?}: {end:?}");
        assert!(end.clearance_m > 0.05, "{layout:?}: {end:?}");
    }
    ends
}

#[test]
fn the_minimum_drives_safely_among_blocks_with_ideal_sonars() {
    for layout in [BlockLayout::Sparse, BlockLayout::Dense] {
        check_blocks(layout, 3);
    }
    // The prototype's paths: 170 and 162 units of 0.2 m at 10.9 and 10.4 cm/s, 5 % of the cycles
    // backing up. Nothing is drawn at random there, so only roundings may differ.
    for (layout, units, speed_cm_s) in
        [(BlockLayout::Sparse, 170.0, 10.9), (BlockLayout::Dense, 162.0, 10.4)]
    {
        let shown = BlockWorldSettings { layout, ..BlockWorldSettings::default() };
        let end = &blocks(&shown, 1)[0];
        assert_eq!((end.wall_contacts + end.block_contacts, end.cycles), (0, 750));
        assert!((end.path_m / 0.2 - units).abs() <= 1.0, "{layout:?}: {end:?}");
        assert!((100.0 * end.speed_m_s - speed_cm_s).abs() <= 0.06, "{layout:?}: {end:?}");
        assert!((100.0 * end.reverse - 5.0).abs() <= 0.6, "{layout:?}: {end:?}");
    }
}

#[test]
#[ignore = "40 runs of 600 s in each world; run in release"]
fn forty_starts_in_each_block_world_are_those_of_the_prototype() {
    // Mean velocity, cm/s, and percent of the cycles that are slow and that back up.
    let wandered =
        [(BlockLayout::Sparse, [10.5, 13.0, 8.7]), (BlockLayout::Dense, [10.0, 14.0, 7.7])];
    let figures: [fn(&RunEnd) -> f64; 3] =
        [|end| 100.0 * end.speed_m_s, |end| 100.0 * end.slow, |end| 100.0 * end.reverse];
    for (layout, expected) in wandered {
        let ends = check_blocks(layout, 40);
        for (figure, expected) in figures.into_iter().zip(expected) {
            let (mean, deviation) =
                mean_and_deviation(&ends.iter().map(figure).collect::<Vec<_>>());
            // Its deviation is not known: taken as ours. Half a unit of what is printed is slack.
            let spread = deviation * (2.0_f64 / 40.0).sqrt();
            let off = (mean - expected).abs();
            assert!(off <= 3.0 * spread + 0.5, "{layout:?}: {mean} against {expected} ± {spread}");
        }
    }
}
