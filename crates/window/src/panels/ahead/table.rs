//! "What if…": the four questions with their answers; a question that is clicked is done.

use egui::{Align2, Color32, FontId, Pos2, Rect, RichText, Sense, Ui, UiBuilder, pos2, vec2};
use saute_kitchen::Command;
use saute_plan::forecast::{Outlook, Question, SPANS_S, Sample};

use crate::ui::{fingers, theme};
use saute_controls::act::{Act, Acts, CookAct};
use saute_controls::ahead_words::{age_words, class, half_band, number, question_words};
use saute_controls::context::PanelContext;
use saute_controls::settings::Settings;
use saute_session::forecasts::AgedForecast;
use saute_words::act_words::command_words;

/// Height of a question with its answer, and of the words above [points].
const ROW: f32 = 29.0;
const HEAD: f32 = 16.0;
/// Width of a question, and of a temperature [points].
const QUESTION: f32 = 104.0;
const CELL: f32 = 33.0;
/// Side of the patch of colour [points].
const PATCH: f32 = 10.0;

/// Shows the table; its height is the same whatever it contains.
pub fn show(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    ui.spacing_mut().item_spacing.y = 3.0;
    head(state, ui);
    for question in Question::ALL {
        row(state, question, ui, acts);
    }
}

fn head(state: &PanelContext, ui: &mut Ui) {
    let l = state.settings.language;
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), HEAD), Sense::hover());
    let mut title = ui.new_child(UiBuilder::new().max_rect(rect.with_max_x(rect.left() + QUESTION + 6.0)));
    title.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 5.0;
        ui.label(RichText::new(l.text("ahead.title")).size(13.0));
        note(state, ui);
    });
    for (place, span) in SPANS_S.into_iter().enumerate() {
        let words = l.fill("ahead.minutes", &[("minutes", &format!("{:.0}", span / 60.0))]);
        small(ui, pos2(cell(rect, place), rect.center().y), &words, theme::of(ui).quiet);
    }
    let highest = l.fill("ahead.highest", &[("unit", &state.settings.unit())]);
    small(ui, pos2(cell(rect, SPANS_S.len()), rect.center().y), &highest, theme::of(ui).quiet);
}

/// How old the answers are, and whether they still apply.
fn note(state: &PanelContext, ui: &mut Ui) {
    let l = state.settings.language;
    let known = Question::ALL.into_iter().filter_map(|question| state.session.foreseen(question));
    let Some(oldest) = known.max_by(|a, b| a.age_s.total_cmp(&b.age_s)) else { return };
    let label = |words: &str| egui::Label::new(RichText::new(words).size(11.5).color(theme::of(ui).quiet)).truncate();
    match (oldest.is_current, age_words(state, &oldest)) {
        (false, _) => drop(ui.add(label(l.text("ahead.outdated"))).on_hover_text(l.text("ahead.stale"))),
        (true, Some(age)) => drop(ui.add(label(&age))),
        (true, None) => {}
    }
}

/// Left edge of a temperature.
fn cell(row: Rect, place: usize) -> f32 {
    row.left() + QUESTION + 8.0 + CELL * place as f32
}

fn small(ui: &Ui, at: Pos2, words: &str, ink: Color32) -> Rect {
    ui.painter().text(at, Align2::LEFT_CENTER, words, FontId::proportional(11.5), ink)
}

fn row(state: &PanelContext, question: Question, ui: &mut Ui, acts: &mut Acts) {
    let height = fingers::height(ui, ROW);
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    let place = Rect::from_min_size(rect.min, vec2(QUESTION, height));
    ask(state, question, ui, acts, place);
    let response = ui.interact(
        rect.with_min_x(place.right()),
        ui.scope_id().with(question_words(state, question)),
        Sense::hover(),
    );
    match state.session.foreseen(question) {
        Some(standing) => {
            let spoken = spoken(state, question, &standing);
            response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Label, true, &spoken));
            let hint =
                state.settings.language.text(if standing.is_current { "ahead.table_hint" } else { "ahead.stale" });
            response.on_hover_text(format!("{spoken}\n{hint}"));
            answer(state, &standing, ui, rect);
        }
        None => drop(small(ui, pos2(cell(rect, 0), rect.center().y), "–", theme::of(ui).quiet)),
    }
}

