//! Worlds of one's own: as files, as drafts traced from maps, and what is wrong with them.

use serde::{Deserialize, Serialize};
use sonarium_core::world as core;
use ts_rs::TS;
use utoipa::ToSchema;

/// A world as its file says it. Lengths in metres, angles in degrees.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct WorldFile {
    /// Name, the value of the setting `world`.
    pub name: String,
    /// Title for people.
    pub title: String,
    /// One sentence on what the world is like.
    pub summary: String,
    /// Where it comes from.
    pub source: String,
    /// Open polylines, each a list of points `[x, y]`.
    #[serde(default)]
    pub walls: Vec<Vec<[f64; 2]>>,
    /// Closed solid polygons.
    #[serde(default)]
    pub blocks: Vec<Vec<[f64; 2]>>,
    /// Closed rings that bound the free floor by the even-odd rule; where there are any, everything off
    /// the floor is solid.
    #[serde(default)]
    pub floor: Vec<Vec<[f64; 2]>>,
    /// Regions; the first whose rules all hold wins, and the last has none.
    pub regions: Vec<WorldRegion>,
    /// Where every trial starts.
    pub home: WorldHome,
    /// Where every trial should end.
    pub goal: WorldGoal,
}

/// A named region.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct WorldRegion {
    /// Name, e.g. "corridor".
    pub name: String,
    /// Rules that must all hold; none means everywhere else.
    #[serde(default)]
    pub rules: Vec<WorldRule>,
}

/// A half-plane: `axis` (or `a` and `b`, for `a·x + b·y`) with exactly one of `above` and `below`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct WorldRule {
    /// `x` or `y`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[ts(optional)]
    pub axis: Option<AxisName>,
    /// Factor of x.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[ts(optional)]
    pub a: Option<f64>,
    /// Factor of y.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[ts(optional)]
    pub b: Option<f64>,
    /// Must be greater than this.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[ts(optional)]
    pub above: Option<f64>,
    /// Must be less than this.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[ts(optional)]
    pub below: Option<f64>,
}

/// A coordinate axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, TS, ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum AxisName {
    /// The x axis.
    X,
    /// The y axis.
    Y,
}

/// Where every trial starts.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct WorldHome {
    /// Metres.
    pub x: f64,
    /// Metres.
    pub y: f64,
    /// Degrees from the x axis, counter-clockwise.
    pub heading_deg: f64,
}

/// Where every trial should end.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct WorldGoal {
    /// Metres.
    pub x: f64,
    /// Metres.
    pub y: f64,
    /// The goal is reached when the robot's centre is nearer than this, metres.
    pub radius_m: f64,
}

/// A place in the world.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct PlaceView {
    /// Metres.
    pub x_m: f64,
    /// Metres.
    pub y_m: f64,
}

/// Something wrong with a world.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct WorldProblem {
    /// The field at fault, e.g. `home` or `regions[1].rules[0]`.
    pub field: String,
    /// What is wrong, and what would be right.
    pub message: String,
    /// The place at fault: a home in a wall, a goal that cannot be reached.
    pub place: Option<PlaceView>,
    /// The reachable place nearest to an unreachable goal.
    pub nearest: Option<PlaceView>,
}

/// A world in the list of all.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct WorldSummary {
    /// Value of the setting `world`.
    pub name: String,
    /// Title for people; the name when the file cannot be read.
    pub title: String,
    /// What it is.
    pub summary: String,
    /// It came with the program and cannot be changed.
    pub built_in: bool,
    /// Why no session can run in it.
    pub problem: Option<String>,
    /// Least and greatest x and y, `[x0, y0, x1, y1]`, metres.
    pub bounds_m: Option<[f64; 4]>,
    /// Wall surfaces.
    pub walls: u32,
    /// Names of the regions.
    pub regions: Vec<String>,
}

/// What a world is like, and everything wrong with it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct WorldCheck {
    /// A session can run in it.
    pub ok: bool,
    /// What was read.
    pub world: WorldFile,
    /// What is wrong.
    pub problems: Vec<WorldProblem>,
    /// Least and greatest x and y, `[x0, y0, x1, y1]`, metres; none when something is wrong.
    pub bounds_m: Option<[f64; 4]>,
    /// Wall surfaces; 0 when something is wrong.
    pub walls: u32,
    /// What each region covers; empty when something is wrong.
    pub regions: Vec<RegionShape>,
    /// From home to the nearest surface, metres.
    pub clearance_m: Option<f64>,
    /// From home straight to the goal's centre, metres.
    pub distance_m: f64,
    /// A short way that the robot fits through, metres, found on a grid of 10 cm and pulled taut.
    pub way_m: Option<f64>,
    /// Radius of the robot that has to fit, metres.
    pub robot_radius_m: f64,
    /// A world of this name exists already: `own` or `built_in`.
    pub taken: Option<String>,
}

/// What a region covers within the bounds.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct RegionShape {
    /// Its name.
    pub name: String,
    /// Convex polygons, metres.
    pub polygons_m: Vec<Vec<[f64; 2]>>,
}

