//! Reports of tabular sessions: page, JSON, CSV, and all of them in one zip file.

use std::collections::BTreeMap;
use std::io::{Read, Seek, Write};

use maud::{Markup, html};
use serde::Serialize;
use serde_json::Value;

use super::archive::{Archive, ArchiveError};
use super::closing::closing;
use super::command::repeat_command;
use super::csv::line;
use super::curve::{Chart, Series};
use super::differences::Differences;
use super::number::{NOTHING, fixed, fixed_or_nothing, grouped, state_text, time_text};
use super::page::{Heading, KeyNumber, facts, key_numbers, number, numbers, page, table, words};
use super::{FORMAT_VERSION, RunInfo};
use crate::wire::{
    CompetitorCurve, EpisodeView, IntervalView, LogEntry, OutcomeOfEpisode, PointView, PresetInfo,
    ScoreView, ScoresView, Session, SettingInfo,
};

/// Everything the report of a tabular session is made from.
#[derive(Clone, Debug)]
pub struct TableReport {
    /// Title of the experiment, for people.
    pub title: String,
    /// The session.
    pub session: Session,
    /// How the competitors stand.
    pub scores: ScoresView,
    /// The episodes, in order.
    pub episodes: Vec<EpisodeView>,
    /// Every setting of the experiment.
    pub settings: Vec<SettingInfo>,
    /// The preset the settings started from.
    pub preset: PresetInfo,
    /// The event log, oldest first.
    pub events: Vec<LogEntry>,
    /// Program version and commit that wrote the report.
    pub build: String,
}

impl TableReport {
    fn run(&self) -> RunInfo<'_> {
        RunInfo { session: &self.session, settings: &self.settings, preset: &self.preset }
    }

    /// Points of figure 3.3, where the session computed them.
    fn points(&self) -> &[PointView] {
        let plot = self.episodes.iter().find_map(|episode| match &episode.outcome {
            OutcomeOfEpisode::Plot { points } => Some(points.as_slice()),
            _ => None,
        });
        plot.unwrap_or_default()
    }
}

/// The session as one HTML file that needs nothing else.
#[must_use]
pub fn table_html(report: &TableReport) -> String {
    let title = format!("{}, seed {}", report.title, report.session.seed);
    let body = html! {
        (heading(report))
        @if report.points().is_empty() {
            (results(report))
            (curves(report))
            section { h2 { "Episodes" } (episodes_table(report)) }
        } @else {
            (plots(report.points()))
        }
        (closing(report.run(), "episodes", "advises the learner or edits its values", &report.events, &report.build))
    };
    page(&title, body)
}

fn heading(report: &TableReport) -> Markup {
    let session = &report.session;
    html! {
        header {
            h1 { (report.title) ", seed " (session.seed) }
            p class="lead" { "Report of session " code { (session.id) } }
            (facts(&[
                ("State", html! { (state_text(session.state)) }),
                ("Experiment", html! { code { (session.experiment) } }),
                ("Seed", html! { (session.seed) }),
                ("Preset", html! { (report.preset.title) " (" code { (session.preset) } ")" }),
                ("World", html! { code { (session.world) } }),
                ("Build", html! { code { (session.build) } }),
                ("Created", html! { (time_text(&session.created_at)) }),
                ("Last change of state", html! { (time_text(&session.changed_at)) }),
            ]))
        }
        @if let Some(reason) = &session.reason { p { b { "Why: " } (reason) } }
        @if !report.preset.summary.is_empty() { p { b { "Preset: " } (report.preset.summary) } }
    }
}

fn results(report: &TableReport) -> Markup {
    let steps = report.episodes.iter().map(|episode| episode.steps).sum();
    let value = |name, value, note: &str| KeyNumber { name, value, note: note.to_owned() };
    let (done, of) = (report.session.rounds_done, report.session.rounds);
    html! {
        section {
            h2 { "Results" }
            (key_numbers(&[
                value("Episodes of all", report.scores.episodes_done.to_string(), "done by every competitor"),
                value("Episodes in all", done.to_string(), &format!("of {of}")),
                value("Competitors", report.scores.scores.len().to_string(), ""),
                value("Steps", grouped(steps), "over all episodes"),
            ]))
            (scores_table(&report.scores))
        }
    }
}

