//! Renders the panels of a figure into one picture.

use saute_kitchen::Kitchen;
use saute_kitchen::doneness::ScaleChoice;
use saute_picture::stage::nearness;
use saute_picture::still::headless::{Gpu, still};
use saute_picture::still::shot::ShotOptions;
use saute_picture::{Picture, View};
use saute_scene::camera::{Camera, FIELD_OF_VIEW};
use saute_scene::quality::Quality;

use super::figure::{Eye, Figure, Panel};
use super::moment::Moment;
use crate::picture::rows::in_rows;

/// Distance of the camera from a steak [m] (chosen: it fills the picture).
const NEAR: f32 = 0.215;
/// Distance of the camera from the pan [m] (chosen: it fills the picture).
const OVER_PAN: f32 = 0.36;

/// Returns the moment that a panel shows.
pub fn moment_of<'a>(panel: &Panel, moments: &'a [Moment]) -> Option<&'a Moment> {
    moments.iter().find(|m| m.cook == panel.cook && m.after_s == panel.after_s)
}

/// How the panels of figures are drawn.
pub struct Drawing<'a> {
    pub gpu: &'a Gpu,
    pub scales: &'a ScaleChoice,
    /// Size of one panel [px].
    pub size: [u32; 2],
    /// Samples of light of a picture of the look [-].
    pub samples: u32,
}

impl Drawing<'_> {
    /// Renders a figure.
    pub fn plate(&self, figure: &Figure, moments: &[Moment]) -> Picture {
        let shown = figure.panels.iter().filter_map(|panel| Some((panel, moment_of(panel, moments)?)));
        let pictures: Vec<Picture> = shown.map(|(panel, moment)| self.panel(panel, &moment.kitchen)).collect();
        in_rows(&pictures, figure.columns)
    }

    fn panel(&self, panel: &Panel, kitchen: &Kitchen) -> Picture {
        let slice = panel.eye == Eye::Cut;
        // Fields are exact: no light of a room falls on them.
        let (quality, samples) =
            if panel.view == View::Look { (Quality::Best, self.samples) } else { (Quality::Smooth, 1) };
        let options = ShotOptions {
            view: panel.view,
            slice,
            white_balance: Default::default(),
            light: Default::default(),
            photo: Default::default(),
            quality,
            flat: false,
            scales: self.scales.clone(),
            split: false,
            eye: None,
            field_of_view: FIELD_OF_VIEW,
            samples,
            plated: false,
        };
        let mut stage = options.stage(kitchen);
        let place = kitchen.pieces().first().map(|piece| (piece.pose.position.as_vec3(), nearness(piece)));
        if let (Eye::Piece | Eye::Cut, Some((target, nearness))) = (panel.eye, place) {
            let pitch = if slice { 0.60 } else { 0.78 };
            stage.camera = Camera { pitch, distance: NEAR * nearness, target, ..stage.camera };
        } else {
            stage.camera.distance = OVER_PAN;
            stage.camera.target = kitchen.world().motion.pose.position.as_vec3();
        }
        still(self.gpu, kitchen, &stage, self.size, (quality, samples))
    }
}
