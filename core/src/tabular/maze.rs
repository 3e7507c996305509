//! A maze drawn in characters: cells, walls, and what a designer knows of them.

mod knowledge;

use super::file::finite;
use super::{FileError, Knowledge, MazeFile, Mdp, Outcome, Row, World};

/// Most cells that are not wall.
const MOST_CELLS: usize = 10_000;
/// The four actions, clockwise.
const ACTIONS: [&str; 4] = ["north", "east", "south", "west"];
/// Where they lead: rows down, columns right.
const MOVES: [(isize, isize); 4] = [(-1, 0), (0, 1), (1, 0), (0, -1)];

/// One cell that is not wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cell {
    /// Row of the drawing, from 0 at the top.
    pub row: usize,
    /// Column of the drawing, from 0 at the left.
    pub column: usize,
    /// What stands there.
    pub mark: char,
}

/// A maze; its states are the cells that are not wall, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Maze {
    name: String,
    cells: Vec<Cell>,
    /// State of each place of the drawing.
    places: Vec<Vec<Option<usize>>>,
    start: usize,
    mdp: Mdp,
    actions: Vec<String>,
    knowledge: Knowledge,
}

impl Maze {
    /// Reads and checks a file.
    ///
    /// # Errors
    /// Names the line and column of the drawing, or the number, that is wrong.
    pub fn new(file: &MazeFile) -> Result<Self, FileError> {
        check_numbers(file)?;
        let (cells, places) = read(&file.map)?;
        let start = start(&cells)?;
        let goals = cells.iter().filter(|cell| cell.mark == 'G').count();
        if goals == 0 {
            return Err(FileError::Count { expected: "at least one goal G", found: 0 });
        }
        let mdp = process(file, &cells, &places)
            .map_err(|error| FileError::Process { field: "map".to_owned(), error })?;
        let ends: Vec<usize> = (0..cells.len()).filter(|&cell| cells[cell].mark == 'G').collect();
        let distances = mdp.distances_to(&ends);
        if distances[start].is_none() {
            let Cell { row, column, .. } = cells[start];
            return Err(FileError::UnreachableGoal { line: row + 1, column: column + 1 });
        }
        let knowledge = knowledge::of(&cells, &places, &ends);
        let actions = ACTIONS.map(str::to_owned).to_vec();
        Ok(Self { name: file.name.clone(), cells, places, start, mdp, actions, knowledge })
    }

    /// Its name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The cells, by state.
    #[must_use]
    pub fn cells(&self) -> &[Cell] {
        &self.cells
    }

    /// Rows and columns of the drawing.
    #[must_use]
    pub fn size(&self) -> (usize, usize) {
        (self.places.len(), self.places.iter().map(Vec::len).max().unwrap_or(0))
    }

    /// The state at a place of the drawing; none for wall.
    #[must_use]
    pub fn state_at(&self, row: usize, column: usize) -> Option<usize> {
        self.places.get(row)?.get(column).copied().flatten()
    }
}

fn check_numbers(file: &MazeFile) -> Result<(), FileError> {
    for (field, found) in [
        ("goal_reward", file.goal_reward),
        ("pit_reward", file.pit_reward),
        ("step_reward", file.step_reward),
        ("bump_reward", file.bump_reward),
    ] {
        finite(field, found)?;
    }
    if (0.0..=1.0).contains(&file.slip) {
        return Ok(());
    }
    Err(FileError::Number { field: "slip".to_owned(), expected: "from 0 to 1", found: file.slip })
}

type Places = Vec<Vec<Option<usize>>>;

fn read(map: &str) -> Result<(Vec<Cell>, Places), FileError> {
    let mut cells = Vec::new();
    let mut places = Vec::new();
    for (row, line) in map.lines().enumerate() {
        let mut states = Vec::new();
        for (column, mark) in line.chars().enumerate() {
            states.push(match mark {
                '#' => None,
                '.' | 'S' | 'G' | 'X' | 'a'..='z' => {
                    cells.push(Cell { row, column, mark });
                    Some(cells.len() - 1)
                }
                found => {
                    return Err(FileError::Character { line: row + 1, column: column + 1, found });
                }
            });
        }
        places.push(states);
    }
    if cells.len() > MOST_CELLS {
        return Err(FileError::TooLarge { limit: MOST_CELLS, found: cells.len() });
    }
    Ok((cells, places))
}

fn start(cells: &[Cell]) -> Result<usize, FileError> {
    let mut starts = cells.iter().enumerate().filter(|(_, cell)| cell.mark == 'S');
    let (start, _) = starts.next().ok_or(FileError::Count { expected: "one start S", found: 0 })?;
    match starts.next() {
        Some((_, Cell { row, column, .. })) => {
            Err(FileError::SecondStart { line: row + 1, column: column + 1 })
        }
        None => Ok(start),
    }
}

/// State beside a cell; none where there is wall.
fn beside(cells: &[Cell], places: &Places, state: usize, action: usize) -> Option<usize> {
    let (down, right) = MOVES[action];
    let row = cells[state].row.checked_add_signed(down)?;
    let column = cells[state].column.checked_add_signed(right)?;
    places.get(row)?.get(column).copied().flatten()
}

fn process(file: &MazeFile, cells: &[Cell], places: &Places) -> Result<Mdp, super::MdpError> {
    let mut rows = Vec::new();
    let ends: Vec<usize> = (0..cells.len()).filter(|&at| "GX".contains(cells[at].mark)).collect();
    for state in 0..cells.len() {
        for action in 0..ACTIONS.len() {
            let mut outcomes: Vec<Outcome> = Vec::new();
            for (turn, chance) in [(0, 1.0 - file.slip), (1, file.slip / 2.0), (3, file.slip / 2.0)]
            {
                let there = beside(cells, places, state, (action + turn) % ACTIONS.len());
                let next = there.unwrap_or(state);
                let reward = match (there, cells[next].mark) {
                    (None, _) => file.bump_reward,
                    (_, 'G') => file.goal_reward,
                    (_, 'X') => file.pit_reward,
                    _ => file.step_reward,
                };
                let same = |outcome: &&mut Outcome| {
                    outcome.next == next && outcome.reward.to_bits() == reward.to_bits()
                };
                match outcomes.iter_mut().find(same) {
                    Some(outcome) => outcome.chance += chance,
                    None => outcomes.push(Outcome { next, chance, reward }),
                }
            }
            rows.push(Row { state, action, outcomes });
        }
    }
    Mdp::new(cells.len(), ACTIONS.len(), &ends, &rows)
}

impl World for Maze {
    fn mdp(&self) -> &Mdp {
        &self.mdp
    }

    fn start(&self) -> usize {
        self.start
    }

    fn state_name(&self, state: usize) -> String {
        let Cell { row, column, .. } = self.cells[state];
        format!("row {}, column {}", row + 1, column + 1)
    }

    fn action_names(&self) -> &[String] {
        &self.actions
    }

    fn knowledge(&self) -> &Knowledge {
        &self.knowledge
    }
}

#[cfg(test)]
mod tests;
