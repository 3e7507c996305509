//! The settings of every plain experiment, by key: numbers and names of the core, and texts.

use serde_json::Value as Json;
use sonarium_core::experiment::{
    BanditSettings, BlockWorldSettings, ContinualSettings, CorridorSettings, GridworldSettings,
    HASHING_SETS, HorizonSettings, LabyrinthExtras, LabyrinthSettings, PEOPLE_FILE, RULES_FILE,
    WallApproachSettings,
};
use sonarium_core::fuzzy::RuleBase;
use sonarium_core::perception::Hashing;
use sonarium_core::settings::{SettingError, Spec, Value};
use sonarium_core::world::{PeopleFile, PersonFile};

use super::super::FieldError;
use crate::wire::Family;

/// Advice in words, one rule a line.
const ADVICE: &str = "advice";
/// A belief matrix of one's own.
const MATRIX: &str = "belief.matrix";
/// Values that its learner begins with.
const TABLE: &str = "learner.table";

/// A setting that is a text.
#[derive(Clone, Copy, Debug)]
pub(super) struct TextSpec {
    pub(super) key: &'static str,
    pub(super) meaning: &'static str,
    pub(super) source: &'static str,
}

const ADVICE_SPEC: TextSpec = TextSpec {
    key: ADVICE,
    meaning: "Advice in words, one rule a line, for `bias.advice`",
    source: "section 4.3",
};

const LABYRINTH_TEXTS: [TextSpec; 3] = [
    ADVICE_SPEC,
    TextSpec {
        key: MATRIX,
        meaning: "A belief matrix of one's own, which then competes too: 16 rows of 3 beliefs, as [[1,-1,1],...]",
        source: "section 4.5",
    },
    TextSpec {
        key: TABLE,
        meaning: "Q-values that the own matrix's learner begins with, as [[0.5,0,1],...]",
        source: "section 4.10",
    },
];

const DRIVE_TEXTS: [TextSpec; 3] = [
    TextSpec {
        key: HASHING_SETS,
        meaning: "Regions of one's own in place of `hashing`'s others: the sonars of each, from the left to the right, as 0,1,2; 1,2,3,4; 3,4,5,6; 5,6,7,8; 7,8,9",
        source: "section 2.3",
    },
    TextSpec {
        key: RULES_FILE,
        meaning: "Rules of one's own in place of the 972, as the navigator's are written or in FLL, with its inputs and outputs",
        source: "section 2.7",
    },
    TextSpec {
        key: PEOPLE_FILE,
        meaning: "People of one's own in place of `people.count`, as TOML: for each a table [[people]] with start_m = [x, y], pace_m_s (below 0 towards the beginning) and, if it is not where they start, lane_m; y is 0 in the middle, left of it above 0",
        source: "section 2.9",
    },
];

/// The settings of one of the experiments.
#[derive(Clone, Debug, PartialEq)]
pub enum PlainSettings {
    /// Chapter 4.
    Labyrinth(LabyrinthSettings),
    /// Section 4.10.
    Continual(ContinualSettings),
    /// Chapter 3 in mazes and other worlds.
    Gridworld(GridworldSettings),
    /// Section 3.5.
    Bandit(BanditSettings),
    /// Figure 3.3.
    Horizon(HorizonSettings),
    /// Section 2.5.
    WallApproach(WallApproachSettings),
    /// Figure 2.10.
    BlockWorld(BlockWorldSettings),
    /// Section 2.9.
    Corridor(CorridorSettings),
}

/// Does the same with whichever settings there are.
macro_rules! each {
    ($settings:expr, $bound:ident => $body:expr) => {
        match $settings {
            PlainSettings::Labyrinth($bound) => $body,
            PlainSettings::Continual($bound) => $body,
            PlainSettings::Gridworld($bound) => $body,
            PlainSettings::Bandit($bound) => $body,
            PlainSettings::Horizon($bound) => $body,
            PlainSettings::WallApproach($bound) => $body,
            PlainSettings::BlockWorld($bound) => $body,
            PlainSettings::Corridor($bound) => $body,
        }
    };
}

