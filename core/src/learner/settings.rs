//! The learner's settings and the choices among readings.

use super::{InputSettings, NoveltyMetric, Partition, RewardSettings};
use crate::experiment::Settings;

crate::choice! {
    /// Frame in which prototypical actions are stored.
    pub enum ActionFrame {
        Heading = "heading": "direction of motion in the odometry frame (\"the robot's next direction of motion\")",
        Rotation = "rotation": "rotation relative to the heading, as printed",
        Goal = "goal": "direction of motion relative to the direction of the goal",
    }
}

crate::choice! {
    /// Where the first action of a new neuron comes from.
    pub enum FirstAction {
        Inherit = "inherit": "action and mean of the nearest neuron of the network, once a trial has succeeded; else the reflex",
        InheritAction = "inherit-action": "action of the nearest neuron, mean 0",
        Reflex = "reflex": "always the reflex, as printed",
    }
}

crate::choice! {
    /// Who chooses the step after a rescue.
    pub enum AfterRescue {
        Reflex = "reflex": "the reflex, for one step",
        NewNeuron = "new-neuron": "a neuron forced at the situation, which asks the reflex",
        Network = "network": "the winner as ever, as printed",
    }
}

crate::choice! {
    /// Standard deviation of the draw for a given σ.
    pub enum Deviation {
        Half = "half": "σ/√2: Eq. (5.12) as printed lacks the 2 of a normal density",
        Whole = "whole": "σ: Eq. (5.12) meant as a normal density",
    }
}

crate::choice! {
    /// How the mean of the exploration is set.
    pub enum MeanUpdate {
        Band = "band": "from the record trajectory, contracted and pushed off walls (addition A1)",
        Gradient = "gradient": "by the TD error and the eligibility, Eq. (5.21)-(5.24)",
        Both = "both": "both, the band last",
        Off = "off": "not at all: the mean stays 0",
    }
}

crate::choice! {
    /// How a record trial replaces prototypical actions, Eq. (5.28).
    pub enum Replacement {
        Forward = "forward": "in the order of time: the last visit to a neuron stays",
        Backward = "backward": "t = T, ..., 1 as printed: the first visit stays",
        Off = "off": "not at all",
    }
}

crate::choice! {
    /// How long a draw of the stochastic unit holds.
    pub enum Draw {
        Step = "step": "one step, Algorithm 9",
        Activation = "activation": "as long as the same neuron stays active",
    }
}

/// Settings of the learner, in the units it computes with.
#[derive(Clone, Debug, PartialEq)]
#[expect(missing_docs, reason = "each is documented once, in the experiment's settings")]
pub struct LearnerSettings {
    pub input: InputSettings,
    pub reward: RewardSettings,
    pub learning: bool,
    pub partition: Partition,
    pub novelty: f64,
    pub novelty_metric: NoveltyMetric,
    pub action_frame: ActionFrame,
    pub temperature_max_deg: f64,
    pub temperature_min_deg: f64,
    pub carried_temperature_deg: f64,
    pub cooling: f64,
    pub exploit_from: u32,
    pub sigma_scale: f64,
    pub deviation: Deviation,
    pub draw: Draw,
    pub first_action: FirstAction,
    pub inherit_radius: f64,
    pub forget_unrecorded: bool,
    pub after_rescue: AfterRescue,
    pub discount: f64,
    pub temporal_difference: bool,
    pub utility_rates: (f64, f64),
    pub mean_update: MeanUpdate,
    pub mean_rates: (f64, f64),
    pub centre_rates: (f64, f64),
    pub split_threshold: f64,
    pub backtrack: bool,
    pub replacement: Replacement,
    pub band_repulsion: f64,
    pub band_decay: f64,
    pub advance_m: f64,
}

impl From<&Settings> for LearnerSettings {
    fn from(settings: &Settings) -> Self {
        Self {
            input: InputSettings {
                sonar_span_m: settings.sonar_span_m,
                distance_span_m: settings.distance_span_m,
                sonar_frame: settings.sonar_frame,
            },
            reward: RewardSettings {
                collision: settings.collision_penalty,
                close_m: settings.close_m,
            },
            learning: settings.learning,
            partition: settings.partition,
            novelty: settings.novelty,
            novelty_metric: settings.novelty_metric,
            action_frame: settings.action_frame,
            temperature_max_deg: settings.temperature_max_deg,
            temperature_min_deg: settings.temperature_min_deg,
            carried_temperature_deg: settings.carried_temperature_deg,
            cooling: settings.cooling,
            exploit_from: settings.exploit_from,
            sigma_scale: settings.sigma_scale,
            deviation: settings.deviation,
            draw: settings.draw,
            first_action: settings.first_action,
            inherit_radius: settings.inherit_radius,
            forget_unrecorded: settings.forget_unrecorded,
            after_rescue: settings.after_rescue,
            discount: settings.discount,
            temporal_difference: settings.temporal_difference,
            utility_rates: (settings.utility_reward_rate, settings.utility_penalty_rate),
            mean_update: settings.mean_update,
            mean_rates: (settings.mean_reward_rate, settings.mean_penalty_rate),
            centre_rates: (settings.centre_reward_rate, settings.centre_penalty_rate),
            split_threshold: settings.split_threshold,
            backtrack: settings.backtrack,
            replacement: settings.replacement,
            band_repulsion: settings.band_repulsion,
            band_decay: settings.band_decay,
            advance_m: settings.advance_m,
        }
    }
}
