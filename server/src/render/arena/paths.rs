//! Paths: those of earlier trials, the best one and the one shown.

use super::{Canvas, rimmed_stroke};
use crate::render::scene::{Point, Primitive, Scene, Stroke, distance};

/// So many earlier trials are drawn at most, the newest.
pub const MOST_GHOSTS: usize = 40;

/// Least distance of two points of a path, pixels.
const STEP_PX: f32 = 2.0;

/// Step dots closer than this would merge into the line.
const LEAST_DOT_GAP: f32 = 7.0;

impl Canvas<'_> {
    /// Earlier trials, the older the fainter.
    pub(super) fn ghosts(&self, scene: &mut Scene) {
        let paths = &self.view.earlier_paths_m;
        let shown = &paths[paths.len().saturating_sub(MOST_GHOSTS)..];
        let [newest, oldest] = self.theme.ghost_opacity;
        for (index, path) in shown.iter().enumerate() {
            let age = (shown.len() - 1 - index) as f32 / shown.len().max(8) as f32;
            let opacity = oldest + (newest - oldest) * (1.0 - age).powi(2);
            let points = self.at.path(path, STEP_PX);
            if points.len() > 1 {
                scene.stroke(points, self.px(1.2).max(0.7), self.theme.ghost.fade(opacity));
            }
        }
    }

    /// The best trial, dashed so that it is known without its colour.
    pub(super) fn best_path(&self, scene: &mut Scene) {
        let points = self.at.path(&self.view.best_path_m, STEP_PX);
        if points.len() < 2 {
            return;
        }
        scene.push(self.best_line(points));
    }

    pub(super) fn best_line(&self, points: Vec<Point>) -> Primitive {
        let width = self.px(2.2).max(1.1);
        // Round caps take from the gaps.
        let dash = Some([3.2 * width, 3.0 * width]);
        Primitive::Stroke(Stroke { points, width, colour: self.theme.best, dash, closed: false })
    }

    /// The planned path, dotted.
    pub(super) fn planned_path(&self, scene: &mut Scene) {
        let points = self.at.path(&self.view.planned_path_m, STEP_PX);
        if points.len() > 1 {
            scene.push(self.planned_line(points));
        }
    }

    pub(super) fn planned_line(&self, points: Vec<Point>) -> Primitive {
        let width = self.px(2.0).max(1.0);
        // Dashes that are nearly all caps: dots.
        let dash = Some([0.1 * width, 2.4 * width]);
        Primitive::Stroke(Stroke { points, width, colour: self.theme.ink, dash, closed: false })
    }

    /// The trial shown: thicker, with a dot at every step as far as they stay apart.
    pub(super) fn path(&self, scene: &mut Scene) {
        for piece in self.view.path_m.split(|[x, y]| !(x.is_finite() && y.is_finite())) {
            self.piece_of_path(scene, piece);
        }
    }

    fn piece_of_path(&self, scene: &mut Scene, path_m: &[[f64; 2]]) {
        let points = self.at.path(path_m, STEP_PX);
        if points.len() < 2 {
            return;
        }
        let (width, colour) = (self.px(2.6).max(1.3), self.theme.path);
        rimmed_stroke(scene, points, width, colour, self.theme.background.fade(0.7));
        if self.layout.is_thumbnail {
            return;
        }
        for dot in spaced(&self.at.places(path_m), self.px(LEAST_DOT_GAP)) {
            scene.disc(dot, self.px(3.1), colour);
            scene.disc(dot, self.px(1.5), self.theme.background);
        }
    }
}

fn spaced(points: &[Point], least_px: f32) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::new();
    for &point in points {
        if kept.last().is_none_or(|&last| distance(last, point) >= least_px) {
            kept.push(point);
        }
    }
    kept
}
