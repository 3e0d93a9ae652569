//! Choosing the food and the pan.

use egui::{RichText, Ui, vec2};
use saute_kitchen::food::{FoodDescription, Rules};
use saute_kitchen::{Library, PieceOrder};

use crate::panels::still::Stills;
use crate::ui::aloud::heading;
use crate::ui::aloud::spoken_value;
use crate::ui::fingers;
use crate::ui::theme;
use saute_controls::act::{Act, Acts, AppAct, Card, CookAct, Setting};
use saute_controls::context::PanelContext;
use saute_recipe::Recipe;
use saute_session::{FoodChoice, noun};
use saute_words::language::Language;

/// Most pieces that are added at once (chosen: a full pan).
const MOST_AT_ONCE: usize = 35;

/// Height of what comes below what was set out [points]: a row of buttons, or three lines of words.
const NEXT: f32 = 46.0;

/// Height of a food with its picture [points] (chosen: for a finger), and where a mouse is likely, so that all are seen at once.
const KIND: f32 = 44.0;
const SMALL_KIND: f32 = 30.0;
/// Width of a window that has room for the scene beside its panels [points].
const WIDE: f32 = 900.0;
/// Largest value that is chosen by tenths.
const THIN: f64 = 10.0;
/// Foods beside each other, so that all of them are seen at once.
const COLUMNS: usize = 2;
/// Width below which a row has a narrow picture and small letters [points].
const TIGHT: f32 = 200.0;

/// What the pantry keeps from frame to frame.
pub struct PantryMemory {
    /// How many pieces are added at once.
    pub count: usize,
    /// Pictures of the foods.
    stills: Stills,
    /// The recipes of the library, read once.
    recipes: Option<(Language, Vec<Listed>)>,
}

/// A recipe of the library, as the list shows it.
struct Listed {
    id: String,
    name: String,
    minutes: Option<f64>,
    /// Kind of its first food.
    food: Option<String>,
}

impl Listed {
    fn all(library: &Library, l: Language) -> Vec<Self> {
        let read = |(id, text): (&String, &String)| {
            // A broken one is listed, too: its error is stated when it is chosen.
            let recipe = Recipe::parse(text, id, library).ok();
            let plain = id.replace('-', " ");
            // A translation where there is one, else its own title.
            let called = l.called("recipe_file", &plain);
            let title = recipe.as_ref().filter(|_| called == plain).map(|recipe| recipe.title.clone());
            let name = title.unwrap_or_else(|| called.to_owned());
            let food = recipe.as_ref().and_then(|recipe| Some(recipe.foods.first()?.kind.clone()));
            Self { id: id.clone(), name, minutes: recipe.and_then(|recipe| recipe.minutes), food }
        };
        library.recipes.iter().map(read).collect()
    }
}

impl Default for PantryMemory {
    fn default() -> Self {
        Self { count: 1, stills: Stills::default(), recipes: None }
    }
}

/// Shows the choices; they take effect with "Set out".
pub fn show(state: &PanelContext, memory: &mut PantryMemory, ui: &mut Ui, acts: &mut Acts) {
    let library = &state.session.library;
    let l = state.settings.language;
    let food = noun(library, &state.settings.choice.kind, l);
    heading(ui, l.fill("pantry.mine", &[("food", &food)]));
    let is_free = !state.forbids(&Act::Cook(CookAct::SetOut(1))) && !state.forbids(&Act::Cook(CookAct::Add(1)));
    free(state, is_free, ui, |ui| {
        set_out(state, memory.count, ui, acts);
        how_many(&mut memory.count, ui, l);
    });
    // Of one height, so that nothing below moves when food is added.
    ui.allocate_ui(vec2(ui.available_width(), NEXT), |ui| {
        ui.set_min_height(NEXT);
        if !crate::panels::pieces::all_at_once(state, ui, acts) {
            let starts = l.fill("pantry.starts", &[("food", &food)]);
            ui.label(RichText::new(starts).size(12.5).color(theme::of(ui).quiet));
        }
    });
    let mut choice = state.settings.choice.clone();
    free(state, is_free, ui, |ui| food_and_pan(state, &mut choice, &mut memory.stills, ui, acts));
    if choice != state.settings.choice {
        acts.push(Act::App(AppAct::Set(Setting::Choice(choice))));
    }
    ui.separator();
    free(state, !state.forbids(&Act::App(AppAct::Open(Card::Files))), ui, |ui| recipes(state, memory, ui, acts));
}

