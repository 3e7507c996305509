//! What lies in the cone of a sonar.

use crate::geometry::Vec2;

use super::super::ray::{CORNER_OVERLAP, GRAZING_M};
use super::{Corner, Near, Round};
use crate::world::Segment;

/// Most rays that may stand for a cone.
pub const MOST_RAYS: usize = 16;

/// A cone of sound as a fan of rays, seen from the sonar: x along its axis, y to the left.
#[derive(Clone, Debug, PartialEq)]
pub struct Cone {
    /// Slope of its sides.
    tangent: f64,
    range_m: f64,
    /// Least cosine of the incidence that still returns an echo.
    least_cosine: f64,
    /// Directions of the rays; the last fills the lanes left over.
    x: [f64; MOST_RAYS],
    y: [f64; MOST_RAYS],
}

/// A sonar that looks into an arena.
#[derive(Clone, Copy, Debug)]
pub struct Sight<'a> {
    /// What is near it.
    pub near: &'a Near,
    /// What is round and near it.
    pub rounds: &'a [Round],
    /// Where it is, metres.
    pub place: Vec2,
    /// Unit vector along its axis.
    pub axis: Vec2,
}

/// The nearest surface along each ray.
struct Met {
    /// 1 / distance, 1/m.
    nearness: [f64; MOST_RAYS],
    /// Cosine of the incidence.
    cosine: [f64; MOST_RAYS],
}

impl Cone {
    /// A cone that reaches `half_rad` to each side, below π/2, with `rays` rays spread evenly over it,
    /// the outer ones on its sides. A ray returns no echo when it meets the nearest surface at an
    /// incidence greater than `critical_rad`; `π/2` loses none.
    ///
    /// # Panics
    /// With fewer than two rays, or more than [`MOST_RAYS`].
    #[must_use]
    pub fn new(half_rad: f64, rays: usize, range_m: f64, critical_rad: f64) -> Self {
        assert!((2..=MOST_RAYS).contains(&rays), "{rays} rays");
        let step_rad = 2.0 * half_rad / (rays - 1) as f64;
        let angle_rad = |ray: usize| step_rad * ray.min(rays - 1) as f64 - half_rad;
        let all = critical_rad >= std::f64::consts::FRAC_PI_2;
        Self {
            tangent: libm::tan(half_rad),
            range_m,
            least_cosine: if all { 0.0 } else { libm::cos(critical_rad) },
            x: std::array::from_fn(|ray| libm::cos(angle_rad(ray))),
            y: std::array::from_fn(|ray| libm::sin(angle_rad(ray))),
        }
    }

    /// Whether a point in the sonar's frame lies in the cone and in range.
    fn holds(&self, point: Vec2) -> bool {
        point.y.abs() <= point.x * self.tangent
            && point.norm_squared() <= self.range_m * self.range_m
    }

    /// Whether a segment in the sonar's frame lies beyond one of the sides.
    fn misses(&self, a: Vec2, b: Vec2) -> bool {
        let left = |point: Vec2| point.y > point.x * self.tangent;
        let right = |point: Vec2| -point.y > point.x * self.tangent;
        (left(a) && left(b)) || (right(a) && right(b))
    }

    /// The part of a segment that lies in the cone, both in the sonar's frame.
    fn clip(&self, a: Vec2, b: Vec2) -> Option<Segment> {
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for side in [1.0, -1.0] {
            let inside = |point: Vec2| point.x * self.tangent - side * point.y;
            let (at_a, at_b) = (inside(a), inside(b));
            if at_a < 0.0 && at_b < 0.0 {
                return None;
            }
            let cut = at_a / (at_a - at_b);
            if at_a < 0.0 {
                from = from.max(cut);
            } else if at_b < 0.0 {
                to = to.min(cut);
            }
        }
        (from <= to).then(|| Segment { a: a + (b - a) * from, b: a + (b - a) * to })
    }
}

