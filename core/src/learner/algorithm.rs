//! Algorithm 9 as a state machine.

mod escape;
mod heritage;
mod recall;
mod room;

pub use recall::{Recall, Silence};

use std::sync::Arc;

use rand_chacha::ChaCha8Rng;

use escape::Escape;
use heritage::{Heritage, REACHED};

use super::critic::{PastSituation, adapt, td_error};
use super::memory::{Memory, Start};
use super::stochastic::{eligibility, explore};
use super::trial_end::{Changes, PathStep, close};
use super::{
    ActionFrame, ActionSource, Adaptation, Aim, Birth, BirthCause, Consequence, Decision, Draw,
    Exploration, Guide, Input, LearnerSettings, MeanUpdate, Neuron, NeuronId, Observation, Origin,
    Partition, Winner, annealing, reinforcement,
};
use crate::control::{Reflex, ReflexTrace};
use crate::geometry::{Pose, Vec2, angle, unit, wrap_angle};
use crate::robot::{Contact, Mount, Readings, Robot};

/// The past situation, waiting for its consequence to be judged.
#[derive(Clone, Debug)]
struct Past {
    network: usize,
    neuron: NeuronId,
    pose: Pose,
    situation: PastSituation,
}

/// A neuron about to act, copied out of its network.
#[derive(Clone, Copy, Debug)]
struct Acting {
    network: usize,
    neuron: NeuronId,
    prototypical_rad: f64,
    mean_deg: f64,
    aim: Option<Aim>,
    utility: f64,
    pending: bool,
}

impl Acting {
    fn from(network: usize, neuron: &Neuron) -> Self {
        Self {
            network,
            neuron: neuron.id,
            prototypical_rad: neuron.prototypical_rad,
            mean_deg: neuron.mean_deg,
            aim: neuron.aim,
            utility: neuron.utility,
            pending: neuron.pending,
        }
    }
}

/// A situation as the learner sees it.
struct Situation<'a> {
    observation: &'a Observation,
    input: Input,
    bearing_rad: f64,
    network: usize,
    /// Direction of the action frame's zero, radians in the odometry frame.
    frame_rad: f64,
}

impl Situation<'_> {
    fn collided(&self) -> bool {
        self.observation.contact != Contact::None
    }

    /// A rotation as an action in the action frame.
    fn action(&self, rotation_rad: f64) -> f64 {
        wrap_angle(rotation_rad + self.observation.pose.heading_rad - self.frame_rad)
    }

    /// An action in the action frame as a rotation.
    fn rotation(&self, action_rad: f64) -> f64 {
        wrap_angle(action_rad + self.frame_rad - self.observation.pose.heading_rad)
    }
}

/// The learner of chapter 5.
#[derive(Clone, Debug)]
pub struct Learner {
    settings: LearnerSettings,
    robot: Arc<Robot>,
    reflex: Reflex,
    goal: Vec2,
    memory: Memory,
    rng: ChaCha8Rng,
    past: Option<Past>,
    path: Vec<PathStep>,
    born: Vec<(usize, NeuronId)>,
    recentred: Vec<NeuronId>,
    waiting: Option<(Past, PathStep)>,
    /// The last draw in this trial, and the neuron it was drawn for.
    drawn: Option<(NeuronId, f64)>,
    escape: Escape,
    /// The leg under way of a way that bends (A3).
    bend: Option<Aim>,
    /// A scout set out in this trial.
    scout: bool,
    step: u32,
}

impl Learner {
    /// A learner with empty networks for a world of `regions` regions and a goal.
    ///
    /// `rng` is the exploration stream of the first trial.
    #[must_use]
    pub fn new(
        settings: LearnerSettings,
        robot: Arc<Robot>,
        reflex: Reflex,
        regions: usize,
        goal: Vec2,
        rng: ChaCha8Rng,
    ) -> Self {
        let memory = Memory::empty(&settings, regions);
        Self::remember(settings, robot, reflex, goal, memory, rng)
    }