/// Shows controls; those that a study or a lesson locks look so, and show why.
fn free(state: &PanelContext, is_free: bool, ui: &mut Ui, content: impl FnOnce(&mut Ui)) {
    let shown = ui.add_enabled_ui(is_free, content).response;
    if !is_free {
        shown.on_hover_text(state.settings.language.text("guided.locked"));
    }
}

/// The kind of food, its size and temperature, and the pan.
fn food_and_pan(state: &PanelContext, choice: &mut FoodChoice, stills: &mut Stills, ui: &mut Ui, acts: &mut Acts) {
    let (library, l, fahrenheit) = (&state.session.library, state.settings.language, state.settings.fahrenheit);
    ui.scope(|ui| kinds(ui, library, choice, stills, l));
    if let Some(food) = library.foods.get(&choice.kind) {
        sizes(ui, food, &mut choice.size_mm, l);
    }
    let coldest = coldest(library, &choice.kind);
    temperature(ui, l.text("pantry.start_temperature"), &mut choice.initial_c, coldest, 30.0, fahrenheit);
    plan_it(&noun(library, &choice.kind, l), ui, acts, l);
    ui.separator();
    heading(ui, l.text("pantry.hob"));
    hobs(ui, library, choice, l);
    heading(ui, l.text("pantry.pan"));
    pans(ui, library, choice, l);
    crate::panels::at_home::chip::show(state, ui, acts);
    temperature(ui, l.text("pantry.preheated"), &mut choice.preheat_c, 20.0, 260.0, fahrenheit);
}

/// The list of the pans.
pub(super) fn pans(ui: &mut Ui, library: &Library, choice: &mut FoodChoice, l: Language) {
    let name = l.called("pan", library.pans.get(&choice.pan).map_or(choice.pan.as_str(), |p| &p.name)).to_owned();
    list(ui, "pan", &name, &l.fill("pantry.pan_spoken", &[("pan", &name)]), |ui| {
        for (id, pan) in &library.pans {
            ui.selectable_value(&mut choice.pan, id.clone(), l.called("pan", &pan.name));
        }
    });
}

/// The list of the hobs; that of the kitchen at home unless another is chosen.
fn hobs(ui: &mut Ui, library: &Library, choice: &mut FoodChoice, l: Language) {
    let at_home = &library.at_home.hob;
    let mut id = choice.hob.as_ref().filter(|id| library.hobs.contains_key(*id)).unwrap_or(at_home).clone();
    let name = l.called("stove", &choice.hob(library).name).to_owned();
    list(ui, "hob", &name, &l.fill("pantry.hob_spoken", &[("hob", &name)]), |ui| {
        for (other, hob) in &library.hobs {
            ui.selectable_value(&mut id, other.clone(), l.called("stove", &hob.name));
        }
    });
    choice.hob = (id != *at_home).then_some(id);
}

/// A list with a name for who cannot see it.
fn list(ui: &mut Ui, salt: &str, shown: &str, spoken: &str, content: impl FnOnce(&mut Ui)) {
    let combo = egui::ComboBox::from_id_salt(salt).selected_text(shown).width(ui.available_width() - 8.0);
    let response = combo.show_ui(ui, content).response;
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::ComboBox, true, spoken));
}

/// One button for each kind of food; another kind begins with its own size.
fn kinds(ui: &mut Ui, library: &Library, choice: &mut FoodChoice, stills: &mut Stills, l: Language) {
    ui.spacing_mut().item_spacing.y = 3.0;
    ui.columns(COLUMNS, |columns| {
        for (place, (id, food)) in library.foods.iter().enumerate() {
            let ui = &mut columns[place % COLUMNS];
            let clicked = pictured(ui, stills.of(ui.ctx(), id), [food.name_in(l.code()), ""], Some(choice.kind == *id));
            if clicked && choice.kind != *id {
                choice.kind.clone_from(id);
                choice.size_mm.clone_from(&food.size.default_mm);
            }
        }
    });
}

