//! Reading remembered settings: a value that cannot be read costs no other.

use serde_json::{Map, Value};

use crate::settings::Settings;

impl Settings {
    /// Settings from JSON, and true if some of it could not be read.
    pub fn remembered(text: &str) -> (Self, bool) {
        let Ok(stored) = serde_json::from_str::<Value>(text) else { return (Self::default(), true) };
        let read = |value: &Value| serde_json::from_value::<Self>(value.clone()).ok();
        let kept = fitting(stored.clone(), &|value| read(value).is_some());
        let refused = kept != stored;
        read(&kept).map_or_else(|| (Self::default(), true), |settings| (settings, refused))
    }
}

/// As much of a value as fits: all of it, else those of its entries that do, and of them as much as fits.
fn fitting(value: Value, fits: &dyn Fn(&Value) -> bool) -> Value {
    match value {
        Value::Object(entries) if !fits(&Value::Object(entries.clone())) => {
            let mut kept = Map::new();
            for (key, entry) in entries {
                let with = |entry: &Value| {
                    let mut all = kept.clone();
                    all.insert(key.clone(), entry.clone());
                    fits(&Value::Object(all))
                };
                let entry = fitting(entry, &with);
                if with(&entry) {
                    kept.insert(key, entry);
                }
            }
            Value::Object(kept)
        }
        all => all,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_that_cannot_be_read_costs_no_other() {
        let text = r#"{"fahrenheit":true,"theme":"plaid","mirror":{"projector":"ceiling","stereo":"holo",
            "calibrations":{"ceiling":{"moved":{"0":[0.1,0.2]}},"wall":{"moved":7}}}}"#;
        let (settings, refused) = Settings::remembered(text);
        assert!(refused && settings.fahrenheit && settings.theme == Default::default());
        assert_eq!(settings.mirror.projector, "ceiling");
        assert_eq!(settings.mirror.calibration().moved[&0], [0.1, 0.2]);
        assert!(!settings.mirror.calibrations.contains_key("wall"));
    }

    #[test]
    fn what_can_be_read_is_read_as_it_is() {
        let settings = Settings { fahrenheit: true, speed: 5.0, ..Settings::default() };
        let text = serde_json::to_string(&settings).expect("is written");
        assert_eq!(Settings::remembered(&text), (settings, false));
        assert!(!Settings::remembered("{}").1);
        assert_eq!(Settings::remembered("not JSON"), (Settings::default(), true));
    }
}
