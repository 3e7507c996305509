//! People who walk up and down a corridor and mind a robot.
//!
//! Section 2.9 has human beings moving around in the corridor and says no more. NOTE: all of this is
//! our reading. They walk both ways at their own pace in lanes of their own, go through the middle of
//! doors, step aside for the robot to the roomier side, keep out of the space before and beside it,
//! stand still now and then, turn back where they are held up, and wait at a door that the robot is in.

use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, Exp, Uniform};
use serde::Deserialize;

use crate::geometry::Vec2;

use super::Round;

/// Radius of a person, metres.
pub const PERSON_RADIUS_M: f64 = 0.22;
/// Paces, m/s.
const PACES_M_S: [f64; 2] = [0.6, 1.2];
/// How fast they step aside for the robot, and change lanes, m/s.
const ASIDE_M_S: f64 = 0.6;
const LANE_M_S: f64 = 0.4;
/// Where along the corridor they mind the robot: so far behind it and before it, metres.
const MINDED_M: [f64; 2] = [0.6, 2.5];
/// Where along the corridor the robot changes nothing for them, metres.
const FAR_M: f64 = 5.0;
/// Room they leave to walls and door frames, metres.
const WALL_M: f64 = 0.05;
const FRAME_M: f64 = 0.13;
/// How far from a door they make for its middle, metres.
const FUNNEL_M: f64 = 1.5;
/// Where they wait while the robot is in a door, and how near to it the robot then is, metres.
const WAIT_M: f64 = 1.4;
const IN_DOOR_M: f64 = 1.0;
/// Mean time between pauses and how long one is, seconds; none nearer to the robot than this, metres.
const PAUSE_EVERY_S: f64 = 60.0;
const PAUSES_S: [f64; 2] = [3.0, 12.0];
const NO_PAUSE_M: f64 = 1.5;
/// How long they are held up before they turn back, seconds.
const PATIENCE_S: f64 = 4.0;
/// How near to the corridor's ends they turn, and where the first of them may start, metres.
const TURN_M: f64 = 0.6;
const FIRST_M: f64 = 4.0;

/// A door across the corridor, centred.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Passage {
    /// Where along the corridor, metres.
    pub x_m: f64,
    /// Half its width, metres.
    pub half_width_m: f64,
}

/// A person.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Person {
    /// Where, metres; y is 0 in the middle of the corridor.
    pub place: Vec2,
    /// Pace along the corridor, m/s; below 0 towards its beginning.
    pub pace_m_s: f64,
    /// Lane, metres to the left of the middle.
    pub lane_m: f64,
    /// How long they still stand still, seconds.
    pub pausing_s: f64,
    until_pause_s: f64,
    held_up_s: f64,
}

/// Most people of a file.
const MOST: usize = 50;

/// People of one's own, as a file gives them.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PeopleFile {
    /// Each of them.
    pub people: Vec<PersonFile>,
}

/// One of them.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PersonFile {
    /// Where they start: along the corridor and to the left of its middle, metres.
    pub start_m: [f64; 2],
    /// Pace along the corridor, from -3 to 3 m/s; below 0 towards its beginning.
    pub pace_m_s: f64,
    /// Lane that they walk in, metres to the left of the middle; where they start when missing.
    pub lane_m: Option<f64>,
}

/// What they have to mind of the robot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Obstacle {
    /// Where it is, metres.
    pub place: Vec2,
    /// Unit vector of its heading.
    pub direction: Vec2,
    /// Half its length and width, metres.
    pub half: Vec2,
}

/// A person who cannot be where they are put.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("people[{person}]: {problem}")]
pub struct PeopleError {
    /// Which, from 0.
    pub person: usize,
    /// What is wrong, and what would be right.
    pub problem: String,
}

/// Everybody in a corridor.
#[derive(Clone, Debug)]
pub struct People {
    length_m: f64,
    half_width_m: f64,
    doors: Vec<Passage>,
    everybody: Vec<Person>,
    rng: ChaCha8Rng,
}

