//! The shortcut proposal (addition A1): where the next trial should explore.
//!
//! NOTE (A1): the thesis sets `μ` by the TD error and the eligibility, Eq. (5.21)-(5.24); in twenty
//! trials that finds nothing. Here each neuron on the record path looks along that path at the later
//! points that were in view from where it acted, and aims at the one with the greatest return the
//! critic predicts: the reinforcement of driving straight there, and the utility of the neuron in
//! charge there. A proposal only moves the *exploration*; what is kept is decided by Eq. (5.28).

use std::f64::consts::PI;

use super::echoes::Echoes;
use super::trial_end::PathStep;
use super::{Aim, Judge, LearnerSettings, Memory, Proposal, annealing};
use crate::geometry::{Vec2, angle, wrap_angle};
use crate::robot::Robot;

/// A nearer point gives no direction to aim along, metres.
const TOO_NEAR_M: f64 = 0.05;

/// Looks for shortcuts along a record path.
pub(super) struct Surveyor<'a> {
    pub(super) settings: &'a LearnerSettings,
    pub(super) robot: &'a Robot,
    pub(super) goal: Vec2,
    pub(super) memory: &'a Memory,
    pub(super) path: &'a [PathStep],
}

/// A later point of the path that a neuron could aim at.
struct Candidate {
    point: Vec2,
    /// Step of the path that ended there.
    step: usize,
    /// What the critic expects from there on; 0 at the goal.
    utility: f64,
}

impl Surveyor<'_> {
    /// The proposal of each step of the path that has one.
    pub(super) fn survey(&self) -> Vec<(usize, Proposal)> {
        let next_trial = self.memory.trials + 2;
        let cooled = annealing::cooled(self.settings, self.memory.temperature_deg);
        let temperature_deg = annealing::effective(self.settings, cooled, next_trial);
        (0..self.path.len()).filter_map(|t| Some((t, self.propose(t, temperature_deg)?))).collect()
    }

    /// The best later point in view from where a step was decided, within the next temperature.
    fn propose(&self, t: usize, temperature_deg: f64) -> Option<Proposal> {
        let step = &self.path[t];
        let neuron = self.memory.networks[step.network].get(step.neuron)?;
        let echoes = self.settings.echoes(self.robot, step.pose, &step.sonar_m);
        let mut best: Option<(f64, Proposal)> = None;
        // The far end first: it mostly has the greatest utility, and spares the look at all others.
        for candidate in self.later_points(t).rev() {
            let greatest = best.as_ref().map_or(f64::NEG_INFINITY, |(score, _)| *score);
            // Driving there gains nothing, so no score exceeds this one.
            if self.score(&candidate, 0.0) <= greatest {
                continue;
            }
            let way = candidate.point - echoes.from();
            let aim_rad = angle(way) - step.frame_rad;
            let mean_deg = wrap_angle(aim_rad - neuron.prototypical_rad).to_degrees();
            // Eq. (5.15): -T(n) ≤ ξ ≤ T(n). What the temperature would clip is not proposed.
            if way.norm() < TOO_NEAR_M || mean_deg.abs() > temperature_deg {
                continue;
            }
            let Some(straight) = self.straight(&echoes, candidate.point) else { continue };
            let score = self.score(&candidate, straight);
            if score > greatest {
                let then = self.path.get(candidate.step + 1);
                let aim = Aim {
                    x_m: candidate.point.x,
                    y_m: candidate.point.y,
                    then: then.map(|next| (next.network, next.neuron)),
                };
                best = Some((
                    score,
                    Proposal {
                        neuron: neuron.id,
                        before_deg: neuron.mean_deg,
                        after_deg: mean_deg,
                        aim,
                        step: self.number(candidate.step),
                        straight,
                        utility: candidate.utility,
                    },
                ));
            }
        }
        best.map(|(_, proposal)| proposal)
    }

    /// What is greatest where a neuron should aim.
    fn score(&self, candidate: &Candidate, straight: f64) -> f64 {
        match self.settings.shortcut_judge {
            // A1: q* = arg max_q r(p_t → q) + u(q)
            Judge::Critic => straight + candidate.utility,
            Judge::Farthest => f64::from(self.number(candidate.step)),
        }
    }

    /// The points reached by this and all later steps, the goal itself last.
    fn later_points(&self, t: usize) -> impl DoubleEndedIterator<Item = Candidate> + '_ {
        let points = (t..self.path.len()).map(|step| {
            let next = self.path.get(step + 1);
            let utility = next.map_or(Some(0.0), |next| {
                self.memory.networks[next.network].get(next.neuron).map(|neuron| neuron.utility)
            });
            let utility = utility.unwrap_or(f64::NEG_INFINITY);
            Candidate { point: self.clear_point(step), step, utility }
        });
        let goal = Candidate { point: self.goal, step: self.path.len() - 1, utility: 0.0 };
        points.chain(std::iter::once(goal))
    }

    /// Where a step ended, moved off the nearest obstacle by the clearance that cost it.
    fn clear_point(&self, step: usize) -> Vec2 {
        let PathStep { reached, away, .. } = self.path[step];
        // A1: q = p_{t+1} + d_c min(-f₁, 1) away from the nearest obstacle
        let lacked_m = self.settings.reward.close_m * self.path[step].paid();
        if self.settings.shortcut_push { reached + away * lacked_m } else { reached }
    }

    /// Reinforcement of driving straight to a point, as far as the echoes tell; none when they show
    /// something in the way.
    fn straight(&self, echoes: &Echoes, point: Vec2) -> Option<f64> {
        let (way, advance_m) = (point - echoes.from(), self.settings.advance_m);
        let (length_m, heading_rad) = (way.norm(), angle(way));
        if length_m > echoes.free_m(heading_rad) {
            return None;
        }
        let direction = way / length_m;
        let mut sum = 0.0;
        let mut driven_m = 0.0;
        while driven_m < length_m {
            let to_m = (driven_m + advance_m).min(length_m);
            let midway = echoes.from() + direction * (to_m - advance_m / 2.0).max(0.0);
            let at = echoes.from() + direction * to_m;
            let clearance_m = echoes.clearance_m(at);
            if clearance_m.min(echoes.clearance_m(midway)) < self.settings.shortcut_clearance_m {
                return None;
            }
            // Eq. (5.6), (5.7) at the places the steps would lead to; the last counts for its share.
            let safety = (clearance_m / self.settings.reward.close_m - 1.0).min(0.0);
            let error_rad = wrap_angle(angle(self.goal - at) - heading_rad);
            sum += (to_m - driven_m) / advance_m * (safety - error_rad.abs() / PI);
            driven_m = to_m;
        }
        Some(sum)
    }

    #[expect(clippy::cast_possible_truncation, reason = "below the step cap, a u32")]
    fn number(&self, step: usize) -> u32 {
        step as u32 + 1
    }
}

#[cfg(test)]
mod tests;
