//! Everything a person can do, by button, key or mouse: one list for the keyboard and for the help.

use egui::Key;
use saute_picture::view::View;
use saute_plan::forecast::Question;
use saute_scene::light::room_light::RoomLight;
use saute_scene::light::white_balance::WhiteBalance;

use crate::at_home::AtHomeAct;
use crate::guided::GuidedAct;
use crate::input::pouring::Pourable;
use crate::mirror::settings::MirrorSettings;
use crate::plan::PlanAct;
use crate::session::SteakChoice;
use crate::ui::glance::EyeView;
use crate::ui::interface_size::InterfaceSize;
use crate::ui::quality_choice::QualityChoice;
use crate::ui::theme::Theme;
use crate::words::language::Language;

/// Acts that panels return, in order; the app carries them out once all panels are shown.
pub type Acts = Vec<Act>;

/// One thing to do.
#[derive(Clone, Debug, PartialEq)]
pub enum Act {
    /// Stop time or let it go on.
    Pause,
    /// One tick.
    Step,
    /// Next slower or faster speed.
    Speed(i8),
    /// Sets how fast simulated time runs [-].
    SpeedSet(f64),
    /// Next lower or higher hob setting.
    Hob(i8),
    /// Sets the hob [W].
    HobSet(f64),
    /// Lets the hob hold the pan at a temperature [°C].
    HobHold(f64),
    /// Wet cloth under the pan.
    Cloth,
    /// The food into the pan.
    Put,
    /// Lays these pieces side by side onto the floor of the pan, as many as fit.
    Lay(Vec<String>),
    /// Drops these pieces into the pan onto each other.
    Heap(Vec<String>),
    /// Takes these pieces away altogether.
    Remove(Vec<String>),
    /// Turn it over.
    Flip,
    /// Onto the board.
    Out,
    /// Does what a forecast asks about with the piece that the panels show.
    Asked(Question),
    /// The knife halves what was taken out.
    Halve,
    /// Tosses what is in the pan.
    Toss,
    /// Adds a portion of oil, butter or water.
    Pour(Pourable),
    /// The next portion.
    Portion,
    /// Lid on or off.
    Lid,
    /// The phone holds the pan, or no longer.
    #[cfg(target_arch = "wasm32")]
    TiltPhone,
    /// The other tool.
    Tool,
    /// Raises the turner [m].
    ToolBy(f64),
    /// Rolls the turner to the right [rad].
    RollBy(f64),
    /// Levels the turner.
    LevelTool,
    /// Lays the tool down.
    PutAway,
    /// The panels show the next piece.
    NextPiece,
    /// The panels show this piece.
    Select(String),
    /// Starts over with the chosen food and pan.
    SetOut,
    /// Sets out so many more of the chosen food.
    Add(usize),
    /// Plays a recipe of the library from its start, by its id.
    Play(String),
    /// Lets the recipe go on from which a command took over.
    ResumeRecipe,
    /// Opens a file dialog for a recipe.
    ChooseFile,
    /// Saves a file that is made of the cook.
    Export(crate::export::Export),
    /// Copies an address that holds the cook.
    CopyLink,
    /// Opens a recipe's file.
    #[cfg(not(target_arch = "wasm32"))]
    OpenFile(std::path::PathBuf),
    /// Shows a file in the system's file manager.
    #[cfg(not(target_arch = "wasm32"))]
    ShowFile(std::path::PathBuf),
    /// List of the pieces.
    Pieces,
    /// Start over.
    Restart,
    /// Goes on with the cook of the last time, or leaves it.
    GoOn(bool),
    /// Back to before the last act.
    Undo,
    /// Forward to where the last undo began.
    Redo,
    /// Turns time to an instant [s].
    Scrub(f64),
    /// Holds time still, or lets it go on.
    HoldTime(bool),
    /// Goes over to another branch, by its place.
    Branch(usize),
    /// All ways side by side, or the one that goes on alone.
    SideBySide,
    /// View that the colours show.
    View(View),
    /// The look next to the view, or the view alone.
    Split,
    /// A probe where the pointer is.
    Probe,
    /// The next click on the food puts a probe in, or no longer does.
    Placing(bool),
    /// Chooses a probe by its number, or none.
    SelectProbe(Option<usize>),
    /// Names a probe.
    NameProbe(usize, String),
    /// Takes a probe out.
    RemoveProbe(usize),
    /// The other colour map.
    Map,
    /// The next scale of doneness.
    Scale,
    /// Cut on or off.
    Slice,
    /// Moves the cut.
    SliceBy(f64),
    /// Cuts at a place (−1…1).
    SliceAt(f64),
    /// °C or °F.
    Units,
    /// Next camera.
    Camera,
    /// Sends the eye to a view.
    Eye(EyeView),
    /// Nearer (below 1) or farther.
    Zoom(f32),
    /// Turns the eye [rad].
    Orbit(f32, f32),
    /// Food and pan choices.
    Pantry,
    /// Curves on or off.
    Curves,
    /// All panels on or off.
    Panels,
    /// Emergency stop of all devices.
    StopHands,
    /// Devices that were stopped may make forces again.
    #[cfg(not(target_arch = "wasm32"))]
    ResumeHands,
    /// The strings of a device.
    Strings,
    /// Connects a device.
    #[cfg(not(target_arch = "wasm32"))]
    Connect {
        /// What it holds.
        role: crate::hand::Role,
        /// NAME or NAME@PLACE.
        device: String,
        /// Pairing code; 0 where there is none.
        pairing: u32,
    },
    /// Disconnects what a hand holds.
    #[cfg(not(target_arch = "wasm32"))]
    Disconnect(crate::hand::Role),
    /// Saves a picture.
    Picture,
    /// The photo mode.
    Photo,
    /// Sets exposure, blur and size of a photo.
    #[cfg(not(target_arch = "wasm32"))]
    SetPhoto(crate::photo::PhotoChoice),
    /// Makes a time lapse of the cook.
    #[cfg(not(target_arch = "wasm32"))]
    TimeLapse,
    /// The half mirror's window on or off, with a word on how to use it.
    Mirror,
    /// Opens the half mirror's window or closes it.
    MirrorWindow(bool),
    /// Shows the half mirror's pattern, or its picture.
    Calibrate(bool),
    /// Reads the half mirror's rig again.
    ReadRig,
    /// Saves the result of the cook as a picture.
    ShareResult,
    /// Begins the tutorial, or leaves it.
    Tutorial(bool),
    /// Changes a remembered setting.
    Set(Setting),
    /// What a study or a lesson asks for.
    Guided(GuidedAct),
    /// Says something over the scene.
    Say(String),
    /// Does something about a plan.
    Plan(PlanAct),
    /// Does something about the kitchen at home.
    AtHome(AtHomeAct),
    /// Opens a card in place of the one that is open.
    Open(Card),
    /// Closes a card.
    Shut(Card),
    /// The card of the settings.
    Settings,
    /// This list.
    Help,
    /// What was said so far.
    Messages,
    /// Closes list and card; no probe is put in.
    Close,
}

