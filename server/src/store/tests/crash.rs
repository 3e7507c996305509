//! Logs that end where nobody meant them to.

use std::fs;
use std::path::Path;

use super::fixture::*;
use crate::store::read::Blocks;
use crate::store::{LogRecord, Store, StoreError, read_log};
use crate::wire::State;

/// Bytes of a finished log of 60 ticks and the places of its chunks' ends.
fn log_bytes() -> (Vec<u8>, Vec<u64>) {
    let (_folder, store) = store();
    write_log(&store, &run(60), 24);
    let path = store.log_path(ID);
    let mut blocks = Blocks::open(&path).expect("the log opens");
    let mut ends = Vec::new();
    while let Some(block) = blocks.next_block().expect("readable") {
        ends.push(block.offset + block.length);
    }
    assert_eq!(ends.len(), 4, "a header and three chunks of records");
    (fs::read(&path).expect("readable"), ends)
}

/// What can be read of a file with these bytes, and whether reading ended with an error.
fn read_bytes(folder: &Path, bytes: &[u8]) -> (Vec<LogRecord>, Option<StoreError>) {
    let path = folder.join("log.mcap");
    fs::write(&path, bytes).expect("writable");
    let mut records = Vec::new();
    match read_log(&path) {
        Err(e) => return (records, Some(e)),
        Ok(log) => {
            for record in log {
                match record {
                    Ok(record) => records.push(record),
                    Err(e) => return (records, Some(e)),
                }
            }
        }
    }
    (records, None)
}

#[test]
fn a_log_cut_anywhere_gives_every_chunk_before_the_cut() {
    let (bytes, ends) = log_bytes();
    let folder = tempfile::tempdir().expect("a temporary folder");
    let all = run(60);
    let in_last_chunk = (ends[2]..=ends[3]).step_by(11);
    let elsewhere = (0..ends[2]).chain(ends[3]..bytes.len() as u64).step_by(503);
    for cut in elsewhere.chain(in_last_chunk).chain(ends.clone()) {
        let cut = cut as usize;
        let (records, error) = read_bytes(folder.path(), &bytes[..cut]);
        assert_eq!(error, None, "cut at {cut}");
        let whole = ends[1..].iter().filter(|&&end| end <= cut as u64).count();
        let least = (24 * whole).min(all.len());
        assert!(records.len() >= least, "cut at {cut}: {} of {least} records", records.len());
        assert_eq!(records, all[..records.len()], "cut at {cut}");
    }
}

#[test]
fn a_damaged_log_gives_what_comes_before_the_damage_and_says_where_it_is() {
    let (bytes, ends) = log_bytes();
    let folder = tempfile::tempdir().expect("a temporary folder");
    let all = run(60);
    for at in (8..bytes.len()).step_by(131) {
        let mut damaged = bytes.clone();
        damaged[at] ^= 0x55;
        let (records, _) = read_bytes(folder.path(), &damaged);
        assert_eq!(records, all[..records.len()], "damage at {at}");
    }
    let mut damaged = bytes.clone();
    damaged[ends[1] as usize + 200] ^= 0x55;
    let (records, error) = read_bytes(folder.path(), &damaged);
    assert_eq!(records, all[..24]);
    let Some(StoreError::Damaged { offset, .. }) = error else { panic!("no damage: {error:?}") };
    assert_eq!(offset, ends[1]);
}

#[test]
fn a_chunk_is_never_passed_over_for_something_else() {
    let (bytes, ends) = log_bytes();
    let folder = tempfile::tempdir().expect("a temporary folder");
    let all = run(60);
    for changed in 1..=255 {
        let mut damaged = bytes.clone();
        damaged[ends[1] as usize] ^= changed;
        let (records, error) = read_bytes(folder.path(), &damaged);
        assert_eq!(records, all[..records.len()], "changed by {changed:#04x}");
        let Some(StoreError::Damaged { offset, .. }) = error else {
            panic!("changed by {changed:#04x}: {error:?}")
        };
        assert_eq!(offset, ends[1]);
    }
}

