//! The report of one trial as a page.

use maud::{Markup, html};

use super::TrialReport;
use super::curve::{Chart, Marks, Series};
use super::number::fixed;
use super::page::{KeyNumber, facts, figure, key_numbers, page};
use super::trial_tables::{changes_tables, parts_table, regions_table, steps_table};
use crate::wire::{TickView, Trial};

/// The trial as one HTML file that needs nothing else.
#[must_use]
pub fn trial_html(report: &TrialReport) -> String {
    let trial = &report.end.trial;
    let title = format!("Trial {}: {}, seed {}", trial.trial, report.title, report.session.seed);
    let body = html! {
        (heading(report, &title))
        (result(trial))
        @if let Some(picture) = &report.picture {
            section {
                h2 { "Path" }
                div class="pictures" { (figure(picture)) }
            }
        }
        section {
            h2 { "Total reinforcement" }
            (parts_table(trial, &report.ticks))
        }
        (charts(report))
        section {
            h2 { "Regions" }
            (regions_table(trial))
        }
        section {
            h2 { "What changed at the end of the trial" }
            (changes_tables(&report.end))
        }
        section class="wide" {
            h2 { "Step by step" }
            (steps_table(&report.ticks))
        }
    };
    page(&title, body)
}

fn heading(report: &TrialReport, title: &str) -> Markup {
    let session = &report.session;
    let trial = &report.end.trial;
    html! {
        header {
            h1 { (title) }
            p class="lead" {
                "Trial " (trial.trial) " of " (session.trials) " of session " code { (session.id) }
            }
            (facts(&[
                ("Experiment", html! { code { (session.experiment) } }),
                ("Seed", html! { (session.seed) }),
                ("Preset", html! { code { (session.preset) } }),
                ("World", html! { code { (session.world) } }),
                ("Build", html! { code { (session.build) } }),
                ("Ticks", html! { (trial.first_tick) " to " (trial.last_tick) }),
            ]))
        }
        p class="note" {
            "Settings, and how they differ from the thesis, stand in the report of the session."
        }
    }
}

fn result(trial: &Trial) -> Markup {
    let number = |name, value, note: &str| KeyNumber { name, value, note: note.to_owned() };
    let reached = if trial.reached_goal { "Reached" } else { "Not reached" };
    let reached_note = match (trial.reached_goal, trial.record) {
        (true, true) => "a record: best so far",
        (true, false) if trial.scout => "not a record; a scout set out (A6)",
        (true, false) => "not a record",
        (false, _) => "the trial was capped",
    };
    let reinforcement_note =
        if trial.reached_goal { "Eq. 5.27" } else { "until the cap; R(n) is not defined" };
    let neurons_note = format!("{} added, {} deleted", trial.born, trial.forgotten);
    html! {
        section {
            h2 { "Result" }
            (key_numbers(&[
                number("Goal", reached.to_owned(), reached_note),
                number("Control steps", trial.steps.to_string(), ""),
                number("Total reinforcement", fixed(trial.total_reinforcement, 2), reinforcement_note),
                number("Collisions", trial.collisions.to_string(), "real and virtual"),
                number("Neurons", trial.neurons.to_string(), &neurons_note),
                number("Temperature T(n)", format!("{} deg", fixed(trial.temperature_deg, 1)), ""),
                number("Path", format!("{} m", fixed(trial.path_m, 2)), "true length"),
            ]))
        }
    }
}

fn charts(report: &TrialReport) -> Markup {
    html! {
        @if !report.ticks.is_empty() {
            section {
                h2 { "Reinforcement and clearance" }
                div class="charts" {
                    (reinforcement_chart(&report.ticks))
                    (nearest_chart(&report.ticks))
                }
            }
        }
    }
}

fn reinforcement_chart(ticks: &[TickView]) -> Markup {
    let points =
        |value: fn(&TickView) -> f64| ticks.iter().map(|t| (at(t), Some(value(t)))).collect();
    let chart = Chart {
        title: "Reinforcement of the step",
        unit: "",
        x_name: "Step",
        x_range: steps_range(ticks),
        series: vec![
            Series { name: "r = f₁ + f₂", points: points(|tick| tick.outcome.reinforcement) },
            Series { name: "f₁ (safety)", points: points(|tick| tick.outcome.safety) },
        ],
        marks: Some(Marks {
            name: "collision",
            at: ticks.iter().filter(|tick| tick.outcome.contact != "none").map(at).collect(),
        }),
        from_zero: true,
    };
    chart.draw()
}

fn nearest_chart(ticks: &[TickView]) -> Markup {
    let nearest = |tick: &TickView| {
        let least = tick.sonar_m.iter().copied().fold(f64::INFINITY, f64::min);
        (at(tick), least.is_finite().then_some(least))
    };
    let chart = Chart {
        title: "Least sonar reading when sensing",
        unit: "m",
        x_name: "Step",
        x_range: steps_range(ticks),
        series: vec![Series { name: "least reading", points: ticks.iter().map(nearest).collect() }],
        marks: Some(Marks {
            name: "ended close to an obstacle (Eq. 5.6)",
            at: ticks.iter().filter(|tick| tick.outcome.close).map(at).collect(),
        }),
        from_zero: true,
    };
    chart.draw()
}

fn at(tick: &TickView) -> f64 {
    f64::from(tick.step)
}

fn steps_range(ticks: &[TickView]) -> [f64; 2] {
    [ticks.first().map_or(1.0, at), ticks.last().map_or(1.0, at)]
}
