//! Relations between the keys of data files, which ranges of single keys cannot state.

mod doneness;
mod food;
mod goals;
mod hob;
mod kinetics;
mod oil;
mod pan;

use saute_food::components::Components;

use crate::data::at_home::KitchenAtHome;
use crate::data::data_file::DataFile;
use crate::data::format::Format;
use crate::data::library_error::LibraryError;
use crate::data::room::Room;
use crate::liquids::fond::FondData;

impl Format for Components {
    fn relations(&self, _: &DataFile) -> Result<(), LibraryError> {
        Ok(())
    }
}

impl Format for FondData {
    fn relations(&self, _: &DataFile) -> Result<(), LibraryError> {
        Ok(())
    }
}

/// The names of the oils are checked against the library, once all files are read.
impl Format for Room {
    fn relations(&self, _: &DataFile) -> Result<(), LibraryError> {
        Ok(())
    }
}

impl Format for KitchenAtHome {
    fn relations(&self, _: &DataFile) -> Result<(), LibraryError> {
        Ok(())
    }
}
