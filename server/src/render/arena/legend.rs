//! The legend: one line for each kind of mark that occurs in the picture.

use super::layout::SYMBOL;
use super::marks::{believed_dash, differs, nose};
use super::paths::MOST_GHOSTS;
use super::{Canvas, rimmed_stroke};
use crate::render::scene::{Anchor, Point, Primitive, Scene, Stroke, Text};
use crate::render::text::CAP_HEIGHT;
use crate::render::view::ArenaView;

/// A line of the legend.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Entry {
    pub(super) symbol: Symbol,
    pub(super) label: String,
}

/// What stands before a label.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Symbol {
    Path,
    Best,
    Planned,
    Ghosts,
    Collision,
    Robot,
    Believed,
    Cone,
    Neuron,
    Winner,
    Pending,
    Utility,
}

/// The lines this view needs.
pub(super) fn entries(view: &ArenaView) -> Vec<Entry> {
    let robot = view.robot.as_ref();
    let neurons = &view.neurons;
    let ghosts = view.earlier_paths_m.len();
    let earlier = if ghosts > MOST_GHOSTS {
        format!("latest {MOST_GHOSTS} of {ghosts} earlier trials")
    } else {
        "earlier trials".to_owned()
    };
    let text = str::to_owned;
    [
        (view.path_m.len() > 1, Symbol::Path, text(view.path_of.this())),
        (view.best_path_m.len() > 1, Symbol::Best, text("best trial")),
        (view.planned_path_m.len() > 1, Symbol::Planned, text("planned path")),
        (ghosts > 0, Symbol::Ghosts, earlier),
        (!view.collisions_m.is_empty(), Symbol::Collision, text("collision")),
        (robot.is_some(), Symbol::Robot, text("robot")),
        (robot.is_some_and(differs), Symbol::Believed, text("believed pose")),
        (robot.is_some_and(|r| !r.sonar_m.is_empty()), Symbol::Cone, text("sonar reading")),
        (!neurons.is_empty(), Symbol::Neuron, text("neuron, prototypical action")),
        (neurons.iter().any(|n| n.winner), Symbol::Winner, text("winner")),
        (neurons.iter().any(|n| n.utility.is_none()), Symbol::Pending, text("utility pending")),
        (
            neurons.iter().any(|n| n.utility.is_some()),
            Symbol::Utility,
            text("utility, worst to best"),
        ),
    ]
    .into_iter()
    .filter(|(occurs, ..)| *occurs)
    .map(|(_, symbol, label)| Entry { symbol, label })
    .collect()
}

/// Draws the legend where the layout has put it.
pub(super) fn draw(canvas: &Canvas<'_>, entries: &[Entry], scene: &mut Scene) {
    let layout = canvas.layout;
    let Some(legend) = layout.legend else { return };
    let lines = entries.len().div_ceil(legend.columns);
    for (index, entry) in entries.iter().enumerate() {
        let (column, line) = (index / lines, index % lines);
        let x = legend.at[0] + column as f32 * legend.column_px;
        let y = legend.at[1] + (line as f32 + 0.5) * layout.line_px();
        let (from, to) = (x, x + layout.font * SYMBOL);
        canvas.symbol(scene, entry.symbol, [from, y], [to, y]);
        scene.push(Primitive::Text(Text {
            at: [to + layout.font * 0.7, y + layout.font * CAP_HEIGHT / 2.0],
            text: entry.label.clone(),
            size: layout.font,
            anchor: Anchor::Start,
            colour: canvas.theme.ink,
            halo: None,
        }));
    }
}

impl Canvas<'_> {
    fn symbol(&self, scene: &mut Scene, symbol: Symbol, from: Point, to: Point) {
        let (theme, centre) = (self.theme, [(from[0] + to[0]) / 2.0, from[1]]);
        let line = vec![from, to];
        match symbol {
            Symbol::Path => self.path_symbol(scene, from, to, centre),
            Symbol::Best => scene.push(self.best_line(line)),
            Symbol::Planned => scene.push(self.planned_line(line)),
            Symbol::Ghosts => {
                scene.stroke(line, self.px(1.2), theme.ghost.fade(theme.ghost_opacity[0]));
            }
            Symbol::Collision => self.cross(scene, centre),
            Symbol::Robot => {
                let radius = self.layout.font * 0.5;
                scene.ring(centre, radius, self.px(1.8), theme.robot);
                scene.polygon(nose(centre, 0.0, radius), theme.robot);
            }
            Symbol::Believed => self.believed_symbol(scene, centre),
            Symbol::Cone => self.cone_symbol(scene, from, to),
            Symbol::Neuron => self.neuron_at(scene, centre, Some(0.5), Some(0.0)),
            Symbol::Winner => {
                self.winner_ring(scene, centre);
                self.neuron_at(scene, centre, Some(0.5), None);
            }
            Symbol::Pending => self.neuron_at(scene, centre, None, Some(0.0)),
            Symbol::Utility => self.utility_symbol(scene, from, to),
        }
    }

    fn path_symbol(&self, scene: &mut Scene, from: Point, to: Point, centre: Point) {
        let (colour, ground) = (self.theme.path, self.theme.background);
        rimmed_stroke(scene, vec![from, to], self.px(2.6), colour, ground);
        scene.disc(centre, self.px(3.1), colour);
        scene.disc(centre, self.px(1.5), ground);
    }

    fn believed_symbol(&self, scene: &mut Scene, centre: Point) {
        let (radius, width) = (self.layout.font * 0.55, self.px(1.6));
        let point = |i: u8| super::marks::toward(centre, f32::from(i) * 0.2618, radius);
        scene.push(Primitive::Stroke(Stroke {
            points: (0..24).map(point).collect(),
            width,
            colour: self.theme.robot,
            dash: Some(believed_dash(width)),
            closed: true,
        }));
    }

    fn cone_symbol(&self, scene: &mut Scene, from: Point, to: Point) {
        let (reach, turn) = (to[0] - from[0], [-0.19, 0.38]);
        scene.arc(from, [0.0, reach], turn, self.theme.cone.fade(0.22));
        let inner = reach - self.px(1.8).max(0.9);
        scene.arc(from, [inner, reach], turn, self.theme.cone.fade(0.8));
    }

    fn utility_symbol(&self, scene: &mut Scene, from: Point, to: Point) {
        for step in 0..3_u8 {
            let share = f32::from(step) / 2.0;
            let inset = self.px(5.0);
            let x = from[0] + inset + (to[0] - from[0] - 2.0 * inset) * share;
            self.neuron_at(scene, [x, from[1]], Some(f64::from(share)), None);
        }
    }
}