/// Regions proposed for a world.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct RegionProposal {
    /// The regions, for the world's file.
    pub regions: Vec<WorldRegion>,
    /// What each covers.
    pub shapes: Vec<RegionShape>,
}

/// A ROS map to be traced.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct TraceRequest {
    /// The PGM or PNG file in base 64.
    pub image_base64: String,
    /// The text of the YAML file.
    pub yaml: String,
    /// Patches of cells smaller than this are dropped, square metres; none unless told otherwise.
    #[serde(default)]
    #[ts(optional)]
    pub speck_m2: Option<f64>,
    /// The part of the world to keep, `[x0, y0, x1, y1]`, metres; all unless told otherwise.
    #[serde(default)]
    #[ts(optional)]
    pub crop: Option<[f64; 4]>,
    /// Name of the world; that of the image unless told otherwise.
    #[serde(default)]
    #[ts(optional)]
    pub name: Option<String>,
}

/// A world traced from a map, to be finished by its user.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct TraceDraft {
    /// The floor with one region and a suggested home and goal.
    pub world: WorldFile,
    /// Edge of a cell, metres.
    pub resolution_m: f64,
    /// Cells along x.
    pub width_cells: u32,
    /// Cells along y.
    pub height_cells: u32,
    /// Free cells.
    pub free_cells: u32,
    /// Occupied cells.
    pub occupied_cells: u32,
    /// Unknown cells.
    pub unknown_cells: u32,
    /// Area of the free cells, square metres.
    pub free_area_m2: f64,
    /// Pieces of wall before they were simplified within half a cell.
    pub segments_before: u32,
    /// Pieces of wall after that.
    pub segments_after: u32,
    /// Patches of cells dropped.
    pub specks_dropped: u32,
    /// Least and greatest x and y of the floor, `[x0, y0, x1, y1]`, metres.
    pub bounds_m: [f64; 4],
    /// The cells as a picture.
    pub picture: MapPicture,
}

/// The cells of a map as a picture: white is free, black occupied, grey unknown.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, ToSchema)]
pub struct MapPicture {
    /// A PNG file in base 64.
    pub png_base64: String,
    /// Pixels; fewer than cells for a large map.
    pub width_px: u32,
    /// Pixels.
    pub height_px: u32,
    /// The lower left corner, metres.
    pub corner: PlaceView,
    /// How far the picture is turned about that corner, degrees counter-clockwise.
    pub yaw_deg: f64,
    /// Width of the map, metres.
    pub width_m: f64,
    /// Height of the map, metres.
    pub height_m: f64,
}

impl From<[f64; 2]> for PlaceView {
    fn from([x_m, y_m]: [f64; 2]) -> Self {
        Self { x_m, y_m }
    }
}

impl From<&core::WorldError> for WorldProblem {
    fn from(error: &core::WorldError) -> Self {
        Self {
            field: error.field(),
            message: error.to_string(),
            place: error.place_m().map(PlaceView::from),
            nearest: error.nearest_m().map(PlaceView::from),
        }
    }
}

impl From<core::WorldFile> for WorldFile {
    fn from(file: core::WorldFile) -> Self {
        let core::HomeFile { x, y, heading_deg } = file.home;
        let home = WorldHome { x, y, heading_deg };
        let core::GoalFile { x, y, radius_m } = file.goal;
        Self {
            name: file.name,
            title: file.title,
            summary: file.summary,
            source: file.source,
            walls: file.walls,
            blocks: file.blocks,
            floor: file.floor,
            regions: file.regions.into_iter().map(WorldRegion::from).collect(),
            home,
            goal: WorldGoal { x, y, radius_m },
        }
    }
}

impl From<WorldFile> for core::WorldFile {
    fn from(file: WorldFile) -> Self {
        let WorldHome { x, y, heading_deg } = file.home;
        let home = core::HomeFile { x, y, heading_deg };
        let WorldGoal { x, y, radius_m } = file.goal;
        Self {
            name: file.name,
            title: file.title,
            summary: file.summary,
            source: file.source,
            walls: file.walls,
            blocks: file.blocks,
            floor: file.floor,
            regions: file.regions.into_iter().map(core::RegionFile::from).collect(),
            home,
            goal: core::GoalFile { x, y, radius_m },
        }
    }
}

impl From<core::RegionFile> for WorldRegion {
    fn from(region: core::RegionFile) -> Self {
        let rule = |rule: core::RuleFile| {
            let axis = rule.axis.map(|axis| match axis {
                core::Axis::X => AxisName::X,
                core::Axis::Y => AxisName::Y,
            });
            WorldRule { axis, a: rule.a, b: rule.b, above: rule.above, below: rule.below }
        };
        Self { name: region.name, rules: region.rules.into_iter().map(rule).collect() }
    }
}

impl From<WorldRegion> for core::RegionFile {
    fn from(region: WorldRegion) -> Self {
        let rule = |rule: WorldRule| {
            let axis = rule.axis.map(|axis| match axis {
                AxisName::X => core::Axis::X,
                AxisName::Y => core::Axis::Y,
            });
            core::RuleFile { axis, a: rule.a, b: rule.b, above: rule.above, below: rule.below }
        };
        Self { name: region.name, rules: region.rules.into_iter().map(rule).collect() }
    }
}
