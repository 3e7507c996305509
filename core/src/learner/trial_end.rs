//! What is learned when a trial ends: back-tracking, replacement, proposals, forgetting.

use super::memory::Waypoint;
use super::shortcut::Surveyor;
use super::{
    Aim, Change, LearnerSettings, MeanUpdate, Memory, NeuronId, Proposal, Replacement, Verdict,
    Withdrawal, annealing,
};
use crate::geometry::{Pose, Vec2};
use crate::robot::{Readings, Robot};

/// One step of the path, as remembered until the trial ends (section 5.9, Back Tracking).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PathStep {
    /// Network of the neuron in charge.
    pub(super) network: usize,
    /// `i(t)`.
    pub(super) neuron: NeuronId,
    /// `μ`, degrees, as stored.
    pub(super) mean_deg: f64,
    /// Where its mean points, if it aims along a shortcut (A1).
    pub(super) aim: Option<Aim>,
    /// Believed pose where it acted.
    pub(super) pose: Pose,
    /// What the sonars read there, metres.
    pub(super) sonar_m: Readings,
    /// `α(t)`, radians, in the action frame.
    pub(super) action_rad: f64,
    /// Direction of the action frame's zero in the odometry frame, radians.
    pub(super) frame_rad: f64,
    /// `r(t+1)`.
    pub(super) reinforcement: f64,
    /// Its safety part, Eq. (5.6).
    pub(super) safety: f64,
    /// Believed position after the step.
    pub(super) reached: Vec2,
    /// Unit vector away from the nearest obstacle after the step.
    pub(super) away: Vec2,
}

impl PathStep {
    /// Safety penalty paid, 0 to 1.
    pub(super) fn paid(&self) -> f64 {
        (-self.safety).clamp(0.0, 1.0)
    }
}

/// What changed at the end of a trial.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Changes {
    /// The trial set a record.
    pub(crate) record: bool,
    /// Eq. (5.26).
    pub(crate) backed_up: Vec<Change>,
    /// Eq. (5.28), radians.
    pub(crate) replaced: Vec<Change>,
    /// A1.
    pub(crate) proposed: Vec<Proposal>,
    /// A8.
    pub(crate) judged: Vec<Verdict>,
    /// D3.
    pub(crate) forgotten: Vec<NeuronId>,
    /// Eq. (5.25), or added.
    pub(crate) recentred: Vec<NeuronId>,
}

/// Closes a trial in memory.
pub(super) fn close(
    settings: &LearnerSettings,
    robot: &Robot,
    goal: Vec2,
    memory: &mut Memory,
    path: &[PathStep],
    born: &[(usize, NeuronId)],
    reached_goal: bool,
) -> Changes {
    // Eq. (5.27): R(n) = Σ_t r(t)
    let total: f64 = path.iter().map(|step| step.reinforcement).sum();
    let record = reached_goal && memory.best.is_none_or(|best| total > best);
    if reached_goal {
        memory.first_success.get_or_insert(memory.trials + 1);
    }
    let mut changes = Changes { record, ..Changes::default() };
    if record {
        memory.best = Some(total);
        changes.replaced = replace(settings, memory, path);
    }
    if reached_goal && settings.backtrack {
        changes.backed_up = back_up(memory, path);
    }
    if record && settings.mean_update == MeanUpdate::Shortcut {
        changes.proposed = propose(settings, robot, goal, memory, path);
    }
    if !record && settings.forget_unrecorded && memory.best.is_some() {
        changes.forgotten = forget(memory, born);
    }
    let trial = memory.trials + 1;
    let explored = annealing::effective(settings, memory.temperature_deg, trial) > 0.0;
    let judges = settings.shortcut_withdraw != Withdrawal::Off;
    if !record && judges && memory.best.is_some() && explored {
        changes.judged = judge(settings, memory, path, reached_goal);
    }
    for (network, id) in born {
        if let Some(neuron) = memory.networks[*network].get_mut(*id) {
            neuron.pending = false;
        }
    }
    changes
}

/// Steps in the order of replacement: what comes last stays.
fn replacement_order(settings: &LearnerSettings, steps: usize) -> Box<dyn Iterator<Item = usize>> {
    match settings.replacement {
        Replacement::Forward => Box::new(0..steps),
        Replacement::Backward => Box::new((0..steps).rev()),
        Replacement::Off => Box::new(std::iter::empty()),
    }
}

fn replace(settings: &LearnerSettings, memory: &mut Memory, path: &[PathStep]) -> Vec<Change> {
    let mut changes = Vec::new();
    if settings.replacement != Replacement::Off {
        memory.record = waypoints(path);
    }
    for t in replacement_order(settings, path.len()) {
        let step = &path[t];
        if let Some(neuron) = memory.networks[step.network].get_mut(step.neuron) {
            let before = neuron.prototypical_rad;
            // Eq. (5.28): p(i(t)) ← α(t)
            neuron.prototypical_rad = step.action_rad;
            note(&mut changes, step.neuron, before, step.action_rad);
        }
    }
    changes
}

