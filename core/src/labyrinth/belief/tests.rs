//! The matrices of the independent reconstruction, one word a state: `+` 1, `-` -1, `h` one half, in the order
//! left, forward, right.

use super::*;

const B0: &str = "+++ +++ +++ +++ +++ +++ +++ +++ +++ +++ +++ +++ +++ +++ +++ +++";
const B10: &str = "+-+ +++ +-+ +-+ +-+ +++ +-+ +++ +-+ +-+ +-+ +++ +-+ +++ +-+ +++";
const B11_FIGURE: &str = "h-+ h+h +-h +-+ +-+ h+h +-+ +++ +-h +-+ h-+ h+h +-+ +++ +-+ h+h";
const B11_ABSOLUTE: &str = "h-+ h+h +-h h-h +-+ h+h +-+ hhh +-h h-h h-+ h+h +-+ hhh +-+ h+h";
const B2_GOAL_DIRECTED: &str = "++- +++ +++ ++- ++- +++ +++ ++- +++ ++- ++- +++ +++ ++- ++- +++";
const B2_WEST: &str = "++- +++ +++ ++- ++- +++ +++ ++- ++- +++ +++ ++- ++- +++ +++ ++-";
const B2_AWAY: &str = "+++ ++- ++- +++ +++ ++- ++- +++ ++- +++ +++ ++- ++- +++ +++ ++-";
const B2_TURNS: &str = "-++ +++ ++- +++ -++ +++ ++- +++ ++- +++ -++ +++ ++- +++ -++ +++";
const B30: &str = "+++ +++ +++ +++ +++ +++ +++ +++ +++ +++ +++ -+- +-- +++ --+ +++";
const B31_BOTH: &str = "--+ -+- +-- +-+ --+ -+- +-- +-+ +-- +-+ --+ +++ +++ +-+ +++ +++";
const B31_ONE: &str = "--+ -+- +-- +-- --+ -+- +-- +-- +-- +-- --+ +++ +++ +-- +++ +++";

fn read(text: &str) -> Matrix {
    let mut matrix = [[0.0; ACTIONS]; STATES];
    for (beliefs, word) in matrix.iter_mut().zip(text.split(' ')) {
        for (belief, sign) in beliefs.iter_mut().zip(word.chars()) {
            *belief = match sign {
                '+' => 1.0,
                '-' => -1.0,
                _ => 0.5,
            };
        }
    }
    matrix
}

#[test]
fn the_definitions_give_the_reconstructed_matrices() {
    let default = Readings::default();
    let insight = |insight| Readings { insight, ..default };
    let absolute = Readings { environment: EnvironmentRule::Absolute, ..default };
    let one = Readings { goal: GoalActions::One, ..default };
    for (bias, readings, expected) in [
        (Bias::B0, default, B0),
        (Bias::B10, default, B10),
        (Bias::B11, default, B11_FIGURE),
        (Bias::B11, absolute, B11_ABSOLUTE),
        (Bias::B2, insight(InsightRule::GoalDirected), B2_GOAL_DIRECTED),
        (Bias::B2, insight(InsightRule::West), B2_WEST),
        (Bias::B2, insight(InsightRule::Away), B2_AWAY),
        (Bias::B2, insight(InsightRule::Turns), B2_TURNS),
        (Bias::B30, default, B30),
        (Bias::B31, default, B31_BOTH),
        (Bias::B31, one, B31_ONE),
    ] {
        assert_eq!(matrix(bias, 15, &readings), read(expected), "{} {readings:?}", bias.name());
    }
}

#[test]
fn the_search_spaces_of_section_4_9() {
    let left = |bias| {
        matrix(bias, 15, &Readings::default())
            .iter()
            .flatten()
            .filter(|belief| **belief >= 0.0)
            .count()
    };
    // Printed: 38 with B10 and 40 with B2, of 48.
    assert_eq!((left(Bias::B0), left(Bias::B10), left(Bias::B2)), (48, 38, 40));
}

#[test]
fn goal_fields_follow_the_goal() {
    for goal in 0..STATES {
        let far = distances(goal);
        let near = matrix(Bias::B30, goal, &Readings::default());
        let vectors = matrix(Bias::B31, goal, &Readings::default());
        for state in 0..STATES {
            for (action, way) in Action::ALL.iter().enumerate() {
                let nearer = far[next(state, *way)] < far[state];
                let (in_near, in_far) = (far[state] == 1, far[state] > 1);
                assert_eq!(near[state][action] > 0.0, nearer || !in_near, "{state} to {goal}");
                assert_eq!(vectors[state][action] > 0.0, nearer || !in_far, "{state} to {goal}");
            }
        }
    }
}
