use sonarium_core::experiment::{MinimumCostPath, Settings};
use sonarium_core::learner::*;
use sonarium_core::robot::{Robot, RobotFile};
use sonarium_core::settings::Value;
use sonarium_core::world::{World, WorldFile};
use std::sync::Arc;
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let (world, seed, key, value) = (&a[1], a[2].parse::<u64>().unwrap(), &a[3], &a[4]);
    let text = std::fs::read_to_string(if world.starts_with("/") { format!("{world}.toml") } else { format!("assets/worlds/{world}.toml") }).unwrap();
    let file: WorldFile = toml::from_str(&text).unwrap();
    let rf: RobotFile =
        toml::from_str(&std::fs::read_to_string("assets/robots/b21.toml").unwrap()).unwrap();
    let robot = Arc::new(Robot::new(&rf).unwrap());
    let world = Arc::new(World::new(&file, robot.body().reach_m()).unwrap());
    let mut s = Settings::default();
    if key != "none" {
        s.set(key, &Value::Number(value.parse().unwrap())).unwrap();
    }
    let mut e = MinimumCostPath::new(world, robot, &s, seed).unwrap();
    let mut rows: Vec<String> = vec![];
    let mut best: (f64, Vec<String>) = (f64::NEG_INFINITY, vec![]);
    while e.trials_done() < 20 {
        let (t, end) = e.step();
        let d = &t.decision;
        let dist = d.winner.as_ref().map_or(9.9, |w| w.distance);
        rows.push(format!("{:3} at {:6.2} {:6.2} true {:6.2} {:6.2} near {:.2} reg {} win {:?} d {:.3} born {:?} src {:?} head {:4.0} r {:6.2} {}", t.step, t.pose.x_m, t.pose.y_m, t.true_pose.x_m, t.true_pose.y_m, t.sonar_m.iter().copied().fold(9.0, f64::min), t.region, d.neuron.map(|n| n.0), dist, d.born.map(|n| n.0), d.source, d.action_rad.to_degrees(), t.total_reinforcement, if format!("{:?}", t.outcome).contains("None") {""} else {"HIT"}));
        if let Some(end) = end {
            let r = end.record.total_reinforcement;
            let ok = end.record.reached_goal;
            println!(
                "trial {} steps {} R {:.2} goal {} record {}",
                end.record.trial, end.record.steps, r, ok, end.record.record
            );
            if ok && r > best.0 {
                best = (r, rows.clone());
            }
            if e.trials_done() == 20 {
                println!("--- best");
                for r in &best.1 {
                    println!("{r}");
                }
                println!("--- last");
                for r in rows.iter().take(60) {
                    println!("{r}");
                }
            }
            rows.clear();
        }
    }
}
