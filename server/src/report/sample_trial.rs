//! A trial as the tests of the reports need one: one collision, some neurons added.

use super::TrialReport;
use super::sample::{picture, session, trials};
use crate::wire::*;

/// Trial 4 with all its ticks.
pub(super) fn trial_report() -> TrialReport {
    let trial = trials().swap_remove(3);
    let change = |neuron, before, after| ChangeView { neuron, before, after };
    TrialReport {
        title: "Minimum-cost path".into(),
        session: session(),
        ticks: (1..=trial.steps).map(|step| tick(&trial, step)).collect(),
        end: TrialEndView {
            trial,
            backed_up: (60..88).map(|n| change(n, -0.31, -0.21 * f64::from(88 - n))).collect(),
            replaced: (60..88).map(|n| change(n, 12.5, 9.75 + f64::from(n % 7))).collect(),
            proposed: (64..88).map(proposal).collect(),
            judged: vec![
                VerdictView { neuron: 66, delta: Some(-0.214), withdrawn: true },
                VerdictView { neuron: 71, delta: None, withdrawn: true },
                VerdictView { neuron: 75, delta: Some(0.087), withdrawn: false },
            ],
            forgotten: Vec::new(),
            neurons: vec![neuron(1), neuron(2)],
        },
        picture: Some(picture(4)),
    }
}

fn proposal(neuron: u32) -> ProposalView {
    ProposalView {
        neuron,
        before: 0.0,
        after: -4.5 + f64::from(neuron % 5),
        aim: AimView {
            x_m: 3.62,
            y_m: -0.42,
            beyond_m: (neuron == 64).then_some([4.16, -0.75]),
            then: Some(neuron + 4),
        },
        step: neuron - 60,
        straight: -0.8,
        utility: -0.21 * f64::from(88 - neuron),
    }
}

fn tick(trial: &Trial, step: u32) -> TickView {
    let turn = f64::from(step);
    let (x_m, y_m) = (0.18 * turn, -0.02 * turn * (0.3 * turn).sin());
    let pose = PoseView { x_m, y_m, heading_deg: 8.0 * (0.4 * turn).sin() };
    let collided = step == 11;
    let safety = if collided {
        -3.0
    } else if step.is_multiple_of(9) {
        -0.25
    } else {
        0.0
    };
    let goal = -0.28 - 0.1 * (0.5 * turn).cos();
    TickView {
        tick: trial.first_tick + u64::from(step) - 1,
        trial: trial.trial,
        step,
        true_pose: pose,
        pose,
        fix: None,
        sonar_m: (0..24)
            .map(|sonar| 0.13 + (0.9 + 0.1 * f64::from(sonar)) * (0.3 * turn).sin().powi(2))
            .collect(),
        reflectance_pct: 12.5,
        goal_distance_m: 4.4 - 0.14 * turn,
        goal_bearing_deg: -26.5,
        region: if step < 20 { "room" } else { "corridor" }.into(),
        winner: (step > 1)
            .then(|| WinnerView { neuron: 40 + step, distance: 0.031 + 0.004 * turn }),
        born: step.is_multiple_of(4).then_some(60 + step),
        toward_m: step.is_multiple_of(8).then_some([1.5, -0.25]),
        reflex: None,
        adaptation: adaptation(step),
        neuron: Some(40 + step),
        prototypical_deg: 35.0 * (0.2 * turn).sin(),
        utility: (!step.is_multiple_of(4)).then_some(-0.4 * (29.0 - turn)),
        aim: None,
        exploration: ExplorationView {
            temperature_deg: trial.temperature_deg,
            mean_deg: -6.5,
            sigma_deg: 51.3,
            deviation_deg: 1.8,
            drawn_deg: -7.1,
            most_deg: Some(trial.temperature_deg),
            xi_deg: -7.1,
        },
        source: if step == 12 { "sidestep" } else { "network" }.into(),
        action_deg: 35.0 * (0.2 * turn).sin() - 7.1,
        action_frame: "heading".into(),
        rotation_deg: -3.4,
        outcome: OutcomeView {
            true_pose: pose,
            pose,
            contact: if collided { "virtual" } else { "none" }.into(),
            backed_m: if collided { 0.12 } else { 0.0 },
            reinforcement: safety + goal,
            safety,
            goal,
            close: safety < 0.0,
            reached_goal: step == trial.steps,
        },
        neurons: 64 + step / 4,
        total_reinforcement: (safety + goal) * turn,
    }
}

fn adaptation(step: u32) -> AdaptationView {
    match step {
        1 => AdaptationView::NoPast,
        step if step % 4 == 0 => AdaptationView::Pending { past: 39 + step },
        step => AdaptationView::Updated {
            past: 39 + step,
            reinforcement: -0.3,
            present_utility: -4.4,
            utility_before: -4.6,
            delta: 0.1 + 1.0 / 3.0 * f64::from(step),
            utility_rate: 0.5,
            utility_after: -4.45,
            eligibility: 0.02,
            mean_before_deg: 0.0,
            mean_after_deg: 0.1,
            centre_shift: 0.003,
        },
    }
}

fn neuron(id: u32) -> NeuronView {
    NeuronView {
        id,
        region: "room".into(),
        centre: (0..32).map(|input| f64::from(input) / 32.0).collect(),
        prototypical_deg: 12.0,
        heading_deg: 12.0,
        mean_deg: -3.0,
        utility: Some(-5.5),
        wins: 4,
        birth: BirthView {
            trial: 1,
            step: id,
            tick: u64::from(id),
            cause: "distance".into(),
            value: Some(0.13),
            parent: None,
            toward_m: None,
            pose: PoseView::default(),
        },
    }
}
