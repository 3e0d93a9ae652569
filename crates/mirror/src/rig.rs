//! A rig: eye, half mirror and screen round a real pan, and where the kitchen is among them.

use glam::{DVec2, DVec3};

use crate::optics::{Plane, VirtualImage};
use crate::registration::Rigid;
use crate::screen::Screen;
use crate::warp::Warp;

/// A rig: all quantities on which its pictures depend. Its frame: metres, x to the cook's right, y away from the cook,
/// z up.
#[derive(Clone, Debug, PartialEq)]
pub struct Rig {
    /// Name.
    pub name: String,
    /// The middle between the eyes [m].
    pub eye: DVec3,
    /// From eye to eye [m].
    pub eye_distance: f64,
    /// The half mirror.
    pub mirror: Plane,
    /// The screen.
    pub screen: Screen,
    /// From the kitchen's frame to the rig's.
    pub rig_from_kitchen: Rigid,
    /// Residual of the registration by touched points [m]; none where the frame was given.
    pub residual: Option<f64>,
    /// The sheet of paper on which the calibration's marks are.
    pub sheet: Sheet,
    /// The rectangle of the screen's virtual image that pictures are drawn for [m].
    pub image: VirtualImage,
    /// The warp that follows from the rig's own numbers, before anything is calibrated.
    pub nominal: Warp,
}

/// A level sheet in the kitchen's frame with its long side along x [m].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sheet {
    /// Its middle [m].
    pub middle: DVec3,
    /// Width and depth [m].
    pub size: DVec2,
}

