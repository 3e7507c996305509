//! Curves as inline SVG: axes with round ticks and units, gaps where there is no value, marks below.

use maud::{Markup, html};

use super::number::fixed;

/// A chart of one or two series over one count, e.g. trials or steps.
pub(super) struct Chart<'a> {
    /// What is drawn.
    pub(super) title: &'a str,
    /// Unit of the values, empty for a pure number.
    pub(super) unit: &'a str,
    /// What is counted along x.
    pub(super) x_name: &'a str,
    /// The whole range along x.
    pub(super) x_range: [f64; 2],
    /// One or two series; the second is drawn dashed.
    pub(super) series: Vec<Series<'a>>,
    /// Events marked on the x axis.
    pub(super) marks: Option<Marks<'a>>,
    /// Zero belongs to the y axis even when no value is near it.
    pub(super) from_zero: bool,
}

/// Values over x; `None` leaves a gap.
pub(super) struct Series<'a> {
    /// Its name, for the legend.
    pub(super) name: &'a str,
    /// Points by rising x.
    pub(super) points: Vec<(f64, Option<f64>)>,
}

/// Places on the x axis where something happened, drawn as crosses.
pub(super) struct Marks<'a> {
    /// What happened.
    pub(super) name: &'a str,
    /// Where.
    pub(super) at: Vec<f64>,
}

/// Size of the drawing and of the plot in it, in the units of its view box.
///
/// It is small, so that the letters can still be read when it is scaled to the width of a phone.
const WIDTH: f64 = 420.0;
const HEIGHT: f64 = 224.0;
const LEFT: f64 = 46.0;
const RIGHT: f64 = 410.0;
const TOP: f64 = 10.0;
const BOTTOM: f64 = 178.0;

/// Dots are drawn on curves with few points only; more would merge into a band.
const MOST_DOTS: usize = 60;

impl Chart<'_> {
    /// The chart with its title and legend.
    pub(super) fn draw(&self) -> Markup {
        let x = Axis { ticks: count_ticks(self.x_range), range: self.x_range, ends: [LEFT, RIGHT] };
        let y = self.y_axis();
        html! {
            figure class="chart" {
                figcaption {
                    (self.title)
                    @if !self.unit.is_empty() { small { ", " (self.unit) } }
                }
                svg viewBox=(format!("0 0 {WIDTH} {HEIGHT}")) role="img" aria-label=(self.words()) {
                    (self.frame(&x, &y))
                    @for (index, series) in self.series.iter().enumerate() {
                        g class=(SERIES_CLASSES[index.min(1)]) { (series.draw(&x, &y)) }
                    }
                    @if let Some(marks) = &self.marks { (marks.draw(&x)) }
                }
                (self.legend())
            }
        }
    }

    fn y_axis(&self) -> Axis {
        let values = self.series.iter().flat_map(|series| &series.points);
        let values = values.filter_map(|(_, value)| value.filter(|value| value.is_finite()));
        let mut range = values.fold(None, |range: Option<[f64; 2]>, value| {
            Some(range.map_or([value, value], |[low, high]| [low.min(value), high.max(value)]))
        });
        if self.from_zero {
            range = range.map(|[low, high]| [low.min(0.0), high.max(0.0)]);
        }
        let ticks = round_ticks(range.unwrap_or([0.0, 1.0]), 4);
        let range = [ticks[0], ticks[ticks.len() - 1]];
        Axis { ticks, range, ends: [BOTTOM, TOP] }
    }

    fn frame(&self, x: &Axis, y: &Axis) -> Markup {
        let decimals = y.decimals();
        html! {
            @for tick in &y.ticks {
                line class="grid" x1=(LEFT) x2=(RIGHT) y1=(y.place(*tick)) y2=(y.place(*tick)) {}
                text x=(LEFT - 6.0) y=(y.place(*tick)) dy="0.35em" text-anchor="end" {
                    (fixed(*tick, decimals))
                }
            }
            line class="axis" x1=(LEFT) x2=(RIGHT) y1=(BOTTOM) y2=(BOTTOM) {}
            @for tick in &x.ticks {
                line class="axis" x1=(x.place(*tick)) x2=(x.place(*tick)) y1=(BOTTOM) y2=(BOTTOM + 4.0) {}
                text x=(x.place(*tick)) y=(BOTTOM + 19.0) text-anchor="middle" { (fixed(*tick, 0)) }
            }
            text x=((LEFT + RIGHT) / 2.0) y=(HEIGHT - 6.0) text-anchor="middle" { (self.x_name) }
        }
    }

    fn legend(&self) -> Markup {
        let marks = self.marks.as_ref().filter(|marks| !marks.at.is_empty());
        html! {
            @if self.series.len() > 1 || marks.is_some() {
                ul class="legend" {
                    @if self.series.len() > 1 {
                        @for (index, series) in self.series.iter().enumerate() {
                            li {
                                svg viewBox="0 0 26 12" aria-hidden="true" {
                                    g class=(SERIES_CLASSES[index.min(1)]) {
                                        path class="line" d="M1 6H25" {}
                                    }
                                }
                                (series.name)
                            }
                        }
                    }
                    @if let Some(marks) = marks {
                        li {
                            svg viewBox="0 0 26 12" aria-hidden="true" { (cross(13.0, 6.0)) }
                            (marks.name)
                        }
                    }
                }
            }
        }
    }

    /// The chart in words, for those who cannot see it.
    fn words(&self) -> String {
        let mut words = format!("{} over {}", self.title, self.x_name.to_lowercase());
        for series in &self.series {
            let known: Vec<f64> = series.points.iter().filter_map(|(_, value)| *value).collect();
            if let (Some(first), Some(last)) = (known.first(), known.last()) {
                let (first, last) = (fixed(*first, 2), fixed(*last, 2));
                words += &format!("; {}: from {first} to {last}", series.name);
            }
        }
        if let Some(marks) = self.marks.as_ref().filter(|marks| !marks.at.is_empty()) {
            words += &format!("; {}: {}", marks.name, marks.at.len());
        }
        words
    }
}

