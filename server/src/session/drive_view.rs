//! What the core says of chapter 2, as it travels: radians become degrees, indices become names.

use sonarium_core::experiment::{
    ApproachEnd, ApproachRun, Contact, Cycle, NavigationRun, RegionState, RunEnd,
};
use sonarium_core::fuzzy::{
    Consequent, Explained, Firing, Input, NamedSet, Output, RuleBase, Shape,
};
use sonarium_core::geometry::Vec2;
use sonarium_core::perception::{Consistency, Hashing, Method};
use sonarium_core::robot::{Body, Mount, Robot};
use sonarium_core::settings::{Field, Kind, Value};
use sonarium_core::stats::Estimate;
use sonarium_core::world::{Arena, PERSON_RADIUS_M, Passage, Surface};

use crate::wire::{
    BumpView, CourseView, CycleView, DoorView, DriveOutcome, DriveRunView, DriveScore, DriveScores,
    FaceView, FiringView, InferenceView, IntervalView, MeasureView, MethodScoreView, MethodSummary,
    MethodView, PoseView, ReadingView, RegionDepthView, RuleBaseView, RuleList, RuleView, SetView,
    SonarView, VariableView,
};

/// Rules that fire and travel with a cycle.
const STRONGEST: usize = 12;

fn number(index: usize) -> u32 {
    u32::try_from(index).unwrap_or(u32::MAX)
}

/// A method's name as its setting has it.
pub(super) fn name(method: Method) -> String {
    match method.to_value() {
        Value::Choice(name) => name,
        other => other.to_string(),
    }
}

pub(super) fn cycle(cycle: &Cycle, tick: u64, round: u32, rules: Option<&RuleBase>) -> CycleView {
    let inference = cycle.inference.as_ref().zip(rules);
    CycleView {
        tick,
        round,
        run: cycle.run,
        cycle: cycle.cycle,
        time_s: cycle.time_s,
        method: name(cycle.method),
        pose: PoseView::from(cycle.pose),
        speed_m_s: cycle.speed.v_m_s,
        turn_deg_s: cycle.speed.w_rad_s.to_degrees(),
        compass_deg: cycle.compass_rad.to_degrees(),
        motor_load: cycle.motor_load,
        readings: cycle
            .readings
            .iter()
            .map(|of| ReadingView { range_m: of.range_m, echo: of.echo.name().into() })
            .collect(),
        regions: cycle.regions.iter().map(region).collect(),
        inference: inference.map(|(explained, rules)| infer(explained, rules, cycle)),
        command_m_s: cycle.command.v_m_s,
        command_deg_s: cycle.command.w_rad_s.to_degrees(),
        bump: cycle.bump.map(|bump| BumpView {
            what: contact(bump.contact).into(),
            time_s: bump.time_s,
            front: bump.front,
        }),
        backing_off: cycle.backing_off,
        clearance_m: cycle.clearance_m,
        people_m: cycle.people.iter().map(|person| [person.place.x, person.place.y]).collect(),
        blind: cycle.blind.map(number),
    }
}

fn contact(contact: Contact) -> &'static str {
    match contact {
        Contact::Surface(of) => surface(of),
        Contact::Person => "person",
    }
}

fn surface(of: Surface) -> &'static str {
    match of {
        Surface::Wall => "wall",
        Surface::Door => "door",
        Surface::Block => "block",
    }
}

fn region(state: &RegionState) -> RegionDepthView {
    let depth = state.depth;
    RegionDepthView {
        live: depth.map_or(0, |depth| number(depth.live)),
        depths_m: depth.map(|depth| depth.depths_m.to_vec()).unwrap_or_default(),
        sigma_m: depth.map(|depth| depth.deviation_m),
        walk_sigma_m: depth.map(|depth| depth.walk_deviation_m),
        truth_m: state.truth_m,
        nis: depth.and_then(|depth| depth.nis),
        nees: state.nees,
    }
}

