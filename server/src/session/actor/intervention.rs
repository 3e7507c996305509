//! What an operator does to a learner under way.

use super::{Actor, ControlError};
use crate::catalog::FieldError;
use crate::session::table_run::Intervention;
use crate::wire::{State, TableFile};

impl Actor {
    /// Does it, if there is a learner under way.
    pub(super) fn intervene(&mut self, intervention: &Intervention) -> Result<(), ControlError> {
        let (Some(run), State::Running | State::Paused) = (&mut self.run, self.condition.state)
        else {
            return Err(ControlError::NotUnderWay { state: self.condition.state });
        };
        let said = run.intervene(intervention)?;
        self.say("operator", &said);
        self.show();
        Ok(())
    }

    /// The table of the learner whose turn it is; none when no machine is in memory.
    pub(super) fn table_file(&self) -> Option<Result<TableFile, FieldError>> {
        let run = self.run.as_ref()?;
        Some(
            self.lab
                .job(&self.session.id)
                .map_err(|error| FieldError::new("session", error.to_string()))
                .and_then(|job| run.table_file(&job)),
        )
    }
}
