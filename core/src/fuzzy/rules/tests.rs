use proptest::prelude::*;

use super::*;
use crate::simd::levels;

/// The base of a published comparison of fuzzy engines: 972 rules, and consequents by formula.
fn shared() -> RuleBase {
    let three = "  low trapezoid -1 -0.5 0.2 0.4\n  mid trapezoid 0.2 0.4 0.6 0.8\n  high trapezoid 0.6 0.8 1.5 2\n";
    let four = "  a trapezoid -1 -0.5 0.1 0.25\n  b trapezoid 0.1 0.25 0.4 0.55\n  c trapezoid 0.4 0.55 0.7 0.9\n  d trapezoid 0.7 0.9 1.5 2\n";
    let mut text = "rules shared\nnorms algebraic\n".to_owned();
    for input in 0..6 {
        text += &format!("input x{input} - 0 1\n{}", if input < 5 { three } else { four });
    }
    text += "output y0 - -1 1\noutput y1 - -1 1\ntable x0 x1 x2 x3 x4 x5 -> y0 y1\n";
    let names = ["low", "mid", "high"];
    for rule in 0..972_u64 {
        let digit = |place: u32| names[(rule / 4 / 3_u64.pow(4 - place) % 3) as usize];
        let last = ["a", "b", "c", "d"][(rule % 4) as usize];
        let value = |output: u64| ((rule * 7919 + output * 104_729) % 2001) as f64 / 1000.0 - 1.0;
        let sets: Vec<&str> = (0..5).map(digit).chain([last]).collect();
        text += &format!("{} -> {} {}\n", sets.join(" "), value(0), value(1));
    }
    RuleBase::parse(&text).expect("a sound base")
}

/// Algorithm 2 as printed: every rule fires, however weakly.
fn all_rules(base: &RuleBase, inputs: &[f64]) -> [f64; MOST_OUTPUTS] {
    let (mut weight, mut moments) = (0.0, [0.0; MOST_OUTPUTS]);
    for rule in &base.rules {
        let each = base.inputs.iter().zip(&rule.when).zip(inputs);
        let strength = each.fold(1.0, |strength, ((input, &set), value)| {
            let degree =
                input.sets[set].set.membership(value.clamp(input.range[0], input.range[1]));
            base.norms.and(strength, degree)
        });
        weight += strength;
        for (moment, consequent) in moments.iter_mut().zip(&rule.then) {
            if let Consequent::Value(value) = consequent {
                *moment += strength * value;
            }
        }
    }
    moments.map(|moment| moment / weight)
}

const SMALL: &str = "rules small
title A base of four rules
norms zadeh
defuzzifier mean-of-maximum

input ahead m 0 2
  near trapezoid -inf -inf 0.5 1
  far trapezoid 0.5 1 inf inf

input left m 0 2
  near triangle -1 0 2
  far triangle 0 2 3

output turn deg/s -10 10

table ahead left -> turn
near near -> -10 | the only way left is right
near far -> 10
far near -> -3
far far -> 0
";

#[test]
fn a_value_known_from_other_engines() {
    let [y0, y1] = shared().evaluate(&[0.25, 0.5, 0.7, 0.33, 0.9, 0.45]);
    assert!((y0 - 0.30037).abs() < 5e-6 && (y1 - 0.03106).abs() < 5e-6, "{y0} {y1}");
}

#[test]
fn what_is_printed_reads_back() {
    let base = RuleBase::parse(SMALL).expect("sound");
    assert_eq!(base.to_text(), SMALL);
    assert_eq!(RuleBase::parse(&shared().to_text()), Ok(shared()));
}

