//! Pictures of a kitchen by the program's own renderer. No graphics driver is looked for before the first one.

use std::f32::consts::PI;
use std::sync::{Arc, Mutex, PoisonError};

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use saute_kitchen::Kitchen;
use saute_kitchen::data::library::DEFAULT_SCALE;
use saute_kitchen::doneness::ScaleChoice;
use saute_picture::View;
use saute_picture::cut::section::Picture;
use saute_picture::still::headless::{Gpu, still};
use saute_picture::still::shot::{Eye, ShotOptions};
use saute_scene::camera::{DISTANCE_MAX, DISTANCE_MIN, FIELD_OF_VIEW, PITCH_MIN};
use saute_scene::light::photo::Photo;
use saute_scene::light::room_light::RoomLight;
use saute_scene::light::white_balance::WhiteBalance;
use saute_scene::quality::Quality;

use crate::package::array::shown_rows;
use crate::package::errors;
use crate::package::expected::{numbers, ranged};
use crate::package::kitchen::PyKitchen;
use crate::package::shelf::library;

/// The graphics device, once a picture was requested.
static GPU: Mutex<Option<Gpu>> = Mutex::new(None);

/// Size of a picture unless another is requested [px].
const DEFAULT_SIZE: [u32; 2] = [640, 480];
/// Smallest and largest side of a picture [px] (chosen: a thumbnail; what every driver can draw).
const SIDE: [u32; 2] = [16, 4096];

#[pymethods]
impl PyKitchen {
    /// A picture, height × width × 3 bytes (red, green, blue): size is (width, height) [px]; view is "look", "temperature",
    /// "moisture", "doneness", "browning", "lethality" or "marbling"; camera is None, "front", "above", "close-up" or
    /// (pitch_deg, yaw_deg, distance_mm); slice cuts the foods open.
    #[pyo3(signature = (size = None, view = "look", camera = None, *, slice = false))]
    fn render<'py>(
        &self,
        py: Python<'py>,
        size: Option<&Bound<'py, PyAny>>,
        view: &str,
        camera: Option<&Bound<'py, PyAny>>,
        slice: bool,
    ) -> PyResult<Bound<'py, PyAny>> {
        let size = size.map_or(Ok(DEFAULT_SIZE), pixels)?;
        let options = options(view_of(view)?, camera.map_or(Ok(None), eye)?, slice)?;
        let state = Arc::clone(&self.state);
        let picture = py.detach(|| drawn(&state, &options, size))?;
        let rows: Vec<[u8; 3]> = picture.rgba.chunks_exact(4).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
        let flat = shown_rows(py, &Arc::new(rows), |rows| rows.as_slice(), |pixel| pixel)?;
        flat.call_method1("reshape", ((picture.height, picture.width, 3),))
    }
}

fn drawn(kitchen: &Kitchen, options: &ShotOptions, size: [u32; 2]) -> PyResult<Picture> {
    let mut gpu = GPU.lock().unwrap_or_else(PoisonError::into_inner);
    if gpu.is_none() {
        *gpu = Some(Gpu::open().map_err(|error| errors::graphics(&error))?);
    }
    let open = gpu.as_ref().ok_or_else(|| errors::graphics(&"the graphics device is gone"))?;
    Ok(still(open, kitchen, &options.stage(kitchen), size, (options.quality, options.samples)))
}

fn options(view: View, eye: Option<Eye>, slice: bool) -> PyResult<ShotOptions> {
    Ok(ShotOptions {
        view,
        split: false,
        slice,
        white_balance: WhiteBalance::AsShot,
        light: RoomLight::Daylight,
        photo: Photo::default(),
        quality: Quality::Smooth,
        flat: false,
        scales: ScaleChoice::new(&library()?.scales, DEFAULT_SCALE),
        eye,
        field_of_view: FIELD_OF_VIEW,
        samples: 1,
        plated: false,
    })
}

fn pixels(size: &Bound<'_, PyAny>) -> PyResult<[u32; 2]> {
    let [width, height] = numbers::<2>(size, "size", "(width, height) in pixels")?;
    let side = |value: f64, what: &str| {
        ranged(value, what, SIDE.map(f64::from))?;
        let whole = value.fract() == 0.0;
        if whole {
            Ok(value as u32)
        } else {
            Err(PyValueError::new_err(format!("{what} = {value} is no whole number")))
        }
    };
    Ok([side(width, "width")?, side(height, "height")?])
}

fn view_of(name: &str) -> PyResult<View> {
    let known = View::ALL.map(|view| view.spec().id).join(", ");
    View::of_id(name).ok_or_else(|| PyValueError::new_err(format!("there is no view \"{name}\"; there are: {known}")))
}

/// Reads where the eye is: a name, or pitch, yaw [°] and distance [mm].
fn eye(camera: &Bound<'_, PyAny>) -> PyResult<Option<Eye>> {
    if camera.is_none() {
        return Ok(None);
    }
    match camera.extract::<String>().as_deref() {
        Ok("front") => return Ok(Some(Eye::Front)),
        Ok("above") => return Ok(Some(Eye::Above)),
        Ok("close-up") => return Ok(Some(Eye::CloseUp)),
        _ => {}
    }
    let form = "None, \"front\", \"above\", \"close-up\" or (pitch_deg, yaw_deg, distance_mm)";
    let [pitch, yaw, distance] = numbers::<3>(camera, "camera", form)?;
    let degrees = 180.0 / PI;
    ranged(pitch, "pitch_deg", [f64::from((PITCH_MIN * degrees).ceil()), 90.0])?;
    ranged(distance, "distance_mm", [DISTANCE_MIN, DISTANCE_MAX].map(|m| (1e3 * f64::from(m)).round()))?;
    let direction = [yaw as f32 / degrees, pitch as f32 / degrees];
    Ok(Some(Eye::From { direction, distance: 1e-3 * distance as f32, target: None }))
}
