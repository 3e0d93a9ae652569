//! The protocols that come with the program.

/// Ids and texts.
pub const SHIPPED: [(&str, &str); 1] = [("2013", include_str!("../../../studies/2013.toml"))];

/// Returns the text of a protocol by its id.
pub fn text(id: &str) -> Option<&'static str> {
    SHIPPED.iter().find(|(name, _)| *name == id).map(|(_, text)| *text)
}

/// Returns the ids, for messages.
pub fn names() -> String {
    SHIPPED.map(|(name, _)| name).join(", ")
}
