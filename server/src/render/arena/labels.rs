//! Names in the arena, put where they hide as little as possible.

use super::Canvas;
use crate::render::scene::{Anchor, Colour, Point, Primitive, Scene, Text};
use crate::render::text::{self, CAP_HEIGHT};

impl Canvas<'_> {
    /// The names of the regions, of home and of the goal.
    pub(super) fn names(&self, scene: &mut Scene) {
        if self.layout.is_thumbnail {
            return;
        }
        let mut taken = self.place_names(scene);
        for region in &self.view.regions {
            self.region_name(scene, region, &mut taken);
        }
    }

    /// Home and goal; gives back the points that names should keep clear of.
    fn place_names(&self, scene: &mut Scene) -> Vec<Point> {
        let mut taken = self.at.path(&self.view.path_m, self.px(8.0));
        taken.extend(self.view.neurons.iter().filter_map(|neuron| self.at.place(neuron.at_m)));
        taken.extend(self.at.path(&self.view.best_path_m, self.px(12.0)));
        taken.extend(self.at.places(&self.view.collisions_m));
        let gap = self.px(13.0);
        let goal_px = self.at.length(self.view.goal_radius_m).min(self.px(200.0));
        for (name, place, below, colour) in [
            ("goal", self.goal_place(), goal_px + self.px(5.0), self.theme.goal),
            ("home", self.at.place(self.view.home.at_m), gap, self.theme.ink),
        ] {
            let Some([x, y]) = place else { continue };
            let down = y + below + self.layout.font * CAP_HEIGHT;
            let baseline = if down < self.at.frame()[3] { down } else { y - below };
            let at = self.inside(name, [x, baseline]);
            self.label(scene, name, at, colour);
            taken.extend(self.box_points(name, at));
        }
        taken.extend(self.view.robot.iter().filter_map(|robot| self.at.place(robot.pose.at_m)));
        taken
    }

    fn region_name(
        &self,
        scene: &mut Scene,
        region: &crate::render::view::RegionView,
        taken: &mut Vec<Point>,
    ) {
        let polygons: Vec<Vec<Point>> =
            region.polygons_m.iter().map(|polygon| self.at.places(polygon)).collect();
        let Some(polygon) = polygons.iter().max_by(|a, b| area(a).total_cmp(&area(b))) else {
            return;
        };
        let name = text::fitted(&region.name, self.layout.font, self.px(180.0));
        let half = [
            text::width_px(&name, self.layout.font) / 2.0 + self.px(7.0),
            self.layout.font * 0.5 + self.px(7.0),
        ];
        let place = clear_place(polygon, half, taken).or_else(|| middle(polygon));
        let Some([x, y]) = place else { return };
        let at = self.inside(&name, [x, y + self.layout.font * CAP_HEIGHT / 2.0]);
        self.label(scene, &name, at, self.theme.faint_ink);
        taken.extend(self.box_points(&name, at));
    }

    /// Moves a label's middle so far that all of it stands in the arena.
    fn inside(&self, name: &str, [x, y]: Point) -> Point {
        let half = text::width_px(name, self.layout.font) / 2.0;
        let [left, _, right, _] = self.at.frame();
        [x.min(right - half).max(left + half), y]
    }

    fn label(&self, scene: &mut Scene, name: &str, at: Point, colour: Colour) {
        scene.push(Primitive::Text(Text {
            at,
            text: name.to_owned(),
            size: self.layout.font,
            anchor: Anchor::Middle,
            colour,
            halo: Some((self.theme.background, self.px(2.2))),
        }));
    }

    /// Points along a label that stand for it when others look for room.
    fn box_points(&self, name: &str, [x, baseline]: Point) -> [Point; 3] {
        let half = text::width_px(name, self.layout.font) / 2.0;
        let y = baseline - self.layout.font * CAP_HEIGHT / 2.0;
        [[x - half, y], [x, y], [x + half, y]]
    }
}

/// Places tried along each side of a region.
const TRIES: usize = 24;

