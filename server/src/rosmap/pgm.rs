//! PGM pictures, plain (P2) and raw (P5).
//!
//! The format is a few numbers and the pixels; the library that reads it brings a colour management
//! engine with it.

use sonarium_core::world::map::Cell;

use super::image::{Image, check_size};

/// Reads a picture whose first two bytes are `P2` or `P5`; `cell` gets a pixel's value and
/// the greatest.
pub(super) fn decode(bytes: &[u8], cell: impl Fn(u32, u32) -> Cell) -> Result<Image, String> {
    let mut reader = Reader { bytes, at: 2 };
    let columns = reader.number("the width")?;
    let rows = reader.number("the height")?;
    check_size(u64::from(columns), u64::from(rows))?;
    let most = reader.number("the greatest value")?;
    if !(1..=65_535).contains(&most) {
        return Err(format!("the greatest value of a PGM file must be 1 to 65535, not {most}"));
    }
    let count = columns as usize * rows as usize;
    let values = if bytes[1] == b'5' { reader.raw(count, most) } else { reader.plain(count) }?;
    if let Some(index) = values.iter().position(|&value| u32::from(value) > most) {
        let (column, row) = (index % columns as usize, index / columns as usize);
        let value = values[index];
        return Err(format!(
            "the pixel in column {column} of row {row} is {value}, above the greatest value {most}"
        ));
    }
    let cells = values.iter().map(|&value| cell(u32::from(value), most)).collect();
    Ok(Image { columns: columns as usize, cells })
}

struct Reader<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl Reader<'_> {
    /// The next whole number, after white space and comments, which run from `#` to the line's end.
    fn number(&mut self, what: &str) -> Result<u32, String> {
        loop {
            match self.bytes.get(self.at) {
                Some(b'#') => {
                    let rest = &self.bytes[self.at..];
                    self.at += rest.iter().position(|b| *b == b'\n').unwrap_or(rest.len());
                }
                Some(byte) if byte.is_ascii_whitespace() => self.at += 1,
                _ => break,
            }
        }
        let digits = self.bytes[self.at..].iter().take_while(|byte| byte.is_ascii_digit());
        let digits: String = digits.map(|byte| char::from(*byte)).collect();
        let place = self.at;
        self.at += digits.len();
        if digits.is_empty() && place >= self.bytes.len() {
            return Err(format!("the PGM file ends before {what}"));
        }
        digits.parse().map_err(|_| {
            format!("{what} of the PGM file must be a whole number, but byte {place} begins none that fits")
        })
    }

    fn plain(&mut self, count: usize) -> Result<Vec<u16>, String> {
        // Each number takes two bytes at least, so this is no more than the file's own size.
        let mut values = Vec::with_capacity(count.min(self.bytes.len()));
        for index in 0..count {
            let value = self.number(&format!("pixel {} of {count}", index + 1))?;
            values.push(u16::try_from(value).unwrap_or(u16::MAX));
        }
        Ok(values)
    }

    /// Pixels of one byte, or of two with the higher first. One character of white space comes before.
    fn raw(&mut self, count: usize, most: u32) -> Result<Vec<u16>, String> {
        let wide = most > 255;
        let pixels = self.bytes.get(self.at + 1..).unwrap_or_default();
        let size = if wide { 2 } else { 1 };
        if pixels.len() / size < count {
            let found = pixels.len() / size;
            return Err(format!("the PGM file ends after {found} of {count} pixels"));
        }
        let value = |pixel: &[u8]| match pixel {
            [high, low] => u16::from_be_bytes([*high, *low]),
            _ => u16::from(pixel[0]),
        };
        Ok(pixels.chunks_exact(size).take(count).map(value).collect())
    }
}
