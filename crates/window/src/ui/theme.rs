//! The theme of the panels: which palette applies, type and spacing.

use egui::{
    CornerRadius, FontFamily, FontId, Frame, Margin, Response, Stroke, StrokeKind, Style, TextEdit, TextStyle, Ui,
    Visuals,
};

use crate::ui::palette::Palette;

/// Corner radius of a panel [points].
pub const CORNER: u8 = 12;
/// Corner radius of a control [points].
pub const CONTROL_CORNER: u8 = 8;
/// Height of a control that a finger can hit [points].
pub const TOUCH: f32 = 44.0;

/// The colours that apply here.
pub fn of(ui: &Ui) -> &'static Palette {
    Palette::of(ui.visuals().dark_mode)
}

/// Shows a field into which text is typed, with an edge: an empty one has nothing else by which it is seen.
pub fn field(ui: &mut Ui, edit: TextEdit) -> Response {
    let palette = of(ui);
    let shown = ui.scope(|ui| {
        ui.visuals_mut().widgets.inactive.bg_stroke = Stroke::new(1.0, palette.quiet);
        ui.add(edit)
    });
    let response = shown.inner;
    if response.has_focus() {
        ui.painter().rect_stroke(response.rect, CONTROL_CORNER, Stroke::new(2.0, palette.text), StrokeKind::Inside);
    }
    response
}

/// Sets up both themes; the settings choose one.
pub fn install(ctx: &egui::Context) {
    // The size of the interface is a setting, which has those keys.
    ctx.options_mut(|options| options.zoom_with_keyboard = false);
    for theme in [egui::Theme::Dark, egui::Theme::Light] {
        ctx.style_mut_of(theme, |style| {
            style.visuals = visuals(Palette::of(theme == egui::Theme::Dark));
            shape(style);
        });
    }
}

/// Spacing and type.
fn shape(style: &mut Style) {
    style.spacing.item_spacing = egui::vec2(8.0, 7.0);
    style.spacing.button_padding = egui::vec2(12.0, 6.0);
    style.spacing.interact_size.y = 30.0;
    style.spacing.slider_width = 150.0;
    // What scrolls shows it before anybody tries: its bar has a place of its own and is never invisible.
    style.spacing.scroll = egui::style::ScrollStyle {
        floating_allocated_width: 5.0,
        dormant_handle_opacity: 0.5,
        ..egui::style::ScrollStyle::floating()
    };
    let size = |text_style: &TextStyle| match text_style {
        TextStyle::Small => 12.5,
        TextStyle::Heading => 19.0,
        _ => 15.0,
    };
    let family = |text_style: &TextStyle| {
        if *text_style == TextStyle::Monospace { FontFamily::Monospace } else { FontFamily::Proportional }
    };
    for (text_style, font) in &mut style.text_styles {
        *font = FontId::new(size(text_style), family(text_style));
    }
}

fn visuals(p: &Palette) -> Visuals {
    let mut v = if p.dark { Visuals::dark() } else { Visuals::light() };
    v.panel_fill = p.ground;
    v.window_fill = p.ground;
    v.extreme_bg_color = p.sunken;
    v.selection.bg_fill = p.chosen;
    v.selection.stroke = Stroke::new(1.0, p.on_chosen);
    v.slider_trailing_fill = true;
    v.weak_text_color = Some(p.quiet);
    for widget in [
        &mut v.widgets.inactive,
        &mut v.widgets.hovered,
        &mut v.widgets.active,
        &mut v.widgets.open,
        &mut v.widgets.noninteractive,
    ] {
        widget.corner_radius = CornerRadius::same(CONTROL_CORNER);
        // Text takes this colour, except on what is chosen: there `selection` applies.
        widget.fg_stroke.color = p.text;
    }
    // What has the focus of the keyboard, and what is pressed.
    v.widgets.active.bg_stroke = Stroke::new(2.0, p.text);
    v.widgets.inactive.weak_bg_fill = p.raised;
    v.widgets.inactive.bg_fill = p.raised;
    v.widgets.hovered.weak_bg_fill = p.hovered;
    v.widgets.hovered.bg_stroke = Stroke::new(1.0, p.quiet);
    v.widgets.active.weak_bg_fill = p.pressed;
    v.widgets.open.weak_bg_fill = p.hovered;
    v.widgets.noninteractive.bg_stroke = Stroke::new(1.0, p.line);
    v
}

impl Palette {
    /// The frame of a floating panel.
    pub fn panel(&self) -> Frame {
        Frame::new().fill(self.ground).corner_radius(CornerRadius::same(CORNER)).inner_margin(Margin::same(12))
    }

    /// A large button; filled where it is `on`.
    pub fn button(&self, text: &str, on: bool) -> egui::Button<'static> {
        self.filled(text, on.then_some((self.chosen, self.on_chosen)))
    }

    /// The large button of what is to be done now.
    pub fn primary(&self, text: &str) -> egui::Button<'static> {
        self.filled(text, Some((self.accent, self.on_accent)))
    }

    fn filled(&self, text: &str, fill: Option<(egui::Color32, egui::Color32)>) -> egui::Button<'static> {
        let rich = egui::RichText::new(text.to_owned()).size(15.0);
        let rich = if let Some((_, ink)) = fill { rich.color(ink) } else { rich };
        let button = egui::Button::new(rich).min_size(egui::vec2(TOUCH, TOUCH));
        if let Some((ground, _)) = fill { button.fill(ground) } else { button }
    }
}
