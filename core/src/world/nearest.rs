//! What is nearest to a point, and to a body round it.

use crate::geometry::Vec2;

use super::segments::{Leaf, SLACK_M, Segment};
use super::tree::{LANES, Node, Seeker, lesser};

/// Looks for the distance from a point to the nearest segment.
pub(super) struct NearestPoint {
    point: Vec2,
    /// Square of the least distance so far, m².
    least2: f64,
}

impl NearestPoint {
    pub(super) fn new(point: Vec2) -> Self {
        Self { point, least2: f64::INFINITY }
    }

    /// Distance to the nearest of the segments looked at, metres.
    pub(super) fn distance_m(&self) -> f64 {
        libm::sqrt(self.least2)
    }

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

/// Looks for the least of a measure of segments that is at least their distance from a point less
/// some reach, such as the distance from a body.
pub(super) struct NearestBody<F> {
    point: Vec2,
    reach_m: f64,
    measure_m: F,
    /// The least so far.
    pub(super) least_m: f64,
}

impl<F: Fn(Segment) -> f64> NearestBody<F> {
    pub(super) fn new(point: Vec2, reach_m: f64, measure_m: F) -> Self {
        Self { point, reach_m, measure_m, least_m: f64::INFINITY }
    }

    /// Square of a distance from the point beyond which nothing matters, m².
    fn limit2(&self) -> f64 {
        let limit_m = self.least_m + self.reach_m + SLACK_M;
        limit_m * limit_m
    }
}

impl<F: Fn(Segment) -> f64> Seeker for NearestBody<F> {
    type Note = ();

    fn boxes(&self, node: &Node) -> ([f64; LANES], [(); LANES]) {
        (node.distances2(self.point), [(); LANES])
    }

    fn matters(&self, distance2: f64, (): ()) -> bool {
        distance2 < self.limit2()
    }

    fn look(&mut self, leaf: &Leaf) {
        for k in 0..leaf.count {
            self.least_m = lesser(self.least_m, (self.measure_m)(leaf.segment(k)));
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::world::examples::{any_place, any_segments};
    use crate::world::segments::Segments;

    proptest! {
        #[test]
        fn the_tree_finds_the_distance_of_the_nearest_of_all(
            walls in any_segments(), point in any_place(),
        ) {
            let all = walls.iter().map(|&wall| Leaf::new(&[(0, wall)]).distances2(point)[0]);
            let expected = all.fold(f64::INFINITY, f64::min).sqrt();
            let mut nearest = NearestPoint::new(point);
            Segments::new(walls.clone()).tree().walk(&mut nearest);
            prop_assert_eq!(nearest.distance_m(), expected);
        }

        #[test]
        fn the_tree_finds_what_is_nearest_to_a_body(
            walls in any_segments(), point in any_place(), reach_m in 0.0..2.0f64,
        ) {
            // Somewhere on the body, as far from the point as it reaches.
            let edge = point + Vec2::new(0.6, -0.8) * reach_m;
            let measure_m = |wall: Segment| wall.distance_m(edge);
            let mut nearest = NearestBody::new(point, reach_m, measure_m);
            Segments::new(walls.clone()).tree().walk(&mut nearest);
            let expected = walls.iter().map(|wall| measure_m(*wall)).fold(f64::INFINITY, f64::min);
            prop_assert_eq!(nearest.least_m, expected);
        }
    }
}
