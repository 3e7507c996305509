use png::{BitDepth, ColorType, Encoder};

use super::*;

const YAML: &str = "image: office.pgm\nresolution: 0.1\norigin: [-1.0, 2.0, 0.0]\nnegate: 0\n\
                    occupied_thresh: 0.65\nfree_thresh: 0.196\n";

/// The metadata with lines replaced or added.
fn metadata(changes: &[&str]) -> Metadata {
    Metadata::parse(&changed(changes)).expect("good metadata")
}

fn changed(changes: &[&str]) -> String {
    let key = |line: &str| line.split(':').next().unwrap_or_default().to_owned();
    let kept = YAML.lines().filter(|line| changes.iter().all(|change| key(change) != key(line)));
    kept.chain(changes.iter().copied()).map(|line| format!("{line}\n")).collect()
}

/// Cells as characters, the top row first.
fn cells(metadata: &Metadata, picture: &[u8]) -> String {
    let grid = read(metadata, picture).expect("a good map");
    let letter = |cell| match cell {
        Cell::Free => '.',
        Cell::Occupied => '#',
        Cell::Unknown => '?',
    };
    let row = |row| (0..grid.columns()).map(|column| letter(grid.cell(column, row))).collect();
    (0..grid.rows()).rev().map(row).collect::<Vec<String>>().join("/")
}

fn png(width: u32, height: u32, colour: ColorType, depth: BitDepth, data: &[u8]) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, width, height);
    encoder.set_color(colour);
    encoder.set_depth(depth);
    if colour == ColorType::Indexed {
        encoder.set_palette(vec![255, 255, 255, 0, 0, 0, 205, 205, 205]);
    }
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(data).expect("pixels");
    writer.finish().expect("an end");
    file
}

#[test]
fn the_metadata_are_read_and_defaults_are_few() {
    let read = metadata(&["negate: 1", "mode: raw", "extra: {a: 1}"]);
    assert_eq!(read.origin, [-1.0, 2.0, 0.0]);
    assert_eq!((read.negate, read.mode, read.image.as_str()), (true, Mode::Raw, "office.pgm"));
    assert_eq!(metadata(&[]).mode, Mode::Trinary);
    assert!(metadata(&["negate: true"]).negate);
    assert_eq!(metadata(&["resolution: 1"]).resolution_m, 1.0);
}

#[test]
fn wrong_metadata_are_refused_by_key() {
    for (change, field) in [
        ("resolution: 0", "yaml.resolution"),
        ("resolution: -0.05", "yaml.resolution"),
        ("resolution: .nan", "yaml.resolution"),
        ("resolution: fine", "yaml.resolution"),
        ("origin: [0, 0]", "yaml.origin"),
        ("origin: 0", "yaml.origin"),
        ("origin: [0, .inf, 0]", "yaml.origin"),
        ("negate: 2", "yaml.negate"),
        ("occupied_thresh: 1.5", "yaml.occupied_thresh"),
        ("free_thresh: -1", "yaml.free_thresh"),
        ("free_thresh: 0.7", "yaml.free_thresh"),
        ("mode: colourful", "yaml.mode"),
        ("image: 7", "yaml.image"),
        ("image: {}", "yaml.image"),
        ("resolution: [", "yaml"),
    ] {
        let error = Metadata::parse(&changed(&[change])).expect_err(change);
        assert_eq!(error.field, field, "{change}: {error}");
    }
    for key in ["image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh"] {
        let lines = YAML.lines().filter(|line| !line.starts_with(key));
        let error = Metadata::parse(&lines.collect::<Vec<_>>().join("\n")).expect_err(key);
        assert_eq!(error.field, format!("yaml.{key}"));
        assert!(error.message.contains("missing"), "{error}");
    }
    for text in ["just text", "", "- 1", &"- ".repeat(4000), &"[".repeat(4000), &"x".repeat(9000)] {
        assert_eq!(Metadata::parse(text).expect_err("no keys").field, "yaml");
    }
}

#[test]
fn pgm_files_are_read_in_all_their_forms() {
    let plain = metadata(&[]);
    let expected = ".#?/..#";
    for picture in [
        &b"P2\n# a comment\n3 2 # another\n255\n254 0 205\n255 230 10\n"[..],
        b"P5 3 2 255\n\xfe\x00\xcd\xff\xe6\x0a",
        b"P5\n#c\n3\n#c\n2\n255\n\xfe\x00\xcd\xff\xe6\x0a and what comes after",
        b"P2 3 2 100 100 0 80 100 90 4",
        b"P5 3 2 1000\n\x03\xe8\x00\x00\x03\x20\x03\xe8\x03\x84\x00\x0a",
        b"P2 3 2 65535 65535 0 52685 65535 60000 1000",
    ] {
        assert_eq!(cells(&plain, picture), expected, "{:?}", String::from_utf8_lossy(picture));
    }
}

