//! Pictures as a whole: both back ends against each other, odd views, refused sizes.

use std::process::{Command, Stdio};
use std::sync::Once;

use super::laboratory::laboratory;
use super::scene::{Anchor, Colour, Primitive, Scene, Stroke, Text};
use super::*;
use crate::wire::ThemeName;

/// How two pictures differ.
#[derive(Debug)]
struct Difference {
    /// Mean over all channels of all pixels of what goes beyond rounding, of 255.
    mean: f64,
    /// Share of pixels with a channel off by more than 48 of 255.
    off: f64,
}

/// Blending in whole numbers may leave a flat area this far off, of 255.
const ROUNDING: u64 = 3;

/// Two pictures of the same scene may differ a little at the edges of shapes, no more.
const ALIKE: Difference = Difference { mean: 0.5, off: 0.0006 };

fn difference(a: &Pixels, b: &Pixels) -> Difference {
    assert_eq!((a.width, a.height, a.rgba.len()), (b.width, b.height, b.rgba.len()));
    let (mut sum, mut off) = (0_u64, 0_u64);
    for (a, b) in a.rgba.chunks_exact(4).zip(b.rgba.chunks_exact(4)) {
        let apart = |i: usize| u64::from(a[i].abs_diff(b[i]));
        sum += (0..3).map(|i| apart(i).saturating_sub(ROUNDING)).sum::<u64>();
        off += u64::from((0..4).map(apart).max() > Some(48));
    }
    let pixels = f64::from(a.width) * f64::from(a.height);
    Difference { mean: sum as f64 / (3.0 * pixels), off: off as f64 / pixels }
}

fn are_alike(found: &Difference) -> bool {
    found.mean <= ALIKE.mean && found.off <= ALIKE.off
}

/// The GPU back end on any adapter; a simulated one is fetched where there is none and this may.
/// Without any the caller compares nothing, and says so.
fn gpu_or_say_so(test: &str) -> Option<GpuBackend> {
    static FETCHED: Once = Once::new();
    FETCHED.call_once(|| {
        if !gpu_available() {
            fetch_simulated_adapter();
        }
    });
    match GpuBackend::open(AdapterChoice::Any) {
        Ok(gpu) => Some(gpu),
        Err(error) => {
            eprintln!("{test}: COMPARED NOTHING, {error}");
            None
        }
    }
}

/// Debian's simulated Vulkan adapter, through apt.
fn fetch_simulated_adapter() {
    let line = "apt-get update && apt-get install -y --no-install-recommends mesa-vulkan-drivers";
    eprintln!("No graphics adapter: fetching a simulated one with: {line}");
    // Where it may not install, the tests say that they compared nothing.
    let _ = Command::new("sh").args(["-c", line]).stdout(Stdio::null()).status();
}

/// One of every primitive, with translucent and awkward ones.
fn every_primitive(shift_px: f32) -> Scene {
    let mut scene = Scene::new(300, 200, Colour::rgb(0xf4f1ea));
    let (blue, red) = (Colour::rgb(0x2266cc), Colour::rgb(0xcc3311));
    scene.polygon(vec![[10.3, 10.0], [90.0, 14.5], [60.0, 40.0], [88.0, 80.2], [12.0, 70.0]], blue);
    scene.disc([130.5 + shift_px, 45.25], 28.0, red.fade(0.5));
    scene.disc([152.0, 45.0], 0.6, red);
    scene.ring([200.0, 45.0], 25.0, 3.0, blue);
    scene.arc([255.0, 20.0], [10.0, 40.0], [0.4, 1.9], red.fade(0.6));
    scene.arc([255.0, 140.0], [0.0, 30.0], [0.5, 4.5], blue.fade(0.6));
    let zigzag: Vec<[f32; 2]> =
        (0..40_u8).map(|i| [10.0 + 5.0 * f32::from(i), 110.0 + 16.0 * f32::from(i % 2)]).collect();
    scene.stroke(zigzag, 5.0, blue.fade(0.5));
    scene.stroke(vec![[10.0, 140.0], [210.0, 146.0]], 0.6, red);
    let wave =
        (0..90_u8).map(|i| [10.0 + 2.2 * f32::from(i), 160.0 + 8.0 * (f32::from(i) / 5.0).sin()]);
    scene.push(Primitive::Stroke(Stroke {
        points: wave.collect(),
        width: 3.0,
        colour: red,
        dash: Some([9.0, 7.0]),
        closed: false,
    }));
    scene.outline(vec![[215.0, 80.0], [235.0, 82.0], [225.0, 100.0]], 3.0, red.fade(0.5));
    scene.push(Primitive::Text(Text {
        at: [150.0, 192.0],
        text: "Trial 3, step 17: 0.5 m".into(),
        size: 15.0,
        anchor: Anchor::Middle,
        colour: Colour::rgb(0x111111),
        halo: Some((Colour::rgb(0xffee99), 2.0)),
    }));
    scene
}

