use proptest::prelude::*;

use super::*;
use crate::geometry::unit;

fn rectangle([x0, y0, x1, y1]: [f64; 4], surface: Surface) -> Ring {
    let points = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]].map(Vec2::from).to_vec();
    Ring { points, surfaces: vec![surface; 4] }
}

fn block([x0, y0, x1, y1]: [f64; 4]) -> Ring {
    let mut ring = rectangle([x0, y0, x1, y1], Surface::Block);
    ring.points.reverse();
    ring
}

/// A room of 10 by 8 m with a block in its middle.
fn arena() -> Arena {
    let rings = vec![rectangle([0.0, 0.0, 10.0, 8.0], Surface::Wall), block([4.0, 3.0, 6.0, 5.0])];
    Arena::new(rings).expect("sound")
}

fn near(place: Vec2) -> Near {
    let mut near = Near::default();
    arena().note_near(place, 3.0, &mut near);
    near
}

fn cone(critical_deg: f64) -> Cone {
    Cone::new(15.0_f64.to_radians(), 15, 2.0, critical_deg.to_radians())
}

#[test]
fn echoes_come_from_what_is_met_nearly_head_on() {
    for (case, x, y, axis_deg, critical_deg, expected) in [
        ("a wall ahead", 9.0, 4.0, 0.0, 30.0, Some(1.0)),
        ("too far", 7.0, 4.0, 0.0, 30.0, None),
        // The cone's side meets the wall at an incidence of 45°, and 60° off the axis nothing does.
        ("a wall aslant", 9.0, 4.0, 60.0, 50.0, Some(1.0 / 45_f64.to_radians().cos())),
        ("a wall too aslant", 9.0, 4.0, 60.0, 30.0, None),
        ("a wall aslant, ideal", 9.0, 4.0, 60.0, 90.0, Some(1.0 / 45_f64.to_radians().cos())),
        ("a block", 3.0, 4.0, 0.0, 30.0, Some(1.0)),
    ] {
        let place = Vec2::new(x, y);
        let near = near(place);
        let axis = unit(f64::to_radians(axis_deg));
        let found = Sight { near: &near, rounds: &[], place, axis }.echo_m(&cone(critical_deg));
        match (found, expected) {
            (Some(found), Some(expected)) => {
                assert!((found - expected).abs() < 1e-9, "{case}: {found}");
            }
            _ => assert_eq!(found, expected, "{case}"),
        }
    }
}

#[test]
fn what_is_round_echoes_and_hides() {
    let place = Vec2::new(9.0, 4.0);
    let near = near(place);
    let person = Round { centre: Vec2::new(9.5, 4.0), radius_m: 0.2 };
    let rounds = [person];
    let sight = Sight { near: &near, rounds: &rounds, place, axis: Vec2::x() };
    assert!((sight.echo_m(&cone(30.0)).expect("in the way") - 0.3).abs() < 1e-9);
    assert!((sight.nearest_m(&cone(30.0)) - 0.3).abs() < 1e-12);
    // To its side, an incidence of more than 30° returns nothing, and the wall behind is hidden there.
    let beside = unit(20_f64.to_radians());
    let sight = Sight { axis: beside, ..sight };
    let found = sight.echo_m(&cone(30.0)).expect("by the ray nearest to its middle");
    assert!(found > 0.3 && found < 0.33, "{found}");
}

#[test]
fn corners_of_blocks_are_edges_and_are_heard_only_from_their_side() {
    let arena = arena();
    let edges: Vec<bool> = arena.corners().iter().map(|corner| corner.is_edge).collect();
    assert_eq!(edges, [false, false, false, false, true, true, true, true]);
    let heard = |x: f64, y: f64, axis_deg: f64| -> Vec<(bool, f64)> {
        let place = Vec2::new(x, y);
        let near = near(place);
        let sight = Sight { near: &near, rounds: &[], place, axis: unit(axis_deg.to_radians()) };
        sight
            .corners(&cone(30.0))
            .map(|(corner, distance_m)| (corner.is_edge, distance_m))
            .collect()
    };
    assert_eq!(heard(3.0, 3.0, 0.0), [(true, 1.0)], "beside the block, its edge ahead");
    assert_eq!(heard(3.5, 2.0, 0.0), [], "out of the cone");
    let diagonal = heard(9.0, 7.0, 45.0);
    assert!(!diagonal[0].0 && (diagonal[0].1 - 2_f64.sqrt()).abs() < 1e-12, "a corner of the room");
    assert_eq!(heard(5.0, 2.5, 90.0), [], "behind the block");
}

#[test]
fn rings_that_bound_no_floor_are_refused() {
    let room = || rectangle([0.0, 0.0, 4.0, 4.0], Surface::Wall);
    let mut short = room();
    short.surfaces.pop();
    for (rings, ring, says) in [
        (vec![], 0, "ring round the floor"),
        (vec![short], 0, "one surface for each edge"),
        (vec![block([0.0, 0.0, 1.0, 1.0])], 0, "counter-clockwise"),
        (vec![room(), room()], 1, "clockwise"),
    ] {
        let error = Arena::new(rings).expect_err(says);
        assert!(error.ring == ring && error.problem.contains(says), "{error}");
    }
}

proptest! {
    #[test]
    fn the_nearest_in_a_cone_is_that_of_many_rays(
        x in 0.2..9.8f64, y in 0.2..7.8f64, axis_rad in -3.2..3.2f64,
        px in 0.2..9.8f64, py in 0.2..7.8f64,
    ) {
        let place = Vec2::new(x, y);
        let rounds = [Round { centre: Vec2::new(px, py), radius_m: 0.3 }];
        prop_assume!((place - rounds[0].centre).norm() > 0.35 && arena().is_floor(place));
        let near = near(place);
        let sight = Sight { near: &near, rounds: &rounds, place, axis: unit(axis_rad) };
        let nearest_m = sight.nearest_m(&cone(30.0));
        // Fine fans that together cover the cone.
        let fine = |k: i32| {
            let axis = unit(axis_rad + (f64::from(k) + 0.5) * 0.5_f64.to_radians());
            let slice = Cone::new(0.25_f64.to_radians(), 16, 2.0, 90_f64.to_radians());
            Sight { axis, ..sight }.echo_m(&slice).unwrap_or(2.0)
        };
        let by_rays_m = (-30..30).map(fine).fold(2.0, f64::min);
        prop_assert!(nearest_m <= by_rays_m + 1e-9, "{nearest_m} {by_rays_m}");
        prop_assert!(by_rays_m - nearest_m < 0.01, "{nearest_m} {by_rays_m}");
    }
}
