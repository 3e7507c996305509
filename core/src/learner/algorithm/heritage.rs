//! Where the first action of a new neuron comes from.

use super::{Acting, Learner, Situation};
use crate::control::ReflexTrace;
use crate::geometry::{Vec2, angle, unit, wrap_angle};
use crate::learner::echoes::SLACK_M;
use crate::learner::trial_end::PathStep;
use crate::learner::{Aim, Carry, FirstAction, Neuron, NeuronId, Origin};

/// Distance at which an aim is reached: half a step never passes it by, in advances.
pub(super) const REACHED: f64 = 0.5;

/// What a new neuron starts with.
pub(super) struct Heritage {
    pub(super) origin: Origin,
    pub(super) prototypical_rad: f64,
    pub(super) mean_deg: f64,
    pub(super) aim: Option<Aim>,
}

impl Heritage {
    /// Everything that acts, from another neuron.
    fn of(neuron: &Neuron) -> Self {
        Self {
            origin: Origin::Inherited { parent: neuron.id },
            prototypical_rad: neuron.prototypical_rad,
            mean_deg: neuron.mean_deg,
            aim: neuron.aim,
        }
    }
}

impl Learner {
    /// NOTE (D2): the thesis always asks the reflex. Off the stored path every situation is new, so
    /// the reflex would pull each excursion back; a new neuron carries on the shortcut under way (A2),
    /// else goes back to the record path.
    pub(super) fn heritage(
        &self,
        situation: &Situation<'_>,
        nearest: Option<&(Acting, f64)>,
        reflex: &mut Option<ReflexTrace>,
    ) -> Heritage {
        if self.may_inherit(situation) {
            let shortcut = self.path.last().and_then(|past| self.carry_on(situation, past));
            let other = || match self.settings.first_action {
                FirstAction::Pursue => self.pursue(situation),
                _ => self.neighbour(situation, nearest?),
            };
            if let Some(heritage) = shortcut.or_else(other) {
                return heritage;
            }
        }
        let advice = *reflex.get_or_insert_with(|| self.advise(situation));
        let prototypical_rad = situation.action(advice.rotation_rad);
        Heritage { origin: Origin::Reflex, prototypical_rad, mean_deg: 0.0, aim: None }
    }

    fn may_inherit(&self, situation: &Situation<'_>) -> bool {
        self.settings.first_action != FirstAction::Reflex
            && self.memory.best.is_some()
            && !situation.collided()
    }

    /// A2: the shortcut that the last step followed goes on, or ends here and the neuron in charge at
    /// its end takes over. Only while exploring: at temperature 0 nothing follows a shortcut.
    fn carry_on(&self, situation: &Situation<'_>, past: &PathStep) -> Option<Heritage> {
        if self.settings.shortcut_carry == Carry::Off || self.temperature_deg() <= 0.0 {
            return None;
        }
        let aim = past.aim?;
        let left_m = (aim.point() - situation.observation.pose.position()).norm();
        if left_m <= REACHED * self.settings.advance_m {
            return match aim.after_bend() {
                Some(next) => self.bend(situation, past, next),
                None => self.hand_over(aim.then?),
            };
        }
        if !self.is_free(situation, aim) {
            return None;
        }
        Some(Heritage {
            origin: Origin::Inherited { parent: past.neuron },
            // It goes on the way it came, so that the aim lies within the temperature.
            prototypical_rad: past.action_rad,
            mean_deg: past.mean_deg,
            aim: Some(aim),
        })
    }

    /// A3: the second leg begins; the new neuron starts with its direction, so that nothing is clipped.
    fn bend(&self, situation: &Situation<'_>, past: &PathStep, next: Aim) -> Option<Heritage> {
        let way = next.point() - situation.observation.pose.position();
        self.is_free(situation, next).then(|| Heritage {
            origin: Origin::Inherited { parent: past.neuron },
            prototypical_rad: wrap_angle(angle(way) - situation.frame_rad),
            mean_deg: 0.0,
            aim: Some(next),
        })
    }

    fn hand_over(&self, (network, neuron): (usize, NeuronId)) -> Option<Heritage> {
        if self.settings.shortcut_carry != Carry::HandOver {
            return None;
        }
        self.memory.networks[network].get(neuron).map(Heritage::of)
    }

    /// Whether the echoes leave room for the next step towards an aim.
    fn is_free(&self, situation: &Situation<'_>, aim: Aim) -> bool {
        let observation = situation.observation;
        let here = observation.pose.position();
        let (advance_m, asked_m) = (self.settings.advance_m, self.settings.shortcut_clearance_m);
        let matters_m = self.robot.reading_beyond_m(asked_m + advance_m) + SLACK_M;
        let (pose, sonar_m) = (observation.pose, &observation.sonar_m);
        let echoes = self.settings.echoes_within(&self.robot, pose, sonar_m, matters_m);
        let step = unit(angle(aim.point() - here)) * advance_m;
        [0.5, 1.0].iter().all(|share| echoes.clearance_m(here + step * *share) >= asked_m)
    }

    /// D2: after the record path (pure pursuit), that is to where the step after its nearest place was
    /// decided; to the goal after the last.
    fn pursue(&self, situation: &Situation<'_>) -> Option<Heritage> {
        let here = situation.observation.pose.position();
        let squared = |place: &[f64; 2]| (Vec2::from(*place) - here).norm_squared();
        let record_m = self.memory.record_m.iter().enumerate();
        let (nearest, _) = record_m.min_by(|a, b| squared(a.1).total_cmp(&squared(b.1)))?;
        let next = self.memory.record_m.get(nearest + 1).map_or(self.goal, |place| (*place).into());
        Some(Heritage {
            origin: Origin::Pursuit { x_m: next.x, y_m: next.y },
            prototypical_rad: wrap_angle(angle(next - here) - situation.frame_rad),
            mean_deg: 0.0,
            aim: None,
        })
    }

    /// The nearest neuron of the network, if it is near enough and what it does leaves room.
    fn neighbour(
        &self,
        situation: &Situation<'_>,
        (nearest, squared): &(Acting, f64),
    ) -> Option<Heritage> {
        let radius = self.settings.inherit_radius * self.settings.novelty;
        if self.settings.novelty_metric.of(*squared) > radius {
            return None;
        }
        let heritage = Heritage::of(self.memory.networks[nearest.network].get(nearest.neuron)?);
        let heading_rad = wrap_angle(heritage.prototypical_rad + situation.frame_rad);
        if !self.has_room(situation, heading_rad) {
            return None;
        }
        Some(match self.settings.first_action {
            FirstAction::InheritAction => Heritage { mean_deg: 0.0, aim: None, ..heritage },
            _ => heritage,
        })
    }
}
