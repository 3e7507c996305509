//! `sonarium reproduce`.

mod folder;
mod markdown;
mod text;

use std::path::PathBuf;

use clap::Args;

use super::{Failure, cores, output};
use crate::reproduce::{Kept, ReproductionError, TARGETS, known_targets, target};

#[derive(Args, Debug)]
pub(super) struct Arguments {
    #[arg(help = format!("What to compute again: all, or one of {}", known_targets().replace('`', "")))]
    target: String,
    /// Print one JSON object a target
    #[arg(long)]
    json: bool,
    /// Print Markdown tables, as the documents hold them
    #[arg(long, conflicts_with = "json")]
    markdown: bool,
    /// Folder for rows and curves as CSV, pictures as PNG and everything as JSON, one folder a target
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

pub(super) fn reproduce(arguments: &Arguments) -> Result<(), Failure> {
    let targets = match arguments.target.as_str() {
        "all" => TARGETS.to_vec(),
        name => vec![target(name)?],
    };
    let folder = arguments.out.as_deref().map(folder::Folder::new).transpose()?;
    let kept = Kept::default();
    for target in targets {
        let progress =
            output::progress(u64::from(target.work()), &format!("{}s", target.unit.name()));
        let findings = target.run(cores(), &kept, &|| progress.inc(1));
        progress.finish_and_clear();
        let findings = findings?;
        let result = findings.wire(target);
        if arguments.json {
            output::json(&result)?;
        } else if arguments.markdown {
            output::line(&markdown::document(target, &result))?;
        } else {
            output::line(&text::table(target, &result))?;
        }
        if let Some(folder) = &folder {
            folder.write(target, &findings)?;
        }
    }
    Ok(())
}

impl From<ReproductionError> for Failure {
    fn from(error: ReproductionError) -> Self {
        match error {
            ReproductionError::Unknown { .. } => Self::Input(format!("{error}, and `all`")),
            ReproductionError::NoPicture { .. } | ReproductionError::Broken(_) => {
                Self::Failed(error.to_string())
            }
        }
    }
}

#[cfg(test)]
fn sample_row(name: &str, verdict: crate::wire::Verdict) -> crate::wire::ReproductionRow {
    crate::wire::ReproductionRow {
        name: name.into(),
        published: Some(1.9),
        required: None,
        ours: 2.0,
        low: 1.0,
        high: 3.0,
        n: 200,
        unit: String::new(),
        verdict,
        reading: format!("a reading of {name} | with a bar"),
    }
}
