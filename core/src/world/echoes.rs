//! What a block of four fans of rays has met so far: the inner loop of a scan, lane by lane.

use crate::geometry::Vec2;

use super::ray::{CORNER_OVERLAP, GRAZING_M};
use super::tree::{LANES, lesser};

/// Two coordinates of each of four fans.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fours {
    pub(super) x: [f64; LANES],
    pub(super) y: [f64; LANES],
}

/// The nearest surfaces met by four rays, one of each fan of a block.
#[derive(Clone, Copy, Debug)]
pub(super) struct Echoes {
    /// 1 / distance of the nearest surface so far, 1/m.
    pub(super) nearness: [f64; LANES],
    /// Cosine of the incidence there.
    pub(super) cosine: [f64; LANES],
}

/// A wall in the frame of a body, metres: one end, and the way to the other.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wall {
    pub(super) ax: f64,
    pub(super) ay: f64,
    pub(super) ex: f64,
    pub(super) ey: f64,
}

/// A wall as seen from four places, scaled so that `d × e` is 1/distance along `d`.
struct Scaled {
    wx: [f64; LANES],
    wy: [f64; LANES],
    ex: [f64; LANES],
    ey: [f64; LANES],
}

impl Fours {
    /// A vector of each fan of a block of one to four; the last fills the lanes left over.
    pub(super) fn of<T>(block: &[T], vector: impl Fn(&T) -> Vec2) -> Self {
        let four: [Vec2; LANES] = std::array::from_fn(|k| vector(&block[k.min(block.len() - 1)]));
        Self { x: four.map(|vector| vector.x), y: four.map(|vector| vector.y) }
    }
}

impl Scaled {
    #[inline(always)]
    fn new(wall: Wall, places: &Fours) -> Self {
        let Wall { ax, ay, ex, ey } = wall;
        let grazing = GRAZING_M * (ex.abs() + ey.abs());
        let mut scaled =
            Self { wx: [0.0; LANES], wy: [0.0; LANES], ex: [0.0; LANES], ey: [0.0; LANES] };
        for k in 0..LANES {
            let (wx, wy) = (ax - places.x[k], ay - places.y[k]);
            // 1/distance along direction d is (d × e) / (w × e); e and w are scaled once here.
            let off_line = wx * ey - wy * ex;
            let scale = if off_line.abs() > grazing { 1.0 / off_line } else { 0.0 };
            (scaled.wx[k], scaled.wy[k]) = (wx * scale, wy * scale);
            (scaled.ex[k], scaled.ey[k]) = (ex * scale, ey * scale);
        }
        scaled
    }

    /// 1/distance of the wall along four rays where it is nearer than what was met; else that.
    #[inline(always)]
    fn nearer(&self, rays: &Fours, met: &[f64; LANES]) -> [f64; LANES] {
        let mut nearest = [0.0; LANES];
        for k in 0..LANES {
            let (dx, dy) = (rays.x[k], rays.y[k]);
            let nearness = dx * self.ey[k] - dy * self.ex[k];
            let along = self.wx[k] * dy - self.wy[k] * dx;
            let within = (along >= -CORNER_OVERLAP * nearness)
                & (along <= (1.0 + CORNER_OVERLAP) * nearness);
            nearest[k] = if within & (nearness > met[k]) { nearness } else { met[k] };
        }
        nearest
    }
}

impl Echoes {
    /// Nothing within a range, metres.
    pub(super) fn nothing(range_m: f64) -> Self {
        Self { nearness: [1.0 / range_m; LANES], cosine: [1.0; LANES] }
    }

    /// Keeps the nearest surface of each fan. Gives the nearness of each.
    #[inline(always)]
    pub(super) fn keep_nearest(
        &mut self,
        wall: Wall,
        places: &Fours,
        rays: &[Fours],
    ) -> [f64; LANES] {
        let seen = Scaled::new(wall, places);
        let mut nearness = self.nearness;
        for rays in rays {
            nearness = seen.nearer(rays, &nearness);
        }
        self.nearness = nearness;
        nearness
    }

    /// Keeps the nearest of some surfaces along one ray of each fan.
    #[inline(always)]
    pub(super) fn keep_nearest_of(
        &mut self,
        walls: impl Iterator<Item = Wall>,
        places: &Fours,
        rays: &Fours,
    ) {
        self.nearness = walls.fold(self.nearness, |nearness, wall| {
            Scaled::new(wall, places).nearer(rays, &nearness)
        });
    }

    /// Keeps the nearest surface of each ray, with the incidence there; `echoes` and `rays` go ray by
    /// ray. Gives the least nearness of the rays of each fan.
    #[inline(always)]
    pub(super) fn keep_each(
        echoes: &mut [Self],
        wall: Wall,
        places: &Fours,
        rays: &[Fours],
    ) -> [f64; LANES] {
        let seen = Scaled::new(wall, places);
        let cosine_per_nearness: [f64; LANES] = std::array::from_fn(|k| {
            1.0 / (seen.ex[k] * seen.ex[k] + seen.ey[k] * seen.ey[k]).sqrt()
        });
        let mut farthest = [f64::INFINITY; LANES];
        for (echoes, rays) in echoes.iter_mut().zip(rays) {
            let nearest = seen.nearer(rays, &echoes.nearness);
            for k in 0..LANES {
                let cosine = nearest[k] * cosine_per_nearness[k];
                let nearer = nearest[k] > echoes.nearness[k];
                echoes.cosine[k] = if nearer { cosine } else { echoes.cosine[k] };
                farthest[k] = lesser(farthest[k], nearest[k]);
            }
            echoes.nearness = nearest;
        }
        farthest
    }
}
