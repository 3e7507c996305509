//! The picture of a map: PGM or PNG.

use std::io::Cursor;

use png::{BitDepth, ColorType, Decoder, Limits, Transformations};
use sonarium_core::world::map::{CELL_LIMIT, Cell, OccupancyGrid};

use super::pgm;
use super::{Metadata, Mode};

/// The cells of a picture, the top row first.
pub(super) struct Image {
    pub(super) columns: usize,
    pub(super) cells: Vec<Cell>,
}

/// Reads a picture.
///
/// # Errors
/// Says what it is when it is none that can be read, and where it ends when it is cut off.
pub(super) fn decode(bytes: &[u8], metadata: &Metadata) -> Result<Image, String> {
    match bytes {
        [b'P', b'2' | b'5', ..] => {
            pgm::decode(bytes, |value, most| metadata.cell(value, most, true))
        }
        [b'P', kind @ (b'1' | b'3' | b'4' | b'6' | b'7'), ..] => {
            let kind = char::from(*kind);
            Err(format!("must be a PGM (P2 or P5) or PNG file, not P{kind}; convert it to one"))
        }
        [0x89, b'P', b'N', b'G', ..] => decode_png(bytes, metadata),
        [] => Err("must be a PGM or PNG file, but it is empty".to_owned()),
        _ => {
            let start = String::from_utf8_lossy(&bytes[..bytes.len().min(8)]);
            Err(format!("must be a PGM or PNG file, but it begins with {start:?}"))
        }
    }
}

/// Refuses a size before anything is allocated for it.
pub(super) fn check_size(columns: u64, rows: u64) -> Result<(), String> {
    OccupancyGrid::check_size(columns, rows).map_err(|error| error.to_string())
}

fn decode_png(bytes: &[u8], metadata: &Metadata) -> Result<Image, String> {
    let damaged = |error: png::DecodingError| format!("the PNG file cannot be read: {error}");
    // Four channels of 16 bits, and some for the decoder itself.
    let limits = Limits { bytes: 9 * CELL_LIMIT };
    let mut decoder = Decoder::new_with_limits(Cursor::new(bytes), limits);
    // Palettes become colours and few bits become eight; sixteen stay.
    decoder.set_transformations(Transformations::EXPAND);
    let header = decoder.read_header_info().map_err(damaged)?;
    let (width, height) = (header.width, header.height);
    check_size(u64::from(width), u64::from(height))?;
    let mut reader = decoder.read_info().map_err(damaged)?;
    let size = reader.output_buffer_size().ok_or("the PNG file is too large")?;
    let mut pixels = vec![0; size];
    let frame = reader.next_frame(&mut pixels).map_err(damaged)?;
    let (colours, has_alpha) = match frame.color_type {
        ColorType::Grayscale => (1, false),
        ColorType::GrayscaleAlpha => (1, true),
        ColorType::Rgba => (3, true),
        ColorType::Rgb | ColorType::Indexed => (3, false),
    };
    let wide = frame.bit_depth == BitDepth::Sixteen;
    let (bytes_each, most) = if wide { (2, 65_535) } else { (1, 255) };
    let pixel = Pixel { colours, has_alpha, most, metadata };
    let pixel_bytes = (colours + usize::from(has_alpha)) * bytes_each;
    let rows = pixels.chunks_exact(frame.line_size).take(height as usize);
    let pixels = rows.flat_map(|row| row.chunks_exact(pixel_bytes).take(width as usize));
    let channels = |bytes: &[u8]| -> [u32; 4] {
        std::array::from_fn(|channel| match bytes.get(channel * bytes_each..) {
            Some([high, low, ..]) if wide => u32::from(*high) << 8 | u32::from(*low),
            Some([value, ..]) => u32::from(*value),
            _ => 0,
        })
    };
    let cells = pixels.map(|bytes| pixel.cell(channels(bytes))).collect();
    Ok(Image { columns: width as usize, cells })
}

/// How the channels of a pixel are to be read.
struct Pixel<'a> {
    colours: usize,
    has_alpha: bool,
    /// Value of a full channel.
    most: u32,
    metadata: &'a Metadata,
}

impl Pixel<'_> {
    fn cell(&self, channels: [u32; 4]) -> Cell {
        let sum: u32 = channels[..self.colours].iter().sum();
        let alpha = if self.has_alpha { channels[self.colours] } else { self.most };
        // A grey pixel stands for three equal colours beside its alpha.
        let sum = if self.colours == 1 { 3 * sum } else { sum };
        let (parts, channels) = if self.has_alpha && self.metadata.mode == Mode::Trinary {
            (sum + alpha, 4)
        } else {
            (sum, 3)
        };
        self.metadata.cell(parts, channels * self.most, alpha == self.most)
    }
}
