//! Rule bases in the FuzzyLite Language (FLL), for other fuzzy engines.
//!
//! Written is everything that the language has a word for; the unit of a variable stands in its
//! description, and why a rule is as it is gets lost. Read is what a [`RuleBase`] can be: trapezoids,
//! triangles, and constants as consequents; one rule block whose rules join one set of every input by
//! `and` and conclude one consequent of every output.

use std::fmt::Write as _;

use super::{Consequent, Input, NamedSet, Output, Rule, RuleBase, RuleError, Set};
use crate::fuzzy::{Defuzzifier, Norms, Trapezoid, Triangle};

impl RuleBase {
    /// The rule base as FLL.
    #[must_use]
    pub fn to_fll(&self) -> String {
        let mut text = format!("Engine: {}\n", self.name);
        for input in &self.inputs {
            head(&mut text, "InputVariable", &input.name, &input.unit, input.range);
            terms(&mut text, &input.sets);
        }
        let constants: Vec<_> =
            (0..self.outputs.len()).map(|output| self.constants(output)).collect();
        for (output, constants) in self.outputs.iter().zip(&constants) {
            head(&mut text, "OutputVariable", &output.name, &output.unit, output.range);
            let (aggregation, defuzzifier) = self.aggregation(output);
            put(&mut text, &format!("  aggregation: {aggregation}\n  defuzzifier: {defuzzifier}"));
            put(&mut text, "  default: nan\n  lock-previous: false");
            terms(&mut text, &output.sets);
            for (name, value) in constants {
                put(&mut text, &format!("  term: {name} Constant {value}"));
            }
        }
        let (conjunction, implication) = match self.norms {
            Norms::Zadeh => ("Minimum", "Minimum"),
            Norms::Algebraic => ("AlgebraicProduct", "AlgebraicProduct"),
        };
        put(&mut text, "RuleBlock: rules\n  enabled: true");
        put(&mut text, &format!("  conjunction: {conjunction}\n  disjunction: none"));
        put(&mut text, &format!("  implication: {implication}\n  activation: General"));
        for rule in &self.rules {
            put(&mut text, &format!("  rule: {}", self.fll_rule(rule, &constants)));
        }
        text
    }

    fn aggregation(&self, output: &Output) -> (&'static str, &'static str) {
        if output.sets.is_empty() {
            return ("none", "WeightedAverage TakagiSugeno");
        }
        let aggregation = match self.norms {
            Norms::Zadeh => "Maximum",
            Norms::Algebraic => "UnboundedSum",
        };
        let defuzzifier = match self.defuzzifier {
            Defuzzifier::CentreOfArea => "Centroid 720",
            Defuzzifier::MeanOfMaximum => "MeanOfMaximum 720",
        };
        (aggregation, defuzzifier)
    }

    /// The different values that rules conclude about an output, each with a name.
    fn constants(&self, output: usize) -> Vec<(String, f64)> {
        let concluded = self.rules.iter().filter_map(|rule| match rule.then[output] {
            Consequent::Value(value) => Some(value),
            Consequent::Set(_) => None,
        });
        let mut values: Vec<f64> = concluded.collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        values.into_iter().enumerate().map(|(index, value)| (format!("c{index}"), value)).collect()
    }

    fn fll_rule(&self, rule: &Rule, constants: &[Vec<(String, f64)>]) -> String {
        let when = self.inputs.iter().zip(&rule.when);
        let when = when.map(|(input, &set)| format!("{} is {}", input.name, input.sets[set].name));
        let outputs = self.outputs.iter().zip(&rule.then).zip(constants);
        let then = outputs.map(|((output, consequent), constants)| {
            let name = match *consequent {
                Consequent::Set(set) => &output.sets[set].name,
                Consequent::Value(value) => {
                    let named = constants.iter().find(|(_, constant)| *constant == value);
                    &named.expect("every value concluded is among the constants").0
                }
            };
            format!("{} is {name}", output.name)
        });
        let joined = |words: Vec<String>| words.join(" and ");
        format!("if {} then {}", joined(when.collect()), joined(then.collect()))
    }

