//! Robots and their sensors.
//!
//! A robot is plain data in a file ([`RobotFile`]), checked once ([`Robot::new`]): its outline on the
//! floor and where its sonars sit. [`SimulatedRobot`] puts one into a world.

mod body;
mod drive;
mod equipment;
mod error;
#[cfg(test)]
pub(crate) mod examples;
mod file;
mod motion;
mod ring;
mod scanner;
mod simulated;

use std::f64::consts::TAU;

pub use body::Body;
pub use drive::{Command, Drive};
pub use equipment::{
    BumperSpec, CompassSpec, DriveSpec, Equipment, FiringOrder, OrdersSpec, ScannerSpec,
};
pub use error::RobotError;
pub use file::{BodyFile, RobotFile, SonarFile};
pub(crate) use motion::Course;
pub use motion::Motion;
pub use ring::{MOST_SONARS, Mount, Readings};
pub use scanner::{Echo, NoiseLevel, Reading, Scanner};
pub(crate) use simulated::STRAIGHT_RAD;
pub use simulated::{Sensed, SimulatedRobot, SimulationSettings};

use crate::geometry::{Vec2, unit};

/// Least and greatest size of a body, metres.
const SIZES_M: (f64, f64) = (0.1, 5.0);
/// Greatest distance of a sonar from the centre along each axis, metres.
const FARTHEST_M: f64 = 5.0;

/// What the body touched.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Contact {
    /// Nothing.
    #[default]
    None,
    /// Virtual collision: an infrared reflectance above the threshold.
    Virtual,
    /// Real collision: the tactile ring.
    Real,
}

/// A checked robot.
#[derive(Clone, Debug, PartialEq)]
pub struct Robot {
    name: String,
    title: String,
    summary: String,
    source: String,
    body: Body,
    sonars: Vec<Mount>,
    /// Greatest distance of a sonar from the centre, metres.
    sonars_reach_m: f64,
    ring: bool,
    equipment: Option<Equipment>,
}

impl Robot {
    /// Checks what a file says.
    ///
    /// # Errors
    /// The first thing wrong, with the field at fault and what would be right.
    pub fn new(file: &RobotFile) -> Result<Self, RobotError> {
        if file.name.is_empty() {
            return Err(RobotError::Unnamed);
        }
        let body = body(&file.body)?;
        let sonars = match (file.ring, file.sonars.as_slice()) {
            (Some(count), []) => even_ring(body, count)?,
            (None, sonars @ [_, ..]) => mounts(sonars)?,
            _ => return Err(RobotError::NoSonars),
        };
        if let Some(equipment) = &file.equipment {
            equipment.check(sonars.len())?;
        }
        Ok(Self {
            name: file.name.clone(),
            title: file.title.clone(),
            summary: file.summary.clone(),
            source: file.source.clone(),
            body,
            sonars_reach_m: sonars.iter().map(|mount| mount.place.norm()).fold(0.0, f64::max),
            sonars,
            ring: file.ring.is_some(),
            equipment: file.equipment.clone(),
        })
    }

    /// Name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Title for people.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.title
    }

    /// One sentence on what it is like.
    #[must_use]
    pub fn summary(&self) -> &str {
        &self.summary
    }

    /// Where it comes from.
    #[must_use]
    pub fn source(&self) -> &str {
        &self.source
    }

    /// The outline on the floor.
    #[must_use]
    pub fn body(&self) -> Body {
        self.body
    }

    /// The sonars, in the order of their readings.
    #[must_use]
    pub fn sonars(&self) -> &[Mount] {
        &self.sonars
    }

    /// Least reading, metres, of a surface that is at least so far from the body, in metres, wherever
    /// the body turns on the spot.
    #[must_use]
    pub(crate) fn reading_beyond_m(&self, clearance_m: f64) -> f64 {
        clearance_m + self.body.reach_m() + self.sonars_reach_m
    }

    /// Scanner, drive and other equipment, for the experiments of chapter 2.
    #[must_use]
    pub fn equipment(&self) -> Option<&Equipment> {
        self.equipment.as_ref()
    }

    /// Whether the sonars are spread evenly round the body.
    #[must_use]
    pub fn has_even_ring(&self) -> bool {
        self.ring
    }
}

fn body(file: &BodyFile) -> Result<Body, RobotError> {
    let size = |field: &str, value: f64, (least, most): (f64, f64)| {
        within(&format!("body.{field}"), value, least, most)
    };
    match (file.radius_m, file.length_m, file.width_m) {
        (Some(radius_m), None, None) => {
            let radii_m = (0.5 * SIZES_M.0, 0.5 * SIZES_M.1);
            Ok(Body::Round { radius_m: size("radius_m", radius_m, radii_m)? })
        }
        (None, Some(length_m), Some(width_m)) => Ok(Body::Box {
            half_length_m: 0.5 * size("length_m", length_m, SIZES_M)?,
            half_width_m: 0.5 * size("width_m", width_m, SIZES_M)?,
        }),
        _ => Err(RobotError::Body),
    }
}

/// Sonar `i` of `n` sits at `360°·i / n` from the heading.
fn even_ring(body: Body, count: u32) -> Result<Vec<Mount>, RobotError> {
    let Body::Round { radius_m } = body else { return Err(RobotError::RingOnBox) };
    counted("ring", count as usize)?;
    let mount = |sonar: u32| {
        let axis_rad = TAU * f64::from(sonar) / f64::from(count);
        let axis_deg = 360.0 * f64::from(sonar) / f64::from(count);
        Mount { place: unit(axis_rad) * radius_m, axis_rad, axis_deg }
    };
    Ok((0..count).map(mount).collect())
}

fn mounts(sonars: &[SonarFile]) -> Result<Vec<Mount>, RobotError> {
    counted("sonars", sonars.len())?;
    let mount = |(index, sonar): (usize, &SonarFile)| {
        let field = |name: &str| format!("sonars[{index}].{name}");
        let x_m = within(&field("x_m"), sonar.x_m, -FARTHEST_M, FARTHEST_M)?;
        let y_m = within(&field("y_m"), sonar.y_m, -FARTHEST_M, FARTHEST_M)?;
        let axis_deg = within(&field("axis_deg"), sonar.axis_deg, -180.0, 180.0)?;
        Ok(Mount { place: Vec2::new(x_m, y_m), axis_rad: axis_deg.to_radians(), axis_deg })
    };
    sonars.iter().enumerate().map(mount).collect()
}

fn counted(field: &'static str, found: usize) -> Result<(), RobotError> {
    if (1..=MOST_SONARS).contains(&found) {
        Ok(())
    } else {
        Err(RobotError::Count { field, found })
    }
}

fn within(field: &str, found: f64, least: f64, most: f64) -> Result<f64, RobotError> {
    if (least..=most).contains(&found) {
        return Ok(found);
    }
    Err(RobotError::OutOfRange { field: field.to_owned(), least, most, found })
}

#[cfg(test)]
mod tests;
