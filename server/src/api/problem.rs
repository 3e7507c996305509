//! Refusals and failures as RFC 9457 problem details.
//!
//! The statuses: 400 when the request cannot be read as what it should be (JSON, a number in a path or
//! query, an unknown field), 422 when it could be read but a value is not acceptable, 404 for what does
//! not exist, 409 for what the state does not allow, 413 for too large a body, 415 for a body that is
//! not JSON, 421 for a foreign `Host`, 507 when the disk refused, 500 for our own failures.

use axum::Json;
use axum::http::{HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};

use crate::catalog::FieldError;
use crate::render::RenderError;
use crate::session::{ControlError, LabError};
use crate::store::StoreError;
use crate::wire::Problem;

/// What every handler fails with; boxed, so that what succeeds is not moved about at its size.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure(pub Box<Problem>);

impl Failure {
    /// A problem of a kind, e.g. `not-found`.
    #[must_use]
    pub fn new(status: StatusCode, kind: &str, title: &str, detail: impl Into<String>) -> Self {
        Self(Box::new(Problem {
            kind: format!("/problems/{kind}"),
            title: title.to_owned(),
            status: status.as_u16(),
            detail: detail.into(),
            field: None,
            place: None,
        }))
    }

    /// The same, naming the field at fault.
    #[must_use]
    pub fn at(mut self, field: impl Into<String>) -> Self {
        self.0.field = Some(field.into());
        self
    }

    /// The request cannot be read.
    #[must_use]
    pub fn unreadable(detail: impl Into<String>) -> Self {
        Self::new(StatusCode::BAD_REQUEST, "unreadable", "The request cannot be read", detail)
    }

    /// A value is not acceptable.
    #[must_use]
    pub fn not_acceptable(field: &str, detail: impl Into<String>) -> Self {
        let title = "A value is not acceptable";
        Self::new(StatusCode::UNPROCESSABLE_ENTITY, "not-acceptable", title, detail).at(field)
    }

    /// There is no such thing.
    #[must_use]
    pub fn not_found(detail: impl Into<String>) -> Self {
        Self::new(StatusCode::NOT_FOUND, "not-found", "There is no such thing", detail)
    }

    /// The state does not allow it.
    #[must_use]
    pub fn conflict(detail: impl Into<String>) -> Self {
        Self::new(StatusCode::CONFLICT, "conflict", "The session's state does not allow it", detail)
    }

    /// Something here failed.
    #[must_use]
    pub fn internal(detail: impl Into<String>) -> Self {
        let title = "The server could not do it";
        Self::new(StatusCode::INTERNAL_SERVER_ERROR, "internal", title, detail)
    }
}

impl IntoResponse for Failure {
    fn into_response(self) -> Response {
        let status = StatusCode::from_u16(self.0.status).unwrap_or_default();
        let mut response = (status, Json(self.0)).into_response();
        response
            .headers_mut()
            .insert(header::CONTENT_TYPE, HeaderValue::from_static("application/problem+json"));
        response
    }
}

impl From<FieldError> for Failure {
    fn from(error: FieldError) -> Self {
        Self::not_acceptable(&error.field, error.message)
    }
}

impl From<StoreError> for Failure {
    fn from(error: StoreError) -> Self {
        match &error {
            StoreError::NoSession { .. } => Self::not_found(error.to_string()),
            StoreError::LogExists { .. } | StoreError::LogTooShort { .. } => {
                Self::conflict(error.to_string())
            }
            StoreError::Index { reason, .. } if !reason.contains("full") => {
                Self::internal(error.to_string())
            }
            StoreError::Folder { .. } | StoreError::File { .. } | StoreError::Index { .. } => {
                Self::new(
                    StatusCode::INSUFFICIENT_STORAGE,
                    "storage",
                    "The data folder refused",
                    error.to_string(),
                )
            }
            _ => Self::internal(error.to_string()),
        }
    }
}

impl From<ControlError> for Failure {
    fn from(error: ControlError) -> Self {
        match error {
            ControlError::Refused(refused) => Self::conflict(refused.to_string()),
            ControlError::Field(error) => error.into(),
            ControlError::Store(error) => error.into(),
            ControlError::NotUnderWay { .. } => Self::conflict(error.to_string()),
            ControlError::Gone => Self::internal(error.to_string()),
        }
    }
}

impl From<LabError> for Failure {
    fn from(error: LabError) -> Self {
        match error {
            LabError::Busy(_) => Self::conflict(error.to_string()),
            LabError::Field(error) => error.into(),
            LabError::Store(error) => error.into(),
        }
    }
}

impl From<RenderError> for Failure {
    fn from(error: RenderError) -> Self {
        Self::internal(error.to_string())
    }
}
