//! A thermometer's log: a CSV file with a column of times and columns of temperatures.

use serde::Serialize;

use super::clock::seconds;

/// A reason for which a log cannot be read.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{file}:{line}: {message}")]
pub struct LogError {
    /// Name of the file.
    pub file: String,
    /// Line, from 1.
    pub line: u64,
    /// What is wrong, and what to write instead.
    pub message: String,
}

/// Unit of the temperatures of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Unit {
    /// °C.
    Celsius,
    /// °F.
    Fahrenheit,
}

impl Unit {
    /// Returns the unit that a header names: `core (°F)`, `probe_f`, `Temp [F]`; °C where it names none.
    pub fn of_header(header: &str) -> Self {
        let header = header.trim().to_lowercase();
        let words: Vec<&str> = header.split(|c: char| !c.is_alphanumeric()).collect();
        let names_it = header.contains("°f")
            || header.contains("fahrenheit")
            || words.last() == Some(&"f")
            || words.contains(&"degf");
        let ends_bracketed = ["(f)", "[f]"].iter().any(|end| header.ends_with(end));
        if names_it || ends_bracketed { Self::Fahrenheit } else { Self::Celsius }
    }

    /// Returns a temperature [K].
    pub fn kelvin(self, value: f64) -> f64 {
        match self {
            Self::Celsius => value + saute_kitchen::food::ZERO_C,
            Self::Fahrenheit => (value - 32.0) / 1.8 + saute_kitchen::food::ZERO_C,
        }
    }
}

/// Words in the headers of columns that nobody names: of the core, and of the pan.
pub const CORE_WORDS: [&str; 6] = ["core", "probe", "internal", "meat", "food", "steak"];
/// See [`CORE_WORDS`].
pub const PAN_WORDS: [&str; 4] = ["pan", "surface", "floor", "infrared"];

/// A log in memory: its headers and its rows.
#[derive(Clone, Debug)]
pub struct LogFile {
    file: String,
    headers: Vec<String>,
    rows: Vec<(u64, Vec<String>)>,
}

/// Most rows of a log [-] (chosen: a day at one a second).
const MOST_ROWS: usize = 100_000;
/// Lowest and highest temperature that a log may hold [K] (chosen: ice in a freezer, a glowing pan).
const RANGE: [f64; 2] = [220.0, 1200.0];

impl LogFile {
    /// Reads the text of a file; its first row holds the headers. Columns are separated by commas, semicolons or tabs.
    ///
    /// # Errors
    ///
    /// If it is no table, or has no rows.
    pub fn parse(file: &str, text: &str) -> Result<Self, LogError> {
        let error = |line, message: String| LogError { file: file.to_owned(), line, message };
        let text = text.trim_start_matches('\u{feff}');
        let first = text.lines().next().unwrap_or_default();
        let separator = [b';', b'\t', b','].into_iter().find(|s| first.as_bytes().contains(s)).unwrap_or(b',');
        let mut reader = csv::ReaderBuilder::new()
            .delimiter(separator)
            .flexible(true)
            .trim(csv::Trim::All)
            .from_reader(text.as_bytes());
        let headers = reader.headers().map_err(|e| error(1, format!("is no CSV table: {e}")))?;
        let headers: Vec<String> = headers.iter().map(str::to_owned).collect();
        let mut rows = Vec::new();
        for record in reader.records() {
            let record =
                record.map_err(|e| error(e.position().map_or(1, csv::Position::line), format!("is no row: {e}")))?;
            let line = record.position().map_or(1, csv::Position::line);
            if rows.len() == MOST_ROWS {
                return Err(error(line, format!("has more than {MOST_ROWS} rows; keep the cook's only")));
            }
            rows.push((line, record.iter().map(str::to_owned).collect()));
        }
        if rows.is_empty() {
            return Err(error(1, "has no rows below its headers".to_owned()));
        }
        Ok(Self { file: file.to_owned(), headers, rows })
    }

    /// Returns the number of a column that is named by its header (letters of either case) or by its number from 1.
    ///
    /// # Errors
    ///
    /// If there is none; the message lists the columns.
    pub fn column(&self, name: &str) -> Result<usize, LogError> {
        let by_header = self.headers.iter().position(|header| header.eq_ignore_ascii_case(name.trim()));
        let by_number =
            || name.trim().parse::<usize>().ok().filter(|n| (1..=self.headers.len()).contains(n)).map(|n| n - 1);
        by_header.or_else(by_number).ok_or_else(|| {
            let known: Vec<String> =
                self.headers.iter().enumerate().map(|(at, header)| format!("{} \"{header}\"", at + 1)).collect();
            self.error(1, format!("has no column \"{name}\"; there are: {}", known.join(", ")))
        })
    }

    /// Returns the column of times where none is named: the first whose header begins with "time", "elapsed", "date" or "clock", else
    /// the first.
    pub fn time_column(&self) -> usize {
        let is_time = |header: &String| {
            let header = header.to_lowercase();
            ["time", "elapsed", "date", "clock", "t_s", "seconds"].iter().any(|start| header.starts_with(start))
        };
        self.headers.iter().position(is_time).unwrap_or(0)
    }

    /// Returns the first column beside that of the times whose header contains one of some words.
    pub fn column_with(&self, words: &[&str], time: usize) -> Option<usize> {
        let contains = |header: &String| words.iter().any(|word| header.to_lowercase().contains(word));
        self.headers.iter().enumerate().find(|(at, header)| *at != time && contains(header)).map(|(at, _)| at)
    }

