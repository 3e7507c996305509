//! A result for people at a terminal.

use crate::reproduce::Target;
use crate::wire::{Reproduction, ReproductionRow, Verdict};

/// What was done, the table, the rule, and what does not agree.
pub(super) fn table(target: &Target, result: &Reproduction) -> String {
    let head = ["", "published", "ours", "95 % interval", "n", "verdict"].map(str::to_owned);
    let rows: Vec<[String; 6]> = result.rows.iter().map(cells).collect();
    let width = rows.iter().map(|row| row[0].chars().count()).max().unwrap_or(0);
    let mut text = format!("{}\n\n{}", head_lines(target), line(&head, width));
    for row in &rows {
        text += &line(row, width);
    }
    text + &format!("\n{}.\n{}", target.rule(), conclusion(&result.rows))
}

/// What was done.
pub(super) fn head_lines(target: &Target) -> String {
    format!(
        "{}: {} ({})\n{}.\n{}; build {}",
        target.name,
        target.title,
        target.source,
        target.compares,
        target.extent(),
        crate::build()
    )
}

/// The cells of a row.
pub(super) fn cells(row: &ReproductionRow) -> [String; 6] {
    let unit = if row.unit.is_empty() { String::new() } else { format!(" ({})", row.unit) };
    [
        format!("{}{unit}", row.name),
        published(row),
        format!("{:.2}", row.ours),
        interval(row),
        sample(row),
        row.verdict.word().to_owned(),
    ]
}

fn interval(row: &ReproductionRow) -> String {
    if row.n == 0 { "exact".to_owned() } else { format!("{:.2} to {:.2}", row.low, row.high) }
}

fn sample(row: &ReproductionRow) -> String {
    if row.n == 0 { "-".to_owned() } else { row.n.to_string() }
}

/// What is published, or required where nothing is.
fn published(row: &ReproductionRow) -> String {
    let published = row.published.map(|published| published.to_string());
    published.or_else(|| row.required.clone()).unwrap_or_else(|| "none".into())
}

fn line([name, published, ours, interval, n, verdict]: &[String; 6], width: usize) -> String {
    format!("{name:<width$}  {published:>9}  {ours:>9}  {interval:>20}  {n:>4}  {verdict}\n")
}

/// Says plainly what does not agree.
fn conclusion(rows: &[ReproductionRow]) -> String {
    let named = |verdict| {
        let rows = rows.iter().filter(|row| row.verdict == verdict);
        rows.map(|row| row.name.as_str()).collect::<Vec<_>>().join("; ")
    };
    let says = |(words, verdict)| {
        let names = named(verdict);
        if names.is_empty() { format!("{words}: nothing") } else { format!("{words}: {names}") }
    };
    [
        ("Does not agree", Verdict::Differs),
        ("Cannot be told", Verdict::CannotTell),
        ("Agrees", Verdict::Agrees),
    ]
    .map(says)
    .join("\n")
}

#[cfg(test)]
mod tests {
    use super::super::sample_row as row;
    use super::*;

    #[test]
    fn the_conclusion_names_what_does_not_agree_first() {
        let rows =
            [row("a", Verdict::Agrees), row("b", Verdict::Differs), row("c", Verdict::Differs)];
        assert_eq!(conclusion(&rows), "Does not agree: b; c\nCannot be told: nothing\nAgrees: a");
    }

    #[test]
    fn what_is_exact_has_neither_interval_nor_sample() {
        let exact = ReproductionRow { n: 0, ..row("pairs", Verdict::Agrees) };
        assert_eq!(cells(&exact)[3..5], ["exact", "-"]);
        assert_eq!(cells(&row("pairs", Verdict::Agrees))[3..5], ["1.00 to 3.00", "200"]);
    }

    #[test]
    fn columns_are_aligned() {
        let row = cells(&row("reflex: variance", Verdict::Differs));
        let head = line(
            &["", "published", "ours", "95 % interval", "n", "verdict"].map(str::to_owned),
            16,
        );
        assert_eq!(head.find("verdict"), line(&row, 16).find("differs"), "{head}{row:?}");
    }
}
