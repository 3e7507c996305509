//! Pictures as a whole.

use super::laboratory::laboratory;
use super::*;
use crate::wire::ThemeName;

#[test]
#[ignore = "writes pictures to look at"]
fn pictures_to_look_at() {
    let renderer = Renderer::start(Backend::Cpu);
    for theme in [ThemeName::Light, ThemeName::Dark] {
        for (width, height) in [(320, 213), (960, 640), (1000, 700), (4096, 4096)] {
            let picture = renderer
                .picture_blocking(laboratory(20, 130), width, height, theme, Quality::Fast)
                .expect("a picture");
            let name = format!("{theme:?}").to_lowercase();
            let path = std::env::temp_dir().join(format!("render-{name}-{width}x{height}.png"));
            std::fs::write(path, &picture).expect("written");
        }
    }
}
