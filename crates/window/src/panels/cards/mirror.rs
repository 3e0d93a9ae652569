//! The card of the half mirror: window, rig, projector, stereo, calibration with its numbers.

use egui::{Align, DragValue, Layout, Response, RichText, ScrollArea, TextEdit, Ui, vec2};

use super::setting_row::{NAMES, explained, row};
use super::settings::{NARROW, WIDTH};
use crate::mirror::view::{MirrorView, stereo_word};
use crate::panels::cards::frame::Framed;
use crate::ui::theme;
use saute_controls::act::{Act, Acts, AppAct, Card, Setting};
use saute_controls::context::PanelContext;
use saute_controls::reads_context;
use saute_mirror::calibration::Calibration;
use saute_mirror::rig::Rig;
use saute_mirror::rig_file::SHIPPED;
use saute_mirror::settings::{MirrorSettings, WIDEST_MM};
use saute_mirror::stereo::Stereo;

/// What the card reads.
pub struct MirrorState<'a> {
    /// What every panel reads.
    pub context: PanelContext<'a>,
    /// The half mirror's window.
    pub mirror: &'a MirrorView,
}

reads_context!(MirrorState);

/// Shows the card over everything; Esc, the button or a click beside it closes it.
pub fn show(state: &MirrorState, ui: &Ui, acts: &mut Acts, whole: egui::Rect) {
    let framed = Framed { card: Card::Mirror, id: "mirror", title: "half_mirror.title", width: WIDTH };
    framed.show(state, ui, acts, whole, |ui, acts| {
        let height = whole.height() - 112.0;
        let scrolled = ScrollArea::vertical().auto_shrink([false, true]).max_height(height).min_scrolled_height(height);
        scrolled.show(ui, |ui| {
            let narrow = whole.width() < NARROW;
            let mut chosen = state.settings.mirror.clone();
            window(state, &mut chosen, ui, acts, narrow);
            place(state, &mut chosen, ui, acts, narrow);
            eyes(state, &mut chosen, ui, narrow);
            calibration(state, &mut chosen, ui, acts, narrow);
            if chosen != state.settings.mirror {
                acts.push(Act::App(AppAct::Set(Setting::Mirror(Box::new(chosen)))));
            }
        });
    });
}

/// The window, and what it shows.
fn window(state: &MirrorState, settings: &mut MirrorSettings, ui: &mut Ui, acts: &mut Acts, narrow: bool) {
    let l = state.settings.language;
    let open = [(l.text("half_mirror.closed"), !state.mirror.open), (l.text("half_mirror.open"), state.mirror.open)];
    if let Some(chosen) = row(ui, narrow, l.text("half_mirror.window"), &open) {
        acts.push(Act::App(AppAct::MirrorWindow(chosen == 1)));
    }
    explained(ui, true, l.text("half_mirror.opened"));
    let shown = settings.pan_shown;
    let pan = [(l.text("half_mirror.pan_real"), !shown), (l.text("half_mirror.pan_drawn"), shown)];
    if let Some(chosen) = row(ui, narrow, l.text("half_mirror.pan"), &pan) {
        settings.pan_shown = chosen == 1;
    }
}

/// Rig and projector.
fn place(state: &MirrorState, settings: &mut MirrorSettings, ui: &mut Ui, acts: &mut Acts, narrow: bool) {
    let l = state.settings.language;
    let now = settings.rig.clone();
    let rigs = SHIPPED.map(|(name, _)| (l.called("rig", name), name == now));
    if let Some(chosen) = row(ui, narrow, l.text("half_mirror.rig"), &rigs) {
        settings.rig = SHIPPED[chosen].0.to_owned();
    }
    let typed = &mut settings.rig;
    if beside(ui, narrow, l.text("half_mirror.rig_file"), |ui| text_field(ui, typed)).lost_focus() {
        acts.push(Act::App(AppAct::ReadRig));
    }
    let said = match state.mirror.rig_read() {
        Err(error) => error,
        Ok(rig) => registered(state, &rig),
    };
    explained(ui, narrow, &said);
    let typed = &mut settings.projector;
    beside(ui, narrow, l.text("half_mirror.projector"), |ui| text_field(ui, typed));
}

