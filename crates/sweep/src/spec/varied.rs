//! One varied value: where it goes and which values it takes.

use saute_schema::{InputError, InputText};
use toml::Value;

use crate::design::DesignKind;
use crate::spec::spec_file::{RangeEntry, VaryEntry};

/// Most levels of a list or a range [-] (chosen: more are a range without `n`).
const MOST_LEVELS: i64 = 1_000_000;

/// The values that a path takes.
#[derive(Clone, Debug, PartialEq)]
pub enum Levels {
    /// These values.
    List(Vec<Value>),
    /// So many evenly spaced numbers of a range.
    Even {
        /// First.
        from: f64,
        /// Last.
        to: f64,
        /// How many.
        n: u64,
    },
    /// Every number of a range.
    Range {
        /// First.
        from: f64,
        /// Last.
        to: f64,
    },
}

impl Levels {
    /// Reads the value of a line of `[vary]`, whose text begins at `at`.
    pub(crate) fn read(
        input: InputText,
        at: usize,
        path: &str,
        value: &VaryEntry,
        kind: DesignKind,
    ) -> Result<Self, InputError> {
        match value {
            VaryEntry::Levels(items) => list(input, at, path, items),
            VaryEntry::Range(ends) => range(input, at, path, ends, kind),
        }
    }

    /// Returns the number of levels; 0 for a range of every number.
    pub fn count(&self) -> u64 {
        match self {
            Self::List(items) => items.len() as u64,
            Self::Even { n, .. } => *n,
            Self::Range { .. } => 0,
        }
    }

    /// Returns the value at a coordinate of 0 to 1.
    pub fn at(&self, coordinate: f64) -> Value {
        let level = |count: u64| ((coordinate * count as f64) as u64).min(count - 1);
        match self {
            Self::List(items) => items[level(items.len() as u64) as usize].clone(),
            Self::Even { from, to, n } => {
                let share = level(*n) as f64 / (n - 1) as f64;
                Value::Float(from + share * (to - from))
            }
            Self::Range { from, to } => Value::Float(from + coordinate * (to - from)),
        }
    }

    /// Returns the values to try: every one of a list, the ends of a range.
    pub(crate) fn samples(&self) -> Vec<Value> {
        match self {
            Self::List(items) => items.clone(),
            Self::Even { from, to, .. } | Self::Range { from, to } => vec![Value::Float(*from), Value::Float(*to)],
        }
    }
}

fn list(input: InputText, at: usize, path: &str, items: &[Value]) -> Result<Levels, InputError> {
    let is_number = |v: &Value| matches!(v, Value::Integer(_) | Value::Float(_));
    if items.is_empty() || items.len() as i64 > MOST_LEVELS {
        let message = format!("\"{path}\" has {} levels", items.len());
        return input.error(at, message, format!("write 1 to {MOST_LEVELS}, as \"{path}\" = [20, 40]"));
    }
    let alike = items.iter().all(is_number) || items.iter().all(Value::is_str) || items.iter().all(Value::is_bool);
    if !alike {
        let message = format!("the levels of \"{path}\" cannot be used");
        return input.error(at, message, "write numbers, texts or flags, all of one type");
    }
    if items.iter().any(|v| v.as_float().is_some_and(|v| !v.is_finite())) {
        return input.error(at, format!("a level of \"{path}\" is not finite"), "write a number");
    }
    let is_float = items.iter().any(Value::is_float);
    let number = |v: &Value| v.as_integer().filter(|_| is_float).map_or_else(|| v.clone(), |i| Value::Float(i as f64));
    Ok(Levels::List(items.iter().map(number).collect()))
}

fn range(input: InputText, at: usize, path: &str, ends: &RangeEntry, kind: DesignKind) -> Result<Levels, InputError> {
    let RangeEntry { from, to, n } = *ends;
    if !(to - from).is_finite() {
        return input.error(at, format!("the range \"{path}\" is too wide"), "write numbers that are closer");
    }
    match n {
        Some(n) => Ok(Levels::Even { from, to, n }),
        None if kind == DesignKind::Grid => {
            input.error(at, format!("the range \"{path}\" has no n"), "a grid needs levels: add n = 3, for instance")
        }
        None => Ok(Levels::Range { from, to }),
    }
}