const SERIES_CLASSES: [&str; 2] = ["first", "second"];

impl Series<'_> {
    fn draw(&self, x: &Axis, y: &Axis) -> Markup {
        let place = |(at, value): (f64, f64)| (x.place(at), y.place(value));
        let runs: Vec<Vec<_>> =
            self.runs().into_iter().map(|run| run.into_iter().map(place).collect()).collect();
        let dots_everywhere = self.points.len() <= MOST_DOTS;
        html! {
            @for run in &runs {
                @if run.len() > 1 { path class="line" d=(path(run)) {} }
                @if dots_everywhere || run.len() == 1 {
                    @for (x, y) in run { circle cx=(x) cy=(y) r="2.5" {} }
                }
            }
        }
    }

    /// Runs of points without a gap.
    fn runs(&self) -> Vec<Vec<(f64, f64)>> {
        let known = |&(x, value): &(f64, Option<f64>)| value.map(|value| (x, value));
        self.points
            .split(|(_, value)| !value.is_some_and(f64::is_finite))
            .map(|run| run.iter().filter_map(known).collect::<Vec<_>>())
            .filter(|run| !run.is_empty())
            .collect()
    }
}

impl Marks<'_> {
    fn draw(&self, x: &Axis) -> Markup {
        html! { @for at in &self.at { (cross(x.place(*at), BOTTOM - 6.0)) } }
    }
}

/// A cross of the marks: its shape, not its colour, tells it from a point.
fn cross(x: f64, y: f64) -> Markup {
    let (left, right, top, bottom) = (x - 3.5, x + 3.5, y - 3.5, y + 3.5);
    let strokes = format!(
        "M{left:.1} {top:.1}L{right:.1} {bottom:.1}M{left:.1} {bottom:.1}L{right:.1} {top:.1}"
    );
    html! { path class="mark" d=(strokes) {} }
}

fn path(run: &[(f64, f64)]) -> String {
    let step = |(index, (x, y)): (usize, &(f64, f64))| {
        format!("{}{x} {y}", if index == 0 { 'M' } else { 'L' })
    };
    run.iter().enumerate().map(step).collect()
}

/// An axis: the values it shows and the ends of its line in the drawing.
struct Axis {
    ticks: Vec<f64>,
    range: [f64; 2],
    ends: [f64; 2],
}

impl Axis {
    /// Where a value stands, to a tenth.
    fn place(&self, value: f64) -> f64 {
        let [low, high] = self.range;
        let share = if high > low { (value - low) / (high - low) } else { 0.5 };
        let place = self.ends[0] + share * (self.ends[1] - self.ends[0]);
        (place * 10.0).round() / 10.0
    }

