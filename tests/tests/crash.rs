//! Killing the server loses the last second at most, and the run goes on to the same bits.

use std::thread::sleep;
use std::time::{Duration, Instant};

use e2e::{Server, sonarium};
use serde_json::{Value, json};

/// Everything in a trial table that a run must repeat. The planner may end after the trials do, and regret
/// is told once it has.
fn trial_table(server: &Server, id: &str) -> Value {
    let start = Instant::now();
    loop {
        let (_, trials) = server.get(&format!("sessions/{id}/trials"));
        if trials[0]["regret"].is_number() {
            return trials;
        }
        assert!(start.elapsed() < Duration::from_secs(60), "still no regret: {trials}");
        sleep(Duration::from_millis(20));
    }
}

#[test]
fn a_killed_session_is_interrupted_and_resumes_to_the_same_bits() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let server = Server::start_on(folder.path());
    let body = json!({"experiment": "minimum-cost-path", "seed": 77, "trials": 12, "speed": 200});
    let id = server.create(&body);
    assert_eq!(server.post(&format!("sessions/{id}/start"), &Value::Null).0, 200);
    let before =
        server.wait(&id, "in trial 6", |session| session["trials_done"].as_u64() >= Some(5));
    server.kill();

    let server = Server::start_on(folder.path());
    let (_, session) = server.get(&format!("sessions/{id}"));
    assert_eq!(session["state"], "interrupted", "{session}");
    let known_tick = before["tick"].as_u64().expect("a tick");
    let kept = server.get(&format!("sessions/{id}/ticks?from=1&to=10000")).1;
    let kept = kept.as_array().expect("ticks");
    // At 200 ticks a second the last second is 200 ticks; the chunk being closed may hold as many.
    let last = kept.last().and_then(|tick| tick["tick"].as_u64()).expect("some ticks were kept");
    assert!(last + 400 >= known_tick, "kept {last} of at least {known_tick}");
    assert_eq!(kept.len() as u64, last, "no tick is missing or twice");

    assert_eq!(server.post(&format!("sessions/{id}/speed"), &json!({"speed": "max"})).0, 200);
    let (status, ack) = server.post(&format!("sessions/{id}/resume"), &Value::Null);
    assert_eq!(status, 200, "{ack}");
    let _ = server.wait(&id, "finished", |session| session["state"] == "finished");

    let whole = server.create(&json!({
        "experiment": "minimum-cost-path", "seed": 77, "trials": 12, "speed": "max"
    }));
    assert_eq!(server.post(&format!("sessions/{whole}/start"), &Value::Null).0, 200);
    let _ = server.wait(&whole, "finished", |session| session["state"] == "finished");
    assert_eq!(trial_table(&server, &id), trial_table(&server, &whole));
    let ticks = |id: &str| server.get(&format!("sessions/{id}/ticks?from=1&to=10000")).1;
    assert_eq!(ticks(&id), ticks(&whole), "every tick, to the bit");
}

#[test]
fn the_command_line_and_the_server_give_the_same_trial_table() {
    let server = Server::start();
    let id = server.create(&json!({
        "experiment": "minimum-cost-path", "seed": 5, "trials": 20, "speed": "max"
    }));
    assert_eq!(server.post(&format!("sessions/{id}/start"), &Value::Null).0, 200);
    let _ = server.wait(&id, "finished", |session| session["state"] == "finished");
    let run = sonarium(&["run", "minimum-cost-path", "--seed", "5", "--trials", "20", "--json"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let result: Value = serde_json::from_str(&run.stdout).expect("one JSON object");
    assert_eq!(result["trials"], trial_table(&server, &id));
}
