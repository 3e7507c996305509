//! A ring of fans of rays cast at once: the fast path behind the sonars.
//!
//! The work is done in the robot's frame, where origins and directions of all rays are constants:
//! the ends of each wall are turned into it instead. A ray that leaves the shell at angle φ in
//! direction φ + δ stays, seen from the centre, between φ and φ + δ; so a wall that spans an
//! angle as seen from the centre can be met only by the fans that overlap this angle, and only
//! those are tried. Which fans are tried is decided with a margin and can never change a reading.
//! Fans that are not spread evenly round a circle are few, and all of them are tried.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::geometry::{Vec2, unit};

use super::World;
use super::segments::{CORNER_OVERLAP, Segment};

/// Rays handled together.
const LANES: usize = 6;

/// Slack on the angles that decide which fans are tried, radians; greater than twice the error of
/// [`rough_angle`].
const MARGIN_RAD: f64 = 0.01;

/// Slack on the places and axes of fans that count as spread evenly, metres and radians.
const EVEN: f64 = 1e-9;

/// Where a fan of rays leaves the body and where its middle ray goes, robot frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayFan {
    /// Place, metres.
    pub place: Vec2,
    /// Direction of the middle ray from the heading, radians.
    pub axis_rad: f64,
}

/// Fans of rays round a body.
#[derive(Clone, Debug)]
pub struct RayRing {
    fans: Vec<Fan>,
    groups_per_fan: usize,
    groups: Vec<RayGroup>,
    /// Scratch: the nearest echo of each ray so far.
    echoes: Vec<Echoes>,
    /// Fan `i` leaves a circle at angle `2π·i / fans`, straight outwards.
    even: bool,
    /// Greatest distance of a fan from the centre.
    radius_m: f64,
    range_m: f64,
    half_cone_rad: f64,
    /// Least cosine of the incidence that still returns an echo; 0 when every ray does.
    least_cosine: f64,
}

/// Place of a fan on the shell, robot frame, metres.
#[derive(Clone, Copy, Debug)]
struct Fan {
    x: f64,
    y: f64,
}

/// Directions of a group of rays, robot frame.
#[derive(Clone, Copy, Debug)]
struct RayGroup {
    x: [f64; LANES],
    y: [f64; LANES],
}

/// The nearest surfaces met by a group of rays.
#[derive(Clone, Copy, Debug)]
struct Echoes {
    /// 1 / distance of the nearest surface so far, 1/m.
    nearness: [f64; LANES],
    /// Cosine of the incidence there.
    cosine: [f64; LANES],
}

impl RayRing {
    /// A ring of fans of `rays` rays, each fan `cone_rad` wide and its outer rays on the cone's edge.
    /// A ray returns no echo when it meets the nearest surface at an incidence greater than
    /// `critical_rad`; `π/2` loses none.
    #[must_use]
    pub fn new(
        fans: &[RayFan],
        rays: usize,
        cone_rad: f64,
        range_m: f64,
        critical_rad: f64,
    ) -> Self {
        let offsets = offsets_rad(rays.max(1), cone_rad);
        let groups: Vec<RayGroup> = fans
            .iter()
            .flat_map(|fan| {
                offsets.chunks(LANES).map(move |chunk| RayGroup::new(fan.axis_rad, chunk))
            })
            .collect();
        Self {
            fans: fans.iter().map(|fan| Fan::new(fan.place)).collect(),
            groups_per_fan: offsets.len().div_ceil(LANES),
            echoes: vec![Echoes::nothing(range_m); groups.len()],
            groups,
            even: is_even(fans),
            radius_m: fans.iter().map(|fan| fan.place.norm()).fold(0.0, f64::max),
            range_m,
            half_cone_rad: 0.5 * cone_rad,
            least_cosine: if critical_rad < FRAC_PI_2 { libm::cos(critical_rad) } else { 0.0 },
        }
    }

    /// Distance to the nearest echo in each fan from its place, metres, the range where there is none.
    /// The body stands at `position` and `direction` is the unit vector of its heading.
    pub fn scan(&mut self, world: &World, position: Vec2, direction: Vec2, readings_m: &mut [f64]) {
        self.echoes.fill(Echoes::nothing(self.range_m));
        let reach_m = self.range_m + self.radius_m;
        for wall in world.walls() {
            let a = into_frame(wall.a - position, direction);
            let b = into_frame(wall.b - position, direction);
            if (a + b).norm_squared() <= square(2.0 * reach_m + (b - a).abs().sum()) {
                let wall = Segment { a, b };
                if self.even { self.meet(wall) } else { self.meet_all(wall) }
            }
        }
        self.read(readings_m);
    }

