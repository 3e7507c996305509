//! The figures of chapter 4, against an independent reconstruction of them.

use sonarium_core::labyrinth::{
    Bias, Contestant, ContinualRule, Episode, EpisodeRule, Gain, InsightRule, Labyrinth, continual,
    episodes, gain, matrix, published, table_4_3,
};
use sonarium_core::tabular::Exclusion;

fn run(contestant: &Contestant, count: u32) -> Vec<Episode> {
    let rule = EpisodeRule { exclusion: contestant.exclusion, ..EpisodeRule::default() };
    let beliefs = matrix(contestant.bias, 15, &contestant.readings);
    episodes(&Labyrinth::of_the_thesis(), &beliefs, &rule, 1, 0..count).expect("actions are left")
}

/// Mean gains of the reconstruction over 4,000 episodes, percent, with the tolerance that its own spread
/// allows; the two marked (1,000) are from fewer episodes there.
fn reconstructed(contestant: &Contestant) -> Option<f64> {
    let Contestant { bias, readings, exclusion, .. } = contestant;
    match (bias, exclusion, readings.insight) {
        (Bias::B0, ..) => None,
        (Bias::B10, ..) => Some(21.6),
        (Bias::B11, Exclusion::Strict, _) => Some(21.5),
        (Bias::B11, ..) if readings.lowered < 0.6 => Some(53.8),
        (Bias::B11, ..) => Some(39.4),
        (Bias::B2, _, InsightRule::GoalDirected) => Some(-64.3),
        (Bias::B2, _, InsightRule::West) => Some(-34.4),
        (Bias::B2, _, InsightRule::Away) => Some(49.6),
        (Bias::B2, _, InsightRule::Turns) => None,
        (Bias::B30, ..) => Some(18.4),
        (Bias::B31, ..) => Some(74.2),
    }
}

fn compare(count: u32, tolerance: f64) -> Vec<(Contestant, Gain)> {
    let contestants = table_4_3();
    let unbiased = run(&contestants[0], count);
    let mut gains = Vec::new();
    for contestant in contestants {
        let found = gain(&run(&contestant, count), &unbiased).expect("enough experiments");
        if let Some(expected) = reconstructed(&contestant) {
            // The literal insight biases lose so much that their spread is three times the others'.
            let allowed = if expected < 0.0 { 2.0 * tolerance } else { tolerance };
            let off = (found.mean.value - expected).abs();
            let name = contestant.bias.name();
            assert!(
                off < allowed,
                "{name}, {}: {:.1} for {expected}",
                contestant.reading,
                found.mean.value
            );
        }
        gains.push((contestant, found));
    }
    gains
}

#[test]
fn table_4_3_with_a_few_episodes() {
    let gains = compare(400, 3.0);
    let of =
        |bias: Bias| gains.iter().find(|(contestant, _)| contestant.bias == bias).expect("a row");
    assert!((of(Bias::B10).1.unbiased - 27.04).abs() < 0.5, "J of the unbiased learner");
    // Claims that hold: B31 is the best, and B10 and B31 are published within our spread.
    for bias in [Bias::B10, Bias::B31] {
        let (_, found) = of(bias);
        let published = published(bias).expect("a printed index");
        assert!(found.low - 1.0 < published && published < found.high + 1.0, "{bias:?} {found:?}");
    }
    // Claims that do not: the literal B2 makes the search longer, not shorter.
    assert!(of(Bias::B2).1.mean.high < 0.0);
    let best = gains.iter().map(|(_, gain)| gain.mean.value).fold(0.0, f64::max);
    assert!((best - of(Bias::B31).1.mean.value).abs() < 1e-12);
}

#[test]
#[ignore = "4,000 episodes of eleven biases take a minute without optimisation"]
fn table_4_3_with_all_episodes() {
    compare(4_000, 1.5);
}

#[test]
fn an_unbiased_learner_ends_near_the_shortest_way() {
    let unbiased = run(&table_4_3()[0], 400);
    let last: f64 = unbiased.iter().map(|episode| episode.tail(10)).sum::<f64>() / 400.0;
    // The reconstruction has 5.26; 5 is the shortest.
    assert!((5.0..5.6).contains(&last), "{last}");
    assert!(unbiased.iter().all(|episode| episode.capped == 0));
}

#[test]
fn with_a_terminal_goal_and_no_discount_an_unbiased_learner_never_learns() {
    // All values are 1 and stay so: a random walk, whose expected length is exactly 42.
    let rule = EpisodeRule {
        transport: sonarium_core::tabular::Transport::Terminal,
        ..EpisodeRule::default()
    };
    for (bias, expected) in [(Bias::B0, 42.0), (Bias::B10, 32.0)] {
        let beliefs = matrix(bias, 15, &Default::default());
        let found =
            episodes(&Labyrinth::of_the_thesis(), &beliefs, &rule, 1, 0..200).expect("left");
        let mean = found.iter().map(Episode::index).sum::<f64>() / 200.0;
        assert!((mean - expected).abs() < 1.2, "{bias:?}: {mean}");
        let last = found.iter().map(|episode| episode.tail(10)).sum::<f64>() / 200.0;
        assert!(last > 0.8 * expected, "{bias:?} does not get better: {last}");
    }
}

#[test]
fn continual_learning_does_not_gain_what_was_published() {
    let (first, second) = (Labyrinth::of_the_thesis(), Labyrinth::new(7, 2).expect("differ"));
    let episode = EpisodeRule { cap: 300, ..EpisodeRule::default() };
    let rule = ContinualRule { episode, restart: true };
    let found = continual(&first, &second, &rule, 1, 0..400).expect("nothing is excluded");
    let scratch: Vec<Episode> = found.iter().map(|c| c.scratch.clone()).collect();
    let later: Vec<Episode> = found.iter().map(|c| c.continual.clone()).collect();
    let gained = gain(&later, &scratch).expect("enough experiments");
    // The reconstruction has +1.5 % over 1,000 episodes, between -21.9 and 20.0; printed is 31.9 %.
    assert!((gained.mean.value - 1.5).abs() < 4.0, "{gained:?}");
    assert!(gained.high < 31.9, "{gained:?}");
}