fn infer(explained: &Explained, rules: &RuleBase, cycle: &Cycle) -> InferenceView {
    let depths = cycle.regions.iter().filter_map(|region| region.depth);
    let depths = depths.map(|depth| depth.by(cycle.method));
    let mut memberships = Vec::new();
    let mut rest = explained.memberships.as_slice();
    for input in rules.inputs() {
        let (mine, others) = rest.split_at(input.sets.len().min(rest.len()));
        memberships.push(mine.to_vec());
        rest = others;
    }
    InferenceView {
        inputs: depths.chain([cycle.speed.v_m_s * 100.0]).collect(),
        memberships,
        fired: number(explained.firings.len()),
        firings: explained.firings.iter().take(STRONGEST).map(|of| firing(of, rules)).collect(),
        outputs: explained.outputs[..rules.outputs().len()].to_vec(),
    }
}

fn firing(firing: &Firing, rules: &RuleBase) -> FiringView {
    let RuleView { rule, when, then, because } = rule(rules, firing.rule);
    FiringView { rule, strength: firing.strength, when, then, because }
}

fn rule(rules: &RuleBase, index: usize) -> RuleView {
    let of = &rules.rules()[index];
    let sets = rules.inputs().iter().zip(&of.when);
    RuleView {
        rule: number(index),
        when: sets.map(|(input, set)| input.sets[*set].name.clone()).collect(),
        then: of.then.iter().zip(rules.outputs()).map(|(then, of)| value(*then, of)).collect(),
        because: of.because.clone(),
    }
}

/// The number that a consequent stands for: of a set, the middle of where it holds wholly.
fn value(consequent: Consequent, output: &Output) -> f64 {
    match consequent {
        Consequent::Value(value) => value,
        Consequent::Set(set) => {
            let [_, from, to, _] = output.sets[set].set.corners();
            0.5 * (from.max(output.range[0]) + to.min(output.range[1]))
        }
    }
}

pub(super) fn approach(end: &ApproachEnd) -> DriveOutcome {
    DriveOutcome::Approach {
        true_variation_m: end.true_variation_m,
        haunted_pct: 100.0 * end.haunted,
        scores: end
            .scores
            .iter()
            .map(|score| MethodScoreView {
                method: name(score.method),
                rms_m: score.rms_m,
                r2: score.r2,
                variation_m: score.variation_m,
                rise_m: score.rise_m,
                jump_m: score.jump_m,
            })
            .collect(),
    }
}

pub(super) fn drive(end: &RunEnd) -> DriveOutcome {
    DriveOutcome::Drive(Box::new(DriveScore {
        time_s: end.time_s,
        done: end.done,
        progress_m: end.progress_m,
        path_m: end.path_m,
        forward_m_s: end.forward_m_s,
        straightness: end.straightness,
        heading_rms_deg: end.heading_rms_deg,
        speed_m_s: end.speed_m_s,
        slow_pct: 100.0 * end.slow,
        reverse_pct: 100.0 * end.reverse,
        flips_per_min: end.flips_per_min,
        turn_deg_s: end.turn_deg_s,
        wall_contacts: end.wall_contacts,
        door_contacts: end.door_contacts,
        block_contacts: end.block_contacts,
        people_contacts: end.people_contacts,
        doors: end.doors,
        clean_doors: end.clean_doors,
        clearance_m: end.clearance_m,
        nis: end.nis.mean(),
        nees: end.nees.mean(),
        blind: end.blind.map(number),
    }))
}

/// A measure of a controlled run: its name, its unit and how it is taken.
type Measure<Of> = (&'static str, &'static str, fn(&Of) -> f64);

