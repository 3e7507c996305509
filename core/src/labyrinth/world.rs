//! The world of figure 4.5: a corridor of four cells, west to east, with four headings in each.

use super::knowledge;
use crate::tabular::{Knowledge, Mdp, Outcome, Row, World};

/// Number of states.
pub const STATES: usize = 16;
/// Number of actions.
pub const ACTIONS: usize = 3;
/// Number of headings: north, east, south, west.
pub(super) const HEADINGS: usize = 4;
/// First state of each cell of the corridor, west to east (figure 4.5 (a)).
const CELLS: [usize; 4] = [0, 4, 12, 8];
pub(super) const EAST: usize = 1;
pub(super) const WEST: usize = 3;

/// The three actions, in the order of figure 4.5 (b).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// A quarter turn to the left.
    Left,
    /// To the next cell, if there is one in that direction.
    Forward,
    /// A quarter turn to the right.
    Right,
}

impl Action {
    /// All of them, in order.
    pub const ALL: [Self; ACTIONS] = [Self::Left, Self::Forward, Self::Right];
}

/// Cell of a state, from 0 in the west to 3 in the east.
pub(super) fn cell(state: usize) -> usize {
    CELLS.iter().position(|first| *first == state - heading(state)).expect("a state below 16")
}

/// Heading of a state, 0 north, 1 east, 2 south, 3 west.
pub(super) fn heading(state: usize) -> usize {
    state % HEADINGS
}

/// The state in a cell with a heading.
pub(super) fn at(cell: usize, heading: usize) -> usize {
    CELLS[cell] + heading % HEADINGS
}

/// Cell of a state, from 0 in the west to 3 in the east, and its heading in degrees counter-clockwise from
/// east, in (-180, 180].
///
/// # Panics
/// When the state is not below 16.
#[must_use]
pub fn place(state: usize) -> (usize, f64) {
    (cell(state), [90.0, 0.0, -90.0, 180.0][heading(state)])
}

/// State that an action leads to, figure 4.5 (b). "Attempting an action against the world boundary does
/// not change the state."
///
/// # Panics
/// When the state is not below 16.
#[must_use]
pub fn next(state: usize, action: Action) -> usize {
    let (cell, heading) = (cell(state), heading(state));
    match action {
        Action::Left => at(cell, heading + HEADINGS - 1),
        Action::Right => at(cell, heading + 1),
        Action::Forward => match heading {
            EAST => at((cell + 1).min(CELLS.len() - 1), heading),
            WEST => at(cell.saturating_sub(1), heading),
            _ => state,
        },
    }
}

/// Whether going forward runs into the boundary.
#[must_use]
pub fn collides(state: usize) -> bool {
    next(state, Action::Forward) == state
}

/// Fewest actions from each state to a goal: the reachability of section 4.6.
#[must_use]
pub fn distances(goal: usize) -> [u32; STATES] {
    let mut distances = [u32::MAX; STATES];
    distances[goal] = 0;
    for distance in 0.. {
        let mut more = false;
        for state in 0..STATES {
            let leads = |action: &Action| distances[next(state, *action)] == distance;
            if distances[state] == u32::MAX && Action::ALL.iter().any(leads) {
                distances[state] = distance + 1;
                more = true;
            }
        }
        if !more {
            break;
        }
    }
    distances
}

/// The labyrinth with a start and a goal.
#[derive(Clone, Debug, PartialEq)]
pub struct Labyrinth {
    start: usize,
    goal: usize,
    mdp: Mdp,
    actions: Vec<String>,
    knowledge: Knowledge,
}

/// A start or goal that cannot be.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LabyrinthError {
    /// No such state.
    #[error("`{field}` must be a state from 0 to 15, not {found}")]
    State {
        /// `start` or `goal`.
        field: &'static str,
        /// What was given.
        found: usize,
    },
    /// Nothing to learn.
    #[error("`goal` must differ from the start, which is {start}")]
    Same {
        /// Both.
        start: usize,
    },
}