/// A name and the field that it is the name of.
fn beside(ui: &mut Ui, narrow: bool, name: &str, field: impl FnOnce(&mut Ui) -> Response) -> Response {
    ui.horizontal(|ui| {
        let width = if narrow { 0.5 * ui.available_width() } else { NAMES };
        let place = vec2(width, theme::TOUCH);
        let label = ui.allocate_ui_with_layout(place, Layout::left_to_right(Align::Center), |ui| {
            ui.set_min_size(place);
            ui.label(name)
        });
        field(ui).labelled_by(label.inner.id)
    })
    .inner
}

fn text_field(ui: &mut Ui, typed: &mut String) -> Response {
    let room = ui.available_width() - 2.0 * ui.spacing().item_spacing.x;
    theme::field(ui, TextEdit::singleline(typed).desired_width(room.min(280.0)))
}

/// What a rig is called, and how well touched points agree with it.
fn registered(state: &PanelContext, rig: &Rig) -> String {
    let l = state.settings.language;
    let residual = rig.residual.map(|metres| format!("{:.2}", 1e3 * metres));
    let name = l.called("rig", &rig.name);
    residual.map_or_else(|| name.to_owned(), |mm| l.fill("half_mirror.registered", &[("rig", &name), ("mm", &mm)]))
}

/// Stereo and the distance of the eyes.
fn eyes(state: &MirrorState, settings: &mut MirrorSettings, ui: &mut Ui, narrow: bool) {
    let l = state.settings.language;
    let now = settings.stereo;
    let ways = Stereo::ALL.map(|way| (stereo_word(way, l), way == now));
    if let Some(chosen) = row(ui, narrow, l.text("half_mirror.stereo"), &ways) {
        settings.stereo = Stereo::ALL[chosen];
    }
    let Ok(rig) = state.mirror.rig_read() else { return };
    let mut mm = 1e3 * settings.eye_distance(&rig);
    let drag = DragValue::new(&mut mm).range(0.0..=WIDEST_MM).speed(0.1).fixed_decimals(1).suffix(" mm");
    if beside(ui, narrow, l.text("half_mirror.eyes"), |ui| ui.add(drag)).changed() {
        settings.eye_distance_mm = Some(mm);
    }
}

/// Calibration: on or off, what to do, the numbers.
fn calibration(state: &MirrorState, settings: &mut MirrorSettings, ui: &mut Ui, acts: &mut Acts, narrow: bool) {
    let l = state.settings.language;
    let on = state.mirror.calibrating;
    let shown = [(l.text("half_mirror.picture"), !on), (l.text("half_mirror.pattern"), on)];
    if let Some(chosen) = row(ui, narrow, l.text("half_mirror.calibration"), &shown) {
        acts.push(Act::App(AppAct::Calibrate(chosen == 1)));
    }
    if let Ok(rig) = state.mirror.rig_read() {
        let [width, depth] = (1e3 * rig.sheet.size).round().to_array();
        explained(ui, true, &l.fill("half_mirror.how", &[("width", &width), ("depth", &depth)]));
    }
    if ui.add(theme::of(ui).button(l.text("half_mirror.reset"), false)).clicked() {
        settings.keep(Calibration::default());
    }
    if let Some(lines) = numbers(state, &settings.calibration(), if narrow { 1 } else { 3 }) {
        lines.iter().for_each(|line| {
            ui.label(RichText::new(line).monospace().size(14.0));
        });
    }
}

/// Where every mark is shown, the lens, and what is left.
fn numbers(state: &MirrorState, calibration: &Calibration, columns: usize) -> Option<Vec<String>> {
    let l = state.settings.language;
    let (rig, size) = (state.mirror.rig_read().ok()?, state.mirror.size);
    let size = if size.min_element() < 1.0 { rig.screen.pixels() } else { size };
    let (fitted, pixels) = (calibration.fitted(&rig, size)?, calibration.pixels(&rig, size)?);
    let mark = |mark: usize| format!("{} {:7.1} {:7.1}", mark + 1, pixels[mark].x, pixels[mark].y);
    let rows = pixels.iter().enumerate().map(|(k, _)| mark(k)).collect::<Vec<_>>();
    let mut lines: Vec<String> = rows.chunks(columns).map(|three| three.join("   ")).collect();
    let [k1, k2] = fitted.warp.lens.k.map(|k| format!("{k:.4}"));
    let centre = fitted.warp.lens.centre;
    let (x, y) = (format!("{:.0}", centre.x), format!("{:.0}", centre.y));
    let residual = format!("{:.2}", fitted.residual);
    lines.push(l.fill("half_mirror.lens", &[("k1", &k1), ("k2", &k2), ("x", &x), ("y", &y), ("residual", &residual)]));
    Some(lines)
}
