//! Hashing: sonars into a few overlapping regions, and what a region reads (sections 2.3 and 2.4).

crate::choice! {
    /// Which of an even number of readings is the median.
    pub enum MedianRank {
        Lower = "lower": "the lesser of the middle two, so that it is the reading of one sonar",
        Upper = "upper": "the greater of the middle two",
    }
}

/// Most regions: as many as sonars cover the front of the TRC.
pub const MOST_REGIONS: usize = 10;
/// Most sonars of a region.
const MOST_IN_REGION: usize = crate::robot::MOST_SONARS;

/// Regions that sonars cannot be hashed into.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum HashingError {
    /// There are too many or too few.
    #[error("there must be 1 to {MOST_REGIONS} regions, not {0}")]
    Count(usize),
    /// A region has no sonar.
    #[error("region {} must have at least one sonar", .0 + 1)]
    Empty(usize),
    /// A region names a sonar that there is not.
    #[error("region {} must name sonars from 0 to {most}, not {found}", region + 1)]
    Unknown {
        /// Which region, from 0.
        region: usize,
        /// The last sonar.
        most: usize,
        /// What it names.
        found: usize,
    },
    /// A region names a sonar twice.
    #[error("region {} must name sonar {sonar} once, not twice", region + 1)]
    Twice {
        /// Which region, from 0.
        region: usize,
        /// The sonar.
        sonar: usize,
    },
    /// A region names what is no number.
    #[error("region {} must name sonars by their numbers, as 0,1,2, not `{found}`", region + 1)]
    Word {
        /// Which region, from 0.
        region: usize,
        /// What it names.
        found: String,
    },
    /// A sonar is in no region.
    #[error("sonar {0} must be in a region; the regions must cover all sonars")]
    Uncovered(usize),
}

/// A reading that is none.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("the reading of sonar {sonar} must be a finite number of at least 0 m, not {found}")]
pub struct ReadingError {
    /// Which sonar.
    pub sonar: usize,
    /// What it read.
    pub found: f64,
}

/// Which sonars each region has, from the left to the right.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hashing {
    regions: Vec<Vec<usize>>,
    sonars: usize,
}

/// What the sonars of a region read at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Snapshot {
    /// Sonars that answer.
    pub live: usize,
    /// Least reading, Eq. (2.1), metres.
    pub minimum_m: f64,
    /// Median reading, Eq. (2.2), metres.
    pub median_m: f64,
}

impl Hashing {
    /// Regions of their own.
    ///
    /// # Errors
    /// When there are too many or too few, one is empty or names a sonar that there is not, or a sonar is
    /// in none.
    pub fn new(regions: Vec<Vec<usize>>, sonars: usize) -> Result<Self, HashingError> {
        if !(1..=MOST_REGIONS).contains(&regions.len()) {
            return Err(HashingError::Count(regions.len()));
        }
        let mut covered = vec![false; sonars];
        for (region, members) in regions.iter().enumerate() {
            if members.is_empty() {
                return Err(HashingError::Empty(region));
            }
            for (place, &found) in members.iter().enumerate() {
                if found >= sonars {
                    return Err(HashingError::Unknown { region, most: sonars.max(1) - 1, found });
                }
                if members[..place].contains(&found) {
                    return Err(HashingError::Twice { region, sonar: found });
                }
                covered[found] = true;
            }
        }
        match covered.iter().position(|covered| !covered) {
            Some(sonar) => Err(HashingError::Uncovered(sonar)),
            None => Ok(Self { regions, sonars }),
        }
    }

    /// Regions as they are written, the sonars of each with commas, regions with semicolons, from the left
    /// to the right: `0,1,2; 1,2,3,4`.
    ///
    /// # Errors
    /// As [`Self::new`], and when a sonar is no number.
    pub fn parse(text: &str, sonars: usize) -> Result<Self, HashingError> {
        let sonar = |region, word: &str| {
            word.parse().map_err(|_| HashingError::Word { region, found: word.to_owned() })
        };
        let members = |(region, text): (usize, &str)| match text.trim() {
            "" => Ok(Vec::new()),
            text => text.split(',').map(|word| sonar(region, word.trim())).collect(),
        };
        let regions: Result<Vec<Vec<usize>>, _> =
            text.split(';').enumerate().map(members).collect();
        Self::new(regions?, sonars)
    }

