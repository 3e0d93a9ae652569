//! The table in the text of a log: below what is above it, with its headers.

use super::stamp::Stamp;
use super::unit::Unit;
use super::values::Value;

/// Most rows of a log [-] (chosen: a day at one a second).
pub(super) const MOST_ROWS: usize = 100_000;
/// Most columns of a log [-] (chosen: the widest of the known ones has 23).
const MOST_COLUMNS: usize = 200;
/// Rows that decide what separates columns, and how many there are [-] (chosen).
const LOOKED_AT: usize = 200;

/// One row: its line from 1 and its fields.
pub(super) type Row = (u64, Vec<String>);

/// A table with its headers.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Table {
    /// Headers, made up where the table has none.
    pub headers: Vec<String>,
    /// Line of the headers, from 1.
    pub line: u64,
    /// True if the table states its headers.
    pub is_named: bool,
    /// True if it had a row for each value of each sensor: a field without one is then no loss.
    pub is_long: bool,
    /// What is above the headers.
    pub preamble: Vec<String>,
    /// Rows.
    pub rows: Vec<Row>,
}

/// Why a text is no table.
#[derive(Debug, PartialEq)]
pub(super) struct NoTable {
    /// Line, from 1.
    pub line: u64,
    /// What is wrong.
    pub message: String,
    /// What to do about it.
    pub remedy: &'static str,
}

impl Table {
    /// Reads a text.
    pub fn of(text: &str) -> Result<Self, NoTable> {
        let (separator, text) = separator_of(text);
        let mut records = records_of(&text, separator)?;
        let data = data_from(&records).ok_or_else(|| no_rows(1))?;
        let mut rows = records.split_off(data);
        rows.retain(|(_, fields)| filled(fields) > 0);
        let (above, headers) = headers_of(&records);
        decimal_commas(&rows, headers.len(), separator)?;
        let preamble = records[..above].iter().map(|(_, fields)| fields.join(" ")).collect();
        let line = records.get(above).map_or(1, |(line, _)| *line);
        Ok(Self {
            is_named: !headers.is_empty(),
            is_long: false,
            headers: widened(headers, &rows),
            line,
            preamble,
            rows,
        })
    }

    /// Returns the fields of a column.
    pub fn column(&self, at: usize) -> impl Iterator<Item = &str> {
        self.rows.iter().map(move |(_, fields)| fields.get(at).map_or("", String::as_str))
    }
}

fn no_rows(line: u64) -> NoTable {
    let message = "has no table of times and temperatures with two rows or more".to_owned();
    NoTable { line, message, remedy: "hand in the log as CSV, with a column of times and columns of temperatures" }
}

/// Separates columns: what gives the most rows the same number of columns, more than one. A first line `sep=;` states it.
fn separator_of(text: &str) -> (u8, String) {
    if let Some(said) = text.lines().next().and_then(|line| line.trim().strip_prefix("sep=")) {
        let rest = text.split_once('\n').map_or("", |(_, rest)| rest);
        return (said.bytes().next().unwrap_or(b','), format!("\n{rest}"));
    }
    let lines: Vec<&str> = text.lines().filter(|line| !line.trim().is_empty()).take(LOOKED_AT).collect();
    let score = |separator: char| {
        let counts: Vec<usize> = lines.iter().map(|line| count_of(line, separator)).collect();
        let best = counts.iter().filter(|count| **count > 0).max_by_key(|a| counts.iter().filter(|b| b == a).count());
        best.map_or(0, |best| counts.iter().filter(|count| *count == best).count())
    };
    // Of equals the first: commas also occur in numbers, blanks between words.
    let found = [';', '\t', '|', ',', ' '].into_iter().rev().max_by_key(|separator| score(*separator)).unwrap_or(',');
    if found == ' ' { (b'\t', by_blanks(text)) } else { (found as u8, text.to_owned()) }
}

