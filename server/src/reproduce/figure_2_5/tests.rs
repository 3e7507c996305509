use std::sync::atomic::{AtomicU32, Ordering};

use super::super::Kept;
use super::*;
use crate::wire::Verdict;

const RUNS: u64 = 60;

fn rows(arms: &'static [Arm]) -> Vec<ReproductionRow> {
    let target = Target { arms, seeds: 700_000..=700_000 + RUNS - 1, ..FIGURE_2_5.clone() };
    target.run(2, &Kept::default(), &|| ()).expect("every arm fits").rows
}

fn row<'a>(rows: &'a [ReproductionRow], name: &str) -> &'a ReproductionRow {
    rows.iter().find(|row| row.name == name).unwrap_or_else(|| panic!("{name} is missing"))
}

/// Holds means against those of the reconstruction, each with its standard deviation over 300 runs, within
/// five deviations of the difference of two means and half a printed digit.
fn near(rows: &[ReproductionRow], expected: &[(&str, f64, f64, f64)]) {
    for (name, mean, deviation, digit) in expected {
        let found = row(rows, name);
        let most = 5.0 * deviation * (1.0 / RUNS as f64 + 1.0 / 300.0).sqrt() + 0.5 * digit;
        assert!((found.ours - mean).abs() <= most, "{found:?}, expected {mean} ± {most}");
    }
}

#[test]
fn without_false_echoes_the_minimum_is_the_better_of_two_lines() {
    let rows = rows(&ARMS[1..2]);
    near(
        &rows,
        &[
            ("x0: minimum, error", 0.019, 0.002, 0.001),
            ("x0: median and Kalman, error", 0.088, 0.002, 0.001),
            ("x0: minimum and Kalman, error", 0.067, 0.002, 0.001),
            ("x0: median alone, error", 0.032, 0.002, 0.001),
        ],
    );
    let line = row(&rows, "x0: minimum, R² of a line");
    assert!(line.ours > 0.998 && line.verdict == Verdict::Differs, "it does not fail: {line:?}");
    let linear = row(&rows, "x0: median and Kalman, R² of a line");
    assert!(linear.ours > 0.998 && linear.verdict == Verdict::Agrees, "{linear:?}");
    let better = row(&rows, "x0: error of the minimum less that of the median and Kalman");
    assert_eq!(better.verdict, Verdict::Differs);
}

#[test]
fn under_false_echoes_the_minimum_fails_and_the_median_does_not() {
    let rows = rows(&ARMS[3..4]);
    near(
        &rows,
        &[
            ("x4: minimum, R² of a line", 0.663, 0.210, 0.001),
            ("x4: minimum and Kalman, R² of a line", 0.784, 0.206, 0.001),
            ("x4: median alone, R² of a line", 0.960, 0.066, 0.001),
            ("x4: median and Kalman, R² of a line", 0.985, 0.037, 0.001),
            ("x4: minimum, error", 0.350, 0.143, 0.001),
            ("x4: median and Kalman, error", 0.095, 0.029, 0.001),
        ],
    );
    for name in ["minimum, R² of a line", "median and Kalman, R² of a line"] {
        assert_eq!(row(&rows, &format!("x4: {name}")).verdict, Verdict::Agrees, "{name}");
    }
}

#[test]
fn staggering_keeps_ghosts_away() {
    const ORDERS: &[Arm] = &[ARMS[2], ARMS[4]];
    let rows = rows(ORDERS);
    // The reconstruction: 3.0 % staggered, 23 % from the left to the right. Runs of 18 s differ much.
    let [staggered, naive] = ["x1", "x1, naive order"]
        .map(|arm| row(&rows, &format!("{arm}: sonars that hear a ghost")));
    assert!((staggered.ours - 3.0).abs() < 1.5, "{staggered:?}");
    assert!((naive.ours - 23.0).abs() < 4.0, "{naive:?}");
}

#[test]
fn the_curves_are_one_run_and_every_run_counts() {
    let target = Target { arms: &ARMS[..1], seeds: 700_000..=700_002, ..FIGURE_2_5.clone() };
    let told = AtomicU32::new(0);
    let count = || {
        told.fetch_add(1, Ordering::Relaxed);
    };
    let findings = target.run(2, &Kept::default(), &count).expect("it fits");
    assert_eq!(told.into_inner(), target.work());
    assert_eq!(findings.curves.len(), 3);
    // 1.8 m at 0.1 m/s are 45 cycles of 0.4 s; each ends 4 cm nearer.
    let distance = &findings.curves[0].points;
    assert_eq!(distance.len(), 45);
    for (cycle, point) in distance.iter().enumerate() {
        let (time_s, distance_m) = (0.4 * (cycle + 1) as f64, 2.0 - 0.04 * (cycle + 1) as f64);
        assert!((point.x - time_s).abs() < 1e-9, "{point:?}");
        assert!((point.mean.expect("known") - distance_m).abs() < 1e-9, "{point:?}");
    }
}
