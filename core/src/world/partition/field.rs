//! A grid over a world that knows how much room there is at each place, and ways on it.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::geometry::Vec2;
use crate::world::World;
use crate::world::map::distances2;

/// Edge of a cell, metres.
pub(super) const CELL_M: f64 = 0.1;
/// Floor beyond the bounds that belongs to the grid, metres.
const MARGIN_M: f64 = 1.0;
/// A way through the middle counts a metre double where the nearest wall is this near, metres.
const ROOM_M: f64 = 0.7;

/// What a way should be like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wish {
    /// As short as it goes.
    Short,
    /// With room on both sides.
    Room,
}

/// Room at each place of a grid over the bounds of a world.
pub(super) struct Field {
    corner: Vec2,
    columns: usize,
    rows: usize,
    /// Distance to the nearest wall, cells².
    room2: Vec<i64>,
}

impl Field {
    pub(super) fn new(world: &World) -> Self {
        let [x0, y0, x1, y1] = world.bounds_m();
        let cells = |length_m: f64| libm::ceil((length_m + 2.0 * MARGIN_M) / CELL_M) as usize + 1;
        let (columns, rows) = (cells(x1 - x0), cells(y1 - y0));
        let corner = Vec2::new(x0 - MARGIN_M, y0 - MARGIN_M);
        let mut field = Self { corner, columns, rows, room2: Vec::new() };
        let mut solid = vec![false; columns * rows];
        for wall in world.walls() {
            let pieces = libm::ceil((wall.b - wall.a).norm() / (0.5 * CELL_M));
            for piece in 0..=pieces as usize {
                let point = wall.a + (wall.b - wall.a) * (piece as f64 / pieces);
                solid[field.cell(point)] = true;
            }
        }
        field.room2 = distances2(columns, rows, |cell| solid[cell]);
        field
    }

    pub(super) fn count(&self) -> usize {
        self.room2.len()
    }

    pub(super) fn cell(&self, point: Vec2) -> usize {
        let [column, row] = [(0, self.columns), (1, self.rows)].map(|(axis, count)| {
            let cells = (point[axis] - self.corner[axis]) / CELL_M;
            (cells.max(0.0) as usize).min(count - 1)
        });
        row * self.columns + column
    }

    pub(super) fn centre(&self, cell: usize) -> Vec2 {
        let (column, row) = (cell % self.columns, cell / self.columns);
        self.corner + Vec2::new(column as f64 + 0.5, row as f64 + 0.5) * CELL_M
    }

    /// Distance to the nearest wall, metres; 0 in a wall.
    pub(super) fn room_m(&self, cell: usize) -> f64 {
        libm::sqrt(self.room2[cell] as f64) * CELL_M
    }

    /// The cells around one, with their distances in cells.
    pub(super) fn around(&self, cell: usize) -> impl Iterator<Item = (usize, f64)> {
        const AROUND: [(isize, isize); 8] =
            [(-1, 0), (1, 0), (0, -1), (0, 1), (-1, -1), (1, -1), (-1, 1), (1, 1)];
        let (column, row) = ((cell % self.columns) as isize, (cell / self.columns) as isize);
        let (width, height) = (self.columns as isize, self.rows as isize);
        AROUND.iter().filter_map(move |(right, up)| {
            let (column, row) = (column + right, row + up);
            let inside = (0..width).contains(&column) && (0..height).contains(&row);
            let length = if *right != 0 && *up != 0 { std::f64::consts::SQRT_2 } else { 1.0 };
            inside.then_some(((row * width + column) as usize, length))
        })
    }

    /// Cells of a way for a robot of a radius from one place to another, or to the nearest place that
    /// can be reached (Dijkstra).
    pub(super) fn way(&self, from: Vec2, to: Vec2, radius_m: f64, wish: Wish) -> Vec<usize> {
        let (start, end) = (self.cell(from), self.cell(to));
        let mut costs = vec![u64::MAX; self.count()];
        let mut before = vec![usize::MAX; self.count()];
        let mut open = BinaryHeap::from([(Reverse(0), start)]);
        costs[start] = 0;
        let mut nearest = (f64::INFINITY, start);
        while let Some((Reverse(cost), cell)) = open.pop() {
            if cost > costs[cell] {
                continue;
            }
            let left = (self.centre(cell) - self.centre(end)).norm();
            if left < nearest.0 {
                nearest = (left, cell);
            }
            if cell == end {
                break;
            }
            for (next, length) in self.around(cell) {
                if !self.fits(next, radius_m) {
                    continue;
                }
                let near = ROOM_M / self.room_m(next);
                let weight = if wish == Wish::Room { 1.0 + near * near } else { 1.0 };
                // Whole thousandths of a cell, so that sums do not depend on their order.
                let sum = cost + (1000.0 * length * weight) as u64;
                if sum < costs[next] {
                    (costs[next], before[next]) = (sum, cell);
                    open.push((Reverse(sum), next));
                }
            }
        }
        let back = std::iter::successors(Some(nearest.1), |&cell| {
            (before[cell] != usize::MAX).then(|| before[cell])
        });
        let mut way: Vec<usize> = back.collect();
        way.reverse();
        way
    }

    /// Length of a way after pulling it taut, metres.
    pub(super) fn taut_length_m(&self, way: &[usize], radius_m: f64) -> f64 {
        let (mut length_m, mut at) = (0.0, 0);
        while at + 1 < way.len() {
            let sees = |&next: &usize| self.straight_fits(way[at], way[next], radius_m);
            let mut next = at + 1;
            // The farthest place in sight; sight comes and goes a little, so look on for a while.
            for ahead in at + 2..way.len().min(at + 400) {
                if sees(&ahead) {
                    next = ahead;
                }
            }
            length_m += (self.centre(way[next]) - self.centre(way[at])).norm();
            at = next;
        }
        length_m
    }

    fn straight_fits(&self, from: usize, to: usize, radius_m: f64) -> bool {
        let (from, to) = (self.centre(from), self.centre(to));
        let pieces = libm::ceil((to - from).norm() / (0.5 * CELL_M)).max(1.0);
        (0..=pieces as usize).all(|piece| {
            self.fits(self.cell(from + (to - from) * (piece as f64 / pieces)), radius_m)
        })
    }

    /// Whether a robot can be at a cell, give or take a cell.
    fn fits(&self, cell: usize, radius_m: f64) -> bool {
        self.room_m(cell) >= radius_m - 0.5 * CELL_M
    }
}
