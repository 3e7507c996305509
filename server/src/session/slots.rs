//! How many sessions may run at once, and who is next.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, PoisonError};

/// The places on the machine's cores. A clone is the same set of places.
#[derive(Clone)]
pub(super) struct Slots(Arc<Mutex<Places>>);

struct Places {
    free: usize,
    waiting: VecDeque<(String, Deliver)>,
}

/// Hands a permit to whoever waited for it.
type Deliver = Box<dyn FnOnce(Permit) + Send>;

/// The right to run; dropping it lets the next one in.
pub(super) struct Permit(Slots);

impl Slots {
    /// So many places, all free.
    #[must_use]
    pub(super) fn new(places: usize) -> Self {
        Self(Arc::new(Mutex::new(Places { free: places, waiting: VecDeque::new() })))
    }

    /// Takes a place, or remembers `deliver` until it is `session`'s turn.
    pub(super) fn request(
        &self,
        session: &str,
        deliver: impl FnOnce(Permit) + Send + 'static,
    ) -> Option<Permit> {
        let mut places = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if places.free > 0 && places.waiting.is_empty() {
            places.free -= 1;
            return Some(Permit(self.clone()));
        }
        places.waiting.push_back((session.to_owned(), Box::new(deliver)));
        None
    }

    /// Takes a session out of the queue.
    pub(super) fn withdraw(&self, session: &str) {
        let mut places = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        places.waiting.retain(|(waiting, _)| waiting != session);
    }

    fn release(&self) {
        let next = {
            let mut places = self.0.lock().unwrap_or_else(PoisonError::into_inner);
            let next = places.waiting.pop_front();
            if next.is_none() {
                places.free += 1;
            }
            next
        };
        // Delivered after the lock is gone: a receiver that has left drops the permit at once.
        if let Some((_, deliver)) = next {
            deliver(Permit(self.clone()));
        }
    }
}

impl Drop for Permit {
    fn drop(&mut self) {
        self.0.release();
    }
}

#[cfg(test)]
mod tests {
    use std::sync::mpsc;

    use super::*;

    #[test]
    fn places_go_to_those_who_asked_first() {
        let slots = Slots::new(1);
        let (sender, turns) = mpsc::channel();
        let ask = |name: &'static str| {
            let sender = sender.clone();
            slots.request(name, move |permit| drop(sender.send((name, permit))))
        };
        let first = ask("first").expect("a free place");
        assert!(ask("second").is_none());
        assert!(ask("third").is_none());
        assert!(ask("fourth").is_none());
        slots.withdraw("third");

        drop(first);
        let (name, permit) = turns.try_recv().expect("the second's turn");
        assert_eq!(name, "second");
        drop(permit);
        assert_eq!(turns.try_recv().expect("the fourth's turn").0, "fourth");
    }

    #[test]
    fn a_permit_for_one_who_left_goes_to_the_next() {
        let slots = Slots::new(1);
        let held = slots.request("first", drop).expect("a free place");
        assert!(slots.request("left", drop).is_none());
        drop(held);
        assert!(slots.request("later", drop).is_some());
    }
}
