use super::super::Kept;
use super::*;
use crate::wire::Verdict;

fn run(arms: &'static [Arm], runs: u64) -> Findings {
    let target = Target { arms, seeds: 700_000..=700_000 + runs - 1, ..FIGURE_2_10.clone() };
    target.run(2, &Kept::default(), &|| ()).expect("every arm fits")
}

fn row<'a>(rows: &'a [ReproductionRow], name: &str) -> &'a ReproductionRow {
    rows.iter().find(|row| row.name == name).unwrap_or_else(|| panic!("{name} is missing"))
}

#[test]
fn with_ideal_sonars_it_touches_nothing_but_backs_up() {
    let Findings { rows, pictures, .. } = run(&ARMS[..2], 10);
    let near = |name: &str, expected: f64, most: f64| {
        let found = row(&rows, name);
        assert!((found.ours - expected).abs() <= most, "{found:?}, expected {expected}");
    };
    for arm in ["sparse", "dense"] {
        near(&format!("{arm}: runs without a contact"), 100.0, 0.0);
        let shown = row(&rows, &format!("{arm}: contacts of the run shown"));
        assert_eq!((shown.ours, shown.verdict, shown.n), (0.0, Verdict::Agrees, 0));
        let back = row(&rows, &format!("{arm}: cycles that back up"));
        assert_eq!(back.verdict, Verdict::Differs, "it turns on the spot before walls: {back:?}");
    }
    // The reconstruction, over 40 starts. It gives no deviations; these are wide enough for ten runs.
    near("sparse: velocity", 10.5, 0.8);
    near("sparse: cycles slower than 5 cm/s", 13.0, 5.0);
    near("sparse: cycles that back up", 8.7, 4.0);
    near("sparse: change of the turn in a cycle", 0.52, 0.2);
    near("dense: velocity", 10.0, 0.8);
    near("dense: cycles slower than 5 cm/s", 14.0, 5.0);
    near("dense: cycles that back up", 7.7, 4.0);
    near("dense: change of the turn in a cycle", 0.80, 0.2);
    // 170 and 162 units at 10.9 and 10.4 cm/s; the way is longer than one ride across.
    for (arm, units) in [("sparse", 170.0), ("dense", 162.0)] {
        let way = row(&rows, &format!("{arm}: way of the run shown"));
        assert!((way.ours - units).abs() < 8.0, "{way:?}, expected {units}");
    }
    assert_eq!(pictures.len(), 2);
    let view = &pictures[0].view;
    // 300 s are 750 cycles; 5 blocks and the border have four sides each.
    assert_eq!((view.path_m.len(), view.walls_m.len()), (750, 24));
    assert_eq!(view.bounds_m, [0.0, 0.0, 9.5, 8.0]);
}

#[test]
fn the_median_touches_blocks_in_rows() {
    // The reconstruction: 125 contacts in 40 runs.
    let rows = run(&ARMS[3..], 10).rows;
    let contacts = row(&rows, "dense, median and Kalman: contacts");
    assert!(contacts.ours > 0.5 && contacts.ours < 8.0, "{contacts:?}");
    assert!(row(&rows, "dense, median and Kalman: runs without a contact").ours < 90.0);
}
