//! Reports for spreadsheets: RFC 4180, one row a trial or a control step, units in the header.
//!
//! A cell without a value is empty. Numbers have the shortest form that reads back to the same bits.

use super::{SessionReport, TrialReport};
use crate::wire::{AdaptationView, TickView, Trial};

/// The session as CSV: one row a trial.
#[must_use]
pub fn csv(report: &SessionReport) -> String {
    let mut header: Vec<String> = TRIAL_COLUMNS.iter().map(|column| column.name.into()).collect();
    let regions = &report.world.regions;
    header.extend(regions.iter().map(|region| format!("steps_in_{region}")));
    let mut text = line(&header);
    for trial in &report.trials {
        let mut cells = row(&TRIAL_COLUMNS, trial);
        let steps_in = |region| trial.region_steps.get(region).copied().unwrap_or(0).to_string();
        cells.extend(regions.iter().map(steps_in));
        text += &line(&cells);
    }
    text
}

/// The trial as CSV: one row a control step.
#[must_use]
pub fn trial_csv(report: &TrialReport) -> String {
    let sonars = report.ticks.iter().map(|tick| tick.sonar_m.len()).max().unwrap_or(0);
    let mut header: Vec<String> = TICK_COLUMNS.iter().map(|column| column.name.into()).collect();
    header.extend((0..sonars).map(|sonar| format!("sonar_{sonar:02}_m")));
    let mut text = line(&header);
    for tick in &report.ticks {
        let mut cells = row(&TICK_COLUMNS, tick);
        cells.extend((0..sonars).map(|sonar| optional(tick.sonar_m.get(sonar))));
        text += &line(&cells);
    }
    text
}

/// The meaning of every column of both files, for the text that goes with them.
pub(super) fn column_meanings() -> String {
    let mut text = String::from("trials.csv, one row a trial\n");
    for column in &TRIAL_COLUMNS {
        text += &format!("  {:<22} {}\n", column.name, column.meaning);
    }
    text += "  steps_in_REGION        steps taken in that region\n";
    text += "\ntrials/NNN.csv, one row a control step\n";
    for column in &TICK_COLUMNS {
        text += &format!("  {:<22} {}\n", column.name, column.meaning);
    }
    text += "  sonar_NN_m             reading of sonar NN, 15 degrees times NN \
             counter-clockwise from the heading\n";
    text
}

/// A column: its name with its unit, what it means, and its value in a row.
struct Column<Row> {
    name: &'static str,
    meaning: &'static str,
    value: fn(&Row) -> String,
}

const fn column<Row>(
    name: &'static str,
    meaning: &'static str,
    value: fn(&Row) -> String,
) -> Column<Row> {
    Column { name, meaning, value }
}

const TRIAL_COLUMNS: [Column<Trial>; 18] = [
    column("trial", "trial, from 1", |t| t.trial.to_string()),
    column("reached_goal", "true, or false when the trial was capped", |t| {
        t.reached_goal.to_string()
    }),
    column("steps", "control steps taken", |t| t.steps.to_string()),
    column("total_reinforcement", "R(n), Eq. (5.27); undefined for a capped trial", |t| {
        t.total_reinforcement.to_string()
    }),
    column("regret", "what the best path a planner finds earns more than R(n)", |t| {
        optional(t.regret.as_ref())
    }),
    column("safety", "share of R(n) from f1, Eq. (5.6)", |t| t.safety.to_string()),
    column("goal", "share of R(n) from f2, Eq. (5.7)", |t| t.goal.to_string()),
    column("record", "beat every earlier successful trial", |t| t.record.to_string()),
    column("collisions", "real and virtual collisions", |t| t.collisions.to_string()),
    column("neurons", "neurons after the trial", |t| t.neurons.to_string()),
    column("born", "neurons added", |t| t.born.to_string()),
    column("forgotten", "neurons deleted at its end", |t| t.forgotten.to_string()),
    column("temperature_deg", "temperature T(n)", |t| t.temperature_deg.to_string()),
    column("path_m", "length of the true path", |t| t.path_m.to_string()),
    column("first_tick", "first tick of the trial", |t| t.first_tick.to_string()),
    column("last_tick", "last tick of the trial", |t| t.last_tick.to_string()),
    column("scout", "a scout set out in it (A6)", |t| t.scout.to_string()),
    column("true_goal", "what goal would be, had the robot known where it was", |t| {
        optional(t.true_goal)
    }),
];

