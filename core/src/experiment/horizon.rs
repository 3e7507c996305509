//! The experiment `horizon`: which of the three policies of figure 3.2 is the best, under each model of
//! optimality (figure 3.3).

use crate::tabular::{Chain, Crossing, crossings, first_best};

/// Places that crossings are looked for at, between the bounds of a plot.
const GRID: u32 = 1_000;

crate::settings! {
    /// Settings of the experiment `horizon`.
    pub struct HorizonSettings {
        longest: u32 = 30, "horizon.longest" [1.0, 10_000.0] "step", Reading, "figure 3.3, left", "Longest horizon h of the plot";
        discounts: u32 = 100, "discount.points" [2.0, 10_000.0] "", Reading, "figure 3.3, right", "Values of γ in the plot, evenly from 0";
        largest: f64 = 0.99, "discount.largest" [0.01, 0.999_999] "", Reading, "figure 3.3, right", "Largest γ of the plot";
    }
}

/// A model of optimality, section 3.3.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Model {
    /// Finite horizon, Eq. (3.1); its parameter is h. With one decision to take, at the start, the receding
    /// horizon of Eq. (3.2) decides the same.
    FiniteHorizon,
    /// Discounted sum, Eq. (3.3); its parameter is γ.
    Discounted,
    /// Average reward, Eq. (3.4); it has no parameter.
    Average,
}

/// One point of a plot.
#[derive(Clone, Debug, PartialEq)]
pub struct HorizonStep {
    /// Step of the experiment, from 1.
    pub tick: u64,
    /// Under which model.
    pub model: Model,
    /// h or γ; 0 where there is none.
    pub parameter: f64,
    /// J of each policy.
    pub values: Vec<f64>,
    /// Number of the best, the first of several.
    pub best: usize,
    /// Crossing passed since the last point.
    pub crossing: Option<Crossing>,
}

/// The experiment as a state machine; nothing in it is random.
#[derive(Clone, Debug)]
pub struct HorizonRun {
    settings: HorizonSettings,
    chains: [Chain; 3],
    by_horizon: Vec<Crossing>,
    by_discount: Vec<Crossing>,
    tick: u64,
}

impl HorizonRun {
    /// The experiment from its beginning, or after so many steps.
    #[must_use]
    pub fn new(settings: HorizonSettings, steps_done: u64) -> Self {
        let chains = Chain::figure_3_2();
        let longest = f64::from(settings.longest);
        let by_horizon = crossings(3, (0.0, longest), GRID, |which, h| chains[which].finite(h));
        let by_discount = crossings(3, (0.0, settings.largest), GRID, |which, gamma| {
            chains[which].discounted(gamma)
        });
        Self { settings, chains, by_horizon, by_discount, tick: steps_done }
    }

    /// Points of all plots.
    #[must_use]
    pub fn points(&self) -> u64 {
        u64::from(self.settings.longest) + 1 + u64::from(self.settings.discounts) + 1
    }

    /// The next point; none after the last.
    pub fn step(&mut self) -> Option<HorizonStep> {
        if self.tick >= self.points() {
            return None;
        }
        let horizons = u64::from(self.settings.longest) + 1;
        let (model, index) = match self.tick {
            tick if tick < horizons => (Model::FiniteHorizon, tick),
            tick if tick + 1 < self.points() => (Model::Discounted, tick - horizons),
            _ => (Model::Average, 0),
        };
        self.tick += 1;
        Some(self.point(model, index))
    }

    /// The points so far.
    #[must_use]
    pub fn so_far(&self) -> Vec<HorizonStep> {
        let mut again = Self { tick: 0, ..self.clone() };
        let points = usize::try_from(self.tick).unwrap_or(usize::MAX);
        std::iter::from_fn(|| again.step()).take(points).collect()
    }

    fn point(&self, model: Model, index: u64) -> HorizonStep {
        let parameter = self.parameter(model, index);
        let value = |chain: &Chain| match model {
            Model::FiniteHorizon => chain.finite(parameter),
            Model::Discounted => chain.discounted(parameter),
            Model::Average => chain.average(),
        };
        let values: Vec<f64> = self.chains.iter().map(value).collect();
        let before = if index == 0 { parameter } else { self.parameter(model, index - 1) };
        let passed = |crossing: &&Crossing| before < crossing.at && crossing.at <= parameter;
        HorizonStep {
            tick: self.tick,
            model,
            parameter,
            best: first_best(values.len(), |which| values[which]),
            values,
            crossing: self.crossings(model).iter().find(passed).copied(),
        }
    }

    #[expect(clippy::cast_precision_loss, reason = "at most 10 000 points")]
    fn parameter(&self, model: Model, index: u64) -> f64 {
        match model {
            Model::FiniteHorizon => index as f64,
            Model::Discounted => {
                self.settings.largest * index as f64 / f64::from(self.settings.discounts - 1)
            }
            Model::Average => 0.0,
        }
    }

    /// Where the best policy changes.
    #[must_use]
    pub fn crossings(&self, model: Model) -> &[Crossing] {
        match model {
            Model::FiniteHorizon => &self.by_horizon,
            Model::Discounted => &self.by_discount,
            Model::Average => &[],
        }
    }

    /// The policies.
    #[must_use]
    pub fn chains(&self) -> &[Chain] {
        &self.chains
    }

    /// Steps done; with them alone the run can go on.
    #[must_use]
    pub fn tick(&self) -> u64 {
        self.tick
    }
}
