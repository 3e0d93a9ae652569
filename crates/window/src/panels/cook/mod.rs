//! The panel of the cook: hob, hands, time, what is poured.

pub mod act_button;
pub mod cook_state;
pub mod few_controls;
pub mod heard;
pub mod hob_bar;
pub mod hob_slider;
pub mod pour;
pub mod speaker_switch;
pub mod status;
pub mod time_strip;
