//! An analysis as text and as tables.

use std::fmt::Write;

use saute_study::Analysis;
use saute_study::analysis::{Change, Interval, Quantity, Span};

use crate::error::CliError;

/// Returns the names and texts of the tables.
pub fn files(analysis: &Analysis) -> Result<Vec<(String, Vec<u8>)>, CliError> {
    Ok(vec![
        ("curves.csv".to_owned(), curves(analysis)?),
        ("before-after.csv".to_owned(), before_after(analysis)?),
        ("participants.csv".to_owned(), participants(analysis)?),
    ])
}

fn table(rows: impl IntoIterator<Item = Vec<String>>) -> Result<Vec<u8>, CliError> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    rows.into_iter().try_for_each(|row| writer.write_record(row))?;
    // Memory takes all that is written.
    Ok(writer.into_inner().unwrap_or_default())
}

fn head(columns: &[&str]) -> Vec<String> {
    columns.iter().map(|column| (*column).to_owned()).collect()
}

fn ends(interval: Option<&Interval>) -> [String; 3] {
    interval.map_or_else(Default::default, |i| [i.median, i.low, i.high].map(|v| format!("{v:.3}")))
}

fn curves(analysis: &Analysis) -> Result<Vec<u8>, CliError> {
    let columns =
        ["quantity", "condition", "phase", "trial", "n", "missing", "median", "low_90", "high_90", "simulated"];
    let rows = analysis.curves.iter().map(|point| {
        let numbers =
            [point.phase.to_string(), point.number.to_string(), point.n.to_string(), point.missing.to_string()];
        let own = [point.quantity.id().to_owned(), point.condition.clone()].into_iter().chain(numbers);
        own.chain(ends(point.interval.as_ref())).chain([analysis.simulated.to_string()]).collect()
    });
    table([head(&columns)].into_iter().chain(rows))
}

fn before_after(analysis: &Analysis) -> Result<Vec<u8>, CliError> {
    let columns = [
        "quantity",
        "compared",
        "condition",
        "after_trial",
        "n",
        "missing",
        "before",
        "after",
        "difference",
        "low_90",
        "high_90",
        "simulated",
    ];
    let rows = analysis.changes.iter().map(|change| {
        let own = [change.quantity.id().to_owned(), span(change.span).to_owned(), condition(change).to_owned()];
        let counts = [change.after_trial.to_string(), change.n.to_string(), change.missing.to_string()];
        let medians = [change.before, change.after].map(|v| format!("{v:.3}"));
        let all = own.into_iter().chain(counts).chain(medians).chain(ends(Some(&change.difference)));
        all.chain([analysis.simulated.to_string()]).collect()
    });
    table([head(&columns)].into_iter().chain(rows))
}

fn participants(analysis: &Analysis) -> Result<Vec<u8>, CliError> {
    let columns = ["participant", "condition", "trials", "missing_trials", "answers", "simulated"];
    let rows = analysis.participants.iter().map(|taker| {
        let counts = [taker.trials, taker.missing_trials, taker.answers].map(|count| count.to_string());
        let own = [taker.participant.clone(), taker.condition.clone()].into_iter().chain(counts);
        own.chain([analysis.simulated.to_string()]).collect()
    });
    table([head(&columns)].into_iter().chain(rows))
}

/// Returns what is compared, in words.
pub fn span(span: Span) -> &'static str {
    match span {
        Span::Nearest => "last trial before, first after",
        Span::Phases => "all trials of the phase before, of the phase after",
    }
}

/// Returns the condition of a comparison.
pub fn condition(change: &Change) -> &str {
    change.condition.as_deref().unwrap_or("all")
}

/// Returns a quantity with its unit, in words.
pub fn quantity(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Score => "Score [points]",
        Quantity::TargetSharePct => "Share on target [%]",
    }
}

/// Returns who took part, in words: that they are simulated comes first.
pub fn who(analysis: &Analysis) -> &'static str {
    if analysis.simulated { "simulated participants" } else { "participants" }
}

/// Returns how many took part in which condition, and what is missing.
pub fn counts(analysis: &Analysis) -> String {
    let count = |condition: &String| analysis.participants.iter().filter(|t| t.condition == *condition).count();
    let by_condition: Vec<String> =
        analysis.conditions().iter().map(|condition| format!("{condition}: {}", count(condition))).collect();
    let missing: usize = analysis.participants.iter().map(|taker| taker.missing_trials).sum();
    let lacking: Vec<&str> = analysis
        .participants
        .iter()
        .filter(|taker| taker.missing_trials > 0)
        .map(|taker| taker.participant.as_str())
        .collect();
    let of = if lacking.is_empty() { String::new() } else { format!(" ({})", lacking.join(", ")) };
    format!(
        "n = {} {} ({}); missing trials: {missing}{of}",
        analysis.participants.len(),
        who(analysis),
        by_condition.join(", ")
    )
}

/// Returns the analysis on one screen.
pub fn text(analysis: &Analysis) -> String {
    let mut text = format!("study {} (protocol {}): {}\n", analysis.study, analysis.protocol, counts(analysis));
    for quantity in Quantity::ALL {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "\n{} by trial: median (90 % interval), n", self::quantity(quantity));
        for point in analysis.curves.iter().filter(|point| point.quantity == quantity) {
            let shown = point.interval.map_or_else(
                || "nobody".to_owned(),
                |i| format!("{:.1} ({:.1} to {:.1}), {}", i.median, i.low, i.high, point.n),
            );
            let _ = writeln!(text, "  {} trial {:<3} {shown}", point.condition, point.number);
        }
    }
    for change in &analysis.changes {
        let Change { before, after, difference: d, n, .. } = change;
        let _ = writeln!(
            text,
            "\n{}, condition {}, {}: {before:.1} → {after:.1}, difference {:+.1} ({:+.1} to {:+.1}), n = {n}",
            quantity(change.quantity),
            condition(change),
            span(change.span),
            d.median,
            d.low,
            d.high
        );
    }
    text
}
