//! The switch of the sound: a loudspeaker, with the volume where the mouse rests on it.

use egui::accesskit::Role;
use egui::{Ui, WidgetInfo, vec2};

use crate::ui::aloud::spoken_value;
use crate::ui::loudspeaker::Loudspeaker;
use crate::ui::{fingers, theme};
use saute_controls::act::{Act, Acts, AppAct, Setting};
use saute_controls::context::PanelContext;

/// Width of the switch [points].
pub const WIDTH: f32 = 36.0;
/// Width of the volume's slider [points].
const SLIDER: f32 = 120.0;

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
    let drawn = Loudspeaker { ink: if on { palette.text } else { palette.quiet }, scale: 1.0, on };
    drawn.paint(ui.painter(), response.rect.center());
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
