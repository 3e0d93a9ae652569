//! Pictures of the cross-sections at each step.

use saute_app::png_file::{PngError, png_bytes};
use saute_app::{TemperatureMap, View, section_picture};
use saute_kitchen::{Piece, Place};
use saute_recipe::Cook;
use saute_recipe::Fired;

/// Fineness of the picture files [pixels per mm].
const FILE_PER_MM: f64 = 12.0;

/// Fineness of the report's pictures [pixels per mm]: enough for a phone, small enough to mail.
const REPORT_PER_MM: f64 = 8.0;

/// Room for everything but the pictures [bytes] (chosen: a cook of a day has 9 MB of series).
const OTHER_FILES: u64 = 12 << 20;

/// A food's cross-section just after a step was carried out (at most one tick later).
#[derive(Debug)]
pub struct Snapshot {
    /// Number of the step, from 1.
    pub step: usize,
    /// When [s].
    pub time_s: f64,
    /// Name of the step's action.
    pub action: &'static str,
    /// Which food.
    pub food: String,
    /// Whether the recipe has other foods, too.
    pub of_several: bool,
    /// Pictures for files: look, temperature.
    pub full: [Vec<u8>; 2],
    /// Pictures for the report: look, temperature.
    pub small: [Vec<u8>; 2],
}

impl Snapshot {
    /// Pictures of those foods that are in the pan or out of it again, for each of the steps that were just carried out.
    pub fn take(cook: &Cook, fired: &[Fired], pictured: &[usize]) -> Result<Vec<Self>, PngError> {
        let first = cook.steps.len() + 1 - fired.len();
        let mut snapshots = Vec::new();
        let pieces = pictured.iter().map(|i| &cook.kitchen.pieces()[*i]);
        for piece in pieces.filter(|p| p.place != Place::Waiting) {
            let (full, small) = (paint(piece, FILE_PER_MM)?, paint(piece, REPORT_PER_MM)?);
            snapshots.extend(fired.iter().enumerate().map(|(i, step)| Self {
                step: first + i,
                time_s: step.time_s,
                action: step.action,
                food: piece.id.clone(),
                of_several: cook.kitchen.pieces().len() > 1,
                full: full.clone(),
                small: small.clone(),
            }));
        }
        Ok(snapshots)
    }

    /// Names and bytes of its files. What stands before the food's id holds no dot, so that no two names can meet.
    pub fn into_files(self) -> [(String, Vec<u8>); 2] {
        let food = if self.of_several { format!(".{}", self.food) } else { String::new() };
        let name = |view: &str| format!("section_{:02}_{}{view}{food}.png", self.step, self.action);
        let names = [name(""), name("_temperature")];
        let [look, temperature] = self.full;
        let [look_name, temperature_name] = names;
        [(look_name, look), (temperature_name, temperature)]
    }
}

fn paint(piece: &Piece, per_mm: f64) -> Result<[Vec<u8>; 2], PngError> {
    let picture = |view: View| {
        let colours = view.colour_map(TemperatureMap::Uniform, None);
        png_bytes(&section_picture(piece, 0.0, view, colours.as_ref(), per_mm))
    };
    Ok([picture(View::Look)?, picture(View::Temperature)?])
}

/// Which foods are pictured: all that belong to no group, and of each group the first piece, or every piece.
pub fn pictured(cook: &Cook, every_piece: bool) -> Vec<usize> {
    let groups = &cook.runner.recipe().groups;
    let follows = |i: usize| groups.iter().any(|g| g.members.contains(&i) && g.members.start != i);
    (0..cook.kitchen.pieces().len()).filter(|i| every_piece || !follows(*i)).collect()
}

/// What a cook with pictures of some foods may need on the disk [bytes]: no picture is larger than its pixels.
pub fn disk_space(cook: &Cook, pictured: &[usize]) -> u64 {
    let pixels = |p: &Piece| p.model.size()[1] * p.model.size()[2] * 1e6 * FILE_PER_MM * FILE_PER_MM;
    let bytes: f64 = pictured.iter().map(|i| 2.0 * 4.0 * pixels(&cook.kitchen.pieces()[*i])).sum();
    OTHER_FILES + (bytes * cook.runner.recipe().steps.len() as f64) as u64
}
