use proptest::prelude::*;

use super::*;
use crate::tabular::{Outcome, Row};

fn to(next: usize, chance: f64, reward: f64) -> Outcome {
    Outcome { next, chance, reward }
}

/// Wait in state 0 for 1, or leave for 5 with a chance of one half each time it is tried.
fn wait_or_leave() -> Mdp {
    let rows = [
        Row { state: 0, action: 0, outcomes: vec![to(0, 1.0, 1.0)] },
        Row { state: 0, action: 1, outcomes: vec![to(1, 0.5, 5.0), to(0, 0.5, 0.0)] },
    ];
    Mdp::new(2, 2, &[1], &rows).expect("rows sum to 1")
}

#[test]
fn values_in_closed_form() {
    // Waiting for ever is worth 1/(1 − γ); leaving 2.5 + γ/2 V, so V = 2.5/(1 − γ/2).
    for (discount, expected, action) in [(0.5, 10.0 / 3.0, 1), (0.9, 10.0, 0)] {
        for sweep in [Sweep::Synchronous, Sweep::InPlace] {
            let found = value_iteration(&wait_or_leave(), discount, 1e-10, sweep).expect("settles");
            assert!((found.values[0] - expected).abs() < 1e-8, "{found:?}");
            assert_eq!((found.values[1], found.policy[0]), (0.0, action));
        }
        let found = policy_iteration(&wait_or_leave(), discount).expect("γ < 1");
        assert!((found.values[0] - expected).abs() < 1e-12);
        assert_eq!(found.policy[0], action);
    }
}

#[test]
fn what_has_no_value_is_named() {
    let endless = Mdp::new(
        2,
        1,
        &[],
        &[
            Row { state: 0, action: 0, outcomes: vec![to(1, 1.0, 1.0)] },
            Row { state: 1, action: 0, outcomes: vec![to(0, 1.0, 1.0)] },
        ],
    )
    .expect("rows sum to 1");
    let error = value_iteration(&endless, 1.0, 1e-6, Sweep::InPlace).expect_err("never ends");
    assert_eq!(error, MdpError::Endless { state: 0 });
    assert!(value_iteration(&endless, 0.9, 1e-6, Sweep::InPlace).is_ok());
    // Here an end can be reached, but it does not pay to go there.
    let error =
        value_iteration(&wait_or_leave(), 1.0, 1e-6, Sweep::InPlace).expect_err("unbounded");
    assert!(matches!(error, MdpError::Unsettled { .. }), "{error}");
    assert_eq!(evaluate(&wait_or_leave(), &[0, 0], 1.0), Err(MdpError::Endless { state: 0 }));
    assert_eq!(
        evaluate(&wait_or_leave(), &[2, 0], 0.9),
        Err(MdpError::Policy { state: 0, action: 2 })
    );
    for discount in [-0.1, 1.1, f64::NAN] {
        let error = value_iteration(&wait_or_leave(), discount, 1e-6, Sweep::InPlace);
        assert!(matches!(error, Err(MdpError::Discount { .. })));
    }
}

#[test]
fn rows_are_checked() {
    let row = |state, action, outcomes| Row { state, action, outcomes };
    for (rows, message) in [
        (
            vec![row(0, 1, vec![to(1, 0.5, 0.0), to(0, 0.4, 0.0)])],
            "the chances of state 0, action 1 must sum to 1, not 0.9",
        ),
        (vec![row(0, 0, vec![to(7, 1.0, 0.0)])], "there is no state 7"),
        (
            vec![row(0, 2, vec![to(1, 1.0, 0.0)])],
            "there is no action 2, which state 0 has a row for",
        ),
        (
            vec![row(0, 0, vec![to(1, 1.5, 0.0), to(0, -0.5, 0.0)])],
            "the chance from state 0 by action 0 to state 1 must be from 0 to 1, not 1.5",
        ),
        (
            vec![row(0, 0, vec![to(1, 1.0, f64::NAN)])],
            "the reward from state 0 by action 0 to state 1 must be a finite number",
        ),
        (
            vec![row(0, 0, vec![to(1, 1.0, 0.0)]), row(0, 0, vec![to(0, 1.0, 0.0)])],
            "state 0, action 0 has two rows; keep one",
        ),
        (vec![], "state 0 must have a row for at least one action, or be absorbing"),
    ] {
        let error = Mdp::new(2, 2, &[1], &rows).expect_err(message);
        assert_eq!(error.to_string(), message);
    }
}

/// A random process of five states and three actions, some of them impossible.
fn random_mdp() -> impl Strategy<Value = Mdp> {
    let row = (proptest::collection::vec(1..10u32, 5), -5.0..5.0f64, any::<bool>());
    proptest::collection::vec(row, 15).prop_map(|rows| {
        let rows: Vec<Row> = rows
            .iter()
            .enumerate()
            .filter(|(pair, (_, _, keep))| *keep || pair % 3 == 0)
            .map(|(pair, (weights, reward, _))| {
                let total: u32 = weights.iter().sum();
                let outcomes = weights.iter().enumerate().map(|(next, weight)| {
                    to(next, f64::from(*weight) / f64::from(total), reward * (next as f64 - 1.5))
                });
                Row { state: pair / 3, action: pair % 3, outcomes: outcomes.collect() }
            })
            .collect();
        Mdp::new(5, 3, &[], &rows).expect("rows sum to 1")
    })
}

proptest! {
    #[test]
    fn both_iterations_agree_and_the_bound_holds(mdp in random_mdp(), discount in 0.0..0.97f64) {
        let exact = policy_iteration(&mdp, discount).expect("γ < 1");
        for (sweep, precision) in
            [(Sweep::Synchronous, 1e-9), (Sweep::InPlace, 1e-9), (Sweep::InPlace, 0.5)]
        {
            let found = value_iteration(&mdp, discount, precision, sweep).expect("γ < 1");
            let of_policy = evaluate(&mdp, &found.policy, discount).expect("possible");
            let bound = found.bound.expect("γ < 1");
            for (state, best) in exact.values.iter().enumerate() {
                prop_assert!(of_policy[state] <= best + 1e-8);
                prop_assert!(of_policy[state] >= best - bound - 1e-8);
                if precision < 1e-6 {
                    prop_assert!((found.values[state] - best).abs() < 1e-6);
                }
            }
        }
    }

    #[test]
    fn iterated_evaluation_agrees_with_the_solve(mdp in random_mdp(), discount in 0.0..0.97f64) {
        let policy = greedy(&mdp, discount, &[0.0; 5]);
        let solved = solve(&mdp, &policy, discount);
        let settled = settle(&mdp, &policy, discount).expect("γ < 1");
        prop_assert!(solved.iter().zip(&settled).all(|(a, b)| (a - b).abs() < 1e-8));
    }
}
