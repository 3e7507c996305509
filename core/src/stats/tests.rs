//! Estimates against closed forms and printed tables.

use std::f64::consts::{FRAC_PI_2, PI};

use proptest::prelude::*;

use super::*;

fn close(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((found - expected).abs() <= tolerance, "{what}: {found}, not {expected}");
}

#[test]
fn moments_of_small_samples() {
    for (sample, expected_mean, expected_variance, expected_median) in [
        (&[][..], None, None, None),
        (&[3.0], Some(3.0), None, Some(3.0)),
        (&[3.0, 1.0], Some(2.0), Some(2.0), Some(2.0)),
        (&[2.0, 9.0, 4.0], Some(5.0), Some(13.0), Some(4.0)),
        (&[4.0, 4.0, 4.0, 4.0], Some(4.0), Some(0.0), Some(4.0)),
        (&[-10.0, 1.0, 2.0, 100.0], Some(23.25), Some(2_647.583_333_333_333_5), Some(1.5)),
    ] {
        assert_eq!(mean(sample), expected_mean, "{sample:?}");
        assert_eq!(variance(sample), expected_variance, "{sample:?}");
        assert_eq!(median(sample), expected_median, "{sample:?}");
    }
}

#[test]
fn t_quantiles_are_those_of_printed_tables() {
    for (probability, freedom, expected) in [
        (0.975, 1.0, 12.706_204_736_432_095),
        (0.975, 2.0, 4.302_652_729_696_142),
        (0.975, 5.0, 2.570_581_835_636_314),
        (0.975, 9.0, 2.262_157_162_740_992),
        (0.975, 10.0, 2.228_138_851_964_939),
        (0.975, 30.0, 2.042_272_456_301_238),
        (0.975, 100.0, 1.983_971_518_523_553),
        (0.995, 10.0, 3.169_272_672_616_841),
        (0.95, 20.0, 1.724_718_242_920_787),
        (0.025, 9.0, -2.262_157_162_740_992),
        (0.5, 7.0, 0.0),
    ] {
        close(t_quantile(probability, freedom), expected, 1e-6, "t");
    }
}

#[test]
fn t_quantiles_with_one_and_two_degrees_have_closed_forms() {
    for probability in [0.001, 0.1, 0.3, 0.6, 0.9, 0.999] {
        let cauchy = libm::tan(PI * probability - FRAC_PI_2);
        close(t_quantile(probability, 1.0), cauchy, 1e-6, "ν = 1");
        let two = (2.0 * probability - 1.0) / libm::sqrt(2.0 * probability * (1.0 - probability));
        close(t_quantile(probability, 2.0), two, 1e-6, "ν = 2");
    }
}

#[test]
fn chi_square_quantiles_are_those_of_printed_tables() {
    for (probability, freedom, expected) in [
        (0.025, 1.0, 0.000_982_069_117_175),
        (0.975, 1.0, 5.023_886_187_314_888),
        (0.95, 1.0, 3.841_458_820_694_124),
        (0.025, 9.0, 2.700_389_499_980_358),
        (0.975, 9.0, 19.022_767_798_641_635),
        (0.025, 30.0, 16.790_772_265_566_626),
        (0.975, 30.0, 46.979_242_243_671_16),
        (0.025, 100.0, 74.221_927_474_923_73),
        (0.975, 100.0, 129.561_197_185_836_75),
    ] {
        close(chi_square_quantile(probability, freedom), expected, 1e-6, "χ²");
    }
}

#[test]
fn chi_square_quantiles_with_two_degrees_have_a_closed_form() {
    for probability in [0.001, 0.025, 0.5, 0.975, 0.999] {
        let expected = -2.0 * libm::log1p(-probability);
        close(chi_square_quantile(probability, 2.0), expected, 1e-9, "ν = 2");
    }
}

