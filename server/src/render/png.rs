//! Pictures as PNG files.

use super::{Pixels, RenderError};

/// How hard to compress.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Quality {
    /// For live pictures: a few milliseconds, larger files.
    #[default]
    Fast,
    /// For archives and reports: ten times the time, much smaller files. The pixels are the same.
    Balanced,
}

/// Encodes a picture; pictures are opaque, so the alpha channel is left out.
pub fn encode(pixels: &Pixels, quality: Quality) -> Result<Vec<u8>, RenderError> {
    let rgb = opaque(&pixels.rgba);
    let mut file = Vec::with_capacity(rgb.len() / 4);
    let mut encoder = png::Encoder::new(&mut file, pixels.width, pixels.height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(match quality {
        Quality::Fast => png::Compression::Fast,
        Quality::Balanced => png::Compression::Balanced,
    });
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&rgb)?;
    writer.finish()?;
    Ok(file)
}

fn opaque(rgba: &[u8]) -> Vec<u8> {
    let mut rgb = Vec::with_capacity(rgba.len() / 4 * 3);
    for pixel in rgba.chunks_exact(4) {
        rgb.extend_from_slice(&pixel[..3]);
    }
    rgb
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_qualities_hold_the_same_pixels() {
        let rgba: Vec<u8> = (0..7 * 5).flat_map(|i| [i, 255 - i, 3 * i, 255]).collect();
        let pixels = Pixels { width: 7, height: 5, rgba };
        for quality in [Quality::Fast, Quality::Balanced] {
            let file = encode(&pixels, quality).expect("encodes");
            let decoder = png::Decoder::new(std::io::Cursor::new(file));
            let mut reader = decoder.read_info().expect("a PNG header");
            let mut decoded = vec![0; reader.output_buffer_size().expect("a known size")];
            let info = reader.next_frame(&mut decoded).expect("pixels");
            assert_eq!((info.width, info.height), (7, 5));
            assert_eq!(decoded, opaque(&pixels.rgba), "{quality:?}");
        }
    }
}
