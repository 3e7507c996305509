//! Where arena, caption, scale bar and legend stand in the picture.

use super::Canvas;
use super::legend::Entry;
use crate::render::projection::Projection;
use crate::render::scene::{Anchor, Primitive, Scene, Text};
use crate::render::text::{self, CAP_HEIGHT};
use crate::render::view::ArenaView;

/// The plan of a picture, pixels.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Layout {
    /// Size of marks and lines against a picture of 960×640.
    pub(super) zoom: f32,
    /// Font size.
    pub(super) font: f32,
    /// The picture is too small for names, step dots and a legend.
    pub(super) is_thumbnail: bool,
    /// Free rim at the edges of the picture.
    pub(super) pad: f32,
    /// Shown beyond the bounds on every side.
    pub(super) rim_px: f32,
    /// Where the arena stands.
    pub(super) projection: Projection,
    /// Left end and baseline of the caption.
    pub(super) caption: [f32; 2],
    /// Left end and baseline of the scale bar.
    pub(super) scale_bar: [f32; 2],
    /// The legend; none where it would not be legible.
    pub(super) legend: Option<Legend>,
}

/// Where the legend stands, pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Legend {
    /// Left and top.
    pub(super) at: [f32; 2],
    /// Width of a column.
    pub(super) column_px: f32,
    /// Number of columns.
    pub(super) columns: usize,
}

/// Below this size (width or height) a picture has no legend and no names.
const THUMBNAIL_PX: u32 = 400;

impl Layout {
    /// Plans a picture: with the legend beside or below the arena, whichever leaves more room.
    pub(super) fn plan(view: &ArenaView, entries: &[Entry], width: u32, height: u32) -> Self {
        let bounds_m = usable_bounds(view);
        let sheet = Sheet::new(view, width, height);
        if sheet.is_thumbnail || entries.is_empty() {
            return sheet.without_legend(bounds_m);
        }
        let (beside, below) =
            (sheet.legend_beside(bounds_m, entries), sheet.legend_below(bounds_m, entries));
        if beside.projection.px_per_m > below.projection.px_per_m { beside } else { below }
    }

    /// Height of a line of the legend.
    pub(super) fn line_px(&self) -> f32 {
        self.font * LINE
    }
}

/// Distance of two lines of text, parts of the font size.
const LINE: f32 = 1.6;

/// Space for a symbol of the legend, parts of the font size.
pub(super) const SYMBOL: f32 = 2.6;

/// Space for the length beside the scale bar, parts of the font size.
const LENGTH: f32 = 4.0;

/// The sheet of paper before the arena has its place.
struct Sheet {
    width: f32,
    height: f32,
    is_thumbnail: bool,
    zoom: f32,
    font: f32,
    pad: f32,
    /// Where the arena may begin below the caption.
    top: f32,
}

impl Sheet {
    fn new(view: &ArenaView, width: u32, height: u32) -> Self {
        let is_thumbnail = width < THUMBNAIL_PX || height < THUMBNAIL_PX;
        let (width, height) = (width as f32, height as f32);
        let size = (width / 960.0).min(height / 640.0);
        // Marks shrink slower than the picture, or a thumbnail would show only specks.
        let zoom = if size < 1.0 { size.max(0.02).powf(0.7) } else { size };
        let font = (13.5 * zoom).max(9.5);
        let pad = (14.0 * zoom).min(0.1 * width.min(height));
        let top = if view.caption.is_empty() { pad } else { pad + font * 1.15 + 0.6 * pad };
        Self { width, height, is_thumbnail, zoom, font, pad, top }
    }

    /// Height of the scale bar with its number.
    fn bar_px(&self) -> f32 {
        self.font * 1.5
    }

    fn fit(&self, bounds_m: [f64; 4], right: f32, bottom: f32) -> Projection {
        let rim = self.rim_px();
        let frame = [self.pad + rim, self.top + rim, right - rim, bottom - rim];
        Projection::fit(bounds_m, frame.map(f64::from))
    }

    fn rim_px(&self) -> f32 {
        (5.0 * self.zoom).min(0.05 * self.width.min(self.height))
    }

