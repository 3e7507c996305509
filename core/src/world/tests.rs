use proptest::prelude::*;

use super::examples::{RADIUS_M, all_files, laboratory_file, room_file, world};
use super::*;
use crate::geometry::unit;

#[test]
fn the_laboratory_is_the_one_of_section_5_3() {
    let laboratory = world(&laboratory_file());
    assert_eq!(laboratory.name(), "laboratory");
    assert_eq!(laboratory.bounds_m(), [-1.5, -3.5, 5.55, 2.5]);
    assert_eq!(laboratory.home(), Pose::new(0.0, 0.0, 0.0));
    assert_eq!(laboratory.goal(), Goal { centre: Vec2::new(4.0, -2.0), radius_m: 0.5 });
    let names: Vec<_> = laboratory.regions().iter().map(|region| &region.name).collect();
    assert_eq!(names, ["corridor", "concave", "room", "door"]);
}

#[test]
fn regions_follow_algorithm_8() {
    let laboratory = world(&laboratory_file());
    for (x, y, expected) in [
        (0.0, 0.0, "room"),
        (3.49, -0.99, "room"),
        (0.0, -1.0, "room"), // l1 itself is not below l1
        (0.0, -1.01, "concave"),
        (3.6, -1.01, "concave"),
        (3.5, 0.0, "door"), // l2 itself is not left of l2
        (3.6, -0.5, "door"),
        (3.75, -0.5, "door"), // l3 itself is not right of l3
        (3.75, -2.0, "door"), // nor left of it, as the concave region asks
        (3.76, -0.5, "corridor"),
        (4.0, -2.0, "corridor"),
        (4.0, 2.0, "corridor"),
    ] {
        let region = laboratory.region_at(Vec2::new(x, y));
        assert_eq!(laboratory.regions()[region].name, expected, "({x}, {y})");
    }
}

#[test]
fn the_laboratory_has_no_gap_and_one_door() {
    let laboratory = world(&laboratory_file());
    for step in 0..3600 {
        let direction = unit(f64::from(step) * 0.1_f64.to_radians());
        for place in [Vec2::new(0.0, 0.0), Vec2::new(4.5, -0.5), Vec2::new(3.6, -0.3)] {
            assert!(laboratory.nearest_m(place, direction, 20.0).is_some(), "{direction:?}");
        }
    }
    // Through the middle of the door to the far wall of the corridor, and beside it to the near one.
    for (y, expected) in [(-0.35, 5.55), (0.29, 5.55), (0.31, 3.5), (-0.99, 5.55), (-1.01, 3.5)] {
        let hit = laboratory.nearest_m(Vec2::new(0.0, y), Vec2::x(), 20.0).expect("a wall");
        assert!((hit.distance_m - expected).abs() < 1e-12, "{y}: {hit:?}");
    }
}

#[test]
fn every_world_that_comes_with_the_program_is_sound_and_returns_to_its_file() {
    for file in all_files() {
        world(&file);
        let text = toml::to_string(&file).expect("a world can be written");
        assert_eq!(toml::from_str::<WorldFile>(&text).expect("and read again"), file);
    }
}

#[test]
fn a_misspelt_key_is_refused() {
    let text = toml::to_string(&room_file(4.0, 4.0)).expect("a world can be written");
    let error = toml::from_str::<WorldFile>(&text.replace("radius_m", "radius"));
    assert!(error.expect_err("no such key").to_string().contains("radius"));
}

#[test]
fn clearance_is_0_inside_a_block_and_the_distance_to_its_surface_outside() {
    let two = world(&all_files()[2]);
    for (x, y, expected) in [
        (1.7, -0.1, 0.0),
        (1.55, -0.25, 0.0),
        (1.4, -0.1, 0.1),
        (2.2, 0.5, 0.5), // from the corner (1.9, 0.1)
        (3.6, 1.0, 0.0), // inside the wall beside the door
        (3.6, -0.35, 0.65),
    ] {
        let found = two.clearance_m(Vec2::new(x, y));
        assert!((found - expected).abs() < 1e-12, "({x}, {y}): {found}");
    }
    assert!(two.surface_distance_m(Vec2::new(1.7, -0.1)) > 0.19);
}

