//! A ring of fans of rays cast at once: the fast path behind the sonars.
//!
//! The work is done in the robot's frame, where origins and directions of all rays are constants:
//! the ends of each wall are turned into it instead. A ray that leaves the body at angle φ in
//! direction φ + δ stays, seen from the centre, between φ and φ + δ; so a wall that spans an
//! angle as seen from the centre can be met only by the fans that look there, and only those are
//! tried, in blocks of four. What is farther than all that these fans still care about is left out,
//! be it a wall or a box of walls. Both are decided with a margin and can never change a reading.

use std::f64::consts::{FRAC_PI_2, PI};

use wide::f64x4;

use crate::geometry::{Vec2, angle, unit};
use crate::simd::{Level, dispatch};

use super::World;
use super::bearing::Sector;
use super::dial::{Dial, Fans, sector_of_fan};
use super::echoes::{Echoes, Fours, Wall};
use super::segments::{Leaf, SLACK_M, Segments};
use super::tree::{FEW, LANES, Node, Seeker, lesser};

/// Where a fan of rays leaves the body and where its middle ray goes, robot frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayFan {
    /// Place, metres.
    pub place: Vec2,
    /// Direction of the middle ray from the heading, radians.
    pub axis_rad: f64,
}

/// Fans of rays round a body.
#[derive(Clone, Debug)]
pub struct RayRing {
    shell: Shell,
    heard: Heard,
}

/// Where the rays are, robot frame. The last block repeats the last fan in lanes left over.
#[derive(Clone, Debug)]
struct Shell {
    fans: usize,
    rays: usize,
    /// Places of the fans of each block, metres.
    places: Vec<Fours>,
    /// Directions of the rays of each block, ray by ray.
    directions: Vec<Fours>,
    dial: Dial,
    /// Greatest distance of a fan from the centre.
    radius_m: f64,
    range_m: f64,
    /// Least cosine of the incidence that still returns an echo; 0 when every ray does.
    least_cosine: f64,
}

/// What has been met so far.
#[derive(Clone, Debug)]
struct Heard {
    /// The nearest surface of each fan of a block; of each of its rays, ray by ray, where an echo
    /// can be lost.
    echoes: Vec<Echoes>,
    /// For each fan of each block, 1 / the distance beyond which nothing matters to it, 1/m.
    least: Vec<[f64; LANES]>,
}

impl RayRing {
    /// At least one and at most 64 fans of `rays` rays, each fan `cone_rad` wide and its outer rays
    /// on the cone's edge. A ray returns no echo when it meets the nearest surface at an incidence
    /// greater than `critical_rad`; `π/2` loses none.
    ///
    /// # Panics
    /// With another number of fans.
    #[must_use]
    pub fn new(
        fans: &[RayFan],
        rays: usize,
        cone_rad: f64,
        range_m: f64,
        critical_rad: f64,
    ) -> Self {
        assert!((1..=Fans::LIMIT).contains(&fans.len()), "{} fans", fans.len());
        let offsets_rad = offsets_rad(rays.max(1), cone_rad);
        let blocks = fans.chunks(LANES);
        let directions = blocks.clone().flat_map(|block| {
            offsets_rad.iter().map(|offset| Fours::of(block, |fan| unit(fan.axis_rad + offset)))
        });
        let half_cone_rad = (0.5 * cone_rad).min(PI);
        let sectors: Vec<_> = fans.iter().map(|fan| sector(fan, half_cone_rad)).collect();
        let shell = Shell {
            fans: fans.len(),
            rays: offsets_rad.len(),
            places: blocks.map(|block| Fours::of(block, |fan| fan.place)).collect(),
            directions: directions.collect(),
            dial: Dial::new(&sectors),
            radius_m: fans.iter().map(|fan| fan.place.norm()).fold(0.0, f64::max),
            range_m,
            least_cosine: if critical_rad < FRAC_PI_2 { libm::cos(critical_rad) } else { 0.0 },
        };
        let heard = Heard {
            echoes: vec![Echoes::nothing(range_m); shell.places.len() * shell.echoes_per_block()],
            least: vec![[1.0 / range_m; LANES]; shell.places.len()],
        };
        Self { shell, heard }
    }

