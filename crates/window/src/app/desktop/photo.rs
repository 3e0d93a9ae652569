//! Photo mode: exposure, blur and size of a picture without panels, and a time lapse of the cook.

use crate::app::SauteApp;
use crate::desktop::photo::making::Making;
use saute_picture::still::shot::Eye;
use saute_scene::camera::Camera;
use saute_scene::quality::Quality;

impl SauteApp {
    /// Draws the scene once more, at the best quality and in the chosen size, and saves it.
    pub(crate) fn take_photo(&mut self, ctx: &egui::Context) {
        let Some(scene) = self.sights.scene.shown.clone() else { return };
        let size = self.host.photo.choice.size;
        self.begin_making(ctx, |making| making.photo(scene, size));
    }

    /// Plays the cook again in the background, seen as now, and saves a time lapse of it.
    pub(crate) fn make_time_lapse(&mut self, ctx: &egui::Context) {
        let options = saute_picture::still::shot::ShotOptions {
            samples: 1,
            plated: false,
            view: self.settings.view,
            split: false,
            slice: self.sights.slice.is_some(),
            white_balance: self.settings.white_balance,
            light: self.settings.light,
            photo: self.host.photo.choice.photo,
            quality: Quality::Smooth,
            flat: false,
            scales: self.session.scales(&self.settings.scale),
            eye: Some(seen_from(&self.sights.camera)),
            field_of_view: self.sights.camera.field_of_view,
        };
        let (recording, library) = (self.session.recording().clone(), self.session.library.clone());
        self.begin_making(ctx, |making| making.time_lapse(recording, library, options));
    }

    /// Begins in its own thread; one at a time is made.
    fn begin_making(
        &mut self,
        ctx: &egui::Context,
        make: impl FnOnce(crate::desktop::photo::making::Maker) -> std::io::Result<Making>,
    ) {
        if self.host.photo.making.is_some() {
            return self.say("notice.photo_is_made");
        }
        match make(crate::desktop::photo::making::Maker { ctx: ctx.clone(), folder: self.host.pictures_folder() }) {
            Ok(making) => self.host.photo.making = Some(making),
            Err(error) => self.say_trouble(&error),
        }
    }

    /// Shows a notice of what was made since the last frame.
    pub(crate) fn take_photo_made(&mut self) {
        let Some(made) = self.host.photo.making.as_ref().and_then(Making::made) else { return };
        self.host.photo.making = None;
        let l = self.settings.language;
        match made {
            Ok(path) => self.desk.notice.say_of(l.fill("notice.saved", &[("path", &path.display())]), path),
            Err(error) => self.desk.notice.say(l.fill("notice.not_saved", &[("error", &error)])),
        }
    }
}

/// The eye of a still that sees what a camera sees.
fn seen_from(camera: &Camera) -> Eye {
    Eye::From { direction: [camera.yaw, camera.pitch], distance: camera.distance, target: Some(camera.target.into()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_lapse_is_seen_as_the_window_is() {
        let camera = Camera::close_up();
        let Eye::From { direction, distance, target } = seen_from(&camera) else { panic!("from a direction") };
        let again = Camera::from_direction(direction, distance, target.expect("a target").into());
        assert!(again.eye().abs_diff_eq(camera.eye(), 1e-5), "{} {}", again.eye(), camera.eye());
    }
}
