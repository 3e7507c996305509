//! Worlds that tests share.

use super::{GoalFile, HomeFile, RegionFile, World, WorldFile};

/// Radius of the B21, metres.
pub(crate) const RADIUS_M: f64 = 0.265;

/// The laboratory's file.
pub(crate) fn laboratory_file() -> WorldFile {
    parsed(include_str!("../../../assets/worlds/laboratory.toml"))
}

/// Files of all worlds that come with the program.
pub(crate) fn all_files() -> [WorldFile; 3] {
    [
        laboratory_file(),
        parsed(include_str!("../../../assets/worlds/laboratory-shifted-door.toml")),
        parsed(include_str!("../../../assets/worlds/two-obstacles.toml")),
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
