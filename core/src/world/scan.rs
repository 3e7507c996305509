//! A ring of fans of rays cast at once: the fast path behind the sonars.
//!
//! The work is done in the robot's frame, where origins and directions of all rays are constants:
//! the ends of each wall are turned into it instead. In a small world every block of four fans tries
//! the walls that reach between its outer rays. In a large one, a ray that leaves the body at angle φ in
//! direction φ + δ stays, seen from the centre, between φ and φ + δ; so a wall that spans an
//! angle as seen from the centre can be met only by the fans that look there, and only those are
//! tried. What is farther than all that these fans still care about is left out,
//! be it a wall or a box of walls. All that is decided with a margin and can never change a reading.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::geometry::{Vec2, angle, unit};
use crate::simd::*;

use super::World;
use super::bearing::Sector;
use super::dial::{Dial, Fans, sector_of_fan};
use super::echoes::{Echoes, Fours, Wall};
use super::few::{Ahead, FewWalls, Gate};
use super::segments::{Leaf, SLACK_M, Segments};
use super::tree::{LANES, Node, Seeker, lesser};

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
    /// What the rays of each block can meet.
    gates: Vec<Gate>,
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
    /// The walls of a small world.
    few: FewWalls,
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
        let gate = |block: &[RayFan]| {
            let rays = block.iter().flat_map(|fan| {
                offsets_rad.iter().map(|offset| (fan.place, unit(fan.axis_rad + offset)))
            });
            Gate::new(&rays.collect::<Vec<_>>())
        };
        let half_cone_rad = (0.5 * cone_rad).min(PI);
        let sectors: Vec<_> = fans.iter().map(|fan| sector(fan, half_cone_rad)).collect();
        let shell = Shell {
            fans: fans.len(),
            rays: offsets_rad.len(),
            places: blocks.map(|block| Fours::of(block, |fan| fan.place)).collect(),
            directions: directions.collect(),
            gates: fans.chunks(LANES).map(gate).collect(),
            dial: Dial::new(&sectors),
            radius_m: fans.iter().map(|fan| fan.place.norm()).fold(0.0, f64::max),
            range_m,
            least_cosine: if critical_rad < FRAC_PI_2 { libm::cos(critical_rad) } else { 0.0 },
        };
        let heard = Heard {
            echoes: vec![Echoes::nothing(range_m); shell.places.len() * shell.echoes_per_block()],
            least: vec![[1.0 / range_m; LANES]; shell.places.len()],
            few: FewWalls::empty(),
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
        let (shell, heard) = (&self.shell, &mut self.heard);
        let least = 1.0 / shell.range_m;
        let tree = segments.tree();
        dispatch!(level, simd => {
            let mut listener = Listener { simd, shell, heard, position, direction, least };
            match tree.few_leaves() {
                Some(leaves) => listener.look_at_all(leaves),
                None => tree.walk(&mut listener),
            }
        });
        self.read(readings_m);
    }

    /// The nearest echo of each fan.
    fn read(&self, readings_m: &mut [f64]) {
        let fans = self.shell.fans.min(readings_m.len());
        let blocks = self.heard.echoes.chunks_exact(self.shell.echoes_per_block());
        for (readings_m, echoes) in readings_m[..fans].chunks_mut(LANES).zip(blocks) {
            let nearest_m = self.shell.nearest_m(echoes);
            readings_m
                .iter_mut()
                .zip(nearest_m)
                .for_each(|(reading_m, nearest_m)| *reading_m = nearest_m);
        }
    }
}

impl Shell {
    /// Echoes kept for a block.
    fn echoes_per_block(&self) -> usize {
        if self.least_cosine > 0.0 { self.rays } else { 1 }
    }

    /// Distances of the nearest echoes of the fans of a block, metres.
    #[inline(always)]
    fn nearest_m(&self, echoes: &[Echoes]) -> [f64; LANES] {
        let mut greatest = [1.0 / self.range_m; LANES];
        for echo in echoes {
            greatest = std::array::from_fn(|k| {
                let returns = echo.cosine[k] >= self.least_cosine;
                let is_nearer = returns & (echo.nearness[k] > greatest[k]);
                if is_nearer { echo.nearness[k] } else { greatest[k] }
            });
        }
        greatest.map(|nearness| lesser(1.0 / nearness, self.range_m))
    }

    /// Whether trying a wall costs less than finding out that it does not matter any more.
    fn is_cheap(&self) -> bool {
        self.rays == 1 && self.least_cosine == 0.0
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
struct Listener<'a, S> {
    simd: S,
    shell: &'a Shell,
    heard: &'a mut Heard,
    position: Vec2,
    direction: Vec2,
    /// The least of what the fans hold as theirs.
    least: f64,
}

impl<S: Simd> Listener<'_, S> {
    /// Lets each block try the walls of a small world that it can meet.
    #[inline(always)]
    fn look_at_all(&mut self, leaves: &[Leaf]) {
        let is_cheap = self.shell.is_cheap();
        self.heard.few.take(leaves, self.position, self.direction, !is_cheap);
        for (block, gate) in self.shell.gates.iter().enumerate() {
            let ahead = gate.lets_in(self.simd, &self.heard.few);
            if is_cheap { self.try_all(block, ahead) } else { self.try_nearest(block, ahead) }
        }
    }

    /// Lets a block of fans of one ray try walls.
    #[inline(always)]
    fn try_all(&mut self, block: usize, ahead: Ahead) {
        let (places, rays) = (&self.shell.places[block], &self.shell.directions[block]);
        let Heard { few, echoes, .. } = &mut *self.heard;
        echoes[block].keep_nearest_of(ahead.map(|index| few.wall(index)), places, rays);
    }

    /// Lets a block try walls, the nearest first, until none matters any more.
    #[inline(always)]
    fn try_nearest(&mut self, block: usize, ahead: Ahead) {
        let mut least = 1.0 / self.shell.range_m;
        for index in ahead {
            if self.beyond_shell_m(self.heard.few.far_m(index)) * least > 1.0 {
                break;
            }
            let wall = self.heard.few.wall(index);
            self.shell.try_block(self.heard, block, wall);
            least = self.heard.least[block].into_iter().fold(f64::INFINITY, lesser);
        }
    }

    /// Lets the fans that look there try the walls of a leaf, the nearest of them so far away.
    #[inline(always)]
    fn look_at(&mut self, leaf: &Leaf, nearest_m: f64) {
        let walls = leaf.in_frame(self.position, self.direction);
        let sectors = Sector::of_walls(&walls);
        let concerned = self.concerned(self.beyond_shell_m(nearest_m));
        for (k, sector) in sectors.into_iter().enumerate().take(leaf.count) {
            for block in self.shell.dial.fans(sector).and(concerned) {
                self.shell.try_block(self.heard, block, walls.wall(k));
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
        let splat = |value| f64x4::splat(self.simd, value);
        let (far_m, one) = (splat(far_m), splat(1.0));
        let blocks = self.heard.least.iter().enumerate();
        blocks.fold(Fans::default(), |fans, (block, least)| {
            let within = (far_m * f64x4::simd_from(self.simd, *least)).simd_le(one);
            fans.or(Fans::of_block(block, within.to_bitmask()))
        })
    }
}

impl<S: Simd> Seeker for Listener<'_, S> {
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
