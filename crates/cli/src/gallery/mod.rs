//! `saute gallery`: the figures of the 2013 paper with this simulator's foods, each with its numbers.

mod figure;
mod moment;
mod page;
mod plate;

use std::path::PathBuf;
use std::process::ExitCode;

use saute_kitchen::data::library::DEFAULT_SCALE;
use saute_picture::still::headless::Gpu;
use saute_picture::still::png_file::png_bytes;
use saute_picture::still::shot::ShotError;

use self::figure::{COOKS, FIGURES};
use crate::error::CliError;
use crate::input::data_library::DataLibrary;
use crate::output::out_dir::OutDir;
use crate::output::progress::Progress;
use crate::output::stderr;
use crate::picture::size::size;

/// `saute gallery`.
#[derive(Debug, clap::Args)]
pub struct GalleryArgs {
    /// Folder for the figures (PNG) and the page with their numbers (gallery.md); created if missing.
    #[arg(long, value_name = "DIR", default_value = "gallery-out")]
    pub out: PathBuf,
    /// Size of one panel in pixels.
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "800x450", value_parser = size)]
    pub size: [u32; 2],
}

/// Cooks the recipes of the gallery, renders its figures and writes them.
pub fn run(args: &GalleryArgs, data: &DataLibrary) -> Result<ExitCode, CliError> {
    let scales = data.scales(DEFAULT_SCALE)?;
    let out = OutDir::prepare(&args.out)?;
    let gpu = Gpu::open().map_err(ShotError::from)?;
    let progress = Progress::over((COOKS.len() + FIGURES.len()) as u64);
    let mut moments = Vec::new();
    for (cook, _) in COOKS {
        progress.next(format!("cooking {cook}"));
        moments.extend(moment::moments(cook, &data.library)?);
    }
    let mut files = Vec::new();
    for figure in &FIGURES {
        progress.next(format!("drawing {}", figure.title));
        let picture = plate::plate(&gpu, figure, &moments, &scales, args.size);
        files.push((format!("{}.png", figure.name), png_bytes(&picture)?));
    }
    files.push(("gallery.md".to_owned(), page::page(&moments).into_bytes()));
    let place = out.place();
    out.fill(files)?;
    stderr::say(format!("{} figures and gallery.md are in {place}", FIGURES.len()));
    Ok(ExitCode::SUCCESS)
}
