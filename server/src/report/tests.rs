//! Facts about the files as a whole; what concerns one module stands in it.

use std::io::{self, Cursor, Read};

use serde_json::Value;

use super::*;

const HOSTILE: &str = "<script>alert(\"1\")</script>&'</title><img src=x onerror=y>";

/// Elements of HTML without content and without an end tag.
const VOID: [&str; 4] = ["meta", "img", "br", "hr"];

/// Checks that every element is closed in its order; answers the tags in the order they open.
fn open_tags(html: &str) -> Vec<String> {
    let style = html.find("<style>").zip(html.find("</style>"));
    let (start, end) = style.expect("every page has its style");
    let html = format!("{}{}", &html[..start], &html[end + "</style>".len()..]);
    let (mut open, mut seen) = (Vec::new(), Vec::new());
    for piece in html.split('<').skip(1) {
        let (tag, _) = piece.split_once('>').expect("a tag that ends");
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop().as_deref(), Some(name), "{name} closes what is open");
        } else if !tag.starts_with('!') {
            let name = tag.split_whitespace().next().expect("a tag with a name");
            seen.push(name.to_owned());
            if !VOID.contains(&name) {
                open.push(name.to_owned());
            }
        }
    }
    assert!(open.is_empty(), "left open: {open:?}");
    seen
}

fn count(tags: &[String], name: &str) -> usize {
    tags.iter().filter(|tag| *tag == name).count()
}

/// Cells of a CSV text without quoted cells.
fn cells(csv: &str) -> Vec<Vec<&str>> {
    csv.trim_end().split("\r\n").map(|line| line.split(',').collect()).collect()
}

