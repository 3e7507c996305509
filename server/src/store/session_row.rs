//! Rows of sessions.

use std::collections::BTreeMap;
use std::fs;
use std::io::ErrorKind;

use rusqlite::{OptionalExtension, Row, params};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;

use super::{Store, StoreError};
use crate::wire::{Family, Speed, State};

/// A session as it is kept.
#[derive(Clone, Debug, PartialEq)]
pub struct SessionRow {
    /// Identifier; also the name of its folder.
    pub id: String,
    /// Name of the experiment.
    pub experiment: String,
    /// Seed, 0 to 2⁵³ − 1.
    pub seed: u64,
    /// Preset the settings started from.
    pub preset: String,
    /// Name of the world.
    pub world: String,
    /// The world's file as it was used, so that a later edit of it changes nothing.
    pub world_text: String,
    /// Every setting with its value.
    pub settings: BTreeMap<String, Value>,
    /// Whether it is a tabular experiment.
    pub family: Family,
    /// Trials asked for; of each episode in a tabular experiment.
    pub trials_each: u32,
    /// What it goes through: trials, or episodes of one competitor each.
    pub rounds: u32,
    /// Pace.
    pub speed: Speed,
    /// Program version and commit it runs on.
    pub build: String,
    /// State.
    pub state: State,
    /// Why it failed or was interrupted.
    pub reason: Option<String>,
    /// When it was created, RFC 3339, UTC.
    pub created_at: String,
    /// When it last changed state, RFC 3339, UTC.
    pub changed_at: String,
    /// Last tick in the log; brought forward with every chunk that is closed.
    pub tick: u64,
    /// Rounds done according to the log.
    pub rounds_done: u32,
}

const COLUMNS: &str = "id, experiment, seed, preset, world, world_text, settings, trials, speed, \
     build, state, reason, created_at, changed_at, tick, trials_done, family, rounds";

impl Store {
    /// Adds a session and its folder.
    pub fn insert_session(&self, row: &SessionRow) -> Result<(), StoreError> {
        let folder = self.session_folder(&row.id);
        fs::create_dir_all(&folder).map_err(|e| StoreError::file("create", &folder, &e))?;
        let sql = format!(
            "INSERT INTO session ({COLUMNS}) VALUES \
             (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13, ?14, ?15, ?16, ?17, ?18)"
        );
        let values = params![
            row.id,
            row.experiment,
            row.seed.cast_signed(),
            row.preset,
            row.world,
            row.world_text,
            to_text(&row.settings),
            row.trials_each,
            to_text(&row.speed),
            row.build,
            to_text(&row.state),
            row.reason,
            row.created_at,
            row.changed_at,
            row.tick.cast_signed(),
            row.rounds_done,
            to_text(&row.family),
            row.rounds,
        ];
        let inserted = self.database().execute(&sql, values);
        inserted.map_err(StoreError::index("add a session"))?;
        Ok(())
    }

    /// Records a change of state. `changed_at` is RFC 3339, UTC.
    pub fn update_state(
        &self,
        id: &str,
        state: State,
        reason: Option<&str>,
        changed_at: &str,
    ) -> Result<(), StoreError> {
        self.update(
            id,
            "UPDATE session SET state = ?2, reason = ?3, changed_at = ?4 WHERE id = ?1",
            params![id, to_text(&state), reason, changed_at],
        )
    }

    /// The last server ended without bringing this session to a rest.
    pub(super) fn interrupt(&self, id: &str, reason: &str) -> Result<(), StoreError> {
        self.update(
            id,
            "UPDATE session SET state = ?2, reason = ?3, \
             changed_at = strftime('%Y-%m-%dT%H:%M:%fZ', 'now') WHERE id = ?1",
            params![id, to_text(&State::Interrupted), reason],
        )
    }

    /// Records a change of pace.
    pub fn update_speed(&self, id: &str, speed: Speed) -> Result<(), StoreError> {
        self.update(id, "UPDATE session SET speed = ?2 WHERE id = ?1", params![id, to_text(&speed)])
    }

    fn update(
        &self,
        id: &str,
        sql: &str,
        values: &[&dyn rusqlite::ToSql],
    ) -> Result<(), StoreError> {
        let changed = self.database().execute(sql, values);
        match changed.map_err(StoreError::index("change a session"))? {
            0 => Err(StoreError::NoSession { id: id.into() }),
            _ => Ok(()),
        }
    }

    /// One session, or none of that name.
    pub fn session(&self, id: &str) -> Result<Option<SessionRow>, StoreError> {
        let sql = format!("SELECT {COLUMNS} FROM session WHERE id = ?1");
        let found = self.database().query_row(&sql, [id], session_row).optional();
        found.map_err(StoreError::index("read a session"))
    }

    /// One session that has to be there. What names files asks this first, so that no other name
    /// reaches the file system.
    pub(super) fn existing(&self, id: &str) -> Result<SessionRow, StoreError> {
        self.session(id)?.ok_or_else(|| StoreError::NoSession { id: id.into() })
    }

    /// All sessions, newest first.
    pub fn sessions(&self) -> Result<Vec<SessionRow>, StoreError> {
        let sql = format!("SELECT {COLUMNS} FROM session ORDER BY number DESC");
        let read = || {
            let database = self.database();
            let mut statement = database.prepare_cached(&sql)?;
            statement.query_map([], session_row)?.collect::<rusqlite::Result<_>>()
        };
        read().map_err(StoreError::index("list the sessions"))
    }

    /// Deletes a session, its index and its files. Its writer must be finished.
    pub fn delete_session(&self, id: &str) -> Result<(), StoreError> {
        self.update(id, "DELETE FROM session WHERE id = ?1", params![id])?;
        let folder = self.session_folder(id);
        match fs::remove_dir_all(&folder) {
            Err(e) if e.kind() != ErrorKind::NotFound => {
                Err(StoreError::file("delete", &folder, &e))
            }
            _ => Ok(()),
        }
    }
}

fn session_row(row: &Row<'_>) -> rusqlite::Result<SessionRow> {
    Ok(SessionRow {
        id: row.get(0)?,
        experiment: row.get(1)?,
        seed: row.get::<_, i64>(2)?.cast_unsigned(),
        preset: row.get(3)?,
        world: row.get(4)?,
        world_text: row.get(5)?,
        settings: from_text(row, 6)?,
        trials_each: row.get(7)?,
        speed: from_text(row, 8)?,
        build: row.get(9)?,
        state: from_text(row, 10)?,
        reason: row.get(11)?,
        created_at: row.get(12)?,
        changed_at: row.get(13)?,
        tick: row.get::<_, i64>(14)?.cast_unsigned(),
        rounds_done: row.get(15)?,
        family: from_text(row, 16)?,
        rounds: row.get(17)?,
    })
}

/// A value as the JSON a column holds. These types have string keys and no custom serialisers, the
/// two things that could make it fail.
pub(super) fn to_text(value: &impl Serialize) -> String {
    serde_json::to_string(value).expect("a wire type always has a JSON form")
}

/// The value a column holds as JSON.
pub(super) fn from_text<T: DeserializeOwned>(row: &Row<'_>, column: usize) -> rusqlite::Result<T> {
    let text = row.get_ref(column)?.as_str()?;
    serde_json::from_str(text).map_err(|e| {
        rusqlite::Error::FromSqlConversionFailure(column, rusqlite::types::Type::Text, e.into())
    })
}
