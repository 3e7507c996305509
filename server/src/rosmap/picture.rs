//! The cells of a map as a picture.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use sonarium_core::world::map::{Cell, OccupancyGrid};

use crate::render::RenderError;
use crate::wire::MapPicture;

/// Greatest width and height, pixels; a larger map is drawn with fewer pixels than cells.
const LARGEST_PX: usize = 1024;

/// Draws the cells of a map: white is free, black occupied, grey unknown. Of the cells that share a
/// pixel, the occupied ones show first, so that thin walls stay.
pub(super) fn picture(grid: &OccupancyGrid) -> Result<MapPicture, RenderError> {
    let (columns, rows) = (grid.columns(), grid.rows());
    let cells_a_pixel = columns.max(rows).div_ceil(LARGEST_PX);
    let (width, height) = (columns.div_ceil(cells_a_pixel), rows.div_ceil(cells_a_pixel));
    let mut grey = vec![GREY_OF_UNKNOWN; width * height];
    for row in 0..rows {
        for column in 0..columns {
            // The picture begins on top, and the part of a pixel that no cell fills lies there.
            let y = height - 1 - row / cells_a_pixel;
            let pixel = &mut grey[y * width + column / cells_a_pixel];
            *pixel = match (grid.cell(column, row), *pixel) {
                (Cell::Occupied, _) | (_, 0) => 0,
                (Cell::Free, _) => 255,
                (Cell::Unknown, shown) => shown,
            };
        }
    }
    let origin = grid.origin();
    let pixel_m = grid.resolution_m() * cells_a_pixel as f64;
    Ok(MapPicture {
        png_base64: BASE64_STANDARD.encode(png(&grey, width, height)?),
        width_px: width as u32,
        height_px: height as u32,
        corner: [origin.x_m, origin.y_m].into(),
        yaw_deg: origin.heading_rad.to_degrees(),
        width_m: width as f64 * pixel_m,
        height_m: height as f64 * pixel_m,
    })
}

/// What `map_saver` writes for unknown cells.
const GREY_OF_UNKNOWN: u8 = 205;

fn png(grey: &[u8], width: usize, height: usize) -> Result<Vec<u8>, png::EncodingError> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width as u32, height as u32);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(grey)?;
    writer.finish()?;
    Ok(file)
}
