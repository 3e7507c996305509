//! The page's types, generated from the wire types.

use ts_rs::{Config, TS};

use super::*;

/// Everything the page may receive or send, as TypeScript declarations in a fixed order.
///
/// Whole numbers of 64 bits become `number`: ticks and seeds stay below 2⁵³.
#[must_use]
pub fn typescript() -> String {
    let config = Config::new().with_large_int("number");
    let mut text = String::from(HEADER);
    for declaration in declarations(&config) {
        text.push('\n');
        text.push_str(&declaration);
    }
    text
}

const HEADER: &str = "\
// Generated from server/src/wire/*.rs, do not edit. To write it again:
//   UPDATE_PROTOCOL=1 cargo test -p sonarium --lib wire
";

macro_rules! declare {
    ($config:ident: $($name:ty),* $(,)?) => { vec![$(declaration::<$name>($config)),*] };
}

fn declarations(config: &Config) -> Vec<String> {
    declare!(config:
        ExperimentInfo, RobotInfo, PresetInfo, WorldInfo, SettingInfo, Choice,
        State, Family, Speed, NamedSpeed, NewSession, Session, Ack, StepRequest, StepUnit, SpeedRequest,
        Trial, Summary, RunResult, Yardstick, PlannedPath, Problem,
        PoseView, TickView, FixView, WinnerView, ReflexView, ExplorationView, AdaptationView, OutcomeView,
        NeuronView, BirthView, TrialEndView, ChangeView, AimView, ProposalView, VerdictView,
        StartView, AlteredStartView, ExcursionView, NetworkFile, InputSpans, GoalView,
        ServerMessage, Hello, WorldView, SonarView, CurvePoint, LogEntry,
        ClientMessage, ArenaRequest, ThemeName,
        StepView, WalkView, RewardView, UpdateView, TableTrialView, PullView, PointView, CrossingView,
        EpisodeView, OutcomeOfEpisode, InterventionView, ScoresView, ScoreView, IntervalView,
        CompetitorCurve, TableView, LearnerView, PlanningView, ModelView, BackupView, QueueView,
        AdviceView, BanditView, HorizonView, TaskView, StateView, TransitionView, FeatureView, PolicyView,
        CycleView, ReadingView, RegionDepthView, InferenceView, FiringView, BumpView, DriveRunView,
        DriveOutcome, MethodScoreView, DriveScore, DriveScores, MethodSummary, MeasureView, CourseView,
        FaceView, MethodView, DoorView, RuleBaseView, VariableView, SetView, RuleList, RuleView, DriveResult,
        MethodRequest, SonarRequest,
        CalibrationQuestion, CalibrationPlace, CalibrationView, CalibratedSetting,
        GaussianView, LostAtSea, TableResult, AdviceRequest, TableRequest, TableFile,
        ReproductionTarget, ReproductionArm, ReproductionProgress, ReproductionState,
        Reproduction, ReproductionRow, Verdict, ReproductionCurve, ReproductionPoint,
        ReproductionPicture,
        WorldFile, WorldRegion, WorldRule, AxisName, WorldHome, WorldGoal, PlaceView, WorldProblem,
        WorldSummary, WorldCheck, RegionShape, RegionProposal, TraceRequest, TraceDraft, MapPicture,
    )
}

fn declaration<T: TS>(config: &Config) -> String {
    let docs = T::docs().unwrap_or_default();
    compact_docs(&format!("{docs}export {}\n", T::decl(config)))
}

/// Puts the marks of a doc comment beside its text; ts-rs gives each a line of its own.
fn compact_docs(declaration: &str) -> String {
    declaration.replace(" \n", "\n").replace("/**\n * ", "/** ").replace("\n */", " */")
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    const PROTOCOL: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../web/src/lib/protocol.ts");

    #[test]
    fn the_page_s_types_are_up_to_date() {
        let path = Path::new(PROTOCOL);
        if std::env::var_os("UPDATE_PROTOCOL").is_some() {
            std::fs::write(path, typescript()).expect("web/src/lib can be written");
        }
        let stored = std::fs::read_to_string(path).unwrap_or_default();
        assert!(
            stored == typescript(),
            "web/src/lib/protocol.ts is stale; write it again with \
             `UPDATE_PROTOCOL=1 cargo test -p sonarium --lib wire`"
        );
    }

    #[test]
    fn whole_numbers_are_numbers_and_never_bigints() {
        assert!(!typescript().contains("bigint"));
        assert!(typescript().contains("tick: number"));
    }
}