/// D2, A8: what a new neuron goes back to, and what a shortcut is held against.
fn waypoints(path: &[PathStep]) -> Vec<Waypoint> {
    let mut to_go = 0.0;
    let waypoint = |step: &PathStep| {
        let Pose { x_m, y_m, .. } = step.pose;
        to_go += step.reinforcement;
        Waypoint { x_m, y_m, neuron: step.neuron, to_go }
    };
    let mut waypoints: Vec<Waypoint> = path.iter().rev().map(waypoint).collect();
    waypoints.reverse();
    waypoints
}

/// A1, after back-tracking: a neuron takes the proposal of its last visit.
fn propose(
    settings: &LearnerSettings,
    robot: &Robot,
    goal: Vec2,
    memory: &mut Memory,
    path: &[PathStep],
) -> Vec<Proposal> {
    let mut proposals: Vec<Proposal> = Vec::new();
    for (t, proposal) in Surveyor::new(settings, robot, goal, memory, path).survey() {
        let Some(neuron) = memory.networks[path[t].network].get_mut(proposal.neuron) else {
            continue;
        };
        neuron.mean_deg = proposal.after_deg;
        neuron.aim = Some(proposal.aim);
        match proposals.iter_mut().find(|earlier| earlier.neuron == proposal.neuron) {
            Some(earlier) => *earlier = proposal,
            None => proposals.push(proposal),
        }
    }
    proposals
}

/// NOTE (A8): the critic's promise of a shortcut is a guess, made before anybody went there. Of what was followed
/// in a trial that set no record, the next trial follows what cost less than the record path did between the same
/// two neurons, and no more what did not.
fn judge(
    settings: &LearnerSettings,
    memory: &mut Memory,
    path: &[PathStep],
    reached_goal: bool,
) -> Vec<Verdict> {
    let mut judged: Vec<Verdict> = Vec::new();
    for (t, step) in path.iter().enumerate() {
        let is_judged = judged.iter().any(|verdict| verdict.neuron == step.neuron);
        let network = &memory.networks[step.network];
        let neuron = network.get(step.neuron).filter(|neuron| neuron.aim == step.aim);
        let Some((aim, _)) = step.aim.zip(neuron).filter(|_| !is_judged) else { continue };
        let delta = delta_over(memory, &path[t..], aim, reached_goal);
        let gains = delta.is_some_and(|delta| delta > 0.0);
        let withdrawn = settings.shortcut_withdraw == Withdrawal::Followed || !gains;
        judged.push(Verdict { neuron: step.neuron, delta, withdrawn });
        if let Some(neuron) =
            memory.networks[step.network].get_mut(step.neuron).filter(|_| withdrawn)
        {
            neuron.aim = None;
            neuron.mean_deg = 0.0;
        }
    }
    judged
}

/// TD error over the way that a shortcut led, from the step that began it to the first at which another neuron of
/// the record path was in charge and did not merely let it pass (A3), or to the goal. The utilities are those of
/// the record trial. None when it led nowhere.
fn delta_over(memory: &Memory, path: &[PathStep], aim: Aim, reached_goal: bool) -> Option<f64> {
    let (begin, rest) = path.split_first()?;
    let before = memory.to_go(begin.neuron)?;
    let mut sum = begin.reinforcement;
    for step in rest {
        let same_way =
            step.aim.is_some_and(|other| other == aim || Some(other) == aim.after_bend());
        let there = Some(step.neuron).filter(|neuron| *neuron != begin.neuron && !same_way);
        if let Some(then) = there.and_then(|neuron| memory.to_go(neuron)) {
            // Eq. (5.19) over k steps, undiscounted as Eq. (5.26): δ = r(t+1) + ... + r(t+k) + u_j - u_i
            return Some(sum + then - before);
        }
        sum += step.reinforcement;
    }
    reached_goal.then_some(sum - before)
}

fn back_up(memory: &mut Memory, path: &[PathStep]) -> Vec<Change> {
    let mut changes = Vec::new();
    let mut to_goal = 0.0;
    for step in path.iter().rev() {
        // Eq. (5.26): u(i(t-1)) ← r(t) + u(i(t))
        to_goal += step.reinforcement;
        if let Some(neuron) = memory.networks[step.network].get_mut(step.neuron) {
            let before = neuron.utility;
            neuron.utility = to_goal;
            neuron.pending = false;
            note(&mut changes, step.neuron, before, to_goal);
        }
    }
    changes
}

/// NOTE (D3): the thesis keeps them; here neurons born in a trial that set no record are deleted, so
/// that they cannot win situations on the record path later.
fn forget(memory: &mut Memory, born: &[(usize, NeuronId)]) -> Vec<NeuronId> {
    let gone = |(network, id): &&(usize, NeuronId)| memory.networks[*network].forget(*id);
    born.iter().filter(gone).map(|(_, id)| *id).collect()
}

/// Remembers a change, once a neuron: the first "before" and the last "after".
fn note(changes: &mut Vec<Change>, neuron: NeuronId, before: f64, after: f64) {
    match changes.iter_mut().find(|change| change.neuron == neuron) {
        Some(change) => change.after = after,
        None => changes.push(Change { neuron, before, after }),
    }
}
