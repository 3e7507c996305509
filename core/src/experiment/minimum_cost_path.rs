//! stub: signatures the rest of the house can rely on
use crate::geometry::Pose;
use crate::learner::{Birth, NeuronId, Tick, TrialEnd};
use crate::settings::{SettingError, Spec, Value};
use crate::world::World;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// All settings of the experiment; `Settings::default()` is the default preset.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Settings {}
impl Settings {
    /// Table of all settings.
    pub fn specs() -> &'static [Spec] {
        todo!()
    }
    /// Value by key.
    pub fn get(&self, _key: &str) -> Option<Value> {
        todo!()
    }
    /// Sets one; checks type and range.
    pub fn set(&mut self, _key: &str, _value: &Value) -> Result<(), SettingError> {
        todo!()
    }
}

/// A neuron as others may look at it.
#[derive(Clone, Copy, Debug)]
pub struct NeuronRef<'a> {
    /// Its number.
    pub id: NeuronId,
    /// Index of its region.
    pub region: usize,
    /// Centre c.
    pub centre: &'a [f64; 32],
    /// Prototypical action p, radians.
    pub prototypical_rad: f64,
    /// Heading that p meant at its birth pose.
    pub heading_rad: f64,
    /// Mean, degrees.
    pub mean_deg: f64,
    /// Utility; none while pending.
    pub utility: Option<f64>,
    /// Times it won.
    pub wins: u32,
    /// Birth certificate.
    pub birth: &'a Birth,
}

/// Everything needed to go on after a finished trial; serde-serialisable (postcard, JSON).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Checkpoint {}
impl Checkpoint {
    /// Trials done.
    pub fn trials_done(&self) -> u32 {
        todo!()
    }
    /// Last tick.
    pub fn tick(&self) -> u64 {
        todo!()
    }
}

/// The settings do not fit the world, or a checkpoint does not fit.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SetupError {
    /// e.g. a checkpoint of another world
    #[error("x")]
    X,
}

/// The experiment as a state machine, one control step at a time.
pub struct MinimumCostPath {}
impl MinimumCostPath {
    /// A new run, empty network.
    pub fn new(_world: Arc<World>, _settings: &Settings, _seed: u64) -> Result<Self, SetupError> {
        todo!()
    }
    /// Goes on after a checkpoint, to the same bits a run that was never stopped gives.
    pub fn resume(
        _world: Arc<World>,
        _settings: &Settings,
        _seed: u64,
        _checkpoint: &Checkpoint,
    ) -> Result<Self, SetupError> {
        todo!()
    }
    /// One control step. `Some(end)` when the trial ended with it; the next step begins the next trial.
    pub fn step(&mut self) -> (&Tick, Option<&TrialEnd>) {
        todo!()
    }
    /// State after the last finished trial; `None` while a trial is under way.
    pub fn checkpoint(&self) -> Option<Checkpoint> {
        todo!()
    }
    /// Trials done.
    pub fn trials_done(&self) -> u32 {
        todo!()
    }
    /// Last tick done.
    pub fn tick(&self) -> u64 {
        todo!()
    }
    /// All neurons, by region and then by age.
    pub fn neurons(&self) -> impl Iterator<Item = NeuronRef<'_>> {
        std::iter::empty()
    }
    /// Home pose etc. of the robot before the first step.
    pub fn pose(&self) -> Pose {
        todo!()
    }
}
