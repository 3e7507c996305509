use super::*;
use crate::geometry::Vec2;
use crate::world::examples::{RADIUS_M, all_files, laboratory_file, room_file, world};
use crate::world::{GoalFile, WorldFile};

/// A file with the regions proposed for it.
fn proposed(mut file: WorldFile, most: usize) -> WorldFile {
    file.regions = vec![RegionFile { name: "everywhere".to_owned(), rules: Vec::new() }];
    file.regions = propose_regions(&world(&file), RADIUS_M, most);
    file
}

#[test]
fn the_laboratory_is_cut_at_its_door_and_beside_it() {
    let file = proposed(laboratory_file(), DEFAULT_REGIONS);
    let ours = world(&file);
    let region = |x: f64, y: f64| ours.regions()[ours.region_at(Vec2::new(x, y))].name.as_str();
    // Algorithm 8's regions, but for the door itself, which is only 0.25 m deep.
    for (x, y, expected) in [
        (0.0, 0.0, "home"),
        (-1.0, 2.0, "home"),
        (3.2, -0.6, "home"),
        (3.0, -1.5, "bay"),
        (-1.0, -2.0, "bay"),
        (4.2, -0.4, "goal"),
        (4.0, -2.0, "goal"),
        (4.5, 2.0, "goal"),
    ] {
        assert_eq!(region(x, y), expected, "({x}, {y}): {:?}", file.regions);
    }
}

#[test]
fn every_proposal_can_be_used_and_has_at_most_as_many_regions_as_asked_for() {
    for file in all_files() {
        for most in [1, 2, 3, 4, 8] {
            let file = proposed(file.clone(), most);
            assert!((1..=most).contains(&file.regions.len()));
            world(&file);
        }
    }
}

#[test]
fn a_room_without_joints_is_one_region() {
    let mut file = room_file(6.0, 4.0);
    file.goal = GoalFile { x: 2.0, y: 0.5, radius_m: 0.3 };
    let regions = proposed(file, DEFAULT_REGIONS).regions;
    assert_eq!(regions, [RegionFile { name: "everywhere".to_owned(), rules: Vec::new() }]);
}

#[test]
fn an_angled_corridor_is_cut_at_its_corner() {
    let mut file = room_file(4.0, 4.0);
    // A corridor 2 m wide that runs 8 m to the east and then 8 m to the north.
    file.walls = vec![vec![
        [-1.0, -1.0],
        [7.0, -1.0],
        [7.0, 7.0],
        [5.0, 7.0],
        [5.0, 1.0],
        [-1.0, 1.0],
        [-1.0, -1.0],
    ]];
    file.goal = GoalFile { x: 6.0, y: 6.0, radius_m: 0.3 };
    let file = proposed(file, DEFAULT_REGIONS);
    let ours = world(&file);
    let region = |x: f64, y: f64| ours.region_at(Vec2::new(x, y));
    assert_ne!(region(1.0, 0.0), region(6.0, 5.0), "{:?}", file.regions);
    assert_eq!(region(0.0, 0.0), region(3.0, 0.5));
    assert_eq!(region(6.0, 3.0), region(6.0, 6.5));
}

#[test]
fn the_way_is_about_as_long_as_a_taut_string() {
    let laboratory = world(&laboratory_file());
    // Past the post of the door at (3.75, −1.0), a robot's radius away from it.
    let post = Vec2::new(3.75 + 0.707 * RADIUS_M, -1.0 + 0.707 * RADIUS_M);
    let taut_m = post.norm() + (Vec2::new(4.0, -2.0) - post).norm();
    let found_m = way_m(&laboratory, RADIUS_M).expect("a way");
    assert!((found_m - taut_m).abs() < 0.06 * taut_m, "{found_m} {taut_m}");
}