#[test]
fn arguments_out_of_range_give_no_number() {
    for (probability, freedom) in [(0.0, 3.0), (1.0, 3.0), (f64::NAN, 3.0), (0.5, 0.0), (0.5, -1.0)]
    {
        assert!(t_quantile(probability, freedom).is_nan(), "t {probability} {freedom}");
        assert!(chi_square_quantile(probability, freedom).is_nan(), "χ² {probability} {freedom}");
    }
    assert!(beta_quantile(0.5, 0.0, 1.0).is_nan());
}

#[test]
fn intervals_of_a_worked_sample() {
    // 1 to 10: x̄ = 5.5, s² = 55/6, ν = 9.
    let sample: Vec<f64> = (1..=10).map(f64::from).collect();
    let mean = Estimate::mean(&sample).expect("ten values");
    let half = 2.262_157_162_740_992 * libm::sqrt(55.0 / 60.0);
    close(mean.low, 5.5 - half, 1e-9, "low end of the mean");
    close(mean.high, 5.5 + half, 1e-9, "high end of the mean");
    let variance = Estimate::variance(&sample).expect("ten values");
    close(variance.low, 82.5 / 19.022_767_798_641_635, 1e-9, "low end of the variance");
    close(variance.high, 82.5 / 2.700_389_499_980_358, 1e-9, "high end of the variance");
    assert_eq!((mean.n, variance.n), (10, 10));
    assert_eq!((Estimate::mean(&[1.0]), Estimate::variance(&[1.0])), (None, None));
}

#[test]
fn proportions_have_exact_intervals() {
    // With no failure the lower end solves low^n = 0.025; 8 of 10 is a textbook example.
    let all = Estimate::proportion(200, 200).expect("an estimate");
    close(all.low, libm::pow(0.025, 1.0 / 200.0), 1e-9, "200 of 200");
    assert_eq!((all.value, all.high), (1.0, 1.0));
    let none = Estimate::proportion(0, 200).expect("an estimate");
    close(none.high, 1.0 - libm::pow(0.025, 1.0 / 200.0), 1e-9, "0 of 200");
    let most = Estimate::proportion(8, 10).expect("an estimate").scaled(100.0);
    close(most.low, 44.390_5, 1e-4, "8 of 10");
    close(most.high, 97.478_9, 1e-4, "8 of 10");
    assert_eq!((Estimate::proportion(0, 0), Estimate::proportion(2, 1)), (None, None));
}

#[test]
fn verdicts() {
    let ours = |low, high, n| Estimate { value: f64::midpoint(low, high), low, high, n };
    for (published, estimate, expected) in [
        (Some(27.7), ours(27.5, 27.9, 200), Verdict::Agrees),
        (Some(27.5), ours(27.5, 27.9, 200), Verdict::Agrees),
        (Some(-6.24), ours(-6.9, -6.0, 200), Verdict::Agrees),
        (Some(27.4), ours(27.5, 27.9, 200), Verdict::Differs),
        (Some(28.0), ours(27.5, 27.9, 10), Verdict::Differs),
        (Some(1.9), ours(150.0, 250.0, 200), Verdict::Differs),
        (Some(27.7), ours(27.7, 27.7, 200), Verdict::Agrees),
        (None, ours(27.5, 27.9, 200), Verdict::CannotTell),
        (Some(f64::NAN), ours(27.5, 27.9, 200), Verdict::CannotTell),
        (Some(28.0), ours(27.5, 27.9, 9), Verdict::CannotTell),
        (Some(27.7), ours(20.0, 34.0, 200), Verdict::CannotTell),
        (Some(27.7), ours(f64::NEG_INFINITY, f64::INFINITY, 200), Verdict::CannotTell),
    ] {
        assert_eq!(Verdict::of(published, &estimate), expected, "{published:?} {estimate:?}");
    }
}

proptest! {
    #[test]
    fn an_interval_holds_its_estimate(sample in prop::collection::vec(-1e3..1e3_f64, 2..60)) {
        for estimate in [Estimate::mean(&sample), Estimate::variance(&sample)].into_iter().flatten() {
            prop_assert!(estimate.low <= estimate.value, "{estimate:?}");
            prop_assert!(estimate.value <= estimate.high, "{estimate:?}");
        }
    }
}