    /// Reads and checks a text in either form: FLL where its first line, comments aside, names an engine.
    ///
    /// # Errors
    /// As [`Self::parse`] and [`Self::from_fll`].
    pub fn from_text(text: &str) -> Result<Self, RuleError> {
        let content = |line: &'_ str| line.split('#').next().unwrap_or_default().trim().to_owned();
        let first = text.lines().map(content).find(|content| !content.is_empty());
        if first.is_some_and(|first| first.starts_with("Engine:")) {
            Self::from_fll(text)
        } else {
            Self::parse(text)
        }
    }

    /// Reads and checks a text in FLL.
    ///
    /// # Errors
    /// The first thing that a rule base cannot be, with its line; without one where it is not in any
    /// line, such as a combination of sets without a rule.
    pub fn from_fll(text: &str) -> Result<Self, RuleError> {
        let mut reader = Reader::default();
        for (index, line) in text.lines().enumerate() {
            let content = line.split('#').next().unwrap_or_default().trim();
            if !content.is_empty() {
                let at = |problem| RuleError { line: Some(index + 1), problem };
                reader.line(content).map_err(at)?;
            }
        }
        let Reader { name, norms, defuzzifier, inputs, outputs, rules, .. } = reader;
        let outputs = outputs.into_iter().map(|(output, _)| output).collect();
        let title = format!("{name}, from FLL");
        Self::new(name, title, norms, defuzzifier, inputs, outputs, rules)
    }
}

fn put(text: &mut String, line: &str) {
    writeln!(text, "{line}").expect("a string takes any text");
}

fn head(text: &mut String, kind: &str, name: &str, unit: &str, [least, most]: [f64; 2]) {
    put(text, &format!("{kind}: {name}\n  description: {unit}\n  enabled: true"));
    put(text, &format!("  range: {least} {most}\n  lock-range: true"));
}

fn terms(text: &mut String, sets: &[NamedSet]) {
    for NamedSet { name, set } in sets {
        let form = match set {
            Set::Trapezoid(t) => format!("Trapezoid {} {} {} {}", t.left, t.from, t.to, t.right),
            Set::Triangle(t) => format!("Triangle {} {} {}", t.left, t.peak, t.right),
            // The language has no singleton; a triangle without width is the same set.
            Set::Singleton(at) => format!("Triangle {at} {at} {at}"),
        };
        put(text, &format!("  term: {name} {form}"));
    }
}

/// What was read so far.
struct Reader {
    name: String,
    norms: Norms,
    defuzzifier: Defuzzifier,
    inputs: Vec<Input>,
    /// With the constants of each.
    outputs: Vec<(Output, Vec<(String, f64)>)>,
    rules: Vec<Rule>,
    blocks: u32,
}

impl Default for Reader {
    fn default() -> Self {
        Self {
            name: "fll".into(),
            norms: Norms::Algebraic,
            defuzzifier: Defuzzifier::CentreOfArea,
            inputs: Vec::new(),
            outputs: Vec::new(),
            rules: Vec::new(),
            blocks: 0,
        }
    }
}

impl Reader {
    fn line(&mut self, content: &str) -> Result<(), String> {
        let Some((key, value)) = content.split_once(':') else {
            return Err(format!("`{content}` must read `key: value`"));
        };
        let (name, value) = (value.trim().to_owned(), value.trim());
        let (unit, range, sets) = ("-".to_owned(), [0.0, 1.0], Vec::new());
        match key {
            "Engine" if !name.is_empty() => self.name = name.replace(char::is_whitespace, "-"),
            "InputVariable" if !self.outputs.is_empty() => {
                return Err("inputs must stand before outputs".into());
            }
            "InputVariable" => self.inputs.push(Input { name, unit, range, sets }),
            "OutputVariable" => {
                self.outputs.push((Output { name, unit, range, sets }, Vec::new()));
            }
            "RuleBlock" => {
                self.blocks += 1;
                if self.blocks > 1 {
                    return Err("there must be one rule block only".into());
                }
            }
            "description" => self.describe(value),
            "range" => self.range(value)?,
            "term" => self.term(value)?,
            "conjunction" => self.norms = conjunction(value)?,
            "defuzzifier" if value.starts_with("MeanOfMaximum") => {
                self.defuzzifier = Defuzzifier::MeanOfMaximum;
            }
            "rule" => self.rule(value)?,
            _ => {}
        }
        Ok(())
    }

