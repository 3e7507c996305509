//! What a live session costs the server: CPU and memory.

use std::thread::sleep;
use std::time::{Duration, Instant};

use serde_json::json;

use super::client::Server;
use super::headless::Folder;
use super::{Failure, Line};

/// Seconds each live measurement takes.
const WINDOW: Duration = Duration::from_secs(10);
const SAMPLES: &str = r#"{"type":"subscribe","tick":30,"depths":30,"neurons":2}"#;
const PICTURES: &str = r#"{"type":"subscribe","tick":30,"depths":30,"neurons":2,
    "arena":{"rate":15,"width":960,"height":640,"theme":"light"}}"#;

/// Share of a core while one viewer watches a session at 30 ticks a second.
pub(super) fn live() -> Result<Vec<Line>, Failure> {
    let folder = Folder::new("bench-live")?;
    let server = Server::start(&folder.0)?;
    let id = start(&server, &json!({ "trials": 100_000, "speed": 30 }))?;
    let mut lines = Vec::new();
    for (name, subscribe, note) in [
        (
            "live without pictures",
            SAMPLES,
            "30 ticks/s, one viewer: tick and depths 30/s, neurons 2/s",
        ),
        ("live with pictures", PICTURES, "the same and 960x640 pictures 15/s on the CPU back end"),
    ] {
        let viewer = server.watch(&id, subscribe)?;
        sleep(Duration::from_secs(2));
        let measured = (0..3).map(|_| cpu_share(&server)).collect::<Result<_, Failure>>()?;
        let bytes = viewer.leave();
        let note = format!("{note}; {} kB sent", bytes / 1024);
        lines.push(Line::new("live", name, "% of a core", measured, &note));
    }
    Ok(lines)
}

/// Resident memory after a session of 500 trials at full speed, with a viewer that also gets pictures.
pub(super) fn memory() -> Result<Vec<Line>, Failure> {
    let folder = Folder::new("bench-memory")?;
    let server = Server::start(&folder.0)?;
    let id = start(&server, &json!({ "trials": 500, "speed": "max" }))?;
    let viewer = server.watch(&id, PICTURES)?;
    while !server.get(&format!("/api/v1/sessions/{id}"))?.contains("\"state\":\"finished\"") {
        sleep(Duration::from_millis(100));
    }
    sleep(Duration::from_secs(1));
    let megabytes = server.metric("process_resident_memory_bytes ")? / f64::from(1 << 20);
    viewer.leave();
    let note = "after a session of 500 trials at full speed with one viewer and its pictures";
    Ok(vec![Line::new("memory", "resident", "MiB", vec![megabytes], note)])
}

fn start(server: &Server, what: &serde_json::Value) -> Result<String, Failure> {
    let mut request = json!({ "experiment": "minimum-cost-path", "seed": 1 });
    if let (Some(request), Some(what)) = (request.as_object_mut(), what.as_object()) {
        request.extend(what.clone());
    }
    let session = server.post("/api/v1/sessions", &request)?;
    let id = session["id"].as_str().unwrap_or_default().to_owned();
    server.post(&format!("/api/v1/sessions/{id}/start"), &json!({}))?;
    Ok(id)
}

fn cpu_share(server: &Server) -> Result<f64, Failure> {
    let (start, before) = (Instant::now(), server.metric("process_cpu_seconds_total ")?);
    sleep(WINDOW);
    let used = server.metric("process_cpu_seconds_total ")? - before;
    Ok(100.0 * used / start.elapsed().as_secs_f64())
}
