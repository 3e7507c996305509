//! The results of a process: each target computed once, for all who ask, with its progress to be seen.

use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, LazyLock, Mutex, PoisonError};
use std::thread;

use tokio::sync::{OnceCell, oneshot};

use super::{Findings, Kept, ReproductionError, TARGETS, Target};
use crate::wire::{ReproductionProgress, ReproductionState};

/// The findings of every target that was asked for. They follow from the build alone, so one
/// computation serves the whole process.
#[derive(Debug)]
pub struct Shelf {
    places: Vec<Place>,
    kept: Kept,
    /// Held by the target under way: one at a time, so that the next finds the sets of the last.
    turn: tokio::sync::Mutex<()>,
}

/// The place of one target.
#[derive(Debug)]
struct Place {
    target: &'static Target,
    findings: OnceCell<Arc<Findings>>,
    standing: Mutex<(ReproductionState, Option<String>)>,
    done: AtomicU32,
}

static SHELF: LazyLock<Shelf> = LazyLock::new(|| Shelf::new(TARGETS));

impl Shelf {
    /// The shelf of this process.
    #[must_use]
    pub fn of_process() -> &'static Self {
        &SHELF
    }

    fn new(targets: &[&'static Target]) -> Self {
        let place = |&target: &&'static Target| Place {
            target,
            findings: OnceCell::new(),
            standing: Mutex::default(),
            done: AtomicU32::new(0),
        };
        let places = targets.iter().map(place).collect();
        Self { places, kept: Kept::default(), turn: tokio::sync::Mutex::default() }
    }

    /// What was found for a target; computed now, on `threads` threads, if nobody asked before. Goes on
    /// when the one who asked leaves.
    ///
    /// # Errors
    /// When it could not be computed; the next who asks tries again.
    pub async fn findings(
        &'static self,
        target: &'static Target,
        threads: usize,
    ) -> Result<Arc<Findings>, ReproductionError> {
        let place = self.place(target)?;
        let found = tokio::spawn(async move {
            place.findings.get_or_try_init(|| self.compute(place, threads)).await.cloned()
        });
        found.await.map_err(|error| ReproductionError::Broken(error.to_string()))?
    }

    /// How far a target is.
    ///
    /// # Errors
    /// When the shelf has no place for it.
    pub fn progress(&self, target: &Target) -> Result<ReproductionProgress, ReproductionError> {
        let place = self.place(target)?;
        let (state, reason) = place.standing().clone();
        Ok(ReproductionProgress {
            target: target.name.into(),
            state,
            done: place.done.load(Ordering::Relaxed),
            of: target.work(),
            reason,
        })
    }

    async fn compute(
        &'static self,
        place: &'static Place,
        threads: usize,
    ) -> Result<Arc<Findings>, ReproductionError> {
        place.stands(ReproductionState::Waiting, None);
        let _turn = self.turn.lock().await;
        place.done.store(0, Ordering::Relaxed);
        place.stands(ReproductionState::Running, None);
        let result = self.on_a_thread(place, threads).await;
        match &result {
            Ok(_) => place.stands(ReproductionState::Done, None),
            Err(error) => place.stands(ReproductionState::Failed, Some(error.to_string())),
        }
        result.map(Arc::new)
    }

    /// A thread of its own, not one of the runtime's: those the end of the server would wait for.
    async fn on_a_thread(
        &'static self,
        place: &'static Place,
        threads: usize,
    ) -> Result<Findings, ReproductionError> {
        let (reply, answer) = oneshot::channel();
        let count = move || {
            place.done.fetch_add(1, Ordering::Relaxed);
        };
        let work = move || drop(reply.send(place.target.run(threads, &self.kept, &count)));
        let broken = |why: String| ReproductionError::Broken(why);
        let name = format!("reproduce {}", place.target.name);
        thread::Builder::new().name(name).spawn(work).map_err(|error| broken(error.to_string()))?;
        answer.await.map_err(|_| broken("the computation ended without a result".into()))?
    }

    fn place(&self, target: &Target) -> Result<&Place, ReproductionError> {
        let found = self.places.iter().find(|place| place.target.name == target.name);
        found.ok_or_else(|| ReproductionError::Broken("a target without a place".into()))
    }
}

impl Place {
    fn standing(&self) -> std::sync::MutexGuard<'_, (ReproductionState, Option<String>)> {
        self.standing.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn stands(&self, state: ReproductionState, reason: Option<String>) {
        *self.standing() = (state, reason);
    }
}

#[cfg(test)]
mod tests {
    use super::super::{ReproductionError, SEEDS, Sets, Unit};
    use super::*;
    use crate::catalog::MINIMUM_COST_PATH;

    fn fails(_: &Target, sets: &Sets<'_>) -> Result<Findings, ReproductionError> {
        (sets.done)();
        Err(ReproductionError::Broken("on purpose".into()))
    }

    fn panics(_: &Target, _: &Sets<'_>) -> Result<Findings, ReproductionError> {
        panic!("on purpose")
    }

    const FAILS: Target = Target {
        name: "fails",
        title: "",
        compares: "",
        source: "",
        readings: &[],
        rules: &[],
        experiment: MINIMUM_COST_PATH,
        arms: &[],
        unit: Unit::Set,
        trials: 1,
        seeds: SEEDS,
        find: fails,
    };
    static BROKEN: Target = FAILS;
    static PANICKING: Target = Target { name: "panics", find: panics, ..FAILS };

    #[tokio::test]
    async fn a_failure_is_told_and_the_next_may_try_again() {
        let shelf: &'static Shelf = Box::leak(Box::new(Shelf::new(&[&BROKEN, &PANICKING])));
        let progress = |target| shelf.progress(target).expect("it has a place");
        assert_eq!(progress(&BROKEN).state, ReproductionState::Idle);
        for target in [&BROKEN, &PANICKING, &BROKEN] {
            assert!(shelf.findings(target, 1).await.is_err());
            assert_eq!(progress(target).state, ReproductionState::Failed);
        }
        assert_eq!(progress(&BROKEN).done, 1, "counted anew");
        assert_eq!(progress(&BROKEN).reason.as_deref(), Some("on purpose"));
    }
}
