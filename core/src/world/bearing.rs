//! Where walls and boxes lie as seen from a place, in rough angles: enough to tell which fans of
//! rays may meet them.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

use crate::geometry::Vec2;

use super::echoes::Wall;
use super::tree::{LANES, Middles};

/// Slack on rough angles, radians; greater than twice the error of [`rough_angle`].
const MARGIN_RAD: f64 = 0.01;

/// An interval of angles, counter-clockwise; the first end is in `[-π, π]` and the second not more
/// than a turn beyond it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sector {
    pub(super) from_rad: f64,
    pub(super) to_rad: f64,
}

/// Four walls in the frame of a body, metres: one end, and the way to the other.
#[derive(Clone, Copy, Debug)]
pub(super) struct Walls {
    pub(super) ax: [f64; LANES],
    pub(super) ay: [f64; LANES],
    pub(super) ex: [f64; LANES],
    pub(super) ey: [f64; LANES],
}

impl Walls {
    /// The wall of a lane.
    #[inline(always)]
    pub(super) fn wall(&self, lane: usize) -> Wall {
        Wall { ax: self.ax[lane], ay: self.ay[lane], ex: self.ex[lane], ey: self.ey[lane] }
    }
}

impl Sector {
    /// The sectors that hold four walls seen from the origin, with the margin for rough angles.
    #[inline(always)]
    pub(super) fn of_walls(walls: &Walls) -> [Self; LANES] {
        let Walls { ax, ay, ex, ey } = walls;
        let (mut from_rad, mut to_rad) = ([0.0; LANES], [0.0; LANES]);
        for k in 0..LANES {
            let (bx, by) = (ax[k] + ex[k], ay[k] + ey[k]);
            let (a_rad, b_rad) = (rough_angle(ax[k], ay[k]), rough_angle(bx, by));
            let left = ax[k] * ey[k] - ay[k] * ex[k] >= 0.0;
            let (from, to) = if left { (a_rad, b_rad) } else { (b_rad, a_rad) };
            // A wall never spans more than half a turn; one that points at the origin or ends there
            // may come out the wrong way round.
            let to = if to - from < -FRAC_PI_2 { to + TAU } else { to };
            let (from, to) = if to < from { (to, from) } else { (from, to) };
            (from_rad[k], to_rad[k]) = (from - MARGIN_RAD, to + MARGIN_RAD);
        }
        std::array::from_fn(|k| Self { from_rad: from_rad[k], to_rad: to_rad[k] })
    }

    /// Sectors that hold four boxes seen from a body at a position, heading along the unit vector
    /// `direction`; all round when the body is in a box or so near that any direction may lead into it.
    #[inline(always)]
    pub(super) fn of_boxes(boxes: &Middles, position: Vec2, direction: Vec2) -> [Self; LANES] {
        let (mut from_rad, mut to_rad) = ([0.0; LANES], [0.0; LANES]);
        for k in 0..LANES {
            let offset = Vec2::new(boxes.x[k], boxes.y[k]) - position;
            let (x, y) = (offset.x.abs(), offset.y.abs());
            // How far the box reaches across the line of sight and towards the eye, times the
            // distance.
            let across = boxes.half_x[k] * y + boxes.half_y[k] * x;
            let nearer = x * x + y * y - (boxes.half_x[k] * x + boxes.half_y[k] * y);
            // atan z ≤ z
            let half_rad = across / nearer;
            let half_rad = if (nearer > 0.0) & (half_rad < PI) { half_rad } else { PI };
            let seen = into_frame(offset, direction);
            let middle_rad = rough_angle(seen.x, seen.y);
            from_rad[k] = middle_rad - (half_rad + MARGIN_RAD);
            to_rad[k] = middle_rad + (half_rad + MARGIN_RAD);
        }
        std::array::from_fn(|k| Self { from_rad: from_rad[k], to_rad: to_rad[k] })
    }
}

/// A displacement in the world frame as seen by a body heading along `direction`.
#[inline(always)]
pub(super) fn into_frame(displacement: Vec2, direction: Vec2) -> Vec2 {
    Vec2::new(
        displacement.x * direction.x + displacement.y * direction.y,
        displacement.y * direction.x - displacement.x * direction.y,
    )
}

/// The angle of a vector to within 0.004 rad.
#[inline(always)]
fn rough_angle(x: f64, y: f64) -> f64 {
    let (far, high) = (x.abs(), y.abs());
    let (small, large) = if high < far { (high, far) } else { (far, high) };
    // atan z ≈ z (π/4 + 0.273 (1 − z)) on [0, 1]. The least number keeps the zero vector at 0.
    let ratio = small / (large + f64::MIN_POSITIVE);
    let octant = ratio * (FRAC_PI_4 + 0.273 * (1.0 - ratio));
    let quadrant = if high < far { octant } else { FRAC_PI_2 - octant };
    let half = if x < 0.0 { PI - quadrant } else { quadrant };
    if y < 0.0 { -half } else { half }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::geometry::{unit, wrap_angle};

    #[test]
    fn the_rough_angle_is_within_its_promise() {
        for step in -31_416..=31_416 {
            let angle_rad = f64::from(step) * 1e-4;
            let place = unit(angle_rad);
            let off = wrap_angle(rough_angle(place.x, place.y) - angle_rad);
            assert!(off.abs() < 0.004, "{angle_rad}: {off}");
        }
    }

    fn place() -> impl Strategy<Value = Vec2> {
        (-9.0..9.0f64, -9.0..9.0f64).prop_map(|(x, y)| Vec2::new(x, y))
    }

    /// Whether a sector holds the direction to a point.
    fn holds(sector: &Sector, point: Vec2) -> bool {
        let angle_rad = crate::geometry::angle(point);
        (-2..=2).any(|turn| {
            (sector.from_rad..=sector.to_rad).contains(&(angle_rad + f64::from(turn) * TAU))
        })
    }

    proptest! {
        #[test]
        fn a_wall_lies_in_its_sector(a in place(), b in place(), share in 0.0..1.0f64) {
            let edge = b - a;
            let walls =
                Walls { ax: [a.x; 4], ay: [a.y; 4], ex: [edge.x; 4], ey: [edge.y; 4] };
            let sector = Sector::of_walls(&walls)[0];
            prop_assert!(holds(&sector, a + edge * share), "{:?}", sector);
            prop_assert!(sector.to_rad - sector.from_rad < PI + 3.0 * MARGIN_RAD);
        }

        #[test]
        fn a_box_lies_in_its_sector(
            centre in place(), half in place(), position in place(), heading_rad in -3.1..3.1f64,
            across in -1.0..1.0f64, along in -1.0..1.0f64,
        ) {
            let (direction, half) = (unit(heading_rad), half.abs() * 0.3);
            let boxes = Middles {
                x: [centre.x; 4], y: [centre.y; 4], half_x: [half.x; 4], half_y: [half.y; 4],
            };
            let sector = Sector::of_boxes(&boxes, position, direction)[3];
            let point = centre + Vec2::new(half.x * across, half.y * along);
            prop_assert!(holds(&sector, into_frame(point - position, direction)));
        }
    }
}
