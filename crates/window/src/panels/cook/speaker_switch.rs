//! The switch of the sound: a loudspeaker, with the volume where the mouse rests on it.

use egui::accesskit::Role;
use egui::{Color32, Painter, Pos2, Shape, Stroke, Ui, WidgetInfo, vec2};

use crate::ui::aloud::spoken_value;
use crate::ui::{fingers, theme};
use saute_controls::act::{Act, Acts, AppAct, Setting};
use saute_controls::context::PanelContext;

/// Width of the switch [points].
pub const WIDTH: f32 = 36.0;
/// Width of the volume's slider [points].
const SLIDER: f32 = 120.0;
/// Angle between the middle and an end of a wave of the drawing [rad].
const WAVE: f32 = 0.8;

/// Shows the switch, `height` points high; nothing where a study leaves no sound.
pub fn show(state: &PanelContext, ui: &mut Ui, acts: &mut Acts, height: f32) {
    let (l, on) = (state.settings.language, state.settings.sound);
    let act = Act::App(AppAct::Set(Setting::Sound(!on)));
    if state.forbids(&act) {
        return;
    }
    let palette = theme::of(ui);
    let response = ui.add(palette.button("", false).min_size(vec2(WIDTH, fingers::height(ui, height))));
    response.widget_info(|| WidgetInfo::selected(Role::Switch, true, on, l.text("heard.title")));
    paint(ui.painter(), response.rect.center(), if on { palette.text } else { palette.quiet }, on);
    if response.clicked() {
        acts.push(act);
    }
    response.on_hover_ui(|ui| {
        ui.label(l.text(if on { "heard.turn_off" } else { "heard.turn_on" }));
        ui.horizontal(|ui| {
            ui.label(l.text("heard.volume"));
            volume(state, ui, acts);
        });
    });
}

/// Shows the volume as a slider.
pub fn volume(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    let mut volume = state.settings.volume;
    ui.spacing_mut().slider_width = SLIDER;
    let response = ui.add(egui::Slider::new(&mut volume, 0.0..=1.0).show_value(false));
    let name = state.settings.language.text("heard.volume");
    response.widget_info(|| WidgetInfo::slider(true, volume, name));
    spoken_value(ui, &response, format!("{:.0} %", 100.0 * volume));
    if response.changed() {
        acts.push(Act::App(AppAct::Set(Setting::Volume(volume))));
        // Who turns it up wants to hear it.
        if !state.settings.sound {
            acts.push(Act::App(AppAct::Set(Setting::Sound(true))));
        }
    }
}

/// A loudspeaker with two waves, or with a cross.
fn paint(painter: &Painter, at: Pos2, ink: Color32, on: bool) {
    let at = at - vec2(4.0, 0.0);
    let cone = [(-6.0, -3.0), (-2.5, -3.0), (2.5, -7.5), (2.5, 7.5), (-2.5, 3.0), (-6.0, 3.0)];
    let points = cone.map(|(x, y)| at + vec2(x, y));
    // Two convex parts: the box, and the cone before it.
    painter.add(Shape::convex_polygon(vec![points[0], points[1], points[4], points[5]], ink, Stroke::NONE));
    painter.add(Shape::convex_polygon(points[1..5].to_vec(), ink, Stroke::NONE));
    let stroke = Stroke::new(1.8, ink);
    if !on {
        painter.line_segment([at + vec2(6.0, -4.0), at + vec2(13.0, 4.0)], stroke);
        painter.line_segment([at + vec2(6.0, 4.0), at + vec2(13.0, -4.0)], stroke);
        return;
    }
    for radius in [6.0, 10.5] {
        let wave = (-4..=4).map(|step| at + vec2(1.5, 0.0) + radius * egui::Vec2::angled(WAVE * step as f32 / 4.0));
        painter.add(Shape::line(wave.collect(), stroke));
    }
}
