//! The shortcut proposal (addition A1): where the next trial should explore.
//!
//! NOTE (A1): the thesis sets `μ` by the TD error and the eligibility, Eq. (5.21)-(5.24); in twenty
//! trials that finds nothing. Here each neuron on the record path looks along that path at the later
//! points that were in view from where it acted, and aims at the one with the greatest return the
//! critic predicts: the reinforcement of driving straight there, and the utility of the neuron in
//! charge there. A proposal only moves the *exploration*; what is kept is decided by Eq. (5.28).

use std::f64::consts::PI;

mod bend;

use super::echoes::{Beside, Cone, Echoes};
use super::trial_end::PathStep;
use super::{Aim, Beyond, Judge, LearnerSettings, Memory, Proposal, annealing};
use crate::geometry::{Vec2, angle, wrap_angle};
use crate::robot::Robot;

/// A nearer point gives no direction to aim along, metres.
const TOO_NEAR_M: f64 = 0.05;

/// Near echoes lie at least this far apart; more of them tell nothing more, metres.
const APART_M: f64 = 0.05;

/// Looks for shortcuts along a record path.
pub(super) struct Surveyor<'a> {
    settings: &'a LearnerSettings,
    robot: &'a Robot,
    goal: Vec2,
    memory: &'a Memory,
    path: &'a [PathStep],
    /// What was heard where each step was decided, and close by at any step (A7).
    views: Vec<Echoes<'a>>,
}

/// A way that a neuron could propose.
#[derive(Clone, Copy)]
struct Way {
    /// What is greatest where a neuron should aim.
    score: f64,
    /// From the prototypical action to the aim, degrees.
    mean_deg: f64,
    aim: Aim,
    /// Step of the path that ended where the way ends.
    step: usize,
    /// Predicted for driving it.
    reinforcement: f64,
    /// What the critic expects from there on.
    utility: f64,
}

/// A later point of the path that a neuron could aim at.
#[derive(Clone, Copy)]
struct Candidate {
    point: Vec2,
    /// Step of the path that ended there.
    step: usize,
    /// What the critic expects from there on; 0 at the goal.
    utility: f64,
}

