//! The outline of a robot on the floor.

use crate::geometry::{Vec2, rotate};
use crate::world::{Segment, World};

/// The outline of a robot, around the point it turns about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Body {
    /// A circle.
    Round {
        /// Metres.
        radius_m: f64,
    },
    /// A rectangle, its length along the heading.
    Box {
        /// Half the length, metres.
        half_length_m: f64,
        /// Half the width, metres.
        half_width_m: f64,
    },
}

impl Body {
    /// Radius of the smallest circle around it: what it needs to turn on the spot, metres.
    #[must_use]
    pub fn reach_m(&self) -> f64 {
        match *self {
            Self::Round { radius_m } => radius_m,
            Self::Box { half_length_m, half_width_m } => {
                libm::sqrt(half_length_m * half_length_m + half_width_m * half_width_m)
            }
        }
    }

    /// Corners of a rectangle, counter-clockwise from the left front, robot frame; none of a circle.
    #[must_use]
    pub fn corners(&self) -> Vec<Vec2> {
        let Self::Box { half_length_m: x, half_width_m: y } = *self else { return Vec::new() };
        vec![Vec2::new(x, y), Vec2::new(-x, y), Vec2::new(-x, -y), Vec2::new(x, -y)]
    }

    /// Distance from the outline to a point, metres; not above 0 inside a circle, 0 inside a rectangle.
    #[must_use]
    pub fn distance_m(&self, position: Vec2, direction: Vec2, point: Vec2) -> f64 {
        match *self {
            Self::Round { radius_m } => (point - position).norm() - radius_m,
            Self::Box { half_length_m, half_width_m } => {
                let half = Vec2::new(half_length_m, half_width_m);
                let within = rotate(point - position, Vec2::new(direction.x, -direction.y));
                outside(half, within).norm()
            }
        }
    }

    /// Distance from the outline to the nearest wall surface, metres; not above 0 when it touches one.
    #[must_use]
    pub fn clearance_m(&self, world: &World, position: Vec2, direction: Vec2) -> f64 {
        match *self {
            Self::Round { radius_m } => world.surface_distance_m(position) - radius_m,
            Self::Box { .. } => world.nearest_to_body_m(position, self.reach_m(), |wall| {
                self.wall_distance_m(position, direction, wall)
            }),
        }
    }

    /// Distance from the outline to one piece of wall, metres; not above 0 when it touches it.
    #[must_use]
    pub(crate) fn wall_distance_m(&self, position: Vec2, direction: Vec2, wall: Segment) -> f64 {
        match *self {
            Self::Round { radius_m } => wall.distance_m(position) - radius_m,
            Self::Box { half_length_m, half_width_m } => {
                let half = Vec2::new(half_length_m, half_width_m);
                let into_frame = |point: Vec2| into_frame(point, position, direction);
                box_distance_m(half, Segment { a: into_frame(wall.a), b: into_frame(wall.b) })
            }
        }
    }

    /// Distance from the outline to a point, metres; not above 0 within it.
    #[must_use]
    pub(crate) fn point_distance_m(&self, position: Vec2, direction: Vec2, point: Vec2) -> f64 {
        match *self {
            Self::Round { radius_m } => (point - position).norm() - radius_m,
            Self::Box { half_length_m, half_width_m } => {
                let half = Vec2::new(half_length_m, half_width_m);
                outside(half, into_frame(point, position, direction)).norm()
            }
        }
    }
}

/// A point in the frame of a body at a position that heads along `direction`.
fn into_frame(point: Vec2, position: Vec2, direction: Vec2) -> Vec2 {
    rotate(point - position, Vec2::new(direction.x, -direction.y))
}

/// Distance from a rectangle round the origin, given by half its sides, to a segment; 0 when they meet.
fn box_distance_m(half: Vec2, wall: Segment) -> f64 {
    if crosses(half, wall) {
        return 0.0;
    }
    // Apart from each other, the least distance is that of an end or of a corner.
    let ends = [wall.a, wall.b].map(|end| outside(half, end).norm());
    let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)]
        .map(|(x, y)| wall.distance_m(Vec2::new(x * half.x, y * half.y)));
    ends.into_iter().chain(corners).fold(f64::INFINITY, f64::min)
}