impl Sight<'_> {
    /// Distance of the nearest surface that returns an echo along a ray, metres; none within range.
    #[must_use]
    pub fn echo_m(&self, cone: &Cone) -> Option<f64> {
        let mut met = Met { nearness: [1.0 / cone.range_m; MOST_RAYS], cosine: [-1.0; MOST_RAYS] };
        for face in &self.near.faces {
            let (a, b) = (self.framed(face.segment.a), self.framed(face.segment.b));
            if !cone.misses(a, b) {
                met.keep_face(cone, a, b);
            }
        }
        for round in self.rounds {
            met.keep_round(cone, self.framed(round.centre), round.radius_m);
        }
        let echoes = met.nearness.iter().zip(&met.cosine);
        let returned = echoes.filter(|(_, cosine)| **cosine >= cone.least_cosine);
        let nearest = returned.map(|(nearness, _)| *nearness).fold(0.0, f64::max);
        (nearest > 0.0).then(|| 1.0 / nearest)
    }

    /// The corners in the cone that the sonar sees, each with its distance in metres.
    pub fn corners<'b>(&'b self, cone: &'b Cone) -> impl Iterator<Item = (&'b Corner, f64)> + 'b {
        self.near.corners.iter().filter_map(move |corner| {
            let at = self.framed(corner.at);
            (cone.holds(at) && self.sees(corner)).then(|| (corner, at.norm()))
        })
    }

    /// Distance of the nearest surface in the cone, metres; the range where there is none.
    #[must_use]
    pub fn nearest_m(&self, cone: &Cone) -> f64 {
        let faces = self.near.faces.iter().filter_map(|face| {
            let part = cone.clip(self.framed(face.segment.a), self.framed(face.segment.b));
            part.map(origin_distance_m)
        });
        let rounds = self.rounds.iter().filter_map(|round| {
            let centre = self.framed(round.centre);
            round_in_cone_m(cone, centre, round.radius_m)
        });
        faces.chain(rounds).fold(cone.range_m, f64::min)
    }

    /// A point as the sonar sees it.
    fn framed(&self, point: Vec2) -> Vec2 {
        let way = point - self.place;
        Vec2::new(way.dot(&self.axis), self.axis.perp(&way))
    }

    /// Whether nothing stands between the sonar and a corner, and one of its faces looks this way.
    fn sees(&self, corner: &Corner) -> bool {
        let faces = self.near.faces.iter().zip(&self.near.numbers);
        let mut looks_here = false;
        for (face, number) in faces {
            let Segment { a, b } = face.segment;
            if corner.faces.contains(number) {
                looks_here |= (b - a).perp(&(self.place - a)) > 0.0;
            } else if crosses(self.place, corner.at, a, b) {
                return false;
            }
        }
        let sight = Segment { a: self.place, b: corner.at };
        looks_here
            && self.rounds.iter().all(|round| sight.distance_m(round.centre) >= round.radius_m)
    }
}

impl Met {
    /// Keeps a face where it is nearer than what a ray has met.
    #[inline]
    fn keep_face(&mut self, cone: &Cone, a: Vec2, b: Vec2) {
        let edge = b - a;
        let off_line = a.perp(&edge);
        if off_line.abs() <= GRAZING_M * (edge.x.abs() + edge.y.abs()) {
            return;
        }
        // 1/distance along direction d is (d × e) / (a × e); a and e are scaled once here.
        let scale = 1.0 / off_line;
        let (ex, ey, ax, ay) = (edge.x * scale, edge.y * scale, a.x * scale, a.y * scale);
        let line_m = off_line.abs() / edge.norm();
        for ray in 0..MOST_RAYS {
            let (dx, dy) = (cone.x[ray], cone.y[ray]);
            let nearness = dx * ey - dy * ex;
            let along = ax * dy - ay * dx;
            let within = (along >= -CORNER_OVERLAP * nearness)
                & (along <= (1.0 + CORNER_OVERLAP) * nearness);
            let nearer = within & (nearness > self.nearness[ray]);
            self.nearness[ray] = if nearer { nearness } else { self.nearness[ray] };
            self.cosine[ray] = if nearer { nearness * line_m } else { self.cosine[ray] };
        }
    }

    fn keep_round(&mut self, cone: &Cone, centre: Vec2, radius_m: f64) {
        for ray in 0..MOST_RAYS {
            let direction = Vec2::new(cone.x[ray], cone.y[ray]);
            let Some(distance_m) = round_along_m(direction, centre, radius_m) else { continue };
            if 1.0 / distance_m > self.nearness[ray] {
                self.nearness[ray] = 1.0 / distance_m;
                self.cosine[ray] = (direction.dot(&centre) - distance_m) / radius_m;
            }
        }
    }
}

/// Way from the origin along a unit vector to something round, metres.
fn round_along_m(direction: Vec2, centre: Vec2, radius_m: f64) -> Option<f64> {
    let (along, beside) = (direction.dot(&centre), direction.perp(&centre));
    let chord2 = radius_m * radius_m - beside * beside;
    let distance_m = along - libm::sqrt(chord2.max(0.0));
    (chord2 > 0.0 && distance_m > 0.0).then_some(distance_m)
}

/// Distance from the origin to what of something round lies in a cone, metres.
fn round_in_cone_m(cone: &Cone, centre: Vec2, radius_m: f64) -> Option<f64> {
    if centre.y.abs() <= centre.x * cone.tangent {
        return Some((centre.norm() - radius_m).max(0.0));
    }
    let length = libm::sqrt(1.0 + cone.tangent * cone.tangent);
    let sides = [1.0, -1.0].map(|side| Vec2::new(1.0, side * cone.tangent) / length);
    let met = sides.into_iter().filter_map(|side| round_along_m(side, centre, radius_m));
    met.reduce(f64::min)
}

fn origin_distance_m(part: Segment) -> f64 {
    if part.a == part.b { part.a.norm() } else { part.distance_m(Vec2::zeros()) }
}

/// Whether two segments cross between their ends.
fn crosses(p: Vec2, q: Vec2, a: Vec2, b: Vec2) -> bool {
    let (sight, edge) = (q - p, b - a);
    let (from_a, from_b) = (sight.perp(&(a - p)), sight.perp(&(b - p)));
    let (from_p, from_q) = (edge.perp(&(p - a)), edge.perp(&(q - a)));
    (from_a > 0.0) != (from_b > 0.0) && (from_p > 0.0) != (from_q > 0.0)
}
