//! `sonarium rules`.

use std::io::Read;
use std::path::{Path, PathBuf};

use clap::{Args, Subcommand, ValueEnum};
use sonarium_core::fuzzy::RuleBase;

use super::{Failure, output};
use crate::catalog::Catalog;

#[derive(Args, Debug)]
pub(super) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// List the rule bases in the program
    List,
    /// Print one of them, to be changed
    Show {
        /// Name of the rule base
        name: String,
        /// Form to print it in
        #[arg(long, default_value = "rules")]
        to: Form,
    },
    /// Check a rule file or FLL: its first fault with the line, or what it holds
    Check {
        /// File; `-` is standard input
        file: PathBuf,
    },
    /// Print a rule file or FLL in another form
    Convert {
        /// File; `-` is standard input
        file: PathBuf,
        /// Form to print it in
        #[arg(long)]
        to: Form,
    },
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Form {
    /// As the navigator's rules are written
    Rules,
    /// FuzzyLite Language
    Fll,
}

pub(super) fn rules(arguments: &Arguments) -> Result<(), Failure> {
    match &arguments.command {
        Command::List => {
            let catalog = Catalog::load(None)?;
            catalog.rules().iter().try_for_each(|rules| output::line(&summary(rules)))
        }
        Command::Show { name, to } => show(name, *to),
        Command::Check { file } => output::line(&summary(&read(file)?)),
        Command::Convert { file, to } => print(&read(file)?, *to),
    }
}

fn show(name: &str, to: Form) -> Result<(), Failure> {
    let known = Catalog::load(None)?.rules();
    match known.iter().find(|rules| rules.name() == name) {
        Some(rules) => print(rules, to),
        None => {
            let names: Vec<&str> = known.iter().map(|rules| rules.name()).collect();
            let names = names.join(", ");
            Err(Failure::Input(format!("there is no rule base `{name}`; there is {names}")))
        }
    }
}

fn print(rules: &RuleBase, to: Form) -> Result<(), Failure> {
    let text = match to {
        Form::Rules => rules.to_text(),
        Form::Fll => rules.to_fll(),
    };
    output::line(text.trim_end())
}

fn summary(rules: &RuleBase) -> String {
    let inputs: Vec<&str> = rules.inputs().iter().map(|input| input.name.as_str()).collect();
    let outputs: Vec<&str> = rules.outputs().iter().map(|output| output.name.as_str()).collect();
    format!(
        "{}  {}: {} rules, {} -> {}",
        rules.name(),
        rules.title(),
        rules.rules().len(),
        inputs.join(", "),
        outputs.join(", ")
    )
}

fn read(file: &Path) -> Result<RuleBase, Failure> {
    let bad = |error: String| Failure::Input(format!("{}: {error}", file.display()));
    let text = if file == Path::new("-") {
        let mut text = String::new();
        std::io::stdin().read_to_string(&mut text).map(|_| text)
    } else {
        std::fs::read_to_string(file)
    };
    let text = text.map_err(|error| bad(error.to_string()))?;
    RuleBase::from_text(&text).map_err(|error| bad(error.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn either_form_is_read_and_a_fault_has_its_line() {
        let folder = tempfile::TempDir::new().expect("a folder");
        let catalog = Catalog::load(None).expect("the embedded files");
        let navigator = catalog.rules().remove(0);
        let written = |name: &str, text: String| {
            let path = folder.path().join(name);
            std::fs::write(&path, text).expect("a file");
            path
        };
        for text in [navigator.to_text(), navigator.to_fll()] {
            let read = read(&written("good", text)).expect("sound rules");
            assert!(summary(&read).contains("972 rules, far_left, left"), "{}", summary(&read));
        }
        let broken = navigator.to_text().replacen("-> 13 3.5", "-> 13 east", 1);
        let line = broken.lines().position(|line| line.contains("east")).expect("a line") + 1;
        let says = match read(&written("bad", broken)) {
            Err(Failure::Input(says)) => says,
            other => panic!("{other:?}"),
        };
        assert!(says.contains(&format!("rules, line {line}:")), "{says}");
    }
}
