//! `sonarium world`: tracing a world from a map, checking one.

use std::fs;
use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};

use super::{Failure, output};
use crate::catalog::{NamedWorld, Worlds, map_beside, map_file, to_toml, world_name};
use crate::render::{Backend, Quality, Renderer};
use crate::session::empty_arena;
use crate::wire::{MapPicture, ThemeName, WorldCheck};

mod placing;
mod source;

pub(super) use placing::Placing;
pub(super) use source::read;

/// Size of a picture of a world, pixels.
const PICTURE_PX: (u32, u32) = (1600, 1200);

#[derive(Args, Debug)]
pub(super) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Trace the walls of a ROS map and write the world as TOML
    Trace(Trace),
    /// Check a world and say what it is like
    Check(Check),
}

#[derive(Args, Debug)]
struct Trace {
    /// The YAML file of the map; it names the picture (PGM or PNG)
    map: PathBuf,
    #[command(flatten)]
    placing: Placing,
    /// Name of the world [default: that of the file it is written to, or of the picture]
    #[arg(long)]
    name: Option<String>,
    /// File for the world; without it the TOML is printed
    #[arg(long, value_name = "FILE.toml")]
    out: Option<PathBuf>,
    /// File for a picture of the world
    #[arg(long, value_name = "FILE.png")]
    png: Option<PathBuf>,
}

#[derive(Args, Debug)]
struct Check {
    /// The world: a TOML file, or the YAML file of a ROS map
    file: PathBuf,
    #[command(flatten)]
    placing: Placing,
    /// File for a picture of the world
    #[arg(long, value_name = "FILE.png")]
    png: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub(super) fn world(arguments: &Arguments) -> Result<(), Failure> {
    match &arguments.command {
        Command::Trace(arguments) => trace(arguments),
        Command::Check(arguments) => check(arguments),
    }
}

fn trace(arguments: &Trace) -> Result<(), Failure> {
    let mut source = source::read(&arguments.map, &arguments.placing)?;
    let stem = arguments.out.as_deref().and_then(Path::file_stem).and_then(|stem| stem.to_str());
    if let Some(name) = arguments.name.clone().or_else(|| stem.map(world_name)) {
        source.rename(&name);
    }
    let summary = source.summary();
    let map = source.map.take();
    let world = source.checked(&arguments.map)?;
    if let Some(path) = &arguments.png {
        draw(&world, path)?;
    }
    match &arguments.out {
        Some(path) => {
            fs::write(path, &world.text).map_err(|error| refused(path, error))?;
            let beside = keep_map(path, map.as_ref())?;
            output::line(&format!("{summary}; written to {}{beside}", path.display()))
        }
        None => output::line(world.text.trim_end()),
    }
}

/// Writes the picture of the map beside the world; says where. Without a map there is nothing to write.
fn keep_map(world: &Path, map: Option<&MapPicture>) -> Result<String, Failure> {
    let Some(map) = map else { return Ok(String::new()) };
    let path = map_beside(world);
    let file = map_file(map).map_err(|error| Failure::Failed(error.to_string()))?;
    fs::write(&path, file).map_err(|error| refused(&path, error))?;
    Ok(format!(", its map to {}", path.display()))
}

fn check(arguments: &Check) -> Result<(), Failure> {
    let source = source::read(&arguments.file, &arguments.placing)?;
    let found = Worlds::load(None)?.check(source.file.clone());
    if arguments.json {
        output::json(&found)?;
    } else {
        output::line(&text(&found))?;
    }
    let world = source.checked(&arguments.file)?;
    arguments.png.as_deref().map_or(Ok(()), |path| draw(&world, path))
}

fn text(check: &WorldCheck) -> String {
    let mut text = format!("{}: {}\n", check.world.name, check.world.title);
    if let Some([x0, y0, x1, y1]) = check.bounds_m {
        let (width, height) = (x1 - x0, y1 - y0);
        let walls = check.walls;
        text += &format!("  {width:.2} x {height:.2} m, {walls} wall surfaces\n");
    }
    for region in &check.regions {
        text += &format!("  region {}\n", region.name);
    }
    if let (Some(clearance_m), Some(way_m)) = (check.clearance_m, check.way_m) {
        let distance_m = check.distance_m;
        text += &format!(
            "  home {clearance_m:.2} m from the nearest wall, {distance_m:.2} m from the goal, a way \
             of about {way_m:.1} m\n"
        );
    }
    for problem in &check.problems {
        text += &format!("  {}: {}\n", problem.field, problem.message);
    }
    text.trim_end().to_owned()
}

fn draw(world: &NamedWorld, path: &Path) -> Result<(), Failure> {
    let backend = Backend::from_environment().map_err(|e| Failure::Input(e.to_string()))?;
    let names: Vec<String> = world.world.regions().iter().map(|r| r.name.clone()).collect();
    let view = empty_arena(&world.world, &names);
    let (width, height) = PICTURE_PX;
    let (theme, quality) = (ThemeName::Light, Quality::Balanced);
    let picture = Renderer::start(backend).picture_blocking(view, width, height, theme, quality);
    let picture = picture.map_err(|error| Failure::Failed(error.to_string()))?;
    fs::write(path, picture).map_err(|error| refused(path, error))
}

fn refused(path: &Path, error: std::io::Error) -> Failure {
    Failure::Input(format!("{}: {error}", path.display()))
}
