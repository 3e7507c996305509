//! Sessions of chapter 2: the same runs at any pace, resumed or not, and what an operator does to them.

use axum::http::StatusCode;
use serde_json::{Value as Json, json};

use super::Control;
use crate::batch;
use crate::catalog::{Catalog, Job};
use crate::testing::{House, MAX, SLOW};
use crate::wire::{DriveOutcome, DriveRunView, NewSession, Round, Speed, State, StepUnit};

use Control::{Resume, Start, Stop};
const CYCLE: Control = Control::Step(StepUnit::Tick);
const RUN: Control = Control::Step(StepUnit::Trial);

fn request(experiment: &str, runs: u32, settings: Json, speed: Speed) -> NewSession {
    let body =
        json!({ "experiment": experiment, "seed": 300, "trials": runs, "settings": settings });
    NewSession { speed: Some(speed), ..serde_json::from_value(body).expect("a request") }
}

/// A short corridor with one door and two people.
fn corridor() -> Json {
    json!({ "corridor.length": 12, "corridor.doors": 1, "people.count": 2, "compare": true })
}

/// The runs that nothing disturbed.
fn undisturbed(request: &NewSession) -> Vec<DriveRunView> {
    let catalog = Catalog::load(None).expect("the embedded files");
    match catalog.job(request).expect("a good request") {
        Job::Plain(plan) => batch::drive(&plan, || {}).expect("good settings").episodes,
        Job::Path(_) => panic!("{} is not of chapter 2", request.experiment),
    }
}

fn runs(house: &House, id: &str) -> Vec<DriveRunView> {
    let rounds = house.lab().store().rounds(id).expect("readable").into_iter();
    let run = |round| match round {
        Round::Run(run) => *run,
        Round::Trial(_) | Round::Episode(_) => panic!("no run in a session of chapter 2"),
    };
    rounds.map(run).collect()
}

#[tokio::test]
async fn every_experiment_of_chapter_2_runs_live_as_headless() {
    let house = House::new();
    for (experiment, settings, rounds) in [
        ("wall-approach", json!({}), 2),
        ("block-world", json!({ "trial.time_limit": 20 }), 2),
        ("corridor", corridor(), 4),
    ] {
        let request = request(experiment, 2, settings, MAX);
        let id = house.lab().create(&request).expect("a good request").id;
        house.control(&id, Start).await;
        let session = house.until_state(&id, State::Finished).await;
        assert_eq!((session.rounds, session.rounds_done), (rounds, rounds), "{experiment}");
        let expected = undisturbed(&request);
        assert_eq!(runs(&house, &id), expected, "{experiment}");
        let last = expected.last().expect("a run").last_tick;
        let cycles = house.lab().store().cycles(&id, 1, u64::MAX).expect("readable");
        let numbers: Vec<u64> = cycles.iter().map(|cycle| cycle.tick).collect();
        assert_eq!(numbers, (1..=last).collect::<Vec<_>>(), "{experiment}: each cycle once");
    }
}

#[test]
fn regions_of_one_s_own_are_those_that_are_read() {
    const THESIS: &str = "0,1,2; 1,2,3,4; 3,4,5,6; 5,6,7,8; 7,8,9";
    // The readings are the same, so that runs are the same if and only if the regions are.
    for (experiment, settings) in [
        ("wall-approach", json!({})),
        ("block-world", json!({ "trial.time_limit": 20 })),
        ("corridor", corridor()),
    ] {
        let with = |sets: &str| {
            let mut settings = settings.clone();
            settings["hashing.sets"] = sets.into();
            undisturbed(&request(experiment, 1, settings, MAX))
        };
        let usual = with("");
        assert_eq!(with(THESIS), usual, "{experiment}");
        assert_ne!(with("0,1; 2,3; 4,5,6; 7,8; 9"), usual, "{experiment}");
    }
}

