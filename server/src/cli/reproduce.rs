//! `sonarium reproduce`.

use std::io::{IsTerminal, stderr};

use clap::Args;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use sonarium_core::stats::Verdict as Judged;

use super::{Failure, cores, output};
use crate::reproduce::{ReproductionError, TARGETS, Target, target};
use crate::wire::{Reproduction, ReproductionRow, Verdict};

#[derive(Args, Debug)]
pub(super) struct Arguments {
    /// What to compute again: table-5.1 or all
    target: String,
    /// Print one JSON object a target
    #[arg(long)]
    json: bool,
}

pub(super) fn reproduce(arguments: &Arguments) -> Result<(), Failure> {
    let targets = match arguments.target.as_str() {
        "all" => TARGETS.to_vec(),
        name => vec![target(name)?],
    };
    for target in targets {
        let progress = progress(target);
        let result = target.run(cores(), &|| progress.inc(1));
        progress.finish_and_clear();
        let result = result?;
        if arguments.json {
            output::json(&result)?;
        } else {
            output::line(&text(target, &result))?;
        }
    }
    Ok(())
}

fn progress(target: &Target) -> ProgressBar {
    let sets = u64::from(target.sets()) * target.presets.len() as u64;
    if !stderr().is_terminal() {
        return ProgressBar::with_draw_target(Some(sets), ProgressDrawTarget::hidden());
    }
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} sets, {eta} left");
    ProgressBar::new(sets).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

/// A result for people: what was done, the table, the rule, and what does not agree.
fn text(target: &Target, result: &Reproduction) -> String {
    let seeds = &target.seeds;
    let mut text = format!(
        "{}: {} ({})\n{}.\n{} sets a preset, {} trials a set, seeds {}..{}, build {}\n\n",
        target.name,
        target.title,
        target.source,
        target.compares,
        target.sets(),
        target.trials,
        seeds.start(),
        seeds.end(),
        crate::build()
    );
    text += &line(["", "published", "ours", "95 % interval", "n", "verdict"]);
    for row in &result.rows {
        text += &table_row(row);
    }
    text + &format!("\n{}.\n{}", Judged::RULE, conclusion(&result.rows))
}

fn table_row(row: &ReproductionRow) -> String {
    let unit = if row.unit.is_empty() { String::new() } else { format!(" ({})", row.unit) };
    line([
        &format!("{}{unit}", row.name),
        &row.published.map_or_else(|| "none".into(), |published| published.to_string()),
        &format!("{:.2}", row.ours),
        &format!("{:.2} to {:.2}", row.low, row.high),
        &row.n.to_string(),
        row.verdict.word(),
    ])
}

fn line([name, published, ours, interval, n, verdict]: [&str; 6]) -> String {
    format!("{name:<40}  {published:>9}  {ours:>9}  {interval:>20}  {n:>4}  {verdict}\n")
}

/// Says plainly what does not agree.
fn conclusion(rows: &[ReproductionRow]) -> String {
    let named = |verdict| {
        let rows = rows.iter().filter(|row| row.verdict == verdict);
        rows.map(|row| row.name.as_str()).collect::<Vec<_>>().join("; ")
    };
    [
        ("Does not agree", Verdict::Differs),
        ("Cannot be told", Verdict::CannotTell),
        ("Agrees", Verdict::Agrees),
    ]
    .into_iter()
    .map(|(words, verdict)| (words, named(verdict)))
    .map(
        |(words, names)| {
            if names.is_empty() { format!("{words}: nothing") } else { format!("{words}: {names}") }
        },
    )
    .collect::<Vec<_>>()
    .join("\n")
}

impl From<ReproductionError> for Failure {
    fn from(error: ReproductionError) -> Self {
        match error {
            ReproductionError::Unknown { .. } => Self::Input(format!("{error}, and `all`")),
            ReproductionError::Catalog(error) => error.into(),
            ReproductionError::Field(error) => Self::Failed(error.to_string()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(name: &str, verdict: Verdict) -> ReproductionRow {
        ReproductionRow {
            name: name.into(),
            published: Some(1.9),
            ours: 2.0,
            low: 1.0,
            high: 3.0,
            n: 200,
            unit: String::new(),
            verdict,
            reading: String::new(),
        }
    }

    #[test]
    fn the_conclusion_names_what_does_not_agree_first() {
        let rows =
            [row("a", Verdict::Agrees), row("b", Verdict::Differs), row("c", Verdict::Differs)];
        assert_eq!(conclusion(&rows), "Does not agree: b; c\nCannot be told: nothing\nAgrees: a");
    }

    #[test]
    fn columns_are_aligned() {
        let head = line(["", "published", "ours", "95 % interval", "n", "verdict"]);
        let row = table_row(&row("reflex: total reinforcement, variance", Verdict::Differs));
        assert_eq!(head.find("verdict"), row.find("differs"), "{head}{row}");
    }
}
