//! The learner's settings and the choices among readings.

use super::echoes::{Cone, Echoes, Hearing};
use super::{InputSettings, NoveltyMetric, Partition, RewardSettings};
use crate::experiment::Settings;
use crate::geometry::Pose;
use crate::robot::{Readings, Robot};

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
        Pursue = "pursue": "the next place of the record path, once a trial has succeeded; else the reflex",
        Reflex = "reflex": "always the reflex, as printed",
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
        Shortcut = "shortcut": "towards the later point of the record path that the critic values most (addition A1)",
        Gradient = "gradient": "by the TD error and the eligibility, Eq. (5.21)-(5.24)",
        Off = "off": "not at all: the mean stays 0",
    }
}

crate::choice! {
    /// What decides which later point a shortcut aims at.
    pub enum Judge {
        Critic = "critic": "predicted reinforcement of driving straight there, plus the utility there",
        Farthest = "farthest": "the farthest along the path that is in view: no critic",
    }
}

crate::choice! {
    /// What a new neuron on a shortcut does (addition A2).
    pub enum Carry {
        HandOver = "hand-over": "carries the shortcut on, and takes over from the neuron where it ends",
        Way = "way": "carries the shortcut on until it ends",
        Off = "off": "does what any other new neuron does",
    }
}

crate::choice! {
    /// Which of the shortcuts that a trial without a record followed are withdrawn (addition A8).
    pub enum Withdrawal {
        Losing = "losing": "those that cost no less than the record path did between the same two neurons",
        Followed = "followed": "all of them",
        Off = "off": "none",
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
    pub keep_to_record: bool,
    pub forget_unrecorded: bool,
    pub discount: f64,
    pub temporal_difference: bool,
    pub utility_rates: (f64, f64),
    pub mean_update: MeanUpdate,
    pub mean_rates: (f64, f64),
    pub centre_rates: (f64, f64),
    pub split_threshold: f64,
    pub backtrack: bool,
    pub replacement: Replacement,
    pub shortcut_judge: Judge,
    pub shortcut_clearance_m: f64,
    pub shortcut_push: bool,
    pub shortcut_sharp: bool,
    pub shortcut_carry: Carry,
    pub shortcut_bend: bool,
    pub shortcut_withdraw: Withdrawal,
    pub near_echo_m: f64,
    pub sidestep_m: f64,
    pub escape_after: u32,
    pub scout_from: u32,
    pub sonar_range_m: f64,
    pub sonar_cone_rad: f64,
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
            keep_to_record: settings.keep_to_record,
            forget_unrecorded: settings.forget_unrecorded,
            discount: settings.discount,
            temporal_difference: settings.temporal_difference,
            utility_rates: (settings.utility_reward_rate, settings.utility_penalty_rate),
            mean_update: settings.mean_update,
            mean_rates: (settings.mean_reward_rate, settings.mean_penalty_rate),
            centre_rates: (settings.centre_reward_rate, settings.centre_penalty_rate),
            split_threshold: settings.split_threshold,
            backtrack: settings.backtrack,
            replacement: settings.replacement,
            shortcut_judge: settings.shortcut_judge,
            shortcut_clearance_m: settings.shortcut_clearance_m,
            shortcut_push: settings.shortcut_push,
            shortcut_sharp: settings.shortcut_sharp,
            shortcut_carry: settings.shortcut_carry,
            shortcut_bend: settings.shortcut_bend,
            shortcut_withdraw: settings.shortcut_withdraw,
            near_echo_m: settings.near_echo_m,
            sidestep_m: settings.sidestep_m,
            escape_after: settings.escape_after,
            scout_from: settings.scout_from,
            sonar_range_m: settings.sonar_range_m,
            sonar_cone_rad: settings.sonar_cone_deg.to_radians(),
            advance_m: settings.advance_m,
        }
    }
}

impl LearnerSettings {
    /// What the sonars show at a pose up to a range in metres; farther echoes are left out.
    pub(super) fn echoes<'a>(
        &self,
        robot: &'a Robot,
        pose: Pose,
        sonar_m: &'a Readings,
        range_m: f64,
        cone: Cone,
    ) -> Echoes<'a> {
        let range_m = range_m.min(self.sonar_range_m);
        Echoes::new(robot, pose, sonar_m, Hearing { range_m, cone_rad: self.sonar_cone_rad, cone })
    }
}
