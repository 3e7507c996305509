//! Worlds of one's own over HTTP.

use axum::body::Body;
use axum::http::{Request, StatusCode, header};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use serde_json::{Value as Json, json};

use super::problem;
use crate::testing::{Answer, House};
use crate::wire::{TraceDraft, WorldCheck};

/// The laboratory under another name.
async fn copy(house: &House, name: &str) -> Json {
    let mut world = house.get("/api/v1/worlds/laboratory").await.json();
    world["name"] = name.into();
    world
}

async fn put(house: &House, name: &str, world: &Json) -> Answer {
    house.request("PUT", &format!("/api/v1/worlds/{name}"), Some(world.to_string())).await
}

async fn send(
    house: &House,
    method: &str,
    path: &str,
    kind: &str,
    body: impl Into<Body>,
) -> Answer {
    let request = Request::builder().method(method).uri(path).header(header::CONTENT_TYPE, kind);
    house.send(request.body(body.into()).expect("a request")).await
}

#[tokio::test]
async fn a_world_is_saved_run_in_and_deleted() {
    let house = House::new();
    let world = copy(&house, "mine").await;
    let saved = put(&house, "mine", &world).await;
    assert_eq!(saved.status, StatusCode::CREATED);
    assert_eq!(saved.json()["built_in"], false);
    assert_eq!(saved.json()["bounds_m"], json!([-1.5, -3.5, 5.55, 2.5]));
    assert_eq!(put(&house, "mine", &world).await.status, StatusCode::OK);

    let names = |list: Json| -> Vec<String> {
        let names = list.as_array().expect("a list").iter();
        names.map(|world| world["name"].as_str().unwrap_or_default().to_owned()).collect()
    };
    let listed = names(house.get("/api/v1/worlds").await.json());
    assert_eq!(
        (listed[0].as_str(), listed.last().map(String::as_str)),
        ("laboratory", Some("mine"))
    );
    let experiment = house.get("/api/v1/experiments/minimum-cost-path").await.json();
    assert!(names(experiment["worlds"].clone()).contains(&"mine".to_owned()));
    assert_eq!(house.get("/api/v1/worlds/mine").await.json(), world);
    let picture = house.get("/api/v1/worlds/mine/picture.png?width=99").await;
    assert_eq!(picture.bytes[16..20], [0, 0, 0, 99], "the width");

    let body = json!({ "experiment": "minimum-cost-path", "settings": { "world": "mine" } });
    let session = house.post("/api/v1/sessions", body).await;
    assert_eq!(session.status, StatusCode::CREATED);
    let deleted = house.request("DELETE", "/api/v1/worlds/mine", None).await;
    assert_eq!(deleted.status, StatusCode::NO_CONTENT);
    assert_eq!(problem(&house.get("/api/v1/worlds/mine").await), (404, Json::Null));
    // The session keeps its world.
    let id = session.json()["id"].as_str().expect("an identifier").to_owned();
    let arena = house.get(&format!("/api/v1/sessions/{id}/arena.png")).await;
    assert_eq!(arena.status, StatusCode::OK);
}

#[tokio::test]
async fn toml_goes_in_and_comes_out_as_it_is() {
    let house = House::new();
    let text = house.get("/api/v1/worlds/laboratory?format=toml").await;
    assert_eq!(text.kind, "application/toml");
    let text = String::from_utf8_lossy(&text.bytes).replace("\"laboratory\"", "\"mine\"");
    assert!(text.starts_with('#'), "with its comments");
    let toml = "application/toml";
    let saved = send(&house, "PUT", "/api/v1/worlds/mine", toml, text.clone()).await;
    assert_eq!(saved.status, StatusCode::CREATED);
    let accepting = Request::get("/api/v1/worlds/mine").header(header::ACCEPT, toml);
    let back = house.send(accepting.body(Body::empty()).expect("a request")).await;
    assert_eq!(back.bytes, text);
    let broken = text.replace("[home]", "[home");
    let answer = send(&house, "PUT", "/api/v1/worlds/mine", toml, broken.clone()).await;
    assert_eq!(problem(&answer), (400, Json::Null));
    assert!(
        answer.json()["detail"].as_str().is_some_and(|text| text.contains("line")),
        "{}",
        answer.json()
    );
    let answer = send(&house, "POST", "/api/v1/worlds/check", toml, broken).await;
    assert_eq!(problem(&answer), (400, Json::Null));
}

