//! What can be told of a maze without solving it.

use super::super::world::Degrees;
use super::super::{Feature, Gate, Knowledge};
use super::{ACTIONS, Cell, Places, beside};
use crate::fuzzy::falling;

/// Cells within which a goal is wholly near, and from which on it is not near at all.
const NEAR: (f64, f64) = (1.0, 5.0);

pub(super) fn of(cells: &[Cell], places: &Places, goals: &[usize]) -> Knowledge {
    let nearest = |state: usize| {
        let far = |goal: &&usize| steps(cells[state], cells[**goal]);
        cells[*goals.iter().min_by_key(far).expect("a maze has a goal")]
    };
    let states = 0..cells.len();
    let estimate: Vec<f64> =
        states.clone().map(|state| steps(cells[state], nearest(state)) as f64).collect();
    let reflex = states.map(|state| reflex(cells, places, state, nearest(state))).collect();
    Knowledge {
        features: vec![goal(cells, &estimate, nearest), wall(cells, places)],
        reflex,
        estimate,
        subgoals: doors(cells, places),
        gate: gate(cells),
    }
}

/// Steps between two cells if there were no wall.
fn steps(a: Cell, b: Cell) -> usize {
    a.row.abs_diff(b.row) + a.column.abs_diff(b.column)
}

/// Which of the four directions lead towards a cell.
fn towards(from: Cell, to: Cell) -> [bool; 4] {
    [to.row < from.row, to.column > from.column, to.row > from.row, to.column < from.column]
}

fn term(name: &str, degrees: impl Iterator<Item = f64>) -> Degrees {
    Degrees { term: name.to_owned(), degrees: degrees.collect() }
}

fn goal(cells: &[Cell], estimate: &[f64], nearest: impl Fn(usize) -> Cell) -> Feature {
    let near = |steps: &f64| falling(*steps, NEAR.0, NEAR.1);
    let mut terms = vec![
        term("near", estimate.iter().map(near)),
        term("far", estimate.iter().map(|s| 1.0 - near(s))),
    ];
    for (action, name) in ACTIONS.iter().enumerate() {
        let there = |state| f64::from(u8::from(towards(cells[state], nearest(state))[action]));
        terms.push(term(name, (0..cells.len()).map(there)));
    }
    Feature {
        name: "goal".to_owned(),
        meaning: "where the nearest goal lies, as the crow flies".to_owned(),
        terms,
    }
}

fn wall(cells: &[Cell], places: &Places) -> Feature {
    let terms = ACTIONS.iter().enumerate().map(|(action, name)| {
        let there = |state| f64::from(u8::from(beside(cells, places, state, action).is_none()));
        term(name, (0..cells.len()).map(there))
    });
    Feature {
        name: "wall".to_owned(),
        meaning: "whether there is wall beside the cell".to_owned(),
        terms: terms.collect(),
    }
}

/// Towards the goal if that is free, else the first free direction clockwise; never into a pit.
fn reflex(cells: &[Cell], places: &Places, state: usize, goal: Cell) -> usize {
    let free = |action: &usize| {
        beside(cells, places, state, *action).is_some_and(|next| cells[next].mark != 'X')
    };
    let there = towards(cells[state], goal);
    let towards = (0..ACTIONS.len()).filter(|action| there[*action]).find(free);
    towards.or_else(|| (0..ACTIONS.len()).find(free)).unwrap_or(0)
}

/// Cells of one room with a neighbour of another: passing from room to room is a subgoal.
fn doors(cells: &[Cell], places: &Places) -> Vec<bool> {
    if cells.iter().all(|cell| !cell.mark.is_ascii_lowercase()) {
        return Vec::new();
    }
    let door = |state: usize| {
        let mut around =
            (0..ACTIONS.len()).filter_map(|action| beside(cells, places, state, action));
        around.any(|next| room(cells, next) > room(cells, state))
    };
    (0..cells.len()).map(door).collect()
}

/// Room of a cell: floor without a letter belongs to the first room, the goal to the last.
fn room(cells: &[Cell], state: usize) -> char {
    let letters = || cells.iter().map(|cell| cell.mark).filter(char::is_ascii_lowercase);
    match cells[state].mark {
        mark if mark.is_ascii_lowercase() => mark,
        'G' => letters().max().unwrap_or('a'),
        _ => letters().min().unwrap_or('a'),
    }
}

/// One behaviour a room, in the order of the letters; each sees the cells of its room.
fn gate(cells: &[Cell]) -> Option<Gate> {
    let mut rooms: Vec<char> =
        cells.iter().map(|cell| cell.mark).filter(char::is_ascii_lowercase).collect();
    rooms.sort_unstable();
    rooms.dedup();
    if rooms.len() < 2 {
        return None;
    }
    let mut sizes = vec![0; rooms.len()];
    let (mut behaviour, mut seen) = (Vec::new(), Vec::new());
    for state in 0..cells.len() {
        let at = rooms.iter().position(|name| *name == room(cells, state)).unwrap_or(0);
        behaviour.push(at);
        seen.push(sizes[at]);
        sizes[at] += 1;
    }
    let names = rooms.iter().map(|name| format!("room {name}")).collect();
    Some(Gate { names, behaviour, seen })
}