#[test]
fn zadeh_by_hand() {
    let base = RuleBase::parse(SMALL).expect("sound");
    // ahead 0.75: near and far to 0.5 each; left 0.5: near to 0.75, far to 0.25.
    let explained = base.explain(&[0.75, 0.5]);
    assert_eq!(explained.memberships, [0.5, 0.5, 0.75, 0.25]);
    let strengths: Vec<(usize, f64)> =
        explained.firings.iter().map(|firing| (firing.rule, firing.strength)).collect();
    assert_eq!(strengths, [(0, 0.5), (2, 0.5), (1, 0.25), (3, 0.25)]);
    let expected = (0.5 * -10.0 + 0.25 * 10.0 + 0.5 * -3.0) / 1.5;
    assert!((explained.outputs[0] - expected).abs() < 1e-15);
}

#[test]
fn rules_may_conclude_sets() {
    let sets = "output turn deg/s -10 10
  right triangle -10 -5 0
  ahead singleton 0
  left triangle 0 5 10
";
    let with = |defuzzifier: &str, norms: &str| {
        let text = SMALL
            .replace("output turn deg/s -10 10\n", sets)
            .replace("-> -10", "-> right")
            .replace("-> 10", "-> left")
            .replace("-> -3", "-> right")
            .replace("-> 0", "-> ahead")
            .replace("mean-of-maximum", defuzzifier)
            .replace("zadeh", norms);
        RuleBase::parse(&text).expect("sound").evaluate(&[0.75, 0.5])[0]
    };
    // right to 0.5, left to 0.25: clipped at 0.5 the plateau of `right` is from -7.5 to -2.5.
    assert_eq!(with("mean-of-maximum", "zadeh"), -5.0);
    // Product: right to 0.375 + 0.375, left to 0.125; equal areas, a set of no area counts nothing.
    let expected = (-5.0 * 0.75 + 5.0 * 0.125) / 0.875;
    assert!((with("centre-of-area", "algebraic") - expected).abs() < 1e-12);
}

#[test]
fn errors_name_the_line() {
    for (from, to, line, problem) in [
        ("near far -> 10", "near wide -> 10", 18, "`left` has no set `wide`; there are near, far"),
        (
            "near far -> 10",
            "near near -> 10",
            18,
            "there is a rule for this combination in line 17 already",
        ),
        ("far near -> -3\n", "", 16, "there is no rule for `far near`"),
        ("near far -> 10", "near far -> 11", 18, "`turn` must be from -10 to 10, not 11"),
        ("near far -> 10", "near far -> ten", 18, "`ten` must be a number"),
        ("near far -> 10", "near far -> NaN", 18, "`NaN` must be a number"),
        (
            "near far -> 10",
            "near -> 10",
            18,
            "a rule must have one set for each of the 2 inputs, not 1",
        ),
        ("near far -> 10", "near far 10", 18, "a rule must read `set … -> consequent …`"),
        ("0.5 1 inf inf", "0.6 1.1 inf inf", 18, ""),
        (
            "0.5 1 inf inf",
            "1.2 1.4 inf inf",
            6,
            "`ahead` belongs to no set at 1; every value must belong to one",
        ),
        (
            "near triangle -1 0 2",
            "near triangle 0.5 1 2",
            10,
            "`left` belongs to no set at 0; every value must belong to one",
        ),
        (
            "near triangle -1 0 2",
            "near triangle 0 0 2",
            11,
            "`near` must have sides of finite width; a triangle's must be above 0, a trapezoid's shoulder reads `-inf -inf` or `inf inf`",
        ),
        (
            "near triangle -1 0 2",
            "near triangle 1 0 2",
            11,
            "the corners of `near` must not descend",
        ),
        (
            "near triangle -1 0 2",
            "near circle -1 0 2",
            11,
            "`near` must be a set: `trapezoid` with four numbers, `triangle` with three or `singleton` with one",
        ),
        (
            "norms zadeh",
            "norms einstein",
            3,
            "`norms` must be one of `zadeh`, `algebraic`, not `einstein`",
        ),
        (
            "table ahead left",
            "table left ahead",
            16,
            "the table's head must be `table ahead left -> turn`",
        ),
        (
            "input left m 0 2",
            "input left m 2 0",
            10,
            "the range of `left` must be two finite numbers, the least first",
        ),
        ("input left m 0 2", "input ahead m 0 2", 10, "there is an input `ahead` already"),
        (
            "table ahead left -> turn",
            "# no table",
            17,
            "`near` must be a set: `trapezoid` with four numbers, `triangle` with three or `singleton` with one",
        ),
    ] {
        let text = SMALL.replacen(from, to, 1);
        assert_ne!(text, SMALL, "{from}");
        match RuleBase::parse(&text) {
            Ok(_) => assert_eq!(problem, "", "{to}"),
            Err(error) => {
                assert_eq!((error.line, error.problem.as_str()), (Some(line), problem), "{to}");
            }
        }
    }
    let error = RuleBase::parse("rules empty\n").expect_err("no table");
    assert_eq!(error.to_string(), "rules, line 1: there is no `table` of rules");
}

