//! Settings as data: every choice has a key, a range, a default and a source.
//!
//! An experiment's settings are a plain struct; the [`settings!`](crate::settings!) macro also gives
//! it a table of [`Spec`]s and access by key, so that the command line, the interface and the page
//! need to know none of them by name.

use serde::{Deserialize, Serialize};

/// The value of a setting.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Value {
    /// On or off.
    Switch(bool),
    /// A whole number.
    Integer(i64),
    /// A number.
    Number(f64),
    /// One of several names.
    Choice(String),
}

/// What a setting may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// On or off.
    Switch,
    /// A whole number between two bounds, both allowed.
    Integer(i64, i64),
    /// A finite number between two bounds, both allowed.
    Number(f64, f64),
    /// One of several names, each with its meaning.
    Choice(&'static [(&'static str, &'static str)]),
}

/// How a setting stands to the thesis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// Printed in the thesis.
    Literal,
    /// One way to read an ambiguous passage.
    Reading,
    /// The thesis is silent; something had to be chosen.
    Gap,
    /// The thesis says otherwise.
    Deviation,
    /// Not in the thesis at all.
    Addition,
    /// Belongs to the simulation, not to the thesis.
    Simulation,
}

impl Standing {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::Literal,
        Self::Reading,
        Self::Gap,
        Self::Deviation,
        Self::Addition,
        Self::Simulation,
    ];

    /// Name for files and screen.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Literal => "literal",
            Self::Reading => "reading",
            Self::Gap => "gap",
            Self::Deviation => "deviation",
            Self::Addition => "addition",
            Self::Simulation => "simulation",
        }
    }
}

/// One setting: what it means and what it may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spec {
    /// Key, e.g. `sonar.noise`.
    pub key: &'static str,
    /// What it means, one sentence.
    pub meaning: &'static str,
    /// What it may be.
    pub kind: Kind,
    /// Unit; empty for a choice, a switch or a pure number.
    pub unit: &'static str,
    /// Equation, section or reading it comes from.
    pub source: &'static str,
    /// How it stands to the thesis.
    pub standing: Standing,
}

/// A setting that cannot be taken.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SettingError {
    /// There is no such key.
    #[error("there is no setting `{key}`{}", hint(.nearest))]
    Unknown {
        /// The key asked for.
        key: String,
        /// The most similar key there is.
        nearest: Option<&'static str>,
    },
    /// The value has the wrong type or is out of range.
    #[error("`{key}` must be {expected}, not {found}")]
    Invalid {
        /// The key.
        key: &'static str,
        /// What would be right.
        expected: String,
        /// What was given.
        found: String,
    },
}

impl SettingError {
    /// The key at fault.
    #[must_use]
    pub fn key(&self) -> &str {
        match self {
            Self::Unknown { key, .. } => key,
            Self::Invalid { key, .. } => key,
        }
    }
}

fn hint(nearest: &Option<&'static str>) -> String {
    nearest.map(|key| format!("; did you mean `{key}`?")).unwrap_or_default()
}

impl std::fmt::Display for Value {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Switch(on) => write!(f, "{on}"),
            Self::Integer(number) => write!(f, "{number}"),
            Self::Number(number) => write!(f, "{number}"),
            Self::Choice(name) => write!(f, "{name}"),
        }
    }
}

impl Spec {
    /// What would be a right value, for messages.
    #[must_use]
    pub fn expected(&self) -> String {
        let unit = if self.unit.is_empty() { String::new() } else { format!(" ({})", self.unit) };
        match self.kind {
            Kind::Switch => "true or false".into(),
            Kind::Integer(least, most) => format!("a whole number from {least} to {most}{unit}"),
            Kind::Number(least, most) => format!("a number from {least} to {most}{unit}"),
            Kind::Choice(names) => {
                let names: Vec<String> =
                    names.iter().map(|(name, _)| format!("`{name}`")).collect();
                format!("one of {}", names.join(", "))
            }
        }
    }
}

/// A type that a setting can have.
pub trait Field: Copy {
    /// What a field of this type may be, given its two bounds if it has any.
    fn kind(bounds: Option<(f64, f64)>) -> Kind;
    /// The field as a value.
    fn to_value(self) -> Value;
    /// The value as a field, if it is of the right kind; bounds are checked by [`read`].
    fn from_value(value: &Value) -> Option<Self>;
    /// The number that bounds apply to.
    fn number(self) -> Option<f64> {
        None
    }
}

impl Field for bool {
    fn kind(_: Option<(f64, f64)>) -> Kind {
        Kind::Switch
    }

    fn to_value(self) -> Value {
        Value::Switch(self)
    }

    fn from_value(value: &Value) -> Option<Self> {
        match value {
            Value::Switch(on) => Some(*on),
            _ => None,
        }
    }
}

