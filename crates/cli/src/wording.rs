//! Numbers and steps as text.

use saute_kitchen::food::Scale;
use saute_recipe::step_record::StepRecord;

/// Returns a time as text: `45.0 s`, `16 min 38 s`.
pub fn duration(seconds: f64) -> String {
    let whole = seconds.round() as u64;
    if seconds < 60.0 { format!("{seconds:.1} s") } else { format!("{} min {:02} s", whole / 60, whole % 60) }
}

/// Returns a step as it was carried out: `hob 2000 W`, `flip steak`.
pub fn step(step: &StepRecord) -> String {
    let food = step.target.as_deref().unwrap_or_default();
    match (step.action, &step.value) {
        ("hob_w", value) => format!("hob {} W", number(value)),
        ("rest", value) => {
            format!("rest {food} on the {}", value.as_str().unwrap_or("board").replace("foil", "board under foil"))
        }
        ("cool", value) => format!("pan on a wet cloth for {} s", number(value)),
        ("press", value) => {
            format!("press {food} with {} N for {} s", number(&value["n"]), number(&value["for_s"]))
        }
        ("move", value) => format!("move {food} to {value} mm"),
        ("put" | "flip" | "halve", _) => format!("{} {food}", step.action),
        (action, value) => on_pan(action, value),
    }
}

/// Returns a step that concerns no single food.
fn on_pan(action: &str, value: &serde_json::Value) -> String {
    let n = |key: &str| number(&value[key]);
    match action {
        "move_pan" => format!("pan to {} mm, lifted by {} mm", value["at_mm"], n("lift_mm")),
        "oil_g" => format!("{} g {}", n("g"), value["kind"].as_str().map_or("oil".to_owned(), |k| format!("{k} oil"))),
        "butter_g" => format!("{} g butter", number(value)),
        "water_g" => format!("{} g water", number(value)),
        "toss" => format!("toss {} mm high", n("height_mm")),
        "shake" => format!("shake ± {} mm at {} Hz for {} s", n("amplitude_mm"), n("hz"), n("for_s")),
        "tilt" if value["deg"] == 0.0 => "level the pan".to_owned(),
        "tilt" => format!("tilt by {}° towards {}°", n("deg"), n("towards_deg")),
        "lid" => if *value == true { "lid on" } else { "lid off" }.to_owned(),
        other => other.to_owned(),
    }
}

/// Returns a step in one word for the marks of a plot; none for the hob, which has its own curve.
pub fn mark(step: &StepRecord) -> Option<&'static str> {
    match step.action {
        "hob_w" => None,
        "cool" => Some("cloth"),
        "move_pan" => Some("pan"),
        action if action.ends_with("_g") => Some(action.trim_end_matches("_g")),
        action => Some(action),
    }
}

fn number(value: &serde_json::Value) -> String {
    value.as_f64().map_or_else(|| value.to_string(), |v| format!("{v}"))
}

/// Returns the range of a class of doneness, as `50–60 °C`.
pub fn class_range(scale: &Scale, place: usize) -> String {
    let from = scale.class.get(place).map_or(0.0, |c| c.from_c);
    match (place, scale.end_c(place)) {
        (0, Some(end)) => format!("< {end} °C"),
        (_, Some(end)) => format!("{from}–{end} °C"),
        (_, None) => format!("> {from} °C"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_action_on_a_food_names_its_food() {
        for action in ["put", "flip", "rest", "halve", "press", "move"] {
            let (target, foods) = (Some("steak".to_owned()), vec!["steak".to_owned()]);
            let record = StepRecord { time_s: 1.0, action, target, foods, value: serde_json::Value::Null };
            assert!(step(&record).starts_with(&format!("{action} steak")), "{}", step(&record));
        }
    }
}
