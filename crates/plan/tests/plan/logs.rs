//! Promise: logs are read as makers' programs, loggers, phones and spreadsheets write them, and what is not stated is reported or requested.

use saute_plan::fit::log::log_error::{LogError, Question};
use saute_plan::fit::log::log_file::LogFile;
use saute_plan::fit::log::logger::{Logger, loggers};
use saute_plan::fit::log::reading::{Choices, Reading};
use saute_plan::fit::log::times::TimeForm;
use saute_plan::fit::log::unit::{Unit, UnitFrom};

/// One cook in each maker's form, as `docs/logs` has it.
fn example(name: &str) -> Vec<u8> {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/logs").join(name);
    std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn read(text: &[u8], choices: &Choices) -> Result<Reading, LogError> {
    LogFile::parse("log.csv", text)?.read(choices)
}

/// The core every 30 s of the cook in the examples [s, K].
fn cook() -> Vec<(f64, f64)> {
    let log = read(&example("combustion.csv"), &Choices::default()).expect("is read");
    log.core.expect("a core").points
}

fn same(reading: &Reading, least: usize) {
    let cook = cook();
    let core = reading.core.as_ref().expect("a core");
    assert!(core.points.len() >= least, "{} points", core.points.len());
    let begin = core.points[0].0;
    for (at_s, kelvin) in &core.points {
        let there = cook.iter().find(|(at, _)| (at - (at_s - begin)).abs() < 1.0);
        assert!(there.is_some_and(|(_, there)| (there - kelvin).abs() < 0.4), "{at_s}: {kelvin} {there:?}");
    }
}

#[test]
fn the_example_of_each_maker_is_read_by_its_preset_and_but_one_without() {
    for logger in loggers() {
        let text = example(&format!("{}.csv", logger.id));
        let least = if logger.id == "spreadsheet" { 15 } else { 27 };
        let by_preset = Choices { logger: Some(logger), ..Choices::default() };
        same(&read(&text, &by_preset).unwrap_or_else(|error| panic!("{}: {error}", logger.id)), least);
        match read(&text, &Choices::default()) {
            Ok(reading) => same(&reading, least),
            // Its names of channels state no unit.
            Err(error) => {
                assert!(logger.id == "thermoworks" && matches!(error.question, Some(Question::Unit(_))), "{error}")
            }
        }
    }
}

#[test]
fn a_pan_is_read_only_where_a_header_says_so() {
    for (id, pan) in [
        ("fireboard", true),
        ("spreadsheet", true),
        ("home-assistant", true),
        ("combustion", false),
        ("meater", false),
        ("heatermeter", false),
    ] {
        let reading = read(&example(&format!("{id}.csv")), &Choices::default()).expect(id);
        assert_eq!(reading.pan.is_some(), pan, "{id}");
    }
}

/// Rows of a table: a header, and each row by time and temperature of the core [s, °C].
fn table(header: &str, row: impl Fn(u32, f64) -> String) -> String {
    let rows = cook().into_iter().map(|(at, kelvin)| row(at as u32, kelvin - 273.15)).collect::<String>();
    format!("{header}{rows}")
}

fn f(celsius: f64) -> f64 {
    1.8 * celsius + 32.0
}

/// Hours, minutes and seconds after 18:03.
fn clock(at: u32) -> [u32; 3] {
    [18 + (180 + at) / 3600, (180 + at) / 60 % 60, at % 60]
}

#[test]
fn dialects_of_times_units_and_tables_are_read() {
    let hms = |at| clock(at).map(|n| format!("{n:02}")).join(":");
    let dialects: [(&str, String); 16] = [
        ("camel case", table("Time (s),InternalTempF\n", |at, c| format!("{at},{:.1}\n", f(c)))),
        ("a column of units", table("time,temperature,unit\n", |at, c| format!("{at},{:.1},F\n", f(c)))),
        ("units in the cells", table("time,Core\n", |at, c| format!("{at},{:.1} \u{2109}\n", f(c)))),
        ("a row of units", table("Time,Core\ns,\u{b0}F\n", |at, c| format!("{at},{:.1}\n", f(c)))),
        (
            "remarks with the unit",
            table("# Unit: F\n# 2025-04-05 18:03\nt,core\n", |at, c| format!("{at},{:.1}\n", f(c))),
        ),
        ("minutes", table("Elapsed (min),Core\n", |at, c| format!("{:.1},{c:.2}\n", f64::from(at) / 60.0))),
        ("minutes without a word", table("Time,Core\n", |at, c| format!("{:.1},{c:.2}\n", f64::from(at) / 60.0))),
        ("milliseconds", table("millis,Core\n", |at, c| format!("{},{c:.2}\n", 1000 * at))),
        ("time since 1970", table("", |at, c| format!("{},{c:.2},0\n", 1_743_876_180 + at))),
        (
            "days of a spreadsheet",
            table("Time,Core\n", |at, c| format!("{:.6},{c:.2}\n", 45_752.75 + f64::from(at) / 86_400.0)),
        ),
        ("zone", table("time,core\n", |at, c| format!("2025-04-05T{}-07:00,{c:.2}\n", hms(at)))),
        ("date and clock", table("Date,Time,Core\n", |at, c| format!("4/5/25,{},{c:.2}\n", hms(at)))),
        (
            "half of the day",
            table("When,Core\n", |at, c| format!("\"Apr 5, 2025 {} PM\",{c:.2}\n", hms(at).replace("18:", "6:"))),
        ),
        ("Japanese", table("時刻,芯温\n", |at, c| format!("2025年4月5日 {},{c:.2}\n", hms(at)))),
        (
            "German",
            table("Zeit;Kern\n", |at, c| format!("05.04.2025 {};{}\n", hms(at), format!("{c:.2}").replace('.', ","))),
        ),
        ("blanks", table("time core\n", |at, c| format!("{at}  {c:.2}\n"))),
    ];
    for (name, text) in dialects {
        same(&read(text.as_bytes(), &Choices::default()).unwrap_or_else(|error| panic!("{name}: {error}\n{text}")), 29);
    }
    let german = "Zeit;Kern (\u{b0}C)\n0;6,5\n300;20,5\n";
    let bytes: Vec<u8> = german.chars().map(|letter| letter as u8).collect();
    assert_eq!(
        read(&bytes, &Choices::default()).expect("Windows-1252").core.expect("a core").unit_from,
        UnitFrom::Header
    );
}

#[test]
fn what_is_assumed_is_told() {
    let reading = read(&example("inkbird.csv"), &Choices::default()).expect("is read");
    let core = reading.core.expect("a core");
    assert_eq!((core.column.as_str(), core.unit, core.unit_from), ("Probe1(°F)", Unit::Fahrenheit, UnitFrom::Header));
    assert_eq!((reading.time_form, reading.is_newest_first, reading.span_s), (TimeForm::Dated, true, 840.0));
    assert_eq!(reading.begins, "2025/04/05 18:03:00");
    let reading = read(&example("home-assistant.csv"), &Choices::default()).expect("is read");
    assert_eq!(reading.core.expect("a core").left_out, 2, "twice unavailable");
}

#[test]
fn where_two_readings_are_possible_the_log_is_refused_with_both() {
    let asks = |text: &str, choices: Choices| {
        let error = read(text.as_bytes(), &choices).expect_err("two readings");
        (error.question.clone().unwrap_or_else(|| panic!("{error}")), error.message)
    };
    let begin = Some((0.0, 279.15));
    let (question, message) = asks("Time,Core\n0,42.8\n200,80.6\n", Choices { begin, ..Choices::default() });
    assert_eq!(question, Question::Unit([Unit::Celsius, Unit::Fahrenheit]));
    assert!(message.contains("put in at 6 °C") && message.contains("read as °F it goes from 6 to 27 °C"), "{message}");
    let (question, _) = asks("Time,Core\n1:00,6\n2:30,20\n4:00,40\n", Choices::default());
    assert_eq!(question, Question::Times(vec![TimeForm::MinSec, TimeForm::HourMin]));
    let (question, _) = asks("Time,Probe 1,Probe 2\n0,6,7\n300,20,22\n", Choices::default());
    assert_eq!(question, Question::Core(vec![1, 2]));
}

#[test]
fn what_cannot_be_read_is_named_with_its_line_and_remedy() {
    let refused = |text: &str| read(text.as_bytes(), &Choices::default()).expect_err("refused").to_string();
    assert_eq!(
        refused("t,core\n0,5\nten,6\n"),
        "log.csv:3: \"ten\" is no time; write seconds (90), min:s (1:30) or a clock (18:03:20), or name another column with --time"
    );
    assert!(refused("t,core\n0,hot\n30,hot\n").contains("no header says which column"));
    assert!(refused("t,core\n0,5000\n30,5001\n").starts_with("log.csv:2: 5000 cannot be a temperature in a kitchen"));
    assert!(refused("t,core\n0,5\n60,6\n0,5\n60,6\n").starts_with("log.csv:4: the time goes back"));
    let log = LogFile::parse("log.csv", b"t,core\n0,5\n30,6\n").expect("a table");
    let unknown = log.column("pan", None).expect_err("refused").to_string();
    assert_eq!(unknown, "log.csv:1: has no column \"pan\"; use one of: 1 \"t\", 2 \"core\"");
}

#[test]
fn times_that_are_equal_are_averaged_and_a_probe_that_is_not_there_is_left_out() {
    let reading =
        read(b"t,core\n0,5\n0,6\n30,--\n60,-999\n90,7\n120,8\n150,9\n180,10\n", &Choices::default()).expect("is read");
    let core = reading.core.expect("a core");
    assert_eq!((core.points[0], core.points.len(), core.left_out), ((0.0, 278.65), 5, 2));
}

#[test]
fn each_preset_is_named_once() {
    assert!(loggers().iter().all(|logger| loggers().iter().filter(|other| other.id == logger.id).count() == 1));
    assert!(Logger::named("combustion").is_some() && Logger::named("else").is_none());
}