proptest! {
    #[test]
    fn a_ray_in_a_rectangle_goes_as_far_as_the_nearer_axis_allows(
        x in -1.9..1.9f64, y in -0.9..0.9f64, angle_rad in -3.2..3.2f64,
    ) {
        let room = world(&room_file(4.0, 2.0));
        let direction = unit(angle_rad);
        let along = |at: f64, way: f64, half: f64| {
            if way == 0.0 { f64::INFINITY } else { (half * way.signum() - at) / way }
        };
        let (dx, dy) = (along(x, direction.x, 2.0), along(y, direction.y, 1.0));
        let hit = room.nearest_m(Vec2::new(x, y), direction, 10.0).expect("a closed room");
        prop_assert!((hit.distance_m - dx.min(dy)).abs() < 1e-9);
        let head_on = if dx < dy { direction.x.abs() } else { direction.y.abs() };
        prop_assert!((dx - dy).abs() < 1e-9 || (libm::cos(hit.incidence_rad) - head_on).abs() < 1e-9);
        prop_assert!(room.nearest_m(Vec2::new(x, y), direction, 0.99 * dx.min(dy)).is_none());
    }

    #[test]
    fn clearance_is_the_least_distance_to_points_on_the_walls(x in -3.0..7.0f64, y in -4.0..4.0f64) {
        let two = world(&all_files()[2]);
        let point = Vec2::new(x, y);
        let samples = two.walls().iter().flat_map(|wall| {
            (0..=2000).map(move |step| wall.a + (wall.b - wall.a) * (f64::from(step) / 2000.0))
        });
        let sampled = samples.map(|place| (place - point).norm()).fold(f64::INFINITY, f64::min);
        let exact = two.surface_distance_m(point);
        prop_assert!((-1e-12..2e-3).contains(&(sampled - exact)), "{} {}", exact, sampled);
    }
}

/// A change to a world's file.
type Change = fn(&mut WorldFile);

/// The field at fault after a change to the laboratory's file.
fn fault(change: Change) -> String {
    let mut file = laboratory_file();
    change(&mut file);
    World::new(&file, RADIUS_M).expect_err("a world with a fault is refused").field()
}

fn rule(text: &str) -> RuleFile {
    toml::from_str(text).expect("a rule")
}

#[test]
fn every_refusal_names_the_field_at_fault() {
    let faults: [(&str, Change); 30] = [
        ("name", |file| file.name.clear()),
        ("walls", |file| (file.walls, file.blocks) = (Vec::new(), Vec::new())),
        ("walls[1]", |file| file.walls[1].truncate(1)),
        ("walls[1][2]", |file| file.walls[1][2] = file.walls[1][1]),
        ("walls[0][3][1]", |file| file.walls[0][3][1] = f64::NAN),
        ("walls", |file| file.walls[0][1][0] = -500.0),
        ("walls", |file| {
            file.walls.push((0..20_001).map(|k| [f64::from(k % 2), 2.4]).collect());
        }),
        ("blocks[0]", |file| file.blocks[0].truncate(2)),
        ("blocks[1][0][0]", |file| file.blocks[1][0][0] = f64::INFINITY),
        ("blocks[0][4]", |file| file.blocks[0].push([3.5, 0.3])),
        ("floor[0]", |file| file.floor.push(vec![[0.0, 0.0], [1.0, 0.0]])),
        ("floor[0][1][0]", |file| file.floor.push(vec![[0.0, 0.0], [f64::NAN, 0.0], [1.0, 1.0]])),
        ("home", |file| file.floor.push(vec![[3.8, -3.0], [5.0, -3.0], [5.0, 2.0], [3.8, 2.0]])),
        ("regions", |file| file.regions.clear()),
        ("regions", |file| file.regions.truncate(3)),
        ("regions", |file| file.regions = vec![file.regions[0].clone(); 65]),
        ("regions[2].name", |file| file.regions[2].name = "corridor".to_owned()),
        ("regions[1].name", |file| file.regions[1].name.clear()),
        ("regions[2].rules[0]", |file| file.regions[2].rules = vec![rule("axis = 'x'")]),
        ("regions[1].rules[1]", |file| file.regions[1].rules[1].axis = None),
        ("regions[1].rules[1]", |file| {
            file.regions[1].rules[1] = rule("a = 0.0\nb = 0.0\nbelow = 1.0");
        }),
        ("regions[1].rules[0]", |file| file.regions[1].rules[0].above = Some(1.0)),
        ("regions[0].rules[0].above", |file| file.regions[0].rules[0].above = Some(f64::NAN)),
        ("regions[0]", |file| file.regions[0].rules[0].above = Some(9.0)),
        ("regions[2]", |file| file.regions[2].rules = vec![rule("axis = 'x'\nabove = 4.0")]),
        ("home.heading_deg", |file| file.home.heading_deg = f64::NAN),
        ("home", |file| (file.home.x, file.home.y) = (3.3, 1.0)),
        ("home", |file| (file.home.x, file.home.y) = (3.62, 1.4)),
        ("goal.radius_m", |file| file.goal.radius_m = 0.0),
        ("goal", |file| file.goal.y = -9.0),
    ];
    for (index, (expected, change)) in faults.into_iter().enumerate() {
        assert_eq!(fault(change), expected, "fault {index}");
    }
    let too_small = World::new(&laboratory_file(), 0.01).expect_err("no such robot");
    assert_eq!(too_small.field(), "robot_radius_m");
}

