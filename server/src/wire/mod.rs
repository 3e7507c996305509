//! What travels: the JSON of the HTTP interface, of the stream, of the log and of the command line.
//!
//! Angles are degrees and lengths metres here; `core` works in radians. The page's TypeScript is
//! generated from these types, and a test fails when it is stale.

mod calibration;
mod drive;
mod experiment;
mod fusion;
mod network;
mod reproduction;
mod session;
mod start;
mod stream;
mod table;
mod tick;
mod typescript;
mod world;
mod yardstick;

pub use calibration::*;
pub use drive::*;
pub use experiment::*;
pub use fusion::*;
pub use network::*;
pub use reproduction::*;
pub use session::*;
pub use start::*;
pub use stream::*;
pub use table::*;
pub use tick::*;
pub use typescript::typescript;
pub use world::*;
pub use yardstick::*;