#[test]
fn png_files_are_read_in_all_their_forms() {
    use BitDepth::{Eight, Four, Sixteen};
    use ColorType::{Grayscale, GrayscaleAlpha, Indexed, Rgb, Rgba};
    let plain = metadata(&[]);
    let rgb = [[255; 3], [0; 3], [205; 3]].concat();
    let rgba = [[255; 4], [0, 0, 0, 255], [205, 205, 205, 255]].concat();
    for (picture, expected) in [
        (png(3, 1, Grayscale, Eight, &[255, 0, 205]), ".#?"),
        (png(3, 1, Grayscale, Sixteen, &[255, 255, 0, 0, 205, 205]), ".#?"),
        (png(3, 1, Grayscale, Four, &[0xf0, 0xc0]), ".#?"),
        (png(3, 1, Rgb, Eight, &rgb), ".#?"),
        (png(3, 1, Indexed, Eight, &[0, 1, 2]), ".#?"),
        // The alpha counts as a colour: (3 · 205 + 255) / 4 is light enough to be free.
        (png(3, 1, Rgba, Eight, &rgba), ".#."),
        (png(3, 1, GrayscaleAlpha, Eight, &[255, 255, 0, 255, 205, 255]), ".#."),
        (png(1, 1, GrayscaleAlpha, Eight, &[255, 0]), "?"),
    ] {
        assert_eq!(cells(&plain, &picture), expected);
    }
}

#[test]
fn modes_and_negate_change_what_a_pixel_says() {
    let grey = b"P2 6 1 255 0 19 20 65 66 101";
    for (changes, expected) in [
        (&["mode: trinary"][..], "#####?"),
        (&["negate: 1"], "...???"),
        (&["mode: raw"], "..??#?"),
        (&["mode: scale"], "#####?"),
        (&["mode: scale", "negate: 1", "free_thresh: 0.3"], ".....?"),
    ] {
        assert_eq!(cells(&metadata(changes), grey), expected, "{changes:?}");
    }
    let alpha = png(2, 1, ColorType::GrayscaleAlpha, BitDepth::Eight, &[255, 255, 255, 254]);
    assert_eq!(cells(&metadata(&["mode: scale"]), &alpha), ".?");
    // A chance of exactly a threshold is neither.
    let edge = b"P2 2 1 255 204 204";
    assert_eq!(cells(&metadata(&["free_thresh: 0.2"]), edge), "??");
}

#[test]
fn a_picture_that_cannot_be_read_is_refused_with_the_place() {
    let good = png(3, 1, ColorType::Grayscale, BitDepth::Eight, &[255, 0, 205]);
    let mut large = good.clone();
    large[16..24].copy_from_slice(&[0, 0, 0x27, 0x10, 0, 0, 0x27, 0x10]);
    for (picture, expected) in [
        (&b""[..], "it is empty"),
        (b"GIF89a", "begins with \"GIF89a\""),
        (b"P6 1 1 255 abc", "not P6"),
        (b"P2", "ends before the width"),
        (b"P2 3 x", "the height of the PGM file must be a whole number, but byte 5"),
        (b"P2 3 2 0 1", "the greatest value of a PGM file must be 1 to 65535"),
        (b"P2 3 2 70000 1", "1 to 65535, not 70000"),
        (b"P2 2 1 255 1", "ends before pixel 2 of 2"),
        (
            b"P2 2 1 100 1 101",
            "the pixel in column 1 of row 0 is 101, above the greatest value 100",
        ),
        (b"P5 3 2 255\nabcde", "ends after 5 of 6 pixels"),
        (b"P5 3 2 256\nabcde", "ends after 2 of 6 pixels"),
        (b"P5 0 2 255\n", "at least one cell, not 0 x 2"),
        (b"P5 10000 10000 255\n", "10000 x 10000 cells, but at most 16000000"),
        (b"P5 4294967295 4294967295 255\n", "at most 16000000"),
        (b"P5 99999999999 1 255\n", "the width of the PGM file must be a whole number"),
        (&good[..good.len() - 20], "the PNG file cannot be read"),
        (&good[..20], "the PNG file cannot be read"),
    ] {
        let error = read(&metadata(&[]), picture).expect_err(expected);
        assert_eq!(error.field, "image");
        assert!(error.message.contains(expected), "{error}");
    }
    // The checksum of the changed header is wrong too, so either refusal is right; both come at once.
    assert!(read(&metadata(&[]), &large).is_err());
    let wide = png(5000, 5000, ColorType::Grayscale, BitDepth::One, &vec![0; 625 * 5000]);
    let error = read(&metadata(&[]), &wide).expect_err("too large");
    assert!(error.message.contains("5000 x 5000 cells"), "{error}");
}

