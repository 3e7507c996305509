//! Trained networks: read from a file, checked against what they shall be used for, written again.

use std::sync::Arc;

use serde_json::Value as Json;
use sonarium_core::learner::Neuron;
use sonarium_core::robot::Mount;

use super::plan::listed;
use super::{FieldError, Plan};
use crate::wire::{
    GoalView, InputSpans, NETWORK_FORMAT, NETWORK_VERSION, NetworkFile, NewSession, SonarView,
};

/// Most neurons of a network file.
const MOST_NEURONS: usize = 100_000;
/// Room for a neuron in a network file, bytes: some fifty numbers of up to 25 characters, and their
/// names.
const NEURON_BYTES: usize = 2048;
/// Room for the largest network file, bytes.
pub const LARGEST_NETWORK: usize = MOST_NEURONS * NEURON_BYTES;
/// Way and angle by which two mounts may differ and still be the same, metres and degrees.
const SAME: f64 = 1e-9;

/// Trained networks as they were read.
#[derive(Clone, Debug, PartialEq)]
pub struct Trained {
    /// What the file says.
    pub file: NetworkFile,
    /// The file.
    pub text: String,
}

impl Trained {
    /// Reads a network file.
    ///
    /// # Errors
    /// When it is none, is cut off, or comes from a newer program; the field names the place.
    pub fn read(text: &str) -> Result<Self, FieldError> {
        let json: Json = serde_json::from_str(text).map_err(|error| {
            let why = if error.is_eof() { "it is cut off" } else { "it is not JSON" };
            let message = format!("is no network file: {why} ({error}); {HOW}");
            FieldError::new("network", message)
        })?;
        Self::from_json(&json)
    }

    /// The same from JSON that was read.
    ///
    /// # Errors
    /// When it is no network file or comes from a newer program; the field names the place.
    pub fn from_json(json: &Json) -> Result<Self, FieldError> {
        check_version(json)?;
        let file: NetworkFile = serde_path_to_error::deserialize(json).map_err(|error| {
            let path = error.path().to_string();
            let field = if path == "." { "network".into() } else { format!("network.{path}") };
            FieldError::new(field, format!("cannot be read: {}; {HOW}", error.inner()))
        })?;
        let neurons = file.networks.iter().map(Vec::len).sum::<usize>();
        if neurons > MOST_NEURONS {
            let message = format!("must hold at most {MOST_NEURONS} neurons, not {neurons}");
            return Err(FieldError::new("network.networks", message));
        }
        Ok(Self { text: to_text(&file), file })
    }

    /// The networks of a run after so many trials.
    #[must_use]
    pub fn new(plan: &Plan, trials: u32, mut networks: Vec<Vec<Neuron>>) -> Self {
        let (world, goal) = (&plan.world, plan.world.world.goal());
        networks.truncate(regions(plan).len());
        let file = NetworkFile {
            format: NETWORK_FORMAT.into(),
            version: NETWORK_VERSION,
            build: crate::build(),
            experiment: plan.experiment.clone(),
            robot: plan.robot.name().to_owned(),
            sonars: plan.robot.sonars().iter().map(SonarView::from).collect(),
            input: spans(plan),
            action_frame: choice(plan, "learner.action_frame"),
            world: world.name.clone(),
            regions: regions(plan),
            goal: GoalView { x_m: goal.centre.x, y_m: goal.centre.y, radius_m: goal.radius_m },
            settings: plan.values.clone(),
            seed: plan.seed,
            trials,
            networks,
        };
        Self { text: to_text(&file), file }
    }

    /// What it is called where there is place for a few words.
    #[must_use]
    pub fn label(&self) -> String {
        let NetworkFile { world, seed, trials, .. } = &self.file;
        format!("{world}, seed {seed}, {trials} trials, {} neurons", self.neurons())
    }

    /// Neurons in all networks.
    #[must_use]
    pub fn neurons(&self) -> usize {
        self.file.networks.iter().map(Vec::len).sum()
    }

    /// Checks that a plan can go on with these networks.
    ///
    /// # Errors
    /// The first thing that does not fit: the field names it, the message says what would be right.
    pub fn check(&self, plan: &Plan) -> Result<(), FieldError> {
        self.check_sonars(plan)?;
        self.check_input(plan)?;
        let frame = choice(plan, "learner.action_frame");
        if self.file.action_frame != frame {
            return Err(FieldError::new(
                "network.action_frame",
                format!(
                    "must be `{frame}`, the frame of this run's actions, not `{found}`; or run with \
                     --set learner.action_frame={found}",
                    found = self.file.action_frame
                ),
            ));
        }
        self.check_regions(plan)
    }

