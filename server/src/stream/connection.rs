//! One viewer, from `hello` to its last message.

use std::sync::Arc;
use std::time::Duration;

use axum::body::Bytes;
use axum::extract::ws::{CloseFrame, Message, WebSocket, close_code};
use tokio::sync::watch;
use tokio::time::{Instant, interval_at, sleep_until, timeout};

use super::frames::{Channel, Frame, Frames};
use super::subscription::Subscription;
use crate::session::{
    DrivePresent, Feed, Missed, PathPresent, Present, Scenery, TablePresent, Viewer, text,
};
use crate::wire::{ArenaRequest, ServerMessage};

/// A client that takes longer to accept one message is let go.
const PATIENCE: Duration = Duration::from_secs(10);
/// Time between two pings.
const PING_EVERY: Duration = Duration::from_secs(20);
/// Cycles in one message.
const MOST_CYCLES: usize = 50;

/// Why a connection ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Goodbye {
    /// The client left.
    #[error("the client left")]
    Left,
    /// The client did not take a message in time.
    #[error("the client did not take a message within {} seconds", PATIENCE.as_secs())]
    TooSlow,
    /// The client sent too long a message, or broke the protocol.
    #[error("a message must be text of at most 64 kB")]
    Unacceptable,
}

/// Serves a viewer until it leaves. `since` is the last event it has seen, if it was here before.
pub async fn serve(
    socket: WebSocket,
    feed: Arc<Feed>,
    scenery: Option<Arc<Scenery>>,
    frames: Frames,
    since: Option<u64>,
) -> Goodbye {
    let mut connection = Connection::new(socket, feed, scenery, frames);
    let goodbye = match connection.greet(since).await {
        Ok(()) => connection.converse().await,
        Err(goodbye) => goodbye,
    };
    connection.close(goodbye).await;
    goodbye
}

struct Connection {
    socket: WebSocket,
    feed: Arc<Feed>,
    /// What pictures are drawn of; none in a tabular experiment.
    scenery: Option<Arc<Scenery>>,
    frames: Frames,
    subscription: Subscription,
    /// Number of the last event sent.
    seen: u64,
    tick: Schedule,
    depths: Schedule,
    neurons: Schedule,
    step: Schedule,
    table: Schedule,
    cycles: Schedule,
    arena: Option<Arena>,
    _viewer: Viewer,
}

/// When a sample may be sent next, and of what the last one was.
struct Schedule {
    due: Instant,
    /// Tick of the sample sent last.
    sent: Option<u64>,
}

/// A subscription to pictures.
struct Arena {
    channel: Arc<Channel>,
    latest: watch::Receiver<Frame>,
    rate_hz: f64,
    due: Instant,
    /// Version of the picture sent last.
    sent: u64,
}

impl Connection {
    fn new(
        socket: WebSocket,
        feed: Arc<Feed>,
        scenery: Option<Arc<Scenery>>,
        frames: Frames,
    ) -> Self {
        Self {
            _viewer: feed.watch(),
            socket,
            feed,
            scenery,
            frames,
            subscription: Subscription::default(),
            seen: 0,
            tick: Schedule::new(),
            depths: Schedule::new(),
            neurons: Schedule::new(),
            step: Schedule::new(),
            table: Schedule::new(),
            cycles: Schedule::new(),
            arena: None,
        }
    }

    async fn greet(&mut self, since: Option<u64>) -> Result<(), Goodbye> {
        match since {
            Some(since) => {
                self.seen = since;
                self.send_events().await
            }
            None => self.send_hello().await,
        }
    }

    async fn converse(&mut self) -> Goodbye {
        let mut changes = self.feed.subscribe();
        changes.mark_changed();
        let mut ping = interval_at(Instant::now() + PING_EVERY, PING_EVERY);
        loop {
            let due = self.next_due();
            let result = tokio::select! {
                message = self.socket.recv() => self.hear(message).await,
                _ = changes.changed() => self.send_events().await,
                () = sleep_until(due.unwrap_or_else(Instant::now)), if due.is_some() => Ok(()),
                () = new_picture(&mut self.arena) => Ok(()),
                _ = ping.tick() => self.send(Message::Ping(Bytes::new())).await,
            };
            let result = match result {
                Ok(()) => self.send_what_is_due().await,
                error => error,
            };
            if let Err(goodbye) = result {
                return goodbye;
            }
        }
    }

