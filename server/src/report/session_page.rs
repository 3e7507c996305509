//! The report of a session as a page.

use maud::{Markup, html};

use super::SessionReport;
use super::command::repeat_command;
use super::curve::{Chart, Marks, Series};
use super::differences::Differences;
use super::number::{count_or_nothing, fixed_or_nothing, grouped, state_text, time_text};
use super::page::{KeyNumber, facts, key_numbers, page, pictures};
use super::session_tables::{
    differences_tables, events_table, preset_table, settings_table, starts_table, trials_table,
};
use crate::wire::{State, Trial};

/// The session as one HTML file that needs nothing else.
#[must_use]
pub fn html(report: &SessionReport) -> String {
    let title = format!("{}, seed {}", report.title, report.session.seed);
    let body = html! {
        (heading(report))
        (results(report))
        (pictures("Paths", &report.pictures))
        (learning(report))
        section {
            h2 { "Trials" }
            (trials_table(report))
        }
        @if !report.starts.is_empty() {
            section {
                h2 { "Altered starts" }
                (starts_table(&report.starts))
            }
        }
        (differences(report))
        (settings(report))
        (repeat(report))
        section {
            h2 { "Events" }
            (events_table(&report.events))
        }
        footer class="note" {
            "Report written by Sonarium " (report.build) ". Lengths are metres, angles degrees, "
            "times UTC."
        }
    };
    page(&title, body)
}

fn heading(report: &SessionReport) -> Markup {
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
                ("World", html! { (report.world.title) " (" code { (session.world) } ")" }),
                ("Build", html! { code { (session.build) } }),
                ("Created", html! { (time_text(&session.created_at)) }),
                ("Last change of state", html! { (time_text(&session.changed_at)) }),
            ]))
        }
        @if let Some(reason) = &session.reason { p { b { "Why: " } (reason) } }
        @if !report.preset.summary.is_empty() {
            p { b { "Preset: " } (report.preset.summary) }
        }
    }
}

fn results(report: &SessionReport) -> Markup {
    let summary = &report.summary;
    let number = |name, value, note| KeyNumber { name, value, note };
    html! {
        section {
            h2 { "Results" }
            (key_numbers(&[
                number("Trials", summary.trials.to_string(), format!("of {}", report.session.trials)),
                number("Goal reached", summary.reached.to_string(), format!("of {} trials", summary.trials)),
                number(
                    "Best total reinforcement",
                    fixed_or_nothing(summary.best_total_reinforcement, 2),
                    summary.best_trial.map(|trial| format!("trial {trial}")).unwrap_or_default(),
                ),
                number(
                    "Last total reinforcement",
                    fixed_or_nothing(last_of(report, |trial| trial.total_reinforcement), 2),
                    last_note(report),
                ),
                yardstick(report),
                number(
                    "Last regret",
                    fixed_or_nothing(summary.last_regret, 2),
                    summary.last_regret_pct.map(|share| format!("{share:.0} % of the best path's cost")).unwrap_or_default(),
                ),
                number(
                    "Steps of the last trial",
                    count_or_nothing(summary.last_steps),
                    last_note(report),
                ),
                number("Neurons", summary.neurons.to_string(), "after the last trial".into()),
                number("Collisions", grouped(summary.collisions.into()), "real and virtual".into()),
                number("Control steps", grouped(summary.steps), "over all trials".into()),
            ]))
        }
    }
}

/// The best path a planner finds, which knows the world and the cost beforehand.
fn yardstick(report: &SessionReport) -> KeyNumber {
    let planned = report.yardstick.ready();
    KeyNumber {
        name: "Best path a planner finds",
        value: fixed_or_nothing(planned.map(|path| path.total_reinforcement), 2),
        note: planned.map_or("none to compare with".into(), |path| format!("{} steps", path.steps)),
    }
}

/// A capped trial has no defined R(n) (section 5.11).
fn last_of(report: &SessionReport, value: fn(&Trial) -> f64) -> Option<f64> {
    report.trials.last().filter(|trial| trial.reached_goal).map(value)
}

