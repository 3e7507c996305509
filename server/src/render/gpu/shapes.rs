//! Primitives as the shader wants them: instances and polygon edges.

use crate::render::scene::{Colour, Point, Primitive, Run, Scene, Sector, Stroke, Text, distance};
use crate::render::text;

/// One instance; the layout is that of `Shape` in `arena.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct Shape {
    place: [f32; 4],
    sides: [f32; 4],
    colour: [f32; 4],
    size: f32,
    kind: [u32; 3],
}

const SEGMENT: u32 = 0;
const SECTOR: u32 = 1;
const POLYGON: u32 = 2;

/// Everything the shader draws, from back to front.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Shapes {
    pub(super) instances: Vec<Shape>,
    /// `[x0, y0, x1, y1]` of every edge of every polygon.
    pub(super) edges: Vec<[f32; 4]>,
}

impl Shapes {
    pub(super) fn of(scene: &Scene) -> Self {
        let mut shapes = Self::default();
        for primitive in scene.primitives() {
            match primitive {
                Primitive::Stroke(stroke) => shapes.stroke(stroke),
                Primitive::Sector(sector) => shapes.sector(sector),
                Primitive::Polygon { contours, colour } => shapes.polygon(contours, *colour),
                Primitive::Text(text) => shapes.text(text),
            }
        }
        shapes
    }

    fn stroke(&mut self, stroke: &Stroke) {
        for run in stroke.runs() {
            self.run(&run, stroke.width, stroke.colour);
        }
    }

    fn run(&mut self, run: &Run, width: f32, colour: Colour) {
        let points = &run.points;
        if let [only] = points[..] {
            let sector = Sector { centre: only, outer: width / 2.0, colour, ..Sector::default() };
            return self.sector(&Sector { sweep_rad: std::f32::consts::TAU, ..sector });
        }
        let count = points.len();
        let segments = if run.closed { count } else { count.saturating_sub(1) };
        let at = |i: usize| points[i % count];
        // The plane at the joint between the segments `i - 1` and `i`, if they meet there.
        let plane = |i: usize| {
            let inner = run.closed || (i > 0 && i < segments);
            let i = i + count;
            if inner { bisector(at(i - 1), at(i), at(i + 1)) } else { [0.0; 2] }
        };
        for i in 0..segments {
            let ([x0, y0], [x1, y1]) = (at(i), at(i + 1));
            let (start, end) = (plane(i), plane(i + 1));
            self.instances.push(Shape {
                place: [x0, y0, x1, y1],
                sides: [start[0], start[1], end[0], end[1]],
                colour: colour.premultiplied(),
                size: width / 2.0,
                kind: [SEGMENT, 0, 0],
            });
        }
    }

    fn sector(&mut self, sector: &Sector) {
        let (start, end) = (sector.start_rad, sector.start_rad + sector.sweep_rad);
        self.instances.push(Shape {
            place: [sector.centre[0], sector.centre[1], sector.inner, sector.outer],
            sides: [start.cos(), start.sin(), end.cos(), end.sin()],
            colour: sector.colour.premultiplied(),
            size: if sector.is_full() { std::f32::consts::TAU } else { sector.sweep_rad },
            kind: [SECTOR, 0, 0],
        });
    }

    fn polygon(&mut self, contours: &[Vec<Point>], colour: Colour) {
        let first = self.edges.len();
        let mut extent = [f32::INFINITY, f32::INFINITY, f32::NEG_INFINITY, f32::NEG_INFINITY];
        for contour in contours {
            for (i, &[x0, y0]) in contour.iter().enumerate() {
                let [x1, y1] = contour[(i + 1) % contour.len()];
                extent =
                    [extent[0].min(x0), extent[1].min(y0), extent[2].max(x0), extent[3].max(y0)];
                self.edges.push([x0, y0, x1, y1]);
            }
        }
        let count = self.edges.len() - first;
        if count == 0 {
            return;
        }
        self.instances.push(Shape {
            place: extent,
            sides: [0.0; 4],
            colour: colour.premultiplied(),
            size: 0.0,
            kind: [POLYGON, first as u32, count as u32],
        });
    }

    fn text(&mut self, text: &Text) {
        let glyphs = text::outlines(text);
        if let Some((colour, rim)) = text.halo {
            for contour in glyphs.iter().flatten() {
                let points = contour.clone();
                let width = 2.0 * rim;
                self.stroke(&Stroke { points, width, colour, closed: true, dash: None });
            }
        }
        for contours in &glyphs {
            self.polygon(contours, text.colour);
        }
    }
}

/// The direction half way between the two segments that meet at `joint`; zero where the line turns
/// back on itself, because no plane parts the two there: both get round caps.
fn bisector(before: Point, joint: Point, after: Point) -> [f32; 2] {
    let unit = |a: Point, b: Point| {
        let length = distance(a, b).max(1e-6);
        [(b[0] - a[0]) / length, (b[1] - a[1]) / length]
    };
    let (a, b) = (unit(before, joint), unit(joint, after));
    let sum = [a[0] + b[0], a[1] + b[1]];
    if sum[0].hypot(sum[1]) < 0.2 { [0.0; 2] } else { sum }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(points: Vec<Point>, closed: bool) -> Vec<Shape> {
        let mut scene = Scene::new(9, 9, Colour::rgb(0));
        let stroke = Stroke { points, width: 2.0, closed, ..Stroke::default() };
        scene.push(Primitive::Stroke(stroke));
        Shapes::of(&scene).instances
    }

    #[test]
    fn neighbours_share_the_plane_at_their_joint() {
        let shapes = line(vec![[0.0, 0.0], [5.0, 0.0], [5.0, 5.0]], false);
        let sides: Vec<[f32; 4]> = shapes.iter().map(|shape| shape.sides).collect();
        assert_eq!(sides, [[0.0, 0.0, 1.0, 1.0], [1.0, 1.0, 0.0, 0.0]]);
    }

    #[test]
    fn lines_have_as_many_segments_as_they_need() {
        let triangle = vec![[0.0, 0.0], [5.0, 0.0], [5.0, 5.0]];
        for (points, closed, kinds) in [
            (vec![], false, vec![]),
            (vec![[1.0, 1.0]], false, vec![SECTOR]),
            (triangle.clone(), false, vec![SEGMENT; 2]),
            (triangle, true, vec![SEGMENT; 3]),
            (vec![[0.0, 0.0], [5.0, 0.0]], true, vec![SEGMENT]),
        ] {
            let found: Vec<u32> = line(points.clone(), closed).iter().map(|s| s.kind[0]).collect();
            assert_eq!(found, kinds, "{points:?}");
        }
    }

    #[test]
    fn a_line_that_turns_back_ends_in_caps() {
        let shapes = line(vec![[0.0, 0.0], [5.0, 0.0], [0.0, 0.0]], false);
        assert!(shapes.iter().all(|shape| shape.sides == [0.0; 4]));
    }
}
