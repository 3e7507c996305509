//! Arenas: floors bounded by rings, as sonars hear them.
//!
//! A sonar hears more than a ray meets: an edge scatters sound back to every side, a corner throws it
//! back whence it came, and people walk about. So an arena keeps, beside its faces, the corners where
//! they meet, with which of the two each is. Coordinates are in the world frame, in metres.

mod sight;
#[cfg(test)]
mod tests;

pub use sight::{Cone, MOST_RAYS, Sight};

use crate::geometry::Vec2;

use super::Segment;

/// What a face belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Surface {
    /// A wall.
    Wall,
    /// The frame of a door.
    Door,
    /// A block that stands on the floor.
    Block,
}

/// A closed ring that bounds the floor, the floor to the left of each edge: counter-clockwise round it,
/// clockwise round a block. What edge `i`, from point `i` to the next, belongs to stands beside it.
#[derive(Clone, Debug, PartialEq)]
pub struct Ring {
    /// Corners.
    pub points: Vec<Vec2>,
    /// One for each edge.
    pub surfaces: Vec<Surface>,
}

/// A piece of surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    /// Where it is.
    pub segment: Segment,
    /// What it belongs to.
    pub surface: Surface,
}

/// Where two faces meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// Where it is.
    pub at: Vec2,
    /// Whether it juts into the floor, as the edge of a door does; else it is the corner of a room.
    pub is_edge: bool,
    /// The faces, by number.
    pub faces: [usize; 2],
}

/// Something round that stands or walks on the floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Round {
    /// Where it is, metres.
    pub centre: Vec2,
    /// Metres.
    pub radius_m: f64,
}

/// The face nearest to a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// Metres; infinite when there is none near.
    pub distance_m: f64,
    /// What it belongs to.
    pub surface: Surface,
}

/// What is near a place, so that a question that is asked there looks at nothing else.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Near {
    faces: Vec<Face>,
    /// Numbers of those faces.
    numbers: Vec<usize>,
    corners: Vec<Corner>,
}

/// Rings that bound no floor.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("ring {ring}: {problem}")]
pub struct ArenaError {
    /// Which ring, from 0.
    pub ring: usize,
    /// What is wrong, and what would be right.
    pub problem: &'static str,
}

/// A floor with what bounds it.
#[derive(Clone, Debug, PartialEq)]
pub struct Arena {
    faces: Vec<Face>,
    corners: Vec<Corner>,
    rings: Vec<Ring>,
    bounds_m: [f64; 4],
}

impl Arena {
    /// The floor inside the first ring and outside all others.
    ///
    /// # Errors
    /// When a ring has fewer than three points, another number of surfaces, an edge without length or
    /// runs the wrong way round.
    pub fn new(rings: Vec<Ring>) -> Result<Self, ArenaError> {
        let mut arena = Self {
            faces: Vec::new(),
            corners: Vec::new(),
            rings: Vec::new(),
            bounds_m: [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY],
        };
        for (index, ring) in rings.iter().enumerate() {
            check(ring, index == 0).map_err(|problem| ArenaError { ring: index, problem })?;
            arena.add(ring);
        }
        if rings.is_empty() {
            return Err(ArenaError { ring: 0, problem: "there must be a ring round the floor" });
        }
        arena.rings = rings;
        Ok(arena)
    }

    fn add(&mut self, ring: &Ring) {
        let (first, count) = (self.faces.len(), ring.points.len());
        for (index, (&a, &surface)) in ring.points.iter().zip(&ring.surfaces).enumerate() {
            let (before, b) = ((index + count - 1) % count, ring.points[(index + 1) % count]);
            let turn = (a - ring.points[before]).perp(&(b - a));
            if turn != 0.0 {
                let faces = [first + before, first + index];
                self.corners.push(Corner { at: a, is_edge: turn < 0.0, faces });
            }
            self.faces.push(Face { segment: Segment { a, b }, surface });
            let [x0, y0, x1, y1] = self.bounds_m;
            self.bounds_m = [x0.min(a.x), y0.min(a.y), x1.max(a.x), y1.max(a.y)];
        }
    }

    /// All faces, ring after ring.
    #[must_use]
    pub fn faces(&self) -> &[Face] {
        &self.faces
    }

    /// All corners, ring after ring.
    #[must_use]
    pub fn corners(&self) -> &[Corner] {
        &self.corners
    }

    /// The rings, the outer one first.
    #[must_use]
    pub fn rings(&self) -> &[Ring] {
        &self.rings
    }

    /// Least and greatest x and y, metres: `[x0, y0, x1, y1]`.
    #[must_use]
    pub fn bounds_m(&self) -> [f64; 4] {
        self.bounds_m
    }

    /// Whether a point lies on the floor (even-odd rule).
    #[must_use]
    pub fn is_floor(&self, point: Vec2) -> bool {
        let rings: Vec<&Vec<Vec2>> = self.rings.iter().map(|ring| &ring.points).collect();
        super::crossings(rings, point) % 2 == 1
    }

    /// Notes all faces and corners within a distance of a place, metres.
    pub fn note_near(&self, place: Vec2, within_m: f64, near: &mut Near) {
        near.faces.clear();
        near.numbers.clear();
        near.corners.clear();
        for (number, face) in self.faces.iter().enumerate() {
            let Segment { a, b } = face.segment;
            // How far the box round the face is, before how far the face itself is.
            let gap = |p: f64, q: f64, at: f64| (p.min(q) - at).max(at - p.max(q)).max(0.0);
            let (dx, dy) = (gap(a.x, b.x, place.x), gap(a.y, b.y, place.y));
            if dx.max(dy) <= within_m && face.segment.distance_m(place) <= within_m {
                near.faces.push(*face);
                near.numbers.push(number);
            }
        }
        let close = |corner: &&Corner| {
            let way = corner.at - place;
            way.x.abs().max(way.y.abs()) <= within_m
        };
        near.corners.extend(self.corners.iter().filter(close));
    }
}

impl Near {
    /// What is near by some measure of faces that is not greater than their distance, metres.
    #[must_use]
    pub fn nearest(&self, measure_m: impl Fn(Segment) -> f64) -> Nearest {
        let nothing = Nearest { distance_m: f64::INFINITY, surface: Surface::Wall };
        self.faces.iter().fold(nothing, |nearest, face| {
            let distance_m = measure_m(face.segment);
            if distance_m < nearest.distance_m {
                Nearest { distance_m, surface: face.surface }
            } else {
                nearest
            }
        })
    }
}

fn check(ring: &Ring, is_outer: bool) -> Result<(), &'static str> {
    let points = &ring.points;
    if points.len() < 3 || ring.surfaces.len() != points.len() {
        return Err("there must be at least three points and one surface for each edge");
    }
    if !points.iter().all(|point| point.x.is_finite() && point.y.is_finite()) {
        return Err("coordinates must be finite");
    }
    let edges = || points.iter().zip(points.iter().cycle().skip(1));
    if edges().any(|(a, b)| a == b) {
        return Err("neighbouring points must differ");
    }
    let twice_area: f64 = edges().map(|(a, b)| a.perp(b)).sum();
    match (is_outer, twice_area > 0.0) {
        (true, false) => Err("the outer ring must run counter-clockwise"),
        (false, true) => Err("a block must run clockwise"),
        _ => Ok(()),
    }
}
