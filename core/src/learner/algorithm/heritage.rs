//! Where the first action of a new neuron comes from, and what leads a known one past its own.

use super::{Acting, Learner, Situation};
use crate::control::ReflexTrace;
use crate::geometry::{Vec2, angle, unit, wrap_angle};
use crate::learner::echoes::{Cone, SLACK_M};
use crate::learner::memory::Waypoint;
use crate::learner::trial_end::PathStep;
use crate::learner::{ActionSource, Aim, Carry, FirstAction, Guide, Neuron, NeuronId, Origin};

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
        leg: Option<Aim>,
        reflex: &mut Option<ReflexTrace>,
    ) -> Heritage {
        if self.may_inherit(situation) {
            let past = self.path.last();
            let shortcut = past.and_then(|past| self.carry_on(situation, past, leg));
            let other = || self.target(situation).map(|target| self.pursuit(situation, target));
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
    fn carry_on(
        &self,
        situation: &Situation<'_>,
        past: &PathStep,
        leg: Option<Aim>,
    ) -> Option<Heritage> {
        if self.settings.shortcut_carry == Carry::Off || self.temperature_deg() <= 0.0 {
            return None;
        }
        if let Some(leg) = leg {
            return Some(Heritage {
                origin: Origin::Inherited { parent: past.neuron },
                prototypical_rad: self.towards(situation, leg.point()),
                mean_deg: 0.0,
                aim: Some(leg),
            });
        }
        let aim = past.aim?;
        let left_m = (aim.point() - situation.observation.pose.position()).norm();
        if left_m <= REACHED * self.settings.advance_m {
            return self.hand_over(aim.then?);
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

    /// A3: the leg to drive on a way that bends, while one is under way and the echoes leave room.
    ///
    /// Known neurons that it passes have aims of their own; where they took over, none was driven to its end.
    pub(super) fn leg(&self, situation: &Situation<'_>) -> Option<Aim> {
        let leg = self.bend.filter(|_| !situation.collided() && self.temperature_deg() > 0.0)?;
        let left_m = (leg.point() - situation.observation.pose.position()).norm();
        let reached = left_m <= REACHED * self.settings.advance_m;
        let leg = if reached { leg.after_bend()? } else { leg };
        self.is_free(situation, leg).then_some(leg)
    }

    /// Direction to a place, radians in the action frame.
    pub(super) fn towards(&self, situation: &Situation<'_>, place: Vec2) -> f64 {
        let way = place - situation.observation.pose.position();
        wrap_angle(angle(way) - situation.frame_rad)
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
        let echoes = self.settings.echoes(&self.robot, pose, sonar_m, matters_m, Cone::Axis);
        let step = unit(angle(aim.point() - here)) * advance_m;
        [0.5, 1.0].iter().all(|share| echoes.clearance_m(here + step * *share) >= asked_m)
    }

    /// D2: where to go back to the record path (pure pursuit), that is where the step after its nearest place
    /// was decided; the goal after the last.
    fn target(&self, situation: &Situation<'_>) -> Option<Vec2> {
        let here = situation.observation.pose.position();
        let squared = |step: &Waypoint| (step.point() - here).norm_squared();
        let record = self.memory.record.iter().enumerate();
        let (nearest, _) = record.min_by(|a, b| squared(a.1).total_cmp(&squared(b.1)))?;
        Some(self.memory.record.get(nearest + 1).map_or(self.goal, Waypoint::point))
    }

    fn pursuit(&self, situation: &Situation<'_>, target: Vec2) -> Heritage {
        Heritage {
            origin: Origin::Pursuit { x_m: target.x, y_m: target.y },
            prototypical_rad: self.towards(situation, target),
            mean_deg: 0.0,
            aim: None,
        }
    }

    /// What leads a known neuron past its own action: a way that bends (A3), which it then aims along, or the
    /// way back to the record path (A9).
    pub(super) fn guide(
        &self,
        situation: &Situation<'_>,
        acting: &mut Acting,
        leg: Option<Aim>,
    ) -> Option<Guide> {
        if let Some(leg) = leg {
            (acting.aim, acting.mean_deg) = (Some(leg), 0.0);
            return Some(Guide { source: ActionSource::Bend, place: leg.point() });
        }
        let place = self.stray(situation, acting)?;
        Some(Guide { source: ActionSource::Pursuit, place })
    }

    /// Where a neuron goes that wins at temperature 0 and is not of the record path.
    ///
    /// NOTE (A9): the receptive fields of neurons that an earlier record left behind reach over the path. What
    /// they do was found elsewhere; here it leads away from the best path, which is to be driven as it is.
    fn stray(&self, situation: &Situation<'_>, acting: &Acting) -> Option<Vec2> {
        let strays = self.settings.keep_to_record
            && self.temperature_deg() <= 0.0
            && !self.memory.is_on_record(acting.neuron);
        strays.then(|| self.target(situation)).flatten()
    }
}