/// How often a line is separated.
fn count_of(line: &str, separator: char) -> usize {
    if separator == ' ' { line.split_whitespace().count().saturating_sub(1) } else { line.matches(separator).count() }
}

/// Columns that blanks separate, with tabs instead.
fn by_blanks(text: &str) -> String {
    text.lines().map(|line| line.split_whitespace().collect::<Vec<_>>().join("\t") + "\n").collect()
}

fn records_of(text: &str, separator: u8) -> Result<Vec<Row>, NoTable> {
    let mut builder = csv::ReaderBuilder::new();
    let builder = builder.delimiter(separator).flexible(true).has_headers(false).trim(csv::Trim::All);
    let lines: Vec<&str> = text.lines().collect();
    // The reader counts empty lines before a row to it.
    let is_empty = |line: u64| lines.get(line as usize - 1).is_some_and(|line| line.trim().is_empty());
    let mut records = Vec::new();
    for record in builder.from_reader(text.as_bytes()).records() {
        let broken = |e: csv::Error| {
            let line = e.position().map_or(1, csv::Position::line);
            NoTable { line, message: format!("is no row: {e}"), remedy: "export the log again as CSV" }
        };
        let record = record.map_err(broken)?;
        let begun = record.position().map_or(1, csv::Position::line);
        let line = (begun..).find(|line| !is_empty(*line)).unwrap_or(begun);
        let many = |what: &str, most: usize| {
            Err(NoTable { line, message: format!("has more than {most} {what}"), remedy: "keep the cook's only" })
        };
        if record.len() > MOST_COLUMNS {
            return many("columns", MOST_COLUMNS);
        }
        if records.len() > MOST_ROWS {
            return many("rows", MOST_ROWS);
        }
        records.push((line, record.iter().map(str::to_owned).collect()));
    }
    Ok(records)
}

/// Number of fields up to the last one that is not empty; a comma at the end of a row makes no column.
fn filled(fields: &[String]) -> usize {
    fields.iter().rposition(|field| !field.is_empty()).map_or(0, |at| at + 1)
}

/// True if a row has two fields or more, and at least half of those that hold something are numbers or times.
fn is_data(fields: &[String]) -> bool {
    let given = fields.iter().filter(|field| !field.is_empty()).count();
    let is_enough = |values: usize| fields.len() > 1 && values > 0 && 2 * values >= given;
    let numbers = fields.iter().filter(|field| Value::of(field).number().is_some()).count();
    // Times are looked for only where the numbers are too few.
    let is_time = |field: &&String| Value::of(field).number().is_none() && Stamp::of(field).is_some();
    is_enough(numbers) || is_enough(numbers + fields.iter().filter(is_time).count())
}

/// Place of the first row of the table: the first of a run of rows of data that is no few lines of remarks above it.
fn data_from(records: &[Row]) -> Option<usize> {
    let is: Vec<bool> = records.iter().map(|(_, fields)| is_data(fields)).collect();
    let least = is.iter().filter(|is| **is).count().div_ceil(REMARKS);
    let mut from = None;
    for at in 0..=is.len() {
        let goes_on = is.get(at).copied().unwrap_or(false);
        from = match from {
            Some(begin) if !goes_on && at - begin >= least => return Some(begin),
            Some(begin) if goes_on => Some(begin),
            _ => goes_on.then_some(at),
        };
    }
    None
}

/// A run of rows that is shorter than one in so many of all is a remark [-] (chosen).
const REMARKS: usize = 10;

