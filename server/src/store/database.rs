//! The SQLite file: its settings and its tables.

use std::path::Path;
use std::time::Duration;

use rusqlite::Connection;

use super::StoreError;

/// Format of the tables below, kept in SQLite's `user_version`.
const FORMAT: i64 = 1;

/// Tables of format 1. `chunk`, `trial` and `event` are an index over the logs.
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
    trials_done INTEGER NOT NULL
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

/// Opens the index, creating its tables when it is new.
pub(super) fn open(path: &Path) -> Result<Connection, StoreError> {
    let mut connection = Connection::open(path).map_err(StoreError::index("open the file"))?;
    configure(&connection).map_err(StoreError::index("set up the file"))?;
    let found: i64 = connection
        .pragma_query_value(None, "user_version", |row| row.get(0))
        .map_err(StoreError::index("read the format"))?;
    match found {
        FORMAT => Ok(connection),
        0 => {
            create_tables(&mut connection).map_err(StoreError::index("create the tables"))?;
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

fn create_tables(connection: &mut Connection) -> rusqlite::Result<()> {
    let change = connection.transaction()?;
    change.execute_batch(TABLES)?;
    change.pragma_update(None, "user_version", FORMAT)?;
    change.commit()
}
