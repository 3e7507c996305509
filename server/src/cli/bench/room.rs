//! The room of 30 walls in which range finders are compared: 10 m × 8 m with a corridor across,
//! four boxes, a triangle and three screens. Also worlds of many walls.

use sonarium_core::geometry::{Vec2, unit};
use sonarium_core::robot::{BodyFile, Robot, RobotError, RobotFile};
use sonarium_core::world::{
    GoalFile, HomeFile, RayFan, RayRing, RegionFile, World, WorldError, WorldFile,
};

/// Radius of the body, metres.
pub(super) const RADIUS_M: f64 = 0.2;
/// Range of the sonars, metres.
pub(super) const RANGE_M: f64 = 5.0;
/// Width of a sonar's cone, degrees.
pub(super) const CONE_DEG: f64 = 15.0;

/// Closed rectangles `[x0, y0, x1, y1]`, metres.
const RECTANGLES: [[f64; 4]; 5] = [
    [0.0, 0.0, 10.0, 8.0],
    [1.5, 1.0, 2.5, 1.8],
    [6.0, 0.8, 6.8, 2.2],
    [2.0, 6.0, 2.6, 7.0],
    [7.0, 6.0, 8.4, 6.6],
];
/// Single walls `[ax, ay, bx, by]`, metres: corridor, triangle, screens.
const WALLS: [[f64; 4]; 10] = [
    [0.0, 3.4, 3.0, 3.4],
    [4.0, 3.4, 8.5, 3.4],
    [1.5, 4.6, 6.0, 4.6],
    [7.0, 4.6, 10.0, 4.6],
    [4.5, 5.6, 5.3, 5.6],
    [5.3, 5.6, 4.9, 6.4],
    [4.9, 6.4, 4.5, 5.6],
    [4.6, 1.2, 4.6, 2.4],
    [8.6, 1.0, 9.2, 2.0],
    [0.8, 5.4, 0.8, 7.0],
];

/// The room, the robot at home at the west end of the corridor.
pub(super) fn room() -> Result<World, WorldError> {
    let rectangles =
        RECTANGLES.map(|[x0, y0, x1, y1]| vec![[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]]);
    let walls = WALLS.map(|[ax, ay, bx, by]| vec![[ax, ay], [bx, by]]);
    let walls = rectangles.into_iter().chain(walls).collect();
    World::new(&file("room", walls, [0.8, 4.0], [9.0, 4.0]), RADIUS_M)
}

/// The disc that drives in the room, with 24 sonars on its shell.
pub(super) fn robot() -> Result<Robot, RobotError> {
    Robot::new(&RobotFile {
        name: "disc".to_owned(),
        title: "Disc".to_owned(),
        summary: "To measure speed".to_owned(),
        source: "bench".to_owned(),
        ring: Some(24),
        body: BodyFile { radius_m: Some(RADIUS_M), ..BodyFile::default() },
        sonars: Vec::new(),
        equipment: None,
    })
}

/// An office of 20 × 20 rooms of 3 m, each with two doors of 1.2 m, its walls broken into pieces of
/// 10 cm that are up to 1 cm off the line, as walls traced from a map are.
pub(super) fn office() -> Result<World, WorldError> {
    let mut walls = Vec::new();
    for line in 0..=20_i32 {
        for room in 0..20_i32 {
            let door = (1..20).contains(&line);
            for vertical in [false, true] {
                walls.extend(traced(line, room, vertical, door));
            }
        }
    }
    World::new(&file("office", walls, [31.5, 31.5], [34.5, 31.5]), 0.265)
}

/// One side of a room as pieces of wall, in two when there is a door between them.
fn traced(line: i32, room: i32, vertical: bool, door: bool) -> Vec<Vec<[f64; 2]>> {
    let point = |piece: i32| {
        let along = 3.0 * f64::from(room) + 0.1 * f64::from(piece);
        let off = 0.01 * f64::from((piece * 7 + room * 5 + line * 3) % 3 - 1);
        let across = 3.0 * f64::from(line) + off;
        if vertical { [across, along] } else { [along, across] }
    };
    let run = |from: i32, to: i32| (from..=to).map(point).collect();
    if door { vec![run(0, 9), run(21, 30)] } else { vec![run(0, 30)] }
}

fn file(name: &str, walls: Vec<Vec<[f64; 2]>>, home: [f64; 2], goal: [f64; 2]) -> WorldFile {
    WorldFile {
        name: name.to_owned(),
        title: name.to_owned(),
        summary: "To measure speed".to_owned(),
        source: "bench".to_owned(),
        walls,
        blocks: Vec::new(),
        floor: Vec::new(),
        regions: vec![RegionFile { name: "everywhere".to_owned(), rules: Vec::new() }],
        home: HomeFile { x: home[0], y: home[1], heading_deg: 0.0 },
        goal: GoalFile { x: goal[0], y: goal[1], radius_m: 0.5 },
    }
}

/// A number of fans of rays from one point, spread evenly.
pub(super) fn star(fans: u32, rays: usize) -> RayRing {
    let fan = |index: u32| RayFan {
        place: Vec2::zeros(),
        axis_rad: (360.0 * f64::from(index) / f64::from(fans)).to_radians(),
    };
    let fans: Vec<_> = (0..fans).map(fan).collect();
    RayRing::new(&fans, rays, CONE_DEG.to_radians(), RANGE_M, std::f64::consts::FRAC_PI_2)
}

/// What the wall follower that drives the comparison does with 24 readings: speed, m/s, and turn
/// rate, rad/s.
pub(super) fn follow(readings_m: &[f64]) -> (f64, f64) {
    let least = |range: std::ops::Range<usize>| {
        readings_m[range].iter().copied().fold(f64::INFINITY, f64::min)
    };
    let (left, right) = (least(2..8), least(17..23));
    if least(0..2).min(readings_m[23]) < 0.8 {
        return (0.05, if left >= right { 1.2 } else { -1.2 });
    }
    (0.4, (0.5 * (left - right)).clamp(-1.0, 1.0))
}

/// The simulator that is compared: a disc, its sonars in its middle, no noise.
pub(super) struct Disc {
    world: World,
    ring: RayRing,
    position: Vec2,
    heading_rad: f64,
    pub(super) readings_m: [f64; 24],
}

impl Disc {
    pub(super) fn new(rays: usize) -> Result<Self, WorldError> {
        let world = room()?;
        let position = world.home().position();
        let ring = star(24, rays);
        Ok(Self { world, ring, position, heading_rad: 0.0, readings_m: [RANGE_M; 24] })
    }

    /// A tenth of a second: turns, advances unless that would touch a wall, and scans.
    pub(super) fn step(&mut self) {
        let (speed, turn) = follow(&self.readings_m);
        self.heading_rad += 0.1 * turn;
        let direction = unit(self.heading_rad);
        let next = self.position + direction * (0.1 * speed);
        if self.world.clearance_m(next) >= RADIUS_M {
            self.position = next;
        }
        self.ring.scan(&self.world, self.position, direction, &mut self.readings_m);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worlds_are_sound() {
        assert_eq!(room().expect("sound").walls().len(), 30);
        assert!(office().expect("sound").walls().len() > 15_000);
    }
}
