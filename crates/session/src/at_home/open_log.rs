//! The log of a thermometer that was opened, with what was chosen for it and how it reads.

use saute_plan::fit::compared::Compared;
use saute_plan::fit::log::log_error::LogError;
use saute_plan::fit::log::log_file::LogFile;
use saute_plan::fit::log::reading::{Choices, Reading};
use saute_plan::fit::observed::Observed;
use saute_recipe::Recipe;

/// What is chosen for a log.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Columns {
    /// Its columns, their unit and what the times are; as the log states where nothing is chosen.
    pub choices: Choices,
    /// Time of the cook at which the log begins [s].
    pub shift_s: f64,
}

/// A log with what was chosen for it.
#[derive(Debug)]
pub struct OpenLog {
    /// Name of its file.
    pub name: String,
    /// Its table.
    pub log: LogFile,
    columns: Columns,
    reading: Result<Reading, LogError>,
}

impl OpenLog {
    /// Opens a log.
    ///
    /// # Errors
    ///
    /// If it is no table.
    pub fn open(name: &str, bytes: &[u8]) -> Result<Self, LogError> {
        let log = LogFile::parse(name, bytes)?;
        let columns = Columns::default();
        Ok(Self { name: name.to_owned(), reading: log.read(&columns.choices), log, columns })
    }

    /// What is chosen.
    pub fn columns(&self) -> &Columns {
        &self.columns
    }

    /// How the log reads, or what would have to be known.
    pub fn reading(&self) -> Result<&Reading, &LogError> {
        self.reading.as_ref()
    }

    /// Chooses.
    pub fn choose(&mut self, columns: Columns) {
        self.reading = self.log.read(&columns.choices);
        self.columns = columns;
    }

    /// Adds what is compared with a recipe's cook to what was observed.
    ///
    /// # Errors
    ///
    /// If the log cannot be read, or a unit that nothing states makes no sense with the recipe.
    pub(super) fn add(&mut self, recipe: &Recipe, observed: &mut Observed) -> Result<(), LogError> {
        let compared = Compared::of(recipe, self.columns.shift_s);
        let choices = Choices { begin: compared.begin(recipe), ..self.columns.choices };
        self.reading = self.log.read(&choices);
        compared.add(self.reading.as_ref().map_err(Clone::clone)?, observed);
        Ok(())
    }
}
