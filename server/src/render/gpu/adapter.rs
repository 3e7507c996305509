//! Finding a graphics adapter and opening a device on it.

use crate::render::RenderError;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use wgpu::{Adapter, AdapterInfo, DeviceType};

/// Which adapters may be used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AdapterChoice {
    /// Only real hardware: adapters simulated on the CPU are slower than the CPU back end.
    Hardware,
    /// Real hardware first, else a simulated adapter.
    Any,
}

/// What to install where no adapter shows up; wgpu's own error never says.
const INSTALL: &str = "install mesa-vulkan-drivers, or libegl1 + libegl-mesa0 + libgl1-mesa-dri, or the maker's driver";

/// Whether the GPU back end can be used here on any adapter, simulated ones included.
pub fn gpu_available() -> bool {
    find(AdapterChoice::Any).is_ok()
}

/// The best adapter of the kind asked for. OpenGL is tried only where Vulkan has none.
pub(super) fn find(choice: AdapterChoice) -> Result<Adapter, RenderError> {
    if choice == AdapterChoice::Hardware && !shows_hardware() {
        return Err(none_fits(&[]));
    }
    let mut found = Vec::new();
    for backends in [wgpu::Backends::VULKAN, wgpu::Backends::GL] {
        let mut adapters = adapters(backends);
        found.extend(adapters.iter().map(|adapter| adapter.get_info().name));
        adapters.retain(|adapter| fits(adapter, choice));
        // Equals keep the order of the driver's loader.
        if let Some(best) = adapters.into_iter().min_by_key(|adapter| rank(&adapter.get_info())) {
            return Ok(best);
        }
    }
    Err(none_fits(&found))
}

/// Whether the kernel shows graphics hardware at all. Where it does not, drivers are better left
/// alone: loading a simulated one costs 100 MB and Mesa writes complaints to standard error.
fn shows_hardware() -> bool {
    let nodes = ["/dev/dri", "/dev/nvidiactl", "/dev/dxg"];
    !cfg!(target_os = "linux") || nodes.iter().any(|node| std::path::Path::new(node).exists())
}

fn adapters(backends: wgpu::Backends) -> Vec<Adapter> {
    let mut description = wgpu::InstanceDescriptor::new_without_display_handle();
    description.backends = backends;
    // Vulkan's validation layers cost time and are not installed on most machines.
    description.flags = wgpu::InstanceFlags::empty();
    pollster::block_on(wgpu::Instance::new(description).enumerate_adapters(backends))
}

fn none_fits(found: &[String]) -> RenderError {
    RenderError::NoAdapter(if found.is_empty() {
        format!("no graphics adapter was found; to use one, {INSTALL}")
    } else {
        let mut names = found.to_vec();
        names.dedup();
        format!(
            "no real graphics adapter was found, only {}; SONARIUM_RENDERER=gpu-any uses it; for a \
             real one, {INSTALL}",
            names.join(", ")
        )
    })
}

fn fits(adapter: &Adapter, choice: AdapterChoice) -> bool {
    // Polygons and glyphs are read from a storage buffer in the fragment stage.
    let can_draw = adapter.limits().max_storage_buffers_per_shader_stage >= 1;
    can_draw && (choice == AdapterChoice::Any || is_hardware(&adapter.get_info()))
}

fn is_hardware(info: &AdapterInfo) -> bool {
    info.device_type != DeviceType::Cpu && !is_simulated(&info.name)
}

/// OpenGL does not say that an adapter is simulated; its name does.
fn is_simulated(name: &str) -> bool {
    let name = name.to_lowercase();
    ["llvmpipe", "softpipe", "swiftshader", "lavapipe", "swrast"].iter().any(|s| name.contains(s))
}

fn rank(info: &AdapterInfo) -> u8 {
    match info.device_type {
        _ if !is_hardware(info) => 4,
        DeviceType::DiscreteGpu => 0,
        DeviceType::IntegratedGpu => 1,
        DeviceType::VirtualGpu => 2,
        DeviceType::Other | DeviceType::Cpu => 3,
    }
}

/// What went wrong with a device since it was opened; its callbacks write, drawing reads.
#[derive(Clone, Debug, Default)]
pub(super) struct Trouble {
    lost: Arc<AtomicBool>,
    last: Arc<Mutex<Option<String>>>,
}

impl Trouble {
    fn note(&self, text: String) {
        *self.last.lock().unwrap_or_else(PoisonError::into_inner) = Some(text);
    }

    /// Whether the device is gone for good.
    pub(super) fn is_lost(&self) -> bool {
        self.lost.load(Ordering::Acquire)
    }

    /// The last error that nobody asked about, once.
    pub(super) fn take(&self) -> Option<String> {
        self.last.lock().unwrap_or_else(PoisonError::into_inner).take()
    }
}

/// Opens a device with the adapter's own limits: the defaults stop at 8192 px and 256 MiB.
pub(super) fn open(adapter: &Adapter) -> Result<(wgpu::Device, wgpu::Queue, Trouble), RenderError> {
    let description = wgpu::DeviceDescriptor {
        label: Some("arena"),
        required_limits: adapter.limits(),
        memory_hints: wgpu::MemoryHints::MemoryUsage,
        ..Default::default()
    };
    let (device, queue) = pollster::block_on(adapter.request_device(&description))
        .map_err(|error| RenderError::Failed(error.to_string()))?;
    let trouble = Trouble::default();
    // Without a handler wgpu panics on any error that no scope catches.
    let noted = trouble.clone();
    device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| noted.note(error.to_string())));
    let noted = trouble.clone();
    device.set_device_lost_callback(move |reason, message| {
        noted.lost.store(true, Ordering::Release);
        noted.note(format!("{reason:?}: {message}"));
    });
    Ok((device, queue, trouble))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn simulated_adapters_are_told_by_their_names() {
        for (name, simulated) in [
            ("llvmpipe (LLVM 15.0.6, 256 bits)", true),
            ("SwiftShader Device (Subzero)", true),
            ("softpipe", true),
            ("NVIDIA T4", false),
            ("Mesa Intel(R) UHD Graphics 620", false),
        ] {
            assert_eq!(is_simulated(name), simulated, "{name}");
        }
    }

    #[test]
    fn a_missing_adapter_names_what_to_install() {
        for found in [vec![], vec!["llvmpipe".to_owned()]] {
            let text = none_fits(&found).to_string();
            assert!(text.contains("mesa-vulkan-drivers") && text.contains("libegl1"), "{text}");
            assert!(found.iter().all(|name| text.contains(name)), "{text}");
        }
    }
}
