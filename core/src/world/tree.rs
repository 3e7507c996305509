//! A tree of boxes over the walls, so that a question about a place looks only at what is near it.
//!
//! Each node holds four boxes side by side, each leaf up to four segments. A walk goes to the
//! nearest box first and leaves out what a [`Seeker`] need not see. That can never change an answer:
//! seekers take least values, which do not depend on the order, and their bounds allow for rounding.

use crate::geometry::Vec2;

use super::segments::{Leaf, Segment};

/// Boxes in a node, and segments in a leaf, handled together.
pub(super) const LANES: usize = 4;

/// Leaves of a world so small that looking at all of them is faster than deciding which; a power of two.
pub(super) const FEW: usize = 16;

/// Boxes a walk can put off: three a level, so enough for a million segments.
const PUT_OFF: usize = 32;

/// A segment with its index in the world's order.
pub(super) type Item = (u32, Segment);

/// Boxes within boxes, the segments in the leaves.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tree {
    nodes: Vec<Node>,
    leaves: Vec<Leaf>,
}

/// Four boxes, coordinate by coordinate, metres. One without contents lies infinitely far away.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Node {
    x0: [f64; LANES],
    y0: [f64; LANES],
    x1: [f64; LANES],
    y1: [f64; LANES],
    children: [Child; LANES],
}

/// What is in a box: the index of a node or of a leaf.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Child {
    Node(u32),
    Leaf(u32),
}

/// Four boxes by their middles and half their sides, metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Middles {
    pub(super) x: [f64; LANES],
    pub(super) y: [f64; LANES],
    pub(super) half_x: [f64; LANES],
    pub(super) half_y: [f64; LANES],
}

/// Who walks a tree: what it looks for, and what it has found so far.
pub(super) trait Seeker {
    /// What a seeker notes about a box that it puts off.
    type Note: Copy + Default;

    /// How far the boxes of a node are at least, in a measure of the seeker's own, 0 or more, and what
    /// to note about them; infinite for boxes that do not matter.
    fn boxes(&self, node: &Node) -> ([f64; LANES], [Self::Note; LANES]);

    /// Whether a box still matters after what was found since it was put off.
    fn matters(&self, distance: f64, note: Self::Note) -> bool;

    /// Looks at the segments of a leaf.
    fn look(&mut self, leaf: &Leaf);
}

impl Tree {
    /// A tree over segments, of which there must be at least one.
    pub(super) fn new(segments: &[Segment]) -> Self {
        let mut items: Vec<_> = (0_u32..).zip(segments.iter().copied()).collect();
        let mut tree = Self { nodes: Vec::new(), leaves: Vec::new() };
        tree.add_node(&mut items);
        tree
    }

    /// All leaves, if there are few.
    #[inline(always)]
    pub(super) fn few_leaves(&self) -> Option<&[Leaf]> {
        (self.leaves.len() <= FEW).then_some(&self.leaves)
    }

    /// Lets a seeker look at whatever matters to it.
    #[inline(always)]
    pub(super) fn walk<S: Seeker>(&self, seeker: &mut S) {
        let mut put_off = PutOff { boxes: [(0.0, 0, S::Note::default()); PUT_OFF], count: 0 };
        let mut next = Some(0);
        while let Some(node) = next {
            put_off.add(node, seeker.boxes(&self.nodes[node as usize]));
            next = self.look_until_node(&mut put_off, seeker);
        }
    }

    /// Looks at leaves until the nearest of the boxes holds a node.
    #[inline(always)]
    fn look_until_node<S: Seeker>(
        &self,
        put_off: &mut PutOff<S::Note>,
        seeker: &mut S,
    ) -> Option<u32> {
        while let Some((distance, place, note)) = put_off.take() {
            if seeker.matters(distance, note) {
                let (node, lane) = (place as usize / LANES, place as usize % LANES);
                match self.nodes[node].children[lane] {
                    Child::Node(index) => return Some(index),
                    Child::Leaf(index) => seeker.look(&self.leaves[index as usize]),
                }
            }
        }
        None
    }

    /// Adds the node over some segments and all below it; gives its index.
    fn add_node(&mut self, items: &mut [Item]) -> u32 {
        let index = self.nodes.len();
        self.nodes.push(Node::empty());
        let (first, second) = halves(items);
        let quarters = [halves(first), halves(second)].map(|(a, b)| [a, b]);
        for (lane, quarter) in quarters.into_iter().flatten().enumerate() {
            if quarter.is_empty() {
                continue;
            }
            self.nodes[index].put_box(lane, quarter);
            let child = if quarter.len() <= LANES {
                self.leaves.push(Leaf::new(quarter));
                Child::Leaf(count(self.leaves.len() - 1))
            } else {
                Child::Node(self.add_node(quarter))
            };
            self.nodes[index].children[lane] = child;
        }
        count(index)
    }
}

impl Node {
    fn empty() -> Self {
        let nowhere = [f64::INFINITY; LANES];
        let children = [Child::Leaf(0); LANES];
        Self { x0: nowhere, y0: nowhere, x1: nowhere, y1: nowhere, children }
    }

