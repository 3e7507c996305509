//! The laboratory as a whole: controls, waiting, mishaps.

use axum::http::StatusCode;
use serde_json::json;

use crate::session::{Control, ControlError};
use crate::testing::{House, MAX, SLOW, request, undisturbed};
use crate::wire::{NewSession, PlannedPath, Speed, State, StepUnit, TickView, Trial, Yardstick};

use Control::{Pause, Reset, Resume, Start, Stop};
const TICK: Control = Control::Step(StepUnit::Tick);
const TRIAL: Control = Control::Step(StepUnit::Trial);

#[tokio::test]
async fn controls_lead_where_they_should() {
    for (controls, state, tick) in [
        (&[Start][..], State::Running, None),
        (&[TICK, TICK, TICK], State::Paused, Some(3)),
        (&[Start, Pause], State::Paused, None),
        (&[Start, Pause, Resume], State::Running, None),
        (&[TICK, Resume, Pause, TICK], State::Paused, None),
        (&[Stop], State::Stopped, Some(0)),
        (&[Stop, Resume], State::Running, None),
        (&[TICK, Stop], State::Stopped, Some(1)),
        (&[TICK, Reset], State::Queued, Some(0)),
        (&[TICK, Stop, Reset, TICK], State::Paused, Some(1)),
        (&[Start, Stop, Resume, Stop, Reset], State::Queued, Some(0)),
    ] {
        let house = House::new();
        let id = house.session(5, SLOW);
        let mut ack = None;
        for control in controls {
            ack = Some(house.control(&id, *control).await);
        }
        let ack = ack.expect("at least one control");
        assert_eq!(ack.state, state, "{controls:?}");
        assert!(tick.is_none_or(|tick| tick == ack.tick), "{controls:?} took effect at {ack:?}");
        assert_eq!(house.lab().session(&id).expect("it is there").state, state, "{controls:?}");
        house.lab().close().await;
    }
}

#[tokio::test]
async fn a_step_to_the_end_of_the_trial_holds_there() {
    let house = House::new();
    let id = house.session(5, MAX);
    for trial in 1..=2 {
        house.control(&id, TRIAL).await;
        let done = |s: &crate::wire::Session| s.state == State::Paused && s.trials_done == trial;
        let session = house.until(&id, done).await;
        assert_eq!(session.tick, undisturbed(trial).last().expect("a trial").last_tick);
    }
}

#[tokio::test]
async fn a_refused_control_changes_nothing() {
    let house = House::new();
    let id = house.session(2, MAX);
    house.control(&id, Start).await;
    house.until_state(&id, State::Finished).await;
    for control in [Start, Pause, Resume, TICK, Stop] {
        let refused = house.lab().control(&id, control).await;
        assert!(matches!(refused, Err(ControlError::Refused(_))), "{control:?}: {refused:?}");
    }
    assert_eq!(house.lab().session(&id).expect("it is there").state, State::Finished);
}

#[tokio::test]
async fn sessions_beyond_the_places_wait_and_start_in_order() {
    let house = House::new();
    let ids: Vec<String> = (0..4).map(|_| house.session(50, SLOW)).collect();
    for (id, state) in
        ids.iter().zip([State::Running, State::Running, State::Queued, State::Queued])
    {
        assert_eq!(house.control(id, Start).await.state, state);
    }
    let waiting = house.lab().session(&ids[2]).expect("it is there");
    assert_eq!(waiting.controls, ["stop"]);
    house.control(&ids[1], Pause).await;
    house.until_state(&ids[2], State::Running).await;
    assert_eq!(house.control(&ids[1], Resume).await.state, State::Queued, "its place is taken");
    house.control(&ids[3], Stop).await;
    house.control(&ids[0], Stop).await;
    house.until_state(&ids[1], State::Running).await;
    house.lab().close().await;
}

