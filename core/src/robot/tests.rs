use super::examples::{b21, b21_file, trc, trc_file};
use super::*;

#[test]
fn the_b21_has_its_ring_and_the_trc_a_front_that_mirrors_itself() {
    let b21 = b21();
    assert_eq!(b21.sonars().len(), 24);
    for (sonar, mount) in b21.sonars().iter().enumerate() {
        assert!((mount.axis_deg - 15.0 * sonar as f64).abs() < 1e-12, "sonar {sonar}");
        assert!((mount.place.norm() - 0.265).abs() < 1e-12, "on the shell");
    }
    let trc = trc();
    let sonars = trc.sonars();
    assert_eq!(sonars.len(), 10, "section 2.2: ten cover the front");
    for (left, right) in sonars.iter().zip(sonars.iter().rev()) {
        assert_eq!((left.place.x, left.place.y), (right.place.x, -right.place.y));
        assert!((left.axis_deg + right.axis_deg).abs() < 1e-12);
    }
    let axes: Vec<f64> = sonars.iter().map(|mount| mount.axis_deg).collect();
    let span_deg = axes.iter().copied().fold(f64::NEG_INFINITY, f64::max) * 2.0;
    assert!((span_deg - 120.0).abs() < 1e-12, "section 2.2: a frontal angle of 120 degrees");
    assert_eq!(trc.body(), Body::Box { half_length_m: 0.375, half_width_m: 0.35 });
}

#[test]
fn a_refusal_names_the_field_and_what_would_be_right() {
    let b21 = |change: fn(&mut RobotFile)| {
        let mut file = b21_file();
        change(&mut file);
        file
    };
    let trc = |change: fn(&mut RobotFile)| {
        let mut file = trc_file();
        change(&mut file);
        file
    };
    for (file, field, says) in [
        (b21(|file| file.name.clear()), "name", "at least one character"),
        (b21(|file| file.body.radius_m = Some(f64::NAN)), "body.radius_m", "from 0.05 to 2.5"),
        (b21(|file| file.body.width_m = Some(0.3)), "body", "either `radius_m`, or `length_m`"),
        (b21(|file| file.ring = None), "sonars", "either `ring`"),
        (b21(|file| file.ring = Some(25)), "ring", "from 1 to 24 sonars, not 25"),
        (b21(|file| file.ring = Some(0)), "ring", "from 1 to 24 sonars, not 0"),
        (trc(|file| file.ring = Some(10)), "sonars", "either `ring`"),
        (trc(|file| file.sonars = vec![file.sonars[0]; 30]), "sonars", "not 30"),
        (trc(|file| file.sonars[3].axis_deg = 200.0), "sonars[3].axis_deg", "from -180 to 180"),
        (trc(|file| file.sonars[1].x_m = f64::INFINITY), "sonars[1].x_m", "not inf"),
        (trc(|file| file.body.length_m = None), "body", "`length_m` and `width_m`"),
        (
            trc(|file| {
                file.sonars.clear();
                file.ring = Some(8);
            }),
            "ring",
            "needs a round `body`",
        ),
    ] {
        let error = Robot::new(&file).expect_err(field);
        assert_eq!(error.field(), field, "{error}");
        assert!(error.to_string().contains(says), "{error}");
    }
}
