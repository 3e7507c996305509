//! A world from a file: TOML, or a ROS map.

use std::fs;
use std::path::Path;

use serde::Deserialize;
use sonarium_core::world::{
    DEFAULT_REGIONS, GoalFile, HomeFile, RegionFile, World, WorldFile, propose_regions,
};

use super::placing::{Numbers, Placing, Regions};
use super::{refused, to_toml};
use crate::catalog::{FieldError, NamedWorld, parse_world, read_world, robot_radius_m};
use crate::cli::Failure;
use crate::rosmap::{Metadata, Options, Traced, trace};
use crate::wire::MapPicture;

/// A world as it was read, with the changes asked for.
pub(crate) struct Source {
    pub(super) file: WorldFile,
    /// The text it was read from, while nothing was changed.
    text: Option<String>,
    traced: Option<String>,
    /// The picture of the map it was traced from.
    pub(super) map: Option<MapPicture>,
}

/// Reads a world from a TOML file or from the YAML file of a map.
pub(crate) fn read(path: &Path, placing: &Placing) -> Result<Source, Failure> {
    let text = fs::read_to_string(path).map_err(|error| refused(path, error))?;
    let is_map = path.extension().is_some_and(|ending| ending == "yaml" || ending == "yml");
    let mut source = if is_map {
        from_map(path, &text, placing)?
    } else {
        if placing.speck.is_some() || placing.crop.is_some() {
            let why = "--speck and --crop need the YAML file of a map";
            return Err(Failure::Input(why.to_owned()));
        }
        let file = parse_world(&text).map_err(|problem| at(path, &problem.message))?;
        Source { file, text: Some(text), traced: None, map: None }
    };
    source.place(path, placing)?;
    Ok(source)
}

fn from_map(path: &Path, yaml: &str, placing: &Placing) -> Result<Source, Failure> {
    let refuse = |error: FieldError| at(path, &error.to_string());
    let metadata = Metadata::parse(yaml).map_err(refuse)?;
    let picture = path.parent().unwrap_or(Path::new("")).join(&metadata.image);
    let bytes = fs::read(&picture).map_err(|error| refused(&picture, error))?;
    let crop_m = placing.crop.map(|Numbers(crop)| crop);
    let options = Options { speck_m2: placing.speck.unwrap_or(0.0), crop_m, name: None };
    let traced = trace(yaml, &bytes, &options).map_err(refuse)?;
    let summary = described(&traced);
    let map = traced.picture().map_err(|error| at(path, &error.to_string()))?;
    Ok(Source { file: traced.world, text: None, traced: Some(summary), map: Some(map) })
}

fn described(traced: &Traced) -> String {
    let grid = &traced.grid;
    format!(
        "{} x {} cells of {} m, {:.1} m² of them free; {} pieces of wall, {} after simplifying; {} \
         specks dropped",
        grid.columns(),
        grid.rows(),
        grid.resolution_m(),
        grid.free_area_m2(),
        traced.segments_before,
        traced.segments_after,
        traced.specks_dropped
    )
}

impl Source {
    /// What was read, in a sentence.
    pub(super) fn summary(&self) -> String {
        let traced = self.traced.as_deref().unwrap_or("a world");
        format!("{}: {traced}", self.file.name)
    }

    /// Gives the world another name.
    pub(super) fn rename(&mut self, name: &str) {
        if self.file.title == self.file.name {
            name.clone_into(&mut self.file.title);
        }
        name.clone_into(&mut self.file.name);
        self.text = None;
    }

    /// Checks the world.
    pub(crate) fn checked(self, path: &Path) -> Result<NamedWorld, Failure> {
        let text = self.text.unwrap_or_else(|| to_toml(&self.file));
        read_world(&self.file.name, text).map_err(|broken| {
            let place = broken.problem.place.map(|at| format!(" [at {}, {}]", at.x_m, at.y_m));
            let place = place.unwrap_or_default();
            at(path, &format!("{}{place}", broken.problem.message))
        })
    }

    fn place(&mut self, path: &Path, placing: &Placing) -> Result<(), Failure> {
        if let Some(Numbers([x, y, heading_deg])) = placing.home {
            self.file.home = HomeFile { x, y, heading_deg };
        }
        if let Some(Numbers([x, y, radius_m])) = placing.goal {
            self.file.goal = GoalFile { x, y, radius_m };
        }
        if let Some(regions) = &placing.regions {
            self.file.regions = regions_for(&self.file, path, regions)?;
        }
        if placing.home.is_some() || placing.goal.is_some() || placing.regions.is_some() {
            self.text = None;
        }
        Ok(())
    }
}

fn regions_for(file: &WorldFile, path: &Path, asked: &Regions) -> Result<Vec<RegionFile>, Failure> {
    let everywhere = vec![RegionFile { name: "everywhere".to_owned(), rules: Vec::new() }];
    match asked {
        Regions::None => Ok(everywhere),
        Regions::Proposed => {
            let whole = WorldFile { regions: everywhere, ..file.clone() };
            let radius_m = robot_radius_m();
            let world =
                World::new(&whole, radius_m).map_err(|error| at(path, &error.to_string()))?;
            Ok(propose_regions(&world, radius_m, DEFAULT_REGIONS))
        }
        Regions::File(path) => {
            #[derive(Deserialize)]
            struct File {
                regions: Vec<RegionFile>,
            }
            let text = fs::read_to_string(path).map_err(|error| refused(path, error))?;
            let file: File = toml::from_str(&text).map_err(|error| at(path, &error.to_string()))?;
            Ok(file.regions)
        }
    }
}

fn at(path: &Path, message: &str) -> Failure {
    Failure::Input(format!("{}: {}", path.display(), message.trim_end()))
}
