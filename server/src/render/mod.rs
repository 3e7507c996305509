//! Pictures of the arena, drawn offscreen.
//!
//! An [`ArenaView`] (plain data) becomes a [`scene::Scene`] (a list of primitives in pixels), and
//! that becomes pixels on one of two back ends that look alike: `wgpu` where there is a graphics
//! adapter, `vello_cpu` everywhere else. [`Renderer`] owns the back end on a thread of its own.

mod arena;
mod bench;
mod cpu;
mod gpu;
mod laboratory;
mod png;
mod projection;
mod renderer;
pub mod scene;
mod text;
mod theme;
pub mod view;

#[cfg(test)]
mod tests;

pub use arena::{MOST_GHOSTS, scene as arena_scene};
pub use bench::{Measurement, bench};
pub use cpu::CpuBackend;
pub use gpu::{AdapterChoice, GpuBackend, gpu_available};
pub use png::{Quality, encode};
pub use renderer::Renderer;
pub use view::{ArenaView, NeuronMark, PathOf, RegionView, RobotPose, RobotView};

use std::str::FromStr;

/// Greatest width and height of a picture, pixels.
pub const LARGEST_PX: u32 = 4096;

/// Memory for larger pictures than this, in pixels, is given back after each.
const MOST_KEPT_PX: u32 = 2048 * 2048;

/// The bytes of a PNG file; cloning shares them.
pub type Picture = axum::body::Bytes;

/// A drawn picture: rows from the top, four bytes (red, green, blue, 255) a pixel, no padding.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pixels {
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
    /// `width · height · 4` bytes.
    pub rgba: Vec<u8>,
}

/// Which back end draws. Read from `SONARIUM_RENDERER` by [`Backend::from_environment`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Backend {
    /// `auto`: a real graphics adapter if there is one, else the CPU.
    #[default]
    Auto,
    /// `gpu`: like `auto`, but a missing adapter is worth a warning.
    Gpu,
    /// `gpu-any`: any adapter, even one that is simulated on the CPU (for development).
    GpuAny,
    /// `cpu`: never look for an adapter.
    Cpu,
}

impl Backend {
    /// What the environment variable `SONARIUM_RENDERER` asks for; `auto` when it is not set.
    pub fn from_environment() -> Result<Self, RenderError> {
        match std::env::var("SONARIUM_RENDERER") {
            Ok(value) => value.parse(),
            Err(_) => Ok(Self::Auto),
        }
    }
}

impl FromStr for Backend {
    type Err = RenderError;

    fn from_str(value: &str) -> Result<Self, RenderError> {
        match value.trim() {
            "" | "auto" => Ok(Self::Auto),
            "gpu" => Ok(Self::Gpu),
            "gpu-any" => Ok(Self::GpuAny),
            "cpu" => Ok(Self::Cpu),
            other => Err(RenderError::Backend(other.to_owned())),
        }
    }
}

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum RenderError {
    /// A size that cannot be drawn.
    #[error("{field} is {value} pixels; it must be 1 to {most}")]
    Size {
        /// `width` or `height`.
        field: &'static str,
        /// What was asked for.
        value: u32,
        /// The greatest that can be drawn.
        most: u32,
    },
    /// `SONARIUM_RENDERER` is none of the known words.
    #[error("SONARIUM_RENDERER is {0:?}; it must be auto, gpu, gpu-any or cpu")]
    Backend(String),
    /// Too many pictures wait already.
    #[error("{waiting} pictures are waiting to be drawn already; ask again later")]
    Busy {
        /// How many may wait.
        waiting: usize,
    },
    /// The drawing thread is gone.
    #[error("the drawing thread has ended; restart the server to get pictures again")]
    Lost,
    /// No adapter of the kind asked for; the text names what to install.
    #[error("{0}")]
    NoAdapter(String),
    /// The graphics device went away; it can be opened anew.
    #[error("the graphics device was lost: {0}")]
    DeviceLost(String),
    /// The back end could not draw.
    #[error("the picture could not be drawn: {0}")]
    Failed(String),
    /// The PNG encoder failed.
    #[error("the picture could not be encoded as PNG: {0}")]
    Png(#[from] ::png::EncodingError),
}
