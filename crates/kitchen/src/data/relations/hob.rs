//! Relations in hob files: one heater, with what belongs to it.

use crate::pan::hob::HobDescription;
use saute_schema::{DataFile, Format, LibraryError};

/// The tables that make heat.
const HEATERS: [&str; 4] = ["coil", "flame", "element", "plate"];

impl Format for HobDescription {
    fn relations(&self, file: &DataFile) -> Result<(), LibraryError> {
        self.one_heater(file)?;
        self.companions(file)?;
        self.settings(file)
    }
}

impl HobDescription {
    fn one_heater(&self, file: &DataFile) -> Result<(), LibraryError> {
        let there = [self.coil.is_some(), self.flame.is_some(), self.element.is_some(), self.plate.is_some()];
        let named: Vec<&str> = HEATERS.into_iter().zip(there).filter_map(|(name, is)| is.then_some(name)).collect();
        match named.as_slice() {
            [_] => Ok(()),
            [] => {
                Err(file
                    .error("name", "nothing makes heat: write one of the tables [coil], [flame], [element], [plate]"))
            }
            [.., last] => {
                let all = named.iter().map(|name| format!("[{name}]")).collect::<Vec<_>>().join(" and ");
                Err(file
                    .error(last, format!("{all} both make heat: keep one of them; a stove of two kinds is two files")))
            }
        }
    }

    /// Tables that belong to a heater are there with it, and only with it.
    fn companions(&self, file: &DataFile) -> Result<(), LibraryError> {
        let (coil, flame) = (self.coil.is_some(), self.flame.is_some());
        let tables = [
            ("control", self.control.is_some(), coil, "coil"),
            ("hold", self.hold.is_some(), coil, "coil"),
            ("grate", self.grate.is_some(), flame, "flame"),
        ];
        for (table, there, wanted, heater) in tables {
            match (there, wanted) {
                (true, false) => {
                    return Err(file.error(
                        table,
                        format!("[{table}] belongs to [{heater}], which this stove has not: leave it out"),
                    ));
                }
                (false, true) => {
                    return Err(file.error(
                        heater,
                        format!("[{heater}] needs [{table}]: write its keys, as in the shipped hob with a {heater}"),
                    ));
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn settings(&self, file: &DataFile) -> Result<(), LibraryError> {
        let named = HEATERS.into_iter().find(|name| match *name {
            "coil" => self.coil.is_some(),
            "flame" => self.flame.is_some(),
            "element" => self.element.is_some(),
            _ => self.plate.is_some(),
        });
        let key = format!("{}.settings_w", named.unwrap_or_default());
        let (settings, largest) = (self.settings_w(), self.largest_w());
        if settings.first() != Some(&0.0) || !settings.is_sorted_by(|a, b| a < b) || largest <= 0.0 {
            return Err(file.error(
                &key,
                "settings_w begins with 0 and rises: write, for instance, settings_w = [0.0, 400.0, 1100.0]",
            ));
        }
        if settings.iter().any(|w| *w > largest) {
            return Err(file.error(&key, format!("settings_w goes beyond largest_w = {largest} W: lower it")));
        }
        let Some(flame) = &self.flame else { return Ok(()) };
        file.within("flame.lowest_w", flame.lowest_w, 10.0, flame.largest_w)?;
        match settings.iter().find(|w| self.nearest_w(**w) != **w) {
            None => Ok(()),
            Some(w) => {
                Err(file
                    .error(&key, format!("no flame burns with {w} W: the smallest is lowest_w = {} W", flame.lowest_w)))
            }
        }
    }
}
