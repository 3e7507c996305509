//! What is written is what is read, while it is written and after.

use std::fs;
use std::thread;
use std::time::{Duration, Instant};

use proptest::prelude::*;
use serde_json::Value;

use super::fixture::*;
use crate::store::record::Topic;
use crate::store::{LogRecord, LogWriter, StoreError, StoredCheckpoint, json_schema, read_log};
use crate::wire::TickView;

#[test]
fn a_finished_log_gives_back_every_record_in_order() {
    let (_folder, store) = store();
    write_log(&store, &run(95), 20);
    let log = read_log(&store.log_path(ID)).expect("the log opens");
    assert_eq!(log.header(), Some(&header()));
    assert_eq!(read_all(&store.log_path(ID)), run(95));
    assert_eq!(store.ticks(ID, 1, 95).as_deref(), Ok(&ticks(1, 95)[..]));
    let rows: Vec<_> = (1..=9).map(|n| trial_end(n).trial).collect();
    assert_eq!(store.trials(ID), Ok(rows));
    for n in 1..=9 {
        assert_eq!(store.trial_end(ID, n), Ok(Some(trial_end(n))), "trial {n}");
    }
    assert_eq!(store.trial_end(ID, 10), Ok(None), "it has not ended");
    assert_eq!(store.events(ID, 2), Ok(vec![entry(80), entry(90)]));
    let row = store.session(ID).expect("readable").expect("there");
    assert_eq!((row.tick, row.rounds_done), (95, 9));
}

#[test]
fn ranges_of_ticks() {
    let (_folder, store) = store();
    write_log(&store, &run(50), 7);
    for (from, to, expected) in [
        (1, 1, ticks(1, 1)),
        (7, 8, ticks(7, 8)),
        (0, u64::MAX, ticks(1, 50)),
        (50, 60, ticks(50, 50)),
        (51, 60, vec![]),
        (9, 3, vec![]),
    ] {
        assert_eq!(store.ticks(ID, from, to), Ok(expected.clone()), "ticks {from} to {to}");
        let json = store.ticks_json(ID, from, to).expect("readable");
        assert_eq!(serde_json::from_slice::<Vec<TickView>>(&json).ok(), Some(expected));
    }
}

#[test]
fn any_reader_of_mcap_files_finds_channels_and_schemas() {
    let (_folder, store) = store();
    write_log(&store, &run(20), 5);
    let bytes = fs::read(store.log_path(ID)).expect("readable");
    let messages: Vec<_> = mcap::MessageStream::new(&bytes)
        .expect("a whole MCAP file")
        .map(|message| message.expect("every checksum holds"))
        .collect();
    assert_eq!(messages.len(), 1 + 20 + 2 + 2);
    for message in &messages {
        assert_eq!(message.channel.message_encoding, "json");
        let schema = message.channel.schema.as_ref().expect("every channel has a schema");
        assert_eq!(schema.encoding, "jsonschema");
        let schema: Value = serde_json::from_slice(&schema.data).expect("the schema is JSON");
        let body: Value = serde_json::from_slice(&message.data).expect("the message is JSON");
        assert_fits(&schema, &body);
    }
    let summary = mcap::Summary::read(&bytes).expect("readable").expect("there");
    assert_eq!(summary.stats.map(|stats| stats.message_count), Some(25));
}

/// Every field of an object is described, and every required one is there.
fn assert_fits(schema: &Value, body: &Value) {
    let fields = body.as_object().expect("messages are objects");
    for (name, value) in fields {
        let field = &schema["properties"][name];
        assert!(!field.is_null(), "{name} is not in {}", schema["title"]);
        if value.is_object() && field["properties"].is_object() {
            assert_fits(field, value);
        }
    }
    for required in schema["required"].as_array().into_iter().flatten() {
        assert!(fields.contains_key(required.as_str().unwrap_or("?")), "{required} is missing");
    }
}

