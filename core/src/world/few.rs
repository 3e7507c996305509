//! The walls of a small world, so few that a scan looks at all of them: side by side in the frame of the body.

use crate::geometry::Vec2;
use crate::simd::*;

use super::echoes::Wall;
use super::segments::{Leaf, SLACK_M};
use super::tree::{FEW, LANES, lesser};

/// Most walls there may be, and so many are handled together.
const MOST: usize = FEW * LANES;
const TOGETHER: usize = 2 * LANES;

/// Walls in the frame of a body, metres.
#[derive(Clone, Debug)]
pub(super) struct FewWalls {
    ax: [f64; MOST],
    ay: [f64; MOST],
    ex: [f64; MOST],
    ey: [f64; MOST],
    /// Distance of each leaf at least, metres, if they were asked for the nearest first.
    far_m: [f64; FEW],
    leaves: usize,
    /// The lanes that hold a wall of their own.
    real: u64,
}

/// Indices of walls, one bit each.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ahead(u64);

impl Iterator for Ahead {
    type Item = usize;

    #[inline(always)]
    fn next(&mut self) -> Option<usize> {
        let index = (self.0 != 0).then(|| self.0.trailing_zeros() as usize)?;
        self.0 &= self.0 - 1;
        Some(index)
    }
}

/// Half-planes that every ray of a block starts in and never leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Gate {
    /// Bounded by the first ray from the right.
    right: HalfPlane,
    /// Bounded by the last.
    left: HalfPlane,
}

/// The points `p` with `normal · p ≥ least_m`.
#[derive(Clone, Copy, Debug, PartialEq)]
struct HalfPlane {
    normal: Vec2,
    least_m: f64,
}

impl FewWalls {
    /// Room for walls.
    pub(super) fn empty() -> Self {
        let nothing = [0.0; MOST];
        Self {
            ax: nothing,
            ay: nothing,
            ex: nothing,
            ey: nothing,
            far_m: [0.0; FEW],
            leaves: 0,
            real: 0,
        }
    }

    /// Takes the walls of leaves, at most [`FEW`], for a body at a position, heading along the unit vector
    /// `direction`; those of the nearest leaves first if asked to.
    #[inline(always)]
    pub(super) fn take(
        &mut self,
        leaves: &[Leaf],
        position: Vec2,
        direction: Vec2,
        nearest_first: bool,
    ) {
        (self.leaves, self.real) = (leaves.len(), 0);
        if nearest_first {
            let (order, far_m) = by_distance(leaves, position);
            self.far_m = far_m;
            for (rank, index) in order.into_iter().enumerate().take(leaves.len()) {
                self.put(rank, &leaves[index], position, direction);
            }
        } else {
            for (rank, leaf) in leaves.iter().enumerate() {
                self.put(rank, leaf, position, direction);
            }
        }
    }

    #[inline(always)]
    fn put(&mut self, rank: usize, leaf: &Leaf, position: Vec2, direction: Vec2) {
        let walls = leaf.in_frame(position, direction);
        let lanes = rank * LANES..(rank + 1) * LANES;
        self.ax[lanes.clone()].copy_from_slice(&walls.ax);
        self.ay[lanes.clone()].copy_from_slice(&walls.ay);
        self.ex[lanes.clone()].copy_from_slice(&walls.ex);
        self.ey[lanes].copy_from_slice(&walls.ey);
        self.real |= ((1 << leaf.count) - 1) << (rank * LANES);
    }

    /// A wall.
    #[inline(always)]
    pub(super) fn wall(&self, index: usize) -> Wall {
        let index = index % MOST;
        Wall { ax: self.ax[index], ay: self.ay[index], ex: self.ex[index], ey: self.ey[index] }
    }

    /// How far from the middle of the body a wall is at least, metres.
    #[inline(always)]
    pub(super) fn far_m(&self, index: usize) -> f64 {
        self.far_m[index / LANES % FEW]
    }
}

/// The indices of leaves, at most [`FEW`], from the nearest on, and how far away each is at least, metres.
#[inline(always)]
fn by_distance(leaves: &[Leaf], position: Vec2) -> ([usize; FEW], [f64; FEW]) {
    // The last bits of a distance carry the index of its leaf while sorting.
    const INDEX: u64 = FEW as u64 - 1;
    let mut keys = [u64::MAX; FEW];
    for (index, leaf) in leaves.iter().enumerate() {
        let [a, b, c, d] = leaf.distances2(position);
        let nearest2 = lesser(lesser(a, b), lesser(c, d));
        keys[index] = nearest2.to_bits() & !INDEX | index as u64;
    }
    keys[..leaves.len()].sort_unstable();
    (keys.map(|key| (key & INDEX) as usize), keys.map(|key| f64::from_bits(key & !INDEX).sqrt()))
}

impl HalfPlane {
    /// Holds every point.
    const EVERYWHERE: Self = Self { normal: Vec2::new(0.0, 0.0), least_m: -1.0 };

    /// The half-plane on this side of all rays, given by place and direction; none when one leaves it.
    fn behind(rays: &[(Vec2, Vec2)], normal: Vec2) -> Option<Self> {
        // A direction along the edge may come out a rounding error across it; over 200 m that is far less
        // than the slack.
        let stays = rays.iter().all(|(_, direction)| normal.dot(direction) >= -1e-12);
        let least_m = rays.iter().map(|(place, _)| normal.dot(place)).fold(f64::INFINITY, f64::min);
        stays.then_some(Self { normal, least_m: least_m - SLACK_M })
    }

    /// The first of some half-planes that no ray leaves.
    fn first(rays: &[(Vec2, Vec2)], mut normals: impl Iterator<Item = Vec2>) -> Self {
        normals.find_map(|normal| Self::behind(rays, normal)).unwrap_or(Self::EVERYWHERE)
    }

    /// How deep the deeper end of each of eight walls lies inside; below 0 where all of it is outside.
    #[inline(always)]
    fn holds<S: Simd>(&self, ax: f64x8<S>, ay: f64x8<S>, ex: f64x8<S>, ey: f64x8<S>) -> f64x8<S> {
        let a = ax * self.normal.x + ay * self.normal.y;
        let b = a + (ex * self.normal.x + ey * self.normal.y);
        a.max(b) - self.least_m
    }
}

impl Gate {
    /// The gate of rays by places and unit directions: to the left of the first, to the right of the last.
    pub(super) fn new(rays: &[(Vec2, Vec2)]) -> Self {
        let directions = || rays.iter().map(|(_, direction)| *direction);
        Self {
            right: HalfPlane::first(rays, directions().map(|d| Vec2::new(-d.y, d.x))),
            left: HalfPlane::first(rays, directions().map(|d| Vec2::new(d.y, -d.x))),
        }
    }

    /// The walls that are not all on the other side of a half-plane.
    #[inline(always)]
    pub(super) fn lets_in<S: Simd>(&self, simd: S, few: &FewWalls) -> Ahead {
        let mut bits = 0;
        for at in (0..few.leaves * LANES).step_by(TOGETHER) {
            let ax = f64x8::from_slice(simd, &few.ax[at..at + TOGETHER]);
            let ay = f64x8::from_slice(simd, &few.ay[at..at + TOGETHER]);
            let ex = f64x8::from_slice(simd, &few.ex[at..at + TOGETHER]);
            let ey = f64x8::from_slice(simd, &few.ey[at..at + TOGETHER]);
            let inside = self.right.holds(ax, ay, ex, ey).min(self.left.holds(ax, ay, ex, ey));
            bits |= inside.simd_ge(0.0).to_bitmask() << at;
        }
        Ahead(bits & few.real)
    }
}