    /// The unit and the range of the variable that was named last.
    fn variable(&mut self) -> Option<(&mut String, &mut [f64; 2])> {
        match (self.outputs.last_mut(), self.inputs.last_mut()) {
            (Some((output, _)), _) => Some((&mut output.unit, &mut output.range)),
            (None, Some(input)) => Some((&mut input.unit, &mut input.range)),
            (None, None) => None,
        }
    }

    /// A description of one word is the unit.
    fn describe(&mut self, value: &str) {
        let is_word = !value.is_empty() && !value.contains(char::is_whitespace);
        if let Some((unit, _)) = self.variable().filter(|_| is_word) {
            *unit = value.to_owned();
        }
    }

    fn range(&mut self, value: &str) -> Result<(), String> {
        let numbers = numbers(value.split_whitespace())?;
        let (&[least, most], Some((_, range))) = (numbers.as_slice(), self.variable()) else {
            return Err("a range must be of a variable and have two numbers".into());
        };
        *range = [least, most];
        Ok(())
    }

    fn term(&mut self, value: &str) -> Result<(), String> {
        let mut words = value.split_whitespace();
        let (name, form) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
        let numbers = numbers(words)?;
        let set = match (form, numbers.as_slice()) {
            ("Constant", &[value]) => {
                let (_, constants) =
                    self.outputs.last_mut().ok_or("a constant must be of an output")?;
                constants.push((name.to_owned(), value));
                return Ok(());
            }
            ("Trapezoid", &[left, from, to, right]) => {
                Set::Trapezoid(Trapezoid { left, from, to, right })
            }
            ("Triangle", &[left, peak, right]) if left == right => Set::Singleton(peak),
            ("Triangle", &[left, peak, right]) => Set::Triangle(Triangle { left, peak, right }),
            _ => {
                return Err(format!(
                    "the term `{name}` must be a Trapezoid with four numbers, a Triangle with three \
                     or a Constant with one"
                ));
            }
        };
        let named = NamedSet { name: name.to_owned(), set };
        match (self.outputs.last_mut(), self.inputs.last_mut()) {
            (Some((output, _)), _) => output.sets.push(named),
            (None, Some(input)) => input.sets.push(named),
            (None, None) => return Err("a term must be of a variable".into()),
        }
        Ok(())
    }

    fn rule(&mut self, value: &str) -> Result<(), String> {
        let form = "a rule must read `if INPUT is SET and … then OUTPUT is TERM and …`";
        let (when, then) = value
            .strip_prefix("if ")
            .and_then(|rule| rule.split_once(" then "))
            .ok_or_else(|| form.to_owned())?;
        let said = |text: &str| -> Result<Vec<(String, String)>, String> {
            let each = text.split(" and ").map(|part| part.split_once(" is "));
            let each = each.map(|part| part.map(|(a, b)| (a.trim().into(), b.trim().into())));
            each.collect::<Option<_>>().ok_or_else(|| form.to_owned())
        };
        let (when, then) = (said(when)?, said(then)?);
        let inputs = self.inputs.iter();
        let when = inputs.map(|input| {
            let name = term_of(&when, &input.name)?;
            position(input.sets.iter().map(|set| &set.name), name, &input.name)
        });
        let outputs = self.outputs.iter();
        let then = outputs.map(|(output, constants)| {
            let name = term_of(&then, &output.name)?;
            if let Some((_, value)) = constants.iter().find(|(constant, _)| constant == name) {
                return Ok(Consequent::Value(*value));
            }
            let sets = output.sets.iter().map(|set| &set.name);
            position(sets, name, &output.name).map(Consequent::Set)
        });
        let (when, then) =
            (when.collect::<Result<_, String>>()?, then.collect::<Result<_, String>>()?);
        self.rules.push(Rule { when, then, because: String::new() });
        Ok(())
    }
}

