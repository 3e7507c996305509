//! How far each cell of a grid is from the nearest solid one: the exact distance transform of
//! A. Meijster, J. Roerdink and W. Hesselink, "A general algorithm for computing distance transforms
//! in linear time", 2000.

/// Squared distance from each cell's centre to that of the nearest solid cell, cells². Everything
/// outside the grid is solid.
pub(in crate::world) fn distances2(
    columns: usize,
    rows: usize,
    is_solid: impl Fn(usize) -> bool,
) -> Vec<i64> {
    let along_columns = column_distances(columns, rows, is_solid);
    let mut distances2 = vec![0; columns * rows];
    // One more solid column on either side, which stands for the outside.
    let mut heights = vec![0; columns + 2];
    let mut envelope = Envelope::default();
    for (row, into) in distances2.chunks_exact_mut(columns).enumerate() {
        heights[1..=columns].copy_from_slice(&along_columns[row * columns..(row + 1) * columns]);
        envelope.fill(&heights);
        envelope.read(&heights, into);
    }
    distances2
}

/// Distance of each cell to the nearest solid one in its column, cells.
fn column_distances(columns: usize, rows: usize, is_solid: impl Fn(usize) -> bool) -> Vec<i64> {
    let mut distances = vec![0; columns * rows];
    for column in 0..columns {
        let mut distance = 0;
        for cell in (0..rows).map(|row| row * columns + column) {
            distance = if is_solid(cell) { 0 } else { distance + 1 };
            distances[cell] = distance;
        }
        distance = 0;
        for cell in (0..rows).rev().map(|row| row * columns + column) {
            distance = (distance + 1).min(distances[cell]);
            distances[cell] = distance;
        }
    }
    distances
}

/// The lower envelope of the parabolas `(x − i)² + height(i)²` over a row.
#[derive(Default)]
struct Envelope {
    /// Each parabola on it, and the first place where it is the lowest.
    parts: Vec<(i64, i64)>,
}

impl Envelope {
    fn fill(&mut self, heights: &[i64]) {
        let height2 = |index: i64| heights[index as usize] * heights[index as usize];
        let value = |x: i64, index: i64| (x - index) * (x - index) + height2(index);
        self.parts.clear();
        self.parts.push((0, 0));
        for index in 1..heights.len() as i64 {
            while self.parts.last().is_some_and(|&(part, at)| value(at, part) > value(at, index)) {
                self.parts.pop();
            }
            let Some(&(part, _)) = self.parts.last() else {
                self.parts.push((index, 0));
                continue;
            };
            // Where the new parabola becomes lower than the last one.
            let rise = index * index - part * part + height2(index) - height2(part);
            let at = 1 + rise.div_euclid(2 * (index - part));
            if at < heights.len() as i64 {
                self.parts.push((index, at));
            }
        }
    }

    fn read(&mut self, heights: &[i64], into: &mut [i64]) {
        for x in (0..into.len() as i64).rev() {
            let place = x + 1;
            while self.parts.last().is_some_and(|&(_, at)| at > place) {
                self.parts.pop();
            }
            let part = self.parts.last().map_or(0, |&(part, _)| part);
            let height = heights[part as usize];
            into[x as usize] = (place - part) * (place - part) + height * height;
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn it_is_the_least_distance_to_any_solid_cell(
            columns in 1..12usize, solid in prop::collection::vec(prop::bool::weighted(0.15), 12..120),
        ) {
            let rows = solid.len() / columns;
            let found = distances2(columns, rows, |cell| solid[cell]);
            for cell in 0..columns * rows {
                let (x, y) = ((cell % columns) as i64, (cell / columns) as i64);
                let to_edge = (x + 1).min(columns as i64 - x).min(y + 1).min(rows as i64 - y);
                let expected = (0..columns * rows)
                    .filter(|&other| solid[other])
                    .map(|other| {
                        let (ox, oy) = ((other % columns) as i64, (other / columns) as i64);
                        (ox - x) * (ox - x) + (oy - y) * (oy - y)
                    })
                    .fold(to_edge * to_edge, i64::min);
                prop_assert_eq!(found[cell], expected, "cell {}", cell);
            }
        }
    }
}