#[test]
fn regions_that_do_not_fit_are_refused_with_the_place() {
    let refusal = |experiment: &str, sets: &str| {
        let request = request(experiment, 1, json!({ "hashing.sets": sets }), MAX);
        let catalog = Catalog::load(None).expect("the embedded files");
        let Job::Plain(plan) = catalog.job(&request).expect("a text") else { panic!("a path") };
        batch::drive(&plan, || {}).err().map(|error| (error.field, error.message))
    };
    for sets in ["0,1,2,3,4,5,6,7,8,9", "0;1;2;3;4;5;6;7;8;9", "0,1,2; 2,3,4,5; 5,6,7,8,9"] {
        assert_eq!(refusal("wall-approach", sets), None, "{sets}");
        for experiment in ["block-world", "corridor"] {
            let (field, message) = refusal(experiment, sets).expect("not five regions");
            assert_eq!(field, "settings.hashing.sets");
            assert!(message.contains("must be 5 regions"), "{message}");
        }
    }
    for (sets, says) in [
        ("0,1,2,3,4; 5,6,7,8,9,12", "region 2 must name sonars from 0 to 9, not 12"),
        ("0,1,2,3; 3,4,5,6; 7,8", "sonar 9 must be in a region"),
    ] {
        let (field, message) = refusal("wall-approach", sets).expect("refused");
        assert_eq!(field, "settings.hashing.sets");
        assert!(message.contains(says), "{message}");
    }
}

const PEOPLE: &str = "[[people]]\nstart_m = [5.0, 0.4]\npace_m_s = -0.7\n\n\
                      [[people]]\nstart_m = [9.0, 0.0]\npace_m_s = 1.1\nlane_m = -0.8\n";

#[test]
fn people_of_one_s_own_start_where_their_file_says() {
    let mut settings = corridor();
    settings["people.file"] = PEOPLE.into();
    let catalog = Catalog::load(None).expect("the embedded files");
    let request = request("corridor", 1, settings, MAX);
    let Job::Plain(plan) = catalog.job(&request).expect("a good request") else { panic!("a path") };
    let mut run = super::DriveRun::new(&plan).expect("good settings");
    let people = run.step().cycle.people_m;
    // A cycle is 0.4 s: 0.28 m back in the own lane, and 0.44 m on while the lane is changed by 0.16 m.
    for (person, expected) in people.iter().zip([[4.72, 0.4], [9.44, -0.16]]) {
        for (found, expected) in person.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-3, "{people:?}");
        }
    }
    assert_eq!(people.len(), 2);
}

#[test]
fn people_who_cannot_be_there_are_named() {
    let refusal = |people: &str| {
        let mut settings = corridor();
        settings["people.file"] = people.into();
        let catalog = Catalog::load(None).expect("the embedded files");
        let request = request("corridor", 1, settings, MAX);
        let Job::Plain(plan) = catalog.job(&request).expect("a text") else { panic!("a path") };
        let error = super::DriveRun::new(&plan).err().expect("refused");
        assert_eq!(error.field, "settings.people.file");
        error.message
    };
    let second = |start: &str, pace: &str| {
        format!("{PEOPLE}[[people]]\nstart_m = {start}\npace_m_s = {pace}")
    };
    for (people, says) in [
        (second("[13, 0]", "1"), "people[2]: (13, 0) is outside the corridor, x from 0 to 12 m"),
        (second("[6.0, 0.9]", "1"), "people[2]: (6, 0.9) is in a wall"),
        (second("[4, 0]", "9"), "people[2]: the pace must be from -3 to 3 m/s"),
        (
            second("[4, 0]", "1\nlane_m = 1.1"),
            "people[2]: the lane at 1.1 leads through the wall at 1.2",
        ),
        (second("[1.5, 0.2]", "1"), "people[2]: stands where the robot may start"),
        (second("[4, 0]", "fast"), "TOML parse error at line 11"),
        ("[[people]]\nstart_m = [1]".into(), "TOML parse error at line 2"),
        ("[[people]]\nspeed = 1".into(), "unknown field `speed`"),
    ] {
        let message = refusal(&people);
        assert!(message.contains(says), "{message}");
    }
}

#[test]
fn rules_of_one_s_own_drive_and_those_that_do_not_fit_are_refused() {
    let catalog = Catalog::load(None).expect("the embedded files");
    let navigator = catalog.rules().remove(0);
    let settings = |rules: &str| json!({ "trial.time_limit": 20, "rules.file": rules });
    let driven = |rules: &str| undisturbed(&request("block-world", 1, settings(rules), MAX));
    let usual = driven("");
    assert_eq!(driven(&navigator.to_text()), usual);
    assert_eq!(driven(&navigator.to_fll()), usual);
    // All is safe and it drives fast: now at 5 cm/s.
    let text = navigator.to_text();
    let slower = text.replacen(
        "safe safe safe safe safe fast -> 15 0",
        "safe safe safe safe safe fast -> 5 0",
        1,
    );
    assert_ne!(slower, text);
    assert_ne!(driven(&slower), usual);
    for (rules, says) in [
        (text.replacen("-> 15 0", "-> fast 0", 1), "rules, line "),
        (text.replace("far_left", "port"), "must be for far_left (m), left (m)"),
        (text.replace("output w deg/s", "output w rad/s"), "not far_left (m)"),
    ] {
        let request = request("block-world", 1, settings(&rules), MAX);
        let Job::Plain(plan) = catalog.job(&request).expect("a text") else { panic!("a path") };
        let error = super::DriveRun::new(&plan).err().expect("refused");
        assert_eq!(error.field, "settings.rules.file");
        assert!(error.message.contains(says), "{}", error.message);
    }
}

