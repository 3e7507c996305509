use proptest::prelude::*;

use super::*;
use crate::geometry::wrap_angle;
use crate::robot::Contact;
use crate::robot::examples::b21;
use crate::world::examples::{all_files, laboratory_file, room_file, world};

fn robot(settings: SimulationSettings, seed: u64) -> SimulatedRobot {
    SimulatedRobot::new(Arc::new(world(&laboratory_file())), b21(), settings, seed)
}

fn quiet() -> SimulationSettings {
    SimulationSettings { sonar_noise: 0.0, ..SimulationSettings::default() }
}

/// Rotations that lead through the laboratory and into its walls.
fn rotation_rad(step: u32) -> f64 {
    f64::from(step * 7919 % 41) * 0.05 - 1.0
}

/// Poses and readings of a whole trial, as bits.
fn trial_bits(robot: &mut SimulatedRobot, trial0: u32) -> Vec<u64> {
    robot.begin_trial(trial0);
    let mut bits = Vec::new();
    for step in 0..200 {
        let sensed = robot.sense();
        bits.extend(sensed.sonar_m.iter().map(|reading| reading.to_bits()));
        let motion = robot.act(rotation_rad(step));
        let (truth, belief) = (robot.true_pose(), robot.pose());
        bits.extend([truth.x_m, belief.y_m, belief.heading_rad, motion.moved.x].map(f64::to_bits));
    }
    bits
}

#[test]
fn the_same_seed_gives_the_same_bits_whatever_came_before() {
    let settings =
        SimulationSettings { odometry_drift: 0.02, sonar_dropout: 0.1, ..Default::default() };
    let mut first = robot(settings.clone(), 7);
    let bits = trial_bits(&mut first, 3);
    trial_bits(&mut first, 4);
    assert_eq!(trial_bits(&mut first, 3), bits);
    assert_eq!(trial_bits(&mut robot(settings.clone(), 7), 3), bits);
    assert_ne!(trial_bits(&mut robot(settings.clone(), 7), 2), bits);
    assert_ne!(trial_bits(&mut robot(settings, 8), 3), bits);
}

#[test]
fn a_new_robot_is_ready_for_the_first_trial() {
    let mut fresh = robot(SimulationSettings::default(), 7);
    let mut begun = fresh.clone();
    begun.begin_trial(0);
    assert_eq!(fresh.sense(), begun.sense());
}

#[test]
fn readings_without_noise_are_the_distances_and_with_noise_scatter_about_them() {
    let room = Arc::new(world(&room_file(4.0, 4.0)));
    let mut quiet = SimulatedRobot::new(room.clone(), b21(), quiet(), 1);
    let exact = quiet.sense();
    assert_eq!(exact, quiet.sense());
    for sonar in [0, 6, 12, 18] {
        assert!((exact.sonar_m[sonar] - 1.735).abs() < 1e-12, "sonar {sonar}");
    }
    let mut noisy = SimulatedRobot::new(room, b21(), SimulationSettings::default(), 1);
    let errors: Vec<f64> = (0..400)
        .flat_map(|_| {
            let (noisy, exact) = (noisy.sense().sonar_m, exact.sonar_m);
            let errors =
                noisy.iter().zip(exact.iter()).map(|(reading, exact)| reading / exact - 1.0);
            errors.collect::<Vec<f64>>()
        })
        .collect();
    let count = errors.len() as f64;
    let mean = errors.iter().sum::<f64>() / count;
    let deviation = (errors.iter().map(|error| error * error).sum::<f64>() / count).sqrt();
    assert!(mean.abs() < 5e-4, "mean {mean}");
    assert!((deviation - 0.01).abs() < 5e-4, "deviation {deviation}");
}

#[test]
fn a_missed_echo_reads_the_range() {
    let settings = SimulationSettings { sonar_dropout: 0.25, ..SimulationSettings::default() };
    let mut robot = robot(settings, 1);
    let readings: Vec<f64> = (0..400).flat_map(|_| robot.sense().sonar_m.to_vec()).collect();
    let missed = readings.iter().filter(|reading| **reading >= 8.0).count() as f64;
    assert!((missed / readings.len() as f64 - 0.25).abs() < 0.02, "{missed}");
}

#[test]
fn the_reflectance_crosses_the_threshold_at_10_cm() {
    let settings = SimulationSettings::default();
    assert!((settings.virtual_collision_m() - 0.1).abs() < 1e-12);
    for (clearance_m, expected) in
        [(-0.1, 87.5), (0.0, 87.5), (0.1, 70.0), (0.25, 43.75), (0.5, 0.0), (3.0, 0.0)]
    {
        let found = settings.reflectance_pct(clearance_m);
        assert!((found - expected).abs() < 1e-9, "{clearance_m}: {found}");
    }
}

