//! Screenshots of the window.

use std::path::{Path, PathBuf};

use crate::app::SauteApp;
use crate::ui::notice::Notice;
use crate::words::language::Language;

impl SauteApp {
    /// Requests a picture of the window; it is written into the folder of pictures as `saute-N.png`, or downloaded by the
    /// browser.
    pub(crate) fn save_picture(&self, ctx: &egui::Context) {
        #[cfg(not(target_arch = "wasm32"))]
        let folder = self.pictures_folder();
        #[cfg(target_arch = "wasm32")]
        let folder = PathBuf::new();
        request(ctx, &self.notice, self.settings.language, folder);
    }
}

fn request(ctx: &egui::Context, notice: &Notice, l: Language, folder: PathBuf) {
    let (notice, repaint) = (notice.clone(), ctx.clone());
    ctx.request_screenshot(move |image| {
        let picture = saute_picture::cut::section::Picture {
            width: image.width(),
            height: image.height(),
            rgba: image.pixels.iter().flat_map(|p| p.to_array()).collect(),
        };
        match write(&picture, &folder) {
            Ok(path) => notice.say_of(l.fill("notice.saved", &[("path", &path.display())]), path),
            Err(error) => notice.say(l.fill("notice.not_saved", &[("error", &error)])),
        }
        repaint.request_repaint();
    });
}

#[cfg(not(target_arch = "wasm32"))]
fn write(picture: &saute_picture::cut::section::Picture, folder: &Path) -> Result<PathBuf, String> {
    let bytes = saute_picture::still::png_file::png_bytes(picture).map_err(|e| e.to_string())?;
    let path = crate::files::fresh_picture(folder, "png")?;
    std::fs::write(&path, bytes).map_err(|e| format!("{}: {e}", path.display()))?;
    Ok(path)
}

#[cfg(target_arch = "wasm32")]
fn write(picture: &saute_picture::cut::section::Picture, _: &Path) -> Result<PathBuf, String> {
    let bytes = saute_picture::still::png_file::png_bytes(picture).map_err(|e| e.to_string())?;
    crate::browser::download(FILE, "image/png", &bytes)?;
    Ok(PathBuf::from(FILE))
}

/// Name of a downloaded picture; browsers number further ones.
#[cfg(target_arch = "wasm32")]
const FILE: &str = "saute.png";
