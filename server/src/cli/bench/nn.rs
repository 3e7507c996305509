//! The nearest of many centres in 32 dimensions, queries a CPU second.

use rand::RngExt;
use sonarium_core::geometry::{Pose, Vec2, unit};
use sonarium_core::learner::{Birth, BirthCause, Input, Network, Neuron, NeuronId, Origin};
use sonarium_core::rng::{Purpose, stream};
use sonarium_core::world::WorldError;

use super::room::{RANGE_M, room, star};
use super::{Failure, Line, cpu};

const SIZES: [u32; 3] = [100, 1000, 10_000];
const QUERIES: u32 = 1000;

pub(super) fn run() -> Result<Vec<Line>, Failure> {
    let mut lines = Vec::new();
    for (kind, points) in [("uniform", uniform as Points), ("sonar", sonar)] {
        let queries = points(1, QUERIES)?;
        for size in SIZES {
            let centres = points(2 + u64::from(size), size)?;
            lines.push(line(kind, &centres, &queries)?);
        }
    }
    Ok(lines)
}

type Points = fn(u64, u32) -> Result<Vec<Input>, WorldError>;

fn line(kind: &str, centres: &[Input], queries: &[Input]) -> Result<Line, Failure> {
    let network = network(centres);
    let mut next = queries.iter().cycle();
    let batch = (2_000_000 / centres.len()).clamp(50, queries.len());
    let measured = cpu::per_second(|| {
        let found = next.by_ref().take(batch).filter_map(|query| network.winner(query));
        Ok(found.map(|(neuron, _)| u64::from(std::hint::black_box(neuron.id.0) < u32::MAX)).sum())
    })?;
    let note = "exact in f64, the oldest of equals; sifted by rough copies in 16-bit whole numbers; one \
                query at a time, one thread, CPU time; own points of the same distribution";
    let mut line = Line::new("5-nn", "winner", "queries/s", measured, note);
    line.task = format!("5-nn {kind} N={}", centres.len());
    Ok(line)
}

/// A network with these centres.
fn network(centres: &[Input]) -> Network {
    let birth = Birth {
        trial: 1,
        step: 1,
        tick: 1,
        cause: BirthCause::Empty,
        origin: Origin::Reflex,
        pose: Pose::default(),
    };
    let mut network = Network::default();
    for (id, centre) in (0..).zip(centres) {
        network.add(Neuron {
            id: NeuronId(id),
            centre: *centre,
            prototypical_rad: 0.0,
            mean_deg: 0.0,
            aim: None,
            utility: 0.0,
            pending: false,
            wins: 0,
            birth,
        });
    }
    network
}

/// Points anywhere in the unit cube.
fn uniform(seed: u64, count: u32) -> Result<Vec<Input>, WorldError> {
    let mut rng = stream(seed, 0, Purpose::Exploration);
    Ok((0..count).map(|_| std::array::from_fn(|_| rng.random())).collect())
}

/// Ranges along 32 rays from anywhere in the room, as shares of the greatest range.
fn sonar(seed: u64, count: u32) -> Result<Vec<Input>, WorldError> {
    let (world, mut ring) = (room()?, star(32, 1));
    let mut rng = stream(seed, 1, Purpose::Exploration);
    let mut point = || {
        let at = Vec2::new(rng.random_range(0.3..9.7), rng.random_range(0.3..7.7));
        let mut ranges_m = [0.0; 32];
        ring.scan(&world, at, unit(rng.random_range(0.0..std::f64::consts::TAU)), &mut ranges_m);
        ranges_m.map(|range_m| range_m / RANGE_M)
    };
    Ok((0..count).map(|_| point()).collect())
}
