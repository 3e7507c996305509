//! Networks that go on in another world, or for another goal, against a start from scratch there.

use std::ops::RangeInclusive;
use std::sync::Arc;

use sonarium_core::stats::Estimate;

use super::{
    Arm, Findings, PUBLISHED, ReproductionError, Row, Sample, Set, Sets, Target, Unit, curve,
};
use crate::catalog::{DEFAULT_TRIALS, FieldError, MINIMUM_COST_PATH, Plan, Trained};
use crate::session::Run;
use crate::wire::{ReproductionRow, Trial};

/// What was learned elsewhere, and what it is worth.
pub static CARRY_OVER: Target = Target {
    name: "carry-over",
    title: "Carried over against from scratch",
    compares: "Networks of 20 trials in one world that go on for 20 trials in another, where the \
               nearer of two doors is closed or the goal lies elsewhere, against empty networks that begin there, \
               seed by seed",
    source: "Not in the thesis, whose continual learning is that of the labyrinth of chapter 4",
    readings: &[
        "The 31.9 % that the thesis prints is what chapter 4's tabular learner gains in its labyrinth by \
         going on from what it knew; chapter 5 has no such experiment, so nothing is published here and \
         nothing is judged: the interval of a difference says whether it is one",
        "What is carried is what a network file holds, as `--save-network` and `--network` do: the \
         neurons with their actions and utilities; the count of trials and the record path begin anew",
        "The default preset begins a carried run at the full temperature (learner.carried_temperature), as \
         from scratch, so that it explores where the task has changed; the arms that say cold begin at \
         0, with what was learned as it is",
        "Arms are held against each other seed by seed; the 20 trials in the first world are not counted \
         against the carried arms",
        "A trial that does not reach the goal counts with the full cap of steps and with what it had \
         earned until then",
        "The reflex finds the goal in all four worlds, so that from scratch there is something to learn \
         from",
    ],
    rules: &[PUBLISHED],
    experiment: MINIMUM_COST_PATH,
    arms: ARMS,
    unit: Unit::Set,
    trials: DEFAULT_TRIALS,
    seeds: CARRY_SEEDS,
    find,
};

/// Seeds of each arm: 100 sets.
const CARRY_SEEDS: RangeInclusive<u64> = 700_000..=700_099;

/// A world that changes: what is run before the change, and the arms after it.
struct Change {
    before: Arm,
    scratch: Arm,
    carried: [Arm; 2],
}

const CLOSED_DOOR: Change = Change {
    before: Arm { name: "both doors open", settings: &[("world", "two-doors")] },
    scratch: Arm { name: "door closed, from scratch", settings: &[("world", "two-doors-closed")] },
    carried: [
        Arm { name: "door closed, carried over", settings: &[("world", "two-doors-closed")] },
        Arm {
            name: "door closed, carried over cold",
            settings: &[("world", "two-doors-closed"), ("learner.carried_temperature", "0")],
        },
    ],
};

const OTHER_GOAL: Change = Change {
    before: Arm { name: "first goal", settings: &[("world", "laboratory")] },
    scratch: Arm {
        name: "other goal, from scratch",
        settings: &[("world", "laboratory-other-goal")],
    },
    carried: [
        Arm { name: "other goal, carried over", settings: &[("world", "laboratory-other-goal")] },
        Arm {
            name: "other goal, carried over cold",
            settings: &[("world", "laboratory-other-goal"), ("learner.carried_temperature", "0")],
        },
    ],
};

static CHANGES: [Change; 2] = [CLOSED_DOOR, OTHER_GOAL];

const ARMS: &[Arm] = &[
    CLOSED_DOOR.scratch,
    CLOSED_DOOR.carried[0],
    CLOSED_DOOR.carried[1],
    OTHER_GOAL.scratch,
    OTHER_GOAL.carried[0],
    OTHER_GOAL.carried[1],
];

fn find(target: &Target, sets: &Sets<'_>) -> Result<Findings, ReproductionError> {
    let mut findings = Findings::default();
    let total = |trial: &Trial| Some(reinforcement(trial));
    for change in &CHANGES {
        let scratch = sets.of(target, &change.scratch)?;
        let alone = MEASURES.iter().filter_map(|measure| measure.alone(&scratch));
        findings.rows.extend(alone);
        findings.curves.push(curve(&scratch, "total reinforcement", "", total));
        for arm in &change.carried {
            let carried = carried(target, sets, &change.before, arm)?;
            let beside = MEASURES.iter().flat_map(|measure| measure.beside(&carried, &scratch));
            findings.rows.extend(beside);
            findings.curves.push(curve(&carried, "total reinforcement", "", total));
        }
    }
    Ok(findings)
}

