//! Networks that are taken from one session and go on learning in another.

use serde_json::{Value as Json, json};

use crate::batch;
use crate::catalog::{Catalog, Trained};
use crate::session::Control;
use crate::testing::{House, MAX, request};
use crate::wire::{NewSession, State, Trial};

const WORLD: &str = "laboratory-shifted-door";

/// A request for trials in another world, with networks.
fn elsewhere(trials: u32, network: Json) -> NewSession {
    let settings = [("world".to_owned(), WORLD.into())].into();
    NewSession { network: Some(network), settings, ..request(trials, MAX) }
}

/// The networks of three trials in the laboratory.
fn trained() -> Trained {
    let catalog = Catalog::load(None).expect("the embedded files");
    let plan = catalog.resolve(&request(3, MAX)).expect("a good request");
    batch::trained_set(&plan, || ()).expect("it fits").1
}

fn as_json(network: &Trained) -> Json {
    serde_json::from_str(&network.text).expect("a network file is JSON")
}

/// The trials of a run that nobody watched.
fn trials(request: &NewSession) -> Vec<Trial> {
    let catalog = Catalog::load(None).expect("the embedded files");
    let plan = catalog.resolve(request).expect("a good request");
    let trials = batch::set(&plan, || ()).expect("it fits").trials;
    // The planner's part is no part of the run.
    trials.into_iter().map(|trial| Trial { regret: None, ..trial }).collect()
}

#[test]
fn a_file_gives_back_every_bit() {
    let network = trained();
    assert!(network.neurons() > 0);
    let read = Trained::read(&network.text).expect("its own file");
    assert_eq!(read, network);
}

#[test]
fn a_run_goes_on_with_what_was_learned() {
    let network = as_json(&trained());
    let begun = trials(&elsewhere(1, network.clone()));
    let scratch = trials(&NewSession { network: None, ..elsewhere(1, Json::Null) });
    let known = network["networks"].as_array().expect("lists").iter();
    let known: usize = known.map(|neurons| neurons.as_array().map_or(0, Vec::len)).sum();
    let before = begun[0].neurons + begun[0].forgotten - begun[0].born;
    assert_eq!(before as usize, known, "it begins with the neurons of the file");
    assert_ne!(begun, scratch);
    assert_eq!(begun, trials(&elsewhere(1, network)), "and repeats to the bit");
}

#[tokio::test]
async fn a_session_begun_with_networks_is_resumed_and_repeated_to_the_bit() {
    let house = House::new();
    let source = house.session(3, MAX);
    house.control(&source, Control::Start).await;
    house.until_state(&source, State::Finished).await;

    let session = house.lab().create(&elsewhere(4, json!(source))).expect("a good request");
    assert!(session.settings["network"].as_str().is_some_and(|label| label.contains("3 trials")));
    assert!(session.changed.contains(&"network".to_owned()));
    house.control(&session.id, Control::Step(crate::wire::StepUnit::Trial)).await;
    house.until(&session.id, |s| s.trials_done == 1 && s.state == State::Paused).await;
    // Without its source, and in a new process: the session's own folder holds all it needs.
    house.lab().delete(&source).expect("it is at rest");
    let house = house.restart().await;
    house.control(&session.id, Control::Resume).await;
    house.until_state(&session.id, State::Finished).await;
    let found = house.lab().store().trials(&session.id).expect("trials");
    assert_eq!(found, trials(&elsewhere(4, as_json(&trained()))));
}

#[test]
fn a_network_that_cannot_be_used_is_refused_with_the_field() {
    let network = as_json(&trained());
    let with = |pointer: &str, value: Json| {
        let mut changed = network.clone();
        *changed.pointer_mut(pointer).expect(pointer) = value;
        changed
    };
    let mut extended = network.clone();
    extended["mood"] = json!("good");
    let mut fewer = network.clone();
    fewer["sonars"].as_array_mut().expect("a list").truncate(10);
    for (network, field, says) in [
        (json!("nobody"), "network", "a network file"),
        (json!({}), "network.format", "no network file"),
        (with("/version", json!(2)), "network.version", "newer"),
        (with("/version", json!("one")), "network.version", "must be 1"),
        (extended, "network.mood", "unknown field"),
        (fewer, "network.sonars", "24 sonars"),
        (with("/sonars/3/bearing_deg", json!(44)), "network.sonars[3]", "45°"),
        (
            with("/input/sonar_span_m", json!(2.5)),
            "network.input.sonar_span_m",
            "--set input.sonar_span=2.5",
        ),
        (with("/action_frame", json!("goal")), "network.action_frame", "`heading`"),
        (with("/regions/0", json!("attic")), "network.regions", "`attic`"),
        (with("/networks", json!([[]])), "network.networks", "4 regions"),
        (
            with("/networks/2/0/centre/1", json!("wide")),
            "network.networks[2][0].centre[1]",
            "cannot be read",
        ),
    ] {
        let catalog = Catalog::load(None).expect("the embedded files");
        let error = catalog.resolve(&elsewhere(1, network)).expect_err(field);
        assert_eq!(error.field, field, "{error}");
        assert!(error.message.contains(says), "{error}");
    }
}

#[test]
fn a_file_that_is_cut_off_or_no_file_is_refused() {
    let text = trained().text;
    for (text, says) in [
        (&text[..text.len() / 2], "cut off"),
        ("P5 2 2 255", "not JSON"),
        ("[1, 2]", "no JSON object"),
        ("", "cut off"),
    ] {
        let error = Trained::read(text).expect_err(says);
        assert!(error.field.starts_with("network") && error.message.contains(says), "{error}");
    }
}
