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
use self::looks::looks;
use self::paper::paper;
use self::plate::Drawing;
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
    /// Samples of light of each picture of the look: more take longer and have softer shadows; 1 is a plain picture.
    #[arg(long, value_name = "N", default_value_t = 32, value_parser = clap::value_parser!(u32).range(1..=256))]
    pub samples: u32,
    /// Draws every food from raw to burnt instead, or one of them.
    #[arg(long, value_name = "FOOD", num_args = 0..=1, default_missing_value = ALL)]
    pub looks: Option<String>,
    /// Draws only this figure, for instance 1-one-side; may be given more than once.
    #[arg(long, value_name = "NAME", conflicts_with = "looks")]
    pub figure: Vec<String>,
}

/// Means all foods.
const ALL: &str = "all";

impl GalleryArgs {
    /// The figures that are requested: all of a book, or those named.
    fn figures<'a>(&self, book: &'a Book) -> Result<Vec<&'a Figure>, CliError> {
        let (option, named) = match &self.looks {
            Some(food) if food != ALL => ("--looks", std::slice::from_ref(food)),
            Some(_) => ("--looks", [].as_slice()),
            None => ("--figure", self.figure.as_slice()),
        };
        let of = |name: &String| {
            book.figures.iter().find(|figure| figure.name == name).ok_or_else(|| unknown(book, option, name))
        };
        let found = named.iter().map(of).collect::<Result<Vec<_>, _>>()?;
        Ok(if found.is_empty() { book.figures.iter().collect() } else { found })
    }
}

fn unknown(book: &Book, option: &str, name: &str) -> CliError {
    let names: Vec<&str> = book.figures.iter().map(|figure| figure.name).collect();
    let remedy = format!("write one of: {}", names.join(", "));
    CliError::place(format!("{option} {name}"), "is no figure of this gallery", remedy)
}

/// Cooks the recipes of the gallery, renders its figures and writes them.
pub fn run(args: &GalleryArgs, data: &DataLibrary) -> Result<ExitCode, CliError> {
    let scales = data.scales(DEFAULT_SCALE)?;
    let book = if args.looks.is_some() { looks() } else { paper() };
    let figures = args.figures(&book)?;
    let shows = |cook: &str| figures.iter().any(|figure| figure.panels.iter().any(|panel| panel.cook == cook));
    let cooks: Vec<&'static str> = book.cooks.iter().map(|(cook, _)| *cook).filter(|cook| shows(cook)).collect();
    let out = OutDir::prepare(&args.out)?;
    let gpu = Gpu::open().map_err(ShotError::from)?;
    let progress = Progress::over((cooks.len() + figures.len()) as u64);
    let mut moments = Vec::new();
    for cook in cooks {
        progress.next(format!("cooking {cook}"));
        moments.extend(moment::moments(&book, cook, &data.library)?);
    }
    let mut files = Vec::new();
    let drawing = Drawing { gpu: &gpu, scales: &scales, size: args.size, samples: args.samples };
    for figure in &figures {
        progress.next(format!("drawing {}", figure.title));
        let picture = drawing.plate(figure, &moments);
        files.push((format!("{}.png", figure.name), png_bytes(&picture)?));
    }
    files.push((book.page.to_owned(), page::page(&book, &figures, &moments).into_bytes()));
    let place = out.place();
    out.fill(files)?;
    stderr::say(format!("{} figures and {} are in {place}", figures.len(), book.page));
    Ok(ExitCode::SUCCESS)
}
