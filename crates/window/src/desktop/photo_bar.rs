//! The bar of the photo mode: exposure, blur, size, and what makes a picture or a time lapse.

use egui::{Align2, Area, Id, ProgressBar, Rect, RichText, Slider, Ui, vec2};
use saute_scene::light::photo::Photo;

use crate::bindings::hint;
use crate::desktop::photo::PhotoMode;
use crate::ui::layout::GAP;
use crate::ui::theme;
use saute_controls::act::{Act, Acts, AppAct, HostAct, SIZES};
use saute_controls::context::PanelContext;

/// Width of a slider [points].
const SLIDER: f32 = 110.0;
/// Below this width of the window the bar has several rows [points] (chosen: one row of it fits).
const NARROW: f32 = 1240.0;

/// Shows the bar at the lower edge of the scene.
pub fn show(state: &PanelContext, photo: &PhotoMode, ui: &Ui, acts: &mut Acts, whole: Rect) {
    let at = whole.center_bottom() - vec2(0.0, GAP);
    let area = Area::new(Id::unique("photo")).fixed_pos(at).pivot(Align2::CENTER_BOTTOM).constrain_to(whole);
    area.show(ui.ctx(), |ui| {
        ui.set_max_width(whole.width() - 2.0 * GAP);
        theme::of(ui).panel().show(ui, |ui| {
            let mut choice = photo.choice;
            ui.spacing_mut().interact_size.y = theme::TOUCH;
            ui.spacing_mut().slider_width = SLIDER;
            let mut rows: [&mut dyn FnMut(&mut Ui); 4] = [
                &mut |ui| exposure(state, ui, &mut choice.photo.exposure_ev),
                &mut |ui| blur(state, ui, &mut choice.photo.aperture),
                &mut |ui| sizes(ui, &mut choice.size),
                &mut |ui| buttons(state, photo, ui, acts),
            ];
            if whole.width() < NARROW {
                rows.iter_mut().for_each(|row| drop(ui.horizontal_wrapped(row)));
            } else {
                ui.horizontal(|ui| rows.iter_mut().for_each(|row| row(ui)));
            }
            if choice != photo.choice {
                acts.push(Act::App(AppAct::Host(HostAct::SetPhoto(choice))));
            }
        });
    });
}

fn exposure(state: &PanelContext, ui: &mut Ui, ev: &mut f32) {
    ui.label(state.settings.language.text("photo.exposure"));
    ui.add(Slider::new(ev, Photo::EXPOSURES_EV).fixed_decimals(1).suffix(" EV"));
}

fn blur(state: &PanelContext, ui: &mut Ui, aperture: &mut f32) {
    let l = state.settings.language;
    ui.label(l.text("photo.blur")).on_hover_text(l.text("photo.blur_hint"));
    ui.add(Slider::new(aperture, Photo::APERTURES).fixed_decimals(1).suffix("×"));
}

fn sizes(ui: &mut Ui, chosen: &mut [u32; 2]) {
    ui.spacing_mut().button_padding.x = 6.0;
    for size in SIZES {
        let text = format!("{} × {}", size[0], size[1]);
        if ui.add(theme::of(ui).button(&text, *chosen == size)).clicked() {
            *chosen = size;
        }
    }
}

fn buttons(state: &PanelContext, photo: &PhotoMode, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    if let Some(progress) = photo.progress() {
        let text = RichText::new(l.text("photo.making")).size(13.0);
        ui.add(ProgressBar::new(progress).desired_width(180.0).text(text));
    } else {
        for (key, act, first) in [
            ("photo.take", Act::App(AppAct::Picture), true),
            ("photo.lapse", Act::App(AppAct::Host(HostAct::TimeLapse)), false),
        ] {
            let shown = ui.add(theme::of(ui).button(l.text(key), first));
            let explained = if first { hint(&act, l) } else { l.text("photo.lapse_hint").to_owned() };
            if shown.on_hover_text(explained).clicked() {
                acts.push(act);
            }
        }
    }
    if ui.add(theme::of(ui).button(l.text("settings.done"), false)).clicked() {
        acts.push(Act::App(AppAct::Photo));
    }
}