impl Obstacle {
    /// The space kept free: how far ahead of the robot, and beside and behind it, metres.
    const KEPT_M: [f64; 2] = [0.45, 0.15];

    /// How deep in the space kept free somebody stands, metres; not above 0 outside it.
    fn depth_m(&self, place: Vec2) -> f64 {
        let way = place - self.place;
        let (ahead, beside) = (self.direction.dot(&way), self.direction.perp(&way));
        let [before, around] = Self::KEPT_M.map(|kept| kept + PERSON_RADIUS_M);
        let front = self.half.x + before - ahead;
        let back = ahead + self.half.x + around;
        front.min(back).min(self.half.y + around - beside.abs())
    }

    /// Whether somebody is so near along the corridor that they step aside.
    fn is_minded_by(&self, place: Vec2) -> bool {
        let before = (place.x - self.place.x) * if self.direction.x < 0.0 { -1.0 } else { 1.0 };
        (-MINDED_M[0] - self.half.x..=MINDED_M[1] + self.half.x).contains(&before)
    }
}

impl Person {
    /// The space that the person takes up.
    #[must_use]
    pub fn round(&self) -> Round {
        Round { centre: self.place, radius_m: PERSON_RADIUS_M }
    }
}

impl People {
    /// So many people anywhere in a corridor from x = 0 to its length, its middle at y = 0.
    #[must_use]
    pub fn anywhere(
        count: usize,
        [length_m, half_width_m]: [f64; 2],
        doors: Vec<Passage>,
        mut rng: ChaCha8Rng,
    ) -> Self {
        let most_m = (half_width_m - PERSON_RADIUS_M - WALL_M).max(0.0);
        let anyone = |_| {
            let lane_m = rng.random_range(-most_m..=most_m);
            let toward = if rng.random_bool(0.5) { 1.0 } else { -1.0 };
            let last_m = (length_m - TURN_M).max(FIRST_M);
            let x_m = rng.random_range(FIRST_M..=last_m);
            // Nobody starts in a door frame.
            let in_door = |door: &Passage| (x_m - door.x_m).abs() < FUNNEL_M;
            let y_m = if doors.iter().any(in_door) { 0.0 } else { lane_m };
            Person {
                place: Vec2::new(x_m, y_m),
                pace_m_s: toward * rng.random_range(PACES_M_S[0]..PACES_M_S[1]),
                lane_m,
                pausing_s: 0.0,
                until_pause_s: until_pause_s(&mut rng),
                held_up_s: 0.0,
            }
        };
        let everybody = (0..count).map(anyone).collect();
        Self { length_m, half_width_m, doors, everybody, rng }
    }

    /// People who start where they are told to and walk in the lanes they are told; a door they pass
    /// through its middle, whatever their lane.
    ///
    /// # Errors
    /// The first who does not stand free of walls and door frames, whose lane leads through a wall, or who
    /// has no pace a person can have; the first who is too many.
    pub fn placed(
        people: &[PersonFile],
        [length_m, half_width_m]: [f64; 2],
        doors: Vec<Passage>,
        rng: ChaCha8Rng,
    ) -> Result<Self, PeopleError> {
        if people.len() > MOST {
            let problem = format!("is too many; there may be {MOST} people");
            return Err(PeopleError { person: MOST, problem });
        }
        let mut all = Self { length_m, half_width_m, doors, everybody: Vec::new(), rng };
        for (person, file) in people.iter().enumerate() {
            let refuse = |problem| PeopleError { person, problem };
            let (place, lane_m) =
                (Vec2::from(file.start_m), file.lane_m.unwrap_or(file.start_m[1]));
            all.check(place, file.pace_m_s).map_err(refuse)?;
            all.check_lane(lane_m).map_err(refuse)?;
            let until_pause_s = until_pause_s(&mut all.rng);
            all.everybody.push(Person {
                place,
                pace_m_s: file.pace_m_s,
                lane_m,
                pausing_s: 0.0,
                until_pause_s,
                held_up_s: 0.0,
            });
        }
        Ok(all)
    }