    async fn hear(&mut self, message: Option<Result<Message, axum::Error>>) -> Result<(), Goodbye> {
        match message {
            None | Some(Ok(Message::Close(_))) => Err(Goodbye::Left),
            Some(Ok(Message::Text(message))) => match self.subscription.apply(&message) {
                Ok(()) => {
                    self.subscribe_pictures();
                    Ok(())
                }
                Err(error) => {
                    let field = Some(error.field).filter(|field| !field.is_empty());
                    self.say(&ServerMessage::Error { message: error.message, field }).await
                }
            },
            Some(Ok(Message::Binary(_))) => Err(Goodbye::Unacceptable),
            Some(Ok(Message::Ping(_) | Message::Pong(_))) => Ok(()),
            Some(Err(error)) if is_too_long(&error) => Err(Goodbye::Unacceptable),
            Some(Err(_)) => Err(Goodbye::Left),
        }
    }

    fn subscribe_pictures(&mut self) {
        let wish = self.subscription.arena.as_ref().filter(|wish| wish.rate > 0.0);
        let sent = self.arena.as_ref().map_or(0, |arena| arena.sent);
        self.arena = wish
            .zip(self.scenery.as_ref())
            .map(|(wish, scenery)| Arena::new(&self.frames, &self.feed, scenery, wish));
        // The same picture is not sent twice, only because a rate was changed.
        if let Some(arena) = &mut self.arena
            && arena.latest.borrow().version == sent
        {
            arena.sent = sent;
        }
    }

    async fn send_events(&mut self) -> Result<(), Goodbye> {
        match self.feed.after(self.seen) {
            Missed::Events(events) => {
                for event in events {
                    self.seen = event.seq;
                    self.send(Message::Text(event.text)).await?;
                }
                Ok(())
            }
            Missed::Gap { oldest } => {
                self.say(&ServerMessage::Gap { since: self.seen, oldest }).await?;
                self.send_hello().await
            }
        }
    }

    async fn send_hello(&mut self) -> Result<(), Goodbye> {
        let hello = self.feed.hello();
        self.seen = hello.seq;
        // What `hello` holds is not sent again.
        self.cycles.sent = hello.cycles.last().map(|cycle| cycle.tick);
        self.say(&ServerMessage::Hello(Box::new(hello))).await
    }

    /// When something subscribed may be sent next, if there is something new.
    fn next_due(&self) -> Option<Instant> {
        let snapshot = self.feed.snapshot();
        let tick = snapshot.present.step();
        let wishes = &self.subscription;
        let of_path = [
            (&self.tick, wishes.tick, tick),
            (&self.depths, wishes.depths, tick),
            (&self.neurons, wishes.neurons, tick),
        ];
        let revision = snapshot.present.table().map(|table| table.revision);
        let of_table = [(&self.step, wishes.step, tick), (&self.table, wishes.table, revision)];
        let of_drive = [(&self.cycles, wishes.cycles, tick)];
        let samples = match &snapshot.present {
            Present::Path(_) => &of_path[..],
            Present::Table(_) => &of_table[..],
            Present::Drive(_) => &of_drive[..],
        };
        let samples =
            samples.iter().filter(|(schedule, rate_hz, of)| schedule.wants(*of, *rate_hz));
        let samples = samples.map(|(schedule, ..)| schedule.due);
        let arena = self.arena.as_ref().and_then(|arena| arena.next_due(self.feed.version()));
        samples.chain(arena).min()
    }

    async fn send_what_is_due(&mut self) -> Result<(), Goodbye> {
        let now = Instant::now();
        let snapshot = self.feed.snapshot();
        let (seq, wishes) = (self.seen, self.subscription.clone());
        let messages = match (&snapshot.present, snapshot.present.step()) {
            (Present::Table(table), tick) => {
                self.table_samples((seq, tick.unwrap_or(0)), table, &wishes, now)
            }
            (_, None) => Vec::new(),
            (Present::Path(path), Some(tick)) => self.path_samples((seq, tick), path, &wishes, now),
            (Present::Drive(drive), Some(tick)) => {
                self.drive_samples((seq, tick), drive, &wishes, now)
            }
        };
        for message in &messages {
            self.say(message).await?;
        }
        match self.arena.as_mut().and_then(|arena| arena.take(self.feed.version(), now)) {
            Some(png) => self.send(Message::Binary(png)).await,
            None => Ok(()),
        }
    }

    fn path_samples(
        &mut self,
        (seq, number): (u64, u64),
        path: &PathPresent,
        wishes: &Subscription,
        now: Instant,
    ) -> Vec<ServerMessage> {
        let mut messages = Vec::new();
        if let Some(tick) = path.tick.as_deref() {
            if self.tick.take(number, wishes.tick, now) {
                messages.push(ServerMessage::Tick { seq, tick: Box::new(tick.clone()) });
            }
            if self.depths.take(number, wishes.depths, now) {
                let sonar_m = tick.sonar_m.clone();
                messages.push(ServerMessage::Depths { seq, tick: number, sonar_m });
            }
        }
        if self.neurons.take(number, wishes.neurons, now) {
            let neurons = path.neurons.to_vec();
            messages.push(ServerMessage::Neurons { seq, tick: number, neurons });
        }
        messages
    }

