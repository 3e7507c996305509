//! A language for advice: if-then rules over fuzzy terms, section 4.3 and table 4.1.
//!
//! ```text
//! # the fuzzy terms are those of the world's features
//! if goal is near and wall is not north then north
//! if goal (far && west) or not wall (west) then move west
//! if goal is near and goal is east then let almost_there
//! if almost_there then not west
//! ```
//!
//! `and` is the least, `or` the greatest and `not` the complement of degrees (section 2.6); `&&`, `||` and
//! `!` mean the same. `not ACTION` advises against an action; `let NAME` makes a new term.

mod lexer;
mod parser;

use super::Norms;

pub use parser::parse;

/// Most characters of a text of advice.
pub const MOST_CHARACTERS: usize = 10_000;
/// Most rules.
pub const MOST_RULES: usize = 100;
/// Deepest nesting of a condition.
pub const DEEPEST: usize = 50;

/// What advice may speak of.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Vocabulary {
    /// Features, each with its terms.
    pub features: Vec<(String, Vec<String>)>,
    /// Actions.
    pub actions: Vec<String>,
}

/// When a rule holds.
#[derive(Clone, Debug, PartialEq)]
pub enum Condition {
    /// A term of a feature, by their numbers in the vocabulary.
    Term {
        /// The feature.
        feature: usize,
        /// Its term.
        term: usize,
    },
    /// A term that an earlier rule made, by its number.
    Made(usize),
    /// Complement.
    Not(Box<Condition>),
    /// Least of both.
    And(Box<Condition>, Box<Condition>),
    /// Greatest of both.
    Or(Box<Condition>, Box<Condition>),
}

/// What a rule says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Conclusion {
    /// Take this action.
    Do(usize),
    /// Do not take this action.
    Avoid(usize),
    /// This new term holds.
    Make(usize),
}

/// One rule.
#[derive(Clone, Debug, PartialEq)]
pub struct Rule {
    /// As it was written.
    pub text: String,
    /// When it holds.
    pub condition: Condition,
    /// What it says.
    pub conclusion: Conclusion,
}

/// Rules, in the order they were written.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Advice {
    /// The rules.
    pub rules: Vec<Rule>,
    /// Names of the terms they make.
    pub made: Vec<String>,
}

/// A text that is no advice: where, and why.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("advice, line {line}, column {column}: {problem}")]
pub struct AdviceError {
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// Offset in characters from the start of the text, from 0.
    pub offset: usize,
    /// What is wrong, and what would be right.
    pub problem: String,
}

impl Condition {
    fn degree(&self, known: &impl Fn(usize, usize) -> f64, made: &[f64]) -> f64 {
        match self {
            Self::Term { feature, term } => known(*feature, *term),
            Self::Made(name) => made[*name],
            Self::Not(inner) => Norms::complement(inner.degree(known, made)),
            Self::And(a, b) => Norms::Zadeh.and(a.degree(known, made), b.degree(known, made)),
            Self::Or(a, b) => Norms::Zadeh.or(a.degree(known, made), b.degree(known, made)),
        }
    }
}

impl Advice {
    /// How far each rule holds, 0 to 1, for given degrees of the terms (feature, term).
    ///
    /// A term made by several rules holds as far as the strongest of them.
    pub fn degrees(&self, known: impl Fn(usize, usize) -> f64) -> Vec<f64> {
        let mut made = vec![0.0; self.made.len()];
        let mut degrees = Vec::with_capacity(self.rules.len());
        for rule in &self.rules {
            let degree = rule.condition.degree(&known, &made);
            if let Conclusion::Make(name) = rule.conclusion {
                made[name] = f64::max(made[name], degree);
            }
            degrees.push(degree);
        }
        degrees
    }
}

#[cfg(test)]
mod tests;
