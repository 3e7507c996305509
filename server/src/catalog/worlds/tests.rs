use std::fs;

use proptest::prelude::*;
use sonarium_core::world::{Axis, GoalFile, HomeFile, RegionFile, RuleFile, WorldFile};

use super::*;

fn laboratory(name: &str) -> WorldFile {
    let worlds = Worlds::load(None).expect("the embedded ones are fine");
    let text = worlds.text(DEFAULT_WORLD).expect("it is there");
    WorldFile { name: name.to_owned(), ..parse(&text).expect("it can be read") }
}

#[test]
fn a_broken_world_of_the_users_is_refused_when_chosen() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("bad.toml"), "name = ").expect("written");
    let worlds = Worlds::load(Some(folder.path())).expect("the embedded ones are fine");
    let robots = super::super::robots::embedded().expect("the embedded ones are fine");
    let infos = worlds.infos(DEFAULT_WORLD, &robots["b21"]);
    assert!(!infos.is_empty() && infos.iter().all(|info| info.name != "bad"));
    let error = worlds.get("bad").expect_err("it is broken");
    assert_eq!(error.field, "settings.world");
    assert!(error.message.starts_with("the world `bad` cannot be used: "), "{error}");
    assert!(worlds.get(DEFAULT_WORLD).is_ok());
    let summaries = worlds.summaries();
    let bad = summaries.last().expect("it is listed");
    assert!(bad.name == "bad" && bad.problem.is_some() && !bad.built_in);
}

#[test]
fn an_unknown_world_is_refused_with_the_known_ones() {
    let worlds = Worlds::load(None).expect("the embedded ones are fine");
    let error = worlds.get("moon").expect_err("there is none");
    assert!(error.message.contains("`laboratory`"), "{error}");
}

#[test]
fn a_saved_world_is_there_at_once_and_follows_its_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let own = folder.path().join("worlds");
    let worlds = Worlds::load(Some(&own)).expect("the embedded ones are fine");
    let save = |title: &str| {
        let file = WorldFile { title: title.to_owned(), ..laboratory("mine") };
        worlds.save("mine", to_toml(&file), false).expect("it is sound")
    };
    assert!(save("First").1, "new");
    assert_eq!(worlds.get("mine").expect("saved").world.title(), "First");
    assert!(!save("Second").1, "replaced");
    assert_eq!(worlds.get("mine").expect("saved").world.title(), "Second");
    // Another program edits the file.
    let text =
        fs::read_to_string(own.join("mine.toml")).expect("a file").replace("Second", "Edited");
    fs::write(own.join("mine.toml"), text).expect("written");
    assert_eq!(worlds.get("mine").expect("saved").world.title(), "Edited");
    assert_eq!(fs::read_dir(&own).expect("a folder").count(), 1, "nothing is left beside it");
    worlds.delete("mine").expect("it is there");
    assert!(matches!(worlds.delete("mine"), Err(WorldsError::Missing { .. })));
    assert!(worlds.get("mine").is_err());
}

#[test]
fn names_that_are_taken_or_lead_elsewhere_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let worlds = Worlds::load(Some(folder.path())).expect("the embedded ones are fine");
    let save = |name: &str| worlds.save(name, to_toml(&laboratory(name)), true);
    for name in ["", "../up", "a/b", ".hidden", "-x", "Big", "a b", "ä", &"x".repeat(65)] {
        assert!(matches!(save(name), Err(WorldsError::Name { .. })), "{name:?}");
        assert!(worlds.get(name).is_err() && worlds.text(name).is_err());
    }
    assert!(matches!(save(DEFAULT_WORLD), Err(WorldsError::BuiltIn { .. })));
    assert!(matches!(worlds.delete(DEFAULT_WORLD), Err(WorldsError::BuiltIn { .. })));
    save("mine").expect("it is free");
    assert!(matches!(save("mine"), Err(WorldsError::Exists { .. })));
    assert!(matches!(
        Worlds::load(None).expect("fine").save("mine", to_toml(&laboratory("mine")), false),
        Err(WorldsError::NoFolder)
    ));
    let misnamed = worlds.save("other", to_toml(&laboratory("mine")), false);
    assert!(matches!(misnamed, Err(WorldsError::Broken(broken)) if broken.problem.field == "name"));
}

#[test]
fn a_name_is_made_of_any_text() {
    for (text, expected) in
        [("Office_2010 (old)", "office-2010--old"), ("--", "map"), ("", "map"), ("a.b", "a-b")]
    {
        assert_eq!(world_name(text), expected);
        assert!(is_name(&world_name(text)));
    }
}

fn any_points(least: usize) -> impl Strategy<Value = Vec<Vec<[f64; 2]>>> {
    let point = prop::array::uniform2(-1e3..1e3f64);
    prop::collection::vec(prop::collection::vec(point, least..6), 0..3)
}

proptest! {
    #[test]
    fn the_text_of_a_world_says_the_same(
        names in prop::array::uniform4(".*"),
        walls in any_points(2), blocks in any_points(3), floor in any_points(3),
        numbers in prop::array::uniform6(prop::num::f64::NORMAL | prop::num::f64::ZERO),
    ) {
        let [name, title, summary, source] = names;
        let [x, y, heading_deg, radius_m, a, above] = numbers;
        let rules = vec![
            RuleFile { axis: Some(Axis::Y), above: Some(above), ..RuleFile::default() },
            RuleFile { a: Some(a), b: Some(1.0), below: Some(y), ..RuleFile::default() },
        ];
        let regions = vec![
            RegionFile { name: title.clone(), rules },
            RegionFile { name: "else".to_owned(), rules: Vec::new() },
        ];
        let (home, goal) = (HomeFile { x, y, heading_deg }, GoalFile { x: y, y: x, radius_m });
        let file =
            WorldFile { name, title, summary, source, walls, blocks, floor, regions, home, goal };
        prop_assert_eq!(parse(&to_toml(&file)), Ok(file));
    }
}