/// The centre for a box (half width, half height) inside the polygon that covers the fewest taken
/// points; of equals the one nearest to the top.
fn clear_place(polygon: &[Point], half: [f32; 2], taken: &[Point]) -> Option<Point> {
    let [left, top, right, bottom] = extent(polygon)?;
    let mut best: Option<(usize, Point)> = None;
    for row in 0..=TRIES {
        for column in 0..=TRIES {
            let share = |i: usize| i as f32 / TRIES as f32;
            let x = left + half[0] + (right - left - 2.0 * half[0]) * share(column);
            let y = top + half[1] + (bottom - top - 2.0 * half[1]) * share(row);
            if !holds_box(polygon, [x, y], half) {
                continue;
            }
            let covers = |p: &&Point| (p[0] - x).abs() < half[0] && (p[1] - y).abs() < half[1];
            let covered = taken.iter().filter(covers).count();
            if best.is_none_or(|(least, _)| covered < least) {
                best = Some((covered, [x, y]));
            }
        }
    }
    best.map(|(_, place)| place)
}

fn holds_box(polygon: &[Point], [x, y]: Point, [half_x, half_y]: [f32; 2]) -> bool {
    // A hair inside, so that a box that just fills a rectangle counts as inside.
    let (half_x, half_y) = (half_x - 0.05, half_y - 0.05);
    [-1.0, 0.0, 1.0].iter().all(|sx| {
        [-1.0, 0.0, 1.0].iter().all(|sy| contains(polygon, [x + sx * half_x, y + sy * half_y]))
    })
}

fn contains(polygon: &[Point], [x, y]: Point) -> bool {
    let mut inside = false;
    for (i, &[x1, y1]) in polygon.iter().enumerate() {
        let [x0, y0] = polygon[(i + polygon.len() - 1) % polygon.len()];
        if (y0 > y) != (y1 > y) && x < x0 + (y - y0) / (y1 - y0) * (x1 - x0) {
            inside = !inside;
        }
    }
    inside
}

fn extent(polygon: &[Point]) -> Option<[f32; 4]> {
    let (first, rest) = polygon.split_first()?;
    Some(rest.iter().fold([first[0], first[1], first[0], first[1]], |e, p| {
        [e[0].min(p[0]), e[1].min(p[1]), e[2].max(p[0]), e[3].max(p[1])]
    }))
}

fn middle(polygon: &[Point]) -> Option<Point> {
    extent(polygon).map(|[left, top, right, bottom]| [(left + right) / 2.0, (top + bottom) / 2.0])
}

fn area(polygon: &[Point]) -> f32 {
    let crossed = |i: usize| {
        let ([x0, y0], [x1, y1]) = (polygon[i], polygon[(i + 1) % polygon.len()]);
        x0 * y1 - x1 * y0
    };
    (0..polygon.len()).map(crossed).sum::<f32>().abs() / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROOM: [Point; 6] =
        [[0.0, 0.0], [100.0, 0.0], [100.0, 40.0], [50.0, 40.0], [50.0, 100.0], [0.0, 100.0]];

    #[test]
    fn names_stay_inside_and_off_the_taken_points() {
        for (half, taken, expected) in [
            ([10.0, 5.0], vec![], Some([10.0, 5.0])),
            ([40.0, 5.0], vec![], Some([40.0, 5.0])),
            ([60.0, 5.0], vec![], None),
            ([10.0, 45.0], vec![], Some([10.0, 45.0])),
        ] {
            assert_eq!(clear_place(&ROOM, half, &taken), expected, "{half:?}");
        }
        let crowd: Vec<Point> = (0..100).map(|x| [x as f32, 5.0]).collect();
        let [_, y] = clear_place(&ROOM, [10.0, 5.0], &crowd).expect("room below the crowd");
        assert!(y >= 10.0, "{y}");
    }

    #[test]
    fn areas_and_insides() {
        assert_eq!(area(&ROOM), 7000.0);
        assert_eq!(area(&[]), 0.0);
        for (point, inside) in [([25.0, 75.0], true), ([75.0, 75.0], false), ([75.0, 20.0], true)] {
            assert_eq!(contains(&ROOM, point), inside, "{point:?}");
        }
    }
}