/// The question: a button that does it, where there is something to do.
fn ask(state: &PanelContext, question: Question, ui: &mut Ui, acts: &mut Acts, place: Rect) {
    let words = question_words(state, question);
    let Some(piece) = state.session.shown_piece().filter(|_| question != Question::AsItIs) else {
        let at = place.left_center() + vec2(6.0, 0.0);
        ui.painter().text(at, Align2::LEFT_CENTER, words, FontId::proportional(13.0), theme::of(ui).text);
        return;
    };
    let commands = question.commands(&state.session.kitchen, &piece.id);
    let button = egui::Button::new(RichText::new(words).size(13.0)).min_size(place.size());
    let mut within = ui.new_child(UiBuilder::new().id_salt(words).max_rect(place));
    within.spacing_mut().button_padding = vec2(6.0, 2.0);
    let response = within.add_enabled(commands.is_some(), button);
    let to_what = commands.as_ref().and_then(|commands| lower_to(commands)).map(|command| {
        let power = command_words(command, state.settings.language);
        state.settings.language.fill("ahead.lower_to", &[("power", &power)])
    });
    let response = match to_what {
        Some(words) => response.on_hover_text(words),
        None => response,
    };
    if response.clicked() {
        acts.push(Act::Cook(CookAct::Asked(question)));
    }
}

/// What the hob is set to.
fn lower_to(commands: &[Command]) -> Option<&Command> {
    commands.iter().find(|command| matches!(command, Command::Hob(_) | Command::HobHold { .. }))
}

fn answer(state: &PanelContext, standing: &AgedForecast, ui: &Ui, row: Rect) {
    let (settings, outlook) = (state.settings, &standing.answer.outlook);
    let palette = theme::of(ui);
    let ink = if standing.is_current { palette.text } else { palette.quiet };
    let (above, below) = (row.center().y - 7.0, row.center().y + 8.0);
    let large = |x: f32, words: String| {
        ui.painter().text(pos2(x, above), Align2::LEFT_CENTER, words, FontId::proportional(15.0), ink)
    };
    for (place, span) in SPANS_S.into_iter().enumerate() {
        large(cell(row, place), number(settings, standing.core_in(span).0));
    }
    let highest = large(cell(row, SPANS_S.len()), highest_words(settings, outlook));
    if let Some(band) = band_words(settings, standing) {
        small(ui, pos2(highest.right() + 5.0, above), &band, ink);
    }
    let after = class(state, outlook)
        .map_or(cell(row, 0), |class| small(ui, pos2(cell(row, 0), below), &class, ink).right() + 8.0);
    if let Some(last) = outlook.samples.last() {
        underside(state, last, ui, pos2(after, below), ink);
    }
}

/// The highest core; of raw food that still warms on the board a bound.
fn highest_words(settings: &Settings, outlook: &Outlook) -> String {
    let highest = number(settings, outlook.peak.core);
    if outlook.still_warms() { format!("> {highest}") } else { highest }
}

/// How far the highest core may be off; a bound has no band.
fn band_words(settings: &Settings, standing: &AgedForecast) -> Option<String> {
    let has_peak = !standing.answer.outlook.still_warms();
    has_peak.then(|| format!("± {}", half_band(settings, standing.band.peak_k)))
}

/// The colour of the underside in the end, and how much of it is brown.
fn underside(state: &PanelContext, last: &Sample, ui: &Ui, at: Pos2, ink: Color32) {
    let [r, g, b] = last.faces[0].lab.srgb8();
    let patch = Rect::from_min_size(at - vec2(0.0, 0.5 * PATCH), vec2(PATCH, PATCH));
    ui.painter().rect_filled(patch, 2.0, Color32::from_rgb(r, g, b));
    let percent = format!("{:.0}", last.faces[0].browned_pct);
    let words = state.settings.language.fill("ahead.browned", &[("percent", &percent)]);
    small(ui, at + vec2(PATCH + 4.0, 0.0), &words, ink);
}

/// An answer as it is read out.
fn spoken(state: &PanelContext, question: Question, standing: &AgedForecast) -> String {
    let (settings, l, outlook) = (state.settings, state.settings.language, &standing.answer.outlook);
    let [one, two, five] = SPANS_S.map(|span| number(settings, standing.core_in(span).0));
    let browned = outlook.samples.last().map_or(0.0, |last| last.faces[0].browned_pct);
    let highest = [Some(highest_words(settings, outlook)), band_words(settings, standing)];
    let highest = highest.into_iter().flatten().collect::<Vec<_>>().join(" ");
    l.fill(
        "ahead.spoken",
        &[
            ("question", &question_words(state, question)),
            ("one", &one),
            ("two", &two),
            ("five", &five),
            ("highest", &highest),
            ("unit", &settings.unit()),
            ("class", &class(state, outlook).unwrap_or_default()),
            ("percent", &format!("{browned:.0}")),
        ],
    )
}
