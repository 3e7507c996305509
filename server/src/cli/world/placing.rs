//! Options that say where home and goal are and how a map is traced.

use std::path::PathBuf;
use std::str::FromStr;

use clap::Args;

use crate::cli::Failure;

/// What a file's world is changed to.
#[derive(Args, Clone, Debug, Default)]
pub(crate) struct Placing {
    /// Where trials start: metres, metres, degrees; the roomiest place of a map when missing
    #[arg(long, value_name = "X,Y,HEADING", allow_hyphen_values = true)]
    pub(super) home: Option<Numbers<3>>,
    /// Where they should end: metres, and the goal's radius, 0.5 when missing
    #[arg(long, value_name = "X,Y[,RADIUS]", allow_hyphen_values = true, value_parser = goal)]
    pub(super) goal: Option<Numbers<3>>,
    /// `none`, `proposed`, or a TOML file with regions; a map has none when missing
    #[arg(long, value_name = "none|proposed|FILE")]
    pub(super) regions: Option<Regions>,
    /// Drop patches of a map's cells smaller than this, square metres
    #[arg(long, value_name = "M2")]
    pub(super) speck: Option<f64>,
    /// Keep only this part of a map, metres
    #[arg(long, value_name = "X0,Y0,X1,Y1", allow_hyphen_values = true)]
    pub(super) crop: Option<Numbers<4>>,
}

impl Placing {
    /// Refuses options that would have no effect.
    pub(crate) fn refuse_without_world(&self) -> Result<(), Failure> {
        let given = [
            ("--home", self.home.is_some()),
            ("--goal", self.goal.is_some()),
            ("--regions", self.regions.is_some()),
            ("--speck", self.speck.is_some()),
            ("--crop", self.crop.is_some()),
        ];
        match given.into_iter().find(|(_, is_given)| *is_given) {
            Some((option, _)) => Err(Failure::Input(format!("{option} needs --world FILE"))),
            None => Ok(()),
        }
    }
}

/// Numbers with commas between them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Numbers<const N: usize>(pub(super) [f64; N]);

impl<const N: usize> FromStr for Numbers<N> {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || format!("`{text}` must be {N} numbers with commas between them");
        let numbers: Result<Vec<f64>, _> =
            text.split(',').map(|part| part.trim().parse()).collect();
        let numbers = numbers.ok().filter(|numbers| numbers.iter().all(|n: &f64| n.is_finite()));
        numbers.and_then(|numbers| numbers.try_into().ok()).map(Self).ok_or_else(wrong)
    }
}

/// Radius of a goal that names none, that of section 5.3, metres.
const GOAL_RADIUS_M: f64 = 0.5;

fn goal(text: &str) -> Result<Numbers<3>, String> {
    if let Ok(Numbers([x, y])) = text.parse() {
        return Ok(Numbers([x, y, GOAL_RADIUS_M]));
    }
    text.parse().map_err(|_| format!("`{text}` must be X,Y or X,Y,RADIUS in metres"))
}

/// Where regions come from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Regions {
    /// One region, which is everywhere.
    None,
    /// The world is cut at its joints.
    Proposed,
    /// A file with `[[regions]]`.
    File(PathBuf),
}

impl FromStr for Regions {
    type Err = std::convert::Infallible;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        Ok(match text {
            "none" => Self::None,
            "proposed" => Self::Proposed,
            file => Self::File(file.into()),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_numbers_with_commas() {
        assert_eq!("1,-2.5, 90".parse(), Ok(Numbers([1.0, -2.5, 90.0])));
        for wrong in ["", "1,2", "1,2,3,4", "1;2;3", "1,2,nan", "1,2,x"] {
            assert!(wrong.parse::<Numbers<3>>().is_err(), "{wrong:?}");
        }
        assert_eq!(goal("1,2"), Ok(Numbers([1.0, 2.0, 0.5])));
        assert_eq!(goal("1,2,0.3"), Ok(Numbers([1.0, 2.0, 0.3])));
        assert!(goal("1").is_err());
    }
}
