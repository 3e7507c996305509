//! Maps as cells, and the walls traced from them.
//!
//! An [`OccupancyGrid`] says of each cell whether it is free, occupied or unknown. To a robot, what
//! is not known to be free is a wall: [`floor_plan`] follows the boundary between free and all
//! other cells as closed rings and simplifies them within half a cell. The rings are the `floor` of
//! a [`WorldFile`](super::WorldFile), in the world frame and metres.

mod distance;
mod error;
mod grid;
mod places;
mod rings;
mod simplify;
mod specks;
#[cfg(test)]
mod tests;

pub use error::MapError;
pub use grid::{CELL_LIMIT, Cell, OccupancyGrid};
pub use places::{Places, suggest};

pub(in crate::world) use distance::distances2;

use super::{EXTENT_LIMIT_M, WALL_LIMIT};

/// Most corners that are simplified. A room of a house has some hundred; noise has them everywhere.
const CORNER_LIMIT: usize = 2_000_000;

/// The free floor of a map.
#[derive(Clone, Debug, PartialEq)]
pub struct FloorPlan {
    /// Closed rings that bound the floor by the even-odd rule, world frame, metres.
    pub rings: Vec<Vec<[f64; 2]>>,
    /// Straight pieces before simplification.
    pub segments_before: usize,
    /// Straight pieces after it.
    pub segments_after: usize,
}

/// Traces the floor of a map.
///
/// # Errors
/// When no cell is free, or when there are more or wider walls than a world can have.
pub fn floor_plan(grid: &OccupancyGrid) -> Result<FloorPlan, MapError> {
    if grid.count(Cell::Free) == 0 {
        let (occupied, unknown) = (grid.count(Cell::Occupied), grid.count(Cell::Unknown));
        return Err(MapError::NoFreeCell { occupied, unknown });
    }
    let traced = rings::rings(grid);
    let segments_before = traced.iter().map(Vec::len).sum();
    if segments_before > CORNER_LIMIT {
        return Err(MapError::TooManyWalls { limit: CORNER_LIMIT, found: segments_before });
    }
    check_extent(&traced, grid.resolution_m())?;
    let rings: Vec<Vec<[f64; 2]>> = traced
        .iter()
        .map(|ring| simplify::simplified(ring).into_iter().map(|at| rounded_m(grid, at)).collect())
        .collect();
    let segments_after = rings.iter().map(Vec::len).sum();
    if segments_after > WALL_LIMIT {
        return Err(MapError::TooManyWalls { limit: WALL_LIMIT, found: segments_after });
    }
    Ok(FloorPlan { rings, segments_before, segments_after })
}

/// The floor itself must fit into a world; the margins of a map need not.
fn check_extent(rings: &[Vec<[i32; 2]>], resolution_m: f64) -> Result<(), MapError> {
    for axis in [0, 1] {
        let along = || rings.iter().flatten().map(|corner| corner[axis]);
        let (least, most) = (along().min().unwrap_or(0), along().max().unwrap_or(0));
        let found_m = f64::from(most - least) * resolution_m;
        if found_m > EXTENT_LIMIT_M {
            return Err(MapError::TooLarge { limit_m: EXTENT_LIMIT_M, found_m });
        }
    }
    Ok(())
}

/// A place of the grid in the world, rounded to less than a thousandth of a cell so that files stay
/// readable.
fn rounded_m(grid: &OccupancyGrid, [x, y]: [f64; 2]) -> [f64; 2] {
    let decimals = (3.0 - libm::floor(libm::log10(grid.resolution_m()))).clamp(0.0, 12.0);
    let scale = libm::pow(10.0, decimals);
    let point = grid.point_m(x, y);
    // Adding 0 turns -0 into 0.
    [point.x, point.y].map(|value| libm::round(value * scale) / scale + 0.0)
}
