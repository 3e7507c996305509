//! The monolithic navigator of section 2.7: 972 rules over five region depths and the velocity.
//!
//! NOTE: the thesis prints what its sets and outputs are called, their ranges and that there are
//! about 1000 rules, but neither the rules nor the corners of the sets (figures 2.7 and 2.8 are
//! lost). Four principles give every consequent here, and each rule says which did:
//!
//! | principle | what it says |
//! |---|---|
//! | R1 speed | full speed less a penalty for every threat; a dangerous centre backs up |
//! | R2 turn | to the freer side, in proportion; more so with a threat ahead; to the left when equal |
//! | R3 commitment | slow or backing up with a threat ahead or a near side dangerous: turn left until clear |
//! | R4 smoothing | no velocity far from the present one, unless the centre is dangerous |
//!
//! The corners of the sets and the constants were chosen with ideal sensors and with the median and
//! Kalman filter in simulation, on seeds that no result uses.

use crate::fuzzy::{
    Consequent, Defuzzifier, Input, NamedSet, Norms, Output, Rule, RuleBase, Set, Trapezoid,
};

/// Regions of the front, I to V.
pub const REGIONS: usize = 5;

/// How threatened a region is.
const THREATS: [&str; 3] = ["safe", "steer", "dangerous"];
/// Names of the regions, from the far left to the far right.
const REGION_NAMES: [&str; REGIONS] = ["far_left", "left", "centre", "right", "far_right"];
/// Figure 2.7: end of dangerous, begin and end of steer, begin of safe; regions II to IV and I, V, metres.
const FRONT_M: [f64; 4] = [0.20, 0.30, 0.55, 1.00];
const FAR_SIDE_M: [f64; 4] = [0.15, 0.25, 0.35, 0.50];
/// Figure 2.8, cm/s; the first falls from wholly `reverse` and the last rises to wholly `fast`.
const VELOCITIES: [&str; 4] = ["reverse", "slow", "normal", "fast"];
const VELOCITY_CM_S: [[f64; 2]; 3] = [[-2.0, 0.0], [3.0, 5.0], [8.0, 10.0]];
/// What a velocity set stands for in R4, cm/s.
const TYPICAL_CM_S: [f64; 4] = [-5.0, 2.0, 6.5, 12.0];
/// Section 2.7: ranges of the outputs, cm/s and deg/s.
const V_CM_S: [f64; 2] = [-10.0, 15.0];
const W_DEG_S: [f64; 2] = [-10.0, 10.0];
/// R1: what a region costs when it is to be steered from, and when it is dangerous, cm/s.
const PENALTIES_CM_S: [[f64; 2]; REGIONS] =
    [[1.0, 2.0], [2.0, 18.0], [2.0, 25.0], [2.0, 18.0], [1.0, 2.0]];
/// R2: turn away from a far side and from a near side for each degree of threat, and from the centre.
const FAR_SIDE_DEG_S: f64 = 1.5;
const NEAR_SIDE_DEG_S: f64 = 3.5;
const CENTRE_DEG_S: f64 = 7.5;
/// R4: how far below and above the present velocity.
const SLOWER_CM_S: f64 = 8.0;
const FASTER_CM_S: f64 = 7.0;

