//! Relations in pan and coating files.

use crate::pan::heat_tint::HeatTint;
use crate::pan::pan_description::{CoatingDescription, PanDescription};
use saute_schema::{DataFile, Format, LibraryError};

/// Widest ridge over the pitch [-] (chosen: a groove remains between two ridges).
const WIDEST_RIDGE: f64 = 0.95;
/// Largest radius of a rim [mm], as the range of its key.
const LARGEST_RIM_MM: f64 = 400.0;

impl Format for PanDescription {
    fn relations(&self, file: &DataFile) -> Result<(), LibraryError> {
        file.within("wall.rim_radius_mm", self.wall.rim_radius_mm, self.floor.radius_mm, LARGEST_RIM_MM)?;
        heat_tint(self.heat_tint.as_ref(), file)?;
        self.ridges.as_ref().map_or(Ok(()), |ridges| {
            file.within("ridges.width_mm", ridges.width_mm, 0.5, WIDEST_RIDGE * ridges.pitch_mm)
        })
    }
}

impl Format for CoatingDescription {
    fn relations(&self, file: &DataFile) -> Result<(), LibraryError> {
        heat_tint(self.heat_tint.as_ref(), file)
    }
}

fn heat_tint(tint: Option<&HeatTint>, file: &DataFile) -> Result<(), LibraryError> {
    let Some((key, remedy)) = tint.and_then(HeatTint::fault) else { return Ok(()) };
    Err(file.error(&format!("heat_tint.{key}"), format!("{key} makes no heat tint: {remedy}")))
}