impl Labyrinth {
    /// A labyrinth.
    ///
    /// # Errors
    /// When start or goal is no state, or both are the same.
    pub fn new(start: usize, goal: usize) -> Result<Self, LabyrinthError> {
        for (field, found) in [("start", start), ("goal", goal)] {
            if found >= STATES {
                return Err(LabyrinthError::State { field, found });
            }
        }
        if start == goal {
            return Err(LabyrinthError::Same { start });
        }
        let mut rows = Vec::new();
        for state in 0..STATES {
            for (action, way) in Action::ALL.iter().enumerate() {
                let next = next(state, *way);
                // Section 4.4: reward is 0 for all transitions but those into the goal state, +1.
                let reward = f64::from(u8::from(next == goal));
                rows.push(Row {
                    state,
                    action,
                    outcomes: vec![Outcome { next, chance: 1.0, reward }],
                });
            }
        }
        let mdp =
            Mdp::new(STATES, ACTIONS, &[goal], &rows).expect("each row has one certain outcome");
        let actions = ["left", "forward", "right"].map(str::to_owned).to_vec();
        Ok(Self { start, goal, mdp, actions, knowledge: knowledge::of(goal) })
    }

    /// From cell #7 to cell #15, as in section 4.9.
    #[must_use]
    pub fn of_the_thesis() -> Self {
        Self::new(7, 15).expect("two different states")
    }

    /// The goal.
    #[must_use]
    pub fn goal(&self) -> usize {
        self.goal
    }
}

impl World for Labyrinth {
    fn mdp(&self) -> &Mdp {
        &self.mdp
    }

    fn start(&self) -> usize {
        self.start
    }

    fn state_name(&self, state: usize) -> String {
        let heading = ["north", "east", "south", "west"][heading(state)];
        format!("#{state} (cell {} from the west, facing {heading})", cell(state) + 1)
    }

    fn action_names(&self) -> &[String] {
        &self.actions
    }

    fn knowledge(&self) -> &Knowledge {
        &self.knowledge
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Figure 4.5 (b), typed from the thesis: left, forward, right.
    const PRINTED: [[usize; ACTIONS]; STATES] = [
        [3, 0, 1],
        [0, 5, 2],
        [1, 2, 3],
        [2, 3, 0],
        [7, 4, 5],
        [4, 13, 6],
        [5, 6, 7],
        [6, 3, 4],
        [11, 8, 9],
        [8, 9, 10],
        [9, 10, 11],
        [10, 15, 8],
        [15, 12, 13],
        [12, 9, 14],
        [13, 14, 15],
        [14, 7, 12],
    ];

    #[test]
    fn the_transition_table_is_the_printed_one() {
        for (state, printed) in PRINTED.iter().enumerate() {
            assert_eq!(Action::ALL.map(|action| next(state, action)), *printed, "state {state}");
        }
    }

    #[test]
    fn the_printed_ways_and_distances() {
        use Action::{Forward, Left, Right};
        for way in [[Left, Left, Forward, Left, Left], [Left, Left, Forward, Right, Right]] {
            assert_eq!(way.iter().fold(7, |state, action| next(state, *action)), 15);
        }
        let far = distances(15);
        assert_eq!((far[7], far[12], distances(2)[7]), (5, 1, 2));
        let near: Vec<usize> = (0..STATES).filter(|state| far[*state] == 1).collect();
        assert_eq!(near, [11, 12, 14]);
        assert_eq!((0..STATES).filter(|state| collides(*state)).count(), 10);
    }

    #[test]
    fn only_the_way_into_the_goal_pays() {
        let labyrinth = Labyrinth::of_the_thesis();
        let mdp = labyrinth.mdp();
        let paid: Vec<(usize, usize)> = (0..STATES)
            .flat_map(|state| (0..ACTIONS).map(move |action| (state, action)))
            .filter(|(state, action)| mdp.expected_reward(*state, *action) > 0.0)
            .collect();
        assert_eq!(paid, [(11, 1), (12, 0), (14, 2)]);
        assert!(mdp.is_absorbing(15));
        assert_eq!(labyrinth.state_name(7), "#7 (cell 2 from the west, facing west)");
    }

    #[test]
    fn a_start_or_goal_that_cannot_be_is_named() {
        for (start, goal, message) in [
            (16, 15, "`start` must be a state from 0 to 15, not 16"),
            (7, 99, "`goal` must be a state from 0 to 15, not 99"),
            (7, 7, "`goal` must differ from the start, which is 7"),
        ] {
            assert_eq!(Labyrinth::new(start, goal).expect_err(message).to_string(), message);
        }
    }
}
