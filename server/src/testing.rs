//! A laboratory for tests, in a folder of its own.

use std::net::SocketAddr;
use std::time::Duration;

use axum::body::{Body, Bytes, to_bytes};
use axum::http::{Request, StatusCode, header};
use serde_json::{Value as Json, json};
use tempfile::TempDir;
use tokio::net::TcpListener;
use tokio::time::timeout;
use tower::ServiceExt;

use crate::api::{self, App};
use crate::catalog::{Catalog, MINIMUM_COST_PATH};
use crate::render::{Backend, Renderer};
use crate::session::{Control, Lab, Run};
use crate::store::Store;
use crate::stream::Frames;
use crate::wire::{Ack, NamedSpeed, NewSession, Session, Speed, State, Trial};

/// Longer than anything here takes; only a test that would hang for ever ends by it.
pub(crate) const PATIENCE: Duration = Duration::from_secs(60);

/// A laboratory with two places.
pub(crate) struct House {
    pub(crate) app: App,
    folder: TempDir,
}

/// An answer of the server.
pub(crate) struct Answer {
    pub(crate) status: StatusCode,
    pub(crate) kind: String,
    pub(crate) bytes: Bytes,
}

impl Answer {
    pub(crate) fn json(&self) -> Json {
        serde_json::from_slice(&self.bytes).unwrap_or_default()
    }
}

impl House {
    pub(crate) fn new() -> Self {
        Self::over(TempDir::new().expect("a folder"))
    }

    fn over(folder: TempDir) -> Self {
        let store = Store::open(folder.path()).expect("a new folder");
        let own_worlds = folder.path().join("worlds");
        let catalog = Catalog::load(Some(&own_worlds)).expect("the embedded files");
        let lab = Lab::new(catalog, store, 2);
        let app = App { lab, frames: Frames::new(Renderer::start(Backend::Cpu)) };
        Self { app, folder }
    }

    pub(crate) fn lab(&self) -> &Lab {
        &self.app.lab
    }

    /// Changes what is stored behind the laboratory's back.
    pub(crate) fn tamper(&self, sql: &str) {
        let file = self.folder.path().join("sonarium.sqlite");
        let database = rusqlite::Connection::open(file).expect("the index opens");
        database.execute_batch(sql).expect("a good statement");
    }

    /// The same folder after a restart of the server.
    pub(crate) async fn restart(self) -> Self {
        self.app.lab.close().await;
        let Self { app, folder } = self;
        drop(app);
        // Actors hold the store until their threads have ended.
        let mut store = Store::open(folder.path());
        while store.is_err() {
            tokio::task::yield_now().await;
            store = Store::open(folder.path());
        }
        drop(store);
        Self::over(folder)
    }

    /// A new session with seed 1.
    pub(crate) fn session(&self, trials: u32, speed: Speed) -> String {
        self.lab().create(&request(trials, speed)).expect("a good request").id
    }

    pub(crate) async fn control(&self, id: &str, control: Control) -> Ack {
        let answer = timeout(PATIENCE, self.lab().control(id, control)).await.expect("in time");
        answer.unwrap_or_else(|error| panic!("{}: {error}", control.name()))
    }

    /// Waits until a session is so.
    pub(crate) async fn until(&self, id: &str, is_so: impl Fn(&Session) -> bool) -> Session {
        let feed = self.lab().feed(id).expect("a session");
        let mut changes = feed.subscribe();
        let waiting = async {
            loop {
                changes.mark_unchanged();
                let session = feed.snapshot().session.clone();
                if is_so(&session) {
                    return session;
                }
                changes.changed().await.expect("the feed lives");
            }
        };
        timeout(PATIENCE, waiting).await.expect("in time")
    }

    pub(crate) async fn until_state(&self, id: &str, state: State) -> Session {
        self.until(id, |session| session.state == state).await
    }

    pub(crate) async fn get(&self, path: &str) -> Answer {
        self.request("GET", path, None).await
    }

    pub(crate) async fn post(&self, path: &str, body: Json) -> Answer {
        self.request("POST", path, Some(body.to_string())).await
    }

    pub(crate) async fn request(&self, method: &str, path: &str, body: Option<String>) -> Answer {
        let request = Request::builder()
            .method(method)
            .uri(path)
            .header(header::HOST, "localhost:7380")
            .header(header::CONTENT_TYPE, "application/json");
        self.send(request.body(body.map_or_else(Body::empty, Body::from)).expect("a request")).await
    }

    pub(crate) async fn send(&self, request: Request<Body>) -> Answer {
        let address = SocketAddr::from(([127, 0, 0, 1], 7380));
        let router = api::router(self.app.clone(), address);
        let response = router.oneshot(request).await.expect("routers do not fail");
        let (status, headers) = (response.status(), response.headers().clone());
        let kind = headers.get(header::CONTENT_TYPE).and_then(|kind| kind.to_str().ok());
        let kind = kind.unwrap_or_default().to_owned();
        let bytes = to_bytes(response.into_body(), usize::MAX).await.expect("a whole body");
        Answer { status, kind, bytes }
    }

    /// A real server on a free port.
    pub(crate) async fn listen(&self) -> SocketAddr {
        let listener = TcpListener::bind("127.0.0.1:0").await.expect("a free port");
        let address = listener.local_addr().expect("an address");
        tokio::spawn(api::serve(listener, self.app.clone(), std::future::pending()));
        address
    }
}

pub(crate) const MAX: Speed = Speed::Named(NamedSpeed::Max);
/// So slow that nothing happens after the first tick.
pub(crate) const SLOW: Speed = Speed::TicksPerSecond(0.1);

pub(crate) fn request(trials: u32, speed: Speed) -> NewSession {
    let body = json!({ "experiment": MINIMUM_COST_PATH, "seed": 1, "trials": trials });
    let request: NewSession = serde_json::from_value(body).expect("a good request");
    NewSession { speed: Some(speed), ..request }
}

/// The trials of a run that nobody watched, paused or logged.
pub(crate) fn undisturbed(trials: u32) -> Vec<Trial> {
    let catalog = Catalog::load(None).expect("the embedded files");
    let plan = catalog.resolve(&request(trials, MAX)).expect("a good request");
    let mut run = Run::new(&plan).expect("the default settings fit");
    std::iter::repeat_with(|| run.step_silently()).flatten().take(trials as usize).collect()
}
