//! Rule bases: named sets over inputs, and one rule for each combination of them, Eq. (2.25).
//!
//! A rule base is readable text ([`RuleBase::parse`]), checked when it is read: every value of every
//! input belongs to some set and every combination of sets has exactly one rule. Consequents are
//! numbers (Sugeno, Algorithm 2) or sets of the output (Mamdani). [`RuleBase::evaluate`] visits only
//! the rules that fire; [`RuleBase::explain`] also says which they are.

mod error;
mod fll;
mod grid;
mod print;
mod read;
#[cfg(test)]
mod tests;

pub use error::RuleError;

use super::{Defuzzifier, Inference, Norms, Set, Shape};
use grid::Grid;

/// Most inputs of a rule base.
pub const MOST_INPUTS: usize = 6;
/// Most outputs.
pub const MOST_OUTPUTS: usize = 2;
/// Most sets of one variable.
pub const MOST_SETS: usize = 8;

/// A set with its name.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedSet {
    /// Its linguistic value, e.g. `safe`.
    pub name: String,
    /// What it means.
    pub set: Set,
}

/// A process state variable.
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    /// Its name.
    pub name: String,
    /// Its unit, `-` for none.
    pub unit: String,
    /// Least and greatest value; what lies beyond counts as the bound.
    pub range: [f64; 2],
    /// The linguistic values it can take.
    pub sets: Vec<NamedSet>,
}

/// A control output variable.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// Its name.
    pub name: String,
    /// Its unit, `-` for none.
    pub unit: String,
    /// Least and greatest value.
    pub range: [f64; 2],
    /// Sets that rules conclude (Mamdani); none where they conclude numbers (Sugeno).
    pub sets: Vec<NamedSet>,
}

/// What a rule concludes about one output.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Consequent {
    /// A value, in the output's unit.
    Value(f64),
    /// A set of the output, by number.
    Set(usize),
}

/// One rule.
#[derive(Clone, Debug, PartialEq)]
pub struct Rule {
    /// The set of each input, by number.
    pub when: Vec<usize>,
    /// What it concludes about each output.
    pub then: Vec<Consequent>,
    /// Why, e.g. the principle that gave each consequent; may be empty.
    pub because: String,
}

/// A rule and how strongly it fires.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Firing {
    /// The rule, by number.
    pub rule: usize,
    /// Its strength `r_i`, Eq. (2.26).
    pub strength: f64,
}

/// An inference with everything on the way.
#[derive(Clone, Debug, PartialEq)]
pub struct Explained {
    /// Membership of each input in each of its sets, input after input, Eq. (2.20).
    pub memberships: Vec<f64>,
    /// The rules that fire, the strongest first, of equals the first.
    pub firings: Vec<Firing>,
    /// Each output, in its unit; 0 beyond the outputs there are.
    pub outputs: [f64; MOST_OUTPUTS],
}

/// A checked rule base.
#[derive(Clone, Debug, PartialEq)]
pub struct RuleBase {
    name: String,
    title: String,
    norms: Norms,
    defuzzifier: Defuzzifier,
    inputs: Vec<Input>,
    outputs: Vec<Output>,
    /// In the order of the combinations, the last input's sets changing fastest.
    rules: Vec<Rule>,
    /// The fast path, where there is one.
    grid: Option<Grid>,
}

/// The sets of one input that a value belongs to, with the degrees.
#[derive(Clone, Copy)]
struct Active {
    sets: [(usize, f64); MOST_SETS],
    count: usize,
}

impl RuleBase {
    /// A rule base from its parts, checked.
    ///
    /// # Errors
    /// The first thing wrong; it has no line, since there is no text.
    pub fn new(
        name: String,
        title: String,
        norms: Norms,
        defuzzifier: Defuzzifier,
        inputs: Vec<Input>,
        outputs: Vec<Output>,
        rules: Vec<Rule>,
    ) -> Result<Self, RuleError> {
        let base = Self { name, title, norms, defuzzifier, inputs, outputs, rules, grid: None };
        Self::parse(&base.to_text()).map_err(|error| RuleError { line: None, ..error })
    }