/// The headers above the first row, a line of units below them included, and the place at which they begin.
fn headers_of(above: &[Row]) -> (usize, Vec<String>) {
    let Some((last, before)) = above.split_last() else { return (0, Vec::new()) };
    let named = |fields: &[String]| fields[..filled(fields)].to_vec();
    if filled(&last.1) < 2 {
        return (above.len(), Vec::new());
    }
    let are_units =
        last.1.iter().all(|field| field.chars().count() <= 6) && last.1.iter().any(|f| Unit::of_word(f).is_some());
    match before.last() {
        Some((_, names)) if are_units && filled(names) >= filled(&last.1) => {
            let unit = |at: usize| {
                last.1.get(at).filter(|unit| !unit.is_empty()).map_or(String::new(), |unit| format!(" ({unit})"))
            };
            (above.len() - 2, names.iter().enumerate().map(|(at, name)| format!("{name}{}", unit(at))).collect())
        }
        _ => (above.len() - 1, named(&last.1)),
    }
}

/// Headers for every column; columns without one get their number.
fn widened(mut headers: Vec<String>, rows: &[Row]) -> Vec<String> {
    let width = rows.iter().map(|(_, fields)| filled(fields)).max().unwrap_or(0).max(filled(&headers));
    headers.resize(width, String::new());
    let named = headers.into_iter().enumerate();
    named.map(|(at, header)| if header.is_empty() { format!("column {}", at + 1) } else { header }).collect()
}

/// Refuses decimal commas between commas: `0,5,3` has two readings.
fn decimal_commas(rows: &[Row], named: usize, separator: u8) -> Result<(), NoTable> {
    let is_digits = |field: &String| (1..=3).contains(&field.len()) && field.bytes().all(|b| b.is_ascii_digit());
    let goes_beyond = |(_, fields): &Row| fields.get(named).is_some_and(is_digits);
    if separator != b',' || named < 2 || !rows.iter().all(goes_beyond) {
        return Ok(());
    }
    Err(NoTable {
        line: rows[0].0,
        message: "has more fields than there are headers; commas stand between columns and, it seems, in numbers"
            .to_owned(),
        remedy: "export with semicolons between columns, or with decimal points",
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(text: &str) -> Table {
        Table::of(text).expect("a table")
    }

    #[test]
    fn what_stands_above_the_table_is_skipped() {
        let text = "Maker Inc.\nApp: 2.1, CSV version: 4\nCreated: 2025-04-05 18:03:00\n\ntime,core\n0,5\n30,6\n";
        let table = table(text);
        assert_eq!((table.headers, table.line, table.rows.len()), (vec!["time".into(), "core".into()], 5, 2));
        assert_eq!(table.preamble.len(), 3);
    }

    #[test]
    fn a_table_without_headers_gets_numbers() {
        let table = table("1743876180,nan,21.1\n1743876210,nan,114.2\n");
        assert_eq!((table.is_named, table.headers[2].as_str(), table.rows.len()), (false, "column 3", 2));
    }

    #[test]
    fn columns_are_separated_by_what_fits() {
        for text in [
            "t;core\n0;5,5\n1;6,5\n",
            "t\tcore\n0\t5,5\n1\t6,5\n",
            "t core\n0 5,5\n1  6,5\n",
            "sep=;\nt;core\n0;5,5\n1;6,5\n",
        ] {
            let table = table(text);
            assert_eq!((table.headers.len(), table.rows[1].1[1].as_str()), (2, "6,5"), "{text}");
        }
    }

    #[test]
    fn rows_may_be_shorter_or_end_in_commas_and_longer_ones_get_a_column() {
        let table = table("t,core,pan\n0,5,,\n30,6,150,\n60,7\n90,8,160,note\n");
        assert_eq!((table.headers.len(), table.rows.len()), (4, 4));
    }

    #[test]
    fn decimal_commas_between_commas_are_refused() {
        let error = Table::of("t,core\n0,5,3\n30,6,1\n").expect_err("two readings");
        assert!(error.line == 2 && error.remedy.contains("semicolons"), "{error:?}");
    }

    #[test]
    fn a_text_without_rows_is_refused() {
        for text in ["", "t,core\n", "one line", "a\nb\nc\n"] {
            assert!(Table::of(text).is_err(), "{text}");
        }
    }
}
