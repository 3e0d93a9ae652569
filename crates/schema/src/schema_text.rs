//! What a JSON Schema states about a key: kind, range, choices, meaning and example.

use serde_json::Value;
use toml::de::DeValue;

use crate::number_text::number_text;

/// Kind of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A text.
    Text,
    /// A number, with or without a fraction.
    Number,
    /// A whole number.
    Integer,
    /// True or false.
    Flag,
    /// A date, which no format has.
    Date,
    /// A list.
    List,
    /// A table.
    Table,
    /// Anything: the schema states nothing.
    Any,
}

impl Kind {
    /// Returns the name with its article, for messages.
    pub fn name(self) -> &'static str {
        match self {
            Self::Text => "a text",
            Self::Number => "a number",
            Self::Integer => "a whole number",
            Self::Flag => "true or false",
            Self::Date => "a date",
            Self::List => "a list",
            Self::Table => "a table",
            Self::Any => "a value",
        }
    }
}

impl Kind {
    /// Returns true if a value of a kind will do where this kind is required.
    pub fn takes(self, value: &DeValue) -> bool {
        self == Self::Any || self == kind_of(value) || (self == Self::Integer && matches!(value, DeValue::Integer(_)))
    }
}

/// Returns the kind of a TOML value.
pub fn kind_of(value: &DeValue) -> Kind {
    match value {
        DeValue::String(_) => Kind::Text,
        DeValue::Integer(_) | DeValue::Float(_) => Kind::Number,
        DeValue::Boolean(_) => Kind::Flag,
        DeValue::Datetime(_) => Kind::Date,
        DeValue::Array(_) => Kind::List,
        DeValue::Table(_) => Kind::Table,
    }
}

/// Returns the alternative of an optional value that is not null.
pub fn resolved(schema: &Value) -> &Value {
    let real = schema["anyOf"].as_array().and_then(|all| all.iter().find(|s| s["type"] != "null"));
    real.map_or(schema, resolved)
}

/// Returns what a value may be: the alternatives of a schema that are not null, or the schema itself.
pub fn alternatives(schema: &Value) -> Vec<&Value> {
    match schema["anyOf"].as_array() {
        Some(all) => all.iter().filter(|s| s["type"] != "null").flat_map(alternatives).collect(),
        None => vec![schema],
    }
}

/// Returns the kind that a schema requires.
pub fn kind(schema: &Value) -> Kind {
    let named = |name: &str| match name {
        "string" => Some(Kind::Text),
        "number" => Some(Kind::Number),
        "integer" => Some(Kind::Integer),
        "boolean" => Some(Kind::Flag),
        "array" => Some(Kind::List),
        "object" => Some(Kind::Table),
        _ => None,
    };
    let kind = match &schema["type"] {
        Value::String(name) => named(name),
        Value::Array(names) => names.iter().filter_map(Value::as_str).find_map(named),
        _ => None,
    };
    kind.unwrap_or(if choices(schema).is_empty() { Kind::Any } else { Kind::Text })
}

/// Returns the smallest and the largest number that a schema allows; infinite without a bound.
pub fn bounds(schema: &Value) -> (f64, f64) {
    let bound = |key: &str| schema[key].as_f64();
    (bound("minimum").unwrap_or(f64::NEG_INFINITY), bound("maximum").unwrap_or(f64::INFINITY))
}

/// Returns what to write instead of a number outside a range.
pub fn range_remedy(low: f64, high: f64, in_list: bool) -> String {
    let values = if in_list && low.is_finite() && high.is_finite() { "numbers from " } else { "" };
    format!("use {values}{}", range_text(low, high))
}

/// Returns a range in words.
pub fn range_text(low: f64, high: f64) -> String {
    match (low.is_finite(), high.is_finite()) {
        (true, true) => format!("{} to {}", number_text(low), number_text(high)),
        (true, false) => format!("{} or more", number_text(low)),
        (false, true) => format!("{} or less", number_text(high)),
        (false, false) => "a finite number".to_owned(),
    }
}

/// Returns the texts that a schema allows; none if it allows every text.
pub fn choices(schema: &Value) -> Vec<&str> {
    let listed = schema["enum"].as_array().into_iter().flatten();
    let alternatives = schema["oneOf"].as_array().into_iter().flatten();
    let grouped = alternatives.flat_map(|s| {
        let more = s["enum"].as_array().into_iter().flatten();
        s.get("const").into_iter().chain(more)
    });
    listed.chain(grouped).filter_map(Value::as_str).collect()
}

/// Returns the description of a key as it is written.
pub fn description(schema: &Value) -> Option<&str> {
    schema["description"].as_str().or_else(|| resolved(schema)["description"].as_str())
}

/// Returns what a key means, as part of a sentence.
pub fn meaning(schema: &Value) -> String {
    let text = description(schema).unwrap_or("see its format").replace('\n', " ");
    let text = text.trim_end_matches('.');
    let mut letters = text.chars();
    match (letters.next(), letters.next()) {
        // An abbreviation or a symbol keeps its capital.
        (Some(first), Some(second)) if second.is_lowercase() || second == ' ' => {
            first.to_lowercase().chain([second]).chain(letters).collect()
        }
        _ => text.to_owned(),
    }
}

/// Returns a line that could set a key.
pub fn example(key: &str, schema: &Value) -> String {
    let value = stated_example(schema).map_or_else(|| stand_in(resolved(schema)), toml_text);
    format!("{key} = {value}")
}

/// Returns the example of a key, else its default; none if the schema states neither.
pub fn stated_example(schema: &Value) -> Option<&Value> {
    let given = [schema, resolved(schema)].into_iter().find_map(|s| s["examples"].get(0));
    given.or_else(|| default(schema))
}

/// Returns what a schema itself states to write instead of what it refuses.
pub fn stated_remedy(schema: &Value) -> Option<&str> {
    schema["x-remedy"].as_str()
}

/// Returns the default of a key.
pub fn default(schema: &Value) -> Option<&Value> {
    [schema, resolved(schema)].into_iter().find_map(|s| s.get("default").filter(|d| !d.is_null()))
}

/// Returns a value of the right kind for a key without an example.
fn stand_in(schema: &Value) -> String {
    match kind(schema) {
        Kind::Text => format!("\"{}\"", choices(schema).first().unwrap_or(&"…")),
        Kind::Number | Kind::Integer => match bounds(schema) {
            (low, _) if low.is_finite() => number_text(low),
            (_, high) if high.is_finite() => number_text(high),
            _ => "1.0".to_owned(),
        },
        Kind::Flag => "true".to_owned(),
        Kind::List => format!("[{}, …]", stand_in(resolved(&schema["items"]))),
        Kind::Table | Kind::Date | Kind::Any => "{ … }".to_owned(),
    }
}

/// Returns the lines that set the required keys of a table.
pub fn required_examples(table: &Value) -> Vec<String> {
    let required = table["required"].as_array().into_iter().flatten().filter_map(Value::as_str);
    required.map(|key| example(key, &table["properties"][key])).collect()
}

/// Returns a JSON value as TOML.
pub fn toml_text(value: &Value) -> String {
    match value {
        Value::Array(items) => format!("[{}]", items.iter().map(toml_text).collect::<Vec<_>>().join(", ")),
        Value::Object(entries) if entries.is_empty() => "{}".to_owned(),
        Value::Object(entries) => {
            let pairs: Vec<String> = entries.iter().map(|(k, v)| format!("{k} = {}", toml_text(v))).collect();
            format!("{{ {} }}", pairs.join(", "))
        }
        other => other.to_string(),
    }
}
