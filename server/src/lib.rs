//! Sonarium's server: sessions, storage, HTTP, WebSocket, rendering, reports and the command line.

pub mod api;
pub mod batch;
pub mod calibration;
pub mod catalog;
pub mod cli;
mod clock;
mod process;
pub mod render;
pub mod report;
pub mod reproduce;
pub mod rosmap;
pub mod session;
pub mod site;
pub mod store;
pub mod stream;
#[cfg(test)]
mod testing;
pub mod wire;
pub mod yardstick;

/// Program version and commit.
#[must_use]
pub fn build() -> String {
    format!(
        "{} ({})",
        env!("CARGO_PKG_VERSION"),
        option_env!("SONARIUM_COMMIT").unwrap_or("unknown")
    )
}
