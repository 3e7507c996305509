//! Robots that tests share.

use std::sync::Arc;

use super::{Robot, RobotFile};

/// The B21.
pub(crate) fn b21() -> Arc<Robot> {
    checked(&b21_file())
}

/// The TRC.
pub(crate) fn trc() -> Arc<Robot> {
    checked(&trc_file())
}

/// The B21's file.
pub(crate) fn b21_file() -> RobotFile {
    parsed(include_str!("../../../assets/robots/b21.toml"))
}

/// The TRC's file.
pub(crate) fn trc_file() -> RobotFile {
    parsed(include_str!("../../../assets/robots/trc.toml"))
}

fn checked(file: &RobotFile) -> Arc<Robot> {
    Arc::new(Robot::new(file).expect("a robot that comes with the program is sound"))
}

fn parsed(text: &str) -> RobotFile {
    toml::from_str(text).expect("a robot that comes with the program can be read")
}
