//! The tables in the report of a trial.

use maud::{Markup, html};

use super::number::{NOTHING, count_or_nothing, fixed, fixed_or_nothing};
use super::page::{Heading, number, numbers, table, words};
use crate::wire::{
    AdaptationView, ChangeView, ProposalView, TickView, Trial, TrialEndView, VerdictView,
};

/// Total reinforcement by its two parts, with the steps that paid.
pub(super) fn parts_table(trial: &Trial, ticks: &[TickView]) -> Markup {
    const HEADINGS: [Heading; 4] = [
        words("Part"),
        numbers("Sum", "reinforcement"),
        numbers("Per step", "mean"),
        numbers("Steps", "below 0"),
    ];
    let per_step = |sum: f64| (trial.steps > 0).then(|| sum / f64::from(trial.steps));
    let paid = |part: fn(&TickView) -> f64| ticks.iter().filter(|tick| part(tick) < 0.0).count();
    let parts: [(&str, f64, usize); 3] = [
        ("Safety f₁, Eq. 5.6", trial.safety, paid(|tick| tick.outcome.safety)),
        ("Goal f₂, Eq. 5.7", trial.goal, paid(|tick| tick.outcome.goal)),
        ("Total R(n), Eq. 5.27", trial.total_reinforcement, paid(|t| t.outcome.reinforcement)),
    ];
    let rows = html! {
        @for (name, sum, paid) in parts {
            tr {
                th scope="row" { (name) }
                (number(fixed(sum, 3)))
                (number(fixed_or_nothing(per_step(sum), 3)))
                (number(paid.to_string()))
            }
        }
    };
    table("parts", "Where the reinforcement of the trial came from", &HEADINGS, rows)
}

/// Steps taken in each region.
pub(super) fn regions_table(trial: &Trial) -> Markup {
    const HEADINGS: [Heading; 2] = [words("Region"), numbers("Steps", "")];
    let rows = html! {
        @for (region, steps) in &trial.region_steps {
            tr { th scope="row" { (region) } (number(steps.to_string())) }
        }
    };
    table("regions", "Control steps by the region the robot believed to be in", &HEADINGS, rows)
}

/// What the learner did at the end: back-tracking, replacement, shortcuts, deletion.
pub(super) fn changes_tables(end: &TrialEndView) -> Markup {
    html! {
        (change_table("Utilities set by back-tracking, Eq. 5.26", "u", "", &end.backed_up, 3))
        (change_table("Prototypical actions replaced, Eq. 5.28", "p", "deg", &end.replaced, 1))
        (proposal_table(&end.proposed))
        (verdict_table(&end.judged))
        h3 { "Neurons deleted, deviation D3" }
        (neurons(&end.forgotten))
    }
}

fn neurons(numbers: &[u32]) -> Markup {
    html! {
        @match numbers {
            [] => p class="note" { "None" },
            [one] => p { "Neuron " (one) },
            several => p { (several.len()) " neurons: " (list(several)) },
        }
    }
}

fn list(neurons: &[u32]) -> String {
    let numbers: Vec<String> = neurons.iter().map(u32::to_string).collect();
    numbers.join(", ")
}

fn change_table(
    title: &str,
    symbol: &'static str,
    unit: &'static str,
    changes: &[ChangeView],
    decimals: usize,
) -> Markup {
    html! {
        h3 { (title) }
        @if changes.is_empty() {
            p class="note" { "None" }
        } @else {
            p class="note" {
                (changes.len()) @if changes.len() == 1 { " neuron" } @else { " neurons" }
                ": number, then " (symbol) " before → after"
                @if !unit.is_empty() { ", " (unit) }
            }
            ul class="changes" {
                @for change in changes {
                    li {
                        b { (change.neuron) } " "
                        (fixed(change.before, decimals)) " → " (fixed(change.after, decimals))
                    }
                }
            }
        }
    }
}

/// The shortcuts: which later point, and what the critic expects of it.
fn proposal_table(proposals: &[ProposalView]) -> Markup {
    const HEADINGS: [Heading; 8] = [
        numbers("Neuron", ""),
        numbers("Aims at step", "of the record path"),
        numbers("x", "m"),
        numbers("y", "m"),
        words("Bends there for"),
        numbers("Driving there", "reinforcement"),
        numbers("u there", "utility"),
        numbers("μ", "deg"),
    ];
    let rows = html! {
        @for proposal in proposals {
            tr {
                th scope="row" class="n" { (proposal.neuron) }
                (number(proposal.step.to_string()))
                (number(fixed(proposal.aim.x_m, 2)))
                (number(fixed(proposal.aim.y_m, 2)))
                td { (bend(proposal.aim.beyond_m)) }
                (number(fixed(proposal.straight, 3)))
                (number(fixed(proposal.utility, 3)))
                (number(fixed(proposal.after, 1)))
            }
        }
    };
    let caption = "The later point with the greatest predicted return: reinforcement of driving there, straight \
                   or, from home, with one bend, plus the utility there";
    html! {
        h3 { "Shortcuts proposed, addition A1" }
        @if proposals.is_empty() {
            p class="note" { "None" }
        } @else {
            (table("shortcuts", caption, &HEADINGS, rows))
        }
    }
}

