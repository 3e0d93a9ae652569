//! A still of a recipe at one instant, drawn by the window's own renderer.

use glam::Vec3;
use saute_kitchen::doneness::ScaleChoice;
use saute_kitchen::kitchen::SetupError;
use saute_kitchen::{Kitchen, Library, Piece, Place, TICK_S};
use saute_recipe::{Cook, Recipe};
use saute_scene::camera::Camera;
use saute_scene::input::SceneInput;
use saute_scene::light::photo::Photo;
use saute_scene::light::room_light::RoomLight;
use saute_scene::light::white_balance::WhiteBalance;
use saute_scene::quality::Quality;
use saute_scene::renderer::SampleProgress;
use saute_schema::InputError;

use crate::colour::map::TemperatureMap;
use crate::cut::section::Picture;
use crate::plated::plated;
use crate::split::scenes;
use crate::stage::{CUT_YAW, Stage, StageOptions};
use crate::still::headless::{Gather, Gpu, GpuError, picture};
use crate::view::View;
use crate::waiting::FIRST_ON_BOARD;

/// Errors of a still.
#[derive(Debug, thiserror::Error)]
pub enum ShotError {
    /// The recipe ends before the requested time.
    #[error(
        "{file}:{line}: --at {at_s} is past the end: this step ends the cook at {end_s:.1} s\n  remedy: choose a time from 0 to {end_s:.1}"
    )]
    PastTheEnd {
        /// Which recipe.
        file: String,
        /// Line of its last step, from 1.
        line: usize,
        /// The requested time [s].
        at_s: f64,
        /// When the recipe ends [s].
        end_s: f64,
    },
    /// A step failed.
    #[error(transparent)]
    Run(#[from] InputError),
    /// The kitchen cannot be set up.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// Nothing can be drawn.
    #[error(transparent)]
    Gpu(#[from] GpuError),
}

impl ShotError {
    /// The error that an instant past the end of a cook is [s].
    pub(crate) fn past_the_end(cook: &Cook, at_s: f64) -> Self {
        let recipe = cook.runner.recipe();
        let line = recipe.steps.last().map_or(1, |step| step.line);
        Self::PastTheEnd { file: recipe.file.clone(), line, at_s, end_s: cook.kitchen.time_s() }
    }
}

/// Cooks a recipe up to a time [s]; steps that are due then have been carried out.
pub fn cook_until(recipe: Recipe, library: &Library, at_s: f64) -> Result<Cook, ShotError> {
    let mut cook = Cook::new(recipe, library)?;
    cook_to(&mut cook, at_s)?;
    Ok(cook)
}

/// Cooks on to a time [s]; steps that are due then have been carried out.
pub fn cook_to(cook: &mut Cook, at_s: f64) -> Result<(), ShotError> {
    if advance_to(cook, at_s)? { Ok(()) } else { Err(ShotError::past_the_end(cook, at_s)) }
}

/// Cooks to the end of the recipe; returns its time [s].
///
/// # Errors
///
/// If a step fails.
pub fn cook_to_end(cook: &mut Cook) -> Result<f64, ShotError> {
    advance_to(cook, f64::INFINITY)?;
    Ok(cook.kitchen.time_s())
}

/// Cooks on to a time [s], steps that are due then included; returns false if the recipe ends earlier.
pub(crate) fn advance_to(cook: &mut Cook, at_s: f64) -> Result<bool, ShotError> {
    while cook.kitchen.time_s() < at_s - 0.5 * TICK_S {
        if cook.stopped().is_some() {
            return Ok(false);
        }
        cook.advance()?;
    }
    cook.fire()?;
    Ok(true)
}

/// Options of a still.
#[derive(Clone, Debug, PartialEq)]
pub struct ShotOptions {
    /// View that the colours show.
    pub view: View,
    /// True if the look is shown to its left.
    pub split: bool,
    /// True if the food is cut open.
    pub slice: bool,
    /// White balance of the look.
    pub white_balance: WhiteBalance,
    /// Light of the room.
    pub light: RoomLight,
    /// Exposure and aperture of the look.
    pub photo: Photo,
    /// Rendering quality.
    pub quality: Quality,
    /// Unlit, exactly decodable colours.
    pub flat: bool,
    /// The scales of doneness, with the one that is chosen.
    pub scales: ScaleChoice,
    /// Where the eye is; by default over hob and board, over food that was taken out, or near a cut.
    pub eye: Option<Eye>,
    /// Field of view [rad].
    pub field_of_view: f32,
    /// True if the food is shown as it is served: on a plate, cut.
    pub plated: bool,
    /// Samples of light that a look at the best level gathers.
    pub samples: u32,
}

/// Where the eye of a still is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Eye {
    /// From the cook's side, over hob and board.
    Front,
    /// From straight above.
    Above,
    /// Near the first food; where it is cut open, on the side to which the cut looks.
    CloseUp,
    /// From a direction and a distance.
    From {
        /// Angle around the vertical, to the right, and above the horizontal [rad].
        direction: [f32; 2],
        /// Distance from the point looked at [m].
        distance: f32,
        /// Point looked at, from the centre of the hob [m]; the first food by default.
        target: Option<[f32; 3]>,
    },
}

