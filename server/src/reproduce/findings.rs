//! What was found: rows, curves and pictures.

use sonarium_core::stats::{Estimate, Verdict};

use super::{ReproductionError, Sample, Target};
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

impl Row<'_> {
    /// The row of an arm; none when nothing could be estimated.
    #[must_use]
    pub fn of(&self, sample: &Sample, ours: Option<Estimate>) -> Option<ReproductionRow> {
        let ours = ours?;
        let [first, last] = sample.seeds;
        Some(ReproductionRow {
            name: format!("{}: {}", sample.arm.name, self.name),
            published: self.published,
            required: None,
            ours: ours.value,
            low: ours.low,
            high: ours.high,
            n: u32::try_from(ours.n).unwrap_or(u32::MAX),
            unit: self.unit.into(),
            verdict: Verdict::of(self.published, &ours).into(),
            reading: format!("{}, seeds {first}..{last}: {}", sample.arm.words(), self.reading),
        })
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
