//! The file format of a half-mirror rig: its measured geometry, as TOML.

use glam::{DQuat, DVec2, DVec3};
use saute_schema::{InputError, InputText};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::lens::Lens;
use crate::optics::Plane;
use crate::registration::{Registered, RegistrationError, Rigid, register};
use crate::rig::{Measured, Rig, RigFault, Sheet};
use crate::screen::{Panel, Projector, Screen};

/// The embedded rigs, by name; the first one is the default.
pub const SHIPPED: [(&str, &str); 2] = [
    ("flat-screen", include_str!("../../../data/rigs/flat-screen.toml")),
    ("projector", include_str!("../../../data/rigs/projector.toml")),
];

/// Distance of the eyes [mm] (chosen: the widest adult distance is 80).
const EYE_DISTANCE_MM: [f64; 2] = [0.0, 120.0];
/// Side of the calibration sheet [m] (chosen: a postcard to a table).
const SHEET_M: [f64; 2] = [0.05, 3.0];
/// Turn of the kitchen in the rig [°].
const TURN_DEG: [f64; 2] = [-180.0, 180.0];
/// Side of the picture [pixels] (chosen: to twice the width of an 8K picture).
const PIXELS: [f64; 2] = [64.0, 16_384.0];
/// Focal length of a projector [pixels] (chosen: beyond any lens).
const FOCAL_PX: [f64; 2] = [10.0, 1e6];
/// Principal point of a projector [pixels] (chosen: twice the widest picture, for shifted lenses).
const PRINCIPAL_PX: [f64; 2] = [-32_768.0, 32_768.0];
/// Radial distortion of a lens [-] (chosen: beyond any projector).
const DISTORTION: [f64; 2] = [-1.0, 1.0];
/// Coordinate in the rig [m] (chosen: a room; catches millimetres in place of metres).
const PLACE_M: [f64; 2] = [-10.0, 10.0];
/// Largest RMS residual of the touched points [m] (chosen: twenty times the error of a careful hand; more means that points
/// were mixed up).
const LARGEST_RESIDUAL: f64 = 0.02;
/// Largest cosine between the sides of a panel [-] (chosen: one degree from a right angle).
const LARGEST_COSINE: f64 = 0.02;
/// Smallest area of a panel [m²] (chosen: a square centimetre).
const SMALLEST_PANEL: f64 = 1e-4;
/// Largest difference of the length of a unit quaternion from 1 [-] (chosen: rounding to two digits).
const LARGEST_LENGTH_ERROR: f64 = 0.01;

/// Errors of a rig file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RigFileError {
    /// The text is not a rig file.
    #[error(transparent)]
    Format(#[from] InputError),
    /// The numbers do not describe a possible rig.
    #[error("{file}: {fault}")]
    Fault {
        /// Which file.
        file: String,
        /// What is wrong.
        fault: RigFault,
    },
}

/// A half-mirror rig as its file describes it. Frame: metres, x to the cook's right, y away from the cook, z up.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute rig")]
pub struct RigFile {
    /// Name for people.
    #[schemars(example = &"My rig")]
    name: String,
    /// Source of the numbers, or "chosen" and the reason.
    #[expect(dead_code, reason = "every data file names its source")]
    #[schemars(example = &"measured with a tape")]
    source: String,
    /// Confidence in the numbers.
    #[expect(dead_code, reason = "and its confidence")]
    #[schemars(example = &"low")]
    confidence: String,
    /// Eyes of the cook.
    eye: EyeTable,
    /// Reflecting side of the half-silvered glass.
    mirror: PlaneTable,
    /// A flat screen; a rig has either this or a projector.
    panel: Option<PanelTable>,
    /// A projector with its board; a rig has either this or a panel.
    projector: Option<ProjectorTable>,
    /// Pose of the kitchen in the rig.
    #[serde(default)]
    kitchen: KitchenTable,
    /// Calibration sheet, in the kitchen's frame, long side along x.
    sheet: SheetTable,
}