    fn layout(&self, projection: Projection, scale_bar: [f32; 2]) -> Layout {
        let (zoom, font, pad, rim_px) = (self.zoom, self.font, self.pad, self.rim_px());
        let [left, top, ..] = projection.frame();
        let caption = [left.max(pad), top - rim_px - 0.6 * pad];
        let is_thumbnail = self.is_thumbnail;
        Layout {
            zoom,
            font,
            is_thumbnail,
            pad,
            rim_px,
            projection,
            caption,
            scale_bar,
            legend: None,
        }
    }

    fn without_legend(&self, bounds_m: [f64; 4]) -> Layout {
        let strip = self.bar_px() + 0.4 * self.pad;
        let bottom = self.height - self.pad - strip;
        let projection = self.fit(bounds_m, self.width - self.pad, bottom);
        let [left, _, _, arena_bottom] = projection.frame();
        self.layout(projection, [left, arena_bottom + self.rim_px() + strip])
    }

    fn legend_beside(&self, bounds_m: [f64; 4], entries: &[Entry]) -> Layout {
        let (gap, column) = (1.6 * self.pad, self.column_px(entries));
        let right = self.width - self.pad - column - gap;
        let mut projection = self.fit(bounds_m, right, self.height - self.pad);
        // Arena and legend stand in the middle together.
        let [left, top, arena_right, bottom] = projection.frame();
        let group_px = arena_right - left + gap + column;
        let start = ((self.width - group_px) / 2.0).max(self.pad);
        projection.top_left_px[0] = f64::from(start);
        let legend_left = start + arena_right - left + gap;
        let legend = Legend { at: [legend_left, top], column_px: column, columns: 1 };
        Layout { legend: Some(legend), ..self.layout(projection, [legend_left, bottom]) }
    }

    fn legend_below(&self, bounds_m: [f64; 4], entries: &[Entry]) -> Layout {
        let column = self.column_px(entries);
        let columns = (((self.width - 2.0 * self.pad) / column) as usize).clamp(1, entries.len());
        let lines = entries.len().div_ceil(columns) as f32;
        let strip = lines * self.font * LINE + self.bar_px() + 1.2 * self.pad;
        let bottom = self.height - self.pad - strip;
        let projection = self.fit(bounds_m, self.width - self.pad, bottom);
        let [left, _, _, arena_bottom] = projection.frame();
        let bar = arena_bottom + self.rim_px() + 0.4 * self.pad + self.bar_px();
        // A column's width is measured for all; the block of columns may be wider than the arena.
        let block_px = column * columns as f32;
        let left_px = left.min(self.width - self.pad - block_px).max(self.pad);
        let legend = Legend { at: [left_px, bar + 0.8 * self.pad], column_px: column, columns };
        Layout { legend: Some(legend), ..self.layout(projection, [left, bar]) }
    }

    /// Width of the legend's column.
    fn column_px(&self, entries: &[Entry]) -> f32 {
        let widest = entries.iter().map(|entry| text::width_px(&entry.label, self.font));
        self.font * (SYMBOL + 0.7) + widest.fold(0.0, f32::max) + 1.4 * self.pad
    }
}

/// The view's bounds if they have an area, else those of what there is to show.
fn usable_bounds(view: &ArenaView) -> [f64; 4] {
    let [x0, y0, x1, y1] = view.bounds_m;
    if is_area(view.bounds_m) {
        return [x0, y0, x1, y1];
    }
    let walls = view.walls_m.iter().flat_map(|w| [[w[0], w[1]], [w[2], w[3]]]);
    let points = view.path_m.iter().chain(view.blocks_m.iter().flatten()).copied();
    let all = walls.chain(points).chain([view.home.at_m, view.goal_m]);
    let mut bounds = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
    for [x, y] in all.filter(|p| p.iter().all(|v| v.abs() < FARTHEST_M)) {
        bounds = [bounds[0].min(x), bounds[1].min(y), bounds[2].max(x), bounds[3].max(y)];
    }
    let spread = [bounds[0] - 0.5, bounds[1] - 0.5, bounds[2] + 0.5, bounds[3] + 0.5];
    if is_area(spread) { spread } else { [-1.0, -1.0, 1.0, 1.0] }
}

/// No arena is larger; numbers beyond come from broken input.
const FARTHEST_M: f64 = 1e5;

