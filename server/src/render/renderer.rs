//! One thread that owns the back end; everybody else holds a cheap handle and asks for pictures.

use super::cpu::CpuBackend;
use super::gpu::{AdapterChoice, GpuBackend};
use super::png::{self, Quality};
use super::scene::Scene;
use super::view::ArenaView;
use super::{Backend, LARGEST_PX, Picture, Pixels, RenderError, arena};
use crate::wire::ThemeName;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, SyncSender, TrySendError, sync_channel};
use std::sync::{Arc, PoisonError, RwLock};
use tokio::sync::oneshot;

/// A handle to the drawing thread, cheap to clone. The thread ends with the last handle.
#[derive(Clone, Debug)]
pub struct Renderer {
    requests: SyncSender<Request>,
    backend_name: Arc<RwLock<String>>,
}

/// So many pictures may wait; asking for more is refused, so that slow drawing cannot eat memory.
const WAITING: usize = 64;

impl Renderer {
    /// Starts the thread and waits until its back end is ready.
    pub fn start(choice: Backend) -> Self {
        let (requests, inbox) = sync_channel(WAITING);
        let backend_name = Arc::new(RwLock::new(String::from("none")));
        let (ready, started) = sync_channel(1);
        let name = Arc::clone(&backend_name);
        let work = move || {
            let mut painter = Painter::open(choice, name);
            // The starter may have given up; drawing goes on regardless.
            let _ = ready.send(());
            painter.serve(&inbox);
        };
        match std::thread::Builder::new().name("renderer".into()).spawn(work) {
            Ok(_) => drop(started.recv()),
            Err(error) => tracing::error!(%error, "the drawing thread could not be started"),
        }
        Self { requests, backend_name }
    }

    /// The back end at work, e.g. `vello_cpu` or `wgpu: NVIDIA T4 (Vulkan)`.
    pub fn backend_name(&self) -> String {
        self.backend_name.read().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Draws an arena as a PNG file of this size.
    pub async fn picture(
        &self,
        view: ArenaView,
        width: u32,
        height: u32,
        theme: ThemeName,
        quality: Quality,
    ) -> Result<Picture, RenderError> {
        let (reply, answer) = oneshot::channel();
        let order = Order { view, width, height, theme, quality };
        self.ask(order, Reply::Async(reply))?;
        answer.await.map_err(|_| RenderError::Lost)?
    }

    /// Like [`Renderer::picture`], for threads that may wait.
    pub fn picture_blocking(
        &self,
        view: ArenaView,
        width: u32,
        height: u32,
        theme: ThemeName,
        quality: Quality,
    ) -> Result<Picture, RenderError> {
        let (reply, answer) = sync_channel(1);
        let order = Order { view, width, height, theme, quality };
        self.ask(order, Reply::Blocking(reply))?;
        answer.recv().map_err(|_| RenderError::Lost)?
    }

    fn ask(&self, order: Order, reply: Reply) -> Result<(), RenderError> {
        check_size("width", order.width)?;
        check_size("height", order.height)?;
        let request = Request { order: Box::new(order), reply };
        self.requests.try_send(request).map_err(|error| match error {
            TrySendError::Full(_) => RenderError::Busy { waiting: WAITING },
            TrySendError::Disconnected(_) => RenderError::Lost,
        })
    }
}

fn check_size(field: &'static str, value: u32) -> Result<(), RenderError> {
    if (1..=LARGEST_PX).contains(&value) {
        return Ok(());
    }
    Err(RenderError::Size { field, value, most: LARGEST_PX })
}

#[derive(Debug)]
struct Order {
    view: ArenaView,
    width: u32,
    height: u32,
    theme: ThemeName,
    quality: Quality,
}

#[derive(Debug)]
struct Request {
    order: Box<Order>,
    reply: Reply,
}

#[derive(Debug)]
enum Reply {
    Async(oneshot::Sender<Result<Picture, RenderError>>),
    Blocking(SyncSender<Result<Picture, RenderError>>),
}

impl Reply {
    fn is_awaited(&self) -> bool {
        !matches!(self, Self::Async(reply) if reply.is_closed())
    }

    fn send(self, result: Result<Picture, RenderError>) {
        // Whoever asked may have left; then nobody misses the answer.
        match self {
            Self::Async(reply) => drop(reply.send(result)),
            Self::Blocking(reply) => drop(reply.send(result)),
        }
    }
}

/// The back end and what it takes to replace it.
struct Painter {
    choice: Backend,
    surface: Surface,
    name: Arc<RwLock<String>>,
}

enum Surface {
    Cpu(Box<CpuBackend>),
    Gpu(Box<GpuBackend>),
}

impl Painter {
    fn open(choice: Backend, name: Arc<RwLock<String>>) -> Self {
        let surface = Surface::open(choice);
        let painter = Self { choice, surface, name };
        painter.announce();
        painter
    }

