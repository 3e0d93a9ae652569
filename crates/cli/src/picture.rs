//! `saute shot` and `saute bench frame`: pictures from the app's own renderer.

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;
use std::time::Instant;

use clap::ValueEnum;
use saute_app::bench_frame::{DISH, DISH_FROM_S, FROM_S, SHRIMPS, SHRIMPS_FROM_S};
use saute_app::mirror::frame::MirrorOptions;
use saute_app::mirror::rig::Rig;
use saute_app::mirror::rig_file;
use saute_app::mirror::stereo::Stereo;
use saute_app::mirror::still::mirror_shot;
use saute_app::png_file::png_bytes;
use saute_app::quality_choice::QualityChoice;
use saute_app::scene::quality::Quality;
use saute_app::scene::white_balance::WhiteBalance;
use saute_app::shot::ShotOptions;
use saute_app::{Start, View};
use saute_kitchen::library::DEFAULT_SCALE;
use saute_recipe::Recipe;

use crate::error::CliError;
use crate::out_file::OutFile;
use crate::shelf::Shelf;
use crate::{recipe_source, stdout, text_file};

/// `saute shot`.
#[derive(Debug, clap::Args)]
pub struct ShotArgs {
    /// A recipe file, or the id of a shipped recipe.
    #[arg(value_name = "RECIPE")]
    pub recipe: String,
    /// Simulated time of the picture.
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_hyphen_values = true)]
    pub at: f64,
    /// What the colours mean.
    #[arg(long, value_enum, default_value_t = ViewName::Look, conflicts_with = "split")]
    pub view: ViewName,
    /// Draws the look at the left and this view of the same instant at the right: see `saute list views`.
    #[arg(long, value_name = "VIEW", value_parser = field)]
    pub split: Option<View>,
    /// Cuts the food open.
    #[arg(long)]
    pub slice: bool,
    /// What the look calls white.
    #[arg(long, value_enum, default_value_t = WhiteName::AsShot)]
    pub white_balance: WhiteName,
    /// How much work the picture is worth.
    #[arg(long, value_enum, default_value_t = QualityName::Smooth)]
    pub quality: QualityName,
    /// Writes unlit colours without tone mapping, for measuring.
    #[arg(long)]
    pub flat: bool,
    /// The scale of the doneness view: see `saute list scales`.
    #[arg(long, value_name = "SCALE", default_value = DEFAULT_SCALE)]
    pub doneness: String,
    /// Draws what a half mirror's screen or projector shows: a rig file, or the name of a shipped rig (flat-screen,
    /// projector); flat-screen unless given.
    #[arg(long, value_name = "RIG", num_args = 0..=1, default_missing_value = "flat-screen", conflicts_with_all = ["split", "flat"])]
    pub mirror: Option<String>,
    /// A picture for each eye in the mirror.
    #[arg(long, value_enum, requires = "mirror")]
    pub stereo: Option<StereoName>,
    /// Draws the virtual pan in the mirror, where else the real one is seen.
    #[arg(long, requires = "mirror")]
    pub show_pan: bool,
    /// Size of the picture in pixels.
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "1280x720", value_parser = size)]
    pub size: [u32; 2],
    /// The PNG file to write.
    #[arg(long, value_name = "FILE.png")]
    pub out: PathBuf,
}

/// `saute bench frame`.
#[derive(Debug, clap::Args)]
pub struct BenchFrameArgs {
    /// A recipe file, or the id of a shipped recipe.
    #[arg(value_name = "RECIPE", default_value = "medium")]
    pub recipe: String,
    /// A made-up scene instead of a recipe.
    #[arg(long, value_enum)]
    pub scene: Option<SceneName>,
    /// Size of the frame in pixels.
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "1280x720", value_parser = size)]
    pub size: [u32; 2],
    /// How much work a picture is worth; automatic unless given.
    #[arg(long, value_enum)]
    pub quality: Option<QualityName>,
    /// Prints the numbers as JSON.
    #[arg(long)]
    pub json: bool,
}

/// Scenes to measure that are no recipes.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum SceneName {
    /// 35 shrimps of the default mesh in the pan.
    Shrimps,
    /// A steak, 11 carrots and 11 leeks that fry.
    Dish,
}

/// The views by their names on the command line.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum ViewName {
    /// As the eye sees it.
    Look,
    /// Temperature now.
    Temperature,
    /// Water left, of what the raw food held there.
    Moisture,
    /// Doneness by the highest temperature so far.
    Doneness,
    /// Browning index.
    Browning,
    /// How far pathogens were killed.
    Lethality,
    /// Fat in the flesh.
    Marbling,
}

impl From<ViewName> for View {
    fn from(name: ViewName) -> Self {
        match name {
            ViewName::Look => Self::Look,
            ViewName::Temperature => Self::Temperature,
            ViewName::Moisture => Self::Moisture,
            ViewName::Doneness => Self::Doneness,
            ViewName::Browning => Self::Browning,
            ViewName::Lethality => Self::Lethality,
            ViewName::Marbling => Self::Marbling,
        }
    }
}

/// The white balances by their names on the command line.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum WhiteName {
    /// A kitchen in the evening sun (5750 K).
    AsShot,
    /// White is white (6500 K).
    Neutral,
    /// As under an overcast sky (8000 K).
    Cool,
    /// As under a lamp (4500 K).
    Warm,
}

