//! A picture as a list of primitives, the only thing a back end has to understand.
//!
//! Everything is in pixels: the origin is the top left corner, `x` grows to the right and `y`
//! downwards, so positive angles turn clockwise on the screen. Whatever the two back ends could do
//! differently (dashes, glyph outlines, dropping of numbers that cannot be drawn) is settled here
//! or in [`super::text`], once for both.

/// A place in the picture, pixels.
pub type Point = [f32; 2];

/// A colour with straight (not premultiplied) alpha, sRGB, eight bits a channel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Colour(pub [u8; 4]);

impl Colour {
    /// An opaque colour from `0xRRGGBB`.
    pub const fn rgb(code: u32) -> Self {
        Self([(code >> 16) as u8, (code >> 8) as u8, code as u8, 255])
    }

    /// The same colour with this opacity, 0 to 1.
    pub fn fade(self, opacity: f32) -> Self {
        let [red, green, blue, _] = self.0;
        Self([red, green, blue, (opacity.clamp(0.0, 1.0) * 255.0).round() as u8])
    }

    /// The colour `share` of the way (0 to 1) from this one to `other`.
    pub fn mix(self, other: Self, share: f32) -> Self {
        let share = share.clamp(0.0, 1.0);
        Self(std::array::from_fn(|i| {
            let (from, to) = (f32::from(self.0[i]), f32::from(other.0[i]));
            (from + (to - from) * share).round() as u8
        }))
    }

    /// Channels 0 to 1 multiplied by the alpha, as a blender wants them.
    pub fn premultiplied(self) -> [f32; 4] {
        let [red, green, blue, alpha] = self.0.map(|channel| f32::from(channel) / 255.0);
        [red * alpha, green * alpha, blue * alpha, alpha]
    }
}

/// One thing to draw.
#[derive(Clone, Debug, PartialEq)]
pub enum Primitive {
    /// A line through points.
    Stroke(Stroke),
    /// A filled ring sector: a disc when `inner` is 0 and the sweep a full turn.
    Sector(Sector),
    /// A filled area, convex or not; later contours wound the other way are holes.
    Polygon {
        /// Closed contours; the last point joins the first.
        contours: Vec<Vec<Point>>,
        /// Fill.
        colour: Colour,
    },
    /// A line of text.
    Text(Text),
}

/// A line with round caps and joints.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stroke {
    /// The points it runs through.
    pub points: Vec<Point>,
    /// Full width, pixels.
    pub width: f32,
    /// Colour.
    pub colour: Colour,
    /// Lengths drawn and left out, pixels; none for a line without gaps.
    pub dash: Option<[f32; 2]>,
    /// The last point joins the first.
    pub closed: bool,
}

/// A ring sector.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sector {
    /// Centre of the circle it is cut from.
    pub centre: Point,
    /// Radius of the hole, pixels.
    pub inner: f32,
    /// Radius, pixels.
    pub outer: f32,
    /// Where it begins, radians clockwise from the `x` axis.
    pub start_rad: f32,
    /// How far it runs clockwise, radians, up to a full turn.
    pub sweep_rad: f32,
    /// Fill.
    pub colour: Colour,
}

/// A line of text.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// The anchor's place on the baseline.
    pub at: Point,
    /// What it says.
    pub text: String,
    /// Font size (pixels to the em).
    pub size: f32,
    /// Which part of the text stands at `at`.
    pub anchor: Anchor,
    /// Fill.
    pub colour: Colour,
    /// An opaque rim that keeps it legible over lines: its colour and width beyond the glyphs.
    pub halo: Option<(Colour, f32)>,
}

/// Which part of a text stands at its place.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Anchor {
    /// Its beginning.
    #[default]
    Start,
    /// Its middle.
    Middle,
    /// Its end.
    End,
}

/// A connected part of a stroke without gaps.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// Points, no two neighbours equal; one point is a dot.
    pub points: Vec<Point>,
    /// The last point joins the first.
    pub closed: bool,
}

/// A picture to be drawn: primitives from back to front on an opaque ground.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
    /// Ground; its alpha is ignored, pictures are opaque.
    pub background: Colour,
    primitives: Vec<Primitive>,
}