/// A row with a picture, a name and a quiet word at its end, which is chosen or not, or acts; returns true if it was clicked.
fn pictured(ui: &mut Ui, still: Option<egui::TextureHandle>, [name, end]: [&str; 2], chosen: Option<bool>) -> bool {
    let palette = theme::of(ui);
    let is_narrow = ui.ctx().content_rect().width() < WIDE;
    let tall = fingers::height(ui, if is_narrow { KIND } else { SMALL_KIND });
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width() - 4.0, tall), egui::Sense::click());
    let (on, enabled) = (chosen == Some(true), response.enabled());
    response.widget_info(|| match chosen {
        Some(on) => egui::WidgetInfo::selected(egui::accesskit::Role::RadioButton, enabled, on, name),
        None => egui::WidgetInfo::labeled(egui::accesskit::Role::Button, enabled, name),
    });
    let ground = if on || response.hovered() { palette.raised } else { egui::Color32::TRANSPARENT };
    let edge = match (response.has_focus(), on) {
        (true, _) => palette.text,
        (_, true) => palette.chosen,
        _ => egui::Color32::TRANSPARENT,
    };
    ui.painter().rect(rect, 7.0, ground, egui::Stroke::new(2.0, edge), egui::StrokeKind::Inside);
    // Beside another one a row has room for the middle of its picture only.
    let is_tight = rect.width() < TIGHT;
    let [wide, gap, edge] = if is_tight { [1.0, 6.0, 2.0] } else { [1.5, 9.0, 9.0] };
    let picture = egui::Rect::from_min_size(rect.min + vec2(3.0, 3.0), vec2(wide * (tall - 6.0), tall - 6.0));
    match still {
        Some(texture) => egui::Image::new((texture.id(), picture.size()))
            .uv(egui::Rect::from_center_size(egui::pos2(0.5, 0.5), vec2(wide / 1.5, 1.0)))
            .corner_radius(5)
            .paint_at(ui, picture),
        None => drop(ui.painter().rect_filled(picture, 5.0, palette.sunken)),
    }
    let at = egui::pos2(picture.right() + gap, rect.center().y);
    let font = |size: f32| egui::FontId::proportional(size);
    let at_end = rect.right_center() - vec2(edge, 0.0);
    let end = ui.painter().text(at_end, egui::Align2::RIGHT_CENTER, end, font(12.5), palette.quiet);
    let room = end.left() - at.x - if is_tight { 0.0 } else { 6.0 };
    let size = match room {
        _ if is_tight => 12.5,
        room if room < 150.0 => 13.5,
        _ => 15.0,
    };
    let name = ui.painter().layout(name.to_owned(), font(size), palette.text, room);
    ui.painter().galley(at - vec2(0.0, 0.5 * name.size().y), name, palette.text);
    response.clicked()
}

/// A slider for each dimension of the form, the thickness first.
pub(super) fn sizes(ui: &mut Ui, food: &FoodDescription, size_mm: &mut Vec<f64>, l: Language) {
    let (names, range) = (food.form.dimensions(), &food.size);
    if size_mm.len() != names.len() {
        size_mm.clone_from(&range.default_mm);
    }
    let thickness = names.len() - 1;
    for axis in std::iter::once(thickness).chain(0..thickness) {
        // The window keeps pieces on the 200 mm floor: length and width end where their corner still fits. Nothing
        // stands on edge: no piece is thicker than long.
        let longest = size_mm[..thickness].iter().copied().fold(0.0, f64::max);
        let most = if axis == thickness { longest.min(60.0) } else { 150.0 };
        slider(
            ui,
            l.called("dimension", names[axis]),
            &mut size_mm[axis],
            range.min_mm[axis],
            range.max_mm[axis].min(most),
            " mm",
        );
    }
}

