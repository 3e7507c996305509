//! The YAML file of a map.

use yaml_rust2::{Yaml, YamlLoader};

use crate::catalog::FieldError;

/// Longest text, bytes; such files have some lines.
const LONGEST: usize = 8 * 1024;
/// Most marks of lists and keys (`- `, `? `): each nests what follows it, and the reader works by recursion.
const MOST_MARKS: usize = 100;

/// How pixels are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Free, occupied or unknown by two thresholds.
    Trinary,
    /// The same, and what is not opaque is unknown.
    Scale,
    /// The value of a pixel is the chance in per cent.
    Raw,
}

/// What the YAML file of a map says.
#[derive(Clone, Debug, PartialEq)]
pub struct Metadata {
    /// Path of the picture, relative to the YAML file.
    pub image: String,
    /// Edge of a cell, metres.
    pub resolution_m: f64,
    /// Pose of the lower left corner: x and y in metres, yaw in radians.
    pub origin: [f64; 3],
    /// Dark pixels are free, light ones occupied.
    pub negate: bool,
    /// A cell is occupied when the chance is greater than this.
    pub occupied_thresh: f64,
    /// A cell is free when the chance is less than this.
    pub free_thresh: f64,
    /// How pixels are read.
    pub mode: Mode,
}

impl Metadata {
    /// Reads the text of a YAML file; keys that are not known are left alone.
    ///
    /// # Errors
    /// When it is no YAML, or a key is missing or wrong; the field is `yaml` or e.g.
    /// `yaml.resolution`.
    pub fn parse(yaml: &str) -> Result<Self, FieldError> {
        let refuse = |why: String| {
            let expected = "must be the YAML file of a map, with `image`, `resolution`, `origin` …";
            Err(FieldError::new("yaml", format!("{expected}; {why}")))
        };
        if yaml.len() > LONGEST {
            return refuse(format!("it has {} bytes, at most {LONGEST} are read", yaml.len()));
        }
        if yaml.matches("- ").count() + yaml.matches("? ").count() > MOST_MARKS {
            return refuse("it has too many lists".to_owned());
        }
        let documents = match YamlLoader::load_from_str(yaml) {
            Ok(documents) => documents,
            Err(error) => return refuse(error.to_string()),
        };
        let keys = match documents.into_iter().next() {
            Some(keys @ Yaml::Hash(_)) => Keys(keys),
            _ => return refuse("it has no keys".to_owned()),
        };
        let metadata = Self {
            image: keys.text("image")?,
            resolution_m: keys.number("resolution")?,
            origin: keys.origin()?,
            negate: keys.negate()?,
            occupied_thresh: keys.share("occupied_thresh")?,
            free_thresh: keys.share("free_thresh")?,
            mode: keys.mode()?,
        };
        if metadata.free_thresh > metadata.occupied_thresh {
            let (free, occupied) = (metadata.free_thresh, metadata.occupied_thresh);
            let message = format!("must be at most `occupied_thresh`, but {free} > {occupied}");
            return Err(FieldError::new("yaml.free_thresh", message));
        }
        Ok(metadata)
    }
}

struct Keys(Yaml);

impl Keys {
    fn wrong<T>(&self, key: &str, expected: &str) -> Result<T, FieldError> {
        let found = match &self.0[key] {
            Yaml::BadValue => "but it is missing".to_owned(),
            Yaml::Real(text) | Yaml::String(text) => format!("not `{text}`"),
            Yaml::Integer(value) => format!("not {value}"),
            Yaml::Boolean(value) => format!("not {value}"),
            Yaml::Array(values) => format!("not a list of {}", values.len()),
            _ => "not that".to_owned(),
        };
        Err(FieldError::new(format!("yaml.{key}"), format!("must be {expected}, {found}")))
    }

    fn text(&self, key: &str) -> Result<String, FieldError> {
        match &self.0[key] {
            Yaml::String(text) if !text.is_empty() => Ok(text.clone()),
            _ => self.wrong(key, "the path of the picture, e.g. office.pgm"),
        }
    }

    fn number(&self, key: &str) -> Result<f64, FieldError> {
        match number(&self.0[key]) {
            Some(value) if value > 0.0 => Ok(value),
            _ => self.wrong(key, "the edge of a cell in metres, greater than 0, e.g. 0.05"),
        }
    }

    fn share(&self, key: &str) -> Result<f64, FieldError> {
        match number(&self.0[key]) {
            Some(value) if (0.0..=1.0).contains(&value) => Ok(value),
            _ => self.wrong(key, "a number from 0 to 1"),
        }
    }

    fn origin(&self) -> Result<[f64; 3], FieldError> {
        let values = self.0["origin"].as_vec().map(|values| values.iter().map(number));
        let values: Option<Vec<f64>> = values.and_then(Iterator::collect);
        match values.as_deref() {
            Some(&[x, y, yaw]) => Ok([x, y, yaw]),
            _ => self.wrong("origin", "x and y in metres and yaw in radians, e.g. [0.0, 0.0, 0.0]"),
        }
    }

    fn negate(&self) -> Result<bool, FieldError> {
        match &self.0["negate"] {
            Yaml::Boolean(value) => Ok(*value),
            Yaml::Integer(value @ (0 | 1)) => Ok(*value == 1),
            _ => self.wrong("negate", "0 or 1"),
        }
    }

    fn mode(&self) -> Result<Mode, FieldError> {
        match &self.0["mode"] {
            Yaml::BadValue => Ok(Mode::Trinary),
            Yaml::String(text) if text == "trinary" => Ok(Mode::Trinary),
            Yaml::String(text) if text == "scale" => Ok(Mode::Scale),
            Yaml::String(text) if text == "raw" => Ok(Mode::Raw),
            _ => self.wrong("mode", "trinary, scale or raw"),
        }
    }
}

/// A finite number.
fn number(value: &Yaml) -> Option<f64> {
    #[expect(clippy::cast_precision_loss, reason = "no length of a map comes near 2^53")]
    let whole = |value: i64| value as f64;
    value.as_f64().or_else(|| value.as_i64().map(whole)).filter(|value| value.is_finite())
}