impl Scene {
    /// An empty picture.
    pub fn new(width: u32, height: u32, background: Colour) -> Self {
        Self { width, height, background, primitives: Vec::new() }
    }

    /// The primitives from back to front.
    pub fn primitives(&self) -> &[Primitive] {
        &self.primitives
    }

    /// Adds a primitive in front, unless a number in it cannot be drawn (NaN, infinity, no size).
    pub fn push(&mut self, primitive: Primitive) {
        if primitive.is_drawable() {
            self.primitives.push(primitive);
        }
    }

    /// Adds a line.
    pub fn stroke(&mut self, points: Vec<Point>, width: f32, colour: Colour) {
        self.push(Primitive::Stroke(Stroke { points, width, colour, ..Stroke::default() }));
    }

    /// Adds a closed outline.
    pub fn outline(&mut self, points: Vec<Point>, width: f32, colour: Colour) {
        let stroke = Stroke { points, width, colour, closed: true, ..Stroke::default() };
        self.push(Primitive::Stroke(stroke));
    }

    /// Adds a filled circle.
    pub fn disc(&mut self, centre: Point, radius: f32, colour: Colour) {
        self.arc(centre, [0.0, radius], [0.0, std::f32::consts::TAU], colour);
    }

    /// Adds a circle line whose middle has this radius.
    pub fn ring(&mut self, centre: Point, radius: f32, width: f32, colour: Colour) {
        let radii = [(radius - width / 2.0).max(0.0), radius + width / 2.0];
        self.arc(centre, radii, [0.0, std::f32::consts::TAU], colour);
    }

    /// Adds a ring sector: inner and outer radius, start and sweep in radians clockwise.
    pub fn arc(&mut self, centre: Point, radii: [f32; 2], turn_rad: [f32; 2], colour: Colour) {
        let ([inner, outer], [start_rad, sweep_rad]) = (radii, turn_rad);
        let sector = Sector { centre, inner, outer, start_rad, sweep_rad, colour };
        self.push(Primitive::Sector(sector));
    }

    /// Adds a filled area with one contour.
    pub fn polygon(&mut self, contour: Vec<Point>, colour: Colour) {
        self.push(Primitive::Polygon { contours: vec![contour], colour });
    }

    /// Adds an upright rectangle `[left, top, right, bottom]`.
    pub fn rectangle(&mut self, [left, top, right, bottom]: [f32; 4], colour: Colour) {
        let corners = vec![[left, top], [right, top], [right, bottom], [left, bottom]];
        self.polygon(corners, colour);
    }
}

/// Beyond this a coordinate is a mistake, and back ends that work in fixed point may overflow.
const FARTHEST_PX: f32 = 60_000.0;

impl Primitive {
    fn is_drawable(&self) -> bool {
        match self {
            Self::Stroke(stroke) => {
                stroke.width > 0.0 && in_reach(stroke.width) && stroke.points.iter().all(placed)
            }
            Self::Sector(sector) => sector.is_drawable(),
            Self::Polygon { contours, .. } => contours.iter().flatten().all(placed),
            Self::Text(text) => {
                text.size > 0.0 && in_reach(text.size) && placed(&text.at) && !text.text.is_empty()
            }
        }
    }
}

impl Sector {
    fn is_drawable(&self) -> bool {
        placed(&self.centre)
            && self.inner >= 0.0
            && self.outer > self.inner
            && in_reach(self.outer)
            && self.start_rad.is_finite()
            && self.sweep_rad > 0.0
    }

    /// A full turn: a disc or a ring.
    pub fn is_full(&self) -> bool {
        self.sweep_rad >= std::f32::consts::TAU - 1e-4
    }
}

fn in_reach(length_px: f32) -> bool {
    length_px.abs() <= FARTHEST_PX
}

fn placed(point: &Point) -> bool {
    in_reach(point[0]) && in_reach(point[1])
}

impl Stroke {
    /// The connected parts to draw: one, or its dashes.
    pub fn runs(&self) -> Vec<Run> {
        let mut points = distinct(&self.points);
        let closed = self.closed && points.len() > 2;
        if closed && distance(points[0], points[points.len() - 1]) < LEAST_STEP_PX {
            points.pop();
        }
        match self.dash {
            Some([on, off]) if on > 0.0 && off > 0.0 && on.is_finite() && off.is_finite() => {
                if closed {
                    points.push(points[0]);
                }
                dashes(&points, on.max(0.5), off.max(0.5))
            }
            _ if points.is_empty() => Vec::new(),
            _ => vec![Run { points, closed }],
        }
    }
}

