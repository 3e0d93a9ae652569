//! Promise: every text of the window has the contrast of WCAG AA (2.2, 1.4.3) against what it is drawn on, and every control the
//! one of 1.4.11, in both themes: read off what is drawn, so that no panel is left out.

use std::collections::BTreeSet;

use egui::epaint::{CircleShape, RectShape, TextShape};
use egui::{Color32, Key, Pos2, Rect, Shape, accesskit::Role, pos2, vec2};
use egui_kittest::{Harness, kittest::NodeT};
use saute_controls::act::{Act, AppAct, Setting};
use saute_controls::settings::theme::Theme;
use saute_kitchen::Command;
use saute_kitchen::food::change::colour::decoded;
use saute_window::SauteApp;
use saute_window::ui::palette::Palette;

use crate::harness::{cook, press, steps, window};

/// Contrast of text, and of controls and large text [-] (WCAG 2.2, 1.4.3 and 1.4.11).
const TEXT: f64 = 4.5;
const CONTROL: f64 = 3.0;

/// Relative luminance by WCAG 2.2.
fn luminance(colour: Color32) -> f64 {
    let linear = |v: u8| decoded(f64::from(v) / 255.0);
    0.2126 * linear(colour.r()) + 0.7152 * linear(colour.g()) + 0.0722 * linear(colour.b())
}

/// Contrast ratio by WCAG 2.2 (1–21).
fn contrast(a: Color32, b: Color32) -> f64 {
    let (a, b) = (luminance(a), luminance(b));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

/// The least contrast of a colour on any of the grounds that it may be drawn on.
fn least(ink: Color32, grounds: &[Color32]) -> f64 {
    grounds.iter().map(|ground| contrast(ground.blend(ink), *ground)).fold(f64::INFINITY, f64::min)
}

/// A text or an edge as it was drawn, with the colours that may be below it: those over the darkest and the brightest scene.
struct Drawn {
    words: String,
    ink: Color32,
    rect: Rect,
    grounds: Vec<Color32>,
}

/// All that was drawn in the last frame.
#[derive(Default)]
struct Page {
    /// Filled areas in the order in which they were drawn; none represents the scene.
    fills: Vec<(Rect, Option<Color32>)>,
    texts: Vec<Drawn>,
    edges: Vec<Drawn>,
}

impl Page {
    fn of(harness: &Harness<'static, SauteApp>, whole: Rect) -> Self {
        let ground = Palette::of(harness.ctx.global_style().visuals.dark_mode).ground;
        let mut page = Self::default();
        for clipped in &harness.output().shapes {
            page.take(&clipped.shape, clipped.clip_rect, (whole, ground));
        }
        page
    }

    fn take(&mut self, shape: &Shape, clip: Rect, below: (Rect, Color32)) {
        let (whole, ground) = below;
        match shape {
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| self.take(shape, clip, below)),
            // The scene covers the window; the other callbacks are the grounds of panels.
            Shape::Callback(callback) => {
                self.fills.push((callback.rect, (callback.rect != whole).then_some(ground)));
            }
            Shape::Rect(rect) => self.take_rect(rect, clip),
            Shape::Circle(CircleShape { center, radius, fill, stroke }) => {
                let rect = Rect::from_center_size(*center, egui::Vec2::splat(2.0 * radius));
                self.edge(rect, *fill, clip);
                self.edge(rect, stroke.color, clip);
            }
            Shape::Text(text) => self.take_text(text, clip),
            _ => {}
        }
    }

    fn take_rect(&mut self, shape: &RectShape, clip: Rect) {
        if shape.stroke.width > 0.0 {
            self.edge(shape.rect, shape.stroke.color, clip);
        }
        self.edge(shape.rect, shape.fill, clip);
        if shape.fill.a() > 0 && shape.brush.is_none() {
            self.fills.push((shape.rect.intersect(clip), Some(shape.fill)));
        }
    }

    fn edge(&mut self, rect: Rect, ink: Color32, clip: Rect) {
        if ink.a() > 0 && clip.contains(rect.center()) {
            self.edges.push(Drawn { words: String::new(), ink, rect, grounds: self.grounds(rect.center()) });
        }
    }

    fn take_text(&mut self, text: &TextShape, clip: Rect) {
        let rect = text.galley.rect.translate(text.pos.to_vec2());
        let words = text.galley.text().to_owned();
        if words.trim().is_empty() || !clip.contains(rect.center()) {
            return;
        }
        for section in &text.galley.job.sections {
            let own = section.format.color;
            let own = if own == Color32::PLACEHOLDER { text.fallback_color } else { own };
            let ink = text.override_text_color.unwrap_or(own).gamma_multiply(text.opacity_factor);
            self.texts.push(Drawn { words: words.clone(), ink, rect, grounds: self.grounds(rect.center()) });
        }
    }

    /// What has been drawn at a place so far.
    fn grounds(&self, at: Pos2) -> Vec<Color32> {
        let below = self.fills.iter().filter(|(rect, _)| rect.contains(at));
        let over =
            |scene: Color32| below.clone().fold(scene, |under, (_, fill)| fill.map_or(scene, |fill| under.blend(fill)));
        [Color32::BLACK, Color32::WHITE].map(over).to_vec()
    }
}