impl ShotOptions {
    /// The eye: over hob and board, or over the food that was taken out, or, for a cut, near to the food and on the side to which the cut looks.
    pub fn stage(&self, kitchen: &Kitchen) -> StageOptions {
        let mut camera = match self.eye {
            Some(eye) => eye.camera(kitchen),
            None if self.slice => working_view(kitchen, Camera::three_quarter()),
            None => working_view(kitchen, over_pan()),
        };
        camera.field_of_view = self.field_of_view;
        if self.slice && self.eye == Some(Eye::CloseUp) {
            camera.yaw = CLOSE_CUT_YAW;
        }
        if self.slice && self.eye.is_none() {
            let in_pan = kitchen.pieces().iter().any(Piece::in_pan);
            camera.zoom(CUT_DISTANCE);
            camera.target.x = 0.0;
            camera.yaw = CUT_YAW;
            if !in_pan {
                camera.target = FIRST_ON_BOARD;
            }
        }
        let slice = self.slice.then_some(0.0);
        StageOptions {
            camera,
            view: self.view,
            map: TemperatureMap::default(),
            scales: self.scales.clone(),
            slice,
            cut: None,
            white_balance: self.white_balance,
            light: self.light,
            photo: self.photo,
            flat: self.flat,
        }
    }
}

/// From the cook's side over the pan: food and pan fill the picture.
fn over_pan() -> Camera {
    Camera { target: OVER_PAN, distance: PAN_DISTANCE, ..Camera::three_quarter() }
}

/// From the cook's side: in front of the pan, or over the food when all of it was taken out.
fn working_view(kitchen: &Kitchen, in_pan: Camera) -> Camera {
    let resting = |piece: &&Piece| matches!(piece.place, Place::Rest(_));
    match kitchen.pieces().iter().find(resting) {
        Some(piece) if !kitchen.pieces().iter().any(Piece::in_pan) => {
            let mut near = Camera { target: piece.pose.position.as_vec3(), ..Camera::three_quarter() };
            near.zoom(REST_DISTANCE);
            near
        }
        _ => in_pan,
    }
}

impl Eye {
    fn camera(self, kitchen: &Kitchen) -> Camera {
        let food = || kitchen.pieces().first().map(|piece| piece.pose.position.as_vec3());
        match self {
            Self::Front => Camera::three_quarter(),
            Self::Above => Camera::above(),
            Self::CloseUp => {
                let near = Camera::close_up();
                Camera { target: food().unwrap_or(near.target), ..near }
            }
            Self::From { direction, distance, target } => {
                let at = target.map(Vec3::from).or_else(food).unwrap_or_default();
                Camera::from_direction(direction, distance, at)
            }
        }
    }
}

