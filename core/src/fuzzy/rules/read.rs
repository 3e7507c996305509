//! Reading and checking the text of a rule base.
//!
//! ```text
//! # a comment
//! rules example
//! title A base of four rules
//! norms algebraic
//! defuzzifier centre-of-area
//!
//! input ahead m 0 2
//!   near trapezoid -inf -inf 0.3 0.6
//!   far trapezoid 0.3 0.6 inf inf
//! input left m 0 2
//!   near trapezoid -inf -inf 0.3 0.6
//!   far trapezoid 0.3 0.6 inf inf
//! output turn deg/s -10 10
//!
//! table ahead left -> turn
//! near near -> -10 | the only way left is right
//! near far -> 10
//! far near -> -3
//! far far -> 0
//! ```

use super::grid::Grid;
use super::{
    Consequent, Input, MOST_INPUTS, MOST_OUTPUTS, MOST_SETS, NamedSet, Output, Rule, RuleBase,
    RuleError,
};
use crate::fuzzy::{Defuzzifier, Norms, Set, Shape, Trapezoid, Triangle};
use crate::settings::{Field, Kind, Value};

impl RuleBase {
    /// Reads and checks a text; the form is the module's own, a line for each set and each rule.
    ///
    /// # Errors
    /// The first thing wrong with its line: a word that means nothing, an unknown set, an input that
    /// belongs to no set somewhere, a combination with two rules or none.
    pub fn parse(text: &str) -> Result<Self, RuleError> {
        let mut reader = Reader::default();
        for (index, line) in text.lines().enumerate() {
            let content = line.split('#').next().unwrap_or_default().trim();
            if !content.is_empty() {
                let at = |problem| RuleError { line: Some(index + 1), problem };
                reader.line(index + 1, content).map_err(at)?;
            }
        }
        reader.finish(text.lines().count())
    }
}

/// What was read so far.
#[derive(Default)]
struct Reader {
    name: Option<String>,
    title: String,
    norms: Option<Norms>,
    defuzzifier: Option<Defuzzifier>,
    inputs: Vec<(usize, Input)>,
    outputs: Vec<(usize, Output)>,
    /// Line of `table`, when the rules began.
    table: Option<usize>,
    /// For each combination, its rule and the line of it.
    rules: Vec<Option<(usize, Rule)>>,
}

type Problem<T> = Result<T, String>;

impl Reader {
    fn line(&mut self, line: usize, content: &str) -> Problem<()> {
        if self.table.is_some() {
            return self.rule(line, content);
        }
        let (word, rest) = content.split_once(char::is_whitespace).unwrap_or((content, ""));
        let rest = rest.trim();
        match word {
            "rules" => self.name = Some(rest.to_owned()),
            "title" => self.title = rest.to_owned(),
            "norms" => self.norms = Some(choice(word, rest)?),
            "defuzzifier" => self.defuzzifier = Some(choice(word, rest)?),
            "input" => self.input(line, rest)?,
            "output" => self.output(line, rest)?,
            "table" => self.begin_table(line, rest)?,
            name => self.set(name, rest)?,
        }
        Ok(())
    }

    fn input(&mut self, line: usize, rest: &str) -> Problem<()> {
        let (name, unit, range) = variable(rest)?;
        if self.inputs.len() == MOST_INPUTS {
            return Err(format!("there can be at most {MOST_INPUTS} inputs"));
        }
        if !self.outputs.is_empty() {
            return Err("inputs must stand before outputs".into());
        }
        if self.inputs.iter().any(|(_, input)| input.name == name) {
            return Err(format!("there is an input `{name}` already"));
        }
        self.inputs.push((line, Input { name, unit, range, sets: Vec::new() }));
        Ok(())
    }

    fn output(&mut self, line: usize, rest: &str) -> Problem<()> {
        let (name, unit, range) = variable(rest)?;
        if self.outputs.len() == MOST_OUTPUTS {
            return Err(format!("there can be at most {MOST_OUTPUTS} outputs"));
        }
        if self.outputs.iter().any(|(_, output)| output.name == name) {
            return Err(format!("there is an output `{name}` already"));
        }
        self.outputs.push((line, Output { name, unit, range, sets: Vec::new() }));
        Ok(())
    }

    /// A set of the variable that was named last.
    fn set(&mut self, name: &str, rest: &str) -> Problem<()> {
        let set = set(name, rest)?;
        let is_output = !self.outputs.is_empty();
        let sets = match (self.outputs.last_mut(), self.inputs.last_mut()) {
            (Some((_, output)), _) => &mut output.sets,
            (_, Some((_, input))) => &mut input.sets,
            _ => return Err(format!("`{name}` must stand below an `input` or an `output`")),
        };
        if sets.len() == MOST_SETS {
            return Err(format!("a variable can have at most {MOST_SETS} sets"));
        }
        if sets.iter().any(|named| named.name == name) {
            return Err(format!("there is a set `{name}` already"));
        }
        if is_output && !set.corners().iter().all(|corner| corner.is_finite()) {
            return Err(format!("`{name}` must have finite corners, since it is of an output"));
        }
        sets.push(NamedSet { name: name.to_owned(), set });
        Ok(())
    }

