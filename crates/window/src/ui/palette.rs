//! The colours of the panels, for a dark and for a light ground.

use egui::Color32;

/// The colours of one theme.
#[derive(Clone, Debug, PartialEq)]
pub struct Palette {
    /// True if text is lighter than its ground.
    pub dark: bool,
    /// The one accent, the orange of a gas flame: what is on, and what is urgent.
    pub accent: Color32,
    /// Text on the accent.
    pub on_accent: Color32,
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

    /// Colour of a way beside others, by its slot from 0: they are told apart as probes are.
    pub fn way(&self, slot: usize) -> Color32 {
        self.probe(slot + 1)
    }
}

/// A kitchen at night (chosen: the pan is the brightest thing in the window).
static DARK: Palette = Palette {
    dark: true,
    accent: Color32::from_rgb(236, 138, 60),
    on_accent: Color32::from_rgb(28, 18, 10),
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

#[cfg(test)]
mod tests {
    use saute_kitchen::food::change::colour::decoded;

    use super::*;

    /// Relative luminance by WCAG 2.2.
    fn luminance(colour: Color32) -> f64 {
        let linear = |v: u8| decoded(f64::from(v) / 255.0);
        0.2126 * linear(colour.r()) + 0.7152 * linear(colour.g()) + 0.0722 * linear(colour.b())
    }

    /// Contrast ratio by WCAG 2.2 (1–21).
    fn contrast(a: Color32, b: Color32) -> f64 {
        let (a, b) = (luminance(a), luminance(b));
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    /// Grounds that text stands on: a panel over the darkest and the brightest scene, a card, a control.
    fn grounds(p: &Palette) -> Vec<Color32> {
        let over = |scene: u8| {
            let seen = |v: u8| v.saturating_add((u16::from(scene) * u16::from(255 - p.ground.a()) / 255) as u8);
            Color32::from_rgb(seen(p.ground.r()), seen(p.ground.g()), seen(p.ground.b()))
        };
        vec![over(0), over(255), p.solid, p.raised]
    }

    #[track_caller]
    fn at_least(least: f64, p: &Palette, ink: Color32, ground: Color32) {
        let got = contrast(ink, ground);
        assert!(got >= least, "dark {}: {ink:?} on {ground:?}: {got:.2} < {least}", p.dark);
    }

    #[test]
    fn the_contrast_of_black_on_white_is_21() {
        assert!((contrast(Color32::BLACK, Color32::WHITE) - 21.0).abs() < 1e-9);
    }

    #[test]
    fn text_has_the_contrast_of_wcag_aa_in_both_themes() {
        for p in [&DARK, &LIGHT] {
            for ground in grounds(p) {
                at_least(4.5, p, p.text, ground);
                at_least(4.5, p, p.quiet, ground);
                at_least(4.5, p, p.accent, ground);
            }
            at_least(4.5, p, p.text, p.hovered);
            at_least(4.5, p, p.text, p.pressed);
            at_least(4.5, p, p.text, p.sunken);
            at_least(4.5, p, p.on_accent, p.accent);
        }
    }

    #[test]
    fn what_is_on_and_what_has_the_focus_is_told_from_its_ground_in_both_themes() {
        for p in [&DARK, &LIGHT] {
            for ground in grounds(p) {
                at_least(3.0, p, p.accent, ground);
                at_least(3.0, p, p.quiet, ground);
            }
        }
    }

    #[test]
    fn curves_and_probes_stand_out_from_the_ground_of_the_curves_in_both_themes() {
        for p in [&DARK, &LIGHT] {
            p.curves.iter().chain(&p.probes).for_each(|&ink| at_least(3.0, p, ink, p.sunken));
            // Their values are written in their colours.
            p.probes.iter().for_each(|&ink| at_least(4.5, p, ink, p.raised));
            p.curves.iter().chain(&p.probes).for_each(|&ink| at_least(4.5, p, ink, p.solid));
            p.probes.iter().for_each(|&ink| at_least(4.5, p, p.on_accent, ink));
        }
    }
}