impl Field for f64 {
    fn kind(bounds: Option<(f64, f64)>) -> Kind {
        let (least, most) = bounds.unwrap_or((f64::MIN, f64::MAX));
        Kind::Number(least, most)
    }

    fn to_value(self) -> Value {
        Value::Number(self)
    }

    #[expect(clippy::cast_precision_loss, reason = "settings are far below 2^53")]
    fn from_value(value: &Value) -> Option<Self> {
        match value {
            Value::Number(number) => Some(*number),
            Value::Integer(number) => Some(*number as f64),
            _ => None,
        }
    }

    fn number(self) -> Option<f64> {
        Some(self)
    }
}

impl Field for u32 {
    #[expect(clippy::cast_possible_truncation, reason = "bounds are written as whole numbers")]
    fn kind(bounds: Option<(f64, f64)>) -> Kind {
        let (least, most) = bounds.unwrap_or((0.0, f64::from(u32::MAX)));
        Kind::Integer(least as i64, most as i64)
    }

    fn to_value(self) -> Value {
        Value::Integer(i64::from(self))
    }

    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the number was just seen to be whole and in range"
    )]
    fn from_value(value: &Value) -> Option<Self> {
        match value {
            Value::Integer(number) => u32::try_from(*number).ok(),
            Value::Number(number)
                if libm::trunc(*number) == *number
                    && (0.0..=f64::from(u32::MAX)).contains(number) =>
            {
                Some(*number as u32)
            }
            _ => None,
        }
    }

    fn number(self) -> Option<f64> {
        Some(f64::from(self))
    }
}

/// Reads a field from a value and checks it against its specification.
///
/// # Errors
/// [`SettingError::Invalid`] when the type is wrong, the number is not finite or out of bounds, or
/// the name is none of the choices.
pub fn read<T: Field>(spec: &Spec, value: &Value) -> Result<T, SettingError> {
    let within = |number: f64| match spec.kind {
        Kind::Number(least, most) => (least..=most).contains(&number),
        #[expect(clippy::cast_precision_loss, reason = "bounds are far below 2^53")]
        Kind::Integer(least, most) => (least as f64..=most as f64).contains(&number),
        Kind::Switch | Kind::Choice(_) => true,
    };
    T::from_value(value).filter(|field| field.number().is_none_or(within)).ok_or_else(|| {
        SettingError::Invalid {
            key: spec.key,
            expected: spec.expected(),
            found: format!("`{value}`"),
        }
    })
}

/// The known key most similar to a mistyped one, if any is close.
#[must_use]
pub fn nearest(specs: &[Spec], key: &str) -> Option<&'static str> {
    let allowed = 2 + key.len() / 5;
    specs
        .iter()
        .map(|spec| (edit_distance(spec.key, key), spec.key))
        .min()
        .filter(|(distance, _)| *distance <= allowed)
        .map(|(_, key)| key)
}

