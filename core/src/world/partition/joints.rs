//! The joints of a way, the parts between them, and which places belong to which part.

use std::collections::VecDeque;

use crate::geometry::{Vec2, angle, wrap_angle};
use crate::world::World;
use crate::world::file::Axis;

use super::along;
use super::field::{CELL_M, Field};

/// A door leaves at most so much room on either side of the way, metres.
const DOOR_ROOM_M: f64 = 0.9;
/// On both sides of a door there is this many times its room,
const DOOR_WIDENING: f64 = 1.35;
/// no farther away than this, metres.
const DOOR_REACH_M: f64 = 1.5;
/// A corner is a turn of at least this, radians,
const CORNER_RAD: f64 = 0.9;
/// between so much way before and after so much more in its middle, metres.
const CORNER_REACH_M: f64 = 1.0;
/// A corner is at least so far from every door, metres; turning after a door is no joint of its own.
const CORNER_APART_M: f64 = 2.0;
/// Joints are at least so far apart and from both ends, metres.
const APART_M: f64 = 1.2;
/// The post of a door is at most so far from its middle, metres.
const BAY_REACH_M: f64 = 3.0;
/// A bay is at least so large, square metres.
const BAY_M2: f64 = 1.0;

/// A part of the world.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Part {
    /// What it is called.
    pub(super) name: String,
    kind: Kind,
}

#[derive(Clone, Debug, PartialEq)]
enum Kind {
    /// What is nearest to these cells of the way.
    Way(Vec<usize>),
    /// What of another part lies beyond a line, on the far side of it as seen from a door.
    Bay { of: usize, axis: Axis, edge_m: f64, above: bool },
}

/// A place where the way passes a door or turns.
#[derive(Clone, Copy, Debug)]
struct Joint {
    /// Index on the way.
    index: usize,
    /// How much it matters: doors before corners, narrow ones and sharp ones first.
    weight: f64,
    is_door: bool,
}

/// Parts of a way and the bays beside its doors, at most `most`.
pub(super) fn parts(field: &Field, way: &[usize], world: &World, most: usize) -> Vec<Part> {
    let joints = joints(field, way, most.saturating_sub(1));
    let mut ends: Vec<usize> = joints.iter().map(|joint| joint.index).collect();
    ends.push(way.len());
    let count = ends.len();
    let mut start = 0;
    let mut parts: Vec<Part> = ends
        .into_iter()
        .enumerate()
        .map(|(index, end)| {
            let cells = way[std::mem::replace(&mut start, end)..end].to_vec();
            Part { name: part_name(index, count), kind: Kind::Way(cells) }
        })
        .collect();
    for (before, joint) in joints.iter().enumerate().filter(|(_, joint)| joint.is_door) {
        if parts.len() < most {
            parts.extend(bay(field, way, world, before, joint.index));
        }
    }
    parts
}

fn part_name(index: usize, count: usize) -> String {
    match index {
        _ if count == 1 => "everywhere".to_owned(),
        0 => "home".to_owned(),
        _ if index + 1 == count => "goal".to_owned(),
        _ => format!("part {}", index + 1),
    }
}

/// Part of each cell that is no farther from the way than a limit, on foot.
pub(super) fn labels(field: &Field, parts: &[Part], near_m: f64) -> Vec<Option<usize>> {
    let mut labels = vec![None; field.count()];
    let mut open = VecDeque::new();
    for (label, part) in parts.iter().enumerate() {
        if let Kind::Way(cells) = &part.kind {
            for &cell in cells {
                labels[cell] = Some(label);
                open.push_back((cell, 0));
            }
        }
    }
    while let Some((cell, steps)) = open.pop_front() {
        let neighbours = field.around(cell).filter(|(_, length)| *length == 1.0);
        for (next, _) in neighbours {
            let is_open = field.room_m(next) > 0.0 && labels[next].is_none();
            if is_open && f64::from(steps) * CELL_M < near_m {
                labels[next] = labels[cell];
                open.push_back((next, steps + 1));
            }
        }
    }
    for (label, part) in parts.iter().enumerate() {
        if let Kind::Bay { of, axis, edge_m, above } = part.kind {
            label_bay(field, &mut labels, label, |cell, found| {
                let beyond = along(axis, field.centre(cell)) - edge_m;
                found == of && (beyond > 0.0) == above
            });
        }
    }
    labels
}

