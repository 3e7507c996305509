//! The SQLite file: its settings and its tables.

use std::path::Path;
use std::time::Duration;

use rusqlite::Connection;

use super::StoreError;

/// Format of the tables below, kept in SQLite's `user_version`.
const FORMAT: i64 = 2;

/// Tables of format 2. `chunk`, `trial` and `event` are an index over the logs.
const TABLES: &str = "
CREATE TABLE session (
    number      INTEGER PRIMARY KEY,
    id          TEXT NOT NULL UNIQUE,
    experiment  TEXT NOT NULL,
    seed        INTEGER NOT NULL,
    preset      TEXT NOT NULL,
    world       TEXT NOT NULL,
    world_text  TEXT NOT NULL,
    settings    TEXT NOT NULL,
    trials      INTEGER NOT NULL,
    speed       TEXT NOT NULL,
    build       TEXT NOT NULL,
    state       TEXT NOT NULL,
    reason      TEXT,
    created_at  TEXT NOT NULL,
    changed_at  TEXT NOT NULL,
    tick        INTEGER NOT NULL,
    trials_done INTEGER NOT NULL,
    family      TEXT NOT NULL,
    rounds      INTEGER NOT NULL
);
CREATE TABLE chunk (
    session     TEXT NOT NULL REFERENCES session(id) ON DELETE CASCADE,
    offset      INTEGER NOT NULL,
    length      INTEGER NOT NULL,
    first_tick  INTEGER,
    last_tick   INTEGER,
    first_trial INTEGER,
    last_trial  INTEGER,
    PRIMARY KEY (session, offset)
) WITHOUT ROWID;
CREATE INDEX chunk_by_tick ON chunk (session, last_tick);
CREATE TABLE trial (
    session      TEXT NOT NULL REFERENCES session(id) ON DELETE CASCADE,
    trial        INTEGER NOT NULL,
    row          TEXT NOT NULL,
    chunk_offset INTEGER NOT NULL,
    chunk_length INTEGER NOT NULL,
    PRIMARY KEY (session, trial)
) WITHOUT ROWID;
CREATE TABLE event (
    number  INTEGER PRIMARY KEY,
    session TEXT NOT NULL REFERENCES session(id) ON DELETE CASCADE,
    entry   TEXT NOT NULL
);
CREATE INDEX event_by_session ON event (session, number);
CREATE TABLE checkpoint (
    session     TEXT PRIMARY KEY REFERENCES session(id) ON DELETE CASCADE,
    tick        INTEGER NOT NULL,
    trials_done INTEGER NOT NULL,
    bytes       BLOB NOT NULL
);
";

/// From format 1, which knew no tabular experiments: a session's rounds were its trials.
const FROM_1_TO_2: &str = "
ALTER TABLE session ADD COLUMN family TEXT NOT NULL DEFAULT '\"path\"';
ALTER TABLE session ADD COLUMN rounds INTEGER NOT NULL DEFAULT 0;
UPDATE session SET rounds = trials;
";

/// Opens the index, creating its tables when it is new.
pub(super) fn open(path: &Path) -> Result<Connection, StoreError> {
    let mut connection = Connection::open(path).map_err(StoreError::index("open the file"))?;
    configure(&connection).map_err(StoreError::index("set up the file"))?;
    let found: i64 = connection
        .pragma_query_value(None, "user_version", |row| row.get(0))
        .map_err(StoreError::index("read the format"))?;
    match found {
        FORMAT => Ok(connection),
        1 => {
            change_tables(&mut connection, FROM_1_TO_2)
                .map_err(StoreError::index("bring the tables up to date"))?;
            Ok(connection)
        }
        0 => {
            change_tables(&mut connection, TABLES)
                .map_err(StoreError::index("create the tables"))?;
            Ok(connection)
        }
        _ => Err(StoreError::Newer { path: path.to_path_buf(), found, known: FORMAT }),
    }
}

/// The write-ahead log lets a killed process lose nothing that was committed.
fn configure(connection: &Connection) -> rusqlite::Result<()> {
    connection.busy_timeout(Duration::from_secs(5))?;
    connection.pragma_update(None, "journal_mode", "WAL")?;
    connection.pragma_update(None, "synchronous", "NORMAL")?;
    connection.pragma_update(None, "foreign_keys", true)
}

fn change_tables(connection: &mut Connection, sql: &str) -> rusqlite::Result<()> {
    let change = connection.transaction()?;
    change.execute_batch(sql)?;
    change.pragma_update(None, "user_version", FORMAT)?;
    change.commit()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_index_of_format_1_is_brought_up_to_date() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("sonarium.sqlite");
        let old = TABLES
            .replace(",\n    family      TEXT NOT NULL,\n    rounds      INTEGER NOT NULL", "");
        assert_ne!(old, TABLES);
        let connection = Connection::open(&path).expect("a file");
        connection.execute_batch(&old).expect("tables of format 1");
        connection
            .execute_batch(
                "INSERT INTO session VALUES (1, 'a', 'x', 1, 'p', 'w', '', '{}', 20, '30', 'b', 's', \
                 NULL, '', '', 5, 3); PRAGMA user_version = 1;",
            )
            .expect("a session of format 1");
        drop(connection);
        let connection = open(&path).expect("an index");
        let row = connection
            .query_row("SELECT family, rounds, trials_done FROM session", [], |row| {
                Ok((row.get::<_, String>(0)?, row.get::<_, u32>(1)?, row.get::<_, u32>(2)?))
            })
            .expect("the session");
        assert_eq!(row, ("\"path\"".to_owned(), 20, 3));
    }
}
