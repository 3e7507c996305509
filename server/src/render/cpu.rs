//! The back end that needs no graphics driver, on `vello_cpu`.

use super::scene::{Colour, Primitive, Scene, Sector, Stroke, Text};
use super::{MOST_KEPT_PX, Pixels, RenderError, text};
use vello_cpu::kurbo::{self, BezPath, Cap, Join, Shape};
use vello_cpu::peniko::Color;
use vello_cpu::{Pixmap, RenderContext, Resources};

/// Greatest distance between a curve and the lines it is drawn with, pixels.
const TOLERANCE_PX: f64 = 0.05;

/// Draws scenes on one core.
#[derive(Default)]
pub struct CpuBackend {
    context: Option<RenderContext>,
    resources: Resources,
}

impl CpuBackend {
    /// Draws a scene.
    pub fn draw(&mut self, scene: &Scene) -> Result<Pixels, RenderError> {
        let (Ok(width), Ok(height)) = (u16::try_from(scene.width), u16::try_from(scene.height))
        else {
            return Err(RenderError::Failed(format!(
                "{} × {} pixels are too many",
                scene.width, scene.height
            )));
        };
        let context = self.context.get_or_insert_with(|| RenderContext::new(width, height));
        context.reset_and_resize(width, height);
        context.set_paint(paint(scene.background.fade(1.0)));
        context.fill_rect(&kurbo::Rect::new(0.0, 0.0, f64::from(width), f64::from(height)));
        for primitive in scene.primitives() {
            draw(context, primitive);
        }
        let mut target = Pixmap::new(width, height);
        context.flush();
        context.render(&mut target, &mut self.resources);
        let rgba = target.data_as_u8_slice().to_vec();
        if scene.width * scene.height > MOST_KEPT_PX {
            *self = Self::default();
        }
        Ok(Pixels { width: scene.width, height: scene.height, rgba })
    }
}

fn draw(context: &mut RenderContext, primitive: &Primitive) {
    match primitive {
        Primitive::Stroke(stroke) => draw_stroke(context, stroke),
        Primitive::Sector(sector) => draw_sector(context, sector),
        Primitive::Polygon { contours, colour } => {
            context.set_paint(paint(*colour));
            context.fill_path(&closed_path(contours));
        }
        Primitive::Text(text) => draw_text(context, text),
    }
}

fn draw_stroke(context: &mut RenderContext, stroke: &Stroke) {
    let mut path = BezPath::new();
    let mut dots = BezPath::new();
    for run in stroke.runs() {
        if let [only] = run.points[..] {
            let radius = f64::from(stroke.width) / 2.0;
            dots.extend(kurbo::Circle::new(point(only), radius).path_elements(TOLERANCE_PX));
            continue;
        }
        trace(&mut path, &run.points, run.closed);
    }
    context.set_paint(paint(stroke.colour));
    context.set_stroke(
        kurbo::Stroke::new(f64::from(stroke.width)).with_caps(Cap::Round).with_join(Join::Round),
    );
    if !path.elements().is_empty() {
        context.stroke_path(&path);
    }
    if !dots.elements().is_empty() {
        context.fill_path(&dots);
    }
}

fn draw_sector(context: &mut RenderContext, sector: &Sector) {
    let (centre, inner, outer) =
        (point(sector.centre), f64::from(sector.inner), f64::from(sector.outer));
    context.set_paint(paint(sector.colour));
    if !sector.is_full() {
        let (start, sweep) = (f64::from(sector.start_rad), f64::from(sector.sweep_rad));
        let shape = kurbo::CircleSegment::new(centre, outer, inner, start, sweep);
        context.fill_path(&shape.to_path(TOLERANCE_PX));
        return;
    }
    let mut path = kurbo::Circle::new(centre, outer).to_path(TOLERANCE_PX);
    if inner > 0.0 {
        path.extend(kurbo::Circle::new(centre, inner).to_path(TOLERANCE_PX).reverse_subpaths());
    }
    context.fill_path(&path);
}

fn draw_text(context: &mut RenderContext, line: &Text) {
    let outlines = text::outlines(line);
    if let Some((colour, rim)) = line.halo {
        context.set_paint(paint(colour));
        let stroke = kurbo::Stroke::new(2.0 * f64::from(rim));
        context.set_stroke(stroke.with_caps(Cap::Round).with_join(Join::Round));
        outlines.iter().for_each(|glyph| context.stroke_path(&closed_path(glyph)));
    }
    context.set_paint(paint(line.colour));
    outlines.iter().for_each(|glyph| context.fill_path(&closed_path(glyph)));
}

fn closed_path(contours: &[Vec<[f32; 2]>]) -> BezPath {
    let mut path = BezPath::new();
    contours.iter().for_each(|contour| trace(&mut path, contour, true));
    path
}

fn trace(path: &mut BezPath, points: &[[f32; 2]], closed: bool) {
    let Some((&first, rest)) = points.split_first() else { return };
    path.move_to(point(first));
    rest.iter().for_each(|&next| path.line_to(point(next)));
    if closed {
        path.close_path();
    }
}

fn point([x, y]: [f32; 2]) -> kurbo::Point {
    kurbo::Point::new(f64::from(x), f64::from(y))
}

fn paint(colour: Colour) -> Color {
    let [red, green, blue, alpha] = colour.0;
    Color::from_rgba8(red, green, blue, alpha)
}
