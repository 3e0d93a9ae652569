//! The keys: one list for the keyboard and for the help.

use egui::Key;
use saute_picture::view::View;

use saute_controls::act::{Act, AppAct, CookAct, TimeAct, ViewAct};
use saute_controls::input::pouring::Pourable;
use saute_words::language::Language;

/// A key and what it does.
pub struct Binding {
    /// The key.
    pub key: Key,
    /// How the key is written.
    pub written: &'static str,
    /// What it does.
    pub act: Act,
}

const fn bind(key: Key, written: &'static str, act: Act) -> Binding {
    Binding { key, written, act }
}

/// Keys with Ctrl, as the help lists them, with the keys of the words for them.
pub const CHORDS: [(&str, &str); 2] = [("Ctrl+Z", "key.undo"), ("Ctrl+Y", "key.redo")];

/// Distance by which a key raises the turner [m] (chosen: a pan's wall in four).
pub const TOOL_STEP: f64 = 0.01;
/// Angle by which a key rolls the turner [rad] (chosen: six presses turn it over).
pub const ROLL_STEP: f64 = std::f64::consts::PI / 6.0;

/// All keys, in the order in which the help lists them.
pub static BINDINGS: [Binding; 65] = [
    bind(Key::A, "A", Act::Cook(CookAct::Put)),
    bind(Key::F, "F", Act::Cook(CookAct::Flip)),
    bind(Key::O, "O", Act::Cook(CookAct::Out)),
    bind(Key::Comma, ",", Act::Cook(CookAct::Halve)),
    bind(Key::T, "T", Act::Cook(CookAct::Toss)),
    bind(Key::Num8, "8", Act::Cook(CookAct::Pour(Pourable::Oil))),
    bind(Key::Num9, "9", Act::Cook(CookAct::Pour(Pourable::Butter))),
    bind(Key::Num0, "0", Act::Cook(CookAct::Pour(Pourable::Water))),
    bind(Key::Minus, "-", Act::Cook(CookAct::Portion)),
    bind(Key::Z, "Z", Act::Cook(CookAct::Lid)),
    bind(Key::U, "U", Act::Cook(CookAct::Tool)),
    bind(Key::Home, "Home", Act::Cook(CookAct::ToolBy(TOOL_STEP))),
    bind(Key::End, "End", Act::Cook(CookAct::ToolBy(-TOOL_STEP))),
    bind(Key::Insert, "Ins", Act::Cook(CookAct::RollBy(-ROLL_STEP))),
    bind(Key::Delete, "Del", Act::Cook(CookAct::RollBy(ROLL_STEP))),
    bind(Key::Slash, "/", Act::Cook(CookAct::LevelTool)),
    bind(Key::Backspace, "Bksp", Act::Cook(CookAct::PutAway)),
    bind(Key::I, "I", Act::View(ViewAct::NextPiece)),
    bind(Key::B, "B", Act::View(ViewAct::Pieces)),
    bind(Key::E, "E", Act::Cook(CookAct::Hob(1))),
    bind(Key::Q, "Q", Act::Cook(CookAct::Hob(-1))),
    bind(Key::W, "W", Act::Cook(CookAct::Cloth)),
    bind(Key::Space, "Space", Act::Time(TimeAct::Pause)),
    bind(Key::Period, ".", Act::Time(TimeAct::Step)),
    bind(Key::CloseBracket, "]", Act::Time(TimeAct::Speed(1))),
    bind(Key::OpenBracket, "[", Act::Time(TimeAct::Speed(-1))),
    bind(Key::R, "R", Act::Cook(CookAct::Restart)),
    bind(Key::N, "N", Act::View(ViewAct::Pantry)),
    bind(Key::Num1, "1", Act::View(ViewAct::View(View::Look))),
    bind(Key::Num2, "2", Act::View(ViewAct::View(View::Temperature))),
    bind(Key::Num3, "3", Act::View(ViewAct::View(View::Moisture))),
    bind(Key::Num4, "4", Act::View(ViewAct::View(View::Doneness))),
    bind(Key::Num5, "5", Act::View(ViewAct::View(View::Browning))),
    bind(Key::Num6, "6", Act::View(ViewAct::View(View::Lethality))),
    bind(Key::Num7, "7", Act::View(ViewAct::View(View::Marbling))),
    bind(Key::Y, "Y", Act::View(ViewAct::Split)),
    bind(Key::P, "P", Act::View(ViewAct::Probe)),
    bind(Key::M, "M", Act::View(ViewAct::Map)),
    bind(Key::D, "D", Act::View(ViewAct::Scale)),
    bind(Key::X, "X", Act::View(ViewAct::Slice)),
    bind(Key::J, "J", Act::View(ViewAct::SliceBy(-0.05))),
    bind(Key::L, "L", Act::View(ViewAct::SliceBy(0.05))),
    bind(Key::C, "C", Act::View(ViewAct::Units)),
    bind(Key::G, "G", Act::View(ViewAct::Curves)),
    bind(Key::H, "H", Act::View(ViewAct::Panels)),
    bind(Key::F10, "F10", Act::View(ViewAct::Projector)),
    bind(Key::F6, "F6", Act::View(ViewAct::More)),
    bind(Key::V, "V", Act::View(ViewAct::Camera)),
    bind(Key::ArrowLeft, "←", Act::View(ViewAct::Orbit(-0.08, 0.0))),
    bind(Key::ArrowRight, "→", Act::View(ViewAct::Orbit(0.08, 0.0))),
    bind(Key::ArrowUp, "↑", Act::View(ViewAct::Orbit(0.0, 0.06))),
    bind(Key::ArrowDown, "↓", Act::View(ViewAct::Orbit(0.0, -0.06))),
    bind(Key::PageUp, "Page up", Act::View(ViewAct::Zoom(0.9))),
    bind(Key::PageDown, "Page down", Act::View(ViewAct::Zoom(1.1))),
    bind(Key::Enter, "Enter", Act::App(AppAct::StopHands)),
    bind(Key::F7, "F7", Act::View(ViewAct::Strings)),
    bind(Key::S, "S", Act::App(AppAct::Picture)),
    bind(Key::F12, "F12", Act::App(AppAct::Picture)),
    bind(Key::F8, "F8", Act::App(AppAct::Photo)),
    bind(Key::F1, "F1", Act::App(AppAct::Help)),
    bind(Key::F2, "F2", Act::App(AppAct::Settings)),
    bind(Key::F3, "F3", Act::App(AppAct::Messages)),
    bind(Key::F4, "F4", Act::View(ViewAct::SideBySide)),
    bind(Key::F9, "F9", Act::App(AppAct::Mirror)),
    bind(Key::Escape, "Esc", Act::App(AppAct::Close)),
];

/// Description of an act with its key, for tooltips.
pub fn hint(act: &Act, l: Language) -> String {
    let words = l.text(act.traits().words);
    BINDINGS.iter().find(|b| b.act == *act).map_or_else(String::new, |b| format!("{words} ({})", b.written))
}

/// The key of an act.
pub fn key_of(act: &Act) -> &'static str {
    BINDINGS.iter().find(|b| b.act == *act).map_or("", |b| b.written)
}

#[cfg(test)]
mod tests {
    use super::*;
    use saute_controls::act::Traits;

    #[test]
    fn no_key_does_two_things_and_each_has_words() {
        for (i, a) in BINDINGS.iter().enumerate() {
            assert!(BINDINGS[i + 1..].iter().all(|b| b.key != a.key), "{}", a.written);
            assert!(a.key != Key::K, "held keys are theirs alone");
            assert_ne!(a.act.traits().words, Traits::NO_WORDS, "{}", a.written);
        }
    }
}