#[tokio::test]
async fn pausing_stopping_and_restarting_change_no_bit_of_a_driven_run() {
    let house = House::new();
    let settings = {
        let mut settings = corridor();
        settings["people.file"] = PEOPLE.into();
        settings
    };
    let request = request("corridor", 4, settings, MAX);
    let id = house.lab().create(&request).expect("a good request").id;
    house.control(&id, RUN).await;
    house.until(&id, |s| s.state == State::Paused && s.rounds_done == 1).await;
    for _ in 0..5 {
        house.control(&id, CYCLE).await;
    }
    house.control(&id, Stop).await;
    house.control(&id, Control::Speed(Speed::TicksPerSecond(400.0))).await;
    house.control(&id, Resume).await;
    house.until(&id, |s| s.rounds_done >= 2).await;

    let house = house.restart().await;
    house.control(&id, Control::Speed(MAX)).await;
    house.control(&id, Resume).await;
    house.until_state(&id, State::Finished).await;
    assert_eq!(runs(&house, &id), undisturbed(&request));
    let summary = house.lab().feed(&id).expect("a feed").hello().summary.expect("a summary");
    let methods: Vec<(&str, u32)> =
        summary.methods.iter().map(|of| (of.method.as_str(), of.n)).collect();
    assert_eq!(methods, [("minimum", 4), ("median-kalman", 4)], "also of runs before the restart");
}

#[tokio::test]
async fn a_method_holds_until_its_run_ends_and_is_told() {
    let house = House::new();
    let settings = json!({ "corridor.length": 12, "corridor.doors": 1, "people.count": 0 });
    let request = request("corridor", 2, settings, MAX);
    let id = house.lab().create(&request).expect("a good request").id;
    let path = |rest: &str| format!("/api/v1/sessions/{id}/{rest}");
    let early = house.post(&path("method"), json!({ "method": "minimum" })).await;
    assert_eq!(early.status, StatusCode::CONFLICT, "nothing is under way");
    house.control(&id, CYCLE).await;
    for (rest, body, field) in [
        ("method", json!({ "method": "mean" }), "method"),
        ("sonars", json!({ "sonar": 10, "silent": true }), "sonar"),
        ("advice", json!({ "text": "if goal is near then forward" }), "experiment"),
    ] {
        let refused = house.post(&path(rest), body).await;
        assert_eq!(refused.status, StatusCode::UNPROCESSABLE_ENTITY, "{rest}");
        assert_eq!(refused.json()["field"], field);
    }
    let given = house.post(&path("method"), json!({ "method": "minimum" })).await;
    assert_eq!(given.status, StatusCode::OK);
    house.control(&id, Resume).await;
    house.until_state(&id, State::Finished).await;
    let found = runs(&house, &id);
    let methods: Vec<&str> = found.iter().map(|run| run.method.as_str()).collect();
    assert_eq!(methods, ["minimum", "median-kalman"]);
    assert_eq!(found[0].interventions[0].kind, "method");
    assert_eq!(found[1].outcome, undisturbed(&request)[1].outcome, "the next run is as it was");
}

#[tokio::test]
async fn a_region_without_a_sonar_that_answers_stops_the_robot() {
    let house = House::new();
    let request = request("corridor", 1, json!({ "people.count": 0 }), MAX);
    let id = house.lab().create(&request).expect("a good request").id;
    house.control(&id, CYCLE).await;
    // The sonars of the leftmost region.
    for sonar in 0..3 {
        let body = json!({ "sonar": sonar, "silent": true });
        let answer = house.post(&format!("/api/v1/sessions/{id}/sonars"), body).await;
        assert_eq!(answer.status, StatusCode::OK);
    }
    house.control(&id, Resume).await;
    house.until_state(&id, State::Finished).await;
    let found = runs(&house, &id);
    let DriveOutcome::Drive(score) = &found[0].outcome else { panic!("a driven run") };
    assert_eq!((score.blind, score.done), (Some(0), false));
    let cycles = house.lab().store().cycles(&id, 1, u64::MAX).expect("readable");
    let last = cycles.last().expect("a cycle");
    assert!(last.speed_m_s.abs() < 1e-3, "{} m/s", last.speed_m_s);
    assert_eq!((last.readings[0].echo.as_str(), last.regions[0].live), ("silent", 0));
    assert!(last.regions[0].depths_m.is_empty());
}

