//! A thermometer's log: a table with a column of times and columns of temperatures.

use std::borrow::Cow;

use super::decode::text_of;
use super::log_error::{LogError, Question};
use super::logger::Logger;
use super::table::Table;
use super::unit::Unit;

/// A log in memory: its headers and its rows.
#[derive(Clone, Debug)]
pub struct LogFile {
    pub(super) file: String,
    pub(super) table: Table,
}

impl LogFile {
    /// Reads the bytes of a file. Columns are separated by commas, semicolons, tabs, bars or blanks; the table may have lines above it,
    /// and need not have headers.
    ///
    /// # Errors
    ///
    /// If it is no text, no table, or has no rows.
    pub fn parse(file: &str, bytes: &[u8]) -> Result<Self, LogError> {
        let error = |line, message: String, remedy: &str| LogError {
            file: file.to_owned(),
            line,
            message,
            remedy: remedy.to_owned(),
            question: None,
        };
        let text = text_of(bytes).map_err(|no| error(1, no.message.to_owned(), no.remedy))?;
        let table = Table::of(&text).map_err(|no| error(no.line, no.message, no.remedy))?;
        Ok(Self { file: file.to_owned(), table: table.with_a_column_each() })
    }

    /// Returns the number of a column that is named by its header (letters of either case) or by its number from 1.
    ///
    /// # Errors
    ///
    /// If there is none; the message lists the columns.
    pub fn column(&self, name: &str, logger: Option<&Logger>) -> Result<usize, LogError> {
        let headers = &self.table_for(logger).headers;
        let by_header = headers.iter().position(|header| header.eq_ignore_ascii_case(name.trim()));
        let by_number = || name.trim().parse::<usize>().ok().filter(|n| (1..=headers.len()).contains(n)).map(|n| n - 1);
        by_header.or_else(by_number).ok_or_else(|| {
            self.error(
                self.table.line,
                format!("has no column \"{name}\""),
                format!("use one of: {}", self.list(headers)),
            )
        })
    }

    /// Returns the headers, in the order of the columns.
    pub fn headers(&self) -> &[String] {
        &self.table.headers
    }

    /// Returns the number of rows.
    pub fn rows(&self) -> usize {
        self.table.rows.len()
    }

    /// Returns the header of a column.
    pub fn header(&self, column: usize) -> &str {
        self.table.headers.get(column).map_or("", String::as_str)
    }

    /// The table with the headers of a maker where it has none.
    pub(super) fn table_for(&self, logger: Option<&Logger>) -> Cow<'_, Table> {
        let headers = logger.map_or(&[][..], |logger| &logger.headers);
        if self.table.is_named || headers.is_empty() {
            return Cow::Borrowed(&self.table);
        }
        let mut named = self.table.clone();
        named.headers.iter_mut().zip(headers).for_each(|(header, name)| header.clone_from(name));
        named.is_named = true;
        Cow::Owned(named)
    }

    /// Columns with their numbers, as people choose them.
    pub(super) fn list(&self, headers: &[String]) -> String {
        let each = headers.iter().enumerate().map(|(at, header)| format!("{} \"{header}\"", at + 1));
        each.collect::<Vec<_>>().join(", ")
    }

    pub(super) fn error(&self, line: u64, message: String, remedy: String) -> LogError {
        LogError { file: self.file.clone(), line, message, remedy, question: None }
    }

    pub(super) fn question(&self, question: Question, message: String, remedy: String) -> LogError {
        LogError { question: Some(question), ..self.error(self.table.line, message, remedy) }
    }

    /// The unit that the lines above the table name: `Unit:C`, `Temperature unit, F`.
    pub(super) fn unit_above(&self) -> Option<Unit> {
        self.table.preamble.iter().find_map(|line| {
            let low = line.to_lowercase();
            let (_, rest) = low.split_once("unit")?;
            rest.trim_start_matches(|c: char| !c.is_alphanumeric() && c != '°' || c == 's')
                .split(|c: char| c.is_whitespace() || ",;".contains(c))
                .find(|word| !word.is_empty())
                .and_then(Unit::of_word)
        })
    }
}
