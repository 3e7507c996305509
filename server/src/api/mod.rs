//! The HTTP interface, under `/api/v1`, and what stands around it: the stream, health, metrics, the
//! OpenAPI document and its page.

mod arena;
mod calibration;
mod controls;
mod experiments;
mod extract;
mod files;
mod fusion;
mod guard;
mod interventions;
mod maps;
mod openapi;
mod problem;
mod reproductions;
mod rules;
mod sessions;
mod starts;
mod status;
mod stream;
mod ticks;
mod traces;
mod worlds;

#[cfg(test)]
mod tests;

use std::future::Future;
use std::io;
use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;

use axum::extract::{DefaultBodyLimit, OriginalUri};
use axum::http::{Method, StatusCode};
use axum::response::{IntoResponse, Response};
use axum::routing::get;
use axum::serve::ListenerExt;
use axum::{Router, middleware};
use tokio::net::TcpListener;
use tokio::sync::Notify;
use tower_http::catch_panic::CatchPanicLayer;
use tower_http::compression::CompressionLayer;
use tower_http::compression::predicate::{DefaultPredicate, NotForContentType, Predicate};

pub use problem::Failure;

use crate::session::{Lab, Reporter};
use crate::stream::Frames;

/// Largest body of a request, bytes.
const LARGEST_BODY: usize = 1 << 20;
/// How long unfinished downloads may hold up the end of the server.
const PATIENCE: Duration = Duration::from_secs(5);

/// What the handlers share.
#[derive(Clone)]
pub struct App {
    /// The sessions.
    pub lab: Lab,
    /// The pictures.
    pub frames: Frames,
}

impl App {
    fn reporter(&self) -> Reporter<'_> {
        Reporter { lab: &self.lab, renderer: self.frames.renderer() }
    }
}

/// Serves a laboratory on a listener until `shutdown`; then all sessions are put down so that they can
/// be taken up again.
///
/// # Errors
/// When the listener fails.
pub async fn serve(
    listener: TcpListener,
    app: App,
    shutdown: impl Future<Output = ()> + Send + 'static,
) -> io::Result<()> {
    let address = listener.local_addr()?;
    let (lab, router) = (app.lab.clone(), router(app, address));
    let listener = listener.tap_io(|connection| {
        // Small messages leave at once; without it they only leave later.
        let _ = connection.set_nodelay(true);
    });
    let closed = Arc::new(Notify::new());
    let ending = {
        let closed = closed.clone();
        async move {
            shutdown.await;
            lab.close().await;
            closed.notify_one();
        }
    };
    let server = axum::serve(listener, router).with_graceful_shutdown(ending).into_future();
    tokio::select! {
        result = server => result,
        () = async { closed.notified().await; tokio::time::sleep(PATIENCE).await } => Ok(()),
    }
}

/// All routes. When the server listens to this machine only, foreign host names are refused.
pub fn router(app: App, address: SocketAddr) -> Router {
    let (api, document) = openapi::routes().split_for_parts();
    let api = api.fallback(no_such_route).method_not_allowed_fallback(no_such_method);
    let not_packed_twice = DefaultPredicate::new()
        .and(NotForContentType::const_new("application/zip"))
        .and(NotForContentType::const_new("application/octet-stream"));
    let router = Router::new()
        .nest("/api/v1", api)
        .route("/api/{*rest}", get(no_such_route).fallback(no_such_route))
        .route("/healthz", get(status::health))
        .route("/metrics", get(status::metrics))
        .with_state(app)
        .merge(openapi::page(document))
        .merge(crate::site::router())
        .layer(DefaultBodyLimit::max(LARGEST_BODY))
        .layer(middleware::from_fn(guard::body_size))
        .layer(middleware::from_fn(guard::same_origin))
        .layer(CompressionLayer::new().compress_when(not_packed_twice))
        .layer(CatchPanicLayer::custom(panicked));
    if address.ip().is_loopback() {
        router.layer(middleware::from_fn(guard::local_host))
    } else {
        router
    }
}

/// Runs what reads the disk or draws, apart from the threads that serve connections.
async fn blocking<T: Send + 'static, E: Into<Failure> + Send + 'static>(
    work: impl FnOnce() -> Result<T, E> + Send + 'static,
) -> Result<T, Failure> {
    match tokio::task::spawn_blocking(work).await {
        Ok(result) => result.map_err(Into::into),
        Err(error) => Err(Failure::internal(error.to_string())),
    }
}

async fn no_such_route(OriginalUri(uri): OriginalUri) -> Failure {
    Failure::not_found(format!("there is no {}; /api/docs lists what there is", uri.path()))
}

async fn no_such_method(method: Method, OriginalUri(uri): OriginalUri) -> Failure {
    Failure::new(
        StatusCode::METHOD_NOT_ALLOWED,
        "method-not-allowed",
        "This cannot be done with it",
        format!("{} does not take {method}; /api/docs lists what it takes", uri.path()),
    )
}

fn panicked(panic: Box<dyn std::any::Any + Send>) -> Response {
    let text = panic.downcast_ref::<&str>().copied();
    let text = text.or_else(|| panic.downcast_ref::<String>().map(String::as_str));
    Failure::internal(text.unwrap_or("a panic")).into_response()
}
