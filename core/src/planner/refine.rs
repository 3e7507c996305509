//! A path made cheaper by changing its headings: one alone, two against each other, a block together,
//! one step more or less. Changes begin large and become small; each is tried on the driver itself and
//! kept when the whole path is cheaper.

use super::drive::{Driver, Place};

/// Changes of headings, degrees, large first.
const CHANGES_DEG: [f64; 9] = [24.0, 12.0, 6.0, 3.0, 1.5, 0.75, 0.3, 0.1, 0.03];
/// Most rounds over a path with one size of change.
const ROUNDS: usize = 5;
/// Most steps between two headings that are changed together.
const REACH: usize = 20;
/// Least gain that counts.
const GAIN: f64 = 1e-9;

/// Headings of a path that none of the changes makes cheaper. After its headings a path goes straight
/// to the goal, which costs nothing unless something is near.
pub(super) fn refine(driver: &mut Driver<'_>, headings: Vec<f64>) -> Vec<f64> {
    let mut line = Line::new(driver, headings);
    for change_deg in CHANGES_DEG {
        let change_rad = change_deg.to_radians();
        for _ in 0..ROUNDS {
            let before = line.cost;
            line.round(driver, change_rad);
            if line.cost > before - GAIN {
                break;
            }
        }
    }
    line.headings
}

/// A path with what its beginnings cost.
struct Line {
    headings: Vec<f64>,
    /// Where each heading is taken, and what was paid until then.
    starts: Vec<(Place, f64)>,
    /// What the whole path costs; infinite when it misses the goal.
    cost: f64,
}

impl Line {
    fn new(driver: &mut Driver<'_>, headings: Vec<f64>) -> Self {
        let mut line = Self { headings, starts: Vec::new(), cost: f64::INFINITY };
        line.settle(driver);
        line
    }

    /// Computes what the beginnings cost, and drops headings after the goal.
    fn settle(&mut self, driver: &mut Driver<'_>) {
        self.starts = vec![(driver.home(), 0.0)];
        for (index, &heading_rad) in self.headings.iter().enumerate() {
            let (place, paid) = self.starts[index];
            let taken = driver.step(place, heading_rad);
            self.starts.push((taken.to, paid + taken.penalty));
            if driver.at_goal(taken.to) {
                break;
            }
        }
        self.headings.truncate(self.starts.len() - 1);
        let whole = cost(driver, self.starts[0], &self.headings, f64::INFINITY);
        self.cost = whole.unwrap_or(f64::INFINITY);
    }

    /// Tries every change of one size at every place.
    fn round(&mut self, driver: &mut Driver<'_>, change_rad: f64) {
        let mut first = 0;
        while first < self.headings.len() {
            self.try_count(driver, first);
            let mut last = first;
            while last < self.headings.len().min(first + REACH) {
                for turn_rad in [change_rad, -change_rad] {
                    self.try_turn(driver, first, last, turn_rad);
                }
                last += 1;
            }
            first += 1;
        }
    }

    /// A block turned together, and its two ends turned against each other.
    fn try_turn(&mut self, driver: &mut Driver<'_>, first: usize, last: usize, turn_rad: f64) {
        if last >= self.headings.len() {
            return;
        }
        let mut block = self.headings.clone();
        block[first..=last].iter_mut().for_each(|heading_rad| *heading_rad += turn_rad);
        self.take_cheaper(driver, first, block);
        if first < last && last < self.headings.len() {
            let mut ends = self.headings.clone();
            ends[first] += turn_rad;
            ends[last] -= turn_rad;
            self.take_cheaper(driver, first, ends);
        }
    }

    /// A step less, a step more.
    fn try_count(&mut self, driver: &mut Driver<'_>, index: usize) {
        let mut fewer = self.headings.clone();
        fewer.remove(index);
        self.take_cheaper(driver, index, fewer);
        if let Some(&heading_rad) = self.headings.get(index) {
            let mut more = self.headings.clone();
            more.insert(index, heading_rad);
            self.take_cheaper(driver, index, more);
        }
    }

    /// Takes headings that differ from `first` on, if the path is cheaper with them.
    fn take_cheaper(&mut self, driver: &mut Driver<'_>, first: usize, headings: Vec<f64>) {
        let limit = self.cost - GAIN;
        if cost(driver, self.starts[first], &headings[first..], limit).is_some() {
            self.headings = headings;
            self.settle(driver);
        }
    }
}

/// What a path costs that goes on with these headings and then straight to the goal; none when that is
/// not below a limit.
fn cost(
    driver: &mut Driver<'_>,
    (mut place, mut paid): (Place, f64),
    headings: &[f64],
    limit: f64,
) -> Option<f64> {
    for step in 0..driver.most_steps(headings.len()) {
        let heading_rad = headings.get(step).copied().unwrap_or_else(|| driver.to_goal_rad(place));
        let taken = driver.step(place, heading_rad);
        (place, paid) = (taken.to, paid + taken.penalty);
        if paid >= limit {
            return None;
        }
        if driver.at_goal(place) {
            return Some(paid);
        }
    }
    None
}
