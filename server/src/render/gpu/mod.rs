//! stub
use super::{Pixels, RenderError, scene::Scene};
/// x
#[derive(Clone, Copy, Debug)]
pub enum AdapterChoice {
    /// x
    Hardware,
    /// x
    Any,
}
/// x
pub struct GpuBackend;
impl GpuBackend {
    /// x
    pub fn open(_: AdapterChoice) -> Result<Self, RenderError> {
        Err(RenderError::NoAdapter("none".into()))
    }
    /// x
    pub fn name(&self) -> String {
        String::new()
    }
    /// x
    pub fn draw(&mut self, _: &Scene) -> Result<Pixels, RenderError> {
        Err(RenderError::Lost)
    }
}
/// x
pub fn gpu_available() -> bool {
    false
}
