//! The link to the kitchen: the contact model that hands feel, and the pan and turner that hands move.

pub mod contact_model;
pub mod handover;
pub mod kitchen_watch;
pub mod lay_down;
pub mod pan_in_hand;
pub mod turner_in_hand;
