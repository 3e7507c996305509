//! Settings as data: every choice has a key, a range, a default and a source.
//!
//! An experiment's settings are a plain struct; the [`settings!`](crate::settings!) macro also gives
//! it a table of [`Spec`]s and access by key, so that the command line, the interface and the page
//! need to know none of them by name.

use serde::{Deserialize, Serialize};

/// The value of a setting.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Value {
    /// On or off.
    Switch(bool),
    /// A whole number.
    Integer(i64),
    /// A number.
    Number(f64),
    /// One of several names.
    Choice(String),
}

/// What a setting may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// On or off.
    Switch,
    /// A whole number between two bounds, both allowed.
    Integer(i64, i64),
    /// A finite number between two bounds, both allowed.
    Number(f64, f64),
    /// One of several names, each with its meaning.
    Choice(&'static [(&'static str, &'static str)]),
}

/// How a setting stands to the thesis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// Printed in the thesis.
    Literal,
    /// One way to read an ambiguous passage.
    Reading,
    /// The thesis is silent; something had to be chosen.
    Gap,
    /// The thesis says otherwise.
    Deviation,
    /// Not in the thesis at all.
    Addition,
    /// Belongs to the simulation, not to the thesis.
    Simulation,
}

impl Standing {
    /// Name for files and screen.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Literal => "literal",
            Self::Reading => "reading",
            Self::Gap => "gap",
            Self::Deviation => "deviation",
            Self::Addition => "addition",
            Self::Simulation => "simulation",
        }
    }
}

/// One setting: what it means and what it may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spec {
    /// Key, e.g. `sonar.noise`.
    pub key: &'static str,
    /// What it means, one sentence.
    pub meaning: &'static str,
    /// What it may be.
    pub kind: Kind,
    /// Unit; empty for a choice, a switch or a pure number.
    pub unit: &'static str,
    /// Equation, section or reading it comes from.
    pub source: &'static str,
    /// How it stands to the thesis.
    pub standing: Standing,
}

/// A setting that cannot be taken.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SettingError {
    /// There is no such key.
    #[error("there is no setting `{key}`{}", hint(.nearest))]
    Unknown {
        /// The key asked for.
        key: String,
        /// The most similar key there is.
        nearest: Option<&'static str>,
    },
    /// The value has the wrong type or is out of range.
    #[error("`{key}` must be {expected}, not {found}")]
    Invalid {
        /// The key.
        key: &'static str,
        /// What would be right.
        expected: String,
        /// What was given.
        found: String,
    },
}

impl SettingError {
    /// The key at fault.
    #[must_use]
    pub fn key(&self) -> &str {
        match self {
            Self::Unknown { key, .. } => key,
            Self::Invalid { key, .. } => key,
        }
    }
}

fn hint(nearest: &Option<&'static str>) -> String {
    nearest.map(|key| format!("; did you mean `{key}`?")).unwrap_or_default()
}

impl std::fmt::Display for Value {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Switch(on) => write!(f, "{on}"),
            Self::Integer(number) => write!(f, "{number}"),
            Self::Number(number) => write!(f, "{number}"),
            Self::Choice(name) => write!(f, "{name}"),
        }
    }
}
