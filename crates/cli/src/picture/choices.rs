//! Names of views, white balances, lights, qualities and stereo modes on the command line.

use clap::ValueEnum;
use clap::builder::PossibleValue;
use saute_mirror::stereo::Stereo;
use saute_picture::View;
use saute_scene::light::room_light::RoomLight;
use saute_scene::light::white_balance::WhiteBalance;
use saute_scene::quality::Quality;

/// A view by its name.
#[derive(Clone, Copy, Debug)]
pub struct ViewName(pub View);

/// All views by their names.
static VIEW_NAMES: [ViewName; View::ALL.len()] = {
    let mut names = [ViewName(View::Look); View::ALL.len()];
    let mut at = 0;
    while at < names.len() {
        names[at] = ViewName(View::ALL[at]);
        at += 1;
    }
    names
};

impl ValueEnum for ViewName {
    fn value_variants<'a>() -> &'a [Self] {
        &VIEW_NAMES
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let spec = self.0.spec();
        Some(PossibleValue::new(spec.id).help(spec.about))
    }
}

impl From<ViewName> for View {
    fn from(name: ViewName) -> Self {
        name.0
    }
}

/// Names of the white balances.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum WhiteName {
    /// A kitchen in the evening sun (5750 K).
    AsShot,
    /// Daylight (6500 K).
    Neutral,
    /// Overcast sky (8000 K).
    Cool,
    /// Lamp (4500 K).
    Warm,
}

impl From<WhiteName> for WhiteBalance {
    fn from(name: WhiteName) -> Self {
        match name {
            WhiteName::AsShot => Self::AsShot,
            WhiteName::Neutral => Self::Neutral,
            WhiteName::Cool => Self::Cool,
            WhiteName::Warm => Self::Warm,
        }
    }
}

/// Names of the lights of the room.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum LightName {
    /// The window lights the kitchen, the lamp over the hob helps.
    Daylight,
    /// The lamp lights the kitchen, the window is dark blue.
    Evening,
}

impl From<LightName> for RoomLight {
    fn from(name: LightName) -> Self {
        match name {
            LightName::Daylight => Self::Daylight,
            LightName::Evening => Self::Evening,
        }
    }
}

/// Names of the rendering qualities.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum QualityName {
    /// The quality of the window without a graphics card.
    Quick,
    /// Antialiased edges.
    Smooth,
    /// In addition contact shadows, finer maps and textures, ambient occlusion, depth of field and bloom.
    Best,
}

impl From<QualityName> for Quality {
    fn from(name: QualityName) -> Self {
        match name {
            QualityName::Quick => Self::Quick,
            QualityName::Smooth => Self::Smooth,
            QualityName::Best => Self::Best,
        }
    }
}

/// Names of the stereo modes.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum StereoName {
    /// Red for the left eye, cyan for the right.
    Anaglyph,
    /// The picture of the left eye in the left half.
    SideBySide,
}

impl From<StereoName> for Stereo {
    fn from(name: StereoName) -> Self {
        match name {
            StereoName::Anaglyph => Self::Anaglyph,
            StereoName::SideBySide => Self::SideBySide,
        }
    }
}
