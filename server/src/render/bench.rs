//! How fast pictures are made: `sonarium bench render` prints what is measured here.

use super::laboratory::laboratory;
use super::scene::Scene;
use super::{AdapterChoice, CpuBackend, GpuBackend, Pixels, Quality, RenderError, arena, encode};
use crate::wire::ThemeName;
use std::time::Instant;

/// One measured quantity: the median of `runs` and its spread.
#[derive(Clone, Debug, PartialEq)]
pub struct Measurement {
    /// What was measured, e.g. `picture 960×640 fast`.
    pub name: String,
    /// Unit of the numbers.
    pub metric: &'static str,
    /// Median.
    pub value: f64,
    /// Least.
    pub min: f64,
    /// Greatest.
    pub max: f64,
    /// How often it was measured.
    pub runs: usize,
    /// Back end and what the picture showed.
    pub note: String,
}

const WIDTH_PX: u32 = 960;
const HEIGHT_PX: u32 = 640;
const RUNS: usize = 41;

/// Measures scene, drawing and encoding of a picture of 960×640 with 130 neurons, 20 earlier
/// trials and 24 sonar cones, on the CPU and on every kind of adapter there is.
pub fn bench() -> Vec<Measurement> {
    let view = laboratory(20, 130);
    let build = || arena::scene(&view, WIDTH_PX, HEIGHT_PX, ThemeName::Light);
    let mut rows = vec![timed("scene", "no back end", &mut || drop(build()))];
    let mut cpu = CpuBackend::default();
    rows.extend(backend_rows("vello_cpu", &build, &mut |scene| cpu.draw(scene)));
    if let Ok(mut gpu) = GpuBackend::open(AdapterChoice::Any) {
        rows.extend(backend_rows(&gpu.name(), &build, &mut |scene| gpu.draw(scene)));
    }
    rows
}

fn backend_rows(
    backend: &str,
    build: &dyn Fn() -> Scene,
    draw: &mut dyn FnMut(&Scene) -> Result<Pixels, RenderError>,
) -> Vec<Measurement> {
    let scene = build();
    // The first picture pays for pipelines and caches; without one there is nothing to measure.
    let Ok(pixels) = draw(&scene) else { return Vec::new() };
    let mut rows = vec![timed("drawing", backend, &mut || drop(draw(&scene)))];
    for (name, quality) in [("fast", Quality::Fast), ("balanced", Quality::Balanced)] {
        let encoding = &mut || drop(encode(&pixels, quality));
        rows.push(timed(&format!("PNG {name}"), backend, encoding));
        let whole = &mut || drop(draw(&build()).and_then(|pixels| encode(&pixels, quality)));
        let row = timed(&format!("picture {name}"), backend, whole);
        rows.push(per_second(&row));
        rows.push(row);
    }
    rows
}

fn timed(name: &str, backend: &str, work: &mut dyn FnMut()) -> Measurement {
    let mut times_ms: Vec<f64> = (0..RUNS)
        .map(|_| {
            let start = Instant::now();
            work();
            start.elapsed().as_secs_f64() * 1e3
        })
        .collect();
    times_ms.sort_by(f64::total_cmp);
    Measurement {
        name: format!("{name} {WIDTH_PX}×{HEIGHT_PX}"),
        metric: "ms",
        value: times_ms[RUNS / 2],
        min: times_ms[0],
        max: times_ms[RUNS - 1],
        runs: RUNS,
        note: format!("{backend}; 130 neurons, 20 earlier trials, 24 cones"),
    }
}

fn per_second(row: &Measurement) -> Measurement {
    Measurement {
        metric: "pictures/s",
        value: 1e3 / row.value,
        min: 1e3 / row.max,
        max: 1e3 / row.min,
        ..row.clone()
    }
}