    /// The nearest echo of each fan.
    fn read(&self, readings_m: &mut [f64]) {
        let fans = self.echoes.chunks_exact(self.groups_per_fan);
        for (echoes, reading_m) in fans.zip(readings_m) {
            *reading_m = nearest_m(echoes, self.least_cosine, self.range_m);
        }
    }

    /// Tries the fans that may meet a wall given in the robot's frame.
    fn meet(&mut self, wall: Segment) {
        let fans = self.fans.len();
        let per_radian = fans as f64 / TAU;
        let (from_rad, width_rad) = spanned(wall);
        let slack_rad = self.half_cone_rad + MARGIN_RAD;
        let first = libm::ceil((from_rad - slack_rad) * per_radian) as i64;
        let last = libm::floor((from_rad + width_rad + slack_rad) * per_radian) as i64;
        let count = ((last - first + 1).max(0) as usize).min(fans);
        let mut fan = first.rem_euclid(fans as i64) as usize;
        for _ in 0..count {
            self.try_fan(fan, wall);
            fan = if fan + 1 == fans { 0 } else { fan + 1 };
        }
    }

    fn meet_all(&mut self, wall: Segment) {
        (0..self.fans.len()).for_each(|fan| self.try_fan(fan, wall));
    }

    fn try_fan(&mut self, fan: usize, wall: Segment) {
        let Fan { x, y } = self.fans[fan];
        let (wx, wy) = (wall.a.x - x, wall.a.y - y);
        let (ex, ey) = (wall.b.x - wall.a.x, wall.b.y - wall.a.y);
        // 1/distance along direction d is (d × e) / (w × e); both e and w are scaled once here.
        let scale = 1.0 / (wx * ey - wy * ex);
        let edge = Scaled { wx: wx * scale, wy: wy * scale, ex: ex * scale, ey: ey * scale };
        let groups = fan * self.groups_per_fan..(fan + 1) * self.groups_per_fan;
        let pairs = self.groups[groups.clone()].iter().zip(&mut self.echoes[groups]);
        if self.least_cosine > 0.0 {
            let cosine_per_nearness = 1.0 / libm::sqrt(edge.ex * edge.ex + edge.ey * edge.ey);
            pairs.for_each(|(rays, echoes)| echoes.keep_nearer(rays, edge, cosine_per_nearness));
        } else {
            pairs.for_each(|(rays, echoes)| echoes.keep_nearness(rays, edge));
        }
    }
}

/// A wall as seen from one fan, scaled so that `d × e` is 1/distance along `d`.
#[derive(Clone, Copy)]
struct Scaled {
    wx: f64,
    wy: f64,
    ex: f64,
    ey: f64,
}

impl Scaled {
    /// 1/distance along a direction, and whether the wall is there at all.
    #[inline(always)]
    fn meet(self, dx: f64, dy: f64) -> (f64, bool) {
        let nearness = dx * self.ey - dy * self.ex;
        let along = self.wx * dy - self.wy * dx;
        let within =
            (along >= -CORNER_OVERLAP * nearness) & (along <= (1.0 + CORNER_OVERLAP) * nearness);
        (nearness, within)
    }
}

impl Echoes {
    fn nothing(range_m: f64) -> Self {
        Self { nearness: [1.0 / range_m; LANES], cosine: [1.0; LANES] }
    }

    #[inline(always)]
    fn keep_nearness(&mut self, rays: &RayGroup, edge: Scaled) {
        for k in 0..LANES {
            let (nearness, within) = edge.meet(rays.x[k], rays.y[k]);
            let nearer = within & (nearness > self.nearness[k]);
            self.nearness[k] = if nearer { nearness } else { self.nearness[k] };
        }
    }

    #[inline(always)]
    fn keep_nearer(&mut self, rays: &RayGroup, edge: Scaled, cosine_per_nearness: f64) {
        for k in 0..LANES {
            let (nearness, within) = edge.meet(rays.x[k], rays.y[k]);
            if within & (nearness > self.nearness[k]) {
                self.nearness[k] = nearness;
                self.cosine[k] = nearness * cosine_per_nearness;
            }
        }
    }
}

impl Fan {
    fn new(place: Vec2) -> Self {
        Self { x: place.x, y: place.y }
    }
}

