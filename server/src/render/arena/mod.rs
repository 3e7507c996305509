//! The picture of an arena: what is drawn, and in which order.
//!
//! From back to front: region tints, sonar cones, goal, ghost paths, planned and best path, path shown,
//! walls, home, neurons, collisions, the robot, the winner (it often lies under the robot); a mat
//! around the arena that hides what sticks out; names, caption, scale bar and legend.
//!
//! Long sessions stay quick and readable: paths are thinned to steps of about 2 px, and only the
//! newest [`MOST_GHOSTS`] earlier trials are drawn, fading with age; the legend says so.

mod labels;
mod layout;
mod legend;
mod marks;
mod paths;

use super::projection::Projection;
use super::scene::{Colour, Point, Scene};
use super::theme::Theme;
use super::view::ArenaView;
use crate::wire::ThemeName;
use layout::Layout;
pub use paths::MOST_GHOSTS;

/// Composes the picture of an arena.
pub fn scene(view: &ArenaView, width: u32, height: u32, theme: ThemeName) -> Scene {
    let theme = Theme::of(theme);
    let entries = legend::entries(view);
    let layout = Layout::plan(view, &entries, width, height);
    let mut scene = Scene::new(width, height, theme.background);
    let canvas = Canvas { view, theme, layout: &layout, at: layout.projection };
    canvas.regions(&mut scene);
    canvas.cones(&mut scene);
    canvas.goal(&mut scene);
    canvas.ghosts(&mut scene);
    canvas.planned_path(&mut scene);
    canvas.best_path(&mut scene);
    canvas.path(&mut scene);
    canvas.walls(&mut scene);
    canvas.home(&mut scene);
    canvas.shell(&mut scene);
    canvas.neurons(&mut scene);
    canvas.collisions(&mut scene);
    canvas.robot(&mut scene);
    canvas.winners(&mut scene);
    canvas.mat(&mut scene);
    canvas.names(&mut scene);
    canvas.caption(&mut scene);
    canvas.scale_bar(&mut scene);
    legend::draw(&canvas, &entries, &mut scene);
    scene
}

/// What every part of the picture needs to know.
struct Canvas<'a> {
    view: &'a ArenaView,
    theme: &'static Theme,
    layout: &'a Layout,
    at: Projection,
}

impl Canvas<'_> {
    /// A length that grows with the picture, given for 960×640.
    fn px(&self, nominal: f32) -> f32 {
        nominal * self.layout.zoom
    }

    fn regions(&self, scene: &mut Scene) {
        for (index, region) in self.view.regions.iter().enumerate() {
            for polygon in &region.polygons_m {
                scene.polygon(self.at.places(polygon), self.theme.region(index));
            }
        }
    }

    fn walls(&self, scene: &mut Scene) {
        let width = self.px(2.2).max(1.0);
        for block in &self.view.blocks_m {
            let outline = self.at.places(block);
            scene.polygon(outline.clone(), self.theme.block);
            scene.outline(outline, self.px(1.6).max(0.8), self.theme.wall);
        }
        for [x0, y0, x1, y1] in &self.view.walls_m {
            let ends = self.at.places(&[[*x0, *y0], [*x1, *y1]]);
            scene.stroke(ends, width, self.theme.wall);
        }
    }

    /// Covers everything around the arena with ground, as the mat of a framed picture does.
    fn mat(&self, scene: &mut Scene) {
        let rim = self.layout.rim_px;
        let [left, top, right, bottom] = self.at.frame();
        // Whole pixels, or what the mat hides would shine through the seams of its strips.
        let (left, top) = ((left - rim).round(), (top - rim).round());
        let (right, bottom) = ((right + rim).round(), (bottom + rim).round());
        let (width, height) = (scene.width as f32, scene.height as f32);
        for strip in [
            [0.0, 0.0, width, top],
            [0.0, bottom, width, height],
            [0.0, top, left, bottom],
            [right, top, width, bottom],
        ] {
            if strip[2] > strip[0] && strip[3] > strip[1] {
                scene.rectangle(strip, self.theme.background);
            }
        }
    }
}

/// A line with a rim of the ground's colour, so that it stays apart from what it crosses.
fn rimmed_stroke(scene: &mut Scene, points: Vec<Point>, width: f32, colour: Colour, rim: Colour) {
    scene.stroke(points.clone(), width * 1.8 + 1.0, rim);
    scene.stroke(points, width, colour);
}
