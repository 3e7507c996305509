use proptest::prelude::*;

use super::*;

fn vocabulary() -> Vocabulary {
    let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>();
    Vocabulary {
        features: vec![
            ("goal".into(), words(&["near", "far", "west", "east"])),
            ("wall".into(), words(&["ahead"])),
        ],
        actions: words(&["left", "forward", "right"]),
    }
}

/// near 0.8, far 0.2, west 1, east 0; wall ahead 0.3.
fn degrees(text: &str) -> Vec<f64> {
    let advice = parse(text, &vocabulary()).expect(text);
    advice.degrees(|feature, term| [&[0.8, 0.2, 1.0, 0.0][..], &[0.3]][feature][term])
}

#[test]
fn rules_hold_as_far_as_their_conditions() {
    for (text, expected) in [
        ("if goal is near then forward", 0.8),
        ("if goal is not near then forward", 0.2),
        ("if not goal is near then forward", 0.2),
        ("if goal is near and wall is ahead then left", 0.3),
        ("if goal is far or wall is ahead then left", 0.3),
        ("if goal is far or wall is ahead and goal is east then left", 0.2),
        ("if (goal is far or wall is ahead) and goal is west then left", 0.3),
        ("if goal (near && west) && !wall (ahead) then left", 0.7),
        ("IF Goal (Near and West) THEN Move Left end;", 0.8),
    ] {
        let found = degrees(text)[0];
        assert!((found - expected).abs() < 1e-12, "{text}: {found}");
    }
}

#[test]
fn a_new_term_can_be_made_and_used() {
    let text = "if goal is near then let there\nif there and goal is west then not right # no\n";
    let advice = parse(text, &vocabulary()).expect("good");
    assert_eq!(advice.made, ["there"]);
    assert_eq!(advice.rules[0].conclusion, Conclusion::Make(0));
    assert_eq!(advice.rules[1].conclusion, Conclusion::Avoid(2));
    assert_eq!(advice.rules[1].text, "if there and goal is west then not right");
    assert!((degrees(text)[1] - 0.8).abs() < 1e-12);
    assert_eq!(parse("", &vocabulary()).expect("nothing is no error").rules, []);
}

#[test]
fn errors_point_at_the_character() {
    for (text, line, column, problem) in [
        ("goal is near then left", 1, 1, "expected `if`, not `goal`"),
        ("if goal near then left", 1, 9, "expected `is` or `(`, not `near`"),
        (
            "if goal is close then left",
            1,
            12,
            "`goal` has no term `close`; there are near, far, west, east",
        ),
        ("if enemy is near then left", 1, 4, "there is no feature `enemy`; there are goal, wall"),
        (
            "if goal is near then\n  hide",
            2,
            3,
            "there is no action `hide`; there are left, forward, right",
        ),
        ("if goal is near\nthen", 2, 5, "expected an action, not the end"),
        ("if (goal is near then left", 1, 18, "expected `)`, `and` or `or`, not `then`"),
        (
            "if goal is near then left\nif wall % 3",
            2,
            9,
            "`%` means nothing; use words, ( ), and, or, not, && || !",
        ),
        ("if goal is near and then left", 1, 21, "expected a condition, not `then`"),
        (
            "if goal is near then let goal",
            1,
            26,
            "`goal` means something already; take another name",
        ),
        (
            "if goal is ü then left",
            1,
            12,
            "`goal` has no term `ü`; there are near, far, west, east",
        ),
    ] {
        let error = parse(text, &vocabulary()).expect_err(text);
        assert_eq!(
            (error.line, error.column, error.problem.as_str()),
            (line, column, problem),
            "{text}"
        );
    }
}

#[test]
fn limits_are_errors() {
    let deep = format!("if {}goal is near", "(".repeat(DEEPEST + 1));
    let nots = format!("if {} goal is near then left", "not ".repeat(10_000 / 4 - 20));
    let many = "if goal is near then left\n".repeat(MOST_RULES + 1);
    let long = " ".repeat(MOST_CHARACTERS + 1);
    for (text, part) in [
        (deep, "nested 50"),
        (nots, "nested 50"),
        (many, "at most 100 rules"),
        (long, "characters"),
    ] {
        let error = parse(&text, &vocabulary()).expect_err(part);
        assert!(error.problem.contains(part), "{error}");
    }
}

proptest! {
    #[test]
    fn any_text_is_read_or_refused(text in "(if |then |goal |is |near |not |\\(|\\)|left |&&|;|\\PC){0,40}") {
        if let Err(error) = parse(&text, &vocabulary()) {
            prop_assert!(error.offset <= text.chars().count());
        }
    }
}
