use proptest::prelude::*;

use super::simplify::{TOLERANCE, simplified};
use super::*;
use crate::geometry::{Vec2, angle};
use crate::world::{crossings, points};

/// A map drawn with characters, the first line on top: ` ` free, `#` occupied, `?` unknown.
fn drawn(lines: &[&str]) -> OccupancyGrid {
    let columns = lines.iter().map(|line| line.len()).max().unwrap_or(0);
    OccupancyGrid::new(columns, lines.len(), 1.0, [0.0; 3], |column, row| {
        match lines[lines.len() - 1 - row].as_bytes().get(column) {
            Some(b' ') => Cell::Free,
            Some(b'#') => Cell::Occupied,
            _ => Cell::Unknown,
        }
    })
    .expect("a small map")
}

fn any_grid() -> impl Strategy<Value = OccupancyGrid> {
    // Blocks of several sizes make walls, corners, staircases and specks.
    let block = (0..24usize, 0..24usize, 1..9usize, 1..9usize, any::<bool>(), any::<bool>());
    prop::collection::vec(block, 1..14).prop_map(|blocks| {
        let mut free = vec![false; 24 * 24];
        for (left, below, width, height, is_free, slanted) in blocks {
            for row in below..(below + height).min(24) {
                let shift = if slanted { row - below } else { 0 };
                for column in (left + shift).min(24)..(left + shift + width).min(24) {
                    free[row * 24 + column] = is_free;
                }
            }
        }
        free[0] = true;
        OccupancyGrid::new(24, 24, 1.0, [0.0; 3], |column, row| {
            if free[row * 24 + column] { Cell::Free } else { Cell::Occupied }
        })
        .expect("a small map")
    })
}

fn distance(point: Vec2, a: Vec2, b: Vec2) -> f64 {
    let edge = b - a;
    let along = ((point - a).dot(&edge) / edge.norm_squared()).clamp(0.0, 1.0);
    (point - a - edge * along).norm()
}

/// Distance from a point to a closed ring.
fn to_ring(point: Vec2, ring: &[[f64; 2]]) -> f64 {
    let ends = ring.iter().zip(ring.iter().cycle().skip(1));
    ends.map(|(&a, &b)| distance(point, a.into(), b.into())).fold(f64::INFINITY, f64::min)
}

fn as_f64(ring: &[[i32; 2]]) -> Vec<[f64; 2]> {
    ring.iter().map(|corner| corner.map(f64::from)).collect()
}

proptest! {
    #[test]
    fn the_traced_and_the_simplified_rings_hold_exactly_the_free_cells(grid in any_grid()) {
        let traced = rings::rings(&grid);
        let exact: Vec<_> = traced.iter().map(|ring| as_f64(ring)).collect();
        let simple: Vec<_> = traced.iter().map(|ring| simplified(ring)).collect();
        for (column, row) in (0..24).flat_map(|row| (0..24).map(move |column| (column, row))) {
            let centre = Vec2::new(column as f64 + 0.5, row as f64 + 0.5);
            let free = grid.cell(column, row) == Cell::Free;
            for (which, rings) in [("traced", &exact), ("simplified", &simple)] {
                prop_assert_eq!(crossings(&points(rings), centre) % 2 == 1, free, "{} {}", which, centre);
            }
        }
    }

    #[test]
    fn a_simplified_ring_is_nowhere_farther_than_half_a_cell(grid in any_grid()) {
        for ring in rings::rings(&grid) {
            let (exact, simple) = (as_f64(&ring), simplified(&ring));
            prop_assert!((3..=exact.len()).contains(&simple.len()), "{:?} {:?}", exact, simple);
            for (from, onto) in [(&exact, &simple), (&simple, &exact)] {
                for (&a, &b) in from.iter().zip(from.iter().cycle().skip(1)) {
                    let (a, b): (Vec2, Vec2) = (a.into(), b.into());
                    for step in 0..=16 {
                        let point = a + (b - a) * (f64::from(step) / 16.0);
                        let found = to_ring(point, onto);
                        prop_assert!(found <= TOLERANCE + 1e-9, "{} from {}", found, point);
                    }
                }
            }
        }
    }
}

#[test]
fn rooms_are_squares_and_slanted_walls_are_straight() {
    let room = drawn(&["######", "#    #", "#  # #", "#    #", "######"]);
    let plan = floor_plan(&room).expect("a room");
    assert_eq!(plan.rings[0], [[1.0, 1.0], [5.0, 1.0], [5.0, 4.0], [1.0, 4.0]]);
    assert_eq!(plan.rings[1].len(), 4, "the pillar");
    assert_eq!((plan.segments_before, plan.segments_after), (8, 8));

    // A floor under a slope of one in three, 90 cells wide.
    let slope = OccupancyGrid::new(90, 40, 1.0, [0.0; 3], |column, row| {
        if row <= 3 + column / 3 { Cell::Free } else { Cell::Unknown }
    });
    let plan = floor_plan(&slope.expect("a small map")).expect("a floor");
    assert_eq!(plan.segments_before, 62);
    assert!(plan.segments_after <= 6, "{:?}", plan.rings);
}

#[test]
fn free_cells_that_touch_at_a_corner_are_apart_and_walls_there_are_closed() {
    let plan = floor_plan(&drawn(&["####", "## #", "# ##", "####"])).expect("two cells");
    assert_eq!(plan.rings.len(), 2);
    let diagonal = drawn(&["       ", " #     ", "  #    ", "   #   ", "       "]);
    assert_eq!(floor_plan(&diagonal).expect("a floor").rings.len(), 2, "one floor, one wall");
}