#[test]
fn schemas_refer_to_nothing_outside_themselves() {
    for topic in Topic::ALL {
        let (name, schema) = json_schema::of_topic(topic);
        let text = String::from_utf8(schema).expect("JSON");
        assert!(!text.contains("$ref"), "{name}: {text}");
    }
}

#[test]
fn a_reader_sees_a_growing_run_without_gaps() {
    let (_folder, store) = store();
    let writer = create(&store);
    thread::scope(|scope| {
        let writing = scope.spawn(|| {
            for part in run(400).chunks(13) {
                write(&writer, part).expect("records are written");
            }
        });
        while !writing.is_finished() {
            let seen = store.ticks(ID, 1, u64::MAX).expect("readable at any time");
            assert_eq!(seen, ticks(1, seen.len() as u64));
        }
    });
    assert_eq!(store.ticks(ID, 1, 400), Ok(ticks(1, 400)), "flushed, not finished");
}

#[test]
fn ticks_reach_the_disk_without_being_asked() {
    let (_folder, store) = store();
    let writer = create(&store);
    writer.write(LogRecord::Tick(Box::new(tick(1)))).expect("taken");
    let patience = Instant::now() + Duration::from_secs(60);
    while store.ticks(ID, 1, 1) != Ok(ticks(1, 1)) {
        assert!(Instant::now() < patience, "the writer never closed its chunk");
        thread::yield_now();
    }
}

#[test]
fn the_newest_checkpoint_wins_and_covers_what_is_on_disk() {
    let (_folder, store) = store();
    let writer = create(&store);
    assert_eq!(store.checkpoint(ID), Ok(None));
    for n in [10, 20, 30] {
        let trials_done = (n / TRIAL_TICKS) as u32;
        let bytes = vec![trials_done as u8; 3];
        writer.write(LogRecord::Tick(Box::new(tick(n)))).expect("taken");
        writer.write(LogRecord::Checkpoint { trials_done, tick: n, bytes }).expect("taken");
    }
    writer.flush().expect("written");
    let newest = StoredCheckpoint { trials_done: 3, tick: 30, bytes: vec![3; 3] };
    assert_eq!(store.checkpoint(ID), Ok(Some(newest)));
    assert_eq!(store.ticks(ID, 30, 30), Ok(ticks(30, 30)));
}

#[test]
fn a_session_with_ticks_is_not_started_over_by_mistake() {
    let (_folder, store) = store();
    write_log(&store, &run(12), 12);
    let refused = LogWriter::create(&store, ID, &header()).map(drop);
    assert_eq!(refused, Err(StoreError::LogExists { id: ID.into(), tick: 12 }));
    assert_eq!(store.ticks(ID, 1, 12), Ok(ticks(1, 12)));
}

#[test]
fn the_same_run_writes_the_same_messages() {
    let messages = |chunk| {
        let (_folder, store) = store();
        write_log(&store, &run(30), chunk);
        let bytes = fs::read(store.log_path(ID)).expect("readable");
        let stream = mcap::MessageStream::new(&bytes).expect("a whole MCAP file");
        stream
            .map(|message| message.expect("readable"))
            .map(|m| (m.channel.id, m.sequence, m.log_time, m.data.into_owned()))
            .collect::<Vec<_>>()
    };
    assert_eq!(messages(3), messages(11), "however it was cut into chunks");
}

proptest! {
    #[test]
    fn numbers_survive_the_log_to_the_bit(bits in prop::collection::vec(any::<u64>(), 24)) {
        let finite = |bits: &u64| Some(f64::from_bits(*bits)).filter(|x| x.is_finite());
        let mut before = tick(1);
        before.sonar_m = bits.iter().filter_map(finite).collect();
        let json = serde_json::to_vec(&before).expect("JSON");
        let after: TickView = serde_json::from_slice(&json).expect("readable");
        let exact = |view: &TickView| view.sonar_m.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        prop_assert_eq!(exact(&after), exact(&before));
        prop_assert_eq!(after.goal_bearing_deg.to_bits(), (-0.0_f64).to_bits());
    }
}
