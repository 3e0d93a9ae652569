//! Compares a parsed TOML document with a JSON Schema.

use serde_json::Value;
use toml::Spanned;
use toml::de::{DeArray, DeFloat, DeInteger, DeTable, DeValue};

use crate::finding::Finding;
use crate::library_error::line_of;
use crate::nearest::nearest;
use crate::number_text::number_text;
use crate::schema_text::{self, Kind};

/// A walk over a document, which collects what the schema refuses.
pub(crate) struct SchemaWalk<'a> {
    text: &'a str,
    /// Name of the format in messages.
    format: &'a str,
    findings: Vec<Finding>,
}

/// Place of a value: its path from the top, as `ridges.width_mm`, and its line.
#[derive(Clone, Copy)]
struct At<'a> {
    path: &'a str,
    line: usize,
    in_list: bool,
}

impl At<'_> {
    fn key(&self) -> &str {
        self.path.rsplit('.').next().unwrap_or_default()
    }

    fn inner(&self, name: &str) -> String {
        if self.path.is_empty() { name.to_owned() } else { format!("{}.{name}", self.path) }
    }
}

impl<'a> SchemaWalk<'a> {
    /// Returns what the schema refuses, in the order of the keys.
    pub(crate) fn over(schema: &'a Value, text: &'a str, top: &DeTable) -> Vec<Finding> {
        let format = schema["title"].as_str().unwrap_or_default().trim_start_matches("saute ");
        let mut walk = Self { text, format, findings: Vec::new() };
        walk.table(At { path: "", line: 1, in_list: false }, schema, top);
        walk.findings
    }

    fn find(&mut self, at: At, message: String, remedy: impl Into<String>) {
        self.findings.push(Finding::new(at.line, at.key(), message, remedy));
    }

    fn table(&mut self, at: At, schema: &Value, entries: &DeTable) {
        // A misspelt key explains why the right one is missing: that is one finding.
        let mut misspelt = Vec::new();
        for (name, value) in entries {
            let path = at.inner(name.get_ref());
            let inner = At { path: &path, line: line_of(self.text, name.span().start), in_list: false };
            match schema["properties"].get(name.get_ref().as_ref()) {
                Some(known) => self.value(inner, known, value),
                None if schema["additionalProperties"].is_object() => {
                    self.value(inner, &schema["additionalProperties"], value);
                }
                None => misspelt.extend(self.unknown(inner, schema)),
            }
        }
        for name in schema["required"].as_array().into_iter().flatten().filter_map(Value::as_str) {
            if !entries.contains_key(name) && !misspelt.contains(&name) {
                let path = at.inner(name);
                self.missing(At { path: &path, ..at }, &schema["properties"][name]);
            }
        }
    }

