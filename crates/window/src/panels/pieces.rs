//! The list of the pieces with their state: groups in one line that unfolds.

use std::collections::{BTreeMap, BTreeSet};

use egui::{RichText, Sense, Ui, vec2};
use saute_kitchen::{Piece, celsius};

use crate::ui::aloud::heading;
use crate::ui::{fingers, theme};
use saute_controls::act::{Act, Acts, CookAct, ViewAct};
use saute_controls::context::PanelContext;
use saute_words::language::Language;
use saute_words::piece_words::group_of;
use saute_words::piece_words::{doneness, grams, place};

/// What a line shows.
struct Line {
    name: String,
    /// True if a group is unfolded; none for a piece.
    fold: Option<bool>,
    core: String,
    mass: String,
    state: String,
}

/// Height of a line [points] (chosen: two rows of type, wide enough for a finger).
const LINE: f32 = 42.0;

/// Shows the list; a click selects the piece that the other panels are about.
pub fn show(state: &PanelContext, unfolded: &mut BTreeSet<String>, ui: &mut Ui, acts: &mut Acts) {
    let count = state.session.kitchen.pieces().len();
    let l = state.settings.language;
    heading(ui, if count == 1 { l.text("piece.one").to_owned() } else { l.fill("piece.many", &[("count", &count)]) });
    ui.label(RichText::new(l.text("piece.click")).size(12.5).color(theme::of(ui).quiet));
    all_at_once(state, ui, acts);
    ui.spacing_mut().item_spacing.y = 3.0;
    for (group, members) in groups(state) {
        match members.as_slice() {
            [single] => piece_line(state, ui, acts, single, 0.0),
            _ => group_lines(state, (&group, &members), unfolded, ui, acts),
        }
    }
}

/// Puts in what waits; returns false where fewer than two pieces do.
pub fn all_at_once(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) -> bool {
    let waiting = state.session.waiting();
    let waits = waiting.len() > 1;
    if waits {
        lay_or_heap(&waiting, state.settings.language, ui, acts);
    }
    waits
}

fn lay_or_heap(waiting: &[String], l: Language, ui: &mut Ui, acts: &mut Acts) {
    ui.horizontal(|ui| {
        if ui
            .add(theme::of(ui).button(l.text("piece.lay_all"), true))
            .on_hover_text(l.text("piece.lay_all_hint"))
            .clicked()
        {
            acts.push(Act::Cook(CookAct::Lay(waiting.to_vec())));
        }
        if ui
            .add(theme::of(ui).button(l.text("piece.heap_all"), false))
            .on_hover_text(l.text("piece.heap_all_hint"))
            .clicked()
        {
            acts.push(Act::Cook(CookAct::Heap(waiting.to_vec())));
        }
    });
}

/// Groups in the order of their first pieces.
fn groups(state: &PanelContext) -> Vec<(String, Vec<String>)> {
    let mut groups: Vec<(String, Vec<String>)> = Vec::new();
    let mut known: BTreeMap<String, usize> = BTreeMap::new();
    for piece in state.session.kitchen.pieces() {
        let group = group_of(&piece.id).to_owned();
        let at = *known.entry(group.clone()).or_insert_with(|| {
            groups.push((group, Vec::new()));
            groups.len() - 1
        });
        groups[at].1.push(piece.id.clone());
    }
    groups
}

fn piece_line(state: &PanelContext, ui: &mut Ui, acts: &mut Acts, id: &str, indent: f32) {
    let Some(piece) = state.session.kitchen.piece(id) else { return };
    let l = state.settings.language;
    let line = Line {
        name: if indent > 0.0 {
            id.trim_start_matches(group_of(id)).trim_start_matches('.').to_owned()
        } else {
            state.session.name_of(id, l)
        },
        fold: None,
        core: state.settings.temperature(celsius(piece.core())),
        mass: grams(piece),
        state: format!("{} · {}", doneness(state.scale_of(piece).as_deref(), piece, l), place(piece, l)),
    };
    let selected = state.session.shown_piece().is_some_and(|p| p.id == id);
    let spoken = spoken(&line, l.fill("piece.select", &[("name", &state.session.name_of(id, l))]), l);
    if shown(ui, &line, indent, selected, &spoken) {
        acts.push(Act::View(ViewAct::Select(id.to_owned())));
    }
}

