//! A robot with 24 sonars in a room of 30 walls, steps a CPU second.

use std::sync::Arc;

use sonarium_core::robot::{SimulatedRobot, SimulationSettings};

use super::room::{CONE_DEG, Disc, RANGE_M, follow, robot, room};
use super::{Failure, Line, cpu};

/// Steps between two looks at the time.
const STEPS: u64 = 5000;

pub(super) fn run() -> Result<Vec<Line>, Failure> {
    let mut lines = Vec::new();
    for rays in [1, 7] {
        lines.push(bare(rays)?);
    }
    for rays in [1, 7] {
        lines.push(real(rays)?);
    }
    Ok(lines)
}

/// The workload of the comparison.
fn bare(rays: usize) -> Result<Line, Failure> {
    let mut disc = Disc::new(rays)?;
    let mut sum_m = 0.0;
    for _ in 0..3000 {
        disc.step();
        sum_m += disc.readings_m.iter().sum::<f64>() / 24.0;
    }
    let measured = cpu::per_second(|| {
        (0..STEPS).for_each(|_| disc.step());
        Ok(STEPS)
    })?;
    let note = format!(
        "control, motion against 30 walls and scan; f64, one thread, CPU time; mean range of the \
         first 3000 steps {:.3} m",
        sum_m / 3000.0
    );
    Ok(Line::new("2-sonar", &format!("24x{rays} rays full step"), "steps/s", measured, &note))
}

/// The robot as experiments drive it: noise, lost echoes, infrared, bumpers and rescues.
fn real(rays: usize) -> Result<Line, Failure> {
    let settings = SimulationSettings {
        sonar_rays: rays,
        sonar_cone_rad: CONE_DEG.to_radians(),
        sonar_range_m: RANGE_M,
        sonar_critical_rad: 60_f64.to_radians(),
        advance_m: 0.04,
        ..SimulationSettings::default()
    };
    let robot = robot().map_err(|error| Failure::Failed(error.to_string()))?;
    let mut robot = SimulatedRobot::new(Arc::new(room()?), Arc::new(robot), settings, 1);
    let measured = cpu::per_second(|| {
        for _ in 0..STEPS {
            let (_, turn) = follow(&robot.sense().sonar_m);
            robot.act(0.1 * turn);
        }
        Ok(STEPS)
    })?;
    let note = "the same room with the robot that experiments use: 1 % noise, no echo beyond 60 deg of \
                incidence, sonars on the shell, infrared, rescues, 4 cm a step; crosstalk is not \
                simulated; log off (see run-log)";
    Ok(Line::new("2-sonar", &format!("24x{rays} rays real path"), "steps/s", measured, note))
}
