//! The stream as a client sees it.

use std::net::SocketAddr;

use futures_util::{SinkExt, StreamExt};
use serde_json::{Value as Json, json};
use tokio::net::TcpStream;
use tokio::time::timeout;
use tokio_tungstenite::tungstenite::client::IntoClientRequest;
use tokio_tungstenite::tungstenite::{Error, Message};
use tokio_tungstenite::{MaybeTlsStream, WebSocketStream, connect_async};

use crate::session::Control;
use crate::testing::{House, MAX, PATIENCE, SLOW, undisturbed};
use crate::wire::{Speed, State, StepUnit};

/// A connected client.
struct Client(WebSocketStream<MaybeTlsStream<TcpStream>>);

impl Client {
    async fn connect(address: SocketAddr, id: &str, query: &str) -> Self {
        let (socket, _) = connect_async(url(address, id, query)).await.expect("a connection");
        Self(socket)
    }

    async fn say(&mut self, text: impl Into<String>) {
        self.0.send(Message::text(text.into())).await.expect("sent");
    }

    async fn hear(&mut self) -> Message {
        loop {
            let next = timeout(PATIENCE, self.0.next()).await.expect("a message in time");
            match next.expect("the connection stays").expect("a good frame") {
                Message::Ping(_) => {}
                message => return message,
            }
        }
    }

    /// Takes `hello`, and the planner's answer if that is still to come; then nothing comes by itself
    /// from a session at rest. Gives the number of the last event.
    async fn settle(&mut self) -> u64 {
        let mut last = self.event().await;
        assert_eq!(kind(&last), "hello");
        if last["yardstick"]["state"] == "computing" {
            last = self.event().await;
            assert_eq!(kind(&last), "yardstick");
        }
        last["seq"].as_u64().expect("a number")
    }

    /// The next text message, samples and pictures left out.
    async fn event(&mut self) -> Json {
        loop {
            if let Message::Text(text) = self.hear().await {
                let json: Json = serde_json::from_str(&text).expect("JSON");
                if !matches!(kind(&json), "tick" | "depths" | "neurons") {
                    return json;
                }
            }
        }
    }
}

fn url(address: SocketAddr, id: &str, query: &str) -> String {
    format!("ws://{address}/api/v1/sessions/{id}/stream{query}")
}

/// Trials as they are before the planner has answered, which it may do at any time.
fn without_regret(trials: &Json) -> Json {
    let mut trials = trials.clone();
    for trial in trials.as_array_mut().expect("a list") {
        trial["regret"] = Json::Null;
    }
    trials
}

fn kind(message: &Json) -> &str {
    message["type"].as_str().unwrap_or_default()
}

#[tokio::test]
async fn the_first_message_carries_state_and_history() {
    let house = House::new();
    let address = house.listen().await;
    let id = house.session(3, MAX);
    house.control(&id, Control::Start).await;
    house.until_state(&id, State::Finished).await;
    let hello = Client::connect(address, &id, "").await.event().await;
    assert_eq!(kind(&hello), "hello");
    assert_eq!(hello["version"], 1);
    assert_eq!(hello["session"]["state"], "finished");
    assert_eq!(without_regret(&hello["trials"]), json!(undisturbed(3)));
    assert_eq!(hello["tick"]["tick"], hello["session"]["tick"]);
    assert_eq!(hello["world"]["regions"], json!(["corridor", "concave", "room", "door"]));
    let neurons = hello["neurons"].as_array().expect("a list").len();
    assert_eq!(neurons, hello["trials"][2]["neurons"].as_u64().expect("a number") as usize);
    assert!(!hello["log"].as_array().expect("a list").is_empty());
}

#[tokio::test]
async fn events_are_numbered_without_holes() {
    let house = House::new();
    let address = house.listen().await;
    let id = house.session(30, MAX);
    let mut client = Client::connect(address, &id, "").await;
    let mut seq = client.event().await["seq"].as_u64().expect("a number");
    house.control(&id, Control::Start).await;
    let mut trials = Vec::new();
    loop {
        let event = client.event().await;
        seq += 1;
        assert_eq!(event["seq"], seq, "{}", kind(&event));
        if kind(&event) == "trial" {
            trials.extend(event["trials"].as_array().expect("a list").clone());
        }
        if event["session"]["state"] == "finished" {
            break;
        }
    }
    assert_eq!(without_regret(&json!(trials)), json!(undisturbed(30)));
}

#[tokio::test]
async fn samples_and_pictures_come_as_subscribed() {
    let house = House::new();
    let address = house.listen().await;
    let id = house.session(30, SLOW);
    let mut client = Client::connect(address, &id, "").await;
    assert_eq!(kind(&client.event().await), "hello");
    let picture = json!({ "rate": 30, "width": 200, "height": 100, "theme": "dark" });
    client.say(json!({ "type": "subscribe", "depths": 0, "arena": picture }).to_string()).await;
    // The picture shows that the subscription has been read.
    let png = loop {
        if let Message::Binary(png) = client.hear().await {
            break png;
        }
    };
    assert_eq!(&png[1..4], b"PNG");
    assert_eq!(png[16..24], [0, 0, 0, 200, 0, 0, 0, 100], "width and height");
    house.control(&id, Control::Step(StepUnit::Tick)).await;
    let mut samples = Vec::new();
    while samples.last().is_none_or(|last| last != "neurons") {
        if let Message::Text(text) = client.hear().await {
            let message: Json = serde_json::from_str(&text).expect("JSON");
            samples.push(kind(&message).to_owned());
            assert!(kind(&message) != "tick" || message["tick"]["tick"] == 1);
        }
    }
    samples.retain(|kind| matches!(kind.as_str(), "tick" | "depths" | "neurons"));
    assert_eq!(samples, ["tick", "neurons"]);
}

