//! What a picture of the arena shows: plain data, filled from the log or from a live session.

/// Everything drawn in a picture of the arena. Lengths in metres, angles in radians, world frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ArenaView {
    /// Least and greatest x and y to show: `[x0, y0, x1, y1]`.
    pub bounds_m: [f64; 4],
    /// Walls as segments `[x0, y0, x1, y1]`.
    pub walls_m: Vec<[f64; 4]>,
    /// Solid blocks as closed polygons.
    pub blocks_m: Vec<Vec<[f64; 2]>>,
    /// Regions: name and the part of the bounds it covers, as polygons.
    pub regions: Vec<RegionView>,
    /// Start of every trial and its heading; not shown if its place is not finite.
    pub home: RobotPose,
    /// Centre of the goal.
    pub goal_m: [f64; 2],
    /// Radius of the goal; there is none if it is not positive.
    pub goal_radius_m: f64,
    /// Paths of earlier trials, oldest first; only the newest [`super::MOST_GHOSTS`] are drawn.
    pub earlier_paths_m: Vec<Vec<[f64; 2]>>,
    /// Path of the best trial so far, if it is not the one shown.
    pub best_path_m: Vec<[f64; 2]>,
    /// The cheapest path that a planner finds.
    pub planned_path_m: Vec<[f64; 2]>,
    /// Path shown; a place that is not finite interrupts it.
    pub path_m: Vec<[f64; 2]>,
    /// What the path is of.
    pub path_of: PathOf,
    /// Places on the path where the robot collided.
    pub collisions_m: Vec<[f64; 2]>,
    /// Neurons at their birth places.
    pub neurons: Vec<NeuronMark>,
    /// The robot; none when only paths are shown.
    pub robot: Option<RobotView>,
    /// Title line, e.g. "Trial 3, step 17".
    pub caption: String,
}

/// What a path is of, as the legend names it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PathOf {
    /// A trial from home to the goal.
    #[default]
    Trial,
    /// A run of chapter 2.
    Run,
}

impl PathOf {
    /// The one shown, among others.
    #[must_use]
    pub const fn this(self) -> &'static str {
        match self {
            Self::Trial => "this trial",
            Self::Run => "this run",
        }
    }
}

/// A named region.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RegionView {
    /// Name, e.g. "corridor".
    pub name: String,
    /// Closed polygons that cover it within the bounds.
    pub polygons_m: Vec<Vec<[f64; 2]>>,
}

/// A neuron as drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct NeuronMark {
    /// Birth place.
    pub at_m: [f64; 2],
    /// Direction of its prototypical action.
    pub heading_rad: f64,
    /// Index of its region in [`ArenaView::regions`].
    pub region: usize,
    /// Utility scaled to 0 (worst) to 1 (best); none while pending.
    pub utility: Option<f64>,
    /// It won the present tick.
    pub winner: bool,
}

/// A position and a heading.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RobotPose {
    /// Metres.
    pub at_m: [f64; 2],
    /// Radians.
    pub heading_rad: f64,
}

/// The robot as drawn.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RobotView {
    /// True pose.
    pub pose: RobotPose,
    /// Where it believes to be.
    pub believed: RobotPose,
    /// Radius of the body; of the circle around it, when it is not round.
    pub radius_m: f64,
    /// Corners of a body that is not round, robot frame.
    pub corners_m: Vec<[f64; 2]>,
    /// Full angle of a sonar cone.
    pub cone_rad: f64,
    /// Range of the sonars.
    pub range_m: f64,
    /// The sonars' cones, in the order of the readings.
    pub cones: Vec<ConeView>,
    /// Readings, each from where its cone begins; none when no cones are to be drawn.
    pub sonar_m: Vec<f64>,
    /// It collided in this step.
    pub collided: bool,
}

/// Where a sonar's cone begins and where it goes, robot frame: x ahead, y to the left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConeView {
    /// Place of the sonar.
    pub at_m: [f64; 2],
    /// Axis from the heading.
    pub axis_rad: f64,
}
