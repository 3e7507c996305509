//! A trained network started from elsewhere: figure 5.8, below right.
//!
//! The network is used as it is, without exploring, growing or adapting. Inside the explored region a
//! neuron is active in every situation; outside, either the active one was learned for another place or
//! none is active (section 5.11, Results). NOTE: the thesis does not say what the robot does then, so both
//! answers are given: the nearest neuron acts all the same, or the reflex does.

use super::MinimumCostPath;
use crate::geometry::{Pose, Vec2};
use crate::learner::{Silence, reinforcement};
use crate::robot::{Contact, SimulatedRobot};

/// What a trained network does from another start.
#[derive(Clone, Debug, PartialEq)]
pub struct AlteredStart {
    /// The start.
    pub start: Pose,
    /// Distance to the nearest place where a neuron was born, metres; none without neurons.
    pub explored_m: Option<f64>,
    /// A neuron is active at the start itself.
    pub inside: bool,
    /// The network alone: where no neuron is active, the nearest acts.
    pub alone: Excursion,
    /// The network with the reflex where no neuron is active.
    pub guided: Excursion,
}

/// One way from an altered start.
#[derive(Clone, Debug, PartialEq)]
pub struct Excursion {
    /// It ended at the goal.
    pub reached_goal: bool,
    /// Steps taken.
    pub steps: u32,
    /// `R`, Eq. (5.27).
    pub total_reinforcement: f64,
    /// Real and virtual collisions.
    pub collisions: u32,
    /// Steps at which no neuron was active.
    pub silent_steps: u32,
    /// True positions, the start first.
    pub path: Vec<Vec2>,
}

impl MinimumCostPath {
    /// Starts the networks as they are now from elsewhere. Each start has a number, which chooses the
    /// noise of its sensors; nothing of the run itself changes.
    #[must_use]
    pub fn altered_start(&self, start: Pose, number: u32) -> AlteredStart {
        let births = self.neurons().map(|neuron| neuron.birth.pose.distance_to(start.position()));
        let mut robot = self.robot.clone();
        robot.begin_trial_at(self.trials_done() + number, start);
        let sensed = robot.sense();
        let first = self.observe_from(robot.pose(), &sensed, Contact::None);
        AlteredStart {
            start,
            explored_m: births.reduce(f64::min),
            inside: self.learner.recall(&first, Silence::Nearest).active,
            alone: self.excursion(start, number, Silence::Nearest),
            guided: self.excursion(start, number, Silence::Reflex),
        }
    }

    fn excursion(&self, start: Pose, number: u32, silence: Silence) -> Excursion {
        let mut robot = self.robot.clone();
        robot.begin_trial_at(self.trials_done() + number, start);
        let mut excursion = Excursion {
            reached_goal: robot.at_goal(),
            steps: 0,
            total_reinforcement: 0.0,
            collisions: 0,
            silent_steps: 0,
            path: vec![start.position()],
        };
        let mut contact = Contact::None;
        let mut sensed = robot.sense();
        while !self.is_over(excursion.reached_goal, contact, excursion.steps) {
            let observation = self.observe_from(robot.pose(), &sensed, contact);
            let recall = self.learner.recall(&observation, silence);
            contact = robot.act(recall.rotation_rad).contact;
            sensed = robot.sense();
            excursion.steps += 1;
            excursion.silent_steps += u32::from(!recall.active);
            excursion.collisions += u32::from(contact != Contact::None);
            excursion.total_reinforcement +=
                self.reinforcement_at(&robot, &sensed.sonar_m, contact);
            excursion.reached_goal = robot.at_goal();
            excursion.path.push(robot.true_pose().position());
        }
        excursion
    }

    fn reinforcement_at(&self, robot: &SimulatedRobot, sonar_m: &[f64], contact: Contact) -> f64 {
        let bearing_rad = robot.pose().bearing_to(self.world.goal().centre);
        reinforcement(&self.reward, sonar_m, contact, bearing_rad).total()
    }
}
