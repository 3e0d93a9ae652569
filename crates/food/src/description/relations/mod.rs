//! Relations between the keys of food, kinetics and component files, which ranges of single keys cannot state.

mod food;
mod kinetics;

use saute_schema::{DataFile, Format, LibraryError};

use crate::components::Components;

impl Format for Components {
    fn relations(&self, _: &DataFile) -> Result<(), LibraryError> {
        Ok(())
    }
}
