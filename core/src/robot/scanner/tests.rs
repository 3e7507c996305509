use super::*;
use crate::rng::{Purpose, stream};
use crate::robot::examples::{trc, trc_file};
use crate::robot::{Robot, RobotError};
use crate::world::{Arena, Ring, Surface};

/// A floor whose walls are out of range but for the one ahead, at x = 0.
fn near(pose: &Pose) -> Near {
    let points =
        [[-30.0, -30.0], [0.0, -30.0], [0.0, 30.0], [-30.0, 30.0]].map(Vec2::from).to_vec();
    let arena = Arena::new(vec![Ring { points, surfaces: vec![Surface::Wall; 4] }]).expect("sound");
    let mut near = Near::default();
    arena.note_near(pose.position(), 3.0, &mut near);
    near
}

fn scanner(noise: NoiseLevel, order: FiringOrder, seed: u64) -> Scanner {
    let trc = trc();
    let spec = &trc.equipment().expect("equipped").scanner;
    Scanner::new(spec, trc.sonars(), order, noise, stream(seed, 0, Purpose::Echo))
}

/// Readings of so many cycles of a robot that stands.
fn cycles(scanner: &mut Scanner, pose: &Pose, count: u32) -> Vec<Vec<Reading>> {
    let near = near(pose);
    let cycle = |cycle: u32| {
        for slot in 0..16_u32 {
            let time_s = f64::from(cycle * 16 + slot + 1) * 0.025;
            scanner.fire(slot as usize, time_s, pose, &near, &[]);
        }
        scanner.readings().to_vec()
    };
    (0..count).map(cycle).collect()
}

/// How often a share of so many independent readings comes out, within four deviations.
fn is_share(found: usize, of: usize, expected: f64) -> bool {
    let of = of as f64;
    let spread = (expected * (1.0 - expected) / of).sqrt();
    (found as f64 / of - expected).abs() <= 4.0 * spread
}

#[test]
fn ideal_sonars_read_the_distance_along_their_rays() {
    // The front at 1 m: sonars 4 and 5 look straight at the wall within a ray's spacing, sonars 3 and 6
    // at 11° to it at least, and those at the sides not at all within 2 m.
    let pose = Pose::new(-1.375, 0.0, 0.0);
    let readings = &cycles(&mut scanner(NoiseLevel::IDEAL, FiringOrder::Staggered, 1), &pose, 1)[0];
    let ranges: Vec<f64> = readings.iter().map(|reading| reading.range_m).collect();
    for (sonar, expected) in [(4, 1.0), (3, 1.0 / 11_f64.to_radians().cos())] {
        assert!((ranges[sonar] - expected).abs() < 1e-3, "{sonar}: {}", ranges[sonar]);
        assert!((ranges[9 - sonar] - ranges[sonar]).abs() < 1e-9, "mirrored");
    }
    // Sonar 0 at 60°: its ray at 45° meets the wall after (1 + 0.05) √2.
    assert!((ranges[0] - 1.05 * 2_f64.sqrt()).abs() < 1e-9);
}

#[test]
fn what_a_wall_far_aside_returns_is_lost() {
    let pose = Pose::new(-1.375, 0.0, 0.0);
    let readings =
        &cycles(&mut scanner(NoiseLevel::times(0.0), FiringOrder::Staggered, 1), &pose, 1)[0];
    let echoes: Vec<Echo> = readings.iter().map(|reading| reading.echo).collect();
    let (heard, none) = (Echo::Surface, Echo::None);
    // Axes of 60, 51 and 40°, cones to 45, 36 and 25°: beyond the critical 30° nothing comes back.
    assert_eq!(echoes, [none, none, heard, heard, heard, heard, heard, heard, none, none]);
}

#[test]
fn noises_are_as_frequent_as_the_file_says() {
    let pose = Pose::new(-1.375, 0.0, 0.0);
    let count = 4000;
    let of = |noise: NoiseLevel, sonar: usize, echo: Echo| {
        let readings = cycles(&mut scanner(noise, FiringOrder::Staggered, 3), &pose, count);
        readings.iter().filter(|cycle| cycle[sonar].echo == echo).count()
    };
    let only = |crosstalk: f64, spurious: f64, dropout: f64| NoiseLevel {
        crosstalk,
        spurious,
        dropout,
        ..NoiseLevel::times(0.0)
    };
    let count = count as usize;
    assert!(is_share(of(only(0.0, 0.0, 4.0), 4, Echo::Dropped), count, 0.08));
    assert!(is_share(of(only(0.0, 4.0, 0.0), 4, Echo::Spurious), count, 0.04));
    // Sonar 5 is fired after a slot that is not used, so it never hears another.
    assert_eq!(of(only(8.0, 0.0, 0.0), 5, Echo::Ghost), 0);
    assert!(of(only(8.0, 0.0, 0.0), 4, Echo::Ghost) > 0);
}

