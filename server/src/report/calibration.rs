//! The report of a calibration of ς: page, JSON, CSV and Markdown.

use maud::{Markup, html};
use serde::Serialize;

use super::csv::line;
use super::number::fixed;
use super::page::{Heading, KeyNumber, facts, key_numbers, number, numbers, page, table, words};
use super::{FORMAT_VERSION, json::pretty};
use crate::wire::{CalibrationPlace, CalibrationView, IntervalView};

/// The calibration as one HTML file that needs nothing else.
#[must_use]
pub fn calibration_html(view: &CalibrationView) -> String {
    let title = "Calibration of a sonar";
    let asked = &view.asked;
    let key = |name, value, note: String| KeyNumber { name, value, note };
    let deviation = &view.deviation_m;
    let body = html! {
        header {
            h1 { (title) }
            p class="lead" { "Deviation ς of a reading, Eq. (2.8), section 2.4" }
            (facts(&[
                ("Noise level", html! { (noise(view)) }),
                ("Pairs a place", html! { (asked.pairs) }),
                ("Factor k", html! { (asked.factor) }),
                ("Seed", html! { (asked.seed) }),
                ("Build", html! { code { (view.build) } }),
            ]))
        }
        section {
            h2 { "Result" }
            (key_numbers(&[
                key("ς", format!("{} m", fixed(deviation.value, 3)), format!("95 % interval {}", ends(deviation, 3))),
                key("Root mean square", format!("{} m", fixed(view.all.rms_m, 3)), format!("of {} pairs", view.all.n)),
            ]))
        }
        section { h2 { "Place by place" } (places(view)) }
        section {
            h2 { "In a run" }
            pre { code { "sonarium run corridor" (sets(view)) } }
            p class="note" {
                "One sonar alone stood still, so there was no crosstalk; what driving and firing all sonars add is "
                "what k > 1 stands for. Truth is the nearest surface in the cone."
            }
        }
        section { h2 { "Again" } pre { code { (calibration_command(view)) } } }
    };
    page(title, body)
}

fn places(view: &CalibrationView) -> Markup {
    const HEADINGS: [Heading; 5] = [
        words("Place"),
        numbers("Pairs", "n"),
        numbers("Mean square", "m²"),
        numbers("95 % interval", "m²"),
        numbers("Root mean square", "m"),
    ];
    let rows = html! {
        @for place in view.places.iter().chain([&view.all]) {
            tr {
                th scope="row" { (place.place) }
                (number(place.n.to_string()))
                (number(fixed(place.mean_square.value, 4)))
                (number(ends(&place.mean_square, 4)))
                (number(fixed(place.rms_m, 3)))
            }
        }
    };
    table("places", "Square of the true distance less the measured one", &HEADINGS, rows)
}

fn ends(of: &IntervalView, decimals: usize) -> String {
    format!("{} to {}", fixed(of.low, decimals), fixed(of.high, decimals))
}

fn noise(view: &CalibrationView) -> String {
    if view.asked.ideal { "ideal sonar".to_owned() } else { format!("×{}", view.asked.noise) }
}

/// The settings that carry the value into a run, as the command line takes them.
fn sets(view: &CalibrationView) -> String {
    let set = |setting: &crate::wire::CalibratedSetting| {
        format!(" --set {}={}", setting.key, setting.value)
    };
    view.settings.iter().map(set).collect()
}

/// The command line that gives the same numbers on the same build.
fn calibration_command(view: &CalibrationView) -> String {
    let asked = &view.asked;
    let noise = if asked.ideal { "--ideal".to_owned() } else { format!("--noise {}", asked.noise) };
    format!(
        "sonarium calibrate {noise} --pairs {} --factor {} --seed {}",
        asked.pairs, asked.factor, asked.seed
    )
}

/// The calibration as CSV: one row a place, then all together, then what k makes of it.
#[must_use]
pub fn calibration_csv(view: &CalibrationView) -> String {
    let header = ["place", "n", "mean_square_m2", "low_m2", "high_m2", "rms_m"];
    let mut text = line(&header.map(str::to_owned));
    for place in view.places.iter().chain([&view.all]) {
        text += &line(&cells(place));
    }
    let [factor, deviation] = [view.asked.factor, view.deviation_m.value];
    let with_factor = |value: f64| (value * factor).to_string();
    let of = &view.all.mean_square;
    text += &line(&[
        format!("all, with k = {factor}"),
        view.all.n.to_string(),
        with_factor(of.value),
        with_factor(of.low),
        with_factor(of.high),
        deviation.to_string(),
    ]);
    text
}

