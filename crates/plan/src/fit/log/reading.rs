//! How a log is read: its times, the curves of core and pan, and what was assumed for it.

use saute_kitchen::food::ZERO_C;
use serde::Serialize;

use super::header_words::words_of;
use super::log_error::{LogError, Question};
use super::log_file::LogFile;
use super::logger::Logger;
use super::plausible::{begins_as, is_believed, range};
use super::roles::Roles;
use super::table::Table;
use super::times::{NoTimes, TimeForm, Times, times_of};
use super::unit::{Unit, UnitFrom};
use super::values::Value;
use crate::fit::observed::Quantity;

/// Which column is read for a quantity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Pick {
    /// The one that its header names.
    #[default]
    ByHeader,
    /// None.
    No,
    /// The one at a place.
    Column(usize),
}

/// What is chosen for a log; what is not is read from it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Choices {
    /// Preset of its maker.
    pub logger: Option<&'static Logger>,
    /// Column of the times.
    pub time: Option<usize>,
    /// Column of the core.
    pub core: Pick,
    /// Column of the pan.
    pub pan: Pick,
    /// Unit of the temperatures.
    pub unit: Option<Unit>,
    /// What the times are.
    pub form: Option<TimeForm>,
    /// What the core must be when the food is put in: time of the log [s] and temperature [K]. A contradicting assumed unit raises a question.
    pub begin: Option<(f64, f64)>,
}

/// A curve that was read.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CurveRead {
    /// Place of its column.
    #[serde(skip)]
    pub at: usize,
    /// Header of its column.
    pub column: String,
    /// Unit of its temperatures.
    pub unit: Unit,
    /// Why that unit was taken.
    pub unit_from: UnitFrom,
    /// Number of rows without a temperature, or with one that is none [-].
    pub left_out: usize,
    /// Times [s] and temperatures [K].
    #[serde(skip)]
    pub points: Vec<(f64, f64)>,
}

/// How a log was read.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Reading {
    /// Header of the column of times; of two columns, both.
    pub time_column: String,
    /// What the times are.
    pub time_form: TimeForm,
    /// The first time, as it is in the log.
    pub begins: String,
    /// From the first row to the last [s].
    pub span_s: f64,
    /// True if the newest row comes first.
    pub is_newest_first: bool,
    /// Number of rows [-].
    pub rows: usize,
    /// The core's curve.
    pub core: Option<CurveRead>,
    /// The pan's curve.
    pub pan: Option<CurveRead>,
}

/// Lowest and highest temperature that a log may hold [K] (chosen: ice in a freezer, a glowing pan).
const RANGE: [f64; 2] = [220.0, 1200.0];
/// Share of the values that may be none without a known word [-] (chosen: dropouts, the column is read all the same).
const FEW: f64 = 0.2;

impl LogFile {
    /// Reads the times and the curves of a log.
    ///
    /// # Errors
    ///
    /// If a time or too many temperatures are none, no column can be the core's or the pan's, or two readings are possible; the error
    /// then has the question.
    pub fn read(&self, choices: &Choices) -> Result<Reading, LogError> {
        let table = self.table_for(choices.logger);
        let looked = Looked { log: self, table: &table, roles: Roles::of(&table), choices };
        let (time, half) = looked.time();
        let times = looked.times(time, half)?;
        let columns: Vec<usize> = std::iter::once(time).chain(half).collect();
        let pan = looked.pan(&times, &columns)?;
        let core = looked.core(&times, &columns, pan.is_some())?;
        if core.is_none() && pan.is_none() {
            let message = "no header says which column is the core's or the pan's".to_owned();
            return Err(self.error(
                table.line,
                message,
                format!("name them: --core COLUMN, --pan COLUMN, of {}", self.list(&table.headers)),
            ));
        }
        let given = || times.at_s.iter().flatten();
        let ends = given().fold((f64::MAX, f64::MIN), |(a, b), at| (a.min(*at), b.max(*at)));
        let first = if times.is_newest_first { table.rows.last() } else { table.rows.first() };
        let text = |at: usize| first.and_then(|(_, fields)| fields.get(at)).cloned().unwrap_or_default();
        let both = |of: &dyn Fn(usize) -> String| columns.iter().map(|at| of(*at)).collect::<Vec<_>>().join(" ");
        Ok(Reading {
            time_column: both(&|at| table.headers[at].clone()),
            time_form: times.form,
            begins: both(&text),
            span_s: ends.1 - ends.0,
            is_newest_first: times.is_newest_first,
            rows: table.rows.len(),
            core,
            pan,
        })
    }
}