/// The sets of an arm, each begun with what the same seed had learned before the change.
fn carried(
    target: &Target,
    sets: &Sets<'_>,
    before: &Arm,
    arm: &Arm,
) -> Result<Sample, ReproductionError> {
    let before = sets.plan(target, before)?;
    let plan = Plan { starts: Vec::new(), ..sets.plan(target, arm)? };
    let seeds: Vec<u64> = target.seeds.clone().collect();
    let done = sets.each(&seeds, |&seed| {
        let network = trained(&Plan { seed, ..before.clone() })?;
        network.check(&plan)?;
        Set::run(&Plan { seed, network: Some(Arc::new(network)), ..plan.clone() })
    })?;
    let seeds = [*target.seeds.start(), *target.seeds.end()];
    Ok(Sample { arm: *arm, plan, seeds, sets: done })
}

/// The networks after all trials of a plan.
fn trained(plan: &Plan) -> Result<Trained, FieldError> {
    let mut run = Run::new(plan)?;
    for _ in 0..plan.trials {
        while run.step_silently().is_none() {}
    }
    Ok(run.trained(plan))
}

/// Something of a set by which the arms of a change are held against each other.
struct Measure {
    name: &'static str,
    unit: &'static str,
    reading: &'static str,
    of: fn(&Set) -> Option<f64>,
}

const MEASURES: &[Measure] = &[
    Measure {
        name: "steps of the first trial",
        unit: "",
        reading: "control steps; mean over sets, Student's t interval",
        of: |set| set.trial(1).map(steps),
    },
    Measure {
        name: "total reinforcement of the first trial",
        unit: "",
        reading: "R(1), Eq. (5.27); mean over sets, Student's t interval",
        of: |set| set.trial(1).map(reinforcement),
    },
    Measure {
        name: "success in the first trial",
        unit: "%",
        reading: "share of sets whose first trial reaches the goal; exact interval of Clopper and \
                  Pearson",
        of: |set| set.trial(1).map(success_pct),
    },
    Measure {
        name: "steps of the last trial",
        unit: "",
        reading: "control steps; mean over sets, Student's t interval",
        of: |set| set.last().map(steps),
    },
    Measure {
        name: "total reinforcement of the last trial",
        unit: "",
        reading: "R(n), Eq. (5.27); mean over sets, Student's t interval",
        of: |set| set.last().map(reinforcement),
    },
    Measure {
        name: "success in the last trial",
        unit: "%",
        reading: "share of sets whose last trial reaches the goal; exact interval of Clopper and \
                  Pearson",
        of: |set| set.last().map(success_pct),
    },
    Measure {
        name: "trials until the first success",
        unit: "",
        reading: "the first trial that reaches the goal, one more than there are where none does; mean \
                  over sets, Student's t interval",
        of: |set| Some(trials_until(set, |trial| trial.reached_goal)),
    },
    Measure {
        name: "trials until within 10 % of the last trial's total reinforcement",
        unit: "",
        reading: "the first trial that reaches the goal with an R(n) at most 10 % below that of the \
                  last trial of the same set, one more than there are where none does, as when the \
                  last trial fails and none before it is as good; each arm is held against its own \
                  last trial, so the one that ends worse has less to reach; mean over sets, Student's \
                  t interval",
        of: trials_until_settled,
    },
];

impl Measure {
    /// What an arm does, by itself.
    fn alone(&self, sample: &Sample) -> Option<ReproductionRow> {
        self.row(self.name, self.reading).of(sample, self.estimate(sample))
    }

    /// A carried arm, and by how much it is above the one from scratch.
    fn beside(&self, carried: &Sample, scratch: &Sample) -> Vec<ReproductionRow> {
        let name = format!("{}, less that from scratch", self.name);
        let reading = format!(
            "carried over less from scratch with the same seed, mean over seeds, Student's t interval; \
             each: {}",
            self.reading
        );
        let differences = carried.differences(scratch, self.of);
        let paired = self.row(&name, &reading).of(carried, Estimate::mean(&differences));
        [self.alone(carried), paired].into_iter().flatten().collect()
    }

    fn row<'a>(&self, name: &'a str, reading: &'a str) -> Row<'a> {
        Row { name, published: None, unit: self.unit, reading }
    }

    fn estimate(&self, sample: &Sample) -> Option<Estimate> {
        match self.unit {
            "%" => sample.share_pct(|set| (self.of)(set).is_some_and(|pct| pct > 0.0)),
            _ => sample.mean(self.of),
        }
    }
}

fn steps(trial: &Trial) -> f64 {
    f64::from(trial.steps)
}

fn reinforcement(trial: &Trial) -> f64 {
    trial.total_reinforcement
}

fn success_pct(trial: &Trial) -> f64 {
    if trial.reached_goal { 100.0 } else { 0.0 }
}

/// The first trial, from 1, of which something is true; one more than there are where there is none.
fn trials_until(set: &Set, is_so: impl Fn(&Trial) -> bool) -> f64 {
    let before = set.trials.iter().take_while(|trial| !is_so(trial)).count();
    (before + 1) as f64
}

