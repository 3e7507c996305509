//! Lines along the axes that part labelled places: a small decision tree, after L. Breiman et al.,
//! "Classification and Regression Trees", 1984.

use crate::geometry::Vec2;
use crate::world::file::Axis;

use super::along;
use super::field::CELL_M;

/// A line must set right places of at least this area, square metres.
const WORTH_M2: f64 = 0.5;

/// A place and the part that it belongs to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    pub(super) at: Vec2,
    pub(super) label: usize,
}

/// A tree of cuts.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Node {
    /// A region; most of its places have this label.
    Leaf { label: usize },
    /// A line: the places below it, and the others.
    Cut { axis: Axis, at_m: f64, sides: Box<[Node; 2]> },
}

/// Cuts the best leaf in the best way until there are `most`, or no cut is worth it.
pub(super) fn grow(places: Vec<Place>, most: usize) -> Node {
    let mut leaves = vec![Leaf::new(places)];
    let mut cuts: Vec<(usize, Cut)> = Vec::new();
    while leaves.len() < most {
        let best = (0..leaves.len()).filter_map(|index| Some((index, leaves[index].cut?)));
        let Some((index, cut)) = best.reduce(|a, b| if b.1.gain > a.1.gain { b } else { a }) else {
            break;
        };
        let places = std::mem::take(&mut leaves[index].places);
        let (below, above) = places.into_iter().partition(|p| along(cut.axis, p.at) < cut.at_m);
        leaves[index] = Leaf::new(below);
        leaves.push(Leaf::new(above));
        cuts.push((index, cut));
    }
    assemble(&leaves, &cuts)
}

/// Joins the leaves again in the reverse order of the cuts.
fn assemble(leaves: &[Leaf], cuts: &[(usize, Cut)]) -> Node {
    let mut nodes: Vec<Node> = leaves.iter().map(|leaf| Node::Leaf { label: leaf.label }).collect();
    for &(index, Cut { axis, at_m, .. }) in cuts.iter().rev() {
        if let Some(above) = nodes.pop() {
            let below = std::mem::replace(&mut nodes[index], Node::Leaf { label: 0 });
            nodes[index] = Node::Cut { axis, at_m, sides: Box::new([below, above]) };
        }
    }
    nodes.swap_remove(0)
}

struct Leaf {
    places: Vec<Place>,
    label: usize,
    cut: Option<Cut>,
}

#[derive(Clone, Copy, Debug)]
struct Cut {
    axis: Axis,
    at_m: f64,
    gain: f64,
}

impl Leaf {
    fn new(places: Vec<Place>) -> Self {
        let counts = counts(&places);
        let label = (0..counts.len()).rev().max_by_key(|&label| counts[label]).unwrap_or(0);
        let cuts = [Axis::X, Axis::Y].into_iter().filter_map(|axis| best_cut(&places, axis));
        let cut = cuts.reduce(|a, b| if b.gain > a.gain { b } else { a });
        Self { places, label, cut }
    }
}

fn counts(places: &[Place]) -> Vec<usize> {
    let labels = places.iter().map(|place| place.label + 1).max().unwrap_or(1);
    let mut counts = vec![0; labels];
    places.iter().for_each(|place| counts[place.label] += 1);
    counts
}

/// The line along which the mixture of labels falls most (Gini's impurity); in the middle where many
/// are equally good, as within a wall.
fn best_cut(places: &[Place], axis: Axis) -> Option<Cut> {
    let mut sorted: Vec<(f64, usize)> =
        places.iter().map(|place| (along(axis, place.at), place.label)).collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut above = counts(places);
    let mut below = vec![0; above.len()];
    let whole = impurity(&above);
    let mut best: Option<Cut> = None;
    for pair in sorted.windows(2) {
        let [(at, label), (next, _)] = [pair[0], pair[1]];
        below[label] += 1;
        above[label] -= 1;
        if next - at < 0.5 * CELL_M {
            continue;
        }
        let gain = whole - impurity(&below) - impurity(&above);
        if gain > best.map_or(WORTH_M2 / (CELL_M * CELL_M), |cut| cut.gain) {
            // Half-way in the gap, on whole centimetres.
            let at_m = libm::round(50.0 * (at + next)) / 100.0;
            best = Some(Cut { axis, at_m, gain });
        }
    }
    best
}

/// Places times the chance that two drawn from them have different labels.
fn impurity(counts: &[usize]) -> f64 {
    let total: usize = counts.iter().sum();
    let squares: f64 = counts.iter().map(|&count| count as f64 * count as f64).sum();
    if total == 0 { 0.0 } else { total as f64 - squares / total as f64 }
}