    /// So many regions of neighbouring sonars, as even as can be.
    ///
    /// Section 2.3: sonars adjacent to two regions are considered in both. NOTE: read as that each region
    /// also has the nearest sonar of its neighbours; so the thesis's five of ten sonars are {0, 1, 2},
    /// {1, 2, 3, 4}, {3, 4, 5, 6}, {5, 6, 7, 8} and {7, 8, 9}. Without overlap each sonar is in one.
    ///
    /// # Errors
    /// When there are too many regions, or more than sonars.
    pub fn even(count: usize, sonars: usize, overlap: bool) -> Result<Self, HashingError> {
        if !(1..=MOST_REGIONS).contains(&count) {
            return Err(HashingError::Count(count));
        }
        let around = usize::from(overlap && count > 1);
        let region = |index: usize| {
            let (first, end) = (index * sonars / count, (index + 1) * sonars / count);
            if first == end {
                return Vec::new();
            }
            (first.saturating_sub(around)..(end + around).min(sonars)).collect()
        };
        Self::new((0..count).map(region).collect(), sonars)
    }

    /// The sonars of each region.
    #[must_use]
    pub fn regions(&self) -> &[Vec<usize>] {
        &self.regions
    }

    /// What each region reads, given one reading a sonar in metres and whether it is silent. A silent
    /// sonar is left out; a region whose sonars are all silent reads nothing.
    ///
    /// # Errors
    /// When a sonar that answers gives no distance.
    ///
    /// # Panics
    /// When there are fewer readings than sonars.
    pub fn read(
        &self,
        readings_m: &[f64],
        silent: &[bool],
        rank: MedianRank,
    ) -> Result<Vec<Option<Snapshot>>, ReadingError> {
        for (sonar, &found) in readings_m[..self.sonars].iter().enumerate() {
            let is_distance = found.is_finite() && found >= 0.0;
            if !(silent[sonar] || is_distance) {
                return Err(ReadingError { sonar, found });
            }
        }
        let live = |members: &Vec<usize>| snapshot(members, readings_m, silent, rank);
        Ok(self.regions.iter().map(live).collect())
    }
}

