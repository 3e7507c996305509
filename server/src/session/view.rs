//! What the core says, as it travels: radians become degrees, indices become names.

use sonarium_core::control::ReflexTrace;
use sonarium_core::experiment::NeuronRef;
use sonarium_core::geometry::{Pose, wrap_angle};
use sonarium_core::learner::{
    ActionSource, Adaptation, Aim, Birth, BirthCause, Change, Exploration, Guide, NeuronId, Origin,
    Outcome, Proposal, Tick, TrialEnd, TrialRecord, Update, Verdict, Winner,
};
use sonarium_core::perception::Fix;
use sonarium_core::robot::Contact;

use crate::wire::{
    AdaptationView, AimView, BirthView, ChangeView, ExplorationView, FixView, NeuronView,
    OutcomeView, PoseView, ProposalView, ReflexView, TickView, Trial, TrialEndView, VerdictView,
    WinnerView,
};

/// The names a session's indices stand for.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Names {
    /// The regions, in the world's order.
    pub regions: Vec<String>,
    /// There is one network for the whole world, the setting `learner.regions`.
    pub one_network: bool,
    /// Frame of prototypical actions, the setting `learner.action_frame`.
    pub action_frame: String,
}

impl Names {
    /// A region's name.
    #[must_use]
    pub fn region(&self, index: usize) -> String {
        self.regions.get(index).cloned().unwrap_or_else(|| format!("region {}", index + 1))
    }

    /// Name of the region whose network this is.
    fn network(&self, index: usize) -> String {
        if self.one_network { "all".to_owned() } else { self.region(index) }
    }

    /// One control step.
    #[must_use]
    pub fn tick(&self, tick: &Tick) -> TickView {
        let decision = &tick.decision;
        TickView {
            tick: tick.tick,
            trial: tick.trial,
            step: tick.step,
            true_pose: tick.true_pose.into(),
            pose: tick.pose.into(),
            fix: tick.fix.as_ref().map(FixView::from),
            sonar_m: tick.sonar_m.to_vec(),
            reflectance_pct: tick.reflectance_pct,
            goal_distance_m: decision.goal_distance_m,
            goal_bearing_deg: decision.goal_bearing_rad.to_degrees(),
            region: self.region(tick.region),
            winner: decision.winner.map(WinnerView::from),
            born: number(decision.born),
            toward_m: decision.origin.and_then(toward_m).or(decision.guide.and_then(pursued_m)),
            reflex: decision.reflex.as_ref().map(ReflexView::from),
            adaptation: decision.adaptation.into(),
            neuron: number(decision.neuron),
            prototypical_deg: decision.prototypical_rad.to_degrees(),
            utility: decision.utility,
            aim: decision.aim.as_ref().map(AimView::from),
            exploration: decision.exploration.into(),
            source: source(decision.source).to_owned(),
            action_deg: decision.action_rad.to_degrees(),
            action_frame: self.action_frame.clone(),
            rotation_deg: decision.rotation_rad.to_degrees(),
            outcome: (&tick.outcome).into(),
            neurons: count(tick.neurons),
            total_reinforcement: tick.total_reinforcement,
        }
    }

    /// A neuron without its centre, as viewers get it.
    #[must_use]
    pub fn neuron(&self, neuron: &NeuronRef<'_>) -> NeuronView {
        NeuronView {
            id: neuron.id.0,
            region: self.network(neuron.region),
            centre: Vec::new(),
            prototypical_deg: neuron.prototypical_rad.to_degrees(),
            heading_deg: wrap_angle(neuron.heading_rad).to_degrees(),
            mean_deg: neuron.mean_deg,
            utility: neuron.utility,
            wins: neuron.wins,
            birth: neuron.birth.into(),
        }
    }

    /// A neuron with its centre.
    #[must_use]
    pub fn whole_neuron(&self, neuron: &NeuronRef<'_>) -> NeuronView {
        NeuronView { centre: neuron.centre.to_vec(), ..self.neuron(neuron) }
    }

