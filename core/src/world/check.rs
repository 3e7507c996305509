//! Checks on a world's file, each naming the field at fault and what would be right.

use crate::geometry::Vec2;

use super::error::WorldError;
use super::file::{Axis, RegionFile, RuleFile, WorldFile};
use super::region::{HalfPlane, Region, polygons, rectangle};
use super::segments::Segment;

/// Greatest extent of a world along each axis, metres.
pub const EXTENT_LIMIT_M: f64 = 200.0;
/// Most wall surfaces a world may have, edges of blocks and floor included.
pub const WALL_LIMIT: usize = 20_000;
/// Most regions, and most rules in one region.
pub const REGION_LIMIT: usize = 64;

/// What is wrong with names and numbers, which need no geometry.
pub(super) fn values(file: &WorldFile) -> Vec<WorldError> {
    let mut problems = Vec::new();
    if file.name.is_empty() {
        problems.push(WorldError::Unnamed { field: "name".to_owned() });
    }
    let numbers = [
        ("home.x", file.home.x),
        ("home.y", file.home.y),
        ("home.heading_deg", file.home.heading_deg),
        ("goal.x", file.goal.x),
        ("goal.y", file.goal.y),
        ("goal.radius_m", file.goal.radius_m),
    ];
    problems.extend(numbers.into_iter().filter_map(|(field, value)| finite(field, value).err()));
    if file.goal.radius_m <= 0.0 {
        problems.push(WorldError::GoalRadius { found: file.goal.radius_m });
    }
    problems
}

/// All wall surfaces: the pieces of the walls, then the edges of the blocks and of the floor.
pub(super) fn segments(file: &WorldFile) -> Result<Vec<Segment>, WorldError> {
    let mut segments = Vec::new();
    for (index, wall) in file.walls.iter().enumerate() {
        check_points(&format!("walls[{index}]"), wall, 2)?;
        segments.extend(edges(wall));
    }
    for (name, polygons) in [("blocks", &file.blocks), ("floor", &file.floor)] {
        for (index, polygon) in polygons.iter().enumerate() {
            let field = format!("{name}[{index}]");
            check_points(&field, polygon, 3)?;
            if polygon.first() == polygon.last() {
                let field = format!("{field}[{}]", polygon.len() - 1);
                return Err(WorldError::RepeatedPoint { field });
            }
            let closed: Vec<_> = polygon.iter().chain(polygon.first()).copied().collect();
            segments.extend(edges(&closed));
        }
    }
    if segments.is_empty() {
        return Err(WorldError::NoWalls);
    }
    at_most("walls", WALL_LIMIT, segments.len())?;
    Ok(segments)
}

/// Least and greatest x and y of walls, home and goal: `[x0, y0, x1, y1]`.
pub(super) fn bounds_m(file: &WorldFile, segments: &[Segment]) -> Result<[f64; 4], WorldError> {
    let places = [Vec2::new(file.home.x, file.home.y), Vec2::new(file.goal.x, file.goal.y)];
    let ends = segments.iter().flat_map(|segment| [segment.a, segment.b]);
    let start = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
    let bounds = ends.chain(places).fold(start, |[x0, y0, x1, y1], point| {
        [x0.min(point.x), y0.min(point.y), x1.max(point.x), y1.max(point.y)]
    });
    for (axis, found_m) in [('x', bounds[2] - bounds[0]), ('y', bounds[3] - bounds[1])] {
        if found_m > EXTENT_LIMIT_M {
            return Err(WorldError::TooLarge { axis, limit_m: EXTENT_LIMIT_M, found_m });
        }
    }
    Ok(bounds)
}

