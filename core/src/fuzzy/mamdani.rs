//! The output area of Mamdani inference, and the defuzzifiers, Eq. (2.21)-(2.24).

use super::Shape;

crate::choice! {
    /// How activations become one output area.
    pub enum Inference {
        ProductSum = "product-sum": "each set scaled by its activation, areas added; the centre of area is exact",
        MinMax = "min-max": "each set clipped at its activation, the greatest kept; the centre of area is a sum over 720 points",
    }
}

crate::choice! {
    /// How an output area becomes a number.
    pub enum Defuzzifier {
        CentreOfArea = "centre-of-area": "centre of the area, Eq. (2.23)",
        MeanOfMaximum = "mean-of-maximum": "mean of the values of greatest membership, Eq. (2.22)",
    }
}

/// Points at which a clipped area is sampled.
const SAMPLES: u32 = 720;
/// How much two heights may differ and still both be the greatest.
const SAME_HEIGHT: f64 = 1e-12;

impl Defuzzifier {
    /// The value an output area stands for; none when nothing is active.
    #[must_use]
    pub fn value<S: Shape>(
        self,
        inference: Inference,
        sets: &[S],
        activations: &[f64],
    ) -> Option<f64> {
        match self {
            Self::CentreOfArea => centre_of_area(inference, sets, activations),
            Self::MeanOfMaximum => mean_of_maximum(inference, sets, activations),
        }
    }
}

/// Centre of the area under the output sets, each activated to a degree of at least 0; none when
/// nothing is active.
#[must_use]
pub fn centre_of_area<S: Shape>(
    inference: Inference,
    sets: &[S],
    activations: &[f64],
) -> Option<f64> {
    match inference {
        Inference::ProductSum => scaled(sets, activations),
        Inference::MinMax => clipped(sets, activations),
    }
}

/// Scaled sets keep their centroids, so their weighted mean is the centre of the added areas.
fn scaled<S: Shape>(sets: &[S], activations: &[f64]) -> Option<f64> {
    let mut moment = 0.0;
    let mut area = 0.0;
    for (set, activation) in sets.iter().zip(activations) {
        moment += activation * set.area() * set.centroid();
        area += activation * set.area();
    }
    // Eq. (2.23): v = (∫ μ_B(x) dx)⁻¹ ∫ x μ_B(x) dx
    (area > 0.0).then(|| moment / area)
}

fn clipped<S: Shape>(sets: &[S], activations: &[f64]) -> Option<f64> {
    let left = sets.iter().map(|set| set.corners()[0]).fold(f64::INFINITY, f64::min);
    let right = sets.iter().map(|set| set.corners()[3]).fold(f64::NEG_INFINITY, f64::max);
    let mut moment = 0.0;
    let mut area = 0.0;
    for sample in 0..SAMPLES {
        let value = left + (right - left) * (f64::from(sample) + 0.5) / f64::from(SAMPLES);
        let height = sets
            .iter()
            .zip(activations)
            .map(|(set, activation)| set.membership(value).min(*activation))
            .fold(0.0, f64::max);
        moment += height * value;
        area += height;
    }
    // Eq. (2.23): v = (∫ μ_B(x) dx)⁻¹ ∫ x μ_B(x) dx
    (area > 0.0).then(|| moment / area)
}

/// Mean of the values at which the output area is highest, Eq. (2.22); none when nothing is active.
///
/// Of several plateaus each counts by its length, so that the mean is that over all such values; of
/// peaks without length each counts once.
#[must_use]
pub fn mean_of_maximum<S: Shape>(
    inference: Inference,
    sets: &[S],
    activations: &[f64],
) -> Option<f64> {
    let highest = match inference {
        Inference::MinMax => clipped_plateaus(sets, activations),
        Inference::ProductSum => summed_plateaus(sets, activations),
    };
    mean_of_intervals(highest)
}

