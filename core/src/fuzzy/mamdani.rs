//! Mamdani inference over triangular output sets, and its centre of area, Eq. (2.23)-(2.24).

use super::Triangle;

crate::choice! {
    /// How activations become one output area.
    pub enum Inference {
        ProductSum = "product-sum": "each set scaled by its activation, areas added; the centre of area is exact",
        MinMax = "min-max": "each set clipped at its activation, the greatest kept; the centre of area is a sum over 720 points",
    }
}

/// Points at which a clipped area is sampled.
const SAMPLES: u32 = 720;

/// Centre of the area under the output sets, each activated to a degree of at least 0; none when
/// nothing is active.
#[must_use]
pub fn centre_of_area<const N: usize>(
    inference: Inference,
    sets: &[Triangle; N],
    activations: &[f64; N],
) -> Option<f64> {
    match inference {
        Inference::ProductSum => scaled(sets, activations),
        Inference::MinMax => clipped(sets, activations),
    }
}

/// Scaled sets keep their centroids, so their weighted mean is the centre of the added areas.
fn scaled<const N: usize>(sets: &[Triangle; N], activations: &[f64; N]) -> Option<f64> {
    let mut moment = 0.0;
    let mut area = 0.0;
    for (set, activation) in sets.iter().zip(activations) {
        moment += activation * set.area() * set.centroid();
        area += activation * set.area();
    }
    (area > 0.0).then(|| moment / area)
}

fn clipped<const N: usize>(sets: &[Triangle; N], activations: &[f64; N]) -> Option<f64> {
    let left = sets.iter().map(|set| set.left).fold(f64::INFINITY, f64::min);
    let right = sets.iter().map(|set| set.right).fold(f64::NEG_INFINITY, f64::max);
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
    (area > 0.0).then(|| moment / area)
}

#[cfg(test)]
mod tests {
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
}