#[test]
fn both_back_ends_draw_alike() {
    let Some(mut gpu) = gpu_or_say_so("both_back_ends_draw_alike") else { return };
    let mut cpu = CpuBackend::default();
    let view = laboratory(20, 130);
    let mut scenes = vec![every_primitive(0.0), Scene::new(1, 1, Colour::rgb(0x336699))];
    for theme in [ThemeName::Light, ThemeName::Dark] {
        // A row of 1000 pixels is no multiple of 256 bytes; one of 960 hides a padding mistake.
        for (width, height) in [(320, 213), (960, 640), (1000, 700), (513, 1024)] {
            scenes.push(arena_scene(&view, width, height, theme));
        }
    }
    for scene in &scenes {
        let on_gpu = gpu.draw(scene).expect("drawn by the adapter");
        let found = difference(&cpu.draw(scene).expect("drawn by the CPU"), &on_gpu);
        let size = (scene.width, scene.height);
        eprintln!("{size:?} on {}: {found:?}", gpu.name());
        assert!(are_alike(&found), "{size:?} on {}: {found:?} is beyond {ALIKE:?}", gpu.name());
    }
    let (moved, still) = (gpu.draw(&every_primitive(2.0)), cpu.draw(&every_primitive(0.0)));
    let found = difference(&moved.expect("drawn"), &still.expect("drawn"));
    assert!(!are_alike(&found), "a shape moved by 2 px goes unseen: {found:?}");
}

#[test]
fn the_comparison_sees_a_shape_moved_by_two_pixels() {
    let mut cpu = CpuBackend::default();
    let still = cpu.draw(&every_primitive(0.0)).expect("drawn");
    for (shift_px, alike) in [(0.0, true), (2.0, false)] {
        let found = difference(&still, &cpu.draw(&every_primitive(shift_px)).expect("drawn"));
        eprintln!("moved by {shift_px} px: {found:?}");
        assert_eq!(are_alike(&found), alike, "moved by {shift_px} px: {found:?}");
    }
}

#[test]
fn a_lost_device_is_reported_and_a_new_one_draws() {
    let Some(mut gpu) = gpu_or_say_so("a_lost_device_is_reported") else { return };
    let scene = every_primitive(0.0);
    gpu.draw(&scene).expect("drawn");
    gpu.lose();
    let lost = gpu.draw(&scene);
    assert!(matches!(lost, Err(RenderError::DeviceLost(_))), "{lost:?}");
    let mut anew = GpuBackend::open(AdapterChoice::Any).expect("opens anew");
    anew.draw(&scene).expect("drawn");
}

/// Views with nothing, with nonsense, and with far too much.
fn odd_views() -> Vec<(&'static str, ArenaView)> {
    let full = || laboratory(3, 12);
    let nan = f64::NAN;
    let mut blind = full();
    let mut lost = full();
    let mut huge = full();
    if let Some(robot) = &mut blind.robot {
        robot.sonar_m = vec![nan, -1.0, 0.0, f64::INFINITY, 1e300];
        robot.cone_rad = nan;
    }
    if let Some(robot) = &mut lost.robot {
        robot.pose = RobotPose { at_m: [nan, 1e300], heading_rad: nan };
        robot.believed = RobotPose { at_m: [f64::INFINITY; 2], heading_rad: f64::INFINITY };
        robot.radius_m = nan;
        robot.range_m = nan;
    }
    huge.earlier_paths_m = vec![huge.best_path_m.clone(); 500];
    huge.path_m = (0..50_000).map(|i| [f64::from(i) * 1e-4, (f64::from(i) * 0.01).sin()]).collect();
    let neuron = |utility| NeuronMark {
        at_m: [nan, 0.0],
        heading_rad: nan,
        region: 99,
        utility,
        winner: true,
    };
    vec![
        ("empty", ArenaView::default()),
        ("no bounds", ArenaView { bounds_m: [0.0; 4], ..full() }),
        ("bounds of NaN", ArenaView { bounds_m: [nan; 4], ..full() }),
        ("endless bounds", ArenaView { bounds_m: [-1e300, -1e300, 1e300, 1e300], ..full() }),
        ("a thread of bounds", ArenaView { bounds_m: [0.0, 0.0, 1e-12, 5.0], ..full() }),
        ("no walls", ArenaView { walls_m: vec![], blocks_m: vec![vec![]], ..full() }),
        ("walls of NaN", ArenaView { walls_m: vec![[nan; 4], [0.0, 0.0, nan, 1.0]], ..full() }),
        ("paths of NaN", ArenaView { path_m: vec![[nan; 2]; 9], ..full() }),
        ("endless goal", ArenaView { goal_radius_m: f64::INFINITY, goal_m: [1e300; 2], ..full() }),
        (
            "nonsense neurons",
            ArenaView { neurons: vec![neuron(None), neuron(Some(nan))], ..full() },
        ),
        ("blind robot", blind),
        ("lost robot", lost),
        ("huge", huge),
        ("long caption", ArenaView { caption: "漢字 long ".repeat(500), ..full() }),
    ]
}