/// Points closer than this have no direction worth drawing.
const LEAST_STEP_PX: f32 = 1e-3;

fn distinct(points: &[Point]) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::with_capacity(points.len());
    for &point in points {
        if kept.last().is_none_or(|&last| distance(last, point) >= LEAST_STEP_PX) {
            kept.push(point);
        }
    }
    kept
}

/// Cuts a line into pieces `on` long with gaps of `off`.
fn dashes(points: &[Point], on: f32, off: f32) -> Vec<Run> {
    let mut runs = Vec::new();
    let mut current: Vec<Point> = points.first().copied().into_iter().collect();
    let (mut drawing, mut left) = (true, on);
    for pair in points.windows(2) {
        let (mut from, to) = (pair[0], pair[1]);
        let mut rest = distance(from, to);
        while rest > left {
            from = along(from, to, left / rest);
            rest -= left;
            if drawing {
                current.push(from);
                runs.push(Run { points: std::mem::take(&mut current), closed: false });
            } else {
                current = vec![from];
            }
            drawing = !drawing;
            left = if drawing { on } else { off };
        }
        left -= rest;
        if drawing {
            current.push(to);
        }
    }
    if drawing && current.len() > 1 {
        runs.push(Run { points: current, closed: false });
    }
    runs.into_iter().map(|run| Run { points: distinct(&run.points), ..run }).collect()
}

/// Distance between two places.
pub fn distance(a: Point, b: Point) -> f32 {
    (b[0] - a[0]).hypot(b[1] - a[1])
}

fn along(from: Point, to: Point, share: f32) -> Point {
    [from[0] + (to[0] - from[0]) * share, from[1] + (to[1] - from[1]) * share]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dashes_cover_the_line_and_leave_the_gaps() {
        let line = |dash| Stroke {
            points: vec![[0.0, 0.0], [7.0, 0.0], [20.0, 0.0]],
            width: 1.0,
            dash,
            ..Stroke::default()
        };
        for (dash, pieces, drawn_px) in [
            (None, 1, 20.0),
            (Some([5.0, 5.0]), 2, 10.0),
            (Some([30.0, 5.0]), 1, 20.0),
            (Some([0.0, 5.0]), 1, 20.0),
            (Some([6.0, 2.0]), 3, 16.0),
        ] {
            let runs = line(dash).runs();
            let length =
                |run: &Run| run.points.windows(2).map(|p| distance(p[0], p[1])).sum::<f32>();
            assert_eq!(runs.len(), pieces, "{dash:?}");
            let total: f32 = runs.iter().map(length).sum();
            assert!((total - drawn_px).abs() < 1e-4, "{dash:?}: {total}");
        }
    }

    #[test]
    fn what_cannot_be_drawn_is_left_out() {
        let mut scene = Scene::new(10, 10, Colour::rgb(0));
        scene.disc([f32::NAN, 0.0], 1.0, Colour::rgb(0));
        scene.disc([0.0, 0.0], f32::INFINITY, Colour::rgb(0));
        scene.disc([0.0, 0.0], -1.0, Colour::rgb(0));
        scene.stroke(vec![[0.0, 0.0], [1e9, 0.0]], 1.0, Colour::rgb(0));
        scene.stroke(vec![[0.0, 0.0], [1.0, 0.0]], f32::NAN, Colour::rgb(0));
        scene.polygon(vec![[0.0, f32::NEG_INFINITY]], Colour::rgb(0));
        assert_eq!(scene.primitives(), []);
        scene.disc([1.0, 1.0], 1.0, Colour::rgb(0));
        assert_eq!(scene.primitives().len(), 1);
    }

    #[test]
    fn repeated_points_make_one_dot() {
        let stroke = Stroke { points: vec![[3.0, 3.0]; 5], width: 2.0, ..Stroke::default() };
        assert_eq!(stroke.runs(), [Run { points: vec![[3.0, 3.0]], closed: false }]);
    }
}