impl<'a> Surveyor<'a> {
    /// A surveyor of a record path, for a goal in the odometry frame.
    pub(super) fn new(
        settings: &'a LearnerSettings,
        robot: &'a Robot,
        goal: Vec2,
        memory: &'a Memory,
        path: &'a [PathStep],
    ) -> Self {
        // NOTE (A7): a surface that throws the echo of a slanting beam away is silent from where a shortcut
        // begins, and was heard where the robot passed it. Far echoes tell less: a cone blurs their place.
        let near_m = settings.near_echo_m;
        let near = path.iter().flat_map(|step| {
            settings.echoes(robot, step.pose, &step.sonar_m, near_m, Cone::Axis).into_points()
        });
        let near = thinned(near);
        let view = |step: &'a PathStep| {
            let all_m = settings.sonar_range_m;
            let mut view = settings.echoes(robot, step.pose, &step.sonar_m, all_m, Cone::Axis);
            view.add(&near);
            view
        };
        let views = path.iter().map(view).collect();
        Self { settings, robot, goal, memory, path, views }
    }

    /// The proposal of each step of the path that has one.
    pub(super) fn survey(&self) -> Vec<(usize, Proposal)> {
        let next_trial = self.memory.trials + 2;
        let cooled = annealing::cooled(self.settings, self.memory.temperature_deg);
        let temperature_deg = annealing::effective(self.settings, cooled, next_trial);
        if temperature_deg <= 0.0 {
            return Vec::new();
        }
        // Eq. (5.15) would clip what turns by more than the next temperature, but for A11.
        let sharp = self.settings.shortcut_sharp;
        let most_deg = if sharp { f64::INFINITY } else { temperature_deg };
        let proposal = |t| Some((t, self.propose(t, most_deg)?));
        (0..self.path.len()).filter_map(proposal).collect()
    }

    /// The best way from where a step was decided to a later point, with the greatest turn allowed.
    fn propose(&self, t: usize, most_deg: f64) -> Option<Proposal> {
        let step = &self.path[t];
        let neuron = self.memory.networks[step.network].get(step.neuron)?;
        let within = |heading_rad: f64| {
            let aim_rad = heading_rad - step.frame_rad;
            let mean_deg = wrap_angle(aim_rad - neuron.prototypical_rad).to_degrees();
            (mean_deg.abs() <= most_deg).then_some(mean_deg)
        };
        let straight = self.best_straight(t, &within);
        let bends = t == 0 && self.looks_for_bends();
        let way = if bends { self.best_bend(t, &within, straight) } else { straight }?;
        Some(Proposal {
            neuron: neuron.id,
            before_deg: neuron.mean_deg,
            after_deg: way.mean_deg,
            aim: way.aim,
            step: self.number(way.step),
            straight: way.reinforcement,
            utility: way.utility,
        })
    }

    /// Whether home looks for ways that bend. Not along a way that a scout has just found: a bend leads to the
    /// other side of an obstacle, and would lead back.
    fn looks_for_bends(&self) -> bool {
        let judged = self.settings.shortcut_judge == Judge::Critic;
        self.settings.shortcut_bend && judged && self.memory.scout_turns_left().is_none()
    }

    /// The best later point in view.
    fn best_straight(&self, t: usize, within: &impl Fn(f64) -> Option<f64>) -> Option<Way> {
        let view = &self.views[t];
        let mut best: Option<Way> = None;
        // The far end first: it mostly has the greatest utility, and spares the look at all others.
        for candidate in self.later_points(t).rev() {
            let greatest = best.as_ref().map_or(f64::NEG_INFINITY, |way| way.score);
            // Driving there gains nothing, so no score exceeds this one.
            if self.score(&candidate, 0.0) <= greatest {
                continue;
            }
            let way = candidate.point - view.from();
            if way.norm() < TOO_NEAR_M {
                continue;
            }
            let Some(mean_deg) = within(angle(way)) else { continue };
            let promises = |straight| self.score(&candidate, straight) > greatest;
            let Some(straight) = self.straight(view, candidate.point, promises) else { continue };
            best = Some(Way {
                score: self.score(&candidate, straight),
                mean_deg,
                aim: self.aim(&candidate),
                step: candidate.step,
                reinforcement: straight,
                utility: candidate.utility,
            });
        }
        best
    }

    fn aim(&self, candidate: &Candidate) -> Aim {
        let then = self.path.get(candidate.step + 1);
        Aim {
            x_m: candidate.point.x,
            y_m: candidate.point.y,
            beyond: None,
            then: then.map(|next| (next.network, next.neuron)),
        }
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
    /// something in the way, or it is worth nothing.
    fn straight(
        &self,
        echoes: &Echoes<'_>,
        point: Vec2,
        is_worth: impl Fn(f64) -> bool,
    ) -> Option<f64> {
        let way = point - echoes.from();
        if way.norm() > echoes.free_m(angle(way)) {
            return None;
        }
        self.leg(echoes.from(), point, &[echoes], is_worth)
    }

    /// Reinforcement of driving straight from a place to a point; none when the echoes do not leave
    /// room, or as soon as what was paid is not worth it: no step gains anything.
    fn leg(
        &self,
        from: Vec2,
        to: Vec2,
        views: &[&Echoes<'_>],
        is_worth: impl Fn(f64) -> bool,
    ) -> Option<f64> {
        let (way, advance_m) = (to - from, self.settings.advance_m);
        let (length_m, heading_rad) = (way.norm(), angle(way));
        let direction = way / length_m;
        let beside = self.beside(from, direction, length_m, views);
        let mut sum = 0.0;
        let mut driven_m = 0.0;
        while driven_m < length_m {
            let to_m = (driven_m + advance_m).min(length_m);
            let midway = from + direction * (to_m - advance_m / 2.0).max(0.0);
            let share = (to_m - driven_m) / advance_m;
            sum += share * self.step_to(from + direction * to_m, midway, heading_rad, &beside)?;
            if !is_worth(sum) {
                return None;
            }
            driven_m = to_m;
        }
        Some(sum)
    }

    /// The echoes that can count on a straight way.
    fn beside(&self, from: Vec2, direction: Vec2, length_m: f64, views: &[&Echoes<'_>]) -> Beside {
        let counts_m = self.settings.shortcut_clearance_m.max(self.settings.reward.close_m);
        Beside::new(views, from, direction, length_m, counts_m)
    }

    /// Reinforcement of a step that ends at a place; none when the echoes do not leave room.
    fn step_to(&self, at: Vec2, midway: Vec2, heading_rad: f64, beside: &Beside) -> Option<f64> {
        let at_end_m = beside.clearance_m(at);
        if at_end_m.min(beside.clearance_m(midway)) < self.settings.shortcut_clearance_m {
            return None;
        }
        // Eq. (5.6), (5.7) at the places the steps would lead to; the last counts for its share.
        let safety = (at_end_m / self.settings.reward.close_m - 1.0).min(0.0);
        let error_rad = wrap_angle(angle(self.goal - at) - heading_rad);
        Some(safety - error_rad.abs() / PI)
    }

    #[expect(clippy::cast_possible_truncation, reason = "below the step cap, a u32")]
    fn number(&self, step: usize) -> u32 {
        step as u32 + 1
    }
}

/// Those of some points that lie apart from all before them.
fn thinned(points: impl Iterator<Item = Vec2>) -> Vec<Vec2> {
    points.fold(Vec::new(), |mut kept, point| {
        let is_apart = |other: &Vec2| (other - point).norm_squared() >= APART_M * APART_M;
        if kept.iter().all(is_apart) {
            kept.push(point);
        }
        kept
    })
}

#[cfg(test)]
mod tests;
