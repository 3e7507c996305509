//! The floor of chapter 2 as a picture, with the way of a run on it.

use crate::render::{ArenaView, PathOf, RobotPose};
use crate::wire::{CourseView, CycleView, DriveOutcome, DriveRunView};

/// Floors at least so many times as long as wide are drawn in strips, one below the other.
const SLENDER: f64 = 4.0;
/// Width over height of the picture that the strips should fill.
const ASPECT: f64 = 1.5;
/// Room between two strips, metres.
const GAP_M: f64 = 0.8;
/// No place: what lies there is not drawn.
const NOWHERE: [f64; 2] = [f64::NAN; 2];

/// How a floor is laid out in a picture: whole, or cut across into strips, the first on top.
struct Strips {
    count: usize,
    /// Length of each, metres.
    length_m: f64,
    bounds_m: [f64; 4],
}

impl Strips {
    fn of(bounds_m: [f64; 4]) -> Self {
        let [x0, y0, x1, y1] = bounds_m;
        let (length_m, width_m) = (x1 - x0, y1 - y0);
        let count = if length_m < SLENDER * width_m {
            1
        } else {
            strips((length_m / (ASPECT * (width_m + GAP_M))).sqrt())
        };
        Self { count, length_m: length_m / count as f64, bounds_m }
    }

    /// What the strips cover together, metres.
    fn covered_m(&self) -> [f64; 4] {
        let [x0, y0, _, y1] = self.bounds_m;
        let down_m = (self.count - 1) as f64 * (y1 - y0 + GAP_M);
        [x0, y0 - down_m, x0 + self.length_m, y1]
    }

    /// The strip that a place along the floor lies in.
    fn strip(&self, x_m: f64) -> usize {
        let along = (x_m - self.bounds_m[0]) / self.length_m;
        (1..self.count).take_while(|strip| along >= *strip as f64).count()
    }

    /// Where a place comes to lie that is drawn in a strip.
    fn placed(&self, strip: usize, [x, y]: [f64; 2]) -> [f64; 2] {
        let [_, y0, _, y1] = self.bounds_m;
        let strip = strip as f64;
        [x - strip * self.length_m, y - strip * (y1 - y0 + GAP_M)]
    }

    fn place(&self, place: [f64; 2]) -> [f64; 2] {
        self.placed(self.strip(place[0]), place)
    }

    /// The parts of a face, one in each strip that it reaches into.
    fn cut(&self, [ax, ay, bx, by]: [f64; 4]) -> Vec<[f64; 4]> {
        let (first, last) = (self.strip(ax.min(bx)), self.strip(ax.max(bx)));
        let part = |strip: usize| {
            let from_m = self.bounds_m[0] + strip as f64 * self.length_m;
            let within = |x: f64| x.clamp(from_m, from_m + self.length_m);
            let at = |x: f64| if ax == bx { ay } else { ay + (x - ax) / (bx - ax) * (by - ay) };
            // Where it is not cut, its end is kept as it is.
            let end =
                |x: f64, y: f64| if within(x) == x { [x, y] } else { [within(x), at(within(x))] };
            let [a, b] = [end(ax, ay), end(bx, by)].map(|end| self.placed(strip, end));
            [a[0], a[1], b[0], b[1]]
        };
        (first..=last).map(part).collect()
    }

    /// A way, interrupted by no place where it goes on in another strip.
    fn way(&self, places: impl Iterator<Item = [f64; 2]>) -> Vec<[f64; 2]> {
        let mut way = Vec::new();
        let mut before = None;
        for place in places {
            let strip = self.strip(place[0]);
            if before.is_some_and(|before| before != strip) {
                way.push(NOWHERE);
            }
            way.push(self.placed(strip, place));
            before = Some(strip);
        }
        way
    }
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "from 1 to 50 by the clamp"
)]
fn strips(count: f64) -> usize {
    count.round().clamp(1.0, 50.0) as usize
}

