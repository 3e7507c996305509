//! Robots and their sensors.

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
