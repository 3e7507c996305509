//! Where the robot has been, kept small enough for any number of trials.

use std::sync::Arc;

use crate::wire::TickView;

/// Earlier trials whose path is kept.
const KEPT: usize = 40;
/// Points kept of an earlier path; the path under way keeps all of them.
const POINTS: usize = 240;

/// A path as true positions, metres.
type Path = Vec<[f64; 2]>;

/// The paths of a session.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Paths {
    /// The last trials that ended, oldest first.
    pub earlier: Arc<Vec<Arc<Path>>>,
    /// The best trial that reached the goal.
    pub best: Option<Arc<Path>>,
    /// The trial under way.
    pub present: Path,
    /// Where the robot collided in the trial under way.
    pub collisions: Path,
}

impl Paths {
    /// The robot made this step.
    pub fn follow(&mut self, tick: &TickView) {
        if self.present.is_empty() {
            self.present.push([tick.true_pose.x_m, tick.true_pose.y_m]);
        }
        let after = &tick.outcome;
        let at_m = [after.true_pose.x_m, after.true_pose.y_m];
        self.present.push(at_m);
        if after.contact != "none" {
            self.collisions.push(at_m);
        }
    }

    /// The trial ended; `record` when it is the best so far.
    pub fn end_trial(&mut self, record: bool) {
        let path = Arc::new(thinned(&self.present, POINTS));
        self.present.clear();
        self.collisions.clear();
        if record {
            self.best = Some(path.clone());
        }
        let earlier = Arc::make_mut(&mut self.earlier);
        earlier.push(path);
        if earlier.len() > KEPT {
            earlier.remove(0);
        }
    }

    /// Forgets the trial under way.
    pub fn drop_trial(&mut self) {
        self.present.clear();
        self.collisions.clear();
    }
}

/// At most `points` of a path, its ends among them.
fn thinned(path: &[[f64; 2]], points: usize) -> Path {
    if path.len() <= points {
        return path.to_vec();
    }
    (0..points).map(|k| path[k * (path.len() - 1) / (points - 1)]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn five_hundred_long_trials_stay_small() {
        let mut paths = Paths::default();
        for trial in 0..500 {
            for step in 0..2000 {
                paths.present.push([f64::from(trial), f64::from(step)]);
            }
            paths.end_trial(trial == 3);
        }
        assert_eq!(paths.earlier.len(), KEPT);
        assert!(paths.earlier.iter().all(|path| path.len() == POINTS));
        assert_eq!(paths.earlier[0].first(), Some(&[460.0, 0.0]));
        assert_eq!(paths.earlier[0].last(), Some(&[460.0, 1999.0]));
        assert_eq!(paths.best.as_deref().and_then(|path| path.first()), Some(&[3.0, 0.0]));
        assert!(paths.present.is_empty());
    }
}
