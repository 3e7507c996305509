//! Wall surfaces as segments, laid out so that distances are computed four at a time.

use crate::geometry::Vec2;

/// Segments handled together. Sums and minima are taken lane by lane and folded in a fixed order,
/// so the result does not depend on the instructions the compiler chooses.
const LANES: usize = 4;

/// How far beyond its ends a segment still stops a ray, as a share of its length: walls that share
/// a corner leave no gap through rounding.
pub(super) const CORNER_OVERLAP: f64 = 1e-9;

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
    fours: Vec<Four>,
}

/// Four segments, coordinate by coordinate.
#[derive(Clone, Debug, PartialEq)]
struct Four {
    ax: [f64; LANES],
    ay: [f64; LANES],
    ex: [f64; LANES],
    ey: [f64; LANES],
    inverse_length2: [f64; LANES],
}

impl Segments {
    /// Lays out segments of positive length; there must be at least one.
    pub(super) fn new(list: Vec<Segment>) -> Self {
        let fours = list.chunks(LANES).map(Four::new).collect();
        Self { list, fours }
    }

    /// The segments in the world's order.
    pub(super) fn list(&self) -> &[Segment] {
        &self.list
    }

    /// Distance from a point to the nearest segment, metres.
    pub(super) fn distance_m(&self, point: Vec2) -> f64 {
        let mut least2 = [f64::INFINITY; LANES];
        for four in &self.fours {
            four.lower_to_distance2(point, &mut least2);
        }
        libm::sqrt(least2.into_iter().fold(f64::INFINITY, f64::min))
    }

    /// The first segment along a ray, within a range. A ray along a segment does not meet it.
    pub(super) fn nearest(&self, origin: Vec2, direction: Vec2, range_m: f64) -> Option<Hit> {
        let mut nearest: Option<Hit> = None;
        for (segment, &Segment { a, b }) in self.list.iter().enumerate() {
            let edge = b - a;
            let (offset, across) = (a - origin, direction.perp(&edge));
            let distance_m = offset.perp(&edge) / across;
            let along = offset.perp(&direction) / across;
            let within = (-CORNER_OVERLAP..=1.0 + CORNER_OVERLAP).contains(&along);
            let limit_m = nearest.map_or(range_m, |hit| hit.distance_m);
            if within && distance_m >= 0.0 && distance_m < limit_m {
                let cosine = (across.abs() / edge.norm()).min(1.0);
                nearest = Some(Hit { distance_m, incidence_rad: libm::acos(cosine), segment });
            }
        }
        nearest
    }
}

impl Four {
    /// Up to four segments; the last fills the lanes left over.
    fn new(segments: &[Segment]) -> Self {
        let lane = |value: fn(&Segment) -> f64| {
            std::array::from_fn(|k| value(&segments[k.min(segments.len() - 1)]))
        };
        Self {
            ax: lane(|segment| segment.a.x),
            ay: lane(|segment| segment.a.y),
            ex: lane(|segment| segment.b.x - segment.a.x),
            ey: lane(|segment| segment.b.y - segment.a.y),
            inverse_length2: lane(|segment| 1.0 / (segment.b - segment.a).norm_squared()),
        }
    }

    /// Lowers each lane to the squared distance of its segment, if that is less.
    #[inline]
    fn lower_to_distance2(&self, point: Vec2, least2: &mut [f64; LANES]) {
        for (k, least2) in least2.iter_mut().enumerate() {
            let (px, py) = (point.x - self.ax[k], point.y - self.ay[k]);
            let along = (px * self.ex[k] + py * self.ey[k]) * self.inverse_length2[k];
            let along = if along > 0.0 { along } else { 0.0 };
            let along = if along < 1.0 { along } else { 1.0 };
            let (dx, dy) = (px - along * self.ex[k], py - along * self.ey[k]);
            let distance2 = dx * dx + dy * dy;
            *least2 = if distance2 < *least2 { distance2 } else { *least2 };
        }
    }
}
