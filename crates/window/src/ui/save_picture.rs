//! Screenshots of the window.

use std::path::PathBuf;

use crate::ui::notice::Notice;
use crate::words::language::Language;

/// Requests a picture of the window; it is written into the folder of pictures as `saute-N.png`, or downloaded by the browser.
pub fn save_picture(ctx: &egui::Context, notice: &Notice, l: Language) {
    let (notice, repaint) = (notice.clone(), ctx.clone());
    ctx.request_screenshot(move |image| {
        let picture = saute_picture::cut::section::Picture {
            width: image.width(),
            height: image.height(),
            rgba: image.pixels.iter().flat_map(|p| p.to_array()).collect(),
        };
        match write(&picture) {
            Ok(path) => notice.say_of(l.fill("notice.saved", &[("path", &path.display())]), path),
            Err(error) => notice.say(l.fill("notice.not_saved", &[("error", &error)])),
        }
        repaint.request_repaint();
    });
}

#[cfg(not(target_arch = "wasm32"))]
fn write(picture: &saute_picture::cut::section::Picture) -> Result<PathBuf, String> {
    let bytes = saute_picture::still::png_file::png_bytes(picture).map_err(|e| e.to_string())?;
    let folder = crate::files::pictures_folder();
    let path = (1..10_000)
        .map(|n| folder.join(format!("saute-{n}.png")))
        .find(|p| !p.exists())
        .ok_or_else(|| format!("{} holds too many pictures", folder.display()))?;
    std::fs::write(&path, bytes).map_err(|e| format!("{}: {e}", path.display()))?;
    Ok(path)
}

#[cfg(target_arch = "wasm32")]
fn write(picture: &saute_picture::cut::section::Picture) -> Result<PathBuf, String> {
    let bytes = saute_picture::still::png_file::png_bytes(picture).map_err(|e| e.to_string())?;
    crate::browser::download(FILE, &bytes)?;
    Ok(PathBuf::from(FILE))
}

/// Name of a downloaded picture; browsers number further ones.
#[cfg(target_arch = "wasm32")]
const FILE: &str = "saute.png";