    /// Returns the headers, in the order of the columns.
    pub fn headers(&self) -> &[String] {
        &self.headers
    }

    /// Returns the number of rows.
    pub fn rows(&self) -> usize {
        self.rows.len()
    }

    /// Returns the header of a column.
    pub fn header(&self, column: usize) -> &str {
        self.headers.get(column).map_or("", String::as_str)
    }

    /// Returns a column of temperatures with their times: [s] since the first row, or, where times are plain seconds or min:s, as they
    /// stand; [K]. Rows without a temperature are left out.
    ///
    /// # Errors
    ///
    /// If a time or a temperature is no number, times do not rise, or a temperature cannot be one.
    pub fn curve(&self, time: usize, column: usize, unit: Unit) -> Result<Vec<(f64, f64)>, LogError> {
        let mut curve: Vec<(f64, f64)> = Vec::new();
        let mut origin = None;
        for (line, row) in &self.rows {
            let field = |at: usize| row.get(at).map(String::as_str).unwrap_or_default();
            let (at, is_clock) = seconds(field(time)).ok_or_else(|| self.no_time(*line, field(time)))?;
            let begin = *origin.get_or_insert(if is_clock { at } else { 0.0 });
            let mut at = at - begin;
            if is_clock && at < 0.0 {
                at += 86_400.0;
            }
            let text = field(column);
            if is_missing(text) {
                continue;
            }
            let value = self.temperature(*line, text, unit)?;
            if curve.last().is_some_and(|(last, _)| *last >= at) {
                return Err(self.error(*line, format!("the time \"{}\" is not after the one before", field(time))));
            }
            curve.push((at, value));
        }
        Ok(curve)
    }

    fn temperature(&self, line: u64, text: &str, unit: Unit) -> Result<f64, LogError> {
        let number: Option<f64> = text.trim_end_matches(['°', 'C', 'F', ' ']).replace(',', ".").parse().ok();
        let kelvin = number.filter(|n| n.is_finite()).map(|n| unit.kelvin(n));
        match kelvin {
            Some(kelvin) if (RANGE[0]..=RANGE[1]).contains(&kelvin) => Ok(kelvin),
            Some(_) => {
                Err(self
                    .error(line, format!("{text} cannot be a temperature in a kitchen; check the unit of its column")))
            }
            None => {
                Err(self.error(line, format!("\"{text}\" is no temperature; write a number, or leave the field empty")))
            }
        }
    }

    fn no_time(&self, line: u64, text: &str) -> LogError {
        self.error(line, format!("\"{text}\" is no time; write seconds (90), min:s (1:30) or a clock (18:03:20)"))
    }

    fn error(&self, line: u64, message: String) -> LogError {
        LogError { file: self.file.clone(), line, message }
    }
}

/// Texts of loggers for a probe that is not there.
fn is_missing(text: &str) -> bool {
    matches!(text.to_lowercase().as_str(), "" | "-" | "--" | "---" | "nan" | "n/a" | "null" | "none")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn log(text: &str) -> LogFile {
        LogFile::parse("log.csv", text).expect("a table")
    }

    #[test]
    fn seconds_minutes_and_clocks_are_times_since_the_beginning() {
        for text in [
            "time_s,core_c\n0,5\n90,20.5\n",
            "Time;Core\n0:00;5\n1:30;20,5\n",
            "Date Time\tcore\n2026-11-24 23:59:00\t5\n2026-11-25 00:00:30\t20.5\n",
        ] {
            let log = log(text);
            let curve = log.curve(log.time_column(), 1, Unit::Celsius).expect("a curve");
            assert_eq!(curve, [(0.0, 278.15), (90.0, 293.65)], "{text}");
        }
    }

    #[test]
    fn a_header_names_its_unit() {
        for (header, unit) in [
            ("Core (°F)", Unit::Fahrenheit),
            ("probe_f", Unit::Fahrenheit),
            ("Temp [F]", Unit::Fahrenheit),
            ("core_c", Unit::Celsius),
            ("Surface", Unit::Celsius),
            ("Fan", Unit::Celsius),
        ] {
            assert_eq!(Unit::of_header(header), unit, "{header}");
        }
        assert!((Unit::Fahrenheit.kelvin(140.0) - 333.15).abs() < 1e-9);
    }

    #[test]
    fn what_cannot_be_read_is_named_with_its_line_and_remedy() {
        let read = |text: &str| log(text).curve(0, 1, Unit::Celsius).expect_err("refused").to_string();
        assert_eq!(
            read("t,core\n0,5\nten,6\n"),
            "log.csv:3: \"ten\" is no time; write seconds (90), min:s (1:30) or a clock (18:03:20)"
        );
        assert!(read("t,core\n0,5\n0,6\n").starts_with("log.csv:3: the time \"0\" is not after"));
        assert!(read("t,core\n0,hot\n").contains("\"hot\" is no temperature"));
        assert!(read("t,core\n0,5000\n").contains("check the unit"));
        let unknown = log("t,core\n0,5\n").column("pan").expect_err("refused").to_string();
        assert_eq!(unknown, "log.csv:1: has no column \"pan\"; there are: 1 \"t\", 2 \"core\"");
        assert!(LogFile::parse("log.csv", "").is_err() && LogFile::parse("log.csv", "t,core\n").is_err());
    }

    #[test]
    fn a_probe_that_is_not_there_is_left_out() {
        let curve = log("t,core\n0,--\n1,5\n2,\n").curve(0, 1, Unit::Celsius).expect("a curve");
        assert_eq!(curve, [(1.0, 278.15)]);
    }
}
