//! A key with a table, or with one bare value and the defaults of the table: `oil_g = 10`.

use core::fmt;
use core::marker::PhantomData;
use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::{BoolDeserializer, F64Deserializer, MapAccessDeserializer, StrDeserializer};
use serde::de::{Deserialize, Deserializer, Error, MapAccess, Visitor};
use serde_json::Value;
use toml::Spanned;

/// A table that can be written as a bare value.
pub trait Shorthand: Sized {
    /// Type of the bare value.
    type Bare;
    /// Key of the table that the bare value sets; none where it only has the table done.
    const SETS: Option<&'static str>;

    /// Returns the table with the bare value and defaults.
    ///
    /// # Errors
    ///
    /// Returns a message if the value has no effect.
    fn from_bare(bare: Spanned<Self::Bare>) -> Result<Self, &'static str>;
}

/// A table, written in full or as a bare value.
#[derive(Clone, Debug)]
pub struct ShortOrTable<T> {
    /// The table.
    pub table: T,
    /// Byte offset in the text.
    pub at: usize,
    /// True if it was written as a bare value.
    pub bare: bool,
}

/// The value of an action's key.
pub trait Written {
    /// Returns true if it is a bare value, not a table.
    fn is_bare(&self) -> bool;
}

impl<T> Written for ShortOrTable<T> {
    fn is_bare(&self) -> bool {
        self.bare
    }
}

/// A bare value or a table, as the text has it.
enum BareOrTable<B, T> {
    Bare(B),
    Table(T),
}

impl<'de, T> Deserialize<'de> for ShortOrTable<T>
where
    T: Shorthand + Deserialize<'de>,
    T::Bare: Deserialize<'de>,
{
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let written = Spanned::<BareOrTable<T::Bare, T>>::deserialize(deserializer)?;
        let span = written.span();
        let at = span.start;
        match written.into_inner() {
            BareOrTable::Table(table) => Ok(Self { table, at, bare: false }),
            BareOrTable::Bare(bare) => {
                let table = T::from_bare(Spanned::new(span, bare)).map_err(D::Error::custom)?;
                Ok(Self { table, at, bare: true })
            }
        }
    }
}

/// The TOML type selects the variant. `#[serde(untagged)]` would lose the place of an error in the file.
impl<'de, B: Deserialize<'de>, T: Deserialize<'de>> Deserialize<'de> for BareOrTable<B, T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Either(PhantomData))
    }
}

struct Either<B, T>(PhantomData<(B, T)>);

impl<'de, B: Deserialize<'de>, T: Deserialize<'de>> Visitor<'de> for Either<B, T> {
    type Value = BareOrTable<B, T>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("one value or a table")
    }

    fn visit_bool<E: Error>(self, v: bool) -> Result<Self::Value, E> {
        B::deserialize(BoolDeserializer::new(v)).map(BareOrTable::Bare)
    }

    fn visit_f64<E: Error>(self, v: f64) -> Result<Self::Value, E> {
        B::deserialize(F64Deserializer::new(v)).map(BareOrTable::Bare)
    }

    fn visit_i64<E: Error>(self, v: i64) -> Result<Self::Value, E> {
        self.visit_f64(v as f64)
    }

    fn visit_str<E: Error>(self, v: &str) -> Result<Self::Value, E> {
        B::deserialize(StrDeserializer::new(v)).map(BareOrTable::Bare)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Self::Value, A::Error> {
        T::deserialize(MapAccessDeserializer::new(map)).map(BareOrTable::Table)
    }
}

/// The schema of a key as that of a bare value: its kind and range, without its words and its default.
fn one_value(key: &Value) -> Schema {
    let mut value = key.clone();
    if let Some(parts) = value.as_object_mut() {
        parts.retain(|part, _| !matches!(part.as_str(), "description" | "default" | "examples"));
    }
    if let Some(kind) = value["type"].as_array().and_then(|kinds| kinds.iter().find(|kind| *kind != "null")).cloned() {
        value["type"] = kind;
    }
    Schema::try_from(value).unwrap_or_default()
}

impl<T> JsonSchema for ShortOrTable<T>
where
    T: Shorthand + JsonSchema,
    T::Bare: JsonSchema,
{
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        format!("{}OrValue", T::schema_name()).into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let table = T::json_schema(generator);
        let key = T::SETS.and_then(|key| table.get("properties")?.get(key)).map(one_value);
        let bare = key.unwrap_or_else(|| generator.subschema_for::<T::Bare>());
        json_schema!({ "anyOf": [bare, generator.subschema_for::<T>()] })
    }
}
