//! The back end on a graphics adapter, through `wgpu`: one pipeline, one draw call a picture.

mod adapter;
mod pipeline;
mod shapes;

use super::scene::Scene;
use super::{MOST_KEPT_PX, Pixels, RenderError};
use adapter::Trouble;
pub use adapter::{AdapterChoice, gpu_available};
use pipeline::{Memory, Pipeline};
use shapes::Shapes;
use std::sync::mpsc::sync_channel;
use wgpu::{Buffer, BufferUsages, Device, Extent3d, Queue, Texture, TextureFormat, TextureUsages};

/// Eight bits a channel, blended as they are: the CPU back end does the same.
const FORMAT: TextureFormat = TextureFormat::Rgba8Unorm;

/// Draws scenes on a graphics adapter.
pub struct GpuBackend {
    name: String,
    device: Device,
    queue: Queue,
    trouble: Trouble,
    pipeline: Pipeline,
    target: Option<Target>,
}

/// The picture on the adapter and the memory it is read back through; kept while the size stays.
struct Target {
    texture: Texture,
    readback: Buffer,
    row_bytes: u32,
}

impl GpuBackend {
    /// Opens the best adapter of this kind.
    pub fn open(choice: AdapterChoice) -> Result<Self, RenderError> {
        let adapter = adapter::find(choice)?;
        let info = adapter.get_info();
        let (device, queue, trouble) = adapter::open(&adapter)?;
        let pipeline = Pipeline::new(&device, FORMAT);
        if let Some(error) = trouble.take() {
            return Err(RenderError::Failed(error));
        }
        let name = format!("wgpu: {} ({:?})", info.name, info.backend);
        Ok(Self { name, device, queue, trouble, pipeline, target: None })
    }

    /// Adapter and interface, e.g. `wgpu: NVIDIA T4 (Vulkan)`.
    pub fn name(&self) -> String {
        self.name.clone()
    }

    /// Draws a scene. After [`RenderError::DeviceLost`] only a new back end helps.
    pub fn draw(&mut self, scene: &Scene) -> Result<Pixels, RenderError> {
        let most = self.device.limits().max_texture_dimension_2d;
        for (field, value) in [("width", scene.width), ("height", scene.height)] {
            if !(1..=most).contains(&value) {
                return Err(RenderError::Size { field, value, most });
            }
        }
        let target = self.target(scene.width, scene.height);
        let shapes = Shapes::of(scene);
        let mut encoder = self.device.create_command_encoder(&Default::default());
        let memory = Memory { device: &self.device, queue: &self.queue };
        self.pipeline.draw(memory, &mut encoder, &target.texture, scene, &shapes);
        target.read_back(&mut encoder);
        self.queue.submit([encoder.finish()]);
        let pixels = self.pixels(&target, scene.width, scene.height);
        // A large target is given back; nobody looks at such pictures several times a second.
        let is_large = scene.width * scene.height > MOST_KEPT_PX;
        self.target = Some(target).filter(|_| !is_large && pixels.is_ok());
        pixels
    }

    /// The target of the last picture if it has this size, else a new one.
    fn target(&mut self, width: u32, height: u32) -> Target {
        match self.target.take() {
            Some(target)
                if target.texture.width() == width && target.texture.height() == height =>
            {
                target
            }
            _ => Target::new(&self.device, width, height),
        }
    }

    fn pixels(&self, target: &Target, width: u32, height: u32) -> Result<Pixels, RenderError> {
        let (sender, mapped) = sync_channel(1);
        target.readback.map_async(wgpu::MapMode::Read, .., move |result| {
            // The receiver stands a few lines below; it outlives the mapping.
            let _ = sender.send(result);
        });
        // After a loss polling succeeds and only the mapping fails, so that is what counts.
        let polled = self.device.poll(wgpu::PollType::wait_indefinitely());
        let is_mapped = matches!(mapped.try_recv(), Ok(Ok(())));
        if let Some(error) = self.trouble.take().filter(|_| !self.trouble.is_lost() && is_mapped) {
            target.readback.unmap();
            return Err(RenderError::Failed(error));
        }
        if !is_mapped {
            return Err(RenderError::DeviceLost(format!("reading back failed ({polled:?})")));
        }
        let rgba = target.rows(width, height);
        target.readback.unmap();
        Ok(Pixels { width, height, rgba: rgba? })
    }

    /// Loses the device as a driver reset would.
    #[cfg(test)]
    pub(crate) fn lose(&self) {
        self.device.destroy();
    }
}

impl Target {
    fn new(device: &Device, width: u32, height: u32) -> Self {
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: Some("picture"),
            size: Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: FORMAT,
            usage: TextureUsages::RENDER_ATTACHMENT | TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        // Copies from a texture want rows of a multiple of 256 bytes.
        let row_bytes = (4 * width).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let readback = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("readback"),
            size: u64::from(row_bytes) * u64::from(height),
            usage: BufferUsages::COPY_DST | BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        Self { texture, readback, row_bytes }
    }

    fn read_back(&self, encoder: &mut wgpu::CommandEncoder) {
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(self.row_bytes),
            rows_per_image: None,
        };
        let buffer = wgpu::TexelCopyBufferInfo { buffer: &self.readback, layout };
        encoder.copy_texture_to_buffer(self.texture.as_image_copy(), buffer, self.texture.size());
    }

    fn rows(&self, width: u32, height: u32) -> Result<Vec<u8>, RenderError> {
        let padded = self
            .readback
            .get_mapped_range(..)
            .map_err(|error| RenderError::DeviceLost(error.to_string()))?;
        let row = 4 * width as usize;
        let mut rgba = Vec::with_capacity(row * height as usize);
        for line in padded.chunks_exact(self.row_bytes as usize) {
            rgba.extend_from_slice(&line[..row]);
        }
        Ok(rgba)
    }
}