/// A remembered setting with the value that it gets.
#[derive(Clone, Debug, PartialEq)]
pub enum Setting {
    /// Dark or light panels.
    Theme(Theme),
    /// White balance of the look.
    White(WhiteBalance),
    /// Light of the room.
    Light(RoomLight),
    /// The quality of the picture.
    Quality(QualityChoice),
    /// The window's language.
    Language(Language),
    /// °F instead of °C.
    Fahrenheit(bool),
    /// Size of the interface.
    Size(InterfaceSize),
    /// True if what glides jumps.
    LessMotion(bool),
    /// The scale of doneness, by its id.
    Scale(String),
    /// Goal for the core by the scale of the food shown, in its unit [°C or %].
    Goal(f64),
    /// The goal that a cook is judged by, by its id.
    GoalNamed(String),
    /// True if the coach speaks.
    Coach(bool),
    /// True if the result opens by itself.
    ResultOpens(bool),
    /// True if all read-outs are hidden.
    SkillMode(bool),
    /// The food and the pan.
    Choice(SteakChoice),
    /// True lets forecasts be made.
    Forecasts(bool),
    /// The half mirror.
    Mirror(Box<MirrorSettings>),
}

/// A card over everything.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Card {
    /// The list of keys.
    Help,
    /// The settings.
    Settings,
    /// What was said so far.
    Messages,
    /// The half mirror.
    Mirror,
    /// The first steps.
    FirstSteps,
    /// What there is to learn and to try.
    Learn,
    /// The lessons.
    Lessons,
    /// The goals of a cook.
    Goals,
    /// The result of the cook.
    Result,
    /// A plan for the chosen food.
    Plan,
    /// The kitchen at home.
    AtHome,
}

