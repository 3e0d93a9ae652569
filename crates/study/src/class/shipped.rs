//! The scenarios that come with the program.

/// Ids and texts, in the order in which they are learned.
pub const SHIPPED: [(&str, &str); 3] = [
    ("first-steak", include_str!("../../../../scenarios/first-steak.toml")),
    ("when-to-flip", include_str!("../../../../scenarios/when-to-flip.toml")),
    ("carry-over", include_str!("../../../../scenarios/carry-over.toml")),
];

/// Returns the text of a scenario by its id.
pub fn text(id: &str) -> Option<&'static str> {
    SHIPPED.iter().find(|(name, _)| *name == id).map(|(_, text)| *text)
}

/// Returns the ids, for messages.
pub fn names() -> String {
    SHIPPED.map(|(name, _)| name).join(", ")
}