const TICK_COLUMNS: [Column<TickView>; 53] = [
    column("tick", "control step of the session, from 1", |t| t.tick.to_string()),
    column("trial", "trial, from 1", |t| t.trial.to_string()),
    column("step", "control step of the trial, from 1", |t| t.step.to_string()),
    column("true_x_m", "true position when sensing", |t| t.true_pose.x_m.to_string()),
    column("true_y_m", "true position when sensing", |t| t.true_pose.y_m.to_string()),
    column("true_heading_deg", "true heading, counter-clockwise from the x axis", |t| {
        t.true_pose.heading_deg.to_string()
    }),
    column("x_m", "believed position", |t| t.pose.x_m.to_string()),
    column("y_m", "believed position", |t| t.pose.y_m.to_string()),
    column("heading_deg", "believed heading", |t| t.pose.heading_deg.to_string()),
    column("goal_distance_m", "believed distance to the goal", |t| t.goal_distance_m.to_string()),
    column("goal_bearing_deg", "believed bearing of the goal from the heading", |t| {
        t.goal_bearing_deg.to_string()
    }),
    column("reflectance_pct", "strongest infrared reflectance", |t| t.reflectance_pct.to_string()),
    column("region", "region the robot believes to be in", |t| t.region.clone()),
    column("winner", "nearest neuron of the region's network, Eq. (5.10)", |t| {
        optional(t.winner.map(|winner| winner.neuron))
    }),
    column("distance", "its distance ||x - c||", |t| optional(t.winner.map(|w| w.distance))),
    column("born", "neuron added at this situation", |t| optional(t.born)),
    column("reflex_rotation_deg", "rotation of the reflex, when it was asked", |t| {
        optional(t.reflex.map(|reflex| reflex.rotation_deg))
    }),
    column("source", "network, reflex, bend, pursuit, sidestep, escape or scout", |t| {
        t.source.clone()
    }),
    column("neuron", "neuron in charge", |t| optional(t.neuron)),
    column("utility", "its utility u", |t| optional(t.utility)),
    column("prototypical_deg", "its prototypical action p", |t| t.prototypical_deg.to_string()),
    column("temperature_deg", "temperature T(n)", |t| t.exploration.temperature_deg.to_string()),
    column("mean_deg", "mean of the draw", |t| t.exploration.mean_deg.to_string()),
    column("sigma_deg", "sigma = T(n) / (1 + exp(u))", |t| t.exploration.sigma_deg.to_string()),
    column("deviation_deg", "standard deviation of the draw", |t| {
        t.exploration.deviation_deg.to_string()
    }),
    column("drawn_deg", "xi as drawn", |t| t.exploration.drawn_deg.to_string()),
    column("most_deg", "most that xi may be: T(n), or |mean| along a shortcut (A11)", |t| {
        optional(t.exploration.most_deg)
    }),
    column("xi_deg", "xi clipped to that", |t| t.exploration.xi_deg.to_string()),
    column("action_deg", "action alpha, Eq. (5.15)", |t| t.action_deg.to_string()),
    column("action_frame", "frame of p and alpha", |t| t.action_frame.clone()),
    column("rotation_deg", "rotation before the advance", |t| t.rotation_deg.to_string()),
    column("end_true_x_m", "true position after the motion", |t| {
        t.outcome.true_pose.x_m.to_string()
    }),
    column("end_true_y_m", "true position after the motion", |t| {
        t.outcome.true_pose.y_m.to_string()
    }),
    column("contact", "none, virtual (infrared) or real (tactile)", |t| t.outcome.contact.clone()),
    column("backed_m", "way backed off", |t| t.outcome.backed_m.to_string()),
    column("close", "close flag of Eq. (5.6)", |t| t.outcome.close.to_string()),
    column("reinforcement", "r = f1 + f2", |t| t.outcome.reinforcement.to_string()),
    column("safety", "f1, Eq. (5.6)", |t| t.outcome.safety.to_string()),
    column("goal", "f2, Eq. (5.7)", |t| t.outcome.goal.to_string()),
    column("total_reinforcement", "of the trial so far", |t| t.total_reinforcement.to_string()),
    column("reached_goal", "the robot is at the goal", |t| t.outcome.reached_goal.to_string()),
    column("adaptation", "what happened to the past neuron, section 5.9", |t| {
        adaptation(&t.adaptation).kind.into()
    }),
    column("past_neuron", "the past neuron", |t| optional(adaptation(&t.adaptation).past)),
    column("delta", "temporal-difference error, Eq. (5.19)", |t| {
        optional(adaptation(&t.adaptation).delta)
    }),
    column("utility_after", "utility of the past neuron after it", |t| match &t.adaptation {
        AdaptationView::Updated { utility_after, .. } => utility_after.to_string(),
        _ => String::new(),
    }),
    column("mean_after_deg", "mean of the past neuron after it", |t| match &t.adaptation {
        AdaptationView::Updated { mean_after_deg, .. } => mean_after_deg.to_string(),
        _ => String::new(),
    }),
    column("split_added", "neuron added by error-driven growth", |t| match &t.adaptation {
        AdaptationView::Split { added, .. } => added.to_string(),
        _ => String::new(),
    }),
    column("neurons", "neurons after this tick", |t| t.neurons.to_string()),
    column("odometry_x_m", "position by odometry alone, where it is corrected (A10)", |t| {
        optional(t.fix.map(|fix| fix.odometry.x_m))
    }),
    column("odometry_y_m", "position by odometry alone", |t| {
        optional(t.fix.map(|fix| fix.odometry.y_m))
    }),
    column("odometry_heading_deg", "heading by odometry alone", |t| {
        optional(t.fix.map(|fix| fix.odometry.heading_deg))
    }),
    column("fix_echoes", "echoes that agreed with what was heard there before", |t| {
        optional(t.fix.map(|fix| fix.echoes))
    }),
    column("fix_spread_m", "standard deviation of the believed position", |t| {
        optional(t.fix.map(|fix| fix.spread_m))
    }),
];