    fn table_samples(
        &mut self,
        (seq, number): (u64, u64),
        present: &TablePresent,
        wishes: &Subscription,
        now: Instant,
    ) -> Vec<ServerMessage> {
        let mut messages = Vec::new();
        if let Some(step) = present.step.as_deref()
            && self.step.take(number, wishes.step, now)
        {
            messages.push(ServerMessage::Step { seq, step: step.clone() });
        }
        if let Some(table) = present.table.as_deref()
            && self.table.take(present.revision, wishes.table, now)
        {
            messages.push(ServerMessage::Table { seq, tick: number, table: table.clone() });
        }
        messages
    }

    fn drive_samples(
        &mut self,
        (seq, number): (u64, u64),
        present: &DrivePresent,
        wishes: &Subscription,
        now: Instant,
    ) -> Vec<ServerMessage> {
        let sent = self.cycles.sent.unwrap_or(0);
        if !self.cycles.take(number, wishes.cycles, now) {
            return Vec::new();
        }
        let newest = present.cycles.len().saturating_sub(MOST_CYCLES);
        // After a reset, ticks begin anew.
        let fresh = |tick: u64| tick > sent || number < sent;
        let cycles = present.cycles.iter().skip(newest).filter(|cycle| fresh(cycle.tick));
        let cycles = cycles.map(|cycle| (**cycle).clone()).collect();
        vec![ServerMessage::Cycles { seq, cycles }]
    }

    async fn say(&mut self, message: &ServerMessage) -> Result<(), Goodbye> {
        self.send(Message::Text(text(message))).await
    }

    async fn send(&mut self, message: Message) -> Result<(), Goodbye> {
        match timeout(PATIENCE, self.socket.send(message)).await {
            Ok(Ok(())) => Ok(()),
            Ok(Err(_)) => Err(Goodbye::Left),
            Err(_) => Err(Goodbye::TooSlow),
        }
    }

    async fn close(mut self, goodbye: Goodbye) {
        let code = match goodbye {
            Goodbye::Left => return,
            Goodbye::TooSlow => close_code::POLICY,
            Goodbye::Unacceptable => close_code::SIZE,
        };
        let frame = CloseFrame { code, reason: goodbye.to_string().into() };
        // A client that takes nothing does not take this either.
        let _ =
            timeout(Duration::from_secs(1), self.socket.send(Message::Close(Some(frame)))).await;
    }
}

impl Schedule {
    fn new() -> Self {
        Self { due: Instant::now(), sent: None }
    }

    fn wants(&self, tick: Option<u64>, rate_hz: f64) -> bool {
        rate_hz > 0.0 && tick.is_some() && tick != self.sent
    }

    /// Whether a sample of this tick is to be sent now.
    fn take(&mut self, tick: u64, rate_hz: f64, now: Instant) -> bool {
        let due = self.wants(Some(tick), rate_hz) && now >= self.due;
        if due {
            self.sent = Some(tick);
            self.due = after(self.due, rate_hz, now);
        }
        due
    }
}

impl Arena {
    fn new(frames: &Frames, feed: &Arc<Feed>, scenery: &Arc<Scenery>, wish: &ArenaRequest) -> Self {
        let channel = frames.channel(feed, scenery, wish);
        let latest = channel.subscribe();
        Self { channel, latest, rate_hz: wish.rate, due: Instant::now(), sent: 0 }
    }

    fn next_due(&self, version: u64) -> Option<Instant> {
        let drawn = self.latest.borrow().version;
        // While the picture is being drawn, its arrival wakes the connection.
        (drawn > self.sent || (version > self.sent && !self.channel.is_drawing()))
            .then_some(self.due)
    }

    /// The picture to send now; asks for one when there is none newer than the last.
    fn take(&mut self, version: u64, now: Instant) -> Option<Bytes> {
        if now < self.due {
            return None;
        }
        let frame = self.latest.borrow_and_update().clone();
        if frame.version > self.sent {
            self.sent = frame.version;
            self.due = after(self.due, self.rate_hz, now);
            return Some(frame.png);
        }
        if version > self.sent {
            self.channel.ask();
        }
        None
    }
}

/// Waits for the next picture; for ever without a subscription.
async fn new_picture(arena: &mut Option<Arena>) {
    match arena {
        // The sender lives as long as the channel, which this subscription holds.
        Some(arena) => drop(arena.latest.changed().await),
        None => std::future::pending().await,
    }
}

/// The next time on a schedule; what was missed is not made up for.
fn after(due: Instant, rate_hz: f64, now: Instant) -> Instant {
    let period = Duration::from_secs_f64(1.0 / rate_hz);
    if now < due + period { due + period } else { now + period }
}

/// Whether reading failed because of the limit on a message's length.
fn is_too_long(error: &axum::Error) -> bool {
    error.to_string().to_lowercase().contains("too long")
}
