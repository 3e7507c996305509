//! Text as filled outlines, the same for both back ends.
//!
//! The font is Ubuntu Light from a crate that carries its bytes; it is made a little heavier by
//! moving every outline outwards, because light strokes vanish at the sizes of a label.

use super::scene::{Anchor, Point, Text};
use skrifa::outline::{DrawSettings, OutlinePen};
use skrifa::prelude::{LocationRef, Size};
use skrifa::{FontRef, MetadataProvider};
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// The contours of one glyph, pixels.
pub(super) type Contours = Vec<Vec<Point>>;

/// Width of a line of text, pixels.
pub(super) fn width_px(text: &str, size: f32) -> f32 {
    text.chars().map(|letter| glyph(letter).advance).sum::<f32>() * size
}

/// Height of capital letters above the baseline as a part of the font size.
pub(super) const CAP_HEIGHT: f32 = 0.69;

/// The outlines of a text's glyphs, where they stand in the picture.
pub(super) fn outlines(text: &Text) -> Vec<Contours> {
    let width = width_px(&text.text, text.size);
    let shift = match text.anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => width / 2.0,
        Anchor::End => width,
    };
    // Whole pixels keep the stems of small letters equally sharp from one picture to the next.
    let (mut left, baseline) = ((text.at[0] - shift).round(), text.at[1].round());
    let mut placed = Vec::new();
    for letter in text.text.chars() {
        let glyph = glyph(letter);
        let place = |p: &Point| [left + p[0] * text.size, baseline - p[1] * text.size];
        let contours: Contours =
            glyph.contours.iter().map(|contour| contour.iter().map(place).collect()).collect();
        if !contours.is_empty() {
            placed.push(contours);
        }
        left += glyph.advance * text.size;
    }
    placed
}

/// The text, cut with an ellipsis if it is wider than this; empty if nothing of it fits.
pub(super) fn fitted(text: &str, size: f32, most_px: f32) -> String {
    if width_px(text, size) <= most_px {
        return text.to_owned();
    }
    let mut cut: Vec<char> = text.chars().take(400).collect();
    while cut.pop().is_some() {
        let shorter = cut.iter().collect::<String>().trim_end().to_owned() + "…";
        if !cut.is_empty() && width_px(&shorter, size) <= most_px {
            return shorter;
        }
    }
    String::new()
}

/// A glyph with the em as unit, `y` upwards.
#[derive(Clone, Debug, Default)]
struct Glyph {
    advance: f32,
    contours: Contours,
}

fn glyph(letter: char) -> &'static Glyph {
    static NONE: Glyph = Glyph { advance: 0.5, contours: Vec::new() };
    static GLYPHS: OnceLock<BTreeMap<char, Glyph>> = OnceLock::new();
    let glyphs = GLYPHS.get_or_init(|| load(epaint_default_fonts::UBUNTU_LIGHT));
    glyphs.get(&letter).or_else(|| glyphs.get(&'?')).unwrap_or(&NONE)
}

/// Latin, Greek, punctuation, arrows and mathematical signs.
const LETTERS: [std::ops::Range<u32>; 5] =
    [0x20..0x180, 0x370..0x400, 0x2010..0x2040, 0x2190..0x2200, 0x2200..0x2300];

/// How far every outline moves outwards, parts of the em.
const HEAVIER: f32 = 0.011;

fn load(font: &[u8]) -> BTreeMap<char, Glyph> {
    let Ok(font) = FontRef::new(font) else { return BTreeMap::new() };
    let (charmap, outlines) = (font.charmap(), font.outline_glyphs());
    let metrics = font.glyph_metrics(Size::new(1.0), LocationRef::default());
    let mut glyphs = BTreeMap::new();
    for letter in LETTERS.into_iter().flatten().filter_map(char::from_u32) {
        let Some(id) = charmap.map(letter) else { continue };
        let mut pen = Flattener::default();
        let settings = DrawSettings::unhinted(Size::new(1.0), LocationRef::default());
        if let Some(outline) = outlines.get(id)
            && outline.draw(settings, &mut pen).is_err()
        {
            continue;
        }
        let contours = pen.contours.iter().map(|contour| heavier(contour)).collect();
        glyphs
            .insert(letter, Glyph { advance: metrics.advance_width(id).unwrap_or(0.5), contours });
    }
    glyphs
}

/// Turns curves into short straight pieces, fine enough for letters 60 pixels high.
#[derive(Default)]
struct Flattener {
    contours: Contours,
}

impl Flattener {
    fn last(&self) -> Point {
        self.contours.last().and_then(|contour| contour.last()).copied().unwrap_or_default()
    }