#[test]
fn unknown_cells_beside_free_ones_are_walls() {
    let plan = floor_plan(&drawn(&["???", "? ?", "???"])).expect("a cell");
    assert_eq!(plan.segments_before, 4);
}

#[test]
fn specks_smaller_than_asked_for_are_dropped() {
    let lines = [
        "##########",
        "#        #",
        "# #  ##  #",
        "#  #     #",
        "#        #",
        "##########",
        "# ########",
    ];
    let (count, rings) = (
        |area_m2| drawn(&lines).drop_specks(area_m2),
        |area_m2| {
            let mut grid = drawn(&lines);
            grid.drop_specks(area_m2).expect("an area");
            rings::rings(&grid).len()
        },
    );
    assert_eq!(count(0.0), Ok(0));
    // The slanted pair is one patch of two cells, like the level one.
    assert_eq!((count(1.0), rings(1.0)), (Ok(0), 4));
    assert_eq!((count(2.0), rings(2.0)), (Ok(1), 3), "the free cell outside");
    assert_eq!((count(2.5), rings(2.5)), (Ok(3), 1));
    assert!(count(-1.0).is_err() && count(f64::NAN).is_err());
}

#[test]
fn a_crop_keeps_the_cells_whose_centres_lie_in_it() {
    let grid = drawn(&["    ", " ## ", "    "]);
    let part = grid.crop([1.2, 0.4, 3.4, 1.6]).expect("a part");
    assert_eq!((part.columns(), part.rows()), (3, 2));
    assert_eq!(part.point_m(0.0, 0.0), Vec2::new(1.0, 0.0));
    let cells: Vec<Cell> = (0..2)
        .flat_map(|row| (0..3).map(move |column| (column, row)))
        .map(|(column, row)| part.cell(column, row))
        .collect();
    use Cell::{Free, Occupied, Unknown};
    assert_eq!(cells, [Free, Free, Unknown, Occupied, Occupied, Unknown]);
    for wrong in [[0.0, 0.0, 0.0, 1.0], [2.0, 0.0, 1.0, 1.0], [9.0, 0.0, 12.0, 1.0], [f64::NAN; 4]]
    {
        assert_eq!(grid.crop(wrong).expect_err("no part").field(), "crop", "{wrong:?}");
    }
}

#[test]
fn a_map_that_makes_no_sense_is_refused_by_field() {
    let new = |columns, rows, resolution_m, origin| {
        OccupancyGrid::new(columns, rows, resolution_m, origin, |_, _| Cell::Free)
            .and_then(|grid| floor_plan(&grid))
            .expect_err("it makes no sense")
            .field()
    };
    for (expected, found) in [
        ("image", new(0, 5, 0.1, [0.0; 3])),
        ("image", new(10_000, 10_000, 0.1, [0.0; 3])),
        ("image", new(usize::MAX, usize::MAX, 0.1, [0.0; 3])),
        ("resolution", new(2, 2, 0.0, [0.0; 3])),
        ("resolution", new(2, 2, -0.1, [0.0; 3])),
        ("resolution", new(2, 2, f64::NAN, [0.0; 3])),
        ("resolution", new(2, 2, 101.0, [0.0; 3])),
        ("origin[2]", new(2, 2, 0.1, [0.0, 0.0, f64::INFINITY])),
    ] {
        assert_eq!(found, expected);
    }
    let solid = drawn(&["##", "??"]);
    let error = floor_plan(&solid).expect_err("nowhere to drive");
    assert_eq!(error, MapError::NoFreeCell { occupied: 2, unknown: 2 });
    // A chequered floor: 40 000 cells, each a ring of four walls.
    let chequered = OccupancyGrid::new(400, 200, 0.1, [0.0; 3], |column, row| {
        if (column + row) % 2 == 0 { Cell::Free } else { Cell::Unknown }
    });
    let error = floor_plan(&chequered.expect("a map")).expect_err("too many walls");
    assert!(matches!(error, MapError::TooManyWalls { limit: WALL_LIMIT, .. }), "{error}");
}

#[test]
fn coordinates_are_rounded_far_below_a_cell() {
    let grid = OccupancyGrid::new(3, 1, 0.1, [0.1, 0.2, 0.3], |_, _| Cell::Free).expect("a map");
    let plan = floor_plan(&grid).expect("a floor");
    for (found, exact) in plan.rings[0].iter().zip([(0.0, 0.0), (3.0, 0.0), (3.0, 1.0), (0.0, 1.0)])
    {
        let exact = grid.point_m(exact.0, exact.1);
        assert!((Vec2::from(*found) - exact).norm() < 1e-4, "{found:?}");
        assert!(found.iter().all(|value| format!("{value}").len() <= 7), "{found:?}");
    }
}

#[test]
fn home_and_goal_are_suggested_where_a_robot_can_be() {
    // Two rooms with a door of 1 m between them, cells of 0.1 m; the second is smaller.
    let grid = OccupancyGrid::new(75, 35, 0.1, [0.0; 3], |column, row| {
        let room = (1..33).contains(&column) && (1..33).contains(&row);
        let other = (34..70).contains(&column) && (1..27).contains(&row);
        let door = column == 33 && (10..20).contains(&row);
        if room || other || door { Cell::Free } else { Cell::Occupied }
    })
    .expect("a map");
    let places = suggest(&grid, 0.265);
    assert!((places.home - Vec2::new(1.7, 1.7)).norm() < 0.3, "{places:?}");
    assert!(places.goal.x > 3.5, "{places:?}");
    assert_eq!(places.heading_rad, angle(places.goal - places.home));
}
