//! The picture of the map that a world was traced from, as a file beside it: a PNG file that also says
//! where in the world the picture lies, so that the two cannot come apart.

use std::io::Cursor;
use std::path::{Path, PathBuf};

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use png::{BitDepth, Decoder, Encoder, Limits, Transformations};
use serde::{Deserialize, Serialize};

use crate::catalog::FieldError;
use crate::wire::{MapPicture, PlaceView};

/// Greatest width and height of a picture, pixels.
const LARGEST_PX: u32 = 4096;
/// Largest file, bytes.
pub(super) const LARGEST_FILE: usize = 8 << 20;
/// What a decoder may take, bytes: four channels of 16 bits, and some for itself.
const DECODER_BYTES: usize = 9 * (LARGEST_PX * LARGEST_PX) as usize;
/// Keyword of the text in the PNG file that says where the picture lies.
const KEYWORD: &str = "sonarium:place";

/// Where a picture lies, as it stands in its file.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Place {
    x_m: f64,
    y_m: f64,
    yaw_deg: f64,
    width_m: f64,
    height_m: f64,
}

/// The file of the picture beside that of its world.
#[must_use]
pub fn map_beside(world: &Path) -> PathBuf {
    world.with_extension("map.png")
}

/// The file that keeps a picture.
///
/// # Errors
/// When it is no PNG, too large, not of the size it says, or lies nowhere; the field names what.
pub fn map_file(picture: &MapPicture) -> Result<Vec<u8>, FieldError> {
    let wrong = |why: String| FieldError::new("png_base64", why);
    if picture.png_base64.len() / 4 * 3 > LARGEST_FILE {
        return Err(wrong(format!("must be at most {} MiB as a file", LARGEST_FILE >> 20)));
    }
    let file = BASE64_STANDARD.decode(&picture.png_base64);
    let file = file.map_err(|error| wrong(format!("must be base 64 ({error})")))?;
    let place = place_of(picture)?;
    let image = decode(&file).map_err(wrong)?;
    if (picture.width_px, picture.height_px) != (image.width, image.height) {
        let (width, height) = (image.width, image.height);
        let message = format!("must be {width} and height_px {height}, the size of the picture");
        return Err(FieldError::new("width_px", message));
    }
    encode(&image, &place).map_err(|error| wrong(format!("cannot be written: {error}")))
}

/// The picture in a file.
///
/// # Errors
/// When it is no PNG, too large, or does not say where it lies.
pub(super) fn read_map(file: &[u8]) -> Result<MapPicture, String> {
    if file.len() > LARGEST_FILE {
        return Err(format!("must be at most {} MiB", LARGEST_FILE >> 20));
    }
    let image = decode(file)?;
    let text =
        image.place.ok_or_else(|| format!("must say in a text `{KEYWORD}` where it lies"))?;
    let place: Place = serde_json::from_str(&text)
        .map_err(|error| format!("must say where it lies; its text `{KEYWORD}`: {error}"))?;
    let picture = MapPicture {
        png_base64: BASE64_STANDARD.encode(file),
        width_px: image.width,
        height_px: image.height,
        corner: PlaceView { x_m: place.x_m, y_m: place.y_m },
        yaw_deg: place.yaw_deg,
        width_m: place.width_m,
        height_m: place.height_m,
    };
    place_of(&picture).map_err(|error| error.to_string())?;
    Ok(picture)
}

fn place_of(picture: &MapPicture) -> Result<Place, FieldError> {
    let &MapPicture { corner: PlaceView { x_m, y_m }, yaw_deg, width_m, height_m, .. } = picture;
    for (field, value) in [("corner.x_m", x_m), ("corner.y_m", y_m), ("yaw_deg", yaw_deg)] {
        if !value.is_finite() {
            return Err(FieldError::new(field, format!("must be a finite number, not {value}")));
        }
    }
    for (field, value) in [("width_m", width_m), ("height_m", height_m)] {
        if !(value > 0.0 && value.is_finite()) {
            return Err(FieldError::new(field, format!("must be above 0 m, not {value}")));
        }
    }
    Ok(Place { x_m, y_m, yaw_deg, width_m, height_m })
}

struct Image {
    width: u32,
    height: u32,
    color: png::ColorType,
    pixels: Vec<u8>,
    place: Option<String>,
}

fn decode(file: &[u8]) -> Result<Image, String> {
    let damaged =
        |error: png::DecodingError| format!("must be a PNG file that can be read ({error})");
    let limits = Limits { bytes: DECODER_BYTES };
    let mut decoder = Decoder::new_with_limits(Cursor::new(file), limits);
    decoder.set_transformations(Transformations::normalize_to_color8());
    let header = decoder.read_header_info().map_err(damaged)?;
    let (width, height) = (header.width, header.height);
    if width > LARGEST_PX || height > LARGEST_PX {
        return Err(format!(
            "must have at most {LARGEST_PX} x {LARGEST_PX} pixels, not {width} x {height}"
        ));
    }
    let mut reader = decoder.read_info().map_err(damaged)?;
    let texts = &reader.info().uncompressed_latin1_text;
    let place = texts.iter().find(|text| text.keyword == KEYWORD).map(|text| text.text.clone());
    let size = reader.output_buffer_size().ok_or("the picture is too large")?;
    let mut pixels = vec![0; size];
    let frame = reader.next_frame(&mut pixels).map_err(damaged)?;
    pixels.truncate(frame.buffer_size());
    Ok(Image { width, height, color: frame.color_type, pixels, place })
}

fn encode(image: &Image, place: &Place) -> Result<Vec<u8>, png::EncodingError> {
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, image.width, image.height);
    encoder.set_color(image.color);
    encoder.set_depth(BitDepth::Eight);
    let text = serde_json::to_string(place).expect("plain numbers always serialise");
    encoder.add_text_chunk(KEYWORD.to_owned(), text)?;
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&image.pixels)?;
    writer.finish()?;
    Ok(file)
}