    /// A trial's row.
    #[must_use]
    pub fn trial(&self, record: &TrialRecord) -> Trial {
        let regions = record.region_steps.iter().enumerate();
        Trial {
            trial: record.trial,
            steps: record.steps,
            total_reinforcement: record.total_reinforcement,
            safety: record.safety,
            goal: record.goal,
            true_goal: Some(record.true_goal),
            neurons: count(record.neurons),
            born: record.born,
            forgotten: record.forgotten,
            collisions: record.collisions,
            reached_goal: record.reached_goal,
            record: record.record,
            scout: record.scout,
            temperature_deg: record.temperature_deg,
            path_m: record.path_m,
            regret: None,
            region_steps: regions.map(|(index, steps)| (self.region(index), *steps)).collect(),
            first_tick: record.first_tick,
            last_tick: record.last_tick,
        }
    }

    /// What the learner did at a trial's end.
    #[must_use]
    pub fn trial_end<'a>(
        &self,
        end: &TrialEnd,
        neurons: impl Iterator<Item = NeuronRef<'a>>,
    ) -> TrialEndView {
        TrialEndView {
            trial: self.trial(&end.record),
            backed_up: end.backed_up.iter().map(ChangeView::from).collect(),
            replaced: end.replaced.iter().map(in_degrees).collect(),
            proposed: end.proposed.iter().map(ProposalView::from).collect(),
            judged: end.judged.iter().map(VerdictView::from).collect(),
            forgotten: end.forgotten.iter().map(|id| id.0).collect(),
            neurons: neurons.map(|neuron| self.neuron_after(end, &neuron)).collect(),
        }
    }

    /// A neuron as the log keeps it: its centre stands where the trial set or moved it, so that a
    /// long log does not repeat what has not changed.
    fn neuron_after(&self, end: &TrialEnd, neuron: &NeuronRef<'_>) -> NeuronView {
        match end.recentred.binary_search(&neuron.id) {
            Ok(_) => self.whole_neuron(neuron),
            Err(_) => self.neuron(neuron),
        }
    }
}

fn number(id: Option<NeuronId>) -> Option<u32> {
    id.map(|id| id.0)
}

fn count(neurons: usize) -> u32 {
    u32::try_from(neurons).unwrap_or(u32::MAX)
}

fn source(source: ActionSource) -> &'static str {
    match source {
        ActionSource::Network => "network",
        ActionSource::Reflex => "reflex",
        ActionSource::Bend => "bend",
        ActionSource::Pursuit => "pursuit",
        ActionSource::Sidestep => "sidestep",
        ActionSource::Escape => "escape",
        ActionSource::Scout => "scout",
    }
}

fn in_degrees(change: &Change) -> ChangeView {
    ChangeView {
        neuron: change.neuron.0,
        before: change.before.to_degrees(),
        after: change.after.to_degrees(),
    }
}

impl From<Pose> for PoseView {
    fn from(pose: Pose) -> Self {
        Self { x_m: pose.x_m, y_m: pose.y_m, heading_deg: pose.heading_rad.to_degrees() }
    }
}

impl From<Winner> for WinnerView {
    fn from(winner: Winner) -> Self {
        Self { neuron: winner.neuron.0, distance: winner.distance }
    }
}

impl From<&ReflexTrace> for ReflexView {
    fn from(trace: &ReflexTrace) -> Self {
        Self {
            nearest_m: trace.nearest_m,
            near: trace.near,
            avoid: trace.avoid,
            goal: trace.goal,
            fused: trace.fused,
            rotation_deg: trace.rotation_rad.to_degrees(),
        }
    }
}

impl From<Exploration> for ExplorationView {
    fn from(unit: Exploration) -> Self {
        Self {
            temperature_deg: unit.temperature_deg,
            mean_deg: unit.mean_deg,
            sigma_deg: unit.sigma_deg,
            deviation_deg: unit.deviation_deg,
            drawn_deg: unit.drawn_deg,
            most_deg: Some(unit.most_deg),
            xi_deg: unit.xi_deg,
        }
    }
}

impl From<Adaptation> for AdaptationView {
    fn from(adaptation: Adaptation) -> Self {
        match adaptation {
            Adaptation::NoPast => Self::NoPast,
            Adaptation::Off => Self::Off,
            Adaptation::Pending { past } => Self::Pending { past: past.0 },
            Adaptation::Split { past, delta, added } => {
                Self::Split { past: past.0, delta, added: added.0 }
            }
            Adaptation::Updated(update) => update.into(),
        }
    }
}

