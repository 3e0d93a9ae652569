//! Whether a food file has the keys that it needs, and no others.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::Finding;
use super::keys::{Key, OTHER_TABLES, REQUIRED_TABLES, keys_of, meaning_of};
use crate::data::library::line_of;

/// Tables that every form but "mesh" needs as well.
const SHAPED_TABLES: [&str; 2] = ["size", "outline"];

/// What is wrong with the layout of a food file.
pub fn findings(text: &str) -> Vec<Finding> {
    let (document, errors) = DeTable::parse_recoverable(text);
    if !errors.is_empty() {
        let finding = |e: &toml::de::Error| {
            let line = line_of(text, e.span().map_or(0, |s| s.start));
            Finding::new(line, "", e.message().trim().to_owned(), "write it as TOML: key = value, text in \"quotes\"")
        };
        let mut findings: Vec<Finding> = errors.iter().map(finding).collect();
        findings.sort_by_key(|f| f.line);
        return findings;
    }
    let top = document.get_ref();
    let mut layout = Layout { text, findings: Vec::new() };
    layout.table("", 1, top);
    let is_mesh = top.get("form").and_then(|v| v.get_ref().as_str()) == Some("mesh");
    let shaped: &[&str] = if is_mesh { &["mesh"] } else { &SHAPED_TABLES };
    for table in REQUIRED_TABLES.iter().chain(shaped).filter(|t| !top.contains_key(**t)) {
        let example: Vec<&str> = keys_of(table).iter().map(|k| k.example).collect();
        let message = format!("[{table}] is missing: {}", meaning_of(table));
        layout.findings.push(Finding::new(
            last_line(text),
            table,
            message,
            format!("write [{table}] with {}", example.join(", ")),
        ));
    }
    layout.findings.sort_by_key(|f| f.line);
    layout.findings
}

fn last_line(text: &str) -> usize {
    text.lines().count().max(1)
}

struct Layout<'a> {
    text: &'a str,
    findings: Vec<Finding>,
}

impl Layout<'_> {
    /// Checks a table's keys against those that it may have.
    fn table(&mut self, table: &'static str, line: usize, entries: &DeTable) {
        let keys = keys_of(table);
        for (name, value) in entries {
            let at = line_of(self.text, name.span().start);
            match keys.iter().find(|k| k.name == name.get_ref()) {
                Some(key) => self.value(key, at, value),
                None => self.inner(table, name.get_ref(), at, value),
            }
        }
        for key in keys.iter().filter(|k| k.required && !entries.contains_key(k.name)) {
            let message = format!("{} is missing: {}", path(table, key.name), key.meaning);
            self.findings.push(Finding::new(line, key.name, message, format!("write {}", key.example)));
        }
    }

    /// A key that is no value: a table, or unknown.
    fn inner(&mut self, table: &str, name: &str, line: usize, value: &Spanned<DeValue>) {
        let full = path(table, name);
        let known = REQUIRED_TABLES.into_iter().chain(OTHER_TABLES).find(|t| *t == full);
        match (known, value.get_ref()) {
            (Some(known), DeValue::Table(entries)) => self.table(known, line, entries),
            (Some(known), _) => {
                let message = format!("{known} is a table: {}", meaning_of(known));
                self.findings.push(Finding::new(line, name, message, format!("write [{known}] and its keys below it")));
            }
            _ => self.unknown(table, name, line),
        }
    }

    fn unknown(&mut self, table: &str, name: &str, line: usize) {
        let tables = REQUIRED_TABLES.into_iter().chain(OTHER_TABLES);
        let depth = if table.is_empty() { 0 } else { table.len() + 1 };
        let below = tables.filter(|t| t.len() > depth && t.starts_with(table) && !t[depth..].contains('.'));
        let mut known: Vec<&str> =
            below.filter(|t| depth == 0 || t.as_bytes()[depth - 1] == b'.').map(|t| &t[depth..]).collect();
        let keys = keys_of(table);
        known.extend(keys.iter().map(|k| k.name));
        let remedy = match nearest(name, &known) {
            Some(near) => format!("write {near}"),
            None => format!("leave it out; there are: {}", known.join(", ")),
        };
        self.findings.push(Finding::new(line, name, format!("{} is no key of a food", path(table, name)), remedy));
    }

    /// Whether a value is of the kind that its key wants.
    fn value(&mut self, key: &Key, line: usize, value: &Spanned<DeValue>) {
        let example = DeTable::parse(key.example).ok();
        let wanted = example.as_ref().and_then(|e| e.get_ref().get(key.name)).map(|v| kind(v.get_ref()));
        let found = kind(value.get_ref());
        if wanted.is_some_and(|w| w != found) {
            let wanted = wanted.unwrap_or_default();
            let message = format!("{} is {found} and must be {wanted}: {}", path(key.table, key.name), key.meaning);
            self.findings.push(Finding::new(line, key.name, message, format!("write, for instance, {}", key.example)));
        }
    }
}

