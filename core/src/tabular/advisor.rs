//! Advice at work: weighed against experience, refined, and discarded, section 4.3.
//!
//! A rule that holds to the degree μ in state x pulls its action by `c μ k/(k + n)` log-odds, where n is
//! how often the action was tried in x: experience gives way to advice first, and advice to experience then.
//! After each trial the agent compares the way to the goal after it followed a rule with the way after it
//! did not; c rises or falls with the outcome, and a rule that has lost most of its weight is discarded.
//!
//! NOTE: the thesis describes advice as rules made into a neural network (figure 4.3) and takes none of it
//! into its experiments. A table has no units to add to; the pull on the chances takes their place.

use serde::{Deserialize, Serialize};

use super::{Knowledge, World};
use crate::fuzzy::advice::{Advice, AdviceError, Conclusion, Vocabulary, parse};

/// Share of a new observation in the running means.
const RECENT: f64 = 0.1;
/// Degree from which on a rule counts as having spoken.
const SPOKEN: f64 = 0.5;
/// Greatest weight, in first weights.
const MOST: f64 = 2.0;
/// Share of its first weight below which a rule is discarded.
const DISCARDED: f64 = 0.1;

/// How advice is taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AdvisorRule {
    /// First weight c of a rule, log-odds.
    pub strength: f64,
    /// Trials of an action after which half of a pull is left, k.
    pub half_life: f64,
    /// Share by which the weight changes after a trial; 0 never changes it.
    pub refinement: f64,
    /// Observations of both kinds before a rule is judged.
    pub patience: u32,
}

impl Default for AdvisorRule {
    fn default() -> Self {
        Self { strength: 2.0, half_life: 10.0, refinement: 0.1, patience: 5 }
    }
}

/// What is known of one rule.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RuleRecord {
    /// As it was written.
    pub text: String,
    /// Weight c of the moment, log-odds; 0 once discarded.
    pub weight: f64,
    /// Decisions at which it spoke and was followed.
    pub followed: u32,
    /// Decisions at which it spoke and was not followed.
    pub ignored: u32,
    /// Mean way to the goal after following it, steps; recent trials count more.
    pub steps_followed: f64,
    /// The same after not following it.
    pub steps_ignored: f64,
    /// Trial in which it was given, from 1.
    pub given: u32,
    /// Trial after which it was discarded.
    pub discarded: Option<u32>,
}

/// All that must be kept of advice.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct AdvisorMemory {
    /// The text it was given as.
    pub text: String,
    /// One record a rule.
    pub rules: Vec<RuleRecord>,
}

/// Advice for one world.
#[derive(Clone, Debug, PartialEq)]
pub struct Advisor {
    rule: AdvisorRule,
    advice: Advice,
    /// Degree of each rule in each state.
    degrees: Vec<Vec<f64>>,
    memory: AdvisorMemory,
    /// Of this trial: rule, step, followed.
    spoken: Vec<(usize, u32, bool)>,
}

/// The words that advice for a world may use.
#[must_use]
pub fn vocabulary(knowledge: &Knowledge, actions: &[String]) -> Vocabulary {
    let terms = |feature: &super::Feature| {
        let terms = feature.terms.iter().map(|degrees| degrees.term.clone()).collect();
        (feature.name.clone(), terms)
    };
    Vocabulary {
        features: knowledge.features.iter().map(terms).collect(),
        actions: actions.to_vec(),
    }
}

impl Advisor {
    /// Reads advice given in a trial (from 1).
    ///
    /// # Errors
    /// At the first character that is wrong.
    pub fn new(
        text: &str,
        rule: AdvisorRule,
        world: &impl World,
        trial: u32,
    ) -> Result<Self, AdviceError> {
        let mut advisor = Self::read(text, rule, world)?;
        advisor.memory.text = text.to_owned();
        for written in &advisor.advice.rules {
            advisor.memory.rules.push(RuleRecord {
                text: written.text.clone(),
                weight: rule.strength,
                followed: 0,
                ignored: 0,
                steps_followed: 0.0,
                steps_ignored: 0.0,
                given: trial,
                discarded: None,
            });
        }
        Ok(advisor)
    }

    /// Goes on from what was kept.
    ///
    /// # Errors
    /// When the text that was kept is not read in this world.
    pub fn remember(
        memory: AdvisorMemory,
        rule: AdvisorRule,
        world: &impl World,
    ) -> Result<Self, AdviceError> {
        let read = Self::read(&memory.text, rule, world)?;
        Ok(Self { memory, ..read })
    }

    fn read(text: &str, rule: AdvisorRule, world: &impl World) -> Result<Self, AdviceError> {
        let knowledge = world.knowledge();
        let advice = parse(text, &vocabulary(knowledge, world.action_names()))?;
        let mut degrees = vec![Vec::new(); advice.rules.len()];
        for state in 0..world.mdp().states() {
            let known = |feature: usize, term: usize| {
                knowledge.features[feature].terms[term].degrees[state]
            };
            for (of_rule, degree) in degrees.iter_mut().zip(advice.degrees(known)) {
                of_rule.push(degree);
            }
        }
        let memory = AdvisorMemory::default();
        Ok(Self { rule, advice, degrees, memory, spoken: Vec::new() })
    }