/// How far a point is outside the rectangle, along each axis.
fn outside(half: Vec2, point: Vec2) -> Vec2 {
    Vec2::new((point.x.abs() - half.x).max(0.0), (point.y.abs() - half.y).max(0.0))
}

/// Whether a segment has a point in the rectangle: clipped by its four sides, something is left.
fn crosses(half: Vec2, Segment { a, b }: Segment) -> bool {
    let edge = b - a;
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for (start, step, limit) in [(a.x, edge.x, half.x), (a.y, edge.y, half.y)] {
        if step == 0.0 {
            if start.abs() > limit {
                return false;
            }
        } else {
            let (first, last) = ((-limit - start) / step, (limit - start) / step);
            from = from.max(first.min(last));
            to = to.min(first.max(last));
        }
    }
    from <= to
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::geometry::unit;
    use crate::world::examples::{room_file, world};

    const TRC: Body = Body::Box { half_length_m: 0.375, half_width_m: 0.35 };

    #[test]
    fn a_box_in_a_room_is_as_far_from_the_walls_as_its_sides_and_corners_are() {
        let room = world(&room_file(4.0, 6.0));
        let diagonal = std::f64::consts::FRAC_PI_4;
        for (case, x, y, heading_rad, expected_m) in [
            ("in the middle, along x", 0.0, 0.0, 0.0, 2.0 - 0.375),
            ("in the middle, along y", 0.0, 0.0, 2.0 * diagonal, 2.0 - 0.35),
            ("near the north wall, along x", 0.0, 2.5, 0.0, 0.5 - 0.35),
            ("a corner ahead", 0.0, 0.0, diagonal, 2.0 - 0.725 * diagonal.cos()),
            ("through the wall", 1.8, 0.0, 0.0, 0.0),
        ] {
            let found_m = TRC.clearance_m(&room, Vec2::new(x, y), unit(heading_rad));
            assert!((found_m - expected_m).abs() < 1e-12, "{case}: {found_m}");
        }
    }

    #[test]
    fn a_point_is_as_far_as_from_the_nearest_side_or_corner() {
        let round = Body::Round { radius_m: 0.265 };
        let (at, north) = (Vec2::new(1.0, 2.0), Vec2::y());
        // Facing north the sides are 0.35 m to the east and the front is 0.375 m to the north.
        for (body, point, expected_m) in [
            (round, [1.0, 3.0], 1.0 - 0.265),
            (TRC, [1.0, 3.0], 1.0 - 0.375),
            (TRC, [2.0, 2.0], 1.0 - 0.35),
            (TRC, [1.0 + 0.35 + 0.3, 2.0 + 0.375 + 0.4], 0.5),
            (TRC, [1.1, 2.1], 0.0),
        ] {
            let found_m = body.distance_m(at, north, Vec2::from(point));
            assert!((found_m - expected_m).abs() < 1e-12, "{body:?} {point:?}: {found_m}");
        }
    }

    proptest! {
        #[test]
        fn the_clearance_of_a_box_is_that_of_the_points_on_its_outline(
            ax in -2.0..2.0f64, ay in -2.0..2.0f64, bx in -2.0..2.0f64, by in -2.0..2.0f64,
        ) {
            let wall = Segment { a: Vec2::new(ax, ay), b: Vec2::new(bx, by) };
            prop_assume!((wall.b - wall.a).norm() > 1e-3);
            let half = Vec2::new(0.375, 0.35);
            let outline = (0..4000).map(|k| {
                let (side, along) = (k % 4, f64::from(k / 4) / 500.0 - 1.0);
                match side {
                    0 => Vec2::new(half.x, along * half.y),
                    1 => Vec2::new(-half.x, along * half.y),
                    2 => Vec2::new(along * half.x, half.y),
                    _ => Vec2::new(along * half.x, -half.y),
                }
            });
            let near_m = outline.map(|point| wall.distance_m(point)).fold(f64::INFINITY, f64::min);
            let inside = wall.a.x.abs() < half.x && wall.a.y.abs() < half.y;
            let expected_m = if inside { 0.0 } else { near_m };
            prop_assert!((box_distance_m(half, wall) - expected_m).abs() < 1e-3);
        }
    }
}
