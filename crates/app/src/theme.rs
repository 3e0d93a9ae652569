//! Colours, type and spacing of the panels.

use egui::{Color32, CornerRadius, FontFamily, FontId, Frame, Margin, Stroke, TextStyle, Visuals};

/// The one accent: a gas-flame orange (chosen).
pub const ACCENT: Color32 = Color32::from_rgb(236, 138, 60);
/// Text on the accent.
pub const ON_ACCENT: Color32 = Color32::from_rgb(28, 18, 10);
/// Panel ground, let through a little.
pub const GROUND: Color32 = Color32::from_rgba_premultiplied(20, 19, 18, 236);
/// Ground of what covers everything.
pub const SOLID: Color32 = Color32::from_rgb(26, 25, 24);
/// Raised controls.
pub const RAISED: Color32 = Color32::from_rgb(46, 44, 42);
/// Text.
pub const TEXT: Color32 = Color32::from_rgb(236, 231, 224);
/// Quiet text.
pub const QUIET: Color32 = Color32::from_rgb(173, 166, 157);
/// Curves: pan, core, surface.
pub const CURVES: [Color32; 3] =
    [Color32::from_rgb(236, 138, 60), Color32::from_rgb(226, 86, 104), Color32::from_rgb(224, 200, 120)];
/// Probes 1 to 6: lightness differs as well as hue (chosen: apart on the dark ground with and without red or green).
const PROBES: [Color32; 6] = [
    Color32::from_rgb(122, 192, 255),
    Color32::from_rgb(250, 236, 150),
    Color32::from_rgb(92, 158, 120),
    Color32::from_rgb(214, 162, 240),
    Color32::from_rgb(236, 236, 236),
    Color32::from_rgb(196, 132, 92),
];

/// Colour of a probe, by its number from 1.
pub fn probe(number: usize) -> Color32 {
    PROBES[number.saturating_sub(1) % PROBES.len()]
}

/// Colours of the pictures on the card of the first start.
pub const STEAK_RAW: Color32 = Color32::from_rgb(186, 52, 58);
/// Warm, not yet grey.
pub const STEAK_PINK: Color32 = Color32::from_rgb(206, 112, 104);
/// Grey-brown.
pub const STEAK_DONE: Color32 = Color32::from_rgb(160, 118, 98);
/// Browned.
pub const STEAK_CRUST: Color32 = Color32::from_rgb(98, 56, 32);
/// The rim of fat.
pub const STEAK_FAT: Color32 = Color32::from_rgb(238, 214, 190);
/// The shaded side.
pub const STEAK_SIDE: Color32 = Color32::from_rgb(122, 34, 40);
/// A board, and its edge.
pub const WOOD: Color32 = Color32::from_rgb(196, 150, 98);
/// Its edge.
pub const WOOD_SIDE: Color32 = Color32::from_rgb(140, 100, 60);
/// A pan.
pub const IRON: Color32 = Color32::from_rgb(22, 22, 24);

/// Corner radius of a panel [points].
pub const CORNER: u8 = 12;
/// Height of a control that a finger can hit [points].
pub const TOUCH: f32 = 44.0;

/// Applies the theme.
pub fn apply(ctx: &egui::Context) {
    ctx.set_theme(egui::Theme::Dark);
    ctx.all_styles_mut(|style| {
        style.visuals = visuals();
        style.spacing.item_spacing = egui::vec2(8.0, 7.0);
        style.spacing.button_padding = egui::vec2(12.0, 6.0);
        style.spacing.interact_size.y = 30.0;
        style.spacing.slider_width = 150.0;
        let size = |text_style: &TextStyle| match text_style {
            TextStyle::Small => 12.5,
            TextStyle::Heading => 19.0,
            _ => 15.0,
        };
        let family = |text_style: &TextStyle| {
            if *text_style == TextStyle::Monospace { FontFamily::Monospace } else { FontFamily::Proportional }
        };
        let styles: Vec<TextStyle> = style.text_styles.keys().cloned().collect();
        for text_style in styles {
            let font = FontId::new(size(&text_style), family(&text_style));
            style.text_styles.insert(text_style, font);
        }
    });
}

fn visuals() -> Visuals {
    let mut v = Visuals::dark();
    v.override_text_color = Some(TEXT);
    v.panel_fill = GROUND;
    v.window_fill = GROUND;
    v.selection.bg_fill = ACCENT;
    v.selection.stroke = Stroke::new(1.0, ON_ACCENT);
    v.slider_trailing_fill = true;
    for widget in [
        &mut v.widgets.inactive,
        &mut v.widgets.hovered,
        &mut v.widgets.active,
        &mut v.widgets.open,
        &mut v.widgets.noninteractive,
    ] {
        widget.corner_radius = CornerRadius::same(8);
    }
    v.widgets.inactive.weak_bg_fill = RAISED;
    v.widgets.inactive.bg_fill = RAISED;
    v.widgets.hovered.weak_bg_fill = Color32::from_rgb(62, 59, 56);
    v.widgets.hovered.bg_stroke = Stroke::new(1.0, QUIET);
    v.widgets.active.weak_bg_fill = Color32::from_rgb(80, 74, 68);
    v.widgets.noninteractive.bg_stroke = Stroke::new(1.0, Color32::from_rgb(58, 55, 52));
    v
}

/// The frame of a floating panel.
pub fn panel() -> Frame {
    Frame::new().fill(GROUND).corner_radius(CornerRadius::same(CORNER)).inner_margin(Margin::same(12))
}

/// A large button; filled with the accent where `on`.
pub fn button(text: &str, on: bool) -> egui::Button<'static> {
    let rich = egui::RichText::new(text.to_owned()).size(15.0);
    let rich = if on { rich.color(ON_ACCENT) } else { rich };
    let button = egui::Button::new(rich).min_size(egui::vec2(TOUCH, TOUCH));
    if on { button.fill(ACCENT) } else { button }
}
