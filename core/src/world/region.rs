//! Regions: the plane cut by half-planes, first match wins (Algorithm 8, section 5.6).

use crate::geometry::Vec2;

/// Area below which a piece of a region counts as nothing, square metres.
const NOTHING_M2: f64 = 1e-9;

/// The open half-plane `a·x + b·y < below`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfPlane {
    /// Factor of x.
    pub a: f64,
    /// Factor of y.
    pub b: f64,
    /// The bound, itself outside.
    pub below: f64,
}

impl HalfPlane {
    /// Whether a point lies strictly inside.
    #[must_use]
    pub fn contains(&self, point: Vec2) -> bool {
        self.a * point.x + self.b * point.y < self.below
    }

    /// The other side of the line.
    fn complement(&self) -> Self {
        Self { a: -self.a, b: -self.b, below: -self.below }
    }

    /// How far outside a point lies, in the rule's own scale; negative inside.
    fn excess(&self, point: Vec2) -> f64 {
        self.a * point.x + self.b * point.y - self.below
    }

    /// The part of a convex polygon inside (Sutherland and Hodgman).
    fn clip(&self, polygon: &[Vec2]) -> Vec<Vec2> {
        let mut kept = Vec::with_capacity(polygon.len() + 1);
        for (index, &to) in polygon.iter().enumerate() {
            let from = polygon[(index + polygon.len() - 1) % polygon.len()];
            let (before, after) = (self.excess(from), self.excess(to));
            if (before < 0.0) != (after < 0.0) {
                kept.push(from + (to - from) * (before / (before - after)));
            }
            if after < 0.0 {
                kept.push(to);
            }
        }
        kept
    }
}

/// A named region.
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    /// Name, e.g. "corridor".
    pub name: String,
    /// Rules that must all hold.
    pub rules: Vec<HalfPlane>,
}

impl Region {
    /// Whether all rules hold at a point.
    #[must_use]
    pub fn contains(&self, point: Vec2) -> bool {
        self.rules.iter().all(|rule| rule.contains(point))
    }

    /// The part of a convex polygon where all rules hold.
    pub(super) fn clip(&self, polygon: &[Vec2]) -> Option<Vec<Vec2>> {
        let kept = self.rules.iter().fold(polygon.to_vec(), |piece, rule| rule.clip(&piece));
        (area_m2(&kept) > NOTHING_M2).then_some(kept)
    }

    /// Convex pieces of a convex polygon where some rule fails.
    fn subtract(&self, polygon: &[Vec2]) -> Vec<Vec<Vec2>> {
        let mut outside = Vec::new();
        let mut inside = polygon.to_vec();
        for rule in &self.rules {
            outside.push(rule.complement().clip(&inside));
            inside = rule.clip(&inside);
        }
        outside.retain(|piece| area_m2(piece) > NOTHING_M2);
        outside
    }
}

/// Convex polygons that cover one region within a rectangle `[x0, y0, x1, y1]`.
pub(super) fn polygons(regions: &[Region], index: usize, bounds_m: [f64; 4]) -> Vec<Vec<Vec2>> {
    let own: Vec<_> = regions[index].clip(&rectangle(bounds_m)).into_iter().collect();
    regions[..index].iter().fold(own, |pieces, earlier| {
        pieces.iter().flat_map(|piece| earlier.subtract(piece)).collect()
    })
}

/// Corners of a rectangle `[x0, y0, x1, y1]`, counter-clockwise.
pub(super) fn rectangle([x0, y0, x1, y1]: [f64; 4]) -> Vec<Vec2> {
    vec![Vec2::new(x0, y0), Vec2::new(x1, y0), Vec2::new(x1, y1), Vec2::new(x0, y1)]
}

/// Area of a simple polygon, square metres.
fn area_m2(polygon: &[Vec2]) -> f64 {
    let twice: f64 = (0..polygon.len())
        .map(|index| polygon[index].perp(&polygon[(index + 1) % polygon.len()]))
        .sum();
    0.5 * twice.abs()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const BOUNDS: [f64; 4] = [-2.0, -1.0, 3.0, 4.0];

    fn any_rule() -> impl Strategy<Value = HalfPlane> {
        (-1.0..1.0f64, 0.1..1.0f64, -2.0..4.0f64).prop_map(|(a, b, below)| HalfPlane {
            a,
            b,
            below,
        })
    }

    fn any_regions() -> impl Strategy<Value = Vec<Region>> {
        let region = prop::collection::vec(any_rule(), 1..4)
            .prop_map(|rules| Region { name: String::new(), rules });
        prop::collection::vec(region, 0..4).prop_map(|mut regions| {
            regions.push(Region { name: "else".to_owned(), rules: Vec::new() });
            regions
        })
    }

    proptest! {
        #[test]
        fn the_polygons_of_all_regions_tile_the_bounds(regions in any_regions()) {
            let total: f64 = (0..regions.len())
                .flat_map(|index| polygons(&regions, index, BOUNDS))
                .map(|piece| area_m2(&piece))
                .sum();
            prop_assert!((total - 25.0).abs() < 1e-6, "{}", total);
        }

        #[test]
        fn the_middle_of_a_piece_belongs_to_its_region(regions in any_regions()) {
            for index in 0..regions.len() {
                for piece in polygons(&regions, index, BOUNDS) {
                    prop_assume!(area_m2(&piece) > 1e-6);
                    let middle = piece.iter().sum::<Vec2>() / piece.len() as f64;
                    let first = regions.iter().position(|region| region.contains(middle));
                    prop_assert_eq!(first, Some(index));
                }
            }
        }
    }
}
