//! Data folders that can and cannot be used, and the rows in them.

use std::fs;

use super::fixture::*;
use crate::store::{Store, StoreError};
use crate::wire::{NamedSpeed, Speed, State};

#[test]
fn a_folder_that_cannot_be_used_is_refused_with_what_to_do() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("file");
    fs::write(&file, "not a folder").expect("writable");
    let cases = [(file.clone(), "a file stands in its place"), (file.join("below"), "--data")];
    for (path, words) in cases {
        let refused = Store::open(&path).map(drop).expect_err("refused").to_string();
        assert!(refused.contains(words), "{refused}");
        assert!(refused.contains(&path.display().to_string()), "{refused}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_folder_that_cannot_be_written_is_refused() {
    let refused = Store::open("/proc/sonarium".as_ref()).map(drop).expect_err("refused");
    assert!(matches!(refused, StoreError::Folder { .. }), "{refused}");
    assert!(refused.to_string().contains("/proc/sonarium"), "{refused}");
}

#[test]
fn one_folder_serves_one_server_at_a_time() {
    let (folder, store) = store();
    let refused = Store::open(folder.path()).map(drop).expect_err("refused").to_string();
    let process = format!("in use by another Sonarium (process {})", std::process::id());
    assert!(refused.contains(&process), "{refused}");
    let again = store.clone();
    drop(store);
    assert!(Store::open(folder.path()).is_err(), "a clone holds it, too");
    drop(again);
    assert!(Store::open(folder.path()).is_ok());
}

#[test]
fn an_index_of_a_newer_program_is_refused() {
    let (folder, store) = store();
    store.database().pragma_update(None, "user_version", 99).expect("changed");
    drop(store);
    let refused = Store::open(folder.path()).map(drop).expect_err("refused");
    assert!(matches!(refused, StoreError::Newer { found: 99, .. }), "{refused}");
    assert!(refused.to_string().contains("update Sonarium"), "{refused}");
}

#[test]
fn sessions_are_listed_newest_first_and_kept_as_given() {
    let (folder, store) = store();
    store.insert_session(&row("s2")).expect("added");
    let ids = |store: &Store| {
        let rows = store.sessions().expect("readable");
        rows.into_iter().map(|row| row.id).collect::<Vec<_>>()
    };
    assert_eq!(ids(&store), ["s2", "s1"]);
    assert!(store.insert_session(&row("s2")).is_err(), "a name is used once");
    let finished = "2026-01-02T00:00:00Z";
    store.update_state("s2", State::Finished, Some("all trials done"), finished).expect("changed");
    store.update_speed("s2", Speed::Named(NamedSpeed::Max)).expect("changed");
    drop(store);
    let store = Store::open(folder.path()).expect("opens again");
    let mut expected = row("s2");
    expected.state = State::Finished;
    expected.reason = Some("all trials done".into());
    expected.changed_at = finished.into();
    expected.speed = Speed::Named(NamedSpeed::Max);
    assert_eq!(store.session("s2"), Ok(Some(expected)));
}

#[test]
fn a_deleted_session_leaves_nothing() {
    let (_folder, store) = store();
    write_log(&store, &run(20), 20);
    store.delete_session(ID).expect("deleted");
    assert_eq!(store.session(ID), Ok(None));
    assert_eq!(store.trials(ID), Ok(vec![]));
    assert_eq!(store.ticks(ID, 1, 20), Ok(vec![]));
    assert!(!store.session_folder(ID).exists());
    let missing = StoreError::NoSession { id: ID.into() };
    assert_eq!(store.delete_session(ID), Err(missing.clone()));
    assert_eq!(store.update_state(ID, State::Failed, None, ""), Err(missing));
}