fn label_bay(
    field: &Field,
    labels: &mut [Option<usize>],
    label: usize,
    belongs: impl Fn(usize, usize) -> bool,
) {
    let cells = labels.iter().enumerate();
    let bay: Vec<usize> = cells
        .filter(|(cell, found)| found.is_some_and(|found| belongs(*cell, found)))
        .map(|(cell, _)| cell)
        .collect();
    let area_m2 =
        bay.iter().filter(|&&cell| field.room_m(cell) > 0.0).count() as f64 * CELL_M * CELL_M;
    if area_m2 >= BAY_M2 {
        bay.into_iter().for_each(|cell| labels[cell] = Some(label));
    }
}

/// The joints that matter most, in the order of the way.
fn joints(field: &Field, way: &[usize], most: usize) -> Vec<Joint> {
    let mut found: Vec<Joint> = doors(field, way).into_iter().chain(corners(field, way)).collect();
    found.sort_by(|a, b| b.weight.total_cmp(&a.weight));
    let mut kept: Vec<Joint> = Vec::new();
    for joint in found {
        let apart_m = if joint.is_door { APART_M } else { CORNER_APART_M };
        let far = |other: usize| joint.index.abs_diff(other) as f64 * CELL_M >= apart_m;
        let inside = far(0) && far(way.len() - 1);
        if kept.len() < most && inside && kept.iter().all(|other| far(other.index)) {
            kept.push(joint);
        }
    }
    kept.sort_by_key(|joint| joint.index);
    kept
}

fn doors(field: &Field, way: &[usize]) -> Vec<Joint> {
    let room_m: Vec<f64> = way.iter().map(|&cell| field.room_m(cell)).collect();
    let reach = (DOOR_REACH_M / CELL_M) as usize;
    let mut doors = Vec::new();
    let mut index = 0;
    while index < way.len() {
        // A thick wall makes a stretch of equal room: its middle is the door.
        let narrow = room_m[index];
        let length =
            room_m[index..].iter().take_while(|room| (*room - narrow).abs() < 1e-9).count();
        let (before, after) =
            (&room_m[index.saturating_sub(reach)..index], &room_m[index + length..]);
        let after = &after[..after.len().min(reach)];
        let least = before.iter().chain(after).copied().fold(f64::INFINITY, f64::min);
        let opens = |side: &[f64]| side.iter().any(|room| *room >= DOOR_WIDENING * narrow);
        if narrow <= DOOR_ROOM_M && narrow <= least && opens(before) && opens(after) {
            let weight = 10.0 + DOOR_ROOM_M - narrow;
            doors.push(Joint { index: index + length / 2, weight, is_door: true });
        }
        index += length;
    }
    doors
}

fn corners(field: &Field, way: &[usize]) -> Vec<Joint> {
    let reach = (CORNER_REACH_M / CELL_M) as usize;
    let direction_rad =
        |from: usize, to: usize| angle(field.centre(way[to]) - field.centre(way[from]));
    let turn_rad = |index: usize| {
        let before = direction_rad(index - 2 * reach, index - reach);
        let after = direction_rad(index + reach, index + 2 * reach);
        wrap_angle(after - before).abs()
    };
    let turns: Vec<(usize, f64)> = (2 * reach..way.len().saturating_sub(2 * reach))
        .map(|index| (index, turn_rad(index)))
        .collect();
    // A turn takes some way: its middle is the corner.
    let sharp = turns.split(|(_, turn_rad)| *turn_rad < CORNER_RAD).filter(|turn| !turn.is_empty());
    let corner = |turn: &[(usize, f64)]| {
        let weight = turn.iter().map(|(_, turn_rad)| *turn_rad).fold(0.0, f64::max);
        Joint { index: turn[turn.len() / 2].0, weight, is_door: false }
    };
    sharp.map(corner).collect()
}

/// The bay before a door, if the goal lies beside the door and not behind it.
fn bay(field: &Field, way: &[usize], world: &World, before: usize, index: usize) -> Option<Part> {
    let around = |k: isize| field.centre(way[index.saturating_add_signed(k).min(way.len() - 1)]);
    let through = around(4) - around(-4);
    let (axis, direction) =
        if through.x.abs() > through.y.abs() { (Axis::Y, Vec2::y()) } else { (Axis::X, Vec2::x()) };
    let (at, goal) = (field.centre(way[index]), along(axis, world.goal().centre));
    let above = goal > along(axis, at);
    let direction = if above { direction } else { -direction };
    // From the middle of the door to its post on the goal's side.
    let post = world.nearest_m(at, direction, BAY_REACH_M)?;
    let edge_m = along(axis, at + direction * post.distance_m);
    let beyond = if above { goal > edge_m } else { goal < edge_m };
    let name = if before == 0 { "bay".to_owned() } else { format!("bay {}", before + 1) };
    beyond.then(|| Part { name, kind: Kind::Bay { of: before, axis, edge_m, above } })
}