    fn check(&self, place: Vec2, pace_m_s: f64) -> Result<(), String> {
        if !(-3.0..=3.0).contains(&pace_m_s) {
            return Err(format!("the pace must be from -3 to 3 m/s, not {pace_m_s}"));
        }
        let [x, y] = [place.x, place.y];
        let inside = (0.0..=self.length_m).contains(&x) && y.abs() <= self.half_width_m;
        if !inside {
            return Err(format!("({x}, {y}) is outside the corridor, {}", self.size()));
        }
        let free = (PERSON_RADIUS_M..=self.length_m - PERSON_RADIUS_M).contains(&x)
            && y.abs() <= self.half_width_m - PERSON_RADIUS_M
            && self.is_clear_of_frames(place);
        if free {
            return Ok(());
        }
        Err(format!(
            "({x}, {y}) is in a wall; a person must stand {PERSON_RADIUS_M} m from walls and door frames in \
             the corridor, {}",
            self.size()
        ))
    }

    fn check_lane(&self, lane_m: f64) -> Result<(), String> {
        let most_m = self.half_width_m - PERSON_RADIUS_M;
        if lane_m.abs() <= most_m {
            return Ok(());
        }
        Err(format!(
            "the lane at {lane_m} leads through the wall at {}; it must be from {:.2} to {most_m:.2} m",
            self.half_width_m.copysign(lane_m),
            -most_m
        ))
    }

    /// Where the corridor is, in words.
    fn size(&self) -> String {
        let half_m = self.half_width_m;
        format!("x from 0 to {} m, y from {} to {half_m} m", self.length_m, -half_m)
    }

    /// Everybody, in their order.
    #[must_use]
    pub fn everybody(&self) -> &[Person] {
        &self.everybody
    }

    /// Lets time pass, seconds.
    pub fn step(&mut self, dt_s: f64, robot: &Obstacle) {
        for person in 0..self.everybody.len() {
            self.everybody[person] = self.moved(self.everybody[person], dt_s, robot);
        }
    }

    fn moved(&mut self, mut person: Person, dt_s: f64, robot: &Obstacle) -> Person {
        self.pause(&mut person, dt_s, robot);
        // Far away the robot changes nothing.
        let robot = Some(robot).filter(|robot| (person.place.x - robot.place.x).abs() < FAR_M);
        let aside = Vec2::new(0.0, self.sidestep_m(&person, dt_s, robot));
        let onwards = Vec2::new(person.pace_m_s * dt_s, 0.0);
        let standing = person.pausing_s > 0.0;
        let crowding = robot.filter(|robot| robot.depth_m(person.place) > 0.0);
        let ways = if let Some(robot) = crowding {
            // The robot came too near: whatever leads out.
            let away = onwards.x.abs() * (person.place.x - robot.place.x).signum();
            let away = Vec2::new(away, 0.0);
            [aside + away, away, aside]
        } else if standing {
            [aside, Vec2::zeros(), Vec2::zeros()]
        } else {
            [aside + onwards, onwards, aside]
        };
        let from = person.place;
        let free = ways.into_iter().find(|way| self.may_go(from, from + way, robot));
        person.place += free.unwrap_or_default();
        let held_up = !standing && (person.place.x - from.x) * person.pace_m_s <= 0.0;
        person.held_up_s = if held_up { person.held_up_s + dt_s } else { 0.0 };
        let ahead_m =
            if person.pace_m_s > 0.0 { self.length_m - person.place.x } else { person.place.x };
        if person.held_up_s > PATIENCE_S || ahead_m < TURN_M {
            person.pace_m_s = -person.pace_m_s;
            person.held_up_s = 0.0;
        }
        person
    }

