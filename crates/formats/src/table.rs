//! A table of typed columns with units.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// A value of a table.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub enum Value {
    /// A number.
    Float(f64),
    /// A whole number.
    Integer(i64),
    /// True or false.
    Flag(bool),
    /// A text.
    Text(String),
}

/// The type of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnKind {
    /// Numbers.
    Float,
    /// Whole numbers.
    Integer,
    /// True or false.
    Flag,
    /// Texts.
    Text,
}

impl Value {
    /// Returns the type of the value.
    pub fn kind(&self) -> ColumnKind {
        match self {
            Self::Float(_) => ColumnKind::Float,
            Self::Integer(_) => ColumnKind::Integer,
            Self::Flag(_) => ColumnKind::Flag,
            Self::Text(_) => ColumnKind::Text,
        }
    }

    /// Returns the value as a number; none for a text.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Float(v) => Some(*v),
            Self::Integer(v) => Some(*v as f64),
            Self::Flag(v) => Some(f64::from(u8::from(*v))),
            Self::Text(_) => None,
        }
    }

    /// Returns the value as the given kind of column; none if it is of another kind.
    pub fn to_kind(self, kind: ColumnKind) -> Option<Self> {
        match (self, kind) {
            (Self::Integer(v), ColumnKind::Float) => Some(Self::Float(v as f64)),
            (value, kind) => (value.kind() == kind).then_some(value),
        }
    }
}

/// Content of a column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Heading {
    /// Name.
    pub name: String,
    /// Unit, as `°C`; empty where there is none.
    pub unit: String,
    /// Type of the values.
    pub kind: ColumnKind,
}

impl Heading {
    /// Returns a heading.
    pub fn new(name: impl Into<String>, unit: impl Into<String>, kind: ColumnKind) -> Self {
        Self { name: name.into(), unit: unit.into(), kind }
    }
}

/// A table: typed columns with units, and notes about all of it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// Headings of the columns.
    pub headings: Vec<Heading>,
    /// Rows; each has a value or none for each heading.
    pub rows: Vec<Vec<Option<Value>>>,
    /// Notes by name, such as the version of the program.
    pub notes: BTreeMap<String, String>,
}

impl Table {
    /// Returns the place of a column.
    pub fn column(&self, name: &str) -> Option<usize> {
        self.headings.iter().position(|heading| heading.name == name)
    }

    /// Returns the values of a column as numbers, none where there is no number.
    pub fn numbers(&self, name: &str) -> Option<Vec<Option<f64>>> {
        let at = self.column(name)?;
        Some(self.rows.iter().map(|row| row[at].as_ref().and_then(Value::number)).collect())
    }
}