impl RayGroup {
    /// Up to a group of rays; the last fills the lanes left over.
    fn new(angle_rad: f64, offsets_rad: &[f64]) -> Self {
        let rays: [Vec2; LANES] =
            std::array::from_fn(|k| unit(angle_rad + offsets_rad[k.min(offsets_rad.len() - 1)]));
        Self { x: rays.map(|ray| ray.x), y: rays.map(|ray| ray.y) }
    }
}

/// Whether fans are spread evenly round a circle, the first along the heading.
fn is_even(fans: &[RayFan]) -> bool {
    let radius_m = fans.first().map_or(0.0, |fan| fan.place.norm());
    fans.iter().enumerate().all(|(index, fan)| {
        let axis_rad = TAU * index as f64 / fans.len() as f64;
        let off_m = (fan.place - unit(axis_rad) * radius_m).norm();
        (fan.axis_rad - axis_rad).abs() < EVEN && off_m < EVEN
    })
}

/// Angles of the rays of a fan from its middle, radians, spread evenly over the cone.
fn offsets_rad(rays: usize, cone_rad: f64) -> Vec<f64> {
    if rays == 1 {
        return vec![0.0];
    }
    (0..rays).map(|ray| cone_rad * (ray as f64 / (rays - 1) as f64 - 0.5)).collect()
}

/// Distance of the nearest echo of a fan, metres.
fn nearest_m(echoes: &[Echoes], least_cosine: f64, range_m: f64) -> f64 {
    let mut nearness = 1.0 / range_m;
    for group in echoes {
        for k in 0..LANES {
            if group.nearness[k] > nearness && group.cosine[k] >= least_cosine {
                nearness = group.nearness[k];
            }
        }
    }
    (1.0 / nearness).min(range_m)
}

/// The angle a wall spans as seen from the origin: where it starts, counter-clockwise, and how wide
/// it is, radians. The error of either end is that of [`rough_angle`].
fn spanned(Segment { a, b }: Segment) -> (f64, f64) {
    let (from, to) = if a.perp(&b) >= 0.0 { (a, b) } else { (b, a) };
    let from_rad = rough_angle(from);
    let width_rad = rough_angle(to) - from_rad;
    // A wall never spans more than half a turn; one pointing at the origin may come out below 0.
    let width_rad = if width_rad < -FRAC_PI_2 { width_rad + TAU } else { width_rad };
    (from_rad, width_rad)
}

/// The angle of a vector to within 0.004 rad.
fn rough_angle(vector: Vec2) -> f64 {
    let (x, y) = (vector.x.abs(), vector.y.abs());
    let (small, large) = if y < x { (y, x) } else { (x, y) };
    let ratio = if large > 0.0 { small / large } else { 0.0 };
    // atan z ≈ z (π/4 + 0.273 (1 − z)) on [0, 1].
    let octant = ratio * (FRAC_PI_2 * 0.5 + 0.273 * (1.0 - ratio));
    let quadrant = if y < x { octant } else { FRAC_PI_2 - octant };
    let half = if vector.x < 0.0 { PI - quadrant } else { quadrant };
    if vector.y < 0.0 { -half } else { half }
}

/// A displacement in the world frame as seen by a body heading along `direction`.
fn into_frame(displacement: Vec2, direction: Vec2) -> Vec2 {
    Vec2::new(
        displacement.x * direction.x + displacement.y * direction.y,
        displacement.y * direction.x - displacement.x * direction.y,
    )
}

