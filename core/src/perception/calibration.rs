//! What the deviation ς of a sonar is: Eq. (2.8) as a procedure.
//!
//! One sonar alone stands at the places that a robot could face, at different distances and angles, and
//! pairs of the true and the measured distance are taken. NOTE: the thesis names the places; their
//! layout, 2000 pairs at each, distances from 0.2 to 1.9 m and angles of up to 30° are ours. Truth is the
//! nearest surface in the cone. Nothing else is fired, so there is no crosstalk; what it adds when the
//! robot drives is what the factor k > 1 stands for.

use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use crate::geometry::{Pose, Vec2, unit};
use crate::rng::{Purpose, stream};
use crate::robot::{Equipment, FiringOrder, Mount, NoiseLevel, Reading, Scanner};
use crate::stats::Estimate;
use crate::world::{Arena, Near, Ring, Surface};

/// Distances and angles that pairs are taken at.
const DISTANCES_M: [f64; 2] = [0.2, 1.9];
const ANGLE_DEG: f64 = 30.0;
/// Half the side of the room that holds a place, so that its other walls are out of range, metres.
const FAR_M: f64 = 20.0;
/// Section 2.9: half the width of a door; half the width of the corridor is ours.
const HALF_DOOR_M: f64 = 0.9;
const HALF_CORRIDOR_M: f64 = 1.2;
const THICKNESS_M: f64 = 0.15;

/// Where the sonar stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Before a wall.
    Wall,
    /// In the corner of a room.
    Corner,
    /// In a corridor, looking along it.
    Corridor,
    /// Before the middle of an open door.
    DoorEdge,
    /// Where nothing is in range.
    FreeWay,
}

impl Place {
    /// All of them, in the order they are visited.
    pub const ALL: [Self; 5] =
        [Self::Wall, Self::Corner, Self::Corridor, Self::DoorEdge, Self::FreeWay];

    /// Name for people.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Wall => "wall",
            Self::Corner => "corner",
            Self::Corridor => "corridor",
            Self::DoorEdge => "door edge",
            Self::FreeWay => "free way",
        }
    }

    /// The floor: a room, with what makes the place at the origin, ahead of which is +x.
    fn arena(self) -> Arena {
        let far = FAR_M;
        let wide = match self {
            Self::Corridor => HALF_CORRIDOR_M,
            _ => far,
        };
        let ends = match self {
            Self::Wall => (-far, 0.0, -wide, wide),
            // The corner is at the origin, between walls ahead and to the left.
            Self::Corner => (-far, 0.0, -wide, 0.0),
            Self::Corridor | Self::DoorEdge | Self::FreeWay => (-far, far, -wide, wide),
        };
        let (x0, x1, y0, y1) = ends;
        let room = ring([[x0, y0], [x1, y0], [x1, y1], [x0, y1]], Surface::Wall);
        // Walls to both sides that leave the door open; clockwise.
        let (near, end, thick) = (HALF_DOOR_M, far - 1.0, THICKNESS_M);
        let frames = [
            [[0.0, near], [0.0, end], [thick, end], [thick, near]],
            [[0.0, -end], [0.0, -near], [thick, -near], [thick, -end]],
        ];
        let frames = frames.into_iter().filter(|_| self == Self::DoorEdge);
        let frames = frames.map(|frame| ring(frame, Surface::Door));
        Arena::new([room].into_iter().chain(frames).collect()).expect("rings that bound a floor")
    }

    /// Where the sonar stands and looks for a distance in metres and an angle.
    fn pose(self, distance_m: f64, angle_rad: f64) -> Pose {
        let (place, ahead_rad) = match self {
            Self::Corner => {
                (unit(-0.75 * std::f64::consts::PI) * distance_m, std::f64::consts::FRAC_PI_4)
            }
            // So far from the left wall.
            Self::Corridor => (Vec2::new(0.0, HALF_CORRIDOR_M - distance_m), 0.0),
            Self::Wall | Self::DoorEdge | Self::FreeWay => (Vec2::new(-distance_m, 0.0), 0.0),
        };
        Pose::new(place.x, place.y, ahead_rad + angle_rad)
    }
}

fn ring(points: [[f64; 2]; 4], surface: Surface) -> Ring {
    Ring { points: points.map(Vec2::from).to_vec(), surfaces: vec![surface; 4] }
}

/// One pair of distances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// Number, from 1.
    pub tick: u64,
    /// Where.
    pub place: Place,
    /// d: the nearest surface in the cone, metres.
    pub truth_m: f64,
    /// r.
    pub reading: Reading,
}

