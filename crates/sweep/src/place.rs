//! A path such as `food.steak.size_mm[2]`: the document that it leads into and the way to the value there.

use serde_json::Value as Json;
use toml::Value;

use crate::documents::{self, Documents, FOLDERS, SINGLE};
use saute_schema::nearest;

/// Which text a path leads into.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Document {
    /// The recipe.
    Recipe,
    /// A data file by path, as `kinetics/beef.toml`.
    Data(String),
}

/// One step on the way to a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Step {
    /// Into the entry of a table.
    Key(String),
    /// Into an item of a list, from 0.
    Item(usize),
}

/// Where a value is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Place {
    pub(crate) document: Document,
    pub(crate) steps: Vec<Step>,
    /// True if the value there is a whole number.
    pub(crate) is_whole: bool,
}

/// Why a path leads nowhere, and what to write instead.
pub(crate) type Lost = (String, String);

impl Place {
    /// Finds the place that a path names.
    pub(crate) fn find(path: &str, documents: &Documents) -> Result<Self, Lost> {
        let parts = split(path).ok_or_else(|| {
            (
                format!("\"{path}\" is not a path"),
                "write keys with dots, and items as [0]: food.steak.size_mm[2]".to_owned(),
            )
        })?;
        let (document, rest) = document(path, &parts, documents)?;
        let table = documents.table(&document).ok_or_else(|| {
            (format!("\"{path}\" leads into a file that is not TOML"), "correct that file".to_owned())
        })?;
        let mut walk =
            Walk { path, at: Some(Value::Table(table)), schema: documents::schema(&document), steps: Vec::new() };
        for step in rest {
            walk.take(step)?;
        }
        if matches!(walk.at, Some(Value::Table(_) | Value::Array(_))) {
            let more = walk.names().join(", ");
            return Err((format!("\"{path}\" is not a single value"), format!("name one of its values: {more}")));
        }
        let is_whole = documents::is_whole(&walk.schema);
        Ok(Self { document, steps: walk.steps, is_whole })
    }
}

/// Splits a path at its dots and brackets; none if it is not well formed.
fn split(path: &str) -> Option<Vec<Step>> {
    let mut steps = Vec::new();
    for part in path.split('.') {
        let (key, items) = part.find('[').map_or((part, ""), |at| part.split_at(at));
        if key.is_empty() {
            return None;
        }
        steps.push(Step::Key(key.to_owned()));
        let mut rest = items;
        while !rest.is_empty() {
            let (index, after) = rest.strip_prefix('[')?.split_once(']')?;
            steps.push(Step::Item(index.parse().ok()?));
            rest = after;
        }
    }
    Some(steps)
}

/// Returns the document of a path and the rest of the path; that of a recipe begins at its top.
fn document<'a>(path: &str, steps: &'a [Step], documents: &Documents) -> Result<(Document, &'a [Step]), Lost> {
    let key = |at: usize| if let Some(Step::Key(key)) = steps.get(at) { key.as_str() } else { "" };
    let first = key(0);
    if FOLDERS.contains(&first) {
        let ids = documents.ids(first);
        if !ids.iter().any(|id| id == key(1)) {
            return Err(unknown(path, key(1), &ids));
        }
        return Ok((Document::Data(format!("{first}/{}.toml", key(1))), &steps[2..]));
    }
    if SINGLE.contains(&first) {
        return Ok((Document::Data(format!("{first}.toml")), &steps[1..]));
    }
    let roots = documents.roots();
    if roots.iter().any(|root| root == first) {
        Ok((Document::Recipe, steps))
    } else {
        Err(unknown(path, first, &roots))
    }
}

/// Returns what is wrong with a name that is not known.
fn unknown(path: &str, name: &str, known: &[String]) -> Lost {
    let message = if name.is_empty() {
        format!("\"{path}\" ends too early")
    } else {
        format!("\"{path}\" leads nowhere: {name} is unknown")
    };
    let remedy = match nearest(name, known.iter().map(String::as_str)) {
        Some(near) => format!("write {near}"),
        None => format!("there are: {}", known.join(", ")),
    };
    (message, remedy)
}

/// A walk along a path, through a document and its schema.
struct Walk<'a> {
    path: &'a str,
    /// Value here; none where the document leaves out an optional key.
    at: Option<Value>,
    schema: Json,
    steps: Vec<Step>,
}

impl Walk<'_> {
    fn take(&mut self, step: &Step) -> Result<(), Lost> {
        match (step, self.at.take()) {
            // Foods of a recipe and scales of doneness are named by their ids.
            (Step::Key(id), Some(Value::Array(items))) => {
                let ids: Vec<String> = items.iter().filter_map(|i| i.get("id")?.as_str().map(str::to_owned)).collect();
                let index = ids.iter().position(|known| known == id).ok_or_else(|| unknown(self.path, id, &ids))?;
                self.item(index, items)
            }
            (Step::Item(index), Some(Value::Array(items))) => self.item(*index, items),
            (Step::Key(key), at) => self.key(key, at),
            (Step::Item(index), None) => Err((
                format!("\"{}\" leads nowhere: there is no list to take [{index}] of", self.path),
                "write the list into the file first".to_owned(),
            )),
            (Step::Item(index), Some(_)) => Err((
                format!("\"{}\" leads nowhere: [{index}] follows what is no list", self.path),
                "leave it out".to_owned(),
            )),
        }
    }

    fn item(&mut self, index: usize, mut items: Vec<Value>) -> Result<(), Lost> {
        if index >= items.len() {
            let message = format!("\"{}\" leads nowhere: there is no item [{index}]", self.path);
            let last = items.len().saturating_sub(1);
            return Err((message, format!("items are numbered from 0; write [0] to [{last}]")));
        }
        self.steps.push(Step::Item(index));
        self.schema = documents::of_item(&self.schema);
        self.at = Some(items.swap_remove(index));
        Ok(())
    }

    fn key(&mut self, key: &str, at: Option<Value>) -> Result<(), Lost> {
        let mut known = documents::keys(&self.schema);
        let entry = match at {
            Some(Value::Table(mut entries)) => {
                known.extend(entries.keys().cloned());
                entries.remove(key)
            }
            Some(_) => {
                let message = format!("\"{}\" leads nowhere: {key} follows a single value", self.path);
                return Err((message, "end the path before it".to_owned()));
            }
            None => None,
        };
        if entry.is_none() && !known.iter().any(|name| name == key) {
            known.sort();
            known.dedup();
            return Err(unknown(self.path, key, &known));
        }
        self.steps.push(Step::Key(key.to_owned()));
        self.schema = documents::of_key(&self.schema, key);
        self.at = entry;
        Ok(())
    }

    /// Returns the names of what is here.
    fn names(&self) -> Vec<String> {
        match &self.at {
            Some(Value::Table(entries)) => entries.keys().map(|key| format!("{}.{key}", self.path)).collect(),
            Some(Value::Array(items)) => {
                let name = |(i, item): (usize, &Value)| match item.get("id").and_then(Value::as_str) {
                    Some(id) => format!("{}.{id}", self.path),
                    None => format!("{}[{i}]", self.path),
                };
                items.iter().enumerate().map(name).collect()
            }
            _ => Vec::new(),
        }
    }
}
