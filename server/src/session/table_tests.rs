//! Tabular sessions: the same episodes at any pace, resumed or not, and what an operator does to them.

use axum::http::StatusCode;
use serde_json::{Value as Json, json};

use super::Control;
use crate::batch;
use crate::catalog::{Catalog, Job};
use crate::testing::{House, MAX, SLOW};
use crate::wire::{EpisodeView, NewSession, OutcomeOfEpisode, Round, Speed, State, StepUnit};

use Control::{Reset, Resume, Start, Stop};
const TICK: Control = Control::Step(StepUnit::Tick);
const EPISODE: Control = Control::Step(StepUnit::Trial);

fn request(experiment: &str, settings: Json, speed: Speed) -> NewSession {
    let body = json!({ "experiment": experiment, "seed": 7, "settings": settings });
    NewSession { speed: Some(speed), ..serde_json::from_value(body).expect("a request") }
}

/// The episodes of a run that nothing disturbed.
fn undisturbed(request: &NewSession) -> Vec<EpisodeView> {
    let catalog = Catalog::load(None).expect("the embedded files");
    match catalog.job(request).expect("a good request") {
        Job::Plain(plan) => batch::table(&plan, || {}).expect("good settings").episodes,
        Job::Path(_) => panic!("{} is no tabular experiment", request.experiment),
    }
}

fn episodes(house: &House, id: &str) -> Vec<EpisodeView> {
    let rounds = house.lab().store().rounds(id).expect("readable").into_iter();
    let episode = |round| match round {
        Round::Episode(episode) => *episode,
        Round::Trial(_) | Round::Run(_) => panic!("no episode in a tabular session"),
    };
    rounds.map(episode).collect()
}

#[tokio::test]
async fn every_tabular_experiment_runs_live_as_headless() {
    let house = House::new();
    for (experiment, settings, rounds) in [
        ("labyrinth", json!({ "episodes": 2, "trials": 5 }), 12),
        ("labyrinth", json!({ "preset": "alternatives", "episodes": 1, "trials": 5 }), 6),
        ("continual", json!({ "episodes": 2, "trials": 5 }), 6),
        ("gridworld", json!({ "episodes": 1, "trials": 3, "learners": "all" }), 4),
        ("gridworld", json!({ "episodes": 1, "trials": 3, "world": "repair" }), 1),
        ("bandit", json!({ "episodes": 2, "pulls": 50 }), 10),
        ("horizon", json!({}), 1),
    ] {
        let request = request(experiment, settings, MAX);
        let id = house.lab().create(&request).expect("a good request").id;
        house.control(&id, Start).await;
        let session = house.until_state(&id, State::Finished).await;
        assert_eq!((session.rounds, session.rounds_done), (rounds, rounds), "{experiment}");
        let expected = undisturbed(&request);
        assert_eq!(episodes(&house, &id), expected, "{experiment}");
        let last = expected.last().expect("an episode").last_tick;
        let ticks = house.lab().store().steps(&id, 1, u64::MAX).expect("readable");
        let numbers: Vec<u64> = ticks.iter().map(crate::wire::StepView::tick).collect();
        assert_eq!(numbers, (1..=last).collect::<Vec<_>>(), "{experiment}: each tick once");
    }
}

#[tokio::test]
async fn pausing_stopping_and_restarting_change_no_bit_of_a_tabular_session() {
    let house = House::new();
    let request = request("labyrinth", json!({ "episodes": 2, "trials": 20 }), MAX);
    let id = house.lab().create(&request).expect("a good request").id;
    house.control(&id, EPISODE).await;
    house.until(&id, |s| s.state == State::Paused && s.rounds_done == 1).await;
    for _ in 0..5 {
        house.control(&id, TICK).await;
    }
    house.control(&id, Stop).await;
    house.control(&id, Control::Speed(Speed::TicksPerSecond(2000.0))).await;
    house.control(&id, Resume).await;
    house.until(&id, |s| s.rounds_done >= 2).await;

    let house = house.restart().await;
    assert_eq!(house.lab().session(&id).expect("it is there").state, State::Interrupted);
    house.control(&id, Control::Speed(MAX)).await;
    house.control(&id, Resume).await;
    house.until_state(&id, State::Finished).await;
    assert_eq!(episodes(&house, &id), undisturbed(&request));
}

#[tokio::test]
async fn a_reset_begins_anew() {
    let house = House::new();
    let request = request("bandit", json!({ "episodes": 1, "pulls": 20 }), MAX);
    let id = house.lab().create(&request).expect("a good request").id;
    for _ in 0..2 {
        house.control(&id, Start).await;
        house.until_state(&id, State::Finished).await;
        assert_eq!(episodes(&house, &id), undisturbed(&request));
        house.control(&id, Reset).await;
        assert!(episodes(&house, &id).is_empty());
    }
}

