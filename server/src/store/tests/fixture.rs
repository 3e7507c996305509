//! A small run to store: 24 sonars, trials of ten ticks, numbers with all their digits.

use std::path::Path;

use tempfile::TempDir;

use crate::store::{LogHeader, LogRecord, LogWriter, SessionRow, Store, StoreError, read_log};
use crate::wire::*;

pub(super) const ID: &str = "s1";

/// Ticks of one trial.
pub(super) const TRIAL_TICKS: u64 = 10;

/// A store with one running session.
pub(super) fn store() -> (TempDir, Store) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let store = Store::open(folder.path()).expect("a new data folder opens");
    store.insert_session(&row(ID)).expect("a session is added");
    (folder, store)
}

pub(super) fn row(id: &str) -> SessionRow {
    SessionRow {
        id: id.into(),
        experiment: "minimum-cost-path".into(),
        seed: (1 << 53) - 1,
        preset: "thesis".into(),
        world: "trc-lab".into(),
        world_text: "walls = []".into(),
        settings: [("sonar.noise".to_owned(), 0.1.into())].into(),
        family: Family::Path,
        trials_each: 20,
        rounds: 20,
        speed: Speed::TicksPerSecond(30.0),
        build: "0.1.0".into(),
        state: State::Running,
        reason: None,
        created_at: "2026-01-01T00:00:00Z".into(),
        changed_at: "2026-01-01T00:00:00Z".into(),
        tick: 0,
        rounds_done: 0,
    }
}

pub(super) fn header() -> LogHeader {
    let SessionRow { experiment, seed, settings, trials_each: trials, build, world_text, .. } =
        row(ID);
    LogHeader {
        experiment,
        family: Family::Path,
        seed,
        settings,
        trials,
        build,
        world_text,
        network_text: None,
    }
}

pub(super) fn create(store: &Store) -> LogWriter {
    LogWriter::create(store, ID, &header()).expect("a log is created")
}

/// Writes the records and waits until they are on disk.
pub(super) fn write(writer: &LogWriter, records: &[LogRecord]) -> Result<(), StoreError> {
    records.iter().try_for_each(|record| writer.write(record.clone()))?;
    writer.flush()
}

/// A finished log of `records`, a chunk for every `chunk` of them.
pub(super) fn write_log(store: &Store, records: &[LogRecord], chunk: usize) {
    let writer = create(store);
    for part in records.chunks(chunk) {
        write(&writer, part).expect("records are written");
    }
    writer.finish().expect("the log is finished");
}

/// What a run of `last` ticks puts in its log.
pub(super) fn run(last: u64) -> Vec<LogRecord> {
    run_between(1, last)
}

/// The part of a run from tick `first` to tick `last`.
pub(super) fn run_between(first: u64, last: u64) -> Vec<LogRecord> {
    let mut records = Vec::new();
    for n in first..=last {
        records.push(LogRecord::Tick(Box::new(tick(n))));
        if n.is_multiple_of(TRIAL_TICKS) {
            records.push(LogRecord::TrialEnd(Box::new(trial_end((n / TRIAL_TICKS) as u32))));
            records.push(LogRecord::Entry(entry(n)));
        }
    }
    records
}

pub(super) fn ticks(first: u64, last: u64) -> Vec<TickView> {
    (first..=last).map(tick).collect()
}

/// All records of a log that is neither damaged nor without a header.
pub(super) fn read_all(path: &Path) -> Vec<LogRecord> {
    let log = read_log(path).expect("the log opens");
    log.map(|record| record.expect("the record is readable")).collect()
}

pub(super) fn entry(tick: u64) -> LogEntry {
    let (at, kind) = ("2026-01-01T00:00:01Z".into(), "trial".into());
    LogEntry { at, tick, kind, text: format!("Trial ended at tick {tick}") }
}

pub(super) fn trial_end(trial: u32) -> TrialEndView {
    let last_tick = u64::from(trial) * TRIAL_TICKS;
    TrialEndView {
        trial: Trial {
            trial,
            steps: TRIAL_TICKS as u32,
            total_reinforcement: -number(last_tick, 1),
            safety: -0.0,
            goal: -number(last_tick, 2),
            true_goal: Some(-number(last_tick, 3)),
            neurons: 2,
            born: 2,
            forgotten: 0,
            collisions: 0,
            reached_goal: true,
            record: trial == 1,
            scout: trial == 2,
            temperature_deg: 100.0,
            path_m: 5.0,
            regret: None,
            region_steps: [("hall".to_owned(), 10)].into(),
            first_tick: last_tick - TRIAL_TICKS + 1,
            last_tick,
        },
        backed_up: vec![ChangeView { neuron: 1, before: 0.1, after: 0.2 }],
        replaced: Vec::new(),
        proposed: Vec::new(),
        judged: vec![VerdictView { neuron: 3, delta: Some(-0.0), withdrawn: true }],
        forgotten: vec![7],
        neurons: Vec::new(),
    }
}

pub(super) fn tick(n: u64) -> TickView {
    TickView {
        tick: n,
        trial: ((n - 1) / TRIAL_TICKS + 1) as u32,
        step: ((n - 1) % TRIAL_TICKS + 1) as u32,
        true_pose: pose(n, 1),
        pose: pose(n, 4),
        fix: n.is_multiple_of(5).then(|| FixView {
            odometry: pose(n, 53),
            echoes: 17,
            spread_m: number(n, 56),
        }),
        sonar_m: (0..24).map(|sonar| number(n, 10 + sonar)).collect(),
        reflectance_pct: 12.5,
        goal_distance_m: number(n, 7),
        goal_bearing_deg: -0.0,
        region: "hall".into(),
        winner: Some(WinnerView { neuron: 1, distance: number(n, 8) }),
        born: n.is_multiple_of(3).then_some(2),
        toward_m: n.is_multiple_of(6).then(|| [number(n, 41), -0.0]),
        reflex: None,
        adaptation: AdaptationView::Pending { past: 1 },
        neuron: Some(1),
        prototypical_deg: number(n, 40),
        utility: None,
        aim: None,
        exploration: ExplorationView {
            temperature_deg: 100.0,
            mean_deg: number(n, 41),
            sigma_deg: 50.0,
            deviation_deg: 1.0,
            drawn_deg: 0.5,
            most_deg: Some(100.0),
            xi_deg: 0.5,
        },
        source: "network".into(),
        action_deg: number(n, 42),
        action_frame: "heading".into(),
        rotation_deg: number(n, 43),
        outcome: OutcomeView {
            true_pose: pose(n, 44),
            pose: pose(n, 47),
            contact: "none".into(),
            backed_m: 0.0,
            reinforcement: -number(n, 50),
            safety: 0.0,
            goal: -number(n, 51),
            close: false,
            reached_goal: false,
        },
        neurons: 2,
        total_reinforcement: -number(n, 52),
    }
}

fn pose(n: u64, salt: u64) -> PoseView {
    PoseView { x_m: number(n, salt), y_m: number(n, salt + 1), heading_deg: number(n, salt + 2) }
}

/// A number in [0, 1) with 53 random-looking bits (SplitMix64).
fn number(n: u64, salt: u64) -> f64 {
    let z = (n << 8 | salt).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let z = (z ^ z >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let z = (z ^ z >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
    ((z ^ z >> 31) >> 11) as f64 / (1_u64 << 53) as f64
}
