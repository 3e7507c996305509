//! Quantiles of the t, χ² and beta distributions.
//!
//! Each is found by bisection of the distribution function, which is a regularised incomplete beta or
//! gamma function (Abramowitz and Stegun, sections 6.5 and 26.5). Slow and sure: about 60 evaluations a
//! quantile, and the same bits on every machine, since all transcendental functions come from `libm`.

/// Halvings that exhaust the bits of a result.
const HALVINGS: u32 = 200;
/// Most terms of a series or a continued fraction; they converge in about the root of their arguments.
const MOST_TERMS: u32 = 10_000;
/// Stands for 0 where Lentz's method would divide by it.
const TINY: f64 = 1e-300;

/// Quantile of Student's t: the value that a t with `freedom` > 0 degrees of freedom stays below with
/// `probability`. NaN when `probability` is not in (0, 1) or `freedom` is not above 0.
#[must_use]
pub fn t_quantile(probability: f64, freedom: f64) -> f64 {
    if !(probability > 0.0 && probability < 1.0 && freedom > 0.0) {
        return f64::NAN;
    }
    // With x = ν/(ν + t²), P(T > t) = I_x(ν/2, 1/2)/2 for t ≥ 0; the lower half mirrors the upper.
    let tail = probability.min(1.0 - probability);
    let x = beta_quantile(2.0 * tail, freedom / 2.0, 0.5);
    let t = libm::sqrt(freedom * (1.0 - x) / x);
    if probability < 0.5 { -t } else { t }
}

/// Quantile of χ²: the value that a χ² with `freedom` > 0 degrees of freedom stays below with
/// `probability`. NaN when `probability` is not in (0, 1) or `freedom` is not above 0.
#[must_use]
pub fn chi_square_quantile(probability: f64, freedom: f64) -> f64 {
    if !(probability > 0.0 && probability < 1.0 && freedom > 0.0) {
        return f64::NAN;
    }
    // P(χ² ≤ x) = P(ν/2, x/2), Abramowitz and Stegun (26.4.19).
    let below = |x: f64| gamma_p(freedom / 2.0, x / 2.0) < probability;
    let mut high = freedom.max(1.0);
    while below(high) {
        high *= 2.0;
    }
    bisect(0.0, high, below)
}

/// Quantile of the beta distribution with shapes `a` > 0 and `b` > 0: the share of [0, 1] that it stays
/// below with `probability`. NaN when `probability` is not in [0, 1] or a shape is not above 0.
#[must_use]
pub fn beta_quantile(probability: f64, a: f64, b: f64) -> f64 {
    if !((0.0..=1.0).contains(&probability) && a > 0.0 && b > 0.0) {
        return f64::NAN;
    }
    bisect(0.0, 1.0, |x| beta_i(x, a, b) < probability)
}

/// Where `below` turns from true to false.
fn bisect(mut low: f64, mut high: f64, below: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(low, high);
        if middle <= low || middle >= high {
            break;
        }
        if below(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    f64::midpoint(low, high)
}

/// Regularised lower incomplete gamma function P(a, x).
fn gamma_p(a: f64, x: f64) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    // e^−x x^a / Γ(a), the factor in front of both expansions.
    let front = libm::exp(a * libm::log(x) - x - libm::lgamma(a));
    if x < a + 1.0 { front * gamma_series(a, x) } else { 1.0 - front * gamma_fraction(a, x) }
}

/// Σ xⁿ / (a (a+1) … (a+n)), Abramowitz and Stegun (6.5.29).
fn gamma_series(a: f64, x: f64) -> f64 {
    let mut term = 1.0 / a;
    let mut sum = term;
    for n in 1..MOST_TERMS {
        term *= x / (a + f64::from(n));
        sum += term;
        if term < sum * f64::EPSILON {
            break;
        }
    }
    sum
}

/// 1/(x+1−a− 1(1−a)/(x+3−a− 2(2−a)/(x+5−a− …))), the even part of (6.5.31), by Lentz's method.
fn gamma_fraction(a: f64, x: f64) -> f64 {
    let mut lentz = Lentz::new(x + 1.0 - a);
    for n in 1..MOST_TERMS {
        let n = f64::from(n);
        if lentz.converges(-n * (n - a), x + 2.0 * n + 1.0 - a) {
            break;
        }
    }
    1.0 / lentz.value
}

/// Regularised incomplete beta function I_x(a, b).
fn beta_i(x: f64, a: f64, b: f64) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    if x >= 1.0 {
        return 1.0;
    }
    let log_beta = libm::lgamma(a) + libm::lgamma(b) - libm::lgamma(a + b);
    let front = libm::exp(a * libm::log(x) + b * libm::log1p(-x) - log_beta);
    // The fraction converges fast below the mean; above it, I_x(a, b) = 1 − I_{1−x}(b, a).
    if x < (a + 1.0) / (a + b + 2.0) {
        front / (a * beta_fraction(x, a, b))
    } else {
        1.0 - front / (b * beta_fraction(1.0 - x, b, a))
    }
}

/// 1 + d₁/(1 + d₂/(1 + …)) of Abramowitz and Stegun (26.5.8), by Lentz's method.
fn beta_fraction(x: f64, a: f64, b: f64) -> f64 {
    let mut lentz = Lentz::new(1.0);
    for m in 0..MOST_TERMS {
        let m = f64::from(m);
        let odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        lentz.converges(odd, 1.0);
        let next = m + 1.0;
        let even = next * (b - next) * x / ((a + 2.0 * next - 1.0) * (a + 2.0 * next));
        if lentz.converges(even, 1.0) {
            break;
        }
    }
    lentz.value
}

/// A continued fraction b₀ + a₁/(b₁ + a₂/(b₂ + …)), evaluated forwards.
struct Lentz {
    value: f64,
    c: f64,
    d: f64,
}

impl Lentz {
    fn new(b0: f64) -> Self {
        Self { value: nonzero(b0), c: nonzero(b0), d: 0.0 }
    }

    /// Takes one more pair; true once a pair no longer changes the value.
    fn converges(&mut self, a: f64, b: f64) -> bool {
        self.d = 1.0 / nonzero(b + a * self.d);
        self.c = nonzero(b + a / self.c);
        let change = self.c * self.d;
        self.value *= change;
        (change - 1.0).abs() <= f64::EPSILON
    }
}

fn nonzero(value: f64) -> f64 {
    if value.abs() < TINY { TINY } else { value }
}
