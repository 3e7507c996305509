//! Occupancy grids.

use crate::geometry::{Pose, Vec2, rotate};

use super::error::MapError;
use super::specks;

/// Most cells of a map.
pub const CELL_LIMIT: usize = 16_000_000;

/// What a map says of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cell {
    /// A robot may be there.
    Free,
    /// Something is there.
    Occupied,
    /// Nobody looked, or could not tell.
    Unknown,
}

/// A map of square cells. Row 0 is the lowest; cell `(0, 0)` has its lower left corner at the
/// origin, and the rows run along the origin's heading.
#[derive(Clone, Debug, PartialEq)]
pub struct OccupancyGrid {
    columns: usize,
    rows: usize,
    cells: Vec<Cell>,
    resolution_m: f64,
    origin: Pose,
}

impl OccupancyGrid {
    /// A map from a function of column and row. `origin` is x and y in metres and yaw in radians.
    ///
    /// # Errors
    /// When the size, the resolution or the origin make no sense.
    pub fn new(
        columns: usize,
        rows: usize,
        resolution_m: f64,
        origin: [f64; 3],
        cell: impl Fn(usize, usize) -> Cell,
    ) -> Result<Self, MapError> {
        Self::check_size(columns as u64, rows as u64)?;
        if !(resolution_m.is_finite() && resolution_m > 0.0) {
            return Err(MapError::Resolution { found: resolution_m });
        }
        if let Some(index) = origin.iter().position(|value| !value.is_finite()) {
            return Err(MapError::Origin { index, found: origin[index] });
        }
        let cells = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
        let cells = cells.map(|(column, row)| cell(column, row)).collect();
        let origin = Pose::new(origin[0], origin[1], origin[2]);
        Ok(Self { columns, rows, cells, resolution_m, origin })
    }

    /// Whether a map of this size can be handled; costs nothing.
    ///
    /// # Errors
    /// When it has no cell, or more than [`CELL_LIMIT`].
    pub fn check_size(columns: u64, rows: u64) -> Result<(), MapError> {
        match columns.checked_mul(rows) {
            Some(0) => Err(MapError::NoCells { columns, rows }),
            Some(cells) if cells <= CELL_LIMIT as u64 => Ok(()),
            _ => Err(MapError::TooManyCells { columns, rows, limit: CELL_LIMIT as u64 }),
        }
    }

    /// Cells in a row.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Edge of a cell, metres.
    #[must_use]
    pub fn resolution_m(&self) -> f64 {
        self.resolution_m
    }

    /// Pose of the lower left corner, from which the rows run along the heading.
    #[must_use]
    pub fn origin(&self) -> Pose {
        self.origin
    }

    /// A cell; what lies outside is unknown.
    #[must_use]
    pub fn cell(&self, column: usize, row: usize) -> Cell {
        if column < self.columns && row < self.rows {
            self.cells[row * self.columns + column]
        } else {
            Cell::Unknown
        }
    }

    /// How many cells are of a kind.
    #[must_use]
    pub fn count(&self, kind: Cell) -> usize {
        self.cells.iter().filter(|cell| **cell == kind).count()
    }

    /// Area of the free cells, square metres.
    #[must_use]
    pub fn free_area_m2(&self) -> f64 {
        self.count(Cell::Free) as f64 * self.resolution_m * self.resolution_m
    }

    /// A place given in cells from the lower left corner, in the world frame, metres.
    #[must_use]
    pub fn point_m(&self, x_cells: f64, y_cells: f64) -> Vec2 {
        let offset = Vec2::new(x_cells, y_cells) * self.resolution_m;
        self.origin.position() + rotate(offset, self.origin.direction())
    }

    /// The part of the map whose cells have their centres in a rectangle `[x0, y0, x1, y1]` of the
    /// world, metres. Where the map is turned against it, cells outside become unknown.
    ///
    /// # Errors
    /// When the rectangle is none, or has no cell of the map.
    pub fn crop(&self, rectangle_m: [f64; 4]) -> Result<Self, MapError> {
        let [x0, y0, x1, y1] = rectangle_m;
        if !(rectangle_m.iter().all(|value| value.is_finite()) && x0 < x1 && y0 < y1) {
            let problem = format!("{rectangle_m:?} is not");
            return Err(MapError::Crop { problem });
        }
        let corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)].map(|(x, y)| self.cells_at(x, y));
        let span = |along: fn(&Vec2) -> f64, count: usize| {
            let least = corners.iter().map(along).fold(f64::INFINITY, f64::min);
            let most = corners.iter().map(along).fold(f64::NEG_INFINITY, f64::max);
            let limit = count as f64;
            (
                libm::floor(least).clamp(0.0, limit) as usize,
                libm::ceil(most).clamp(0.0, limit) as usize,
            )
        };
        let (left, right) = span(|corner| corner.x, self.columns);
        let (below, above) = span(|corner| corner.y, self.rows);
        if left >= right || below >= above {
            let problem = format!("{rectangle_m:?} lies outside the map");
            return Err(MapError::Crop { problem });
        }
        let corner = self.point_m(left as f64, below as f64);
        let origin = [corner.x, corner.y, self.origin.heading_rad];
        Self::new(right - left, above - below, self.resolution_m, origin, |column, row| {
            let (column, row) = (column + left, row + below);
            let centre = self.point_m(column as f64 + 0.5, row as f64 + 0.5);
            let inside = (x0..=x1).contains(&centre.x) && (y0..=y1).contains(&centre.y);
            if inside { self.cell(column, row) } else { Cell::Unknown }
        })
    }

    /// Drops specks smaller than an area in square metres and says how many: patches of cells that
    /// are not free become free, then free patches become unknown.
    ///
    /// # Errors
    /// When the area is negative or not a number.
    pub fn drop_specks(&mut self, area_m2: f64) -> Result<usize, MapError> {
        if !(area_m2.is_finite() && area_m2 >= 0.0) {
            return Err(MapError::Speck { found: area_m2 });
        }
        // A patch of exactly the area stays, whatever rounding makes of the quotient.
        let cells = area_m2 / (self.resolution_m * self.resolution_m) - 1e-9;
        let solid = specks::fill(&mut self.cells, self.columns, cells, false);
        Ok(solid + specks::fill(&mut self.cells, self.columns, cells, true))
    }

    /// A place of the world in cells from the lower left corner.
    fn cells_at(&self, x_m: f64, y_m: f64) -> Vec2 {
        let offset = Vec2::new(x_m, y_m) - self.origin.position();
        let direction = self.origin.direction();
        rotate(offset, Vec2::new(direction.x, -direction.y)) / self.resolution_m
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turned_map_lies_where_its_origin_says() {
        let yaw = std::f64::consts::FRAC_PI_2;
        let grid =
            OccupancyGrid::new(4, 2, 0.5, [1.0, 2.0, yaw], |_, _| Cell::Free).expect("a small map");
        for (x, y, expected) in
            [(0.0, 0.0, [1.0, 2.0]), (4.0, 0.0, [1.0, 4.0]), (4.0, 2.0, [0.0, 4.0])]
        {
            let point = grid.point_m(x, y);
            assert!((point - Vec2::from(expected)).norm() < 1e-12, "({x}, {y}): {point}");
            assert!((grid.cells_at(point.x, point.y) - Vec2::new(x, y)).norm() < 1e-12);
        }
    }
}