    /// Begins and ends pauses.
    fn pause(&mut self, person: &mut Person, dt_s: f64, robot: &Obstacle) {
        person.until_pause_s -= dt_s;
        if (person.place - robot.place).norm() < NO_PAUSE_M {
            person.pausing_s = 0.0;
        } else if person.pausing_s > 0.0 {
            person.pausing_s -= dt_s;
        } else if person.until_pause_s <= 0.0 {
            person.pausing_s = self.rng.sample(uniform(PAUSES_S));
            person.until_pause_s = until_pause_s(&mut self.rng);
        }
    }

    /// Way to the side in a time: to the lane, to the middle of a door, or out of the robot's way.
    fn sidestep_m(&self, person: &Person, dt_s: f64, robot: Option<&Obstacle>) -> f64 {
        let minded = robot.filter(|robot| robot.is_minded_by(person.place));
        let wanted_m = minded.map_or(person.lane_m, |robot| self.beside_m(robot));
        let door = self.doors.iter().find(|door| (person.place.x - door.x_m).abs() < FUNNEL_M);
        let most_m = match door {
            Some(door) => door.half_width_m - PERSON_RADIUS_M - FRAME_M,
            None => self.half_width_m - PERSON_RADIUS_M - WALL_M,
        };
        let wanted_m = wanted_m.clamp(-most_m.max(0.0), most_m.max(0.0));
        let most_m = if minded.is_some() { ASIDE_M_S } else { LANE_M_S } * dt_s;
        (wanted_m - person.place.y).clamp(-most_m, most_m)
    }

    /// The middle of the roomier side of the robot.
    fn beside_m(&self, robot: &Obstacle) -> f64 {
        let side = if robot.place.y > 0.0 { -1.0 } else { 1.0 };
        f64::midpoint(robot.place.y + side * robot.half.y, side * self.half_width_m)
    }

    /// Whether somebody may go from a place to another: not into a frame, not into a door that the
    /// robot is in, and not deeper into the space before the robot.
    fn may_go(&self, from: Vec2, to: Vec2, robot: Option<&Obstacle>) -> bool {
        let stays = to.y.abs() <= self.half_width_m - PERSON_RADIUS_M
            && (PERSON_RADIUS_M..=self.length_m - PERSON_RADIUS_M).contains(&to.x);
        stays
            && self.is_clear_of_frames(to)
            && robot.is_none_or(|robot| self.leaves_room(from, to, robot))
    }

    /// Whether a way leads neither deeper into the space before the robot nor into a door it is in.
    fn leaves_room(&self, from: Vec2, to: Vec2, robot: &Obstacle) -> bool {
        let waits = |door: &Passage| {
            let (now_m, then_m) = ((from.x - door.x_m).abs(), (to.x - door.x_m).abs());
            let robot_in_door = (robot.place.x - door.x_m).abs() < IN_DOOR_M;
            robot_in_door && then_m < now_m && then_m < WAIT_M
        };
        let deep_m = robot.depth_m(to);
        let deeper = deep_m > 0.0 && deep_m >= robot.depth_m(from);
        !deeper && !self.doors.iter().any(waits)
    }

    fn is_clear_of_frames(&self, place: Vec2) -> bool {
        self.doors.iter().all(|door| {
            (place.x - door.x_m).abs() > PERSON_RADIUS_M + FRAME_M
                || place.y.abs() <= door.half_width_m - PERSON_RADIUS_M
        })
    }
}

fn uniform([least, most]: [f64; 2]) -> Uniform<f64> {
    Uniform::new(least, most).expect("bounds are in order")
}