#[test]
fn echoes_vary_as_much_as_the_file_says() {
    let pose = Pose::new(-1.375, 0.0, 0.0);
    let readings =
        cycles(&mut scanner(NoiseLevel::times(0.0), FiringOrder::Staggered, 3), &pose, 4000);
    let errors: Vec<f64> = readings.iter().map(|cycle| cycle[4].range_m - 1.0).collect();
    let variance = crate::stats::variance(&errors).expect("many");
    // 0.01 m + 0.01 of 1 m; a sample of 4000 gives a deviation to 1/√8000.
    assert!((variance.sqrt() / 0.02 - 1.0).abs() < 4.0 / 8000_f64.sqrt(), "{}", variance.sqrt());
}

#[test]
fn crosstalk_begins_by_the_angle_and_lasts_by_chance() {
    // Naive order at level 1: sonar 1 follows sonar 0, 9° apart.
    let pose = Pose::new(-20.0, 0.0, 0.0);
    let noise = NoiseLevel { spurious: 0.0, dropout: 0.0, ..NoiseLevel::times(1.0) };
    let mut scanner = scanner(noise, FiringOrder::Naive, 5);
    let readings = cycles(&mut scanner, &pose, 20_000);
    let haunted = |cycle: &Vec<Reading>| cycle[1].echo == Echo::Ghost;
    let pairs = || readings.iter().zip(&readings[1..]);
    let free = pairs().filter(|(before, _)| !haunted(before)).count();
    let began = pairs().filter(|(before, now)| !haunted(before) && haunted(now)).count();
    // A ghost beyond the greatest reading is none to be seen; 1 in 1.85 m / 0.03 m at most.
    let expected = 0.1 * (-9.0_f64 / 30.0).exp();
    assert!(
        is_share(began, free, expected)
            || (began as f64 / free as f64 / expected - 1.0).abs() < 0.1
    );
    let on = pairs().filter(|(before, _)| haunted(before)).count();
    let ended = pairs().filter(|(before, now)| haunted(before) && !haunted(now)).count();
    // Over in a cycle of 0.4 s with probability 1 − e^(−0.4/2), unless it begins anew at once.
    let expected = (1.0 - (-0.2_f64).exp()) * (1.0 - expected);
    assert!(
        (ended as f64 / on as f64 / expected - 1.0).abs() < 0.15,
        "{ended} of {on}, {expected}"
    );
}

#[test]
fn a_silent_sonar_neither_hears_nor_is_heard() {
    let pose = Pose::new(-1.375, 0.0, 0.0);
    let mut scanner = scanner(NoiseLevel::times(8.0), FiringOrder::Naive, 5);
    scanner.silence(3, true);
    let readings = cycles(&mut scanner, &pose, 500);
    assert!(readings.iter().all(|cycle| cycle[3].echo == Echo::Silent));
    assert!(
        readings.iter().all(|cycle| cycle[4].echo != Echo::Ghost),
        "only sonar 3 comes before it"
    );
}

#[test]
fn successive_sonars_sit_far_apart_when_staggered() {
    let trc = trc();
    let orders = &trc.equipment().expect("equipped").scanner.orders;
    let least = |fired: &[usize]| fired.windows(2).map(|pair| pair[0].abs_diff(pair[1])).min();
    // Five positions apart is the best there is for ten.
    assert_eq!(least(orders.of(FiringOrder::Staggered)), Some(5));
    assert_eq!(least(orders.of(FiringOrder::Naive)), Some(1));
}

#[test]
fn equipment_that_does_not_fit_is_refused_with_the_field() {
    let refused = |change: fn(&mut crate::robot::Equipment)| -> RobotError {
        let mut file = trc_file();
        change(file.equipment.as_mut().expect("equipped"));
        Robot::new(&file).expect_err("refused")
    };
    for (error, field) in [
        (refused(|e| e.scanner.dropout = 1.5), "equipment.scanner.dropout"),
        (refused(|e| e.scanner.range_m = f64::NAN), "equipment.scanner.range_m"),
        (refused(|e| e.scanner.rays = 1), "equipment.scanner.rays"),
        (refused(|e| e.drive.time_constant_s = 0.0), "equipment.drive.time_constant_s"),
        (refused(|e| e.bumper.free_m = -1.0), "equipment.bumper.free_m"),
        (refused(|e| e.scanner.orders.naive[0] = 1), "equipment.scanner.orders"),
        (refused(|e| e.scanner.slots = 9), "equipment.scanner.orders"),
    ] {
        assert_eq!(error.field(), field, "{error}");
        assert!(error.to_string().contains(field), "{error}");
    }
}