fn is_area([x0, y0, x1, y1]: [f64; 4]) -> bool {
    let near = [x0, y0, x1, y1].iter().all(|v| v.abs() < FARTHEST_M);
    let (width, height) = (x1 - x0, y1 - y0);
    near && width > 1e-3 && height > 1e-3 && width / height < 1e3 && height / width < 1e3
}

impl Canvas<'_> {
    pub(super) fn caption(&self, scene: &mut Scene) {
        let layout = self.layout;
        let size = layout.font * 1.15;
        let room = scene.width as f32 - layout.caption[0] - layout.pad;
        scene.push(Primitive::Text(Text {
            at: layout.caption,
            text: text::fitted(&self.view.caption, size, room),
            size,
            anchor: Anchor::Start,
            colour: self.theme.ink,
            halo: None,
        }));
    }

    /// A bar of a round number of metres with its length beside it.
    pub(super) fn scale_bar(&self, scene: &mut Scene) {
        let layout = self.layout;
        // Beside a narrow legend the bar is short, so that its length stands inside the picture.
        let room_px = scene.width as f32 - layout.scale_bar[0] - layout.pad - LENGTH * layout.font;
        let most_px = (layout.font * 10.0).min(0.3 * scene.width as f32).min(room_px);
        let most_px = most_px.max(layout.font);
        let (length_m, label) = round_length(f64::from(most_px) / self.at.px_per_m);
        let (length, thick) = (self.at.length(length_m), self.px(2.0).max(1.0));
        let [left, bottom] = layout.scale_bar.map(f32::round);
        let (middle, half) = (bottom - layout.font * CAP_HEIGHT / 2.0, self.px(5.0).max(3.0));
        let right = left + length;
        let line = [left, middle - thick / 2.0, right, middle + thick / 2.0];
        scene.rectangle(line, self.theme.faint_ink);
        for end in [left, right - thick] {
            let tick = [end, middle - half, end + thick, middle + half];
            scene.rectangle(tick, self.theme.faint_ink);
        }
        scene.push(Primitive::Text(Text {
            at: [right + layout.font * 0.5, bottom],
            text: label,
            size: layout.font,
            anchor: Anchor::Start,
            colour: self.theme.faint_ink,
            halo: None,
        }));
    }
}

/// The greatest of 1, 2, 5 times a power of ten not above `most_m`, with its label.
fn round_length(most_m: f64) -> (f64, String) {
    let power = most_m.max(1e-6).log10().floor();
    let unit = 10_f64.powf(power);
    let factor = [5.0, 2.0, 1.0].into_iter().find(|f| f * unit <= most_m).unwrap_or(1.0);
    let decimals = (-power).max(0.0) as usize;
    (factor * unit, format!("{:.decimals$} m", factor * unit))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scale_bars_have_round_lengths() {
        for (most_m, length_m, label) in [
            (1.2, 1.0, "1 m"),
            (2.0, 2.0, "2 m"),
            (7.0, 5.0, "5 m"),
            (0.7, 0.5, "0.5 m"),
            (0.02, 0.02, "0.02 m"),
            (730.0, 500.0, "500 m"),
        ] {
            let (length, text) = round_length(most_m);
            assert!((length - length_m).abs() < 1e-9, "{most_m}: {length}");
            assert_eq!(text, label);
        }
    }

    #[test]
    fn bounds_that_are_none_are_replaced() {
        let wall = vec![[0.0, 0.0, 2.0, 1.0]];
        for (bounds_m, walls_m, expected) in [
            ([0.0, 0.0, 3.0, 4.0], vec![], [0.0, 0.0, 3.0, 4.0]),
            ([0.0; 4], wall.clone(), [-0.5, -0.5, 2.5, 1.5]),
            ([f64::NAN; 4], wall.clone(), [-0.5, -0.5, 2.5, 1.5]),
            ([0.0, 0.0, f64::INFINITY, 1.0], vec![], [-0.5, -0.5, 0.5, 0.5]),
            ([3.0, 0.0, 1.0, 1.0], vec![], [-0.5, -0.5, 0.5, 0.5]),
        ] {
            let view = ArenaView { bounds_m, walls_m, ..ArenaView::default() };
            assert_eq!(usable_bounds(&view), expected, "{bounds_m:?}");
        }
    }
}