/// Eyes of the cook.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct EyeTable {
    /// Midpoint between the eyes [m].
    #[schemars(inner(range(min = PLACE_M[0], max = PLACE_M[1])), extend("examples" = [[0.0, -0.35, 0.55]]))]
    position_m: [f64; 3],
    /// Distance of the pupils [mm].
    #[schemars(range(min = EYE_DISTANCE_MM[0], max = EYE_DISTANCE_MM[1]), example = 63.0)]
    distance_mm: f64,
}

/// A plane.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct PlaneTable {
    /// Any point on it [m].
    #[schemars(inner(range(min = PLACE_M[0], max = PLACE_M[1])), extend("examples" = [[0.0, 0.0, 0.28]]))]
    point_m: [f64; 3],
    /// Normal; its length does not matter.
    #[schemars(extend("examples" = [[0.0, 0.1736, 0.9848]]))]
    normal: [f64; 3],
}

/// A flat screen, by the corners of its lit area, which form a right angle.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct PanelTable {
    /// Width and height of the picture [pixels].
    #[schemars(inner(range(min = PIXELS[0], max = PIXELS[1])), extend("examples" = [[1920, 1080]]))]
    pixels: [u32; 2],
    /// Start of the first row of pixels [m].
    #[schemars(inner(range(min = PLACE_M[0], max = PLACE_M[1])), extend("examples" = [[0.2655, 0.26, 0.483]]))]
    top_left_m: [f64; 3],
    /// End of the first row of pixels [m].
    #[schemars(inner(range(min = PLACE_M[0], max = PLACE_M[1])), extend("examples" = [[-0.2655, 0.26, 0.483]]))]
    top_right_m: [f64; 3],
    /// Start of the last row of pixels [m].
    #[schemars(inner(range(min = PLACE_M[0], max = PLACE_M[1])), extend("examples" = [[0.2655, -0.021, 0.586]]))]
    bottom_left_m: [f64; 3],
}

/// A projector.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ProjectorTable {
    /// Width and height of the picture [pixels].
    #[schemars(inner(range(min = PIXELS[0], max = PIXELS[1])), extend("examples" = [[1920, 1080]]))]
    pixels: [u32; 2],
    /// Centre of projection [m].
    #[schemars(inner(range(min = PLACE_M[0], max = PLACE_M[1])), extend("examples" = [[0.0, 0.306, 1.318]]))]
    position_m: [f64; 3],
    /// Direction of the optical axis.
    #[schemars(extend("examples" = [[0.0, -0.2315, -0.9728]]))]
    axis: [f64; 3],
    /// Direction of a row of pixels, from its start to its end.
    #[schemars(extend("examples" = [[1.0, 0.0, 0.0]]))]
    right: [f64; 3],
    /// Focal length [pixels].
    #[schemars(range(min = FOCAL_PX[0], max = FOCAL_PX[1]), example = 2750.0)]
    focal_px: f64,
    /// Principal point: where the optical axis meets the picture [pixels].
    #[schemars(inner(range(min = PRINCIPAL_PX[0], max = PRINCIPAL_PX[1])), extend("examples" = [[960.0, 540.0]]))]
    principal_px: [f64; 2],
    /// Radial distortion of second order [-].
    #[schemars(range(min = DISTORTION[0], max = DISTORTION[1]), example = -0.03)]
    k1: f64,
    /// Radial distortion of fourth order [-].
    #[schemars(range(min = DISTORTION[0], max = DISTORTION[1]), example = 0.005)]
    k2: f64,
    /// Board that it lights.
    board: PlaneTable,
}

