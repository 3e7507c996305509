//! What was found: rows, curves and pictures.

use std::sync::Arc;

use sonarium_core::stats::{Estimate, Verdict};

use super::{ReproductionError, Target};
use crate::render::ArenaView;
use crate::wire::{Reproduction, ReproductionCurve, ReproductionPicture, ReproductionRow};

/// What was found in the sets of a target.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Findings {
    /// Published beside ours.
    pub rows: Vec<ReproductionRow>,
    /// Quantities over trials.
    pub curves: Vec<ReproductionCurve>,
    /// Trajectories and the like.
    pub pictures: Vec<Picture>,
}

/// A picture, not yet drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Name, unique in the target; letters, digits and hyphens.
    pub name: String,
    /// Name of the arm.
    pub arm: String,
    /// What is to be seen, for those who cannot see it.
    pub alt: String,
    /// What is drawn; its caption is the picture's.
    pub view: ArenaView,
}

/// A row before our figure is known.
#[derive(Clone, Copy, Debug)]
pub struct Row<'a> {
    /// The quantity.
    pub name: &'a str,
    /// What the thesis prints, or what its words were read as; none when it says nothing.
    pub published: Option<f64>,
    /// Unit; empty for a pure number.
    pub unit: &'a str,
    /// How the figure was found and the thesis read.
    pub reading: &'a str,
}

/// Where the figure of a row was found.
pub trait Origin {
    /// Name of the arm, with which the row's begins.
    fn arm(&self) -> &str;
    /// What was run, with the seeds: `Preset default, seeds 700000..700199`.
    fn words(&self) -> String;
}

impl<Inside: Origin> Origin for Arc<Inside> {
    fn arm(&self) -> &str {
        (**self).arm()
    }

    fn words(&self) -> String {
        (**self).words()
    }
}

impl Row<'_> {
    /// The row of an arm; none when nothing could be estimated.
    #[must_use]
    pub fn of(&self, origin: &dyn Origin, ours: Option<Estimate>) -> Option<ReproductionRow> {
        let row = self.over_arms(ours)?;
        Some(ReproductionRow {
            name: format!("{}: {}", origin.arm(), row.name),
            reading: format!("{}: {}", origin.words(), row.reading),
            ..row
        })
    }

    /// A row about several arms together; none when nothing could be estimated.
    #[must_use]
    pub fn over_arms(&self, ours: Option<Estimate>) -> Option<ReproductionRow> {
        let ours = ours?;
        Some(ReproductionRow {
            name: self.name.into(),
            published: self.published,
            required: None,
            ours: ours.value,
            low: ours.low,
            high: ours.high,
            n: u32::try_from(ours.n).unwrap_or(u32::MAX),
            unit: self.unit.into(),
            verdict: Verdict::of(self.published, &ours).into(),
            reading: self.reading.into(),
        })
    }

    /// The row of a figure that was computed exactly, of an arm or of all together, held against what is
    /// printed to a digit of this worth. It has no sample: its n is 0 and its interval has no width.
    #[must_use]
    pub fn exact(&self, arm: Option<&str>, ours: f64, digit: f64) -> ReproductionRow {
        ReproductionRow {
            name: arm.map_or_else(|| self.name.into(), |arm| format!("{arm}: {}", self.name)),
            published: self.published,
            required: None,
            ours,
            low: ours,
            high: ours,
            n: 0,
            unit: self.unit.into(),
            verdict: Verdict::exact(self.published, ours, digit).into(),
            reading: self.reading.into(),
        }
    }
}

impl Findings {
    /// The findings as they travel.
    #[must_use]
    pub fn wire(&self, target: &Target) -> Reproduction {
        let picture = |picture: &Picture| ReproductionPicture {
            name: picture.name.clone(),
            arm: picture.arm.clone(),
            caption: picture.view.caption.clone(),
            alt: picture.alt.clone(),
        };
        Reproduction {
            target: target.name.into(),
            rows: self.rows.clone(),
            curves: self.curves.clone(),
            pictures: self.pictures.iter().map(picture).collect(),
            build: crate::build(),
        }
    }

    /// A picture by name.
    ///
    /// # Errors
    /// When there is none; the error names those there are.
    pub fn picture(&self, name: &str) -> Result<&Picture, ReproductionError> {
        self.pictures.iter().find(|picture| picture.name == name).ok_or_else(|| {
            let known: Vec<&str> = self.pictures.iter().map(|p| p.name.as_str()).collect();
            let known = if known.is_empty() { "none".to_owned() } else { known.join(", ") };
            ReproductionError::NoPicture { name: name.to_owned(), known }
        })
    }
}
