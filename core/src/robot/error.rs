//! Why a robot's file cannot be used.

use super::MOST_SONARS;

/// A refusal: what is wrong, where in the file, and what would be right.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RobotError {
    /// The name is empty.
    #[error("`name` must be a name of at least one character")]
    Unnamed,
    /// A number is out of range, or none.
    #[error("`{field}` must be a number from {least} to {most}, not {found}")]
    OutOfRange {
        /// Where.
        field: String,
        /// The least.
        least: f64,
        /// The greatest.
        most: f64,
        /// What was given.
        found: f64,
    },
    /// The body is neither a circle nor a rectangle, or both.
    #[error("`body` must have either `radius_m`, or `length_m` and `width_m`")]
    Body,
    /// The sonars are given twice or not at all.
    #[error(
        "there must be either `ring`, the number of sonars round a round body, or `sonars`, a list \
         of them with `x_m`, `y_m` and `axis_deg`"
    )]
    NoSonars,
    /// There are too many or too few sonars.
    #[error("`{field}` must be from 1 to {MOST_SONARS} sonars, not {found}")]
    Count {
        /// `ring` or `sonars`.
        field: &'static str,
        /// What was given.
        found: usize,
    },
    /// A firing order that does not fire each sonar once.
    #[error(
        "`equipment.scanner.orders.{order}` must name each of the {sonars} sonars once, and fit into \
         `equipment.scanner.slots`"
    )]
    Order {
        /// `staggered` or `naive`.
        order: &'static str,
        /// Sonars there are.
        sonars: usize,
    },
    /// Sonars can be spread evenly only round a circle.
    #[error("`ring` needs a round `body`; give a rectangular one its `sonars` one by one")]
    RingOnBox,
}

impl RobotError {
    /// The field at fault, e.g. `sonars[3].axis_deg`.
    #[must_use]
    pub fn field(&self) -> &str {
        match self {
            Self::Unnamed => "name",
            Self::OutOfRange { field, .. } => field,
            Self::Body => "body",
            Self::NoSonars => "sonars",
            Self::Count { field, .. } => field,
            Self::Order { .. } => "equipment.scanner.orders",
            Self::RingOnBox => "ring",
        }
    }
}
