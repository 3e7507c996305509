//! Single rays.

use crate::geometry::Vec2;

use super::segments::{Leaf, SLACK_M, Segment};
use super::tree::{LANES, Node, Seeker};

/// How far beyond its ends a segment still stops a ray, as a share of its length: walls that share
/// a corner leave no gap through rounding.
pub(super) const CORNER_OVERLAP: f64 = 1e-9;

/// A ray that starts nearer than about this to the line of a wall does not meet the wall, metres.
/// Where it would is a matter of rounding otherwise.
pub(super) const GRAZING_M: f64 = 1e-8;

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

/// Looks for the first segment along a ray.
pub(super) struct Ray {
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
    /// A ray along a unit vector, that ends at a range in metres.
    pub(super) fn new(origin: Vec2, direction: Vec2, range_m: f64) -> Self {
        Self { origin, direction, range_m, met: None }
    }

    /// The first of the segments looked at; the first in the world's order of equals.
    pub(super) fn hit(&self, walls: &[Segment]) -> Option<Hit> {
        self.met.map(|Met { distance_m, segment, across }| {
            let Segment { a, b } = walls[segment as usize];
            let cosine = (across.abs() / (b - a).norm()).min(1.0);
            Hit { distance_m, incidence_rad: libm::acos(cosine), segment: segment as usize }
        })
    }

    /// What meeting a segment comes to, if the ray does.
    fn meet(&self, segment: u32, Segment { a, b }: Segment) -> Option<Met> {
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
            let met = self.meet(leaf.index[k], leaf.segment(k));
            if let Some(met) = met.filter(|met| self.is_nearer(met)) {
                self.met = Some(met);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::geometry::unit;
    use crate::world::examples::{any_place, any_segments};
    use crate::world::segments::Segments;

    proptest! {
        #[test]
        fn the_tree_finds_the_first_wall_along_a_ray(
            walls in any_segments(), origin in any_place(), heading_rad in -3.2..3.2f64,
            quarter in 0..9i32, range_m in 0.5..40.0f64,
        ) {
            // Now and then along the grid on which some of the walls lie.
            let turned = f64::from(quarter) * std::f64::consts::FRAC_PI_2;
            let direction = unit(if quarter < 4 { turned } else { heading_rad });
            let mut all = Ray::new(origin, direction, range_m);
            for (index, wall) in (0..).zip(&walls) {
                all.look(&Leaf::new(&[(index, *wall)]));
            }
            let mut ray = Ray::new(origin, direction, range_m);
            Segments::new(walls.clone()).tree().walk(&mut ray);
            prop_assert_eq!(ray.hit(&walls), all.hit(&walls));
        }
    }
}
