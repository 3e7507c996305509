use sonarium_core::experiment::{MinimumCostPath, Settings};
use sonarium_core::planner::best_path;
use sonarium_core::robot::{Robot, RobotFile};
use sonarium_core::settings::Value;
use sonarium_core::world::{World, WorldFile};
use std::sync::Arc;
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let n: u64 = a[1].parse().unwrap();
    let from: u64 = a[2].parse().unwrap();
    let only: Vec<&str> = a[3..].iter().map(String::as_str).collect();
    let arms: Vec<(&str, &str, Vec<(&str, f64)>)> = vec![
        ("laboratory", "laboratory", vec![]),
        ("drift1", "laboratory", vec![("odometry.drift", 0.01)]),
        ("drift2", "laboratory", vec![("odometry.drift", 0.02)]),
        ("nd", "laboratory", vec![("odometry.drift", 0.02), ("sonar.noise", 0.03)]),
        ("drift05", "laboratory", vec![("odometry.drift", 0.005)]),
        ("drift5", "laboratory", vec![("odometry.drift", 0.05)]),
        ("noise3", "laboratory", vec![("sonar.noise", 0.03)]),
        ("40deg", "laboratory", vec![("sonar.critical_angle", 40.0)]),
        ("25deg", "laboratory", vec![("sonar.critical_angle", 25.0)]),
        ("moved", "laboratory-shifted-door", vec![]),
        ("narrow", "laboratory-narrow-door", vec![]),
        ("twoobst", "two-obstacles", vec![]),
        ("lcorr", "l-corridor", vec![]),
        ("rooms3", "three-rooms", vec![]),
        ("baffles", "two-baffles", vec![]),
        ("pillars", "pillars", vec![]),
        ("bend", "/tmp/bend", vec![]),
        ("desks", "/tmp/desks", vec![]),
    ];
    let rf: RobotFile =
        toml::from_str(&std::fs::read_to_string("assets/robots/b21.toml").unwrap()).unwrap();
    let robot = Arc::new(Robot::new(&rf).unwrap());
    for (name, world, sets) in arms {
        if !only.is_empty() && !only.contains(&name) {
            continue;
        }
        let file: WorldFile = toml::from_str(
            &std::fs::read_to_string(if world.starts_with("/") { format!("{world}.toml") } else { format!("assets/worlds/{world}.toml") }).unwrap(),
        )
        .unwrap();
        let world = Arc::new(World::new(&file, robot.body().reach_m()).unwrap());
        let mut s = Settings::default();
        if let Ok(extra) = std::env::var("EXTRA") {
            for kv in extra.split(",") {
                let (k, v) = kv.split_once("=").unwrap();
                let v =
                    v.parse::<f64>().map(Value::Number).unwrap_or_else(|_| Value::Choice(v.into()));
                s.set(k, &v).unwrap();
            }
        }
        for (k, v) in &sets {
            s.set(k, &Value::Number(*v)).unwrap();
        }
        let star = best_path(&world, &robot, &s).unwrap().total_reinforcement();
        let run = |seed: u64| {
            let mut e = MinimumCostPath::new(world.clone(), robot.clone(), &s, seed).unwrap();
            let (mut best, mut last, mut late, mut ok, mut t8, mut born) =
                (f64::NEG_INFINITY, 0.0, 0.0, 0u32, 0, 0);
            let (mut tr, mut trl) = (0.0, 0.0);
            let goal = world.goal().centre;
            while e.trials_done() < 20 {
                let (tick, end) = e.step();
                tr += tick.outcome.reinforcement.safety
                    - tick.outcome.true_pose.bearing_to(goal).abs() / std::f64::consts::PI;
                if let Some(end) = end {
                    let r = &end.record;
                    last = r.total_reinforcement;
                    trl = tr;
                    tr = 0.0;
                    if r.reached_goal {
                        best = best.max(last);
                    }
                    if r.trial > 15 {
                        late += last / 5.0;
                        ok += u32::from(r.reached_goal);
                    }
                    if r.trial == 8 {
                        t8 = r.steps;
                    }
                    born = r.neurons as u32;
                }
            }
            if let Ok(b) = std::env::var("BIG") {
                let b: f64 = b.parse().unwrap();
                if 100.0 * (star - last) / -star > b {
                    println!("  seed {seed} last {last:.2} best {best:.2}");
                }
            }
            [
                100.0 * (star - last) / -star,
                100.0 * (star - best) / -star,
                100.0 * (star - late) / -star,
                f64::from(ok) / 5.0,
                f64::from(t8),
                f64::from(born),
                100.0 * (star - trl) / -star,
            ]
        };
        let half = |k: u64| (from..from + n).filter(|s| s % 2 == k).map(run).collect::<Vec<_>>();
        let t = std::time::Instant::now();
        let rows: Vec<[f64; 7]> = std::thread::scope(|sc| {
            let h = sc.spawn(|| half(0));
            let mut b = half(1);
            b.extend(h.join().unwrap());
            b
        });
        let col = |k: usize| {
            let mut v: Vec<f64> = rows.iter().map(|r| r[k]).collect();
            v.sort_by(f64::total_cmp);
            v
        };
        let mean = |v: &[f64]| v.iter().sum::<f64>() / v.len() as f64;
        let sd = |v: &[f64]| {
            let m = mean(v);
            (v.iter().map(|x| (x - m) * (x - m)).sum::<f64>() / (v.len() - 1) as f64).sqrt()
        };
        let (l, b, late) = (col(0), col(1), col(2));
        println!(
            "{name:10} last {:6.1} ± {:5.1} med {:6.1} | true {:6.1} ± {:.1} | record {:6.1} med {:6.1} | late mean {:6.1} | ok {:.3} t8 {:.1} neurons {:.1} | worst {:.0} {:.0} {:.0} | {:.1} ms",
            mean(&l),
            2.0 * sd(&l) / (n as f64).sqrt(),
            l[l.len() / 2],
            mean(&col(6)),
            2.0 * sd(&col(6)) / (n as f64).sqrt(),
            mean(&b),
            b[b.len() / 2],
            mean(&late),
            mean(&col(3)),
            col(4)[l.len() / 2],
            mean(&col(5)),
            l[l.len() - 1],
            l[l.len() - 2],
            l[l.len() - 3],
            t.elapsed().as_secs_f64() * 2e3 / n as f64
        );
    }
}
