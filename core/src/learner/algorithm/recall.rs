//! The network as it is: what was learned, without exploring, growing or adapting.

use super::super::Observation;
use super::Learner;

/// Who acts where no neuron is active, that is, where the nearest is farther than ς.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Silence {
    /// The nearest neuron all the same.
    Nearest,
    /// The reflex.
    Reflex,
}

/// What a network does in a situation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recall {
    /// Rotation before the advance, radians.
    pub rotation_rad: f64,
    /// A neuron is active: the situation lies in its receptive field.
    pub active: bool,
}

impl Learner {
    /// What the network does in a situation.
    #[must_use]
    pub fn recall(&self, observation: &Observation, silence: Silence) -> Recall {
        let situation = self.situate(observation);
        let network = &self.memory.networks[situation.network];
        let Some((neuron, squared)) = network.winner(&situation.input) else {
            return Recall { rotation_rad: self.advise(&situation).rotation_rad, active: false };
        };
        // Section 5.7: a neuron answers for ‖x - c_i‖ ≤ ς
        let active = self.settings.novelty_metric.of(squared) <= self.settings.novelty;
        let rotation_rad = if active || silence == Silence::Nearest {
            situation.rotation(neuron.prototypical_rad)
        } else {
            self.advise(&situation).rotation_rad
        };
        Recall { rotation_rad, active }
    }
}