impl PlainSettings {
    /// The defaults of an experiment; none when there is no plain experiment of that name.
    pub(super) fn of(experiment: &str) -> Option<Self> {
        Some(match experiment {
            "labyrinth" => Self::Labyrinth(LabyrinthSettings::default()),
            "continual" => Self::Continual(ContinualSettings::default()),
            "gridworld" => Self::Gridworld(GridworldSettings::default()),
            "bandit" => Self::Bandit(BanditSettings::default()),
            "horizon" => Self::Horizon(HorizonSettings::default()),
            "wall-approach" => Self::WallApproach(WallApproachSettings::default()),
            "block-world" => Self::BlockWorld(BlockWorldSettings::default()),
            "corridor" => Self::Corridor(CorridorSettings::default()),
            _ => return None,
        })
    }

    pub(super) fn specs(&self) -> &'static [Spec] {
        match self {
            Self::Labyrinth(_) => LabyrinthSettings::specs(),
            Self::Continual(_) => ContinualSettings::specs(),
            Self::Gridworld(_) => GridworldSettings::specs(),
            Self::Bandit(_) => BanditSettings::specs(),
            Self::Horizon(_) => HorizonSettings::specs(),
            Self::WallApproach(_) => WallApproachSettings::specs(),
            Self::BlockWorld(_) => BlockWorldSettings::specs(),
            Self::Corridor(_) => CorridorSettings::specs(),
        }
    }

    pub(super) fn texts(&self) -> &'static [TextSpec] {
        match self {
            Self::Labyrinth(_) => &LABYRINTH_TEXTS,
            Self::Gridworld(_) => &LABYRINTH_TEXTS[..1],
            Self::WallApproach(_) => &DRIVE_TEXTS[..1],
            Self::BlockWorld(_) => &DRIVE_TEXTS[..2],
            Self::Corridor(_) => &DRIVE_TEXTS,
            _ => &[],
        }
    }

    pub(super) fn get(&self, key: &str) -> Option<Value> {
        each!(self, settings => settings.get(key))
    }

    pub(super) fn set(&mut self, key: &str, value: &Value) -> Result<(), SettingError> {
        each!(self, settings => settings.set(key, value))
    }

    /// Key of what `trials` stands for; none where there are no trials.
    pub(super) fn trials_key(&self) -> Option<&'static str> {
        match self {
            Self::Labyrinth(_) | Self::Continual(_) | Self::Gridworld(_) => Some("trials"),
            Self::Bandit(_) => Some("pulls"),
            Self::Horizon(_) | Self::WallApproach(_) | Self::BlockWorld(_) | Self::Corridor(_) => {
                None
            }
        }
    }

    /// Which kind of experiment it is.
    #[must_use]
    pub fn family(&self) -> Family {
        match self {
            Self::WallApproach(_) | Self::BlockWorld(_) | Self::Corridor(_) => Family::Drive,
            _ => Family::Table,
        }
    }

    /// Trials of an episode; runs are not among the settings.
    pub(super) fn trials(&self) -> u32 {
        match self {
            Self::Labyrinth(settings) => settings.trials,
            Self::Continual(settings) => settings.trials,
            Self::Gridworld(settings) => settings.trials,
            Self::Bandit(settings) => settings.pulls,
            Self::Horizon(_) | Self::WallApproach(_) | Self::BlockWorld(_) | Self::Corridor(_) => 1,
        }
    }

    /// Episodes of each competitor.
    #[must_use]
    pub fn episodes(&self) -> u32 {
        match self {
            Self::Labyrinth(settings) => settings.episodes,
            Self::Continual(settings) => settings.episodes,
            Self::Gridworld(settings) => settings.episodes,
            Self::Bandit(settings) => settings.episodes,
            Self::Horizon(_) | Self::WallApproach(_) | Self::BlockWorld(_) | Self::Corridor(_) => 1,
        }
    }
}

/// The texts of a run.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Texts {
    /// Advice.
    pub advice: String,
    /// Belief matrix.
    pub matrix: String,
    /// Q-values.
    pub table: String,
    /// Regions of one's own.
    pub hashing: String,
    /// People of one's own.
    pub people: String,
    /// Rules of one's own.
    pub rules: String,
}

impl Texts {
    pub(super) fn get(&self, key: &str) -> &str {
        match key {
            ADVICE => &self.advice,
            MATRIX => &self.matrix,
            HASHING_SETS => &self.hashing,
            PEOPLE_FILE => &self.people,
            RULES_FILE => &self.rules,
            _ => &self.table,
        }
    }