/// Where a way leads on that bends.
fn bend(beyond_m: Option<[f64; 2]>) -> String {
    beyond_m.map_or_else(
        || NOTHING.to_owned(),
        |[x_m, y_m]| format!("{}, {}", fixed(x_m, 2), fixed(y_m, 2)),
    )
}

/// What came of the shortcuts that were followed without a record.
fn verdict_table(judged: &[VerdictView]) -> Markup {
    const HEADINGS: [Heading; 3] =
        [numbers("Neuron", ""), numbers("δ", "TD error over the way"), words("Its shortcut")];
    let rows = html! {
        @for verdict in judged {
            tr {
                th scope="row" class="n" { (verdict.neuron) }
                (number(fixed_or_nothing(verdict.delta, 3)))
                td { @if verdict.withdrawn { "withdrawn" } @else { "kept" } }
            }
        }
    };
    let caption = "δ = r + … + r + u where it ended − u where it began: above 0, it cost less than the record \
                   path; none where it began off that path or never came back to it";
    html! {
        h3 { "Shortcuts followed without a record, addition A8" }
        @if judged.is_empty() {
            p class="note" { "None" }
        } @else {
            (table("verdicts", caption, &HEADINGS, rows))
        }
    }
}

/// One row a control step.
pub(super) fn steps_table(ticks: &[TickView]) -> Markup {
    const HEADINGS: [Heading; 17] = [
        numbers("Tick", ""),
        words("Region"),
        numbers("Winner", "neuron"),
        numbers("‖x − c‖", "distance"),
        numbers("u", "utility"),
        numbers("p", "deg"),
        numbers("μ", "deg"),
        numbers("T", "deg"),
        numbers("σ", "deg"),
        numbers("ξ", "deg"),
        numbers("α", "deg"),
        numbers("Rotation", "deg"),
        numbers("f₁", "safety"),
        numbers("f₂", "goal"),
        numbers("r", ""),
        numbers("δ", "TD error"),
        words("Growth, contact"),
    ];
    let caption = "Sensed, decided, moved: α in its frame, rotation before the advance, \
                   r after it; δ is the error of the past neuron";
    let rows = html! { @for tick in ticks { (step_row(tick)) } };
    table("steps", caption, &HEADINGS, rows)
}

fn step_row(tick: &TickView) -> Markup {
    let (outcome, draw) = (&tick.outcome, &tick.exploration);
    html! {
        tr {
            th scope="row" class="n" { (tick.tick) }
            td { (tick.region) }
            (number(count_or_nothing(tick.winner.map(|winner| winner.neuron))))
            (number(fixed_or_nothing(tick.winner.map(|winner| winner.distance), 3)))
            (number(fixed_or_nothing(tick.utility, 2)))
            (number(fixed(tick.prototypical_deg, 1)))
            (number(fixed(draw.mean_deg, 1)))
            (number(fixed(draw.temperature_deg, 1)))
            (number(fixed(draw.sigma_deg, 1)))
            (number(fixed(draw.xi_deg, 1)))
            (number(fixed(tick.action_deg, 1)))
            (number(fixed(tick.rotation_deg, 1)))
            (number(fixed(outcome.safety, 2)))
            (number(fixed(outcome.goal, 2)))
            (number(fixed(outcome.reinforcement, 2)))
            (number(delta(&tick.adaptation)))
            td { (happenings(tick)) }
        }
    }
}

/// The temporal-difference error, or why there is none.
fn delta(adaptation: &AdaptationView) -> String {
    match adaptation {
        AdaptationView::Updated { delta, .. } | AdaptationView::Split { delta, .. } => {
            fixed(*delta, 2)
        }
        AdaptationView::Pending { .. } => "pending".to_owned(),
        AdaptationView::Off => "off".to_owned(),
        AdaptationView::NoPast => NOTHING.to_owned(),
    }
}

/// Neurons added, who decided when it was not the network, and what was touched.
fn happenings(tick: &TickView) -> String {
    let mut words = Vec::new();
    if let Some(born) = tick.born {
        let toward = tick.toward_m.map(|[x, y]| format!(" for ({x:.2}, {y:.2})"));
        words.push(format!("+ neuron {born}{}", toward.unwrap_or_default()));
    }
    if let AdaptationView::Split { added, past, .. } = &tick.adaptation {
        words.push(format!("+ neuron {added} (split {past})"));
    }
    if tick.source != "network" {
        words.push(tick.source.replace('-', " "));
    }
    if tick.outcome.contact != "none" {
        words.push(format!("{} collision", tick.outcome.contact));
    }
    if tick.outcome.reached_goal {
        words.push("goal".to_owned());
    }
    words.join(", ")
}