fn group_lines(
    state: &PanelContext,
    (group, members): (&str, &[String]),
    unfolded: &mut BTreeSet<String>,
    ui: &mut Ui,
    acts: &mut Acts,
) {
    let open = unfolded.contains(group);
    let line = means(state, group, members, open);
    let selected = !open && state.session.shown_piece().is_some_and(|p| members.contains(&p.id));
    let l = state.settings.language;
    let what = l.fill(if open { "piece.fold" } else { "piece.unfold" }, &[("name", &state.session.name_of(group, l))]);
    let spoken = spoken(&line, what, l);
    if shown(ui, &line, 0.0, selected, &spoken) {
        if open {
            unfolded.remove(group)
        } else {
            unfolded.insert(group.to_owned())
        };
    }
    if !open {
        return;
    }
    ui.horizontal(|ui| {
        ui.add_space(14.0);
        let lay = CookAct::Lay as fn(Vec<String>) -> CookAct;
        for (key, act) in [("piece.lay", lay), ("piece.heap", CookAct::Heap), ("piece.take_away", CookAct::Remove)] {
            let button = egui::Button::new(RichText::new(l.text(key)).size(13.0)).min_size(vec2(0.0, 30.0));
            if ui.add(button).clicked() {
                acts.push(Act::Cook(act(members.to_vec())));
            }
        }
    });
    for id in members {
        piece_line(state, ui, acts, id, 14.0);
    }
}

/// A group in one line: means over its pieces, and how many are where.
fn means(state: &PanelContext, group: &str, members: &[String], open: bool) -> Line {
    let pieces: Vec<&Piece> = members.iter().filter_map(|id| state.session.kitchen.piece(id)).collect();
    let mean =
        |value: &dyn Fn(&Piece) -> f64| pieces.iter().map(|p| value(p)).sum::<f64>() / pieces.len().max(1) as f64;
    let l = state.settings.language;
    let mut states: BTreeMap<String, usize> = BTreeMap::new();
    for piece in &pieces {
        *states.entry(place(piece, l).to_owned()).or_default() += 1;
    }
    let states = states.iter().map(|(word, count)| l.fill("piece.count_of", &[("count", count), ("place", word)]));
    let states: Vec<String> = states.collect();
    Line {
        name: l.fill("piece.group", &[("name", &state.session.name_of(group, l)), ("count", &pieces.len())]),
        fold: Some(open),
        core: state.settings.temperature(celsius(mean(&Piece::core))),
        mass: l.fill("piece.mean_mass", &[("mass", &format!("{:.1} g", 1e3 * mean(&Piece::mass)))]),
        state: states.join(" · "),
    }
}

/// A triangle that points at what it unfolds.
fn fold_mark(painter: &egui::Painter, at: egui::Pos2, open: bool, ink: egui::Color32) {
    let ends = if open { [[-4.0, -2.5], [4.0, -2.5], [0.0, 3.5]] } else { [[-2.5, -4.0], [3.5, 0.0], [-2.5, 4.0]] };
    let points = ends.map(|[x, y]| at + vec2(x, y)).to_vec();
    painter.add(egui::Shape::convex_polygon(points, ink, egui::Stroke::NONE));
}

/// A line as it is read out, after what a click does.
fn spoken(line: &Line, what: String, l: Language) -> String {
    let open: [(&str, &dyn std::fmt::Display); 4] =
        [("what", &what), ("name", &line.name), ("core", &line.core), ("state", &line.state)];
    l.fill("piece.spoken", &open)
}

/// Draws a line; returns true if it was clicked.
fn shown(ui: &mut Ui, line: &Line, indent: f32, selected: bool, spoken: &str) -> bool {
    let size = vec2(ui.available_width(), fingers::height(ui, LINE));
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    response.widget_info(|| egui::WidgetInfo::selected(egui::accesskit::Role::Button, true, selected, spoken));
    if !ui.is_rect_visible(rect) {
        return response.clicked();
    }
    let painter = ui.painter().with_clip_rect(rect.intersect(ui.clip_rect()));
    let ground = if selected {
        theme::of(ui).raised
    } else if response.hovered() {
        theme::of(ui).solid
    } else {
        egui::Color32::TRANSPARENT
    };
    painter.rect_filled(rect, 6.0, ground);
    let at = |x: f32, y: f32| rect.min + vec2(x, y);
    let (large, small) = (egui::FontId::proportional(14.5), egui::FontId::proportional(12.0));
    let (mut left, right) = (8.0 + indent, rect.width() - 8.0);
    if let Some(open) = line.fold {
        fold_mark(&painter, at(left + 5.0, 13.0), open, theme::of(ui).quiet);
        left += 16.0;
    }
    let ink = if selected { theme::of(ui).chosen } else { theme::of(ui).text };
    painter.text(at(left, 5.0), egui::Align2::LEFT_TOP, &line.name, large.clone(), ink);
    painter.text(at(right, 5.0), egui::Align2::RIGHT_TOP, &line.core, large, theme::of(ui).text);
    painter.text(at(left, 23.0), egui::Align2::LEFT_TOP, &line.state, small.clone(), theme::of(ui).quiet);
    painter.text(at(right, 23.0), egui::Align2::RIGHT_TOP, &line.mass, small, theme::of(ui).quiet);
    response.clicked()
}