#[tokio::test]
async fn pausing_stopping_and_restarting_change_no_bit() {
    let house = House::new();
    let id = house.session(8, MAX);
    house.control(&id, TRIAL).await;
    house.until(&id, |s| s.state == State::Paused && s.trials_done == 1).await;
    for _ in 0..5 {
        house.control(&id, TICK).await;
    }
    house.control(&id, Stop).await;
    house.control(&id, Control::Speed(Speed::TicksPerSecond(500.0))).await;
    house.control(&id, Resume).await;
    house.until(&id, |s| s.trials_done >= 3).await;

    let house = house.restart().await;
    let session = house.lab().session(&id).expect("it is there");
    assert_eq!(session.state, State::Interrupted);
    assert_eq!(session.reason.as_deref(), Some("the server was shut down"));
    house.control(&id, Control::Speed(MAX)).await;
    house.control(&id, Resume).await;
    house.until_state(&id, State::Finished).await;

    let trials = house.lab().store().trials(&id).expect("readable");
    assert_eq!(trials, undisturbed(8));
    let last = trials.last().expect("trials").last_tick;
    let ticks = house.lab().store().ticks(&id, 1, u64::MAX).expect("readable");
    let numbers: Vec<u64> = ticks.iter().map(|tick| tick.tick).collect();
    assert_eq!(numbers, (1..=last).collect::<Vec<_>>(), "each tick is in the log once");
}

#[tokio::test]
async fn where_new_neurons_make_for_and_what_scouts_do_is_told() {
    let house = House::new();
    let id = house.session(20, MAX);
    house.control(&id, Start).await;
    house.until_state(&id, State::Finished).await;
    let trials = house.lab().store().trials(&id).expect("readable");
    let scouts: Vec<u32> = trials.iter().filter(|t| t.scout).map(|t| t.trial).collect();
    assert_eq!(scouts, [3, 5]);
    let ticks = house.lab().store().ticks(&id, 1, u64::MAX).expect("readable");
    let scouting = ticks.iter().filter(|tick| tick.source == "scout");
    assert!(scouting.map(|tick| tick.trial).all(|trial| scouts.contains(&trial)));
    assert!(ticks.iter().any(|tick| tick.source == "scout"));
    let mut told = ticks.iter().filter(|tick| tick.toward_m.is_some()).peekable();
    assert!(
        told.peek().is_some() && told.all(|tick| tick.born.is_some() || tick.source == "pursuit")
    );
}

#[tokio::test]
async fn where_odometry_is_off_and_what_that_makes_of_a_trial_is_told() {
    let house = House::new();
    let settings = [("odometry.drift".to_owned(), json!(0.02))].into();
    let request = NewSession { settings, ..request(3, MAX) };
    let id = house.lab().create(&request).expect("a good request").id;
    house.control(&id, Start).await;
    house.until_state(&id, State::Finished).await;
    let ticks = house.lab().store().ticks(&id, 1, u64::MAX).expect("readable");
    let off = |tick: &TickView| tick.fix.is_some_and(|fix| fix.odometry != tick.pose);
    assert!(ticks.iter().all(|tick| tick.fix.is_some()) && ticks.iter().any(off));
    let trials = house.lab().store().trials(&id).expect("readable");
    assert!(trials.iter().all(|trial| trial.true_goal.is_some_and(|goal| goal != trial.goal)));
    let yardstick = Yardstick::Ready(PlannedPath {
        total_reinforcement: -4.0,
        steps: 27,
        collisions: 0,
        resolution: 0.01,
        path_m: Vec::new(),
    });
    let trial = &Trial { safety: -1.0, goal: -5.0, true_goal: Some(-4.5), ..trials[1].clone() };
    assert_eq!(yardstick.regret(trial), Some(1.5));
    let old = &Trial { true_goal: None, ..trial.clone() };
    assert_eq!(yardstick.regret(old), Some(2.0), "an older log does not say");
}

