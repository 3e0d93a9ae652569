//! The panel of the cook: hob, hands, time, what is poured.

pub mod act_button;
pub mod few_controls;
pub mod hob_bar;
pub mod hob_slider;
pub mod pour;
pub mod status;
pub mod time_strip;
