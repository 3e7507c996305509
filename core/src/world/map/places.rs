//! Where a robot could start and end on a map, to begin with; the user moves both.

use crate::geometry::{Vec2, angle};

use super::distance::distances2;
use super::grid::{Cell, OccupancyGrid};
use super::specks::neighbours;

/// A goal is looked for as far from home as a robot can learn to find in some trials, metres of way.
const WAY_M: f64 = 8.0;

/// A home and a goal that a robot can drive between.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Places {
    /// The roomiest place of the map.
    pub home: Vec2,
    /// A roomy place some way off.
    pub goal: Vec2,
    /// Direction from home to goal, radians.
    pub heading_rad: f64,
}

/// Suggests a home and a goal for a robot of a radius in metres: the roomiest cell, and the roomiest
/// one among those about [`WAY_M`] away along a way that the robot fits through. In a map that has no
/// room for it, both are the roomiest cell.
#[must_use]
pub fn suggest(grid: &OccupancyGrid, radius_m: f64) -> Places {
    let columns = grid.columns();
    let is_solid = |cell: usize| grid.cell(cell % columns, cell / columns) != Cell::Free;
    let room2 = distances2(columns, grid.rows(), is_solid);
    let roomiest = |cells: &mut dyn Iterator<Item = usize>| {
        // Of equally roomy cells the first.
        cells.fold(None, |best: Option<usize>, cell| match best {
            Some(best) if room2[best] >= room2[cell] => Some(best),
            _ => Some(cell),
        })
    };
    let home = roomiest(&mut (0..room2.len())).unwrap_or(0);
    // Half a cell from the centre to the wall of its neighbour, and as much for slack.
    let needed = radius_m / grid.resolution_m() + 1.0;
    let ways = ways(columns, room2.len(), home, |cell| room2[cell] as f64 >= needed * needed);
    let farthest = ways.iter().flatten().max().copied().unwrap_or(0);
    let limit = farthest.min((WAY_M / grid.resolution_m()) as u32);
    let far =
        |cell: &usize| ways[*cell].is_some_and(|way| way <= limit && way >= limit - limit / 5);
    let goal = roomiest(&mut (0..room2.len()).filter(far)).unwrap_or(home);
    let centre = |cell: usize| {
        let (column, row) = (cell % columns, cell / columns);
        grid.point_m(column as f64 + 0.5, row as f64 + 0.5)
    };
    let (home, goal) = (centre(home), centre(goal));
    Places { home, goal, heading_rad: angle(goal - home) }
}

/// Steps from a cell to each other one through open cells.
fn ways(
    columns: usize,
    count: usize,
    start: usize,
    is_open: impl Fn(usize) -> bool,
) -> Vec<Option<u32>> {
    let mut ways = vec![None; count];
    let mut open = std::collections::VecDeque::from([(start, 0)]);
    ways[start] = Some(0);
    while let Some((cell, way)) = open.pop_front() {
        for neighbour in neighbours(cell, columns, count, false) {
            if ways[neighbour].is_none() && is_open(neighbour) {
                ways[neighbour] = Some(way + 1);
                open.push_back((neighbour, way + 1));
            }
        }
    }
    ways
}
