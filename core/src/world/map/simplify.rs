//! A traced ring with fewer corners, never farther than half a cell from it.
//!
//! The boundary of cells is a staircase wherever a wall is not along an axis; a line through the
//! middles of its steps is a better wall. So the new corners are chosen among the old ones and the
//! middles between them, as few as possible, and among equally few those nearest to the old ring
//! (the shortest way through all admissible pieces, as in H. Imai and M. Iri, "Polygonal
//! approximations of a curve", 1988).
//!
//! A piece is admissible when every old corner that it skips lies within [`TOLERANCE`] of it. Then
//! the old ring can be pulled onto the new one without crossing any place farther from it than that:
//! nothing opens that was closed, and every cell's centre stays on its side.

/// Greatest distance of a skipped corner from the piece that replaces it, cells. Less than a half, so
/// that the centre of a cell keeps off the line.
pub(super) const TOLERANCE: f64 = 0.49;

/// Most candidates that one piece may skip, which bounds the time spent on a long slanted wall.
const LONGEST_SKIP: usize = 2_000;

/// The corners of a simplified ring, in the units of the traced one.
pub(super) fn simplified(ring: &[[i32; 2]]) -> Vec<[f64; 2]> {
    let candidates = Candidates::new(ring);
    let last = candidates.points.len() - 1;
    let mut cost = vec![f64::INFINITY; last + 1];
    let mut from = vec![0; last + 1];
    cost[0] = 0.0;
    for start in 0..last {
        candidates.pieces(start, |end, deviation| {
            // One for the piece, and up to one more for how far it leaves the old ring.
            let sum = cost[start] + 1.0 + deviation;
            if sum < cost[end] {
                (cost[end], from[end]) = (sum, start);
            }
        });
    }
    let chosen = std::iter::successors(Some(from[last]), |&end| (end > 0).then(|| from[end]));
    let mut corners: Vec<_> = chosen.map(|index| halved(candidates.points[index])).collect();
    corners.reverse();
    corners
}

/// Old corners at even indices, the middles after them at odd ones, and the first again at the end.
/// All in half cells, so that they are whole numbers.
struct Candidates {
    points: Vec<[i64; 2]>,
    /// Sums over the corners before each one: their number, x, y, x², xy, y².
    sums: Vec<[i128; 6]>,
}

impl Candidates {
    fn new(ring: &[[i32; 2]]) -> Self {
        let corner = |index: usize| ring[index % ring.len()].map(i64::from);
        let mut points = Vec::with_capacity(2 * ring.len() + 1);
        let mut sums = vec![[0; 6]];
        for index in 0..ring.len() {
            let ([x, y], [next_x, next_y]) = (corner(index), corner(index + 1));
            points.extend([[2 * x, 2 * y], [x + next_x, y + next_y]]);
            let [px, py] = [2 * x, 2 * y].map(i128::from);
            let terms = [1, px, py, px * px, px * py, py * py];
            let before = sums[index];
            sums.push(std::array::from_fn(|term| before[term] + terms[term]));
        }
        points.push(points[0]);
        Self { points, sums }
    }

    /// All admissible pieces from a candidate, each with the mean square of the skipped corners'
    /// distances as a share of the tolerance's.
    fn pieces(&self, start: usize, mut take: impl FnMut(usize, f64)) {
        let mut view = View::default();
        let mut farthest2 = 0;
        let longest = (start + LONGEST_SKIP).min(self.points.len() - 1);
        for end in start + 1..=longest {
            let skipped = end - 1;
            if skipped > start && skipped.is_multiple_of(2) {
                let offset = self.offset(start, skipped);
                farthest2 = farthest2.max(norm2(offset));
                if !view.narrow(offset) {
                    return;
                }
            }
            // No skipped corner lies beyond the end, so being near the ray means being near the piece.
            let offset = self.offset(start, end);
            if norm2(offset) >= farthest2 && view.holds(offset) {
                take(end, self.deviation(start, end));
            }
        }
    }

    fn offset(&self, from: usize, to: usize) -> [i64; 2] {
        let (from, to) = (self.points[from], self.points[to]);
        [to[0] - from[0], to[1] - from[1]]
    }

    fn deviation(&self, start: usize, end: usize) -> f64 {
        // Corners strictly between: index k of the ring stands at 2k.
        let (first, beyond) = (start / 2 + 1, end.div_ceil(2));
        if first >= beyond {
            return 0.0;
        }
        let (low, high) = (self.sums[first], self.sums[beyond]);
        let [n, sx, sy, sxx, sxy, syy] = std::array::from_fn(|term| high[term] - low[term]);
        let [ax, ay] = self.points[start].map(i128::from);
        // Second moments about the start.
        let xx = (sxx - 2 * ax * sx + n * ax * ax) as f64;
        let xy = (sxy - ax * sy - ay * sx + n * ax * ay) as f64;
        let yy = (syy - 2 * ay * sy + n * ay * ay) as f64;
        let [dx, dy] = self.offset(start, end).map(|value| value as f64);
        let squares = dy * dy * xx - 2.0 * dx * dy * xy + dx * dx * yy;
        squares / ((dx * dx + dy * dy) * n as f64 * 4.0 * TOLERANCE * TOLERANCE)
    }
}

/// The directions in which a ray passes all corners seen so far within the tolerance.
#[derive(Default)]
struct View {
    /// Its right and left edges, less than half a turn apart; none while all directions do.
    edges: Option<[[f64; 2]; 2]>,
}

impl View {
    /// Takes another corner into account; false when no direction is left.
    fn narrow(&mut self, offset: [i64; 2]) -> bool {
        let [x, y] = offset.map(|value| value as f64);
        let (distance2, radius) = (x * x + y * y, 2.0 * TOLERANCE);
        if distance2 <= radius * radius {
            return true;
        }
        // The tangents of the circle round the corner, as seen from the start.
        let along = libm::sqrt(distance2 - radius * radius);
        let tangents = [
            [along * x + radius * y, along * y - radius * x],
            [along * x - radius * y, along * y + radius * x],
        ];
        let Some([right, left]) = self.edges else {
            self.edges = Some(tangents);
            return true;
        };
        let pick = |old: [f64; 2], new: [f64; 2]| {
            if between(tangents, old) {
                Some(old)
            } else {
                between([right, left], new).then_some(new)
            }
        };
        self.edges = pick(right, tangents[0]).zip(pick(left, tangents[1])).map(|(r, l)| [r, l]);
        self.edges.is_some()
    }

    fn holds(&self, offset: [i64; 2]) -> bool {
        self.edges.is_none_or(|edges| between(edges, offset.map(|value| value as f64)))
    }
}

/// Whether a direction lies between a right and a left one that are less than half a turn apart.
fn between([right, left]: [[f64; 2]; 2], direction: [f64; 2]) -> bool {
    cross(right, direction) >= 0.0 && cross(direction, left) >= 0.0
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn norm2([x, y]: [i64; 2]) -> i64 {
    x * x + y * y
}

fn halved(point: [i64; 2]) -> [f64; 2] {
    point.map(|value| value as f64 * 0.5)
}
