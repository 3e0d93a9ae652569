//! The card of the settings: how everything looks and reads, not what is cooked.

use egui::{RichText, ScrollArea, Ui};
use saute_scene::light::room_light::RoomLight;
use saute_scene::light::white_balance::WhiteBalance;
use saute_scene::quality::Quality;

use crate::panels::cards::frame::Framed;
use crate::panels::cards::language;
use crate::panels::cards::setting_row::{explained, named, row};
use crate::panels::cook::speaker_switch;
use crate::panels::host_panels::{self, HostMemory};
use crate::system::IS_PAGE;
use crate::ui::theme;
use saute_controls::act::{Act, Acts, AppAct, Card, Setting, ViewAct};
use saute_controls::context::PanelContext;
use saute_controls::reads_context;
use saute_controls::settings::interface_size::InterfaceSize;
use saute_controls::settings::quality_choice::QualityChoice;
use saute_controls::settings::theme::Theme;
use saute_words::language::Language;

/// Below this width names are above their choices [points].
pub(super) const NARROW: f32 = 640.0;
/// Width of the card at most [points].
pub(super) const WIDTH: f32 = 660.0;

/// What the card reads.
pub struct SettingsState<'a> {
    /// What every panel reads.
    pub context: PanelContext<'a>,
    /// The quality at which the scene is drawn.
    pub quality: Quality,
    /// True if the system has a font with kana and kanji.
    pub japanese_font: bool,
}

reads_context!(SettingsState);

/// Shows the card over everything; Esc, F2, the button or a click beside it closes it.
pub(crate) fn show(state: &SettingsState, memory: &mut HostMemory, ui: &Ui, acts: &mut Acts, whole: egui::Rect) {
    let framed = Framed { card: Card::Settings, id: "settings", title: "settings.title", width: WIDTH };
    let to_mirror = |ui: &mut Ui, acts: &mut Acts| {
        let words = state.settings.language.text("half_mirror.more");
        if !IS_PAGE && ui.add(theme::of(ui).button(words, false)).clicked() {
            acts.push(Act::App(AppAct::Open(Card::Mirror)));
        }
    };
    framed.show_with(state, ui, acts, whole, to_mirror, |ui, acts| {
        let height = whole.height() - 112.0;
        let scrolled = ScrollArea::vertical().auto_shrink([false, true]).max_height(height).min_scrolled_height(height);
        scrolled.show(ui, |ui| choices(state, memory, ui, acts, whole.width() < NARROW));
    });
}

