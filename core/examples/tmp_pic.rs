use sonarium_core::experiment::{MinimumCostPath, Settings};
use sonarium_core::planner::best_path;
use sonarium_core::robot::{Robot, RobotFile};
use sonarium_core::world::{World, WorldFile};
use std::sync::Arc;
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let file: WorldFile = toml::from_str(&std::fs::read_to_string(&a[1]).unwrap()).unwrap();
    let rf: RobotFile = toml::from_str(&std::fs::read_to_string("assets/robots/b21.toml").unwrap()).unwrap();
    let robot = Arc::new(Robot::new(&rf).unwrap());
    let world = Arc::new(World::new(&file, robot.body().reach_m()).unwrap());
    let s = Settings::default();
    let star = best_path(&world, &robot, &s).unwrap();
    println!("plan {}", star.total_reinforcement());
    let k: Vec<String> = star.poses.iter().zip(&star.reinforcements).map(|(p, r)| format!("{:.3},{:.3},{:.3},{:.3}", p.x_m, p.y_m, r.safety, r.goal)).collect();
    println!("{}", k.join(" "));
    for seed in a[2].parse::<u64>().unwrap()..a[3].parse().unwrap() {
        let mut e = MinimumCostPath::new(world.clone(), robot.clone(), &s, seed).unwrap();
        let mut rows = vec![];
        while e.trials_done() < 20 {
            let (t, end) = e.step();
            let o = &t.outcome;
            rows.push(format!("{:.3},{:.3},{:.3},{:.3}", o.true_pose.x_m, o.true_pose.y_m, o.reinforcement.safety, o.reinforcement.goal));
            if let Some(end) = end {
                eprintln!("seed {seed} trial {} steps {} R {:.2} rec {}", end.record.trial, end.record.steps, end.record.total_reinforcement, end.record.record);
                if end.record.trial == 20 { println!("seed {seed} {:.2}", end.record.total_reinforcement); println!("{}", rows.join(" ")); }
                rows.clear();
            }
        }
    }
}