#[test]
fn what_is_not_a_number_does_not_pass_for_one() {
    for base in [shared(), RuleBase::parse(SMALL).expect("sound")] {
        let inputs = [f64::NAN, 0.5, 0.5, 0.5, 0.5, 0.5];
        assert!(base.evaluate(&inputs)[0].is_nan(), "{}", base.name());
    }
}

#[test]
fn the_fast_path_is_taken_where_sets_lie_side_by_side() {
    let side_by_side =
        SMALL.replace("zadeh", "algebraic").replace("triangle 0 2 3", "triangle 0 2 9");
    for (text, fast) in [
        (side_by_side.clone(), true),
        (side_by_side.replace("0.5 1 inf inf", "0.4 1 inf inf"), false),
        (side_by_side.replace("algebraic", "zadeh"), false),
    ] {
        let base = RuleBase::parse(&text).expect("sound");
        assert_eq!(base.grid.is_some(), fast, "{text}");
        let (found, expected) = (base.evaluate(&[0.7, 0.3]), all_rules(&base, &[0.7, 0.3]));
        assert!((found[0] - expected[0]).abs() < 1e-12, "{text}");
    }
    assert!(shared().grid.is_some());
}

proptest! {
    #[test]
    fn visiting_what_fires_equals_the_sum_over_all_rules(
        inputs in proptest::array::uniform6(-0.2..1.2f64),
    ) {
        let base = shared();
        let expected = all_rules(&base, &inputs);
        let mut each = [[0.0; MOST_OUTPUTS]];
        base.evaluate_each(&[inputs], &mut each);
        let explained = base.explain(&inputs);
        for found in [base.evaluate(&inputs), each[0], explained.outputs] {
            for (found, expected) in found.into_iter().zip(expected) {
                prop_assert!((found - expected).abs() < 1e-12, "{found} {expected}");
            }
        }
        prop_assert!(explained.firings.len() <= 64);
        let sum: f64 = explained.firings.iter().map(|firing| firing.strength).sum();
        prop_assert!((sum - 1.0).abs() < 1e-12, "the sets are a partition of unity");
    }

    #[test]
    fn every_level_of_instructions_gives_the_same_bits(
        inputs in proptest::array::uniform6(-0.2..1.2f64),
    ) {
        let base = shared();
        let grid = base.grid.as_ref().expect("side by side");
        for level in levels() {
            let mut each = [[0.0; MOST_OUTPUTS]];
            grid.evaluate_each_at(level, &[inputs], &mut each);
            prop_assert_eq!(each[0], base.evaluate(&inputs));
        }
    }

    #[test]
    fn any_text_is_read_or_refused(text in "(rules |input |x - 0 1|output |table |trapezoid |-> |-inf |0.5 |\\n|\\PC){0,40}") {
        if let Err(error) = RuleBase::parse(&text) {
            prop_assert!(error.line.is_some());
        }
    }
}