fn snapshot(
    members: &[usize],
    readings_m: &[f64],
    silent: &[bool],
    rank: MedianRank,
) -> Option<Snapshot> {
    let mut sorted = [0.0; MOST_IN_REGION];
    let mut live = 0;
    for &sonar in members.iter().filter(|&&sonar| !silent[sonar]) {
        sorted[live] = readings_m[sonar];
        live += 1;
    }
    let sorted = &mut sorted[..live];
    sorted.sort_by(f64::total_cmp);
    let middle = match rank {
        // NOTE: Eq. (2.2) chooses the reading of a single sonar, so of an even number the mean of the
        // middle two is none; the lower one is the ⌈N/2⌉-th smallest.
        MedianRank::Lower => live.div_ceil(2).checked_sub(1)?,
        MedianRank::Upper => live / 2,
    };
    // Eq. (2.1): d = min(s_1, …, s_N)
    let minimum_m = *sorted.first()?;
    // Eq. (2.2): z = median(s_1, …, s_N)
    Some(Snapshot { live, minimum_m, median_m: sorted[middle] })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn the_regions_of_the_thesis() {
        let five = Hashing::even(5, 10, true).expect("ten sonars");
        let expected: [&[usize]; 5] =
            [&[0, 1, 2], &[1, 2, 3, 4], &[3, 4, 5, 6], &[5, 6, 7, 8], &[7, 8, 9]];
        assert_eq!(five.regions(), expected);
        let one = Hashing::even(1, 10, true).expect("no hashing");
        assert_eq!(one.regions(), [(0..10).collect::<Vec<_>>()]);
        assert_eq!(Hashing::even(10, 10, false).expect("each its own").regions()[9], [9]);
    }

    #[test]
    fn regions_that_do_not_cover_the_sonars_are_refused() {
        for (regions, error) in [
            (vec![], HashingError::Count(0)),
            (vec![vec![0]; 11], HashingError::Count(11)),
            (vec![vec![0, 1, 2], vec![]], HashingError::Empty(1)),
            (vec![vec![0, 1], vec![2, 3]], HashingError::Unknown { region: 1, most: 2, found: 3 }),
            (vec![vec![0, 1, 2, 0]], HashingError::Twice { region: 0, sonar: 0 }),
            (vec![vec![0], vec![2]], HashingError::Uncovered(1)),
        ] {
            assert_eq!(Hashing::new(regions, 3), Err(error));
        }
        assert_eq!(Hashing::even(6, 5, true), Err(HashingError::Empty(0)));
    }

    #[test]
    fn regions_are_read_as_they_are_written() {
        let text = "0,1,2; 1,2,3,4; 3,4,5,6; 5, 6,7,8 ;7,8,9";
        assert_eq!(Hashing::parse(text, 10), Hashing::even(5, 10, true));
        for (text, says) in [
            ("0,1;;2", "region 2 must have at least one sonar"),
            ("0,1,2;", "region 2 must have at least one sonar"),
            ("0,1,12;2", "region 1 must name sonars from 0 to 2, not 12"),
            ("0,1;2,1,2", "region 2 must name sonar 2 once, not twice"),
            ("0,1;2,x", "region 2 must name sonars by their numbers, as 0,1,2, not `x`"),
            ("0,1;-2", "region 2 must name sonars by their numbers, as 0,1,2, not `-2`"),
            ("0;2", "sonar 1 must be in a region; the regions must cover all sonars"),
            ("0;1;2;0;1;2;0;1;2;0;1", "there must be 1 to 10 regions, not 11"),
        ] {
            let error = Hashing::parse(text, 3).expect_err(text);
            assert_eq!(error.to_string(), says);
        }
    }

    #[test]
    fn readings_by_hand() {
        let hashing = Hashing::new(vec![vec![0, 1, 2, 3], vec![3, 4]], 5).expect("covers");
        let readings_m = [0.8, 0.3, 2.0, 1.1, 0.9];
        let read = |silent: [bool; 5], rank| {
            let read = hashing.read(&readings_m, &silent, rank).expect("distances");
            read.iter()
                .map(|read| read.map(|read| (read.live, read.minimum_m, read.median_m)))
                .collect::<Vec<_>>()
        };
        let all = [false; 5];
        assert_eq!(read(all, MedianRank::Lower), [Some((4, 0.3, 0.8)), Some((2, 0.9, 0.9))]);
        assert_eq!(read(all, MedianRank::Upper), [Some((4, 0.3, 1.1)), Some((2, 0.9, 1.1))]);
        let some = [false, true, false, true, true];
        assert_eq!(read(some, MedianRank::Lower), [Some((2, 0.8, 0.8)), None]);
    }

    #[test]
    fn what_is_no_distance_is_refused_unless_it_is_not_looked_at() {
        let hashing = Hashing::even(1, 3, true).expect("one region");
        for found in [-0.1, f64::NAN, f64::INFINITY] {
            let readings_m = [1.0, found, 1.0];
            let error = hashing.read(&readings_m, &[false; 3], MedianRank::Lower).expect_err("bad");
            assert!(error.to_string().starts_with("the reading of sonar 1 must be"), "{error}");
            let silent = [false, true, false];
            assert!(hashing.read(&readings_m, &silent, MedianRank::Lower).is_ok());
        }
    }

    proptest! {
        #[test]
        fn hashing_covers_every_sonar(count in 1..=10usize, more in 0..14usize, overlap: bool) {
            let sonars = count + more;
            let hashing = Hashing::even(count, sonars, overlap).expect("enough sonars");
            prop_assert_eq!(hashing.regions().len(), count);
            let of = |sonar: usize| {
                hashing.regions().iter().filter(|members| members.contains(&sonar)).count()
            };
            for sonar in 0..sonars {
                prop_assert!(of(sonar) >= 1 && (overlap || of(sonar) == 1), "sonar {sonar}");
            }
            for members in hashing.regions() {
                prop_assert!(members.windows(2).all(|pair| pair[1] == pair[0] + 1));
            }
        }

        #[test]
        fn minimum_and_medians_are_in_order(readings_m in proptest::array::uniform10(0.0..2.0f64)) {
            let hashing = Hashing::even(5, 10, true).expect("ten sonars");
            let read = |rank| hashing.read(&readings_m, &[false; 10], rank).expect("distances");
            for (lower, upper) in read(MedianRank::Lower).iter().zip(read(MedianRank::Upper)) {
                let (lower, upper) = (lower.expect("live"), upper.expect("live"));
                prop_assert!(lower.minimum_m <= lower.median_m && lower.median_m <= upper.median_m);
            }
        }
    }
}
