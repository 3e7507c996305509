//! Dijkstra's algorithm over the places that whole steps from home lead to.
//!
//! Places are kept as they are, not moved to the grid, so that every path found can be driven. The grid
//! only says which places are alike: of those in one cell the cheapest is kept. What that loses, the
//! refinement has to find again.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::f64::consts::TAU;

use crate::geometry::{Pose, Vec2};
use crate::world::World;

use super::drive::{Driver, Place};

/// Way beyond the walls that a path may take, metres.
const MARGIN_M: f64 = 1.0;
/// Most cells; in a world too large for that they are larger.
const MOST_CELLS: f64 = 4e6;
/// The parent of home.
const NOBODY: u32 = u32::MAX;

/// Cells over a world, each with the least cost a place in it was reached at.
pub(super) struct Grid {
    origin: Vec2,
    columns: usize,
    rows: usize,
    cell_m: f64,
    headings: u32,
    least: Vec<f64>,
}

/// A place reached.
struct Node {
    place: Place,
    cost: f64,
    steps: u32,
    parent: u32,
    heading_rad: f64,
}

/// Nodes by cost, then by steps, then by age. Costs are never negative, and then the order of their
/// bits is that of their values.
type Queue = BinaryHeap<Reverse<(u64, u32, u32)>>;

impl Grid {
    /// Cells over a whole world, with so many headings tried at each place.
    pub(super) fn over(world: &World, cell_m: f64, headings: u32) -> Self {
        let [x0, y0, x1, y1] = world.bounds_m();
        let margin = Vec2::repeat(MARGIN_M);
        let mut grid =
            Self::new(Vec2::new(x0, y0) - margin, Vec2::new(x1, y1) + margin, cell_m, headings);
        grid.least.fill(f64::INFINITY);
        grid
    }

    /// Cells no farther than `within_m` from the places of a path.
    pub(super) fn along(path: &[Pose], within_m: f64, cell_m: f64, headings: u32) -> Self {
        let places = || path.iter().map(Pose::position);
        let margin = Vec2::repeat(within_m);
        let low = places().fold(Vec2::repeat(f64::INFINITY), |low, place| low.inf(&place));
        let high = places().fold(Vec2::repeat(f64::NEG_INFINITY), |high, place| high.sup(&place));
        let mut grid = Self::new(low - margin, high + margin, cell_m, headings);
        let reach = libm::ceil(within_m / grid.cell_m) as i32;
        for place in places() {
            for (dx, dy) in (-reach..=reach).flat_map(|dx| (-reach..=reach).map(move |dy| (dx, dy)))
            {
                let away = Vec2::new(f64::from(dx), f64::from(dy)) * grid.cell_m;
                let cell = grid.cell(place + away).filter(|_| away.norm() <= within_m);
                if let Some(cell) = cell {
                    grid.least[cell] = f64::INFINITY;
                }
            }
        }
        grid
    }

    /// Cells between two corners, all of them closed: nothing costs less than nothing.
    fn new(low: Vec2, high: Vec2, cell_m: f64, headings: u32) -> Self {
        let extent = high - low;
        let cell_m = cell_m.max(libm::sqrt(extent.x * extent.y / MOST_CELLS));
        let cells = |length_m: f64| libm::ceil(length_m / cell_m) as usize + 1;
        let (columns, rows) = (cells(extent.x), cells(extent.y));
        Self { origin: low, columns, rows, cell_m, headings, least: vec![0.0; columns * rows] }
    }

    /// Headings of the cheapest path to the goal over these cells; none when there is no way.
    pub(super) fn search(mut self, driver: &mut Driver<'_>) -> Option<Vec<f64>> {
        let home =
            Node { place: driver.home(), cost: 0.0, steps: 0, parent: NOBODY, heading_rad: 0.0 };
        let (mut nodes, mut queue) = (Vec::new(), Queue::new());
        self.keep(home, &mut nodes, &mut queue);
        while let Some(Reverse((_, _, index))) = queue.pop() {
            let node = &nodes[index as usize];
            if node.parent != NOBODY && driver.at_goal(node.place) {
                return Some(headings(&nodes, index));
            }
            let cell = self.cell(node.place.position);
            if cell.is_some_and(|cell| node.cost <= self.least[cell]) {
                self.expand(index, driver, &mut nodes, &mut queue);
            }
        }
        None
    }

    /// Takes every heading from a place: straight to the goal, and evenly round.
    fn expand(
        &mut self,
        parent: u32,
        driver: &mut Driver<'_>,
        nodes: &mut Vec<Node>,
        queue: &mut Queue,
    ) {
        let Node { place, cost, steps, .. } = nodes[parent as usize];
        let headings = self.headings;
        let round = (0..headings).map(|k| TAU * f64::from(k) / f64::from(headings));
        for heading_rad in std::iter::once(driver.to_goal_rad(place)).chain(round) {
            let free = driver.free_step(place, heading_rad);
            if free.is_some_and(|(position, more)| !self.improves(position, cost + more)) {
                continue;
            }
            let taken = driver.step(place, heading_rad);
            let cost = cost + taken.penalty;
            let node = Node { place: taken.to, cost, steps: steps + 1, parent, heading_rad };
            self.keep(node, nodes, queue);
        }
    }

    /// Keeps a place that is the cheapest of its cell so far.
    fn keep(&mut self, node: Node, nodes: &mut Vec<Node>, queue: &mut Queue) {
        let Some(cell) = self.cell(node.place.position) else { return };
        if node.cost < self.least[cell] {
            self.least[cell] = node.cost;
            let index = u32::try_from(nodes.len()).unwrap_or(NOBODY);
            queue.push(Reverse((node.cost.to_bits(), node.steps, index)));
            nodes.push(node);
        }
    }

    fn improves(&self, position: Vec2, cost: f64) -> bool {
        self.cell(position).is_some_and(|cell| cost < self.least[cell])
    }

    /// Index of the cell of a point; none outside the grid.
    fn cell(&self, point: Vec2) -> Option<usize> {
        let at = (point - self.origin) / self.cell_m;
        let (column, row) = (libm::floor(at.x), libm::floor(at.y));
        let within = column >= 0.0 && row >= 0.0;
        let (column, row) = (column as usize, row as usize);
        (within && column < self.columns && row < self.rows).then(|| row * self.columns + column)
    }
}

/// The headings that led to a node.
fn headings(nodes: &[Node], last: u32) -> Vec<f64> {
    let mut headings = Vec::new();
    let mut node = &nodes[last as usize];
    while node.parent != NOBODY {
        headings.push(node.heading_rad);
        node = &nodes[node.parent as usize];
    }
    headings.reverse();
    headings
}
