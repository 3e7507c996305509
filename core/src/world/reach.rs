//! Whether a round robot can drive from home to the goal: a flood fill on a grid.

use crate::geometry::Vec2;

use super::segments::Segment;

/// Edge of a grid cell, metres. Less than twice any robot's radius, so that no wall is stepped over.
pub(super) const CELL_M: f64 = 0.05;

/// A reachable point and its distance to the goal's centre, metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Nearest {
    pub(super) point: Vec2,
    pub(super) distance_m: f64,
}

/// The place nearest to `goal` that a robot can reach from `home`. Places are the centres of grid
/// cells, one of them home itself, no nearer to a wall than the robot's radius.
pub(super) fn nearest_reachable(
    walls: &[Segment],
    bounds_m: [f64; 4],
    radius_m: f64,
    home: Vec2,
    goal: Vec2,
) -> Nearest {
    let mut floor = Floor::new(bounds_m, radius_m, home);
    for wall in walls {
        floor.block(wall, radius_m);
    }
    floor.flood(goal)
}

/// A grid over the bounds and a margin around them, so that the way round the outside counts.
struct Floor {
    origin: Vec2,
    columns: usize,
    rows: usize,
    home: usize,
    /// Cells that are blocked or were visited.
    closed: Vec<bool>,
}

impl Floor {
    fn new([x0, y0, x1, y1]: [f64; 4], radius_m: f64, home: Vec2) -> Self {
        let margin_m = radius_m + 2.0 * CELL_M;
        let cells = |length_m: f64| libm::ceil((length_m + margin_m) / CELL_M) as usize;
        let (left, below) = (cells(home.x - x0), cells(home.y - y0));
        let (columns, rows) = (left + cells(x1 - home.x) + 1, below + cells(y1 - home.y) + 1);
        let origin = home - Vec2::new(left as f64, below as f64) * CELL_M;
        let closed = vec![false; columns * rows];
        Self { origin, columns, rows, home: below * columns + left, closed }
    }

    fn centre(&self, cell: usize) -> Vec2 {
        let (column, row) = (cell % self.columns, cell / self.columns);
        self.origin + Vec2::new(column as f64, row as f64) * CELL_M
    }

    /// Closes the cells whose centres are nearer to a wall than the robot's radius.
    fn block(&mut self, wall: &Segment, radius_m: f64) {
        let (low, high) = if wall.a.y < wall.b.y { (wall.a, wall.b) } else { (wall.b, wall.a) };
        for row in self.span(low.y - radius_m, high.y + radius_m, self.origin.y, self.rows) {
            let y = self.origin.y + row as f64 * CELL_M;
            let (left, right) = reach_along_row(low, high, y - radius_m, y + radius_m);
            let columns = self.span(left - radius_m, right + radius_m, self.origin.x, self.columns);
            for cell in columns.map(|column| row * self.columns + column) {
                // Home was found free to the last bit; rounding in the grid must not close it.
                let open = !self.closed[cell] && cell != self.home;
                if open && wall.distance_m(self.centre(cell)) < radius_m {
                    self.closed[cell] = true;
                }
            }
        }
    }

    /// Cells between two coordinates along an axis.
    fn span(&self, from_m: f64, to_m: f64, origin_m: f64, count: usize) -> std::ops::Range<usize> {
        let first = libm::floor((from_m - origin_m) / CELL_M).max(0.0) as usize;
        let end = (libm::ceil((to_m - origin_m) / CELL_M).max(0.0) as usize + 1).min(count);
        first..end
    }

    /// Visits every cell that can be reached from home, and closes it.
    fn flood(&mut self, goal: Vec2) -> Nearest {
        let mut open = vec![self.home];
        self.closed[self.home] = true;
        let mut nearest = Nearest { point: self.centre(self.home), distance_m: f64::INFINITY };
        while let Some(cell) = open.pop() {
            let point = self.centre(cell);
            let distance_m = (point - goal).norm();
            if distance_m < nearest.distance_m {
                nearest = Nearest { point, distance_m };
            }
            for neighbour in self.neighbours(cell).into_iter().flatten() {
                if !std::mem::replace(&mut self.closed[neighbour], true) {
                    open.push(neighbour);
                }
            }
        }
        nearest
    }

    fn neighbours(&self, cell: usize) -> [Option<usize>; 4] {
        let (column, row) = (cell % self.columns, cell / self.columns);
        [
            (column > 0).then(|| cell - 1),
            (column + 1 < self.columns).then(|| cell + 1),
            (row > 0).then(|| cell - self.columns),
            (row + 1 < self.rows).then(|| cell + self.columns),
        ]
    }
}

/// Least and greatest x of the part of a segment between two heights; `low` is its lower end.
fn reach_along_row(low: Vec2, high: Vec2, from_m: f64, to_m: f64) -> (f64, f64) {
    let rise_m = high.y - low.y;
    if rise_m < CELL_M {
        return (low.x.min(high.x), low.x.max(high.x));
    }
    let x_at = |y: f64| low.x + (high.x - low.x) * ((y - low.y) / rise_m).clamp(0.0, 1.0);
    let (first, last) = (x_at(from_m), x_at(to_m));
    (first.min(last), first.max(last))
}
