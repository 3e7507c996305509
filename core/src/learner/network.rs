//! The growing radial-basis network of section 5.7: one network a region.

use serde::{Deserialize, Serialize};

use super::sketch::{self, Sketch};
use super::{Aim, Birth, Input, NeuronId};

crate::choice! {
    /// Which networks there are.
    pub enum Partition {
        World = "world": "one network for each region of the world, Algorithm 8",
        One = "one": "one network for the whole world",
    }
}

crate::choice! {
    /// What is compared with the width of a receptive field.
    pub enum NoveltyMetric {
        Distance = "distance": "‖x − c‖, as the text and Algorithm 9 say",
        Squared = "squared": "(x − c)ᵀ(x − c), as Eq. (5.10) is written",
    }
}

impl NoveltyMetric {
    /// The measure for a squared Euclidean distance.
    #[must_use]
    pub fn of(self, distance_squared: f64) -> f64 {
        match self {
            Self::Distance => distance_squared.sqrt(),
            Self::Squared => distance_squared,
        }
    }
}

/// A neuron: a receptive field with the four learning parameters of figure 5.7.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Neuron {
    /// Its number in the session.
    pub id: NeuronId,
    /// Centre `c`, the excitatory connections.
    pub centre: Input,
    /// Prototypical action `p`, radians, in the frame of the setting `learner.action_frame`.
    pub prototypical_rad: f64,
    /// Mean `μ` of the exploration, degrees.
    pub mean_deg: f64,
    /// Where the mean points, once a shortcut is proposed (addition A1).
    #[serde(default)]
    pub aim: Option<Aim>,
    /// Utility `u`.
    pub utility: f64,
    /// The utility is only a first guess until the trial ends (section 5.9, Exceptions).
    pub pending: bool,
    /// Times it won.
    pub wins: u32,
    /// When and why it was added.
    pub birth: Birth,
}

impl Neuron {
    /// The utility, unless it is pending.
    #[must_use]
    pub fn known_utility(&self) -> Option<f64> {
        (!self.pending).then_some(self.utility)
    }
}

/// Sketches compared at once.
const LANES: usize = 8;

/// The network of one region: its neurons in the order of their birth.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(from = "Stored")]
pub struct Network {
    neurons: Vec<Neuron>,
    /// Rough copies of the centres, neuron by neuron.
    #[serde(skip)]
    sketches: Vec<Sketch>,
    /// Position of a neuron that was handed out to change since its sketch was drawn.
    #[serde(skip)]
    changing: Option<usize>,
}

/// A network as it is stored.
#[derive(Deserialize)]
struct Stored {
    neurons: Vec<Neuron>,
}

/// The nearest neuron so far: its position and squared distance.
#[derive(Clone, Copy)]
struct Nearest {
    position: usize,
    squared: f64,
}

impl Network {
    /// All neurons, oldest first.
    #[must_use]
    pub fn neurons(&self) -> &[Neuron] {
        &self.neurons
    }

    /// Adds a neuron; its number is greater than all before.
    pub fn add(&mut self, neuron: Neuron) {
        debug_assert!(self.neurons.last().is_none_or(|last| last.id < neuron.id));
        self.sketches.push(Sketch::new(&neuron.centre));
        self.neurons.push(neuron);
    }

    /// The neuron with this number.
    #[must_use]
    pub fn get(&self, id: NeuronId) -> Option<&Neuron> {
        self.position(id).map(|position| &self.neurons[position])
    }

    /// The neuron with this number, to change.
    pub fn get_mut(&mut self, id: NeuronId) -> Option<&mut Neuron> {
        self.draw_changed();
        self.changing = self.position(id);
        self.changing.map(|position| &mut self.neurons[position])
    }

    /// Deletes a neuron; false when it is not here.
    pub fn forget(&mut self, id: NeuronId) -> bool {
        self.draw_changed();
        let found = self.position(id);
        if let Some(position) = found {
            self.neurons.remove(position);
            self.sketches.remove(position);
        }
        found.is_some()
    }

