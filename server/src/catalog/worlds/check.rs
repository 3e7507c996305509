//! What a world is like, and everything wrong with it.

use sonarium_core::world::{Region, World, WorldFile, way_m};

use super::{Worlds, robot_radius_m};
use crate::wire::{self, RegionShape, WorldCheck, WorldProblem};

impl Worlds {
    /// Looks a world over for its user, without saving it.
    #[must_use]
    pub fn check(&self, file: WorldFile) -> WorldCheck {
        let radius_m = robot_radius_m();
        let problems = World::problems(&file, radius_m);
        let world = World::new(&file, radius_m).ok();
        let world = world.as_ref();
        WorldCheck {
            ok: problems.is_empty(),
            problems: problems.iter().map(WorldProblem::from).collect(),
            bounds_m: world.map(World::bounds_m),
            walls: world.map_or(0, |world| world.walls().len() as u32),
            regions: world.map(region_shapes).unwrap_or_default(),
            clearance_m: world.map(|world| world.clearance_m(world.home().position())),
            distance_m: (file.goal.x - file.home.x).hypot(file.goal.y - file.home.y),
            way_m: world.and_then(|world| way_m(world, radius_m)),
            robot_radius_m: radius_m,
            taken: self.taken(&file.name).map(str::to_owned),
            world: wire::WorldFile::from(file),
        }
    }
}

/// What each region of a world covers within the bounds.
#[must_use]
pub fn region_shapes(world: &World) -> Vec<RegionShape> {
    let shape = |(index, region): (usize, &Region)| {
        let polygons = world.region_polygons(index);
        let points = polygons.iter().map(|polygon| polygon.iter().map(|at| [at.x, at.y]).collect());
        RegionShape { name: region.name.clone(), polygons_m: points.collect() }
    };
    world.regions().iter().enumerate().map(shape).collect()
}
