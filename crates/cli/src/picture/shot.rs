//! `saute shot`: one picture of a recipe at one moment.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::ValueEnum;
use saute_kitchen::data::library::DEFAULT_SCALE;
use saute_picture::View;
use saute_picture::still::png_file::png_bytes;
use saute_picture::still::shot::{Eye, ShotOptions};
use saute_scene::camera::FIELD_OF_VIEW;
use saute_window::mirror::frame::MirrorOptions;
use saute_window::mirror::rig::Rig;
use saute_window::mirror::rig_file;
use saute_window::mirror::stereo::Stereo;
use saute_window::mirror::still::mirror_shot;

use super::choices::{LightName, QualityName, StereoName, ViewName, WhiteName};
use super::eye::{eye, field_of_view};
use super::size::size;
use crate::error::CliError;
use crate::input::data_library::DataLibrary;
use crate::input::{recipe_source, text_file};
use crate::output::out_file::OutFile;

/// `saute shot`.
#[derive(Debug, clap::Args)]
pub struct ShotArgs {
    /// Recipe file, or id of a shipped recipe.
    #[arg(value_name = "RECIPE")]
    pub recipe: String,
    /// Simulated time of the picture.
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_hyphen_values = true)]
    pub at: f64,
    /// Meaning of the colours.
    #[arg(long, value_enum, default_value_t = ViewName::Look, conflicts_with = "split")]
    pub view: ViewName,
    /// Renders the look in the left half and this view of the same instant in the right half, see `saute list views`.
    #[arg(long, value_name = "VIEW", value_parser = field)]
    pub split: Option<View>,
    /// Shows the food cut open.
    #[arg(long)]
    pub slice: bool,
    /// White balance of the look.
    #[arg(long, value_enum, default_value_t = WhiteName::AsShot)]
    pub white_balance: WhiteName,
    /// Light of the room.
    #[arg(long, value_enum, default_value_t = LightName::Daylight)]
    pub light: LightName,
    /// Rendering quality.
    #[arg(long, value_enum, default_value_t = QualityName::Smooth)]
    pub quality: QualityName,
    /// Renders unlit colours without tone mapping, for measurements.
    #[arg(long)]
    pub flat: bool,
    /// Scale of the doneness view, for foods that it fits, see `saute list scales`. Other foods keep their own.
    #[arg(long, value_name = "SCALE", default_value = DEFAULT_SCALE)]
    pub doneness: String,
    /// Renders the picture for the screen or projector of a half mirror: a rig file, or the name of a shipped rig
    /// (flat-screen, projector).
    #[arg(long, value_name = "RIG", num_args = 0..=1, default_missing_value = "flat-screen", conflicts_with_all = ["split", "flat"])]
    pub mirror: Option<String>,
    /// Renders one picture for each eye in the mirror.
    #[arg(long, value_enum, requires = "mirror")]
    pub stereo: Option<StereoName>,
    /// Renders the virtual pan in the mirror too; without it only the real pan is visible.
    #[arg(long, requires = "mirror")]
    pub show_pan: bool,
    /// Where the eye is: front, above, close-up (near the first food), or PITCH,YAW,DISTANCE[,X,Y,Z]. Angles in degrees
    /// (90 looks straight down, a positive yaw comes from the right), lengths in millimetres from the centre of the hob;
    /// without X,Y,Z it looks at the first food.
    #[arg(long, value_name = "EYE", value_parser = eye, allow_hyphen_values = true, conflicts_with = "mirror")]
    pub camera: Option<Eye>,
    /// Field of view along the height of the picture [°].
    #[arg(long, value_name = "DEGREES", default_value_t = FIELD_OF_VIEW.to_degrees().round(), value_parser = field_of_view, conflicts_with = "mirror")]
    pub fov: f32,
    /// Size of the picture in pixels.
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "1280x720", value_parser = size)]
    pub size: [u32; 2],
    /// PNG file to write.
    #[arg(long, value_name = "FILE.png")]
    pub out: PathBuf,
}

/// Reads a view other than the look.
fn field(text: &str) -> Result<View, String> {
    let names = ViewName::value_variants().iter().filter_map(ValueEnum::to_possible_value).skip(1);
    let fields: Vec<String> = names.map(|name| name.get_name().to_owned()).collect();
    match ViewName::from_str(text, false) {
        Ok(name) if View::from(name) != View::Look => Ok(name.into()),
        _ => Err(format!("write a view other than the look: {}", fields.join(", "))),
    }
}

/// Reads a time from the start of the recipe [s].
fn seconds(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(s) if s.is_finite() && s >= 0.0 => Ok(s),
        _ => Err("write seconds from the start of the recipe, as in 300".to_owned()),
    }
}

/// Renders one picture and writes it.
pub fn run(args: &ShotArgs, data: &DataLibrary) -> Result<ExitCode, CliError> {
    let recipe = recipe_source::load(&args.recipe, data)?;
    let out = OutFile::prepare(&args.out)?;
    let scales = data.scales(&args.doneness)?;
    let options = ShotOptions {
        view: args.split.unwrap_or(args.view.into()),
        split: args.split.is_some(),
        slice: args.slice,
        white_balance: args.white_balance.into(),
        light: args.light.into(),
        quality: args.quality.into(),
        flat: args.flat,
        scales,
        eye: args.camera,
        field_of_view: args.fov.to_radians(),
    };
    let library = &data.library;
    let picture = match &args.mirror {
        None => saute_picture::still::shot::shot(recipe, library, args.at, options, args.size)?,
        Some(name) => {
            let rig = rig(name)?;
            let stereo = args.stereo.map_or(Stereo::Off, Stereo::from);
            let mirror = MirrorOptions { stereo, eye_distance: rig.eye_distance, pan_shown: args.show_pan };
            mirror_shot(recipe, library, args.at, &options, (&rig, &mirror), args.size)?
        }
    };
    out.fill(&png_bytes(&picture)?)?;
    Ok(ExitCode::SUCCESS)
}

/// Returns a shipped rig by its name, or reads a rig file.
fn rig(name: &str) -> Result<Rig, CliError> {
    match rig_file::shipped(name) {
        Some(rig) => Ok(rig?),
        None => Ok(rig_file::parse(&text_file::read(Path::new(name))?, name)?),
    }
}