/// Where the union of clipped sets is highest: where the strongest sets are cut.
fn clipped_plateaus<S: Shape>(sets: &[S], activations: &[f64]) -> Vec<(f64, f64)> {
    let greatest = activations.iter().copied().fold(0.0, f64::max);
    let strongest = sets.iter().zip(activations);
    let strongest = strongest.filter(|(_, height)| greatest > 0.0 && **height == greatest);
    strongest.map(|(set, height)| set.level(height.min(1.0))).collect()
}

/// Where the sum of scaled sets is highest: it has linear pieces, so at a corner or between two.
fn summed_plateaus<S: Shape>(sets: &[S], activations: &[f64]) -> Vec<(f64, f64)> {
    let mut corners: Vec<f64> = sets.iter().flat_map(Shape::corners).collect();
    corners.sort_by(f64::total_cmp);
    corners.dedup();
    let height = |value: f64| {
        let scaled = sets.iter().zip(activations);
        scaled.map(|(set, activation)| activation * set.membership(value)).sum::<f64>()
    };
    let heights: Vec<f64> = corners.iter().map(|&corner| height(corner)).collect();
    let greatest = heights.iter().copied().fold(0.0, f64::max);
    if greatest <= 0.0 {
        return Vec::new();
    }
    let top = |height: f64| height >= greatest - SAME_HEIGHT;
    let peaks = corners.iter().zip(&heights).filter(|(_, height)| top(**height));
    let peaks = peaks.map(|(&corner, _)| (corner, corner));
    let pairs = corners.windows(2).filter(|pair| {
        pair.iter().all(|&corner| top(height(corner)))
            && top(height(f64::midpoint(pair[0], pair[1])))
    });
    peaks.chain(pairs.map(|pair| (pair[0], pair[1]))).collect()
}

/// Mean over a union of intervals, by length; of points alone, their mean.
fn mean_of_intervals(mut intervals: Vec<(f64, f64)>) -> Option<f64> {
    intervals.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut merged: Vec<(f64, f64)> = Vec::new();
    for (from, to) in intervals {
        match merged.last_mut() {
            Some(last) if from <= last.1 => last.1 = last.1.max(to),
            _ => merged.push((from, to)),
        }
    }
    let length: f64 = merged.iter().map(|(from, to)| to - from).sum();
    let weighted = merged.iter().map(|(from, to)| (to - from, f64::midpoint(*from, *to)));
    if length > 0.0 {
        return Some(weighted.map(|(weight, middle)| weight * middle).sum::<f64>() / length);
    }
    let middles: Vec<f64> = weighted.map(|(_, middle)| middle).collect();
    mean_of_greatest(&middles, &vec![1.0; middles.len()])
}

/// Centroid of a set of single values with their memberships, Eq. (2.24); none when all are 0.
#[must_use]
pub fn centre_of_values(values: &[f64], memberships: &[f64]) -> Option<f64> {
    let weight: f64 = memberships.iter().sum();
    let moment: f64 = values.iter().zip(memberships).map(|(value, degree)| value * degree).sum();
    // Eq. (2.24): v = (Σ μ_B(v_i))⁻¹ Σ v_i μ_B(v_i)
    (weight > 0.0).then(|| moment / weight)
}

/// Mean of the single values of greatest membership, Eq. (2.22); of one, Eq. (2.21). None when all
/// are 0.
#[must_use]
pub fn mean_of_greatest(values: &[f64], memberships: &[f64]) -> Option<f64> {
    let greatest = memberships.iter().copied().fold(0.0, f64::max);
    let strongest: Vec<f64> = values
        .iter()
        .zip(memberships)
        .filter(|(_, degree)| greatest > 0.0 && **degree == greatest)
        .map(|(value, _)| *value)
        .collect();
    // Eq. (2.22): v = (1/N) Σ v_i
    crate::stats::mean(&strongest)
}

#[cfg(test)]
mod tests {
    use super::super::{Trapezoid, Triangle};
    use super::*;

    const SETS: [Triangle; 3] = [
        Triangle { left: 0.0, peak: 1.0, right: 2.0 },
        Triangle { left: -1.0, peak: 0.0, right: 1.0 },
        Triangle { left: -2.0, peak: -1.0, right: 0.0 },
    ];

