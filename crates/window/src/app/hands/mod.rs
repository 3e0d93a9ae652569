//! What hands do to the kitchen: keys, mouse, gamepad and tools.

mod grab;
mod pad_input;
mod pan_keys;
mod picking;
mod pouring;
mod probe_hand;
mod put_in;
mod scale_choice;
mod tool_hand;

use crate::ui::tab_end::TabEnd;
use saute_controls::input::pad_input::Pad;
use saute_controls::input::pan_keys::PanKeys;
use saute_controls::input::pouring::Portion;
use saute_controls::input::tool_hand::ToolHand;

/// What keys, mouse and gamepad hold from frame to frame.
#[derive(Default)]
pub(crate) struct Inputs {
    pub(crate) pan_keys: PanKeys,
    pub(crate) tool_hand: ToolHand,
    /// Portion that is poured at once.
    pub(crate) portion: Portion,
    pub(crate) pad: Pad,
    /// Where the Tab key has come to.
    pub(crate) tab_end: TabEnd,
}