#[tokio::test]
async fn worlds_that_cannot_be_used_are_refused_with_field_and_place() {
    let house = House::new();
    let good = copy(&house, "mine").await;
    let with = |pointer: &str, value: Json| {
        let mut world = good.clone();
        *world.pointer_mut(pointer).expect("it is there") = value;
        world
    };
    for (world, status, field, place) in [
        (with("/home/x", json!(-1.4)), 422, "home", json!({ "x_m": -1.4, "y_m": 0.0 })),
        (with("/goal/y", json!(-9.0)), 422, "goal", json!({ "x_m": 4.0, "y_m": -9.0 })),
        (with("/goal/radius_m", json!(0.0)), 422, "goal.radius_m", Json::Null),
        (with("/name", json!("other")), 422, "name", Json::Null),
        (
            with("/regions/1/rules", json!([{ "axis": "x", "above": 99.0 }])),
            422,
            "regions[1]",
            Json::Null,
        ),
        (
            with("/regions/1/rules", json!([{ "axis": "x", "above": 4.0 }])),
            422,
            "regions[1]",
            Json::Null,
        ),
        (with("/regions/0/rules/0/axis", json!("z")), 400, "regions[0].rules[0].axis", Json::Null),
        (with("/walls/0/0", json!([1.0])), 400, "walls[0][0]", Json::Null),
        (with("/home/x", json!("left")), 400, "home.x", Json::Null),
    ] {
        let answer = put(&house, "mine", &world).await;
        assert_eq!(problem(&answer), (status, json!(field)), "{}", answer.json());
        assert_eq!(answer.json()["place"], place, "{field}");
    }
    for (name, status) in [("laboratory", 409), ("Mine", 422), ("..%2Fup", 422), ("-x", 422)] {
        let answer = put(&house, name, &copy(&house, name).await).await;
        assert_eq!(problem(&answer), (status, json!("name")), "{name}");
    }
    let request = |method: &str| Request::builder().method(method).uri("/api/v1/worlds/mine");
    let careful = || {
        let request = request("PUT").header(header::IF_NONE_MATCH, "*");
        let request = request.header(header::CONTENT_TYPE, "application/json");
        request.body(Body::from(good.to_string())).expect("a request")
    };
    assert_eq!(house.send(careful()).await.status, StatusCode::CREATED);
    assert_eq!(problem(&house.send(careful()).await), (412, json!("name")));
    let form = send(&house, "PUT", "/api/v1/worlds/mine", "text/plain", "x").await;
    assert_eq!(problem(&form), (415, Json::Null));
    let delete = house.request("DELETE", "/api/v1/worlds/laboratory", None).await;
    assert_eq!(problem(&delete), (409, json!("name")));
    let delete = house.request("DELETE", "/api/v1/worlds/none", None).await;
    assert_eq!(problem(&delete), (404, Json::Null));
}

#[tokio::test]
async fn a_check_finds_everything_wrong_and_what_a_good_world_is_like() {
    let house = House::new();
    let mut world = copy(&house, "mine").await;
    let check = |world: &Json| house.post("/api/v1/worlds/check", world.clone());
    let good: WorldCheck = serde_json::from_value(check(&world).await.json()).expect("a check");
    assert!(good.ok && good.problems.is_empty() && good.taken.is_none());
    assert_eq!(good.regions.len(), 4);
    let way_m = good.way_m.expect("there is a way");
    assert!(way_m > good.distance_m, "{way_m} {}", good.distance_m);
    world["name"] = "laboratory".into();
    world["regions"][0]["rules"][0]["above"] = 99.0.into();
    world["goal"]["y"] = (-9.0).into();
    let bad: WorldCheck = serde_json::from_value(check(&world).await.json()).expect("a check");
    let fields: Vec<&str> = bad.problems.iter().map(|problem| problem.field.as_str()).collect();
    assert_eq!((bad.ok, fields), (false, vec!["regions[0]", "goal"]));
    let goal = &bad.problems[1];
    assert!(
        goal.place.is_some_and(|at| at.y_m == -9.0) && goal.nearest.is_some_and(|at| at.y_m > -3.5)
    );
    assert_eq!(bad.taken.as_deref(), Some("built_in"));
}

#[tokio::test]
async fn regions_are_proposed_that_can_be_saved() {
    let house = House::new();
    let mut world = copy(&house, "mine").await;
    world["regions"] = json!([]);
    let proposal = house.post("/api/v1/worlds/regions", world.clone()).await.json();
    assert_eq!(
        proposal["regions"].as_array().map(Vec::len),
        proposal["shapes"].as_array().map(Vec::len)
    );
    world["regions"] = proposal["regions"].clone();
    assert_eq!(put(&house, "mine", &world).await.status, StatusCode::CREATED);
    let most = house.post("/api/v1/worlds/regions?most=0", world.clone()).await;
    assert_eq!(problem(&most), (422, json!("most")));
    world["home"]["x"] = (-1.4).into();
    let walled = house.post("/api/v1/worlds/regions", world).await;
    assert_eq!(problem(&walled), (422, json!("home")));
}

