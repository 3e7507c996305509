//! What the learner keeps from trial to trial.

use serde::{Deserialize, Serialize};

use super::scout::Scouting;
use super::{Aim, Birth, Input, LearnerSettings, Network, Neuron, NeuronId, annealing};
use crate::geometry::Vec2;

/// All that outlives a trial: the networks and what steers them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Memory {
    /// One network a region, in the world's order.
    pub(super) networks: Vec<Network>,
    /// Number of the next neuron.
    pub(super) next_neuron: u32,
    /// `T(n)` of the present trial, degrees.
    pub(super) temperature_deg: f64,
    /// Best total reinforcement of a successful trial.
    pub(super) best: Option<f64>,
    /// The first trial that reached the goal, from 1.
    #[serde(default)]
    pub(super) first_success: Option<u32>,
    /// The steps of the record trial.
    #[serde(default)]
    pub(super) record: Vec<Waypoint>,
    /// What is laid aside while a scout looks for another way (addition A6).
    #[serde(default)]
    pub(super) scouting: Option<Scouting>,
    /// Trials done.
    pub(super) trials: u32,
    /// Ticks done.
    pub(super) ticks: u64,
}

impl Memory {
    /// The memory of a learner that has seen nothing, for a number of regions.
    pub(super) fn empty(settings: &LearnerSettings, regions: usize) -> Self {
        Self {
            networks: vec![Network::default(); regions],
            next_neuron: 0,
            temperature_deg: annealing::initial(settings),
            best: None,
            first_success: None,
            record: Vec::new(),
            scouting: None,
            trials: 0,
            ticks: 0,
        }
    }

    /// Adds a neuron with mean and utility; once a trial has succeeded the utility is only a guess
    /// until the trial ends (section 5.9, Exceptions).
    pub(super) fn add(
        &mut self,
        network: usize,
        centre: Input,
        start: Start,
        birth: Birth,
    ) -> NeuronId {
        let id = NeuronId(self.next_neuron);
        self.next_neuron += 1;
        self.networks[network].add(Neuron {
            id,
            centre,
            prototypical_rad: start.prototypical_rad,
            mean_deg: start.mean_deg,
            aim: start.aim,
            utility: start.utility,
            pending: self.best.is_some(),
            wins: 1,
            birth,
        });
        id
    }

    /// Whether a neuron was in charge of a step of the record trial.
    pub(super) fn is_on_record(&self, neuron: NeuronId) -> bool {
        self.record.iter().any(|step| step.neuron == neuron)
    }

    /// What the record trial got from the last step on of which a neuron was in charge.
    pub(super) fn to_go(&self, neuron: NeuronId) -> Option<f64> {
        self.record.iter().rev().find(|step| step.neuron == neuron).map(|step| step.to_go)
    }

    /// Trials done.
    #[must_use]
    pub fn trials(&self) -> u32 {
        self.trials
    }

    /// Ticks done.
    #[must_use]
    pub fn ticks(&self) -> u64 {
        self.ticks
    }

    /// The networks, in the order of the world's regions.
    #[must_use]
    pub fn networks(&self) -> &[Network] {
        &self.networks
    }

    /// Neurons in all networks.
    #[must_use]
    pub fn neurons(&self) -> usize {
        self.networks.iter().map(|network| network.neurons().len()).sum()
    }
}

/// Where a step of the record trial was decided, and by whom.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Waypoint {
    /// Metres.
    pub(super) x_m: f64,
    /// Metres.
    pub(super) y_m: f64,
    /// The neuron in charge.
    pub(super) neuron: NeuronId,
    /// Reinforcement that the trial got from there on.
    pub(super) to_go: f64,
}

impl Waypoint {
    /// The place.
    pub(super) fn point(&self) -> Vec2 {
        Vec2::new(self.x_m, self.y_m)
    }
}

/// The first values of a neuron's parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Start {
    /// `p`, radians, in the action frame.
    pub(super) prototypical_rad: f64,
    /// `μ`, degrees.
    pub(super) mean_deg: f64,
    /// Where the mean points, if a shortcut is taken over.
    pub(super) aim: Option<Aim>,
    /// `u`.
    pub(super) utility: f64,
}
