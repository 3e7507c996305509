//! Arena pictures of live sessions: drawn and encoded once, for everybody who wants the same.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError, Weak};

use tokio::sync::watch;

use crate::render::{Picture, Quality, Renderer};
use crate::session::{Feed, Scenery};
use crate::wire::{ArenaRequest, ThemeName};

/// All pictures in the making. A clone is the same.
#[derive(Clone)]
pub struct Frames(Arc<Inner>);

struct Inner {
    renderer: Renderer,
    channels: Mutex<BTreeMap<Key, Weak<Channel>>>,
    drawn: AtomicU64,
}

/// What makes two pictures the same: session, width, height, theme.
type Key = (String, u32, u32, ThemeName);

/// A picture of the present.
#[derive(Clone, Debug, Default)]
pub(super) struct Frame {
    /// The feed's version that it shows; 0 before the first picture.
    pub(super) version: u64,
    /// A whole PNG file.
    pub(super) png: Picture,
}

/// One kind of picture of one session. It draws when asked and never by itself, so nothing is drawn
/// when nobody watches.
pub(super) struct Channel {
    key: Key,
    frames: Frames,
    feed: Arc<Feed>,
    scenery: Arc<Scenery>,
    latest: watch::Sender<Frame>,
    drawing: AtomicBool,
}

impl Frames {
    /// No pictures yet.
    #[must_use]
    pub fn new(renderer: Renderer) -> Self {
        let (channels, drawn) = (Mutex::default(), AtomicU64::new(0));
        Self(Arc::new(Inner { renderer, channels, drawn }))
    }

    /// What draws.
    #[must_use]
    pub fn renderer(&self) -> &Renderer {
        &self.0.renderer
    }

    /// Pictures drawn for viewers since the server started.
    #[must_use]
    pub fn drawn(&self) -> u64 {
        self.0.drawn.load(Ordering::Relaxed)
    }

    /// The channel that everybody with the same wish shares.
    pub(super) fn channel(
        &self,
        feed: &Arc<Feed>,
        scenery: &Arc<Scenery>,
        wish: &ArenaRequest,
    ) -> Arc<Channel> {
        let id = feed.snapshot().session.id.clone();
        let key = (id, wish.width, wish.height, wish.theme);
        let mut channels = self.0.channels.lock().unwrap_or_else(PoisonError::into_inner);
        channels.retain(|_, channel| channel.strong_count() > 0);
        if let Some(channel) = channels.get(&key).and_then(Weak::upgrade) {
            return channel;
        }
        let channel = Arc::new(Channel {
            key: key.clone(),
            frames: self.clone(),
            feed: feed.clone(),
            scenery: scenery.clone(),
            latest: watch::Sender::default(),
            drawing: AtomicBool::new(false),
        });
        channels.insert(key, Arc::downgrade(&channel));
        channel
    }
}

impl Channel {
    pub(super) fn subscribe(&self) -> watch::Receiver<Frame> {
        self.latest.subscribe()
    }

    pub(super) fn is_drawing(&self) -> bool {
        self.drawing.load(Ordering::Acquire)
    }

    /// Draws the present, unless that is under way.
    pub(super) fn ask(self: &Arc<Self>) {
        if self.drawing.swap(true, Ordering::AcqRel) {
            return;
        }
        let channel = self.clone();
        tokio::spawn(async move {
            let frame = channel.draw().await;
            // Free before anybody is woken, so that whoever wants a still newer one can ask at once.
            channel.drawing.store(false, Ordering::Release);
            if let Some(frame) = frame {
                channel.latest.send_replace(frame);
            }
        });
    }

    async fn draw(&self) -> Option<Frame> {
        let (_, width, height, theme) = self.key;
        let version = self.feed.version();
        let view = self.scenery.live(&self.feed.snapshot(), &self.feed.yardstick());
        let renderer = self.frames.renderer();
        match renderer.picture(view, width, height, theme, Quality::Fast).await {
            Ok(png) => {
                self.frames.0.drawn.fetch_add(1, Ordering::Relaxed);
                Some(Frame { version, png })
            }
            Err(error) => {
                tracing::warn!("no picture of session {}: {error}", self.key.0);
                None
            }
        }
    }
}