/// Pose of the kitchen in the rig: from touched points, else from the home pose of the pan, else as given.
#[derive(Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct KitchenTable {
    /// Origin of the kitchen (middle of the hob, foot of the pan) [m].
    #[serde(default)]
    #[schemars(inner(range(min = PLACE_M[0], max = PLACE_M[1])), extend("examples" = [[0.0, 0.0, 0.0]]))]
    origin_m: [f64; 3],
    /// Turn about z, counter-clockwise seen from above [°].
    #[serde(default)]
    #[schemars(range(min = TURN_DEG[0], max = TURN_DEG[1]), example = 0.0)]
    turn_deg: f64,
    /// Three or more points, each measured in both frames.
    #[serde(default)]
    touched: Vec<TouchedTable>,
    /// Pose of the pan's device at its home position.
    home: Option<HomeTable>,
}

/// A point that was touched.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct TouchedTable {
    /// Where it is in the kitchen [m].
    #[schemars(inner(range(min = PLACE_M[0], max = PLACE_M[1])), extend("examples" = [[0.1, 0.0, 0.0]]))]
    kitchen_m: [f64; 3],
    /// Where it is in the rig [m].
    #[schemars(inner(range(min = PLACE_M[0], max = PLACE_M[1])), extend("examples" = [[0.101, 0.002, 0.0]]))]
    rig_m: [f64; 3],
}

/// A pose.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct HomeTable {
    /// Position [m].
    #[schemars(inner(range(min = PLACE_M[0], max = PLACE_M[1])), extend("examples" = [[0.0, 0.0, 0.0]]))]
    position_m: [f64; 3],
    /// Rotation, as a unit quaternion x, y, z, w.
    #[schemars(extend("examples" = [[0.0, 0.0, 0.0, 1.0]]))]
    rotation_xyzw: [f64; 4],
}

/// The calibration sheet.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct SheetTable {
    /// Its middle [m].
    #[schemars(inner(range(min = PLACE_M[0], max = PLACE_M[1])), extend("examples" = [[0.0, 0.0, 0.0]]))]
    middle_m: [f64; 3],
    /// Length along x and along y [m].
    #[schemars(inner(range(min = SHEET_M[0], max = SHEET_M[1])), extend("examples" = [[0.297, 0.21]]))]
    size_m: [f64; 2],
}

/// Parses and checks a rig file. `file` is the name in error messages.
pub fn parse(text: &str, file: &str) -> Result<Rig, RigFileError> {
    let read: RigFile = InputText { text, file }.parse("write this key as data/rigs/flat-screen.toml has it")?;
    read.rig().map_err(|fault| RigFileError::Fault { file: file.to_owned(), fault })
}

/// Returns an embedded rig by its name.
pub fn shipped(name: &str) -> Option<Result<Rig, RigFileError>> {
    let (name, text) = SHIPPED.iter().find(|(shipped, _)| *shipped == name)?;
    Some(parse(text, &format!("data/rigs/{name}.toml")))
}

impl RigFile {
    fn rig(self) -> Result<Rig, RigFault> {
        let eye_distance = 1e-3 * self.eye.distance_mm;
        let (rig_from_kitchen, residual) = self.kitchen.transform()?;
        let measured = Measured {
            eye: DVec3::from_array(self.eye.position_m),
            eye_distance,
            mirror: self.mirror.plane("mirror")?,
            screen: screen(self.panel, self.projector)?,
            rig_from_kitchen,
            residual,
            sheet: Sheet { middle: DVec3::from_array(self.sheet.middle_m), size: DVec2::from_array(self.sheet.size_m) },
            name: self.name,
        };
        measured.rig()
    }
}

fn screen(panel: Option<PanelTable>, projector: Option<ProjectorTable>) -> Result<Screen, RigFault> {
    match (panel, projector) {
        (Some(panel), None) => panel.screen(),
        (None, Some(projector)) => projector.screen(),
        _ => Err(RigFault::new(
            "panel",
            "the rig needs exactly one of [panel] and [projector]",
            "write one of the two tables",
        )),
    }
}

impl PlaneTable {
    fn plane(&self, key: &str) -> Result<Plane, RigFault> {
        Ok(Plane { point: DVec3::from_array(self.point_m), normal: direction(&format!("{key}.normal"), self.normal)? })
    }
}