#[test]
fn driving_at_a_wall_ends_in_a_virtual_collision_and_a_rescue() {
    let mut robot = SimulatedRobot::new(Arc::new(world(&room_file(4.0, 4.0))), b21(), quiet(), 1);
    for step in 0..8 {
        let motion = robot.act(0.0);
        assert_eq!((motion.contact, motion.backed_m), (Contact::None, 0.0), "step {step}");
    }
    let motion = robot.act(0.0);
    assert_eq!(motion.contact, Contact::Virtual);
    assert!((motion.advanced_m - 0.04).abs() < 1e-12 && (motion.backed_m - 0.1).abs() < 1e-12);
    assert!((motion.moved - Vec2::new(-0.06, 0.0)).norm() < 1e-12);
    assert!((robot.true_pose().x_m - 1.54).abs() < 1e-12);
    assert_eq!(robot.true_pose().heading_rad.to_bits(), 0.0_f64.to_bits());
    assert!((robot.shell_clearance_m() - 0.195).abs() < 1e-12);
    assert!((robot.sense().reflectance_pct - 87.5 * (1.0 - 0.195 / 0.5)).abs() < 1e-9);
}

#[test]
fn without_drift_the_belief_is_true_to_the_bit() {
    let mut robot = robot(quiet(), 1);
    for step in 0..5000 {
        robot.act(rotation_rad(step));
        assert_eq!(robot.pose(), robot.true_pose(), "step {step}");
    }
}

#[test]
fn with_drift_the_turn_is_off_and_the_way_is_mismeasured() {
    let k = 0.02;
    let settings = SimulationSettings { odometry_drift: k, ..quiet() };
    let mut robot =
        SimulatedRobot::new(Arc::new(world(&room_file(30.0, 30.0))), b21(), settings, 1);
    let (mut turns, mut ways) = (Vec::new(), Vec::new());
    for trial0 in 0..80 {
        robot.begin_trial(trial0);
        for commanded_rad in [0.5, -0.5].repeat(25) {
            let before = robot.true_pose();
            let motion = robot.act(commanded_rad);
            let turned_rad = wrap_angle(robot.true_pose().heading_rad - before.heading_rad);
            turns.push(turned_rad - commanded_rad);
            ways.push(motion.moved.norm() / motion.advanced_m - 1.0);
        }
    }
    let deviation = |errors: &[f64]| {
        (errors.iter().map(|error| error * error).sum::<f64>() / errors.len() as f64).sqrt()
    };
    // Two independent parts: k of half a radian, and 0.2 k.
    let expected = k * (0.25_f64 + 0.04).sqrt();
    assert!((deviation(&turns) / expected - 1.0).abs() < 0.05, "{}", deviation(&turns));
    assert!((deviation(&ways) / k - 1.0).abs() < 0.05, "{}", deviation(&ways));
}

#[test]
fn the_goal_counts_where_the_robot_is_not_where_it_believes_to_be() {
    let mut file = room_file(6.0, 6.0);
    file.goal.radius_m = 0.3;
    let mut robot = SimulatedRobot::new(Arc::new(world(&file)), b21(), quiet(), 1);
    assert!(robot.at_goal());
    robot.act(0.0);
    assert!(robot.at_goal());
    robot.act(0.0);
    assert!(!robot.at_goal());
}

proptest! {
    #[test]
    fn the_shell_never_meets_a_wall(
        world_index in 0..3usize,
        rotations in prop::collection::vec(-3.2..3.2f64, 200),
        drift in 0.0..0.1f64,
        // Below 0.7 the infrared sensors never warn, and the tactile ring has to.
        infrared_reflectance in 0.6..1.0f64,
    ) {
        let settings =
            SimulationSettings { infrared_reflectance, odometry_drift: drift, ..SimulationSettings::default() };
        let world = Arc::new(world(&all_files()[world_index]));
        let mut robot = SimulatedRobot::new(world.clone(), b21(), settings, 1);
        for rotation_rad in rotations {
            let motion = robot.act(rotation_rad);
            let clearance_m = world.clearance_m(robot.true_pose().position()) - 0.265;
            prop_assert!(clearance_m > 0.0, "{} after {:?}", clearance_m, motion);
            prop_assert_eq!(clearance_m.to_bits(), robot.shell_clearance_m().to_bits());
        }
    }
}
