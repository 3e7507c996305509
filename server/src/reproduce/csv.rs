//! Rows and curves for spreadsheets: RFC 4180; a cell without a value is empty.

use crate::report::csv_line;
use crate::wire::{ReproductionCurve, ReproductionRow};

/// One line a row.
#[must_use]
pub fn rows_csv(rows: &[ReproductionRow]) -> String {
    let header =
        ["name", "published", "required", "ours", "low", "high", "n", "unit", "verdict", "reading"];
    let mut text = csv_line(&header.map(String::from));
    for row in rows {
        text += &csv_line(&[
            row.name.clone(),
            optional(row.published),
            row.required.clone().unwrap_or_default(),
            row.ours.to_string(),
            row.low.to_string(),
            row.high.to_string(),
            row.n.to_string(),
            row.unit.clone(),
            row.verdict.word().to_owned(),
            row.reading.clone(),
        ]);
    }
    text
}

/// One line a point.
#[must_use]
pub fn curves_csv(curves: &[ReproductionCurve]) -> String {
    let header = ["arm", "quantity", "unit", "x", "mean", "low", "high", "least", "greatest", "n"];
    let mut text = csv_line(&header.map(String::from));
    for curve in curves {
        for point in &curve.points {
            text += &csv_line(&[
                curve.arm.clone(),
                curve.quantity.clone(),
                curve.unit.clone(),
                point.x.to_string(),
                optional(point.mean),
                optional(point.low),
                optional(point.high),
                optional(point.least),
                optional(point.greatest),
                point.n.to_string(),
            ]);
        }
    }
    text
}

fn optional(value: Option<f64>) -> String {
    value.map(|value| value.to_string()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wire::{ReproductionPoint, Verdict};

    #[test]
    fn a_reading_with_commas_and_quotes_stays_one_cell() {
        let row = ReproductionRow {
            name: "default: steps".into(),
            published: None,
            required: None,
            ours: 27.5,
            low: 27.0,
            high: 28.0,
            n: 200,
            unit: String::new(),
            verdict: Verdict::CannotTell,
            reading: "read as \"few\", or so".into(),
        };
        let text = rows_csv(&[row]);
        let line = text.lines().nth(1).expect("a row");
        assert_eq!(
            line,
            "default: steps,,,27.5,27,28,200,,cannot tell,\"read as \"\"few\"\", or so\""
        );
    }

    #[test]
    fn a_gap_in_a_curve_is_an_empty_cell() {
        let point = ReproductionPoint {
            x: 1.0,
            mean: None,
            low: None,
            high: None,
            least: None,
            greatest: None,
            n: 0,
        };
        let curve = ReproductionCurve {
            arm: "default".into(),
            quantity: "number of steps".into(),
            unit: String::new(),
            x_name: "trial".into(),
            band: String::new(),
            bars: String::new(),
            points: vec![point],
        };
        assert_eq!(curves_csv(&[curve]).lines().nth(1), Some("default,number of steps,,1,,,,,,0"));
    }
}