    /// A learner that goes on from a memory, at the start of a trial.
    #[must_use]
    pub fn remember(
        settings: LearnerSettings,
        robot: Arc<Robot>,
        reflex: Reflex,
        goal: Vec2,
        memory: Memory,
        rng: ChaCha8Rng,
    ) -> Self {
        Self {
            settings,
            robot,
            reflex,
            goal,
            memory,
            rng,
            past: None,
            path: Vec::new(),
            born: Vec::new(),
            recentred: Vec::new(),
            waiting: None,
            drawn: None,
            escape: Escape::default(),
            bend: None,
            scout: false,
            step: 0,
        }
    }

    /// All that outlives a trial.
    #[must_use]
    pub fn memory(&self) -> &Memory {
        &self.memory
    }

    /// Steps decided in this trial.
    #[must_use]
    pub fn step(&self) -> u32 {
        self.step
    }

    /// `T(n)` as this trial uses it, degrees.
    #[must_use]
    pub fn temperature_deg(&self) -> f64 {
        annealing::effective(&self.settings, self.memory.temperature_deg, self.memory.trials + 1)
    }

    /// Neurons added in this trial.
    #[must_use]
    pub fn born(&self) -> usize {
        self.born.len()
    }

    /// Whether a scout set out in this trial (addition A6).
    #[must_use]
    pub fn is_scouting(&self) -> bool {
        self.scout
    }

    /// Heading that a neuron's prototypical action meant where it was born, radians.
    #[must_use]
    pub fn heading_of(&self, neuron: &Neuron) -> f64 {
        wrap_angle(neuron.prototypical_rad + self.frame_at(neuron.birth.pose))
    }

    /// Decides on a rotation: one turn of the loop of Algorithm 9.
    pub fn decide(&mut self, observation: &Observation) -> Decision {
        if self.step == 0 && self.settings.learning {
            self.memory.send_scout(&self.settings);
            self.scout = self.memory.scout_turns_left().is_some();
        }
        self.step += 1;
        self.memory.ticks += 1;
        if self.memory.has_scouted_enough(self.step) {
            self.memory.stop_scouting();
            self.escape = Escape::default();
            self.past = None;
        }
        let situation = self.situate(observation);
        if self.settings.learning {
            self.act_from_network(&situation)
        } else {
            self.act_from_reflex(&situation)
        }
    }

    /// Takes what came of the last decision.
    pub fn consequence(&mut self, consequence: &Consequence) {
        let Some((mut past, mut step)) = self.waiting.take() else { return };
        step.reached = consequence.pose.position();
        step.reinforcement = consequence.reinforcement.total();
        step.safety = consequence.reinforcement.safety;
        if step.paid() > 0.0 {
            step.away =
                away_from_nearest(self.robot.sonars(), &consequence.sonar_m, consequence.pose);
        }
        past.situation.reinforcement = step.reinforcement;
        self.path.push(step);
        self.past = Some(past);
    }

    /// Closes the trial and cools the temperature; `rng` is the exploration stream of the next trial.
    pub(crate) fn end_trial(&mut self, reached_goal: bool, rng: ChaCha8Rng) -> Changes {
        let mut changes = close(
            &self.settings,
            &self.robot,
            self.goal,
            &mut self.memory,
            &self.path,
            &self.born,
            reached_goal,
        );
        changes.record &= self.memory.holds_the_record();
        changes.recentred = std::mem::take(&mut self.recentred);
        changes.recentred.sort_unstable();
        changes.recentred.dedup();
        self.memory.temperature_deg =
            annealing::cooled(&self.settings, self.memory.temperature_deg);
        self.memory.trials += 1;
        self.memory.judge_scout();
        self.scout = false;
        self.rng = rng;
        self.past = None;
        self.waiting = None;
        self.drawn = None;
        self.escape = Escape::default();
        self.bend = None;
        self.path.clear();
        self.born.clear();
        self.step = 0;
        changes
    }

