//! A result as Markdown, for documents that hold the table with the command that made it.

use std::collections::BTreeMap;

use super::text::cells;
use crate::reproduce::Target;
use crate::wire::{Reproduction, ReproductionRow};

/// The heading, what was done, the table, the rule and the readings.
pub(super) fn document(target: &Target, result: &Reproduction) -> String {
    let mut text = format!("### {}: {}\n\n", target.name, target.title);
    text += &format!("{} ({}). ", target.compares, target.source);
    text += &format!("{}: `sonarium reproduce {}`.\n\n", capital(&target.extent()), target.name);
    let published = result.rows.iter().any(|row| row.published.is_some());
    let held_against = if published { "published" } else { "required" };
    text += &format!("| | {held_against} | ours | 95 % interval | n | verdict |\n");
    text += "|---|--:|--:|--:|--:|---|\n";
    for row in &result.rows {
        text += &format!("| {} |\n", cells(row).map(|cell| escaped(&cell)).join(" | "));
    }
    text += &format!("\n{}.\n", target.rule());
    let readings = readings(target, &result.rows);
    if !readings.is_empty() {
        text += &format!("\nReadings:\n\n{}", readings.join(""));
    }
    text
}

/// Those of the target, then one a quantity, whatever the arm.
fn readings(target: &Target, rows: &[ReproductionRow]) -> Vec<String> {
    let mut lines: Vec<String> =
        target.readings.iter().map(|reading| format!("- {}.\n", escaped(reading))).collect();
    let mut seen = BTreeMap::new();
    for row in rows {
        let (_, quantity) = row.name.split_once(": ").unwrap_or(("", &row.name));
        let (_, reading) = row.reading.split_once(": ").unwrap_or(("", &row.reading));
        if seen.insert(quantity.to_owned(), ()).is_none() {
            lines.push(format!("- *{}*: {}.\n", escaped(quantity), escaped(reading)));
        }
    }
    lines
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default()
}

fn escaped(text: &str) -> String {
    text.replace('|', "\\|")
}

#[cfg(test)]
mod tests {
    use super::super::sample_row as row;
    use super::*;
    use crate::reproduce::TABLE_5_1;
    use crate::wire::Verdict;

    #[test]
    fn every_line_of_the_table_has_six_cells() {
        let rows = vec![row("default: a | b", Verdict::Agrees), row("thesis: c", Verdict::Differs)];
        let result = Reproduction {
            target: "table-5.1".into(),
            rows,
            curves: Vec::new(),
            pictures: Vec::new(),
            build: String::new(),
        };
        let text = document(&TABLE_5_1, &result);
        let table: Vec<&str> = text.lines().filter(|line| line.starts_with('|')).collect();
        assert_eq!(table.len(), 4, "a head, a rule, two rows: {text}");
        for line in table {
            assert_eq!(line.replace("\\|", "").matches('|').count(), 7, "{line}");
        }
        assert!(text.contains("`sonarium reproduce table-5.1`"), "{text}");
    }
}