/// What the pairs of a place come to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaceError {
    /// Where.
    pub place: Place,
    /// Mean square of d − r, m².
    pub mean_square: Estimate,
}

/// What all pairs come to.
#[derive(Clone, Debug, PartialEq)]
pub struct CalibrationReport {
    /// Place by place.
    pub places: Vec<PlaceError>,
    /// Mean square of d − r over all places, m².
    pub mean_square: Estimate,
    /// k of Eq. (2.8).
    pub factor: f64,
    /// ς, metres: the root of k times the mean square.
    pub deviation_m: Estimate,
}

/// The procedure as a state machine, one pair at a time.
#[derive(Debug)]
pub struct Calibration {
    scanner: Scanner,
    slots: usize,
    pairs_per_place: u64,
    factor: f64,
    rng: ChaCha8Rng,
    arenas: Vec<Arena>,
    near: Near,
    /// Squares of d − r, pair by pair, m².
    squares: Vec<f64>,
    tick: u64,
}

impl Calibration {
    /// A calibration of one of a robot's sonars, alone: at a noise level without its crosstalk, with so
    /// many pairs a place, at least 2, and a factor k.
    #[must_use]
    pub fn new(
        equipment: &Equipment,
        noise: NoiseLevel,
        pairs_per_place: u64,
        factor: f64,
        seed: u64,
    ) -> Self {
        let mut spec = equipment.scanner.clone();
        spec.orders.staggered = vec![0];
        let alone = [Mount { place: Vec2::zeros(), axis_rad: 0.0, axis_deg: 0.0 }];
        let noise = NoiseLevel { crosstalk: 0.0, ..noise };
        let rng = stream(seed, 0, Purpose::Echo);
        Self {
            scanner: Scanner::new(&spec, &alone, FiringOrder::Staggered, noise, rng),
            slots: spec.slots as usize,
            pairs_per_place: pairs_per_place.max(2),
            factor,
            rng: stream(seed, 0, Purpose::Start),
            arenas: Place::ALL.iter().map(|place| place.arena()).collect(),
            near: Near::default(),
            squares: Vec::new(),
            tick: 0,
        }
    }

    /// The next pair; none after the last.
    pub fn step(&mut self) -> Option<Pair> {
        let index = usize::try_from(self.tick / self.pairs_per_place).ok()?;
        let place = *Place::ALL.get(index)?;
        let distance_m = self.rng.random_range(DISTANCES_M[0]..DISTANCES_M[1]);
        let angle_rad = self.rng.random_range(-ANGLE_DEG..ANGLE_DEG).to_radians();
        let pose = place.pose(distance_m, angle_rad);
        let within_m = self.scanner.range_m() + 0.1;
        self.arenas[index].note_near(pose.position(), within_m, &mut self.near);
        let cycle_s = self.scanner.slot_s() * self.slots as f64;
        #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
        let time_s = self.tick as f64 * cycle_s;
        self.scanner.fire(0, time_s, &pose, &self.near, &[]);
        let truth_m = self.scanner.truth_m(0, &pose, &self.near, &[]);
        let reading = self.scanner.readings()[0];
        self.squares.push((truth_m - reading.range_m) * (truth_m - reading.range_m));
        self.tick += 1;
        Some(Pair { tick: self.tick, place, truth_m, reading })
    }

    /// Pairs of all places.
    #[must_use]
    pub fn pairs(&self) -> u64 {
        self.pairs_per_place * Place::ALL.len() as u64
    }

    /// What the pairs come to; none before the last.
    #[must_use]
    pub fn report(&self) -> Option<CalibrationReport> {
        if self.tick < self.pairs() {
            return None;
        }
        let of_each = self.squares.chunks(usize::try_from(self.pairs_per_place).ok()?);
        let places = Place::ALL.into_iter().zip(of_each);
        let places: Option<Vec<PlaceError>> = places
            .map(|(place, squares)| {
                Some(PlaceError { place, mean_square: Estimate::mean(squares)? })
            })
            .collect();
        let places = places?;
        let mean_square = over_all(&places);
        // Eq. (2.8): ς² = k/N ‖d − r‖²
        let root = |mean_square: f64| libm::sqrt(self.factor * mean_square.max(0.0));
        let deviation_m = Estimate {
            value: root(mean_square.value),
            low: root(mean_square.low),
            high: root(mean_square.high),
            n: mean_square.n,
        };
        Some(CalibrationReport { places, mean_square, factor: self.factor, deviation_m })
    }
}

