//! `saute shot`: pictures of a recipe: one, a sheet of several, or an animation.

use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use saute_kitchen::TICK_S;
use saute_kitchen::data::library::DEFAULT_SCALE;
use saute_mirror::options::MirrorOptions;
use saute_mirror::rig::Rig;
use saute_mirror::rig_file;
use saute_mirror::stereo::Stereo;
use saute_picture::View;
use saute_picture::cut::section::Picture;
use saute_picture::mirrored::still::mirror_shot_of;
use saute_picture::still::animation::Format;
use saute_picture::still::png_file::png_bytes;
use saute_picture::still::series::Series;
use saute_picture::still::shot::{Eye, ShotOptions, cook_to_end, shot_of};
use saute_recipe::Cook;
use saute_scene::camera::FIELD_OF_VIEW;
use saute_scene::light::photo::Photo;
use saute_scene::quality::Quality;
use saute_scene::renderer::SampleProgress;

use super::choices::{LightName, QualityName, StereoName, ViewName, WhiteName};
use super::contact_sheet::{check_sheet, contact_sheet};
use super::eye::{eye, field_of_view};
use super::size::size;
use super::time_lapse::{Lapse, time_lapse};
use crate::error::CliError;
use crate::input::data_library::DataLibrary;
use crate::input::{session_source, text_file};
use crate::output::out_file::OutFile;
use crate::output::progress::Progress;

/// `saute shot`.
#[derive(Debug, clap::Args)]
pub struct ShotArgs {
    /// Recipe file, id of a shipped recipe, or session file (.saute).
    #[arg(value_name = "RECIPE")]
    pub recipe: String,
    /// Simulated time of the picture; of an animation the end. The end of the cook unless given.
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_hyphen_values = true)]
    pub at: Option<f64>,
    /// Renders an animation with a frame for every so many simulated seconds, ten frames a second, up to --at or to the
    /// end of the recipe; --out names a .gif or an .apng.
    #[arg(long, value_name = "EVERY_S", value_parser = every, conflicts_with_all = ["mirror", "contact_sheet"])]
    pub time_lapse: Option<f64>,
    /// Renders the pictures of several times in one file, in rows of up to four, each of the size given.
    #[arg(long, value_name = "SECONDS,…", value_parser = seconds, value_delimiter = ',', conflicts_with_all = ["mirror", "at"])]
    pub contact_sheet: Vec<f64>,
    /// Meaning of the colours.
    #[arg(long, value_enum, default_value_t = ViewName(View::Look), conflicts_with = "split")]
    pub view: ViewName,
    /// Renders the look in the left half and this view of the same instant in the right half, see `saute list views`.
    #[arg(long, value_name = "VIEW", value_parser = field)]
    pub split: Option<View>,
    /// Shows the food cut open.
    #[arg(long)]
    pub slice: bool,
    /// Shows the food as it is served: on a plate, a thick slice cut with one half on the other; the eye is at the plate.
    #[arg(long, conflicts_with_all = ["slice", "camera", "mirror", "flat"])]
    pub plated: bool,
    /// White balance of the look.
    #[arg(long, value_enum, default_value_t = WhiteName::AsShot)]
    pub white_balance: WhiteName,
    /// Light of the room.
    #[arg(long, value_enum, default_value_t = LightName::Daylight)]
    pub light: LightName,
    /// Exposure over the usual one, from -2 to 2; each 1 doubles the light.
    #[arg(long, value_name = "EV", default_value_t = 0.0, value_parser = exposure, allow_hyphen_values = true, conflicts_with_all = ["flat", "mirror"])]
    pub exposure: f32,
    /// Blur of what is behind the food over the usual one, from 0 (all is sharp) to 4; seen with --quality best.
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, value_parser = blur, conflicts_with_all = ["flat", "mirror"])]
    pub blur: f32,
    /// Rendering quality.
    #[arg(long, value_enum, default_value_t = QualityName::Smooth)]
    pub quality: QualityName,
    /// Samples of light of which the picture is the mean: soft shadows, a lens, smooth edges. Up to 256; 1 is a single picture.
    /// More need --quality best and the look.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=256), conflicts_with_all = ["flat", "mirror"])]
    pub samples: u32,
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
    /// without X,Y,Z it looks at the first food. By default over hob and board, or over the food when all of it was taken
    /// out.
    #[arg(long, value_name = "EYE", value_parser = eye, allow_hyphen_values = true, conflicts_with = "mirror")]
    pub camera: Option<Eye>,
    /// Field of view along the height of the picture [°].
    #[arg(long, value_name = "DEGREES", default_value_t = FIELD_OF_VIEW.to_degrees().round(), value_parser = field_of_view, conflicts_with = "mirror")]
    pub fov: f32,
    /// Size of the picture in pixels.
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "1280x720", value_parser = size)]
    pub size: [u32; 2],
    /// PNG file to write; of a time lapse a GIF or an APNG.
    #[arg(long, value_name = "FILE.png")]
    pub out: PathBuf,
}

/// Reads a view other than the look.
fn field(text: &str) -> Result<View, String> {
    let mut fields = View::ALL.into_iter().filter(|view| *view != View::Look);
    let known: Vec<&str> = fields.clone().map(|view| view.spec().id).collect();
    let found = fields.find(|view| view.spec().id == text);
    found.ok_or_else(|| format!("write a view other than the look: {}", known.join(", ")))
}

/// Reads a time from the start of the recipe [s].
fn seconds(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(s) if s.is_finite() && s >= 0.0 => Ok(s),
        _ => Err("write seconds from the start of the recipe, as in 300".to_owned()),
    }
}

