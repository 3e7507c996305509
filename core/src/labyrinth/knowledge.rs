//! What a designer knows of the labyrinth: features for advice, a reflex, progress, subgoals and modules.

use super::world::{Action, EAST, HEADINGS, STATES, WEST, cell, collides, heading};
use crate::fuzzy::falling;
use crate::tabular::{Degrees, Feature, Gate, Knowledge};

/// Cells within which the goal is wholly near, and from which on it is not near at all.
const NEAR: (f64, f64) = (0.0, 2.0);

pub(super) fn of(goal: usize) -> Knowledge {
    let estimate = (0..STATES).map(|state| estimate(state, goal)).collect();
    Knowledge {
        features: vec![wall(), goal_feature(goal), headings(), states()],
        reflex: (0..STATES).map(reflex).collect(),
        estimate,
        subgoals: (0..STATES).map(|state| state != goal && faces(state, goal)).collect(),
        gate: Some(gate(goal)),
    }
}

fn term(name: &str, degree: impl Fn(usize) -> f64) -> Degrees {
    Degrees { term: name.to_owned(), degrees: (0..STATES).map(degree).collect() }
}

fn crisp(name: &str, holds: impl Fn(usize) -> bool) -> Degrees {
    term(name, |state| f64::from(u8::from(holds(state))))
}

fn wall() -> Feature {
    Feature {
        name: "wall".into(),
        meaning: "whether going forward runs into the boundary".into(),
        terms: vec![crisp("ahead", collides)],
    }
}

/// Heading in which the goal's cell lies; none in that cell.
fn side(state: usize, goal: usize) -> Option<usize> {
    match cell(state).cmp(&cell(goal)) {
        std::cmp::Ordering::Less => Some(EAST),
        std::cmp::Ordering::Equal => None,
        std::cmp::Ordering::Greater => Some(WEST),
    }
}

/// Facing the goal's cell, or in it.
fn faces(state: usize, goal: usize) -> bool {
    side(state, goal).is_none_or(|side| side == heading(state))
}

fn cells_away(state: usize, goal: usize) -> u8 {
    u8::try_from(cell(state).abs_diff(cell(goal))).unwrap_or(u8::MAX)
}

fn goal_feature(goal: usize) -> Feature {
    let near = move |state| falling(cells_away(state, goal).into(), NEAR.0, NEAR.1);
    let lies = move |turns: usize| {
        move |state| {
            side(state, goal)
                .is_some_and(|side| (side + HEADINGS - heading(state)) % HEADINGS == turns)
        }
    };
    Feature {
        name: "goal".into(),
        meaning: "where the goal's cell lies, seen along the heading".into(),
        terms: vec![
            term("near", near),
            term("far", move |state| 1.0 - near(state)),
            crisp("ahead", lies(0)),
            crisp("right", lies(1)),
            crisp("behind", lies(2)),
            crisp("left", lies(3)),
            crisp("here", |state| side(state, goal).is_none()),
        ],
    }
}

fn headings() -> Feature {
    let names = ["north", "east", "south", "west"];
    let terms =
        names.iter().enumerate().map(|(at, name)| crisp(name, move |state| heading(state) == at));
    Feature {
        name: "heading".into(),
        meaning: "where the robot faces".into(),
        terms: terms.collect(),
    }
}

fn states() -> Feature {
    let terms = (0..STATES).map(|at| crisp(&at.to_string(), move |state| state == at));
    Feature {
        name: "state".into(),
        meaning: "the number of the state".into(),
        terms: terms.collect(),
    }
}

/// Forward if that is free, else to the left: safe, and ignorant of the goal.
fn reflex(state: usize) -> usize {
    if collides(state) { Action::Left as usize } else { Action::Forward as usize }
}

/// Quarter turns until the goal's cell lies ahead, and cells until then; the last turns are not counted.
fn estimate(state: usize, goal: usize) -> f64 {
    let turns = side(state, goal).map_or(0, |side| {
        let right = (side + HEADINGS - heading(state)) % HEADINGS;
        right.min(HEADINGS - right)
    });
    f64::from(cells_away(state, goal)) + f64::from(u8::try_from(turns).unwrap_or(u8::MAX))
}

/// Three behaviours: face the goal's cell, go there, face as the goal does.
fn gate(goal: usize) -> Gate {
    let names = ["face the goal's cell", "go to the goal's cell", "face as at the goal"];
    let place = |state: usize| match side(state, goal) {
        Some(side) if side != heading(state) => {
            (0, heading(state) + if side == EAST { 0 } else { HEADINGS })
        }
        Some(_) => (1, usize::from(cells_away(state, goal)) - 1),
        None => (2, heading(state)),
    };
    Gate {
        names: names.map(str::to_owned).to_vec(),
        behaviour: (0..STATES).map(|state| place(state).0).collect(),
        seen: (0..STATES).map(|state| place(state).1).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::labyrinth::world::at;
    use crate::labyrinth::{distances, next};

    #[test]
    fn the_reflex_reaches_the_goal_but_not_on_the_shortest_way() {
        let knowledge = of(15);
        let mut state = 7;
        let mut steps = 0;
        while state != 15 && steps < 50 {
            state = next(state, Action::ALL[knowledge.reflex[state]]);
            steps += 1;
        }
        // To the west end, half a turn, to the east end, half a turn, one cell back.
        assert_eq!(steps, 1 + 2 + 3 + 2 + 1);
        assert!(steps > distances(15)[7]);
    }

    #[test]
    fn the_estimate_never_promises_less_than_the_way() {
        for goal in 0..STATES {
            let (knowledge, exact) = (of(goal), distances(goal));
            for (state, estimate) in knowledge.estimate.iter().enumerate() {
                assert!(*estimate <= f64::from(exact[state]), "{state} to {goal}");
            }
        }
    }

    #[test]
    fn directions_are_seen_from_the_robot() {
        let knowledge = of(15);
        let degree = |feature: usize, name: &str, state: usize| {
            let terms = &knowledge.features[feature].terms;
            terms.iter().find(|term| term.term == name).expect(name).degrees[state]
        };
        // The goal is in the third cell; states 4-7 are in the second, 8-11 in the fourth.
        for (state, name) in
            [(5, "ahead"), (4, "right"), (6, "left"), (7, "behind"), (8, "left"), (13, "here")]
        {
            assert!(degree(1, name, state) > 0.5, "{state} {name}");
        }
        assert_eq!(
            (degree(1, "near", 12), degree(1, "near", 4), degree(1, "near", 0)),
            (1.0, 0.5, 0.0)
        );
        assert_eq!((degree(0, "ahead", 0), degree(0, "ahead", 1)), (1.0, 0.0));
        let gate = knowledge.gate.as_ref().expect("three behaviours");
        assert_eq!([7, 5, 12].map(|state| gate.behaviour[state]), [0, 1, 2]);
        assert_eq!(at(2, 3), 15);
        // Three headings on each side, two distances, four headings in the goal's cell.
        assert_eq!(gate.hypotheses(3), (3 + 3 + 2 + 4) * 3);
    }
}
