//! Reference page of a file format: Markdown from its JSON Schema.

use serde_json::Value;

use crate::schema_text::{Kind, bounds, choices, default, description, kind, range_text, stated_example, toml_text};

/// Place of a name that the writer of a file chooses.
const ANY_NAME: &str = "<name>";
/// Head of a table of keys.
const HEAD: &str = "| Key | Meaning | Range | Default | Example |\n|---|---|---|---|---|\n";

/// A table of a format.
struct Section<'a> {
    /// Keys that lead to it, separated by dots; empty at the top of the file.
    path: String,
    /// True if it may be repeated.
    in_list: bool,
    schema: &'a Value,
}

/// All tables of a format; tables with equal keys are listed once.
pub(crate) struct FormatPage<'a> {
    root: &'a Value,
    sections: Vec<Section<'a>>,
}

impl<'a> FormatPage<'a> {
    /// Collects the tables of a schema without references.
    pub(crate) fn over(root: &'a Value) -> Self {
        let mut page = Self { root, sections: Vec::new() };
        page.add(Section { path: String::new(), in_list: false, schema: root });
        page
    }

    /// Returns the page.
    pub(crate) fn markdown(&self) -> String {
        let title = self.root["title"].as_str().unwrap_or_default().trim_start_matches("saute ");
        let mut page = format!("# The {title} format\n");
        for section in &self.sections {
            page += &self.section(section);
        }
        page
    }

    /// Adds a table and the tables in it, depth first. A table that is in several places is listed where its path is shortest.
    fn add(&mut self, section: Section<'a>) {
        let depth = |path: &str| path.split('.').count();
        if let Some(known) = self.sections.iter().position(|s| same_keys(s.schema, section.schema)) {
            if depth(&section.path) >= depth(&self.sections[known].path) {
                return;
            }
            self.sections.remove(known);
        }
        let (path, schema) = (section.path.clone(), section.schema);
        self.sections.push(section);
        for (key, of) in members(schema) {
            let path = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
            for inner in tables(&path, of, false) {
                self.add(inner);
            }
        }
    }

    /// Returns the section that lists the keys of a table.
    fn section_of(&self, table: &Value) -> Option<&Section<'a>> {
        self.sections.iter().find(|s| same_keys(s.schema, table))
    }

    fn section(&self, section: &Section) -> String {
        let heading = if section.path.is_empty() { "Top of the file".to_owned() } else { section.name() };
        let about = description(section.schema).map(|text| format!("{}\n\n", prose(text))).unwrap_or_default();
        let is_required =
            |key: &str| section.schema["required"].as_array().is_some_and(|all| all.iter().any(|k| k == key));
        let mut rows: Vec<_> = members(section.schema).map(|(key, of)| (is_required(key), key, of)).collect();
        rows.sort_by_key(|(required, ..)| !required);
        let rows: String = rows.into_iter().map(|(required, key, of)| self.row(key, of, required)).collect();
        format!("\n## {heading}\n\n{about}{HEAD}{rows}")
    }

    fn row(&self, key: &str, schema: &Value, required: bool) -> String {
        let line = |value: &Value| code(&format!("{key} = {}", toml_text(value)));
        let default = match default(schema) {
            _ if required => "**required**".to_owned(),
            value => value.map(|v| code(&toml_text(v))).unwrap_or_default(),
        };
        let cells = [
            code(key),
            description(schema).map(prose).unwrap_or_default(),
            self.range(schema),
            default,
            stated_example(schema).map(line).unwrap_or_default(),
        ];
        format!("| {} |\n", cells.map(|cell| cell.replace('|', "\\|")).join(" | "))
    }

    /// Returns the values that a schema allows, in words.
    fn range(&self, schema: &Value) -> String {
        let mut alternatives: Vec<String> = Vec::new();
        for form in forms(schema) {
            let text = self.form(form);
            if !alternatives.contains(&text) {
                alternatives.push(text);
            }
        }
        alternatives.join(" or ")
    }

    fn form(&self, schema: &Value) -> String {
        let words = choices(schema);
        if !words.is_empty() {
            return words.iter().map(|word| code(&format!("\"{word}\""))).collect::<Vec<_>>().join(", ");
        }
        let (low, high) = bounds(schema);
        match kind(schema) {
            Kind::Text => "text".to_owned(),
            Kind::Number => range_text(low, high),
            Kind::Integer => format!("whole number, {}", range_text(low, high)),
            Kind::Flag => "`true`, `false`".to_owned(),
            Kind::List => self.list(schema),
            Kind::Table => self.table(schema),
            Kind::Date | Kind::Any => "any value".to_owned(),
        }
    }

    fn list(&self, schema: &Value) -> String {
        if let Some(items) = schema["prefixItems"].as_array() {
            let items: Vec<String> = items.iter().map(|item| self.range(item)).collect();
            return format!("list of {}: {}", items.len(), items.join("; "));
        }
        let items = self.range(&schema["items"]);
        match (schema["minItems"].as_u64(), schema["maxItems"].as_u64()) {
            (Some(least), Some(most)) if least == most => format!("list of {least}: {items}"),
            (Some(least), Some(most)) => format!("list of {least} to {most}: {items}"),
            (Some(least), None) => format!("list of {least} or more: {items}"),
            (None, Some(most)) => format!("list of at most {most}: {items}"),
            (None, None) => format!("list: {items}"),
        }
    }

    fn table(&self, schema: &Value) -> String {
        if schema["additionalProperties"].is_object() {
            return format!("table of names, each with {}", self.range(&schema["additionalProperties"]));
        }
        self.section_of(schema).map_or_else(|| "table".to_owned(), Section::link)
    }
}

