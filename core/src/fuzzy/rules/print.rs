//! A rule base as text, in the form that [`RuleBase::parse`] reads.

use std::fmt::{Display, Write as _};

use super::{Consequent, NamedSet, Rule, RuleBase, Set};
use crate::settings::Field;

impl RuleBase {
    /// The text of the rule base: reading it gives the same base again.
    #[must_use]
    pub fn to_text(&self) -> String {
        let mut text = String::new();
        line(&mut text, format_args!("rules {}", self.name));
        line(&mut text, format_args!("title {}", self.title));
        line(&mut text, format_args!("norms {}", self.norms.to_value()));
        line(&mut text, format_args!("defuzzifier {}", self.defuzzifier.to_value()));
        for input in &self.inputs {
            variable(&mut text, "input", [&input.name, &input.unit], input.range, &input.sets);
        }
        for output in &self.outputs {
            variable(&mut text, "output", [&output.name, &output.unit], output.range, &output.sets);
        }
        let names = self.inputs.iter().map(|input| input.name.as_str());
        let outputs = self.outputs.iter().map(|output| output.name.as_str());
        line(&mut text, format_args!("\ntable {} -> {}", joined(names), joined(outputs)));
        for rule in &self.rules {
            line(&mut text, format_args!("{}", self.rule_text(rule)));
        }
        text
    }

    /// One rule as a line of the table.
    #[must_use]
    pub fn rule_text(&self, rule: &Rule) -> String {
        let sets = self.inputs.iter().zip(&rule.when);
        let when = sets.map(|(input, &set)| input.sets[set].name.clone());
        let outputs = self.outputs.iter().zip(&rule.then);
        let then = outputs.map(|(output, consequent)| match *consequent {
            Consequent::Value(value) => value.to_string(),
            Consequent::Set(set) => output.sets[set].name.clone(),
        });
        let because =
            if rule.because.is_empty() { String::new() } else { format!(" | {}", rule.because) };
        format!("{} -> {}{because}", joined(when), joined(then))
    }
}

fn line(text: &mut String, content: std::fmt::Arguments) {
    writeln!(text, "{content}").expect("a string takes any text");
}

fn joined<S: Display>(words: impl Iterator<Item = S>) -> String {
    words.map(|word| word.to_string()).collect::<Vec<_>>().join(" ")
}

fn variable(
    text: &mut String,
    kind: &str,
    [name, unit]: [&String; 2],
    range: [f64; 2],
    sets: &[NamedSet],
) {
    line(text, format_args!("\n{kind} {name} {unit} {} {}", range[0], range[1]));
    for NamedSet { name, set } in sets {
        let form = match set {
            Set::Trapezoid(t) => format!("trapezoid {} {} {} {}", t.left, t.from, t.to, t.right),
            Set::Triangle(t) => format!("triangle {} {} {}", t.left, t.peak, t.right),
            Set::Singleton(at) => format!("singleton {at}"),
        };
        line(text, format_args!("  {name} {form}"));
    }
}