#[test]
fn the_interval_of_a_median_is_that_of_the_tables() {
    // Ranks from the table of Conover, Practical Nonparametric Statistics: n, lower rank from 1.
    for (n, rank) in [(5, 1), (6, 1), (8, 1), (9, 2), (10, 2), (15, 4), (20, 6), (25, 8)] {
        let sample: Vec<f64> = (1..=n).map(f64::from).collect();
        let found = Estimate::median(&sample).expect("a sample");
        assert_eq!(found.low, f64::from(rank), "n = {n}");
        assert_eq!(found.high, f64::from(n + 1 - rank), "n = {n}");
    }
    assert_eq!(Estimate::median(&[]), None);
    let alone = Estimate::median(&[3.0]).expect("one value");
    assert_eq!((alone.value, alone.low, alone.high, alone.n), (3.0, 3.0, 3.0, 1));
}

#[test]
fn the_interval_of_a_quantile_is_that_of_the_binomial_distribution() {
    // Sums of binomial terms in exact whole numbers: n, share, places of the ends from 0.
    for (n, share, low, high) in [(400, 0.05, 11, 29), (400, 0.95, 370, 388), (100, 0.25, 16, 34)] {
        let sample: Vec<f64> = (0..n).map(f64::from).collect();
        let found = Estimate::quantile(&sample, share).expect("a sample");
        assert_eq!((found.low, found.high), (f64::from(low), f64::from(high)), "{n} {share}");
        assert!((found.value - share * f64::from(n - 1)).abs() < 1e-9, "{found:?}");
    }
    assert_eq!(Estimate::quantile(&[], 0.05), None);
}

#[test]
fn a_single_value_lies_in_the_middle_of_the_sample() {
    let sample: Vec<f64> = (0..=40).rev().map(f64::from).collect();
    let found = Estimate::single(&sample).expect("a sample");
    assert_eq!((found.value, found.low, found.high, found.n), (20.0, 1.0, 39.0, 41));
    assert_eq!(Estimate::single(&[]), None);
}

#[test]
fn an_exact_value_agrees_to_the_digit_that_is_printed() {
    for (published, ours, digit, verdict) in [
        (Some(59.0), 59.049, 0.1, Verdict::Agrees),
        (Some(58.5), 58.4585, 0.1, Verdict::Agrees),
        (Some(58.5), 58.39, 0.1, Verdict::Differs),
        (Some(38.0), 38.0, 1.0, Verdict::Agrees),
        (Some(38.0), 39.0, 1.0, Verdict::Differs),
        (None, 38.0, 1.0, Verdict::CannotTell),
    ] {
        assert_eq!(Verdict::exact(published, ours, digit), verdict, "{published:?} {ours}");
    }
}

#[test]
fn a_bound_is_kept_only_by_a_whole_interval() {
    let ours = |low, high, n| Estimate { value: f64::midpoint(low, high), low, high, n };
    for (bound, low, high, n, verdict) in [
        (Bound::AtLeast(95.0), 96.0, 99.0, 200, Verdict::Agrees),
        (Bound::AtLeast(95.0), 95.0, 99.0, 200, Verdict::Agrees),
        (Bound::AtLeast(95.0), 94.0, 99.0, 200, Verdict::CannotTell),
        (Bound::AtLeast(95.0), 80.0, 94.0, 200, Verdict::Differs),
        (Bound::AtMost(15.0), 3.0, 15.0, 200, Verdict::Agrees),
        (Bound::AtMost(15.0), 14.0, 16.0, 200, Verdict::CannotTell),
        (Bound::AtMost(15.0), 16.0, 18.0, 200, Verdict::Differs),
        (Bound::AtMost(15.0), 3.0, 4.0, 9, Verdict::CannotTell),
        (Bound::AtMost(15.0), f64::NAN, f64::NAN, 200, Verdict::CannotTell),
    ] {
        assert_eq!(bound.judge(&ours(low, high, n)), verdict, "{bound:?} {low} {high} {n}");
    }
}
