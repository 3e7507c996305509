//! Worlds: walls, regions, home and goal.
//!
//! A world is plain data in a file ([`WorldFile`]), checked once ([`World::new`]) and then asked:
//! how far is the nearest surface ([`World::clearance_m`]), what does a ray meet
//! ([`World::nearest_m`]), what does a whole ring of rays meet ([`RayRing`]), which region is this
//! ([`World::region_at`], Algorithm 8 of section 5.6). All coordinates are in the world frame, in
//! metres.

mod check;
mod error;
#[cfg(test)]
pub(crate) mod examples;
mod file;
mod reach;
mod region;
mod scan;
mod segments;

pub use check::{EXTENT_LIMIT_M, REGION_LIMIT, WALL_LIMIT};
pub use error::WorldError;
pub use file::{Axis, GoalFile, HomeFile, RegionFile, RuleFile, WorldFile};
pub use region::{HalfPlane, Region};
pub use scan::{RayFan, RayRing};
pub use segments::{Hit, Segment};

use crate::geometry::{Pose, Vec2};
use segments::Segments;

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
        check::check_values(file)?;
        let segments = check::segments(file)?;
        let bounds_m = check::bounds_m(file, &segments)?;
        let regions = check::regions(file, bounds_m)?;
        let world = Self {
            name: file.name.clone(),
            title: file.title.clone(),
            summary: file.summary.clone(),
            source: file.source.clone(),
            segments: Segments::new(segments),
            blocks: file.blocks.iter().map(|block| block.iter().map(point).collect()).collect(),
            regions,
            bounds_m,
            home: Pose::new(file.home.x, file.home.y, file.home.heading_deg.to_radians()),
            goal: Goal {
                centre: Vec2::new(file.goal.x, file.goal.y),
                radius_m: file.goal.radius_m,
            },
        };
        world.check_way(robot_radius_m)?;
        Ok(world)
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

    /// All wall surfaces: the pieces of the walls, then the edges of the blocks.
    #[must_use]
    pub fn walls(&self) -> &[Segment] {
        self.segments.list()
    }

    /// Corners of the solid blocks.
    #[must_use]
    pub fn blocks(&self) -> &[Vec<Vec2>] {
        &self.blocks
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

    /// Distance from a point to the nearest wall surface, metres; 0 inside a block.
    #[must_use]
    pub fn clearance_m(&self, point: Vec2) -> f64 {
        if self.blocks.iter().any(|block| contains(block, point)) {
            return 0.0;
        }
        self.surface_distance_m(point)
    }

    /// What a ray meets first within a range in metres; `direction` is a unit vector. A ray that
    /// runs along a wall does not meet it.
    #[must_use]
    pub fn nearest_m(&self, origin: Vec2, direction: Vec2, range_m: f64) -> Option<Hit> {
        self.segments.nearest(origin, direction, range_m)
    }

    /// Distance from a point to the nearest wall surface, metres, also from inside a block. Faster
    /// than [`World::clearance_m`], and the same for a body that never crosses a surface.
    #[must_use]
    pub(crate) fn surface_distance_m(&self, point: Vec2) -> f64 {
        self.segments.distance_m(point)
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
        Err(WorldError::GoalUnreachable { nearest: point, distance_m, radius_m })
    }
}

fn point(&[x, y]: &[f64; 2]) -> Vec2 {
    Vec2::new(x, y)
}

/// Whether a point lies inside a simple polygon (even-odd rule).
fn contains(polygon: &[Vec2], point: Vec2) -> bool {
    let edges = polygon.iter().zip(polygon.iter().cycle().skip(1));
    let crossings = edges.filter(|(a, b)| {
        (a.y > point.y) != (b.y > point.y)
            && point.x < a.x + (b.x - a.x) * ((point.y - a.y) / (b.y - a.y))
    });
    crossings.count() % 2 == 1
}

#[cfg(test)]
mod tests;
