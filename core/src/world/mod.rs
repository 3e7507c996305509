//! Worlds: walls, regions, home and goal.
//!
//! A world is plain data in a file ([`WorldFile`]), checked once ([`World::new`]) and then asked:
//! how far is the nearest surface ([`World::clearance_m`]), what does a ray meet
//! ([`World::nearest_m`]), what does a whole ring of rays meet ([`RayRing`]), which region is this
//! ([`World::region_at`], Algorithm 8 of section 5.6). All coordinates are in the world frame, in
//! metres.

mod arena;
mod bearing;
mod check;
mod dial;
mod echoes;
mod error;
#[cfg(test)]
pub(crate) mod examples;
mod few;
mod file;
pub mod map;
mod nearest;
mod partition;
mod people;
mod ray;
mod reach;
mod region;
mod scan;
mod segments;
mod tree;

pub use arena::{
    Arena, ArenaError, Cone, Corner, Face, MOST_RAYS, Near, Nearest, Ring, Round, Sight, Surface,
};
pub use check::{EXTENT_LIMIT_M, REGION_LIMIT, WALL_LIMIT};
pub use error::WorldError;
pub use file::{Axis, GoalFile, HomeFile, RegionFile, RuleFile, WorldFile};
pub use partition::{DEFAULT_REGIONS, propose_regions, way_m};
pub use people::{
    Obstacle, PERSON_RADIUS_M, Passage, People, PeopleError, PeopleFile, Person, PersonFile,
};
pub use ray::Hit;
pub use region::{HalfPlane, Region};
pub use scan::{RayFan, RayRing};
pub use segments::Segment;

use crate::geometry::{Pose, Vec2};
use crate::simd::{Level, dispatch};
use nearest::{NearestBody, NearestPoint};
use ray::Ray;
use segments::Segments;
use tree::Seeker;

/// Least radius of a robot that a way to the goal is looked for, metres.
const LEAST_RADIUS_M: f64 = 0.05;
/// Greatest radius of a robot, metres.
const GREATEST_RADIUS_M: f64 = 5.0;

/// Where every trial should end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Goal {
    /// Centre, metres.
    pub centre: Vec2,
    /// The goal is reached when the robot's centre is nearer to `centre` than this, metres.
    pub radius_m: f64,
}

/// A checked world: a robot of the radius it was checked for fits at home and can reach the goal.
#[derive(Clone, Debug, PartialEq)]
pub struct World {
    name: String,
    title: String,
    summary: String,
    source: String,
    segments: Segments,
    blocks: Vec<Vec<Vec2>>,
    floor: Vec<Vec<Vec2>>,
    regions: Vec<Region>,
    bounds_m: [f64; 4],
    home: Pose,
    goal: Goal,
}

impl World {
    /// Checks what a file says for a round robot of a radius in metres.
    ///
    /// # Errors
    /// The first thing wrong, with the field at fault and what would be right.
    pub fn new(file: &WorldFile, robot_radius_m: f64) -> Result<Self, WorldError> {
        if let Some(problem) = check::values(file).into_iter().next() {
            return Err(problem);
        }
        let (segments, bounds_m) = Self::surfaces(file)?;
        let regions = check::regions(file, bounds_m)?;
        let world = Self::assembled(file, segments, bounds_m, regions);
        world.check_way(robot_radius_m)?;
        Ok(world)
    }

    /// Everything wrong with a file that can be found at once, for people who draw one; nothing when
    /// [`World::new`] takes it. What hangs on something wrong is not looked at.
    #[must_use]
    pub fn problems(file: &WorldFile, robot_radius_m: f64) -> Vec<WorldError> {
        let mut problems = check::values(file);
        let (segments, bounds_m) = match Self::surfaces(file) {
            Ok(found) => found,
            Err(problem) => {
                problems.push(problem);
                return problems;
            }
        };
        // A number that is none has been named already, and has spoilt the bounds.
        if bounds_m.iter().all(|bound| bound.is_finite()) {
            problems.extend(check::regions(file, bounds_m).err());
            if problems.iter().all(|problem| problem.field().starts_with("regions")) {
                let world = Self::assembled(file, segments, bounds_m, Vec::new());
                problems.extend(world.check_way(robot_radius_m).err());
            }
        }
        problems
    }