    pub(super) fn set(&mut self, key: &'static str, value: &Json) -> Result<(), FieldError> {
        let text = match value {
            Json::String(text) => text.trim().to_owned(),
            // A matrix may be given as what it is.
            Json::Array(_) if matches!(key, MATRIX | TABLE) => value.to_string(),
            other => {
                let message = format!("must be a text, not `{other}`");
                return Err(FieldError::new(format!("settings.{key}"), message));
            }
        };
        match key {
            ADVICE => self.advice = text,
            MATRIX => self.matrix = text,
            HASHING_SETS => self.hashing = text,
            PEOPLE_FILE => self.people = text,
            RULES_FILE => self.rules = text,
            _ => self.table = text,
        }
        Ok(())
    }

    /// What the labyrinth takes besides its settings.
    ///
    /// # Errors
    /// When a matrix is not written as rows of numbers.
    pub fn extras(&self) -> Result<LabyrinthExtras, FieldError> {
        let (matrix, table) = (rows(MATRIX, &self.matrix)?, rows(TABLE, &self.table)?);
        if table.is_some() && matrix.is_none() {
            let message = "belongs to a matrix of one's own; give `belief.matrix` too";
            return Err(FieldError::new(format!("settings.{TABLE}"), message));
        }
        Ok(LabyrinthExtras { advice: self.advice.clone(), matrix, table })
    }

    /// People of one's own; none where there are none.
    ///
    /// # Errors
    /// When the text is no file of people.
    pub fn people(&self) -> Result<Option<Vec<PersonFile>>, FieldError> {
        if self.people.is_empty() {
            return Ok(None);
        }
        toml::from_str(&self.people)
            .map(|file: PeopleFile| Some(file.people))
            .map_err(|error| FieldError::new(format!("settings.{PEOPLE_FILE}"), error.to_string()))
    }

    /// Rules of one's own; none where there are none.
    ///
    /// # Errors
    /// When the text is no rule base, with the line at fault.
    pub fn rules(&self) -> Result<Option<RuleBase>, FieldError> {
        if self.rules.is_empty() {
            return Ok(None);
        }
        RuleBase::from_text(&self.rules)
            .map(Some)
            .map_err(|error| FieldError::new(format!("settings.{RULES_FILE}"), error.to_string()))
    }

    /// Regions of one's own for so many sonars; none where there are none.
    ///
    /// # Errors
    /// When they are not written as regions or do not cover the sonars.
    pub fn regions(&self, sonars: usize) -> Result<Option<Hashing>, FieldError> {
        if self.hashing.is_empty() {
            return Ok(None);
        }
        Hashing::parse(&self.hashing, sonars)
            .map(Some)
            .map_err(|error| FieldError::new(format!("settings.{HASHING_SETS}"), error.to_string()))
    }
}

fn rows(key: &str, text: &str) -> Result<Option<Vec<Vec<f64>>>, FieldError> {
    if text.is_empty() {
        return Ok(None);
    }
    serde_json::from_str(text).map(Some).map_err(|error| {
        let message = format!("must be rows of numbers, as [[1,-1,1],[1,1,1]]: {error}");
        FieldError::new(format!("settings.{key}"), message)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn matrices_are_rows_of_numbers() {
        let with = |matrix: &str, table: &str| Texts {
            matrix: matrix.into(),
            table: table.into(),
            ..Texts::default()
        };
        let extras = with("[[1,-1],[0.5,1]]", "").extras().expect("rows of numbers");
        assert_eq!(extras.matrix, Some(vec![vec![1.0, -1.0], vec![0.5, 1.0]]));
        for (texts, field) in [
            (with("[[1,", ""), "settings.belief.matrix"),
            (with("7", ""), "settings.belief.matrix"),
            (with("[[1,\"a\"]]", ""), "settings.belief.matrix"),
            (with("", "[[1]]"), "settings.learner.table"),
        ] {
            assert_eq!(texts.extras().expect_err(field).field, field);
        }
    }

    #[test]
    fn every_plain_experiment_has_its_settings() {
        for name in super::super::NAMES {
            let settings = PlainSettings::of(name).expect("a plain experiment");
            for spec in settings.specs() {
                assert!(settings.get(spec.key).is_some(), "{name}: {}", spec.key);
            }
        }
        assert_eq!(PlainSettings::of("minimum-cost-path"), None);
    }
}