fn column<'a>(table: &'a [Vec<&'a str>], name: &str) -> Vec<&'a str> {
    let index = table[0].iter().position(|cell| *cell == name);
    let index = index.unwrap_or_else(|| panic!("no column {name}"));
    table[1..].iter().map(|row| row[index]).collect()
}

/// A column of numbers and where they come from.
type Column<Row> = (&'static str, fn(&Row) -> f64);

fn bits(cells: &[&str]) -> Vec<u64> {
    cells.iter().map(|cell| cell.parse::<f64>().expect("a number").to_bits()).collect()
}

#[test]
fn the_session_page_is_whole_and_has_its_parts() {
    let page = html(&sample::session_report());
    let tags = open_tags(&page);
    assert!(page.starts_with("<!DOCTYPE html><html lang=\"en\">"));
    assert_eq!(count(&tags, "title"), 1);
    assert_eq!(count(&tags, "h1"), 1);
    assert_eq!(count(&tags, "img"), 2);
    assert_eq!(count(&tags, "figure"), 2 + 3, "two pictures and three curves");
    assert_eq!(count(&tags, "table"), count(&tags, "caption"));
    assert_eq!(count(&tags, "table"), count(&tags, "thead"));
    for text in ["One run, n = 1, no interval", "Differences from the thesis", "not reached"] {
        assert!(page.contains(text), "{text}");
    }
}

#[test]
fn the_trial_page_is_whole_and_has_its_parts() {
    let report = sample_trial::trial_report();
    let page = trial_html(&report);
    let tags = open_tags(&page);
    assert_eq!(count(&tags, "h1"), 1);
    assert_eq!(count(&tags, "figure"), 1 + 2, "the path and two charts");
    assert_eq!(count(&tags, "table"), count(&tags, "caption"));
    assert_eq!(page.matches("class=\"steps\"").count(), 1);
    for text in ["Eq. 5.6", "Eq. 5.7", "Eq. 5.26", "Eq. 5.28", "addition A1", "virtual collision"] {
        assert!(page.contains(text), "{text}");
    }
}

#[test]
fn the_trial_page_tells_where_shortcuts_bend_and_what_came_of_them() {
    let page = trial_html(&sample_trial::trial_report());
    assert_eq!(page.matches("<td>4.16, −0.75</td>").count(), 1, "one way bends");
    let (_, verdicts) = page.split_once("class=\"verdicts\"").expect("a table of verdicts");
    let (verdicts, _) = verdicts.split_once("</table>").expect("its end");
    let told: Vec<&str> = verdicts.split("<tr>").skip(2).collect();
    for (row, (neuron, delta, came)) in told.iter().zip([
        (">66<", ">−0.214<", ">withdrawn<"),
        (">71<", ">–<", ">withdrawn<"),
        (">75<", ">0.087<", ">kept<"),
    ]) {
        assert!([neuron, delta, came].iter().all(|text| row.contains(text)), "{row}");
    }
    assert_eq!(told.len(), 3);
}

#[test]
fn pages_need_nothing_from_elsewhere_and_run_nothing() {
    let pages = [html(&sample::session_report()), trial_html(&sample_trial::trial_report())];
    for page in pages {
        for word in ["http", "//", "<script", "<link", "url(", "@import", "onload"] {
            let pictures_out = page
                .split("base64,")
                .map(|piece| piece.split_once('"').map_or(piece, |(_, rest)| rest));
            assert!(pictures_out.clone().skip(1).all(|piece| !piece.contains(word)), "{word}");
            assert!(!page[..page.find("base64,").unwrap_or(page.len())].contains(word), "{word}");
        }
    }
}

#[test]
fn hostile_words_stay_words() {
    let mut report = sample::session_report();
    report.title = HOSTILE.into();
    report.session.id = HOSTILE.into();
    report.session.experiment = HOSTILE.into();
    report.session.build = HOSTILE.into();
    report.session.reason = Some(HOSTILE.into());
    report.session.settings.insert(HOSTILE.into(), HOSTILE.into());
    report.preset.title = HOSTILE.into();
    report.preset.settings.insert(HOSTILE.into(), HOSTILE.into());
    report.world.title = HOSTILE.into();
    report.settings[2].meaning = HOSTILE.into();
    report.settings[2].standing = "reading".into();
    report.settings[2].unit = HOSTILE.into();
    report.pictures[0].alt = HOSTILE.into();
    report.pictures[0].caption = HOSTILE.into();
    report.events[0].text = HOSTILE.into();
    report.build = HOSTILE.into();
    let page = html(&report);
    assert!(!page.contains("<script") && !page.contains("<img src=x"));
    assert_eq!(count(&open_tags(&page), "img"), 2);
    assert!(page.contains("&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt;&amp;"));

    let mut report = sample_trial::trial_report();
    report.title = HOSTILE.into();
    report.ticks[0].region = HOSTILE.into();
    report.ticks[0].source = HOSTILE.into();
    report.end.trial.region_steps.insert(HOSTILE.into(), 1);
    let page = trial_html(&report);
    assert!(!page.contains("<script") && !page.contains("<img src=x"));
    assert_eq!(count(&open_tags(&page), "img"), 1);
}

#[test]
fn the_curves_leave_the_failed_trial_out() {
    let page = html(&sample::session_report());
    let svgs: Vec<&str> = page.split("<svg ").filter(|svg| svg.contains("role=\"img\"")).collect();
    let lines: Vec<usize> = svgs.iter().map(|svg| svg.matches("class=\"line\"").count()).collect();
    let marks: Vec<usize> = svgs.iter().map(|svg| svg.matches("class=\"mark\"").count()).collect();
    // Trial 1 stands alone before the gap: it is a dot, not a line.
    let dots: Vec<usize> = svgs.iter().map(|svg| svg.matches("<circle").count()).collect();
    // Neurons are defined for a failed trial, steps and R are not; both have the planner's line as well.
    assert_eq!(dots, [20, 19 + 2, 19 + 2]);
    assert_eq!(lines, [1, 2, 2]);
    assert_eq!(marks, [1, 1, 1]);
}

#[test]
fn a_session_without_trials_still_has_its_report() {
    let mut report = sample::session_report();
    report.trials.clear();
    report.pictures.clear();
    report.events.clear();
    report.session.settings.clear();
    let page = html(&report);
    open_tags(&page);
    assert!(page.contains("No trial has ended yet"));
    assert_eq!(csv(&report).lines().count(), 1);
    let mut trial = sample_trial::trial_report();
    trial.ticks.clear();
    trial.picture = None;
    open_tags(&trial_html(&trial));
    assert_eq!(trial_csv(&trial).lines().count(), 1);
}

#[test]
fn trials_csv_reads_back_to_the_same_bits() {
    let report = sample::session_report();
    let text = csv(&report);
    let table = cells(&text);
    assert_eq!(table.len(), 1 + 20);
    assert!(table.iter().all(|row| row.len() == 18 + 4), "18 columns and 4 regions");
    let columns: [Column<Trial>; 5] = [
        ("temperature_deg", |t| t.temperature_deg),
        ("total_reinforcement", |t| t.total_reinforcement),
        ("safety", |t| t.safety),
        ("goal", |t| t.goal),
        ("path_m", |t| t.path_m),
    ];
    for (name, value) in columns {
        let written: Vec<u64> = report.trials.iter().map(|t| value(t).to_bits()).collect();
        assert_eq!(bits(&column(&table, name)), written, "{name}");
    }
    assert_eq!(column(&table, "reached_goal")[1], "false");
    assert_eq!(column(&table, "steps_in_corridor")[0], "8");
    assert_eq!(column(&table, "steps_in_door")[0], "0");
    assert_eq!((column(&table, "scout")[7], column(&table, "scout")[8]), ("false", "true"));
}

#[test]
fn trial_csv_reads_back_to_the_same_bits() {
    let report = sample_trial::trial_report();
    let text = trial_csv(&report);
    let table = cells(&text);
    assert_eq!(table.len(), 1 + 29);
    assert!(table.iter().all(|row| row.len() == table[0].len()));
    let columns: [Column<TickView>; 8] = [
        ("x_m", |t| t.pose.x_m),
        ("true_heading_deg", |t| t.true_pose.heading_deg),
        ("prototypical_deg", |t| t.prototypical_deg),
        ("action_deg", |t| t.action_deg),
        ("goal", |t| t.outcome.goal),
        ("reinforcement", |t| t.outcome.reinforcement),
        ("total_reinforcement", |t| t.total_reinforcement),
        ("sonar_23_m", |t| t.sonar_m[23]),
    ];
    for (name, value) in columns {
        let written: Vec<u64> = report.ticks.iter().map(|t| value(t).to_bits()).collect();
        assert_eq!(bits(&column(&table, name)), written, "{name}");
    }
    assert_eq!(column(&table, "delta")[0], "", "no past, no error");
    assert_eq!(column(&table, "adaptation")[3], "pending");
}

#[test]
fn csv_quotes_what_rfc_4180_says() {
    let mut report = sample_trial::trial_report();
    report.ticks.truncate(1);
    report.ticks[0].region = "a \"b\", c\r\nd".into();
    assert!(trial_csv(&report).contains(",\"a \"\"b\"\", c\r\nd\","));
}

#[test]
fn session_json_starts_with_the_contract_and_keeps_all_bits() {
    let report = sample::session_report();
    let text = json(&report);
    let places: Vec<usize> =
        ["experiment", "seed", "build", "settings", "trials", "summary", "differences"]
            .iter()
            .map(|key| text.find(&format!("\n  \"{key}\":")).expect("a top-level key"))
            .collect();
    assert!(places.is_sorted() && text.starts_with("{\n  \"experiment\""));
    let read: crate::wire::RunResult = serde_json::from_str(&text).expect("a run's result");
    assert_eq!(read.trials, report.trials);
    assert_eq!(read.settings, report.session.settings);
    let value: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(value["format_version"], FORMAT_VERSION);
    assert_eq!(value["events"].as_array().map(Vec::len), Some(4));
    assert_eq!(value["settings_info"].as_array().map(Vec::len), Some(10));
    assert_eq!(value["differences"]["additions"][0]["key"], "shortcut.push");
}

#[test]
fn trial_json_holds_the_record_all_ticks_and_the_end() {
    let report = sample_trial::trial_report();
    let value: Value = serde_json::from_str(&trial_json(&report)).expect("JSON");
    let ticks: Vec<TickView> = serde_json::from_value(value["ticks"].clone()).expect("ticks");
    let end: TrialEndView = serde_json::from_value(value["end"].clone()).expect("the end");
    assert_eq!(ticks, report.ticks);
    assert_eq!(end, report.end);
    assert_eq!(value["trial"]["trial"], 4);
}

fn archive(report: &SessionReport) -> ::zip::ZipArchive<Cursor<Vec<u8>>> {
    // Trial 2 is lost; every other one is answered with the ticks of the sample.
    let trial = |number: u32| Ok((number != 2).then(sample_trial::trial_report));
    let mut log: &[u8] = b"log";
    let bytes = zip(report, trial, Some(&mut log), Cursor::new(Vec::new())).expect("an archive");
    ::zip::ZipArchive::new(bytes).expect("an archive that opens")
}

fn entry(archive: &mut ::zip::ZipArchive<Cursor<Vec<u8>>>, name: &str) -> Vec<u8> {
    let mut bytes = Vec::new();
    archive.by_name(name).expect(name).read_to_end(&mut bytes).expect(name);
    bytes
}

fn names(archive: &::zip::ZipArchive<Cursor<Vec<u8>>>) -> Vec<String> {
    archive.file_names().map(|name| name.expect("a readable name").into_owned()).collect()
}

#[test]
fn the_zip_holds_what_its_readme_says() {
    let report = sample::session_report();
    let mut archive = archive(&report);
    let readme = String::from_utf8(entry(&mut archive, "README.txt")).expect("text");
    let files = readme.split_once("\nFiles\n").expect("a list of files").1;
    let listed = files.lines().take_while(|line| line.starts_with("  "));
    for line in listed.clone() {
        let name = line.split_whitespace().next().expect("a name").replace("NNN", "003");
        assert!(names(&archive).contains(&name), "{name}");
    }
    assert_eq!(listed.count(), 5 + 2 + 4, "single files, pictures, kinds of trial files");
    assert_eq!(archive.len(), 5 + 2 + 19 * 4);
    assert!(readme.contains("no longer holds the ticks of trials 2."));
    assert!(readme.contains("sonarium run minimum-cost-path --seed 7"));
    assert_eq!(entry(&mut archive, "report.html"), html(&report).into_bytes());
    assert_eq!(entry(&mut archive, "pictures/01-trial-001.png"), report.pictures[0].png);
    assert_eq!(entry(&mut archive, "log.mcap"), b"log");
}

#[test]
fn a_name_cannot_leave_the_archive() {
    let mut report = sample::session_report();
    report.pictures[0].name = "../../etc/passwd".into();
    let archive = archive(&report);
    assert!(names(&archive).iter().all(|name| !name.contains("..")));
}

#[test]
fn an_archive_says_which_trial_could_not_be_read() {
    let fail =
        |number| if number == 3 { Err(io::Error::other("chunk 9 is torn")) } else { Ok(None) };
    let result = zip(&sample::session_report(), fail, None, Cursor::new(Vec::new()));
    let message = result.expect_err("trial 3 fails").to_string();
    assert_eq!(message, "trial 3 could not be read for the archive: chunk 9 is torn");
}

#[test]
fn the_same_session_gives_the_same_bytes() {
    let report = sample::session_report();
    assert_eq!(
        archive(&report).into_inner().into_inner(),
        archive(&report).into_inner().into_inner()
    );
}

/// Writes the sample files where they can be looked at and printed.
#[test]
#[ignore = "SONARIUM_SAMPLE_DIR=FOLDER cargo test -p sonarium sample_files -- --ignored"]
fn sample_files_can_be_looked_at() {
    let folder = std::env::var_os("SONARIUM_SAMPLE_DIR").expect("SONARIUM_SAMPLE_DIR is set");
    let folder = std::path::PathBuf::from(folder);
    let (session, trial) = (sample::session_report(), sample_trial::trial_report());
    let files = [
        ("report.html", html(&session)),
        ("report.json", json(&session)),
        ("trials.csv", csv(&session)),
        ("004.html", trial_html(&trial)),
        ("004.json", trial_json(&trial)),
        ("004.csv", trial_csv(&trial)),
    ];
    for (name, text) in files {
        std::fs::write(folder.join(name), text).expect("a folder that can be written");
    }
    let file = std::fs::File::create(folder.join("report.zip")).expect("a file");
    zip(&session, |_| Ok(Some(sample_trial::trial_report())), None, file).expect("an archive");
}