fn scores_table(scores: &ScoresView) -> Markup {
    const HEADINGS: [Heading; 8] = [
        words("Competitor"),
        numbers("Episodes", "n"),
        numbers("Measure", "mean"),
        numbers("95 % interval", ""),
        numbers("Gain", "%, Eq. 4.13"),
        numbers("95 % interval", "%"),
        numbers("Final policy", ""),
        numbers("Search space", "pairs"),
    ];
    let rows = html! {
        @for score in &scores.scores { (score_row(score)) }
        @if scores.scores.is_empty() { tr { td colspan="8" { "No episode has ended yet" } } }
    };
    let caption = format!(
        "The measure is {}, less is better; the gain is over the competitor that it is compared with",
        scores.measure
    );
    table("scores", &caption, &HEADINGS, rows)
}

fn score_row(score: &ScoreView) -> Markup {
    let ends = |of: &Option<IntervalView>, decimals| {
        of.map_or_else(
            || NOTHING.to_owned(),
            |of| format!("{} to {}", fixed(of.low, decimals), fixed(of.high, decimals)),
        )
    };
    html! {
        tr {
            th scope="row" {
                (score.name)
                @if let Some(reference) = &score.reference { " " small { "against " (reference) } }
            }
            (number(score.n.to_string()))
            (number(fixed_or_nothing(score.index.map(|index| index.value), 2)))
            (number(ends(&score.index, 2)))
            (number(fixed_or_nothing(score.gain_pct, 1)))
            (number(ends(&score.gain, 1)))
            (number(fixed_or_nothing(score.last, 2)))
            (number(score.search_space.map_or_else(|| NOTHING.to_owned(), |pairs| pairs.to_string())))
        }
    }
}

fn curves(report: &TableReport) -> Markup {
    let shown = report.scores.curves.iter().filter(|curve| curve.n > 0);
    let reference = |curve: &CompetitorCurve| {
        let score = report.scores.scores.iter().find(|score| score.name == curve.name)?;
        let of = score.reference.as_ref()?;
        report.scores.curves.iter().find(|other| other.name == *of && other.n > 0)
    };
    html! {
        section class="learning" {
            h2 { "Learning curves" }
            @if report.scores.curves.iter().all(|curve| curve.n == 0) {
                p { "No episode has ended yet" }
            } @else {
                p class="note" {
                    "Means of " (report.scores.measure) " over the episodes; the dashed curve is the "
                    "competitor that it is compared with. The table above gives the intervals."
                }
                div class="charts" {
                    @for curve in shown { (chart(report, curve, reference(curve))) }
                }
            }
        }
    }
}

fn chart(report: &TableReport, curve: &CompetitorCurve, other: Option<&CompetitorCurve>) -> Markup {
    let series = |curve: &'_ CompetitorCurve| -> Vec<(f64, Option<f64>)> {
        curve.at.iter().copied().zip(curve.mean.iter().copied().map(Some)).collect()
    };
    let title = format!("{}, n = {}", curve.name, curve.n);
    let mut all = vec![Series { name: &curve.name, points: series(curve) }];
    all.extend(other.map(|other| Series { name: &other.name, points: series(other) }));
    let x_name = if report.scores.over == "pull" { "Pull" } else { "Trial" };
    Chart {
        title: &title,
        unit: &report.scores.measure,
        x_name,
        x_range: [1.0, curve.at.last().copied().unwrap_or(1.0)],
        series: all,
        marks: None,
        from_zero: true,
    }
    .draw()
}