    /// What must be kept of it.
    #[must_use]
    pub fn memory(&self) -> &AdvisorMemory {
        &self.memory
    }

    /// Degree of each rule in a state.
    pub fn degrees(&self, state: usize) -> impl Iterator<Item = f64> {
        self.degrees.iter().map(move |of_rule| of_rule[state])
    }

    /// Adds the pull of every rule on each action, log-odds; `tried` counts how often each was tried here.
    pub fn pull(&self, state: usize, tried: &[u32], pulls: &mut [f64]) {
        for (at, rule) in self.advice.rules.iter().enumerate() {
            let (action, sign) = match rule.conclusion {
                Conclusion::Do(action) => (action, 1.0),
                Conclusion::Avoid(action) => (action, -1.0),
                Conclusion::Make(_) => continue,
            };
            let fresh = self.rule.half_life / (self.rule.half_life + f64::from(tried[action]));
            pulls[action] += sign * self.memory.rules[at].weight * self.degrees[at][state] * fresh;
        }
    }

    /// Notes which rules spoke at a step, and whether they were followed.
    pub fn note(&mut self, state: usize, action: usize, step: u32) {
        for (at, rule) in self.advice.rules.iter().enumerate() {
            let followed = match rule.conclusion {
                Conclusion::Do(advised) => advised == action,
                Conclusion::Avoid(advised) => advised != action,
                Conclusion::Make(_) => continue,
            };
            if self.degrees[at][state] >= SPOKEN && self.memory.rules[at].discarded.is_none() {
                self.spoken.push((at, step, followed));
            }
        }
    }

    /// Judges the rules by a trial of so many steps (trial from 1).
    pub fn end_trial(&mut self, steps: u32, trial: u32) {
        for (at, step, followed) in self.spoken.drain(..) {
            let record = &mut self.memory.rules[at];
            let (count, mean) = if followed {
                (&mut record.followed, &mut record.steps_followed)
            } else {
                (&mut record.ignored, &mut record.steps_ignored)
            };
            *count += 1;
            let left = f64::from(steps - step);
            *mean += RECENT.max(1.0 / f64::from(*count)) * (left - *mean);
        }
        for record in &mut self.memory.rules {
            judge(record, &self.rule, trial);
        }
    }
}

fn judge(record: &mut RuleRecord, rule: &AdvisorRule, trial: u32) {
    if record.discarded.is_some() || record.followed.min(record.ignored) < rule.patience {
        return;
    }
    let helps = record.steps_followed < record.steps_ignored;
    record.weight *= if helps { 1.0 + rule.refinement } else { 1.0 - rule.refinement };
    record.weight = record.weight.min(MOST * rule.strength);
    if record.weight < DISCARDED * rule.strength {
        record.weight = 0.0;
        record.discarded = Some(trial);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::labyrinth::Labyrinth;

    const RULE: AdvisorRule =
        AdvisorRule { strength: 2.0, half_life: 4.0, refinement: 0.1, patience: 5 };

    #[test]
    fn a_pull_is_weighed_by_degree_and_experience() {
        let world = Labyrinth::of_the_thesis();
        let text = "if wall is ahead then not forward\nif goal is ahead then forward";
        let advisor = Advisor::new(text, RULE, &world, 1).expect("good");
        // State 0 looks north, against the wall; state 5 looks east, along the corridor to the goal.
        for (state, tried, expected) in [
            (0, [0, 0, 0], [0.0, -2.0, 0.0]),
            (0, [9, 4, 9], [0.0, -1.0, 0.0]),
            (5, [0, 0, 0], [0.0, 2.0, 0.0]),
        ] {
            let mut pulls = [0.0; 3];
            advisor.pull(state, &tried, &mut pulls);
            assert_eq!(pulls, expected, "state {state}, tried {tried:?}");
        }
    }

    #[test]
    fn bad_advice_is_discarded_and_good_advice_kept() {
        let world = Labyrinth::of_the_thesis();
        let text = "if wall is ahead then left";
        for (followed_steps, ignored_steps, kept) in [(30, 10, false), (10, 30, true)] {
            let mut advisor = Advisor::new(text, RULE, &world, 1).expect("good");
            for trial in 1..=60 {
                let follows = trial % 2 == 0;
                advisor.note(0, if follows { 0 } else { 2 }, 0);
                advisor.end_trial(if follows { followed_steps } else { ignored_steps }, trial);
            }
            let record = &advisor.memory().rules[0];
            assert_eq!(
                (record.discarded.is_none(), record.weight > 0.0),
                (kept, kept),
                "{record:?}"
            );
            if kept {
                assert!((record.weight - 4.0).abs() < 1e-12, "no more than twice its first weight");
                assert!((record.steps_followed - 10.0).abs() < 1e-9);
            }
        }
    }
}