#[test]
fn a_closed_door_is_refused_with_the_place_nearest_to_the_goal() {
    let mut file = laboratory_file();
    file.walls.push(vec![[3.6, -1.0], [3.6, 0.3]]);
    let error = World::new(&file, RADIUS_M).expect_err("the door is closed");
    let WorldError::GoalUnreachable { nearest, distance_m, .. } = error else {
        panic!("{error}");
    };
    // The corner of the room nearest to the goal, a robot's radius off the walls.
    assert!((nearest[0] - 3.235).abs() < 0.06 && (nearest[1] + 2.0).abs() < 0.06, "{nearest:?}");
    assert!((distance_m - 0.8).abs() < 0.07);
    assert_eq!((error.place_m(), error.nearest_m()), (Some([4.0, -2.0]), Some(nearest)));
    assert!(error.to_string().contains("nearest point it can reach is (3.2"), "{error}");
}

#[test]
fn a_gap_is_a_way_only_for_a_robot_that_fits() {
    // A slanted wall with a gap, which no grid line follows.
    let gap = |width_m: f64| {
        let mut file = room_file(6.0, 4.0);
        file.goal = GoalFile { x: 2.5, y: 0.0, radius_m: 0.2 };
        let (slope, half) = (unit(1.2), 0.5 * width_m);
        let at = |way_m: f64| [1.0 + slope.x * way_m, slope.y * way_m];
        file.walls.push(vec![at(-2.0 / slope.y), at(-half)]);
        file.walls.push(vec![at(half), at(2.0 / slope.y)]);
        World::new(&file, RADIUS_M)
    };
    assert_eq!(gap(0.50).expect_err("too narrow").field(), "goal");
    assert!(gap(0.65).is_ok());
}

#[test]
fn the_way_round_the_outside_counts() {
    let mut file = room_file(4.0, 4.0);
    file.walls = vec![vec![[1.0, -2.0], [1.0, 2.0]]];
    file.goal = GoalFile { x: 2.0, y: 0.0, radius_m: 0.2 };
    assert!(World::new(&file, RADIUS_M).is_ok());
}

#[test]
fn everything_off_the_floor_is_solid() {
    let mut file = room_file(8.0, 8.0);
    let square = |half: f64| vec![[-half, -half], [half, -half], [half, half], [-half, half]];
    (file.walls, file.floor) = (Vec::new(), vec![square(3.0), square(1.0)]);
    (file.home.x, file.goal.x) = (-2.0, 2.0);
    let ring = world(&file);
    assert_eq!(ring.walls().len(), 8);
    for (x, expected) in [(2.0, 1.0), (-1.25, 0.25), (0.0, 0.0), (3.5, 0.0)] {
        assert_eq!(ring.clearance_m(Vec2::new(x, 0.0)), expected, "{x}");
    }
    file.home.x = 0.5;
    let error = World::new(&file, RADIUS_M).expect_err("home is in the pillar");
    assert_eq!((error.field().as_str(), error.place_m()), ("home", Some([0.5, 0.0])));
}

#[test]
fn all_problems_are_found_at_once() {
    let mut file = laboratory_file();
    assert_eq!(World::problems(&file, RADIUS_M), []);
    file.name.clear();
    file.home.x = f64::NAN;
    file.goal.radius_m = -1.0;
    file.walls[1].truncate(1);
    let fields = |file: &WorldFile| -> Vec<String> {
        World::problems(file, RADIUS_M).iter().map(WorldError::field).collect()
    };
    assert_eq!(fields(&file), ["name", "home.x", "goal.radius_m", "walls[1]"]);
    let mut file = laboratory_file();
    file.regions[0].rules[0].above = Some(9.0);
    file.goal.y = -9.0;
    assert_eq!(fields(&file), ["regions[0]", "goal"]);
}