    /// Distance to the nearest echo in each fan from its place, metres, the range where there is
    /// none. The body stands at `position` and `direction` is the unit vector of its heading.
    pub fn scan(&mut self, world: &World, position: Vec2, direction: Vec2, readings_m: &mut [f64]) {
        self.scan_at(Level::new(), &world.segments, position, direction, readings_m);
    }

    /// A scan with the vector instructions of a level, which change nothing but the time it takes.
    fn scan_at(
        &mut self,
        level: Level,
        segments: &Segments,
        position: Vec2,
        direction: Vec2,
        readings_m: &mut [f64],
    ) {
        self.heard.clear(self.shell.range_m);
        let mut listener = Listener {
            shell: &self.shell,
            heard: &mut self.heard,
            position,
            direction,
            least: 1.0 / self.shell.range_m,
        };
        let tree = segments.tree();
        match tree.few_leaves() {
            Some(leaves) => dispatch!(level, _ => listener.look_at_all(leaves)),
            None => dispatch!(level, _ => tree.walk(&mut listener)),
        }
        self.read(readings_m);
    }

    /// The nearest echo of each fan.
    fn read(&self, readings_m: &mut [f64]) {
        let per_block = self.shell.echoes_per_block();
        for (fan, reading_m) in readings_m.iter_mut().enumerate().take(self.shell.fans) {
            let first = fan / LANES * per_block;
            let echoes = &self.heard.echoes[first..first + per_block];
            *reading_m = self.shell.nearest_m(echoes, fan % LANES);
        }
    }
}

impl Shell {
    /// Echoes kept for a block.
    fn echoes_per_block(&self) -> usize {
        if self.least_cosine > 0.0 { self.rays } else { 1 }
    }

    /// Distance of the nearest echo of a fan, metres.
    fn nearest_m(&self, echoes: &[Echoes], lane: usize) -> f64 {
        let returned = echoes.iter().filter(|echo| echo.cosine[lane] >= self.least_cosine);
        let nearness = returned.map(|echo| echo.nearness[lane]);
        let greatest = nearness.fold(1.0 / self.range_m, |a, b| if b > a { b } else { a });
        (1.0 / greatest).min(self.range_m)
    }

    /// Lets a block try a wall.
    #[inline(always)]
    fn try_block(&self, heard: &mut Heard, block: usize, wall: Wall) {
        let rays = block * self.rays..(block + 1) * self.rays;
        let (places, directions) = (&self.places[block], &self.directions[rays.clone()]);
        heard.least[block] = if self.least_cosine > 0.0 {
            Echoes::keep_each(&mut heard.echoes[rays], wall, places, directions)
        } else {
            heard.echoes[block].keep_nearest(wall, places, directions)
        };
    }
}

impl Heard {
    fn clear(&mut self, range_m: f64) {
        self.echoes.fill(Echoes::nothing(range_m));
        self.least.fill([1.0 / range_m; LANES]);
    }
}

/// A ring at work: looks for the nearest echo of every fan.
struct Listener<'a> {
    shell: &'a Shell,
    heard: &'a mut Heard,
    position: Vec2,
    direction: Vec2,
    /// The least of what the fans hold as theirs.
    least: f64,
}