/// Reads an interval of simulated time [s].
pub fn every(text: &str) -> Result<f64, String> {
    match seconds(text) {
        Ok(s) if s >= TICK_S => Ok(s),
        _ => Err(format!("write the simulated seconds from one to the next, {TICK_S} or more, as in 5")),
    }
}

/// Reads an exposure [EV].
fn exposure(text: &str) -> Result<f32, String> {
    within(text, Photo::EXPOSURES_EV).ok_or_else(|| "write a number of stops from -2 to 2, as in 0.5".to_owned())
}

/// Reads a blur [-].
fn blur(text: &str) -> Result<f32, String> {
    within(text, Photo::APERTURES).ok_or_else(|| "write a factor from 0 (all is sharp) to 4, as in 2".to_owned())
}

fn within(text: &str, range: RangeInclusive<f32>) -> Option<f32> {
    text.parse().ok().filter(|value| range.contains(value))
}

/// Renders the pictures and writes them.
pub fn run(args: &ShotArgs, data: &DataLibrary) -> Result<ExitCode, CliError> {
    check_samples(args)?;
    let source = session_source::load(&args.recipe, data)?;
    let kind = Rendered::of(args)?;
    let out = OutFile::prepare(&args.out)?;
    let scales = data.scales(&args.doneness)?;
    let options = ShotOptions {
        view: args.split.unwrap_or(args.view.into()),
        split: args.split.is_some(),
        slice: args.slice,
        white_balance: args.white_balance.into(),
        light: args.light.into(),
        photo: Photo { exposure_ev: args.exposure, aperture: args.blur },
        quality: args.quality.into(),
        flat: args.flat,
        scales,
        eye: args.camera,
        field_of_view: args.fov.to_radians(),
        samples: args.samples,
        plated: args.plated,
    };
    let mut cook = session_source::cook(source, data)?;
    let bytes = match kind {
        Rendered::One(at_s) => {
            let at_s = at_s.map_or_else(|| cook_to_end(&mut cook), Ok)?;
            png_bytes(&one(args, cook, at_s, options)?)?
        }
        Rendered::Sheet => {
            let mut series = Series::of(cook, options, args.size)?;
            png_bytes(&contact_sheet(&mut series, &args.contact_sheet, args.size)?)?
        }
        Rendered::Lapse(format, every_s) => {
            let mut series = Series::of(cook, options, args.size)?;
            time_lapse(&mut series, &Lapse { format, every_s, until_s: args.at, size: args.size })?
        }
    };
    out.fill(&bytes)?;
    Ok(ExitCode::SUCCESS)
}

/// Only a look at the best level gathers light.
fn check_samples(args: &ShotArgs) -> Result<(), CliError> {
    let best = Quality::from(args.quality) == Quality::Best;
    let wrong =
        |message: &str, remedy: &str| Err(CliError::place(format!("--samples {}", args.samples), message, remedy));
    match (args.samples, View::from(args.view)) {
        (1, _) => Ok(()),
        (_, View::Look) if best => Ok(()),
        (_, View::Look) => wrong("are gathered by the best quality only", "add --quality best, or leave --samples out"),
        _ => wrong("are gathered by the look only", "leave --view or --samples out"),
    }
}

/// What is rendered.
enum Rendered {
    /// One picture at a time [s], or at the end of the cook.
    One(Option<f64>),
    /// Several pictures in one.
    Sheet,
    /// An animation with a frame for every so many seconds.
    Lapse(Format, f64),
}

impl Rendered {
    /// Reads it from the arguments; the name of the file must fit.
    fn of(args: &ShotArgs) -> Result<Self, CliError> {
        let ending = args.out.extension().and_then(|e| e.to_str()).map(str::to_ascii_lowercase);
        let wrong =
            |remedy: &str| CliError::place(format!("--out {}", args.out.display()), "has the wrong ending", remedy);
        if let Some(every_s) = args.time_lapse {
            let format = Format::of(&args.out)
                .ok_or_else(|| wrong("a time lapse is a GIF or an APNG: write --out FILE.gif or FILE.apng"))?;
            return Ok(Self::Lapse(format, every_s));
        }
        if ending.as_deref() != Some("png") {
            return Err(wrong("pictures are written as PNG: write --out FILE.png"));
        }
        if args.contact_sheet.is_empty() {
            return Ok(Self::One(args.at));
        }
        check_sheet(args.contact_sheet.len(), args.size)?;
        Ok(Self::Sheet)
    }
}

/// One picture, or that of a half mirror.
fn one(args: &ShotArgs, cook: Cook, at_s: f64, options: ShotOptions) -> Result<Picture, CliError> {
    let Some(name) = &args.mirror else {
        let progress = Progress::over(args.samples.into());
        let told: SampleProgress = Box::new(move |taken, of| progress.next(format!("sample {taken} of {of}")));
        return Ok(shot_of(cook, at_s, options, args.size, Some(told))?);
    };
    let rig = rig(name)?;
    let stereo = args.stereo.map_or(Stereo::Off, Stereo::from);
    let mirror = MirrorOptions { stereo, eye_distance: rig.eye_distance, pan_shown: args.show_pan };
    Ok(mirror_shot_of(cook, at_s, &options, (&rig, &mirror), args.size)?)
}

/// Returns a shipped rig by its name, or reads a rig file.
fn rig(name: &str) -> Result<Rig, CliError> {
    match rig_file::shipped(name) {
        Some(rig) => Ok(rig?),
        None => Ok(rig_file::parse(&text_file::read(Path::new(name))?, name)?),
    }
}