fn path(table: &str, name: &str) -> String {
    if table.is_empty() { name.to_owned() } else { format!("{table}.{name}") }
}

fn kind(value: &DeValue) -> &'static str {
    match value {
        DeValue::String(_) => "a text",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}

/// Returns the known name with the smallest Levenshtein distance to another name, if the distance is small.
fn nearest<'a>(name: &str, known: &[&'a str]) -> Option<&'a str> {
    let near = known.iter().map(|k| (strsim::levenshtein(name, k), *k)).min()?;
    (near.0 <= 2.max(name.len() / 3)).then_some(near.1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::library::Library;

    fn shipped() -> Vec<(String, String)> {
        Library::embedded_files().into_iter().filter(|(path, _)| path.starts_with("foods/")).collect()
    }

    #[test]
    fn shipped_foods_have_the_keys_that_the_check_knows() {
        let foods = shipped();
        assert!(foods.len() >= 7);
        for (path, text) in foods {
            assert_eq!(findings(&text), Vec::new(), "{path}");
        }
    }

    /// Without a required key the program's own reader refuses the file too; without another one it does not.
    #[test]
    fn required_keys_are_those_without_which_no_food_is_read() {
        for (path, text) in shipped() {
            let whole: toml::Table = text.parse().expect("parses");
            for (table, entries) in whole.iter().filter_map(|(t, v)| Some((t, v.as_table()?))) {
                for key in keys_of(table).iter().filter(|k| entries.contains_key(k.name)) {
                    let mut less = whole.clone();
                    less[table].as_table_mut().expect("a table").remove(key.name);
                    let read = toml::from_str::<saute_food::FoodDescription>(&less.to_string());
                    assert_eq!(read.is_err(), key.required, "{path}: {table}.{}", key.name);
                }
            }
        }
    }

    #[test]
    fn misspelt_missing_and_mistyped_keys_are_told_with_their_line() {
        let (_, text) = shipped().into_iter().find(|(path, _)| path.ends_with("beef-lean.toml")).expect("is shipped");
        let wrong = text
            .replace("ripple =", "rippel =")
            .replace("emissivity = 0.95", "emissivity = \"wet\"")
            .replace("[crust]", "[crusts]");
        let found = findings(&wrong);
        let line = |part: &str| 1 + wrong.lines().position(|l| l.contains(part)).expect("is there");
        let about =
            |part: &str| found.iter().find(|f| f.message.contains(part)).unwrap_or_else(|| panic!("{part}: {found:?}"));
        let rippel = about("outline.rippel is no key");
        assert_eq!((rippel.line, rippel.remedy.as_str()), (line("rippel"), "write ripple"));
        assert!(about("outline.ripple is missing").remedy.contains("ripple = 0.02"));
        let wet = about("surface.emissivity is a text and must be a number");
        assert_eq!(wet.line, line("\"wet\""));
        assert_eq!(about("crusts is no key").remedy, "write crust");
        assert!(about("[crust] is missing: the dry crust").remedy.contains("conductivity_w_mk"));
    }

    #[test]
    fn every_mistake_of_writing_is_told() {
        let found = findings("name = \nform = steak\n[lean\n");
        assert!(found.len() >= 2 && found[0].line == 1, "{found:?}");
    }
}