const YAML: &str = "image: hall.pgm\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 0\n\
                    occupied_thresh: 0.65\nfree_thresh: 0.196\n";

/// A hall of 3 x 2 m.
fn hall() -> Vec<u8> {
    let wall = |k: usize| k.is_multiple_of(32) || k % 32 == 31 || k / 32 == 0 || k / 32 == 21;
    let pixels = (0..32 * 22).map(|k| if wall(k) { 0 } else { 254 });
    b"P5 32 22 255\n".iter().copied().chain(pixels).collect()
}

/// A form with parts.
fn form(parts: &[(&str, &[u8])]) -> Vec<u8> {
    let mut body = Vec::new();
    for (name, content) in parts {
        let head = format!("--edge\r\nContent-Disposition: form-data; name=\"{name}\"\r\n\r\n");
        body.extend_from_slice(head.as_bytes());
        body.extend_from_slice(content);
        body.extend_from_slice(b"\r\n");
    }
    body.extend_from_slice(b"--edge--\r\n");
    body
}

#[tokio::test]
async fn a_map_is_traced_from_json_and_from_a_form_alike() {
    let house = House::new();
    let image = BASE64_STANDARD.encode(hall());
    let traced = house.post("/api/v1/worlds/trace", json!({ "image_base64": image, "yaml": YAML }));
    let draft = traced.await.json();
    let parts = form(&[("image", &hall()), ("yaml", YAML.as_bytes())]);
    let kind = "multipart/form-data; boundary=edge";
    let same = send(&house, "POST", "/api/v1/worlds/trace", kind, parts).await;
    assert_eq!(same.json(), draft);
    let draft: TraceDraft = serde_json::from_value(draft).expect("a draft");
    assert_eq!(draft.world.floor, [[[0.1, 0.1], [3.1, 0.1], [3.1, 2.1], [0.1, 2.1]]]);
    let png = BASE64_STANDARD.decode(&draft.picture.png_base64).expect("base 64");
    assert!(png.starts_with(b"\x89PNG"));
    let world = serde_json::to_value(&draft.world).expect("JSON");
    assert_eq!(put(&house, "hall", &world).await.status, StatusCode::CREATED);

    let options = [
        ("image", &hall()[..]),
        ("yaml", YAML.as_bytes()),
        ("crop", b"0,0,2,9"),
        ("name", b"part"),
    ];
    let part = send(&house, "POST", "/api/v1/worlds/trace", kind, form(&options)).await.json();
    assert_eq!((&part["world"]["name"], &part["bounds_m"][2]), (&json!("part"), &json!(2.0)));
}

#[tokio::test]
async fn a_map_that_cannot_be_traced_is_refused_by_field() {
    let house = House::new();
    let kind = "multipart/form-data; boundary=edge";
    let hall = hall();
    let (image, yaml) = (("image", &hall[..]), ("yaml", YAML.as_bytes()));
    let zero = YAML.replace("0.1", "0.0");
    for (parts, status, field) in [
        (&[yaml][..], 400, "image"),
        (&[image], 400, "yaml"),
        (&[image, yaml, ("colour", b"red")], 400, "colour"),
        (&[image, yaml, ("speck_m2", b"small")], 400, "speck_m2"),
        (&[image, yaml, ("speck_m2", b"-1")], 422, "speck_m2"),
        (&[image, yaml, ("crop", b"1,2,3")], 400, "crop"),
        (&[image, yaml, ("crop", b"7,7,8,8")], 422, "crop"),
        (&[("image", b"no picture"), yaml], 422, "image"),
        (&[("image", b"P5 10000 10000 255\n"), yaml], 422, "image"),
        (&[image, ("yaml", zero.as_bytes())], 422, "yaml.resolution"),
        (&[image, ("yaml", b"\tx: [")], 422, "yaml"),
    ] {
        let answer = send(&house, "POST", "/api/v1/worlds/trace", kind, form(parts)).await;
        assert_eq!(problem(&answer), (status, json!(field)), "{}", answer.json());
    }
    let body = json!({ "image_base64": "*", "yaml": YAML });
    let answer = house.post("/api/v1/worlds/trace", body).await;
    assert_eq!(problem(&answer), (422, json!("image_base64")));
    let plain = send(&house, "POST", "/api/v1/worlds/trace", "text/plain", "x").await;
    assert_eq!(problem(&plain), (415, Json::Null));
    let headless = send(&house, "POST", "/api/v1/worlds/trace", "multipart/form-data", "x").await;
    assert_eq!(problem(&headless), (400, Json::Null));
}

