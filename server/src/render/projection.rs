//! From the world's metres to the picture's pixels.

use super::scene::Point;

/// Places the world's bounds in a picture: the same scale along both axes, `y` turned downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Projection {
    /// Pixels to the metre.
    pub(super) px_per_m: f64,
    /// Shown part of the world, `[x0, y0, x1, y1]` in metres.
    pub(super) bounds_m: [f64; 4],
    /// Pixel of the corner `(x0, y1)`.
    pub(super) top_left_px: [f64; 2],
}

impl Projection {
    /// Fits the bounds into `[left, top, right, bottom]` pixels, as large as possible, centred.
    pub(super) fn fit(bounds_m: [f64; 4], frame_px: [f64; 4]) -> Self {
        let [left, top, right, bottom] = frame_px;
        let (width_px, height_px) = ((right - left).max(1.0), (bottom - top).max(1.0));
        let (width_m, height_m) = (bounds_m[2] - bounds_m[0], bounds_m[3] - bounds_m[1]);
        let px_per_m = (width_px / width_m).min(height_px / height_m);
        let top_left_px = [
            left + (width_px - width_m * px_per_m) / 2.0,
            top + (height_px - height_m * px_per_m) / 2.0,
        ];
        Self { px_per_m, bounds_m, top_left_px }
    }

    /// The pixel of a place. Places beyond the bounds are pulled to just outside them, so that a
    /// wild estimate shows at the rim and not somewhere in the legend; none if not finite.
    pub(super) fn place(&self, at_m: [f64; 2]) -> Option<Point> {
        let [x0, y0, x1, y1] = self.bounds_m;
        let rim_m = 0.02 * (x1 - x0).max(y1 - y0);
        let x_m = at_m[0].clamp(x0 - rim_m, x1 + rim_m);
        let y_m = at_m[1].clamp(y0 - rim_m, y1 + rim_m);
        let x = self.top_left_px[0] + (x_m - x0) * self.px_per_m;
        let y = self.top_left_px[1] + (y1 - y_m) * self.px_per_m;
        (x.is_finite() && y.is_finite()).then_some([x as f32, y as f32])
    }

    /// The pixels of those places that are finite.
    pub(super) fn places(&self, points_m: &[[f64; 2]]) -> Vec<Point> {
        points_m.iter().filter_map(|&point| self.place(point)).collect()
    }

    /// A path thinned to steps of at least `least_px`; its ends stay.
    pub(super) fn path(&self, points_m: &[[f64; 2]], least_px: f32) -> Vec<Point> {
        let mut kept: Vec<Point> = Vec::new();
        let mut dropped = None;
        for point in points_m.iter().filter_map(|&point| self.place(point)) {
            let near = |last: &Point| super::scene::distance(*last, point) < least_px;
            if kept.last().is_some_and(near) {
                dropped = Some(point);
            } else {
                kept.push(point);
                dropped = None;
            }
        }
        kept.extend(dropped);
        kept
    }

    /// A length in pixels.
    pub(super) fn length(&self, length_m: f64) -> f32 {
        (length_m * self.px_per_m) as f32
    }

    /// The shown bounds in pixels, `[left, top, right, bottom]`.
    pub(super) fn frame(&self) -> [f32; 4] {
        let [left, top] = self.top_left_px;
        let [x0, y0, x1, y1] = self.bounds_m;
        let (right, bottom) = (left + (x1 - x0) * self.px_per_m, top + (y1 - y0) * self.px_per_m);
        [left as f32, top as f32, right as f32, bottom as f32]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_and_centre_fall_where_they_should() {
        // Bounds, frame, place in metres, its pixel.
        for (bounds_m, frame_px, at_m, expected) in [
            ([0.0, 0.0, 2.0, 1.0], [0.0, 0.0, 200.0, 100.0], [0.0, 0.0], [0.0, 100.0]),
            ([0.0, 0.0, 2.0, 1.0], [0.0, 0.0, 200.0, 100.0], [2.0, 1.0], [200.0, 0.0]),
            // A wide frame: centred across, the scale set by the height.
            ([0.0, 0.0, 1.0, 1.0], [0.0, 0.0, 300.0, 100.0], [0.0, 1.0], [100.0, 0.0]),
            // A tall frame with an offset.
            ([-1.0, -1.0, 1.0, 1.0], [10.0, 20.0, 110.0, 320.0], [0.0, 0.0], [60.0, 170.0]),
            ([-1.0, -1.0, 1.0, 1.0], [10.0, 20.0, 110.0, 320.0], [-1.0, 1.0], [10.0, 120.0]),
            // Far beyond the bounds: just outside them.
            ([0.0, 0.0, 1.0, 1.0], [0.0, 0.0, 100.0, 100.0], [9e99, 0.5], [102.0, 50.0]),
        ] {
            let projection = Projection::fit(bounds_m, frame_px);
            assert_eq!(projection.place(at_m), Some(expected), "{at_m:?} in {bounds_m:?}");
        }
    }

    #[test]
    fn places_that_are_no_places_are_left_out() {
        let projection = Projection::fit([0.0, 0.0, 1.0, 1.0], [0.0, 0.0, 10.0, 10.0]);
        assert_eq!(projection.place([f64::NAN, 0.0]), None);
        assert_eq!(projection.places(&[[0.0, f64::NAN], [0.0, 0.0]]), [[0.0, 10.0]]);
    }

    #[test]
    fn dense_paths_are_thinned_and_keep_their_ends() {
        let projection = Projection::fit([0.0, 0.0, 1.0, 1.0], [0.0, 0.0, 100.0, 100.0]);
        let dense: Vec<[f64; 2]> = (0..=50_000).map(|i| [f64::from(i) / 50_000.0, 0.0]).collect();
        let thinned = projection.path(&dense, 2.0);
        assert!((48..=52).contains(&thinned.len()), "{}", thinned.len());
        assert_eq!(thinned.first(), Some(&[0.0, 100.0]));
        assert_eq!(thinned.last(), Some(&[100.0, 100.0]));
    }
}