impl PanelTable {
    fn screen(&self) -> Result<Screen, RigFault> {
        let first = DVec3::from_array(self.top_left_m);
        let row = DVec3::from_array(self.top_right_m) - first;
        let column = DVec3::from_array(self.bottom_left_m) - first;
        let cosine_bound = LARGEST_COSINE * row.length() * column.length();
        if row.cross(column).length() < SMALLEST_PANEL || row.dot(column).abs() > cosine_bound {
            let message = "the three corners do not form a right angle";
            return Err(RigFault::new("panel.top_left_m", message, "measure the corners of the lit area again"));
        }
        Ok(Screen::Panel(Panel { pixels: pixels(self.pixels), first, row, column }))
    }
}

impl ProjectorTable {
    fn screen(&self) -> Result<Screen, RigFault> {
        let axis = direction("projector.axis", self.axis)?;
        let right = direction("projector.right", self.right)?;
        let across = (right - right.dot(axis) * axis).try_normalize();
        let along =
            || RigFault::new("projector.right", "it is parallel to the axis", "give the direction of a pixel row");
        let focal = self.focal_px;
        let centre = DVec2::from_array(self.principal_px);
        let k = [self.k1, self.k2];
        Ok(Screen::Projector(Projector {
            pixels: pixels(self.pixels),
            position: DVec3::from_array(self.position_m),
            axis,
            right: across.ok_or_else(along)?,
            focal,
            lens: Lens { k, centre, unit: focal },
            board: self.board.plane("projector.board")?,
        }))
    }
}

impl KitchenTable {
    /// Returns the pose of the kitchen in the rig, from touched points, else from the home pose of the pan, else as given.
    fn transform(&self) -> Result<(Rigid, Option<f64>), RigFault> {
        if !self.touched.is_empty() {
            return self.touched();
        }
        if let Some(home) = &self.home {
            let [x, y, z, w] = home.rotation_xyzw;
            let turn = DQuat::from_xyzw(x, y, z, w);
            if !turn.is_finite() || (turn.length() - 1.0).abs() > LARGEST_LENGTH_ERROR {
                let message = "its length is not 1";
                return Err(RigFault::new("kitchen.home.rotation_xyzw", message, "write a unit quaternion x, y, z, w"));
            }
            let home = Rigid { rotation: turn.normalize(), shift: DVec3::from_array(home.position_m) };
            // In its home pose the pan is at the centre of the hob.
            return Ok((Rigid::from_home(&home, &Rigid::IDENTITY), None));
        }
        let turn = self.turn_deg.to_radians();
        let shift = DVec3::from_array(self.origin_m);
        Ok((Rigid { rotation: DQuat::from_rotation_z(turn), shift }, None))
    }

    fn touched(&self) -> Result<(Rigid, Option<f64>), RigFault> {
        let pairs: Vec<_> = self.touched.iter().map(|t| [t.kitchen_m, t.rig_m].map(DVec3::from_array)).collect();
        let refused = |e: RegistrationError| {
            RigFault::new("kitchen.touched", e.to_string(), "touch three or more points spread over pan and table")
        };
        let Registered { transform, residual } = register(&pairs).map_err(refused)?;
        if residual.is_nan() || residual > LARGEST_RESIDUAL {
            let message = format!("the residual of the points is {:.1} mm (RMS)", 1e3 * residual);
            return Err(RigFault::new(
                "kitchen.touched",
                message,
                "check which point is which, and their units: metres",
            ));
        }
        Ok((transform, Some(residual)))
    }
}

fn direction(key: &str, along: [f64; 3]) -> Result<DVec3, RigFault> {
    let none = || RigFault::new(key, "it has no direction", "write three numbers that are not all 0");
    DVec3::from_array(along).try_normalize().ok_or_else(none)
}

fn pixels(sides: [u32; 2]) -> DVec2 {
    DVec2::from_array(sides.map(f64::from))
}

