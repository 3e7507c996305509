//! Section 4.9's search spaces, with the distances and the ways through the labyrinth it names.

use sonarium_core::labyrinth::{Action, Bias, Labyrinth, belief, distances, matrix, next};
use sonarium_core::stats::Verdict;

use super::episodes::{LABYRINTH, broken, contestant, settings};
use super::table_4_3::ARMS;
use super::{Arm, Findings, NO_SEEDS, ReproductionError, Row, Sets, Target, Unit};
use crate::wire::ReproductionRow;

/// The search spaces of section 4.9.
pub static SEARCH_SPACE_4_9: Target = Target {
    name: "search-space-4.9",
    title: "What the biases leave to be searched",
    compares: "Pairs of state and action that each bias leaves, the fewest actions between cells, and the two \
               ways that section 4.9 names: counted, not sampled",
    source: "Sections 4.4, 4.6, 4.9 and 4.10",
    readings: &[
        "\"the state-action pairs left after those irrelevant state-action pairs supplied by the bias are \
         removed\": what is counted are the pairs whose belief is not below 0, of 16 states and 3 actions",
        "B2 is printed for one cell only; every reading of the others leaves as many",
    ],
    rules: &[Verdict::EXACT_RULE],
    experiment: LABYRINTH,
    arms: ARMS,
    unit: Unit::Experiment,
    trials: 0,
    seeds: NO_SEEDS,
    find,
};

fn find(target: &Target, _: &Sets<'_>) -> Result<Findings, ReproductionError> {
    let pairs = target.arms.iter().map(pairs_left);
    let mut rows: Vec<ReproductionRow> = pairs.collect::<Result<_, ReproductionError>>()?;
    rows.extend(ways());
    Ok(Findings { rows, ..Findings::default() })
}

fn pairs_left(arm: &Arm) -> Result<ReproductionRow, ReproductionError> {
    let (_, contestant) = contestant(arm, &settings(arm)?)?;
    let labyrinth = Labyrinth::of_the_thesis();
    let beliefs = matrix(contestant.bias, labyrinth.goal(), &contestant.readings);
    let belief =
        belief(&beliefs, &labyrinth, contestant.exclusion).map_err(|error| broken(arm, error))?;
    let published = match contestant.bias {
        Bias::B10 => Some(38.0),
        Bias::B2 => Some(40.0),
        _ => None,
    };
    let row = Row {
        name: "pairs of state and action left",
        published,
        unit: "",
        reading: "the effective search space; printed for B10 and B2",
    };
    Ok(row.exact(Some(arm.name), belief.search_space() as f64, 1.0))
}

/// Fewest actions, and where the printed ways end.
fn ways() -> Vec<ReproductionRow> {
    use Action::{Forward, Left, Right};
    let mut rows = Vec::new();
    for (from, to, published) in [(7, 15, 5.0), (12, 15, 1.0), (7, 2, 2.0)] {
        let name = format!("fewest actions from #{from} to #{to}");
        let row = Row { name: &name, published: Some(published), unit: "", reading: FEWEST };
        rows.push(row.exact(None, f64::from(distances(to)[from]), 1.0));
    }
    for (words, way) in [
        ("left left forward left left", [Left, Left, Forward, Left, Left]),
        ("left left forward right right", [Left, Left, Forward, Right, Right]),
    ] {
        let name = format!("state that {{{words}}} leads to from #7");
        let row = Row { name: &name, published: Some(15.0), unit: "", reading: WAY };
        let end = way.iter().fold(7, |state, action| next(state, *action));
        rows.push(row.exact(None, end as f64, 1.0));
    }
    rows
}

const FEWEST: &str = "\"computed by hand and turned out to be 5\" (section 4.9), \"it requires only one\" (section 4.6), \
    \"the optimum number of actions of the new task was two\" (section 4.10); searched breadth first";
const WAY: &str =
    "an optimal policy that section 4.9 gives as an example, followed in the table of figure 4.5";
