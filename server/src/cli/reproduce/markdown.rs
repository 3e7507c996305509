//! A result as Markdown, for documents that hold the table with the command that made it.

use std::collections::BTreeSet;

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

/// Those of the target, then one a quantity, whatever the arm; quantities that are read alike share theirs.
fn readings(target: &Target, rows: &[ReproductionRow]) -> Vec<String> {
    let mut seen = BTreeSet::new();
    let mut groups: Vec<(Vec<String>, &str)> = Vec::new();
    for row in rows {
        let (_, quantity) = row.name.rsplit_once(": ").unwrap_or(("", &row.name));
        let (_, reading) = row.reading.split_once(": ").unwrap_or(("", &row.reading));
        if !seen.insert(quantity) {
            continue;
        }
        let quantity = format!("*{}*", escaped(quantity));
        match groups.iter_mut().find(|(_, known)| *known == reading) {
            Some((quantities, _)) => quantities.push(quantity),
            None => groups.push((vec![quantity], reading)),
        }
    }
    let of_target = target.readings.iter().map(|reading| format!("- {}.\n", escaped(reading)));
    let of_rows = groups.iter().map(|(quantities, reading)| {
        format!("- {}: {}.\n", quantities.join(", "), escaped(reading))
    });
    of_target.chain(of_rows).collect()
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
    fn quantities_that_are_read_alike_share_a_line() {
        let alike =
            |name| ReproductionRow { reading: "arm: alike".into(), ..row(name, Verdict::Agrees) };
        let rows =
            [alike("a: one"), alike("b: one"), alike("a: two"), row("a: three", Verdict::Agrees)];
        let lines = readings(&Target { readings: &[], ..TABLE_5_1.clone() }, &rows);
        assert_eq!(lines[0], "- *one*, *two*: alike.\n");
        assert_eq!(lines.len(), 2, "{lines:?}");
    }

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
