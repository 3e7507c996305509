//! Operations on degrees of membership, Eq. (2.13)-(2.18).

crate::choice! {
    /// How degrees of membership are joined.
    pub enum Norms {
        Zadeh = "zadeh": "least, greatest and complement, Eq. (2.13)-(2.15)",
        Algebraic = "algebraic": "product, sum up to 1 and complement, Eq. (2.16)-(2.18)",
    }
}

impl Norms {
    /// Degree of an intersection.
    #[must_use]
    #[inline]
    pub fn and(self, a: f64, b: f64) -> f64 {
        match self {
            // Eq. (2.13): μ_{A∩B} = min(μ_A, μ_B)
            Self::Zadeh => a.min(b),
            // Eq. (2.16): μ_{A∩B} = μ_A × μ_B
            Self::Algebraic => a * b,
        }
    }

    /// Degree of a union.
    #[must_use]
    #[inline]
    pub fn or(self, a: f64, b: f64) -> f64 {
        match self {
            // Eq. (2.14): μ_{A∪B} = max(μ_A, μ_B)
            Self::Zadeh => a.max(b),
            // Eq. (2.17): μ_{A∪B} = min(1, μ_A + μ_B)
            Self::Algebraic => (a + b).min(1.0),
        }
    }

    /// Degree of a complement, the same for both: Eq. (2.15) and (2.18), μ_{A'} = 1 − μ_A.
    #[must_use]
    #[inline]
    pub fn complement(degree: f64) -> f64 {
        1.0 - degree
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn both_agree_with_classical_sets_and_differ_in_between() {
        for (a, b) in [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (1.0, 1.0)] {
            for norms in [Norms::Zadeh, Norms::Algebraic] {
                assert_eq!(norms.and(a, b), f64::from(a == 1.0 && b == 1.0), "{norms:?} {a} {b}");
                assert_eq!(norms.or(a, b), f64::from(a == 1.0 || b == 1.0), "{norms:?} {a} {b}");
            }
        }
        assert_eq!((Norms::Zadeh.and(0.5, 0.25), Norms::Algebraic.and(0.5, 0.25)), (0.25, 0.125));
        assert_eq!((Norms::Zadeh.or(0.5, 0.25), Norms::Algebraic.or(0.5, 0.25)), (0.5, 0.75));
        assert_eq!(Norms::Algebraic.or(0.75, 0.5), 1.0);
    }

    proptest! {
        #[test]
        fn norms_commute_and_keep_within_bounds(a in 0.0..=1.0f64, b in 0.0..=1.0f64) {
            for norms in [Norms::Zadeh, Norms::Algebraic] {
                let (both, either) = (norms.and(a, b), norms.or(a, b));
                prop_assert_eq!((both, either), (norms.and(b, a), norms.or(b, a)));
                prop_assert!((0.0..=a.min(b)).contains(&both) && (a.max(b)..=1.0).contains(&either));
            }
            // De Morgan holds for least and greatest; it does not for product and bounded sum.
            let not = Norms::complement;
            let (left, right) = (not(Norms::Zadeh.and(a, b)), Norms::Zadeh.or(not(a), not(b)));
            prop_assert!((left - right).abs() < 1e-15);
        }
    }
}
