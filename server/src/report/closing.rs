//! What the reports of plain experiments end with: readings, settings, how to repeat the run, events.

use maud::{Markup, html};

use super::RunInfo;
use super::command::repeat_command;
use super::differences::Differences;
use super::session_tables::{differences_tables, events_table, preset_table, settings_table};
use crate::wire::LogEntry;

/// The last sections of a report. `what` is repeated to the bit as long as nobody does what `hand` says.
pub(super) fn closing(
    run: RunInfo<'_>,
    what: &str,
    hand: &str,
    events: &[LogEntry],
    build: &str,
) -> Markup {
    html! {
        section {
            h2 { "Differences from the thesis" }
            p { "How this run reads the thesis, setting by setting." }
            (differences_tables(&Differences::of(run)))
        }
        section {
            h2 { "Settings" }
            (settings_table(run))
            (preset_table(run.preset))
        }
        section {
            h2 { "How to repeat this run" }
            pre { code { (repeat_command(run)) } }
            p class="note" {
                "The same build (" code { (run.session.build) } ") gives the same " (what)
                " to the bit, at any pace, as long as nobody " (hand) " on the way."
            }
        }
        section { h2 { "Events" } (events_table(events)) }
        footer class="note" {
            "Report written by Sonarium " (build) ". Lengths are metres, angles degrees, times UTC."
        }
    }
}
