//! Who may talk to the server.

use axum::body::to_bytes;
use axum::extract::Request;
use axum::http::{HeaderMap, StatusCode, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};

use super::LARGEST_BODY;
use super::extract::too_large;
use super::problem::Failure;
use super::sessions::LARGEST_SESSION;
use super::worlds::LARGEST_WORLD;

/// Refuses foreign host names, so that a page elsewhere cannot make its own name point here (DNS
/// rebinding). A request without `Host` does not come from a browser.
pub(super) async fn local_host(request: Request, next: Next) -> Response {
    match host(request.headers()) {
        Some(host) if !is_local(host) => Failure::new(
            StatusCode::MISDIRECTED_REQUEST,
            "misdirected",
            "This server answers to this machine only",
            format!(
                "the host is `{host}`; use localhost, 127.0.0.1 or [::1], or start with --listen"
            ),
        )
        .into_response(),
        _ => next.run(request).await,
    }
}

/// How the field begins that may make a request for a session large.
const NETWORK: &[u8] = b"\"network\"";

/// Largest refused body that is still read to its end, bytes.
const LARGEST_HEARD: usize = 8 * LARGEST_BODY;

/// Refuses a body that says it is too large. Most clients listen only after they have sent all, so a
/// moderate one is heard out; a huge one is cut off.
pub(super) async fn body_size(request: Request, next: Next) -> Response {
    let limit = largest_body(request.uri().path());
    let length = request.headers().get(header::CONTENT_LENGTH);
    let length = length.and_then(|value| value.to_str().ok()?.parse::<u64>().ok());
    if length.is_some_and(|length| length > limit as u64) {
        if length.is_some_and(|length| length <= LARGEST_HEARD as u64) {
            // A client that goes away in between needs no answer.
            let _ = to_bytes(request.into_body(), LARGEST_HEARD).await;
        }
        return too_large(limit).into_response();
    }
    if limit == LARGEST_SESSION && length.is_some_and(|length| length > LARGEST_BODY as u64) {
        return network_only(request, next).await;
    }
    next.run(request).await
}

/// Passes a request for a session on that is as large as only one with a network may be.
async fn network_only(request: Request, next: Next) -> Response {
    let (parts, body) = request.into_parts();
    let Ok(body) = to_bytes(body, LARGEST_SESSION).await else {
        return too_large(LARGEST_SESSION).into_response();
    };
    if !body.windows(NETWORK.len()).any(|part| part == NETWORK) {
        return too_large(LARGEST_BODY).into_response();
    }
    next.run(Request::from_parts(parts, body.into())).await
}

/// Largest body that a path takes, bytes, with or without the root of the interface. Maps, worlds traced
/// from them and networks that a session goes on with are larger than all else.
pub(super) fn largest_body(path: &str) -> usize {
    let path = path.strip_prefix("/api/v1").unwrap_or(path);
    match path {
        "/sessions" => LARGEST_SESSION,
        _ if path.starts_with("/worlds/") => LARGEST_WORLD,
        _ => LARGEST_BODY,
    }
}

/// Refuses changes that a page of another origin asks for; a browser would send them.
pub(super) async fn same_origin(request: Request, next: Next) -> Response {
    match check_origin(request.headers()) {
        Err(refusal) if !request.method().is_safe() => refusal.into_response(),
        _ => next.run(request).await,
    }
}

/// Refuses a page of another origin, which a browser would let open a WebSocket here.
pub(super) fn check_origin(headers: &HeaderMap) -> Result<(), Failure> {
    let Some(origin) = headers.get(header::ORIGIN) else { return Ok(()) };
    let origin = origin.to_str().unwrap_or_default();
    let of = origin.split_once("://").map(|(_, host)| host);
    if of.is_some() && of == host(headers) {
        return Ok(());
    }
    Err(Failure::new(
        StatusCode::FORBIDDEN,
        "foreign-origin",
        "Another page may not do this",
        format!("the origin is `{origin}`; open the page of this server"),
    ))
}

fn host(headers: &HeaderMap) -> Option<&str> {
    headers.get(header::HOST).and_then(|host| host.to_str().ok())
}

fn is_local(host: &str) -> bool {
    let name = match host.rsplit_once(':') {
        Some((name, port)) if port.bytes().all(|b| b.is_ascii_digit()) => name,
        _ => host,
    };
    matches!(name.to_ascii_lowercase().as_str(), "localhost" | "127.0.0.1" | "[::1]")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_names_of_this_machine_are_local() {
        for (host, expected) in [
            ("localhost", true),
            ("localhost:7380", true),
            ("LOCALHOST:1", true),
            ("127.0.0.1:7380", true),
            ("[::1]:7380", true),
            ("[::1]", true),
            ("example.org", false),
            ("example.org:7380", false),
            ("localhost.example.org", false),
            ("127.0.0.1.example.org:80", false),
            ("", false),
        ] {
            assert_eq!(is_local(host), expected, "{host:?}");
        }
    }

    #[test]
    fn a_stream_is_opened_from_the_same_host() {
        for (origin, expected) in [
            (None, true),
            (Some("http://localhost:7380"), true),
            (Some("http://localhost:8000"), false),
            (Some("https://example.org"), false),
            (Some("null"), false),
        ] {
            let mut headers = HeaderMap::new();
            headers.insert(header::HOST, "localhost:7380".parse().expect("a header"));
            if let Some(origin) = origin {
                headers.insert(header::ORIGIN, origin.parse().expect("a header"));
            }
            assert_eq!(check_origin(&headers).is_ok(), expected, "{origin:?}");
        }
    }
}
