//! Robots, from `assets/robots`.

use std::collections::BTreeMap;
use std::sync::Arc;

use rust_embed::Embed;
use sonarium_core::robot::{Robot, RobotFile};

use super::CatalogError;

#[derive(Embed)]
#[folder = "$CARGO_MANIFEST_DIR/../assets/robots"]
struct Files;

/// The robots in the program, by name.
pub(super) fn embedded() -> Result<BTreeMap<String, Arc<Robot>>, CatalogError> {
    let robot = |file: &str| {
        let name = file.trim_end_matches(".toml").to_owned();
        let text = Files::get(file).map(|file| String::from_utf8_lossy(&file.data).into_owned());
        let robot = read(&name, &text.unwrap_or_default())
            .map_err(|message| CatalogError { file: format!("robots/{file}"), message })?;
        Ok((name, Arc::new(robot)))
    };
    Files::iter().map(|file| robot(&file)).collect()
}

/// Reads and checks a robot.
///
/// # Errors
/// What is wrong with it: where, and what would be right.
fn read(name: &str, text: &str) -> Result<Robot, String> {
    let file: RobotFile = toml::from_str(text).map_err(|error| error.to_string())?;
    if file.name != name {
        return Err(format!(
            "`name` must be \"{name}\", the name of its file, not {:?}",
            file.name
        ));
    }
    Robot::new(&file).map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_broken_robot_is_refused_with_the_place() {
        for (text, says) in [
            ("name = ", "line 1"),
            (
                "name = \"x\"\ntitle = \"\"\nsummary = \"\"\nsource = \"\"\nring = 99\n\
                 [body]\nradius_m = 0.3",
                "`ring` must be from 1 to 24",
            ),
            (
                "name = \"y\"\ntitle = \"\"\nsummary = \"\"\nsource = \"\"\nring = 8\n\
                 [body]\nradius_m = 0.3",
                "`name` must be \"x\"",
            ),
        ] {
            let error = read("x", text).expect_err(says);
            assert!(error.contains(says), "{error}");
        }
    }
}
