//! From a map to a world that its user finishes.

use std::path::Path;

use sonarium_core::world::map::{Cell, OccupancyGrid, floor_plan, suggest};
use sonarium_core::world::{GoalFile, HomeFile, RegionFile, WorldFile};

use super::{Metadata, picture, read, refused};
use crate::catalog::{FieldError, robot_radius_m, world_name};
use crate::render::RenderError;
use crate::wire::{self, MapPicture, TraceDraft};

/// Radius of a suggested goal, that of section 5.3, metres.
const GOAL_RADIUS_M: f64 = 0.5;

/// What is done with a map before it is traced.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// Patches of cells smaller than this are dropped, square metres.
    pub speck_m2: f64,
    /// The part of the world to keep, `[x0, y0, x1, y1]`, metres.
    pub crop_m: Option<[f64; 4]>,
    /// Name of the world; that of the picture unless told otherwise.
    pub name: Option<String>,
}

/// A map and the world traced from it.
#[derive(Clone, Debug)]
pub struct Traced {
    /// The cells, after cropping and dropping of specks.
    pub grid: OccupancyGrid,
    /// The floor with one region and a suggested home and goal.
    pub world: WorldFile,
    /// Patches of cells dropped.
    pub specks_dropped: usize,
    /// Pieces of wall before they were simplified.
    pub segments_before: usize,
    /// Pieces of wall after that.
    pub segments_after: usize,
}

/// Traces a map.
///
/// # Errors
/// The first thing wrong with its metadata, its picture or the options, by field.
pub fn trace(yaml: &str, picture: &[u8], options: &Options) -> Result<Traced, FieldError> {
    let metadata = Metadata::parse(yaml)?;
    let mut grid = read(&metadata, picture)?;
    if let Some(crop_m) = options.crop_m {
        grid = grid.crop(crop_m).map_err(refused)?;
    }
    let specks_dropped = grid.drop_specks(options.speck_m2).map_err(refused)?;
    let plan = floor_plan(&grid).map_err(refused)?;
    let places = suggest(&grid, robot_radius_m());
    let [home, goal] =
        [places.home, places.goal].map(|place| [centimetres(place.x), centimetres(place.y)]);
    let stem = Path::new(&metadata.image).file_stem().and_then(|stem| stem.to_str());
    let stem = stem.unwrap_or("map");
    let name = options.name.clone().unwrap_or_else(|| world_name(stem));
    let world = WorldFile {
        title: name.clone(),
        name,
        summary: format!("{:.0} m² of floor traced from a map", grid.free_area_m2()),
        source: format!("{}, {} m a cell", metadata.image, metadata.resolution_m),
        walls: Vec::new(),
        blocks: Vec::new(),
        floor: plan.rings,
        regions: vec![RegionFile { name: "everywhere".to_owned(), rules: Vec::new() }],
        home: HomeFile {
            x: home[0],
            y: home[1],
            heading_deg: places.heading_rad.to_degrees().round(),
        },
        goal: GoalFile { x: goal[0], y: goal[1], radius_m: GOAL_RADIUS_M },
    };
    let (segments_before, segments_after) = (plan.segments_before, plan.segments_after);
    Ok(Traced { grid, world, specks_dropped, segments_before, segments_after })
}

impl Traced {
    /// The cells as a picture.
    ///
    /// # Errors
    /// When it cannot be encoded.
    pub fn picture(&self) -> Result<MapPicture, RenderError> {
        picture::picture(&self.grid)
    }

    /// The draft as it travels.
    ///
    /// # Errors
    /// When the picture cannot be encoded.
    pub fn draft(self) -> Result<TraceDraft, RenderError> {
        let cells = |kind: Cell| self.grid.count(kind) as u32;
        Ok(TraceDraft {
            resolution_m: self.grid.resolution_m(),
            width_cells: self.grid.columns() as u32,
            height_cells: self.grid.rows() as u32,
            free_cells: cells(Cell::Free),
            occupied_cells: cells(Cell::Occupied),
            unknown_cells: cells(Cell::Unknown),
            free_area_m2: self.grid.free_area_m2(),
            segments_before: self.segments_before as u32,
            segments_after: self.segments_after as u32,
            specks_dropped: self.specks_dropped as u32,
            bounds_m: bounds_m(&self.world.floor),
            picture: self.picture()?,
            world: wire::WorldFile::from(self.world),
        })
    }
}

fn bounds_m(rings: &[Vec<[f64; 2]>]) -> [f64; 4] {
    let start = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
    rings
        .iter()
        .flatten()
        .fold(start, |[x0, y0, x1, y1], [x, y]| [x0.min(*x), y0.min(*y), x1.max(*x), y1.max(*y)])
}

fn centimetres(value_m: f64) -> f64 {
    (value_m * 100.0).round() / 100.0
}