#[tokio::test]
async fn a_reset_puts_the_log_aside_and_begins_anew() {
    let house = House::new();
    let id = house.session(2, MAX);
    for _ in 0..2 {
        house.control(&id, Start).await;
        house.until_state(&id, State::Finished).await;
        assert_eq!(house.lab().store().trials(&id).expect("readable"), undisturbed(2));
        let ack = house.control(&id, Reset).await;
        assert_eq!((ack.state, ack.tick), (State::Queued, 0));
        assert!(house.lab().feed(&id).expect("a feed").rounds().is_empty());
    }
    let folder = house.lab().store().session_folder(&id);
    assert!(folder.join("log-1.mcap").exists() && folder.join("log-2.mcap").exists());
}

#[tokio::test]
async fn a_session_with_settings_that_are_gone_is_read_and_not_run() {
    let house = House::new();
    let id = house.session(3, MAX);
    house.control(&id, TRIAL).await;
    house.until_state(&id, State::Paused).await;
    house.control(&id, Stop).await;
    house.tamper(
        "UPDATE session SET build = '0.0.9', settings =
         json_set(settings, '$.\"shortcut.gone\"', 0.2, '$.\"shortcut.withdraw\"', json('true'))",
    );
    let house = house.restart().await;
    let path = format!("/api/v1/sessions/{id}");
    for read in
        ["", "/trials", "/report.json", "/report.html", "/trials/1/report.html", "/arena.png"]
    {
        let answer = house.get(&format!("{path}{read}")).await;
        assert_eq!(answer.status, StatusCode::OK, "{read}: {}", answer.json());
    }
    // What it ran with is told as it was.
    let session = house.get(&path).await.json();
    assert_eq!(session["settings"]["shortcut.gone"], 0.2);
    for control in ["/resume", "/reset"] {
        let answer = house.post(&format!("{path}{control}"), json!({})).await;
        assert_eq!(answer.status, StatusCode::UNPROCESSABLE_ENTITY, "{control}");
        let problem = answer.json();
        assert_eq!(problem["field"], "settings.shortcut.gone", "{problem}");
        let detail = problem["detail"].as_str().unwrap_or_default();
        assert!(detail.ends_with("made by Sonarium 0.0.9 and can be read, not run"), "{detail}");
    }
}

#[tokio::test]
async fn every_action_of_an_operator_is_in_the_log() {
    let house = House::new();
    let id = house.session(3, SLOW);
    for control in [Control::Speed(SLOW), TICK, Resume, Pause, Stop, Resume, Stop] {
        house.control(&id, control).await;
    }
    let events = house.lab().store().events(&id, 100).expect("readable");
    let said: Vec<&str> =
        events.iter().filter(|e| e.kind == "operator").map(|e| e.text.as_str()).collect();
    assert_eq!(
        said,
        [
            "Speed set to 0.1 ticks a second",
            "Stepped one tick",
            "Resumed",
            "Paused",
            "Stopped",
            "Resumed",
            "Stopped",
        ]
    );
}

#[tokio::test]
async fn a_panic_fails_the_session_and_nothing_else() {
    let house = House::new();
    let (id, other) = (house.session(50, MAX), house.session(3, MAX));
    house.control(&id, TRIAL).await;
    house.until(&id, |s| s.state == State::Paused && s.trials_done == 1).await;
    house.lab().panic(&id);
    let failed = house.until_state(&id, State::Failed).await;
    assert_eq!(failed.reason.as_deref(), Some("internal error: a mistake"));
    assert_eq!(failed.controls, ["resume", "reset"], "it has a checkpoint");
    house.control(&other, Start).await;
    house.until_state(&other, State::Finished).await;
    house.control(&id, Resume).await;
    house.until(&id, |s| s.trials_done >= 2).await;
    house.lab().close().await;
}

#[tokio::test]
async fn a_session_in_use_is_not_deleted() {
    let house = House::new();
    let id = house.session(50, SLOW);
    house.control(&id, Start).await;
    assert!(house.lab().delete(&id).is_err());
    house.control(&id, Stop).await;
    // The actor leaves when it has answered; until then the session is in use.
    while house.lab().delete(&id).is_err() {
        tokio::task::yield_now().await;
    }
    assert!(house.lab().session(&id).is_err());
}
