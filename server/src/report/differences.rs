//! Where a run differs from the thesis: the settings that say how it was read, by standing.

use serde::Serialize;
use serde_json::Value;

use super::RunInfo;
use crate::wire::SettingInfo;

/// Settings that say how the thesis was read, grouped by their standing.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Differences {
    /// The thesis says otherwise; a literal setting with another value than the printed one counts.
    pub deviations: Vec<Difference>,
    /// Not in the thesis at all.
    pub additions: Vec<Difference>,
    /// One way to read an ambiguous passage.
    pub readings: Vec<Difference>,
    /// The thesis is silent; something had to be chosen.
    pub gaps: Vec<Difference>,
    /// Belongs to the simulation, not to the thesis.
    pub simulation: Vec<Difference>,
}

/// One such setting, with the value of this run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Difference {
    /// Key of the setting.
    pub key: String,
    /// Value in this run.
    pub value: Value,
    /// What the value means, when it is one of several names.
    pub value_meaning: Option<String>,
    /// The value is the experiment's default.
    pub is_default: bool,
    /// Unit; empty for a choice, a switch or a pure number.
    pub unit: String,
    /// What the setting means.
    pub meaning: String,
    /// Equation, section or reading it comes from.
    pub source: String,
    /// Standing of the setting; `literal` for a printed value that was changed.
    pub standing: String,
}

/// They name sets of other settings and of walls; what they choose is listed itself.
const NAMES_OF_SETS: [&str; 2] = ["preset", "world"];

impl Differences {
    /// Those of a session.
    #[must_use]
    pub fn of(run: RunInfo) -> Self {
        let mut differences = Self::default();
        for info in run.settings {
            if NAMES_OF_SETS.contains(&info.key.as_str()) {
                continue;
            }
            let Some(value) = run.session.settings.get(&info.key) else { continue };
            // An empty text stands for nothing of one's own.
            if value == "" {
                continue;
            }
            let difference = Difference::new(info, value);
            match info.standing.as_str() {
                "literal" if difference.is_default => {}
                "literal" | "deviation" => differences.deviations.push(difference),
                "addition" => differences.additions.push(difference),
                "reading" => differences.readings.push(difference),
                "gap" => differences.gaps.push(difference),
                _ => differences.simulation.push(difference),
            }
        }
        differences
    }

    /// The groups with their headings, in the order of a report; the simulation stands last.
    #[must_use]
    pub fn groups(&self) -> [(&'static str, &'static str, &[Difference]); 5] {
        [
            ("Deviations", "The thesis says otherwise", &self.deviations),
            ("Additions", "Not in the thesis", &self.additions),
            ("Readings", "The thesis can be read in more than one way", &self.readings),
            ("Gaps", "The thesis is silent; something had to be chosen", &self.gaps),
            ("Simulation", "Properties of the simulated robot and its world", &self.simulation),
        ]
    }
}

impl Difference {
    fn new(info: &SettingInfo, value: &Value) -> Self {
        let meaning_of_value = info
            .choices
            .iter()
            .find(|choice| value.as_str() == Some(&choice.value))
            .map(|choice| choice.meaning.clone());
        Self {
            key: info.key.clone(),
            value: value.clone(),
            value_meaning: meaning_of_value,
            is_default: same_value(value, &info.default),
            unit: info.unit.clone(),
            meaning: info.meaning.clone(),
            source: info.source.clone(),
            standing: info.standing.clone(),
        }
    }
}

/// Equality of settings: `16` and `16.0` are the same number.
pub(super) fn same_value(one: &Value, other: &Value) -> bool {
    match (one.as_f64(), other.as_f64()) {
        (Some(one), Some(other)) => one == other,
        _ => one == other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::sample;

    fn keys(group: &[Difference]) -> Vec<&str> {
        group.iter().map(|difference| difference.key.as_str()).collect()
    }

    #[test]
    fn settings_are_grouped_by_standing() {
        let differences = Differences::of(sample::session_report().run());
        assert_eq!(keys(&differences.deviations), ["exploration.scale", "goal.radius"]);
        assert_eq!(keys(&differences.additions), ["shortcut.push"]);
        assert_eq!(keys(&differences.readings), ["action.frame"]);
        assert_eq!(keys(&differences.gaps), ["reflex.turn"]);
        assert_eq!(keys(&differences.simulation), ["sonar.noise", "odometry.drift"]);
    }

    #[test]
    fn a_literal_setting_counts_only_when_it_was_changed() {
        let mut report = sample::session_report();
        let printed = report.settings.iter().find(|info| info.key == "goal.radius");
        let printed = printed.expect("the sample has it").default.clone();
        report.session.settings.insert("goal.radius".into(), printed);
        assert_eq!(keys(&Differences::of(report.run()).deviations), ["exploration.scale"]);
    }

    #[test]
    fn a_choice_says_what_it_means() {
        let differences = Differences::of(sample::session_report().run());
        let frame = &differences.readings[0];
        assert_eq!(frame.value_meaning.as_deref(), Some("Heading in the odometry frame"));
    }

    #[test]
    fn a_whole_number_equals_itself_however_it_is_written() {
        assert!(same_value(&Value::from(16), &Value::from(16.0)));
        assert!(!same_value(&Value::from(16), &Value::from(16.5)));
        assert!(!same_value(&Value::from("16"), &Value::from(16)));
    }
}
