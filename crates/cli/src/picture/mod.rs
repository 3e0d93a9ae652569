//! Pictures from the renderer of the window: `saute shot` and `saute bench frame`.

pub mod bench_frame;
pub mod choices;
mod contact_sheet;
pub mod eye;
pub mod shot;
pub mod size;
mod time_lapse;