/// Marks of a sheet: four corners from the far left round to the near left, the middle, the middles of the edges from
/// the far one round to the left one.
pub const MARKS: usize = 9;
/// Where the marks are, in halves of the sheet's sides.
const PLACES: [[f64; 2]; MARKS] =
    [[-1.0, 1.0], [1.0, 1.0], [1.0, -1.0], [-1.0, -1.0], [0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [0.0, -1.0], [-1.0, 0.0]];

impl Sheet {
    /// A point of the sheet in halves of its sides, in the kitchen's frame [m].
    pub fn point(&self, place: DVec2) -> DVec3 {
        self.middle + (0.5 * place * self.size).extend(0.0)
    }

    /// Its marks in the kitchen's frame [m].
    pub fn marks(&self) -> [DVec3; MARKS] {
        PLACES.map(|place| self.point(DVec2::from_array(place)))
    }
}

/// A fault in the parts of a rig; the key is the one that has to change.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{key}: {message}\n  remedy: {remedy}")]
pub struct RigFault {
    /// Which key of the rig's file.
    pub key: String,
    /// What is wrong.
    pub message: String,
    /// What to do.
    pub remedy: String,
}

impl RigFault {
    /// A fault of a key.
    pub fn new(key: &str, message: impl Into<String>, remedy: &str) -> Self {
        Self { key: key.to_owned(), message: message.into(), remedy: remedy.to_owned() }
    }
}

/// Measurements of a rig.
#[derive(Clone, Debug)]
pub struct Measured {
    /// Name.
    pub name: String,
    /// The middle between the eyes [m].
    pub eye: DVec3,
    /// From eye to eye [m].
    pub eye_distance: f64,
    /// The half mirror.
    pub mirror: Plane,
    /// The screen.
    pub screen: Screen,
    /// From the kitchen's frame to the rig's.
    pub rig_from_kitchen: Rigid,
    /// Residual of the registration [m].
    pub residual: Option<f64>,
    /// The sheet of the calibration.
    pub sheet: Sheet,
}

/// Points along each side of the device by which its picture's extent on the screen is found (chosen: a bowed side
/// shows).
const BORDER_STEPS: u32 = 16;

impl Measured {
    /// Works out the virtual image and the warp.
    pub fn rig(self) -> Result<Rig, RigFault> {
        let beyond = |p: DVec3| (p - self.mirror.point).dot(self.mirror.normal) * self.eye_side();
        if self.eye_side() == 0.0 {
            return Err(RigFault::new("mirror.point_m", "the mirror runs through the eye", "measure both again"));
        }
        let border = self.border()?;
        if border.iter().any(|p| beyond(*p) <= 0.0) {
            let message = "part of the screen is behind the mirror, where the eye cannot see it";
            return Err(RigFault::new("screen", message, "put eye and screen on one side of the mirror"));
        }
        let images: Vec<DVec3> = border.iter().map(|p| self.mirror.mirrored(*p)).collect();
        let plane = self.screen.plane();
        let normal = self.mirror.mirrored(plane.point + plane.normal) - self.mirror.mirrored(plane.point);
        let plane = Plane { point: self.mirror.mirrored(plane.point), normal };
        let edge_on = || RigFault::new("screen", "the eye sees the screen edge on", "turn mirror or screen");
        if (self.eye - plane.point).dot(plane.normal).abs() < 0.02 {
            return Err(edge_on());
        }
        let image = VirtualImage::round(&images, &plane, self.eye, DVec3::X).ok_or_else(edge_on)?;
        let nominal = self.nominal(&image).ok_or_else(edge_on)?;
        let Self { name, eye, eye_distance, mirror, screen, rig_from_kitchen, residual, sheet } = self;
        Ok(Rig { name, eye, eye_distance, mirror, screen, rig_from_kitchen, residual, sheet, image, nominal })
    }

    fn eye_side(&self) -> f64 {
        let above = (self.eye - self.mirror.point).dot(self.mirror.normal);
        if above.abs() < 1e-6 { 0.0 } else { above.signum() }
    }

    /// Where the device's border appears on the screen [m].
    fn border(&self) -> Result<Vec<DVec3>, RigFault> {
        let pixels = self.screen.pixels();
        let steps = (0..=BORDER_STEPS).map(|k| f64::from(k) / f64::from(BORDER_STEPS));
        let places =
            steps.flat_map(|t| [DVec2::new(t, 0.0), DVec2::new(t, 1.0), DVec2::new(0.0, t), DVec2::new(1.0, t)]);
        let points: Option<Vec<DVec3>> = places.map(|place| self.screen.point(place * pixels)).collect();
        let remedy = "measure the projector's place and axis and the board again";
        points.ok_or_else(|| RigFault::new("projector", "part of the picture misses the board", remedy))
    }

    /// Four pixels within the device and where they are seen make the keystone.
    fn nominal(&self, image: &VirtualImage) -> Option<Warp> {
        let shares = [[0.1, 0.1], [0.9, 0.1], [0.9, 0.9], [0.1, 0.9]].map(DVec2::from_array);
        let pixels = shares.map(|share| share * self.screen.pixels());
        let mut places = [DVec2::ZERO; 4];
        for (place, pixel) in places.iter_mut().zip(pixels) {
            *place = image.place(self.mirror.mirrored(self.screen.point(pixel)?));
        }
        Warp::through(places, pixels, self.screen.lens())
    }
}

impl Rig {
    /// The place in the picture at which an eye of the rig sees a point of the kitchen [-].
    pub fn seen(&self, eye: DVec3, in_kitchen: DVec3) -> Option<DVec2> {
        self.image.seen(eye, self.rig_from_kitchen.point(in_kitchen))
    }

    /// Places in the picture at which the sheet's marks are seen [-].
    pub fn mark_places(&self) -> Option<[DVec2; MARKS]> {
        let mut places = [DVec2::ZERO; MARKS];
        for (place, mark) in places.iter_mut().zip(self.sheet.marks()) {
            *place = self.seen(self.eye, mark)?;
        }
        Some(places)
    }

    /// An eye of the rig in the kitchen's frame [m].
    pub fn eye_in_kitchen(&self, eye: DVec3) -> DVec3 {
        self.rig_from_kitchen.inverse().point(eye)
    }

    /// Maps the kitchen to the clip space of an eye's picture.
    pub fn view_projection(&self, eye: DVec3) -> glam::DMat4 {
        self.image.view_projection(eye) * self.rig_from_kitchen.matrix()
    }

    /// Size that keeps the device's pixels in the eye's picture, no side longer than given [pixels].
    pub fn picture_size(&self, device: DVec2, longest: f64) -> [u32; 2] {
        let sides = [[0.0, 0.5], [1.0, 0.5], [0.5, 0.0], [0.5, 1.0]].map(|at| {
            let pixel = DVec2::from_array(at) * self.screen.pixels();
            self.nominal.place(pixel)
        });
        // Pixels a picture's side: those of the device over the share of the side that they cover.
        let along = |k: usize, count: f64| count / (sides[k + 1] - sides[k]).abs().max_element().max(1e-3);
        let (rows, columns) = (along(0, device.x), along(2, device.y));
        let turned = (sides[1] - sides[0]).y.abs() > (sides[1] - sides[0]).x.abs();
        let size = if turned { DVec2::new(columns, rows) } else { DVec2::new(rows, columns) };
        let shrink = (longest / size.max_element()).min(1.0);
        (size * shrink).round().max(DVec2::ONE).to_array().map(|v| v as u32)
    }
}