impl Listener<'_> {
    /// Looks at the leaves of a small world, the nearest first, until none matters any more.
    #[inline(always)]
    fn look_at_all(&mut self, leaves: &[Leaf]) {
        // The last bits of a distance carry the index of its leaf while sorting.
        const INDEX: u64 = FEW as u64 - 1;
        let mut order = [0; FEW];
        for (index, leaf) in leaves.iter().enumerate() {
            let [a, b, c, d] = leaf.distances2(self.position);
            let nearest2 = lesser(lesser(a, b), lesser(c, d));
            order[index] = nearest2.to_bits() & !INDEX | index as u64;
        }
        let order = &mut order[..leaves.len()];
        order.sort_unstable();
        for key in order {
            let nearest_m = f64::from_bits(*key & !INDEX).sqrt();
            if self.beyond_shell_m(nearest_m) * self.least > 1.0 {
                break;
            }
            self.look_at(&leaves[(*key & INDEX) as usize], nearest_m);
        }
    }

    /// Lets the fans that look there try the walls of a leaf, the nearest of them so far away.
    #[inline(always)]
    fn look_at(&mut self, leaf: &Leaf, nearest_m: f64) {
        let walls = leaf.in_frame(self.position, self.direction);
        let sectors = Sector::of_walls(&walls);
        let concerned = self.concerned(self.beyond_shell_m(nearest_m));
        for (k, sector) in sectors.into_iter().enumerate().take(leaf.count) {
            let (ax, ay, ex, ey) = (walls.ax[k], walls.ay[k], walls.ex[k], walls.ey[k]);
            for block in self.shell.dial.fans(sector).and(concerned) {
                self.shell.try_block(self.heard, block, Wall { ax, ay, ex, ey });
            }
        }
        let least = self.heard.least.iter().fold([f64::INFINITY; LANES], |least, four| {
            std::array::from_fn(|k| lesser(least[k], four[k]))
        });
        self.least = least.into_iter().fold(f64::INFINITY, lesser);
    }

    /// How far something is from the places of all fans at least, metres.
    #[inline(always)]
    fn beyond_shell_m(&self, distance_m: f64) -> f64 {
        distance_m - self.shell.radius_m - SLACK_M
    }

    /// The fans to which something so far away may still matter.
    #[inline(always)]
    fn concerned(&self, far_m: f64) -> Fans {
        let far_m = f64x4::splat(far_m);
        let blocks = self.heard.least.iter().enumerate();
        blocks.fold(Fans::default(), |fans, (block, least)| {
            let within = (far_m * f64x4::new(*least)).simd_le(f64x4::ONE);
            fans.or(Fans::of_block(block, within.to_bitmask()))
        })
    }
}

impl Seeker for Listener<'_> {
    /// The fans that look towards a box.
    type Note = Fans;

    #[inline(always)]
    fn boxes(&self, node: &Node) -> ([f64; LANES], [Fans; LANES]) {
        let reach_m = 1.0 / self.least;
        let distances_m = node.distances2(self.position).map(f64::sqrt);
        let near = distances_m.map(|far_m| self.beyond_shell_m(far_m) <= reach_m);
        let sectors = Sector::of_boxes(&node.middles(), self.position, self.direction);
        let fans = |k: usize| self.shell.dial.fans(sectors[k]);
        (
            std::array::from_fn(|k| if near[k] { distances_m[k] } else { f64::INFINITY }),
            std::array::from_fn(|k| if near[k] { fans(k) } else { Fans::default() }),
        )
    }

    #[inline(always)]
    fn matters(&self, distance_m: f64, fans: Fans) -> bool {
        !fans.and(self.concerned(self.beyond_shell_m(distance_m))).is_empty()
    }

    #[inline(always)]
    fn look(&mut self, leaf: &Leaf) {
        let nearest2 = leaf.distances2(self.position).into_iter().fold(f64::INFINITY, lesser);
        self.look_at(leaf, nearest2.sqrt());
    }
}

/// The sector in which the rays of a fan are seen from the centre; none when that may be anywhere.
fn sector(fan: &RayFan, half_cone_rad: f64) -> Option<Sector> {
    let outwards = if fan.place == Vec2::zeros() { fan.axis_rad } else { angle(fan.place) };
    sector_of_fan(outwards, fan.axis_rad, half_cone_rad)
}

/// Angles of the rays of a fan from its middle, radians, spread evenly over the cone.
fn offsets_rad(rays: usize, cone_rad: f64) -> Vec<f64> {
    if rays == 1 {
        return vec![0.0];
    }
    (0..rays).map(|ray| cone_rad * (ray as f64 / (rays - 1) as f64 - 0.5)).collect()
}

#[cfg(test)]
mod tests;
