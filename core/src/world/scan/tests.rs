use std::f64::consts::TAU;

use proptest::prelude::*;

use super::*;
use crate::geometry::rotate;
use crate::simd::levels;
use crate::world::bearing::into_frame;
use crate::world::examples::{all_files, any_place, any_segments, room_file, world};
use crate::world::segments::Segment;

const FANS: usize = 24;

/// Fans spread evenly round a circle.
fn even(fans: usize, radius_m: f64) -> Vec<RayFan> {
    let fan = |index: usize| {
        let axis_rad = TAU * index as f64 / fans as f64;
        RayFan { place: unit(axis_rad) * radius_m, axis_rad }
    };
    (0..fans).map(fan).collect()
}

/// Fans spread evenly or anyhow, up to half a metre from the centre.
fn any_fans() -> impl Strategy<Value = Vec<RayFan>> {
    let anyhow = (-0.4..0.4f64, -0.4..0.4f64, -7.0..7.0f64)
        .prop_map(|(x, y, axis_rad)| RayFan { place: Vec2::new(x, y), axis_rad });
    prop_oneof![
        (1..30usize, 0.0..0.5f64).prop_map(|(fans, radius_m)| even(fans, radius_m)),
        prop::collection::vec(anyhow, 1..12),
    ]
}

/// Readings with every block tried against every wall, in the world's order.
fn tried_all(ring: &mut RayRing, walls: &[Segment], at: Vec2, direction: Vec2) -> Vec<f64> {
    ring.heard.clear(ring.shell.range_m);
    for &wall in walls {
        let a = into_frame(wall.a - at, direction);
        let e = into_frame(wall.b - at, direction) - a;
        let wall = Wall { ax: a.x, ay: a.y, ex: e.x, ey: e.y };
        for block in 0..ring.shell.places.len() {
            ring.shell.try_block(&mut ring.heard, block, wall);
        }
    }
    let mut readings = vec![0.0; ring.shell.fans];
    ring.read(&mut readings);
    readings
}

/// Readings of a scan with the instructions of a level.
fn scanned(
    ring: &mut RayRing,
    level: Level,
    segments: &Segments,
    at: Vec2,
    direction: Vec2,
) -> Vec<f64> {
    let mut readings = vec![0.0; ring.shell.fans];
    ring.scan_at(level, segments, at, direction, &mut readings);
    readings
}

/// Readings from single rays cast in the world frame.
fn cast_singly(ring: &RayRing, world: &World, at: Vec2, direction: Vec2) -> [f64; FANS] {
    let shell = &ring.shell;
    let critical_rad = libm::acos(shell.least_cosine);
    std::array::from_fn(|fan| {
        let (block, lane) = (fan / LANES, fan % LANES);
        let place = Vec2::new(shell.places[block].x[lane], shell.places[block].y[lane]);
        let origin = at + rotate(place, direction);
        let rays = shell.directions[block * shell.rays..][..shell.rays].iter();
        let hits = rays.filter_map(|rays| {
            let ray = Vec2::new(rays.x[lane], rays.y[lane]);
            world.nearest_m(origin, rotate(ray, direction), shell.range_m)
        });
        hits.filter(|hit| hit.incidence_rad <= critical_rad)
            .map(|hit| hit.distance_m)
            .fold(shell.range_m, f64::min)
    })
}

proptest! {
    #[test]
    fn leaving_out_walls_and_fans_changes_no_bit(
        walls in any_segments(), at in any_place(), heading_rad in -3.2..3.2f64,
        fans in any_fans(), rays in 1..9usize, cone_rad in 0.0..1.5f64, range_m in 0.5..30.0f64,
        critical_rad in 0.3..3.0f64,
    ) {
        let segments = Segments::new(walls.clone());
        let direction = unit(heading_rad);
        let mut ring = RayRing::new(&fans, rays, cone_rad, range_m, critical_rad);
        let expected = tried_all(&mut ring, &walls, at, direction);
        for level in levels() {
            let readings = scanned(&mut ring, level, &segments, at, direction);
            prop_assert_eq!(&readings, &expected, "{:?}", level);
        }
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
        let mut fans = even(FANS, 0.265);
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
    let mut ring = RayRing::new(&even(FANS, 0.265), 5, 15.0_f64.to_radians(), 8.0, FRAC_PI_2);
    let mut readings = [0.0; FANS];
    ring.scan(&room, Vec2::zeros(), Vec2::x(), &mut readings);
    let to_wall = |sonar_deg: f64, ray_deg: f64| {
        (2.0 - 0.265 * sonar_deg.to_radians().cos()) / ray_deg.to_radians().cos()
    };
    // The nearest ray is the one of the cone that comes closest to the wall's normal.
    let eighth = [to_wall(0.0, 0.0), to_wall(15.0, 7.5), to_wall(30.0, 22.5), to_wall(45.0, 37.5)];
    for (sonar, reading) in readings.into_iter().enumerate() {
        let from_axis = sonar % 6;
        let expected = eighth[from_axis.min(6 - from_axis)];
        assert!((reading - expected).abs() < 1e-12, "sonar {sonar}: {reading} {expected}");
    }
}

#[test]
fn nothing_within_range_reads_the_range() {
    let room = world(&room_file(40.0, 40.0));
    let mut ring = RayRing::new(&even(FANS, 0.265), 5, 0.26, 8.0, FRAC_PI_2);
    let mut readings = [0.0; FANS];
    ring.scan(&room, Vec2::zeros(), Vec2::x(), &mut readings);
    assert_eq!(readings, [8.0; FANS]);
}
