//! What a robot's file says about its scanner, drive, bumpers and compass (section 2.2).

use serde::{Deserialize, Serialize};

use super::RobotError;
use super::within;
use crate::world::MOST_RAYS;

crate::choice! {
    /// The order in which the sonars are fired.
    pub enum FiringOrder {
        Staggered = "staggered": "sonars fired one after the other sit far apart, section 2.2",
        Naive = "naive": "from the left to the right",
    }
}

/// Everything beside outline and sonars.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Equipment {
    /// How the sonars are scanned and what they hear.
    pub scanner: ScannerSpec,
    /// How velocities follow commands.
    pub drive: DriveSpec,
    /// What a contact does.
    pub bumper: BumperSpec,
    /// How well the heading is measured.
    pub compass: CompassSpec,
}

/// How the sonars are scanned and what they hear. Probabilities of noise are those of level 1.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ScannerSpec {
    /// Slots of a cycle.
    pub slots: u32,
    /// Time of a slot, seconds.
    pub slot_s: f64,
    /// Full width of a cone, degrees.
    pub cone_deg: f64,
    /// Rays that stand for a cone.
    pub rays: u32,
    /// Least reading, metres.
    pub least_m: f64,
    /// Greatest reading, and the reading when there is no echo, metres.
    pub range_m: f64,
    /// Incidence beyond which a surface returns no echo, degrees.
    pub critical_deg: f64,
    /// Probability that an edge returns an echo.
    pub edge_echo: f64,
    /// Standard deviation of an echo at no distance, metres.
    pub deviation_m: f64,
    /// What is added to it, as a share of the distance.
    pub deviation_share: f64,
    /// Probability that crosstalk begins between two sonars with one axis.
    pub crosstalk: f64,
    /// Angle between axes over which that falls to 1/e, degrees.
    pub crosstalk_angle_deg: f64,
    /// Mean time that crosstalk lasts, seconds.
    pub crosstalk_mean_s: f64,
    /// Standard deviation of a ghost, metres.
    pub crosstalk_deviation_m: f64,
    /// Probability of a reading that is too short by chance.
    pub spurious: f64,
    /// Probability of a lost echo.
    pub dropout: f64,
    /// Which sonar each slot fires.
    pub orders: OrdersSpec,
}

/// Which sonar each slot fires; slots beyond fire sonars that are not used.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OrdersSpec {
    /// Far apart one after the other.
    pub staggered: Vec<usize>,
    /// As they sit.
    pub naive: Vec<usize>,
}

/// How velocities follow commands.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DriveSpec {
    /// Time constant, seconds.
    pub time_constant_s: f64,
    /// Greatest acceleration, m/s².
    pub acceleration_m_s2: f64,
    /// Greatest acceleration of a turn, deg/s².
    pub turn_acceleration_deg_s2: f64,
}

/// What a contact does.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BumperSpec {
    /// Velocity of backing off, m/s.
    pub back_off_m_s: f64,
    /// How long the robot backs off, seconds.
    pub back_off_s: f64,
    /// Clearance at which a contact is over, metres.
    pub free_m: f64,
}

/// How well the heading is measured.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CompassSpec {
    /// Standard deviation, degrees.
    pub deviation_deg: f64,
}

impl OrdersSpec {
    /// The sonars in an order.
    #[must_use]
    pub fn of(&self, order: FiringOrder) -> &[usize] {
        match order {
            FiringOrder::Staggered => &self.staggered,
            FiringOrder::Naive => &self.naive,
        }
    }
}

impl Equipment {
    /// Checks every number for a robot with so many sonars.
    ///
    /// # Errors
    /// The first thing wrong, with the field at fault and what would be right.
    pub(super) fn check(&self, sonars: usize) -> Result<(), RobotError> {
        self.scanner.check(sonars)?;
        let DriveSpec { time_constant_s, acceleration_m_s2, turn_acceleration_deg_s2 } = self.drive;
        let BumperSpec { back_off_m_s, back_off_s, free_m } = self.bumper;
        each(
            "equipment",
            &[
                ("drive.time_constant_s", time_constant_s, 0.001, 10.0),
                ("drive.acceleration_m_s2", acceleration_m_s2, 0.001, 100.0),
                ("drive.turn_acceleration_deg_s2", turn_acceleration_deg_s2, 0.1, 10_000.0),
                ("bumper.back_off_m_s", back_off_m_s, 0.0, 1.0),
                ("bumper.back_off_s", back_off_s, 0.0, 60.0),
                ("bumper.free_m", free_m, 0.0, 1.0),
                ("compass.deviation_deg", self.compass.deviation_deg, 0.0, 180.0),
            ],
        )
    }
}

impl ScannerSpec {
    fn check(&self, sonars: usize) -> Result<(), RobotError> {
        each(
            "equipment.scanner",
            &[
                ("slots", f64::from(self.slots), 1.0, 64.0),
                ("slot_s", self.slot_s, 0.001, 1.0),
                ("cone_deg", self.cone_deg, 1.0, 170.0),
                ("rays", f64::from(self.rays), 2.0, MOST_RAYS as f64),
                ("range_m", self.range_m, 0.1, 50.0),
                ("least_m", self.least_m, 0.0, self.range_m),
                ("critical_deg", self.critical_deg, 1.0, 90.0),
                ("edge_echo", self.edge_echo, 0.0, 1.0),
                ("deviation_m", self.deviation_m, 0.0, 1.0),
                ("deviation_share", self.deviation_share, 0.0, 1.0),
                ("crosstalk", self.crosstalk, 0.0, 1.0),
                ("crosstalk_angle_deg", self.crosstalk_angle_deg, 0.1, 360.0),
                ("crosstalk_mean_s", self.crosstalk_mean_s, 0.001, 1000.0),
                ("crosstalk_deviation_m", self.crosstalk_deviation_m, 0.0, 1.0),
                ("spurious", self.spurious, 0.0, 1.0),
                ("dropout", self.dropout, 0.0, 1.0),
            ],
        )?;
        for (order, fired) in [("staggered", &self.orders.staggered), ("naive", &self.orders.naive)]
        {
            let mut once = fired.clone();
            once.sort_unstable();
            let fits = fired.len() <= self.slots as usize;
            if !fits || once != (0..sonars).collect::<Vec<_>>() {
                return Err(RobotError::Order { order, sonars });
            }
        }
        Ok(())
    }
}

fn each(of: &str, numbers: &[(&str, f64, f64, f64)]) -> Result<(), RobotError> {
    for &(field, value, least, most) in numbers {
        within(&format!("{of}.{field}"), value, least, most)?;
    }
    Ok(())
}