#[tokio::test]
async fn rules_and_reports_of_chapter_2_are_there() {
    let house = House::new();
    let rules = house.get("/api/v1/rules/navigator").await.json();
    assert_eq!(rules["rules"].as_array().map(Vec::len), Some(972));
    assert_eq!(rules["rules"][0]["when"][0], "safe");
    assert_eq!(house.get("/api/v1/rules/pilot").await.status, StatusCode::NOT_FOUND);

    let request = request("wall-approach", 2, json!({}), MAX);
    let id = house.lab().create(&request).expect("a good request").id;
    house.control(&id, Start).await;
    house.until_state(&id, State::Finished).await;
    let get = async |file: &str| house.get(&format!("/api/v1/sessions/{id}/{file}")).await;
    let json = get("report.json").await.json();
    assert_eq!(json["episodes"], serde_json::to_value(undisturbed(&request)).expect("JSON"));
    let csv = String::from_utf8(get("report.csv").await.bytes.to_vec()).expect("text");
    assert_eq!(csv.lines().count(), 1 + 2 * 5, "a row a run and method");
    let html = String::from_utf8(get("report.html").await.bytes.to_vec()).expect("text");
    for part in ["How well each method told the distance", "sonarium run wall-approach --seed 300"]
    {
        assert!(html.contains(part), "{part}");
    }
    assert_eq!(get("report.zip").await.status, StatusCode::OK);
    assert!(!html.contains("<img"), "an approach has no way worth a picture");
}

#[tokio::test]
async fn ways_are_drawn_on_request_and_in_the_report() {
    let house = House::new();
    let request =
        request("block-world", 1, json!({ "trial.time_limit": 20.0, "compare": true }), MAX);
    let id = house.lab().create(&request).expect("a good request").id;
    let get = async |file: &str| house.get(&format!("/api/v1/sessions/{id}/{file}")).await;
    // Before the first cycle there is a floor to see, and no run.
    assert_eq!(get("arena.png").await.status, StatusCode::OK);
    assert_eq!(get("arena.png?trial=1").await.status, StatusCode::NOT_FOUND);
    house.control(&id, Start).await;
    house.until_state(&id, State::Finished).await;
    let [first, second, newest] = ["arena.png?trial=1", "arena.png?trial=2", "arena.png"];
    let (first, second) = (get(first).await, get(second).await);
    for picture in [&first, &second] {
        assert_eq!(picture.status, StatusCode::OK);
        assert!(picture.bytes.starts_with(b"\x89PNG"));
    }
    assert_ne!(first.bytes, second.bytes, "the captions name the methods");
    assert_eq!(get(newest).await.bytes, second.bytes, "nothing was driven since");
    assert_eq!(get("arena.png?trial=3").await.status, StatusCode::NOT_FOUND);
    let html = String::from_utf8(get("report.html").await.bytes.to_vec()).expect("text");
    assert_eq!(html.matches("<img").count(), 2, "one way for each method");
    let zip = get("report.zip").await.bytes;
    let mut zip = zip::ZipArchive::new(std::io::Cursor::new(zip)).expect("a zip file");
    for name in ["pictures/01-run-001.png", "pictures/02-run-002.png"] {
        assert!(zip.by_name(name).is_ok(), "{name}");
    }
}

#[tokio::test]
async fn settings_that_contradict_each_other_are_named() {
    let house = House::new();
    for (experiment, settings, field) in [
        (
            "wall-approach",
            json!({ "approach.end": 2.0, "approach.start": 1.0 }),
            "settings.approach.end",
        ),
        ("wall-approach", json!({ "hashing.regions": 11 }), "settings.hashing.regions"),
        ("corridor", json!({ "fusion.window": 0 }), "settings.fusion.window"),
        ("corridor", json!({ "fusion.method": "mean" }), "settings.fusion.method"),
        ("corridor", json!({ "corridor.door_width": 3.0 }), "settings.corridor.door_width"),
    ] {
        let refused = house.lab().create(&request(experiment, 1, settings.clone(), SLOW));
        let error = refused.expect_err("a refusal").to_string();
        assert!(error.starts_with(field), "{experiment} {settings}: {error}");
    }
}
