//! The colours of a picture, light and dark, in one place.
//!
//! Hues follow the Okabe-Ito palette, which stays apart under the common colour vision
//! deficiencies; the scale of utilities is viridis. Everything that carries meaning by colour also
//! differs in shape, line style or size.

use super::scene::Colour;
use crate::wire::ThemeName;

/// Colours by what they are used for.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Theme {
    /// Ground of the whole picture.
    pub(super) background: Colour,
    /// Text and fine marks.
    pub(super) ink: Colour,
    /// Secondary text and rules.
    pub(super) faint_ink: Colour,
    /// Wall lines and outlines of blocks.
    pub(super) wall: Colour,
    /// Filling of solid blocks.
    pub(super) block: Colour,
    /// Floor tints of the regions, used in turn.
    pub(super) regions: [Colour; 6],
    /// Goal disc and its rim.
    pub(super) goal: Colour,
    /// Paths of earlier trials; faded by age.
    pub(super) ghost: Colour,
    /// Best path.
    pub(super) best: Colour,
    /// Path of the trial shown.
    pub(super) path: Colour,
    /// Collision marks.
    pub(super) collision: Colour,
    /// Sonar cones.
    pub(super) cone: Colour,
    /// Shell of the robot.
    pub(super) robot: Colour,
    /// The part of the scale of utilities that stands out from the ground.
    pub(super) utilities: [f64; 2],
    /// Opacity of a region's tint.
    pub(super) tint_opacity: f32,
    /// Opacity of the newest and of the oldest ghost path drawn.
    pub(super) ghost_opacity: [f32; 2],
}

impl Theme {
    /// The colours of this theme.
    pub(super) fn of(name: ThemeName) -> &'static Self {
        match name {
            ThemeName::Light => &LIGHT,
            ThemeName::Dark => &DARK,
        }
    }

    /// The colour of a utility scaled to 0 (worst) to 1 (best).
    pub(super) fn utility(&self, utility: f64) -> Colour {
        let [worst, best] = self.utilities;
        viridis(worst + (best - worst) * utility.clamp(0.0, 1.0))
    }

    /// Floor tint of the region with this index.
    pub(super) fn region(&self, index: usize) -> Colour {
        self.regions[index % self.regions.len()].fade(self.tint_opacity)
    }
}

const OKABE_ITO: [Colour; 6] = [
    Colour::rgb(0x56b4e9),
    Colour::rgb(0xe69f00),
    Colour::rgb(0x009e73),
    Colour::rgb(0xcc79a7),
    Colour::rgb(0xf0e442),
    Colour::rgb(0xd55e00),
];

const LIGHT: Theme = Theme {
    background: Colour::rgb(0xffffff),
    ink: Colour::rgb(0x1d232b),
    faint_ink: Colour::rgb(0x5c6672),
    wall: Colour::rgb(0x2a313a),
    block: Colour::rgb(0xb9c0c8),
    regions: OKABE_ITO,
    goal: Colour::rgb(0x00875f),
    ghost: Colour::rgb(0x57616e),
    best: Colour::rgb(0x00795a),
    path: Colour::rgb(0x0b5cad),
    collision: Colour::rgb(0xc0392b),
    cone: Colour::rgb(0xd98200),
    robot: Colour::rgb(0x1d232b),
    utilities: [0.0, 0.97],
    tint_opacity: 0.11,
    ghost_opacity: [0.40, 0.08],
};

const DARK: Theme = Theme {
    background: Colour::rgb(0x12161c),
    ink: Colour::rgb(0xe8edf2),
    faint_ink: Colour::rgb(0x9aa6b3),
    wall: Colour::rgb(0xc3ccd6),
    block: Colour::rgb(0x49535f),
    regions: OKABE_ITO,
    goal: Colour::rgb(0x2fc79a),
    ghost: Colour::rgb(0xaab6c4),
    best: Colour::rgb(0x35d0a2),
    path: Colour::rgb(0x63b3ff),
    collision: Colour::rgb(0xff7b6b),
    cone: Colour::rgb(0xffb84d),
    robot: Colour::rgb(0xf2f5f8),
    utilities: [0.2, 1.0],
    tint_opacity: 0.12,
    ghost_opacity: [0.42, 0.09],
};

/// Viridis at nine even steps (Smith and van der Walt, matplotlib 2.0).
const VIRIDIS: [Colour; 9] = [
    Colour::rgb(0x440154),
    Colour::rgb(0x472d7b),
    Colour::rgb(0x3b528b),
    Colour::rgb(0x2c728e),
    Colour::rgb(0x21918c),
    Colour::rgb(0x28ae80),
    Colour::rgb(0x5ec962),
    Colour::rgb(0xaddc30),
    Colour::rgb(0xfde725),
];

/// The colour at a place on the scale, 0 to 1; lightness grows evenly along it.
fn viridis(place: f64) -> Colour {
    let place = if place.is_finite() { place.clamp(0.0, 1.0) as f32 } else { 0.0 } * 8.0;
    let below = (place.floor() as usize).min(7);
    VIRIDIS[below].mix(VIRIDIS[below + 1], place - below as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_is_viridis() {
        for (place, expected) in [
            (0.0, 0x440154),
            (0.5, 0x21918c),
            (1.0, 0xfde725),
            (-3.0, 0x440154),
            (7.0, 0xfde725),
            (f64::NAN, 0x440154),
            (0.0625, 0x461768),
        ] {
            assert_eq!(viridis(place), Colour::rgb(expected), "{place}");
        }
    }

    /// Relative luminance of the Web Content Accessibility Guidelines.
    fn luminance(colour: Colour) -> f64 {
        let linear = |channel: u8| {
            let value = f64::from(channel) / 255.0;
            if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
        };
        let [red, green, blue, _] = colour.0;
        0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue)
    }

    fn contrast(a: Colour, b: Colour) -> f64 {
        let (a, b) = (luminance(a), luminance(b));
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    #[test]
    fn text_and_marks_stand_out_from_the_ground() {
        for name in [ThemeName::Light, ThemeName::Dark] {
            let theme = Theme::of(name);
            for (what, colour, least) in [
                ("ink", theme.ink, 7.0),
                ("faint ink", theme.faint_ink, 4.5),
                ("wall", theme.wall, 7.0),
                ("goal", theme.goal, 4.5),
                ("best path", theme.best, 4.5),
                ("path", theme.path, 4.5),
                ("collision", theme.collision, 4.5),
            ] {
                let ratio = contrast(colour, theme.background);
                assert!(ratio >= least, "{name:?} {what}: {ratio:.2} is below {least}");
            }
        }
    }
}