impl Section<'_> {
    /// Returns the head of the table as a file has it.
    fn name(&self) -> String {
        code(&if self.in_list { format!("[[{}]]", self.path) } else { format!("[{}]", self.path) })
    }

    /// Returns a link to the section; renderers name a heading by its letters, digits, `_` and `-`.
    fn link(&self) -> String {
        let anchor = self.path.chars().filter(|c| c.is_alphanumeric() || matches!(c, '_' | '-'));
        format!("table [{}](#{})", self.name(), anchor.collect::<String>().to_lowercase())
    }
}

/// Returns true if two tables have the same keys.
fn same_keys(a: &Value, b: &Value) -> bool {
    ["properties", "required"].iter().all(|part| a[part] == b[part])
}

/// Returns the keys of a table.
fn members(table: &Value) -> impl Iterator<Item = (&String, &Value)> {
    table["properties"].as_object().into_iter().flatten()
}

/// Returns the alternatives of a value, without null.
fn forms(schema: &Value) -> Vec<&Value> {
    let single = schema["properties"].is_object() || !choices(schema).is_empty();
    match ["anyOf", "oneOf"].iter().find_map(|key| schema[key].as_array()) {
        Some(all) if !single => all.iter().filter(|s| s["type"] != "null").flat_map(forms).collect(),
        _ => vec![schema],
    }
}

/// Returns the tables that a value may be or contain.
fn tables<'a>(path: &str, schema: &'a Value, in_list: bool) -> Vec<Section<'a>> {
    let inside = |form: &'a Value| match kind(form) {
        Kind::Table if form["properties"].is_object() => vec![Section { path: path.to_owned(), in_list, schema: form }],
        Kind::Table => tables(&format!("{path}.{ANY_NAME}"), &form["additionalProperties"], false),
        Kind::List => tables(path, &form["items"], true),
        _ => Vec::new(),
    };
    forms(schema).into_iter().flat_map(inside).collect()
}

/// Returns a description on one line, with its asterisks as they are.
fn prose(text: &str) -> String {
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ").replace('*', "\\*");
    if text.ends_with(['.', '!', '?']) { text } else { text + "." }
}

fn code(text: &str) -> String {
    format!("`{text}`")
}
