//! Relations in oil files.

use crate::liquids::oil::OilDescription;
use saute_schema::{DataFile, Format, LibraryError};

impl Format for OilDescription {
    fn relations(&self, file: &DataFile) -> Result<(), LibraryError> {
        let (fluid, heat) = (&self.fluid, &self.heat);
        file.within("heat.flash_c", heat.flash_c, heat.smoke_c, 500.0)?;
        file.within("heat.fire_c", heat.fire_c, heat.flash_c, 600.0)?;
        let (xs, ys) = (&fluid.viscosity_c, &fluid.viscosity_mpa_s);
        if xs.len() < 2 || xs.len() != ys.len() || !xs.is_sorted_by(|a, b| a < b) {
            let message = "viscosity_c needs two or more ascending temperatures, and as many values of viscosity_mpa_s";
            return Err(file.error("fluid.viscosity_c", message));
        }
        Ok(())
    }
}
