//! Builds the page into `OUT_DIR/site` and notes the commit this program is built from.
//!
//! `WEB_DIST` names a folder that already holds a built site; then neither Node nor npm is needed.
#![allow(clippy::print_stdout, reason = "a build script talks to cargo on stdout")]

use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::time::SystemTime;
use std::{env, fs};

/// What the built site depends on, in `web/`.
const PAGE_SOURCES: [&str; 7] = [
    "src",
    "public",
    "index.html",
    "package.json",
    "package-lock.json",
    "tsconfig.json",
    "vite.config.ts",
];

/// What makes a build "dirty" when it differs from the commit, in the repository.
const PROGRAM_SOURCES: [&str; 7] =
    ["core", "server", "assets", "web/src", "web/public", "Cargo.toml", "Cargo.lock"];

fn main() -> ExitCode {
    let repository = PathBuf::from("..");
    println!("cargo::rustc-env=SONARIUM_COMMIT={}", commit(&repository));
    match site(&repository.join("web")) {
        Ok(site) => {
            println!("cargo::rustc-env=SITE_DIR={}", site.display());
            ExitCode::SUCCESS
        }
        Err(sentence) => {
            println!("cargo::error={sentence}");
            ExitCode::FAILURE
        }
    }
}

/// Short hash of the commit, with `-dirty` when the sources differ from it; `unknown` without git.
fn commit(repository: &Path) -> String {
    for source in PROGRAM_SOURCES {
        watch(&repository.join(source));
    }
    let Some(hash) = git(repository, &["rev-parse", "--short=10", "HEAD"]) else {
        return "unknown".to_owned();
    };
    for name in ["HEAD", "logs/HEAD"] {
        if let Some(path) = git(repository, &["rev-parse", "--git-path", name]) {
            watch(&repository.join(path));
        }
    }
    let mut status = vec!["status", "--porcelain", "--untracked-files=no", "--"];
    status.extend(PROGRAM_SOURCES);
    match git(repository, &status) {
        Some(changes) if changes.is_empty() => hash,
        _ => format!("{hash}-dirty"),
    }
}

/// Runs this again when the path changes; cargo would take a missing one for ever changed.
fn watch(path: &Path) {
    if path.exists() {
        println!("cargo::rerun-if-changed={}", path.display());
    }
}

fn git(repository: &Path, arguments: &[&str]) -> Option<String> {
    let output = Command::new("git").arg("-C").arg(repository).args(arguments).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    output.status.success().then(|| text.trim().to_owned())
}

/// Folder of the built site; builds it when it was built from other sources.
fn site(web: &Path) -> Result<PathBuf, String> {
    println!("cargo::rerun-if-env-changed=WEB_DIST");
    if let Some(built) = env::var_os("WEB_DIST") {
        return built_site(Path::new(&built));
    }
    for source in PAGE_SOURCES {
        watch(&web.join(source));
    }
    let out = PathBuf::from(env::var_os("OUT_DIR").ok_or("OUT_DIR is not set; run cargo")?);
    let (site, stamp) = (out.join("site"), out.join("site.stamp"));
    let sources = fingerprint(web).to_string();
    if fs::read_to_string(&stamp).ok().as_ref() != Some(&sources) {
        check_node()?;
        install(web)?;
        build(web, &site)?;
        fs::write(&stamp, sources).map_err(|error| format!("{}: {error}", stamp.display()))?;
    }
    Ok(site)
}

fn built_site(folder: &Path) -> Result<PathBuf, String> {
    watch(folder);
    let folder = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    if folder.join("index.html").is_file() {
        Ok(folder)
    } else {
        Err(format!(
            "WEB_DIST is {}, which holds no index.html; give the full path of a built site, \
             or unset WEB_DIST to build it with npm.",
            folder.display()
        ))
    }
}

fn check_node() -> Result<(), String> {
    let found = Command::new("node").arg("--version").output();
    let version = found.ok().and_then(|output| String::from_utf8(output.stdout).ok());
    let version = version.unwrap_or_default();
    let mut parts = version.trim().trim_start_matches('v').split('.').map(str::parse::<u32>);
    match (parts.next(), parts.next()) {
        (Some(Ok(major)), Some(Ok(minor))) if (major, minor) >= (20, 19) => Ok(()),
        (Some(Ok(_)), _) => Err(needs(&format!("Node {} is too old", version.trim()))),
        _ => Err(needs("Node was not found")),
    }
}

fn needs(what: &str) -> String {
    format!(
        "{what}: the page is built with Node 20.19 or newer and npm; install them, \
         or set WEB_DIST to the full path of an already built site."
    )
}

/// Installs what the lock file asks for, when it is newer than what is installed.
fn install(web: &Path) -> Result<(), String> {
    let installed = modified(&web.join("node_modules/.package-lock.json"));
    if installed >= modified(&web.join("package-lock.json")) {
        return Ok(());
    }
    npm(web, &["ci"])
}

fn build(web: &Path, site: &Path) -> Result<(), String> {
    let site = site.to_string_lossy();
    npm(web, &["run", "build", "--", "--emptyOutDir", "--outDir", &site])
}

/// Runs npm in `web/`; what it says goes to the build log.
fn npm(web: &Path, arguments: &[&str]) -> Result<(), String> {
    let program = if cfg!(windows) { "npm.cmd" } else { "npm" };
    let run = Command::new(program).args(arguments).current_dir(web).output();
    let output = run.map_err(|error| needs(&format!("npm could not be run ({error})")))?;
    if output.status.success() {
        return Ok(());
    }
    let said = [output.stdout, output.stderr].concat();
    eprintln!("{}", String::from_utf8_lossy(&said));
    Err(format!("`npm {}` failed in web/; its output stands below.", arguments.join(" ")))
}

/// A number that changes with any name or content among the page's sources. Times would not do:
/// several checkouts may share one target folder.
fn fingerprint(web: &Path) -> u64 {
    let mut hasher = DefaultHasher::new();
    for source in PAGE_SOURCES {
        hash_tree(&web.join(source), source, &mut hasher);
    }
    hasher.finish()
}

fn hash_tree(path: &Path, name: &str, hasher: &mut DefaultHasher) {
    name.hash(hasher);
    let Ok(entries) = fs::read_dir(path) else {
        return fs::read(path).unwrap_or_default().hash(hasher);
    };
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.sort();
    for path in paths {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        hash_tree(&path, &name, hasher);
    }
}

fn modified(path: &Path) -> Option<SystemTime> {
    fs::metadata(path).and_then(|metadata| metadata.modified()).ok()
}