    fn surfaces(file: &WorldFile) -> Result<(Vec<Segment>, [f64; 4]), WorldError> {
        let segments = check::segments(file)?;
        let bounds_m = check::bounds_m(file, &segments)?;
        Ok((segments, bounds_m))
    }

    fn assembled(
        file: &WorldFile,
        segments: Vec<Segment>,
        bounds_m: [f64; 4],
        regions: Vec<Region>,
    ) -> Self {
        Self {
            name: file.name.clone(),
            title: file.title.clone(),
            summary: file.summary.clone(),
            source: file.source.clone(),
            segments: Segments::new(segments),
            blocks: points(&file.blocks),
            floor: points(&file.floor),
            regions,
            bounds_m,
            home: Pose::new(file.home.x, file.home.y, file.home.heading_deg.to_radians()),
            goal: Goal {
                centre: Vec2::new(file.goal.x, file.goal.y),
                radius_m: file.goal.radius_m,
            },
        }
    }

    /// Name, the value of the setting `world`.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Title for people.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.title
    }

    /// One sentence on what the world is like.
    #[must_use]
    pub fn summary(&self) -> &str {
        &self.summary
    }

    /// Where it comes from.
    #[must_use]
    pub fn source(&self) -> &str {
        &self.source
    }

    /// Least and greatest x and y of walls, blocks, home and goal, metres: `[x0, y0, x1, y1]`.
    #[must_use]
    pub fn bounds_m(&self) -> [f64; 4] {
        self.bounds_m
    }

    /// All wall surfaces: the pieces of the walls, then the edges of the blocks and of the floor.
    #[must_use]
    pub fn walls(&self) -> &[Segment] {
        self.segments.list()
    }

    /// Corners of the solid blocks.
    #[must_use]
    pub fn blocks(&self) -> &[Vec<Vec2>] {
        &self.blocks
    }

    /// Rings that bound the free floor by the even-odd rule; none where everything but the blocks is
    /// free.
    #[must_use]
    pub fn floor(&self) -> &[Vec<Vec2>] {
        &self.floor
    }

    /// The regions in their fixed order.
    #[must_use]
    pub fn regions(&self) -> &[Region] {
        &self.regions
    }

    /// Index of the region of a point: the first whose rules all hold (Algorithm 8).
    #[must_use]
    pub fn region_at(&self, point: Vec2) -> usize {
        let first = self.regions.iter().position(|region| region.contains(point));
        // The last region has no rules, so there always is a first one.
        first.unwrap_or(self.regions.len() - 1)
    }

    /// Convex polygons that cover a region within the bounds, for drawing; none for an index that
    /// no region has.
    #[must_use]
    pub fn region_polygons(&self, index: usize) -> Vec<Vec<Vec2>> {
        if index >= self.regions.len() {
            return Vec::new();
        }
        region::polygons(&self.regions, index, self.bounds_m)
    }

    /// Where every trial starts.
    #[must_use]
    pub fn home(&self) -> Pose {
        self.home
    }

    /// Where every trial should end.
    #[must_use]
    pub fn goal(&self) -> Goal {
        self.goal
    }

    /// Distance from a point to the nearest wall surface, metres; 0 inside a block and off the floor.
    #[must_use]
    pub fn clearance_m(&self, point: Vec2) -> f64 {
        if self.is_solid(point) { 0.0 } else { self.surface_distance_m(point) }
    }

    /// Whether a point lies inside a block or off the floor.
    #[must_use]
    pub fn is_solid(&self, point: Vec2) -> bool {
        let off_floor = !self.floor.is_empty() && crossings(&self.floor, point) % 2 == 0;
        off_floor || self.blocks.iter().any(|block| crossings([block], point) % 2 == 1)
    }

    /// What a ray meets first within a range in metres, the first in [`World::walls`] of equals;
    /// `direction` is a unit vector. A ray that runs along a wall, or starts on it, does not meet it.
    #[must_use]
    pub fn nearest_m(&self, origin: Vec2, direction: Vec2, range_m: f64) -> Option<Hit> {
        let mut ray = Ray::new(origin, direction, range_m);
        self.segments.tree().walk(&mut ray);
        ray.hit(self.walls())
    }

    /// Distance from a point to the nearest wall surface, metres, also from inside a block. Faster
    /// than [`World::clearance_m`], and the same for a body that never crosses a surface.
    #[must_use]
    pub(crate) fn surface_distance_m(&self, point: Vec2) -> f64 {
        let mut nearest = NearestPoint::new(point);
        dispatch!(Level::new(), _ => match self.segments.tree().few_leaves() {
            Some(leaves) => leaves.iter().for_each(|leaf| nearest.look(leaf)),
            None => self.segments.tree().walk(&mut nearest),
        });
        nearest.distance_m()
    }

    /// The least of a measure of wall surfaces, metres, that is at least their distance from a point
    /// less a reach in metres: how far a body is from them.
    #[must_use]
    pub(crate) fn nearest_to_body_m(
        &self,
        point: Vec2,
        reach_m: f64,
        measure_m: impl Fn(Segment) -> f64,
    ) -> f64 {
        let mut nearest = NearestBody::new(point, reach_m, measure_m);
        self.segments.tree().walk(&mut nearest);
        nearest.least_m
    }

    /// Whether the robot fits at home and can drive to the goal.
    fn check_way(&self, radius_m: f64) -> Result<(), WorldError> {
        if !(LEAST_RADIUS_M..=GREATEST_RADIUS_M).contains(&radius_m) {
            let (least, most) = (LEAST_RADIUS_M, GREATEST_RADIUS_M);
            return Err(WorldError::RobotRadius { least, most, found: radius_m });
        }
        let home = self.home.position();
        let clearance_m = self.clearance_m(home);
        if clearance_m < radius_m {
            let (x, y) = (home.x, home.y);
            return Err(WorldError::HomeBlocked { x, y, clearance_m, radius_m });
        }
        self.check_reach(radius_m)
    }

    fn check_reach(&self, radius_m: f64) -> Result<(), WorldError> {
        let (home, goal) = (self.home.position(), self.goal);
        let nearest =
            reach::nearest_reachable(self.walls(), self.bounds_m, radius_m, home, goal.centre);
        // A goal smaller than a cell of the grid is reached in the cell that holds its centre.
        let within_m = goal.radius_m.max(reach::CELL_M * std::f64::consts::FRAC_1_SQRT_2);
        if nearest.distance_m < within_m {
            return Ok(());
        }
        let point = [nearest.point.x, nearest.point.y];
        let distance_m = nearest.distance_m;
        let goal = [goal.centre.x, goal.centre.y];
        Err(WorldError::GoalUnreachable { nearest: point, distance_m, goal, radius_m })
    }
}

fn points(polygons: &[Vec<[f64; 2]>]) -> Vec<Vec<Vec2>> {
    polygons.iter().map(|polygon| polygon.iter().copied().map(Vec2::from).collect()).collect()
}

/// How many edges of closed polygons a ray from a point to the right crosses; odd inside (even-odd
/// rule).
fn crossings<'a>(polygons: impl IntoIterator<Item = &'a Vec<Vec2>>, point: Vec2) -> usize {
    let edges = polygons.into_iter().flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)));
    let crossed = edges.filter(|(a, b)| {
        (a.y > point.y) != (b.y > point.y)
            && point.x < a.x + (b.x - a.x) * ((point.y - a.y) / (b.y - a.y))
    });
    crossed.count()
}

#[cfg(test)]
mod tests;