const DRIVEN: [Measure<DriveScore>; 13] = [
    ("progress", "m", |of| of.progress_m),
    ("time", "s", |of| of.time_s),
    ("velocity", "m/s", |of| of.speed_m_s),
    ("straightness", "", |of| of.straightness),
    ("heading, RMS", "deg", |of| of.heading_rms_deg),
    ("changes of side", "1/min", |of| of.flips_per_min),
    ("mean turn", "deg/s", |of| of.turn_deg_s),
    ("backing up", "%", |of| of.reverse_pct),
    ("wall contacts", "", |of| f64::from(of.wall_contacts)),
    ("door contacts", "", |of| f64::from(of.door_contacts)),
    ("block contacts", "", |of| f64::from(of.block_contacts)),
    ("people contacts", "", |of| f64::from(of.people_contacts)),
    ("doors passed", "", |of| f64::from(of.doors)),
];

const APPROACHED: [Measure<MethodScoreView>; 5] = [
    ("RMS error", "m", |of| of.rms_m),
    ("straightness R²", "", |of| of.r2),
    ("total variation", "m", |of| of.variation_m),
    ("rise", "m", |of| of.rise_m),
    ("greatest jump", "m", |of| of.jump_m),
];

/// Over the runs that no operator changed; `ends` and `doors` say whether the way has an end and doors.
pub(super) fn scores(done: &[DriveRunView], ends: bool, doors: bool) -> DriveScores {
    let measures: Vec<Measure<DriveScore>> = DRIVEN
        .into_iter()
        .filter(|(name, ..)| match *name {
            "doors passed" | "door contacts" => doors,
            "people contacts" | "heading, RMS" | "progress" | "straightness" => ends,
            "block contacts" => !ends,
            _ => true,
        })
        .collect();
    let mut driven: Vec<(String, Vec<&DriveScore>)> = Vec::new();
    let mut approached: Vec<(String, Vec<&MethodScoreView>)> = Vec::new();
    for run in done.iter().filter(|run| run.interventions.is_empty()) {
        match &run.outcome {
            DriveOutcome::Drive(score) => add(&mut driven, &run.method, score),
            DriveOutcome::Approach { scores, .. } => {
                scores.iter().for_each(|score| add(&mut approached, &score.method, score));
            }
        }
    }
    let of_drives = driven.iter().map(|(method, runs)| MethodSummary {
        done: ends.then(|| number(runs.iter().filter(|run| run.done).count())),
        ..summary(method, runs, &measures)
    });
    let of_approaches = approached.iter().map(|(method, runs)| summary(method, runs, &APPROACHED));
    let methods: Vec<MethodSummary> = of_drives.chain(of_approaches).collect();
    DriveScores { runs_done: methods.iter().map(|of| of.n).min().unwrap_or(0), methods }
}

fn add<'a, Of>(methods: &mut Vec<(String, Vec<&'a Of>)>, method: &str, score: &'a Of) {
    match methods.iter_mut().find(|(name, _)| name == method) {
        Some((_, scores)) => scores.push(score),
        None => methods.push((method.to_owned(), vec![score])),
    }
}

fn summary<Of>(method: &str, runs: &[&Of], measures: &[Measure<Of>]) -> MethodSummary {
    let measure = |(name, unit, of): &Measure<Of>| {
        let sample: Vec<f64> = runs.iter().map(|run| of(run)).collect();
        let interval = Estimate::mean(&sample);
        MeasureView {
            name: (*name).into(),
            unit: (*unit).into(),
            mean: sonarium_core::stats::mean(&sample).unwrap_or(f64::NAN),
            interval: interval.map(|of| IntervalView {
                value: of.value,
                low: of.low,
                high: of.high,
            }),
        }
    };
    MethodSummary {
        method: method.to_owned(),
        n: number(runs.len()),
        done: None,
        measures: measures.iter().map(measure).collect(),
    }
}

/// What a course is made of.
pub(super) struct Stage<'a> {
    arena: &'a Arena,
    hashing: &'a Hashing,
    mounts: &'a [Mount],
    body: Body,
    doors: &'a [Passage],
    finish_m: Option<f64>,
    rules: Option<&'a RuleBase>,
}