fn until_pause_s(rng: &mut ChaCha8Rng) -> f64 {
    Exp::new(1.0 / PAUSE_EVERY_S).expect("a positive rate").sample(rng)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::rng::{Purpose, stream};

    const SIZE_M: [f64; 2] = [40.0, 1.2];

    fn doors() -> Vec<Passage> {
        vec![Passage { x_m: 20.0, half_width_m: 0.9 }]
    }

    fn robot(x: f64, y: f64) -> Obstacle {
        Obstacle { place: Vec2::new(x, y), direction: Vec2::x(), half: Vec2::new(0.375, 0.35) }
    }

    #[test]
    fn who_stands_in_a_wall_is_refused() {
        let rng = || stream(1, 0, Purpose::People);
        for (place, person, says) in [
            ([5.0, 1.1, 1.0], 1, "(5, 1.1) is in a wall"),
            ([20.0, 0.8, 1.0], 1, "in a wall"),
            ([0.1, 0.0, 1.0], 1, "in a wall"),
            ([f64::NAN, 0.0, 1.0], 1, "is outside the corridor"),
            ([41.0, 0.0, 1.0], 1, "(41, 0) is outside the corridor, x from 0 to 40 m"),
            ([5.0, -1.3, 1.0], 1, "(5, -1.3) is outside the corridor"),
            ([5.0, 0.0, f64::INFINITY], 1, "the pace must be"),
        ] {
            let person_of = |[x_m, y_m, pace_m_s]: [f64; 3]| PersonFile {
                start_m: [x_m, y_m],
                pace_m_s,
                lane_m: None,
            };
            let people = [[3.0, 0.0, 1.0], place].map(person_of);
            let error = People::placed(&people, SIZE_M, doors(), rng()).expect_err(says);
            assert!(error.person == person && error.problem.contains(says), "{error}");
        }
    }

    #[test]
    fn a_lane_that_leads_through_a_wall_is_refused_and_another_is_walked_in() {
        let person =
            |lane_m| PersonFile { start_m: [3.0, 0.0], pace_m_s: 1.0, lane_m: Some(lane_m) };
        let placed = |people: &[PersonFile]| {
            People::placed(people, SIZE_M, doors(), stream(1, 0, Purpose::People))
        };
        for lane_m in [1.0, -1.0, f64::NAN] {
            let error = placed(&[person(0.0), person(lane_m)]).expect_err("in the wall");
            assert!(error.person == 1 && error.problem.contains("leads through"), "{error}");
        }
        assert_eq!(placed(&[person(0.0); 51]).expect_err("51 people").person, 50);
        let mut people = placed(&[person(-0.9)]).expect("free");
        // 0.9 m aside at 0.4 m/s are 2.25 s; the robot is far away.
        for _ in 0..100 {
            people.step(0.025, &robot(35.0, 0.0));
        }
        let place = people.everybody()[0].place;
        assert!((place - Vec2::new(5.5, -0.9)).norm() < 1e-9, "{place}");
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(40))]
        #[test]
        fn nobody_walks_through_walls_or_into_a_robot_that_stands(
            seed in 0..1000u64, x in 2.0..38.0f64, y in -0.5..0.5f64,
        ) {
            let mut people =
                People::anywhere(6, SIZE_M, doors(), stream(seed, 0, Purpose::People));
            let robot = robot(x, y);
            let body_m = |place: Vec2| {
                let way = place - robot.place;
                let beyond = Vec2::new(
                    (way.x.abs() - robot.half.x).max(0.0), (way.y.abs() - robot.half.y).max(0.0),
                );
                beyond.norm() - PERSON_RADIUS_M
            };
            let at_first: Vec<f64> =
                people.everybody().iter().map(|person| body_m(person.place)).collect();
            for _ in 0..4000 {
                people.step(0.025, &robot);
                for (person, at_first) in people.everybody().iter().zip(&at_first) {
                    prop_assert!(people.check(person.place, person.pace_m_s).is_ok(), "{person:?}");
                    prop_assert!(*at_first < 0.2 || body_m(person.place) > 0.0, "{person:?}");
                }
            }
        }
    }
}
