use std::sync::Arc;
use sonarium_core::experiment::{MinimumCostPath, Settings};
use sonarium_core::robot::{Robot, RobotFile};
use sonarium_core::settings::Value;
use sonarium_core::world::{World, WorldFile};
use sonarium_core::geometry::Pose;
fn value(t: &str) -> Value {
    if let Ok(b) = t.parse() { return Value::Switch(b) }
    if let Ok(i) = t.parse() { return Value::Integer(i) }
    if let Ok(f) = t.parse() { return Value::Number(f) }
    Value::Choice(t.into())
}
fn main() {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets");
    let (mut world, mut robot, mut trials, mut seeds, mut show, mut starts) = ("blocks".to_string(), "trc".to_string(), 50u32, 1..=20u64, false, vec![]);
    let mut s = Settings::default();
    for (k, v) in [("trial.on_collision","end"),("learner.regions","one"),("sonar.cone","30.0"),("sonar.range","2.0"),("sonar.least","0.1524"),("input.sonar_span","2.0"),("motion.advance","0.05"),("trial.step_cap","600")] { s.set(k, &value(v)).unwrap(); }
    for a in std::env::args().skip(1) {
        let (k, v) = a.split_once('=').unwrap();
        match k {
            "world" => world = v.into(), "robot" => robot = v.into(), "trials" => trials = v.parse().unwrap(),
            "seeds" => seeds = 1..=v.parse().unwrap(), "show" => show = true,
            "start" => { let p: Vec<f64> = v.split(',').map(|x| x.parse().unwrap()).collect(); starts.push(Pose::new(p[0], p[1], p[2].to_radians())); }
            "thesis" => for (k, v) in [("learner.action_frame","rotation"),("learner.sigma_scale","1.0"),("learner.new_neuron","reflex"),("learner.forget_unrecorded","false"),("learner.after_rescue","network"),("learner.mean_update","gradient"),("learner.replacement","backward"),("learner.exploit_from","0")] { s.set(k, &value(v)).unwrap(); },
            _ => s.set(k, &value(v)).unwrap(),
        }
    }
    let wf: WorldFile = toml::from_str(&std::fs::read_to_string(if world.contains('/') { world.clone() } else { format!("{root}/worlds/{world}.toml") }).unwrap()).unwrap();
    let rf: RobotFile = toml::from_str(&std::fs::read_to_string(format!("{root}/robots/{robot}.toml")).unwrap()).unwrap();
    let robot = Arc::new(Robot::new(&rf).unwrap());
    let world = Arc::new(World::new(&wf, robot.body().reach_m()).unwrap());
    let n = seeds.clone().count() as f64;
    let mut all = vec![];
    for seed in seeds {
        let mut m = MinimumCostPath::new(world.clone(), robot.clone(), &s, seed).unwrap();
        let mut rs = vec![];
        let mut path = vec![];
        while m.trials_done() < trials {
            let (t, e) = m.step();
            if show { path.push((t.true_pose.x_m, t.true_pose.y_m, t.true_pose.heading_rad.to_degrees())); }
            if let Some(e) = e { rs.push(e.record.clone());
                if show { let r = &e.record; let last = path.last().unwrap();
                  println!("seed {seed} trial {} steps {} R {:.2} ok {} coll {} neurons {} end ({:.2},{:.2},{:.0}) path {:?}", r.trial, r.steps, r.total_reinforcement, r.reached_goal, r.collisions, r.neurons, last.0,last.1,last.2, path.iter().step_by(12).map(|p| format!("{:.1},{:.1}", p.0, p.1)).collect::<Vec<_>>().join(" "));
                } path.clear(); }
        }
        for (i, p) in starts.iter().enumerate() {
            let a = m.altered_start(*p, i as u32);
            println!("seed {seed} start {:?} inside {} explored {:?} alone ok {} steps {} coll {} silent {:.2} | guided ok {} steps {} silent {:.2}", (p.x_m, p.y_m), a.inside, a.explored_m.map(|x| (x*100.).round()/100.), a.alone.reached_goal, a.alone.steps, a.alone.collisions, a.alone.silent_steps as f64 / a.alone.steps as f64, a.guided.reached_goal, a.guided.steps, a.guided.silent_steps as f64 / a.guided.steps as f64);
        }
        all.push(rs);
    }
    let firsts: Vec<_> = all.iter().map(|rs| rs.iter().position(|r| r.reached_goal).map_or(999, |i| i + 1)).collect();
    let mut f = firsts.clone(); f.sort();
    println!("first success median {} range {}..{}", f[f.len()/2], f[0], f[f.len()-1]);
    for t in 0..trials as usize {
        if t > 14 && t % 5 != 4 && t + 1 != trials as usize { continue }
        let ok: Vec<_> = all.iter().map(|rs| &rs[t]).filter(|r| r.reached_goal).collect();
        let k = ok.len() as f64;
        let mean = |f: &dyn Fn(&sonarium_core::learner::TrialRecord) -> f64| ok.iter().map(|r| f(r)).sum::<f64>() / k;
        println!("trial {:>3} ok {:>5.1}% steps {:>6.1} R {:>8.2} path {:>5.2} neurons {:>6.1} born {:>5.1} allsteps {:>6.1}", t + 1, 100. * k / n, mean(&|r| r.steps as f64), mean(&|r| r.total_reinforcement), mean(&|r| r.path_m), all.iter().map(|rs| rs[t].neurons as f64).sum::<f64>() / n, all.iter().map(|rs| rs[t].born as f64).sum::<f64>() / n, all.iter().map(|rs| rs[t].steps as f64).sum::<f64>() / n);
    }
}
