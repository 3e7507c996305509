//! A run: the experiment's machine and the names its numbers stand for.

use sonarium_core::experiment::{Checkpoint, MinimumCostPath, SetupError};
use sonarium_core::learner::{Tick, TrialEnd};

use super::view::Names;
use crate::catalog::{FieldError, Plan, Trained};
use crate::store::{LogRecord, StoredCheckpoint};
use crate::wire::{NeuronView, TickView, Trial, TrialEndView};

/// An experiment under way.
pub struct Run {
    machine: MinimumCostPath,
    names: Names,
}

/// What one control step gave.
pub struct Stepped {
    /// The step.
    pub tick: TickView,
    /// What the learner did, when the trial ended with this step.
    pub end: Option<TrialEndView>,
}

impl Run {
    /// A new run, with empty networks or with those of the plan.
    ///
    /// # Errors
    /// When the settings do not fit the world.
    pub fn new(plan: &Plan) -> Result<Self, FieldError> {
        let (world, robot) = (plan.world.world.clone(), plan.robot.clone());
        let (settings, seed) = (&plan.settings, plan.seed);
        let machine = match &plan.network {
            None => MinimumCostPath::new(world, robot, settings, seed),
            Some(network) => {
                MinimumCostPath::carry_on(world, robot, settings, seed, &network.file.networks)
            }
        };
        let machine = machine.map_err(|error| match &error {
            SetupError::Networks(damage) => {
                FieldError::new(format!("network.{}", damage.place), damage.problem.clone())
            }
            _ => FieldError::new("settings", error.to_string()),
        })?;
        Ok(Self { machine, names: plan.names() })
    }

    /// Goes on from a checkpoint, to the same bits as if it had never stopped.
    ///
    /// # Errors
    /// When the checkpoint is damaged or belongs to another program, world or setting.
    pub fn resume(plan: &Plan, stored: &StoredCheckpoint) -> Result<Self, FieldError> {
        let refuse =
            |why: String| FieldError::new("checkpoint", format!("{why}; reset the session"));
        let checkpoint: Checkpoint =
            postcard::from_bytes(&stored.bytes).map_err(|error| refuse(error.to_string()))?;
        let (world, robot) = (plan.world.world.clone(), plan.robot.clone());
        let machine = MinimumCostPath::resume(world, robot, &plan.settings, plan.seed, &checkpoint)
            .map_err(|error| refuse(error.to_string()))?;
        Ok(Self { machine, names: plan.names() })
    }

    /// One control step with everything there is to say about it.
    pub fn step(&mut self) -> Stepped {
        let Self { machine, names } = self;
        let (tick, end) = machine.step();
        let (tick, end) = (names.tick(tick), end.cloned());
        let end = end.map(|end| names.trial_end(&end, machine.neurons()));
        Stepped { tick, end }
    }

    /// One control step, when nobody wants to know more than how trials end.
    pub fn step_silently(&mut self) -> Option<Trial> {
        let (_, end): (&Tick, Option<&TrialEnd>) = self.machine.step();
        end.map(|end| self.names.trial(&end.record))
    }

    /// The networks as they are, to be used elsewhere.
    #[must_use]
    pub fn trained(&self, plan: &Plan) -> Trained {
        Trained::new(plan, self.machine.trials_done(), self.machine.networks())
    }

    pub(super) fn machine(&self) -> &MinimumCostPath {
        &self.machine
    }

    /// One control step, of which nothing but the true way is kept: where the robot was, unless the
    /// path has begun, and where it went.
    pub fn step_along(&mut self, path_m: &mut Vec<[f64; 2]>) -> Option<Trial> {
        let (tick, end) = self.machine.step();
        if path_m.is_empty() {
            path_m.push([tick.true_pose.x_m, tick.true_pose.y_m]);
        }
        path_m.push([tick.outcome.true_pose.x_m, tick.outcome.true_pose.y_m]);
        end.map(|end| self.names.trial(&end.record))
    }

    /// All neurons, without their centres.
    #[must_use]
    pub fn neurons(&self) -> Vec<NeuronView> {
        self.machine.neurons().map(|neuron| self.names.neuron(&neuron)).collect()
    }

    /// One neuron with its centre.
    #[must_use]
    pub fn neuron(&self, number: u32) -> Option<NeuronView> {
        let found = self.machine.neurons().find(|neuron| neuron.id.0 == number);
        found.map(|neuron| self.names.whole_neuron(&neuron))
    }

    /// What to resume from, between two trials.
    #[must_use]
    pub fn checkpoint(&self) -> Option<LogRecord> {
        let checkpoint = self.machine.checkpoint()?;
        let bytes = postcard::to_stdvec(&checkpoint)
            .expect("a checkpoint is plain data, which postcard always takes");
        Some(LogRecord::Checkpoint {
            trials_done: checkpoint.trials_done(),
            tick: checkpoint.tick(),
            bytes,
        })
    }
}
