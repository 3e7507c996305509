//! ROS maps: a YAML file and a picture, read as `map_server` reads them, and traced into a world.
//!
//! Of each pixel the lightness `l` from 0 (black) to 1 (white) gives the chance that its cell is
//! occupied, `p = 1 − l`, or `l` where `negate` is set. The cell is occupied when `p >
//! occupied_thresh`, free when `p < free_thresh`, and unknown otherwise. What `mode` changes:
//!
//! - `trinary` (unless told otherwise): a picture's alpha counts as one more colour.
//! - `scale`: a cell that is not opaque is unknown. The shades between the thresholds, which
//!   `map_server` publishes as 1 to 99, stay unknown: nothing says that a robot may be there.
//! - `raw`: the value of the pixel itself, 0 to 255, is the chance in per cent; above 100 the cell is
//!   unknown.
//!
//! The origin is the pose of the picture's lower left corner; its yaw is honoured.

mod draft;
mod image;
mod metadata;
mod pgm;
mod picture;
#[cfg(test)]
mod tests;

pub use draft::{Options, Traced, trace};
pub use metadata::{Metadata, Mode};

use sonarium_core::world::map::{Cell, MapError, OccupancyGrid};

use crate::catalog::FieldError;

/// Reads the picture of a map.
///
/// # Errors
/// When it is no picture, too large, cut off, or the metadata make no sense.
pub fn read(metadata: &Metadata, picture: &[u8]) -> Result<OccupancyGrid, FieldError> {
    let image = image::decode(picture, metadata).map_err(|why| FieldError::new("image", why))?;
    let (columns, rows) = (image.columns, image.cells.len() / image.columns);
    let cell = |column: usize, row: usize| image.cells[(rows - 1 - row) * columns + column];
    OccupancyGrid::new(columns, rows, metadata.resolution_m, metadata.origin, cell).map_err(refused)
}

impl Metadata {
    /// What a pixel says: its lightness as so many parts of a whole, and whether it is opaque.
    fn cell(&self, parts: u32, whole: u32, opaque: bool) -> Cell {
        let parts = if self.negate { whole - parts } else { parts };
        let share = |parts: u32| f64::from(parts) / f64::from(whole);
        let occupied = match self.mode {
            // NOTE: `negate` turns the value itself, as in ROS 1; ROS 2 ignores it here.
            Mode::Raw => (share(parts) * 255.0).round() / 100.0,
            // Subtracted as whole numbers, so that a chance of exactly a threshold is one.
            _ => share(whole - parts),
        };
        let untold = (self.mode == Mode::Scale && !opaque) || occupied > 1.0;
        if untold {
            Cell::Unknown
        } else if occupied > self.occupied_thresh {
            Cell::Occupied
        } else if occupied < self.free_thresh {
            Cell::Free
        } else {
            Cell::Unknown
        }
    }
}

/// Names the part of the request that a refusal of the map is about.
fn refused(error: MapError) -> FieldError {
    let field = error.field();
    let in_yaml = field == "resolution" || field.starts_with("origin");
    FieldError::new(if in_yaml { format!("yaml.{field}") } else { field }, error.to_string())
}