fn last_note(report: &SessionReport) -> String {
    match report.trials.last() {
        Some(last) if last.reached_goal => format!("trial {}", last.trial),
        Some(last) => format!("trial {}, goal not reached", last.trial),
        None => String::new(),
    }
}

fn learning(report: &SessionReport) -> Markup {
    let failed: Vec<f64> =
        report.trials.iter().filter(|t| !t.reached_goal).map(number_of).collect();
    let reached = |value: fn(&Trial) -> f64| {
        let point = |t: &Trial| (number_of(t), t.reached_goal.then(|| value(t)));
        report.trials.iter().map(point).collect()
    };
    let neurons =
        report.trials.iter().map(|t| (number_of(t), Some(f64::from(t.neurons)))).collect();
    let planned = report.yardstick.ready();
    let best_steps = planned.map(|path| f64::from(path.steps));
    let best_reinforcement = planned.map(|path| path.total_reinforcement);
    let curves = [
        ("Neurons after the trial", "neurons", neurons, None),
        ("Steps to the goal", "control steps", reached(|trial| f64::from(trial.steps)), best_steps),
        (
            "Total reinforcement R(n)",
            "",
            reached(|trial| trial.total_reinforcement),
            best_reinforcement,
        ),
    ];
    html! {
        section class="learning" {
            h2 { "Learning curves" }
            @if report.trials.is_empty() {
                p { "No trial has ended yet" }
            } @else {
                p class="note" {
                    "One run, n = 1, no interval. A trial that did not reach the goal has no defined "
                    "steps and R(n): it is a gap in the curve and a cross on the axis."
                }
                div class="charts" {
                    @for (title, unit, points, best) in curves {
                        (curve(report, (title, unit), points, best, failed.clone()))
                    }
                }
            }
        }
    }
}

fn number_of(trial: &Trial) -> f64 {
    f64::from(trial.trial)
}

fn curve(
    report: &SessionReport,
    (title, unit): (&str, &str),
    points: Vec<(f64, Option<f64>)>,
    best: Option<f64>,
    failed: Vec<f64>,
) -> Markup {
    let last = report.trials.last().map_or(1.0, number_of);
    let mut series = vec![Series { name: "this run", points }];
    series.extend(best.map(|best| Series {
        name: "best path a planner finds",
        points: vec![(1.0, Some(best)), (last, Some(best))],
    }));
    let chart = Chart {
        title,
        unit,
        x_name: "Trial",
        x_range: [1.0, last],
        series,
        marks: Some(Marks { name: "goal not reached", at: failed }),
        from_zero: false,
    };
    chart.draw()
}

fn differences(report: &SessionReport) -> Markup {
    html! {
        section {
            h2 { "Differences from the thesis" }
            p {
                "How this run reads the thesis, setting by setting. A setting that is off stands here "
                "too, so that what was not used can be seen. Properties of the simulation are listed "
                "apart, below the readings."
            }
            (differences_tables(&Differences::of(report.run())))
        }
    }
}

fn settings(report: &SessionReport) -> Markup {
    html! {
        section {
            h2 { "Settings" }
            (settings_table(report.run()))
            (preset_table(&report.preset))
        }
    }
}

fn repeat(report: &SessionReport) -> Markup {
    let session = &report.session;
    let whole = session.trials_done >= session.trials;
    html! {
        section {
            h2 { "How to repeat this run" }
            pre { code { (repeat_command(report.run())) } }
            p class="note" {
                "The same build (" code { (session.build) } ") gives the same trials to the bit, at "
                "any pace. "
                @if !whole {
                    "This session did " (session.trials_done) " of " (session.trials)
                    " trials; the first " (session.trials_done) " of the command are these. "
                }
                @if session.state == State::Running || session.state == State::Paused {
                    "The session was still open when this report was written."
                }
            }
        }
    }
}
