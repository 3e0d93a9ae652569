//! Relations between the keys of data files, which ranges of single keys cannot state.

mod doneness;
mod goals;
mod hob;
mod oil;
mod pan;

pub(crate) use self::doneness::scale_fault;
use crate::data::at_home::KitchenAtHome;
use crate::data::room::Room;
use crate::liquids::fond::FondData;
use saute_schema::{DataFile, Format, LibraryError};

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
