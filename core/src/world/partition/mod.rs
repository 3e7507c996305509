//! A proposed partition into regions, in the spirit of section 5.6: "the world is cut at its joints".
//!
//! The thesis draws the lines of Algorithm 8 by hand. Here they are found in three steps. A way from
//! home to goal is planned that keeps to the middle; where it passes a door or turns a corner is a
//! joint. Every place near the way belongs to the part of the way, between two joints, that is
//! nearest to it on foot; what lies beside a door on the side of the goal, where the goal draws a
//! robot into a dead end, is a bay of its own (the thesis's "concave" region). Last, lines along the
//! axes are chosen one by one that part these places best, as a decision tree does, and become rules
//! of which the first that holds wins.
//!
//! NOTE: the thesis says nothing of how to find joints; all lengths below are ours. They suit a robot
//! half a metre wide indoors.

mod field;
mod joints;
#[cfg(test)]
mod tests;
mod tree;

use super::file::{Axis, RegionFile, RuleFile};
use super::{REGION_LIMIT, World};
use field::Field;
use joints::Part;
use tree::{Node, Place};

/// Regions proposed unless told otherwise: as many as Algorithm 8 has.
pub const DEFAULT_REGIONS: usize = 4;

/// Places farther from the way than this have no say in where lines are drawn, metres.
const NEAR_M: f64 = 4.0;

/// Proposes at most `most` regions for a robot of a radius in metres. They cover everything, and each
/// has a place of its own; a world without joints has one.
#[must_use]
pub fn propose_regions(world: &World, radius_m: f64, most: usize) -> Vec<RegionFile> {
    let most = most.clamp(1, REGION_LIMIT);
    let field = Field::new(world);
    let (home, goal) = (world.home().position(), world.goal().centre);
    let way = field.way(home, goal, radius_m, field::Wish::Room);
    let parts = joints::parts(&field, &way, world, most);
    let tree = tree::grow(places(&field, &parts, world.bounds_m()), most);
    let mut regions = Vec::new();
    emit(&tree, &mut Vec::new(), &mut regions);
    name(&parts, regions)
}

/// Length of a short way from home to goal for a robot of a radius, metres: found on a grid and pulled
/// taut, so it may be some per cent longer than the shortest. None where there is no way.
#[must_use]
pub fn way_m(world: &World, radius_m: f64) -> Option<f64> {
    let field = Field::new(world);
    let (home, goal) = (world.home().position(), world.goal());
    let way = field.way(home, goal.centre, radius_m, field::Wish::Short);
    let end = field.centre(*way.last()?);
    let reached = (end - goal.centre).norm() <= goal.radius_m.max(2.0 * field::CELL_M);
    reached.then(|| field.taut_length_m(&way, radius_m))
}

/// The labelled places inside the bounds.
fn places(field: &Field, parts: &[Part], [x0, y0, x1, y1]: [f64; 4]) -> Vec<Place> {
    let labels = joints::labels(field, parts, NEAR_M);
    let labelled = labels.iter().enumerate().filter_map(|(cell, label)| Some((cell, (*label)?)));
    let places = labelled.map(|(cell, label)| Place { at: field.centre(cell), label });
    let inside = |place: &Place| (x0..=x1).contains(&place.at.x) && (y0..=y1).contains(&place.at.y);
    places.filter(inside).collect()
}

/// Turns a tree into rules. Whoever comes to the upper side of a cut did not match the lower one, so
/// only the lower sides need rules, and the last region has none (as in Algorithm 8).
fn emit(node: &Node, rules: &mut Vec<RuleFile>, regions: &mut Vec<(usize, Vec<RuleFile>)>) {
    match node {
        Node::Leaf { label } => regions.push((*label, rules.clone())),
        Node::Cut { axis, at_m, sides } => {
            let below = Some(*at_m);
            rules.push(RuleFile { axis: Some(*axis), below, ..RuleFile::default() });
            emit(&sides[0], rules, regions);
            rules.pop();
            emit(&sides[1], rules, regions);
        }
    }
}

/// Names regions by what they hold; a second region of the same part gets a number.
fn name(parts: &[Part], regions: Vec<(usize, Vec<RuleFile>)>) -> Vec<RegionFile> {
    let mut seen = vec![0; parts.len().max(1)];
    let named = regions.into_iter().map(|(label, rules)| {
        seen[label] += 1;
        let name = parts.get(label).map_or("everywhere", |part| part.name.as_str());
        let name =
            if seen[label] == 1 { name.to_owned() } else { format!("{name} {}", seen[label]) };
        RegionFile { name, rules }
    });
    named.collect()
}

/// The coordinate of a place along an axis.
fn along(axis: Axis, at: crate::geometry::Vec2) -> f64 {
    match axis {
        Axis::X => at.x,
        Axis::Y => at.y,
    }
}
