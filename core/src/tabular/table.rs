//! A world from a table of rows.

use super::file::finite;
use super::{FileError, Knowledge, Mdp, Outcome, Row, RowFile, TableFile, World};

/// A process with names.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    name: String,
    mdp: Mdp,
    start: usize,
    states: Vec<String>,
    actions: Vec<String>,
    knowledge: Knowledge,
}

impl Table {
    /// Reads and checks a file.
    ///
    /// # Errors
    /// Names the row, state or action that is wrong.
    pub fn new(file: &TableFile) -> Result<Self, FileError> {
        distinct("states", &file.states)?;
        distinct("actions", &file.actions)?;
        let state = |field: &str, name: &str| find(field, name, "states", &file.states);
        let start = state("start", &file.start)?;
        let mut absorbing = Vec::new();
        for (at, name) in file.absorbing.iter().enumerate() {
            absorbing.push(state(&format!("absorbing[{at}]"), name)?);
        }
        let mut rows = Vec::new();
        for (at, row) in file.rows.iter().enumerate() {
            rows.push(read(file, &format!("rows[{at}]"), row)?);
        }
        let mdp = Mdp::new(file.states.len(), file.actions.len(), &absorbing, &rows)
            .map_err(|error| FileError::Process { field: place(file, &rows, &error), error })?;
        if !absorbing.is_empty() && mdp.distances()[start].is_none() {
            return Err(FileError::UnreachableEnd { start: file.start.clone() });
        }
        Ok(Self {
            name: file.name.clone(),
            mdp,
            start,
            states: file.states.clone(),
            actions: file.actions.clone(),
            knowledge: Knowledge::default(),
        })
    }

    /// Its name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }
}

fn distinct(field: &'static str, names: &[String]) -> Result<(), FileError> {
    for (at, name) in names.iter().enumerate() {
        if names[..at].contains(name) {
            return Err(FileError::Twice { field, found: name.clone() });
        }
    }
    Ok(())
}

fn find(
    field: &str,
    name: &str,
    among: &'static str,
    names: &[String],
) -> Result<usize, FileError> {
    names.iter().position(|known| known == name).ok_or_else(|| FileError::Unknown {
        field: field.to_owned(),
        found: name.to_owned(),
        among,
    })
}

fn read(file: &TableFile, field: &str, row: &RowFile) -> Result<Row, FileError> {
    let state = find(&format!("{field}.state"), &row.state, "states", &file.states)?;
    let action = find(&format!("{field}.action"), &row.action, "actions", &file.actions)?;
    finite(&format!("{field}.reward"), row.reward)?;
    for (next, reward) in &row.rewards {
        finite(&format!("{field}.rewards.{next}"), *reward)?;
        if !row.to.contains_key(next) {
            return Err(FileError::Unknown {
                field: format!("{field}.rewards"),
                found: next.clone(),
                among: "to",
            });
        }
    }
    let mut outcomes = Vec::new();
    for (next, &chance) in &row.to {
        let reward = row.rewards.get(next).copied().unwrap_or(row.reward);
        let next = find(&format!("{field}.to"), next, "states", &file.states)?;
        outcomes.push(Outcome { next, chance, reward });
    }
    Ok(Row { state, action, outcomes })
}

/// The row of the file that a refusal by numbers speaks of.
fn place(file: &TableFile, rows: &[Row], error: &super::MdpError) -> String {
    use super::MdpError as E;
    match error {
        E::Repeated { state, action }
        | E::Sum { state, action, .. }
        | E::Chance { state, action, .. }
        | E::Reward { state, action, .. } => {
            let at = rows.iter().rposition(|row| (row.state, row.action) == (*state, *action));
            format!(
                "rows[{}] ({}, {})",
                at.unwrap_or(0),
                file.states[*state],
                file.actions[*action]
            )
        }
        E::NoAction { state } => format!("rows, state {}", file.states[*state]),
        _ => "rows".to_owned(),
    }
}

impl World for Table {
    fn mdp(&self) -> &Mdp {
        &self.mdp
    }

    fn start(&self) -> usize {
        self.start
    }

    fn state_name(&self, state: usize) -> String {
        self.states[state].clone()
    }

    fn action_names(&self) -> &[String] {
        &self.actions
    }

    fn knowledge(&self) -> &Knowledge {
        &self.knowledge
    }
}
