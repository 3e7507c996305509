//! Every setting of the minimum-cost path, with its source.
//!
//! The defaults are the default preset: the learner that really learns. The literal thesis is the
//! preset `thesis`; each deviation and addition can be switched off alone.

use crate::control::ReflexSettings;
use crate::fuzzy::Inference;
use crate::learner::{
    ActionFrame, Carry, Deviation, Draw, FirstAction, Judge, MeanUpdate, NoveltyMetric, Partition,
    Replacement, SonarFrame, Withdrawal,
};
use crate::robot::SimulationSettings;

crate::choice! {
    /// What a collision, real or virtual, does to a trial.
    pub enum OnCollision {
        Rescue = "rescue": "the robot backs off and the trial goes on, as on the physical robot",
        End = "end": "the trial ends, failed, and the robot is put back home, as in the simulation of section 5.11",
    }
}

crate::settings! {
    /// Settings of the experiment `minimum-cost-path`.
    pub struct Settings {
        sonar_noise: f64 = 0.01, "sonar.noise" [0.0, 0.5] "", Simulation, "section 5.11, reading", "Standard deviation of a sonar reading as a share of it";
        sonar_cone_deg: f64 = 15.0, "sonar.cone" [1.0, 60.0] "deg", Simulation, "section 5.3, reading", "Full angle of a sonar cone";
        sonar_rays: u32 = 5, "sonar.rays" [1.0, 31.0] "", Simulation, "reading", "Rays per cone; the reading is the least of them";
        sonar_range_m: f64 = 8.0, "sonar.range" [0.5, 50.0] "m", Simulation, "reading", "Greatest sonar reading";
        sonar_least_m: f64 = 0.0, "sonar.least" [0.0, 1.0] "m", Simulation, "section 2.2, reading", "Least sonar reading";
        sonar_critical_deg: f64 = 90.0, "sonar.critical_angle" [10.0, 90.0] "deg", Simulation, "chapter 2, reading", "Incidence beyond which a ray returns no echo (specular loss); 90 loses none";
        sonar_dropout: f64 = 0.0, "sonar.dropout" [0.0, 1.0] "", Simulation, "chapter 2, reading", "Probability that a sonar misses its echo and reads its range";
        infrared_range_m: f64 = 0.5, "infrared.range" [0.1, 2.0] "m", Literal, "section 5.5, note", "Distance beyond which the infrared sensors see nothing";
        infrared_threshold_pct: f64 = 70.0, "infrared.threshold" [1.0, 99.0] "%", Literal, "section 5.5", "Reflectance above which a virtual collision is reported";
        infrared_reflectance: f64 = 0.875, "infrared.reflectance" [0.1, 1.0] "", Gap, "section 5.5, note", "Reflectance of the walls; 0.875 puts the virtual collision at 0.10 m, 1 at 0.15 m";
        odometry_drift: f64 = 0.0, "odometry.drift" [0.0, 0.2] "", Simulation, "section 5.5", "Odometry error as a share of each rotation and advance";
        advance_m: f64 = 0.2, "motion.advance" [0.05, 1.0] "m", Literal, "section 5.4", "Way advanced after each rotation";
        clear_to_m: f64 = 0.15, "motion.clear_to" [0.02, 0.5] "m", Gap, "section 5.5", "Clearance at which a rescue ends";
        back_min_m: f64 = 0.1, "motion.back_least" [0.0, 0.5] "m", Gap, "section 5.5", "Least way backed off in a rescue";
        step_cap: u32 = 200, "trial.step_cap" [1.0, 100_000.0] "", Simulation, "reading", "Steps after which a trial counts as failed";
        on_collision: OnCollision = OnCollision::Rescue, "trial.on_collision" "", Literal, "section 5.11, Simulation vs. Reality", "What a real or virtual collision does to the trial";
        collision_penalty: f64 = -3.0, "reward.collision" [-100.0, 0.0] "", Literal, "Eq. (5.6)", "Reinforcement of a collision";
        close_m: f64 = 0.2, "reward.close_distance" [0.01, 2.0] "m", Gap, "Eq. (5.6), d_c", "Sonar reading below which being close is penalised; tuned in the laboratory";
        avoid_desirability: f64 = 0.9, "reflex.avoid" [0.0, 1.0] "", Literal, "Eq. (5.8), d_a", "Desirability of obstacle avoidance";
        goal_desirability: f64 = 0.1, "reflex.goal" [0.0, 1.0] "", Literal, "Eq. (5.8), d_g", "Desirability of goal following";
        reflex_inference: Inference = Inference::ProductSum, "reflex.inference" "", Gap, "section 5.6", "How the fused activations become an area";
        reflex_idle_forward: bool = false, "reflex.idle_forward" "", Gap, "section 5.6", "Avoidance votes for forward when nothing is near; off: it is silent";
        front_near_m: f64 = 0.10, "reflex.front_near" [0.0, 2.0] "m", Gap, "section 5.6, tuned", "Reading ahead that is wholly near";
        front_free_m: f64 = 0.40, "reflex.front_free" [0.01, 4.0] "m", Gap, "section 5.6, tuned", "Reading ahead that is wholly free";
        side_near_m: f64 = 0.05, "reflex.side_near" [0.0, 2.0] "m", Gap, "section 5.6, tuned", "Reading to a side that is wholly near";
        side_free_m: f64 = 0.25, "reflex.side_free" [0.01, 4.0] "m", Gap, "section 5.6, tuned", "Reading to a side that is wholly free";
        goal_span_deg: f64 = 60.0, "reflex.goal_span" [1.0, 180.0] "deg", Gap, "section 5.6", "Bearing of the goal at which following it is all turning";
        sonar_span_m: f64 = 8.0, "input.sonar_span" [0.5, 50.0] "m", Gap, "Eq. (5.3)", "Reading that is normalised to 1";
        distance_span_m: f64 = 6.0, "input.distance_span" [0.5, 100.0] "m", Gap, "Eq. (5.4)", "Distance to the goal that is normalised to 1";
        sonar_frame: SonarFrame = SonarFrame::Robot, "input.sonar_frame" "", Literal, "section 5.6", "Frame in which the sonars enter the input";
        learning: bool = true, "learner.learning" "", Literal, "Algorithm 9", "Learn; off: the bare reflex drives";
        partition: Partition = Partition::World, "learner.regions" "", Literal, "Algorithm 8", "Which networks there are";
        novelty: f64 = 0.1, "learner.novelty" [0.001, 2.0] "", Literal, "Eq. (5.9), ς", "Width of a receptive field: a farther situation is new";
        novelty_metric: NoveltyMetric = NoveltyMetric::Distance, "learner.novelty_metric" "", Reading, "Eq. (5.10) against the text", "What is compared with the width";
        action_frame: ActionFrame = ActionFrame::Heading, "learner.action_frame" "", Reading, "R1; section 5.4", "Frame in which prototypical actions are stored";
        temperature_max_deg: f64 = 100.0, "learner.temperature_max" [0.0, 360.0] "deg", Literal, "Eq. (5.16), T_max", "Temperature of the first trial";
        temperature_min_deg: f64 = 10.0, "learner.temperature_min" [0.0, 360.0] "deg", Literal, "Eq. (5.17), T_min", "Temperature it cools to";
        carried_temperature_deg: f64 = 100.0, "learner.carried_temperature" [0.0, 360.0] "deg", Addition, "continual learning", "Temperature of the first trial of a run that begins with trained networks";
        cooling: f64 = 0.8, "learner.cooling" [0.0, 1.0] "", Literal, "Eq. (5.17), β", "Share of the temperature kept from trial to trial";
        exploit_from: u32 = 18, "learner.exploit_from" [0.0, 100_000.0] "trial", Deviation, "D4; Eq. (5.17)", "Trial from which the temperature is 0 and the best path is replayed; 0: never; tuned";
        sigma_scale: f64 = 0.05, "learner.sigma_scale" [0.0, 1.0] "", Deviation, "D1; Eq. (5.14)", "Share of σ that is used; 1 is literal";
        deviation: Deviation = Deviation::Half, "learner.sigma_reading" "", Reading, "Eq. (5.12)", "Standard deviation of the draw for a given σ";
        draw: Draw = Draw::Step, "learner.draw" "", Literal, "Algorithm 9", "How long a draw of the stochastic unit holds";
        first_action: FirstAction = FirstAction::Pursue, "learner.new_neuron" "", Deviation, "D2; section 5.7", "Where the first action of a new neuron comes from";
        forget_unrecorded: bool = true, "learner.forget_unrecorded" "", Deviation, "D3; section 5.9", "Delete the neurons born in a trial that set no record";
        discount: f64 = 0.7, "learner.discount" [0.0, 1.0] "", Literal, "Eq. (5.18), γ", "Discounting factor";
        temporal_difference: bool = true, "learner.temporal_difference" "", Literal, "Eq. (5.20), (5.25)", "Adapt utilities and centres by the TD error";
        utility_reward_rate: f64 = 0.5, "learner.utility_reward_rate" [0.0, 1.0] "", Literal, "Eq. (5.20), η_r", "Learning rate of a utility when δ > 0";
        utility_penalty_rate: f64 = 0.05, "learner.utility_penalty_rate" [0.0, 1.0] "", Literal, "Eq. (5.20), η_p", "Learning rate of a utility when δ < 0";
        mean_update: MeanUpdate = MeanUpdate::Shortcut, "learner.mean_update" "", Addition, "A1; Eq. (5.21)-(5.24)", "How the mean of the exploration is set";
        mean_reward_rate: f64 = 0.2, "learner.mean_reward_rate" [0.0, 10.0] "", Literal, "Eq. (5.24), β_r", "Learning rate of a mean when δ > 0";
        mean_penalty_rate: f64 = 0.02, "learner.mean_penalty_rate" [0.0, 10.0] "", Literal, "Eq. (5.24), β_p", "Learning rate of a mean when δ < 0";
        centre_reward_rate: f64 = 0.01, "learner.centre_reward_rate" [0.0, 1.0] "", Literal, "Eq. (5.25), ε_r", "Learning rate of a centre when δ > 0";
        centre_penalty_rate: f64 = 0.001, "learner.centre_penalty_rate" [0.0, 1.0] "", Literal, "Eq. (5.25), ε_p", "Learning rate of a centre when δ < 0";
        split_threshold: f64 = 50.0, "learner.split_threshold" [0.0, 1000.0] "", Literal, "section 5.9, Δ", "TD error above which the past situation gets its own neuron";
        backtrack: bool = true, "learner.backtrack" "", Literal, "Eq. (5.26)", "Set utilities from the reinforcements to the goal after a successful trial";
        replacement: Replacement = Replacement::Forward, "learner.replacement" "", Literal, "Eq. (5.28)", "How a record trial replaces prototypical actions";
        shortcut_judge: Judge = Judge::Critic, "shortcut.judge" "", Addition, "A1", "What decides which later point of the record path a neuron aims at";
        shortcut_push: bool = true, "shortcut.push" "", Addition, "A1", "Move the points aimed at off the obstacle by the clearance that cost the step that led there";
        shortcut_clearance_m: f64 = 0.1, "shortcut.clearance" [0.0, 1.0] "m", Addition, "A1, A2; the distance of a virtual collision", "Least clearance that the echoes must show along a shortcut";
        shortcut_carry: Carry = Carry::HandOver, "shortcut.carry" "", Addition, "A2", "What a new neuron on a shortcut does";
        shortcut_bend: bool = true, "shortcut.bend" "", Addition, "A3", "A shortcut from home may bend once, at a place in view from both its ends";
        sidestep_m: f64 = 0.15, "learner.sidestep" [0.0, 1.0] "m", Addition, "A4; the clearance at which a rescue ends", "Clearance of the next step below which it is turned aside, once a trial has succeeded; 0: never";
        escape_after: u32 = 25, "learner.escape_after" [0.0, 100_000.0] "", Addition, "A5, tuned", "Steps without coming nearer to the goal after which the robot follows the obstacle; 0: never";
        scout_from: u32 = 3, "learner.scout_from" [0.0, 100_000.0] "trial", Addition, "A6, tuned", "Trial in which the first of two scouts looks for another way, the second two trials later, once a trial has succeeded; 0: none";
        near_echo_m: f64 = 0.3, "shortcut.near_echoes" [0.0, 10.0] "m", Addition, "A7, tuned", "Echoes heard from nearer than this anywhere on the record path count for every shortcut; 0: none do";
        shortcut_withdraw: Withdrawal = Withdrawal::Losing, "shortcut.withdraw" "", Addition, "A8; Eq. (5.19) over several steps", "Which of the shortcuts that a trial without a record followed are withdrawn";
        keep_to_record: bool = true, "learner.keep_to_record" "", Addition, "A9", "At temperature 0 a neuron that is not of the record path goes back to it, as a new one does";
        odometry_correction: bool = true, "odometry.correction" "", Addition, "A10", "Correct an odometry that errs by what the sonars heard in the same places before; needs an even ring of sonars";
        shortcut_sharp: bool = true, "shortcut.sharp" "", Addition, "A11; Eq. (5.15)", "A shortcut may turn by more than the temperature";
    }
}