#[test]
fn a_map_becomes_a_draft_that_can_be_used() {
    // A room of 4 x 3 m with a pillar, in cells of 0.1 m.
    let solid = |x: u32, y: u32| {
        x == 0 || y == 0 || x == 41 || y == 31 || ((20..23).contains(&x) && (14..17).contains(&y))
    };
    let pixels: Vec<String> =
        (0..32 * 42).map(|k| if solid(k % 42, k / 42) { "0" } else { "254" }.to_owned()).collect();
    let picture = format!("P2 42 32 255 {}", pixels.join(" "));
    let traced = trace(YAML, picture.as_bytes(), &Options::default()).expect("a good map");
    assert_eq!((traced.segments_before, traced.segments_after), (8, 8));
    assert_eq!(traced.world.floor[0][0], [-0.9, 2.1], "the lower left corner of the floor");
    let draft = traced.draft().expect("a picture");
    assert_eq!(draft.bounds_m, [-0.9, 2.1, 3.1, 5.1]);
    assert!((draft.free_area_m2 - 11.91).abs() < 1e-9, "{}", draft.free_area_m2);
    assert_eq!((draft.picture.width_px, draft.picture.height_px), (42, 32));
    assert_eq!((draft.picture.corner.x_m, draft.picture.corner.y_m), (-1.0, 2.0));
    let world = sonarium_core::world::WorldFile::from(draft.world);
    assert_eq!(world.name, "office");
    sonarium_core::world::World::new(&world, 0.265).expect("the suggestion can be used");

    let options = |speck_m2, crop_m| Options { speck_m2, crop_m, name: None };
    let speckless = trace(YAML, picture.as_bytes(), &options(0.1, None)).expect("a good map");
    assert_eq!((speckless.specks_dropped, speckless.segments_after), (1, 4));
    for (options, field) in [
        (options(-1.0, None), "speck_m2"),
        (options(0.0, Some([5.0, 5.0, 4.0, 6.0])), "crop"),
        (options(0.0, Some([50.0, 5.0, 60.0, 6.0])), "crop"),
        (options(0.0, Some([-1.0, 2.0, -0.9, 3.0])), "image"),
    ] {
        let error = trace(YAML, picture.as_bytes(), &options).expect_err(field);
        assert_eq!(error.field, field, "{error}");
    }
    let error = trace(YAML, b"P2 2 1 255 0 0", &Options::default()).expect_err("nowhere to be");
    assert!(error.field == "image" && error.message.contains("no free cell"), "{error}");
}

/// The real office map, which is not part of the project: in the folder that `SONARIUM_MAPS` names, or
/// in `shared/data/maps` beside the repository.
fn office() -> Option<(String, Vec<u8>)> {
    let beside = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/data/maps");
    let folder = std::env::var("SONARIUM_MAPS").unwrap_or_else(|_| beside.to_owned());
    let yaml = std::fs::read_to_string(format!("{folder}/willow-2010-02-18-0.10.yaml")).ok()?;
    let picture = format!("{folder}/{}", Metadata::parse(&yaml).ok()?.image);
    Some((yaml, std::fs::read(picture).ok()?))
}

#[test]
fn the_office_becomes_a_world_of_some_thousand_walls() {
    let Some((yaml, picture)) = office() else {
        eprintln!("skipped: there is no office map; name its folder in SONARIUM_MAPS");
        return;
    };
    let traced = trace(&yaml, &picture, &Options::default()).expect("a good map");
    assert_eq!((traced.grid.columns(), traced.grid.rows()), (566, 608));
    let (before, after) = (traced.segments_before, traced.segments_after);
    assert!((1_000..20_000).contains(&after) && 10 * after < 7 * before, "{before} {after}");
    sonarium_core::world::World::new(&traced.world, 0.265).expect("the suggestion can be used");
}
