//! The classes of bias of section 4.3, switched on for an experiment.

use crate::tabular::{
    Advisor, AdvisorRule, AnyWorld, Reflex, Shaping, Subgoals, WalkError, WalkSetup, World,
};

use super::contest::Entrant;

/// Which biases compete, and how strong they are.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Biases {
    pub(super) reflex: Option<(f64, f64)>,
    pub(super) advice: bool,
    pub(super) heterogeneous: Option<(f64, f64)>,
    pub(super) progress: Option<f64>,
    pub(super) modules: bool,
    pub(super) advisor: AdvisorRule,
}

/// A bias that this world does not offer.
fn missing(what: &'static str, setting: &'static str) -> WalkError {
    WalkError::NoKnowledge { what, setting }
}

impl Biases {
    /// One entrant for each bias that is on, compared with the entrant number `reference`.
    pub(super) fn entrants(
        &self,
        base: &WalkSetup,
        advice: &str,
        reference: usize,
    ) -> Result<Vec<Entrant>, WalkError> {
        let mut entrants = Vec::new();
        let mut add = |name: &str, setup: WalkSetup| {
            entrants.push(Entrant { name: name.to_owned(), setup, training: None, reference });
        };
        let base = WalkSetup { advisor: self.advisor, ..base.clone() };
        if let Some((strength, half_life)) = self.reflex {
            let reflex = Some(reflex(&base.world, strength, half_life)?);
            add("reflex", WalkSetup { reflex, ..base.clone() });
        }
        if self.advice {
            Advisor::new(advice, self.advisor, base.world.as_ref(), 1)?;
            add("advice", WalkSetup { advice: advice.to_owned(), ..base.clone() });
        }
        if let Some((reward, bump)) = self.heterogeneous {
            let subgoals = Some(subgoals(&base.world, reward, bump)?);
            let shaping = Shaping { subgoals, ..Shaping::default() };
            add("heterogeneous reward", WalkSetup { shaping, ..base.clone() });
        }
        if let Some(reward) = self.progress {
            let estimate = base.world.knowledge().estimate.clone();
            if estimate.is_empty() {
                return Err(missing("an estimate of the way to the goal", "bias.progress"));
            }
            let shaping = Shaping { progress: Some((estimate, reward)), ..Shaping::default() };
            add("progress estimator", WalkSetup { shaping, ..base.clone() });
        }
        if self.modules {
            add("modules", WalkSetup { modules: true, ..base.clone() });
        }
        Ok(entrants)
    }
}

fn reflex(world: &AnyWorld, strength: f64, half_life: f64) -> Result<Reflex, WalkError> {
    let actions = world.knowledge().reflex.clone();
    if actions.is_empty() {
        Err(missing("a reflex", "bias.reflex"))
    } else {
        Ok(Reflex { actions, strength, half_life })
    }
}

fn subgoals(world: &AnyWorld, reward: f64, bump: f64) -> Result<Subgoals, WalkError> {
    let states = world.knowledge().subgoals.clone();
    if states.is_empty() {
        Err(missing("subgoals", "bias.heterogeneous"))
    } else {
        Ok(Subgoals { states, reward, bump })
    }
}
