//! The data dictionary: what each column of a log means, its unit and its range.

/// A column of a log.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Column {
    /// Its header.
    pub name: &'static str,
    /// What it contains.
    pub meaning: &'static str,
    /// Its unit, or the kind of its values.
    pub unit: &'static str,
    /// Lowest and highest value, of numbers.
    pub range: Option<[f64; 2]>,
    /// Kinds of rows that have it.
    pub rows: &'static str,
}

const fn text(name: &'static str, unit: &'static str, rows: &'static str, meaning: &'static str) -> Column {
    Column { name, meaning, unit, range: None, rows }
}

const fn number(
    name: &'static str,
    (unit, low, high): (&'static str, f64, f64),
    rows: &'static str,
    meaning: &'static str,
) -> Column {
    Column { name, meaning, unit, range: Some([low, high]), rows }
}

/// Longest time that a log may state [s] (chosen: a day).
const DAY_S: f64 = 86_400.0;

/// All columns, in the order of a log.
pub const COLUMNS: [Column; 36] = [
    text("study", "id", "all", "id of the protocol"),
    text(
        "protocol",
        "8 hexadecimal digits",
        "all",
        "CRC-32 of the protocol's text: a protocol that was changed has another one",
    ),
    text("participant", "code", "all", "code of the participant: 1 to 12 letters, digits and hyphens"),
    text("simulated", "true, false", "all", "true if a program took part in the place of a person"),
    text("condition", "id", "all", "condition of the protocol, assigned by the code"),
    number("phase", ("1", 0.0, 20.0), "all", "number of the phase, from 1; 0 for the consent"),
    text("kind", "consent, trial, entry, answer", "all", "what the row is about"),
    number(
        "elapsed_s",
        ("s", 0.0, DAY_S),
        "all",
        "wall time since this run of the program began; a study that is gone on with later begins at 0 again",
    ),
    text(
        "started",
        "ISO 8601, UTC",
        "all",
        "time of day at which the program was started; empty unless the protocol has time_of_day = true",
    ),
    number("trial", ("1", 1.0, 50.0), "trial", "number of the trial in its phase, from 1"),
    text("information", "shown, hidden", "trial", "whether read-outs were shown"),
    text("goal", "id", "trial", "goal of the trial (saute list goals)"),
    number("score", ("points", -1000.0, 100.0), "trial", "score of the cook (docs/planning.md)"),
    text("is_met", "true, false", "trial", "true if the goal was met"),
    number(
        "target_share_pct",
        ("%", 0.0, 100.0),
        "trial",
        "share that the goal counts: of the section in its class, or of the faces browned",
    ),
    number("beyond_pct", ("%", 0.0, 100.0), "trial", "share of the section beyond the class of the goal"),
    number(
        "grey_band_mm",
        ("mm", 0.0, 200.0),
        "trial",
        "thickness of the band beyond the class of the goal below the faces, mean of both",
    ),
    number("core_peak_c", ("°C", -20.0, 300.0), "trial", "highest temperature that the core reached"),
    number("crust_pct", ("%", 0.0, 100.0), "trial", "browned share of the two faces"),
    number("charred_pct", ("%", 0.0, 100.0), "trial", "charred share of the two faces"),
    number("lost_pct", ("%", -50.0, 100.0), "trial", "mass that was lost"),
    number("energy_kj", ("kJ", 0.0, 50_000.0), "trial", "electrical energy of the hob"),
    number("flips", ("1", 0.0, 10_000.0), "trial", "number of flips"),
    number("put_s", ("simulated s", 0.0, DAY_S), "trial", "when the food went into the pan; empty if it never did"),
    number(
        "out_s",
        ("simulated s", 0.0, DAY_S),
        "trial",
        "when it was taken out for the last time; empty if it never was",
    ),
    number("end_s", ("simulated s", 0.0, DAY_S), "trial", "when the trial ended"),
    number(
        "trial_wall_s",
        ("s", 0.0, DAY_S),
        "trial",
        "wall time that the trial took; empty for simulated participants",
    ),
    text("session", "file name", "trial", "session of the trial; empty unless the protocol has keep_sessions = true"),
    text("item", "id", "entry, answer", "what was entered, or the question"),
    number(
        "value",
        ("by item", -1e9, 1e9),
        "entry, answer",
        "the value, if it is a number; of a choice its place from 1",
    ),
    text("text", "text", "entry, answer", "the value, if it is a word: a class, a choice, free text"),
    number(
        "mark",
        ("points", 0.0, 100.0),
        "trial",
        "mark of the cook (docs/learning.md); empty in logs of before it was kept",
    ),
    number(
        "speed_set",
        ("1", 1.0, 20.0),
        "trial",
        "simulated time over wall time that the protocol sets; empty for simulated participants and in logs of before it was kept",
    ),
    number(
        "speed_held_median",
        ("1", 0.0, 20.0),
        "trial",
        "median over the seconds of the trial of the speed that the machine held; empty as speed_set",
    ),
    number(
        "behind_s",
        ("simulated s", 0.0, DAY_S),
        "trial",
        "simulated time by which the trial ended behind speed_set times its wall time; empty as speed_set",
    ),
    text(
        "devices",
        "names",
        "trial",
        "haptic devices that were connected during the trial, with what they held, as pan:spidar-frame, separated by spaces; empty where mouse, keys or touch did all, and in logs of before it was kept",
    ),
];

/// Returns the dictionary as CSV.
pub fn csv() -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    // Memory takes all that is written.
    let _ = writer.write_record(["column", "meaning", "unit", "lowest", "highest", "rows"]);
    for Column { name, meaning, unit, range, rows } in COLUMNS {
        let [low, high] = range.map_or_else(Default::default, |range| range.map(|v| v.to_string()));
        let _ = writer.write_record([name, meaning, unit, &low, &high, rows]);
    }
    writer.into_inner().ok().and_then(|bytes| String::from_utf8(bytes).ok()).unwrap_or_default()
}

/// Returns the dictionary as a page in Markdown.
pub fn page() -> String {
    let row = |column: &Column| {
        let range = column.range.map_or_else(|| "–".to_owned(), |[low, high]| format!("{low} to {high}"));
        format!("| `{}` | {} | {} | {range} | {} |\n", column.name, column.meaning, column.unit, column.rows)
    };
    let rows: String = COLUMNS.iter().map(row).collect();
    format!("{HEAD}{rows}")
}

/// Head of the page.
const HEAD: &str = "# Data dictionary

Columns of `study-CODE.csv`. What a kind of row does not have is empty. Percentages run from 0 to 100.

| column | meaning | unit or values | range | rows |
|---|---|---|---|---|
";
