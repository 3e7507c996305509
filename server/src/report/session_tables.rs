//! The tables in the report of a session.

use maud::{Markup, html};

use super::differences::{Difference, Differences, same_value};
use super::number::{NOTHING, fixed, fixed_or_nothing, time_text, value_for_people};
use super::page::{Heading, number, numbers, table, words};
use super::{RunInfo, SessionReport};
use crate::wire::{AlteredStartView, ExcursionView, LogEntry, PresetInfo, SettingInfo, Trial};

/// One row a trial.
pub(super) fn trials_table(report: &SessionReport) -> Markup {
    const HEADINGS: [Heading; 13] = [
        numbers("Trial", ""),
        words("Goal"),
        numbers("Steps", ""),
        numbers("R(n)", "total"),
        numbers("Regret", "R* − R(n)"),
        numbers("f₁", "Eq. 5.6"),
        numbers("f₂", "Eq. 5.7"),
        numbers("Collisions", ""),
        numbers("Neurons", ""),
        numbers("Added", "neurons"),
        numbers("Deleted", "neurons"),
        numbers("T(n)", "deg"),
        numbers("Path", "m"),
    ];
    let rows = html! {
        @for trial in &report.trials { (trial_row(trial, report.summary.best_trial)) }
        @if report.trials.is_empty() { tr { td colspan="13" { "No trial has ended yet" } } }
    };
    let caption = "R(n) = f₁ + f₂, safety and goal; in brackets what was paid until the trial was capped; \
         R* is what the best path a planner finds earns, and the regret is reckoned with the goal where it truly was";
    table("trials", caption, &HEADINGS, rows)
}

/// One row of [`trials_table`]; words say what colour and weight say too.
fn trial_row(trial: &Trial, best: Option<u32>) -> Markup {
    let is_best = best == Some(trial.trial);
    let class = if is_best { Some("best") } else { (!trial.reached_goal).then_some("failed") };
    let outcome = match (trial.reached_goal, trial.record) {
        (true, _) if is_best => "reached, best",
        (true, true) => "reached, record",
        (true, false) => "reached",
        (false, _) => "not reached",
    };
    let outcome = if trial.scout { format!("{outcome} (scout)") } else { outcome.to_owned() };
    let defined = |text: String| if trial.reached_goal { text } else { format!("({text})") };
    html! {
        tr class=[class] {
            th scope="row" class="n" { (trial.trial) }
            td { (outcome) }
            (number(defined(trial.steps.to_string())))
            (number(defined(fixed(trial.total_reinforcement, 2))))
            (number(fixed_or_nothing(trial.regret, 2)))
            (number(fixed(trial.safety, 2)))
            (number(fixed(trial.goal, 2)))
            (number(trial.collisions.to_string()))
            (number(trial.neurons.to_string()))
            (number(trial.born.to_string()))
            (number(trial.forgotten.to_string()))
            (number(fixed(trial.temperature_deg, 1)))
            (number(fixed(trial.path_m, 2)))
        }
    }
}

/// What the trained networks do from elsewhere (figure 5.8, below right).
pub(super) fn starts_table(starts: &[AlteredStartView]) -> Markup {
    const HEADINGS: [Heading; 9] = [
        words("Start"),
        words("Neuron active"),
        numbers("Explored", "m away"),
        words("Network alone"),
        numbers("Steps", ""),
        numbers("R", "total"),
        numbers("Silent", "% of steps"),
        words("With the reflex"),
        numbers("Steps", ""),
    ];
    let rows = html! {
        @for AlteredStartView { start, inside, explored_m, alone, guided } in starts {
            tr {
                th scope="row" { (start.name) }
                td { (if *inside { "yes" } else { "no" }) }
                (number(explored_m.map_or_else(|| NOTHING.to_owned(), |way_m| fixed(way_m, 2))))
                td { (ending(alone)) }
                (number(alone.steps.to_string()))
                (number(fixed(alone.total_reinforcement, 2)))
                (number(fixed(alone.silent_pct, 1)))
                td { (ending(guided)) }
                (number(guided.steps.to_string()))
            }
        }
    };
    let caption = "The networks as the last trial left them, without exploring or learning. Alone, the \
                   nearest neuron acts even where none is active (silent); beside it, the reflex does";
    table("starts", caption, &HEADINGS, rows)
}