#[cfg(test)]
mod tests {
    use saute_schema::FormatSchema;

    use super::*;

    #[test]
    fn the_shipped_rigs_satisfy_the_schema() {
        let schema = FormatSchema::of::<RigFile>();
        for (name, text) in SHIPPED {
            assert_eq!(schema.findings(text), Vec::new(), "{name}");
        }
    }

    fn refused(from: &str, to: &str) -> String {
        let (name, text) = SHIPPED[0];
        assert!(text.contains(from), "{from}");
        parse(&text.replacen(from, to, 1), name).expect_err("is refused").to_string()
    }

    #[test]
    fn the_shipped_rigs_are_read_and_a_panel_before_a_mirror_is_flipped() {
        let [panel, behind] = SHIPPED.map(|(name, _)| shipped(name).expect("is there").expect("is read"));
        assert!(panel.nominal.flips());
        // A board that is lit from behind and seen in a mirror turns the picture over twice.
        assert!(!behind.nominal.flips());
    }

    #[test]
    fn all_marks_of_the_sheet_are_shown_with_room_for_their_crosses() {
        for (name, _) in SHIPPED {
            let rig = shipped(name).expect("is there").expect("is read");
            let size = rig.screen.pixels();
            for place in rig.mark_places().expect("before the eye") {
                let pixel = rig.nominal.pixel(place);
                let room = pixel.min(size - pixel).min_element();
                assert!(room > 40.0, "{name}: {pixel}");
            }
        }
    }

    #[test]
    fn a_bad_number_is_refused_with_file_key_and_remedy() {
        let said = refused("position_m = [0.0, -0.35, 0.55]", "position_m = [0.0, -350.0, 550.0]");
        assert!(
            said.contains("flat-screen")
                && said.contains("position_m = -350 is out of range")
                && said.contains("remedy"),
            "{said}"
        );
        let said = refused("normal = [0.0, 0.1736, 0.9848]", "normal = [0.0, 0.0, 0.0]");
        assert!(said.contains("mirror.normal"), "{said}");
        let said = refused("position_m = [0.0, -0.35, 0.55]", "position_m = [0.0, -0.35, 0.05]");
        assert!(said.contains("screen") && said.contains("behind the mirror"), "{said}");
        let said = refused("distance_mm", "distance_m");
        assert!(said.contains("flat-screen:") && said.contains("distance_m"), "{said}");
    }

    #[test]
    fn touched_points_and_a_home_pose_place_the_kitchen() {
        let (name, text) = SHIPPED[0];
        let with = |kitchen: &str| parse(&text.replace("origin_m = [0.0, 0.0, 0.0]\nturn_deg = 0.0", kitchen), name);
        let rig = with(
            "touched = [{ kitchen_m = [0.0, 0.0, 0.0], rig_m = [0.01, 0.02, 0.0] }, { kitchen_m = [0.1, 0.0, 0.0], rig_m = [0.01, 0.12, 0.0] }, { kitchen_m = [0.0, 0.1, 0.0], rig_m = [-0.09, 0.02, 0.0] }]",
        )
        .expect("is read");
        let at = rig.rig_from_kitchen.point(DVec3::new(0.1, 0.1, 0.05));
        assert!(at.distance(DVec3::new(-0.09, 0.12, 0.05)) < 1e-9, "{at}");
        assert!(rig.residual.is_some_and(|r| r < 1e-9));
        let rig = with("home = { position_m = [0.0, 0.05, 0.01], rotation_xyzw = [0.0, 0.0, 0.0, 1.0] }");
        assert_eq!(rig.expect("is read").rig_from_kitchen.shift, DVec3::new(0.0, 0.05, 0.01));
        let said = with("touched = [{ kitchen_m = [0, 0, 0], rig_m = [0, 0, 0] }]").expect_err("is refused");
        assert!(said.to_string().contains("three or more"), "{said}");
    }
}