#[tokio::test]
async fn a_message_that_cannot_be_used_is_answered_and_the_connection_stays() {
    let house = House::new();
    let address = house.listen().await;
    let id = house.session(30, SLOW);
    let mut client = Client::connect(address, &id, "").await;
    client.settle().await;
    for (message, field) in [
        ("nonsense", Json::Null),
        (r#"{"type":"subscribe","tick":1000}"#, json!("tick")),
        (r#"{"type":"subscribe","tock":1}"#, json!("tock")),
    ] {
        client.say(message).await;
        let answer = client.event().await;
        assert_eq!((kind(&answer), &answer["field"]), ("error", &field), "{message}");
    }
    house.control(&id, Control::Speed(Speed::TicksPerSecond(1.0))).await;
    assert_eq!(kind(&client.event().await), "log");
}

#[tokio::test]
async fn too_long_a_message_ends_the_connection_with_the_reason() {
    let house = House::new();
    let address = house.listen().await;
    let id = house.session(30, SLOW);
    let mut client = Client::connect(address, &id, "").await;
    client.settle().await;
    client.say("x".repeat(65 << 10)).await;
    let Message::Close(Some(frame)) = client.hear().await else { panic!("it stays open") };
    assert_eq!(u16::from(frame.code), 1009);
    assert!(frame.reason.contains("64 kB"), "{}", frame.reason);
}

#[tokio::test]
async fn a_client_that_comes_back_gets_what_it_missed_or_is_told_of_the_gap() {
    let house = House::new();
    let address = house.listen().await;
    let id = house.session(30, SLOW);
    // Somebody else keeps watching, as another browser would.
    let mut other = Client::connect(address, &id, "").await;
    let seq = other.settle().await;
    for _ in 0..3 {
        house.control(&id, Control::Speed(SLOW)).await;
    }
    let mut back = Client::connect(address, &id, &format!("?since={seq}")).await;
    for k in 1..=6 {
        assert_eq!(back.event().await["seq"], seq + k);
    }
    // The planner's answer is the first event held, so the one before it can still be had.
    for since in [0, seq - 2, seq + 1000] {
        let mut lost = Client::connect(address, &id, &format!("?since={since}")).await;
        let gap = lost.event().await;
        assert_eq!((kind(&gap), &gap["since"]), ("gap", &json!(since)));
        let hello = lost.event().await;
        assert_eq!((kind(&hello), &hello["seq"]), ("hello", &json!(seq + 6)));
    }
}

#[tokio::test]
async fn a_reset_gives_every_client_a_new_picture() {
    let house = House::new();
    let address = house.listen().await;
    let id = house.session(2, MAX);
    house.control(&id, Control::Start).await;
    house.until_state(&id, State::Finished).await;
    let mut client = Client::connect(address, &id, "").await;
    assert_eq!(client.event().await["trials"].as_array().map(Vec::len), Some(2));
    house.control(&id, Control::Reset).await;
    let mut message = client.event().await;
    while kind(&message) != "hello" {
        message = client.event().await;
    }
    assert_eq!(message["trials"], json!([]));
    assert_eq!(message["session"]["state"], "queued");
}

#[tokio::test]
async fn a_client_that_reads_nothing_neither_stops_nor_changes_the_run() {
    let house = House::new();
    let address = house.listen().await;
    let id = house.session(60, MAX);
    let mut clients = Vec::new();
    for _ in 0..3 {
        let mut client = Client::connect(address, &id, "").await;
        let picture = json!({ "rate": 30, "width": 640, "height": 480, "theme": "light" });
        let all = json!({ "type": "subscribe", "tick": 60, "depths": 60, "neurons": 30,
            "arena": picture });
        client.say(all.to_string()).await;
        clients.push(client);
    }
    house.control(&id, Control::Start).await;
    house.until_state(&id, State::Finished).await;
    assert_eq!(house.lab().store().trials(&id).expect("readable"), undisturbed(60));
}

#[tokio::test]
async fn a_page_of_another_origin_is_refused() {
    let house = House::new();
    let address = house.listen().await;
    let id = house.session(30, SLOW);
    for (origin, expected) in
        [("http://example.org", Some(403)), (&format!("http://{address}"), None)]
    {
        let mut request = url(address, &id, "").into_client_request().expect("a request");
        request.headers_mut().insert("origin", origin.parse().expect("a header"));
        let status = match connect_async(request).await {
            Ok(_) => None,
            Err(Error::Http(response)) => Some(response.status().as_u16()),
            Err(other) => panic!("{other}"),
        };
        assert_eq!(status, expected, "{origin}");
    }
}
