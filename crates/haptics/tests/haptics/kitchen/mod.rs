//! What the link to the kitchen promises: the contact model, and the pan and turner in hand.

mod hands;
mod kitchen_watch;
