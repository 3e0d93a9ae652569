//! Remembered settings with the values that they get.

use saute_scene::light::room_light::RoomLight;
use saute_scene::light::white_balance::WhiteBalance;

use crate::settings::interface_size::InterfaceSize;
use crate::settings::quality_choice::QualityChoice;
use crate::settings::theme::Theme;
use saute_mirror::settings::MirrorSettings;
use saute_session::FoodChoice;
use saute_session::permits::Permit;
use saute_words::language::Language;

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
    /// True if the coach is on.
    Coach(bool),
    /// True if the result opens by itself.
    ResultOpens(bool),
    /// True if all read-outs are hidden.
    SkillMode(bool),
    /// The food and the pan.
    Choice(FoodChoice),
    /// True lets forecasts be made.
    Forecasts(bool),
    /// The half mirror.
    Mirror(Box<MirrorSettings>),
    /// True if the pan is heard.
    Sound(bool),
    /// Volume, from 0 to 1 [-].
    Volume(f64),
}

impl Setting {
    /// What must be allowed to change it.
    pub fn needs(&self) -> &'static [Permit] {
        match self {
            Self::Theme(Theme::Dark | Theme::Light | Theme::System)
            | Self::White(_)
            | Self::Light(_)
            | Self::Quality(_)
            | Self::Language(_)
            | Self::Fahrenheit(_)
            | Self::Size(_)
            | Self::LessMotion(_) => &[Permit::Comfort],
            Self::Scale(_)
            | Self::Goal(_)
            | Self::GoalNamed(_)
            | Self::Coach(_)
            | Self::ResultOpens(_)
            | Self::Forecasts(_) => &[Permit::Advice],
            Self::SkillMode(_) => &[Permit::Leaving],
            Self::Choice(_) => &[Permit::Foods, Permit::Pan],
            Self::Mirror(_) => &[Permit::Devices],
            Self::Sound(_) | Self::Volume(_) => &[Permit::Sound],
        }
    }
}
