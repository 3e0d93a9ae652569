//! The stacked bar of the classes of doneness: colour, pattern, words and numbers; or what else has changed.

use egui::{Color32, ComboBox, Painter, Rect, RichText, Sense, Ui, pos2, vec2};
use saute_kitchen::food::Scale;
use saute_kitchen::food::change::doneness::Measure;
use saute_picture::colour::map::Tone;

use crate::panels::section_read::Inside;
use crate::ui::{fingers, theme};
use saute_controls::act::{Act, Acts, AppAct, Setting};
use saute_controls::context::PanelContext;
use saute_controls::settings::Settings;
use saute_words::doneness_words;
use saute_words::piece_words::change;

/// Bounds of a class in the chosen unit; the first and the last have the unit.
fn range(settings: &Settings, scale: &Scale, class: usize) -> String {
    let share = scale.measure() == Measure::Share;
    let shown = |bound: f64| if share { bound } else { settings.degrees(bound) };
    let unit = if share { "%" } else { settings.unit() };
    let from = shown(scale.from(class));
    match (class, scale.end(class).map(shown)) {
        (0, Some(end)) => format!("< {end:.0} {unit}"),
        (_, Some(end)) => format!("{from:.0}–{end:.0}"),
        (_, None) => format!("> {from:.0} {unit}"),
    }
}

/// Shows the shares of a section in the words of the food, or the changes of a food without a scale.
pub fn show(state: &PanelContext, inside: &Inside, ui: &mut Ui, acts: &mut Acts) {
    let Some(scale) = state.scale() else {
        changes(state, inside, ui);
        return;
    };
    selector(state, ui, acts, &scale);
    bar(state, inside, ui, &scale);
    columns(state, inside, ui, &scale);
}

/// The scale's label; a click chooses another.
fn selector(state: &PanelContext, ui: &mut Ui, acts: &mut Acts, scale: &Scale) {
    let l = state.settings.language;
    ui.horizontal(|ui| {
        ui.spacing_mut().interact_size.y = fingers::height(ui, 22.0);
        ui.spacing_mut().button_padding = vec2(8.0, 2.0);
        ui.label(RichText::new(l.text("doneness.by")).size(12.5).color(theme::of(ui).quiet));
        let own = doneness_words::label(scale, l);
        let text = RichText::new(own).size(13.0);
        let combo = ComboBox::from_id_salt("scale").selected_text(text).width(ui.available_width() - 4.0);
        let mut chosen = None;
        let shown = combo.show_ui(ui, |ui| {
            for other in &state.session.fitting_scales() {
                if ui.selectable_label(other.id == scale.id, doneness_words::label(other, l)).clicked() {
                    chosen = Some(other.id.clone());
                }
            }
        });
        let name = l.fill("doneness.scale", &[("scale", &own)]);
        shown.response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::ComboBox, true, &name));
        shown.response.on_hover_text(l.text("doneness.another"));
        if let Some(other) = chosen {
            acts.push(Act::App(AppAct::Set(Setting::Scale(other))));
        }
    });
}

fn bar(state: &PanelContext, inside: &Inside, ui: &mut Ui, scale: &Scale) {
    let shares = inside.shares.0;
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), 20.0), Sense::hover());
    let l = state.settings.language;
    let share = |name: &str, share: f64| {
        l.fill(
            "doneness.share",
            &[("class", &doneness_words::class(scale, name, l)), ("percent", &format!("{share:.0}"))],
        )
    };
    let spoken: Vec<String> = scale.class.iter().zip(shares).map(|(c, s)| share(&c.name, s)).collect();
    let spoken = spoken.join(l.text("doneness.list_joint"));
    let spoken = l.fill("doneness.section", &[("scale", &doneness_words::label(scale, l)), ("shares", &spoken)]);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Label, true, &spoken));
    let hint = match scale.measure() {
        Measure::Peak => l.text("doneness.section_hint").to_owned(),
        Measure::Share => l.fill("doneness.section_hint_change", &[("change", &l.called("change", &scale.for_change))]),
    };
    response.on_hover_text(hint);
    let mut left = rect.left();
    for (class, share) in (0..scale.class.len()).zip(shares) {
        let width = rect.width() * share as f32 / 100.0;
        if width > 0.0 {
            let part = Rect::from_min_size(pos2(left, rect.top()), vec2(width, rect.height()));
            swatch(ui.painter(), part, Tone::of(scale, class));
        }
        left += width;
    }
}