#[test]
fn odd_views_give_pictures() {
    let renderer = Renderer::start(Backend::Cpu);
    for (name, view) in odd_views() {
        for (width, height) in [(1, 1), (1, 300), (300, 1), (40, 30), (320, 213), (700, 500)] {
            let theme = ThemeName::Dark;
            let picture =
                renderer.picture_blocking(view.clone(), width, height, theme, Quality::Fast);
            assert!(picture.is_ok(), "{name} at {width}×{height}: {picture:?}");
        }
    }
}

#[test]
fn sizes_that_cannot_be_drawn_are_refused_by_name() {
    let renderer = Renderer::start(Backend::Cpu);
    for (width, height, refusal) in [
        (0, 100, Some("width is 0 pixels; it must be 1 to 4096")),
        (100, 0, Some("height is 0 pixels; it must be 1 to 4096")),
        (4097, 100, Some("width is 4097 pixels; it must be 1 to 4096")),
        (100, u32::MAX, Some("height is 4294967295 pixels; it must be 1 to 4096")),
        (4096, 1, None),
    ] {
        let (view, theme) = (ArenaView::default(), ThemeName::Light);
        let answer = renderer.picture_blocking(view, width, height, theme, Quality::Fast);
        assert_eq!(answer.err().map(|error| error.to_string()).as_deref(), refusal);
    }
}

/// A maze of three metres with home and goal in its corners.
fn maze() -> ArenaView {
    let cell = |x: f64, y: f64| vec![[x, y], [x + 1.0, y], [x + 1.0, y + 1.0], [x, y + 1.0]];
    ArenaView {
        bounds_m: [0.0, 0.0, 3.0, 3.0],
        walls_m: vec![[0.0, 0.0, 3.0, 0.0], [0.0, 1.0, 2.0, 1.0], [1.0, 2.0, 3.0, 2.0]],
        blocks_m: vec![cell(1.0, 1.0)],
        regions: vec![RegionView { name: "start".into(), polygons_m: vec![cell(0.0, 0.0)] }],
        home: RobotPose { at_m: [0.0, 0.0], heading_rad: 1.0 },
        goal_m: [3.0, 3.0],
        goal_radius_m: 0.2,
        path_m: vec![[0.0, 0.0], [2.5, 0.5], [2.5, 1.5], [0.5, 1.5], [0.5, 2.5], [3.0, 3.0]],
        caption: "Episode 4 of 100".into(),
        ..ArenaView::default()
    }
}

/// A corridor in strips with nothing but the way of a run: its legend is narrow.
fn corridor() -> ArenaView {
    ArenaView {
        bounds_m: [0.0, -8.8, 13.3, 1.2],
        walls_m: vec![[0.0, 1.2, 13.3, 1.2]],
        home: RobotPose { at_m: [f64::NAN; 2], heading_rad: 0.0 },
        path_m: vec![[1.2, 0.0], [9.0, 0.2]],
        path_of: PathOf::Run,
        caption: "Run 1 by median-kalman".into(),
        ..ArenaView::default()
    }
}

#[test]
fn every_text_stands_inside_the_picture() {
    let sizes =
        [(320, 213), (420, 640), (640, 400), (960, 640), (1000, 700), (700, 1400), (4096, 4096)];
    for ((width, height), view) in sizes
        .iter()
        .flat_map(|&size| [(size, laboratory(500, 130)), (size, maze()), (size, corridor())])
    {
        let scene = arena_scene(&view, width, height, ThemeName::Light);
        for primitive in scene.primitives() {
            let Primitive::Text(text) = primitive else { continue };
            for [x, y] in text::outlines(text).into_iter().flatten().flatten() {
                let inside =
                    (0.0..=width as f32).contains(&x) && (0.0..=height as f32).contains(&y);
                assert!(inside, "{:?} reaches {x}, {y} at {width}×{height}", text.text);
            }
        }
    }
}

