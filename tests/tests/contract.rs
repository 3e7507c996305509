//! The contract of the command line and of the interface, as its users rely on it.

use e2e::{Server, root, sonarium};
use serde_json::{Value, json};

const EXPERIMENT: &str = "minimum-cost-path";

#[test]
fn run_prints_one_object_with_the_fields_that_stay() {
    let run = sonarium(&["run", EXPERIMENT, "--seed", "3", "--trials", "2", "--json"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let result: Value = serde_json::from_str(&run.stdout).expect("one JSON object");
    for field in ["experiment", "seed", "build", "settings", "trials", "summary"] {
        assert!(!result[field].is_null(), "{field}");
    }
    for field in ["trial", "steps", "total_reinforcement", "neurons", "collisions", "reached_goal"]
    {
        assert!(!result["trials"][1][field].is_null(), "{field}");
    }
    assert_eq!(result["seed"], 3);
}

#[test]
fn a_tabular_run_prints_its_episodes() {
    for (experiment, episodes, competitors) in
        [("labyrinth", 6, 6), ("continual", 3, 2), ("gridworld", 1, 1), ("bandit", 5, 5)]
    {
        let one = "episodes=1";
        let run =
            sonarium(&["run", experiment, "--seed", "3", "--trials", "5", "--set", one, "--json"]);
        assert_eq!(run.code, Some(0), "{experiment}: {}", run.stderr);
        let result: Value = serde_json::from_str(&run.stdout).expect("one JSON object");
        for field in ["experiment", "seed", "build", "settings", "summary"] {
            assert!(!result[field].is_null(), "{experiment}: {field}");
        }
        let rows = result["episodes"].as_array().expect("episodes");
        assert_eq!(rows.len(), episodes, "{experiment}");
        for field in ["round", "episode", "entrant", "steps", "outcome"] {
            assert!(!rows[0][field].is_null(), "{experiment}: {field}");
        }
        let scores = result["summary"]["scores"].as_array().expect("scores");
        assert_eq!(scores.len(), competitors, "{experiment}");
    }
    let run = sonarium(&["run", "horizon", "--json"]);
    let result: Value = serde_json::from_str(&run.stdout).expect("one JSON object");
    let points = result["episodes"][0]["outcome"]["points"].as_array().expect("points");
    let crossings = points.iter().filter(|point| !point["crossing"].is_null()).count();
    assert_eq!(crossings, 4, "figure 3.3: two changes of the best policy in each plot");
}

#[test]
fn a_broken_maze_or_process_is_refused_with_the_place() {
    let folder = tempfile::tempdir().expect("a folder");
    let heading = "name = \"own\"\ntitle = \"\"\nsummary = \"\"\nsource = \"\"\n";
    let process =
        "states = [\"a\", \"b\"]\nactions = [\"go\"]\nstart = \"a\"\nabsorbing = [\"b\"]\n";
    for (text, says) in [
        ("map = \"\"\"\n..G\n\"\"\"".to_owned(), "start"),
        ("map = \"\"\"\nS#G\n\"\"\"".to_owned(), "line 1"),
        ("map = \"\"\"\nS?G\n\"\"\"".to_owned(), "line 1, column 2"),
        ("map = \"\"\"\nS.G\n\"\"\"\nslip = 2.0".to_owned(), "slip"),
        (format!("{process}[[rows]]\nstate = \"a\"\naction = \"go\"\nto = {{ b = 0.9 }}"), "0.9"),
    ] {
        let file = folder.path().join("own.toml");
        std::fs::write(&file, format!("{heading}{text}")).expect("can be written");
        let file = file.to_str().expect("a plain path");
        let run = sonarium(&["run", "gridworld", "--world", file]);
        assert_eq!(run.code, Some(2), "{text}: {}", run.stderr);
        assert!(run.stderr.contains(says), "{text} does not say {says}: {}", run.stderr);
    }
}

#[test]
fn several_seeds_print_one_object_a_line_in_order() {
    let run = sonarium(&["run", EXPERIMENT, "--seeds", "4..6", "--trials", "1", "--json"]);
    let seeds: Vec<Value> = run
        .stdout
        .lines()
        .map(|line| serde_json::from_str::<Value>(line).expect("an object a line")["seed"].clone())
        .collect();
    assert_eq!(seeds, [json!(4), json!(5), json!(6)]);
}

#[test]
fn the_command_line_refuses_bad_input_and_names_the_field() {
    let broken = tempfile::NamedTempFile::new().expect("a temporary file");
    std::fs::write(broken.path(), "sonar.noise = = 1").expect("can be written");
    let broken = broken.path().to_str().expect("a plain path");
    for (arguments, words) in [
        (vec!["run", "minimum-cost-pth"], vec!["minimum-cost-pth", "minimum-cost-path"]),
        (vec!["run", EXPERIMENT, "--set", "sonar.nose=0.1"], vec!["sonar.nose", "sonar.noise"]),
        (vec!["run", EXPERIMENT, "--set", "sonar.noise=9"], vec!["sonar.noise", "0 to 0.5"]),
        (vec!["run", EXPERIMENT, "--set", "learner.learning=maybe"], vec!["true or false"]),
        (vec!["run", EXPERIMENT, "--set", "world=atlantis"], vec!["world", "laboratory"]),
        (vec!["run", EXPERIMENT, "--set", "sonar.noise"], vec!["KEY=VALUE"]),
        (vec!["run", EXPERIMENT, "--trials", "0"], vec!["trials"]),
        (vec!["run", "labyrinth", "--set", "start=15"], vec!["settings.goal", "start"]),
        (vec!["run", "labyrinth", "--set", "exploration.first=0"], vec!["0.001 to 1000"]),
        (vec!["run", "labyrinth", "--set", "belief.matrix=[[1,2]]"], vec!["matrix", "16 rows"]),
        (vec!["run", "labyrinth", "--network", "net.json"], vec!["--network"]),
        (
            vec!["run", "gridworld", "--set", "world=repair", "--set", "bias.reflex=true"],
            vec!["settings.bias.reflex", "does not offer a reflex"],
        ),
        (vec!["run", "horizon", "--trials", "5"], vec!["trials"]),
        (vec!["run", EXPERIMENT, "--seeds", "9..3"], vec!["seeds"]),
        (vec!["run", EXPERIMENT, "--config", broken], vec!["line 1"]),
        (vec!["run", EXPERIMENT, "--config", "no-such-file.toml"], vec!["no-such-file.toml"]),
        (vec!["serve", "--listen", "nowhere"], vec!["listen"]),
        (vec!["serve", "--listen", "127.0.0.1:0", "--data", "/proc/sonarium"], vec!["data"]),
    ] {
        let run = sonarium(&arguments);
        assert_eq!(run.code, Some(2), "{arguments:?}: {}", run.stderr);
        for word in words {
            assert!(run.stderr.contains(word), "{arguments:?} does not say {word}: {}", run.stderr);
        }
    }
}

#[test]
fn experiments_names_every_setting_with_default_unit_and_source() {
    let run = sonarium(&["experiments", "--json"]);
    let experiments: Value = serde_json::from_str(&run.stdout).expect("JSON");
    let settings = experiments[0]["settings"].as_array().expect("settings");
    assert!(settings.len() > 40, "{}", settings.len());
    for setting in settings {
        for field in ["key", "meaning", "default", "source", "standing", "unit"] {
            assert!(!setting[field].is_null(), "{setting}");
        }
    }
    let names = sonarium(&["experiments"]).stdout;
    assert!(names.contains(EXPERIMENT), "{names}");
}

#[test]
fn reproduce_prints_one_object_a_target_with_published_beside_ours() {
    let run = sonarium(&["reproduce", "table-5.1", "--json"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert_eq!(run.stdout.lines().count(), 1, "one object");
    let result: Value = serde_json::from_str(&run.stdout).expect("an object a line");
    assert_eq!(result["target"], "table-5.1");
    let rows = rows_of(&result);
    assert_eq!(rows.len(), 21);
    for row in rows {
        assert_eq!(row["n"], json!(200), "{row}");
        assert!(row["reading"].as_str().is_some_and(|reading| reading.contains("Preset")));
    }
    assert_eq!(
        (&rows[2]["name"], &rows[2]["published"]),
        (&json!("default: number of steps, mean"), &json!(27.7))
    );
    let table = sonarium(&["reproduce", "table-5.1"]).stdout;
    for words in ["seeds 700000..700199", "95 % interval", "Does not agree:", "cannot tell"] {
        assert!(table.contains(words), "the table does not say {words}: {table}");
    }
    let markdown = sonarium(&["reproduce", "table-5.1", "--markdown"]).stdout;
    assert!(markdown.contains("| | published | ours |"), "{markdown}");
    let unknown = sonarium(&["reproduce", "table-9.9"]);
    assert_eq!(unknown.code, Some(2), "{}", unknown.stderr);
    assert!(unknown.stderr.contains("`table-5.1`"), "{}", unknown.stderr);
}

#[test]
fn reproduce_leaves_curves_and_pictures_in_a_folder() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let out = folder.path().to_str().expect("a plain path");
    for (target, files) in [
        (
            "figure-5.10",
            vec!["rows.csv", "reproduction.json", "default-first.png", "reflex-last.png"],
        ),
        ("figure-5.12", vec!["rows.csv", "reproduction.json", "curves.csv"]),
    ] {
        let run = sonarium(&["reproduce", target, "--json", "--out", out]);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        let result: Value = serde_json::from_str(&run.stdout).expect("an object a line");
        assert!(!rows_of(&result).is_empty());
        for file in files {
            let bytes = std::fs::read(folder.path().join(target).join(file)).unwrap_or_default();
            assert!(bytes.len() > 100, "{target}/{file} has {} bytes", bytes.len());
        }
    }
    let refused = sonarium(&["reproduce", "table-5.1", "--out", "/proc/sonarium"]);
    assert_eq!(refused.code, Some(2), "{}", refused.stderr);
    assert!(refused.stderr.contains("--out"), "{}", refused.stderr);
}

/// The rows of a result, each in the shape that stays.
fn rows_of(result: &Value) -> &Vec<Value> {
    let rows = result["rows"].as_array().expect("rows");
    for row in rows {
        for field in ["ours", "low", "high", "n"] {
            assert!(row[field].is_number(), "{field} of {row}");
        }
        for field in ["name", "unit", "reading"] {
            assert!(row[field].is_string(), "{field} of {row}");
        }
        assert!(row["published"].is_number() || row["published"].is_null(), "{row}");
        let verdict = row["verdict"].as_str().unwrap_or_default();
        assert!(["agrees", "differs", "cannot tell"].contains(&verdict), "{row}");
    }
    rows
}

#[test]
fn a_session_is_created_driven_and_downloaded() {
    let server = Server::start();
    let id =
        server.create(&json!({"experiment": EXPERIMENT, "seed": 1, "trials": 3, "speed": "max"}));
    let path = format!("sessions/{id}");
    let (status, ack) = server.post(&format!("{path}/step"), &Value::Null);
    assert_eq!((status, &ack["state"], &ack["tick"]), (200, &json!("paused"), &json!(1)));
    let (status, ack) = server.post(&format!("{path}/resume"), &Value::Null);
    assert_eq!(status, 200, "{ack}");
    let session = server.wait(&id, "finished", |session| session["state"] == "finished");
    assert_eq!(session["trials_done"], 3);
    for (file, kind, start) in [
        ("report.html", "text/html", &b"<!DOCTYPE html>"[..]),
        ("report.json", "application/json", b"{"),
        ("report.csv", "text/csv", b"trial"),
        ("report.zip", "application/zip", b"PK"),
        ("log.mcap", "application/octet-stream", b"\x89MCAP"),
        ("arena.png?width=333&height=222", "image/png", b"\x89PNG"),
        ("trials/2/report.html", "text/html", b"<!DOCTYPE html>"),
        ("trials/2/report.json", "application/json", b"{"),
        ("trials/2/report.csv", "text/csv", b"tick"),
        ("trials/2/report.png", "image/png", b"\x89PNG"),
    ] {
        let (status, found, body) = server.download(&format!("/api/v1/{path}/{file}"));
        assert_eq!(status, 200, "{file}");
        assert!(found.starts_with(kind), "{file} is {found}");
        assert!(body.starts_with(start), "{file} starts {:?}", &body[..body.len().min(20)]);
    }
    assert_eq!(server.delete(&path), 204);
    assert_eq!(server.get(&path).0, 404);
}

#[test]
fn bad_requests_get_problem_details_and_the_server_goes_on() {
    let server = Server::start();
    let id = server.create(&json!({"experiment": EXPERIMENT, "seed": 1, "trials": 2}));
    let big = format!("{{\"experiment\":\"{}\"}}", "x".repeat(1 << 20));
    let session = |change: Value| {
        let mut body = json!({"experiment": EXPERIMENT});
        for (key, value) in change.as_object().expect("an object") {
            body[key] = value.clone();
        }
        body.to_string()
    };
    for (path, body, status, field) in [
        ("sessions".into(), session(json!({"experiment": "x"})), 422, "experiment"),
        (
            "sessions".into(),
            session(json!({"settings": {"sonar.noise": 7}})),
            422,
            "settings.sonar.noise",
        ),
        (
            "sessions".into(),
            session(json!({"settings": {"sonar.nois": 0}})),
            422,
            "settings.sonar.nois",
        ),
        ("sessions".into(), session(json!({"settings": {"world": "x"}})), 422, "settings.world"),
        ("sessions".into(), session(json!({"settings": {"preset": "x"}})), 422, "settings.preset"),
        ("sessions".into(), session(json!({"trials": 0})), 422, "trials"),
        ("sessions".into(), session(json!({"speed": -1})), 422, "speed"),
        ("sessions".into(), "{".into(), 400, ""),
        ("sessions".into(), big, 413, ""),
        ("sessions/nobody/start".into(), String::new(), 404, ""),
        (format!("sessions/{id}/pause"), String::new(), 409, ""),
    ] {
        let (found, problem) = server.post_text(&path, &body);
        assert_eq!(found, status, "{path} {problem}");
        assert_eq!(problem["status"], status, "{problem}");
        assert!(problem["title"].is_string() && problem["detail"].is_string(), "{problem}");
        if !field.is_empty() {
            assert_eq!(problem["field"], field, "{problem}");
        }
    }
    assert_eq!(server.post(&format!("sessions/{id}/start"), &Value::Null).0, 200);
    assert_eq!(server.post(&format!("sessions/{id}/start"), &Value::Null).0, 409, "a second start");
    for (path, status) in [
        ("sessions/nobody", 404),
        ("nothing/here", 404),
        (&format!("sessions/{id}/arena.png?width=0"), 422),
        (&format!("sessions/{id}/arena.png?width=5000"), 422),
        (&format!("sessions/{id}/trials/99"), 404),
        (&format!("sessions/{id}/report.parquet"), 404),
    ] {
        let (found, problem) = server.get(path);
        assert_eq!((found, &problem["status"]), (status, &json!(status)), "{path} {problem}");
    }
    assert_eq!(server.get("experiments").0, 200, "the server goes on");
}

#[test]
fn a_world_of_ones_own_is_used_or_refused_with_the_place_at_fault() {
    let laboratory = root().join("assets/worlds/laboratory.toml");
    let laboratory = std::fs::read_to_string(laboratory).expect("the laboratory is there");
    let folder = tempfile::tempdir().expect("a temporary folder");
    let worlds = folder.path().join("worlds");
    std::fs::create_dir(&worlds).expect("can be made");
    for (name, from, to) in [
        ("mine", "title = \"Laboratory\"", "title = \"My own\""),
        ("walled", "[home]\nx = 0.0", "[home]\nx = 5.5"),
        ("unreachable", "[[3.5, 0.3], [3.75, 0.3]", "[[3.5, -1.0], [3.75, -1.0]"),
        ("broken", "[home]", "[home"),
    ] {
        assert!(laboratory.contains(from), "{from}");
        let text = laboratory
            .replace(from, to)
            .replace("name = \"laboratory\"", &format!("name = \"{name}\""));
        std::fs::write(worlds.join(format!("{name}.toml")), text).expect("can be written");
    }
    let server = Server::start_on(folder.path());
    let create = |world: &str| {
        let settings = json!({ "world": world });
        server.post("sessions", &json!({"experiment": EXPERIMENT, "settings": settings}))
    };
    assert_eq!(create("mine").0, 201);
    for (world, word) in [("walled", "home"), ("unreachable", "goal"), ("broken", "line")] {
        let (status, problem) = create(world);
        assert_eq!((status, &problem["field"]), (422, &json!("settings.world")), "{problem}");
        assert!(problem["detail"].to_string().contains(word), "{problem}");
    }
    let (_, experiments) = server.get("experiments");
    let listed = experiments[0]["worlds"].to_string();
    assert!(listed.contains("My own") && !listed.contains("walled"), "{listed}");
}

#[test]
fn every_route_of_the_contract_is_in_the_openapi_document() {
    let server = Server::start();
    let (status, _, body) = server.download("/api/openapi.json");
    assert_eq!(status, 200);
    let document: Value = serde_json::from_slice(&body).expect("JSON");
    assert_eq!(document["servers"][0]["url"], "/api/v1");
    for path in [
        "/experiments",
        "/sessions",
        "/sessions/{id}",
        "/sessions/{id}/start",
        "/sessions/{id}/ticks",
        "/sessions/{id}/{file}",
        "/sessions/{id}/trials/{trial}/{file}",
        "/sessions/{id}/arena.png",
        "/sessions/{id}/stream",
        "/reproductions",
        "/reproductions/{target}",
    ] {
        assert!(!document["paths"][path].is_null(), "{path} is missing");
    }
    assert_eq!(server.download("/healthz").0, 200);
    assert!(String::from_utf8_lossy(&server.download("/metrics").2).contains("# TYPE"));
}

#[test]
fn the_readme_names_what_ci_runs() {
    let readme = std::fs::read_to_string(root().join("README.md")).expect("a README");
    let ci = std::fs::read_to_string(root().join(".ci/run")).expect("a CI script");
    assert!(ci.contains("cargo test") && readme.contains("cargo test"));
}