/// Number, name and range of each class, side by side; longer names get more room.
fn columns(state: &PanelContext, inside: &Inside, ui: &mut Ui, scale: &Scale) {
    let gap = 4.0;
    let room = ui.available_width() - gap * (scale.class.len() - 1) as f32;
    // As many letters as its name or its range needs, at least.
    let l = state.settings.language;
    let name = |c: usize| doneness_words::class(scale, &scale.class[c].name, l);
    let letters = |c: usize| width_in_letters(name(c)).max(6.0);
    let all: f32 = (0..scale.class.len()).map(letters).sum();
    ui.horizontal_top(|ui| {
        ui.spacing_mut().item_spacing.x = gap;
        for class in 0..scale.class.len() {
            let size = vec2(room * letters(class) / all, 0.0);
            ui.allocate_ui_with_layout(size, egui::Layout::top_down(egui::Align::Min), |ui| {
                ui.set_width(size.x);
                ui.spacing_mut().item_spacing.y = 1.0;
                let (mark, _) = ui.allocate_exact_size(vec2(18.0, 10.0), Sense::hover());
                swatch(ui.painter(), mark, Tone::of(scale, class));
                let small = if scale.class.len() > 4 { 11.0 } else { 12.5 };
                let share = RichText::new(format!("{:.0} %", inside.shares.0[class])).size(16.0).strong();
                ui.add(egui::Label::new(share).extend());
                ui.add(egui::Label::new(RichText::new(name(class)).size(small)).extend());
                let range = RichText::new(range(state.settings, scale, class)).size(11.0).color(theme::of(ui).quiet);
                ui.add(egui::Label::new(range).extend());
            });
        }
    });
}

/// How many Latin letters wide a name is; a kana or kanji is as wide as 1.6 of them in the fonts of the panel.
fn width_in_letters(name: &str) -> f32 {
    name.chars().map(|c| if c.is_ascii() { 1.0 } else { 1.6 }).sum()
}

/// What heat has changed in a food without a scale of doneness: name and mean share of each change.
fn changes(state: &PanelContext, inside: &Inside, ui: &mut Ui) {
    let l = state.settings.language;
    let caption = l.text("doneness.changed");
    ui.label(RichText::new(caption).size(12.5).color(theme::of(ui).quiet));
    for (name, share) in &inside.changed {
        let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), 20.0), Sense::hover());
        let text = change(l, name, *share);
        let name = l.called("change", name);
        response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Label, true, &text));
        let track = Rect::from_min_max(
            pos2(rect.left() + 92.0, rect.top() + 4.0),
            pos2(rect.right() - 52.0, rect.bottom() - 4.0),
        );
        let full = Rect::from_min_size(track.min, vec2(track.width() * *share as f32, track.height()));
        let (painter, font) = (ui.painter(), egui::FontId::proportional(14.0));
        painter.text(rect.left_center(), egui::Align2::LEFT_CENTER, name, font.clone(), theme::of(ui).text);
        painter.rect_filled(track, 3.0, theme::of(ui).raised);
        painter.rect_filled(full, 3.0, theme::of(ui).curves[2]);
        let percent = format!("{:.0} %", 100.0 * share);
        painter.text(rect.right_center(), egui::Align2::RIGHT_CENTER, percent, font, theme::of(ui).text);
    }
}

/// A patch in a class's colour and pattern, so that no class is shown by hue alone.
pub fn swatch(painter: &Painter, rect: Rect, tone: Tone) {
    let [r, g, b] = tone.colour();
    painter.rect_filled(rect, 2.0, Color32::from_rgb(r, g, b));
    crate::paint::hatch::paint(tone.pattern(), painter, rect);
}
