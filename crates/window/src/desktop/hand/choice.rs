//! The section of the settings about haptic devices: which device holds what, and its address.

use egui::accesskit;
use egui::{RichText, TextEdit, Ui, WidgetInfo};
use saute_haptics::open::{self, Access, Reach};

use crate::panels::cards::setting_row::{explained, named, row};
use crate::ui::theme;
use saute_controls::act::{Act, Acts, AppAct, HostAct};
use saute_controls::context::PanelContext;
use saute_controls::hands::Role;
use saute_words::language::Language;

/// Width of a line to type into at most [points] (chosen: an address and a port).
const TYPED: f32 = 400.0;

/// What the person has chosen so far.
#[derive(Clone, Debug)]
pub(crate) struct Choice {
    names: Vec<String>,
    name: usize,
    place: String,
    code: String,
    role: Role,
}

impl Default for Choice {
    fn default() -> Self {
        // A device library that cannot be read offers nothing; connecting by name then reports the error.
        let names = open::names().unwrap_or_default();
        let name = names.iter().position(|n| n == saute_haptics::library::DEFAULT_DEVICE).unwrap_or(0);
        Self { names, name, place: String::new(), code: String::new(), role: Role::Pan }
    }
}

impl Choice {
    /// NAME or NAME@PLACE.
    fn text(&self) -> String {
        let name = self.names.get(self.name).map_or("", String::as_str);
        let place = self.place.trim();
        if place.is_empty() { name.to_owned() } else { format!("{name}@{place}") }
    }
}

/// Shows the part.
pub(crate) fn section(state: &PanelContext, choice: &mut Choice, ui: &mut Ui, acts: &mut Acts, narrow: bool) {
    let l = state.settings.language;
    // Folded: who has no device sees no more than a line of it.
    egui::CollapsingHeader::new(RichText::new(l.text("hand.title")).strong())
        .id_salt("hands")
        .show(ui, |ui| choices(state, choice, ui, acts, narrow));
}

fn choices(state: &PanelContext, choice: &mut Choice, ui: &mut Ui, acts: &mut Acts, narrow: bool) {
    let l = state.settings.language;
    let names: Vec<(&str, bool)> =
        choice.names.iter().enumerate().map(|(i, n)| (n.as_str(), i == choice.name)).collect();
    let device = row(ui, narrow, l.text("hand.device"), &names);
    let roles = [Role::Pan, Role::Turner];
    let held = roles.map(|r| (role_word(r, l), r == choice.role));
    let role = row(ui, narrow, l.text("hand.holds"), &held);
    choice.name = device.unwrap_or(choice.name);
    choice.role = role.map_or(choice.role, |r| roles[r]);
    typed(ui, narrow, l.text("hand.place"), l.text("hand.place_hint"), &mut choice.place);
    typed(ui, narrow, l.text("hand.code"), l.text("hand.code_hint"), &mut choice.code);
    ui.horizontal(|ui| buttons(state, choice, ui, acts));
    for role in roles {
        if let Some(device) = state.session.hands.device(role) {
            let lines = device.access.iter().flat_map(|a| access_words(a, l));
            let text: Vec<String> = std::iter::once(device.name.clone()).chain(lines).collect();
            explained(ui, narrow, &format!("{}: {}", role_word(role, l), text.join("; ")));
        }
    }
}

fn buttons(state: &PanelContext, choice: &Choice, ui: &mut Ui, acts: &mut Acts) {
    let (role, l) = (choice.role, state.settings.language);
    if ui.add(theme::of(ui).button(l.text("hand.connect"), false)).clicked() {
        let code = choice.code.trim();
        acts.push(match if code.is_empty() { Ok(0) } else { code.parse() } {
            Ok(pairing) => Act::App(AppAct::Host(HostAct::Connect { role, device: choice.text(), pairing })),
            Err(_) => Act::App(AppAct::Say(l.fill("hand.no_code", &[("code", &code)]))),
        });
    }
    let connected = state.session.hands.device(role).is_some();
    if ui.add_enabled(connected, theme::of(ui).button(l.text("hand.disconnect"), false)).clicked() {
        acts.push(Act::App(AppAct::Host(HostAct::Disconnect(role))));
    }
}

/// How to reach a device, a line for each fact.
fn access_words(access: &Access, l: Language) -> Vec<String> {
    let reach = match access.reach {
        Reach::Cable => "hand.by_cable",
        Reach::ThisMachine => "hand.this_machine",
        Reach::Network => "hand.network",
    };
    let mut words = vec![l.fill(reach, &[("place", &access.place)])];
    words.extend(access.url.iter().map(|url| l.fill("hand.open_page", &[("url", url)])));
    words.extend(access.code.iter().map(|code| l.fill("hand.pair", &[("code", code)])));
    words.extend(access.fingerprint.iter().map(|print| l.fill("hand.certificate", &[("print", print)])));
    words
}

/// A name and a line to type into.
fn typed(ui: &mut Ui, narrow: bool, name: &str, hint: &str, text: &mut String) {
    named(ui, narrow, name, |ui| {
        let width = ui.available_width().min(TYPED);
        let line = theme::field(ui, TextEdit::singleline(text).hint_text(hint).desired_width(width));
        line.widget_info(|| WidgetInfo::labeled(accesskit::Role::TextInput, true, name));
    });
}

/// Name of a role.
pub(crate) fn role_word(role: Role, l: Language) -> &'static str {
    l.text(match role {
        Role::Pan => "hand.pan",
        Role::Turner => "hand.turner",
    })
}