/// The regions, each with some place of its own inside the bounds.
pub(super) fn regions(file: &WorldFile, bounds_m: [f64; 4]) -> Result<Vec<Region>, WorldError> {
    at_most("regions", REGION_LIMIT, file.regions.len())?;
    let mut regions: Vec<Region> = Vec::with_capacity(file.regions.len());
    for (index, region) in file.regions.iter().enumerate() {
        let first = regions.iter().position(|earlier| earlier.name == region.name);
        if let Some(first) = first {
            let field = format!("regions[{index}].name");
            return Err(WorldError::DuplicateRegion { field, name: region.name.clone(), first });
        }
        regions.push(self::region(&format!("regions[{index}]"), region)?);
        check_extent(&regions, bounds_m)?;
    }
    match regions.last() {
        Some(last) if last.rules.is_empty() => Ok(regions),
        _ => Err(WorldError::NoCatchAll),
    }
}

fn region(field: &str, region: &RegionFile) -> Result<Region, WorldError> {
    if region.name.is_empty() {
        return Err(WorldError::Unnamed { field: format!("{field}.name") });
    }
    at_most(&format!("{field}.rules"), REGION_LIMIT, region.rules.len())?;
    let rules = region.rules.iter().enumerate();
    let rules = rules.map(|(index, rule)| half_plane(format!("{field}.rules[{index}]"), rule));
    Ok(Region { name: region.name.clone(), rules: rules.collect::<Result<_, _>>()? })
}

/// Whether the last region covers anything that the ones before it leave.
fn check_extent(regions: &[Region], bounds_m: [f64; 4]) -> Result<(), WorldError> {
    let index = regions.len() - 1;
    if !polygons(regions, index, bounds_m).is_empty() {
        return Ok(());
    }
    let (field, name) = (format!("regions[{index}]"), regions[index].name.clone());
    match regions[index].clip(&rectangle(bounds_m)) {
        None => Err(WorldError::EmptyRegion { field, name }),
        Some(_) => Err(WorldError::CoveredRegion { field, name }),
    }
}

fn half_plane(field: String, rule: &RuleFile) -> Result<HalfPlane, WorldError> {
    for (key, value) in [("a", rule.a), ("b", rule.b), ("above", rule.above), ("below", rule.below)]
    {
        finite(&format!("{field}.{key}"), value.unwrap_or_default())?;
    }
    let (a, b) = match (rule.axis, rule.a, rule.b) {
        (Some(Axis::X), None, None) => (1.0, 0.0),
        (Some(Axis::Y), None, None) => (0.0, 1.0),
        (None, Some(a), Some(b)) if a != 0.0 || b != 0.0 => (a, b),
        _ => {
            let problem = "must have either `axis`, or `a` and `b` that are not both 0";
            return Err(WorldError::Rule { field, problem });
        }
    };
    match (rule.above, rule.below) {
        (Some(above), None) => Ok(HalfPlane { a: -a, b: -b, below: -above }),
        (None, Some(below)) => Ok(HalfPlane { a, b, below }),
        _ => {
            let problem = "must have exactly one of `above` and `below`";
            Err(WorldError::Rule { field, problem })
        }
    }
}

fn edges(points: &[[f64; 2]]) -> impl Iterator<Item = Segment> {
    let point = |[x, y]: [f64; 2]| Vec2::new(x, y);
    points.windows(2).map(move |ends| Segment { a: point(ends[0]), b: point(ends[1]) })
}

fn check_points(field: &str, points: &[[f64; 2]], needed: usize) -> Result<(), WorldError> {
    if points.len() < needed {
        let field = field.to_owned();
        return Err(WorldError::TooFewPoints { field, needed, found: points.len() });
    }
    for (index, point) in points.iter().enumerate() {
        for (axis, value) in point.iter().enumerate() {
            finite(&format!("{field}[{index}][{axis}]"), *value)?;
        }
        if index > 0 && points[index - 1] == *point {
            return Err(WorldError::RepeatedPoint { field: format!("{field}[{index}]") });
        }
    }
    Ok(())
}

fn at_most(field: &str, limit: usize, found: usize) -> Result<(), WorldError> {
    if found > limit {
        return Err(WorldError::TooMany { field: field.to_owned(), limit, found });
    }
    Ok(())
}

fn finite(field: &str, value: f64) -> Result<(), WorldError> {
    if value.is_finite() {
        return Ok(());
    }
    Err(WorldError::NotFinite { field: field.to_owned(), found: value })
}
