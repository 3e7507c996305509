//! The document that describes the interface, and the page that shows it.

use axum::Router;
use axum::extract::DefaultBodyLimit;
use utoipa::OpenApi;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;
use utoipa_swagger_ui::SwaggerUi;

use super::{
    App, arena, calibration, controls, experiments, files, fusion, interventions, maps,
    reproductions, rules, sessions, starts, stream, ticks, traces, worlds,
};

#[derive(OpenApi)]
#[openapi(
    info(
        title = "Sonarium",
        description = "A robot-learning laboratory: experiments, sessions and their reports.\n\n\
            Every refusal is an RFC 9457 problem that names the field at fault: 400 when a request \
            cannot be read, 422 when a value is not acceptable, 409 when the session's state does not \
            allow a control.\n\n\
            `GET /api/v1/sessions/{id}/stream` is a WebSocket; its messages are described in \
            `server/src/wire/stream.rs`.",
        license(name = "MIT OR Apache-2.0")
    ),
    servers((url = "/api/v1"))
)]
struct Document;

/// All documented routes.
pub(super) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::with_openapi(Document::openapi())
        .routes(routes!(experiments::list))
        .routes(routes!(experiments::one))
        .routes(routes!(experiments::picture))
        .routes(routes!(sessions::one, sessions::delete))
        .routes(routes!(controls::start))
        .routes(routes!(controls::pause))
        .routes(routes!(controls::resume))
        .routes(routes!(controls::step))
        .routes(routes!(controls::stop))
        .routes(routes!(controls::reset))
        .routes(routes!(controls::speed))
        .routes(routes!(interventions::advise))
        .routes(routes!(interventions::save, interventions::change))
        .routes(routes!(interventions::method))
        .routes(routes!(interventions::sonar))
        .routes(routes!(rules::one))
        .routes(routes!(ticks::runs))
        .routes(routes!(ticks::episodes))
        .routes(routes!(ticks::trials))
        .routes(routes!(ticks::trial))
        .routes(routes!(ticks::ticks))
        .routes(routes!(ticks::neurons))
        .routes(routes!(ticks::neuron))
        .routes(routes!(arena::picture))
        .routes(routes!(sessions::network))
        .routes(routes!(starts::list))
        .routes(routes!(starts::picture))
        .routes(routes!(files::log))
        .routes(routes!(files::session))
        .routes(routes!(files::trial))
        .routes(routes!(reproductions::list))
        .routes(routes!(reproductions::one))
        .routes(routes!(reproductions::progress))
        .routes(routes!(reproductions::rows))
        .routes(routes!(reproductions::curves))
        .routes(routes!(reproductions::picture))
        .routes(routes!(fusion::fuse))
        .routes(routes!(calibration::one))
        .routes(routes!(calibration::file))
        .routes(routes!(stream::open))
        .merge(world_routes())
        .merge(session_routes())
}

/// Routes whose bodies may carry a network.
fn session_routes() -> OpenApiRouter<App> {
    OpenApiRouter::new()
        .routes(routes!(sessions::create, sessions::list))
        .layer(DefaultBodyLimit::max(sessions::LARGEST_SESSION))
}

/// Routes whose bodies may carry a world or a map.
fn world_routes() -> OpenApiRouter<App> {
    OpenApiRouter::new()
        .routes(routes!(worlds::list))
        .routes(routes!(worlds::one, worlds::save, worlds::delete))
        .routes(routes!(worlds::check))
        .routes(routes!(worlds::regions))
        .routes(routes!(worlds::picture))
        .routes(routes!(maps::one, maps::keep, maps::delete))
        .routes(routes!(traces::create))
        .layer(DefaultBodyLimit::max(worlds::LARGEST_WORLD))
}

/// The document at `/api/openapi.json` and its page at `/api/docs`.
pub(super) fn page(document: utoipa::openapi::OpenApi) -> Router {
    SwaggerUi::new("/api/docs").url("/api/openapi.json", document).into()
}
