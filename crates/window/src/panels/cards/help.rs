//! The list of keys, of what the mouse does and of what a gamepad does: by subjects, with a search.

use egui::{Id, Modal, Rect, RichText, TextEdit, Ui, vec2};

use crate::bindings::{BINDINGS, CHORDS};
use crate::host::CurrentHost;
use crate::panels::host_panels;
use crate::system::IS_PAGE;
use crate::ui::aloud::heading;
use crate::ui::theme;
use saute_controls::act::{Act, Acts, AppAct, Card, Subject, ViewAct};
use saute_controls::context::PanelContext;
use saute_controls::input::gamepad::PAD;
use saute_controls::input::pan_keys::HELD;
use saute_words::language::Language;

/// Room for a key as it is written [points].
const KEY: egui::Vec2 = vec2(82.0, 18.0);

/// A group of keys: its title, and how each key is written with what it does.
struct Group {
    title: &'static str,
    lines: Vec<(&'static str, &'static str)>,
}

/// The keys of a subject; a browser reaches no haptic device and no half mirror, and a page has no photo mode.
fn keys(subject: Subject) -> impl Iterator<Item = (&'static str, &'static str)> {
    let native = |act: &Act| {
        matches!(act, Act::App(AppAct::StopHands | AppAct::Mirror | AppAct::Photo) | Act::View(ViewAct::Strings))
    };
    let here = move |b: &&crate::bindings::Binding| !IS_PAGE || !native(&b.act);
    BINDINGS
        .iter()
        .filter(here)
        .map(|b| (b.written, b.act.traits()))
        .filter(move |(_, traits)| traits.subject == subject)
        .map(|(written, traits)| (written, traits.words))
}

/// Groups of keys that have what was searched for in their words, or in how they are written.
fn groups(search: &str, l: Language) -> Vec<Group> {
    let title = |subject| match subject {
        Subject::Food => "help.food",
        Subject::Tool => "help.tool",
        Subject::Hob => "help.hob",
        Subject::Views => "help.views",
        Subject::Eye => "help.eye",
        Subject::Window => "help.window",
    };
    let mut groups: Vec<Group> = Subject::ALL
        .into_iter()
        .map(|subject| Group { title: l.text(title(subject)), lines: keys(subject).collect() })
        .collect();
    groups.push(Group { title: l.text("help.time"), lines: CHORDS.to_vec() });
    groups.push(Group { title: l.text("help.pan"), lines: HELD.to_vec() });
    groups.push(Group { title: l.text("help.pad"), lines: PAD.to_vec() });
    let wanted = search.trim().to_lowercase();
    let found = |(written, words): &(&str, &'static str)| {
        written.to_lowercase() == wanted || l.text(words).to_lowercase().contains(&wanted)
    };
    for group in &mut groups {
        if !group.title.to_lowercase().contains(&wanted) {
            group.lines.retain(found);
        }
    }
    groups.retain(|group| !group.lines.is_empty());
    groups
}

/// Shows the list over everything; Esc, F1, the button or a click beside it closes it.
pub fn show(state: &PanelContext, host: &CurrentHost, search: &mut String, ui: &Ui, acts: &mut Acts, whole: Rect) {
    let mut done = false;
    let modal =
        Modal::new(Id::unique("help")).frame(theme::of(ui).panel().fill(theme::of(ui).solid)).show(ui.ctx(), |ui| {
            ui.set_width((whole.width() - 60.0).min(960.0));
            done = head(state, search, ui, acts, whole.width() > 700.0);
            let height = whole.height() - 140.0 - host_panels::FOOT;
            egui::ScrollArea::vertical().max_height(height).min_scrolled_height(height).show(ui, |ui| {
                let columns = if whole.width() > 700.0 { 3 } else { 1 };
                list(ui, &groups(search, state.settings.language), columns, state.settings.language);
                ui.separator();
                ui.label(state.settings.language.text("help.mouse"));
                ui.label(state.settings.language.text("help.touch"));
            });
            host_panels::foot(state, host, ui, acts);
        });
    if done || modal.should_close() {
        search.clear();
        acts.push(Act::App(AppAct::Shut(Card::Help)));
    }
}

/// Title, search and buttons; returns true if the help is to be closed.
fn head(state: &PanelContext, search: &mut String, ui: &mut Ui, acts: &mut Acts, wide: bool) -> bool {
    let l = state.settings.language;
    let mut done = false;
    let mut field = |ui: &mut Ui, width: f32| {
        let edit = TextEdit::singleline(search).hint_text(l.text("help.search")).desired_width(width);
        let spoken = l.text("help.search");
        theme::field(ui, edit)
            .widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::TextInput, true, spoken));
    };
    ui.horizontal(|ui| {
        heading(ui, l.text("help.title"));
        if wide {
            field(ui, 260.0);
        }
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            done = ui.add(theme::of(ui).button(l.text("settings.done"), false)).clicked();
            if ui.add(theme::of(ui).button(l.text("help.first_steps"), false)).clicked() {
                acts.push(Act::App(AppAct::Open(Card::FirstSteps)));
            }
        });
    });
    if !wide {
        field(ui, ui.available_width() - 24.0);
    }
    ui.separator();
    done
}

/// Groups in columns of about one length, none of them parted.
fn list(ui: &mut Ui, groups: &[Group], columns: usize, l: Language) {
    let all: usize = groups.iter().map(|group| group.lines.len() + 2).sum();
    let most = all.div_ceil(columns);
    ui.columns(columns, |uis| {
        let mut filled = 0;
        for group in groups {
            // The middle of a group decides in which column it is.
            let column = ((filled + group.lines.len() / 2) / most.max(1)).min(columns - 1);
            filled += group.lines.len() + 2;
            shown(&mut uis[column], group, l);
        }
    });
}

fn shown(ui: &mut Ui, group: &Group, l: Language) {
    (ui.spacing_mut().item_spacing.y, ui.spacing_mut().interact_size.y) = (2.0, 18.0);
    ui.label(RichText::new(group.title).size(15.0).strong());
    for (written, words) in &group.lines {
        ui.horizontal(|ui| {
            let key = RichText::new(l.called("button", written)).size(13.0).strong().color(theme::of(ui).text);
            let beside = egui::Layout::left_to_right(egui::Align::Center);
            ui.allocate_ui_with_layout(KEY, beside, |ui| {
                ui.set_min_size(KEY);
                ui.label(key);
            });
            ui.add(egui::Label::new(RichText::new(l.text(words)).size(13.5)).wrap());
        });
    }
    ui.add_space(8.0);
}