/// A log with what is known of it.
struct Looked<'t> {
    log: &'t LogFile,
    table: &'t Table,
    roles: Roles<'t>,
    choices: &'t Choices,
}

impl Looked<'_> {
    fn time(&self) -> (usize, Option<usize>) {
        match self.choices.time.or_else(|| self.preset(|logger| &logger.time)) {
            Some(at) => (at, self.roles.other_half(at)),
            None => self.roles.time(),
        }
    }

    /// The first column that a maker's preset names.
    fn preset(&self, names: fn(&Logger) -> &Vec<String>) -> Option<usize> {
        let is = |name: &String| {
            self.table.headers.iter().position(|header| begins_with(&words_of(header), &words_of(name)))
        };
        names(self.choices.logger?).iter().find_map(is)
    }

    fn times(&self, time: usize, half: Option<usize>) -> Result<Times, LogError> {
        let column = |at: usize| self.table.column(at);
        let fields: Vec<String> = match half {
            Some(half) => column(time).zip(column(half)).map(|(field, other)| format!("{field} {other}")).collect(),
            None => column(time).map(str::to_owned).collect(),
        };
        let line = |row: usize| self.table.rows.get(row).map_or(1, |(line, _)| *line);
        times_of(&self.table.headers[time], &fields, self.choices.form).map_err(|no| match no {
            NoTimes::Row(row) => self.log.error(
                line(row),
                format!("\"{}\" is no time", fields[row]),
                "write seconds (90), min:s (1:30) or a clock (18:03:20), or name another column with --time".to_owned(),
            ),
            NoTimes::Back(row) => self.log.error(
                line(row),
                format!("the time goes back to \"{}\": another recording begins here", fields[row]),
                "keep one recording".to_owned(),
            ),
            NoTimes::Several(forms) => {
                let words: Vec<&str> = forms.iter().map(|form| form.words()).collect();
                let (from, to) =
                    (fields.first().cloned().unwrap_or_default(), fields.last().cloned().unwrap_or_default());
                let message = format!("the times from \"{from}\" to \"{to}\" can be {}", words.join(" or "));
                self.log.question(Question::Times(forms), message, "say which with --times".to_owned())
            }
        })
    }

    fn pan(&self, times: &Times, columns: &[usize]) -> Result<Option<CurveRead>, LogError> {
        let found = match self.choices.pan {
            Pick::No => return Ok(None),
            Pick::Column(at) => vec![at],
            Pick::ByHeader => match self.preset(|logger| &logger.pan) {
                Some(at) => vec![at],
                None => self.roles.pans(columns),
            },
        };
        self.one_of(found, times, Quantity::Pan, Question::Pan, "--pan")
    }

    fn core(&self, times: &Times, columns: &[usize], has_pan: bool) -> Result<Option<CurveRead>, LogError> {
        let found = match self.choices.core {
            Pick::No => return Ok(None),
            Pick::Column(at) => vec![at],
            Pick::ByHeader => match self.preset(|logger| &logger.core) {
                Some(at) => vec![at],
                None => self.roles.cores(columns, has_pan),
            },
        };
        self.one_of(found, times, Quantity::Core, Question::Core, "--core")
    }

    /// The curve of the one column among some that can be it.
    fn one_of(
        &self,
        found: Vec<usize>,
        times: &Times,
        quantity: Quantity,
        question: fn(Vec<usize>) -> Question,
        option: &str,
    ) -> Result<Option<CurveRead>, LogError> {
        if let [only] = found[..] {
            return self.curve(only, times, quantity).map(Some);
        }
        let read: Vec<CurveRead> = found.iter().filter_map(|at| self.curve(*at, times, quantity).ok()).collect();
        let mut can: Vec<CurveRead> = Vec::new();
        for curve in read.into_iter().filter(|curve| is_believed(&curve.points, quantity)) {
            // The same temperatures twice are one reading.
            if can.first().is_none_or(|first| first.points != curve.points) {
                can.push(curve);
            }
        }
        match (can.len(), found.first()) {
            (0, Some(first)) => self.curve(*first, times, quantity).map(Some),
            (0 | 1, _) => Ok(can.pop()),
            _ => {
                let each =
                    can.iter().map(|curve| format!("{} \"{}\" ({})", curve.at + 1, curve.column, range(&curve.points)));
                let what = if quantity == Quantity::Core { "core" } else { "pan" };
                let message =
                    format!("more than one column can be the {what}'s: {}", each.collect::<Vec<_>>().join(", "));
                Err(self.log.question(
                    question(can.iter().map(|c| c.at).collect()),
                    message,
                    format!("name it: {option} COLUMN"),
                ))
            }
        }
    }

    /// Reads a column of temperatures.
    fn curve(&self, at: usize, times: &Times, quantity: Quantity) -> Result<CurveRead, LogError> {
        let (unit, unit_from) = self.unit(at);
        let curve = self.in_unit(at, times, unit)?;
        if unit_from == UnitFrom::Assumed {
            self.believe(at, &curve.0, times, quantity)?;
        }
        Ok(CurveRead {
            at,
            column: self.table.headers[at].clone(),
            unit,
            unit_from,
            left_out: curve.1,
            points: curve.0,
        })
    }

    fn unit(&self, at: usize) -> (Unit, UnitFrom) {
        let headers = &self.table.headers;
        let own = || Unit::of_header(&headers[at]).filter(|_| !is_letter_of_channel(headers, at));
        let others = || {
            let named: Vec<Unit> = headers.iter().filter_map(|header| Unit::of_header(header)).collect();
            named.first().copied().filter(|first| named.iter().all(|unit| unit == first))
        };
        let by_maker = || self.choices.logger.and_then(Logger::unit);
        let asked = self.choices.unit.map(|unit| (unit, UnitFrom::Asked));
        asked
            .or_else(|| own().map(|unit| (unit, UnitFrom::Header)))
            .or_else(|| self.unit_of_rows(at).map(|unit| (unit, UnitFrom::Rows)))
            .or_else(|| self.log.unit_above().map(|unit| (unit, UnitFrom::Preamble)))
            .or_else(|| by_maker().map(|unit| (unit, UnitFrom::Maker)))
            .or_else(|| others().map(|unit| (unit, UnitFrom::OtherColumn)))
            .unwrap_or((Unit::Celsius, UnitFrom::Assumed))
    }

    /// The unit next to the values of a column, or in a column of units.
    fn unit_of_rows(&self, at: usize) -> Option<Unit> {
        let has_unit = |header: &String| {
            words_of(header).iter().any(|word| ["unit", "units", "einheit", "単位"].contains(&&**word))
        };
        let beside = self.table.headers.iter().position(has_unit);
        self.table.rows.iter().find_map(|(_, fields)| match Value::of(fields.get(at)?) {
            Value::Number(_, Some(unit)) => Some(unit),
            Value::Number(..) => Unit::of_word(fields.get(beside?)?),
            _ => None,
        })
    }

    /// The points of a column [s, K] by time, those of one time averaged; and how many rows have none.
    fn in_unit(&self, at: usize, times: &Times, unit: Unit) -> Result<(Vec<(f64, f64)>, usize), LogError> {
        let mut points: Vec<(f64, f64)> = Vec::new();
        let mut wrong: Vec<(u64, &str)> = Vec::new();
        let mut missing = 0;
        for ((line, fields), at_s) in self.table.rows.iter().zip(&times.at_s) {
            let text = fields.get(at).map_or("", String::as_str);
            match (at_s, Value::of(text)) {
                (Some(at_s), Value::Number(value, own)) => match own.unwrap_or(unit).kelvin(value) {
                    kelvin if (RANGE[0]..=RANGE[1]).contains(&kelvin) => points.push((*at_s, kelvin)),
                    _ => wrong.push((*line, text)),
                },
                (Some(_), Value::Other) => wrong.push((*line, text)),
                _ => missing += usize::from(!(self.table.is_long && text.is_empty())),
            }
        }
        if let Some((line, text)) =
            wrong.first().filter(|_| wrong.len() as f64 > FEW * (points.len() + wrong.len()) as f64)
        {
            return Err(self.no_temperature(*line, text));
        }
        if points.is_empty() {
            let message = format!("the column \"{}\" has no temperatures", self.table.headers[at]);
            return Err(self.log.error(self.table.line, message, "name another column".to_owned()));
        }
        Ok((averaged(points), missing + wrong.len()))
    }

    fn no_temperature(&self, line: u64, text: &str) -> LogError {
        match Value::of(text) {
            Value::Number(..) => {
                let message = format!("{text} cannot be a temperature in a kitchen");
                self.log.error(line, message, "check the column and its unit (--unit)".to_owned())
            }
            _ => self.log.error(
                line,
                format!("\"{text}\" is no temperature"),
                "write a number, or leave the field empty".to_owned(),
            ),
        }
    }

    /// Refuses °C that nothing states where only °F makes sense.
    fn believe(&self, at: usize, points: &[(f64, f64)], times: &Times, quantity: Quantity) -> Result<(), LogError> {
        let begin = self.choices.begin.filter(|_| quantity == Quantity::Core);
        let is_good = |points: &[(f64, f64)]| is_believed(points, quantity) && begins_as(points, begin);
        if is_good(points) {
            return Ok(());
        }
        let (other, _) = self.in_unit(at, times, Unit::Fahrenheit)?;
        if !is_good(&other) {
            return Ok(());
        }
        let why = match begin {
            Some((_, kelvin)) if is_believed(points, quantity) => {
                format!("while the recipe's food is put in at {:.0} °C", kelvin - ZERO_C)
            }
            _ if quantity == Quantity::Core => "which no core reaches".to_owned(),
            _ => "which no pan reaches".to_owned(),
        };
        let message = format!(
            "nothing states the unit of \"{}\": read as °C it goes {}, {why}; read as °F it goes {}",
            self.table.headers[at],
            range(points),
            range(&other)
        );
        let remedy = "say which with --unit f or --unit c".to_owned();
        Err(self.log.question(Question::Unit([Unit::Celsius, Unit::Fahrenheit]), message, remedy))
    }
}

fn begins_with(words: &[String], name: &[String]) -> bool {
    words.len() >= name.len() && words.iter().zip(name).all(|(word, name)| word == name)
}

/// True if a header ends in a letter as its neighbours end in others: `Probe A`, …, `Probe F`.
fn is_letter_of_channel(headers: &[String], at: usize) -> bool {
    let split = |header: &String| {
        let mut words = words_of(header);
        words.pop().filter(|last| last.len() == 1).map(|last| (words, last))
    };
    let Some((stem, _)) = split(&headers[at]) else { return false };
    let is_other = |(words, last): (Vec<String>, String)| {
        words == stem && Unit::of_word(&last).is_none() && last.parse::<u8>().is_err()
    };
    headers.iter().filter_map(split).any(is_other)
}

/// Points by time; those of one time become their mean.
fn averaged(mut points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let same = points.chunk_by(|a, b| a.0 == b.0);
    same.map(|group| (group[0].0, group.iter().map(|(_, kelvin)| kelvin).sum::<f64>() / group.len() as f64)).collect()
}