/// The mean over places of as many pairs each. The places are chosen, not drawn, so that what they differ
/// by adds nothing to the interval.
#[expect(clippy::cast_precision_loss, reason = "a handful of places")]
fn over_all(places: &[PlaceError]) -> Estimate {
    let count = places.len() as f64;
    let value = places.iter().map(|place| place.mean_square.value).sum::<f64>() / count;
    let half = |of: &Estimate| of.high - of.value;
    let squares = places.iter().map(|place| half(&place.mean_square).powi(2)).sum::<f64>();
    let half = libm::sqrt(squares) / count;
    let n = places.iter().map(|place| place.mean_square.n).sum();
    Estimate { value, low: value - half, high: value + half, n }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::robot::examples::trc;

    fn run(noise: NoiseLevel, pairs: u64) -> (Vec<Pair>, CalibrationReport) {
        let trc = trc();
        let equipment = trc.equipment().expect("the TRC is equipped");
        let mut calibration = Calibration::new(equipment, noise, pairs, 1.5, 1);
        assert_eq!(calibration.report(), None);
        let pairs: Vec<Pair> = std::iter::from_fn(|| calibration.step()).collect();
        assert_eq!(pairs.len() as u64, calibration.pairs());
        (pairs, calibration.report().expect("done"))
    }

    #[test]
    fn the_variance_is_k_times_the_mean_square_of_all_pairs() {
        let (pairs, report) = run(NoiseLevel::times(1.0), 2000);
        let squares = pairs.iter().map(|pair| (pair.truth_m - pair.reading.range_m).powi(2));
        let mean_square = squares.sum::<f64>() / pairs.len() as f64;
        assert!((report.mean_square.value - mean_square).abs() < 1e-12);
        assert!((report.deviation_m.value.powi(2) - 1.5 * mean_square).abs() < 1e-12);
    }

    #[test]
    fn places_where_errors_have_a_closed_form() {
        let (_, report) = run(NoiseLevel::times(1.0), 40_000);
        // In the free way only spurious readings err, with probability 0.01: U(0.1524, 2) instead of 2.
        let expected = 0.01 * (2.0_f64 - 0.1524).powi(2) / 3.0;
        let free = report.places[4].mean_square;
        // 400 such readings, of a square with a deviation of 0.9 times its mean: four deviations.
        assert!(
            (free.value / expected - 1.0).abs() < 4.0 * 0.9 / 400_f64.sqrt() + 0.05,
            "{free:?}"
        );
        // An ideal sonar before a wall errs by what lies between two rays.
        let (_, ideal) = run(NoiseLevel::IDEAL, 2000);
        for place in &ideal.places {
            assert!(place.mean_square.value < 1e-3, "{place:?}");
        }
    }

    #[test]
    fn places_err_as_in_a_model_made_apart_from_this_one() {
        // Mean squares of 2000 pairs a place at the level 1, in m², by a prototype that shares no code.
        // NOTE: its corridor, 0.2109, and its door edge, 0.0660, are laid out in ways that it does not
        // state, and ours, 0.269 and 0.017, are not within its error.
        let prototype = [(Place::Wall, 0.0304), (Place::Corner, 0.0241), (Place::FreeWay, 0.0126)];
        let (ours, theirs) = (100_000_u32, 2000.0);
        let (_, report) = run(NoiseLevel::times(1.0), u64::from(ours));
        // Half an interval is 1.96 standard errors of our mean; the prototype's is greater by the root of
        // the ratio of the samples. Three standard errors of the difference.
        let grown = libm::sqrt(1.0 + f64::from(ours) / theirs);
        let allowed = |of: &Estimate| 3.0 / 1.96 * (of.high - of.value) * grown;
        for (place, expected) in prototype {
            let found = report.places.iter().find(|of| of.place == place).expect("visited");
            let found = found.mean_square;
            let off = (found.value - expected).abs();
            assert!(off < allowed(&found), "{place:?}: {found:?}, not {expected}");
        }
        let off = (report.mean_square.value - 0.0688).abs();
        assert!(off < allowed(&report.mean_square), "{:?}", report.mean_square);
    }

    #[test]
    fn the_interval_of_all_places_is_that_of_a_mean_of_means() {
        // Half widths 3 and 4 of two places: √(3² + 4²) / 2.
        let place = |value, half: f64| PlaceError {
            place: Place::Wall,
            mean_square: Estimate { value, low: value - half, high: value + half, n: 10 },
        };
        let all = over_all(&[place(10.0, 3.0), place(20.0, 4.0)]);
        assert_eq!(all, Estimate { value: 15.0, low: 12.5, high: 17.5, n: 20 });
    }
}
