//! Renders the panels of a figure into one picture.

use saute_kitchen::Kitchen;
use saute_kitchen::doneness::ScaleChoice;
use saute_picture::Picture;
use saute_picture::stage::nearness;
use saute_picture::still::headless::{Gpu, still};
use saute_picture::still::shot::ShotOptions;
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

/// Renders a figure; `size` is the size of one panel [px].
pub fn plate(gpu: &Gpu, figure: &Figure, moments: &[Moment], scales: &ScaleChoice, size: [u32; 2]) -> Picture {
    let shown = figure.panels.iter().filter_map(|panel| Some((panel, moment_of(panel, moments)?)));
    let pictures: Vec<Picture> = shown.map(|(panel, moment)| draw(gpu, panel, &moment.kitchen, scales, size)).collect();
    in_rows(&pictures, figure.columns)
}

fn draw(gpu: &Gpu, panel: &Panel, kitchen: &Kitchen, scales: &ScaleChoice, size: [u32; 2]) -> Picture {
    let slice = panel.eye == Eye::Cut;
    let options = ShotOptions {
        view: panel.view,
        slice,
        white_balance: Default::default(),
        light: Default::default(),
        photo: Default::default(),
        quality: Quality::Smooth,
        flat: false,
        scales: scales.clone(),
        split: false,
        eye: None,
        field_of_view: FIELD_OF_VIEW,
        samples: 1,
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
    still(gpu, kitchen, &stage, size)
}
