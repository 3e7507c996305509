use super::super::Kept;
use super::*;
use crate::wire::Verdict;

fn findings() -> Findings {
    FIGURE_3_3.run(1, &Kept::default(), &|| ()).expect("nothing can fail")
}

#[test]
fn rewards_and_crossings_are_the_closed_forms() {
    let rows = findings().rows;
    let ours = |name: &str| {
        rows.iter().find(|row| row.name == name).unwrap_or_else(|| panic!("{name} is missing")).ours
    };
    let power = |exponent: i32| 0.9_f64.powi(exponent);
    for (name, expected) in [
        ("a0: total reward of h = 5 steps", 6.0),
        ("a1: total reward of h = 5 steps", 0.0),
        ("a0: discounted reward at γ = 0.9", 2.0 * power(2) / 0.1),
        ("a1: discounted reward at γ = 0.9", 10.0 * power(5) / 0.1),
        ("a2: discounted reward at γ = 0.9", 11.0 * power(6) / 0.1),
        ("a2: average reward", 11.0),
        ("a1: horizon from which it is the best", 5.75),
        ("a2: horizon from which it is the best", 16.0),
        ("a1: discount from which it is the best", 0.2_f64.cbrt()),
        ("a2: discount from which it is the best", 10.0 / 11.0),
    ] {
        assert!((ours(name) - expected).abs() < 1e-9, "{name}: {} for {expected}", ours(name));
    }
    let judged = rows.iter().filter(|row| row.published.is_some());
    assert!(judged.clone().all(|row| row.verdict == Verdict::Agrees), "{rows:?}");
    assert_eq!(judged.count(), 11);
}

#[test]
fn the_curves_are_the_closed_forms() {
    let curves = findings().curves;
    assert_eq!(curves.len(), 6, "three policies in two plots");
    for (policy, (zeros, then)) in [(2, 2.0), (5, 10.0), (6, 11.0)].into_iter().enumerate() {
        let [finite, discounted] = &curves[2 * policy..2 * policy + 2] else { panic!("two plots") };
        assert_eq!(finite.points.len(), 31);
        for point in &finite.points {
            let expected = then * (point.x - f64::from(zeros)).max(0.0);
            assert!((point.mean.expect("a value") - expected).abs() < 1e-9, "{point:?}");
        }
        for point in &discounted.points {
            let expected = then * point.x.powi(zeros) / (1.0 - point.x);
            assert!((point.mean.expect("a value") - expected).abs() < 1e-6, "{point:?}");
        }
    }
}