/// What is drawn too faintly on a window; controls that are switched off are exempt.
fn faint(harness: &Harness<'static, SauteApp>, size: egui::Vec2) -> BTreeSet<String> {
    let page = Page::of(harness, Rect::from_min_size(Pos2::ZERO, size));
    let nodes: Vec<_> = harness.root().children_recursive().collect();
    let off: Vec<Rect> = nodes.iter().filter(|n| n.accesskit_node().is_disabled()).map(|n| n.rect()).collect();
    let is_off = |drawn: &&Drawn| off.iter().any(|rect| rect.contains(drawn.rect.center()));
    let texts = page.texts.iter().filter(|drawn| !is_off(drawn));
    let mut faint: BTreeSet<String> = texts
        .map(|drawn| (drawn, least(drawn.ink, &drawn.grounds)))
        .filter(|(_, ratio)| *ratio < TEXT)
        .map(|(drawn, ratio)| format!("\"{}\" {:?} on {:?}: {ratio:.2}", drawn.words, drawn.ink, drawn.grounds))
        .collect();
    let roles = [Role::TextInput, Role::Slider, Role::CheckBox, Role::ComboBox, Role::SpinButton];
    let window = Rect::from_min_size(Pos2::ZERO, size);
    for control in nodes.iter().filter(|n| roles.contains(&n.accesskit_node().role())) {
        let place = control.rect().expand(3.0);
        if off.contains(&control.rect()) || !window.contains_rect(place) {
            continue;
        }
        let parts = page.edges.iter().chain(&page.texts).filter(|drawn| place.contains_rect(drawn.rect));
        let parts: Vec<&Drawn> = parts.collect();
        // Over a dark scene another part may be seen than over a bright one.
        let best =
            |scene: usize| parts.iter().map(|part| least(part.ink, &part.grounds[scene..=scene])).fold(0.0, f64::max);
        let seen = best(0).min(best(1));
        if !parts.is_empty() && seen < CONTROL {
            faint.insert(format!(
                "{:?} {:?}: {seen:.2}",
                control.accesskit_node().role(),
                control.accesskit_node().label()
            ));
        }
    }
    faint
}

