//! The render pipeline around `arena.wgsl`.

use super::shapes::{Shape, Shapes};
use crate::render::scene::Scene;
use wgpu::{
    BindGroup, BindGroupLayout, Buffer, BufferUsages, Device, Queue, TextureFormat, VertexFormat,
};

/// The shader; its doc comments say how coverage is computed.
const SHADER: &str = include_str!("../../../../assets/shaders/arena.wgsl");

/// The one pipeline every picture goes through.
pub(super) struct Pipeline {
    pipeline: wgpu::RenderPipeline,
    bindings: BindGroupLayout,
}

impl Pipeline {
    pub(super) fn new(device: &Device, format: TextureFormat) -> Self {
        let bindings = bindings(device);
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("arena"),
            bind_group_layouts: &[Some(&bindings)],
            immediate_size: 0,
        });
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("arena.wgsl"),
            source: wgpu::ShaderSource::Wgsl(SHADER.into()),
        });
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("arena"),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("vertex"),
                compilation_options: Default::default(),
                buffers: &[Some(instances())],
            },
            primitive: wgpu::PrimitiveState {
                topology: wgpu::PrimitiveTopology::TriangleStrip,
                ..Default::default()
            },
            depth_stencil: None,
            multisample: Default::default(),
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some("fragment"),
                compilation_options: Default::default(),
                targets: &[Some(wgpu::ColorTargetState {
                    format,
                    blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
                    write_mask: wgpu::ColorWrites::ALL,
                })],
            }),
            multiview_mask: None,
            cache: None,
        });
        Self { pipeline, bindings }
    }

    /// Records the drawing of a scene into a texture.
    pub(super) fn draw(
        &self,
        memory: Memory<'_>,
        encoder: &mut wgpu::CommandEncoder,
        texture: &wgpu::Texture,
        scene: &Scene,
        shapes: &Shapes,
    ) {
        let view = texture.create_view(&Default::default());
        let group = self.group(memory, scene, shapes);
        let instances = memory.filled("shapes", &shapes.instances, BufferUsages::VERTEX);
        let [red, green, blue, _] = scene.background.0.map(|channel| f64::from(channel) / 255.0);
        let ground = wgpu::Color { r: red, g: green, b: blue, a: 1.0 };
        let ops =
            wgpu::Operations { load: wgpu::LoadOp::Clear(ground), store: wgpu::StoreOp::Store };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("arena"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &view,
                depth_slice: None,
                resolve_target: None,
                ops,
            })],
            ..Default::default()
        });
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.set_vertex_buffer(0, instances.slice(..));
        pass.draw(0..4, 0..shapes.instances.len() as u32);
    }

    fn group(&self, memory: Memory<'_>, scene: &Scene, shapes: &Shapes) -> BindGroup {
        let size = [scene.width as f32, scene.height as f32, 0.0, 0.0];
        let sheet = memory.filled("sheet", &[size], BufferUsages::UNIFORM);
        let edges = memory.filled("edges", &shapes.edges, BufferUsages::STORAGE);
        memory.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("arena"),
            layout: &self.bindings,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: sheet.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 1, resource: edges.as_entire_binding() },
            ],
        })
    }
}

/// Where buffers come from and how they are filled.
#[derive(Clone, Copy)]
pub(super) struct Memory<'a> {
    pub(super) device: &'a Device,
    pub(super) queue: &'a Queue,
}

impl Memory<'_> {
    /// A buffer with this content; an empty one gets a single unused element, since a binding must
    /// hold at least one. Mapping it at creation would panic once the device is lost.
    fn filled<T: bytemuck::Pod>(self, label: &str, content: &[T], usage: BufferUsages) -> Buffer {
        let spare = [T::zeroed()];
        let content = if content.is_empty() { &spare } else { content };
        let buffer = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(label),
            size: size_of_val(content) as u64,
            usage: usage | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        self.queue.write_buffer(&buffer, 0, bytemuck::cast_slice(content));
        buffer
    }
}

fn bindings(device: &Device) -> BindGroupLayout {
    let entry = |binding, visibility, ty| wgpu::BindGroupLayoutEntry {
        binding,
        visibility,
        ty: wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None },
        count: None,
    };
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("arena"),
        entries: &[
            entry(0, wgpu::ShaderStages::VERTEX, wgpu::BufferBindingType::Uniform),
            entry(
                1,
                wgpu::ShaderStages::FRAGMENT,
                wgpu::BufferBindingType::Storage { read_only: true },
            ),
        ],
    })
}

/// The layout of [`Shape`], one a shape.
fn instances() -> wgpu::VertexBufferLayout<'static> {
    const ATTRIBUTES: [wgpu::VertexAttribute; 5] = wgpu::vertex_attr_array![
        0 => Float32x4, 1 => Float32x4, 2 => Float32x4, 3 => Float32, 4 => Uint32x3
    ];
    const { assert!(size_of::<Shape>() as u64 == 3 * VertexFormat::Float32x4.size() + 16) };
    wgpu::VertexBufferLayout {
        array_stride: size_of::<Shape>() as u64,
        step_mode: wgpu::VertexStepMode::Instance,
        attributes: &ATTRIBUTES,
    }
}