/// Angle of the eye about the vertical axis from near a cut [rad] (chosen: the face is seen from in front, one edge of it in depth).
const CLOSE_CUT_YAW: f32 = 1.1;
/// From where a pan is seen: a point above its floor [m], how far [m] (chosen: pan and food fill the picture, and
/// of the room only what tells where they are).
const OVER_PAN: Vec3 = Vec3::new(0.012, -0.012, 0.018);
const PAN_DISTANCE: f32 = 0.46;
/// Factor on the distance from which food on the board is seen [-] (chosen: the board fills the picture).
const REST_DISTANCE: f32 = 0.7;
/// Factor on the distance from which a cut is seen [-] (chosen: the pan fills the picture).
const CUT_DISTANCE: f32 = 0.62;

/// Width of the line between the halves of a split picture at least [pixels].
const LINE: u32 = 2;

/// Cooks a recipe up to a time [s] and draws the kitchen.
pub fn shot(
    recipe: Recipe,
    library: &Library,
    at_s: f64,
    options: ShotOptions,
    size: [u32; 2],
) -> Result<Picture, ShotError> {
    shot_of(Cook::new(recipe, library)?, at_s, options, size, None)
}

/// Cooks on to a time [s], or plays a session again up to it, and draws the kitchen; `told` is called after each sample of light.
pub fn shot_of(
    mut cook: Cook,
    at_s: f64,
    options: ShotOptions,
    size: [u32; 2],
    told: Option<SampleProgress>,
) -> Result<Picture, ShotError> {
    cook_to(&mut cook, at_s)?;
    let gpu = Gpu::open()?;
    Ok(drawn(&gpu, &cook.kitchen, &options, size, told))
}

/// Draws a kitchen as the options state.
pub(crate) fn drawn(
    gpu: &Gpu,
    kitchen: &Kitchen,
    options: &ShotOptions,
    size: [u32; 2],
    told: Option<SampleProgress>,
) -> Picture {
    let stage = options.stage(kitchen);
    let input = match options.plated {
        true => plated(kitchen, &stage),
        false => Stage::default().scene(kitchen, &stage, &Default::default()),
    };
    let gather = Gather { samples: options.samples, told };
    if options.split {
        return pair(gpu, input, size, options.quality, gather);
    }
    picture(gpu, &input, size, options.quality, gather)
}

/// The look and the view of one instant side by side, each in half the width, with a dark line between.
fn pair(gpu: &Gpu, input: SceneInput, [width, height]: [u32; 2], quality: Quality, gather: Gather) -> Picture {
    let mut renderer = gather.renderer(gpu);
    let half = [(width - LINE) / 2, height];
    let scenes = scenes(input, true);
    let halves = scenes.iter().map(|scene| renderer.render_to_image(&gpu.device, &gpu.queue, scene, half, quality));
    let [row, all] = [half[0], width].map(|pixels| 4 * pixels as usize);
    let mut rgba = [24, 24, 24, 255].repeat((width * height) as usize);
    for (side, picture) in halves.enumerate() {
        let left = side * (all - row);
        for (from, to) in picture.chunks(row).zip(rgba.chunks_mut(all)) {
            to[left..left + row].copy_from_slice(from);
        }
    }
    Picture { width: width as usize, height: height as usize, rgba }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn a_close_up_of_a_cut_looks_at_its_face_and_one_of_whole_food_from_the_cooks_side() {
        let library = Library::embedded().unwrap();
        let kitchen = Kitchen::new(&library, "carbon-steel-26", saute_kitchen::kelvin(20.0)).unwrap();
        let yaw = |slice, eye| {
            let options = ShotOptions {
                view: View::Look,
                split: false,
                slice,
                white_balance: WhiteBalance::default(),
                light: RoomLight::default(),
                photo: Photo::default(),
                quality: Quality::Quick,
                flat: false,
                scales: ScaleChoice::default(),
                eye: Some(eye),
                field_of_view: 0.6,
                samples: 1,
                plated: false,
            };
            options.stage(&kitchen).camera.yaw
        };
        assert_eq!(yaw(true, Eye::CloseUp), CLOSE_CUT_YAW);
        assert_eq!(yaw(false, Eye::CloseUp), Camera::close_up().yaw);
        assert_eq!(yaw(true, Eye::Front), Camera::three_quarter().yaw, "who says from where is obeyed");
    }
}