/// What a key is about: the help lists keys by it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// Food, oil, lid.
    Food,
    /// Turner and tongs.
    Tool,
    /// Hob and time.
    Hob,
    /// What is seen of the food.
    Views,
    /// The eye.
    Eye,
    /// Panels, pictures, devices.
    Window,
}

impl Subject {
    /// All of them, in the order of the help.
    pub const ALL: [Self; 6] = [Self::Food, Self::Hob, Self::Views, Self::Eye, Self::Tool, Self::Window];

    /// The subject of an act that has a key.
    pub fn of(act: &Act) -> Self {
        use Act::{
            Camera, Cloth, Halve, Hob, LevelTool, Lid, Map, NextPiece, Orbit, Out, Pause, Portion, Pour, Probe, Put,
            PutAway, Restart, RollBy, Scale, Slice, SliceBy, Speed, Split, Step, Tool, ToolBy, Toss, Units, View, Zoom,
        };
        match act {
            Put | Act::Flip | Out | Halve | Toss | Pour(_) | Portion | Lid | NextPiece => Self::Food,
            Tool | ToolBy(_) | RollBy(_) | LevelTool | PutAway => Self::Tool,
            Hob(_) | Cloth | Pause | Step | Speed(_) | Restart => Self::Hob,
            View(_) | Split | Probe | Map | Scale | Slice | SliceBy(_) | Units | Act::SideBySide => Self::Views,
            Camera | Orbit(..) | Zoom(_) => Self::Eye,
            _ => Self::Window,
        }
    }
}

/// A key, what it does, and how the help calls it.
pub struct Binding {
    /// The key.
    pub key: Key,
    /// How the key is written.
    pub written: &'static str,
    /// What it does.
    pub act: Act,
    /// Key of the words for it.
    pub words: &'static str,
}

const fn bind(key: Key, written: &'static str, act: Act, words: &'static str) -> Binding {
    Binding { key, written, act, words }
}

/// Keys with Ctrl, as the help lists them, with the keys of the words for them.
pub const CHORDS: [(&str, &str); 2] = [("Ctrl+Z", "key.undo"), ("Ctrl+Y", "key.redo")];

/// Distance by which a key raises the turner [m] (chosen: a pan's wall in four).
pub const TOOL_STEP: f64 = 0.01;
/// Angle by which a key rolls the turner [rad] (chosen: six presses turn it over).
pub const ROLL_STEP: f64 = std::f64::consts::PI / 6.0;