    fn situate<'a>(&self, observation: &'a Observation) -> Situation<'a> {
        let pose = observation.pose;
        let distance_m = pose.distance_to(self.goal);
        Situation {
            observation,
            input: self.settings.input.encode(&observation.sonar_m, pose, distance_m),
            bearing_rad: pose.bearing_to(self.goal),
            network: match self.settings.partition {
                Partition::World => observation.region,
                Partition::One => 0,
            },
            frame_rad: self.frame_at(pose),
        }
    }

    /// Direction of the action frame's zero at a pose, radians in the odometry frame.
    ///
    /// NOTE (R1): the thesis says rotation and "the robot's next direction of motion"; a rotation
    /// cannot be replayed from a slightly other heading, so the default stores directions.
    fn frame_at(&self, pose: Pose) -> f64 {
        match self.settings.action_frame {
            ActionFrame::Heading => 0.0,
            ActionFrame::Rotation => pose.heading_rad,
            ActionFrame::Goal => angle(self.goal - pose.position()),
        }
    }

    fn advise(&self, situation: &Situation<'_>) -> ReflexTrace {
        self.reflex.advise(&situation.observation.sonar_m, situation.bearing_rad)
    }

    fn act_from_reflex(&mut self, situation: &Situation<'_>) -> Decision {
        let reflex = self.advise(situation);
        let action_rad = situation.action(reflex.rotation_rad);
        Decision {
            goal_distance_m: situation.observation.pose.distance_to(self.goal),
            goal_bearing_rad: situation.bearing_rad,
            winner: None,
            born: None,
            origin: None,
            guide: None,
            reflex: Some(reflex),
            adaptation: Adaptation::Off,
            neuron: None,
            prototypical_rad: action_rad,
            utility: None,
            aim: None,
            exploration: Exploration::default(),
            source: ActionSource::Reflex,
            action_rad,
            rotation_rad: reflex.rotation_rad,
        }
    }

    fn act_from_network(&mut self, situation: &Situation<'_>) -> Decision {
        let mut reflex = None;
        let leg = self.leg(situation);
        let winner = self.memory.networks[situation.network]
            .winner(&situation.input)
            .map(|(neuron, squared)| (Acting::from(situation.network, neuron), squared));
        let (acting, born) = match self.cause_of_birth(winner.as_ref()) {
            None => (self.generalise(winner.map(|(acting, _)| acting)), None),
            Some(cause) => {
                let acting = self.grow(situation, cause, leg, &mut reflex);
                (Some(acting), Some(acting.neuron))
            }
        };
        let Some(mut acting) = acting else { return self.act_from_reflex(situation) };
        let adaptation = self.adapt_past(&acting);
        let guide = match born {
            Some(_) => None,
            None => self.guide(situation, &mut acting, leg),
        };
        self.bend = acting.aim.filter(|aim| aim.beyond.is_some() || leg == Some(*aim));
        let mean_deg = guide.map_or_else(|| self.mean_deg(situation, &acting), |_| 0.0);
        let mut exploration = explore(
            &self.settings,
            acting.utility,
            mean_deg,
            self.temperature_deg(),
            self.most_deg(&acting, mean_deg),
            self.held(&acting),
            &mut self.rng,
        );
        self.drawn = Some((acting.neuron, exploration.drawn_deg));
        let (action_rad, source) = self.choose(situation, &acting, guide, &mut exploration);
        self.wait_for_consequence(situation, &acting, &exploration, action_rad);
        Decision {
            goal_distance_m: situation.observation.pose.distance_to(self.goal),
            goal_bearing_rad: situation.bearing_rad,
            winner: winner.map(|(acting, squared)| Winner {
                neuron: acting.neuron,
                distance: squared.sqrt(),
            }),
            origin: born.and_then(|born| self.origin_of(acting.network, born)),
            born,
            guide,
            reflex,
            adaptation,
            neuron: Some(acting.neuron),
            prototypical_rad: acting.prototypical_rad,
            utility: (!acting.pending).then_some(acting.utility),
            aim: acting.aim,
            exploration,
            source,
            action_rad,
            rotation_rad: situation.rotation(action_rad),
        }
    }

    /// The action in the action frame, and who chose it. What is not chosen by the network is recorded
    /// like any other action, and explores nothing.
    fn choose(
        &mut self,
        situation: &Situation<'_>,
        acting: &Acting,
        guide: Option<Guide>,
        exploration: &mut Exploration,
    ) -> (f64, ActionSource) {
        let left = self.memory.scout_turns_left();
        if let Some(heading_rad) = self.escape(situation, left) {
            exploration.xi_deg = 0.0;
            let source = left.map_or(ActionSource::Escape, |_| ActionSource::Scout);
            return (wrap_angle(heading_rad - situation.frame_rad), source);
        }
        let (start_rad, source) = match guide {
            Some(Guide { source, place }) => (self.towards(situation, place), source),
            None => (acting.prototypical_rad, ActionSource::Network),
        };
        // Eq. (5.15): α = p_i + ξ
        let action_rad = wrap_angle(start_rad + exploration.xi_deg.to_radians());
        match self.sidestep(situation, wrap_angle(action_rad + situation.frame_rad)) {
            Some(heading_rad) => {
                exploration.xi_deg = 0.0;
                (wrap_angle(heading_rad - situation.frame_rad), ActionSource::Sidestep)
            }
            None => (action_rad, source),
        }
    }

    /// `μ` at this place, degrees: along the shortcut when the neuron aims at one (A1).
    fn mean_deg(&self, situation: &Situation<'_>, acting: &Acting) -> f64 {
        let Some(aim) = acting.aim else { return acting.mean_deg };
        let way = aim.point() - situation.observation.pose.position();
        if way.norm() < REACHED * self.settings.advance_m {
            return 0.0;
        }
        // A1: μ_i = arg(q - p_r) - p_i
        let aim_rad = angle(way) - situation.frame_rad;
        wrap_angle(aim_rad - acting.prototypical_rad).to_degrees()
    }

    /// Most that `ξ` may be, degrees.
    ///
    /// NOTE (A11): Eq. (5.15) clips every action to T(n). A shortcut is no guess of the stochastic unit but was
    /// looked at beforehand, and the corners that late trials would cut ask for more.
    fn most_deg(&self, acting: &Acting, mean_deg: f64) -> f64 {
        let temperature_deg = self.temperature_deg();
        let aims = acting.aim.is_some() && temperature_deg > 0.0;
        if aims && self.settings.shortcut_sharp {
            temperature_deg.max(mean_deg.abs())
        } else {
            temperature_deg
        }
    }

    /// The draw that still holds, if one does.
    ///
    /// NOTE: where a step is short against a receptive field, a neuron acts several times running, and
    /// keeps one action only, Eq. (5.28); draws that differ from step to step could not be kept.
    fn held(&self, acting: &Acting) -> Option<f64> {
        let drawn = self.drawn.filter(|(neuron, _)| *neuron == acting.neuron);
        drawn.filter(|_| self.settings.draw == Draw::Activation).map(|(_, drawn_deg)| drawn_deg)
    }

    /// Why a neuron must be added here, if it must.
    fn cause_of_birth(&self, winner: Option<&(Acting, f64)>) -> Option<BirthCause> {
        let Some((_, squared)) = winner else { return Some(BirthCause::Empty) };
        // Section 5.7: ‖x - c_i‖ > ς is new; otherwise Eq. (5.11): x = c_i, V(x) = u_i
        let distance = self.settings.novelty_metric.of(*squared);
        (distance > self.settings.novelty).then_some(BirthCause::Distance { distance })
    }

    /// Counts a win.
    fn generalise(&mut self, acting: Option<Acting>) -> Option<Acting> {
        let acting = acting?;
        let neuron = self.memory.networks[acting.network].get_mut(acting.neuron)?;
        neuron.wins = neuron.wins.saturating_add(1);
        Some(acting)
    }

    /// Adds a neuron at the situation (distance-driven growth).
    fn grow(
        &mut self,
        situation: &Situation<'_>,
        cause: BirthCause,
        leg: Option<Aim>,
        reflex: &mut Option<ReflexTrace>,
    ) -> Acting {
        let observation = situation.observation;
        let heritage = self.heritage(situation, leg, reflex);
        // Section 5.9, Exceptions: u is the reinforcement of the present situation.
        let now = reinforcement(
            &self.settings.reward,
            &observation.sonar_m,
            observation.contact,
            situation.bearing_rad,
        );
        let birth = self.birth(cause, heritage.origin, observation.pose);
        let Heritage { prototypical_rad, mean_deg, aim, .. } = heritage;
        let start = Start { prototypical_rad, mean_deg, aim, utility: now.total() };
        self.add(situation.network, situation.input, start, birth)
    }

    fn origin_of(&self, network: usize, neuron: NeuronId) -> Option<Origin> {
        self.memory.networks[network].get(neuron).map(|neuron| neuron.birth.origin)
    }

    fn birth(&self, cause: BirthCause, origin: Origin, pose: Pose) -> Birth {
        let trial = self.memory.trials + 1;
        Birth { trial, step: self.step, tick: self.memory.ticks, cause, origin, pose }
    }

    fn add(&mut self, network: usize, centre: Input, start: Start, birth: Birth) -> Acting {
        let id = self.memory.add(network, centre, start, birth);
        self.born.push((network, id));
        self.recentred.push(id);
        Acting {
            network,
            neuron: id,
            prototypical_rad: start.prototypical_rad,
            mean_deg: start.mean_deg,
            aim: start.aim,
            utility: start.utility,
            pending: self.memory.best.is_some(),
        }
    }

    /// Judges the past situation by where it led, section 5.9.
    fn adapt_past(&mut self, present: &Acting) -> Adaptation {
        let Some(past) = self.past.take() else { return Adaptation::NoPast };
        let learns_mean = self.settings.mean_update == MeanUpdate::Gradient;
        if !self.settings.temporal_difference && !learns_mean {
            return Adaptation::Off;
        }
        let Some(neuron) = self.memory.networks[past.network].get_mut(past.neuron) else {
            return Adaptation::NoPast;
        };
        if neuron.pending || present.pending {
            return Adaptation::Pending { past: past.neuron };
        }
        let reinforcement = past.situation.reinforcement;
        let delta = td_error(&self.settings, reinforcement, neuron.utility, present.utility);
        if delta > self.settings.split_threshold {
            return self.split(&past, delta, present.utility);
        }
        let update = adapt(&self.settings, neuron, &past.situation, delta, present.utility);
        if update.centre_shift > 0.0 {
            self.recentred.push(past.neuron);
        }
        Adaptation::Updated(update)
    }

    /// Error-driven growth: the past situation gets its own neuron (section 5.9, Hidden States).
    ///
    /// NOTE: the text does not say what its parameters are; it takes the action that was executed and
    /// the utility that was found.
    fn split(&mut self, past: &Past, delta: f64, present_utility: f64) -> Adaptation {
        let Some(action_rad) = self.path.last().map(|step| step.action_rad) else {
            return Adaptation::NoPast;
        };
        let utility = past.situation.reinforcement + self.settings.discount * present_utility;
        let origin = Origin::Inherited { parent: past.neuron };
        let birth = self.birth(BirthCause::Error { delta }, origin, past.pose);
        let start = Start { prototypical_rad: action_rad, mean_deg: 0.0, aim: None, utility };
        let added = self.add(past.network, past.situation.input, start, birth);
        if let Some(step) = self.path.last_mut() {
            step.neuron = added.neuron;
        }
        Adaptation::Split { past: past.neuron, delta, added: added.neuron }
    }

    fn wait_for_consequence(
        &mut self,
        situation: &Situation<'_>,
        acting: &Acting,
        exploration: &Exploration,
        action_rad: f64,
    ) {
        let past = Past {
            network: acting.network,
            neuron: acting.neuron,
            pose: situation.observation.pose,
            situation: PastSituation {
                input: situation.input,
                eligibility: eligibility(&self.settings, exploration),
                reinforcement: 0.0,
            },
        };
        let step = PathStep {
            network: acting.network,
            neuron: acting.neuron,
            aim: acting.aim,
            mean_deg: acting.mean_deg,
            pose: situation.observation.pose,
            sonar_m: situation.observation.sonar_m,
            action_rad,
            frame_rad: situation.frame_rad,
            reinforcement: 0.0,
            safety: 0.0,
            reached: situation.observation.pose.position(),
            away: Vec2::zeros(),
        };
        self.waiting = Some((past, step));
    }
}

/// Unit vector away from where the least reading looks, odometry frame.
fn away_from_nearest(sonars: &[Mount], sonar_m: &Readings, pose: Pose) -> Vec2 {
    let bearing_rad = sonars[sonar_m.nearest()].axis_deg.to_radians();
    -unit(pose.heading_rad + bearing_rad)
}
