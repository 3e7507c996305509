//! The stream: a viewer's WebSocket.
//!
//! Each viewer has one task that reads the session's feed at its own pace. What it cannot send in time
//! it never sends: samples and pictures are the latest ones, and only events are kept for it, in the
//! feed's bounded ring.

mod connection;
mod frames;
mod subscription;

#[cfg(test)]
mod tests;

pub use connection::{Goodbye, serve};
pub use frames::Frames;
pub use subscription::{LARGEST_MESSAGE, Subscription};