/// All keys, in the order in which the help lists them.
pub static BINDINGS: [Binding; 63] = [
    bind(Key::A, "A", Act::Put, "key.put"),
    bind(Key::F, "F", Act::Flip, "key.flip"),
    bind(Key::O, "O", Act::Out, "key.out"),
    bind(Key::Comma, ",", Act::Halve, "key.halve"),
    bind(Key::T, "T", Act::Toss, "key.toss"),
    bind(Key::Num8, "8", Act::Pour(Pourable::Oil), "key.oil"),
    bind(Key::Num9, "9", Act::Pour(Pourable::Butter), "key.butter"),
    bind(Key::Num0, "0", Act::Pour(Pourable::Water), "key.water"),
    bind(Key::Minus, "-", Act::Portion, "key.portion"),
    bind(Key::Z, "Z", Act::Lid, "key.lid"),
    bind(Key::U, "U", Act::Tool, "key.tool"),
    bind(Key::Home, "Home", Act::ToolBy(TOOL_STEP), "key.tool_up"),
    bind(Key::End, "End", Act::ToolBy(-TOOL_STEP), "key.tool_down"),
    bind(Key::Insert, "Ins", Act::RollBy(-ROLL_STEP), "key.roll_left"),
    bind(Key::Delete, "Del", Act::RollBy(ROLL_STEP), "key.roll_right"),
    bind(Key::Slash, "/", Act::LevelTool, "key.level"),
    bind(Key::Backspace, "Bksp", Act::PutAway, "key.put_away"),
    bind(Key::I, "I", Act::NextPiece, "key.next_piece"),
    bind(Key::B, "B", Act::Pieces, "key.pieces"),
    bind(Key::E, "E", Act::Hob(1), "key.hob_up"),
    bind(Key::Q, "Q", Act::Hob(-1), "key.hob_down"),
    bind(Key::W, "W", Act::Cloth, "key.cloth"),
    bind(Key::Space, "Space", Act::Pause, "key.pause"),
    bind(Key::Period, ".", Act::Step, "key.step"),
    bind(Key::CloseBracket, "]", Act::Speed(1), "key.faster"),
    bind(Key::OpenBracket, "[", Act::Speed(-1), "key.slower"),
    bind(Key::R, "R", Act::Restart, "key.restart"),
    bind(Key::N, "N", Act::Pantry, "key.pantry"),
    bind(Key::Num1, "1", Act::View(View::Look), "key.look"),
    bind(Key::Num2, "2", Act::View(View::Temperature), "key.temperature"),
    bind(Key::Num3, "3", Act::View(View::Moisture), "key.moisture"),
    bind(Key::Num4, "4", Act::View(View::Doneness), "key.doneness"),
    bind(Key::Num5, "5", Act::View(View::Browning), "key.browning"),
    bind(Key::Num6, "6", Act::View(View::Lethality), "key.lethality"),
    bind(Key::Num7, "7", Act::View(View::Marbling), "key.marbling"),
    bind(Key::Y, "Y", Act::Split, "key.split"),
    bind(Key::P, "P", Act::Probe, "key.probe"),
    bind(Key::M, "M", Act::Map, "key.map"),
    bind(Key::D, "D", Act::Scale, "key.scale"),
    bind(Key::X, "X", Act::Slice, "key.cut"),
    bind(Key::J, "J", Act::SliceBy(-0.05), "key.cut_left"),
    bind(Key::L, "L", Act::SliceBy(0.05), "key.cut_right"),
    bind(Key::C, "C", Act::Units, "key.units"),
    bind(Key::G, "G", Act::Curves, "key.curves"),
    bind(Key::H, "H", Act::Panels, "key.panels"),
    bind(Key::V, "V", Act::Camera, "key.camera"),
    bind(Key::ArrowLeft, "←", Act::Orbit(-0.08, 0.0), "key.turn_view"),
    bind(Key::ArrowRight, "→", Act::Orbit(0.08, 0.0), "key.turn_view"),
    bind(Key::ArrowUp, "↑", Act::Orbit(0.0, 0.06), "key.look_higher"),
    bind(Key::ArrowDown, "↓", Act::Orbit(0.0, -0.06), "key.look_lower"),
    bind(Key::PageUp, "Page up", Act::Zoom(0.9), "key.nearer"),
    bind(Key::PageDown, "Page down", Act::Zoom(1.1), "key.farther"),
    bind(Key::Enter, "Enter", Act::StopHands, "key.stop_hands"),
    bind(Key::F7, "F7", Act::Strings, "key.strings"),
    bind(Key::S, "S", Act::Picture, "key.picture"),
    bind(Key::F12, "F12", Act::Picture, "key.picture"),
    bind(Key::F8, "F8", Act::Photo, "key.photo"),
    bind(Key::F1, "F1", Act::Help, "key.help"),
    bind(Key::F2, "F2", Act::Settings, "key.settings"),
    bind(Key::F3, "F3", Act::Messages, "key.messages"),
    bind(Key::F4, "F4", Act::SideBySide, "key.side_by_side"),
    bind(Key::F9, "F9", Act::Mirror, "key.mirror"),
    bind(Key::Escape, "Esc", Act::Close, "key.close"),
];

/// Description of an act with its key, for tooltips.
pub fn hint(act: &Act, l: Language) -> String {
    BINDINGS.iter().find(|b| b.act == *act).map_or_else(String::new, |b| format!("{} ({})", l.text(b.words), b.written))
}

/// The key of an act.
pub fn key_of(act: &Act) -> &'static str {
    BINDINGS.iter().find(|b| b.act == *act).map_or("", |b| b.written)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_key_does_two_things() {
        for (i, a) in BINDINGS.iter().enumerate() {
            assert!(BINDINGS[i + 1..].iter().all(|b| b.key != a.key), "{}", a.written);
            assert!(a.key != Key::K, "held keys are theirs alone");
        }
    }
}
