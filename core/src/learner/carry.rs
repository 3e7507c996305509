//! Networks that go on learning elsewhere: another goal, a closed door, another seed.
//!
//! What was learned is kept: centres, prototypical actions, means, utilities. What belonged to the run is
//! not: its trials and ticks, its temperature, its record, since another task has another, and the
//! shortcuts (addition A1) along that record's path.

use super::{LearnerSettings, Memory, Neuron};

/// Networks that cannot be taken over: what is wrong with them, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{place}` {problem}")]
pub struct CarryError {
    /// Where, e.g. `networks[1].neurons[4].centre[7]`.
    pub place: String,
    /// What it must be.
    pub problem: String,
}

impl Memory {
    /// The memory of a learner that begins with trained networks, `inputs` of whose lanes are used.
    ///
    /// # Errors
    /// The first neuron whose number is not greater than the one before it in the same network, or is
    /// taken in another, or that holds something that is no finite number.
    pub(crate) fn carrying(
        settings: &LearnerSettings,
        networks: &[Vec<Neuron>],
        inputs: usize,
    ) -> Result<Self, CarryError> {
        check(networks, inputs)?;
        let next_neuron = networks.iter().flatten().map(|neuron| neuron.id.0 + 1).max();
        let mut memory = Self::empty(settings, networks.len());
        memory.next_neuron = next_neuron.unwrap_or(0);
        memory.temperature_deg = settings.carried_temperature_deg;
        for (network, neurons) in memory.networks.iter_mut().zip(networks) {
            neurons.iter().for_each(|neuron| network.add(carried(neuron)));
        }
        Ok(memory)
    }
}

/// A neuron as it enters a run that did not bear it: trial, step and tick 0.
fn carried(neuron: &Neuron) -> Neuron {
    let mut carried = neuron.clone();
    (carried.birth.trial, carried.birth.step, carried.birth.tick) = (0, 0, 0);
    carried.pending = false;
    if carried.aim.take().is_some() {
        carried.mean_deg = 0.0;
    }
    carried
}

fn check(networks: &[Vec<Neuron>], inputs: usize) -> Result<(), CarryError> {
    let mut taken = std::collections::BTreeSet::new();
    for (network, neurons) in networks.iter().enumerate() {
        for (index, neuron) in neurons.iter().enumerate() {
            let place = |field: &str| format!("networks[{network}].neurons[{index}]{field}");
            let refuse = |field: &str, problem: &str| {
                Err(CarryError { place: place(field), problem: problem.to_owned() })
            };
            if neuron.id.0 == u32::MAX {
                return refuse(".id", "must be less than 4294967295");
            }
            if index > 0 && neuron.id <= neurons[index - 1].id {
                return refuse(".id", "must be greater than that of the neuron before it");
            }
            if !taken.insert(neuron.id) {
                return refuse(".id", "must differ from those in the other networks");
            }
            for (field, value) in [
                (".prototypical_rad", neuron.prototypical_rad),
                (".mean_deg", neuron.mean_deg),
                (".utility", neuron.utility),
                (".birth.pose.x_m", neuron.birth.pose.x_m),
                (".birth.pose.y_m", neuron.birth.pose.y_m),
                (".birth.pose.heading_rad", neuron.birth.pose.heading_rad),
            ] {
                if !value.is_finite() {
                    return refuse(field, "must be a finite number");
                }
            }
            check_centre(neuron, inputs).map_err(|(input, problem)| CarryError {
                place: place(&format!(".centre[{input}]")),
                problem: problem.to_owned(),
            })?;
        }
    }
    Ok(())
}

fn check_centre(neuron: &Neuron, inputs: usize) -> Result<(), (usize, &'static str)> {
    for (input, value) in neuron.centre.iter().enumerate() {
        if !value.is_finite() {
            return Err((input, "must be a finite number"));
        }
        if input >= inputs && *value != 0.0 {
            return Err((input, "must be 0: the robot has no such input"));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::Settings;
    use crate::learner::NeuronId;

    fn settings() -> LearnerSettings {
        LearnerSettings::from(&Settings::default())
    }

    fn neuron(id: u32) -> Neuron {
        Neuron { pending: true, ..Neuron::example(id, [0.5; 32], -3.0) }
    }

    #[test]
    fn what_was_learned_is_kept_and_what_belonged_to_the_run_is_not() {
        let networks = vec![vec![neuron(2), neuron(7)], vec![neuron(4)]];
        let memory = Memory::carrying(&settings(), &networks, 32).expect("good networks");
        assert_eq!((memory.neurons(), memory.trials(), memory.ticks()), (3, 0, 0));
        let first = &memory.networks()[0].neurons()[0];
        assert_eq!((first.id, first.utility, first.pending), (NeuronId(2), -3.0, false));
        assert_eq!((first.birth.trial, first.birth.tick), (0, 0));
        assert_eq!(memory.next_neuron, 8, "numbers are never used again");
        assert!(memory.best.is_none(), "another task has another record");
    }

    #[test]
    fn a_refusal_names_the_place() {
        let with = |change: fn(&mut Neuron)| {
            let mut changed = neuron(3);
            change(&mut changed);
            vec![vec![neuron(2), changed], vec![]]
        };
        for (networks, place, says) in [
            (with(|n| n.id = NeuronId(2)), "networks[0].neurons[1].id", "greater"),
            (with(|n| n.id = NeuronId(u32::MAX)), "networks[0].neurons[1].id", "less than"),
            (vec![vec![neuron(1)], vec![neuron(1)]], "networks[1].neurons[0].id", "differ"),
            (with(|n| n.utility = f64::NAN), "networks[0].neurons[1].utility", "finite"),
            (with(|n| n.centre[9] = f64::INFINITY), "networks[0].neurons[1].centre[9]", "finite"),
            (with(|n| n.centre[9] = 0.1), "networks[0].neurons[0].centre[18]", "no such input"),
        ] {
            let inputs = if says == "no such input" { 18 } else { 32 };
            let error = Memory::carrying(&settings(), &networks, inputs).expect_err(place);
            assert_eq!(error.place, place);
            assert!(error.problem.contains(says), "{error}");
        }
    }
}