/// A consequent with the principle that gave it.
type Given = (f64, &'static str);

/// The rule base of the navigator, as `assets/rules/navigator.rules` has it.
///
/// Rule `((((t₁·3 + t₂)·3 + t₃)·3 + t₄)·3 + t₅)·4 + velocity`, where 0 is safe, 1 steer, 2 dangerous.
///
/// # Panics
/// Never: the rules are complete.
#[must_use]
pub fn navigator() -> RuleBase {
    let combinations = THREATS.len().pow(REGIONS as u32) * VELOCITIES.len();
    RuleBase::new(
        "navigator".into(),
        "The navigator of section 2.7: five region depths and the velocity".into(),
        Norms::Algebraic,
        Defuzzifier::CentreOfArea,
        (0..REGIONS).map(depth).chain([velocity()]).collect(),
        vec![output("v", "cm/s", V_CM_S), output("w", "deg/s", W_DEG_S)],
        (0..combinations).map(rule).collect(),
    )
    .expect("a rule for each combination, all within the ranges")
}

fn depth(region: usize) -> Input {
    let far_side = region == 0 || region == REGIONS - 1;
    let [dangerous, from, to, safe] = if far_side { FAR_SIDE_M } else { FRONT_M };
    let (none, all) = (f64::NEG_INFINITY, f64::INFINITY);
    let corners =
        [[to, safe, all, all], [dangerous, from, to, safe], [none, none, dangerous, from]];
    let sets = THREATS.iter().zip(corners).map(|(name, corners)| named(name, corners));
    Input {
        name: REGION_NAMES[region].into(),
        unit: "m".into(),
        range: [0.0, 2.0],
        sets: sets.collect(),
    }
}

fn velocity() -> Input {
    let (none, all) = (f64::NEG_INFINITY, f64::INFINITY);
    let [first, second, third] = VELOCITY_CM_S;
    let corners = [
        [none, none, first[0], first[1]],
        [first[0], first[1], second[0], second[1]],
        [second[0], second[1], third[0], third[1]],
        [third[0], third[1], all, all],
    ];
    let sets = VELOCITIES.iter().zip(corners).map(|(name, corners)| named(name, corners));
    Input { name: "velocity".into(), unit: "cm/s".into(), range: V_CM_S, sets: sets.collect() }
}

fn output(name: &str, unit: &str, range: [f64; 2]) -> Output {
    Output { name: name.into(), unit: unit.into(), range, sets: Vec::new() }
}

fn named(name: &str, [left, from, to, right]: [f64; 4]) -> NamedSet {
    NamedSet { name: name.into(), set: Set::Trapezoid(Trapezoid { left, from, to, right }) }
}

/// The rule of a combination.
fn rule(index: usize) -> Rule {
    let (threats, velocity) = (index / VELOCITIES.len(), index % VELOCITIES.len());
    let digit =
        |region: usize| threats / THREATS.len().pow((REGIONS - 1 - region) as u32) % THREATS.len();
    let threat: [usize; REGIONS] = std::array::from_fn(digit);
    let (v, v_by) = speed(threat, velocity);
    let (w, w_by) = turn(threat, velocity);
    Rule {
        when: threat.into_iter().chain([velocity]).collect(),
        then: vec![Consequent::Value(v), Consequent::Value(w)],
        because: format!("v {v_by}, w {w_by}"),
    }
}

/// R1 and R4: the velocity, cm/s.
fn speed(threat: [usize; REGIONS], velocity: usize) -> Given {
    let penalty = |(costs, threat): (&[f64; 2], &usize)| match threat {
        0 => 0.0,
        threat => costs[threat - 1],
    };
    let penalties: f64 = PENALTIES_CM_S.iter().zip(&threat).map(penalty).sum();
    let by_threat = (V_CM_S[1] - penalties).clamp(V_CM_S[0], V_CM_S[1]);
    if threat[2] == 2 {
        return (by_threat, "R1");
    }
    let typical = TYPICAL_CM_S[velocity];
    let smooth = by_threat.clamp(typical - SLOWER_CM_S, typical + FASTER_CM_S);
    let smooth = smooth.clamp(V_CM_S[0], V_CM_S[1]);
    (smooth, if smooth == by_threat { "R1" } else { "R4" })
}

/// R2 and R3: the turn, deg/s, to the left above 0.
fn turn(threat: [usize; REGIONS], velocity: usize) -> Given {
    let blocked = threat[2] > 0 || threat[1] == 2 || threat[3] == 2;
    if velocity < 2 && blocked {
        return (W_DEG_S[1], "R3");
    }
    let [far_left, left, centre, right, far_right] = threat.map(|threat| threat as f64);
    let from_left = FAR_SIDE_DEG_S * far_left + NEAR_SIDE_DEG_S * left;
    let from_right = FAR_SIDE_DEG_S * far_right + NEAR_SIDE_DEG_S * right;
    let freer = from_right - from_left;
    let side = if freer < 0.0 { -1.0 } else { 1.0 };
    let ahead = if centre > 0.0 { side * CENTRE_DEG_S } else { 0.0 };
    ((freer + ahead).clamp(W_DEG_S[0], W_DEG_S[1]), "R2")
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const FILE: &str = include_str!("../../../assets/rules/navigator.rules");

    fn consequents(base: &RuleBase, rule: usize) -> [f64; 2] {
        let value = |output: usize| match base.rules()[rule].then[output] {
            Consequent::Value(value) => value,
            Consequent::Set(_) => f64::NAN,
        };
        [value(0), value(1)]
    }

    #[test]
    fn the_rules_are_those_of_the_principles() {
        let base = navigator();
        assert_eq!(base.rules().len(), 972);
        let expected: [([usize; 5], [[f64; 2]; 4]); 7] = [
            ([0, 0, 0, 0, 0], [[2.0, 0.0], [9.0, 0.0], [13.5, 0.0], [15.0, 0.0]]),
            ([0, 0, 1, 0, 0], [[2.0, 10.0], [9.0, 10.0], [13.0, 7.5], [13.0, 7.5]]),
            ([0, 0, 2, 0, 0], [[-10.0, 10.0], [-10.0, 10.0], [-10.0, 7.5], [-10.0, 7.5]]),
            ([0, 1, 0, 0, 0], [[2.0, -3.5], [9.0, -3.5], [13.0, -3.5], [13.0, -3.5]]),
            ([0, 2, 0, 0, 0], [[-3.0, 10.0], [-3.0, 10.0], [-1.5, -7.0], [4.0, -7.0]]),
            ([1, 1, 1, 0, 0], [[2.0, 10.0], [9.0, 10.0], [10.0, -10.0], [10.0, -10.0]]),
            ([2, 2, 2, 2, 2], [[-10.0, 10.0], [-10.0, 10.0], [-10.0, 7.5], [-10.0, 7.5]]),
        ];
        for (threat, by_velocity) in expected {
            let first = threat.iter().fold(0, |index, threat| index * 3 + threat) * 4;
            for (velocity, expected) in by_velocity.into_iter().enumerate() {
                let found = consequents(&base, first + velocity);
                assert_eq!(found, expected, "{threat:?} {}", VELOCITIES[velocity]);
            }
        }
        let sums = (0..972).map(|rule| consequents(&base, rule));
        let sums = sums.fold([0.0, 0.0], |[v, w], [dv, dw]| [v + dv, w + dw]);
        assert_eq!(sums, [-2013.5, 4410.0]);
    }

    #[test]
    fn the_file_is_what_the_principles_give() {
        let text = format!(
            "# The 972 rules of section 2.7, made by the four principles of core/src/control/navigator.rs\n\
             # and written here to be read and changed. After `|` stands the principle that gave each.\n\
             # To write the file anew: UPDATE_RULES=1 cargo test -p sonarium-core --lib navigator\n\n{}",
            navigator().to_text()
        );
        if std::env::var_os("UPDATE_RULES").is_some() {
            let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/rules/navigator.rules");
            std::fs::write(path, &text).expect("the repository can be written to");
        } else {
            assert!(
                FILE == text,
                "assets/rules/navigator.rules is stale; UPDATE_RULES=1 writes it anew"
            );
        }
    }

    #[test]
    fn rules_say_which_principle_gave_them() {
        let base = navigator();
        let because = |rule: usize| base.rules()[rule].because.as_str();
        assert_eq!(because(0), "v R4, w R2", "safe and backing up: not at full speed at once");
        assert_eq!(because(3), "v R1, w R2", "safe and fast");
        assert_eq!(because(4 * 9 + 1), "v R4, w R3", "a threat ahead and slow: turn left");
    }

    proptest! {
        #[test]
        fn memberships_are_a_partition_of_unity(depth_m in 0.0..2.0f64, v_cm_s in -10.0..15.0f64) {
            let inputs = [depth_m, depth_m, depth_m, depth_m, depth_m, v_cm_s];
            let memberships = navigator().explain(&inputs).memberships;
            for (first, sets) in [(0, 3), (3, 3), (6, 3), (9, 3), (12, 3), (15, 4)] {
                let sum: f64 = memberships[first..first + sets].iter().sum();
                prop_assert!((sum - 1.0).abs() < 1e-12, "{first}: {sum}");
            }
        }
    }
}
