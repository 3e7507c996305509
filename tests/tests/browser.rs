//! The browser tests: Playwright against a real server, one server for each file of tests.

use std::process::Command;

use e2e::{Server, chromium, node_modules, root};

/// Runs one file of `tests/browser` against a server of its own.
fn passes(spec: &str) {
    let browser = chromium();
    let folder = root().join("tests");
    node_modules(&folder);
    let server = Server::start();
    let output = Command::new("npx")
        .args(["playwright", "test", spec])
        .args(["--output", &format!("test-results/{spec}")])
        .current_dir(&folder)
        .env("SONARIUM_URL", server.url())
        .env("CHROMIUM", browser)
        .output()
        .expect("npx can be started: Node 20.19 or newer is needed");
    assert!(
        output.status.success(),
        "{}\n{}",
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr),
    );
}

#[test]
fn a_person_can_do_the_whole_story_in_a_browser() {
    passes("story.spec.ts");
}

#[test]
fn a_person_can_bring_and_edit_a_world_in_a_browser() {
    passes("worlds.spec.ts");
}

#[test]
fn a_person_can_look_at_the_reproductions_in_a_browser() {
    passes("reproduce.spec.ts");
}

#[test]
fn a_person_can_watch_and_change_what_drives_a_robot_in_a_browser() {
    passes("drive.spec.ts");
}

#[test]
fn a_person_can_watch_and_advise_learners_with_tables_in_a_browser() {
    passes("tables.spec.ts");
}