impl From<WhiteName> for WhiteBalance {
    fn from(name: WhiteName) -> Self {
        match name {
            WhiteName::AsShot => Self::AsShot,
            WhiteName::Neutral => Self::Neutral,
            WhiteName::Cool => Self::Cool,
            WhiteName::Warm => Self::Warm,
        }
    }
}

/// The qualities by their names on the command line.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum QualityName {
    /// As the window draws without a graphics card.
    Quick,
    /// Smooth edges everywhere.
    Smooth,
    /// Besides, shadows where food touches the ground, and finer maps and textures.
    Best,
}

impl From<QualityName> for Quality {
    fn from(name: QualityName) -> Self {
        match name {
            QualityName::Quick => Self::Quick,
            QualityName::Smooth => Self::Smooth,
            QualityName::Best => Self::Best,
        }
    }
}

/// Ways of stereo by their names on the command line.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum StereoName {
    /// Red for the left eye, cyan for the right.
    Anaglyph,
    /// The left eye's picture in the left half.
    SideBySide,
}

impl From<StereoName> for Stereo {
    fn from(name: StereoName) -> Self {
        match name {
            StereoName::Anaglyph => Self::Anaglyph,
            StereoName::SideBySide => Self::SideBySide,
        }
    }
}

/// Sides that a picture may have [pixels] (chosen: every graphics adapter can draw 8192).
const SIDES: std::ops::RangeInclusive<u32> = 64..=8192;

pub(crate) fn size(text: &str) -> Result<[u32; 2], String> {
    let sides = text.split_once('x').and_then(|(w, h)| Some([w.parse().ok()?, h.parse().ok()?]));
    match sides {
        Some(sides) if sides.iter().all(|s| SIDES.contains(s)) => Ok(sides),
        _ => Err(format!("write WIDTHxHEIGHT in pixels, each {} to {}, as in 1280x720", SIDES.start(), SIDES.end())),
    }
}

/// A view of a field, which can stand beside the look.
fn field(text: &str) -> Result<View, String> {
    let names = ViewName::value_variants().iter().filter_map(ValueEnum::to_possible_value).skip(1);
    let fields: Vec<String> = names.map(|name| name.get_name().to_owned()).collect();
    match ViewName::from_str(text, false) {
        Ok(name) if View::from(name) != View::Look => Ok(name.into()),
        _ => Err(format!("write the view that stands beside the look: {}", fields.join(", "))),
    }
}

fn seconds(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(s) if s.is_finite() && s >= 0.0 => Ok(s),
        _ => Err("write seconds from the start of the recipe, as in 300".to_owned()),
    }
}

/// Draws one picture.
pub fn shot(args: &ShotArgs, shelf: &Shelf) -> Result<ExitCode, CliError> {
    let recipe = recipe_source::load(&args.recipe, shelf)?;
    let out = OutFile::prepare(&args.out)?;
    let scale = shelf.scale(&args.doneness)?;
    let options = ShotOptions {
        view: args.split.unwrap_or(args.view.into()),
        split: args.split.is_some(),
        slice: args.slice,
        white_balance: args.white_balance.into(),
        quality: args.quality.into(),
        flat: args.flat,
        scale,
    };
    let library = &shelf.library;
    let picture = match &args.mirror {
        None => saute_app::shot::shot(recipe, library, args.at, options, args.size)?,
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

/// A shipped rig by its name, else a rig file.
fn rig(name: &str) -> Result<Rig, CliError> {
    match rig_file::shipped(name) {
        Some(rig) => Ok(rig?),
        None => Ok(rig_file::parse(&text_file::read(Path::new(name))?, name)?),
    }
}

/// Measures frames.
pub fn bench_frame(args: &BenchFrameArgs, shelf: &Shelf, process_start: Instant) -> Result<ExitCode, CliError> {
    let (recipe, from_s) = match args.scene {
        Some(SceneName::Dish) => (Recipe::parse(DISH, "dish", &shelf.library)?, DISH_FROM_S),
        Some(SceneName::Shrimps) => (Recipe::parse(SHRIMPS, "shrimps", &shelf.library)?, SHRIMPS_FROM_S),
        None => (recipe_source::load(&args.recipe, shelf)?, FROM_S),
    };
    let quality = args.quality.map_or(QualityChoice::Automatic, |name| QualityChoice::Always(name.into()));
    let start = Start { library: Some(Arc::new(shelf.library.clone())), recipe: Some(recipe), ..Start::default() };
    let bench = saute_app::bench_frame::bench_frame(start, args.size, from_s, quality, process_start)?;
    if args.json {
        stdout::print(&format!("{}\n", serde_json::to_string_pretty(&bench)?))?;
        return Ok(ExitCode::SUCCESS);
    }
    let [w, h] = bench.scene_size;
    stdout::print(&format!(
        "{}, {}\nwindow {} × {}, scene {w} × {h}, quality {}, {} frames\nmedian {:.1} frames/s, 5th percentile {:.1} frames/s, first frame after {:.2} s\n",
        bench.recipe,
        bench.adapter,
        bench.size[0],
        bench.size[1],
        format!("{:?}", bench.quality).to_lowercase(),
        bench.frames,
        bench.frames_per_s.median,
        bench.frames_per_s.p5,
        bench.first_frame_s
    ))?;
    Ok(ExitCode::SUCCESS)
}
