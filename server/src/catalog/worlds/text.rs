//! A world as text that people can read on: one polyline or ring a line.

use std::fmt::Write;

use sonarium_core::world::{Axis, RuleFile, WorldFile};
use toml::Value;

/// The TOML text of a world.
#[must_use]
pub fn to_toml(file: &WorldFile) -> String {
    let mut text = String::new();
    for (key, value) in [
        ("name", &file.name),
        ("title", &file.title),
        ("summary", &file.summary),
        ("source", &file.source),
    ] {
        line(&mut text, &format!("{key} = {}", quoted(value)));
    }
    for (key, polygons) in
        [("walls", &file.walls), ("blocks", &file.blocks), ("floor", &file.floor)]
    {
        if !polygons.is_empty() {
            line(&mut text, &format!("\n{key} = ["));
            polygons.iter().for_each(|polygon| line(&mut text, &format!("  {},", points(polygon))));
            line(&mut text, "]");
        }
    }
    if file.regions.is_empty() {
        line(&mut text, "\nregions = []");
    }
    for region in &file.regions {
        let rules: Vec<String> = region.rules.iter().map(rule).collect();
        let name = quoted(&region.name);
        line(&mut text, &format!("\n[[regions]]\nname = {name}\nrules = [{}]", rules.join(", ")));
    }
    let (home, goal) = (file.home, file.goal);
    let (x, y) = (number(home.x), number(home.y));
    let heading = number(home.heading_deg);
    line(&mut text, &format!("\n[home]\nx = {x}\ny = {y}\nheading_deg = {heading}"));
    let (x, y, radius) = (number(goal.x), number(goal.y), number(goal.radius_m));
    line(&mut text, &format!("\n[goal]\nx = {x}\ny = {y}\nradius_m = {radius}"));
    text
}

fn line(text: &mut String, line: &str) {
    // Writing to a string cannot fail.
    let _ = writeln!(text, "{line}");
}

fn points(polygon: &[[f64; 2]]) -> String {
    let points = polygon.iter().map(|[x, y]| format!("[{}, {}]", number(*x), number(*y)));
    format!("[{}]", points.collect::<Vec<_>>().join(", "))
}

fn rule(rule: &RuleFile) -> String {
    let axis = rule.axis.map(|axis| match axis {
        Axis::X => "axis = \"x\"".to_owned(),
        Axis::Y => "axis = \"y\"".to_owned(),
    });
    let numbers = [("a", rule.a), ("b", rule.b), ("above", rule.above), ("below", rule.below)];
    let numbers =
        numbers.into_iter().filter_map(|(key, value)| Some(format!("{key} = {}", number(value?))));
    let parts: Vec<String> = axis.into_iter().chain(numbers).collect();
    format!("{{ {} }}", parts.join(", "))
}

fn quoted(text: &str) -> String {
    Value::String(text.to_owned()).to_string()
}

fn number(value: f64) -> String {
    Value::Float(value).to_string()
}