    /// The nearest neuron and its squared distance; the oldest of equals.
    #[must_use]
    pub fn winner(&self, x: &Input) -> Option<(&Neuron, f64)> {
        // What may have moved is looked at first, since its sketch says nothing.
        let moved = self.changing.and_then(|position| self.nearer(x, position, None));
        let nearest = self.search(x, &Sketch::new(x), moved)?;
        Some((&self.neurons[nearest.position], nearest.squared))
    }

    /// Looks at the neurons whose sketches are near enough, block by block. What is left out cannot
    /// be the winner, and distances are those of the centres themselves: sketches never show.
    fn search(&self, x: &Input, sketch: &Sketch, moved: Option<Nearest>) -> Option<Nearest> {
        let mut nearest = moved;
        let mut limit = nearest.map_or(i32::MAX, |nearest| sketch::greatest(nearest.squared));
        for (block, sketches) in self.sketches.chunks(LANES).enumerate() {
            let mut rough = [i32::MAX; LANES];
            for (rough, other) in rough.iter_mut().zip(sketches) {
                *rough = sketch.squared_distance(other);
            }
            if rough.iter().all(|rough| *rough > limit) {
                continue;
            }
            for (k, rough) in rough.iter().enumerate().take(sketches.len()) {
                if *rough > limit {
                    continue;
                }
                if let Some(found) = self.nearer(x, block * LANES + k, nearest) {
                    nearest = Some(found);
                    limit = sketch::greatest(found.squared);
                }
            }
        }
        nearest
    }

    /// A neuron, if it is nearer than the nearest so far, or as near and older.
    fn nearer(&self, x: &Input, position: usize, than: Option<Nearest>) -> Option<Nearest> {
        let least = than.map_or(f64::INFINITY, |nearest| nearest.squared);
        // Eq. (5.10): i = arg max_j φ_j(x) = arg min_j (x - c_j)ᵀ(x - c_j)
        // NOTE: all widths are equal, so the activation φ_j of Eq. (5.9) falls with the distance
        // and need not be computed.
        let squared = squared_distance(x, &self.neurons[position].centre, least);
        let older = than.is_some_and(|nearest| position < nearest.position);
        let nearer = squared < least || (older && squared == least);
        nearer.then_some(Nearest { position, squared })
    }

    /// Draws the sketch of the neuron that was handed out last.
    fn draw_changed(&mut self) {
        if let Some(position) = self.changing.take() {
            self.sketches[position] = Sketch::new(&self.neurons[position].centre);
        }
    }

    fn position(&self, id: NeuronId) -> Option<usize> {
        self.neurons.binary_search_by_key(&id, |neuron| neuron.id).ok()
    }
}

impl From<Stored> for Network {
    fn from(stored: Stored) -> Self {
        let sketches = stored.neurons.iter().map(|neuron| Sketch::new(&neuron.centre)).collect();
        Self { neurons: stored.neurons, sketches, changing: None }
    }
}

/// The sketches follow from the neurons.
impl PartialEq for Network {
    fn eq(&self, other: &Self) -> bool {
        self.neurons == other.neurons
    }
}

/// Squared distance, or any greater number once it is known to exceed `enough`.
///
/// Four running sums over blocks of eight: the order is fixed, so vector instructions change nothing.
fn squared_distance(x: &Input, centre: &Input, enough: f64) -> f64 {
    let mut sums = [0.0; 4];
    let mut total = 0.0;
    for (xs, cs) in x.chunks_exact(8).zip(centre.chunks_exact(8)) {
        for lane in 0..4 {
            let first = xs[lane] - cs[lane];
            let second = xs[lane + 4] - cs[lane + 4];
            sums[lane] += first * first + second * second;
        }
        total = (sums[0] + sums[1]) + (sums[2] + sums[3]);
        if total > enough {
            break;
        }
    }
    total
}

