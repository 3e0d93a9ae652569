//! Views, white balances, qualities and ways of stereo by their names on the command line.

use clap::ValueEnum;
use saute_picture::View;
use saute_scene::light::white_balance::WhiteBalance;
use saute_scene::quality::Quality;
use saute_window::mirror::stereo::Stereo;

/// The views by their names on the command line.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum ViewName {
    /// As the eye sees it.
    Look,
    /// Temperature now.
    Temperature,
    /// Water left, of what the raw food held there.
    Moisture,
    /// Doneness by the highest temperature so far.
    Doneness,
    /// Browning index.
    Browning,
    /// How far pathogens were killed.
    Lethality,
    /// Fat in the flesh.
    Marbling,
}

impl From<ViewName> for View {
    fn from(name: ViewName) -> Self {
        match name {
            ViewName::Look => Self::Look,
            ViewName::Temperature => Self::Temperature,
            ViewName::Moisture => Self::Moisture,
            ViewName::Doneness => Self::Doneness,
            ViewName::Browning => Self::Browning,
            ViewName::Lethality => Self::Lethality,
            ViewName::Marbling => Self::Marbling,
        }
    }
}

/// The white balances by their names on the command line.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum WhiteName {
    /// A kitchen in the evening sun (5750 K).
    AsShot,
    /// White is white (6500 K).
    Neutral,
    /// As under an overcast sky (8000 K).
    Cool,
    /// As under a lamp (4500 K).
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

/// The qualities by their names on the command line.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum QualityName {
    /// As the window draws without a graphics card.
    Quick,
    /// Smooth edges everywhere.
    Smooth,
    /// Besides, shadows where food touches the ground, and finer maps and textures.
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

/// Ways of stereo by their names on the command line.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum StereoName {
    /// Red for the left eye, cyan for the right.
    Anaglyph,
    /// The left eye's picture in the left half.
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