/// The first trial as good as the set's last one, but for 10 %.
fn trials_until_settled(set: &Set) -> Option<f64> {
    let last = reinforcement(set.last()?);
    let least = last - 0.1 * last.abs();
    Some(trials_until(set, |trial| trial.reached_goal && reinforcement(trial) >= least))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;
    use std::sync::atomic::{AtomicU32, Ordering};

    use super::*;
    use crate::catalog::Catalog;
    use crate::reproduce::Kept;

    /// A few short sets.
    fn few_sets() -> Target {
        Target { seeds: 700_000..=700_002, trials: 2, ..CARRY_OVER.clone() }
    }

    fn set(trials: &[(f64, bool)]) -> Set {
        let sample = crate::testing::undisturbed(1).remove(0);
        let trial = |&(total_reinforcement, reached_goal): &(f64, bool)| Trial {
            total_reinforcement,
            reached_goal,
            ..sample.clone()
        };
        Set {
            seed: 1,
            trials: trials.iter().map(trial).collect(),
            first_path_m: Vec::new(),
            last_path_m: Vec::new(),
            starts: Vec::new(),
        }
    }

    #[test]
    fn trials_are_counted_until_the_set_s_own_level() {
        for (trials, first_success, settled) in [
            (&[(-9.0, false), (-8.0, true), (-5.4, true), (-5.0, true)][..], 2.0, 3.0),
            (&[(-5.5, true), (-5.0, true)], 1.0, 1.0),
            (&[(-5.0, false), (-5.0, false)], 3.0, 3.0),
            (&[(0.2, true), (0.5, true), (0.5, true)], 1.0, 2.0),
        ] {
            let set = set(trials);
            assert_eq!(trials_until(&set, |trial| trial.reached_goal), first_success, "{trials:?}");
            assert_eq!(trials_until_settled(&set), Some(settled), "{trials:?}");
        }
    }

    #[test]
    fn networks_fit_the_world_after_the_change() {
        let catalog = Catalog::load(None).expect("the embedded files are fine");
        let sets = Sets { catalog: &catalog, threads: 1, kept: &Kept::default(), done: &|| () };
        for Change { before, scratch, .. } in &CHANGES {
            let plan = |arm: &Arm| sets.plan(&CARRY_OVER, arm).expect("it fits");
            let (before, after) = (plan(before), plan(scratch));
            assert_ne!(before.world.name, after.world.name);
            assert_eq!(before.names().regions, after.names().regions, "{}", after.world.name);
        }
    }

    #[test]
    fn a_carried_set_begins_with_the_neurons_of_the_first_world() {
        let catalog = Catalog::load(None).expect("the embedded files are fine");
        let (target, kept) = (few_sets(), Kept::default());
        let sets = Sets { catalog: &catalog, threads: 2, kept: &kept, done: &|| () };
        let Change { before, carried: arms, .. } = &OTHER_GOAL;
        let carried = carried(&target, &sets, before, &arms[0]).expect("it fits");
        let before = sets.of(&target, before).expect("it fits");
        for (after, before) in carried.sets.iter().zip(&before.sets) {
            let first = &after.trials[0];
            let known = first.neurons + first.forgotten - first.born;
            assert_eq!(after.seed, before.seed);
            assert_eq!(Some(known), before.last().map(|trial| trial.neurons), "{}", after.seed);
        }
    }

    #[test]
    fn every_measure_stands_for_each_arm_and_its_difference() {
        let (target, told) = (few_sets(), AtomicU32::new(0));
        let count = || {
            told.fetch_add(1, Ordering::Relaxed);
        };
        let findings = target.run(2, &Kept::default(), &count).expect("the embedded files fit");
        assert_eq!(told.into_inner(), target.work());
        // One row for the arm from scratch, two for each of two carried ones.
        assert_eq!(findings.rows.len(), CHANGES.len() * MEASURES.len() * 5);
        let ours: BTreeMap<&str, f64> =
            findings.rows.iter().map(|row| (row.name.as_str(), row.ours)).collect();
        assert_eq!(ours.len(), findings.rows.len(), "each with its name");
        assert!(findings.rows.iter().all(|row| row.published.is_none() && row.n == 3));
        for name in MEASURES.iter().map(|measure| measure.name) {
            let of = |arm: &str| ours[format!("{arm}: {name}").as_str()];
            let difference =
                ours[format!("other goal, carried over: {name}, less that from scratch").as_str()];
            let expected = of("other goal, carried over") - of("other goal, from scratch");
            assert!((difference - expected).abs() < 1e-9, "{name}: {difference}, not {expected}");
        }
        let arms: Vec<&str> = findings.curves.iter().map(|curve| curve.arm.as_str()).collect();
        assert_eq!(arms, target.arms.iter().map(|arm| arm.name).collect::<Vec<&str>>());
    }
}
