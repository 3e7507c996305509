//! Patches of cells too small to count.

use super::grid::Cell;

/// Turns patches of fewer cells than a limit into the other kind, and says how many. Free cells
/// hang together by their edges; all others also by their corners, so that a slanted wall one cell
/// thin is one patch and stops a robot.
pub(super) fn fill(cells: &mut [Cell], columns: usize, limit: f64, free: bool) -> usize {
    let is_kind = |cell: Cell| (cell == Cell::Free) == free;
    let mut seen = vec![false; cells.len()];
    let mut dropped = 0;
    let mut patch = Vec::new();
    for start in 0..cells.len() {
        if seen[start] || !is_kind(cells[start]) {
            continue;
        }
        patch.clear();
        patch.push(start);
        seen[start] = true;
        let mut next = 0;
        while let Some(&cell) = patch.get(next) {
            next += 1;
            for neighbour in neighbours(cell, columns, cells.len(), !free) {
                if !seen[neighbour] && is_kind(cells[neighbour]) {
                    seen[neighbour] = true;
                    patch.push(neighbour);
                }
            }
        }
        if (patch.len() as f64) < limit {
            dropped += 1;
            let other = if free { Cell::Unknown } else { Cell::Free };
            patch.iter().for_each(|&cell| cells[cell] = other);
        }
    }
    dropped
}

/// Cells that share an edge with a cell, or also a corner.
pub(super) fn neighbours(
    cell: usize,
    columns: usize,
    count: usize,
    corners: bool,
) -> impl Iterator<Item = usize> {
    const AROUND: [(isize, isize); 8] =
        [(-1, 0), (1, 0), (0, -1), (0, 1), (-1, -1), (1, -1), (-1, 1), (1, 1)];
    let (column, row) = ((cell % columns) as isize, (cell / columns) as isize);
    let (width, height) = (columns as isize, (count / columns) as isize);
    AROUND[..if corners { 8 } else { 4 }].iter().filter_map(move |(right, up)| {
        let (column, row) = (column + right, row + up);
        let inside = (0..width).contains(&column) && (0..height).contains(&row);
        inside.then_some((row * width + column) as usize)
    })
}