fn ending(excursion: &ExcursionView) -> &'static str {
    match (excursion.reached_goal, excursion.collisions) {
        (true, 0) => "reached",
        (true, _) => "reached after collisions",
        (false, 0) => "not reached",
        (false, _) => "collided",
    }
}

/// One table a group; a group without settings says so.
pub(super) fn differences_tables(differences: &Differences) -> Markup {
    html! {
        @for (title, meaning, group) in differences.groups() {
            h3 { (title) }
            @if group.is_empty() {
                p class="note" { (meaning) ": none" }
            } @else {
                (difference_table(meaning, group))
            }
        }
    }
}

fn difference_table(caption: &str, group: &[Difference]) -> Markup {
    const HEADINGS: [Heading; 4] =
        [words("Setting"), words("This run"), words("Meaning"), words("Source")];
    let rows = html! {
        @for difference in group {
            tr {
                td { code { (difference.key) } }
                td {
                    (value_for_people(&difference.value)) (unit(&difference.unit))
                    @if !difference.is_default { " " span class="tag" { "not the default" } }
                    @if let Some(meaning) = &difference.value_meaning { br; small { (meaning) } }
                }
                td { (difference.meaning) }
                td { (difference.source) }
            }
        }
    };
    table("differences", caption, &HEADINGS, rows)
}

/// Every setting with its value.
pub(super) fn settings_table(run: RunInfo) -> Markup {
    const HEADINGS: [Heading; 6] = [
        words("Setting"),
        words("Value"),
        words("Default"),
        words("Meaning"),
        words("Source"),
        words("Standing"),
    ];
    let rows = html! {
        @for (key, value) in &run.session.settings {
            @let info = run.settings.iter().find(|info| info.key == *key);
            tr {
                td { code { (key) } }
                td { (value_for_people(value)) (unit(info.map_or("", |info| &info.unit))) }
                td { (default_mark(info, value)) }
                td { (info.map_or(NOTHING, |info| &info.meaning)) }
                td { (info.map_or("", |info| &info.source)) }
                td { (info.map_or(NOTHING, |info| &info.standing)) }
            }
        }
    };
    let (changed, all) = (run.session.changed.len(), run.session.settings.len());
    let caption = format!("Every setting of this run; {changed} of {all} changed from the default");
    table("settings", &caption, &HEADINGS, rows)
}

fn default_mark(info: Option<&SettingInfo>, value: &serde_json::Value) -> Markup {
    html! {
        @match info {
            None => (NOTHING),
            Some(info) if same_value(&info.default, value) => "default",
            Some(info) => {
                span class="tag" { "changed" } " from " (value_for_people(&info.default))
            }
        }
    }
}

/// What the preset changes; nothing is said of a preset that changes nothing.
pub(super) fn preset_table(preset: &PresetInfo) -> Markup {
    const HEADINGS: [Heading; 2] = [words("Setting"), words("Value")];
    let rows = html! {
        @for (key, value) in &preset.settings {
            tr { td { code { (key) } } td { (value_for_people(value)) } }
        }
    };
    let caption = format!("What the preset {} changes", preset.name);
    html! { @if !preset.settings.is_empty() { (table("preset", &caption, &HEADINGS, rows)) } }
}

/// The event log.
pub(super) fn events_table(events: &[LogEntry]) -> Markup {
    const HEADINGS: [Heading; 4] =
        [words("Time"), numbers("Tick", ""), words("Kind"), words("What happened")];
    let rows = html! {
        @for event in events {
            tr {
                td class="time" { (time_text(&event.at)) }
                (number(event.tick.to_string()))
                td { (event.kind) }
                td { (event.text) }
            }
        }
        @if events.is_empty() { tr { td colspan="4" { "No events" } } }
    };
    table("events", "Oldest first; the tick is the last one done", &HEADINGS, rows)
}

/// A unit behind its number.
fn unit(unit: &str) -> Markup {
    html! { @if !unit.is_empty() { "\u{a0}" (unit) } }
}