/// The floor with the way of some cycles, and where something was touched.
pub(super) fn drive_arena(course: &CourseView, cycles: &[CycleView], caption: String) -> ArenaView {
    let strips = Strips::of(course.bounds_m);
    let at = |cycle: &CycleView| [cycle.pose.x_m, cycle.pose.y_m];
    ArenaView {
        bounds_m: strips.covered_m(),
        walls_m: course.faces.iter().flat_map(|face| strips.cut(face.segment_m)).collect(),
        home: RobotPose { at_m: NOWHERE, heading_rad: 0.0 },
        path_m: strips.way(cycles.iter().map(at)),
        path_of: PathOf::Run,
        collisions_m: (cycles.iter().filter(|cycle| cycle.bump.is_some()))
            .map(|cycle| strips.place(at(cycle)))
            .collect(),
        caption: if strips.count == 1 {
            caption
        } else {
            format!("{caption}; {:.1} m a strip", strips.length_m)
        },
        ..ArenaView::default()
    }
}

/// What came of a run, in words.
pub(super) fn run_caption(run: &DriveRunView) -> String {
    let DriveRunView { run: number, method, .. } = run;
    match &run.outcome {
        DriveOutcome::Drive(score) => {
            let contacts = score.wall_contacts
                + score.door_contacts
                + score.block_contacts
                + score.people_contacts;
            format!("Run {number} by {method}: {:.0} s, {contacts} contacts", score.time_s)
        }
        DriveOutcome::Approach { .. } => format!("Run {number}: {} cycles", run.cycles),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORRIDOR_M: [f64; 4] = [0.0, -1.2, 100.0, 1.2];

    #[test]
    fn a_long_floor_is_cut_into_strips_that_fill_the_picture() {
        let strips = Strips::of(CORRIDOR_M);
        // √(100 / (1.5 · 3.2)) = 4.6
        assert_eq!((strips.count, strips.length_m), (5, 20.0));
        assert_eq!(strips.covered_m(), [0.0, -1.2 - 4.0 * 3.2, 20.0, 1.2]);
        assert_eq!(strips.place([19.9, 0.5]), [19.9, 0.5]);
        let [x, y] = strips.place([45.0, 0.5]);
        assert!((x - 5.0).abs() < 1e-12 && (y - (0.5 - 6.4)).abs() < 1e-12);
        assert_eq!(strips.strip(100.0), 4, "its end lies in the last");
        assert_eq!(Strips::of([0.0, 0.0, 9.5, 8.0]).count, 1);
    }

    #[test]
    fn a_wall_loses_nothing_where_it_is_cut() {
        let strips = Strips::of(CORRIDOR_M);
        let length = |[ax, ay, bx, by]: [f64; 4]| (bx - ax).hypot(by - ay);
        for wall in [[100.0, 1.2, 0.0, 1.2], [10.0, -1.0, 50.0, 1.0], [25.0, 0.9, 25.0, 1.2]] {
            let parts = strips.cut(wall);
            let sum: f64 = parts.iter().copied().map(length).sum();
            assert!((sum - length(wall)).abs() < 1e-9, "{wall:?}: {parts:?}");
            let covered = strips.covered_m();
            for [ax, ay, bx, by] in parts {
                for (x, y) in [(ax, ay), (bx, by)] {
                    assert!((covered[0] - 1e-9..=covered[2] + 1e-9).contains(&x), "{wall:?}");
                    assert!((covered[1] - 1e-9..=covered[3] + 1e-9).contains(&y), "{wall:?}");
                }
            }
        }
        let whole = Strips::of([0.0, 0.0, 9.5, 8.0]);
        assert_eq!(whole.cut([1.0, 2.0, 3.0, 7.0]), [[1.0, 2.0, 3.0, 7.0]]);
    }

    #[test]
    fn a_way_is_interrupted_between_strips() {
        let strips = Strips::of(CORRIDOR_M);
        let way = strips.way([[19.0, 0.0], [19.9, 0.0], [20.1, 0.0], [19.8, 0.1]].into_iter());
        let gaps: Vec<usize> = (0..way.len()).filter(|k| way[*k][0].is_nan()).collect();
        assert_eq!((way.len(), gaps), (6, vec![2, 4]));
    }
}