    fn check_sonars(&self, plan: &Plan) -> Result<(), FieldError> {
        let (ours, theirs) = (plan.robot.sonars(), &self.file.sonars);
        let title = plan.robot.title();
        if ours.len() != theirs.len() {
            let message = format!(
                "must be the {} sonars of the {title}, not {} (of robot `{}`)",
                ours.len(),
                theirs.len(),
                self.file.robot
            );
            return Err(FieldError::new("network.sonars", message));
        }
        let moved = ours.iter().zip(theirs).position(|(ours, theirs)| !same(ours, theirs));
        moved.map_or(Ok(()), |sonar| {
            let Mount { place, axis_deg, .. } = ours[sonar];
            let message = format!(
                "must sit at ({}, {}) m and look along {axis_deg}°, as on the {title}; the networks were \
                 trained on robot `{}`",
                place.x, place.y, self.file.robot
            );
            Err(FieldError::new(format!("network.sonars[{sonar}]"), message))
        })
    }

    fn check_input(&self, plan: &Plan) -> Result<(), FieldError> {
        let (ours, theirs) = (spans(plan), &self.file.input);
        for (name, ours, theirs) in [
            ("sonar_span_m", ours.sonar_span_m, theirs.sonar_span_m),
            ("distance_span_m", ours.distance_span_m, theirs.distance_span_m),
        ] {
            if ours != theirs {
                let key = name.trim_end_matches("_m");
                let message = format!(
                    "must be {ours} m, as in this run, not {theirs} m; or run with --set \
                     input.{key}={theirs}"
                );
                return Err(FieldError::new(format!("network.input.{name}"), message));
            }
        }
        if ours.sonar_frame != theirs.sonar_frame {
            let message = format!(
                "must be `{}`, as in this run, not `{theirs}`; or run with --set \
                 input.sonar_frame={theirs}",
                ours.sonar_frame,
                theirs = theirs.sonar_frame
            );
            return Err(FieldError::new("network.input.sonar_frame", message));
        }
        Ok(())
    }

    fn check_regions(&self, plan: &Plan) -> Result<(), FieldError> {
        let (ours, theirs) = (regions(plan), &self.file.regions);
        if ours != *theirs {
            let names = |regions: &[String]| {
                listed(&regions.iter().map(String::as_str).collect::<Vec<&str>>())
            };
            let message = format!(
                "must be {}, the regions of the world `{}`, not {} (of world `{}`)",
                names(&ours),
                plan.world.name,
                names(theirs),
                self.file.world
            );
            return Err(FieldError::new("network.regions", message));
        }
        let (expected, found) = (ours.len(), self.file.networks.len());
        if expected != found {
            let message = format!(
                "must hold one list of neurons for each of {expected} regions, not {found}"
            );
            return Err(FieldError::new("network.networks", message));
        }
        Ok(())
    }
}

/// The networks a request begins with, if it names some; those of a session must have been put in the
/// place of its name before.
pub(super) fn asked(request: &NewSession) -> Result<Option<Arc<Trained>>, FieldError> {
    match &request.network {
        None | Some(Json::Null) => Ok(None),
        Some(json @ Json::Object(_)) => {
            Trained::from_json(json).map(|network| Some(Arc::new(network)))
        }
        Some(_) => Err(FieldError::new(
            "network",
            "must be a network file (an object), or to a server the identifier of a session",
        )),
    }
}

const HOW: &str =
    "`sonarium run ... --save-network FILE` and `GET sessions/{id}/network` write network files";

fn check_version(json: &Json) -> Result<(), FieldError> {
    let Json::Object(fields) = json else {
        return Err(FieldError::new(
            "network",
            format!("is no network file: no JSON object; {HOW}"),
        ));
    };
    match fields.get("format").and_then(Json::as_str) {
        Some(NETWORK_FORMAT) => {}
        _ => {
            let message = format!("must be \"{NETWORK_FORMAT}\": this is no network file; {HOW}");
            return Err(FieldError::new("network.format", message));
        }
    }
    match fields.get("version").and_then(Json::as_u64) {
        Some(version) if version == u64::from(NETWORK_VERSION) => Ok(()),
        Some(version) if version > u64::from(NETWORK_VERSION) => {
            let message = format!(
                "{version} is newer than this program reads ({NETWORK_VERSION}); use a newer sonarium"
            );
            Err(FieldError::new("network.version", message))
        }
        _ => {
            let message = format!("must be {NETWORK_VERSION}");
            Err(FieldError::new("network.version", message))
        }
    }
}

fn to_text(file: &NetworkFile) -> String {
    serde_json::to_string(file).expect("plain data with text keys always serialises")
}

fn same(ours: &Mount, theirs: &SonarView) -> bool {
    let off_m = (ours.place.x - theirs.x_m).abs().max((ours.place.y - theirs.y_m).abs());
    off_m < SAME && (ours.axis_deg - theirs.bearing_deg).abs() < SAME
}

fn spans(plan: &Plan) -> InputSpans {
    InputSpans {
        sonar_span_m: plan.settings.sonar_span_m,
        distance_span_m: plan.settings.distance_span_m,
        sonar_frame: choice(plan, "input.sonar_frame"),
    }
}

fn regions(plan: &Plan) -> Vec<String> {
    let names = plan.names();
    if names.one_network { vec!["all".to_owned()] } else { names.regions }
}

fn choice(plan: &Plan, key: &str) -> String {
    plan.values.get(key).and_then(Json::as_str).unwrap_or_default().to_owned()
}