    /// Sets the box of a lane to the least that holds some segments.
    fn put_box(&mut self, lane: usize, items: &[Item]) {
        let ends = || items.iter().flat_map(|(_, segment)| [segment.a, segment.b]);
        self.x0[lane] = ends().map(|end| end.x).fold(f64::INFINITY, f64::min);
        self.y0[lane] = ends().map(|end| end.y).fold(f64::INFINITY, f64::min);
        self.x1[lane] = ends().map(|end| end.x).fold(f64::NEG_INFINITY, f64::max);
        self.y1[lane] = ends().map(|end| end.y).fold(f64::NEG_INFINITY, f64::max);
    }

    /// Squared distances from a point to the boxes, m².
    #[inline(always)]
    pub(super) fn distances2(&self, point: Vec2) -> [f64; LANES] {
        let mut distances2 = [0.0; LANES];
        for (k, distance2) in distances2.iter_mut().enumerate() {
            let dx = greater(greater(self.x0[k] - point.x, point.x - self.x1[k]), 0.0);
            let dy = greater(greater(self.y0[k] - point.y, point.y - self.y1[k]), 0.0);
            *distance2 = dx * dx + dy * dy;
        }
        distances2
    }

    /// Middles and half sides of the boxes; no numbers for one without contents.
    #[inline(always)]
    pub(super) fn middles(&self) -> Middles {
        let Self { x0, y0, x1, y1, .. } = self;
        Middles {
            x: std::array::from_fn(|k| (x0[k] + x1[k]) * 0.5),
            y: std::array::from_fn(|k| (y0[k] + y1[k]) * 0.5),
            half_x: std::array::from_fn(|k| (x1[k] - x0[k]) * 0.5),
            half_y: std::array::from_fn(|k| (y1[k] - y0[k]) * 0.5),
        }
    }
}

/// Boxes put off, the nearest of each node on top: distance, index of node and lane in one, and note.
struct PutOff<Note> {
    boxes: [(f64, u32, Note); PUT_OFF],
    count: usize,
}

impl<Note: Copy> PutOff<Note> {
    #[inline(always)]
    fn add(&mut self, node: u32, (distances, notes): ([f64; LANES], [Note; LANES])) {
        for (distance, lane) in farthest_first(distances) {
            if distance < f64::INFINITY {
                self.boxes[self.count] =
                    (distance, node * LANES as u32 + lane, notes[lane as usize]);
                self.count += 1;
            }
        }
    }

    #[inline(always)]
    fn take(&mut self) -> Option<(f64, u32, Note)> {
        self.count = self.count.checked_sub(1)?;
        Some(self.boxes[self.count])
    }
}

/// Distances with their lanes in descending order; rounded down in the last two bits, which carry
/// the lane while sorting. Numbers that are not negative are ordered like their bits.
#[inline(always)]
fn farthest_first(distances: [f64; LANES]) -> [(f64, u32); LANES] {
    let mut keys: [u64; LANES] =
        std::array::from_fn(|lane| distances[lane].to_bits() & !3 | lane as u64);
    for (i, j) in [(0, 1), (2, 3), (0, 2), (1, 3), (1, 2)] {
        (keys[i], keys[j]) = (keys[i].max(keys[j]), keys[i].min(keys[j]));
    }
    keys.map(|key| (f64::from_bits(key & !3), (key & 3) as u32))
}

/// Cuts segments in two halves across the longer side of where their middles lie. The first fills
/// whole leaves; what fits in one leaf is not cut.
fn halves(items: &mut [Item]) -> (&mut [Item], &mut [Item]) {
    let first = (items.len() / 2).next_multiple_of(LANES);
    if first >= items.len() {
        return items.split_at_mut(items.len());
    }
    let middle = |segment: &Segment| segment.a + segment.b;
    let extent = |along: fn(Vec2) -> f64| {
        let all = items.iter().map(|(_, segment)| along(middle(segment)));
        all.clone().fold(f64::NEG_INFINITY, f64::max) - all.fold(f64::INFINITY, f64::min)
    };
    let along: fn(Vec2) -> f64 =
        if extent(|point| point.x) < extent(|point| point.y) { |p| p.y } else { |p| p.x };
    items.select_nth_unstable_by(first, |(i, s), (j, t)| {
        along(middle(s)).total_cmp(&along(middle(t))).then(i.cmp(j))
    });
    items.split_at_mut(first)
}

/// An index as it is kept; a world has far fewer walls than fit.
#[expect(clippy::cast_possible_truncation, reason = "far below 2^32 / 4 by the limit on walls")]
fn count(index: usize) -> u32 {
    index as u32
}

#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// The lesser of two numbers, neither of which is NaN.
#[inline(always)]
pub(super) fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::world::examples::any_segments;

    /// Looks at everything.
    struct All(Vec<u32>);

    impl Seeker for All {
        type Note = ();

        fn boxes(&self, node: &Node) -> ([f64; LANES], [(); LANES]) {
            (node.distances2(Vec2::zeros()), [(); LANES])
        }

        fn matters(&self, _: f64, (): ()) -> bool {
            true
        }

        fn look(&mut self, leaf: &Leaf) {
            self.0.extend(&leaf.index[..leaf.count]);
        }
    }

    proptest! {
        #[test]
        fn every_segment_is_in_one_leaf(walls in any_segments()) {
            let mut all = All(Vec::new());
            Tree::new(&walls).walk(&mut all);
            all.0.sort_unstable();
            prop_assert_eq!(all.0, (0..walls.len() as u32).collect::<Vec<_>>());
        }
    }
}
