//! All reports of a session in one zip file, written as they are made.

use std::collections::BTreeSet;
use std::io::{self, Read, Seek, Write};

use thiserror::Error;
use zip::CompressionMethod;
use zip::result::ZipError;
use zip::write::{SimpleFileOptions, ZipWriter};

use super::{Picture, SessionReport, TrialReport};
use super::{csv, html, json, trial_csv, trial_html, trial_json};

/// Why an archive could not be written.
#[derive(Debug, Error)]
pub enum ArchiveError {
    /// The target refused the bytes, e.g. because the disk is full.
    #[error("the archive could not be written at {entry}: {source}; is the disk full?")]
    Write {
        /// Entry that was being written.
        entry: String,
        /// What the target said.
        source: ZipError,
    },
    /// A trial could not be read.
    #[error("trial {trial} could not be read for the archive: {source}")]
    Trial {
        /// Its number.
        trial: u32,
        /// Why.
        source: io::Error,
    },
    /// The log could not be read.
    #[error("the log could not be read for the archive: {0}")]
    Log(io::Error),
}

/// Writes all reports of a session into `target` and gives it back.
///
/// `trial` is asked for one trial after the other, so that only one is held at a time; it answers
/// `None` when the log no longer holds the trial, and the README says so. `log` is copied as it is.
///
/// # Errors
/// When a trial or the log cannot be read, or the target cannot be written.
pub fn zip<W: Write + Seek>(
    report: &SessionReport,
    trial: impl FnMut(u32) -> io::Result<Option<TrialReport>>,
    log: Option<&mut dyn Read>,
    target: W,
) -> Result<W, ArchiveError> {
    let mut archive = Archive::new(target);
    archive.text("report.html", &html(report))?;
    archive.text("report.json", &json(report))?;
    archive.text("trials.csv", &csv(report))?;
    archive.pictures(&report.pictures)?;
    if let Some(network) = &report.network {
        archive.text("network.json", network)?;
    }
    let missing = archive.trials(report, trial)?;
    if let Some(log) = log {
        archive.log(log)?;
    }
    let readme = super::readme::text(report, &archive.names, &missing);
    archive.text("README.txt", &readme)?;
    archive.finish()
}

/// A picture's place; the number keeps two pictures of one name apart.
fn picture_path(index: usize, picture: &Picture) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() || "-_".contains(c) { c } else { '-' };
    let name: String = picture.name.chars().map(plain).collect();
    format!("pictures/{:02}-{name}.png", index + 1)
}

pub(super) struct Archive<W: Write + Seek> {
    writer: ZipWriter<W>,
    names: BTreeSet<String>,
}

impl<W: Write + Seek> Archive<W> {
    pub(super) fn new(target: W) -> Self {
        Self { writer: ZipWriter::new(target), names: BTreeSet::new() }
    }

    /// Adds pictures, numbered.
    pub(super) fn pictures(&mut self, pictures: &[Picture]) -> Result<(), ArchiveError> {
        for (index, picture) in pictures.iter().enumerate() {
            self.stored(&picture_path(index, picture), &picture.png)?;
        }
        Ok(())
    }

    pub(super) fn finish(self) -> Result<W, ArchiveError> {
        self.writer.finish().map_err(|source| failed("its directory", source))
    }

    /// Writes the trials; answers those that the log no longer holds.
    fn trials(
        &mut self,
        report: &SessionReport,
        mut trial: impl FnMut(u32) -> io::Result<Option<TrialReport>>,
    ) -> Result<Vec<u32>, ArchiveError> {
        let mut missing = Vec::new();
        for row in &report.trials {
            let number = row.trial;
            match trial(number).map_err(|source| ArchiveError::Trial { trial: number, source })? {
                Some(found) => self.trial(number, &found)?,
                None => missing.push(number),
            }
        }
        Ok(missing)
    }

    fn trial(&mut self, number: u32, report: &TrialReport) -> Result<(), ArchiveError> {
        let path = format!("trials/{number:03}");
        self.text(&format!("{path}.html"), &trial_html(report))?;
        self.text(&format!("{path}.json"), &trial_json(report))?;
        self.text(&format!("{path}.csv"), &trial_csv(report))?;
        match &report.picture {
            Some(picture) => self.stored(&format!("{path}.png"), &picture.png),
            None => Ok(()),
        }
    }

    pub(super) fn text(&mut self, name: &str, text: &str) -> Result<(), ArchiveError> {
        self.start(name, SimpleFileOptions::default())?;
        self.bytes(name, text.as_bytes())
    }

    /// A PNG file is compressed already.
    fn stored(&mut self, name: &str, png: &[u8]) -> Result<(), ArchiveError> {
        let stored = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
        self.start(name, stored)?;
        self.bytes(name, png)
    }

    /// The log's chunks are compressed already, and it may pass 4 GiB.
    pub(super) fn log(&mut self, log: &mut dyn Read) -> Result<(), ArchiveError> {
        let stored = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
        self.start("log.mcap", stored.large_file(true))?;
        let mut block = vec![0; 64 * 1024];
        loop {
            match log.read(&mut block) {
                Ok(0) => return Ok(()),
                Ok(read) => self.bytes("log.mcap", &block[..read])?,
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => return Err(ArchiveError::Log(error)),
            }
        }
    }

    fn start(&mut self, name: &str, options: SimpleFileOptions) -> Result<(), ArchiveError> {
        self.names.insert(name.to_owned());
        let options = options.unix_permissions(0o644);
        self.writer.start_file(name, options).map_err(|source| failed(name, source))
    }

    fn bytes(&mut self, name: &str, bytes: &[u8]) -> Result<(), ArchiveError> {
        self.writer.write_all(bytes).map_err(|source| failed(name, source.into()))
    }
}

fn failed(entry: &str, source: ZipError) -> ArchiveError {
    ArchiveError::Write { entry: entry.to_owned(), source }
}