    fn add(&mut self, point: Point) {
        if let Some(contour) = self.contours.last_mut()
            && contour.last() != Some(&point)
        {
            contour.push(point);
        }
    }

    fn curve(&mut self, pieces: u32, at: impl Fn(f32) -> Point) {
        for piece in 1..=pieces {
            self.add(at(piece as f32 / pieces as f32));
        }
    }
}

impl OutlinePen for Flattener {
    fn move_to(&mut self, x: f32, y: f32) {
        self.contours.push(vec![[x, y]]);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.add([x, y]);
    }

    fn quad_to(&mut self, cx: f32, cy: f32, x: f32, y: f32) {
        let from = self.last();
        let mix = |t: f32, a: f32, b: f32, c: f32| {
            (1.0 - t) * (1.0 - t) * a + 2.0 * t * (1.0 - t) * b + t * t * c
        };
        self.curve(4, |t| [mix(t, from[0], cx, x), mix(t, from[1], cy, y)]);
    }

    fn curve_to(&mut self, cx0: f32, cy0: f32, cx1: f32, cy1: f32, x: f32, y: f32) {
        let from = self.last();
        let mix = |t: f32, a: f32, b: f32, c: f32, d: f32| {
            let u = 1.0 - t;
            u * u * u * a + 3.0 * u * u * t * b + 3.0 * u * t * t * c + t * t * t * d
        };
        self.curve(6, |t| [mix(t, from[0], cx0, cx1, x), mix(t, from[1], cy0, cy1, y)]);
    }

    fn close(&mut self) {
        if let Some(contour) = self.contours.last_mut()
            && contour.len() > 1
            && contour.first() == contour.last()
        {
            contour.pop();
        }
    }
}

/// Moves a contour to its left. Filled areas of a TrueType outline lie to the right of their
/// contours, so strokes grow and holes shrink.
fn heavier(contour: &[Point]) -> Vec<Point> {
    let count = contour.len();
    if count < 3 {
        return contour.to_vec();
    }
    let left_of = |a: Point, b: Point| {
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let length = dx.hypot(dy).max(1e-9);
        [-dy / length, dx / length]
    };
    let moved = |i: usize| {
        let (before, here, after) =
            (contour[(i + count - 1) % count], contour[i], contour[(i + 1) % count]);
        let (a, b) = (left_of(before, here), left_of(here, after));
        // The mitre of both sides, kept short at needle points.
        let reach = HEAVIER / (1.0 + a[0] * b[0] + a[1] * b[1]).max(0.5);
        [here[0] + (a[0] + b[0]) * reach, here[1] + (a[1] + b[1]) * reach]
    };
    (0..count).map(moved).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::scene::Colour;

    fn line(text: &str, anchor: Anchor) -> Text {
        let (at, size, colour) = ([100.0, 50.0], 20.0, Colour::rgb(0));
        Text { at, text: text.to_owned(), size, anchor, colour, halo: None }
    }

    #[test]
    fn anchors_place_the_measured_width() {
        let width = width_px("Trial 3", 20.0);
        assert!((40.0..90.0).contains(&width), "{width}");
        for (anchor, left) in [
            (Anchor::Start, 100.0),
            (Anchor::Middle, 100.0 - width / 2.0),
            (Anchor::End, 100.0 - width),
        ] {
            let outlines = outlines(&line("Trial 3", anchor));
            let points: Vec<Point> = outlines.into_iter().flatten().flatten().collect();
            let least = points.iter().map(|p| p[0]).fold(f32::INFINITY, f32::min);
            let most = points.iter().map(|p| p[0]).fold(f32::NEG_INFINITY, f32::max);
            assert!((least - left).abs() < 3.0, "{anchor:?} begins at {least}, not {left}");
            assert!((most - left - width).abs() < 3.0, "{anchor:?} ends at {most}");
        }
    }

    #[test]
    fn every_letter_we_print_has_an_outline() {
        for letter in "aZ09.,:()%/−–…·×°αδγθρ".chars() {
            assert_eq!(outlines(&line(&letter.to_string(), Anchor::Start)).len(), 1, "{letter}");
        }
        assert_eq!(outlines(&line("漢", Anchor::Start)), outlines(&line("?", Anchor::Start)));
        assert!(outlines(&line("  ", Anchor::Start)).is_empty());
    }

    #[test]
    fn long_lines_are_cut_to_fit() {
        for (text, most_px, expected) in [
            ("short", 500.0, "short"),
            ("Trial 3, step 17", 60.0, "Trial 3…"),
            ("Trial 3", 1.0, ""),
            ("", 10.0, ""),
        ] {
            assert_eq!(fitted(text, 16.0, most_px), expected);
        }
    }
}
