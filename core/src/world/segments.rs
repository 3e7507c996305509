//! Wall surfaces as segments, in a tree whose leaves are laid out so that four are handled at once.

use crate::geometry::Vec2;

use super::bearing::{Walls, into_frame};
use super::tree::{Item, LANES, Tree};

/// Allowance for rounding wherever something is left out for being too far away, metres. Off the
/// line of a wall by [`GRAZING_M`](super::ray::GRAZING_M) a ray of 200 m meets it within 3 mm of where it should.
pub(super) const SLACK_M: f64 = 0.01;

/// A piece of wall surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// One end, metres.
    pub a: Vec2,
    /// The other end, metres.
    pub b: Vec2,
}

impl Segment {
    /// Distance from a point, metres.
    #[must_use]
    pub fn distance_m(&self, point: Vec2) -> f64 {
        let edge = self.b - self.a;
        let along = ((point - self.a).dot(&edge) / edge.norm_squared()).clamp(0.0, 1.0);
        (point - self.a - edge * along).norm()
    }
}

/// All wall surfaces of a world.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Segments {
    list: Vec<Segment>,
    tree: Tree,
}

/// Up to four segments, coordinate by coordinate; the last fills the lanes left over.
///
/// Each lane is computed by itself and what lanes are folded into does not depend on the order, so
/// no result depends on the instructions the compiler chooses.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Leaf {
    ax: [f64; LANES],
    ay: [f64; LANES],
    bx: [f64; LANES],
    by: [f64; LANES],
    ex: [f64; LANES],
    ey: [f64; LANES],
    inverse_length2: [f64; LANES],
    /// Indices in the world's order.
    pub(super) index: [u32; LANES],
    pub(super) count: usize,
}

impl Segments {
    /// Lays out segments of positive length; there must be at least one.
    pub(super) fn new(list: Vec<Segment>) -> Self {
        let tree = Tree::new(&list);
        Self { list, tree }
    }

    /// The segments in the world's order.
    pub(super) fn list(&self) -> &[Segment] {
        &self.list
    }

    /// The tree over the segments.
    pub(super) fn tree(&self) -> &Tree {
        &self.tree
    }
}

impl Leaf {
    /// A leaf of one to four segments with their indices.
    pub(super) fn new(items: &[Item]) -> Self {
        let lane = |value: fn(&Segment) -> f64| {
            std::array::from_fn(|k| value(&items[k.min(items.len() - 1)].1))
        };
        Self {
            ax: lane(|segment| segment.a.x),
            ay: lane(|segment| segment.a.y),
            bx: lane(|segment| segment.b.x),
            by: lane(|segment| segment.b.y),
            ex: lane(|segment| segment.b.x - segment.a.x),
            ey: lane(|segment| segment.b.y - segment.a.y),
            inverse_length2: lane(|segment| 1.0 / (segment.b - segment.a).norm_squared()),
            index: std::array::from_fn(|k| items[k.min(items.len() - 1)].0),
            count: items.len(),
        }
    }

    /// The segment of a lane.
    pub(super) fn segment(&self, lane: usize) -> Segment {
        let a = Vec2::new(self.ax[lane], self.ay[lane]);
        Segment { a, b: Vec2::new(self.bx[lane], self.by[lane]) }
    }

    /// The segments as seen by a body at a position, heading along the unit vector `direction`.
    #[inline(always)]
    pub(super) fn in_frame(&self, position: Vec2, direction: Vec2) -> Walls {
        let nothing = [0.0; LANES];
        let mut walls = Walls { ax: nothing, ay: nothing, ex: nothing, ey: nothing };
        for k in 0..LANES {
            let a = into_frame(Vec2::new(self.ax[k], self.ay[k]) - position, direction);
            let b = into_frame(Vec2::new(self.bx[k], self.by[k]) - position, direction);
            (walls.ax[k], walls.ay[k]) = (a.x, a.y);
            (walls.ex[k], walls.ey[k]) = (b.x - a.x, b.y - a.y);
        }
        walls
    }

    /// Squared distances from a point to the segments, m².
    #[inline(always)]
    pub(super) fn distances2(&self, point: Vec2) -> [f64; LANES] {
        let mut distances2 = [0.0; LANES];
        for (k, distance2) in distances2.iter_mut().enumerate() {
            let (px, py) = (point.x - self.ax[k], point.y - self.ay[k]);
            let along = (px * self.ex[k] + py * self.ey[k]) * self.inverse_length2[k];
            let along = if along > 0.0 { along } else { 0.0 };
            let along = if along < 1.0 { along } else { 1.0 };
            let (dx, dy) = (px - along * self.ex[k], py - along * self.ey[k]);
            *distance2 = dx * dx + dy * dy;
        }
        distances2
    }
}
