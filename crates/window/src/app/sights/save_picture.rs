//! Screenshots of the window.

use crate::app::SauteApp;
use crate::host::Host;
use saute_picture::cut::section::Picture;
use saute_picture::still::png_file::png_bytes;

impl SauteApp {
    /// Requests a picture of the window; it is written into the folder of pictures as `saute-N.png`, or downloaded by the
    /// browser.
    pub(crate) fn save_picture(&self, ctx: &egui::Context) {
        let (notice, repaint, l) = (self.desk.notice.clone(), ctx.clone(), self.settings.language);
        let keep = self.host.picture_keeper();
        ctx.request_screenshot(move |image| {
            let picture = Picture {
                width: image.width(),
                height: image.height(),
                rgba: image.pixels.iter().flat_map(|p| p.to_array()).collect(),
            };
            match png_bytes(&picture).map_err(|e| e.to_string()).and_then(|bytes| keep(&bytes)) {
                Ok(path) => notice.say_of(l.fill("notice.saved", &[("path", &path.display())]), path),
                Err(error) => notice.say(l.fill("notice.not_saved", &[("error", &error)])),
            }
            repaint.request_repaint();
        });
    }
}