#[test]
fn other_files_are_not_logs() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut foreign = Vec::new();
    let mut writer = mcap::Writer::new(std::io::Cursor::new(&mut foreign)).expect("a file");
    writer.add_channel(0, "/camera", "json", &Default::default()).expect("a channel");
    writer.finish().expect("finished");
    drop(writer);
    for (bytes, words) in [(&b"PNG, or so"[..], "does not start like"), (&foreign[..], "/camera")] {
        let (_, error) = read_bytes(folder.path(), bytes);
        let error = error.expect("refused").to_string();
        assert!(error.contains(words), "{error}");
    }
    let missing = read_log(&folder.path().join("none.mcap")).map(drop);
    assert!(matches!(missing, Err(StoreError::File { .. })), "{missing:?}");
}

/// A copy of a data folder as a killed server would have left it.
fn killed(store: &Store) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let session = folder.path().join("sessions").join(ID);
    fs::create_dir_all(&session).expect("a folder");
    for name in ["sonarium.sqlite", "sonarium.sqlite-wal", "sessions/s1/log.mcap"] {
        let from = store.folder().join(name);
        if from.exists() {
            fs::copy(from, folder.path().join(name)).expect("copied");
        }
    }
    folder
}

#[test]
fn a_killed_server_leaves_interrupted_sessions_with_all_that_was_flushed() {
    for (state, after) in [
        (State::Starting, State::Interrupted),
        (State::Running, State::Interrupted),
        (State::Paused, State::Interrupted),
        (State::Stopping, State::Interrupted),
        (State::Queued, State::Interrupted),
        (State::Stopped, State::Stopped),
        (State::Failed, State::Failed),
    ] {
        let (_folder, store) = store();
        store.update_state(ID, state, None, "2026-01-01T00:00:02Z").expect("changed");
        let writer = create(&store);
        write(&writer, &run(25)).expect("written");
        let left = killed(&store);
        let reopened = Store::open(left.path()).expect("the folder opens");
        let row = reopened.session(ID).expect("readable").expect("there");
        assert_eq!((row.state, row.tick, row.rounds_done), (after, 25, 2), "was {state:?}");
        assert_eq!(row.reason.is_some(), after == State::Interrupted);
        assert_eq!(reopened.ticks(ID, 1, 99), Ok(ticks(1, 25)));
    }
}

#[test]
fn a_queued_session_that_never_started_stays_queued() {
    let (_folder, store) = store();
    store.update_state(ID, State::Queued, None, "2026-01-01T00:00:02Z").expect("changed");
    let left = killed(&store);
    let reopened = Store::open(left.path()).expect("the folder opens");
    assert_eq!(reopened.session(ID).map(|row| row.map(|row| row.state)), Ok(Some(State::Queued)));
}

#[test]
fn one_unreadable_log_does_not_keep_the_others_from_being_served() {
    let (_folder, store) = store();
    fs::write(store.log_path(ID), "not a log").expect("writable");
    let left = killed(&store);
    let reopened = Store::open(left.path()).expect("the folder opens");
    let row = reopened.session(ID).expect("readable").expect("there");
    assert_eq!(row.state, State::Interrupted);
    let reason = row.reason.unwrap_or_default();
    assert!(reason.contains("is not a Sonarium log"), "{reason}");
}

#[test]
fn recovery_rebuilds_the_index_the_writer_made() {
    let (_folder, store) = store();
    write_log(&store, &run(60), 24);
    let before = index_text(&store);
    store.replace_chunks(ID, &[], || Ok(())).expect("emptied");
    assert_eq!(store.ticks(ID, 1, 60), Ok(vec![]));
    let recovered = store.recover(ID).expect("recovered");
    assert_eq!((recovered.tick, recovered.trials_done, recovered.cut_off), (60, 6, false));
    assert_eq!(recovered.damage, None);
    assert_eq!(index_text(&store), before);
}

/// The chunk table as text.
fn index_text(store: &Store) -> Vec<String> {
    let database = store.database();
    let mut statement = database.prepare("SELECT * FROM chunk ORDER BY offset").expect("SQL");
    let rows = statement.query_map([], |row| {
        let number = |column| row.get::<_, Option<i64>>(column);
        Ok(format!("{:?}", (1..7).map(number).collect::<rusqlite::Result<Vec<_>>>()?))
    });
    rows.expect("rows").map(|row| row.expect("a row")).collect()
}
