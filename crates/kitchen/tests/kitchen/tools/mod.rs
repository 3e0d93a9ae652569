//! Tools in a hand.

mod knife;
mod led_turner;
mod press;
mod squeeze;
