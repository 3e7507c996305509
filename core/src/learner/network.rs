//! The growing radial-basis network of section 5.7: one network a region.

use serde::{Deserialize, Serialize};

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

/// The network of one region: its neurons in the order of their birth.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Network {
    neurons: Vec<Neuron>,
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
        self.neurons.push(neuron);
    }

    /// The neuron with this number.
    #[must_use]
    pub fn get(&self, id: NeuronId) -> Option<&Neuron> {
        self.position(id).map(|position| &self.neurons[position])
    }

    /// The neuron with this number, to change.
    pub fn get_mut(&mut self, id: NeuronId) -> Option<&mut Neuron> {
        self.position(id).map(|position| &mut self.neurons[position])
    }

    /// Deletes a neuron; false when it is not here.
    pub fn forget(&mut self, id: NeuronId) -> bool {
        let found = self.position(id);
        if let Some(position) = found {
            self.neurons.remove(position);
        }
        found.is_some()
    }

    /// The nearest neuron and its squared distance; the oldest of equals.
    #[must_use]
    pub fn winner(&self, x: &Input) -> Option<(&Neuron, f64)> {
        let mut nearest = None;
        let mut least = f64::INFINITY;
        for neuron in &self.neurons {
            // Eq. (5.10): i = arg max_j φ_j(x) = arg min_j (x - c_j)ᵀ(x - c_j)
            // NOTE: all widths are equal, so the activation φ_j of Eq. (5.9) falls with the distance
            // and need not be computed.
            let squared = squared_distance(x, &neuron.centre, least);
            if squared < least {
                least = squared;
                nearest = Some(neuron);
            }
        }
        nearest.map(|neuron| (neuron, least))
    }

    fn position(&self, id: NeuronId) -> Option<usize> {
        self.neurons.binary_search_by_key(&id, |neuron| neuron.id).ok()
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

    proptest! {
        #[test]
        fn the_winner_is_the_nearest(x in input(), centres in proptest::collection::vec(input(), 1..20)) {
            let mut network = Network::default();
            for (id, centre) in centres.iter().enumerate() {
                network.add(Neuron::example(id as u32, *centre, 0.0));
            }
            let (winner, squared) = network.winner(&x).expect("a network with neurons");
            let plain = |c: &Input| x.iter().zip(c).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
            let least = centres.iter().map(plain).fold(f64::INFINITY, f64::min);
            prop_assert!((squared - least).abs() < 1e-12);
            prop_assert!((plain(&winner.centre) - least).abs() < 1e-12);
        }
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