fn cells(place: &CalibrationPlace) -> [String; 6] {
    let of = &place.mean_square;
    [
        place.place.clone(),
        place.n.to_string(),
        of.value.to_string(),
        of.low.to_string(),
        of.high.to_string(),
        place.rms_m.to_string(),
    ]
}

/// The calibration as JSON: what was asked and everything it came to.
#[must_use]
pub fn calibration_json(view: &CalibrationView) -> String {
    #[derive(Serialize)]
    struct File<'a> {
        format_version: u32,
        #[serde(flatten)]
        view: &'a CalibrationView,
    }
    pretty(&File { format_version: FORMAT_VERSION, view })
}

/// The calibration as a table in Markdown, with the command that made it.
#[must_use]
pub fn calibration_markdown(view: &CalibrationView) -> String {
    let mut text = String::from("### Deviation ς of a sonar, Eq. (2.8)\n\n");
    text += &format!("`{}`\n\n", calibration_command(view));
    text += "| place | n | mean square (m²) | 95 % interval | rms (m) |\n|---|--:|--:|--:|--:|\n";
    for place in view.places.iter().chain([&view.all]) {
        let of = &place.mean_square;
        text += &format!(
            "| {} | {} | {:.4} | {:.4} to {:.4} | {:.3} |\n",
            place.place, place.n, of.value, of.low, of.high, place.rms_m
        );
    }
    let of = &view.deviation_m;
    text += &format!(
        "\nς = {:.3} m ({:.3} to {:.3}) with k = {}; in a run:`{}`.\n",
        of.value,
        of.low,
        of.high,
        view.asked.factor,
        sets(view)
    );
    text
}

/// The calibration as a table for a terminal.
#[must_use]
pub fn calibration_text(view: &CalibrationView) -> String {
    let mut text = format!("{}, build {}\n", calibration_command(view), view.build);
    text += "place           n  mean square (m²)     95 % interval  rms (m)\n";
    for place in view.places.iter().chain([&view.all]) {
        let of = &place.mean_square;
        let ends = format!("{:.4} to {:.4}", of.low, of.high);
        text += &format!(
            "{:<9} {:>7}  {:>16.4}  {ends:>16}  {:>7.3}\n",
            place.place, place.n, of.value, place.rms_m
        );
    }
    let of = &view.deviation_m;
    text += &format!(
        "ς = {:.3} m ({:.3} to {:.3}) with k = {}\n",
        of.value, of.low, of.high, view.asked.factor
    );
    text + "in a run:" + &sets(view)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::calibration::calibrate;
    use crate::catalog::Catalog;
    use crate::wire::CalibrationQuestion;

    fn view() -> CalibrationView {
        let catalog = Catalog::load(None).expect("the embedded files");
        let asked = CalibrationQuestion { pairs: 20, ..CalibrationQuestion::default() };
        calibrate(catalog.equipment().expect("the TRC is equipped"), asked).expect("acceptable")
    }

    #[test]
    fn every_form_says_the_deviation_and_how_to_drive_with_it() {
        let view = view();
        let digits = format!("{:.3}", view.deviation_m.value);
        let set = format!("--set fusion.sonar_deviation={digits} --set noise.level=1");
        for text in [calibration_html(&view), calibration_markdown(&view), calibration_text(&view)]
        {
            assert!(text.contains(&set), "{text}");
            for place in ["wall", "corner", "corridor", "door edge", "free way"] {
                assert!(text.contains(place), "{place}: {text}");
            }
        }
        let read: serde_json::Value = serde_json::from_str(&calibration_json(&view)).expect("JSON");
        assert_eq!(read["deviation_m"]["value"], view.deviation_m.value);
    }

    #[test]
    fn the_csv_has_a_row_a_place_and_one_with_k() {
        let text = calibration_csv(&view());
        let rows: Vec<&str> = text.lines().collect();
        assert_eq!(rows.len(), 1 + 5 + 2);
        assert!(rows[7].starts_with("\"all, with k = 1.5\",100,"), "{}", rows[7]);
        let numbers: Vec<f64> =
            rows[7].rsplit(',').take(4).map(|cell| cell.parse().expect("a number")).collect();
        assert!((numbers[0].powi(2) - numbers[3]).abs() < 1e-12, "ς² is k times the mean square");
    }
}
