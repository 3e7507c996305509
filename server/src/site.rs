//! The page, embedded in the program: index, scripts, styles and icon.

use axum::Router;
use axum::body::Body;
use axum::extract::Path;
use axum::http::{HeaderMap, HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use axum::routing::get;
use rust_embed::{Embed, EmbeddedFile};

/// The built site; `build.rs` says where it lies.
#[derive(Embed)]
#[folder = "$SITE_DIR"]
struct Site;

/// Everything the page loads comes from this server; pictures may also be made in the page.
const CONTENT_SECURITY_POLICY: &str = "default-src 'self'; img-src 'self' blob: data:; \
     object-src 'none'; base-uri 'none'; form-action 'self'; frame-ancestors 'self'";

/// Names under `assets/` carry a hash of their content, so a name never changes its meaning.
const IMMUTABLE: &str = "public, max-age=31536000, immutable";
const REVALIDATE: &str = "no-cache";

/// Routes of the page: one index for all pages, its assets, its icon.
pub fn router<S: Clone + Send + Sync + 'static>() -> Router<S> {
    Router::new()
        .route("/", get(index))
        .route("/sessions/{id}", get(index))
        .route("/worlds", get(index))
        .route("/worlds/{name}", get(index))
        .route("/lost-at-sea", get(index))
        .route("/calibration", get(index))
        .route("/rules/{name}", get(index))
        .route("/reproduce", get(index))
        .route("/reproduce/{target}", get(index))
        .route("/assets/{*path}", get(asset))
        .route("/favicon.svg", get(icon))
}

async fn index(request: HeaderMap) -> Response {
    file("index.html", REVALIDATE, &request)
}

async fn icon(request: HeaderMap) -> Response {
    file("favicon.svg", REVALIDATE, &request)
}

async fn asset(Path(path): Path<String>, request: HeaderMap) -> Response {
    file(&format!("assets/{path}"), IMMUTABLE, &request)
}

fn file(path: &str, caching: &'static str, request: &HeaderMap) -> Response {
    let Some(file) = Site::get(path) else {
        return (StatusCode::NOT_FOUND, format!("There is no {path} in this build of the page\n"))
            .into_response();
    };
    let tag = entity_tag(&file);
    let known = request.get(header::IF_NONE_MATCH).is_some_and(|given| given.as_bytes() == tag);
    let mut response = if known { StatusCode::NOT_MODIFIED.into_response() } else { content(file) };
    let headers = response.headers_mut();
    headers.insert(header::CACHE_CONTROL, HeaderValue::from_static(caching));
    headers
        .insert(header::CONTENT_SECURITY_POLICY, HeaderValue::from_static(CONTENT_SECURITY_POLICY));
    headers.insert(header::X_CONTENT_TYPE_OPTIONS, HeaderValue::from_static("nosniff"));
    if let Ok(tag) = HeaderValue::from_bytes(&tag) {
        headers.insert(header::ETAG, tag);
    }
    response
}

fn content(file: EmbeddedFile) -> Response {
    let kind = file.metadata.mimetype().to_owned();
    let kind = if kind.starts_with("text/") { format!("{kind}; charset=utf-8") } else { kind };
    ([(header::CONTENT_TYPE, kind)], Body::from(file.data.into_owned())).into_response()
}

/// The first 16 bytes of the content's SHA-256, quoted.
fn entity_tag(file: &EmbeddedFile) -> Vec<u8> {
    let hash = file.metadata.sha256_hash();
    let digits: String = hash[..16].iter().map(|byte| format!("{byte:02x}")).collect();
    format!("\"{digits}\"").into_bytes()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn header_of(response: &Response, name: header::HeaderName) -> &str {
        response.headers().get(name).and_then(|value| value.to_str().ok()).unwrap_or_default()
    }

    fn asset_ending(end: &str) -> String {
        Site::iter()
            .find(|path| path.ends_with(end))
            .expect("the site has such a file")
            .into_owned()
    }

    #[test]
    fn index_is_html_and_always_asked_again() {
        let response = file("index.html", REVALIDATE, &HeaderMap::new());
        assert_eq!(response.status(), StatusCode::OK);
        assert_eq!(header_of(&response, header::CONTENT_TYPE), "text/html; charset=utf-8");
        assert_eq!(header_of(&response, header::CACHE_CONTROL), "no-cache");
        assert!(
            header_of(&response, header::CONTENT_SECURITY_POLICY).contains("default-src 'self'")
        );
    }

    #[test]
    fn scripts_and_styles_have_their_types() {
        for (end, kind) in [(".js", "text/javascript"), (".css", "text/css")] {
            let response = file(&asset_ending(end), IMMUTABLE, &HeaderMap::new());
            let expected = format!("{kind}; charset=utf-8");
            assert_eq!(header_of(&response, header::CONTENT_TYPE), expected);
            assert!(header_of(&response, header::CACHE_CONTROL).ends_with("immutable"));
        }
    }

    #[test]
    fn known_content_is_not_sent_again() {
        let first = file("index.html", REVALIDATE, &HeaderMap::new());
        let mut request = HeaderMap::new();
        request.insert(header::IF_NONE_MATCH, first.headers()[header::ETAG].clone());
        let second = file("index.html", REVALIDATE, &request);
        assert_eq!(second.status(), StatusCode::NOT_MODIFIED);
        assert_eq!(second.headers()[header::ETAG], first.headers()[header::ETAG]);
    }

    #[test]
    fn unknown_files_are_not_found() {
        for path in ["assets/none.js", "assets/../../Cargo.toml", ""] {
            let response = file(path, IMMUTABLE, &HeaderMap::new());
            assert_eq!(response.status(), StatusCode::NOT_FOUND, "{path}");
        }
    }
}
