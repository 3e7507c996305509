//! A shortcut that bends once (addition A3).
//!
//! NOTE (A3): chords of the record path cut its corners and no more. Eq. (5.7) asks to head for the goal,
//! not to be short, so the cheapest way may leave the record path, even to the other side of an
//! obstacle. A bend is a place off the path that was in view from where the neuron acted and from where
//! the way ends, so both legs were seen by the robot itself.

use std::f64::consts::{FRAC_PI_2, PI};

use super::{Beyond, Candidate, Surveyor, Way};
use crate::geometry::{Vec2, angle, unit, wrap_angle};
use crate::learner::Aim;
use crate::learner::echoes::Echoes;

/// A bend is tried at every second step of a first leg.
const EVERY: u32 = 2;

/// A place where a way could bend.
struct Bend {
    place: Vec2,
    /// From the prototypical action to the first leg, degrees.
    mean_deg: f64,
    /// Reinforcement of the first leg.
    reinforcement: f64,
}

impl Surveyor<'_> {
    /// The best way in two legs, where it promises more than the best straight way; else that.
    pub(super) fn best_bend(
        &self,
        t: usize,
        within: &impl Fn(f64) -> Option<f64>,
        straight: Option<Way>,
    ) -> Option<Way> {
        let mut floor = straight.as_ref().map_or(f64::NEG_INFINITY, |way| way.score);
        let mut best = straight;
        // The end of a way has to be a place where the robot looked round.
        let ends: Vec<Candidate> =
            self.later_points(t).filter(|end| end.step + 1 < self.path.len()).collect();
        let bends = self.bends(t, within, floor - greatest_utility(&ends));
        for (promise, bend, end) in self.promises(&bends, &ends, floor) {
            if promise <= floor {
                break;
            }
            let known = bend.reinforcement + end.utility;
            let views = [&self.views[t], &self.views[end.step + 1]];
            let is_worth = |second| known + second > floor;
            if let Some(second) = self.second_leg(views, bend.place, end.point, is_worth) {
                floor = known + second;
                best = Some(self.bent(bend, end, second));
            }
        }
        best
    }

    /// Pairs of a bend and an end that about promise more than a floor, the greatest promise first:
    /// so few second legs have to be looked at.
    fn promises<'a>(
        &self,
        bends: &'a [Bend],
        ends: &'a [Candidate],
        floor: f64,
    ) -> Vec<(f64, &'a Bend, &'a Candidate)> {
        let mut promises = Vec::new();
        for bend in bends {
            for end in ends.iter().rev() {
                let known = bend.reinforcement + end.utility;
                // No second leg gains anything.
                if known <= floor {
                    continue;
                }
                if let Some(cost) = self.rough_cost(bend.place, end.point, known - floor) {
                    promises.push((known + cost, bend, end));
                }
            }
        }
        promises.sort_by(|a, b| b.0.total_cmp(&a.0));
        promises
    }

    fn bent(&self, bend: &Bend, end: &Candidate, second: f64) -> Way {
        let straight = self.aim(end);
        let beyond = Some(Beyond { x_m: straight.x_m, y_m: straight.y_m });
        Way {
            // A3: (v, q)* = arg max r(p_t → v) + r(v → q) + u(q)
            score: bend.reinforcement + second + end.utility,
            mean_deg: bend.mean_deg,
            aim: Aim { x_m: bend.place.x, y_m: bend.place.y, beyond, ..straight },
            step: end.step,
            reinforcement: bend.reinforcement + second,
            utility: end.utility,
        }
    }

    /// The places in view where a way could bend and still be worth more than a floor.
    fn bends(&self, t: usize, within: &impl Fn(f64) -> Option<f64>, floor: f64) -> Vec<Bend> {
        let view = &self.views[t];
        let mut bends = Vec::new();
        for heading_rad in self.fan(t, view) {
            if let Some(mean_deg) = within(heading_rad) {
                self.bends_along(view, heading_rad, floor, |place, reinforcement| {
                    bends.push(Bend { place, mean_deg, reinforcement });
                });
            }
        }
        bends
    }

    /// Headings of first legs: to the goal and along the sonars, unless away from the goal.
    fn fan(&self, t: usize, view: &Echoes<'_>) -> impl Iterator<Item = f64> {
        let heading_rad = self.path[t].pose.heading_rad;
        let goal_rad = angle(self.goal - view.from());
        let axes = self.robot.sonars().iter().map(move |mount| heading_rad + mount.axis_rad);
        std::iter::once(goal_rad)
            .chain(axes)
            .filter(move |axis_rad| wrap_angle(axis_rad - goal_rad).abs() < FRAC_PI_2)
    }

    fn bends_along(
        &self,
        view: &Echoes<'_>,
        heading_rad: f64,
        floor: f64,
        mut found: impl FnMut(Vec2, f64),
    ) {
        let advance_m = self.settings.advance_m;
        let (direction, free_m) = (unit(heading_rad), view.free_m(heading_rad));
        let beside = self.beside(view.from(), direction, free_m, &[view]);
        let mut reinforcement = 0.0;
        for step in (1..).take_while(|step| f64::from(*step) * advance_m <= free_m) {
            let place = view.from() + direction * (f64::from(step) * advance_m);
            let midway = place - direction * (advance_m / 2.0);
            let Some(paid) = self.step_to(place, midway, heading_rad, &beside) else { return };
            reinforcement += paid;
            if reinforcement <= floor {
                return;
            }
            if step % EVERY == 0 {
                found(place, reinforcement);
            }
        }
    }

    /// Reinforcement of the second leg, when it is in view from its end and worth it.
    fn second_leg(
        &self,
        views: [&Echoes<'_>; 2],
        from: Vec2,
        to: Vec2,
        is_worth: impl Fn(f64) -> bool,
    ) -> Option<f64> {
        let way = to - from;
        let (length_m, back_rad) = (way.norm(), angle(-way));
        let in_view = length_m >= self.settings.advance_m && length_m <= views[1].free_m(back_rad);
        in_view.then(|| self.leg(from, to, &views, is_worth)).flatten()
    }

    /// About what Eq. (5.7) takes for driving straight: that of the middle, all the way. None when it
    /// takes all that may be paid.
    fn rough_cost(&self, from: Vec2, to: Vec2, most: f64) -> Option<f64> {
        let (way, ahead) = (to - from, self.goal - (from + to) / 2.0);
        let across = way.x * ahead.y - way.y * ahead.x;
        // sin ε ≤ ε spares most of the roots and inverse tangents; the margin is far above rounding.
        let bearable = (most + 1e-9) * PI * self.settings.advance_m;
        if across * across > bearable * bearable * ahead.norm_squared() {
            return None;
        }
        let error_rad = libm::atan2(across.abs(), way.dot(&ahead));
        let cost = -error_rad / PI * way.norm() / self.settings.advance_m;
        (most + cost > 0.0).then_some(cost)
    }
}

fn greatest_utility(ends: &[Candidate]) -> f64 {
    ends.iter().map(|end| end.utility).fold(f64::NEG_INFINITY, f64::max)
}