impl Settings {
    /// The simulation's share of the settings.
    #[must_use]
    pub fn simulation(&self) -> SimulationSettings {
        SimulationSettings {
            sonar_noise: self.sonar_noise,
            sonar_cone_rad: self.sonar_cone_deg.to_radians(),
            sonar_rays: self.sonar_rays as usize,
            sonar_range_m: self.sonar_range_m,
            sonar_least_m: self.sonar_least_m,
            sonar_critical_rad: self.sonar_critical_deg.to_radians(),
            sonar_dropout: self.sonar_dropout,
            infrared_range_m: self.infrared_range_m,
            infrared_threshold_pct: self.infrared_threshold_pct,
            infrared_reflectance: self.infrared_reflectance,
            odometry_drift: self.odometry_drift,
            advance_m: self.advance_m,
            clear_to_m: self.clear_to_m,
            back_min_m: self.back_min_m,
            rescue: self.on_collision == OnCollision::Rescue,
            ..SimulationSettings::default()
        }
    }

    /// The reflex's share of the settings.
    #[must_use]
    pub fn reflex(&self) -> ReflexSettings {
        ReflexSettings {
            avoid: self.avoid_desirability,
            goal: self.goal_desirability,
            inference: self.reflex_inference,
            idle_forward: self.reflex_idle_forward,
            front_m: (self.front_near_m, self.front_free_m),
            side_m: (self.side_near_m, self.side_free_m),
            goal_span_rad: self.goal_span_deg.to_radians(),
        }
    }
}