    /// Name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Title for people.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.title
    }

    /// How degrees are joined.
    #[must_use]
    pub fn norms(&self) -> Norms {
        self.norms
    }

    /// How an output area becomes a number (Mamdani).
    #[must_use]
    pub fn defuzzifier(&self) -> Defuzzifier {
        self.defuzzifier
    }

    /// The inputs.
    #[must_use]
    pub fn inputs(&self) -> &[Input] {
        &self.inputs
    }

    /// The outputs.
    #[must_use]
    pub fn outputs(&self) -> &[Output] {
        &self.outputs
    }

    /// The rules, one for each combination of sets, the last input's sets changing fastest.
    #[must_use]
    pub fn rules(&self) -> &[Rule] {
        &self.rules
    }

    /// The outputs for one value an input, in their units; 0 beyond the outputs there are. What is not
    /// a number gives none.
    ///
    /// # Panics
    /// When there are fewer values than inputs.
    #[must_use]
    pub fn evaluate(&self, inputs: &[f64]) -> [f64; MOST_OUTPUTS] {
        match &self.grid {
            Some(grid) => grid.evaluate_some(&inputs[..self.inputs.len()]),
            None => self.infer(inputs, |_| ()),
        }
    }

    /// The same for many, as fast as the processor can; each has a value for each of [`MOST_INPUTS`]
    /// inputs, those beyond the inputs there are being ignored.
    ///
    /// # Panics
    /// When there are not as many outputs as inputs.
    pub fn evaluate_each(
        &self,
        inputs: &[[f64; MOST_INPUTS]],
        outputs: &mut [[f64; MOST_OUTPUTS]],
    ) {
        assert_eq!(inputs.len(), outputs.len(), "one output for each input");
        match &self.grid {
            Some(grid) => grid.evaluate_each(inputs, outputs),
            None => {
                for (input, output) in inputs.iter().zip(outputs) {
                    *output = self.infer(input, |_| ());
                }
            }
        }
    }

    /// An inference with the memberships and the rules that fire.
    ///
    /// # Panics
    /// When there are fewer values than inputs.
    #[must_use]
    pub fn explain(&self, inputs: &[f64]) -> Explained {
        let mut firings = Vec::new();
        let outputs = self.infer(inputs, |firing| firings.push(firing));
        firings
            .sort_by(|a: &Firing, b| b.strength.total_cmp(&a.strength).then(a.rule.cmp(&b.rule)));
        Explained { memberships: self.memberships(inputs), firings, outputs }
    }

    /// Eq. (2.20): membership of each input in each of its sets, input after input.
    fn memberships(&self, inputs: &[f64]) -> Vec<f64> {
        let each = self.inputs.iter().zip(inputs);
        each.flat_map(|(input, value)| {
            let value = input.clamped(*value);
            input.sets.iter().map(move |named| named.set.membership(value))
        })
        .collect()
    }

    /// Fires the rules whose sets are all active, telling of each.
    fn infer(&self, inputs: &[f64], mut tell: impl FnMut(Firing)) -> [f64; MOST_OUTPUTS] {
        if inputs[..self.inputs.len()].iter().any(|value| value.is_nan()) {
            return [f64::NAN; MOST_OUTPUTS];
        }
        let active = self.active(inputs);
        let mut sum = Sum::new(self);
        let mut at = [0; MOST_INPUTS];
        'rules: loop {
            let (mut rule, mut strength) = (0, 1.0);
            for (input, active) in active.iter().enumerate().take(self.inputs.len()) {
                let (set, degree) = active.sets[at[input]];
                rule = rule * self.inputs[input].sets.len() + set;
                // Eq. (2.26): r_i = Π_j μ_ij(u_j), or the least of them
                strength = self.norms.and(strength, degree);
            }
            sum.add(&self.rules[rule], strength);
            tell(Firing { rule, strength });
            for input in (0..self.inputs.len()).rev() {
                at[input] += 1;
                if at[input] < active[input].count {
                    continue 'rules;
                }
                at[input] = 0;
            }
            return sum.outputs();
        }
    }

    /// The active sets of each input: at least one, as was checked.
    fn active(&self, inputs: &[f64]) -> [Active; MOST_INPUTS] {
        let mut each = [Active { sets: [(0, 0.0); MOST_SETS], count: 0 }; MOST_INPUTS];
        for ((input, value), active) in self.inputs.iter().zip(inputs).zip(&mut each) {
            let value = input.clamped(*value);
            for (index, named) in input.sets.iter().enumerate() {
                let degree = named.set.membership(value);
                if degree > 0.0 {
                    active.sets[active.count] = (index, degree);
                    active.count += 1;
                }
            }
        }
        each
    }
}

impl Input {
    fn clamped(&self, value: f64) -> f64 {
        value.clamp(self.range[0], self.range[1])
    }
}

/// What the rules that fired so far add up to.
struct Sum<'a> {
    base: &'a RuleBase,
    weight: f64,
    moments: [f64; MOST_OUTPUTS],
    /// Activation of each set of each output (Mamdani).
    activations: [[f64; MOST_SETS]; MOST_OUTPUTS],
}

impl<'a> Sum<'a> {
    fn new(base: &'a RuleBase) -> Self {
        let activations = [[0.0; MOST_SETS]; MOST_OUTPUTS];
        Self { base, weight: 0.0, moments: [0.0; MOST_OUTPUTS], activations }
    }

    fn add(&mut self, rule: &Rule, strength: f64) {
        self.weight += strength;
        for (output, consequent) in rule.then.iter().enumerate() {
            match *consequent {
                Consequent::Value(value) => self.moments[output] += strength * value,
                Consequent::Set(set) => {
                    let activation = &mut self.activations[output][set];
                    *activation = self.base.norms.or(*activation, strength);
                }
            }
        }
    }

    fn outputs(&self) -> [f64; MOST_OUTPUTS] {
        let mut outputs = [0.0; MOST_OUTPUTS];
        for (index, output) in self.base.outputs.iter().enumerate() {
            outputs[index] = if output.sets.is_empty() {
                // Algorithm 2: b_l = (Σ r_i)⁻¹ Σ r_i b_il
                self.moments[index] / self.weight
            } else {
                let sets: Vec<Set> = output.sets.iter().map(|named| named.set).collect();
                let activations = &self.activations[index][..sets.len()];
                let value = self.base.defuzzifier.value(self.inference(), &sets, activations);
                value.unwrap_or(f64::NAN)
            };
        }
        outputs
    }

    /// Sets are clipped with Zadeh's norms and scaled with the algebraic ones.
    fn inference(&self) -> Inference {
        match self.base.norms {
            Norms::Zadeh => Inference::MinMax,
            Norms::Algebraic => Inference::ProductSum,
        }
    }
}
