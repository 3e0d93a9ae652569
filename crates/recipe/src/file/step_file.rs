//! A step as a recipe file states it: a trigger and actions, read by [`ActionKind`].

use core::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::de::{Deserialize, Deserializer, Error, MapAccess, Visitor};
use serde_json::Value;
use std::borrow::Cow;
use toml::Spanned;

use crate::action::kind::{ActionEntry, ActionKind};
use crate::file::recipe_file::WhenEntry;
use saute_kitchen::hands::command::RestOn;
use saute_kitchen::hands::ranges::{COOL_S, MAX_S, PLACE_MM};

/// A step as the text has it. A valid step has at most one trigger and exactly one action.
#[derive(Clone, Debug, Default)]
pub struct StepEntry {
    /// Keys other than the actions.
    pub keys: StepKeys,
    /// Actions, in the order of the text.
    pub actions: Vec<ActionEntry>,
}

/// One step: at most one trigger (`at_s`, `after_s`, `when`) and exactly one action. An action takes a table, or a bare value
/// that leaves the table's other keys at their defaults.
#[derive(Clone, Debug, Default, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct StepKeys {
    /// Trigger: time from the start [s].
    #[schemars(with = "Option<f64>", range(min = 0, max = MAX_S.high))]
    pub at_s: Option<Spanned<f64>>,
    /// Trigger: time from the step before [s], or from its end where it states how long it takes, at the earliest when the
    /// hands are done with it; 0 where no trigger is given.
    #[schemars(with = "Option<f64>", range(min = 0, max = MAX_S.high))]
    pub after_s: Option<Spanned<f64>>,
    /// Trigger: a temperature or a mass is above or below a value; at once if it is already.
    #[schemars(with = "Option<WhenEntry>")]
    pub when: Option<Spanned<WhenEntry>>,
    /// With a bare `put`: place of its centre relative to the pan's [mm]; [0, 0] by default.
    #[schemars(with = "Option<[f64; 2]>", inner(range(min = PLACE_MM.low, max = PLACE_MM.high)), extend("x-remedy" = "write at_mm = [x, y], for instance [20, 0]"))]
    pub at_mm: Option<Spanned<[f64; 2]>>,
    /// With a bare `rest`: onto what; the board by default.
    #[schemars(with = "Option<RestOn>")]
    pub on: Option<Spanned<RestOn>>,
    /// With a bare `cool`: how long [s]; 3 by default.
    #[schemars(with = "Option<f64>", range(min = COOL_S.low, max = COOL_S.high))]
    pub for_s: Option<Spanned<f64>>,
}

/// Prefix of the description of an action in the schema.
pub const ACTION_PREFIX: &str = "Action: ";

/// Keys of [`StepKeys`].
const OWN_KEYS: [&str; 6] = ["at_s", "after_s", "when", "at_mm", "on", "for_s"];

/// All keys of a step, for messages.
const ALL_KEYS: [&str; OWN_KEYS.len() + ActionKind::ALL.len()] = {
    let mut keys = [""; OWN_KEYS.len() + ActionKind::ALL.len()];
    let mut i = 0;
    while i < keys.len() {
        keys[i] = if i < OWN_KEYS.len() { OWN_KEYS[i] } else { ActionKind::ALL[i - OWN_KEYS.len()].name() };
        i += 1;
    }
    keys
};

/// A key of a step.
enum StepKey {
    Own(&'static str),
    Action(ActionKind),
}

impl<'de> Deserialize<'de> for StepKey {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_identifier(KeyVisitor)
    }
}

struct KeyVisitor;

impl Visitor<'_> for KeyVisitor {
    type Value = StepKey;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a key of a step")
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<StepKey, E> {
        let own = OWN_KEYS.into_iter().find(|key| *key == name).map(StepKey::Own);
        let key = own.or_else(|| ActionKind::from_name(name).map(StepKey::Action));
        key.ok_or_else(|| E::unknown_field(name, &ALL_KEYS))
    }
}

impl<'de> Deserialize<'de> for StepEntry {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_struct("StepEntry", &ALL_KEYS, StepVisitor)
    }
}

struct StepVisitor;

impl<'de> Visitor<'de> for StepVisitor {
    type Value = StepEntry;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("struct StepEntry")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<StepEntry, A::Error> {
        let mut step = StepEntry::default();
        while let Some(key) = map.next_key()? {
            match key {
                StepKey::Action(kind) => step.actions.push(kind.read(&mut map)?),
                StepKey::Own(name) => step.keys.read(name, &mut map)?,
            }
        }
        Ok(step)
    }
}

impl StepKeys {
    /// Reads the value of one of the [`OWN_KEYS`].
    fn read<'de, A: MapAccess<'de>>(&mut self, name: &str, map: &mut A) -> Result<(), A::Error> {
        match name {
            "at_s" => self.at_s = map.next_value()?,
            "after_s" => self.after_s = map.next_value()?,
            "when" => self.when = map.next_value()?,
            "at_mm" => self.at_mm = map.next_value()?,
            "on" => self.on = map.next_value()?,
            "for_s" => self.for_s = map.next_value()?,
            other => return Err(A::Error::unknown_field(other, &ALL_KEYS)),
        }
        Ok(())
    }
}

/// The schema of [`StepKeys`] with a property for each action.
impl JsonSchema for StepEntry {
    fn schema_name() -> Cow<'static, str> {
        "StepEntry".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let mut schema = StepKeys::json_schema(generator);
        let actions = ActionKind::ALL.map(|kind| {
            let mut property = kind.schema(generator);
            property.insert("description".to_owned(), format!("{ACTION_PREFIX}{}", kind.summary()).into());
            (kind.name().to_owned(), Value::from(property))
        });
        if let Some(Value::Object(properties)) = schema.get_mut("properties") {
            properties.extend(actions);
        }
        schema
    }
}
