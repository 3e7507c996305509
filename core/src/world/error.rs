//! Why a world cannot be used.

/// A refusal: what is wrong, where in the file, and what would be right.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum WorldError {
    /// A number is infinite or not a number.
    #[error("`{field}` must be a finite number, not {found}")]
    NotFinite {
        /// Where.
        field: String,
        /// What was given.
        found: f64,
    },
    /// A name is empty.
    #[error("`{field}` must be a name of at least one character")]
    Unnamed {
        /// Where.
        field: String,
    },
    /// A wall or block has too few points.
    #[error("`{field}` must have at least {needed} points, not {found}")]
    TooFewPoints {
        /// Where.
        field: String,
        /// Points needed.
        needed: usize,
        /// Points given.
        found: usize,
    },
    /// Two neighbouring points are the same.
    #[error(
        "`{field}` repeats the point before it; leave it out (a block closes itself, its first \
         corner is not repeated at the end)"
    )]
    RepeatedPoint {
        /// Where.
        field: String,
    },
    /// There is nothing to sense.
    #[error("`walls` must hold at least one wall, or `blocks` or `floor` at least one polygon")]
    NoWalls,
    /// More of something than can be handled.
    #[error("`{field}` must hold at most {limit}, not {found}")]
    TooMany {
        /// Where.
        field: String,
        /// The limit.
        limit: usize,
        /// What was given.
        found: usize,
    },
    /// The world is too large.
    #[error(
        "walls, blocks, home and goal must lie within a square of {limit_m} m, but they span \
         {found_m} m along {axis}"
    )]
    TooLarge {
        /// The axis, `x` or `y`.
        axis: char,
        /// The limit, metres.
        limit_m: f64,
        /// What was given, metres.
        found_m: f64,
    },
    /// A region's rule says nothing, or two things.
    #[error(
        "`{field}` {problem}, like {{ axis = \"x\", above = 3.75 }} or {{ a = 1, b = 1, below = 2 }}"
    )]
    Rule {
        /// Where.
        field: String,
        /// What it must have.
        problem: &'static str,
    },
    /// Two regions have one name.
    #[error(
        "`{field}` must differ from the names before it, but \"{name}\" is that of regions[{first}]"
    )]
    DuplicateRegion {
        /// Where.
        field: String,
        /// The name.
        name: String,
        /// Index of the region that has it already.
        first: usize,
    },
    /// There is no region for some places.
    #[error("`regions` must end with a region without rules, which covers everywhere else")]
    NoCatchAll,
    /// A region's rules hold nowhere inside the bounds of the walls.
    #[error("`{field}` (\"{name}\") covers nothing inside the walls; change or remove it")]
    EmptyRegion {
        /// Where.
        field: String,
        /// Its name.
        name: String,
    },
    /// A region lies inside the ones before it.
    #[error(
        "`{field}` (\"{name}\") can never be the first whose rules hold, because the regions before \
         it cover it; move it up, change its rules or remove it"
    )]
    CoveredRegion {
        /// Where.
        field: String,
        /// Its name.
        name: String,
    },
    /// The goal has no extent.
    #[error("`goal.radius_m` must be greater than 0, not {found}")]
    GoalRadius {
        /// What was given.
        found: f64,
    },
    /// The robot does not fit where it should start.
    #[error(
        "`home` must be at least the robot's radius of {radius_m} m from every wall, but at \
         ({x}, {y}) the nearest surface is {clearance_m:.3} m away"
    )]
    HomeBlocked {
        /// Metres.
        x: f64,
        /// Metres.
        y: f64,
        /// Distance from home to the nearest surface, 0 inside a block, metres.
        clearance_m: f64,
        /// Radius of the robot, metres.
        radius_m: f64,
    },
    /// There is no way from home to the goal.
    #[error(
        "`goal` cannot be reached from home by a robot of radius {radius_m} m; the nearest point it \
         can reach is ({:.2}, {:.2}), {distance_m:.2} m from the goal's centre",
        nearest[0], nearest[1]
    )]
    GoalUnreachable {
        /// The reachable point nearest to the goal's centre, metres.
        nearest: [f64; 2],
        /// Its distance from the goal's centre, metres.
        distance_m: f64,
        /// The goal's centre, metres.
        goal: [f64; 2],
        /// Radius of the robot, metres.
        radius_m: f64,
    },
    /// The robot is too small or too large to plan for.
    #[error("`robot_radius_m` must be from {least} to {most} m, not {found}")]
    RobotRadius {
        /// The least radius, metres.
        least: f64,
        /// The greatest radius, metres.
        most: f64,
        /// What was given.
        found: f64,
    },
}

impl WorldError {
    /// The field at fault, e.g. `regions[2].rules[0]`.
    #[must_use]
    pub fn field(&self) -> String {
        match self {
            Self::NotFinite { field, .. }
            | Self::Unnamed { field }
            | Self::TooFewPoints { field, .. }
            | Self::RepeatedPoint { field }
            | Self::TooMany { field, .. }
            | Self::Rule { field, .. }
            | Self::DuplicateRegion { field, .. }
            | Self::EmptyRegion { field, .. }
            | Self::CoveredRegion { field, .. } => field.clone(),
            Self::NoWalls | Self::TooLarge { .. } => "walls".to_owned(),
            Self::NoCatchAll => "regions".to_owned(),
            Self::GoalRadius { .. } => "goal.radius_m".to_owned(),
            Self::HomeBlocked { .. } => "home".to_owned(),
            Self::GoalUnreachable { .. } => "goal".to_owned(),
            Self::RobotRadius { .. } => "robot_radius_m".to_owned(),
        }
    }

    /// The place at fault, to be marked on a plan, metres.
    #[must_use]
    pub fn place_m(&self) -> Option<[f64; 2]> {
        match self {
            Self::HomeBlocked { x, y, .. } => Some([*x, *y]),
            Self::GoalUnreachable { goal, .. } => Some(*goal),
            _ => None,
        }
    }

    /// The place nearest to an unreachable goal that can be reached, metres.
    #[must_use]
    pub fn nearest_m(&self) -> Option<[f64; 2]> {
        match self {
            Self::GoalUnreachable { nearest, .. } => Some(*nearest),
            _ => None,
        }
    }
}
