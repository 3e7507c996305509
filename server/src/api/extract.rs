//! Reading requests: like axum's extractors, but what cannot be read is a problem that names the field.

use axum::body::Bytes;
use axum::extract::rejection::{BytesRejection, FailedToBufferBody, PathRejection};
use axum::extract::{FromRequest, FromRequestParts, Request};
use axum::http::request::Parts;
use axum::http::{HeaderMap, StatusCode, header};
use serde::de::DeserializeOwned;

use super::guard::largest_body;
use super::problem::Failure;

/// A JSON body.
pub(super) struct Body<T>(pub(super) T);

impl<S: Send + Sync, T: DeserializeOwned> FromRequest<S> for Body<T> {
    type Rejection = Failure;

    async fn from_request(request: Request, state: &S) -> Result<Self, Failure> {
        check_json(request.headers())?;
        let bytes = bytes(request, state).await?;
        parse(&bytes).map(Self)
    }
}

/// A JSON body that may be left out.
pub(super) struct OptionalBody<T>(pub(super) T);

impl<S: Send + Sync, T: DeserializeOwned + Default> FromRequest<S> for OptionalBody<T> {
    type Rejection = Failure;

    async fn from_request(request: Request, state: &S) -> Result<Self, Failure> {
        let checked = check_json(request.headers());
        let bytes = bytes(request, state).await?;
        if bytes.is_empty() || bytes.as_ref() == b"null" {
            return Ok(Self(T::default()));
        }
        checked?;
        parse(&bytes).map(Self)
    }
}

/// Parts of the path.
pub(super) struct Path<T>(pub(super) T);

impl<S: Send + Sync, T: DeserializeOwned + Send> FromRequestParts<S> for Path<T> {
    type Rejection = Failure;

    async fn from_request_parts(parts: &mut Parts, state: &S) -> Result<Self, Failure> {
        let path = axum::extract::Path::from_request_parts(parts, state).await;
        path.map(|axum::extract::Path(value)| Self(value)).map_err(|rejection| {
            let field = match &rejection {
                PathRejection::FailedToDeserializePathParams(error) => field_of_path(error.kind()),
                _ => None,
            };
            named(Failure::unreadable(rejection.body_text()), field)
        })
    }
}

/// The query.
pub(super) struct Query<T>(pub(super) T);

impl<S: Send + Sync, T: DeserializeOwned> FromRequestParts<S> for Query<T> {
    type Rejection = Failure;

    async fn from_request_parts(parts: &mut Parts, _: &S) -> Result<Self, Failure> {
        let query = parts.uri.query().unwrap_or_default();
        let deserializer =
            serde_urlencoded::Deserializer::new(form_urlencoded::parse(query.as_bytes()));
        serde_path_to_error::deserialize(deserializer).map(Self).map_err(|error| {
            let (path, detail) = (error.path().to_string(), error.inner().to_string());
            named(Failure::unreadable(detail.clone()), field_of(&path, &detail))
        })
    }
}

/// The kind of a body, without its parameters.
pub(super) fn media_type(headers: &HeaderMap) -> &str {
    let given = headers.get(header::CONTENT_TYPE).and_then(|value| value.to_str().ok());
    given.and_then(|value| value.split(';').next()).unwrap_or_default().trim()
}

/// Refuses a body that is not announced as JSON; a browser asks before it sends one elsewhere.
pub(super) fn check_json(headers: &HeaderMap) -> Result<(), Failure> {
    let found = media_type(headers);
    if found.eq_ignore_ascii_case("application/json") {
        return Ok(());
    }
    let found = if found.is_empty() { "nothing" } else { found };
    Err(Failure::new(
        StatusCode::UNSUPPORTED_MEDIA_TYPE,
        "unsupported-media-type",
        "The body must be JSON",
        format!("send the body with `content-type: application/json`, not `{found}`"),
    ))
}

/// Reads a JSON object.
pub(super) fn parse<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, Failure> {
    // A list would be read as the fields in their order, which nobody means.
    if bytes.trim_ascii_start().first() == Some(&b'[') {
        return Err(Failure::unreadable("the body must be a JSON object, not a list"));
    }
    let mut deserializer = serde_json::Deserializer::from_slice(bytes);
    let value = serde_path_to_error::deserialize(&mut deserializer).map_err(|error| {
        let (path, detail) = (error.path().to_string(), error.inner().to_string());
        let field = if error.inner().is_data() { field_of(&path, &detail) } else { None };
        let detail = match field.as_deref().and_then(expected) {
            Some(expected) => format!("must be {expected} ({detail})"),
            None => detail,
        };
        named(Failure::unreadable(detail), field)
    })?;
    deserializer
        .end()
        .map_err(|error| Failure::unreadable(format!("after the JSON object: {error}")))?;
    Ok(value)
}

/// What would be right, for the fields whose types say too little.
fn expected(field: &str) -> Option<&'static str> {
    match field {
        "seed" => Some("a whole number from 0 to 9007199254740991"),
        "trials" => Some("a whole number from 1 to 100000"),
        "speed" => Some("ticks a second from 0.1 to 10000, or \"max\""),
        "settings" => Some("an object of settings, e.g. {\"sonar.noise\": 0.02}"),
        _ => None,
    }
}

/// The field at fault: where the reader stood, or what it missed or did not know.
fn field_of(path: &str, detail: &str) -> Option<String> {
    if path != "." && !path.is_empty() {
        return Some(path.to_owned());
    }
    let quoted = ["unknown field `", "missing field `"].into_iter().find_map(|start| {
        let rest = detail.strip_prefix(start)?;
        rest.split('`').next()
    });
    quoted.map(str::to_owned)
}

fn field_of_path(kind: &axum::extract::path::ErrorKind) -> Option<String> {
    use axum::extract::path::ErrorKind;
    match kind {
        ErrorKind::ParseErrorAtKey { key, .. } | ErrorKind::DeserializeError { key, .. } => {
            Some(key.clone())
        }
        ErrorKind::InvalidUtf8InPathParam { key } => Some(key.clone()),
        _ => None,
    }
}

fn named(failure: Failure, field: Option<String>) -> Failure {
    match field {
        Some(field) => failure.at(field),
        None => failure,
    }
}

/// A body as it came.
pub(super) struct Raw(pub(super) Bytes);

impl<S: Send + Sync> FromRequest<S> for Raw {
    type Rejection = Failure;

    async fn from_request(request: Request, state: &S) -> Result<Self, Failure> {
        bytes(request, state).await.map(Self)
    }
}

/// A body up to the limit of its route.
async fn bytes<S: Send + Sync>(request: Request, state: &S) -> Result<Bytes, Failure> {
    let limit = largest_body(request.uri().path());
    let bytes = Bytes::from_request(request, state).await;
    bytes.map_err(|rejection| unreadable_body(&rejection, limit))
}

fn unreadable_body(rejection: &BytesRejection, limit: usize) -> Failure {
    if let BytesRejection::FailedToBufferBody(FailedToBufferBody::LengthLimitError(_)) = rejection {
        return too_large(limit);
    }
    Failure::unreadable(rejection.body_text())
}

/// A body over a limit in bytes.
#[must_use]
pub(super) fn too_large(limit: usize) -> Failure {
    Failure::new(
        StatusCode::PAYLOAD_TOO_LARGE,
        "too-large",
        "The body is too large",
        format!("a body may have at most {} MiB here", limit >> 20),
    )
}
