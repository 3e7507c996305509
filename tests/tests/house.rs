//! The house rules: formatted, free of lint, the page checked and its units tested.

use std::process::Command;

use e2e::{node_modules, root};

/// Runs a command in a folder of the repository and shows what it said when it fails.
fn passes(folder: &str, program: &str, arguments: &[&str]) {
    let output = Command::new(program)
        .args(arguments)
        .current_dir(root().join(folder))
        .output()
        .unwrap_or_else(|error| panic!("{program} cannot be started: {error}"));
    assert!(
        output.status.success(),
        "{program} {} failed:\n{}\n{}",
        arguments.join(" "),
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr),
    );
}

fn cargo() -> String {
    std::env::var("CARGO").unwrap_or_else(|_| "cargo".into())
}

#[test]
fn the_code_is_formatted() {
    passes(".", &cargo(), &["fmt", "--all", "--check"]);
}

#[test]
fn clippy_finds_nothing() {
    passes(
        ".",
        &cargo(),
        &["clippy", "--workspace", "--all-targets", "--quiet", "--", "-D", "warnings"],
    );
}

#[test]
fn the_page_is_checked_and_its_units_tested() {
    node_modules(&root().join("web"));
    passes("web", "npm", &["run", "--silent", "check"]);
    passes("web", "npm", &["test", "--silent"]);
}

#[test]
fn lock_files_carry_no_addresses() {
    for folder in ["web", "tests"] {
        let path = root().join(folder).join("package-lock.json");
        let text = std::fs::read_to_string(&path).expect("each has a lock file");
        assert!(!text.contains("\"resolved\""), "{}", path.display());
    }
}
