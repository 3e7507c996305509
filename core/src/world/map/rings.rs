//! The boundary between free and all other cells, followed along the edges of the cells.

use super::grid::{Cell, OccupancyGrid};

/// Right, up, left, down; each the last one turned to the left.
const STEPS: [[i32; 2]; 4] = [[1, 0], [0, 1], [-1, 0], [0, -1]];

/// Offsets from a corner of the grid to the cells ahead of it, on the left and on the right, for each
/// of [`STEPS`].
const AHEAD: [[[i32; 2]; 2]; 4] =
    [[[0, 0], [0, -1]], [[-1, 0], [0, 0]], [[-1, -1], [-1, 0]], [[0, -1], [-1, -1]]];

/// All boundaries as rings of corners, in cells from the lower left corner of the grid, with the free
/// cells on the left. A ring begins with the leftmost of its lowest edges that run to the right.
pub(super) fn rings(grid: &OccupancyGrid) -> Vec<Vec<[i32; 2]>> {
    let (columns, rows) = (grid.columns() as i32, grid.rows() as i32);
    let mut tracer = Tracer { grid, followed: vec![false; grid.columns() * grid.rows()] };
    let mut rings = Vec::new();
    for row in 0..rows {
        for column in 0..columns {
            let edge = tracer.is_free([column, row]) && !tracer.is_free([column, row - 1]);
            if edge && !tracer.followed[tracer.index([column, row])] {
                rings.push(tracer.follow([column, row]));
            }
        }
    }
    rings
}

struct Tracer<'a> {
    grid: &'a OccupancyGrid,
    /// Cells whose lower edge belongs to a ring already.
    followed: Vec<bool>,
}

impl Tracer<'_> {
    fn is_free(&self, [column, row]: [i32; 2]) -> bool {
        let cell = usize::try_from(column).ok().zip(usize::try_from(row).ok());
        cell.is_some_and(|(column, row)| self.grid.cell(column, row) == Cell::Free)
    }

    fn index(&self, [column, row]: [i32; 2]) -> usize {
        row as usize * self.grid.columns() + column as usize
    }

    /// Follows a boundary from the lower left corner of a cell to the right and round to it.
    fn follow(&mut self, start: [i32; 2]) -> Vec<[i32; 2]> {
        let mut corners = vec![start];
        let (mut at, mut way) = (start, 0);
        loop {
            if way == 0 {
                let cell = self.index(at);
                self.followed[cell] = true;
            }
            at = plus(at, STEPS[way]);
            let turned = self.turn(at, way);
            if at == start && turned == 0 {
                return corners;
            }
            if turned != way {
                corners.push(at);
            }
            way = turned;
        }
    }

    /// The way on from a corner. Where two free cells touch only there, it stays with the one that it
    /// came along, since nothing can pass between them.
    fn turn(&self, at: [i32; 2], way: usize) -> usize {
        let [left, right] = AHEAD[way].map(|offset| self.is_free(plus(at, offset)));
        match (left, right) {
            (false, _) => (way + 1) % 4,
            (true, false) => way,
            (true, true) => (way + 3) % 4,
        }
    }
}

fn plus(a: [i32; 2], b: [i32; 2]) -> [i32; 2] {
    [a[0] + b[0], a[1] + b[1]]
}
