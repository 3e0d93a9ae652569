//! The scenarios that come with the program.

use super::scenario_file::{AskKind, ScenarioFile};

/// Ids and texts, in the order in which they are learned.
pub const SHIPPED: [(&str, &str); 4] = [
    ("first-steak", include_str!("../../../../scenarios/first-steak.toml")),
    ("when-to-flip", include_str!("../../../../scenarios/when-to-flip.toml")),
    ("carry-over", include_str!("../../../../scenarios/carry-over.toml")),
    ("white-is-not-done", include_str!("../../../../scenarios/white-is-not-done.toml")),
];

/// Returns the text of a scenario by its id.
pub fn text(id: &str) -> Option<&'static str> {
    SHIPPED.iter().find(|(name, _)| *name == id).map(|(_, text)| *text)
}

/// What a shipped scenario asks, by its id and the checksum of its text; none if it was changed since.
pub(super) fn asks(id: &str, checksum: &str) -> Option<Vec<AskKind>> {
    let text = text(id).filter(|text| format!("{:08x}", crc32fast::hash(text.as_bytes())) == checksum)?;
    let file: ScenarioFile = toml::from_str(text).ok()?;
    Some(file.predict.iter().map(|entry| entry.get_ref().ask).collect())
}

/// Returns the ids, for messages.
pub fn names() -> String {
    SHIPPED.map(|(name, _)| name).join(", ")
}
