//! Altered starts as text: `x,y,heading`, with `;` between several.

use super::FieldError;
use crate::wire::StartView;

/// Poses from text, each named after what was written.
///
/// # Errors
/// The first that is not three numbers; the field is `start`.
pub fn starts_from_text(text: &str) -> Result<Vec<StartView>, FieldError> {
    text.split(';').map(start).collect()
}

fn start(text: &str) -> Result<StartView, FieldError> {
    let name = text.trim();
    let numbers: Option<Vec<f64>> = name
        .split(',')
        .map(|number| number.trim().parse().ok().filter(|n: &f64| n.is_finite()))
        .collect();
    match numbers.as_deref() {
        Some(&[x_m, y_m, heading_deg]) => {
            Ok(StartView { name: name.to_owned(), x_m, y_m, heading_deg })
        }
        _ => Err(FieldError::new(
            "start",
            format!(
                "`{name}` must be three numbers, x and y in metres and the heading in degrees, e.g. 1,0.5,90"
            ),
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn poses_are_three_numbers_each() {
        let starts = starts_from_text("1, 0.5,90; -2,1,0").expect("two poses");
        let poses: Vec<_> = starts.iter().map(|s| (s.x_m, s.y_m, s.heading_deg)).collect();
        assert_eq!(poses, [(1.0, 0.5, 90.0), (-2.0, 1.0, 0.0)]);
        for wrong in ["", "1,2", "1,2,x", "1,2,NaN", "1,2,3,4", "1,2,3;"] {
            let error = starts_from_text(wrong).expect_err(wrong);
            assert!(error.message.contains("three numbers"), "{error}");
        }
    }
}