impl From<Update> for AdaptationView {
    fn from(update: Update) -> Self {
        Self::Updated {
            past: update.past.0,
            reinforcement: update.reinforcement,
            present_utility: update.present_utility,
            utility_before: update.utility_before,
            delta: update.delta,
            utility_rate: update.utility_rate,
            utility_after: update.utility_after,
            eligibility: update.eligibility,
            mean_before_deg: update.mean_before_deg,
            mean_after_deg: update.mean_after_deg,
            centre_shift: update.centre_shift,
        }
    }
}

impl From<&Outcome> for OutcomeView {
    fn from(outcome: &Outcome) -> Self {
        let contact = match outcome.contact {
            Contact::None => "none",
            Contact::Virtual => "virtual",
            Contact::Real => "real",
        };
        Self {
            true_pose: outcome.true_pose.into(),
            pose: outcome.pose.into(),
            contact: contact.to_owned(),
            backed_m: outcome.backed_m,
            reinforcement: outcome.reinforcement.total(),
            safety: outcome.reinforcement.safety,
            goal: outcome.reinforcement.goal,
            close: outcome.reinforcement.close,
            reached_goal: outcome.reached_goal,
        }
    }
}

impl From<&Birth> for BirthView {
    fn from(birth: &Birth) -> Self {
        let (cause, value) = match birth.cause {
            BirthCause::Empty => ("empty", None),
            BirthCause::Distance { distance } => ("distance", Some(distance)),
            BirthCause::Error { delta } => ("error", Some(delta)),
        };
        let parent = match birth.origin {
            Origin::Reflex | Origin::Pursuit { .. } => None,
            Origin::Inherited { parent } => Some(parent.0),
        };
        Self {
            trial: birth.trial,
            step: birth.step,
            tick: birth.tick,
            cause: cause.to_owned(),
            value,
            parent,
            toward_m: toward_m(birth.origin),
            pose: birth.pose.into(),
        }
    }
}

/// The place of the record path that the first action of a neuron makes for.
fn toward_m(origin: Origin) -> Option<[f64; 2]> {
    match origin {
        Origin::Pursuit { x_m, y_m } => Some([x_m, y_m]),
        Origin::Reflex | Origin::Inherited { .. } => None,
    }
}

/// The place of the record path that a neuron makes for which is not of it.
fn pursued_m(guide: Guide) -> Option<[f64; 2]> {
    (guide.source == ActionSource::Pursuit).then_some([guide.place.x, guide.place.y])
}

impl From<&Fix> for FixView {
    fn from(fix: &Fix) -> Self {
        Self { odometry: fix.odometry.into(), echoes: fix.echoes, spread_m: fix.spread_m }
    }
}

impl From<&Aim> for AimView {
    fn from(aim: &Aim) -> Self {
        let beyond_m = aim.after_bend().map(|end| [end.x_m, end.y_m]);
        let then = number(aim.then.map(|(_, neuron)| neuron));
        Self { x_m: aim.x_m, y_m: aim.y_m, beyond_m, then }
    }
}

impl From<&Verdict> for VerdictView {
    fn from(verdict: &Verdict) -> Self {
        let Verdict { neuron, delta, withdrawn } = *verdict;
        Self { neuron: neuron.0, delta, withdrawn }
    }
}

impl From<&Proposal> for ProposalView {
    fn from(proposal: &Proposal) -> Self {
        Self {
            neuron: proposal.neuron.0,
            before: proposal.before_deg,
            after: proposal.after_deg,
            aim: (&proposal.aim).into(),
            step: proposal.step,
            straight: proposal.straight,
            utility: proposal.utility,
        }
    }
}

impl From<&Change> for ChangeView {
    fn from(change: &Change) -> Self {
        Self { neuron: change.neuron.0, before: change.before, after: change.after }
    }
}

#[cfg(test)]
mod tests {
    use sonarium_core::learner::Beyond;

    use super::*;

    #[test]
    fn an_aim_tells_both_legs_of_a_way_that_bends() {
        let straight = Aim { x_m: 2.0, y_m: -1.0, beyond: None, then: Some((1, NeuronId(40))) };
        let expected = AimView { x_m: 2.0, y_m: -1.0, beyond_m: None, then: Some(40) };
        assert_eq!(AimView::from(&straight), expected);
        let bent = Aim { beyond: Some(Beyond { x_m: 4.0, y_m: 0.5 }), ..straight };
        assert_eq!(AimView::from(&bent), AimView { beyond_m: Some([4.0, 0.5]), ..expected });
    }
}
