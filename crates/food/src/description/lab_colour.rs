//! The schema of a colour in a data file.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};

/// Schema of a colour L*, a*, b* under D65, which the tables keep as three numbers.
#[derive(Clone, Copy, Debug)]
pub struct LabColour;

impl JsonSchema for LabColour {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "LabColour".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let opponent = || json_schema!({ "type": "number", "minimum": -128, "maximum": 127 });
        json_schema!({
            "title": "colour",
            "description": "L* 0 to 100, a* and b* -128 to 127",
            "type": "array",
            "prefixItems": [{ "type": "number", "minimum": 0, "maximum": 100 }, opponent(), opponent()],
            "minItems": 3,
            "maxItems": 3,
            "x-remedy": "use L* 0 to 100, a* and b* -128 to 127",
        })
    }
}

/// Schema of what a change adds to L*, a* and b*.
#[derive(Clone, Copy, Debug)]
pub struct LabShift;

impl JsonSchema for LabShift {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "LabShift".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let part = || json_schema!({ "type": "number", "minimum": -255, "maximum": 255 });
        json_schema!({
            "title": "shift of a colour",
            "type": "array",
            "prefixItems": [part(), part(), part()],
            "minItems": 3,
            "maxItems": 3,
            "x-remedy": "use three numbers from -255 to 255",
        })
    }
}
