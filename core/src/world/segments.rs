//! Wall surfaces as segments, in a tree whose leaves are laid out so that four are handled at once.

use crate::geometry::Vec2;

use super::bearing::{Walls, into_frame};
use super::tree::{Item, LANES, Node, Seeker, Tree, lesser};

/// How far beyond its ends a segment still stops a ray, as a share of its length: walls that share
/// a corner leave no gap through rounding.
pub(super) const CORNER_OVERLAP: f64 = 1e-9;

/// A ray that starts nearer than about this to the line of a wall does not meet the wall, metres.
/// Where it would is a matter of rounding otherwise.
pub(super) const GRAZING_M: f64 = 1e-8;

/// Allowance for rounding wherever something is left out for being too far away, metres. Off the
/// line of a wall by [`GRAZING_M`] a ray of 200 m meets it within 3 mm of where it should.
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

/// What a ray met.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Way from the origin, metres.
    pub distance_m: f64,
    /// Angle between the ray and the surface's normal, radians, 0 (head on) to π/2 (grazing).
    pub incidence_rad: f64,
    /// Index of the segment in [`World::walls`](super::World::walls).
    pub segment: usize,
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
    pub(super) ax: [f64; LANES],
    pub(super) ay: [f64; LANES],
    pub(super) bx: [f64; LANES],
    pub(super) by: [f64; LANES],
    ex: [f64; LANES],
    ey: [f64; LANES],
    inverse_length2: [f64; LANES],
    /// Indices in the world's order.
    index: [u32; LANES],
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

    /// Distance from a point to the nearest segment, metres.
    pub(super) fn distance_m(&self, point: Vec2) -> f64 {
        let mut nearest = NearestPoint { point, least2: f64::INFINITY };
        self.tree.walk(&mut nearest);
        libm::sqrt(nearest.least2)
    }

    /// The first segment along a ray, within a range; the first in the world's order of equals. A
    /// ray along a segment, or from a place on it, does not meet it.
    pub(super) fn nearest(&self, origin: Vec2, direction: Vec2, range_m: f64) -> Option<Hit> {
        let mut ray = Ray { origin, direction, range_m, met: None };
        self.tree.walk(&mut ray);
        ray.met.map(|Met { distance_m, segment, across }| {
            let Segment { a, b } = self.list[segment as usize];
            let cosine = (across.abs() / (b - a).norm()).min(1.0);
            Hit { distance_m, incidence_rad: libm::acos(cosine), segment: segment as usize }
        })
    }
}

/// Looks for the distance from a point to the nearest segment.
struct NearestPoint {
    point: Vec2,
    /// Square of the least distance so far, m².
    least2: f64,
}

impl NearestPoint {
    /// Square of a distance at which nothing can be nearer, m².
    #[inline(always)]
    fn limit2(&self) -> f64 {
        self.least2 * (1.0 + SLACK_M) + SLACK_M * SLACK_M
    }
}

impl Seeker for NearestPoint {
    type Note = ();

    #[inline(always)]
    fn boxes(&self, node: &Node) -> ([f64; LANES], [(); LANES]) {
        let limit2 = self.limit2();
        let near =
            node.distances2(self.point).map(|d2| if d2 < limit2 { d2 } else { f64::INFINITY });
        (near, [(); LANES])
    }

    #[inline(always)]
    fn matters(&self, distance2: f64, (): ()) -> bool {
        distance2 < self.limit2()
    }

    #[inline(always)]
    fn look(&mut self, leaf: &Leaf) {
        let [a, b, c, d] = leaf.distances2(self.point);
        self.least2 = lesser(self.least2, lesser(lesser(a, b), lesser(c, d)));
    }
}

/// Looks for the first segment along a ray.
struct Ray {
    origin: Vec2,
    direction: Vec2,
    range_m: f64,
    met: Option<Met>,
}

/// A segment met by a ray.
#[derive(Clone, Copy)]
struct Met {
    distance_m: f64,
    segment: u32,
    /// Cross product of the ray's direction and the segment.
    across: f64,
}

impl Ray {
    /// What meeting a segment comes to, if the ray does.
    fn meet(&self, segment: u32, a: Vec2, b: Vec2) -> Option<Met> {
        let edge = b - a;
        let (offset, across) = (a - self.origin, self.direction.perp(&edge));
        let off_line = offset.perp(&edge);
        let distance_m = off_line / across;
        let along = offset.perp(&self.direction) / across;
        let within = (-CORNER_OVERLAP..=1.0 + CORNER_OVERLAP).contains(&along);
        let grazes = off_line.abs() <= GRAZING_M * (edge.x.abs() + edge.y.abs());
        (within && !grazes && distance_m >= 0.0).then_some(Met { distance_m, segment, across })
    }

