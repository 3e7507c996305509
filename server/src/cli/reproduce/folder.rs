//! Results as files: CSV, JSON and PNG, one folder a target.

use std::fs;
use std::path::{Path, PathBuf};

use crate::cli::{Failure, refused};
use crate::render::{Backend, Quality, RenderError, Renderer};
use crate::reproduce::{Findings, Target, curves_csv, rows_csv};
use crate::wire::ThemeName;

/// Size of the pictures, pixels.
const PICTURE_PX: (u32, u32) = (960, 860);

/// Where the files go.
pub(super) struct Folder {
    place: PathBuf,
    renderer: Renderer,
}

impl Folder {
    pub(super) fn new(place: &Path) -> Result<Self, Failure> {
        fs::create_dir_all(place).map_err(|error| refused(place, &error))?;
        let backend = Backend::from_environment().map_err(|e| Failure::Input(e.to_string()))?;
        Ok(Self { place: place.to_owned(), renderer: Renderer::start(backend) })
    }

    /// Writes everything that was found for a target.
    pub(super) fn write(&self, target: &Target, findings: &Findings) -> Result<(), Failure> {
        let folder = self.place.join(target.name);
        fs::create_dir_all(&folder).map_err(|error| refused(&folder, &error))?;
        let json = serde_json::to_string_pretty(&findings.wire(target))
            .map_err(|error| Failure::Failed(error.to_string()))?;
        let mut files = vec![
            ("reproduction.json".to_owned(), json.into_bytes()),
            ("rows.csv".to_owned(), rows_csv(&findings.rows).into_bytes()),
        ];
        if !findings.curves.is_empty() {
            files.push(("curves.csv".to_owned(), curves_csv(&findings.curves).into_bytes()));
        }
        let (width, height) = PICTURE_PX;
        for picture in &findings.pictures {
            let view = picture.view.clone();
            let (theme, quality) = (ThemeName::Light, Quality::Balanced);
            let drawn = self.renderer.picture_blocking(view, width, height, theme, quality);
            files.push((format!("{}.png", picture.name), drawn?.to_vec()));
        }
        for (name, bytes) in files {
            let path = folder.join(name);
            fs::write(&path, bytes).map_err(|error| refused(&path, &error))?;
        }
        Ok(())
    }
}

impl From<RenderError> for Failure {
    fn from(error: RenderError) -> Self {
        Self::Failed(error.to_string())
    }
}