/// Visits what the window can show; `look` is called at every stop.
fn visit(harness: &mut Harness<'static, SauteApp>, mut look: impl FnMut(&Harness<'static, SauteApp>)) {
    look(harness);
    harness.state_mut().session_mut().command(&Command::Hob(1100.0)).expect("hob");
    press(harness, Key::A);
    cook(harness, 20.0);
    let views = [Key::Num2, Key::Num3, Key::Num4, Key::Num5, Key::Num6, Key::Num7, Key::Num1];
    let panels = [Key::X, Key::P, Key::G, Key::N, Key::B, Key::U, Key::W, Key::F];
    let cards = [Key::F1, Key::F2, Key::F3];
    for key in views.into_iter().chain(panels) {
        press(harness, key);
        look(harness);
    }
    for key in cards {
        press(harness, key);
        look(harness);
        press(harness, Key::Escape);
    }
    harness.key_press_modifiers(egui::Modifiers::COMMAND, Key::Z);
    steps(harness, 30);
    press(harness, Key::T);
    look(harness);
    press(harness, Key::F4);
    steps(harness, 10);
    look(harness);
}

#[test]
fn every_text_and_control_stands_out_from_what_it_is_drawn_on_in_both_themes() {
    let mut faintly = BTreeSet::new();
    for theme in [Theme::Dark, Theme::Light] {
        for size in [vec2(1280.0, 720.0), vec2(390.0, 844.0)] {
            let mut harness = window(size);
            let ctx = harness.ctx.clone();
            harness.state_mut().act(Act::App(AppAct::Set(Setting::Theme(theme))), &ctx);
            steps(&mut harness, 2);
            let mut texts = 0;
            visit(&mut harness, |harness| {
                texts += Page::of(harness, Rect::from_min_size(pos2(0.0, 0.0), size)).texts.len();
                faintly.extend(faint(harness, size).into_iter().map(|what| format!("{theme:?} {size:?}: {what}")));
            });
            assert!(texts > 500, "{texts} texts were looked at");
        }
    }
    assert!(faintly.is_empty(), "{faintly:#?}");
}

#[test]
fn the_contrast_of_black_on_white_is_21_and_what_is_faint_is_found() {
    assert!((contrast(Color32::BLACK, Color32::WHITE) - 21.0).abs() < 1e-9);
    let panel = Color32::from_black_alpha(128);
    let mut page = Page { fills: vec![(Rect::EVERYTHING, None), (Rect::EVERYTHING, Some(panel))], ..Page::default() };
    let [dark, bright] = page.grounds(Pos2::ZERO)[..] else { panic!("two grounds") };
    assert_eq!((dark.r(), bright.r()), (0, 127));
    assert!(least(Color32::from_gray(127), &[dark, bright]) < 1.1);
    page.fills.push((Rect::EVERYTHING, Some(Color32::WHITE)));
    assert!(least(Color32::BLACK, &page.grounds(Pos2::ZERO)) > 20.9);
}

/// Colours that have a meaning wherever a panel uses them, also where the tour above does not come by.
#[test]
fn the_colours_of_curves_probes_and_states_stand_out_in_both_themes() {
    for p in [true, false].map(Palette::of) {
        #[track_caller]
        fn at_least(contrast_at_least: f64, ink: Color32, ground: Color32) {
            let got = contrast(ink, ground);
            assert!(got >= contrast_at_least, "{ink:?} on {ground:?}: {got:.2} < {contrast_at_least}");
        }
        let over = |scene: Color32| scene.blend(p.ground);
        let grounds = [over(Color32::BLACK), over(Color32::WHITE), p.solid, p.raised];
        for ground in grounds {
            [p.text, p.quiet, p.accent].into_iter().for_each(|ink| at_least(TEXT, ink, ground));
        }
        [p.hovered, p.pressed, p.sunken].into_iter().for_each(|ground| at_least(TEXT, p.text, ground));
        at_least(TEXT, p.on_accent, p.accent);
        at_least(TEXT, p.on_chosen, p.chosen);
        at_least(CONTROL, p.chosen, p.raised);
        for ink in (1..=6).map(|number| p.probe(number)) {
            at_least(CONTROL, ink, p.sunken);
            // Their values are written in their colours.
            at_least(TEXT, ink, p.raised);
            at_least(TEXT, ink, p.solid);
            at_least(TEXT, p.on_accent, ink);
        }
        for ink in p.curves {
            at_least(CONTROL, ink, p.sunken);
            at_least(TEXT, ink, p.solid);
        }
    }
}
