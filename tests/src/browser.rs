//! Debian's Chromium and the browser tests' own packages.

use std::path::{Path, PathBuf};
use std::process::Command;

/// What to type where nothing may be installed.
const INSTALL: &str = "apt-get update && apt-get install -y --no-install-recommends chromium";

/// The browser: `CHROMIUM`, else Debian's, fetched through apt when it is missing and this may.
#[must_use]
pub fn chromium() -> PathBuf {
    let wanted = std::env::var("CHROMIUM").unwrap_or_else(|_| "/usr/bin/chromium".into());
    let path = PathBuf::from(&wanted);
    if path.exists() {
        return path;
    }
    eprintln!("No browser at {wanted}: fetching Debian's chromium through apt");
    let fetched = Command::new("sh").args(["-c", INSTALL]).status();
    assert!(
        fetched.is_ok_and(|status| status.success()) && path.exists(),
        "The browser tests need Chromium at {wanted} (or CHROMIUM=path). Install it with:\n  {INSTALL}"
    );
    path
}

/// Installs the packages of a folder when its lock file is newer than they are.
pub fn node_modules(folder: &Path) {
    let modified = |path: PathBuf| path.metadata().and_then(|data| data.modified()).ok();
    let installed = modified(folder.join("node_modules/.package-lock.json"));
    let wanted = modified(folder.join("package-lock.json"));
    if installed.is_some() && installed >= wanted {
        return;
    }
    let status = Command::new("npm")
        .args(["ci", "--no-audit", "--no-fund", "--loglevel=error"])
        .current_dir(folder)
        .status()
        .expect("npm can be started: Node 20.19 or newer is needed");
    assert!(status.success(), "npm ci failed in {}", folder.display());
}