#[cfg(test)]
impl Neuron {
    /// A neuron for tests: it does nothing in particular.
    pub(super) fn example(id: u32, centre: Input, utility: f64) -> Self {
        let birth = Birth {
            trial: 1,
            step: 1,
            tick: 1,
            cause: super::BirthCause::Empty,
            origin: super::Origin::Reflex,
            pose: crate::geometry::Pose::default(),
        };
        Self {
            id: NeuronId(id),
            centre,
            prototypical_rad: 0.0,
            mean_deg: 0.0,
            aim: None,
            utility,
            pending: false,
            wins: 0,
            birth,
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn input() -> impl Strategy<Value = Input> {
        proptest::array::uniform32(0.0..1.0f64)
    }

    /// Inputs near each other, far apart, beyond the unit and often equal.
    fn inputs() -> impl Strategy<Value = Vec<Input>> {
        let near = (input(), input(), 0.0..0.01f64).prop_map(|(a, b, share)| {
            std::array::from_fn(|k| 0.5 + share * a[k] + share * (b[k] - 0.5))
        });
        let beyond = input().prop_map(|x| x.map(|x| 3.0 * x - 1.0));
        let equal = (0..4u8).prop_map(|x| [f64::from(x) * 0.25; 32]);
        proptest::collection::vec(prop_oneof![input(), near, beyond, equal], 1..60)
    }

    /// A network of neurons with these centres.
    fn network(centres: &[Input]) -> Network {
        let mut network = Network::default();
        for (id, centre) in (0..).zip(centres) {
            network.add(Neuron::example(id, *centre, 0.0));
        }
        network
    }

    /// The nearest of all centres one by one, the oldest of equals: position and squared distance.
    fn looked_at_all(centres: &[Input], x: &Input) -> (usize, f64) {
        let squared = centres.iter().map(|centre| squared_distance(x, centre, f64::INFINITY));
        let nearest = squared.enumerate().min_by(|(_, a), (_, b)| a.total_cmp(b));
        nearest.expect("there are centres")
    }

    proptest! {
        #[test]
        fn the_winner_is_the_nearest(x in input(), centres in proptest::collection::vec(input(), 1..20)) {
            let network = network(&centres);
            let (winner, squared) = network.winner(&x).expect("a network with neurons");
            let plain = |c: &Input| x.iter().zip(c).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
            let least = centres.iter().map(plain).fold(f64::INFINITY, f64::min);
            prop_assert!((squared - least).abs() < 1e-12);
            prop_assert!((plain(&winner.centre) - least).abs() < 1e-12);
        }

        #[test]
        fn sketches_change_no_bit(
            mut centres in inputs(), queries in inputs(), moved in inputs(), at in any::<prop::sample::Index>(),
        ) {
            let mut network = network(&centres);
            for (query, moved) in queries.iter().zip(moved.iter().cycle()) {
                let at = at.index(centres.len());
                let neuron = network.get_mut(NeuronId(at as u32)).expect("it is there");
                neuron.centre = *moved;
                centres[at] = *moved;
                let expected = looked_at_all(&centres, query);
                let (winner, squared) = network.winner(query).expect("there are neurons");
                prop_assert_eq!((winner.id.0 as usize, squared), expected);
            }
        }
    }

    #[test]
    fn a_stored_network_finds_the_same_winner() {
        let centres = [[0.25; 32], [0.75; 32]];
        let mut network = network(&centres);
        network.get_mut(NeuronId(0)).expect("the first").centre = [0.5; 32];
        let text = serde_json::to_string(&network).expect("a network can be stored");
        let again: Network = serde_json::from_str(&text).expect("and read again");
        assert_eq!(again, network);
        let winner = again.winner(&[0.6; 32]).map(|(neuron, _)| neuron.id);
        assert_eq!(winner, Some(NeuronId(0)));
    }

    #[test]
    fn neurons_are_found_and_forgotten_by_number() {
        let mut network = Network::default();
        assert!(network.winner(&[0.0; 32]).is_none());
        for id in [2, 5, 9] {
            network.add(Neuron::example(id, [f64::from(id); 32], 0.0));
        }
        assert!(network.forget(NeuronId(5)) && !network.forget(NeuronId(5)));
        assert_eq!(network.get(NeuronId(9)).map(|neuron| neuron.id), Some(NeuronId(9)));
        assert_eq!(network.winner(&[5.0; 32]).map(|(neuron, _)| neuron.id), Some(NeuronId(2)));
    }
}
