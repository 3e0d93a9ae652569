//! Colours that a case expects, measured on flat pictures of its cook.

use crate::validate::colorimeter::Colorimeter;
use saute_kitchen::Library;
use saute_kitchen::food::Lab;
use saute_lab::Verdict;
use saute_lab::cook_case::{CookCase, SeenAt};
use saute_picture::still::headless::Gpu;
use saute_picture::still::shot::ShotError;
use saute_recipe::Cook;

use crate::error::CliError;

/// Compares all colours of a case with their expected values.
pub fn verdicts(case: &CookCase, library: &Library) -> Result<Vec<Verdict>, CliError> {
    if case.seen().is_empty() && case.courses().is_empty() {
        return Ok(Vec::new());
    }
    let mut eye = Colorimeter::new(Gpu::open().map_err(ShotError::from)?);
    let mut look = |cook: &Cook, at: SeenAt| {
        let shown = cook.kitchen.pieces().first().map(|piece| eye.read(&cook.kitchen, piece, at));
        shown.unwrap_or(Lab([f64::NAN; 3]))
    };
    let mut cook = case.begin(library)?;
    let mut read: Vec<Vec<f64>> = vec![Vec::new(); case.courses().len()];
    while cook.stopped().is_none() {
        for (course, read) in case.courses().iter().zip(&mut read) {
            if course.is_due(cook.kitchen.time_s(), read.len()) {
                read.push(course.of.read(look(&cook, course.place)));
            }
        }
        cook.advance()?;
    }
    let mut verdicts: Vec<Verdict> =
        case.seen().iter().map(|seen| case.verdict_on_colour(seen, look(&cook, seen.place))).collect();
    verdicts.extend(case.courses().iter().zip(&read).flat_map(|(course, read)| case.verdicts_on_course(course, read)));
    Ok(verdicts)
}