    fn is_nearer(&self, met: &Met) -> bool {
        match &self.met {
            None => met.distance_m < self.range_m,
            Some(other) => {
                let same = met.distance_m == other.distance_m;
                met.distance_m < other.distance_m || (same && met.segment < other.segment)
            }
        }
    }
}

impl Seeker for Ray {
    type Note = ();

    fn boxes(&self, node: &Node) -> ([f64; LANES], [(); LANES]) {
        let boxes = node.middles();
        let enters = |lane: usize| {
            let half = Vec2::new(boxes.half_x[lane], boxes.half_y[lane]);
            let offset = Vec2::new(boxes.x[lane], boxes.y[lane]) - self.origin;
            let side = self.direction.abs();
            // What the box takes up along the ray and across it.
            let (along_m, across_m) = (half.dot(&side), half.x * side.y + half.y * side.x);
            let enters_m = offset.dot(&self.direction) - along_m - SLACK_M;
            let misses_m = self.direction.perp(&offset).abs() - across_m - SLACK_M;
            let behind = enters_m + 2.0 * (along_m + SLACK_M) < 0.0;
            // A box without contents gives no number, and is not met either.
            if misses_m <= 0.0 && !behind { enters_m.max(0.0) } else { f64::INFINITY }
        };
        (std::array::from_fn(enters), [(); LANES])
    }

    fn matters(&self, distance_m: f64, (): ()) -> bool {
        distance_m <= self.met.map_or(self.range_m, |met| met.distance_m)
    }

    fn look(&mut self, leaf: &Leaf) {
        for k in 0..leaf.count {
            let (a, b) = (Vec2::new(leaf.ax[k], leaf.ay[k]), Vec2::new(leaf.bx[k], leaf.by[k]));
            if let Some(met) = self.meet(leaf.index[k], a, b).filter(|met| self.is_nearer(met)) {
                self.met = Some(met);
            }
        }
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

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::geometry::unit;
    use crate::world::examples::{any_place, any_segments};

    proptest! {
        #[test]
        fn the_tree_finds_the_distance_of_the_nearest_of_all(
            walls in any_segments(), point in any_place(),
        ) {
            let all = walls.iter().map(|&wall| Leaf::new(&[(0, wall)]).distances2(point)[0]);
            let expected = all.fold(f64::INFINITY, f64::min).sqrt();
            prop_assert_eq!(Segments::new(walls.clone()).distance_m(point), expected);
        }

        #[test]
        fn the_tree_finds_the_first_wall_along_a_ray(
            walls in any_segments(), origin in any_place(), heading_rad in -3.2..3.2f64,
            quarter in 0..9i32, range_m in 0.5..40.0f64,
        ) {
            // Now and then along the grid on which some of the walls lie.
            let turned = f64::from(quarter) * std::f64::consts::FRAC_PI_2;
            let direction = unit(if quarter < 4 { turned } else { heading_rad });
            let mut all = Ray { origin, direction, range_m, met: None };
            for (index, wall) in (0..).zip(&walls) {
                all.look(&Leaf::new(&[(index, *wall)]));
            }
            let found = Segments::new(walls.clone()).nearest(origin, direction, range_m);
            let place = |met: Met| (met.segment as usize, met.distance_m);
            prop_assert_eq!(found.map(|hit| (hit.segment, hit.distance_m)), all.met.map(place));
        }

        #[test]
        fn every_segment_is_in_one_leaf(walls in any_segments()) {
            let mut all = All(Vec::new());
            Tree::new(&walls).walk(&mut all);
            all.0.sort_unstable();
            prop_assert_eq!(all.0, (0..walls.len() as u32).collect::<Vec<_>>());
        }
    }

    /// Looks at everything.
    struct All(Vec<u32>);

    impl Seeker for All {
        type Note = ();

        fn boxes(&self, node: &Node) -> ([f64; LANES], [(); LANES]) {
            (node.distances2(Vec2::zeros()), [(); LANES])
        }

        fn matters(&self, _: f64, (): ()) -> bool {
            true
        }

        fn look(&mut self, leaf: &Leaf) {
            self.0.extend(&leaf.index[..leaf.count]);
        }
    }
}
