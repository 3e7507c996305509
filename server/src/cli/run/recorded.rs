//! Runs that leave logs and reports, in the layout of a data folder.

use std::path::Path;

use indicatif::ProgressBar;

use super::super::{Failure, cores};
use crate::batch::{drive_result, result, table_result};
use crate::catalog::{Catalog, PlainPlan, Plan, Trained};
use crate::render::{Backend, Renderer};
use crate::report;
use crate::session::{Control, Feed, Lab, Reporter};
use crate::store::Store;
use crate::wire::{
    DriveResult, NamedSpeed, NewSession, RunResult, Session, Speed, State, TableResult,
};

/// Runs sessions as the server does, as fast as it goes, and hands over the results in order.
pub(super) fn run(
    catalog: Catalog,
    requests: &[NewSession],
    plans: &[Plan],
    folder: &Path,
    progress: &ProgressBar,
    mut take: impl FnMut(RunResult, &Trained) -> Result<(), Failure>,
) -> Result<(), Failure> {
    each_session(catalog, requests, folder, progress, |index, reporter, id| {
        let lab = reporter.lab;
        let report = reporter.session(id)?;
        write(
            lab,
            id,
            [
                ("report.html", report::html(&report)),
                ("report.json", report::json(&report)),
                ("trials.csv", report::csv(&report)),
            ],
        )?;
        let starts = lab.altered_starts(id, Some(&plans[index].starts))?;
        let trials = lab.store().trials(id)?;
        let plan = lab.plan(id)?;
        let network = lab.trained(id)?.unwrap_or_else(|| Trained::new(&plan, 0, Vec::new()));
        take(result(&plan, trials, starts), &network)
    })
}

/// The same for tabular experiments.
pub(super) fn run_tables(
    catalog: Catalog,
    requests: &[NewSession],
    plans: &[PlainPlan],
    folder: &Path,
    progress: &ProgressBar,
    mut take: impl FnMut(TableResult) -> Result<(), Failure>,
) -> Result<(), Failure> {
    each_session(catalog, requests, folder, progress, |index, reporter, id| {
        let Some(report) = reporter.table(id)? else { return Ok(()) };
        write(
            reporter.lab,
            id,
            [
                ("report.html", report::table_html(&report)),
                ("report.json", report::table_json(&report)),
                ("episodes.csv", report::table_csv(&report)),
            ],
        )?;
        take(table_result(&plans[index], report.episodes, report.scores))
    })
}

/// The same for experiments of chapter 2.
pub(super) fn run_drives(
    catalog: Catalog,
    requests: &[NewSession],
    plans: &[PlainPlan],
    folder: &Path,
    progress: &ProgressBar,
    mut take: impl FnMut(DriveResult) -> Result<(), Failure>,
) -> Result<(), Failure> {
    each_session(catalog, requests, folder, progress, |index, reporter, id| {
        let Some(report) = reporter.drive(id)? else { return Ok(()) };
        write(
            reporter.lab,
            id,
            [
                ("report.html", report::drive_html(&report)),
                ("report.json", report::drive_json(&report)),
                ("runs.csv", report::drive_csv(&report)),
            ],
        )?;
        take(drive_result(&plans[index], report.runs, report.scores))
    })
}

/// Runs sessions, and hands each over by its number when it is done.
fn each_session(
    catalog: Catalog,
    requests: &[NewSession],
    folder: &Path,
    progress: &ProgressBar,
    mut done: impl FnMut(usize, Reporter<'_>, &str) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let lab = Lab::new(catalog, Store::open(folder)?, cores());
    let backend = Backend::from_environment().map_err(|e| Failure::Input(e.to_string()))?;
    let renderer = Renderer::start(backend);
    let runtime = tokio::runtime::Runtime::new()?;
    let mut index = 0;
    // A few more than cores are created ahead, so that no core waits for a report to be written.
    for requests in requests.chunks(4 * cores()) {
        let sessions = requests.iter().map(|request| create(&lab, request));
        let sessions: Vec<Session> = sessions.collect::<Result<_, Failure>>()?;
        let feeds = sessions.iter().map(|session| lab.feed(&session.id));
        let feeds = feeds.collect::<Result<Vec<_>, _>>()?;
        for session in &sessions {
            runtime.block_on(lab.control(&session.id, Control::Start))?;
        }
        for (session, feed) in sessions.iter().zip(feeds) {
            runtime.block_on(finished(&feed, progress))?;
            done(index, Reporter { lab: &lab, renderer: &renderer }, &session.id)?;
            index += 1;
        }
    }
    Ok(())
}

fn create(lab: &Lab, request: &NewSession) -> Result<Session, Failure> {
    let speed = Some(Speed::Named(NamedSpeed::Max));
    Ok(lab.create(&NewSession { speed, ..request.clone() })?)
}

/// Waits until a session has done its rounds.
async fn finished(feed: &Feed, progress: &ProgressBar) -> Result<(), Failure> {
    let mut changes = feed.subscribe();
    let mut counted = 0;
    loop {
        changes.mark_unchanged();
        let session = feed.snapshot().session.clone();
        progress.inc(u64::from(session.rounds_done - counted));
        counted = session.rounds_done;
        match session.state {
            State::Finished => return Ok(()),
            State::Failed => return Err(Failure::Failed(session.reason.unwrap_or_default())),
            // The feed outlives this loop, so there always is a next change.
            _ => drop(changes.changed().await),
        }
    }
}

/// Writes the files of a session beside its log.
fn write(lab: &Lab, id: &str, files: [(&str, String); 3]) -> Result<(), Failure> {
    let folder = lab.store().session_folder(id);
    for (name, text) in files {
        std::fs::write(folder.join(name), text)?;
    }
    Ok(())
}
