//! Going on from a checkpoint, and starting over.

use std::fs;

use super::fixture::*;
use crate::store::{LogRecord, StoreError, read_log, resume_log};

#[test]
fn a_resumed_log_is_the_log_of_a_run_without_a_break() {
    for checkpoint in [0, 1, 10, 23, 24, 30, 60] {
        let (_folder, store) = store();
        let writer = create(&store);
        for part in run(60).chunks(24) {
            write(&writer, part).expect("written");
        }
        drop(writer);
        let resumed = resume_log(&store, ID, checkpoint).expect("resumed");
        let trials_done = (checkpoint / TRIAL_TICKS) as usize;
        assert_eq!(store.ticks(ID, 1, 99), Ok(ticks(1, checkpoint)), "checkpoint {checkpoint}");
        assert_eq!(store.trials(ID).map(|rows| rows.len()), Ok(trials_done));
        assert_eq!(store.events(ID, 99).map(|entries| entries.len()), Ok(trials_done));
        let row = store.session(ID).expect("readable").expect("there");
        assert_eq!((row.tick, row.rounds_done as usize), (checkpoint, trials_done));
        write(&resumed, &run_between(checkpoint + 1, 80)).expect("written");
        resumed.finish().expect("finished");
        assert_eq!(read_all(&store.log_path(ID)), run(80), "checkpoint {checkpoint}");
        assert_eq!(store.ticks(ID, 1, 99), Ok(ticks(1, 80)));
        let log = read_log(&store.log_path(ID)).expect("the log opens");
        assert_eq!(log.header(), Some(&header()));
    }
}

#[test]
fn a_log_that_ends_before_the_checkpoint_is_left_alone() {
    let (_folder, store) = store();
    write_log(&store, &run(20), 7);
    let before = fs::read(store.log_path(ID)).expect("readable");
    let refused = resume_log(&store, ID, 21).map(drop).expect_err("too short");
    assert!(matches!(refused, StoreError::LogTooShort { last_tick: 20, .. }), "{refused}");
    assert_eq!(fs::read(store.log_path(ID)).expect("readable"), before);
    assert_eq!(store.ticks(ID, 1, 99), Ok(ticks(1, 20)));
    let left = fs::read_dir(store.session_folder(ID)).expect("readable").count();
    assert_eq!(left, 1, "nothing but the log is left");
}

#[test]
fn a_cut_off_log_is_resumed_from_what_it_holds() {
    let (_folder, store) = store();
    write_log(&store, &run(60), 24);
    let path = store.log_path(ID);
    let size = fs::metadata(&path).expect("there").len();
    let file = fs::File::options().write(true).open(&path).expect("writable");
    file.set_len(size / 2).expect("cut");
    let recovered = store.recover(ID).expect("recovered");
    assert!(recovered.cut_off && recovered.tick >= 20, "{recovered:?}");
    let resumed = resume_log(&store, ID, 20).expect("resumed");
    resumed.finish().expect("finished");
    assert_eq!(read_all(&path), run(20));
}

#[test]
fn a_reset_puts_the_log_aside_and_starts_from_nothing() {
    let (_folder, store) = store();
    for round in 1..=2 {
        let writer = create(&store);
        write(&writer, &run(20)).expect("written");
        let checkpoint = LogRecord::Checkpoint { trials_done: 2, tick: 20, bytes: vec![1] };
        write(&writer, &[checkpoint]).expect("written");
        writer.finish().expect("finished");
        let aside = store.reset(ID).expect("reset").expect("there was a log");
        assert!(aside.ends_with(format!("log-{round}.mcap")), "{}", aside.display());
        assert_eq!(read_all(&aside), run(20));
        assert_eq!(store.ticks(ID, 1, 99), Ok(vec![]));
        assert_eq!(store.trials(ID), Ok(vec![]));
        assert_eq!(store.checkpoint(ID), Ok(None));
    }
    assert_eq!(store.reset(ID), Ok(None), "nothing to put aside");
}

#[test]
fn names_of_no_session_reach_no_file() {
    let (_folder, store) = store();
    let id = "../../elsewhere";
    let missing = StoreError::NoSession { id: id.into() };
    assert_eq!(store.reset(id), Err(missing.clone()));
    assert_eq!(store.recover(id), Err(missing.clone()));
    assert_eq!(resume_log(&store, id, 1).map(drop), Err(missing));
}