    /// Reports an unknown key; returns the known key that it resembles.
    fn unknown<'s>(&mut self, at: At, schema: &'s Value) -> Option<&'s str> {
        let known: Vec<&str> =
            schema["properties"].as_object().into_iter().flatten().map(|(k, _)| k.as_str()).collect();
        let near = nearest(at.key(), known.iter().copied());
        let remedy = match near {
            Some(near) => format!("write {near}"),
            None => schema_text::stated_remedy(schema)
                .map_or_else(|| format!("leave it out; there are: {}", known.join(", ")), str::to_owned),
        };
        self.find(at, format!("{} is no key of the {} format", at.path, self.format), remedy);
        near
    }

    fn missing(&mut self, at: At, schema: &Value) {
        let resolved = schema_text::resolved(schema);
        let meaning = schema_text::meaning(schema);
        if resolved["properties"].is_object() || resolved["additionalProperties"].is_object() {
            let line = self.text.lines().count().max(1);
            let keys = schema_text::required_examples(resolved).join(", ");
            let message = format!("[{}] is missing: {meaning}", at.path);
            let remedy = if keys.is_empty() {
                format!("write [{}]", at.path)
            } else {
                format!("write [{}] with {keys}", at.path)
            };
            self.find(At { line, ..at }, message, remedy);
        } else {
            let remedy = format!("write {}", schema_text::example(at.key(), schema));
            self.find(at, format!("{} is missing: {meaning}", at.path), remedy);
        }
    }

    fn value(&mut self, at: At, schema: &Value, value: &Spanned<DeValue>) {
        let all = schema_text::alternatives(schema);
        let Some(fitting) = all.iter().find(|s| schema_text::kind(s).takes(value.get_ref())) else {
            return self.mistyped(at, schema, &all, schema_text::kind_of(value.get_ref()));
        };
        match (schema_text::kind(fitting), value.get_ref()) {
            (Kind::Table, DeValue::Table(entries)) => self.table(at, fitting, entries),
            (Kind::List, DeValue::Array(items)) => self.list(at, fitting, items),
            (Kind::Number, DeValue::Float(number)) => self.number(at, fitting, float(number)),
            (Kind::Number | Kind::Integer, DeValue::Integer(number)) => self.number(at, fitting, integer(number)),
            (Kind::Text, DeValue::String(text)) => self.choice(at, fitting, text),
            _ => {}
        }
    }

    fn mistyped(&mut self, at: At, schema: &Value, all: &[&Value], found: Kind) {
        let meaning = schema_text::meaning(schema);
        let mut wanted: Vec<&str> = all.iter().map(|s| schema_text::kind(s).name()).collect();
        wanted.dedup();
        let message = format!("{} is {} and must be {}: {meaning}", at.path, found.name(), wanted.join(" or "));
        let remedy = if let Some(stated) = schema_text::stated_remedy(schema) {
            stated.to_owned()
        } else if schema_text::resolved(schema)["properties"].is_object() {
            format!("write [{}] and its keys below it", at.path)
        } else {
            format!("write, for instance, {}", schema_text::example(at.key(), schema))
        };
        self.find(at, message, remedy);
    }

    fn list(&mut self, at: At, schema: &Value, items: &DeArray) {
        if schema["prefixItems"].is_array() {
            self.tuple(at, schema, items);
            return;
        }
        let count = items.len();
        let bound = |key: &str| schema[key].as_u64().map(|n| n as usize);
        let (least, most) = (bound("minItems").unwrap_or(0), bound("maxItems"));
        if count < least || most.is_some_and(|most| count > most) {
            let wanted = match most {
                Some(most) if most == least => least.to_string(),
                Some(most) => format!("{least} to {most}"),
                None => format!("{least} or more"),
            };
            let remedy = schema_text::stated_remedy(schema).map_or_else(|| format!("write {wanted}"), str::to_owned);
            self.find(at, format!("{} has {count} entries", at.path), remedy);
        }
        for item in items.iter() {
            self.value(At { line: line_of(self.text, item.span().start), in_list: true, ..at }, &schema["items"], item);
        }
    }

    /// Checks a list with a range for each place, such as a colour.
    fn tuple(&mut self, at: At, schema: &Value, items: &DeArray) {
        let places = schema["prefixItems"].as_array().map_or(&[][..], Vec::as_slice);
        let values: Vec<Option<f64>> = items.iter().map(|item| finite(item.get_ref())).collect();
        let within = |(value, place): (&Option<f64>, &Value)| {
            let (low, high) = schema_text::bounds(place);
            value.is_some_and(|v| (low..=high).contains(&v))
        };
        if values.len() != places.len() || !values.iter().zip(places).all(within) {
            let shown: Vec<String> =
                values.iter().map(|v| v.map_or_else(|| "?".to_owned(), |v| format!("{v:?}"))).collect();
            let noun = schema["title"].as_str().unwrap_or("list of the right form");
            let remedy = schema_text::stated_remedy(schema).unwrap_or("use the range of each place");
            self.find(at, format!("{} = [{}] is no {noun}", at.path, shown.join(", ")), remedy);
        }
    }

    fn number(&mut self, at: At, schema: &Value, value: f64) {
        let (low, high) = schema_text::bounds(schema);
        if !value.is_finite() {
            let message = format!("{} = {value} is no finite number", at.path);
            self.find(at, message, schema_text::range_remedy(low, high, at.in_list));
        } else if !(low..=high).contains(&value) {
            let message = format!("{} = {} is out of range", at.path, number_text(value));
            self.find(at, message, schema_text::range_remedy(low, high, at.in_list));
        }
    }

    fn choice(&mut self, at: At, schema: &Value, text: &str) {
        let choices = schema_text::choices(schema);
        if !choices.is_empty() && !choices.contains(&text) {
            let remedy = match nearest(text, choices.iter().copied()) {
                Some(near) => format!("write \"{near}\"; there are: {}", choices.join(", ")),
                None => format!("use one of: {}", choices.join(", ")),
            };
            self.find(at, format!("{} = \"{text}\" is unknown", at.path), remedy);
        }
    }
}

/// Returns the number of a value; not-a-number if it does not fit.
fn float(number: &DeFloat) -> f64 {
    number.as_str().parse().unwrap_or(f64::NAN)
}

fn integer(number: &DeInteger) -> f64 {
    i64::from_str_radix(number.as_str(), number.radix()).map_or(f64::NAN, |v| v as f64)
}

/// Returns a value that is a finite number.
fn finite(value: &DeValue) -> Option<f64> {
    let number = match value {
        DeValue::Float(number) => float(number),
        DeValue::Integer(number) => integer(number),
        _ => return None,
    };
    number.is_finite().then_some(number)
}
