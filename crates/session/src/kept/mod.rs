//! A cook that outlasts the program: kept while it goes on, and as the fragment of an address.

pub mod autosave;
pub mod link;