#[test]
fn what_is_not_there_is_not_named() {
    let no_goal = ArenaView { goal_radius_m: 0.0, ..maze() };
    let of_a_run = ArenaView { path_of: PathOf::Run, goal_radius_m: 0.0, ..maze() };
    let no_home = ArenaView {
        home: RobotPose { at_m: [f64::NAN; 2], heading_rad: 0.0 },
        regions: vec![],
        path_m: vec![],
        ..maze()
    };
    for (view, expected) in [
        (maze(), ["goal", "home", "start", "Episode 4 of 100", "0.5 m", "this trial"].as_slice()),
        (no_goal, &["home", "start", "Episode 4 of 100", "0.5 m", "this trial"]),
        (of_a_run, &["home", "start", "Episode 4 of 100", "0.5 m", "this run"]),
        (no_home, &["goal", "Episode 4 of 100", "0.5 m"]),
    ] {
        let scene = arena_scene(&view, 960, 640, ThemeName::Light);
        let found: Vec<String> = scene.primitives().iter().filter_map(text_of).collect();
        assert_eq!(found, expected);
    }
}

#[test]
fn many_earlier_trials_are_capped_and_the_legend_says_so() {
    let strokes = |ghosts: usize| {
        let scene = arena_scene(&laboratory(ghosts, 0), 960, 640, ThemeName::Light);
        let texts: Vec<String> = scene.primitives().iter().filter_map(text_of).collect();
        (scene.primitives().len(), texts)
    };
    let (few, named) = strokes(MOST_GHOSTS);
    let (many, counted) = strokes(500);
    assert_eq!(few, many);
    assert!(named.contains(&"earlier trials".to_owned()), "{named:?}");
    assert!(counted.contains(&"latest 40 of 500 earlier trials".to_owned()), "{counted:?}");
}

fn text_of(primitive: &Primitive) -> Option<String> {
    match primitive {
        Primitive::Text(text) => Some(text.text.clone()),
        _ => None,
    }
}

#[tokio::test]
async fn many_may_ask_at_once_and_get_equal_pictures() {
    let renderer = Renderer::start(Backend::Cpu);
    assert_eq!(renderer.backend_name(), "vello_cpu");
    let ask = || {
        let renderer = renderer.clone();
        async move {
            let view = laboratory(2, 10);
            renderer.picture(view, 200, 150, ThemeName::Light, Quality::Balanced).await
        }
    };
    let (first, second) = tokio::join!(ask(), ask());
    assert_eq!(first.expect("a picture"), second.expect("a picture"));
}

#[test]
fn back_ends_are_chosen_by_word() {
    for (word, expected) in [
        ("auto", Some(Backend::Auto)),
        ("", Some(Backend::Auto)),
        ("gpu", Some(Backend::Gpu)),
        (" gpu-any ", Some(Backend::GpuAny)),
        ("cpu", Some(Backend::Cpu)),
        ("fast", None),
    ] {
        assert_eq!(word.parse::<Backend>().ok(), expected, "{word:?}");
    }
}

#[test]
#[ignore = "writes pictures to look at, into the system's folder for temporary files"]
fn pictures_to_look_at() {
    for (backend, choice) in [("cpu", Backend::Cpu), ("gpu", Backend::GpuAny)] {
        let renderer = Renderer::start(choice);
        eprintln!("{}", renderer.backend_name());
        for theme in [ThemeName::Light, ThemeName::Dark] {
            for (width, height) in [(320, 213), (960, 640), (1000, 700), (700, 1000), (4096, 4096)]
            {
                let picture = renderer
                    .picture_blocking(laboratory(20, 130), width, height, theme, Quality::Fast)
                    .expect("a picture");
                let name =
                    format!("render-{theme:?}-{backend}-{width}x{height}.png").to_lowercase();
                std::fs::write(std::env::temp_dir().join(name), &picture).expect("written");
            }
            let picture = renderer.picture_blocking(maze(), 700, 480, theme, Quality::Fast);
            let name = format!("render-maze-{theme:?}-{backend}.png").to_lowercase();
            std::fs::write(std::env::temp_dir().join(name), picture.expect("a picture"))
                .expect("written");
        }
    }
}