fn episodes_table(report: &TableReport) -> Markup {
    const HEADINGS: [Heading; 6] = [
        numbers("Round", ""),
        numbers("Episode", ""),
        words("Competitor"),
        numbers("Steps", ""),
        numbers("Measure", ""),
        words("Remarks"),
    ];
    let rows = html! {
        @for episode in &report.episodes {
            tr {
                th scope="row" class="n" { (episode.round) }
                (number(episode.episode.to_string()))
                td { (episode.entrant) @if episode.training { " (training)" } }
                (number(grouped(episode.steps)))
                (number(measure(episode)))
                td { (remarks(episode)) }
            }
        }
        @if report.episodes.is_empty() { tr { td colspan="6" { "No episode has ended yet" } } }
    };
    table("episodes", "A round is one episode of one competitor", &HEADINGS, rows)
}

fn measure(episode: &EpisodeView) -> String {
    match &episode.outcome {
        OutcomeOfEpisode::Walk { index, .. } => fixed(*index, 2),
        OutcomeOfEpisode::Pull { regret, .. } => fixed(*regret, 2),
        OutcomeOfEpisode::Plot { .. } => NOTHING.to_owned(),
    }
}

fn remarks(episode: &EpisodeView) -> Markup {
    let capped = match &episode.outcome {
        OutcomeOfEpisode::Walk { capped, .. } => *capped,
        _ => 0,
    };
    html! {
        @if capped > 0 { (capped) " trials broken off at the cap " }
        @for intervention in &episode.interventions {
            (intervention.text) " (trial " (intervention.trial) ") "
        }
    }
}

/// The plots of figure 3.3 and where their best policy changes.
fn plots(points: &[PointView]) -> Markup {
    let of = |model: &str| points.iter().filter(|point| point.model == model).collect::<Vec<_>>();
    let plots = [("finite-horizon", "horizon h"), ("discounted", "discount γ")];
    html! {
        section {
            h2 { "Where the best policy changes" }
            (crossings_table(points))
        }
        section class="learning" {
            h2 { "Values of the policies" }
            @for (model, parameter) in plots {
                h3 { (model) }
                (values_table(&of(model), parameter))
            }
            @for point in of("average") {
                p { "Average reward: " (values(point)) }
            }
        }
    }
}

fn crossings_table(points: &[PointView]) -> Markup {
    const HEADINGS: [Heading; 4] =
        [words("Model"), numbers("At", "h or γ"), words("Best before"), words("Best after")];
    let rows = html! {
        @for point in points {
            @if let Some(crossing) = point.crossing {
                tr {
                    td { (point.model) }
                    (number(fixed(crossing.at, 3)))
                    td { "policy " (crossing.from + 1) }
                    td { "policy " (crossing.to + 1) }
                }
            }
        }
    };
    table("crossings", "Crossings of the curves of the best policies", &HEADINGS, rows)
}

fn values_table(points: &[&PointView], parameter: &'static str) -> Markup {
    let mut headings = vec![numbers(parameter, "")];
    let policies = points.first().map_or(0, |point| point.values.len());
    headings
        .extend(["J of policy 1", "J of policy 2", "J of policy 3"].map(|name| numbers(name, "")));
    headings.truncate(policies + 1);
    let rows = html! {
        @for point in points {
            tr {
                th scope="row" class="n" { (fixed(point.parameter, 3)) }
                @for value in &point.values { (number(fixed(*value, 2))) }
            }
        }
    };
    table("values", "Values of the policies", &headings, rows)
}

fn values(point: &PointView) -> String {
    point.values.iter().map(|value| fixed(*value, 2)).collect::<Vec<_>>().join(", ")
}

/// The session as JSON: the fields of a [`crate::wire::TableResult`] first, then all the rest.
#[must_use]
pub fn table_json(report: &TableReport) -> String {
    let session = &report.session;
    let file = TableSessionFile {
        experiment: &session.experiment,
        seed: session.seed,
        build: &session.build,
        settings: &session.settings,
        episodes: &report.episodes,
        summary: &report.scores,
        differences: Differences::of(report.run()),
        events: &report.events,
        settings_info: &report.settings,
        format_version: FORMAT_VERSION,
        report_build: &report.build,
        title: &report.title,
        preset: &report.preset,
        session,
    };
    serde_json::to_string_pretty(&file).expect("plain data with text keys always serialises")
}