#[tokio::test]
async fn maps_may_be_larger_than_other_bodies_but_not_without_limit() {
    let house = House::new();
    let kind = "multipart/form-data; boundary=edge";
    let padded = [hall(), vec![0; 2 << 20]].concat();
    let body = form(&[("image", &padded), ("yaml", YAML.as_bytes())]);
    let answer = send(&house, "POST", "/api/v1/worlds/trace", kind, body).await;
    assert_eq!(answer.status, StatusCode::OK, "{}", answer.json());
    let huge = vec![b' '; (32 << 20) + 1];
    for kind in [kind, "application/json"] {
        let answer = send(&house, "POST", "/api/v1/worlds/trace", kind, huge.clone()).await;
        assert!(matches!(answer.status.as_u16(), 400 | 413), "{}", answer.json());
    }
}

#[tokio::test]
async fn the_picture_of_a_map_stays_with_its_world() {
    let house = House::new();
    let image = BASE64_STANDARD.encode(hall());
    let yaml = YAML.replace("[0, 0, 0]", "[-1.5, 2, 0.5]");
    let traced = house.post("/api/v1/worlds/trace", json!({ "image_base64": image, "yaml": yaml }));
    let mut draft = traced.await.json();
    let picture = draft["picture"].take();
    let at = "/api/v1/worlds/hall/map";
    let keep = async |picture: &Json| house.request("PUT", at, Some(picture.to_string())).await;
    assert_eq!(problem(&keep(&picture).await), (404, Json::Null));
    let saved = put(&house, "hall", &draft["world"]).await;
    assert_eq!(saved.status, StatusCode::CREATED);
    let text = house.get("/api/v1/worlds/hall?format=toml").await.bytes;
    assert_eq!(house.get(at).await.json(), Json::Null);
    assert_eq!(keep(&picture).await.status, StatusCode::NO_CONTENT);
    let kept = house.get(at).await.json();
    // 32 x 22 cells of 0.1 m, turned by 0.5 rad about (-1.5, 2).
    assert_eq!(kept["corner"], json!({ "x_m": -1.5, "y_m": 2.0 }));
    assert_eq!((&kept["width_px"], &kept["height_px"]), (&json!(32), &json!(22)));
    let near = |field: &str, value: f64| (kept[field].as_f64().unwrap_or(0.0) - value).abs() < 1e-9;
    assert!(near("yaw_deg", 90.0 / std::f64::consts::PI), "{kept}");
    assert!(near("width_m", 3.2) && near("height_m", 2.2), "{kept}");
    // What sessions are stored with, and resumed from, is the same text.
    assert_eq!(house.get("/api/v1/worlds/hall?format=toml").await.bytes, text);

    for (field, value, refused) in [
        ("png_base64", json!("%"), "png_base64"),
        ("png_base64", json!(BASE64_STANDARD.encode(hall())), "png_base64"),
        ("width_px", json!(33), "width_px"),
        ("width_m", json!(0), "width_m"),
    ] {
        let mut wrong = picture.clone();
        wrong[field] = value;
        assert_eq!(problem(&keep(&wrong).await), (422, json!(refused)));
    }
    let built_in = house.request("PUT", "/api/v1/worlds/laboratory/map", Some(picture.to_string()));
    assert_eq!(problem(&built_in.await), (409, json!("name")));
    assert_eq!(house.get("/api/v1/worlds/laboratory/map").await.json(), Json::Null);

    let gone = house.request("DELETE", "/api/v1/worlds/hall", None).await;
    assert_eq!(gone.status, StatusCode::NO_CONTENT);
    assert_eq!(problem(&house.get(at).await), (404, Json::Null));
    assert_eq!(put(&house, "hall", &draft["world"]).await.status, StatusCode::CREATED);
    assert_eq!(house.get(at).await.json(), Json::Null, "a new world has no map of an old one");
    assert_eq!(keep(&picture).await.status, StatusCode::NO_CONTENT);
    assert_eq!(house.request("DELETE", at, None).await.status, StatusCode::NO_CONTENT);
    assert_eq!(house.get(at).await.json(), Json::Null);
}
