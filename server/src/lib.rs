//! Sonarium's server: sessions, storage, HTTP, WebSocket, rendering, reports and the command line.

pub mod render;
pub mod report;
pub mod site;
pub mod store;
pub mod wire;