fn conjunction(value: &str) -> Result<Norms, String> {
    match value {
        "Minimum" => Ok(Norms::Zadeh),
        "AlgebraicProduct" => Ok(Norms::Algebraic),
        _ => Err(format!("`conjunction` must be Minimum or AlgebraicProduct, not {value}")),
    }
}

fn numbers<'a>(words: impl Iterator<Item = &'a str>) -> Result<Vec<f64>, String> {
    words.map(|word| word.parse().map_err(|_| format!("`{word}` must be a number"))).collect()
}

/// What is said of a variable, which must be once.
fn term_of<'a>(said: &'a [(String, String)], variable: &str) -> Result<&'a String, String> {
    let mut of = said.iter().filter(|(name, _)| name == variable);
    match (of.next(), of.next()) {
        (Some((_, term)), None) => Ok(term),
        _ => Err(format!("a rule must say once what `{variable}` is")),
    }
}

fn position<'a>(
    mut names: impl Iterator<Item = &'a String>,
    name: &str,
    variable: &str,
) -> Result<usize, String> {
    names
        .position(|known| known == name)
        .ok_or_else(|| format!("`{variable}` has no term `{name}`"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::navigator;

    const FLL: &str = "Engine: small
InputVariable: x
  range: 0.000 1.000
  term: low Trapezoid -1.000 -0.500 0.200 0.400
  term: high Trapezoid 0.200 0.400 1.500 2.000
OutputVariable: y
  range: -1.000 1.000
  defuzzifier: WeightedAverage TakagiSugeno
  term: down Constant -1.000
  term: up Constant 0.500
RuleBlock: rb
  conjunction: AlgebraicProduct
  rule: if x is low then y is down
  rule: if x is high then y is up
";

    #[test]
    fn another_engines_text_is_read() {
        let base = RuleBase::from_fll(FLL).expect("sound");
        // Half low and half high.
        assert!((base.evaluate(&[0.3])[0] - (-0.25)).abs() < 1e-12);
    }

    #[test]
    fn the_navigator_survives_the_way_there_and_back() {
        let base = navigator();
        let back = RuleBase::from_fll(&base.to_fll()).expect("what was written");
        assert_eq!((back.inputs(), back.outputs()), (base.inputs(), base.outputs()));
        for (back, rule) in back.rules().iter().zip(base.rules()) {
            assert_eq!((&back.when, &back.then), (&rule.when, &rule.then));
        }
        let small = RuleBase::parse(
            "rules sets\nnorms zadeh\ninput x m 0 1\n all trapezoid 0 0 1 1\noutput y - 0 2\n one singleton 1\n two triangle 0 1 2\ntable x -> y\nall -> two\n",
        );
        let small = small.expect("sound");
        let back = RuleBase::from_fll(&small.to_fll()).expect("what was written");
        assert_eq!((back.outputs(), back.norms()), (small.outputs(), small.norms()));
    }

    #[test]
    fn what_a_rule_base_cannot_be_is_refused_with_the_line() {
        for (from, to, line, problem) in [
            ("Constant -1.000", "Linear 1 2", Some(9), "must be a Trapezoid"),
            ("AlgebraicProduct", "EinsteinProduct", Some(12), "Minimum or AlgebraicProduct"),
            ("x is low then", "z is low then", Some(13), "say once what `x` is"),
            ("y is down", "y is left", Some(13), "`y` has no term `left`"),
            ("if x is high", "when x is high", Some(14), "a rule must read"),
            ("  rule: if x is high then y is up\n", "", None, "no rule for `high`"),
            ("0.200 0.400 1.500", "0.3 x 1.500", Some(5), "`x` must be a number"),
        ] {
            let error = RuleBase::from_fll(&FLL.replacen(from, to, 1)).expect_err(to);
            assert_eq!(error.line, line, "{error}");
            assert!(error.problem.contains(problem), "{error}");
        }
    }
}