    fn begin_table(&mut self, line: usize, rest: &str) -> Problem<()> {
        let inputs = self.inputs.iter().map(|(_, input)| input.name.as_str());
        let outputs = self.outputs.iter().map(|(_, output)| output.name.as_str());
        let expected: Vec<&str> = inputs.chain(["->"]).chain(outputs).collect();
        if self.inputs.is_empty() || self.outputs.is_empty() {
            return Err("a table needs at least one `input` and one `output` above it".into());
        }
        if rest.split_whitespace().collect::<Vec<_>>() != expected {
            return Err(format!("the table's head must be `table {}`", expected.join(" ")));
        }
        if let Some((_, empty)) = self.inputs.iter().find(|(_, input)| input.sets.is_empty()) {
            return Err(format!("the input `{}` has no set", empty.name));
        }
        let combinations = self.inputs.iter().map(|(_, input)| input.sets.len()).product();
        self.rules = (0..combinations).map(|_| None).collect();
        self.table = Some(line);
        Ok(())
    }

    fn rule(&mut self, line: usize, content: &str) -> Problem<()> {
        let (content, because) = content.split_once('|').unwrap_or((content, ""));
        let Some((when, then)) = content.split_once("->") else {
            return Err("a rule must read `set … -> consequent …`".into());
        };
        let when = self.when(when)?;
        let rule = Rule { then: self.then(then)?, because: because.trim().to_owned(), when };
        let each = self.inputs.iter().zip(&rule.when);
        let index = each.fold(0, |index, ((_, input), set)| index * input.sets.len() + set);
        if let Some((first, _)) = &self.rules[index] {
            return Err(format!("there is a rule for this combination in line {first} already"));
        }
        self.rules[index] = Some((line, rule));
        Ok(())
    }

    fn when(&self, text: &str) -> Problem<Vec<usize>> {
        let words: Vec<&str> = text.split_whitespace().collect();
        counted(&words, self.inputs.len(), "set", "input")?;
        let each = self.inputs.iter().zip(words);
        each.map(|((_, input), word)| number_of(&input.sets, word, &input.name)).collect()
    }

    fn then(&self, text: &str) -> Problem<Vec<Consequent>> {
        let words: Vec<&str> = text.split_whitespace().collect();
        counted(&words, self.outputs.len(), "consequent", "output")?;
        let each = self.outputs.iter().zip(words);
        each.map(|((_, output), word)| consequent(output, word)).collect()
    }

    fn finish(self, lines: usize) -> Result<RuleBase, RuleError> {
        let fail = |line: usize, problem: String| Err(RuleError { line: Some(line), problem });
        let Some(table) = self.table else {
            return fail(lines.max(1), "there is no `table` of rules".into());
        };
        let Some(name) = self.name.filter(|name| !name.is_empty()) else {
            return fail(1, "the first line must be `rules NAME`".into());
        };
        for (line, input) in &self.inputs {
            if let Some(problem) = gap(input) {
                return fail(*line, problem);
            }
        }
        let inputs: Vec<Input> = self.inputs.into_iter().map(|(_, input)| input).collect();
        let mut rules = Vec::with_capacity(self.rules.len());
        for (index, rule) in self.rules.into_iter().enumerate() {
            match rule {
                Some((_, rule)) => rules.push(rule),
                None => {
                    let sets = combination(&inputs, index);
                    return fail(table, format!("there is no rule for `{sets}`"));
                }
            }
        }
        let outputs: Vec<Output> = self.outputs.into_iter().map(|(_, output)| output).collect();
        let norms = self.norms.unwrap_or(Norms::Algebraic);
        let grid = Grid::new(norms, &inputs, &outputs, &rules);
        let defuzzifier = self.defuzzifier.unwrap_or(Defuzzifier::CentreOfArea);
        let title = self.title;
        Ok(RuleBase { name, title, norms, defuzzifier, inputs, outputs, rules, grid })
    }
}

fn choice<T: Field>(word: &str, name: &str) -> Problem<T> {
    T::from_value(&Value::Choice(name.to_owned())).ok_or_else(|| {
        let Kind::Choice(names) = T::kind(None) else { return format!("`{word}` means nothing") };
        let names: Vec<String> = names.iter().map(|(name, _)| format!("`{name}`")).collect();
        format!("`{word}` must be one of {}, not `{name}`", names.join(", "))
    })
}