fn square(value: f64) -> f64 {
    value * value
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::geometry::{rotate, wrap_angle};
    use crate::world::examples::{all_files, room_file, world};

    const FANS: usize = 24;

    /// Fans spread evenly round the B21.
    fn even() -> Vec<RayFan> {
        let fan = |index: usize| {
            let axis_rad = TAU * index as f64 / FANS as f64;
            RayFan { place: unit(axis_rad) * 0.265, axis_rad }
        };
        (0..FANS).map(fan).collect()
    }

    /// Readings with every fan tried against every wall.
    fn tried_all(ring: &mut RayRing, world: &World, at: Vec2, direction: Vec2) -> [f64; FANS] {
        let mut readings = [0.0; FANS];
        ring.echoes.fill(Echoes::nothing(ring.range_m));
        for wall in world.walls() {
            let (a, b) = (into_frame(wall.a - at, direction), into_frame(wall.b - at, direction));
            ring.meet_all(Segment { a, b });
        }
        ring.read(&mut readings);
        readings
    }

    /// Readings from single rays cast in the world frame.
    fn cast_singly(ring: &RayRing, world: &World, at: Vec2, direction: Vec2) -> [f64; FANS] {
        let critical_rad = libm::acos(ring.least_cosine);
        std::array::from_fn(|fan| {
            let Fan { x, y } = ring.fans[fan];
            let origin = at + rotate(Vec2::new(x, y), direction);
            let groups = &ring.groups[fan * ring.groups_per_fan..(fan + 1) * ring.groups_per_fan];
            let rays = groups.iter().flat_map(|group| group.x.into_iter().zip(group.y));
            let hits = rays.filter_map(|(x, y)| {
                world.nearest_m(origin, rotate(Vec2::new(x, y), direction), ring.range_m)
            });
            hits.filter(|hit| hit.incidence_rad <= critical_rad)
                .map(|hit| hit.distance_m)
                .fold(ring.range_m, f64::min)
        })
    }

    proptest! {
        #[test]
        fn leaving_out_fans_changes_no_bit(
            world_index in 0..3usize, x in -1.2..5.3f64, y in -3.2..2.2f64,
            heading_rad in -3.2..3.2f64, rays in 1..9usize, cone_rad in 0.0..1.5f64,
            range_m in 0.5..10.0f64,
        ) {
            let world = world(&all_files()[world_index]);
            let (at, direction) = (Vec2::new(x, y), unit(heading_rad));
            prop_assume!(world.clearance_m(at) > 0.265);
            let mut ring = RayRing::new(&even(), rays, cone_rad, range_m, FRAC_PI_2);
            let mut readings = [0.0; FANS];
            ring.scan(&world, at, direction, &mut readings);
            prop_assert_eq!(readings, tried_all(&mut ring, &world, at, direction));
        }

        #[test]
        fn a_ring_reads_what_its_single_rays_meet(
            x in -1.2..5.3f64, y in -3.2..2.2f64, heading_rad in -3.2..3.2f64,
            critical_rad in 0.3..1.6f64, shift_m in 0.0..0.1f64,
        ) {
            let world = world(&all_files()[2]);
            let (at, direction) = (Vec2::new(x, y), unit(heading_rad));
            prop_assume!(world.clearance_m(at) > 0.365);
            // With a shift the fans lie anyhow, as those of a body that is not round do.
            let mut fans = even();
            fans.iter_mut().step_by(3).for_each(|fan| fan.place.y += shift_m);
            let mut ring = RayRing::new(&fans, 5, 0.26, 4.0, critical_rad);
            let mut readings = [0.0; FANS];
            ring.scan(&world, at, direction, &mut readings);
            let expected = cast_singly(&ring, &world, at, direction);
            for fan in 0..FANS {
                prop_assert!((readings[fan] - expected[fan]).abs() < 1e-9, "fan {}", fan);
            }
        }
    }

    #[test]
    fn readings_in_a_square_room_are_those_of_trigonometry() {
        let room = world(&room_file(4.0, 4.0));
        let mut ring = RayRing::new(&even(), 5, 15.0_f64.to_radians(), 8.0, FRAC_PI_2);
        let mut readings = [0.0; FANS];
        ring.scan(&room, Vec2::zeros(), Vec2::x(), &mut readings);
        let to_wall = |sonar_deg: f64, ray_deg: f64| {
            (2.0 - 0.265 * sonar_deg.to_radians().cos()) / ray_deg.to_radians().cos()
        };
        // The nearest ray is the one of the cone that comes closest to the wall's normal.
        let eighth =
            [to_wall(0.0, 0.0), to_wall(15.0, 7.5), to_wall(30.0, 22.5), to_wall(45.0, 37.5)];
        for (sonar, reading) in readings.into_iter().enumerate() {
            let from_axis = sonar % 6;
            let expected = eighth[from_axis.min(6 - from_axis)];
            assert!((reading - expected).abs() < 1e-12, "sonar {sonar}: {reading} {expected}");
        }
    }

    #[test]
    fn nothing_within_range_reads_the_range() {
        let room = world(&room_file(40.0, 40.0));
        let mut ring = RayRing::new(&even(), 5, 0.26, 8.0, FRAC_PI_2);
        let mut readings = [0.0; FANS];
        ring.scan(&room, Vec2::zeros(), Vec2::x(), &mut readings);
        assert_eq!(readings, [8.0; FANS]);
    }

    #[test]
    fn the_rough_angle_is_within_its_promise() {
        for step in -31_416..=31_416 {
            let angle_rad = f64::from(step) * 1e-4;
            let off = wrap_angle(rough_angle(unit(angle_rad)) - angle_rad);
            assert!(off.abs() < 0.004, "{angle_rad}: {off}");
        }
    }
}
