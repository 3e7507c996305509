//! Home-goal pairs in a real office, traced from a ROS map that is not part of the program.
//!
//! The map is that of Willow Garage, 0.10 m a cell, as ROS distributed it. Its YAML file is named by the
//! environment variable [`MAP`]; without it there are no such rows.

use std::fs;
use std::path::{Path, PathBuf};

use sonarium_core::world::{GoalFile, HomeFile, WorldFile};

use super::{Arm, ReproductionError, Sample, Sets, Target};
use crate::catalog::{NamedWorld, Plan, read_world, to_toml};
use crate::rosmap::{Metadata, Options, trace};

/// Names the YAML file of the map.
pub(super) const MAP: &str = "SONARIUM_OFFICE_MAP";

/// Where a trial starts and should end in the frame of the map, metres and degrees. Ways are 1.2 to 1.3
/// times the straight line, and no door is narrower than 1.1 m.
#[derive(Clone, Copy)]
pub(super) struct Pair {
    arm: Arm,
    /// Name of the way, whatever it is driven with.
    way: &'static str,
    home: [f64; 3],
    goal: [f64; 2],
}

impl Pair {
    const fn new(name: &'static str, home: [f64; 3], goal: [f64; 2]) -> Self {
        Self { arm: Arm { name, settings: &[] }, way: name, home, goal }
    }

    /// The same way under other settings.
    const fn with(
        self,
        name: &'static str,
        settings: &'static [(&'static str, &'static str)],
    ) -> Self {
        Self { arm: Arm { name, settings }, ..self }
    }
}

const BEND: Pair = Pair::new("office, bend", [16.95, 57.05, -31.0], [23.05, 53.35]);
const DESKS: Pair = Pair::new("office, desks", [45.05, 41.85, 172.0], [39.05, 42.65]);

/// Six ways through the office.
pub(super) const PAIRS: [Pair; 6] = [
    BEND,
    DESKS,
    Pair::new("office, rooms", [32.65, 16.15, 82.0], [33.75, 24.25]),
    Pair::new("office, nook", [28.15, 2.65, 111.0], [26.35, 7.35]),
    Pair::new("office, corridor", [14.95, 35.35, -161.0], [8.15, 33.05]),
    Pair::new("office, around", [19.55, 19.85, 67.0], [21.85, 25.35]),
];

/// Differences from the thesis, switched off where they are worth most.
pub(super) const DIFFERENCES: [Pair; 7] = [
    BEND.with("office, bend, default", &[]),
    BEND.with("office, bend, no steps aside", &[("learner.sidestep", "0")]),
    BEND.with("office, bend, all withdrawn", &[("shortcut.withdraw", "followed")]),
    BEND.with("office, bend, no sharper than T(n)", &[("shortcut.sharp", "false")]),
    DESKS.with("office, desks, default", &[]),
    DESKS.with("office, desks, not handed over", &[("shortcut.carry", "way")]),
    DESKS.with("office, desks, nothing withdrawn", &[("shortcut.withdraw", "off")]),
];

/// What a target says of them.
pub(super) const READING: &str = "The pairs in a real office are there when SONARIUM_OFFICE_MAP names the YAML file of the \
     Willow Garage map of 0.10 m a cell, which is not part of the program";

/// Radius of the goals, that of section 5.3, metres.
const GOAL_RADIUS_M: f64 = 0.5;

/// The sets of some pairs; none where no map is named.
pub(super) fn samples(
    target: &Target,
    sets: &Sets<'_>,
    pairs: &[Pair],
) -> Result<Vec<Sample>, ReproductionError> {
    let Some(map) = std::env::var_os(MAP).map(PathBuf::from) else { return Ok(Vec::new()) };
    let traced = traced(&map)?;
    let sample = |pair: &Pair| {
        let plan = sets.plan(target, &pair.arm)?;
        sets.with(target, &pair.arm, Plan { world: pair.world(&traced)?, ..plan })
    };
    pairs.iter().map(sample).collect()
}

impl Pair {
    /// The map as a world of one region, with this home and goal.
    fn world(&self, map: &WorldFile) -> Result<NamedWorld, ReproductionError> {
        let [x, y, heading_deg] = self.home;
        let name = self.way.replace(", ", "-");
        let file = WorldFile {
            name: name.clone(),
            home: HomeFile { x, y, heading_deg },
            goal: GoalFile { x: self.goal[0], y: self.goal[1], radius_m: GOAL_RADIUS_M },
            ..map.clone()
        };
        read_world(&name, to_toml(&file)).map_err(|broken| {
            ReproductionError::Broken(format!("{}: {}", self.arm.name, broken.problem.message))
        })
    }
}

fn traced(path: &Path) -> Result<WorldFile, ReproductionError> {
    let refused = |what: &Path, why: String| {
        ReproductionError::Broken(format!("{MAP}: {}: {why}", what.display()))
    };
    let yaml = fs::read_to_string(path).map_err(|error| refused(path, error.to_string()))?;
    let metadata = Metadata::parse(&yaml).map_err(|error| refused(path, error.to_string()))?;
    let picture = path.parent().unwrap_or(Path::new("")).join(&metadata.image);
    let bytes = fs::read(&picture).map_err(|error| refused(&picture, error.to_string()))?;
    let options = Options { speck_m2: 0.0, crop_m: None, name: None };
    let traced =
        trace(&yaml, &bytes, &options).map_err(|error| refused(path, error.to_string()))?;
    Ok(traced.world)
}
