//! Why a rule base cannot be used.

/// A refusal: where, what is wrong, and what would be right.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("rules{}: {problem}", place(.line))]
pub struct RuleError {
    /// Line of the text, from 1; none where there is no text.
    pub line: Option<usize>,
    /// What is wrong, and what would be right.
    pub problem: String,
}

fn place(line: &Option<usize>) -> String {
    line.map(|line| format!(", line {line}")).unwrap_or_default()
}
