use std::sync::Arc;
use sonarium_core::experiment::{MinimumCostPath, Settings};
use sonarium_core::settings::Value;
use sonarium_core::world::{World, WorldFile};
fn main() {
    let c = |n: &str| Value::Choice(n.into());
    let presets: Vec<(&str, Vec<(&str, Value)>)> = vec![
        ("default", vec![]),
        ("reflex", vec![("learner.learning", Value::Switch(false))]),
        ("thesis", vec![("learner.action_frame", c("rotation")), ("learner.sigma_scale", Value::Number(1.0)), ("learner.new_neuron", c("reflex")), ("learner.forget_unrecorded", Value::Switch(false)), ("learner.after_rescue", c("network")), ("learner.mean_update", c("gradient")), ("learner.replacement", c("backward")), ("learner.exploit_from", Value::Integer(0))]),
        ("mixed", vec![("input.sonar_frame", c("odometry")), ("sonar.critical_angle", Value::Number(40.0)), ("sonar.dropout", Value::Number(0.02)), ("odometry.drift", Value::Number(0.01)), ("sonar.rays", Value::Integer(9))]),
    ];
    for w in ["laboratory", "two-obstacles", "laboratory-shifted-door"] {
        let text = std::fs::read_to_string(format!("{}/../assets/worlds/{w}.toml", env!("CARGO_MANIFEST_DIR"))).unwrap();
        let file: WorldFile = toml::from_str(&text).unwrap();
        for (name, changes) in &presets {
            let mut s = Settings::default();
            for (k, v) in changes { s.set(k, v).unwrap(); }
            for seed in [1u64, 2, 77] {
                let world = Arc::new(World::new(&file, 0.265).unwrap());
                let mut m = make(world, &s, seed);
                let mut h: u64 = 0xcbf29ce484222325;
                let mut eat = |x: u64| { h ^= x; h = h.wrapping_mul(0x100000001b3); };
                while m.trials_done() < 20 {
                    let (t, e) = m.step();
                    for r in t.sonar_m.iter() { eat(r.to_bits()); }
                    for b in format!("{:?} {:?} {:?}", t.true_pose, t.decision, t.outcome).bytes() { eat(b as u64); }
                    if let Some(e) = e { for b in format!("{:?}", e).bytes() { eat(b as u64); } }
                }
                println!("{w} {name} {seed} {h:016x}");
            }
        }
    }
}
fn make(w: Arc<World>, s: &Settings, seed: u64) -> MinimumCostPath {
    use sonarium_core::robot::{Robot, RobotFile};
    let text = std::fs::read_to_string(format!("{}/../assets/robots/b21.toml", env!("CARGO_MANIFEST_DIR"))).unwrap();
    let file: RobotFile = toml::from_str(&text).unwrap();
    MinimumCostPath::new(w, Arc::new(Robot::new(&file).unwrap()), s, seed).unwrap()
}
