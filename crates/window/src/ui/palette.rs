//! The colours of the panels, for a dark and for a light ground.

use egui::Color32;

/// The colours of one theme.
#[derive(Clone, Debug, PartialEq)]
pub struct Palette {
    /// True if text is lighter than its ground.
    pub dark: bool,
    /// The one accent, the orange of a gas flame: what is to be done now, and nothing else.
    pub accent: Color32,
    /// Text on the accent.
    pub on_accent: Color32,
    /// What is chosen, and how far something is.
    pub chosen: Color32,
    /// Text on what is chosen.
    pub on_chosen: Color32,
    /// Ground of a panel, let through a little.
    pub ground: Color32,
    /// Ground of what covers everything.
    pub solid: Color32,
    /// Ground of the curves and of what text is typed into.
    pub sunken: Color32,
    /// Ground of controls.
    pub raised: Color32,
    /// Ground of a control under the pointer.
    pub hovered: Color32,
    /// Ground of a control that is pressed.
    pub pressed: Color32,
    /// Lines that part.
    pub line: Color32,
    /// Text.
    pub text: Color32,
    /// Quiet text.
    pub quiet: Color32,
    /// Curves: pan, core, surface.
    pub curves: [Color32; 3],
    /// Probes 1 to 6.
    probes: [Color32; 6],
}

impl Palette {
    /// Colours of the present theme.
    pub fn of(dark: bool) -> &'static Self {
        if dark { &DARK } else { &LIGHT }
    }

    /// Colour of a probe, by its number from 1.
    pub fn probe(&self, number: usize) -> Color32 {
        self.probes[number.saturating_sub(1) % self.probes.len()]
    }

    /// Colour of a way next to others, by its slot from 0: they are distinguished as probes are.
    pub fn way(&self, slot: usize) -> Color32 {
        self.probe(slot + 1)
    }
}

/// A kitchen at night (chosen: the pan is the brightest thing in the window).
static DARK: Palette = Palette {
    dark: true,
    accent: Color32::from_rgb(236, 138, 60),
    on_accent: Color32::from_rgb(28, 18, 10),
    chosen: Color32::from_rgb(204, 197, 186),
    on_chosen: Color32::from_rgb(24, 22, 20),
    ground: Color32::from_rgba_premultiplied(20, 19, 18, 236),
    solid: Color32::from_rgb(26, 25, 24),
    sunken: Color32::from_rgb(10, 10, 10),
    raised: Color32::from_rgb(46, 44, 42),
    hovered: Color32::from_rgb(62, 59, 56),
    pressed: Color32::from_rgb(80, 74, 68),
    line: Color32::from_rgb(58, 55, 52),
    text: Color32::from_rgb(236, 231, 224),
    quiet: Color32::from_rgb(173, 166, 157),
    curves: [Color32::from_rgb(236, 138, 60), Color32::from_rgb(226, 86, 104), Color32::from_rgb(224, 200, 120)],
    // Lightness differs as well as hue (chosen: apart with and without red or green).
    probes: [
        Color32::from_rgb(122, 192, 255),
        Color32::from_rgb(250, 236, 150),
        Color32::from_rgb(98, 164, 126),
        Color32::from_rgb(214, 162, 240),
        Color32::from_rgb(236, 236, 236),
        Color32::from_rgb(196, 132, 92),
    ],
};

/// Warm paper in a bright room or on a projector (chosen: the same hues, dark enough for paper).
static LIGHT: Palette = Palette {
    dark: false,
    accent: Color32::from_rgb(156, 68, 8),
    on_accent: Color32::from_rgb(255, 250, 244),
    chosen: Color32::from_rgb(84, 75, 64),
    on_chosen: Color32::from_rgb(255, 250, 244),
    ground: Color32::from_rgba_premultiplied(235, 230, 221, 246),
    solid: Color32::from_rgb(247, 243, 236),
    sunken: Color32::from_rgb(255, 253, 249),
    raised: Color32::from_rgb(226, 218, 206),
    hovered: Color32::from_rgb(214, 204, 190),
    pressed: Color32::from_rgb(200, 188, 171),
    line: Color32::from_rgb(205, 196, 182),
    text: Color32::from_rgb(36, 31, 26),
    quiet: Color32::from_rgb(88, 79, 68),
    curves: [Color32::from_rgb(176, 76, 8), Color32::from_rgb(176, 26, 62), Color32::from_rgb(122, 98, 0)],
    // All dark enough to be read as numbers; where lightness does not separate the curves, their dashes do (chosen).
    probes: [
        Color32::from_rgb(0, 86, 168),
        Color32::from_rgb(104, 84, 0),
        Color32::from_rgb(0, 98, 62),
        Color32::from_rgb(128, 44, 160),
        Color32::from_rgb(58, 58, 58),
        Color32::from_rgb(124, 56, 16),
    ],
};