    fn announce(&self) {
        let name = match &self.surface {
            Surface::Cpu(_) => "vello_cpu".to_owned(),
            Surface::Gpu(gpu) => gpu.name(),
        };
        *self.name.write().unwrap_or_else(PoisonError::into_inner) = name;
    }

    fn serve(&mut self, inbox: &Receiver<Request>) {
        while let Ok(Request { order, reply }) = inbox.recv() {
            if reply.is_awaited() {
                reply.send(self.fill(&order));
            }
        }
    }

    fn fill(&mut self, order: &Order) -> Result<Picture, RenderError> {
        let drawn = catch_unwind(AssertUnwindSafe(|| self.draw(order)));
        drawn.unwrap_or_else(|_| {
            self.replace(Backend::Cpu);
            Err(RenderError::Failed("the back end panicked; it has been replaced".into()))
        })
    }

    fn draw(&mut self, order: &Order) -> Result<Picture, RenderError> {
        let scene = arena::scene(&order.view, order.width, order.height, order.theme);
        let pixels = match self.surface.draw(&scene) {
            Err(RenderError::DeviceLost(why)) => {
                tracing::warn!(why, "the graphics device was lost; opening it anew");
                self.replace(self.choice);
                self.surface.draw(&scene).or_else(|_| {
                    self.replace(Backend::Cpu);
                    self.surface.draw(&scene)
                })?
            }
            result => result?,
        };
        Ok(Picture::from(png::encode(&pixels, order.quality)?))
    }

    fn replace(&mut self, choice: Backend) {
        self.surface = Surface::open(choice);
        self.announce();
    }
}

impl Surface {
    /// Opens what was asked for, or the CPU back end with a line in the log that says why.
    fn open(choice: Backend) -> Self {
        let adapters = match choice {
            Backend::Cpu => return Self::Cpu(Box::default()),
            Backend::Auto | Backend::Gpu => AdapterChoice::Hardware,
            Backend::GpuAny => AdapterChoice::Any,
        };
        match catch_unwind(|| GpuBackend::open(adapters)) {
            Ok(Ok(gpu)) => return Self::Gpu(Box::new(gpu)),
            Ok(Err(error)) if choice == Backend::Auto => {
                tracing::info!(%error, "pictures are drawn on the CPU");
            }
            Ok(Err(error)) => tracing::warn!(%error, "pictures are drawn on the CPU"),
            Err(_) => tracing::warn!("the graphics driver panicked; pictures are drawn on the CPU"),
        }
        Self::Cpu(Box::default())
    }

    fn draw(&mut self, scene: &Scene) -> Result<Pixels, RenderError> {
        match self {
            Self::Cpu(cpu) => cpu.draw(scene),
            Self::Gpu(gpu) => gpu.draw(scene),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_survives_the_loss_of_the_device() {
        let mut painter = Painter::open(Backend::GpuAny, Arc::default());
        let Surface::Gpu(gpu) = &painter.surface else {
            eprintln!("a_picture_survives_the_loss_of_the_device: NO ADAPTER, nothing was tried");
            return;
        };
        gpu.lose();
        let (view, theme, quality) = (ArenaView::default(), ThemeName::Dark, Quality::Fast);
        let order = Order { view, width: 64, height: 48, theme, quality };
        assert!(painter.fill(&order).is_ok());
        assert!(matches!(painter.surface, Surface::Gpu(_)), "the device was opened anew");
    }

    #[tokio::test]
    async fn a_lost_thread_is_an_error() {
        let (requests, inbox) = sync_channel(1);
        let renderer = Renderer { requests, backend_name: Arc::default() };
        drop(inbox);
        let (view, theme, quality) = (ArenaView::default(), ThemeName::Light, Quality::Fast);
        let picture = renderer.picture(view, 9, 9, theme, quality).await;
        assert!(matches!(picture, Err(RenderError::Lost)), "{picture:?}");
    }

    #[test]
    fn a_full_inbox_refuses_more() {
        let (requests, _inbox) = sync_channel(0);
        let renderer = Renderer { requests, backend_name: Arc::default() };
        let (view, theme, quality) = (ArenaView::default(), ThemeName::Light, Quality::Fast);
        let picture = renderer.picture_blocking(view, 9, 9, theme, quality);
        assert!(matches!(picture, Err(RenderError::Busy { .. })), "{picture:?}");
    }
}