/// Levenshtein distance over bytes.
fn edit_distance(a: &str, b: &str) -> usize {
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.bytes().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.bytes().enumerate() {
            let substituted = diagonal + usize::from(x != y);
            diagonal = row[j + 1];
            row[j + 1] = substituted.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

/// Declares an enum whose variants are the choices of a setting.
#[macro_export]
macro_rules! choice {
    ($(#[$outer:meta])* pub enum $name:ident {
        $($(#[$first:meta])? $variant:ident = $value:literal: $meaning:literal,)+
    }) => {
        $(#[$outer])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $name {
            $(#[doc = $meaning] $variant,)+
        }

        impl $crate::settings::Field for $name {
            fn kind(_: Option<(f64, f64)>) -> $crate::settings::Kind {
                $crate::settings::Kind::Choice(&[$(($value, $meaning)),+])
            }

            fn to_value(self) -> $crate::settings::Value {
                $crate::settings::Value::Choice(match self { $(Self::$variant => $value,)+ }.into())
            }

            fn from_value(value: &$crate::settings::Value) -> Option<Self> {
                let $crate::settings::Value::Choice(name) = value else { return None };
                match name.as_str() {
                    $($value => Some(Self::$variant),)+
                    _ => None,
                }
            }
        }
    };
}

/// Declares a settings struct with its defaults and its table of [`Spec`]s.
///
/// Each field reads: name, type, default, key, bounds (numbers only), unit, standing, source,
/// meaning.
#[macro_export]
macro_rules! settings {
    ($(#[$outer:meta])* pub struct $name:ident {
        $($field:ident: $type:ty = $default:expr, $key:literal $([$least:expr, $most:expr])?
            $unit:literal, $standing:ident, $source:literal, $meaning:literal;)+
    }) => {
        $(#[$outer])*
        #[derive(Clone, Debug, PartialEq)]
        pub struct $name {
            $(#[doc = $meaning] #[doc = ""] #[doc = concat!("Unit: ", $unit, ". Source: ", $source, ".")]
              pub $field: $type,)+
        }

        impl Default for $name {
            fn default() -> Self {
                Self { $($field: $default,)+ }
            }
        }

        impl $name {
            /// The table of all settings, in the order they are shown.
            #[must_use]
            pub fn specs() -> &'static [$crate::settings::Spec] {
                static SPECS: std::sync::LazyLock<Vec<$crate::settings::Spec>> =
                    std::sync::LazyLock::new(|| vec![$($crate::settings::Spec {
                        key: $key,
                        meaning: $meaning,
                        kind: <$type as $crate::settings::Field>::kind(
                            None$(.or(Some((f64::from($least), f64::from($most)))))?,
                        ),
                        unit: $unit,
                        source: $source,
                        standing: $crate::settings::Standing::$standing,
                    },)+]);
                &SPECS
            }

            /// The value of a setting; none when there is no such key.
            #[must_use]
            pub fn get(&self, key: &str) -> Option<$crate::settings::Value> {
                match key {
                    $($key => Some($crate::settings::Field::to_value(self.$field)),)+
                    _ => None,
                }
            }

            /// Sets one setting by key.
            ///
            /// # Errors
            /// When there is no such key, or the value is of the wrong kind or out of range; nothing
            /// is changed then.
            pub fn set(
                &mut self,
                key: &str,
                value: &$crate::settings::Value,
            ) -> Result<(), $crate::settings::SettingError> {
                let specs = Self::specs();
                let Some(spec) = specs.iter().find(|spec| spec.key == key) else {
                    return Err($crate::settings::SettingError::Unknown {
                        key: key.into(),
                        nearest: $crate::settings::nearest(specs, key),
                    });
                };
                match key {
                    $($key => self.$field = $crate::settings::read(spec, value)?,)+
                    _ => {}
                }
                Ok(())
            }
        }
    };
}

#[cfg(test)]
#[expect(unreachable_pub, reason = "the macros declare public items")]
mod tests {
    use super::*;

    choice! {
        /// A choice for the tests.
        pub enum Colour {
            Red = "red": "like a rose",
            Blue = "blue": "like the sea",
        }
    }

    settings! {
        /// Settings for the tests.
        pub struct Sample {
            noise: f64 = 0.5, "sonar.noise" [0.0, 1.0] "m", Reading, "Eq. (1)", "Noise of a reading";
            rays: u32 = 5, "sonar.rays" [1.0, 9.0] "", Gap, "none", "Rays in a cone";
            on: bool = true, "learner.on" "", Literal, "Alg. 9", "Learn";
            colour: Colour = Colour::Red, "colour" "", Addition, "none", "Colour of the body";
        }
    }

    #[test]
    fn every_setting_reads_back_what_was_set() {
        let mut sample = Sample::default();
        for (key, value) in [
            ("sonar.noise", Value::Number(0.25)),
            ("sonar.rays", Value::Integer(9)),
            ("learner.on", Value::Switch(false)),
            ("colour", Value::Choice("blue".into())),
        ] {
            sample.set(key, &value).expect("a value in range");
            assert_eq!(sample.get(key), Some(value), "{key}");
        }
    }

    #[test]
    fn a_refusal_names_the_key_and_what_would_be_right() {
        let mut sample = Sample::default();
        for (key, value, message) in [
            (
                "sonar.noise",
                Value::Number(1.5),
                "`sonar.noise` must be a number from 0 to 1 (m), not `1.5`",
            ),
            (
                "sonar.noise",
                Value::Number(f64::NAN),
                "`sonar.noise` must be a number from 0 to 1 (m), not `NaN`",
            ),
            (
                "sonar.rays",
                Value::Number(2.5),
                "`sonar.rays` must be a whole number from 1 to 9, not `2.5`",
            ),
            (
                "sonar.rays",
                Value::Integer(0),
                "`sonar.rays` must be a whole number from 1 to 9, not `0`",
            ),
            ("learner.on", Value::Integer(1), "`learner.on` must be true or false, not `1`"),
            (
                "colour",
                Value::Choice("green".into()),
                "`colour` must be one of `red`, `blue`, not `green`",
            ),
            (
                "sonar.nois",
                Value::Number(0.1),
                "there is no setting `sonar.nois`; did you mean `sonar.noise`?",
            ),
            ("weather", Value::Number(0.1), "there is no setting `weather`"),
        ] {
            let error = sample.set(key, &value).expect_err(key);
            assert_eq!(error.to_string(), message);
            assert_eq!(sample, Sample::default());
        }
    }
}
