//! Worlds that tests share.

use proptest::prelude::*;

use crate::geometry::Vec2;

use super::segments::Segment;
use super::{GoalFile, HomeFile, RegionFile, World, WorldFile};

/// Radius of the B21, metres.
pub(crate) const RADIUS_M: f64 = 0.265;

/// The laboratory's file.
pub(crate) fn laboratory_file() -> WorldFile {
    parsed(include_str!("../../../assets/worlds/laboratory.toml"))
}

/// Files of all worlds that come with the program.
pub(crate) fn all_files() -> [WorldFile; 8] {
    [
        laboratory_file(),
        parsed(include_str!("../../../assets/worlds/laboratory-shifted-door.toml")),
        parsed(include_str!("../../../assets/worlds/two-obstacles.toml")),
        parsed(include_str!("../../../assets/worlds/laboratory-narrow-door.toml")),
        parsed(include_str!("../../../assets/worlds/l-corridor.toml")),
        parsed(include_str!("../../../assets/worlds/three-rooms.toml")),
        parsed(include_str!("../../../assets/worlds/two-baffles.toml")),
        parsed(include_str!("../../../assets/worlds/pillars.toml")),
    ]
}

/// An empty room of one region round the origin, home in its middle.
pub(crate) fn room_file(width_m: f64, height_m: f64) -> WorldFile {
    let (x, y) = (0.5 * width_m, 0.5 * height_m);
    WorldFile {
        name: "room".to_owned(),
        title: "Room".to_owned(),
        summary: "An empty room".to_owned(),
        source: "A test".to_owned(),
        walls: vec![vec![[-x, -y], [x, -y], [x, y], [-x, y], [-x, -y]]],
        blocks: Vec::new(),
        floor: Vec::new(),
        regions: vec![RegionFile { name: "everywhere".to_owned(), rules: Vec::new() }],
        home: HomeFile { x: 0.0, y: 0.0, heading_deg: 0.0 },
        goal: GoalFile { x: 0.0, y: 0.0, radius_m: 0.1 },
    }
}

/// The world of a file, for the B21.
pub(crate) fn world(file: &WorldFile) -> World {
    World::new(file, RADIUS_M).expect("a test's world is sound")
}

fn parsed(text: &str) -> WorldFile {
    toml::from_str(text).expect("a world that comes with the program can be read")
}

/// Walls anywhere in a square of 24 m, up to a few hundred: small pieces near each other as traced
/// maps have them, long ones, and lines of a grid that share corners and run along each other.
pub(crate) fn any_segments() -> impl Strategy<Value = Vec<Segment>> {
    let long = (any_place(), any_place()).prop_map(|(a, b)| (a, b - a));
    let small =
        (any_place(), -0.3..0.3f64, -0.3..0.3f64).prop_map(|(a, dx, dy)| (a, Vec2::new(dx, dy)));
    let grid = (-12..12i32, -12..12i32, 0..2usize, -9..9i32).prop_map(|(x, y, axis, length)| {
        let along = [Vec2::x(), Vec2::y()][axis] * f64::from(length);
        (Vec2::new(f64::from(x), f64::from(y)), along)
    });
    let walls =
        |most: usize, kind: BoxedStrategy<(Vec2, Vec2)>| prop::collection::vec(kind, 0..most);
    (walls(8, long.boxed()), walls(300, small.boxed()), walls(30, grid.boxed())).prop_map(
        |(long, small, grid)| {
            let all = long.into_iter().chain(small).chain(grid);
            let pieces = all.filter(|(_, way)| way.norm() > 1e-3);
            let mut walls: Vec<_> = pieces.map(|(a, way)| Segment { a, b: a + way }).collect();
            if walls.is_empty() {
                walls.push(Segment { a: Vec2::zeros(), b: Vec2::x() });
            }
            walls
        },
    )
}

/// A place in that square; now and then on its grid.
pub(crate) fn any_place() -> impl Strategy<Value = Vec2> {
    let anywhere = (-12.0..12.0f64, -12.0..12.0f64).prop_map(|(x, y)| Vec2::new(x, y));
    let on_grid = (-12..12i32, -12..12i32).prop_map(|(x, y)| Vec2::new(f64::from(x), f64::from(y)));
    prop_oneof![4 => anywhere, 1 => on_grid]
}
