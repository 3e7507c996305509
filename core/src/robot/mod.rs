//! Robots and their sensors.

mod b21;
mod motion;

pub use b21::{B21, B21Settings, SONARS, Sensed};
pub(crate) use motion::Course;
pub use motion::Motion;

/// What the body touched.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Contact {
    /// Nothing.
    #[default]
    None,
    /// Virtual collision: an infrared reflectance above the threshold.
    Virtual,
    /// Real collision: the tactile ring.
    Real,
}
