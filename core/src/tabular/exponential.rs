//! The exponential of the softmax rule.
//!
//! Action selection computes nothing else so often. This one has no branch and is made of additions and
//! multiplications alone, so that it gives the same bits on every machine, as `libm`'s does; and it keeps
//! the power of two apart, so that neither a great nor a small preference leaves the range of numbers.

/// 1.5 · 2⁵²: added and taken off, it rounds to a whole number, which then stands in the low bits.
const ROUND: f64 = 6_755_399_441_055_744.0;
/// ln 2 in two parts, the first with 33 bits, so that whole multiples of it are exact.
const LN_2: [f64; 2] = [0.693_147_180_369_123_8, 1.908_214_929_270_587_7e-10];
/// Greatest argument in magnitude.
const MOST: f64 = 1e12;
/// Least power of two that still counts beside the greatest.
const LEAST_POWER: i64 = -1000;

/// `eˣ = mantissa · 2^power`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exponential {
    /// From about 0.7 to 1.5; 0 for what has no chance at all.
    pub mantissa: f64,
    /// The power of two.
    pub power: i64,
}

impl Exponential {
    /// Nothing: the exponential of minus infinity.
    pub const NOTHING: Self = Self { mantissa: 0.0, power: i64::MIN / 4 };

    /// `eˣ`; relative error below 1e-13 for |x| up to 700, and beyond that x · 1e-15.
    #[inline(always)]
    #[must_use]
    pub fn of(x: f64) -> Self {
        let x = if x > -MOST { x } else { -MOST };
        Self::within(if x < MOST { x } else { MOST })
    }

    /// The same for |x| up to 1e12; of any other x the power alone has a meaning: it is beyond 1e12 in
    /// magnitude too.
    #[inline(always)]
    pub(super) fn within(x: f64) -> Self {
        let shifted = x * core::f64::consts::LOG2_E + ROUND;
        let whole = shifted - ROUND;
        // x = whole · ln 2 + r, |r| <= ln 2 / 2
        let r = (x - whole * LN_2[0]) - whole * LN_2[1];
        #[expect(
            clippy::cast_possible_wrap,
            reason = "the low bits hold a whole number and its sign"
        )]
        let power = (shifted.to_bits() as i64).wrapping_sub(ROUND.to_bits() as i64);
        Self { mantissa: near_zero(r), power }
    }

    /// As a number, in units of `2^greatest`.
    #[inline(always)]
    #[must_use]
    pub fn beside(self, greatest: i64) -> f64 {
        let power = self.power - greatest;
        self.mantissa * power_of_two(if power > LEAST_POWER { power } else { LEAST_POWER })
    }
}

/// 2ⁿ for n from -1022 to 1023.
#[inline(always)]
#[expect(clippy::cast_sign_loss, reason = "n + 1023 is from 1 to 2046")]
pub(super) fn power_of_two(n: i64) -> f64 {
    f64::from_bits(((n + 1023) as u64) << 52)
}

/// The series `Σ rᵏ/k!` to k = 11.
#[inline(always)]
fn near_zero(r: f64) -> f64 {
    let r2 = r * r;
    let r4 = r2 * r2;
    let low = (1.0 + r) + r2 * (1.0 / 2.0 + r * (1.0 / 6.0));
    let middle = (1.0 / 24.0 + r * (1.0 / 120.0)) + r2 * (1.0 / 720.0 + r * (1.0 / 5_040.0));
    let high = (1.0 / 40_320.0 + r * (1.0 / 362_880.0))
        + r2 * (1.0 / 3_628_800.0 + r * (1.0 / 39_916_800.0));
    low + r4 * (middle + r4 * high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_agrees_with_the_library() {
        let mut x = -690.0;
        while x < 690.0 {
            let found = Exponential::of(x);
            let power = libm::exp2(found.power as f64);
            assert!((found.mantissa * power / libm::exp(x) - 1.0).abs() < 1e-13, "at {x}");
            x += 0.137;
        }
        assert_eq!(Exponential::of(0.0), Exponential { mantissa: 1.0, power: 0 });
    }

    #[test]
    fn differences_survive_where_the_exponential_itself_would_not() {
        for at in [-1e6, -3000.0, 0.0, 3000.0, 1e6] {
            let (less, more) = (Exponential::of(at), Exponential::of(at + 1.5));
            let greatest = less.power.max(more.power);
            let ratio = more.beside(greatest) / less.beside(greatest);
            assert!((ratio / libm::exp(1.5) - 1.0).abs() < 1e-8, "{ratio} at {at}");
        }
        for (x, expected) in [(f64::NEG_INFINITY, 0.0), (-2000.0, 0.0), (0.0, 1.0)] {
            assert!((Exponential::of(x).beside(0) - expected).abs() < 1e-300, "{x}");
        }
        for x in [1e13, 1e20, f64::MAX, f64::INFINITY, f64::NAN, -1e13, f64::NEG_INFINITY] {
            assert!(Exponential::within(x).power.unsigned_abs() > 1_000_000_000_000, "{x}");
        }
        assert_eq!(Exponential::NOTHING.beside(-1_000_000), 0.0);
    }
}