fn choices(state: &SettingsState, memory: &mut HostMemory, ui: &mut Ui, acts: &mut Acts, narrow: bool) {
    let (l, now) = (state.settings.language, state.settings);
    let mut set = |setting| acts.push(Act::App(AppAct::Set(setting)));
    if let Some(theme) =
        row(ui, narrow, l.text("settings.theme"), &Theme::ALL.map(|t| (theme_word(t, l), t == now.theme)))
    {
        set(Setting::Theme(Theme::ALL[theme]));
    }
    let lights = RoomLight::ALL.map(|light| (light_word(light, l), light == now.light));
    let few = [(l.text("settings.controls_all"), !now.few), (l.text("settings.controls_few"), now.few)];
    let mut light_and_controls = |ui: &mut Ui| {
        if let Some(light) = row(ui, narrow, l.text("settings.room_light"), &lights) {
            set(Setting::Light(RoomLight::ALL[light]));
        }
        row(ui, narrow, l.text("settings.controls"), &few).is_some_and(|chosen| (chosen == 1) != now.few)
    };
    let turns = if narrow { light_and_controls(ui) } else { ui.horizontal_top(light_and_controls).inner };
    let whites = WhiteBalance::ALL.map(|w| (white_word(w, l), w == now.white_balance));
    if let Some(white) = row(ui, narrow, l.text("settings.white"), &whites) {
        set(Setting::White(WhiteBalance::ALL[white]));
    }
    let kelvin = format!("{:.0}", now.white_balance.appears_in(now.light));
    explained(ui, narrow, &l.fill("settings.white_now", &[("kelvin", &kelvin)]));
    let qualities = QualityChoice::ALL.map(|q| (quality_word(q, l), q == now.quality));
    if let Some(quality) = row(ui, narrow, l.text("settings.quality"), &qualities) {
        set(Setting::Quality(QualityChoice::ALL[quality]));
    }
    let drawn = quality_word(QualityChoice::Always(state.quality), l);
    explained(ui, narrow, &l.fill("settings.quality_now", &[("quality", &drawn)]));
    let all: Vec<Language> = Language::all().collect();
    let named = |one: &Language| (language::name(state.japanese_font, *one), *one == now.language);
    let languages: Vec<_> = all.iter().map(named).collect();
    let units = [("°C", !now.fahrenheit), ("°F", now.fahrenheit)];
    let mut language_and_unit = |ui: &mut Ui| {
        if let Some(chosen) = row(ui, narrow, l.text("settings.language"), &languages) {
            set(Setting::Language(all[chosen]));
        }
        if let Some(unit) = row(ui, narrow, l.text("settings.unit"), &units) {
            set(Setting::Fahrenheit(unit == 1));
        }
    };
    // Two short rows share a line where there is room.
    if narrow {
        language_and_unit(ui)
    } else {
        ui.horizontal_top(language_and_unit).inner
    }
    let sizes = InterfaceSize::ALL.map(|s| (format!("{:.0} %", 100.0 * s.factor()), s == now.size));
    let sizes = sizes.each_ref().map(|(text, on)| (text.as_str(), *on));
    let less = crate::ui::display::moves_less(now);
    let motions = [(l.text("settings.motion_full"), !less), (l.text("settings.motion_less"), less)];
    let mut size_and_motion = |ui: &mut Ui| {
        if let Some(size) = row(ui, narrow, l.text("settings.size"), &sizes) {
            set(Setting::Size(InterfaceSize::ALL[size]));
        }
        if let Some(motion) = row(ui, narrow, l.text("settings.motion"), &motions) {
            set(Setting::LessMotion(motion == 1));
        }
    };
    if narrow {
        size_and_motion(ui)
    } else {
        ui.horizontal_top(size_and_motion).inner
    }
    if turns {
        acts.push(Act::View(ViewAct::More));
    }
    if !state.forbids(&Act::App(AppAct::Set(Setting::Sound(true)))) {
        volume(state, ui, acts, narrow);
    }
    host_panels::device_settings(state, memory, ui, acts, narrow);
}

/// The volume; its slider is short enough for one line with its name.
fn volume(state: &PanelContext, ui: &mut Ui, acts: &mut Acts, narrow: bool) {
    let name = state.settings.language.text("heard.volume");
    if !narrow {
        return named(ui, narrow, name, |ui| speaker_switch::volume(state, ui, acts));
    }
    ui.horizontal(|ui| {
        ui.label(RichText::new(name).size(14.0).color(theme::of(ui).quiet));
        speaker_switch::volume(state, ui, acts);
    });
}

fn theme_word(theme: Theme, l: Language) -> &'static str {
    l.text(match theme {
        Theme::Dark => "settings.dark",
        Theme::Light => "settings.light",
        Theme::System => "settings.system",
    })
}

fn light_word(light: RoomLight, l: Language) -> &'static str {
    l.text(match light {
        RoomLight::Daylight => "settings.daylight",
        RoomLight::Evening => "settings.evening",
    })
}

fn white_word(white: WhiteBalance, l: Language) -> &'static str {
    l.text(match white {
        WhiteBalance::AsShot => "settings.as_shot",
        WhiteBalance::Neutral => "settings.neutral",
        WhiteBalance::Cool => "settings.cool",
        WhiteBalance::Warm => "settings.warm",
    })
}

fn quality_word(quality: QualityChoice, l: Language) -> &'static str {
    l.text(match quality {
        QualityChoice::Automatic => "settings.automatic",
        QualityChoice::Always(Quality::Quick) => "settings.quick",
        QualityChoice::Always(Quality::Smooth) => "settings.smooth",
        QualityChoice::Always(Quality::Best) => "settings.best",
    })
}
