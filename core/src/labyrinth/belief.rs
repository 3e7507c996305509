//! Belief matrices, section 4.5 and 4.6, made from their definitions.
//!
//! 1 stands for a neutral belief, a number below 1 for a lesser preference, -1 for what is excluded.

use serde::{Deserialize, Serialize};

use super::world::{
    ACTIONS, Action, EAST, STATES, WEST, at, cell, collides, distances, heading, next,
};

/// One belief for each pair of state and action.
pub type Matrix = [[f64; ACTIONS]; STATES];

/// Belief of what is excluded.
const EXCLUDED: f64 = -1.0;

/// The six matrices of chapter 4.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Bias {
    /// Unbiased.
    B0,
    /// Environment: no action with an immediate consequence.
    B10,
    /// Environment: and less preference for potential ones.
    B11,
    /// Insight: one of two ways to turn round is left out.
    B2,
    /// Goal, near.
    B30,
    /// Goal, far.
    B31,
}

impl Bias {
    /// All of them, in the order of table 4.3.
    pub const ALL: [Self; 6] = [Self::B0, Self::B10, Self::B11, Self::B2, Self::B30, Self::B31];

    /// Name as printed, without the subscript.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::B0 => "B0",
            Self::B10 => "B10",
            Self::B11 => "B11",
            Self::B2 => "B2",
            Self::B30 => "B30",
            Self::B31 => "B31",
        }
    }
}

crate::choice! {
    /// Where B11 lowers a belief.
    pub enum EnvironmentRule {
        Figure = "figure": "only where another action is better, as figure 4.7 (c) shows in row 3",
        Absolute = "absolute": "wherever a collision could follow, which contradicts row 3",
    }
}

crate::choice! {
    /// Which half turns B2 leaves out; figure 4.8 shows the first cell only.
    pub enum InsightRule {
        GoalDirected = "goal-directed": "{right right} towards the goal, in every cell: the printed example continued",
        West = "west-to-east": "{right right} from west to east, in every cell: the printed example repeated",
        Away = "away": "{right right} away from the goal; contradicts the printed example (chosen after the fact)",
        Turns = "turns-away": "the turn away from the goal where the robot faces a wall (chosen after the fact)",
    }
}

crate::choice! {
    /// What B30 and B31 leave where two actions are equally good.
    pub enum GoalActions {
        Both = "both": "both",
        One = "one": "the first",
    }
}

/// One reading of each definition.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Readings {
    /// Of B11.
    pub environment: EnvironmentRule,
    /// Belief that B11 gives to potential consequences; 0.5 is printed.
    pub lowered: f64,
    /// Of B2.
    pub insight: InsightRule,
    /// Of B30 and B31.
    pub goal: GoalActions,
}

impl Default for Readings {
    fn default() -> Self {
        Self {
            environment: EnvironmentRule::Figure,
            lowered: 0.5,
            insight: InsightRule::GoalDirected,
            goal: GoalActions::Both,
        }
    }
}

/// A belief matrix for a goal.
#[must_use]
pub fn matrix(bias: Bias, goal: usize, readings: &Readings) -> Matrix {
    match bias {
        Bias::B0 => [[1.0; ACTIONS]; STATES],
        Bias::B10 => immediate(),
        Bias::B11 => potential(readings),
        Bias::B2 => insight(goal, readings.insight),
        Bias::B30 => vector_field(goal, readings.goal, |distance| distance == 1),
        Bias::B31 => vector_field(goal, readings.goal, |distance| distance > 1),
    }
}

/// B10: "excludes those actions that have immediate consequences".
fn immediate() -> Matrix {
    let mut matrix = [[1.0; ACTIONS]; STATES];
    for state in (0..STATES).filter(|state| collides(*state)) {
        matrix[state][Action::Forward as usize] = EXCLUDED;
    }
    matrix
}

/// B11: besides, "actions that have potential consequences after a transition has occurred are less
/// preferred to those actions that do not have consequences".
fn potential(readings: &Readings) -> Matrix {
    let mut matrix = immediate();
    for (state, beliefs) in matrix.iter_mut().enumerate() {
        let allowed: Vec<usize> = (0..ACTIONS).filter(|action| beliefs[*action] > 0.0).collect();
        let risky = |action: &usize| collides(next(state, Action::ALL[*action]));
        let all_risky = allowed.iter().all(risky);
        if all_risky && readings.environment == EnvironmentRule::Figure {
            continue;
        }
        for action in allowed.into_iter().filter(risky) {
            beliefs[action] = readings.lowered;
        }
    }
    matrix
}

/// Heading that leads towards the goal: along the corridor, and in the goal's own cell the goal's heading if
/// that is along the corridor, else east.
fn wanted(of: usize, goal: usize) -> usize {
    match of.cmp(&cell(goal)) {
        std::cmp::Ordering::Less => EAST,
        std::cmp::Ordering::Greater => WEST,
        std::cmp::Ordering::Equal if heading(goal) == WEST => WEST,
        std::cmp::Ordering::Equal => EAST,
    }
}

/// B2: of {left left} and {right right}, which turn round with the same end effect, one is left out.
fn insight(goal: usize, rule: InsightRule) -> Matrix {
    let mut matrix = [[1.0; ACTIONS]; STATES];
    for of in 0..4 {
        let wanted = wanted(of, goal);
        let against = wanted + 2;
        let pairs = match rule {
            InsightRule::GoalDirected => right_right(of, against),
            InsightRule::West => right_right(of, WEST),
            InsightRule::Away => right_right(of, wanted),
            // From one heading to the left of the wanted one a further left turns away; and the reverse.
            InsightRule::Turns => {
                [(at(of, wanted + 3), Action::Left), (at(of, wanted + 1), Action::Right)]
            }
        };
        for (state, action) in pairs {
            matrix[state][action as usize] = EXCLUDED;
        }
    }
    matrix
}

/// The two pairs of a half turn to the right that begins at a heading.
fn right_right(cell: usize, from: usize) -> [(usize, Action); 2] {
    [(at(cell, from), Action::Right), (at(cell, from + 1), Action::Right)]
}

/// B30 and B31: "the right vector fields are supplied" to some states, by their reachability.
///
/// NOTE: the figure's other entries are not in the text; they are taken as excluded.
fn vector_field(goal: usize, actions: GoalActions, supplied: impl Fn(u32) -> bool) -> Matrix {
    let distances = distances(goal);
    let mut matrix = [[1.0; ACTIONS]; STATES];
    for (state, beliefs) in matrix.iter_mut().enumerate() {
        if !supplied(distances[state]) {
            continue;
        }
        let mut kept = 0;
        for (belief, action) in beliefs.iter_mut().zip(Action::ALL) {
            let right = distances[next(state, action)] + 1 == distances[state];
            if right && (kept == 0 || actions == GoalActions::Both) {
                kept += 1;
            } else {
                *belief = EXCLUDED;
            }
        }
    }
    matrix
}

#[cfg(test)]
mod tests;
