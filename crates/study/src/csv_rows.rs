//! Rows of a CSV file that other people hand in: logs of a study, results of a class.

use serde::de::DeserializeOwned;

use crate::log_row::LogError;

/// What a file of rows is, and what it must hold.
pub(crate) struct Rows<'c> {
    /// What a row is, in words.
    pub what: &'static str,
    /// What to do about a row that is none.
    pub remedy: &'static str,
    /// Its columns, in their order.
    pub columns: &'c [String],
    /// Columns at the end that files of before have not.
    pub new: usize,
    /// Columns of ids: letters, digits, dots, hyphens and low lines.
    pub ids: &'static [&'static str],
    /// Most rows [-].
    pub most: usize,
}

/// Longest id [letters] (chosen: the longest shipped one has 24).
const LONGEST_ID: usize = 64;

impl Rows<'_> {
    /// Reads the text of a file. Spreadsheets may have saved it again with semicolons or tabs and decimal commas; without headers it is
    /// read by the order of the columns.
    pub fn read<T: DeserializeOwned>(&self, file: &str, text: &str) -> Result<Vec<T>, LogError> {
        let error = |line: u64, message: String| LogError { file: file.to_owned(), line, message };
        let text = text.trim_start_matches('\u{feff}');
        let separator = separator_of(text);
        let mut reader = csv::ReaderBuilder::new().delimiter(separator).has_headers(false).from_reader(text.as_bytes());
        let (mut headers, mut rows) = (None, Vec::new());
        for record in reader.records() {
            let none = |e: &csv::Error| {
                let line = e.position().map_or(1, csv::Position::line);
                error(line, format!("is no {}: {e}; {}", self.what, self.remedy))
            };
            let record = record.map_err(|e| none(&e))?;
            let line = record.position().map_or(1, csv::Position::line);
            let Some(named) = &headers else {
                let own = csv::StringRecord::from(self.columns[..record.len().min(self.columns.len())].to_vec());
                if self.has_headers(&record) {
                    headers = Some(record);
                    continue;
                }
                self.checked_length(&record).map_err(|message| error(line, message))?;
                rows.push(self.row(&record, &own, separator).map_err(|message| error(line, message))?);
                headers = Some(own);
                continue;
            };
            if rows.len() == self.most {
                return Err(error(line, format!("has more than {} rows; {}", self.most, self.remedy)));
            }
            rows.push(self.row(&record, named, separator).map_err(|message| error(line, message))?);
        }
        Ok(rows)
    }

    /// True if the first row names columns: one of its fields is the name of one.
    fn has_headers(&self, first: &csv::StringRecord) -> bool {
        first.iter().any(|field| self.columns.iter().any(|column| column == field))
    }

    fn checked_length(&self, first: &csv::StringRecord) -> Result<(), String> {
        let all = self.columns.len();
        if (all - self.new..=all).contains(&first.len()) {
            return Ok(());
        }
        Err(format!("is no {}: the first line names no column of it; {}", self.what, self.remedy))
    }

    fn row<T: DeserializeOwned>(
        &self,
        record: &csv::StringRecord,
        headers: &csv::StringRecord,
        separator: u8,
    ) -> Result<T, String> {
        let mut own = csv::StringRecord::new();
        for (name, field) in headers.iter().zip(record) {
            let is_decimal_comma = separator != b',' && field.replacen(',', ".", 1).parse::<f64>().is_ok();
            let field = if is_decimal_comma { field.replacen(',', ".", 1) } else { field.to_owned() };
            self.check(name, &field)?;
            own.push_field(&field);
        }
        if record.len() > headers.len() {
            return Err(format!("has more fields than the headers; {}", self.remedy));
        }
        own.deserialize(Some(headers)).map_err(|e| format!("is no {}: {e}; {}", self.what, self.remedy))
    }

    /// Refuses what no program of this kind has written: a number that is none, an id that is none, a formula.
    fn check(&self, name: &str, field: &str) -> Result<(), String> {
        if field.parse::<f64>().is_ok_and(|number| !number.is_finite()) {
            return Err(format!("\"{name}\" is {field}, which is no finite number; correct the row or leave it out"));
        }
        let is_id = field.len() <= LONGEST_ID && field.chars().all(|c| c.is_ascii_alphanumeric() || "._-".contains(c));
        if self.ids.contains(&name) && (!is_id || field.starts_with(['-', '.'])) {
            return Err(format!(
                "\"{name}\" is no id of letters, digits, dots, hyphens and low lines; correct the row or leave it out"
            ));
        }
        let is_number = field.parse::<f64>().is_ok();
        if (!is_number && field.starts_with(['=', '+', '-', '@'])) || field.contains(['\t', '\r', '\n']) {
            return Err(format!("\"{name}\" would be a formula in a spreadsheet; correct the row or leave it out"));
        }
        Ok(())
    }
}

/// What is between the columns of the first line: commas, or what a spreadsheet has put there.
fn separator_of(text: &str) -> u8 {
    let first = text.lines().next().unwrap_or_default();
    let count = |separator: char| first.matches(separator).count();
    [',', ';', '\t'].into_iter().rev().max_by_key(|separator| count(*separator)).map_or(b',', |found| found as u8)
}
