//! The experiments of chapter 2: the approach to a wall, the block world and the corridor.
//!
//! In every cycle the scanner fires its slots one after the other while the robot moves; then readings
//! are hashed and fused, the rules give a command, and that command holds for the next cycle. A
//! [`Cycle`] keeps every number on the way.

mod block_world;
mod checkpoint;
mod corridor;
mod cycle;
mod error;
mod run;
mod score;
mod vehicle;
mod wall_approach;

pub use block_world::{BlockLayout, BlockStart, BlockWorldSettings};
pub use checkpoint::NavigationCheckpoint;
pub use corridor::CorridorSettings;
pub use cycle::{Bump, Contact, Cycle, RegionState};
pub use error::NavigationError;
pub use run::NavigationRun;
pub use score::RunEnd;
pub use wall_approach::{ApproachEnd, ApproachRun, MethodScore, WallApproachSettings};

use crate::perception::{FusionRule, MedianRank};
use crate::robot::NoiseLevel;

/// Key of the text that gives regions of one's own, as [`Hashing::parse`](crate::perception::Hashing::parse)
/// takes them.
pub const HASHING_SETS: &str = "hashing.sets";

/// Key of the text that gives people of one's own, a [`PeopleFile`](crate::world::PeopleFile).
pub const PEOPLE_FILE: &str = "people.file";

/// Key of the text that gives rules of one's own, as
/// [`RuleBase::from_text`](crate::fuzzy::RuleBase::from_text) takes them.
pub const RULES_FILE: &str = "rules.file";

/// What several experiments set about noise.
#[derive(Clone, Copy, Debug, PartialEq)]
struct NoiseChoice {
    ideal: bool,
    level: f64,
    crosstalk: bool,
    spurious: bool,
    dropout: bool,
    neighbours: f64,
}

impl NoiseChoice {
    fn level(self) -> NoiseLevel {
        if self.ideal {
            return NoiseLevel::IDEAL;
        }
        let times = |on: bool| if on { self.level } else { 0.0 };
        NoiseLevel {
            real: true,
            crosstalk: times(self.crosstalk),
            spurious: times(self.spurious),
            dropout: times(self.dropout),
            neighbours: self.neighbours,
        }
    }
}

fn fusion_rule(rank: MedianRank, window: u32, deviation_m: f64, walk_m: f64) -> FusionRule {
    FusionRule { rank, window: window as usize, deviation_m, walk_m }
}