#[tokio::test]
async fn advice_and_edits_change_the_learner_and_are_told() {
    let house = House::new();
    let request = request("labyrinth", json!({ "episodes": 1, "trials": 30 }), MAX);
    let id = house.lab().create(&request).expect("a good request").id;
    let path = |rest: &str| format!("/api/v1/sessions/{id}/{rest}");
    let early =
        house.post(&path("advice"), json!({ "text": "if goal is near then forward" })).await;
    assert_eq!(early.status, StatusCode::CONFLICT, "nothing is under way");
    house.control(&id, TICK).await;

    for (rest, body, field, says) in [
        ("advice", json!({ "text": "if goal is nar then forward" }), "text", "line 1, column 12"),
        ("table", json!({ "state": 16, "action": 0, "value": 1.0 }), "value", "16 rows"),
        ("table", json!({ "state": 0, "action": 3, "value": 1.0 }), "value", "3"),
        ("table", json!({ "values": [[1.0]] }), "values", "16 rows"),
    ] {
        let refused = house.post(&path(rest), body).await;
        assert_eq!(refused.status, StatusCode::UNPROCESSABLE_ENTITY, "{rest}");
        assert_eq!(refused.json()["field"], field);
        let detail = refused.json()["detail"].to_string();
        assert!(detail.contains(says), "{detail}");
    }

    let set = json!({ "state": 3, "action": 1, "value": 2.5 });
    assert_eq!(house.post(&path("table"), set).await.status, StatusCode::OK);
    let saved = house.get(&path("table")).await.json();
    assert_eq!(saved["values"][3], json!([1.0, 2.5, 1.0]), "B0 begins with 1 everywhere");
    let given =
        house.post(&path("advice"), json!({ "text": "if goal is near then forward" })).await;
    assert_eq!(given.status, StatusCode::OK);
    let hello = house.lab().feed(&id).expect("a feed").hello();
    let table = serde_json::to_value(hello.table.expect("tables")).expect("JSON");
    assert_eq!(table["advice"][0]["text"], "if goal is near then forward");

    house.control(&id, Resume).await;
    house.until_state(&id, State::Finished).await;
    let (disturbed, others) = (episodes(&house, &id), undisturbed(&request));
    let kinds: Vec<&str> = disturbed[0].interventions.iter().map(|i| i.kind.as_str()).collect();
    assert_eq!(kinds, ["value", "advice"]);
    assert_ne!(disturbed[0].outcome, others[0].outcome, "the learner was changed");
    let outcomes = |episodes: &[EpisodeView]| {
        episodes.iter().skip(1).map(|episode| episode.outcome.clone()).collect::<Vec<_>>()
    };
    assert_eq!(outcomes(&disturbed), outcomes(&others), "it holds until the end of its episode");
    let log = house.lab().store().events(&id, 100).expect("readable");
    assert!(
        log.iter().any(|entry| entry.text.starts_with("Advised: if goal is near then forward"))
    );
}

#[tokio::test]
async fn what_belongs_to_robots_is_refused_by_name() {
    let house = House::new();
    let request = request("labyrinth", json!({ "episodes": 1 }), SLOW);
    let id = house.lab().create(&request).expect("a good request").id;
    for rest in ["arena.png", "network", "starts"] {
        let answer = house.get(&format!("/api/v1/sessions/{id}/{rest}")).await;
        assert_eq!(answer.status, StatusCode::UNPROCESSABLE_ENTITY, "{rest}");
        assert!(answer.json()["detail"].to_string().contains("no robot"), "{rest}");
    }
    let path = house.session(1, SLOW);
    house.control(&path, TICK).await;
    let advice = json!({ "text": "if goal is near then forward" });
    let answer = house.post(&format!("/api/v1/sessions/{path}/advice"), advice).await;
    assert_eq!(answer.status, StatusCode::UNPROCESSABLE_ENTITY);
}

#[tokio::test]
async fn reports_of_a_tabular_session_hold_its_episodes() {
    let house = House::new();
    let request = request("labyrinth", json!({ "episodes": 2, "trials": 4 }), MAX);
    let id = house.lab().create(&request).expect("a good request").id;
    house.control(&id, Start).await;
    house.until_state(&id, State::Finished).await;
    let get = async |file: &str| house.get(&format!("/api/v1/sessions/{id}/{file}")).await;
    let json = get("report.json").await.json();
    let expected = undisturbed(&request);
    assert_eq!(json["episodes"], serde_json::to_value(&expected).expect("JSON"));
    assert_eq!(json["summary"]["scores"][1]["name"], "B10");
    let csv = String::from_utf8(get("report.csv").await.bytes.to_vec()).expect("text");
    assert_eq!(csv.lines().count(), 1 + 12 * 4, "a row a trial");
    let OutcomeOfEpisode::Walk { trials, .. } = &expected[0].outcome else { panic!("a walk") };
    assert_eq!(csv.lines().nth(1), Some(format!("1,1,B0,false,1,{}", trials[0]).as_str()));
    let html = String::from_utf8(get("report.html").await.bytes.to_vec()).expect("text");
    for part in ["Learning curves", "Eq. 4.13", "sonarium run labyrinth --seed 7 --trials 4"] {
        assert!(html.contains(part), "{part}");
    }
    assert_eq!(get("report.zip").await.status, StatusCode::OK);
}