fn number(word: &str) -> Problem<f64> {
    let number = word.parse::<f64>().ok().filter(|number| !number.is_nan());
    number.ok_or_else(|| format!("`{word}` must be a number"))
}

fn variable(rest: &str) -> Problem<(String, String, [f64; 2])> {
    let words: Vec<&str> = rest.split_whitespace().collect();
    let [name, unit, least, most] = words.as_slice() else {
        return Err("a variable must read `NAME UNIT LEAST GREATEST`, the unit `-` for none".into());
    };
    let range = [number(least)?, number(most)?];
    if !(range[0].is_finite() && range[1].is_finite() && range[0] < range[1]) {
        return Err(format!("the range of `{name}` must be two finite numbers, the least first"));
    }
    Ok(((*name).to_owned(), (*unit).to_owned(), range))
}

fn set(name: &str, rest: &str) -> Problem<Set> {
    let mut words = rest.split_whitespace();
    let form = words.next().unwrap_or_default();
    let numbers: Option<Vec<f64>> = words.map(|word| number(word).ok()).collect();
    let set = match (form, numbers.as_deref()) {
        ("trapezoid", Some(&[left, from, to, right])) => {
            Set::Trapezoid(Trapezoid { left, from, to, right })
        }
        ("triangle", Some(&[left, peak, right])) => Set::Triangle(Triangle { left, peak, right }),
        ("singleton", Some(&[at])) => Set::Singleton(at),
        _ => {
            return Err(format!(
                "`{name}` must be a set: `trapezoid` with four numbers, `triangle` with three or \
                 `singleton` with one"
            ));
        }
    };
    let corners = set.corners();
    if !corners.is_sorted() {
        return Err(format!("the corners of `{name}` must not descend"));
    }
    let strict =
        matches!(set, Set::Triangle(_)) && (corners[0] == corners[1] || corners[2] == corners[3]);
    let nowhere = corners[1] == f64::INFINITY || corners[2] == f64::NEG_INFINITY;
    let endless = matches!(set, Set::Triangle(_) | Set::Singleton(_))
        && !corners.iter().all(|corner| corner.is_finite());
    let ramp = |outer: f64, inner: f64| outer.is_infinite() && inner.is_finite();
    if strict || nowhere || endless || ramp(corners[0], corners[1]) || ramp(corners[3], corners[2])
    {
        return Err(format!(
            "`{name}` must have sides of finite width; a triangle's must be above 0, a trapezoid's \
             shoulder reads `-inf -inf` or `inf inf`"
        ));
    }
    Ok(set)
}

fn counted(words: &[&str], expected: usize, what: &str, of: &str) -> Problem<()> {
    if words.len() == expected {
        return Ok(());
    }
    Err(format!(
        "a rule must have one {what} for each of the {expected} {of}s, not {}",
        words.len()
    ))
}

fn number_of(sets: &[NamedSet], word: &str, variable: &str) -> Problem<usize> {
    sets.iter().position(|named| named.name == word).ok_or_else(|| {
        let names: Vec<&str> = sets.iter().map(|named| named.name.as_str()).collect();
        format!("`{variable}` has no set `{word}`; there are {}", names.join(", "))
    })
}

fn consequent(output: &Output, word: &str) -> Problem<Consequent> {
    if !output.sets.is_empty() {
        return Ok(Consequent::Set(number_of(&output.sets, word, &output.name)?));
    }
    let value = number(word)?;
    let [least, most] = output.range;
    if (least..=most).contains(&value) {
        return Ok(Consequent::Value(value));
    }
    Err(format!("`{}` must be from {least} to {most}, not {word}", output.name))
}

/// A value of an input that belongs to no set, if there is one.
fn gap(input: &Input) -> Option<String> {
    let [least, most] = input.range;
    let corners = input.sets.iter().flat_map(|named| named.set.corners());
    let within = corners.filter(|corner| (least..=most).contains(corner));
    let mut places: Vec<f64> = within.chain(input.range).collect();
    places.sort_by(f64::total_cmp);
    let middles: Vec<f64> = places.windows(2).map(|pair| f64::midpoint(pair[0], pair[1])).collect();
    let mut every = places.iter().chain(&middles);
    let value =
        every.find(|&&value| input.sets.iter().all(|named| named.set.membership(value) <= 0.0))?;
    Some(format!("`{}` belongs to no set at {value}; every value must belong to one", input.name))
}

/// The names of the sets of a combination.
fn combination(inputs: &[Input], mut index: usize) -> String {
    let mut names = Vec::new();
    for input in inputs.iter().rev() {
        names.push(input.sets[index % input.sets.len()].name.as_str());
        index /= input.sets.len();
    }
    names.reverse();
    names.join(" ")
}
