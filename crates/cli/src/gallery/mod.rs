//! `saute gallery`: the figures of the 2013 paper, or every food from raw to burnt, each with its numbers.

mod figure;
mod looks;
mod moment;
mod page;
mod paper;
mod plate;

use std::path::PathBuf;
use std::process::ExitCode;

use saute_kitchen::data::library::DEFAULT_SCALE;
use saute_picture::still::headless::Gpu;
use saute_picture::still::png_file::png_bytes;
use saute_picture::still::shot::ShotError;

use self::figure::{Book, Figure};
use self::looks::LOOKS;
use self::paper::PAPER;
use crate::error::CliError;
use crate::input::data_library::DataLibrary;
use crate::output::out_dir::OutDir;
use crate::output::progress::Progress;
use crate::output::stderr;
use crate::picture::size::size;

/// `saute gallery`.
#[derive(Debug, clap::Args)]
pub struct GalleryArgs {
    /// Folder for the figures (PNG) and the page with their numbers (gallery.md or looks.md); created if missing.
    #[arg(long, value_name = "DIR", default_value = "gallery-out")]
    pub out: PathBuf,
    /// Size of one panel in pixels.
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "800x450", value_parser = size)]
    pub size: [u32; 2],
    /// Draws every food from raw to burnt instead, or one of them.
    #[arg(long, value_name = "FOOD", num_args = 0..=1, default_missing_value = ALL)]
    pub looks: Option<String>,
}

/// Stands for all foods.
const ALL: &str = "all";

/// The figures of a book, or the one of a food.
fn chosen(book: &'static Book, food: Option<&str>) -> Result<Vec<&'static Figure>, CliError> {
    let figures: Vec<_> = book.figures.iter().filter(|figure| food.is_none_or(|name| name == figure.name)).collect();
    if figures.is_empty() {
        let names: Vec<&str> = book.figures.iter().map(|figure| figure.name).collect();
        let place = format!("--looks {}", food.unwrap_or_default());
        return Err(CliError::place(place, "is no food of the looks", format!("write one of: {}", names.join(", "))));
    }
    Ok(figures)
}

/// Cooks the recipes of the gallery, renders its figures and writes them.
pub fn run(args: &GalleryArgs, data: &DataLibrary) -> Result<ExitCode, CliError> {
    let scales = data.scales(DEFAULT_SCALE)?;
    let book = if args.looks.is_some() { &LOOKS } else { &PAPER };
    let figures = chosen(book, args.looks.as_deref().filter(|food| *food != ALL))?;
    let shows = |cook: &str| figures.iter().any(|figure| figure.panels.iter().any(|panel| panel.cook == cook));
    let cooks: Vec<&str> = book.cooks.iter().map(|(cook, _)| *cook).filter(|cook| shows(cook)).collect();
    let out = OutDir::prepare(&args.out)?;
    let gpu = Gpu::open().map_err(ShotError::from)?;
    let progress = Progress::over((cooks.len() + figures.len()) as u64);
    let mut moments = Vec::new();
    for cook in cooks {
        progress.next(format!("cooking {cook}"));
        moments.extend(moment::moments(book, cook, &data.library)?);
    }
    let mut files = Vec::new();
    for figure in &figures {
        progress.next(format!("drawing {}", figure.title));
        let picture = plate::plate(&gpu, figure, &moments, &scales, args.size);
        files.push((format!("{}.png", figure.name), png_bytes(&picture)?));
    }
    files.push((book.page.to_owned(), page::page(book, &figures, &moments).into_bytes()));
    let place = out.place();
    out.fill(files)?;
    stderr::say(format!("{} figures and {} are in {place}", figures.len(), book.page));
    Ok(ExitCode::SUCCESS)
}
