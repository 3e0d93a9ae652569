//! Pictures of the cross-sections at each step.

use saute_kitchen::{Piece, Place};
use saute_picture::still::png_file::{PngError, png_bytes};
use saute_picture::{TemperatureMap, View, section_picture};
use saute_recipe::Cook;
use saute_recipe::Fired;

/// Resolution of the picture files [px/mm] (chosen: a steak fills a screen).
const FILE_PER_MM: f64 = 12.0;

/// Resolution of the pictures in the report [px/mm] (chosen: enough for a phone, small enough to mail).
const REPORT_PER_MM: f64 = 8.0;

/// The cross-section of a food just after a step was carried out (at most one tick later).
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
    /// True if the recipe has other foods too.
    pub of_several: bool,
    /// Pictures for files: look, temperature.
    pub full: [Vec<u8>; 2],
    /// Pictures for the report: look, temperature.
    pub small: [Vec<u8>; 2],
}

impl Snapshot {
    /// Takes the pictures of the given foods for each step that was just carried out; foods that have not been put yet are
    /// left out.
    pub fn take(cook: &Cook, fired: &[Fired], pictured: &[usize]) -> Result<Vec<Self>, PngError> {
        let first = cook.steps.len() + 1 - fired.len();
        let mut snapshots = Vec::new();
        let pieces = pictured.iter().map(|i| &cook.kitchen.pieces()[*i]);
        for piece in pieces.filter(|p| p.place != Place::Waiting) {
            let (full, small) = (paint(piece, FILE_PER_MM)?, paint(piece, REPORT_PER_MM)?);
            snapshots.extend(fired.iter().enumerate().map(|(i, step)| Self {
                step: first + i,
                time_s: step.time_s,
                action: step.action.name(),
                food: piece.id.clone(),
                of_several: cook.kitchen.pieces().len() > 1,
                full: full.clone(),
                small: small.clone(),
            }));
        }
        Ok(snapshots)
    }

    /// Returns names and bytes of its files. The part before the id of the food contains no dot, so that names are unique.
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

/// Returns the indices of the foods that get pictures: all outside groups and the first piece of each group, or every piece.
pub fn pictured(cook: &Cook, every_piece: bool) -> Vec<usize> {
    let groups = &cook.runner.recipe().groups;
    let follows = |i: usize| groups.iter().any(|g| g.members.contains(&i) && g.members.start != i);
    (0..cook.kitchen.pieces().len()).filter(|i| every_piece || !follows(*i)).collect()
}
