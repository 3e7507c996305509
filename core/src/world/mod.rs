//! Worlds: walls, regions, home and goal.

/// A world.
#[derive(Clone, Debug, PartialEq)]
pub struct World {}
