//! The table of `repeat`: an action, its rhythm and its end.

use core::fmt;
use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::de::{Deserialize, Deserializer, Error, MapAccess, Visitor};
use serde_json::Value;
use toml::Spanned;

use crate::action::kind::{ActionEntry, ActionKind};
use crate::file::recipe_file::WhenEntry;
use crate::file::shorthand::Written;

/// Range of the period of a repetition [s] (chosen: not below a tick, not above an hour).
pub const EVERY_S: [f64; 2] = [0.1, 3600.0];
/// Range of the number of repetitions [-] (chosen: more is a mistyped number).
pub const TIMES: [i64; 2] = [1, 1000];

/// The table of `repeat` as the text has it. A valid one has one action, `every_s`, and `until` or `times`.
#[derive(Clone, Debug)]
pub struct RepeatEntry {
    /// Keys other than the action.
    pub keys: Box<RepeatKeys>,
    /// Actions, in the order of the text.
    pub actions: Vec<ActionEntry>,
    /// Byte offset in the text.
    pub at: usize,
}

/// Carries out one action again and again. The first time is one period after the step is due, so that `put` and then
/// `repeat` with `flip` turns first after that period. Beside these keys it has the key of one action, but not `repeat` or
/// `end`.
#[derive(Clone, Debug, Default, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct RepeatKeys {
    /// Period, from one repetition to the next [s]; longer where the hands are not done.
    #[schemars(with = "f64", range(min = EVERY_S[0], max = EVERY_S[1]))]
    pub every_s: Option<Spanned<f64>>,
    /// Ends it once this condition holds, also between two repetitions.
    #[schemars(with = "Option<WhenEntry>")]
    pub until: Option<Spanned<WhenEntry>>,
    /// Ends it after so many repetitions.
    #[schemars(with = "Option<u32>", range(min = TIMES[0], max = TIMES[1]))]
    pub times: Option<Spanned<u32>>,
}

/// A table, before its place in the text is known.
#[derive(Default)]
struct Body {
    keys: RepeatKeys,
    actions: Vec<ActionEntry>,
}

impl Written for RepeatEntry {
    fn is_bare(&self) -> bool {
        false
    }
}

impl<'de> Deserialize<'de> for RepeatEntry {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let written = Spanned::<Body>::deserialize(deserializer)?;
        let at = written.span().start;
        let Body { keys, actions } = written.into_inner();
        Ok(Self { keys: Box::new(keys), actions, at })
    }
}

impl<'de> Deserialize<'de> for Body {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(BodyVisitor)
    }
}

struct BodyVisitor;

impl<'de> Visitor<'de> for BodyVisitor {
    type Value = Body;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a table with an action, every_s, and until or times")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Body, A::Error> {
        let mut body = Body::default();
        while let Some(key) = map.next_key::<String>()? {
            match (key.as_str(), ActionKind::from_name(&key)) {
                ("every_s", _) => body.keys.every_s = map.next_value()?,
                ("until", _) => body.keys.until = map.next_value()?,
                ("times", _) => body.keys.times = map.next_value()?,
                (_, Some(kind)) => body.actions.push(kind.read(&mut map)?),
                (other, None) => {
                    let message =
                        format!("unknown key `{other}` in repeat, expected every_s, until, times or an action");
                    return Err(A::Error::custom(message));
                }
            }
        }
        Ok(body)
    }
}

/// The schema of [`RepeatKeys`] with a property for each action that can be repeated.
impl JsonSchema for RepeatEntry {
    fn schema_name() -> Cow<'static, str> {
        "RepeatEntry".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let mut schema = RepeatKeys::json_schema(generator);
        let repeatable = ActionKind::ALL.into_iter().filter(|kind| kind.is_repeatable());
        let actions: Vec<_> = repeatable
            .map(|kind| {
                let mut property = kind.schema(generator);
                property.insert("description".to_owned(), format!("Repeats: {}", kind.summary()).into());
                (kind.name().to_owned(), Value::from(property))
            })
            .collect();
        if let Some(Value::Object(properties)) = schema.get_mut("properties") {
            properties.extend(actions);
        }
        schema
    }
}