    /// Decimals that tell one tick from the next.
    fn decimals(&self) -> usize {
        let step = self.ticks.windows(2).map(|pair| pair[1] - pair[0]).next().unwrap_or(1.0);
        (0..6).find(|&decimals| step * 10f64.powi(decimals) >= 0.999).unwrap_or(6) as usize
    }
}

/// Ticks at 1, 2 or 5 times a power of ten, from below the range to above it; at least two.
fn round_ticks([low, high]: [f64; 2], intervals: u32) -> Vec<f64> {
    let span = if high > low { high - low } else { high.abs().max(1.0) * 0.2 };
    let step = round_step(span / f64::from(intervals));
    let first = (low / step + 1e-9).floor();
    let last = (high / step - 1e-9).ceil().max(first + 1.0);
    let count = (last - first).min(20.0) as usize;
    (0..=count).map(|index| (first + index as f64) * step).collect()
}

/// Whole ticks inside the range.
fn count_ticks([low, high]: [f64; 2]) -> Vec<f64> {
    let step = round_step((high - low).max(1.0) / 6.0).max(1.0);
    let first = (low / step).ceil() * step;
    let mut ticks = vec![low];
    let mut tick = first;
    while tick <= high {
        // The first trial is always named; a tick beside it would touch its number.
        if tick - low >= step * 0.6 {
            ticks.push(tick);
        }
        tick += step;
    }
    ticks
}

/// The least of 1, 2 and 5 times a power of ten that is not below `least`.
fn round_step(least: f64) -> f64 {
    let power = 10f64.powf(least.log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0];
    let step = steps.into_iter().find(|step| step * power >= least * 0.999_999);
    step.unwrap_or(10.0) * power
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart(values: &[Option<f64>]) -> String {
        let points: Vec<_> = (1..).map(f64::from).zip(values.iter().copied()).collect();
        let failed = points.iter().filter(|(_, value)| value.is_none()).map(|(x, _)| *x).collect();
        let chart = Chart {
            title: "Steps",
            unit: "control steps",
            x_name: "Trial",
            x_range: [1.0, values.len() as f64],
            series: vec![Series { name: "steps", points }],
            marks: Some(Marks { name: "goal not reached", at: failed }),
            from_zero: false,
        };
        chart.draw().into_string()
    }

    fn count(text: &str, what: &str) -> usize {
        text.matches(what).count()
    }

    #[test]
    fn ticks_are_round_and_hold_the_range() {
        assert_eq!(round_ticks([-30.1, -6.4], 4), [-40.0, -30.0, -20.0, -10.0, 0.0]);
        assert_eq!(round_ticks([27.0, 39.0], 4), [25.0, 30.0, 35.0, 40.0]);
        assert_eq!(round_ticks([0.0, 0.8], 4), [0.0, 0.2, 0.4, 0.6000000000000001, 0.8]);
        assert_eq!(round_ticks([5.0, 5.0], 4), [5.0, 5.5]);
        assert_eq!(count_ticks([1.0, 20.0]), [1.0, 5.0, 10.0, 15.0, 20.0]);
        assert_eq!(count_ticks([1.0, 1.0]), [1.0]);
        assert_eq!(count_ticks([1.0, 3.0]), [1.0, 2.0, 3.0]);
    }

    #[test]
    fn a_failed_trial_leaves_a_gap_and_a_cross() {
        let whole = chart(&[Some(39.0), Some(35.0), Some(30.0), Some(29.0)]);
        assert_eq!(count(&whole, "class=\"line\""), 1);
        assert_eq!(count(&whole, "class=\"mark\""), 0);
        let gap = chart(&[Some(39.0), Some(35.0), None, Some(30.0), Some(29.0)]);
        assert_eq!(count(&gap, "class=\"line\""), 2, "the line is cut at the gap");
        assert_eq!(count(&gap, "<circle"), 4);
        assert_eq!(count(&gap, "class=\"mark\""), 2, "on the axis and in the legend");
        assert!(gap.contains("goal not reached: 1"));
    }

    #[test]
    fn a_chart_stands_on_any_values() {
        let table: [&[Option<f64>]; 5] = [
            &[],
            &[None],
            &[Some(3.0)],
            &[Some(f64::NAN), Some(1.0)],
            &[Some(1e300), Some(-1e300)],
        ];
        for values in table {
            let svg = chart(values);
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{values:?}: {svg}");
        }
    }
}