/// What every kind of adaptation has in common.
struct Adaptation {
    kind: &'static str,
    past: Option<u32>,
    delta: Option<f64>,
}

fn adaptation(view: &AdaptationView) -> Adaptation {
    let (kind, past, delta) = match view {
        AdaptationView::NoPast => ("no-past", None, None),
        AdaptationView::Off => ("off", None, None),
        AdaptationView::Pending { past } => ("pending", Some(*past), None),
        AdaptationView::Split { past, delta, .. } => ("split", Some(*past), Some(*delta)),
        AdaptationView::Updated { past, delta, .. } => ("updated", Some(*past), Some(*delta)),
    };
    Adaptation { kind, past, delta }
}

fn optional(value: Option<impl ToString>) -> String {
    value.map(|value| value.to_string()).unwrap_or_default()
}

fn row<Row>(columns: &[Column<Row>], row: &Row) -> Vec<String> {
    columns.iter().map(|column| (column.value)(row)).collect()
}

/// One line of cells.
#[must_use]
pub fn line(cells: &[String]) -> String {
    let cells: Vec<String> = cells.iter().map(|cell| quoted(cell)).collect();
    cells.join(",") + "\r\n"
}

/// RFC 4180: a cell with a comma, a quote or a line break stands in quotes, its own quotes doubled.
fn quoted(cell: &str) -> String {
    if cell.contains([',', '"', '\r', '\n']) {
        format!("\"{}\"", cell.replace('"', "\"\""))
    } else {
        cell.to_owned()
    }
}