#[derive(Serialize)]
struct TableSessionFile<'a> {
    experiment: &'a str,
    seed: u64,
    build: &'a str,
    settings: &'a BTreeMap<String, Value>,
    episodes: &'a [EpisodeView],
    summary: &'a ScoresView,
    differences: Differences,
    events: &'a [LogEntry],
    settings_info: &'a [SettingInfo],
    format_version: u32,
    report_build: &'a str,
    title: &'a str,
    preset: &'a PresetInfo,
    session: &'a Session,
}

/// The episodes as CSV: a row a trial, a hundredth of the pulls, or a point of a plot.
#[must_use]
pub fn table_csv(report: &TableReport) -> String {
    let cells =
        |cells: &[&str]| line(&cells.iter().map(|cell| (*cell).to_owned()).collect::<Vec<_>>());
    let mut text = match report.episodes.first().map(|episode| &episode.outcome) {
        Some(OutcomeOfEpisode::Pull { .. }) => {
            cells(&["round", "episode", "strategy", "hundredth_of_pulls", "regret"])
        }
        Some(OutcomeOfEpisode::Plot { .. }) => cells(&["model", "parameter", "policy", "value"]),
        _ => cells(&["round", "episode", "competitor", "training", "trial", "actions"]),
    };
    for episode in &report.episodes {
        for row in rows(episode) {
            text += &line(&row);
        }
    }
    text
}

fn rows(episode: &EpisodeView) -> Vec<Vec<String>> {
    let EpisodeView { round, episode: number, entrant, training, .. } = episode;
    match &episode.outcome {
        OutcomeOfEpisode::Walk { trials, .. } => (1..)
            .zip(trials)
            .map(|(trial, actions): (u32, &u32)| {
                vec![
                    round.to_string(),
                    number.to_string(),
                    entrant.clone(),
                    training.to_string(),
                    trial.to_string(),
                    actions.to_string(),
                ]
            })
            .collect(),
        OutcomeOfEpisode::Pull { course, .. } => (1..)
            .zip(course)
            .map(|(hundredth, regret): (u32, &f64)| {
                vec![
                    round.to_string(),
                    number.to_string(),
                    entrant.clone(),
                    hundredth.to_string(),
                    regret.to_string(),
                ]
            })
            .collect(),
        OutcomeOfEpisode::Plot { points } => points
            .iter()
            .flat_map(|point| {
                (1..).zip(&point.values).map(|(policy, value): (u32, &f64)| {
                    vec![
                        point.model.clone(),
                        point.parameter.to_string(),
                        policy.to_string(),
                        value.to_string(),
                    ]
                })
            })
            .collect(),
    }
}

/// Writes all reports of a tabular session into `target` and gives it back.
///
/// # Errors
/// When the log cannot be read, or the target cannot be written.
pub fn table_zip<W: Write + Seek>(
    report: &TableReport,
    log: Option<&mut dyn Read>,
    target: W,
) -> Result<W, ArchiveError> {
    let mut archive = Archive::new(target);
    archive.text("report.html", &table_html(report))?;
    archive.text("report.json", &table_json(report))?;
    archive.text("episodes.csv", &table_csv(report))?;
    if let Some(log) = log {
        archive.log(log)?;
    }
    archive.text("README.txt", &readme(report))?;
    archive.finish()
}

fn readme(report: &TableReport) -> String {
    let session = &report.session;
    format!(
        "{}: report of session {}\n\
         State {}, seed {}, preset {}, world {}, build {}\n\n\
         Files\n  \
         report.html    the report, for reading and printing\n  \
         report.json    the report, complete, for programs\n  \
         episodes.csv   the episodes, for spreadsheets\n  \
         log.mcap       every step with its explanation (MCAP, JSON messages)\n\n\
         Run it again\n  {}\n  \
         The same build gives the same episodes to the bit, unless somebody advised the learner or edited\n  \
         its values on the way; the events say so.\n",
        report.title,
        session.id,
        state_text(session.state).to_lowercase(),
        session.seed,
        session.preset,
        session.world,
        session.build,
        repeat_command(report.run()),
    )
}
