//! Numbers and steps as text.

use saute_kitchen::food::Scale;
use saute_kitchen::food::change::doneness::Measure;
use saute_recipe::ActionKind;
use saute_recipe::step_record::StepRecord;

/// Returns a time as text: `45.0 s`, `16 min 38 s`.
pub fn duration(seconds: f64) -> String {
    let whole = seconds.round() as u64;
    if seconds < 60.0 { format!("{seconds:.1} s") } else { format!("{} min {:02} s", whole / 60, whole % 60) }
}

/// Returns a time as minutes and seconds, for tables: `16:38.0`.
pub fn clock(seconds: f64) -> String {
    let tenths = (10.0 * seconds).round() as u64;
    format!("{}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10)
}

/// Returns a step as it was carried out: `hob 2000 W`, `flip steak`.
pub fn step(step: &StepRecord) -> String {
    step.action.words()
}

/// Returns a step in one word for the marks of a plot; none for the hob, which has its own curve.
pub fn mark(step: &StepRecord) -> Option<&'static str> {
    match step.action.kind() {
        ActionKind::Hob => None,
        ActionKind::Cool => Some("cloth"),
        ActionKind::MovePan => Some("pan"),
        ActionKind::Oil => Some("oil"),
        ActionKind::Butter => Some("butter"),
        ActionKind::Water => Some("water"),
        kind @ (ActionKind::Put
        | ActionKind::Flip
        | ActionKind::Rest
        | ActionKind::Halve
        | ActionKind::Press
        | ActionKind::Baste
        | ActionKind::Move
        | ActionKind::Toss
        | ActionKind::Shake
        | ActionKind::Tilt
        | ActionKind::Lid
        | ActionKind::Wipe
        | ActionKind::Repeat
        | ActionKind::End) => Some(kind.name()),
    }
}

/// Returns the range of a class of doneness, as `50–60 °C` or `40–85 %`.
pub fn class_range(scale: &Scale, place: usize) -> String {
    let from = scale.from(place);
    let unit = match scale.measure() {
        Measure::Peak => "°C",
        Measure::Share => "%",
    };
    match (place, scale.end(place)) {
        (0, Some(end)) => format!("< {end} {unit}"),
        (_, Some(end)) => format!("{from}–{end} {unit}"),
        (_, None) => format!("> {from} {unit}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_in_tables_are_minutes_and_seconds() {
        assert_eq!([0.0, 59.96, 345.6, 998.0].map(clock), ["0:00.0", "1:00.0", "5:45.6", "16:38.0"]);
    }
}
