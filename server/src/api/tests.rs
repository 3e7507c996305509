//! The interface as its users see it.

use axum::body::Body;
use axum::http::{Request, StatusCode, header};
use serde_json::{Value as Json, json};

use crate::session::Control;
use crate::testing::{Answer, House, MAX, SLOW, undisturbed};
use crate::wire::State;

mod worlds;

/// A problem names its field and has the right type.
fn problem(answer: &Answer) -> (u16, Json) {
    let json = answer.json();
    assert_eq!(answer.kind, "application/problem+json", "{json}");
    assert_eq!(json["status"], answer.status.as_u16());
    assert!(json["detail"].as_str().is_some_and(|detail| !detail.is_empty()), "{json}");
    (answer.status.as_u16(), json["field"].clone())
}

#[tokio::test]
async fn bad_sessions_are_refused_by_field() {
    let house = House::new();
    let with = |fields: &str| format!(r#"{{"experiment":"minimum-cost-path",{fields}}}"#);
    for (body, status, field) in [
        (r#"{"experiment":"moon-landing"}"#.to_owned(), 422, json!("experiment")),
        (r#"{"experiment":7}"#.to_owned(), 400, json!("experiment")),
        ("{}".to_owned(), 400, json!("experiment")),
        (with(r#""colour":"red""#), 400, json!("colour")),
        (with(r#""seed":-1"#), 400, json!("seed")),
        (with(r#""seed":1.5"#), 400, json!("seed")),
        (with(r#""seed":9007199254740992"#), 422, json!("seed")),
        (with(r#""trials":0"#), 422, json!("trials")),
        (with(r#""trials":100001"#), 422, json!("trials")),
        (with(r#""trials":"many""#), 400, json!("trials")),
        (with(r#""speed":0.05"#), 422, json!("speed")),
        (with(r#""speed":10001"#), 422, json!("speed")),
        (with(r#""speed":"fast""#), 400, json!("speed")),
        (with(r#""settings":7"#), 400, json!("settings")),
        (with(r#""settings":{"sonar.nois":0.1}"#), 422, json!("settings.sonar.nois")),
        (with(r#""settings":{"sonar.noise":7}"#), 422, json!("settings.sonar.noise")),
        (with(r#""settings":{"sonar.noise":"much"}"#), 422, json!("settings.sonar.noise")),
        (with(r#""settings":{"sonar.noise":null}"#), 422, json!("settings.sonar.noise")),
        (with(r#""settings":{"world":"moon"}"#), 422, json!("settings.world")),
        (with(r#""settings":{"world":1}"#), 422, json!("settings.world")),
        (with(r#""settings":{"preset":"x"}"#), 422, json!("settings.preset")),
        ("{".to_owned(), 400, Json::Null),
        ("[]".to_owned(), 400, Json::Null),
        (with(r#""seed":1"#) + "x", 400, Json::Null),
        (String::new(), 400, Json::Null),
    ] {
        let answer = house.request("POST", "/api/v1/sessions", Some(body.clone())).await;
        assert_eq!(problem(&answer), (status, field), "{body}");
    }
    assert_eq!(house.get("/api/v1/sessions").await.json(), json!([]), "nothing was created");
}

#[tokio::test]
async fn bad_requests_are_refused_by_field() {
    let house = House::new();
    let id = house.session(1, MAX);
    house.control(&id, Control::Start).await;
    house.until_state(&id, State::Finished).await;
    for (method, path, status, field) in [
        ("GET", "/api/v1/nothing", 404, Json::Null),
        ("GET", "/api/nothing", 404, Json::Null),
        ("PUT", "/api/v1/sessions", 405, Json::Null),
        ("GET", "/api/v1/sessions/{id}/start", 405, Json::Null),
        ("GET", "/api/v1/sessions/none", 404, Json::Null),
        ("DELETE", "/api/v1/sessions/none", 404, Json::Null),
        ("POST", "/api/v1/sessions/none/start", 404, Json::Null),
        ("GET", "/api/v1/sessions/none/stream", 404, Json::Null),
        ("GET", "/api/v1/sessions/{id}/stream", 426, Json::Null),
        ("GET", "/api/v1/sessions/{id}/stream?since=x", 400, json!("since")),
        ("POST", "/api/v1/sessions/{id}/start", 409, Json::Null),
        ("POST", "/api/v1/sessions/{id}/stop", 409, Json::Null),
        ("GET", "/api/v1/sessions/{id}/trials/2", 404, json!("trial")),
        ("GET", "/api/v1/sessions/{id}/trials/x", 400, json!("trial")),
        ("GET", "/api/v1/sessions/{id}/neurons/99999", 404, json!("neuron")),
        ("GET", "/api/v1/sessions/{id}/ticks?from=0", 422, json!("from")),
        ("GET", "/api/v1/sessions/{id}/ticks?from=5&to=4", 422, json!("to")),
        ("GET", "/api/v1/sessions/{id}/ticks?to=10001", 422, json!("to")),
        ("GET", "/api/v1/sessions/{id}/ticks?until=7", 400, json!("until")),
        ("GET", "/api/v1/sessions/{id}/report.pdf", 404, json!("file")),
        ("GET", "/api/v1/sessions/{id}/trials/1/report.pdf", 404, json!("file")),
        ("GET", "/api/v1/sessions/{id}/trials/9/report.html", 404, json!("trial")),
        ("GET", "/api/v1/sessions/{id}/arena.png?width=0", 422, json!("width")),
        ("GET", "/api/v1/sessions/{id}/arena.png?height=4097", 422, json!("height")),
        ("GET", "/api/v1/sessions/{id}/arena.png?theme=red", 400, json!("theme")),
        ("GET", "/api/v1/sessions/{id}/arena.png?trial=7", 404, json!("trial")),
        ("GET", "/api/v1/experiments/none", 404, Json::Null),
        ("GET", "/api/v1/experiments/minimum-cost-path/picture.png?world=x", 422, json!("world")),
    ] {
        let path = path.replace("{id}", &id);
        let answer = house.request(method, &path, None).await;
        assert_eq!(problem(&answer), (status, field), "{method} {path}");
    }
}

#[tokio::test]
async fn a_session_is_created_run_and_read() {
    let house = House::new();
    let body = json!({ "experiment": "minimum-cost-path", "seed": 1, "trials": 3, "speed": "max",
        "settings": { "sonar.rays": 5 } });
    let created = house.post("/api/v1/sessions", body).await;
    assert_eq!(created.status, StatusCode::CREATED);
    let session = created.json();
    assert_eq!(session["state"], "queued");
    assert_eq!(session["controls"], json!(["start", "step", "stop"]));
    assert_eq!(session["settings"]["world"], "laboratory");
    let id = session["id"].as_str().expect("an identifier").to_owned();
    let path = |rest: &str| format!("/api/v1/sessions/{id}{rest}");

    let started = house.post(&path("/start"), json!({})).await;
    assert_eq!(started.json(), json!({ "state": "running", "tick": 0 }));
    house.until_state(&id, State::Finished).await;

    let trials = house.get(&path("/trials")).await.json();
    assert_eq!(trials, json!(undisturbed(3)));
    let ticks = house.get(&path("/ticks?from=2&to=4")).await.json();
    let numbers: Vec<_> = ticks.as_array().expect("a list").iter().map(|t| &t["tick"]).collect();
    assert_eq!(json!(numbers), json!([2, 3, 4]));
    let neurons = house.get(&path("/neurons")).await.json();
    assert_eq!(neurons.as_array().map(Vec::len), trials[2]["neurons"].as_u64().map(|n| n as usize));
    let first = &neurons[0]["id"];
    let neuron = house.get(&path(&format!("/neurons/{first}"))).await.json();
    assert_eq!(neuron["centre"].as_array().map(Vec::len), Some(32));
    let network = house.get(&path("/network")).await.json();
    assert_eq!((&network["format"], &network["trials"]), (&json!("sonarium-network"), &json!(3)));
    let starts = house.get(&path("/starts?at=1,0.5,90;-1,-2,0")).await.json();
    let starts = starts.as_array().expect("a list");
    assert_eq!(
        starts.iter().map(|s| &s["start"]["y_m"]).collect::<Vec<_>>(),
        [&json!(0.5), &json!(-2.0)]
    );
    assert!(
        starts
            .iter()
            .all(|s| s["alone"]["path_m"][0] == json!([s["start"]["x_m"], s["start"]["y_m"]]))
    );
    let picture = house.get(&path("/starts.png?at=1,0.5,90&width=120&height=90")).await;
    assert_eq!((picture.status, picture.kind.as_str()), (StatusCode::OK, "image/png"));
    for (at, says) in
        [("1,2", "three numbers"), ("-1.49,0,0", "touch a wall"), ("99,0,0", "within")]
    {
        let refused = house.get(&path(&format!("/starts?at={at}"))).await;
        assert_eq!(refused.status, StatusCode::UNPROCESSABLE_ENTITY, "{at}");
        assert!(refused.json()["detail"].as_str().is_some_and(|d| d.contains(says)), "{at}");
    }
    assert_eq!(house.request("DELETE", &path(""), None).await.status, StatusCode::NO_CONTENT);
    assert_eq!(house.get(&path("")).await.status, StatusCode::NOT_FOUND);
}

#[tokio::test]
async fn a_seed_that_nobody_gave_is_drawn_and_shown() {
    let house = House::new();
    let body = json!({ "experiment": "minimum-cost-path" });
    let session = house.post("/api/v1/sessions", body).await.json();
    assert!(session["seed"].is_u64());
    assert_eq!((&session["trials"], &session["speed"]), (&json!(20), &json!(30.0)));
}

#[tokio::test]
async fn every_download_is_what_it_says() {
    let house = House::new();
    let id = house.session(2, MAX);
    house.control(&id, Control::Start).await;
    house.until_state(&id, State::Finished).await;
    for (file, kind, start) in [
        ("report.html", "text/html; charset=utf-8", &b"<!doctype html>"[..]),
        ("report.json", "application/json", b"{"),
        ("report.csv", "text/csv; charset=utf-8", b"trial,"),
        ("report.zip", "application/zip", b"PK"),
        ("log.mcap", "application/octet-stream", b"\x89MCAP"),
        ("arena.png", "image/png", b"\x89PNG"),
        ("arena.png?trial=2&width=1000&height=300&theme=dark", "image/png", b"\x89PNG"),
        ("trials/1/report.html", "text/html; charset=utf-8", b"<!doctype html>"),
        ("trials/1/report.json", "application/json", b"{"),
        ("trials/1/report.csv", "text/csv; charset=utf-8", b"tick,"),
        ("trials/1/report.png", "image/png", b"\x89PNG"),
    ] {
        let answer = house.get(&format!("/api/v1/sessions/{id}/{file}")).await;
        assert_eq!((answer.status, answer.kind.as_str()), (StatusCode::OK, kind), "{file}");
        let begins = answer.bytes[..start.len()].eq_ignore_ascii_case(start);
        assert!(begins, "{file} begins with {:?}", &answer.bytes[..start.len()]);
    }
    let picture = house.get("/api/v1/experiments/minimum-cost-path/picture.png?width=99").await;
    assert_eq!(picture.bytes[16..20], [0, 0, 0, 99], "the width");
}

#[tokio::test]
async fn the_log_of_a_running_session_is_read_up_to_the_present() {
    let house = House::new();
    let id = house.session(50, SLOW);
    house.control(&id, Control::Step(Default::default())).await;
    house.control(&id, Control::Resume).await;
    let ticks = house.get(&format!("/api/v1/sessions/{id}/ticks")).await.json();
    let tick = house.lab().session(&id).expect("it is there").tick;
    assert!(ticks.as_array().is_some_and(|ticks| ticks.len() as u64 >= tick.min(1)), "{ticks}");
    let delete = house.request("DELETE", &format!("/api/v1/sessions/{id}"), None).await;
    assert_eq!(problem(&delete), (409, Json::Null));
    house.lab().close().await;
}

#[tokio::test]
async fn a_session_may_bring_a_large_network_and_not_more() {
    let house = House::new();
    // Two mebibytes of blanks before the request: a network of some 3000 neurons takes as much.
    let mut body = vec![b' '; 2 << 20];
    body.extend_from_slice(br#"{"experiment": "minimum-cost-path", "trials": 1}"#);
    let request =
        Request::post("/api/v1/sessions").header(header::CONTENT_TYPE, "application/json");
    let answer = house.send(request.body(Body::from(body)).expect("a request")).await;
    assert_eq!(answer.status, StatusCode::CREATED);
    // 100,000 neurons of 2 KiB and a mebibyte for the rest, rounded down.
    let announced = Request::post("/api/v1/sessions").header(header::CONTENT_LENGTH, 300 << 20);
    let announced = announced.header(header::CONTENT_TYPE, "application/json");
    let answer = house.send(announced.body(Body::empty()).expect("a request")).await;
    assert_eq!(problem(&answer), (413, Json::Null));
    assert_eq!(answer.json()["detail"], "a body may have at most 196 MiB here");
}

#[tokio::test]
async fn a_body_over_one_mebibyte_is_refused() {
    let house = House::new();
    let large = vec![b' '; (1 << 20) + 1];
    let announced =
        Request::post("/api/v1/sessions/any/speed").header(header::CONTENT_LENGTH, large.len());
    let silent = Request::post("/api/v1/sessions/any/speed");
    for request in [announced, silent] {
        let request = request.header(header::CONTENT_TYPE, "application/json");
        let answer = house.send(request.body(Body::from(large.clone())).expect("a request")).await;
        assert_eq!(problem(&answer), (413, Json::Null));
    }
}

#[tokio::test]
async fn a_foreign_host_origin_or_body_is_refused() {
    let house = House::new();
    let foreign = Request::get("/api/v1/sessions").header(header::HOST, "example.org");
    let answer = house.send(foreign.body(Body::empty()).expect("a request")).await;
    assert_eq!(problem(&answer), (421, Json::Null));
    let elsewhere = Request::post("/api/v1/sessions")
        .header(header::HOST, "localhost:7380")
        .header(header::ORIGIN, "http://example.org");
    let answer = house.send(elsewhere.body(Body::from("{}")).expect("a request")).await;
    assert_eq!(problem(&answer), (403, Json::Null));
    let form = Request::post("/api/v1/sessions").header(header::CONTENT_TYPE, "text/plain");
    let answer = house.send(form.body(Body::from("{}")).expect("a request")).await;
    assert_eq!(problem(&answer), (415, Json::Null));
}

#[tokio::test]
async fn the_interface_describes_itself() {
    let house = House::new();
    let document = house.get("/api/openapi.json").await.json();
    let paths = document["paths"].as_object().expect("paths");
    for (path, methods) in [
        ("/sessions", &["get", "post"][..]),
        ("/sessions/{id}", &["delete", "get"]),
        ("/sessions/{id}/start", &["post"]),
        ("/sessions/{id}/trials/{trial}", &["get"]),
        ("/sessions/{id}/arena.png", &["get"]),
        ("/experiments/{name}", &["get"]),
        ("/worlds/{name}", &["delete", "get", "put"]),
        ("/worlds/trace", &["post"]),
    ] {
        let described: Vec<&String> = paths[path].as_object().expect(path).keys().collect();
        assert_eq!(described, methods, "{path}");
    }
    let page = house.get("/api/docs/").await;
    assert_eq!((page.status, page.kind.as_str()), (StatusCode::OK, "text/html"));
    assert_eq!(house.get("/healthz").await.bytes, "ok\n");
    house.session(1, SLOW);
    let metrics = house.get("/metrics").await;
    let text = String::from_utf8_lossy(&metrics.bytes).into_owned();
    assert!(text.contains("sonarium_sessions{state=\"queued\"} 1\n"), "{text}");
}