impl<'a> Stage<'a> {
    pub(super) fn of_approach(run: &'a ApproachRun, robot: &'a Robot) -> Self {
        Self {
            arena: run.arena(),
            hashing: run.hashing(),
            mounts: robot.sonars(),
            body: robot.body(),
            doors: &[],
            finish_m: None,
            rules: None,
        }
    }

    pub(super) fn of_drive(run: &'a NavigationRun) -> Self {
        Self {
            arena: run.arena(),
            hashing: run.hashing(),
            mounts: run.mounts(),
            body: run.body(),
            doors: run.doors(),
            finish_m: run.finish_m(),
            rules: Some(run.rules()),
        }
    }
}

pub(super) fn course(stage: Stage<'_>, robot: &Robot) -> CourseView {
    let scanner = robot.equipment().map(|equipment| &equipment.scanner);
    let ends = |a: Vec2, b: Vec2| [a.x, a.y, b.x, b.y];
    let (low, high) = Consistency::bounds(1);
    CourseView {
        kind: String::new(),
        title: String::new(),
        bounds_m: stage.arena.bounds_m(),
        faces: stage
            .arena
            .faces()
            .iter()
            .map(|face| FaceView {
                segment_m: ends(face.segment.a, face.segment.b),
                surface: surface(face.surface).into(),
            })
            .collect(),
        robot_corners_m: stage.body.corners().iter().map(|corner| [corner.x, corner.y]).collect(),
        sonars: stage.mounts.iter().map(SonarView::from).collect(),
        half_cone_deg: scanner.map_or(15.0, |scanner| 0.5 * scanner.cone_deg),
        sonar_range_m: scanner.map_or(2.0, |scanner| scanner.range_m),
        regions: stage
            .hashing
            .regions()
            .iter()
            .map(|members| members.iter().map(|sonar| number(*sonar)).collect())
            .collect(),
        methods: methods(),
        drivers: Vec::new(),
        doors: stage
            .doors
            .iter()
            .map(|door| DoorView { x_m: door.x_m, half_width_m: door.half_width_m })
            .collect(),
        finish_m: stage.finish_m,
        person_radius_m: PERSON_RADIUS_M,
        chi_square: [low, high],
        rules: stage.rules.map(rule_base),
    }
}

fn methods() -> Vec<MethodView> {
    let Kind::Choice(names) = Method::kind(None) else { return Vec::new() };
    let view = |(name, meaning): &(&str, &str)| MethodView {
        name: (*name).into(),
        meaning: (*meaning).into(),
    };
    names.iter().map(view).collect()
}

/// A rule base without its rules.
fn rule_base(rules: &RuleBase) -> RuleBaseView {
    RuleBaseView {
        name: rules.name().to_owned(),
        title: rules.title().to_owned(),
        inputs: rules.inputs().iter().map(input).collect(),
        outputs: rules.outputs().iter().map(output).collect(),
        rules: number(rules.rules().len()),
    }
}

fn input(of: &Input) -> VariableView {
    let sets = sets(&of.sets, of.range);
    VariableView { name: of.name.clone(), unit: of.unit.clone(), range: of.range, sets }
}

fn output(of: &Output) -> VariableView {
    let sets = sets(&of.sets, of.range);
    VariableView { name: of.name.clone(), unit: of.unit.clone(), range: of.range, sets }
}

fn sets(sets: &[NamedSet], [low, high]: [f64; 2]) -> Vec<SetView> {
    let view = |of: &NamedSet| SetView {
        name: of.name.clone(),
        corners: of.set.corners().map(|corner| corner.clamp(low, high)),
    };
    sets.iter().map(view).collect()
}

/// A rule base, rule by rule.
#[must_use]
pub fn rule_list(rules: &RuleBase) -> RuleList {
    RuleList {
        base: rule_base(rules),
        rules: (0..rules.rules().len()).map(|index| rule(rules, index)).collect(),
    }
}