fn set_out(state: &PanelContext, count: usize, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    ui.horizontal(|ui| {
        let half = 0.5 * (ui.available_width() - ui.spacing().item_spacing.x) - 4.0;
        let palette = theme::of(ui);
        let button = |text: &str, on| palette.button(text, on).min_size(egui::vec2(half, theme::TOUCH));
        if ui.add(button(l.text("pantry.set_out"), true)).clicked() {
            acts.push(Act::Cook(CookAct::SetOut(count)));
        }
        if ui.add(button(&l.fill("pantry.add", &[("count", &count)]), false)).clicked() {
            acts.push(Act::Cook(CookAct::Add(count)));
        }
    });
}

/// The way to a plan for the chosen food.
fn plan_it(food: &str, ui: &mut Ui, acts: &mut Acts, l: Language) {
    let size = vec2(ui.available_width() - 8.0, theme::TOUCH);
    let button = theme::of(ui).button(&l.fill("plan.of_food", &[("food", &food)]), false).min_size(size);
    if ui.add(button).on_hover_text(l.text("learn.plan")).clicked() {
        acts.push(Act::App(AppAct::Open(Card::Plan)));
    }
}

fn how_many(count: &mut usize, ui: &mut Ui, l: Language) {
    let mut shown = *count as f64;
    slider(ui, l.text("pantry.count"), &mut shown, 1.0, MOST_AT_ONCE as f64, "");
    *count = (shown.round() as usize).clamp(1, MOST_AT_ONCE);
}

fn recipes(state: &PanelContext, memory: &mut PantryMemory, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    heading(ui, l.text("pantry.play"));
    memory.recipes.take_if(|(language, _)| *language != l);
    let shipped = memory.recipes.get_or_insert_with(|| (l, Listed::all(&state.session.library, l)));
    for recipe in &shipped.1 {
        let minutes = recipe.minutes.map(|minutes| l.fill("pantry.minutes", &[("minutes", &format!("{minutes:.0}"))]));
        let still = recipe.food.as_ref().and_then(|food| memory.stills.of(ui.ctx(), food));
        if pictured(ui, still, [&recipe.name, minutes.as_deref().unwrap_or_default()], None) {
            acts.push(Act::Cook(CookAct::Play(recipe.id.clone())));
        }
    }
    let size = vec2(ui.available_width() - 4.0, theme::TOUCH);
    if ui.add(theme::of(ui).button(l.text("files.title"), false).min_size(size)).clicked() {
        acts.push(Act::App(AppAct::Open(Card::Files)));
    }
}

pub(super) fn slider(ui: &mut Ui, name: &str, value: &mut f64, low: f64, high: f64, suffix: &str) {
    ui.label(RichText::new(name).size(13.0).color(theme::of(ui).quiet));
    // Thin food is cut by tenths of a millimetre.
    let decimals = usize::from(high <= THIN);
    let response = ui.add(egui::Slider::new(value, low..=high).fixed_decimals(decimals).suffix(suffix));
    let shown = *value;
    response.widget_info(|| egui::WidgetInfo::slider(true, shown, name));
    spoken_value(ui, &response, format!("{shown:.decimals$}{suffix}"));
}

/// Coldest start of a food [°C]: below 0 only where its file states how it freezes.
pub(super) fn coldest(library: &Library, kind: &str) -> f64 {
    let freezes = library.foods.get(kind).is_some_and(|food| food.may_be_ice(Rules::Full));
    if freezes { PieceOrder::INITIAL_C[0] } else { 0.0 }
}

pub(super) fn temperature(ui: &mut Ui, name: &str, celsius: &mut f64, low: f64, high: f64, fahrenheit: bool) {
    let show = move |c: f64| if fahrenheit { c * 1.8 + 32.0 } else { c };
    let mut degrees = show(*celsius);
    slider(ui, name, &mut degrees, show(low), show(high), if fahrenheit { " °F" } else { " °C" });
    *celsius = if fahrenheit { (degrees - 32.0) / 1.8 } else { degrees };
}
