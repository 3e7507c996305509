//! Why a map cannot become a world.

/// A refusal: what is wrong, where, and what would be right.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MapError {
    /// The size of a cell makes no sense.
    #[error(
        "`resolution` must be the edge of a cell in metres, greater than 0 and finite, not {found}"
    )]
    Resolution {
        /// What was given.
        found: f64,
    },
    /// The pose of the map makes no sense.
    #[error("`origin[{index}]` must be a finite number, not {found}")]
    Origin {
        /// 0 for x, 1 for y, 2 for yaw.
        index: usize,
        /// What was given.
        found: f64,
    },
    /// The image has no cells.
    #[error("the image must have at least one cell, not {columns} x {rows}")]
    NoCells {
        /// Cells along x.
        columns: u64,
        /// Cells along y.
        rows: u64,
    },
    /// The image has more cells than can be handled.
    #[error(
        "the image has {columns} x {rows} cells, but at most {limit} can be traced, e.g. 4000 x \
         4000; scale it down or cut out the part you need"
    )]
    TooManyCells {
        /// Cells along x.
        columns: u64,
        /// Cells along y.
        rows: u64,
        /// Most cells.
        limit: u64,
    },
    /// Nowhere to drive.
    #[error(
        "the map has no free cell ({occupied} are occupied and {unknown} unknown); look at \
         `free_thresh`, `negate` and the crop"
    )]
    NoFreeCell {
        /// Occupied cells.
        occupied: usize,
        /// Unknown cells.
        unknown: usize,
    },
    /// The boundary of the floor is too ragged.
    #[error(
        "the map has {found} pieces of wall, but at most {limit} can be handled; drop specks, crop \
         the map or use a coarser one"
    )]
    TooManyWalls {
        /// Most pieces.
        limit: usize,
        /// What the map has.
        found: usize,
    },
    /// The floor is too large.
    #[error(
        "the free floor spans {found_m} m, but a world may span at most {limit_m} m; look at \
         `resolution`, or crop the map"
    )]
    TooLarge {
        /// The limit, metres.
        limit_m: f64,
        /// What was found, metres.
        found_m: f64,
    },
    /// The size of a speck makes no sense.
    #[error("`speck_m2` must be an area of at least 0 square metres, not {found}")]
    Speck {
        /// What was given.
        found: f64,
    },
    /// The crop is no part of the map.
    #[error("`crop` must be x0, y0, x1, y1 in metres with x0 < x1 and y0 < y1, and {problem}")]
    Crop {
        /// What is wrong.
        problem: String,
    },
}

impl MapError {
    /// The field at fault: `resolution`, `origin[2]`, `image`, `speck_m2` or `crop`.
    #[must_use]
    pub fn field(&self) -> String {
        match self {
            Self::Resolution { .. } | Self::TooLarge { .. } => "resolution".to_owned(),
            Self::Origin { index, .. } => format!("origin[{index}]"),
            Self::NoCells { .. }
            | Self::TooManyCells { .. }
            | Self::NoFreeCell { .. }
            | Self::TooManyWalls { .. } => "image".to_owned(),
            Self::Speck { .. } => "speck_m2".to_owned(),
            Self::Crop { .. } => "crop".to_owned(),
        }
    }
}