    #[test]
    fn centres_of_area_in_closed_form() {
        // Clipping (1, 0, 0) at 1 leaves the whole triangle; (1, 0, 1) is symmetric.
        for (inference, activations, expected) in [
            (Inference::ProductSum, [1.0, 0.0, 0.0], Some(1.0)),
            (Inference::ProductSum, [0.3, 0.6, 0.1], Some(0.2)),
            (Inference::ProductSum, [0.0, 0.0, 0.0], None),
            (Inference::MinMax, [1.0, 0.0, 0.0], Some(1.0)),
            (Inference::MinMax, [0.4, 0.2, 0.4], Some(0.0)),
            (Inference::MinMax, [0.0, 0.0, 0.0], None),
        ] {
            let found = centre_of_area(inference, &SETS, &activations);
            match (found, expected) {
                (Some(found), Some(expected)) => {
                    assert!(
                        (found - expected).abs() < 1e-9,
                        "{inference:?} {activations:?} {found}"
                    );
                }
                _ => assert_eq!(found, expected, "{inference:?} {activations:?}"),
            }
        }
    }

    #[test]
    fn a_clipped_triangle_keeps_its_symmetry_axis() {
        for height in [0.1, 0.5, 0.9] {
            let found = centre_of_area(Inference::MinMax, &SETS, &[height, 0.0, 0.0]);
            assert!((found.unwrap_or(f64::NAN) - 1.0).abs() < 1e-9, "clipped at {height}");
        }
    }

    #[test]
    fn means_of_maximum_in_closed_form() {
        // A clipped triangle of width 2 keeps a plateau of 2 (1 - height) round its peak. The same two
        // sets at equal heights leave two plateaus; scaled, two peaks with nothing between.
        for (inference, activations, expected) in [
            (Inference::MinMax, [0.5, 0.2, 0.1], Some(1.0)),
            (Inference::MinMax, [0.5, 0.5, 0.1], Some(0.5)),
            (Inference::MinMax, [0.5, 0.1, 0.5], Some(0.0)),
            (Inference::MinMax, [0.0; 3], None),
            (Inference::ProductSum, [0.5, 0.2, 0.1], Some(1.0)),
            (Inference::ProductSum, [0.5, 0.5, 0.0], Some(0.5)),
            (Inference::ProductSum, [0.5, 0.0, 0.5], Some(0.0)),
            (Inference::ProductSum, [0.0; 3], None),
        ] {
            let found = mean_of_maximum(inference, &SETS, &activations);
            let same = match (found, expected) {
                (Some(found), Some(expected)) => f64::abs(found - expected) < 1e-12,
                (found, expected) => found == expected,
            };
            assert!(same, "{inference:?} {activations:?}: {found:?}");
        }
        let level = Trapezoid { left: 0.0, from: 1.0, to: 4.0, right: 6.0 };
        for inference in [Inference::MinMax, Inference::ProductSum] {
            let whole = mean_of_maximum(inference, &[level], &[1.0]);
            assert_eq!(whole, Some(2.5), "{inference:?}: the middle of the plateau");
        }
        // Cut at one half, the plateau is from 0.5 to 5.
        assert_eq!(mean_of_maximum(Inference::MinMax, &[level], &[0.5]), Some(2.75));
    }

    #[test]
    fn single_values_have_a_centroid_and_a_mean_of_the_greatest() {
        let values = [-10.0, 2.0, 6.0];
        assert_eq!(centre_of_values(&values, &[0.25, 0.25, 0.5]), Some(1.0));
        assert_eq!(mean_of_greatest(&values, &[0.1, 0.5, 0.5]), Some(4.0));
        assert_eq!(mean_of_greatest(&values, &[0.7, 0.5, 0.5]), Some(-10.0));
        assert_eq!(
            (centre_of_values(&values, &[0.0; 3]), mean_of_greatest(&values, &[0.0; 3])),
            (None, None)
        );
    }
}
