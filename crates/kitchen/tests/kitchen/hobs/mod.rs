//! The hob: what it gives, how it keeps a temperature, and how other stoves heat.

mod hob;
mod hold;
mod stoves;
